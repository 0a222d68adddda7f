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
//!
//! Where a label would be too small to be read there is none: a row tells its shift as a tooltip,
//! and a strip above the columns their monomials. Entries that follow each other are one line of
//! dashes, so that large templates are small files.

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
/// The smallest cells, in whole pixels, the smallest whose labels can be read, and the largest.
const CELLS: [f64; 3] = [4.0, 8.0, 24.0];
/// Height of the strip above columns without labels.
const STRIP: f64 = 12.0;

/// The sizes by which everything is placed, in pixels.
struct Layout<'a> {
    picture: &'a Picture,
    cell: f64,
    font: f64,
    is_labelled: bool,
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl<'a> Layout<'a> {
    fn new(picture: &'a Picture, title: &str, subtitle: &str) -> Self {
        let columns = picture.columns.len() as f64;
        let [smallest, readable, largest] = CELLS;
        let cell = (900.0 / columns.max(1.0)).floor().clamp(smallest, largest);
        let font = (cell * 0.9).min(13.0);
        let is_labelled = cell >= readable;
        let width_of = |label: &String| pretty(label).chars().count() as f64 * CHARACTER * font;
        let (left, labels) = if is_labelled {
            let shifts = picture.rows.iter().map(width_of).fold(0.0, f64::max);
            let monomials = picture.columns.iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max);
            ((MARGIN + shifts + GAP).round(), monomials)
        } else {
            (MARGIN, STRIP)
        };
        let top = (MARGIN + 1.6 * TITLE + 1.8 * SUBTITLE + labels + GAP).round();
        let heading =
            (title.chars().count() as f64 * TITLE * CHARACTER).max(subtitle.chars().count() as f64 * SUBTITLE * 0.52);
        let right = left + columns * cell + 2.0 * GAP;
        let width = right.max(MARGIN + heading).max(left + legend_width(is_labelled)) + MARGIN;
        let legend = 2.2 * SUBTITLE + LEGEND_LINE * (legend_lines(is_labelled).len() - 1) as f64;
        let height = top + picture.rows.len() as f64 * cell + legend + MARGIN;
        Self { picture, cell, font, is_labelled, left, top, width, height }
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

/// A group for each row, whose tooltip is the shift: a band to point at, and lines of dashes.
fn entries(layout: &Layout<'_>) -> Vec<String> {
    let picture = layout.picture;
    let (cell, inset) = (layout.cell, layout.cell * 0.1);
    let side = cell - 2.0 * inset;
    let right = picture.columns.len().checked_sub(1).map_or(layout.left, |last| layout.x(last) + cell);
    let mut lines = vec![format!(
        "<g fill=\"none\" pointer-events=\"all\" stroke-width=\"{side:.1}\" stroke-dasharray=\"{side:.1} {:.1}\">",
        2.0 * inset
    )];
    for (row, label) in picture.rows.iter().enumerate() {
        let (x, y, width) = (layout.left, layout.y(row), right - layout.left);
        lines.push(format!(
            "<g><title>{}</title><rect x=\"{x:.0}\" y=\"{y:.0}\" width=\"{width:.0}\" height=\"{cell:.0}\" \
             stroke=\"none\"/>",
            escape(label)
        ));
        for part in Part::ALL {
            let [full, light, _] = part.colours();
            for (colour, is_light) in [(light, true), (full, false)] {
                let path = dashes(layout, row, part, is_light);
                if !path.is_empty() {
                    lines.push(format!("<path d=\"{path}\" stroke=\"{colour}\"/>"));
                }
            }
        }
        lines.push("</g>".to_owned());
    }
    lines.push("</g>".to_owned());
    lines
}

/// The entries of a row in a part, those that earlier blocks have solved or the others, as a path.
/// Each run of entries is a line, and dashes begin anew on each.
fn dashes(layout: &Layout<'_>, row: usize, part: Part, is_light: bool) -> String {
    let cells = &layout.picture.cells[row];
    let is_drawn = |column: &usize| cells[*column] != Cell::Empty && (cells[*column] == Cell::Coupling) == is_light;
    let columns: Vec<usize> = layout.picture.columns_of(part).collect();
    let inset = layout.cell * 0.1;
    let middle = layout.y(row) + layout.cell / 2.0;
    let mut path = String::new();
    for run in columns.chunk_by(|left, right| is_drawn(left) && is_drawn(right)) {
        if is_drawn(&run[0]) {
            let length = run.len() as f64 * layout.cell - 2.0 * inset;
            // Writing to a string cannot fail.
            let _ = write!(path, "M{:.1} {middle}h{length:.1}", layout.x(run[0]) + inset);
        }
    }
    path
}

/// Row shifts to the left, column monomials upwards; the plain text is in the tooltip. Where they
/// could not be read, a strip above the columns.
fn labels(layout: &Layout<'_>) -> Vec<String> {
    if !layout.is_labelled {
        return strip(layout);
    }
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

/// A rectangle above each column, whose tooltip is the monomial.
fn strip(layout: &Layout<'_>) -> Vec<String> {
    let (cell, y) = (layout.cell, layout.top - GAP - STRIP);
    let columns = layout.picture.columns.iter().enumerate();
    let rectangle = |(column, (part, label)): (usize, &(Part, String))| {
        let (x, fill) = (layout.x(column), part.colours()[column % 2]);
        format!(
            "<rect x=\"{x:.0}\" y=\"{y:.0}\" width=\"{cell:.0}\" height=\"{STRIP}\" fill=\"{fill}\"><title>{}</title></rect>",
            escape(label)
        )
    };
    columns.map(rectangle).collect()
}

/// The lines of the legend: swatches (part, which of its colours) before each text.
type LegendEntry = (&'static [(Part, usize)], &'static str);
const LEGEND: [&[LegendEntry]; 3] = [
    &[(&[(Part::Excess, 0)], "excess"), (&[(Part::Reducible, 0)], "reducible"), (&[(Part::Basis, 0)], "basis")],
    &[(&[(Part::Excess, 1), (Part::Reducible, 1)], "solved by an earlier block")],
    &[(&[], "point at a row, or at the strip above a column, for its name")],
];
const SWATCH: f64 = 11.0;
const LEGEND_LINE: f64 = 1.6 * SUBTITLE;

fn legend_step((swatches, text): &LegendEntry) -> f64 {
    swatches.len() as f64 * (SWATCH + 4.0) + text.chars().count() as f64 * SUBTITLE * 0.58 + 14.0
}

/// The last line is for templates without labels.
fn legend_lines(is_labelled: bool) -> &'static [&'static [LegendEntry]] {
    &LEGEND[..LEGEND.len() - usize::from(is_labelled)]
}

fn legend_width(is_labelled: bool) -> f64 {
    legend_lines(is_labelled).iter().map(|line| line.iter().map(legend_step).sum()).fold(0.0, f64::max)
}

fn legend(layout: &Layout<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    let mut y = layout.y(layout.picture.rows.len()) + 2.2 * SUBTITLE;
    for line in legend_lines(layout.is_labelled) {
        let mut x = layout.left;
        for entry in *line {
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
    use super::{Layout, dashes, pretty, svg};
    use crate::plan::picture::{Cell, Part, Picture};

    /// A picture of so many full rows, with twice as many columns.
    fn full(rows: usize) -> Picture {
        let part = |column| if column < rows { Part::Excess } else { Part::Basis };
        let cell = |column| if column < rows { Cell::Diagonal } else { Cell::Right };
        Picture {
            rows: (1..=rows).map(|row| format!("f{row}")).collect(),
            columns: (0..2 * rows).map(|column| (part(column), format!("x^{column}"))).collect(),
            cells: vec![(0..2 * rows).map(cell).collect(); rows],
            blocks: vec![rows],
        }
    }

    /// Two lines are above the drawing, and four texts, of large templates five, in the legend.
    #[test]
    fn labels_that_could_not_be_read_are_tooltips() {
        let [small, large] = [10, 100].map(|rows| svg(&full(rows), "name", "sizes"));
        assert_eq!((small.matches("<text").count(), large.matches("<text").count()), (6 + 10 + 20, 7));
        for row in 1..=100 {
            assert!(large.contains(&format!("<g><title>f{row}</title><rect ")), "{row}");
        }
        for column in 0..200 {
            assert!(large.contains(&format!("<title>x^{column}</title></rect>")), "{column}");
        }
        assert!(large.len() < 70_000, "{} bytes for 20,000 entries", large.len());
    }

    #[test]
    fn entries_that_follow_each_other_are_one_line() {
        let mut picture = full(3);
        picture.cells[1][4] = Cell::Empty;
        picture.cells[1][0] = Cell::Coupling;
        let layout = Layout::new(&picture, "", "");
        let lengths = |row, part, is_light| {
            let path = dashes(&layout, row, part, is_light);
            path.split('h').skip(1).map(|rest| rest.split('M').next().unwrap().parse().unwrap()).collect::<Vec<f64>>()
        };
        let [one, two, three] =
            [1.0, 2.0, 3.0].map(|cells| format!("{:.1}", 24.0 * cells - 4.8).parse::<f64>().unwrap());
        assert_eq!(lengths(0, Part::Excess, false), [three]);
        assert_eq!(lengths(0, Part::Excess, true), [0.0; 0]);
        assert_eq!(lengths(1, Part::Excess, false), [two]);
        assert_eq!(lengths(1, Part::Excess, true), [one]);
        assert_eq!(lengths(1, Part::Basis, false), [one, one]);
    }

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
