//! Connected pixels whose level lines have one direction (LSD, section 2.5).

use super::level_lines::LevelLines;

/// Connected pixels of about one direction.
#[derive(Clone, Debug)]
pub(super) struct Region {
    /// The pixels; the first is that from which the region grew.
    pub(super) pixels: Vec<usize>,
    /// Mean direction, radians.
    pub(super) angle: f32,
}

/// Grows a region from a pixel and marks its pixels as used: neighbours join while their direction
/// is within the tolerance of the mean so far.
pub(super) fn grow(lines: &LevelLines, seed: usize, tolerance: f32, used: &mut [bool]) -> Region {
    let mut region = Region { pixels: vec![seed], angle: lines.angles[seed] };
    let (mut sine, mut cosine) = region.angle.sin_cos();
    used[seed] = true;
    let mut next = 0;
    while let Some(&pixel) = region.pixels.get(next) {
        next += 1;
        let (column, row) = (pixel % lines.width, pixel / lines.width);
        for y in row.saturating_sub(1)..=(row + 1).min(lines.height - 1) {
            for x in column.saturating_sub(1)..=(column + 1).min(lines.width - 1) {
                let neighbour = y * lines.width + x;
                if used[neighbour] || !lines.is_aligned(neighbour, region.angle, tolerance) {
                    continue;
                }
                used[neighbour] = true;
                region.pixels.push(neighbour);
                let (s, c) = lines.angles[neighbour].sin_cos();
                (sine, cosine) = (sine + s, cosine + c);
                region.angle = sine.atan2(cosine);
            }
        }
    }
    region
}
