//! Cylinders in photographs: cameras and images to a report as JSON.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use eliminant_cylinders::detection::GreyImage;
use eliminant_cylinders::photograph::Photograph;
use eliminant_cylinders::photos::decode::decode_photograph;
use eliminant_cylinders::photos::{LineOptions, PhotoOptions, Seen, find_in_photographs, seen};
use eliminant_cylinders::{Interrupt, Scene, View, parse_scene, read_colmap};
use nalgebra::Point3;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::cylinders::{SCENE, check_directions, check_threshold, evidence, json, of_interruption, of_label};
use crate::cylinders::{refined, unit};
use crate::errors::CylinderError;
use crate::progress::Tally;
use crate::threads::interruptible;

/// Where cameras and images are, and how cylinders are found.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Photographs<'py> {
    /// A scene as JSON, or the folder of a COLMAP model.
    scene: Option<String>,
    model: Option<PathBuf>,
    /// The folder of the photographs, or their names and brightness, 0 to 255.
    folder: Option<PathBuf>,
    arrays: Vec<(String, PyReadonlyArray2<'py, f32>)>,
    threshold: f64,
    directions: Option<usize>,
    direction: Option<[f64; 3]>,
    has_points: bool,
}

/// The cylinders in photographs whose cameras are known: a JSON report. Between whiles `progress`
/// is called with the number of photographs in which lines were detected, and of all.
#[pyfunction]
#[pyo3(signature = (given, progress = None))]
pub(crate) fn cylinders_of_photographs(
    py: Python<'_>,
    given: Photographs<'_>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    check_threshold(Some(given.threshold))?;
    check_directions(given.directions)?;
    let Photographs { scene, model, folder, arrays, threshold, directions, direction, has_points } = given;
    let images = match folder {
        Some(folder) => Images::Files(folder),
        None => Images::Arrays(arrays.iter().map(|(name, array)| grey(name, array)).collect::<Result<_, _>>()?),
    };
    let tally = Tally::new(progress, 0);
    let work = |is_over: &AtomicBool| -> Result<_, String> {
        let interrupt = Interrupt::by(is_over);
        let (photographs, points) = cameras(scene, model)?;
        let scene = Scene { views: Vec::new(), points };
        evidence(&scene, has_points)?;
        tally.expect(photographs.len());
        let look = |photograph| look(photograph, &images, interrupt).inspect(|_| tally.add(1));
        let seen = all_of(photographs.par_iter().map(look).collect())?;
        let views: Vec<View> = seen.iter().map(|seen| seen.view.clone()).collect();
        let mut options = PhotoOptions::of(&views);
        options.matching.threshold = threshold;
        options.matching.interrupt = interrupt;
        options.directions = directions.unwrap_or(options.directions);
        let direction = direction.map(unit).transpose()?;
        let found = find_in_photographs(&seen, direction, &options).map_err(|error| of_label(None, &error))?;
        let scene = Scene { views: found.views, ..scene };
        refined(&scene, (threshold, &found.matching), evidence(&scene, has_points)?, interrupt)
    };
    let report = interruptible(py, work, |py| tally.tell(py))?;
    tally.tell(py)?;
    json(&report.map_err(CylinderError::new_err)?)
}

/// Where the photographs are.
enum Images {
    Files(PathBuf),
    Arrays(Vec<(String, GreyImage)>),
}

fn grey(name: &str, array: &PyReadonlyArray2<'_, f32>) -> PyResult<(String, GreyImage)> {
    let array = array.as_array();
    let (height, width) = array.dim();
    let image = GreyImage::new(width, height, array.iter().copied().collect());
    image
        .map(|image| (name.to_owned(), image))
        .map_err(|error| CylinderError::new_err(format!("image `{name}`: {error}")))
}

/// The photographs with their cameras, and the points of the scene or the model.
fn cameras(scene: Option<String>, model: Option<PathBuf>) -> Result<(Vec<Photograph>, Vec<Point3<f64>>), String> {
    if let Some(model) = model {
        let model = read_colmap(&model).map_err(|error| error.to_string())?;
        return Ok((model.photographs, model.points));
    }
    let scene = parse_scene(&scene.unwrap_or_default(), SCENE).map_err(|error| error.to_string())?;
    let photographs = scene.photographs().map_err(|view| format!("{SCENE}: view {view} has no name of its image"))?;
    Ok((photographs, scene.points))
}

/// What all photographs show; else the first error in the order of the photographs, whichever
/// thread failed first, and how many more there are.
fn all_of(looked: Vec<Result<Seen, String>>) -> Result<Vec<Seen>, String> {
    let failed = looked.iter().filter(|view| view.is_err()).count();
    let views: Result<Vec<_>, _> = looked.into_iter().collect();
    views.map_err(|first| match failed {
        1 => first,
        _ => format!("{first}; and {} more", failed - 1),
    })
}

/// Detects the candidates for silhouettes in a photograph.
fn look(photograph: &Photograph, images: &Images, interrupt: Interrupt<'_>) -> Result<Seen, String> {
    interrupt.check().map_err(of_interruption)?;
    let name = &photograph.name;
    let read;
    let image = match images {
        Images::Files(folder) => {
            read = decoded(&folder.join(name))?;
            &read
        }
        Images::Arrays(arrays) => match arrays.iter().find(|(of, _)| of == name) {
            Some((_, image)) => image,
            None => return Err(format!("there is no image `{name}`")),
        },
    };
    seen(photograph, image, &LineOptions { interrupt, ..LineOptions::default() }).map_err(|error| error.to_string())
}

fn decoded(path: &Path) -> Result<GreyImage, String> {
    let file = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    decode_photograph(&file).map_err(|error| format!("{}: {error}", path.display()))
}
