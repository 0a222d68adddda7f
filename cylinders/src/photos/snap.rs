//! Lines that were marked by hand, moved to the edges that are there.

use nalgebra::Point2;

use crate::observations::view::View;

/// Largest distance from a marked line to both ends of its edge, pixels.
const REACH: f64 = 5.0;

/// Replaces each line of `marked` by the longest of the `edges` both of whose end points are within
/// five pixels of it, in pixels without distortion. An edge replaces one line, the first to have
/// it. Labels stay. Returns the lines with the number of those that were replaced; `None` if the
/// camera has no calibration or an end point is out of range.
pub fn snapped(marked: &View, edges: &View) -> Option<(View, usize)> {
    let calibration = marked.camera().calibration()?;
    let pixels = |ends: &[Point2<f64>; 2]| ends.map(|end| calibration.point_to_pixels(&end));
    let mut free: Vec<_> =
        edges.ends().iter().enumerate().filter_map(|(edge, ends)| Some((edge, pixels(ends.as_ref()?)))).collect();
    free.sort_by(|a, b| (b.1[1] - b.1[0]).norm().total_cmp(&(a.1[1] - a.1[0]).norm()));
    let mut chosen = Vec::with_capacity(marked.lines().len());
    for (line, ends) in marked.lines().iter().zip(marked.ends()) {
        let in_pixels = calibration.line_to_pixels(line);
        let in_pixels = in_pixels / in_pixels.xy().norm();
        let is_near = |(_, ends): &(usize, [Point2<f64>; 2])| {
            ends.iter().all(|end| in_pixels.dot(&end.to_homogeneous()).abs() <= REACH)
        };
        chosen.push(match free.iter().position(is_near) {
            Some(place) => {
                let (edge, _) = free.remove(place);
                (edges.lines()[edge], edges.ends()[edge], 1)
            }
            None => (*line, *ends, 0),
        });
    }
    let lines: Vec<_> = chosen.iter().map(|(line, ..)| *line).collect();
    let view = View::from_normalised_lines(*marked.camera(), &lines).ok()?;
    let view = view.with_ends(chosen.iter().map(|(_, ends, _)| *ends).collect()).ok()?;
    let view = view.with_labels(marked.labels().to_vec()).ok()?;
    let view = match marked.image() {
        Some(image) => view.with_image(image.to_owned()),
        None => view,
    };
    Some((view, chosen.iter().map(|(.., count)| count).sum()))
}
