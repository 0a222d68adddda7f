//! JPEG and PNG files to grey images, and grey images to PNG files.

use std::io::Cursor;

use thiserror::Error;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use crate::detection::{GreyError, GreyImage};

/// First bytes of a PNG file.
const PNG: &[u8] = b"\x89PNG";
/// First bytes of a JPEG file.
const JPEG: &[u8] = b"\xff\xd8";

/// Weights of red, green and blue in brightness (ITU-R BT.601, that of JPEG files).
const BRIGHTNESS: [f32; 3] = [0.299, 0.587, 0.114];

/// Why a file is not a photograph.
#[derive(Debug, Error)]
pub enum DecodeError {
    /// The file starts like neither.
    #[error("it is neither a JPEG nor a PNG file")]
    UnknownFormat,
    /// The JPEG decoder failed.
    #[error("the JPEG file cannot be decoded: {0}")]
    Jpeg(String),
    /// The PNG decoder failed.
    #[error("the PNG file cannot be decoded: {0}")]
    Png(#[from] png::DecodingError),
    /// The decoder gave another number of values.
    #[error(transparent)]
    Size(#[from] GreyError),
}

/// The kind of file, as browsers name it; `None` if it is no photograph.
pub fn media_type(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        _ if bytes.starts_with(PNG) => Some("image/png"),
        _ if bytes.starts_with(JPEG) => Some("image/jpeg"),
        _ => None,
    }
}

/// The brightness of a photograph, JPEG or PNG, 0 to 255. What a file says about its orientation is
/// ignored, as cameras from structure from motion ignore it.
///
/// # Errors
/// [`DecodeError`].
pub fn decode_photograph(bytes: &[u8]) -> Result<GreyImage, DecodeError> {
    match media_type(bytes) {
        Some("image/png") => png(bytes),
        Some(_) => jpeg(bytes),
        None => Err(DecodeError::UnknownFormat),
    }
}

fn jpeg(bytes: &[u8]) -> Result<GreyImage, DecodeError> {
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::Luma);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    let failure = |error: zune_jpeg::errors::DecodeErrors| DecodeError::Jpeg(format!("{error:?}"));
    let values = decoder.decode().map_err(failure)?;
    let (width, height) = decoder.dimensions().ok_or_else(|| DecodeError::Jpeg("it has no size".to_owned()))?;
    Ok(GreyImage::new(width, height, values.into_iter().map(f32::from).collect())?)
}

fn png(bytes: &[u8]) -> Result<GreyImage, DecodeError> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info()?;
    let mut values = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let frame = reader.next_frame(&mut values)?;
    values.truncate(frame.buffer_size());
    let brightness = |pixel: &[u8]| match pixel {
        [red, green, blue, ..] => {
            [*red, *green, *blue].iter().zip(BRIGHTNESS).map(|(value, weight)| f32::from(*value) * weight).sum()
        }
        // Grey, perhaps with opacity.
        [grey, ..] => f32::from(*grey),
        [] => f32::NAN,
    };
    let grey = values.chunks_exact(frame.color_type.samples()).map(brightness).collect();
    Ok(GreyImage::new(frame.width as usize, frame.height as usize, grey)?)
}

/// A PNG file of an image. Unknown pixels are black.
///
/// # Errors
/// [`png::EncodingError`], for an image without pixels too.
pub fn encode_png(image: &GreyImage) -> Result<Vec<u8>, png::EncodingError> {
    let size = |length: usize| u32::try_from(length).unwrap_or(0);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size(image.width()), size(image.height()));
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    // The conversion saturates, and turns what is not a number into 0.
    let values: Vec<_> = image.values().iter().map(|value| value.round() as u8).collect();
    writer.write_image_data(&values)?;
    writer.finish()?;
    Ok(bytes)
}
