//! Photographs as files. They are embedded byte by byte, so that no decoder is needed; only type
//! and size are read from the file's header.

use std::fs;
use std::path::{Component, Path, PathBuf};

/// Larger files are not embedded, so that the page stays readable.
const LARGEST: u64 = 32 << 20;

/// A photograph that a browser shows.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ImageFile {
    pub(super) bytes: Vec<u8>,
    pub(super) media_type: &'static str,
    /// Width and height, pixels.
    pub(super) size: [u32; 2],
}

/// The photograph of this name in the first folder that has it; `None` if none has, or if the file
/// is no JPEG or PNG file or too large. A name that leads out of the folder is not followed.
pub(super) fn find(folders: &[PathBuf], name: &str) -> Option<ImageFile> {
    let is_inside = Path::new(name).components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    let paths = folders.iter().filter(|_| is_inside).map(|folder| folder.join(name));
    let path = paths.into_iter().find(|path| path.is_file())?;
    let is_small = fs::metadata(&path).is_ok_and(|metadata| metadata.len() <= LARGEST);
    is_small.then(|| fs::read(&path).ok())?.and_then(recognised)
}

fn recognised(bytes: Vec<u8>) -> Option<ImageFile> {
    let (media_type, size) = match png_size(&bytes) {
        Some(size) => ("image/png", size),
        None => ("image/jpeg", jpeg_size(&bytes)?),
    };
    size.iter().all(|&side| side > 0).then_some(ImageFile { bytes, media_type, size })
}

/// The first chunk of a PNG file, IHDR, starts with width and height.
fn png_size(bytes: &[u8]) -> Option<[u32; 2]> {
    let header = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?.get(4..)?.strip_prefix(b"IHDR")?;
    let side = |at: usize| Some(u32::from_be_bytes(*header.get(at..)?.first_chunk()?));
    Some([side(0)?, side(4)?])
}

/// A JPEG file is a sequence of segments: `FF`, marker, length, content. The frame header, markers
/// `C0` to `CF` but `C4`, `C8` and `CC`, has the precision and then height and width.
fn jpeg_size(bytes: &[u8]) -> Option<[u32; 2]> {
    let mut rest = bytes.strip_prefix(b"\xff\xd8")?;
    loop {
        let [first, marker, high, low, content @ ..] = rest else { return None };
        if *first != 0xff {
            return None;
        }
        match *marker {
            // A fill byte.
            0xff => rest = &rest[1..],
            0xc0..=0xcf if !matches!(*marker, 0xc4 | 0xc8 | 0xcc) => {
                let [_, h1, h0, w1, w0, ..] = content else { return None };
                return Some([[*w1, *w0], [*h1, *h0]].map(|side| u32::from(u16::from_be_bytes(side))));
            }
            _ => rest = rest.get(2 + usize::from(u16::from_be_bytes([*high, *low]))..)?,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_from_headers() {
        let png = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x01\x02\0\0\0\x03";
        assert_eq!(png_size(png), Some([258, 3]));
        let jpeg = b"\xff\xd8\xff\xe0\0\x04ab\xff\xff\xc2\0\x0b\x08\0\x03\x01\x02";
        assert_eq!(jpeg_size(jpeg), Some([258, 3]));
        for length in 0..jpeg.len() {
            assert_eq!(jpeg_size(&jpeg[..length]), None);
        }
        for length in 0..png.len() {
            assert_eq!(png_size(&png[..length]), None);
        }
    }

    #[test]
    fn names_that_lead_out_are_not_followed() {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src");
        assert_eq!(find(std::slice::from_ref(&folder), "../Cargo.toml"), None);
        assert_eq!(find(&[folder], "lib.rs"), None);
    }
}
