//! Writes the headers that a build made.

use std::io;
use std::path::Path;

/// Writes headers, each with its name, into a folder that is made where it is missing.
///
/// # Errors
/// Errors of the file system.
pub fn write_headers(headers: &[(&str, &str)], folder: &Path) -> io::Result<()> {
    std::fs::create_dir_all(folder)?;
    headers.iter().try_for_each(|(name, text)| std::fs::write(folder.join(name), text))
}
