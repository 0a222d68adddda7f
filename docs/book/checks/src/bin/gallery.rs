//! Writes the gallery of the book, and its pictures.

use std::fs;
use std::process::ExitCode;

use eliminant_book_checks::{Gallery, gallery, page_path, root};

fn main() -> ExitCode {
    let written = gallery(&root()).and_then(|gallery| write(&gallery).map_err(|error| error.to_string()));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Writes the page and its pictures, and removes pictures of problems that are no more.
fn write(Gallery { page, pictures }: &Gallery) -> std::io::Result<()> {
    let folder = page_path("gallery");
    fs::create_dir_all(&folder)?;
    for (name, picture) in pictures {
        fs::write(folder.join(name), picture)?;
    }
    for file in fs::read_dir(&folder)? {
        let file = file?;
        if !file.file_name().to_str().is_some_and(|name| pictures.contains_key(name)) {
            fs::remove_file(file.path())?;
        }
    }
    fs::write(page_path("gallery.md"), page)
}
