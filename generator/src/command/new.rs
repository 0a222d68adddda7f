//! `eliminant new`: a commented problem file to start from.

use std::fmt;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::PathBuf;

use serde::Serialize;

use super::error::CommandError;
use super::report::Output;
use crate::problem::Problem;

/// Write a commented problem file to start from
#[derive(clap::Args, Debug)]
#[command(after_help = "Example:
  eliminant new two_circles --dir problems    writes problems/two_circles.rs")]
pub(super) struct Arguments {
    /// Name of the problem, of its file and of its solver; a Rust identifier
    #[arg(value_parser = problem_name)]
    name: String,
    /// Folder of the file; made if there is none
    #[arg(long, default_value = ".")]
    dir: PathBuf,
}

#[derive(Serialize)]
struct NewProblemReport {
    problem: String,
    file: String,
}

impl fmt::Display for NewProblemReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "wrote {0}\nnext: eliminant check {0}", self.file)
    }
}

/// A name is valid if the language takes a problem of that name.
fn problem_name(name: &str) -> Result<String, String> {
    syn::parse_str::<syn::Ident>(name)
        .map_err(|_| "expected a Rust identifier that is no keyword, such as `two_circles`".to_owned())?;
    match Problem::parse(name, &starter(name)) {
        Ok(_) => Ok(name.to_owned()),
        Err(diagnostics) => {
            Err(diagnostics.messages.iter().map(|message| message.message.as_str()).collect::<Vec<_>>().join("; "))
        }
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let path = arguments.dir.join(format!("{}.rs", arguments.name));
    fs::create_dir_all(&arguments.dir).map_err(|source| CommandError::Write { path: arguments.dir.clone(), source })?;
    let created = OpenOptions::new().write(true).create_new(true).open(&path);
    let mut file = created.map_err(|source| match source.kind() {
        io::ErrorKind::AlreadyExists => CommandError::Exists { path: path.clone() },
        _ => CommandError::Write { path: path.clone(), source },
    })?;
    file.write_all(starter(&arguments.name).as_bytes()).map_err(|source| {
        // No file is better than half a file. If it cannot be removed either, the first error is
        // still the one to report.
        let _ = fs::remove_file(&path);
        CommandError::Write { path: path.clone(), source }
    })?;
    Ok(Output::of(&NewProblemReport { problem: arguments.name.clone(), file: path.display().to_string() }))
}

fn starter(name: &str) -> String {
    format!(
        "\
//! A problem file is Rust syntax, so editors and rustfmt work on it. It is never compiled: the body
//! is interpreted symbolically. Parameters are the data, known when the solver runs. The names in
//! the return type are the unknowns, scalars as here or arrays such as `v: [f64; 3]`. A vector
//! whose length is free, so that any multiple is a solution, too, is `#[projective] v: [f64; 3]`.
//!
//! `eliminant check {name}.rs` counts the solutions.
//! `eliminant search {name}.rs` finds an elimination template.

/// The intersection of two conics: 4 solutions.
///
/// These lines become the documentation of the solver: what is solved, what the data are, and where
/// the problem comes from. `p` and `q` hold the coefficients of x^2, x y, y^2, x, y, 1.
///
/// If data satisfy a condition, an attribute states it:
/// `#[symmetric] m: [[f64; 3]; 3]`, `#[rotation] r: [[f64; 3]; 3]`, `#[unit] u: [f64; 3]`,
/// `#[plucker] l: [[f64; 3]; 2]`, `#[integer] n: f64`, `#[rank(2)] f: [[f64; 3]; 3]`.
/// Means over any number of measurements are `#[mean(of_point)] m: [f64; 4]`, with a function
/// `of_point` of this file that says what one of them gives.
fn {name}(p: [f64; 6], q: [f64; 6]) -> (x, y) {{
    // `let` names an intermediate value, here an array of six polynomials.
    // Powers are written `x * x` or `x.pow(2)`.
    let monomials = [x.pow(2), x * y, y.pow(2), x, y, 1];
    // A statement with `==` is an equation. Between arrays it holds for every element. Other
    // functions of the language are det, trace, cross, skew, identity and gradient; `.t()`
    // transposes a matrix.
    dot(p, monomials) == 0;
    dot(q, monomials) == 0;
    // `x != 0;` would exclude the solutions with x = 0.
}}
"
    )
}
