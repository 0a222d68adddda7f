//! The arguments that name the files of cameras and lines, shared by the subcommands that take a
//! scene.

use std::io::Read;
use std::path::{Path, PathBuf};

use super::error::CommandError;
use crate::colmap::Model;
use crate::{
    PixelOrigin, Scene, SegmentError, Segments, parse_segments, read_bundler, read_colmap, read_scene, read_segments,
    read_transforms,
};

/// The name of standard input.
const STDIN: &str = "-";

/// A scene file, or the cameras of another program with segments.
#[derive(clap::Args, Debug)]
pub(super) struct SceneArguments {
    /// Scene: cameras and silhouette lines, JSON
    #[arg(required_unless_present_any = CAMERAS, conflicts_with_all = CAMERAS)]
    scene: Option<PathBuf>,
    /// Folder of a COLMAP model with the cameras: cameras, images and perhaps points3D, binary or
    /// text
    #[arg(long, value_name = "FOLDER", requires = "segments", conflicts_with_all = ["transforms", "bundle"])]
    colmap: Option<PathBuf>,
    /// Cameras in the transforms.json of instant-ngp or nerfstudio
    #[arg(long, value_name = "JSON", requires = "segments", conflicts_with = "bundle")]
    transforms: Option<PathBuf>,
    /// Cameras in a bundle.out of Bundler, version 0.3
    #[arg(long, value_name = "FILE", requires_all = ["segments", "list"])]
    bundle: Option<PathBuf>,
    /// The images of the bundle: a line for each camera with its name, and perhaps width and height
    #[arg(long, value_name = "FILE", requires = "bundle")]
    list: Option<PathBuf>,
    /// Width and height of the images for which the list has none, pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", requires = "bundle", value_parser = image_size)]
    image_size: Option<[f64; 2]>,
    /// Line segments to add to the images: CSV with the columns image,x1,y1,x2,y2 and optionally
    /// cylinder,line, separated by commas, semicolons or tabs; - is standard input
    #[arg(long, value_name = "CSV")]
    segments: Option<PathBuf>,
    /// Which point of the upper left pixel is (0, 0) in the segments: its corner, as in COLMAP, or
    /// its centre, as in OpenCV
    #[arg(long, value_enum, default_value = "corner", requires = "segments")]
    pixel_origin: Origin,
}

/// The arguments that give cameras without lines.
const CAMERAS: [&str; 3] = ["colmap", "transforms", "bundle"];

/// [`PixelOrigin`] on the command line.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Origin {
    Corner,
    Centre,
}

fn image_size(text: &str) -> Result<[f64; 2], String> {
    let side = |text: &str| text.parse::<u32>().ok().filter(|&side| side > 0).map(f64::from);
    let sides = text.split_once('x').and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| "not a width and height such as 4000x3000".to_owned())
}

impl SceneArguments {
    /// The file that is named by messages about the whole scene.
    pub(super) fn path(&self) -> &Path {
        self.scene.as_ref().or(self.segments.as_ref()).map_or(Path::new(""), PathBuf::as_path)
    }

    /// The folders of the files that are read, in which photographs may be.
    pub(super) fn folders(&self) -> Vec<PathBuf> {
        let files = [&self.scene, &self.transforms, &self.list, &self.segments].into_iter().flatten();
        files.filter_map(|path| path.parent()).map(Path::to_owned).chain(self.colmap.clone()).collect()
    }

    /// Reads the scene, or cameras and their segments.
    pub(super) fn read(&self) -> Result<Scene, CommandError> {
        let segments = self.segments()?;
        match (&self.scene, &segments) {
            (Some(scene), Some(segments)) => Ok(read_scene(scene)?.with_segments(segments)?),
            (Some(scene), None) => Ok(read_scene(scene)?),
            (None, Some(segments)) => Ok(Scene::from_colmap(self.cameras()?, segments)?),
            // The parser of the command line rejects all other combinations.
            (None, None) => Err(CommandError::NoScene),
        }
    }

    fn cameras(&self) -> Result<Model, CommandError> {
        match (&self.colmap, &self.transforms, &self.bundle, &self.list) {
            (Some(folder), ..) => Ok(read_colmap(folder)?),
            (_, Some(transforms), ..) => Ok(read_transforms(transforms)?),
            (.., Some(bundle), Some(list)) => Ok(read_bundler(bundle, list, self.image_size)?),
            _ => Err(CommandError::NoScene),
        }
    }

    fn segments(&self) -> Result<Option<Segments>, SegmentError> {
        let Some(path) = self.segments.as_deref() else { return Ok(None) };
        let segments = if path == Path::new(STDIN) {
            let (mut text, file) = (Vec::new(), "standard input");
            match std::io::stdin().lock().read_to_end(&mut text) {
                Ok(_) => parse_segments(&text, file)?,
                Err(source) => return Err(SegmentError::Read { file: file.to_owned(), source }),
            }
        } else {
            read_segments(path)?
        };
        Ok(Some(segments.with_pixel_origin(match self.pixel_origin {
            Origin::Corner => PixelOrigin::Corner,
            Origin::Centre => PixelOrigin::Centre,
        })))
    }
}
