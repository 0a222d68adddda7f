//! Line segments are detected where they are: against edges that are known, and against the
//! detections of another implementation.

#![cfg(feature = "command")]

use eliminant_cylinders::detection::{DetectedSegment, GreyImage, detect_segments};
use eliminant_cylinders::distortion::Distortion;
use eliminant_cylinders::random::Random;
use eliminant_cylinders::rendering::RenderingSetup;
use nalgebra::{Point2, Vector2, distance};

/// Detections of OpenCV 5.0 (`createLineSegmentDetector` with `LSD_REFINE_ADV`) of 15 pixels or
/// more in the image of [`reference_image`], moved by half a pixel to our coordinates.
const REFERENCE: &str = include_str!("detection/reference.csv");

fn reference_image() -> GreyImage {
    let setup = RenderingSetup {
        cylinders: 3,
        images: 2,
        width: 400,
        height: 300,
        noise: 2.0,
        distortion: Distortion::default(),
    };
    setup.scene(5).expect("a scene").images.swap_remove(0)
}

fn reference() -> Vec<[Point2<f64>; 2]> {
    let row = |row: &str| {
        let numbers: Vec<f64> = row.split(',').map(|number| number.parse().expect("a number")).collect();
        [Point2::new(numbers[0], numbers[1]), Point2::new(numbers[2], numbers[3])]
    };
    REFERENCE.lines().skip(1).map(row).collect()
}

/// The part of a segment that is within a pixel of one of the others with nearly its direction.
fn covered(segment: &[Point2<f64>; 2], others: &[[Point2<f64>; 2]]) -> f64 {
    const STEPS: usize = 50;
    let along = (segment[1] - segment[0]).normalize();
    let near = |point: &Point2<f64>| {
        others.iter().any(|[start, end]| {
            let direction = end - start;
            let part = ((point - start).dot(&direction) / direction.norm_squared()).clamp(0.0, 1.0);
            // The brighter side is the same.
            distance(point, &(start + direction * part)) < 1.0 && direction.normalize().dot(&along) > 0.99
        })
    };
    let at = |step: usize| segment[0] + (segment[1] - segment[0]) * (step as f64 / STEPS as f64);
    (0..=STEPS).filter(|&step| near(&at(step))).count() as f64 / (STEPS + 1) as f64
}

#[test]
fn detections_agree_with_those_of_another_implementation() {
    let reference = reference();
    let found: Vec<_> = detect_segments(&reference_image()).iter().map(|segment| segment.ends).collect();
    let long: Vec<_> = found.iter().filter(|ends| distance(&ends[0], &ends[1]) >= 15.0).copied().collect();
    let share = |segments: &[[Point2<f64>; 2]], others: &[[Point2<f64>; 2]]| {
        let length = |ends: &[Point2<f64>; 2]| distance(&ends[0], &ends[1]);
        let all: f64 = segments.iter().map(length).sum();
        segments.iter().map(|ends| length(ends) * covered(ends, others)).sum::<f64>() / all
    };
    let (recall, precision) = (share(&reference, &found), share(&long, &reference));
    println!("{} reference, {} found; recall {recall:.3}, precision {precision:.3}", reference.len(), long.len());
    assert!(reference.len() > 50);
    assert!(recall > 0.95 && precision > 0.9, "{recall} {precision}");
}

/// An image with a bright half plane `normal^T x > offset`, by 8 x 8 samples to the pixel.
fn half_plane(normal: Vector2<f64>, offset: f64, noise: f64) -> GreyImage {
    let mut random = Random::new(7);
    let (width, height) = (160, 120);
    let value = |index: usize| {
        let inside = |sample: usize| {
            let x = (index % width) as f64 + ((sample % 8) as f64 + 0.5) / 8.0;
            let y = (index / width) as f64 + ((sample / 8) as f64 + 0.5) / 8.0;
            normal.dot(&Vector2::new(x, y)) > offset
        };
        let share = (0..64).filter(|&sample| inside(sample)).count() as f64 / 64.0;
        (60.0 + 120.0 * share + noise * random.normal()).round() as f32
    };
    GreyImage::new(width, height, (0..width * height).map(value).collect()).expect("an image")
}

#[test]
fn an_edge_is_found_within_a_tenth_of_a_pixel_and_its_bright_side_is_known() {
    for degrees in [0.0_f64, 3.0, 31.0, 45.0, 88.0, 90.0, 134.0, 200.0, 271.0, 300.0] {
        let normal = Vector2::new(degrees.to_radians().cos(), degrees.to_radians().sin());
        let offset = normal.dot(&Vector2::new(80.3, 59.6));
        let found = detect_segments(&half_plane(normal, offset, 2.0));
        let longest = found.iter().max_by(|a, b| a.length().total_cmp(&b.length())).expect("a segment");
        assert!(longest.length() > 95.0, "{degrees}: {}", longest.length());
        for end in longest.ends {
            assert!((normal.dot(&end.coords) - offset).abs() < 0.1, "{degrees}: {}", normal.dot(&end.coords) - offset);
        }
        let along = longest.ends[1] - longest.ends[0];
        assert!(Vector2::new(along.y, -along.x).normalize().dot(&normal) > 0.999, "{degrees}");
    }
}

#[test]
fn noise_and_degenerate_images_give_nothing() {
    let mut random = Random::new(3);
    let noise = (0..320 * 240).map(|_| (128.0 + 30.0 * random.normal()) as f32).collect();
    let found = detect_segments(&GreyImage::new(320, 240, noise).expect("an image"));
    assert!(found.len() <= 3, "{} segments in noise; one is expected", found.len());
    let nothing = |width, height, value| {
        let image = GreyImage::new(width, height, vec![value; width * height]).expect("an image");
        assert_eq!(detect_segments(&image), Vec::<DetectedSegment>::new(), "{width} x {height} of {value}");
    };
    for (width, height) in [(0, 0), (0, 5), (5, 0), (1, 1), (2, 1), (2, 2), (3, 50), (64, 64)] {
        for value in [0.0, 255.0, f32::NAN, f32::INFINITY] {
            nothing(width, height, value);
        }
    }
    assert!(GreyImage::new(2, 2, vec![0.0; 3]).is_err());
}

#[test]
fn unknown_pixels_have_no_edge() {
    let image = half_plane(Vector2::new(1.0, 0.2), 90.0, 0.0);
    let masked = image.warped(|point| (point.y < 60.0).then_some(point));
    let found = detect_segments(&masked);
    assert!(!found.is_empty());
    assert!(found.iter().flat_map(|segment| segment.ends).all(|end| end.y < 60.0));
}
