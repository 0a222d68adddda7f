//! The pictures of the gallery: a template, and how far solutions are from what they should be.
//!
//! ```text
//!   +-----------+           _            residuals of random data: filled
//!   |  template |          | |_          errors of scenes: a line
//!   +-----------+        _-|_|_|-_____
//!                       -16  -12  -8  -4
//! ```

use std::fmt::Write as _;

use eliminant_generator::plan::picture::{Cell, Part, Picture};

use crate::histograms::Histogram;

/// The square of a template, in pixels.
const SIDE: f64 = 200.0;
/// The largest entry.
const LARGEST_CELL: f64 = 14.0;
/// Space between the parts.
const GAP: f64 = 4.0;
/// Around everything.
const MARGIN: f64 = 10.0;
/// The histogram, in pixels, and how far below it the numbers and the two lines of the legend are.
const HISTOGRAM: (f64, f64) = (260.0, 150.0);
const LABELS: [f64; 3] = [15.0, 34.0, 51.0];
/// Fill of the residuals, and line of the errors.
const COLOURS: [&str; 2] = ["#9ecae1", "#d55e00"];

/// The picture of a problem as SVG: residuals of random data, and errors of scenes.
pub(crate) fn svg(template: &Picture, residuals: &Histogram, errors: &Histogram) -> String {
    let (width, height) = (3.0 * MARGIN + SIDE + HISTOGRAM.0, 2.0 * MARGIN + SIDE);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" font-size=\"13\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    );
    draw_template(&mut text, template);
    draw_histograms(&mut text, residuals, errors);
    text + "</svg>\n"
}

/// Entries that follow each other in a row are one line, so that large templates are small files.
fn draw_template(text: &mut String, template: &Picture) {
    let (rows, columns) = (template.rows.len(), template.columns.len());
    let cell = ((SIDE - 2.0 * GAP) / rows.max(columns).max(1) as f64).min(LARGEST_CELL);
    let (width, height) = (cell * columns as f64 + 2.0 * GAP, cell * rows as f64);
    let (left, top) = (MARGIN + (SIDE - width) / 2.0, MARGIN + (SIDE - height) / 2.0);
    for (at, part) in Part::ALL.into_iter().enumerate() {
        let of_part: Vec<usize> = template.columns_of(part).collect();
        let Some(&first) = of_part.first() else { continue };
        let [full, light, band] = part.colours();
        let x = left + cell * first as f64 + GAP * at as f64;
        let _ = writeln!(
            text,
            "<g transform=\"translate({x:.2} {top:.2}) scale({cell:.4})\" fill=\"none\">\n\
             <path d=\"M0 {:.1}h{}\" stroke=\"{band}\" stroke-width=\"{rows}\"/>",
            rows as f64 / 2.0,
            of_part.len()
        );
        for (colour, is_light) in [(light, true), (full, false)] {
            let is_drawn = |cell: Cell| cell != Cell::Empty && (cell == Cell::Coupling) == is_light;
            let lines: String = (0..rows).map(|row| line(row, &template.cells[row], &of_part, &is_drawn)).collect();
            if !lines.is_empty() {
                let _ = writeln!(text, "<path d=\"{lines}\" stroke=\"{colour}\" stroke-width=\".84\"/>");
            }
        }
        text.push_str("</g>\n");
    }
}

/// The entries of a row that are drawn, as a path.
fn line(row: usize, cells: &[Cell], columns: &[usize], is_drawn: &dyn Fn(Cell) -> bool) -> String {
    let (mut path, mut at) = (String::new(), 0);
    while at < columns.len() {
        let length = columns[at..].iter().take_while(|&&column| is_drawn(cells[column])).count();
        if length > 0 {
            let _ = write!(path, "M{at} {row}.5h{length}");
        }
        at += length + 1;
    }
    path
}

fn draw_histograms(text: &mut String, residuals: &Histogram, errors: &Histogram) {
    let (width, height) = HISTOGRAM;
    let (left, bottom) = (2.0 * MARGIN + SIDE, MARGIN + height);
    let step = width / residuals.shares.len() as f64;
    let highest =
        residuals.shares.iter().chain(&errors.shares).fold(f64::MIN_POSITIVE, |highest, share| highest.max(*share));
    let x = |bin: usize| left + step * bin as f64;
    let outline = |histogram: &Histogram| {
        let mut path = format!("M{left:.1} {bottom:.1}");
        for (bin, share) in histogram.shares.iter().enumerate() {
            let _ = write!(path, "V{:.1}H{:.1}", bottom - height * share / highest, x(bin + 1));
        }
        path + &format!("V{bottom:.1}")
    };
    let _ = writeln!(text, "<path d=\"{}\" fill=\"{}\"/>", outline(residuals), COLOURS[0]);
    let _ = writeln!(
        text,
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>",
        outline(errors),
        COLOURS[1]
    );
    let _ = writeln!(text, "<path d=\"M{left:.1} {bottom:.1}h{width}\" stroke=\"#444\"/>");
    for (bin, edge) in residuals.edges.iter().enumerate().filter(|(_, edge)| *edge % 4.0 == 0.0) {
        let (x, y) = (x(bin), bottom + LABELS[0]);
        let _ = writeln!(text, "<path d=\"M{x:.1} {bottom:.1}v4\" stroke=\"#444\"/>");
        let _ = writeln!(text, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\" fill=\"#444\">{edge}</text>");
    }
    let [first, second] = [LABELS[1], LABELS[2]].map(|below| bottom + below);
    let (x, y) = (left + 18.0, first - 10.0);
    let _ = writeln!(
        text,
        "<rect x=\"{left:.1}\" y=\"{y:.1}\" width=\"12\" height=\"10\" fill=\"{}\"/>\n\
         <text x=\"{x:.1}\" y=\"{first:.1}\" fill=\"#444\">log10 of residuals, random data</text>",
        COLOURS[0]
    );
    let _ = writeln!(
        text,
        "<path d=\"M{left:.1} {:.1}h12\" stroke=\"{}\" stroke-width=\"1.5\"/>\n\
         <text x=\"{x:.1}\" y=\"{second:.1}\" fill=\"#444\">log10 of errors, scenes</text>",
        second - 5.0,
        COLOURS[1]
    );
}
