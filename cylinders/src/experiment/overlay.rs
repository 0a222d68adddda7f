//! A photograph with the given lines and the silhouettes that were found, as SVG. The file contains
//! the photograph, so that it can be moved.

use std::fmt::Write;

use nalgebra::{Point2, Vector3};

use crate::output::palette::{self, Colour, GIVEN};
use crate::space::extent::image_corners;
use crate::{Cylinder, CylinderLines, View};

/// The overlay for the view of this index. `None` if the bytes are neither JPEG nor PNG, or the
/// view has no calibration. The size of the photograph is taken as twice the principal point.
pub(super) fn overlay(
    photograph: &[u8],
    index: usize,
    view: &View,
    found: &[(CylinderLines, Cylinder)],
) -> Option<String> {
    let kind = match photograph {
        [0xff, 0xd8, 0xff, ..] => "jpeg",
        [0x89, b'P', b'N', b'G', ..] => "png",
        _ => return None,
    };
    let camera = view.camera();
    let calibration = camera.calibration()?;
    let size = calibration.point_to_pixels(&image_corners(camera)[2]);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\">\n\
         <image width=\"{w}\" height=\"{h}\" xlink:href=\"data:image/{kind};base64,{data}\"/>\n",
        w = size.x,
        h = size.y,
        data = base64(photograph)
    );
    let mut draw = |line: &Vector3<f64>, colour: Colour, width: f64, dashes: &str| {
        let Some([from, to]) = across(&calibration.line_to_pixels(line), &size) else { return };
        let [red, green, blue] = colour;
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "<path d=\"M{:.2} {:.2}L{:.2} {:.2}\" stroke=\"rgb({red},{green},{blue})\" stroke-width=\"{width}\" \
             stroke-dasharray=\"{dashes}\"/>",
            from.x, from.y, to.x, to.y
        );
    };
    for (number, (lines, cylinder)) in found.iter().enumerate() {
        let seen = lines.views.get(index).is_some_and(|view| !view.lines().is_empty());
        let silhouette = if seen { cylinder.silhouette(camera) } else { None };
        for line in silhouette.iter().flatten() {
            draw(line, palette::series(number), 0.003 * size.x, "none");
        }
    }
    // Dashed and above, so that both are visible where they agree.
    for line in view.lines() {
        draw(line, GIVEN, 0.001 * size.x, &format!("{0:.1} {0:.1}", 0.01 * size.x));
    }
    text.push_str("</svg>\n");
    Some(text)
}

/// The segment of a line in the photograph.
fn across(line: &Vector3<f64>, size: &Point2<f64>) -> Option<[Point2<f64>; 2]> {
    let corners = [(0.0, 0.0), (size.x, 0.0), (size.x, size.y), (0.0, size.y)].map(|(x, y)| Point2::new(x, y));
    let value = |corner: usize| line.dot(&corners[corner % 4].to_homogeneous());
    let crossing = |side: usize| {
        let (start, end) = (value(side), value(side + 1));
        let part = start / (start - end);
        ((start < 0.0) != (end < 0.0)).then(|| corners[side] + (corners[(side + 1) % 4] - corners[side]) * part)
    };
    let ends: Vec<_> = (0..4).filter_map(crossing).collect();
    ends.try_into().ok()
}

/// Base 64 (RFC 4648, section 4).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |place: usize| u32::from(chunk.get(place).copied().unwrap_or(0));
        let group = byte(0) << 16 | byte(1) << 8 | byte(2);
        for place in 0..4 {
            let digit = DIGITS[(group >> (18 - 6 * place) & 63) as usize];
            text.push(if place <= chunk.len() { char::from(digit) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of RFC 4648, section 10.
    #[test]
    fn base64_agrees_with_its_standard() {
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (bytes, text) in pairs {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn lines_are_cut_at_the_edges() {
        let size = Point2::new(4.0, 2.0);
        let ends = across(&Vector3::new(1.0, 0.0, -1.0), &size).expect("a line in the photograph");
        assert_eq!(ends, [Point2::new(1.0, 0.0), Point2::new(1.0, 2.0)]);
        assert_eq!(across(&Vector3::new(1.0, 0.0, 1.0), &size), None);
    }
}
