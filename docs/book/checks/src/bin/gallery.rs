//! Writes the gallery of the book.

use std::fs;
use std::process::ExitCode;

use eliminant_book_checks::{gallery, page_path, root};

fn main() -> ExitCode {
    let written =
        gallery(&root()).and_then(|text| fs::write(page_path("gallery.md"), text).map_err(|error| error.to_string()));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
