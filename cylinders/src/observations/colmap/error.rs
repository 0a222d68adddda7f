//! What is wrong with a model.

use std::fmt;

use thiserror::Error;

use crate::observations::view::ViewError;

/// A place in a file of a model.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum Location {
    /// Line of a text file, from 1.
    Line {
        /// File name.
        file: String,
        /// Line.
        line: usize,
    },
    /// Offset in a binary file, from 0.
    Byte {
        /// File name.
        file: String,
        /// Offset.
        byte: usize,
    },
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { file, line } => write!(f, "{file}:{line}"),
            Self::Byte { file, byte } => write!(f, "{file}: byte {byte}"),
        }
    }
}

/// What is wrong with a COLMAP model. Every message starts with the file, then the line or byte in
/// it.
#[derive(Debug, Error)]
pub enum ColmapError {
    /// A file cannot be read.
    #[error("{file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The model has no images: their file is empty.
    #[error("{file}: there are no images")]
    NoImages {
        /// File name.
        file: String,
    },
    /// The file ends within a record.
    #[error("{at}: the file is cut short: it ends in {record}")]
    CutShort {
        /// Where it ends.
        at: Location,
        /// In what.
        record: String,
    },
    /// A binary file announces more than it can hold.
    #[error("{at}: {count} {records} are announced, but only {left} bytes follow: the file is cut short or damaged")]
    Count {
        /// Where the count stands.
        at: Location,
        /// What is counted.
        records: String,
        /// The count.
        count: u64,
        /// Bytes after the count.
        left: usize,
    },
    /// A text file announces another number of records than it has.
    #[error("{at}: {announced} {records} are announced, but there are {found}: the file is cut short or damaged")]
    Announced {
        /// Where the number stands.
        at: Location,
        /// What is counted.
        records: &'static str,
        /// Number announced.
        announced: usize,
        /// Number found.
        found: usize,
    },
    /// A binary file goes on after its last record.
    #[error("{at}: the last of the {records} ends here, but the file goes on")]
    Trailing {
        /// End of the last record.
        at: Location,
        /// What should have been all.
        records: &'static str,
    },
    /// A name or a text file is not UTF-8.
    #[error("{at}: not UTF-8 text")]
    NotUtf8 {
        /// Where the text stops to be UTF-8, or the name starts.
        at: Location,
    },
    /// A field of a text file is missing or not what it should be.
    #[error("{at}: {field} should be {expected}, not `{found}`")]
    Field {
        /// Where.
        at: Location,
        /// Name of the field.
        field: &'static str,
        /// What should stand there.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// A line of a text file has a number of fields that no such record has.
    #[error("{at}: {found} fields; {expected}")]
    FieldCount {
        /// Where.
        at: Location,
        /// What such a line has.
        expected: &'static str,
        /// Number of fields.
        found: usize,
    },
    /// A camera model whose distortion is not known here.
    #[error(
        "{at}: camera {camera} has the model {model}; known are SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL and OPENCV"
    )]
    UnsupportedModel {
        /// Where.
        at: Location,
        /// Id of the camera.
        camera: u32,
        /// Name of the model, or its number where that has no known name.
        model: String,
    },
    /// A camera has another number of parameters than its model.
    #[error("{at}: camera {camera} has {found} parameters; its model {model} has {expected}")]
    ParameterCount {
        /// Where.
        at: Location,
        /// Id of the camera.
        camera: u32,
        /// Name of the model.
        model: &'static str,
        /// Number of parameters of the model.
        expected: usize,
        /// Number of parameters found.
        found: usize,
    },
    /// A number is NaN or infinite, or a focal length or a quaternion is zero.
    #[error("{at}: {record} has {what}")]
    Value {
        /// Where.
        at: Location,
        /// Which record.
        record: String,
        /// What is wrong.
        what: &'static str,
    },
    /// Two records have the same id, or two images the same name.
    #[error("{at}: there is another {record}")]
    Repeated {
        /// Where the second is.
        at: Location,
        /// Which record.
        record: String,
    },
    /// An image names a camera that is not there.
    #[error("{at}: image `{image}` has camera {camera}, which is not in the model")]
    UnknownCamera {
        /// Where the image is.
        at: Location,
        /// Name of the image.
        image: String,
        /// Id of the camera.
        camera: u32,
    },
    /// A camera or a pose is refused.
    #[error("{at}: {record}: {source}")]
    Invalid {
        /// Where.
        at: Location,
        /// Which record.
        record: String,
        /// Reason.
        source: ViewError,
    },
}
