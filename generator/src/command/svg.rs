//! A template drawn as an SVG picture.
//!
//! ```text
//! title
//! subtitle           column monomials, upwards
//!                  +--------+-----------+-------+
//! row shifts       | excess | reducible | basis |   bands with a square for each entry
//!                  +--------+-----------+-------+
//!                  legend
//! ```

use std::fmt::Write as _;

use crate::plan::picture::{Cell, Part, Picture};

/// Width of a character of the labels, as a share of the size of the font.
const CHARACTER: f64 = 0.61;
/// Space between the parts.
const GAP: f64 = 6.0;
/// Space between the drawing and the edge of the picture.
const MARGIN: f64 = 20.0;
const TITLE: f64 = 17.0;
const SUBTITLE: f64 = 12.0;

/// The sizes by which everything is placed, in pixels.
struct Layout<'a> {
    picture: &'a Picture,
    cell: f64,
    font: f64,
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl<'a> Layout<'a> {
    fn new(picture: &'a Picture, title: &str, subtitle: &str) -> Self {
        let columns = picture.columns.len() as f64;
        let cell = (900.0 / columns.max(1.0)).clamp(7.0, 24.0);
        let font = (cell * 0.72).min(13.0);
        let width_of = |label: &String| pretty(label).chars().count() as f64 * CHARACTER * font;
        let left = MARGIN + picture.rows.iter().map(width_of).fold(0.0, f64::max) + GAP;
        let labels = picture.columns.iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max);
        let top = MARGIN + 1.6 * TITLE + 1.8 * SUBTITLE + labels + GAP;
        let heading =
            (title.chars().count() as f64 * TITLE * CHARACTER).max(subtitle.chars().count() as f64 * SUBTITLE * 0.52);
        let right = left + columns * cell + 2.0 * GAP;
        let width = right.max(MARGIN + heading).max(left + legend_width()) + MARGIN;
        let height = top + picture.rows.len() as f64 * cell + 2.2 * SUBTITLE + LEGEND_LINE + MARGIN;
        Self { picture, cell, font, left, top, width, height }
    }

    /// The left edge of a column.
    fn x(&self, column: usize) -> f64 {
        let gaps = match self.picture.columns[column].0 {
            Part::Excess => 0.0,
            Part::Reducible => GAP,
            Part::Basis => 2.0 * GAP,
        };
        self.left + column as f64 * self.cell + gaps
    }

    /// The upper edge of a row.
    fn y(&self, row: usize) -> f64 {
        self.top + row as f64 * self.cell
    }
}

/// The picture, with `title` and `subtitle` above it.
pub(super) fn svg(picture: &Picture, title: &str, subtitle: &str) -> String {
    let layout = Layout::new(picture, title, subtitle);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0}\" height=\"{1:.0}\" viewBox=\"0 0 {0:.0} {1:.0}\" \
         font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        layout.width, layout.height
    );
    let mut put = |line: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{line}");
    };
    let (x, y) = (MARGIN, MARGIN + TITLE);
    put(format!(
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{TITLE}\" font-weight=\"bold\" fill=\"#222\">{}</text>",
        escape(title)
    ));
    let y = y + 1.7 * SUBTITLE;
    put(format!("<text x=\"{x}\" y=\"{y:.1}\" font-size=\"{SUBTITLE}\" fill=\"#666\">{}</text>", escape(subtitle)));
    bands(&layout).into_iter().for_each(&mut put);
    entries(&layout).into_iter().for_each(&mut put);
    labels(&layout).into_iter().for_each(&mut put);
    legend(&layout).into_iter().for_each(&mut put);
    text + "</svg>\n"
}

/// The tinted background of each part, and a line under each diagonal block.
fn bands(layout: &Layout<'_>) -> Vec<String> {
    let picture = layout.picture;
    let (top, bottom) = (layout.y(0), layout.y(picture.rows.len()));
    let mut lines = Vec::new();
    for part in Part::ALL {
        let columns: Vec<usize> = picture.columns_of(part).collect();
        let (Some(&first), Some(&last)) = (columns.first(), columns.last()) else { continue };
        let (x, end) = (layout.x(first), layout.x(last) + layout.cell);
        let [line, _, fill] = part.colours();
        lines.push(format!(
            "<rect x=\"{x:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{fill}\" stroke=\"{line}\" stroke-width=\"0.8\"/>",
            end - x,
            bottom - top
        ));
        let mut row = 0;
        for size in &picture.blocks[..picture.blocks.len().saturating_sub(1)] {
            row += size;
            let y = layout.y(row);
            lines.push(format!(
                "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{end:.1}\" y2=\"{y:.1}\" stroke=\"{line}\" stroke-width=\"0.5\" opacity=\"0.45\"/>"
            ));
        }
    }
    lines
}

fn entries(layout: &Layout<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    let inset = layout.cell * 0.1;
    let side = layout.cell - 2.0 * inset;
    for (row, cells) in layout.picture.cells.iter().enumerate() {
        for (column, &cell) in cells.iter().enumerate().filter(|&(_, &cell)| cell != Cell::Empty) {
            let part = layout.picture.columns[column].0;
            let [full, light, _] = part.colours();
            let fill = if cell == Cell::Coupling { light } else { full };
            let (x, y) = (layout.x(column) + inset, layout.y(row) + inset);
            lines.push(format!(
                "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{side:.1}\" height=\"{side:.1}\" rx=\"1.5\" fill=\"{fill}\"/>"
            ));
        }
    }
    lines
}

/// Row shifts to the left, column monomials upwards; the plain text is in the tooltip.
fn labels(layout: &Layout<'_>) -> Vec<String> {
    let font = layout.font;
    let style = format!("font-size=\"{font:.1}\" font-family=\"'DejaVu Sans Mono', Menlo, Consolas, monospace\"");
    let mut lines = Vec::new();
    for (row, label) in layout.picture.rows.iter().enumerate() {
        let (x, y) = (layout.left - GAP, layout.y(row) + layout.cell / 2.0 + font * 0.35);
        lines.push(format!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" {style} text-anchor=\"end\" fill=\"#333\"><title>{}</title>{}</text>",
            escape(label),
            escape(&pretty(label))
        ));
    }
    for (column, (part, label)) in layout.picture.columns.iter().enumerate() {
        let (x, y) = (layout.x(column) + layout.cell / 2.0 + font * 0.35, layout.top - GAP);
        lines.push(format!(
            "<text transform=\"translate({x:.1} {y:.1}) rotate(-90)\" {style} fill=\"{}\"><title>{}</title>{}</text>",
            part.colours()[0],
            escape(label),
            escape(&pretty(label))
        ));
    }
    lines
}

/// The lines of the legend: swatches (part, which of its colours) before each text.
type LegendEntry = (&'static [(Part, usize)], &'static str);
const LEGEND: [&[LegendEntry]; 2] = [
    &[(&[(Part::Excess, 0)], "excess"), (&[(Part::Reducible, 0)], "reducible"), (&[(Part::Basis, 0)], "basis")],
    &[(&[(Part::Excess, 1), (Part::Reducible, 1)], "solved by an earlier block")],
];
const SWATCH: f64 = 11.0;
const LEGEND_LINE: f64 = 1.6 * SUBTITLE;

fn legend_step((swatches, text): &LegendEntry) -> f64 {
    swatches.len() as f64 * (SWATCH + 4.0) + text.chars().count() as f64 * SUBTITLE * 0.58 + 14.0
}

fn legend_width() -> f64 {
    LEGEND.iter().map(|line| line.iter().map(legend_step).sum()).fold(0.0, f64::max)
}

fn legend(layout: &Layout<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    let mut y = layout.y(layout.picture.rows.len()) + 2.2 * SUBTITLE;
    for line in LEGEND {
        let mut x = layout.left;
        for entry in line {
            for (at, &(part, shade)) in entry.0.iter().enumerate() {
                let (x, fill) = (x + at as f64 * (SWATCH + 4.0), part.colours()[shade]);
                lines.push(format!(
                    "<rect x=\"{x:.1}\" y=\"{:.1}\" width=\"{SWATCH}\" height=\"{SWATCH}\" rx=\"1.5\" fill=\"{fill}\"/>",
                    y - 10.0
                ));
            }
            let (x_text, text) = (x + entry.0.len() as f64 * (SWATCH + 4.0) + 1.0, entry.1);
            lines.push(format!(
                "<text x=\"{x_text:.1}\" y=\"{y:.1}\" font-size=\"{SUBTITLE}\" fill=\"#333\">{text}</text>"
            ));
            x += legend_step(entry);
        }
        y += LEGEND_LINE;
    }
    lines
}

/// `f2 * x^2*y` as `f2 · x²y`: superscripts, and products of single letters without a sign.
fn pretty(label: &str) -> String {
    let (equation, monomial) = label.split_once(" * ").map_or(("", label), |(equation, monomial)| (equation, monomial));
    let single =
        monomial.split(['*', '/']).all(|factor| factor.split('^').next().is_some_and(|name| name.chars().count() == 1));
    let mut text = String::new();
    let mut raised = false;
    for c in monomial.chars() {
        let digit = c.to_digit(10).and_then(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize));
        match (c, digit) {
            ('^', _) => raised = true,
            (_, Some(digit)) if raised => text.push(digit),
            ('*', _) => {
                raised = false;
                text.push_str(if single { "" } else { "·" });
            }
            _ => {
                raised = false;
                text.push(c);
            }
        }
    }
    if equation.is_empty() { text } else { format!("{equation} · {text}") }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::pretty;

    #[test]
    fn labels_are_set_as_mathematics() {
        for (plain, set) in [
            ("f2 * x^2*y", "f2 · x²y"),
            ("f12", "f12"),
            ("x^12/y", "x¹²/y"),
            ("d3*d5^2", "d3·d5²"),
            ("f1 * 1/d3^2", "f1 · 1/d3²"),
            ("1", "1"),
        ] {
            assert_eq!(pretty(plain), set, "{plain}");
        }
    }
}
