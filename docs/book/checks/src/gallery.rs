//! The page of all problems of the catalogue, by families.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use eliminant_generator::generate::plan;
use eliminant_generator::plan::Plan;
use eliminant_generator::plan::picture::Picture;
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;

use crate::histograms::Histograms;
use crate::measured::Measured;
use crate::pictures::svg;

/// What begins the page.
const HEAD: &str = "\
# Gallery of the catalogue

All problems that come with Eliminant, by families. A family is a feature of `eliminant-solvers`,
and so is each problem. A problem of several families stands in the first. Each entry says what is
given and sought, and leads to the problem file, which cites its source. The template has so many
rows x columns, beside the published one with the fewest rows, and |B| is the size of the eigenvalue
problem. The time of `solve` is predicted, for one core of an EPYC processor. Scenes are data as
users have them, without noise: on so many of them `solve` returns all solutions that are known, and
the error is log10 of that of the nearest solution, relative to the known one.

Each picture shows the template: excess columns in blue, reducible ones in orange, those of the
basis in green, paler where an earlier block has solved a column. Beside it stand two histograms of
log10: of the relative residuals of all solutions of random data, and of the errors of scenes. The
last bin holds what is missing, too.

[templates/README.md](../../../templates/README.md) cites the publications, has more figures and the
commands that give them.

This page is written by

```sh
cargo run --manifest-path docs/book/checks/Cargo.toml --bin gallery
```

from the problem files, their templates and those figures, with the pictures, and a test tells when
it is not fresh.
";

/// The families in the order of the page, with their titles. Problems of no family are the last.
const FAMILIES: [(&str, &str); 9] = [
    ("absolute-pose", "Pose of a camera from known points"),
    ("relative-pose", "Relative pose of two cameras"),
    ("circle", "Circles that touch lines"),
    ("triangulation", "Points from three views"),
    ("ranging", "Positions from ranges"),
    ("generalized-camera", "Cameras without a common centre"),
    ("radial-distortion", "Unknown radial distortion"),
    ("focal-length", "Unknown focal length"),
    ("least-squares", "Stationary points of a cost"),
];

struct Entry {
    problem: Problem,
    template: TemplateFile,
}

/// The page, and its pictures.
pub struct Gallery {
    /// The page in Markdown.
    pub page: String,
    /// The names and the texts of the files in the folder `gallery` beside the page.
    pub pictures: BTreeMap<String, String>,
}

/// What was measured.
struct Figures {
    measured: Measured,
    histograms: Histograms,
}

/// The whole page.
///
/// # Errors
/// A message, where a problem, a template, the manifest of the solvers or what was measured cannot
/// be read.
pub fn gallery(root: &Path) -> Result<Gallery, String> {
    let mut entries = entries(&root.join("templates"))?;
    let histograms = Histograms::of(&read(&root.join("templates/histograms.csv"))?);
    let figures = Figures {
        measured: Measured::of(&read(&root.join("templates/README.md"))?),
        histograms: histograms.map_err(|error| format!("templates/histograms.csv: {error}"))?,
    };
    let families = families(&root.join("solvers/Cargo.toml"))?;
    let mut gallery = Gallery { page: HEAD.to_owned(), pictures: BTreeMap::new() };
    for (family, title) in FAMILIES {
        let members = families.get(family).ok_or_else(|| format!("there is no family `{family}`"))?;
        let names: Vec<String> = entries.keys().filter(|name| members.contains(*name)).cloned().collect();
        let of_family: Vec<Entry> = names.iter().filter_map(|name| entries.remove(name)).collect();
        gallery.section((title, &format!("Feature `{family}`.")), &of_family, &figures)?;
    }
    let rest: Vec<Entry> = entries.into_values().collect();
    gallery.section(("Others", "Problems of no family."), &rest, &figures)?;
    Ok(gallery)
}

impl Gallery {
    fn section(&mut self, (title, what): (&str, &str), entries: &[Entry], figures: &Figures) -> Result<(), String> {
        if entries.is_empty() {
            return Ok(());
        }
        let _ = write!(self.page, "\n## {title}\n\n{what}\n");
        for entry in entries {
            let planned = plan(&entry.problem, &entry.template).map_err(|error| error.to_string())?;
            self.page.push_str(&text(entry, &planned.plan, &figures.measured));
            let name = &entry.problem.name;
            let [residuals, errors] = ["residual", "error"].map(|figure| figures.histograms.get(name, figure));
            let picture = Picture::new(&entry.template.template, &planned.plan);
            self.pictures.insert(format!("{name}.svg"), svg(&picture, &residuals?, &errors?));
        }
        Ok(())
    }
}

fn text(Entry { problem, template }: &Entry, plan: &Plan, measured: &Measured) -> String {
    let name = &problem.name;
    let title: Vec<&str> = problem.docs.iter().map(|line| line.trim()).take_while(|line| !line.is_empty()).collect();
    let shaped = |name: &str, shape: &[usize]| {
        let dimensions: String = shape.iter().map(|length| format!("[{length}]")).collect();
        format!("`{name}{dimensions}`")
    };
    let data: Vec<String> = problem.data.iter().map(|data| shaped(&data.name, &data.shape)).collect();
    let data = if data.is_empty() { "nothing".to_owned() } else { data.join(", ") };
    let unknowns: Vec<String> = problem.fields.iter().map(|field| shaped(&field.name, &field.shape)).collect();
    let result = problem.output.as_ref().map_or(String::new(), |output| format!("; returns `{}`", output.name));
    let (rows, columns) = (template.template.rows(), template.template.columns());
    let basis = template.template.basis.len();
    let mut text = format!("\n### {name}\n\n");
    wrap(&mut text, "", &title.join(" "));
    text.push('\n');
    wrap(&mut text, "- ", &format!("given {data}; sought {}{result}", unknowns.join(", ")));
    let published = measured.smallest_published(name).map_or(String::new(), |size| format!(", published {size}"));
    let facts = format!("{} solutions, template {rows}x{columns}{published}, |B| = {basis}", template.solutions);
    wrap(&mut text, "- ", &facts);
    let time = time(plan.predicted_nanoseconds(0.0));
    let column = |column| measured.cell(name, column);
    let scenes = match (column("scenes"), column("recovered"), column("forward median"), column("forward p99")) {
        (Some(scenes), Some(recovered), Some(median), Some(p99)) => {
            let share = match recovered.parse::<f64>() {
                Ok(1.0) => "all".to_owned(),
                Ok(share) => format!("{:.2} %", 100.0 * share),
                Err(_) => recovered.to_owned(),
            };
            format!("; on {share} of {scenes} scenes, error {median}, 99th percentile {p99}")
        }
        _ => String::new(),
    };
    wrap(&mut text, "- ", &format!("{time}{scenes}"));
    let _ = writeln!(text, "- [problem file](../../../templates/{name}.rs)\n");
    wrap(&mut text, "", &format!("![The template and its histograms](gallery/{name}.svg)"));
    text
}

/// Two digits: the prediction has no more.
fn time(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        ..1e3 => (nanoseconds, "ns"),
        ..1e6 => (nanoseconds / 1e3, "us"),
        _ => (nanoseconds / 1e6, "ms"),
    };
    if value < 10.0 { format!("{value:.1} {unit}") } else { format!("{:.0} {unit}", (value / 10.0).round() * 10.0) }
}

/// Words in lines of at most 100 columns.
fn wrap(text: &mut String, bullet: &str, words: &str) {
    let mut line = bullet.to_owned();
    for word in words.split_whitespace() {
        if line.len() > bullet.len() && line.chars().count() + 1 + word.chars().count() > 100 {
            let _ = writeln!(text, "{}", line.trim_end());
            line = " ".repeat(bullet.len());
        } else if line.len() > bullet.len() {
            line.push(' ');
        }
        line.push_str(word);
    }
    let _ = writeln!(text, "{line}");
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// All problems with their templates, by name.
fn entries(folder: &Path) -> Result<BTreeMap<String, Entry>, String> {
    let files = fs::read_dir(folder).map_err(|error| error.to_string())?;
    let mut entries = BTreeMap::new();
    for file in files {
        let path = file.map_err(|error| error.to_string())?.path();
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let problem = Problem::parse(&path.display().to_string(), &read(&path)?).map_err(|found| found.render())?;
        let template = read(&path.with_extension("template.toml"))?;
        let template = TemplateFile::parse(&template, &problem.unknowns).map_err(|error| error.to_string())?;
        entries.insert(problem.name.clone(), Entry { problem, template });
    }
    Ok(entries)
}

/// The features of the solvers, each with what it turns on.
fn families(manifest: &Path) -> Result<BTreeMap<String, BTreeSet<String>>, String> {
    let text = fs::read_to_string(manifest).map_err(|error| error.to_string())?;
    let manifest: toml::Table = text.parse().map_err(|error: toml::de::Error| error.to_string())?;
    let features = manifest.get("features").and_then(toml::Value::as_table).ok_or("no features")?;
    let names = |list: &toml::Value| {
        list.as_array().into_iter().flatten().filter_map(|name| name.as_str().map(str::to_owned)).collect()
    };
    Ok(features.iter().map(|(feature, list)| (feature.clone(), names(list))).collect())
}
