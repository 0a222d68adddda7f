//! Pictures, as SVG and as PNG.
//!
//! A picture is drawn on a fine grid of four pixels to the unit. This grid is the coordinate system
//! of the SVG file. The PNG file has half the resolution: each of its pixels is the mean of four.

/// Axes: ranges, ticks, frame, legend.
mod axes;
/// The part of a line inside a window.
mod clip;
/// Conics of several methods, with the tangent lines.
mod conics;
/// Histograms of several samples.
mod histogram;
/// Series of points, lines and bands over linear and logarithmic axes.
mod plot;
/// The cross-section with its cameras, tangents and circles.
mod section;
/// The silhouettes in an image.
mod silhouettes;
/// Dashes and markers of series.
mod style;

use std::path::Path;

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::prelude::{BitMapBackend, DrawingBackend, IntoDrawingArea, SVGBackend, WHITE};
use plotters::style::{FontStyle, RGBColor, register_font};
use thiserror::Error;

pub use axes::{Axis, Scale};
pub use conics::ConicPicture;
pub use histogram::Histogram;
pub use plot::{Band, Plot, Series};
pub use section::SectionPicture;
pub use silhouettes::SilhouettePicture;

/// Pixels of the fine grid to a unit of length; a unit is a pixel of a screen.
const FINE: u32 = 4;

/// Pixels of the fine grid to one of a PNG file, in each direction.
const SMOOTH: u32 = 2;

/// Why a picture cannot be drawn.
#[derive(Debug, Error)]
pub enum PictureError {
    /// The extension of the file is neither SVG nor PNG.
    #[error("the name of a picture ends in .svg or .png")]
    UnknownFormat,
    /// The drawing library failed.
    #[error("the picture cannot be drawn: {0}")]
    Drawing(String),
    /// The PNG encoder failed.
    #[error("the picture cannot be encoded: {0}")]
    Encoding(#[from] png::EncodingError),
}

/// The result of drawing on a backend.
type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

/// A part of a picture, in pixels of the fine grid.
type Area<DB> = DrawingArea<DB, Shift>;

/// Something that can be drawn.
pub trait Picture {
    /// Width and height, units.
    fn size(&self) -> (u32, u32);

    /// Draws the picture on a white area of this size.
    #[doc(hidden)]
    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB>;
}

/// The format of a picture file.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Format {
    /// Scalable vector graphics.
    Svg,
    /// Portable network graphics, two pixels to the unit.
    Png,
}

impl Format {
    /// The format that belongs to the extension of a file name.
    ///
    /// # Errors
    /// [`PictureError::UnknownFormat`].
    pub fn of(path: &Path) -> Result<Self, PictureError> {
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
        match extension.as_deref().and_then(|extension| extension.to_str()) {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(PictureError::UnknownFormat),
        }
    }

    /// The file of a picture: the same bytes each time.
    ///
    /// # Errors
    /// [`PictureError::Drawing`], [`PictureError::Encoding`].
    pub fn render(self, picture: &impl Picture) -> Result<Vec<u8>, PictureError> {
        // The library measures and draws text only with the fonts that are registered here, not
        // with those of the system.
        register_font("sans-serif", FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
            .map_err(|_| PictureError::Drawing("the font cannot be read".to_owned()))?;
        match self {
            Self::Svg => svg(picture),
            Self::Png => png(picture),
        }
    }
}

fn fine((width, height): (u32, u32)) -> (u32, u32) {
    (width * FINE, height * FINE)
}

/// Converts a length in units to pixels of the fine grid.
fn units(length: f64) -> i32 {
    (length * f64::from(FINE)).round() as i32
}

fn rgb([red, green, blue]: super::palette::Colour) -> RGBColor {
    RGBColor(red, green, blue)
}

fn draw<DB: DrawingBackend>(picture: &impl Picture, backend: DB) -> Result<(), PictureError> {
    let area = backend.into_drawing_area();
    area.fill(&WHITE)
        .and_then(|()| picture.draw(&area))
        .and_then(|()| area.present())
        .map_err(|error| PictureError::Drawing(error.to_string()))
}

fn svg(picture: &impl Picture) -> Result<Vec<u8>, PictureError> {
    let (width, height) = picture.size();
    let fine = fine(picture.size());
    let mut text = String::new();
    draw(picture, SVGBackend::with_string(&mut text, fine))?;
    // The view box has the size of the grid; the size on the screen is that of the picture.
    let grid = format!("width=\"{}\" height=\"{}\"", fine.0, fine.1);
    Ok(text.replacen(&grid, &format!("width=\"{width}\" height=\"{height}\""), 1).into_bytes())
}

fn png(picture: &impl Picture) -> Result<Vec<u8>, PictureError> {
    let (width, height) = fine(picture.size());
    let row = 3 * width as usize;
    let mut grid = vec![0; row * height as usize];
    draw(picture, BitMapBackend::with_buffer(&mut grid, (width, height)))?;

    let smooth = SMOOTH as usize;
    let mut pixels = Vec::with_capacity(grid.len() / (smooth * smooth));
    for rows in grid.chunks_exact(row * smooth) {
        for x in 0..(width / SMOOTH) as usize {
            for channel in 0..3 {
                let place = |i: usize| (i / smooth) * row + (x * smooth + i % smooth) * 3 + channel;
                let sum: usize = (0..smooth * smooth).map(|i| usize::from(rows[place(i)])).sum();
                pixels.push((sum / (smooth * smooth)) as u8);
            }
        }
    }
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width / SMOOTH, height / SMOOTH);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(bytes)
}
