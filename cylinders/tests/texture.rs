//! Matching without correspondences where the clutter is no chance: the edges of a floor, of a wall
//! or of boxes agree on directions and on circles, but they are no silhouettes.

#![cfg(feature = "command")]

mod textures;

use std::time::Instant;

use eliminant_cylinders::{MatchOptions, match_directions};
use textures::{Texture, TextureSetup};

/// Cylinders found and false ones, told nothing.
fn right_and_false(setup: &TextureSetup, seed: u64) -> [usize; 2] {
    let scene = setup.scene(seed);
    let lines: usize = scene.views.iter().map(|view| view.lines().len()).sum();
    let start = Instant::now();
    let found = match_directions(&scene.views, &MatchOptions::of(&scene.views));
    let time = start.elapsed();
    let found: Vec<_> = found.iter().flat_map(|matching| &matching.cylinders).map(|found| found.cylinder).collect();
    let [right, others] = scene.right_and_false(&found);
    println!("{setup:?}, seed {seed}, {lines} lines: {right} right, {others} false, {time:.1?}");
    [right, others]
}

#[track_caller]
fn check(setup: &TextureSetup, seeds: std::ops::Range<u64>) {
    for seed in seeds {
        assert_eq!(right_and_false(setup, seed), [setup.cylinders, 0], "{:?}, seed {seed}", setup.texture);
    }
}

#[test]
fn seven_cylinders_on_a_floor_grid_are_found_and_nothing_else() {
    check(&TextureSetup::new(Texture::Floor), 0..4);
}

#[test]
fn seven_cylinders_before_a_tiled_wall_are_found_and_nothing_else() {
    check(&TextureSetup::new(Texture::Wall), 0..4);
}

#[test]
fn seven_cylinders_before_boxes_are_found_and_nothing_else() {
    check(&TextureSetup::new(Texture::Boxes), 0..4);
}

/// Edges of boxes crowd together, so that chance makes circles among them more often than among
/// lines that are spread evenly.
#[test]
fn three_cylinders_before_boxes_are_found_and_nothing_else() {
    check(&TextureSetup { cylinders: 3, ..TextureSetup::new(Texture::Boxes) }, 100..108);
}

#[test]
fn texture_without_cylinders_gives_none() {
    for texture in [Texture::Floor, Texture::Wall, Texture::Boxes] {
        for seed in 10..13 {
            let scene = TextureSetup { cylinders: 0, ..TextureSetup::new(texture) }.scene(seed);
            let found = match_directions(&scene.views, &MatchOptions::of(&scene.views));
            let found: Vec<_> = found.iter().flat_map(|matching| &matching.cylinders).collect();
            // The tiles of a wall are flat bands, all cameras are on one side, and that is said.
            let doubtful = found.iter().filter(|found| !found.is_round(&scene.views)).count();
            println!("{texture:?}, seed {seed}: {} found, {doubtful} with a warning", found.len());
            assert_eq!(found.len(), doubtful, "{texture:?}, seed {seed}");
            assert!(found.is_empty() || matches!(texture, Texture::Wall), "{texture:?}, seed {seed}");
        }
    }
}

/// From a narrow range of angles the silhouettes on one side pass nearly through a point, as edges
/// do; from many images, those of near ones.
#[test]
fn silhouettes_are_not_taken_for_edges() {
    let three = TextureSetup { cylinders: 3, ..TextureSetup::new(Texture::None) };
    for (images, arc) in [(8, 0.5), (12, 1.0)] {
        check(&TextureSetup { images, arc, ..three }, 0..4);
    }
    check(&TextureSetup { images: 60, ..TextureSetup::new(Texture::None) }, 0..3);
}
