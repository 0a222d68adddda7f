//! `cylinders triangulate`: silhouette lines and cameras in, cylinder out.

use std::ffi::OsString;
use std::io;
use std::process::ExitCode;

use eliminant_cylinders::command;

fn main() -> ExitCode {
    let subcommand = ["cylinders", "triangulate"].map(OsString::from);
    let arguments = subcommand.into_iter().chain(std::env::args_os().skip(1));
    ExitCode::from(command::run(arguments, &mut io::stdout(), &mut io::stderr()))
}
