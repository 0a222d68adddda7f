//! Output files.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::Path;

use super::error::CommandError;

/// Writes a whole file or nothing: if it fails, an existing file is unchanged. Only a regular file
/// is replaced, never a folder or a device.
pub(super) fn write(path: &Path, content: &[u8]) -> Result<(), CommandError> {
    let fail = |source: io::Error| CommandError::Write { path: path.to_owned(), source };
    if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return Err(fail(io::Error::other("it is not a regular file")));
    }
    let name = path.file_name().ok_or_else(|| fail(io::Error::other("it does not name a file")))?;
    // The temporary file is hidden, and its name differs from that of another run.
    let mut temporary = OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(temporary);
    let written = fs::write(&temporary, content).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|error| {
        // The temporary file is of no use. The error to report is that of writing, not of removing.
        let _ = fs::remove_file(&temporary);
        fail(error)
    })
}
