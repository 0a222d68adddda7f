//! A photograph with the lines and silhouettes drawn over it: SVG with the photograph inside, in
//! pixels of the photograph.

use std::fmt::{self, Write};

use nalgebra::Point2;

use super::clip::Window;
use crate::output::palette::{self, Colour, GIVEN};
use crate::{Calibration, Cylinder, CylinderLines, Scene, View};

/// Width of a line as a part of the width of the photograph.
const STROKE: f64 = 1.0 / 640.0;

/// A photograph without distortion, as a file.
#[derive(Clone, Copy, Debug)]
pub struct PhotographFile<'a> {
    /// Kind of the file, such as `image/jpeg`.
    pub media_type: &'a str,
    /// The bytes of the file.
    pub bytes: &'a [u8],
    /// Width, pixels.
    pub width: usize,
    /// Height, pixels.
    pub height: usize,
}

/// The photograph of a view of the scene under its lines and the silhouettes of the cylinders that
/// have lines in it, as an SVG file that needs no other file. Lines that belong to no cylinder are
/// thin; silhouettes and the lines that match them have the colour of their cylinder. `None` if
/// there is no such view, or its camera has no calibration.
pub fn photograph_overlay(
    photograph: &PhotographFile<'_>,
    scene: &Scene,
    found: &[(CylinderLines, Cylinder)],
    view: usize,
) -> Option<String> {
    let seen = scene.views.get(view)?;
    let calibration = seen.camera().calibration()?;
    let (width, height) = (photograph.width, photograph.height);
    let mut svg = String::new();
    let overlay = Overlay {
        window: Window { low: Point2::origin(), high: Point2::new(width as f64, height as f64) },
        stroke: STROKE * width as f64,
        calibration,
    };
    // Writing to a string does not fail.
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <image width=\"{width}\" height=\"{height}\" href=\"data:{};base64,{}\"/>",
        photograph.media_type,
        base64(photograph.bytes)
    );
    let _ = overlay.lines(&mut svg, seen, GIVEN, 1.0);
    for (number, (lines, cylinder)) in found.iter().enumerate() {
        if let Some(of_cylinder) = lines.views.get(view).filter(|view| !view.lines().is_empty()) {
            let _ = overlay.cylinder(&mut svg, of_cylinder, cylinder, palette::series(number));
        }
    }
    svg.push_str("</svg>\n");
    Some(svg)
}

struct Overlay<'a> {
    window: Window,
    stroke: f64,
    calibration: &'a Calibration,
}

impl Overlay<'_> {
    /// The lines of a view: from end to end, or through the whole photograph.
    fn lines(&self, svg: &mut String, view: &View, colour: Colour, width: f64) -> fmt::Result {
        for (line, ends) in view.lines().iter().zip(view.ends()) {
            let inside = match ends {
                Some(ends) => self.window.segment(ends.map(|end| self.calibration.point_to_pixels(&end))),
                None => self.window.line(&self.calibration.line_to_pixels(line)),
            };
            self.segment(svg, inside, colour, (width, 1.0))?;
        }
        Ok(())
    }

    /// Both silhouettes, faint where no line is near them, and the lines that match them.
    fn cylinder(&self, svg: &mut String, view: &View, cylinder: &Cylinder, colour: Colour) -> fmt::Result {
        for silhouette in cylinder.silhouette(view.camera()).into_iter().flatten() {
            let inside = self.window.line(&self.calibration.line_to_pixels(&silhouette));
            self.segment(svg, inside, colour, (1.5, 0.6))?;
        }
        self.lines(svg, view, colour, 3.0)
    }

    fn segment(
        &self,
        svg: &mut String,
        ends: Option<[Point2<f64>; 2]>,
        [red, green, blue]: Colour,
        (width, opacity): (f64, f64),
    ) -> fmt::Result {
        let Some([start, end]) = ends else { return Ok(()) };
        writeln!(
            svg,
            "<line x1=\"{:.2}\" y1=\"{:.2}\" x2=\"{:.2}\" y2=\"{:.2}\" stroke=\"rgb({red},{green},{blue})\" \
             stroke-width=\"{:.2}\" stroke-opacity=\"{opacity}\"/>",
            start.x,
            start.y,
            end.x,
            end.y,
            width * self.stroke
        )
    }
}

/// Bytes as text: three bytes to four characters (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |index: usize| u32::from(chunk.get(index).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for place in 0..4 {
            let is_padding = place > chunk.len();
            let digit = (bits >> (18 - 6 * place)) as usize % 64;
            text.push(if is_padding { '=' } else { char::from(ALPHABET[digit]) });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    #[test]
    fn text_of_bytes_is_that_of_the_standard() {
        for (bytes, text) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            assert_eq!(super::base64(bytes.as_bytes()), text);
        }
    }
}
