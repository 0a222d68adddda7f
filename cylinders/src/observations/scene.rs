//! A scene: views with their lines, perhaps of several cylinders, and points to compare the result
//! with.

use std::collections::BTreeSet;

use nalgebra::Point3;

use super::colmap::Model;
use super::distortion::Distortion;
use super::photograph::Photograph;
use super::segments::{SegmentError, Segments};
use super::view::View;

/// Views of one or several cylinders.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The views, in the order of the file.
    pub views: Vec<View>,
    /// Scene points, world frame; empty if the file has none.
    pub points: Vec<Point3<f64>>,
}

/// A line of a scene.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub struct LineId {
    /// Index of the view in its scene.
    pub view: usize,
    /// Index of the line in its view.
    pub line: usize,
}

/// The silhouette lines of one cylinder of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct CylinderLines {
    /// Label of the cylinder; `None` for lines without label.
    pub label: Option<String>,
    /// All views of the scene, each with the lines of this cylinder only.
    pub views: Vec<View>,
    /// The place in the scene of each line of `views`, in their order.
    pub lines: Vec<LineId>,
}

impl CylinderLines {
    /// A selection of the lines, each given by its place in `views`.
    pub fn selected(&self, chosen: &[LineId]) -> Self {
        let mut selected = Self { label: self.label.clone(), views: Vec::new(), lines: Vec::new() };
        let mut scene_lines = self.lines.iter();
        for (index, view) in self.views.iter().enumerate() {
            let in_scene: Vec<_> = scene_lines.by_ref().take(view.lines().len()).collect();
            let kept: Vec<_> =
                (0..in_scene.len()).filter(|&line| chosen.contains(&LineId { view: index, line })).collect();
            selected.views.push(view.selected(&kept));
            selected.lines.extend(kept.iter().map(|&line| in_scene[line]));
        }
        selected
    }
}

impl Scene {
    /// The photographs of the views, without distortion.
    ///
    /// # Errors
    /// The index of a view without the name of an image.
    pub fn photographs(&self) -> Result<Vec<Photograph>, usize> {
        let photograph = |(index, view): (usize, &View)| {
            let name = view.image().ok_or(index)?.to_owned();
            Ok(Photograph { name, camera: *view.camera(), distortion: Distortion::default() })
        };
        self.views.iter().enumerate().map(photograph).collect()
    }

    /// A scene with the photographs of a COLMAP model in which segments are marked, and with its
    /// points.
    ///
    /// # Errors
    /// [`SegmentError`].
    pub fn from_colmap(model: Model, segments: &Segments) -> Result<Self, SegmentError> {
        Ok(Self { views: segments.views(&model.photographs)?, points: model.points })
    }

    /// The scene with the lines of segments added to its views. The views are found by the names of
    /// their images.
    ///
    /// # Errors
    /// [`SegmentError`].
    pub fn with_segments(mut self, segments: &Segments) -> Result<Self, SegmentError> {
        let photograph = |view: &View| {
            let name = view.image()?.to_owned();
            Some(Photograph { name, camera: *view.camera(), distortion: Distortion::default() })
        };
        let photographs: Vec<_> = self.views.iter().filter_map(photograph).collect();
        for marked in segments.views(&photographs)? {
            if let Some(view) = self.views.iter_mut().find(|view| view.image() == marked.image()) {
                view.append(marked);
            }
        }
        Ok(self)
    }

    /// The lines of each cylinder: first the lines without label, then label by label in
    /// alphabetical order. There is at least one cylinder, which has no lines if the scene has
    /// none.
    pub fn cylinders(&self) -> Vec<CylinderLines> {
        let mut labels: BTreeSet<_> = self.views.iter().flat_map(View::labels).map(Option::as_deref).collect();
        if labels.is_empty() {
            labels.insert(None);
        }
        labels.into_iter().map(|label| self.labelled(label)).collect()
    }

    /// Whether a line has a label.
    pub fn has_labels(&self) -> bool {
        self.views.iter().flat_map(View::labels).any(Option::is_some)
    }

    fn labelled(&self, label: Option<&str>) -> CylinderLines {
        let mut cylinder = CylinderLines { label: label.map(str::to_owned), views: Vec::new(), lines: Vec::new() };
        for (index, view) in self.views.iter().enumerate() {
            let (view, lines) = view.labelled(label);
            cylinder.views.push(view);
            cylinder.lines.extend(lines.into_iter().map(|line| LineId { view: index, line }));
        }
        cylinder
    }
}
