//! A scene as a PLY file, for viewers such as MeshLab and CloudCompare: binary, little endian, in
//! three elements
//!
//! ```text
//!   vertex   x y z (double), red green blue (uchar)
//!   face     list of vertex_indices (uchar count, int)          the surfaces, triangles
//!   edge     vertex1 vertex2 (int)                               cameras and viewing planes
//! ```
//!
//! Vertices without face or edge are points. An edge has the colour of its ends, because readers do
//! not agree on more properties.

use std::f64::consts::TAU;

use nalgebra::{Point3, Vector3};

use super::palette::{self, Colour, GIVEN, GREY};
use crate::observations::scene::{CylinderLines, Scene};
use crate::observations::view::{Camera, View};
use crate::space::cylinder::Cylinder;
use crate::space::extent::{end_contacts, image_corners, visible_extent};

/// Number of facets of a surface. The middle of a facet is 0.1 % of the radius inside the cylinder.
const FACETS: usize = 72;

/// Depth of a camera's pyramid, relative to its distance from the cylinder.
const PYRAMID: f64 = 0.15;

/// The scene with its points, the cameras that see lines, and the cylinders. Each cylinder has the
/// visible part of its surface, without lids, and the viewing planes of its silhouette lines. A
/// viewing plane extends from the camera to the end points of the line on the surface or, without
/// end points, to where it comes nearest to the axis. Points on a surface have the colour of its
/// cylinder; all other points are grey.
pub fn to_ply(scene: &Scene, found: &[(CylinderLines, Cylinder)]) -> Vec<u8> {
    let mut model = Model::default();
    for point in &scene.points {
        let colour = found.iter().position(|(_, cylinder)| cylinder.is_near(point)).map_or(GREY, palette::series);
        model.vertices.push((*point, colour));
    }
    for (index, (lines, cylinder)) in found.iter().enumerate() {
        if let Some(extent) = visible_extent(cylinder, &lines.views, &scene.points) {
            model.add_surface(cylinder, extent, palette::series(index));
            for view in &lines.views {
                model.add_viewing_planes(cylinder, extent, view);
            }
        }
    }
    for view in scene.views.iter().filter(|view| !view.lines().is_empty()) {
        let distances = found.iter().map(|(_, cylinder)| cylinder.distance(&view.camera().centre()));
        model.add_camera(view.camera(), PYRAMID * distances.fold(f64::INFINITY, f64::min));
    }
    model.to_bytes()
}

/// Triangles, edges and points.
#[derive(Default)]
struct Model {
    vertices: Vec<(Point3<f64>, Colour)>,
    faces: Vec<[usize; 3]>,
    edges: Vec<[usize; 2]>,
}

impl Model {
    fn add_surface(&mut self, cylinder: &Cylinder, extent: [f64; 2], colour: Colour) {
        let w = cylinder.direction.into_inner();
        let u = w.cross(&Vector3::ith(w.iamin(), 1.0)).normalize();
        let v = w.cross(&u);
        let start = self.vertices.len();
        for facet in 0..FACETS {
            let (sine, cosine) = (TAU * facet as f64 / FACETS as f64).sin_cos();
            let outward = (u * cosine + v * sine) * cylinder.radius;
            self.vertices.extend(extent.map(|height| (cylinder.axis_at(height) + outward, colour)));
            // Bottom and top of this edge and of the next one, counter-clockwise from outside.
            let [bottom, next] = [facet, (facet + 1) % FACETS].map(|facet| start + 2 * facet);
            self.faces.extend([[bottom, next, next + 1], [bottom, next + 1, bottom + 1]]);
        }
    }

    fn add_viewing_planes(&mut self, cylinder: &Cylinder, extent: [f64; 2], view: &View) {
        for (plane, contacts) in view.planes().zip(end_contacts(cylinder, view)) {
            let in_plane = |height| {
                let point = cylinder.axis_at(height);
                point - plane.normal * plane.normal.dot(&(point - plane.centre))
            };
            let [bottom, top] = contacts.unwrap_or_else(|| extent.map(in_plane));
            self.add_polygon(&[plane.centre, bottom, top], GIVEN);
        }
    }

    /// A pyramid from the centre to the borders of the image.
    fn add_camera(&mut self, camera: &Camera, depth: f64) {
        let centre = camera.centre();
        let corners = image_corners(camera).map(|corner| {
            let ray = corner.to_homogeneous();
            centre + camera.rotation().tr_mul(&ray) * depth
        });
        let first = self.add_polygon(&corners, GIVEN);
        let apex = self.vertices.len();
        self.vertices.push((centre, GIVEN));
        self.edges.extend((first..apex).map(|corner| [apex, corner]));
    }

    /// Adds the edges around a polygon. Returns the index of its first vertex.
    fn add_polygon(&mut self, corners: &[Point3<f64>], colour: Colour) -> usize {
        let first = self.vertices.len();
        self.vertices.extend(corners.iter().map(|&corner| (corner, colour)));
        let edge = |index| [first + index, first + (index + 1) % corners.len()];
        self.edges.extend((0..corners.len()).map(edge));
        first
    }

    fn to_bytes(&self) -> Vec<u8> {
        let colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
        let header = format!(
            "ply\nformat binary_little_endian 1.0\n\
             element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{colour}\
             element face {}\nproperty list uchar int vertex_indices\n\
             element edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n",
            self.vertices.len(),
            self.faces.len(),
            self.edges.len()
        );
        let mut bytes = header.into_bytes();
        // The format has 32 bits for an index. A scene with more vertices would not fit into memory
        // as JSON either.
        let index = |index: usize| (index as u32).to_le_bytes();
        for (point, colour) in &self.vertices {
            bytes.extend(point.iter().flat_map(|coordinate| coordinate.to_le_bytes()));
            bytes.extend(colour);
        }
        for face in &self.faces {
            bytes.push(3);
            bytes.extend(face.iter().flat_map(|&vertex| index(vertex)));
        }
        for edge in &self.edges {
            bytes.extend(edge.iter().flat_map(|&vertex| index(vertex)));
        }
        bytes
    }
}
