//! A template drawn in characters.

use std::fmt::Write as _;

use crate::plan::picture::{Cell, Part, Picture};

/// The plot with its labels and a legend.
pub(super) fn spy(picture: &Picture) -> String {
    let label_width = picture.rows.iter().map(|label| label.chars().count()).max().unwrap_or(0);
    // A part is at least as wide as its name.
    let parts: Vec<(Part, Vec<usize>, usize)> = Part::ALL
        .into_iter()
        .map(|part| (part, picture.columns_of(part).collect::<Vec<_>>()))
        .filter(|(_, columns)| !columns.is_empty())
        .map(|(part, columns)| {
            let width = columns.len().max(part.name().len());
            (part, columns, width)
        })
        .collect();
    let border = {
        let lines: Vec<String> = parts.iter().map(|&(_, _, width)| "-".repeat(width + 2)).collect();
        format!("{:label_width$} +{}+\n", "", lines.join("+"))
    };
    let mut text = String::new();
    // Writing to a string cannot fail.
    let mut put = |line: String| {
        let _ = write!(text, "{line}");
    };
    let names: Vec<String> = parts.iter().map(|(part, _, width)| format!("{:width$}", part.name())).collect();
    put(format!("{:label_width$} | {} |\n{border}", "", names.join(" | ")));
    let mut row = 0;
    for &size in &picture.blocks {
        for _ in 0..size {
            let cells: Vec<String> = parts
                .iter()
                .map(|(_, columns, width)| {
                    let drawn: String = columns.iter().map(|&column| character(picture.cells[row][column])).collect();
                    format!("{drawn:width$}")
                })
                .collect();
            put(format!("{:label_width$} | {} |\n", picture.rows[row], cells.join(" | ")));
            row += 1;
        }
    }
    put(border.clone());
    put("# in a diagonal block, + at a pivot solved before, o in the basis; blocks in the order of solution\n".into());
    for (part, columns, _) in &parts {
        let monomials: Vec<&str> = columns.iter().map(|&column| picture.columns[column].1.as_str()).collect();
        put(format!("{:<10}{}\n", part.name(), monomials.join(", ")));
    }
    text
}

fn character(cell: Cell) -> char {
    match cell {
        Cell::Empty => '.',
        Cell::Diagonal => '#',
        Cell::Coupling => '+',
        Cell::Right => 'o',
    }
}
