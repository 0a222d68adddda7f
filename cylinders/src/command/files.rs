//! Output files.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::error::CommandError;

/// A file to write: its path and its content.
pub(super) type File = (PathBuf, Vec<u8>);

/// Writes all files, or none: contents go to temporary files first, and these take their places
/// when all are written. If that fails, existing files are unchanged, and folders that were made
/// are removed. Only a regular file is replaced, never a folder or a device. Missing `folders` are
/// made.
pub(super) fn write_all(folders: &[&Path], files: &[File]) -> Result<(), CommandError> {
    let mut made = Vec::new();
    let mut temporaries = Vec::with_capacity(files.len());
    let written = folders
        .iter()
        .try_for_each(|folder| make_folder(folder, &mut made))
        .and_then(|()| files.iter().try_for_each(|file| write_temporary(file, &mut temporaries)))
        .and_then(|()| {
            let place = |(temporary, (path, _)): (&PathBuf, &File)| fs::rename(temporary, path).map_err(failure(path));
            temporaries.iter().zip(files).try_for_each(place)
        });
    if written.is_err() {
        // What was made is of no use. The error to report is that of writing, not of removing.
        for temporary in &temporaries {
            let _ = fs::remove_file(temporary);
        }
        for folder in made.iter().rev() {
            let _ = fs::remove_dir(folder);
        }
    }
    written
}

fn failure(path: &Path) -> impl Fn(io::Error) -> CommandError {
    let path = path.to_owned();
    move |source| CommandError::Write { path: path.clone(), source }
}

/// Makes a folder and those above it that are missing, and lists them.
fn make_folder(folder: &Path, made: &mut Vec<PathBuf>) -> Result<(), CommandError> {
    let missing: Vec<_> =
        folder.ancestors().take_while(|path| !path.as_os_str().is_empty() && !path.exists()).collect();
    made.extend(missing.into_iter().rev().map(Path::to_owned));
    fs::create_dir_all(folder).map_err(failure(folder))
}

fn write_temporary((path, content): &File, temporaries: &mut Vec<PathBuf>) -> Result<(), CommandError> {
    let fail = failure(path);
    if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return Err(fail(io::Error::other("it is not a regular file")));
    }
    let name = path.file_name().ok_or_else(|| fail(io::Error::other("it does not name a file")))?;
    // The temporary file is hidden, and its name differs from that of another run.
    let mut temporary = OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(temporary);
    temporaries.push(temporary.clone());
    fs::write(&temporary, content).map_err(fail)
}
