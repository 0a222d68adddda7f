//! Errors of a model.

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

/// Errors of a COLMAP model. Every message starts with the file and the line or byte in it.
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
        /// End of the file.
        at: Location,
        /// The record.
        record: String,
    },
    /// A binary file announces more than it can hold.
    #[error("{at}: {count} {records} are announced, but only {left} bytes follow: the file is cut short or damaged")]
    Count {
        /// Place of the count.
        at: Location,
        /// What is counted, such as images.
        records: String,
        /// The count.
        count: u64,
        /// Bytes after the count.
        left: usize,
    },
    /// A text file announces another number of records than it has.
    #[error("{at}: {announced} {records} are announced, but there are {found}: the file is cut short or damaged")]
    Announced {
        /// Place of the number.
        at: Location,
        /// What is counted, such as images.
        records: &'static str,
        /// Number announced.
        announced: usize,
        /// Number found.
        found: usize,
    },
    /// A binary file continues after its last record.
    #[error("{at}: the last of the {records} ends here, but the file continues")]
    Trailing {
        /// End of the last record.
        at: Location,
        /// What the records are, such as cameras.
        records: &'static str,
    },
    /// A name or a text file is not UTF-8.
    #[error("{at}: not UTF-8 text")]
    NotUtf8 {
        /// Place where the text is not UTF-8, or where the name starts.
        at: Location,
    },
    /// A field of a text file is missing or malformed.
    #[error("{at}: {field} should be {expected}, not `{found}`")]
    Field {
        /// Place in the file.
        at: Location,
        /// Name of the field.
        field: &'static str,
        /// What was expected.
        expected: &'static str,
        /// What was found.
        found: String,
    },
    /// A line of a text file has a wrong number of fields.
    #[error("{at}: {found} fields; {expected}")]
    FieldCount {
        /// Place in the file.
        at: Location,
        /// The numbers of fields of such a line.
        expected: &'static str,
        /// Number of fields.
        found: usize,
    },
    /// The distortion of the camera model is not supported.
    #[error(
        "{at}: camera {camera} has the model {model}; the models of COLMAP up to EUCM are supported (numbers 0 to 16); hint: `colmap image_undistorter` writes PINHOLE"
    )]
    UnsupportedModel {
        /// Place in the file.
        at: Location,
        /// Id of the camera.
        camera: u32,
        /// Name of the model, or its number if it has no known name.
        model: String,
    },
    /// The number of parameters of a camera is not that of its model.
    #[error("{at}: camera {camera} has {found} parameters; its model {model} has {expected}")]
    ParameterCount {
        /// Place in the file.
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
        /// Place in the file.
        at: Location,
        /// The record.
        record: String,
        /// What is wrong.
        what: &'static str,
    },
    /// Two records have the same id, or two images the same name.
    #[error("{at}: {record} occurs twice")]
    Repeated {
        /// Place of the second one.
        at: Location,
        /// The record.
        record: String,
    },
    /// An image names a camera that is not in the model.
    #[error("{at}: image `{image}` has camera {camera}, which is not in the model")]
    UnknownCamera {
        /// Place of the image.
        at: Location,
        /// Name of the image.
        image: String,
        /// Id of the camera.
        camera: u32,
    },
    /// A camera or a pose is not valid.
    #[error("{at}: {record}: {source}")]
    Invalid {
        /// Place in the file.
        at: Location,
        /// The record.
        record: String,
        /// Reason.
        source: ViewError,
    },
}
