//! Problems whose names mean something in C and C++ give headers that compile.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use eliminant_capi_generator::{Interface, cpp_header, header};
use eliminant_generator::problem::Problem;

/// Names that are keywords, parameters of the functions, and each other's lengths.
const ODD: &str = "\
/// Ends no comment: */ and begins none: /*
fn template(double: [f64; 2], count: f64, double_: [f64; 2], x: [f64; 2], x_length: f64) -> (class, class_) {
    double[0] * class * class + double[1] * class_ == count + x[0];
    double_[0] * class_ * class_ + double_[1] * class == x_length + x[1];
    Found { private: class * class_, public: [class, class_] }
}
";

fn odd() -> Interface {
    let problem = Problem::parse("template.rs", ODD).unwrap_or_else(|messages| panic!("{}", messages.render()));
    Interface::new(&problem, 4)
}

/// Whether a compiler accepts a file; `None` where there is no such compiler.
fn compiles(compiler: &str, options: &[&str], file: &str) -> Option<bool> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let output = Command::new(compiler)
        .args(["-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only"])
        .args(options)
        .arg(folder.join(file))
        .output()
        .ok()?;
    println!("{}", String::from_utf8_lossy(&output.stderr));
    Some(output.status.success())
}

#[test]
fn names_of_the_languages_are_left_to_them() {
    let odd = odd();
    let names = |fields: &[eliminant_capi_generator::Field]| -> Vec<String> {
        fields.iter().map(|field| field.c_name.clone()).collect()
    };
    assert_eq!(names(&odd.data), ["double_", "count_", "double__", "x", "x_length_"]);
    assert_eq!(names(&odd.rows[0].fields), ["class_", "class__"]);
    assert_eq!(names(&odd.rows[1].fields), ["private_", "public_"]);
}

#[test]
fn headers_of_odd_names_compile() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let files = [
        ("odd.h", header("odd", &[odd()])),
        ("odd.hpp", cpp_header("odd", &[odd()])),
        ("odd.c", "#include \"odd.h\"\nint main(void) { return 0; }\n".to_owned()),
        ("odd.cpp", "#include \"odd.hpp\"\nint main() {}\n".to_owned()),
    ];
    for (name, text) in files {
        fs::write(folder.join(name), text).expect("written");
    }
    for (compiler, options, file) in
        [("gcc", "-std=c99", "odd.c"), ("g++", "-std=c++17", "odd.cpp"), ("g++", "-std=c++20", "odd.cpp")]
    {
        match compiles(compiler, &[options, "-DODD_NO_EIGEN"], file) {
            Some(is_good) => assert!(is_good, "{compiler} {options}"),
            None => println!("left out: there is no {compiler}"),
        }
    }
}
