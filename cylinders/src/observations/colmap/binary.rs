//! Binary files. Each is a 64-bit count and that number of records. All numbers are little-endian.
//!
//! ```text
//!   cameras.bin    u32 id, i32 model number, u64 width, u64 height, f64 parameters
//!   images.bin     u32 id, 7 x f64 pose, u32 camera id, name up to a zero byte,
//!                  u64 count of (f64 x, f64 y, u64 point id)
//!   points3D.bin   u64 id, 3 x f64 position, 3 x u8 colour, f64 error,
//!                  u64 count of (u32 image id, u32 index)
//! ```

use nalgebra::Point3;

use super::camera::CameraModel;
use super::error::{ColmapError, Location};
use super::record::{CameraRecord, ImageRecord};

/// Bytes of the shortest camera: three parameters.
const CAMERA: u64 = 4 + 4 + 8 + 8 + 3 * 8;
/// Bytes of the shortest image: no name, no points.
const IMAGE: u64 = 4 + 7 * 8 + 4 + 1 + 8;
/// Bytes of the shortest point: no track.
const POINT: u64 = 8 + 3 * 8 + 3 + 8 + 8;
/// Bytes of a point observed in an image.
const OBSERVATION: u64 = 8 + 8 + 8;
/// Bytes of an image in the track of a point.
const TRACK: u64 = 4 + 4;

/// The cameras of `cameras.bin`.
pub(super) fn cameras((file, bytes): (&str, &[u8])) -> Result<Vec<CameraRecord>, ColmapError> {
    Reader::new(bytes, file, "cameras").records(CAMERA, |reader| {
        let at = reader.location();
        let id = reader.u32()?;
        let model = match CameraModel::from_number(i32::from_le_bytes(reader.take()?)) {
            Ok(model) => model,
            Err(model) => return Err(ColmapError::UnsupportedModel { at, camera: id, model }),
        };
        reader.numbers::<2>()?;
        let parameters = (0..model.parameter_count()).map(|_| reader.f64()).collect::<Result<_, _>>()?;
        Ok(CameraRecord { at, id, model, parameters })
    })
}

/// The images of `images.bin`.
pub(super) fn images((file, bytes): (&str, &[u8])) -> Result<Vec<ImageRecord>, ColmapError> {
    Reader::new(bytes, file, "images").records(IMAGE, |reader| {
        let at = reader.location();
        let id = reader.u32()?;
        let (quaternion, translation) = (reader.numbers()?, reader.numbers()?);
        let camera = reader.u32()?;
        let name = reader.name()?;
        reader.skip_counted("observed points", OBSERVATION)?;
        Ok(ImageRecord { at, id, quaternion, translation, camera, name })
    })
}

/// The points of `points3D.bin`.
pub(super) fn points((file, bytes): (&str, &[u8])) -> Result<Vec<Point3<f64>>, ColmapError> {
    Reader::new(bytes, file, "points").records(POINT, |reader| {
        let byte = reader.position;
        let id = reader.u64()?;
        let position: [f64; 3] = reader.numbers()?;
        if !position.iter().all(|coordinate| coordinate.is_finite()) {
            let at = Location::Byte { file: file.to_owned(), byte };
            let what = "a coordinate that is not a finite number";
            return Err(ColmapError::Value { at, record: format!("point {id}"), what });
        }
        reader.take::<3>()?;
        reader.f64()?;
        reader.skip_counted("images in the track", TRACK)?;
        Ok(Point3::from(position))
    })
}

/// The bytes of a file and the position of the reader.
struct Reader<'a> {
    bytes: &'a [u8],
    position: usize,
    file: &'a str,
    /// What the records are, such as cameras.
    records: &'static str,
    /// Number of the record that is being read, from 1.
    record: usize,
}

impl<'a> Reader<'a> {
    fn new(bytes: &'a [u8], file: &'a str, records: &'static str) -> Self {
        Self { bytes, position: 0, file, records, record: 0 }
    }

    /// All records of the file, which must end after them. `shortest` is the least number of bytes
    /// of a record.
    fn records<T>(
        mut self,
        shortest: u64,
        mut read: impl FnMut(&mut Self) -> Result<T, ColmapError>,
    ) -> Result<Vec<T>, ColmapError> {
        let count = self.count(self.records, shortest)?;
        let mut records = Vec::with_capacity(count);
        while records.len() < count {
            self.record += 1;
            records.push(read(&mut self)?);
        }
        match self.left() {
            0 => Ok(records),
            _ => Err(ColmapError::Trailing { at: self.location(), records: self.records }),
        }
    }

    /// A count of items of at least `size` bytes each. It is never more than the remaining bytes
    /// can hold.
    fn count(&mut self, things: &str, size: u64) -> Result<usize, ColmapError> {
        let at = self.location();
        let count = self.u64()?;
        let left = self.left();
        match usize::try_from(count) {
            Ok(fitting) if count.checked_mul(size).is_some_and(|bytes| bytes <= left as u64) => Ok(fitting),
            _ => Err(ColmapError::Count { at, records: things.to_owned(), count, left }),
        }
    }

    /// Skips a count and that number of items of `size` bytes.
    fn skip_counted(&mut self, things: &str, size: u64) -> Result<(), ColmapError> {
        // The count is at most the number of bytes in memory.
        self.position += self.count(things, size)? * size as usize;
        Ok(())
    }

    /// Text up to a zero byte, which is skipped.
    fn name(&mut self) -> Result<String, ColmapError> {
        let at = self.location();
        let rest = &self.bytes[self.position..];
        let length = rest.iter().position(|&byte| byte == 0).ok_or_else(|| self.cut_short())?;
        self.position += length + 1;
        match std::str::from_utf8(&rest[..length]) {
            Ok(name) => Ok(name.to_owned()),
            Err(_) => Err(ColmapError::NotUtf8 { at }),
        }
    }

    fn numbers<const COUNT: usize>(&mut self) -> Result<[f64; COUNT], ColmapError> {
        let mut numbers = [0.0; COUNT];
        for number in &mut numbers {
            *number = self.f64()?;
        }
        Ok(numbers)
    }

    fn f64(&mut self) -> Result<f64, ColmapError> {
        Ok(f64::from_le_bytes(self.take()?))
    }

    fn u64(&mut self) -> Result<u64, ColmapError> {
        Ok(u64::from_le_bytes(self.take()?))
    }

    fn u32(&mut self) -> Result<u32, ColmapError> {
        Ok(u32::from_le_bytes(self.take()?))
    }

    fn take<const COUNT: usize>(&mut self) -> Result<[u8; COUNT], ColmapError> {
        let taken = self.bytes[self.position..].first_chunk().ok_or_else(|| self.cut_short())?;
        self.position += COUNT;
        Ok(*taken)
    }

    fn left(&self) -> usize {
        self.bytes.len() - self.position
    }

    fn location(&self) -> Location {
        Location::Byte { file: self.file.to_owned(), byte: self.position }
    }

    fn cut_short(&self) -> ColmapError {
        let at = Location::Byte { file: self.file.to_owned(), byte: self.bytes.len() };
        let record = match self.record {
            0 => format!("the count of {}", self.records),
            record => format!("record {record} of its {}", self.records),
        };
        ColmapError::CutShort { at, record }
    }
}
