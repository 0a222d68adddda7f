//! What the tests of the book share: its pages, their blocks of code, and the gallery.

use std::path::{Path, PathBuf};
use std::{env, fs};

mod accuracy;
mod blocks;
mod comparison;
mod gallery;
mod histograms;
mod measured;
mod pictures;
mod reach;

pub use accuracy::accuracy;
pub use blocks::{Block, Mark, blocks};
pub use comparison::comparison;
pub use gallery::{Gallery, gallery};
pub use reach::reach;

/// The root of the project.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// A page of the book.
#[must_use]
pub fn page_path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../src").join(name)
}

/// The text of a page.
///
/// # Panics
/// Where it cannot be read: this is for tests.
#[must_use]
pub fn page(name: &str) -> String {
    fs::read_to_string(page_path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A file of the project, from its root.
///
/// # Panics
/// Where it cannot be read: this is for tests.
#[must_use]
pub fn file(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A page with another part between two marks; `None` where it has no such part.
fn replaced(page: &str, marks: [&str; 2], part: &str) -> Option<String> {
    let (head, rest) = page.split_once(marks[0])?;
    let (_, tail) = rest.split_once(marks[1])?;
    Some(format!("{head}{}\n{part}\n{}{tail}", marks[0], marks[1]))
}

/// The command `eliminant`: the one that the variable ELIMINANT names, or that of the project,
/// which `docs/book/check` builds.
#[must_use]
pub fn command() -> PathBuf {
    let built = || {
        let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
        target.join("release/eliminant")
    };
    env::var_os("ELIMINANT").map_or_else(built, PathBuf::from)
}
