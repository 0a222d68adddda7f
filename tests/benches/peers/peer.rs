//! The side of a peer: our driver, compiled with the peer's own code, in a process that takes turns
//! with this one.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::{env, fs};

use crate::cases::Side;

/// A driver that was compiled.
pub(crate) struct Driver {
    /// `poselib` or `circles`.
    pub(crate) name: &'static str,
    /// How it was compiled, for the table.
    pub(crate) build: &'static str,
    /// The program.
    pub(crate) program: PathBuf,
}

const NATIVE: &str = "-march=native";

/// Drivers of all peers that the environment names, and why others are missing.
///
/// - `POSELIB_PREFIX`, `POSELIB_NATIVE_PREFIX`: where PoseLib is installed, built as it is by
///   default, and with `-DMARCH_NATIVE=ON`.
/// - `CYLINDER_TRIANGULATION_SOURCE`: a checkout of the code of Gummeson and Oskarsson.
/// - `EIGEN_INCLUDE`: the headers of Eigen, if not in `/usr/include/eigen3`.
/// - `CXX`: the compiler, if not `c++`.
pub(crate) fn drivers() -> (Vec<Driver>, Vec<String>) {
    let (mut drivers, mut missing) = (Vec::new(), Vec::new());
    let mut add = |result: Result<Driver, String>| match result {
        Ok(driver) => drivers.push(driver),
        Err(reason) => missing.push(reason),
    };
    for (variable, build) in [("POSELIB_PREFIX", "-O3"), ("POSELIB_NATIVE_PREFIX", "-O3 -march=native")] {
        add(named(variable).and_then(|prefix| poselib(&prefix, build)));
    }
    match named("CYLINDER_TRIANGULATION_SOURCE") {
        Ok(source) => {
            for build in ["-O3", "-O3 -march=native"] {
                add(circles(&source, build));
            }
        }
        Err(reason) => add(Err(reason)),
    }
    (drivers, missing)
}

fn named(variable: &str) -> Result<PathBuf, String> {
    let value = env::var_os(variable).ok_or_else(|| format!("{variable} is not set"))?;
    Ok(PathBuf::from(value))
}

fn poselib(prefix: &Path, build: &'static str) -> Result<Driver, String> {
    let folder = ["lib", "lib64"].map(|folder| prefix.join(folder)).into_iter().find(|folder| folder.is_dir());
    let folder = folder.ok_or_else(|| format!("{} has no folder lib", prefix.display()))?;
    let include = [OsString::from("-I"), prefix.join("include").into()];
    let link = [OsString::from("-L"), folder.into(), "-lPoseLib".into()];
    compile("poselib", build, &include, &link)
}

fn circles(source: &Path, build: &'static str) -> Result<Driver, String> {
    let matlab = drivers_folder().join("matlab");
    let include = [OsString::from("-I"), matlab.into(), "-I".into(), source.join("solvers").into()];
    compile("circles", build, &include, &[])
}

fn drivers_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers/drivers")
}

fn compile(name: &'static str, build: &'static str, include: &[OsString], link: &[OsString]) -> Result<Driver, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let suffix = if build.contains(NATIVE) { "-native" } else { "" };
    let program = folder.join(format!("{name}{suffix}"));
    let compiler = env::var_os("CXX").unwrap_or_else(|| "c++".into());
    let eigen = env::var_os("EIGEN_INCLUDE").unwrap_or_else(|| "/usr/include/eigen3".into());
    let output = Command::new(&compiler)
        .args(["-std=c++17", "-o"])
        .arg(&program)
        .args(build.split(' '))
        .args(include)
        .arg("-I")
        .arg(eigen)
        .arg(drivers_folder().join(format!("{name}.cpp")))
        .args(link)
        .output()
        .map_err(|error| format!("{}: {error}", compiler.display()))?;
    if output.status.success() {
        Ok(Driver { name, build, program })
    } else {
        Err(format!("the driver {name} does not compile:\n{}", String::from_utf8_lossy(&output.stderr)))
    }
}

impl Driver {
    /// Starts the driver on the instances of a file.
    pub(crate) fn start(&self, case: &str, file: &Path) -> io::Result<Peer> {
        let mut child =
            Command::new(&self.program).arg(case).arg(file).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let missing = || io::Error::other("the driver has no pipe");
        let input = child.stdin.take().ok_or_else(missing)?;
        let output = BufReader::new(child.stdout.take().ok_or_else(missing)?);
        Ok(Peer { child, input: Some(input), output })
    }
}

/// A driver that runs.
pub(crate) struct Peer {
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
}

impl Peer {
    fn ask(&mut self, question: &str) -> Vec<f64> {
        let mut line = String::new();
        if let Some(input) = &mut self.input
            && writeln!(input, "{question}").and_then(|()| input.flush()).is_ok()
            && self.output.read_line(&mut line).is_ok()
        {
            return line.split_whitespace().map(|word| word.parse().unwrap_or(f64::NAN)).collect();
        }
        Vec::new()
    }
}

impl Side for Peer {
    /// Not a number if the driver has ended.
    fn time(&mut self, first: usize, count: usize) -> f64 {
        self.ask(&format!("time {first} {count}")).first().copied().unwrap_or(f64::NAN)
    }

    fn solutions(&mut self, index: usize) -> Vec<f64> {
        self.ask(&format!("solutions {index}")).get(1..).unwrap_or_default().to_vec()
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        // The driver ends with its input.
        self.input = None;
        let _ = self.child.wait();
    }
}
