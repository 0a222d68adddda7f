//! Output files.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::Path;

use super::error::CommandError;

/// Writes all of a file or nothing; where it fails, an old file is untouched. Only files are replaced: no folder, no device.
pub(super) fn write(path: &Path, content: &[u8]) -> Result<(), CommandError> {
    let fail = |source: io::Error| CommandError::Write { path: path.to_owned(), source };
    if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return Err(fail(io::Error::other("it is no regular file")));
    }
    let name = path.file_name().ok_or_else(|| fail(io::Error::other("it names no file")))?;
    // Hidden, and apart from that of another run.
    let mut temporary = OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(temporary);
    let written = fs::write(&temporary, content).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|error| {
        // What is left of it is of no use; the error to report is the first one.
        let _ = fs::remove_file(&temporary);
        fail(error)
    })
}
