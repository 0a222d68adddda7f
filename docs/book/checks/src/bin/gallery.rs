//! Writes what the book shows of the catalogue: the gallery with its pictures, and the tables of
//! pages that follow from other tables: templates beside published ones, accuracy before and now,
//! and how far the aims of speed are.

use std::fs;
use std::process::ExitCode;

use eliminant_book_checks::{Gallery, accuracy, comparison, file, gallery, page, page_path, reach, root};

fn main() -> ExitCode {
    match write_all() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write_all() -> Result<(), String> {
    let text = |error: std::io::Error| error.to_string();
    fs::write(page_path("comparison.md"), comparison(&root())?).map_err(text)?;
    fs::write(page_path("accuracy.md"), accuracy(&file("templates/README.md"), &page("accuracy.md"))?).map_err(text)?;
    fs::write(page_path("speed.md"), reach(&file("README.md"), &page("speed.md"))?).map_err(text)?;
    write(&gallery(&root())?).map_err(text)
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
