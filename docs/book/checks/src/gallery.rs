//! The page of all problems of the catalogue, by families.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;

/// What begins the page.
const HEAD: &str = "\
# Gallery of the catalogue

All problems that come with Eliminant, by families. A family is a feature of `eliminant-solvers`,
and so is each problem. A problem of several families stands in the first. Each entry says what is
given and sought, and leads to the problem file, which cites its source. The template has so many
rows x columns, and |B| is the size of the eigenvalue problem. How the solvers measure up, beside
published ones, is in [templates/README.md](../../../templates/README.md).

This page is written by

```sh
cargo run --manifest-path docs/book/checks/Cargo.toml --bin gallery
```

from the problem files and their templates, and a test tells when it is not fresh.
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

/// The whole page.
///
/// # Errors
/// A message, where a problem, a template or the manifest of the solvers cannot be read.
pub fn gallery(root: &Path) -> Result<String, String> {
    let mut entries = entries(&root.join("templates"))?;
    let families = families(&root.join("solvers/Cargo.toml"))?;
    let mut page = HEAD.to_owned();
    for (family, title) in FAMILIES {
        let members = families.get(family).ok_or_else(|| format!("there is no family `{family}`"))?;
        let names: Vec<String> = entries.keys().filter(|name| members.contains(*name)).cloned().collect();
        let of_family: Vec<Entry> = names.iter().filter_map(|name| entries.remove(name)).collect();
        section(&mut page, title, &format!("Feature `{family}`."), &of_family);
    }
    let rest: Vec<Entry> = entries.into_values().collect();
    section(&mut page, "Others", "Problems of no family.", &rest);
    Ok(page)
}

fn section(page: &mut String, title: &str, what: &str, entries: &[Entry]) {
    if entries.is_empty() {
        return;
    }
    let _ = write!(page, "\n## {title}\n\n{what}\n");
    entries.iter().for_each(|entry| page.push_str(&text(entry)));
}

fn text(Entry { problem, template }: &Entry) -> String {
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
    let facts = format!("{} solutions, template {rows} x {columns}, |B| = {basis}", template.solutions);
    wrap(&mut text, "- ", &facts);
    let _ = writeln!(text, "- [problem file](../../../templates/{name}.rs)");
    text
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

/// All problems with their templates, by name.
fn entries(folder: &Path) -> Result<BTreeMap<String, Entry>, String> {
    let read = |path: &Path| fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()));
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
