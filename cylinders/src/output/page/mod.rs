//! A result as one HTML page that needs no other file and no network: photographs with lines and
//! silhouettes, cross-sections, a view of the scene in space that turns, tables and warnings. All
//! but the view in space shows without JavaScript.

/// Bytes as the text of a data URL.
mod data_url;
/// Text and numbers that may stand in HTML.
mod escape;
/// Photographs as files: found, recognised, measured.
mod image_file;
/// A view of the scene as an SVG element over its photograph.
mod overlay;
/// The scene in space, as the numbers that the script draws.
mod space;

use std::fmt::Write;
use std::path::PathBuf;

use super::picture::{Format, PictureError, SectionPicture};
use crate::{Cylinder, CylinderLines, Scene};
use data_url::data_url;
use escape::escaped;

pub use overlay::photograph_overlay;

/// Everything of the page that does not change, with marks for what does.
const TEMPLATE: &str = include_str!("page.html");

/// A table of the page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// The names of its columns.
    pub header: Vec<String>,
    /// Its rows, each of as many cells as there are columns.
    pub rows: Vec<Vec<String>>,
}

/// What the page shows.
#[derive(Clone, Debug)]
pub struct Page<'a> {
    /// The scene. Views without lines are left out.
    pub scene: &'a Scene,
    /// The cylinders, each with its lines.
    pub found: &'a [(CylinderLines, Cylinder)],
    /// The command line, for the reader.
    pub command: String,
    /// What makes the result doubtful.
    pub warnings: Vec<String>,
    /// Numbers: the first table is the result, the others are folded up at the end of the page.
    pub tables: Vec<Table>,
    /// Folders in which the photographs are looked for by the names of their images, the first
    /// first. A photograph that is in none of them is left out, and its lines are drawn on white.
    pub folders: Vec<PathBuf>,
}

impl Page<'_> {
    /// The page: the same bytes each time for the same photographs.
    ///
    /// # Errors
    /// [`PictureError`], if a cross-section cannot be drawn.
    pub fn to_html(&self) -> Result<String, PictureError> {
        let mut sections = String::new();
        for (lines, cylinder) in self.found {
            let picture = Format::Svg.render(&SectionPicture::of_cylinder(lines, cylinder))?;
            let name = lines.label.as_deref().unwrap_or("the cylinder");
            let url = data_url("image/svg+xml", &picture);
            // Writing to a string does not fail; the same holds below.
            let _ =
                writeln!(sections, "<img class=\"section\" alt=\"cross-section of {}\" src=\"{url}\">", escaped(name));
        }
        let parts = [
            ("TITLE", escaped(&self.title())),
            ("SUMMARY", self.summary()),
            ("WARNINGS", self.warnings()),
            ("FIRST_TABLE", self.tables.first().map(table).unwrap_or_default()),
            ("OTHER_TABLES", self.tables.iter().skip(1).map(folded).collect()),
            ("PHOTOGRAPHS", overlay::figures(self.scene, self.found, &self.folders)),
            ("SECTIONS", sections),
            ("COMMAND", escaped(&self.command)),
            ("VERSION", escaped(env!("CARGO_PKG_VERSION"))),
            ("SPACE", space::json(self.scene, self.found)),
        ];
        Ok(filled(TEMPLATE, &parts))
    }

    fn title(&self) -> String {
        match self.found.len() {
            1 => "1 cylinder".to_owned(),
            count => format!("{count} cylinders"),
        }
    }

    fn summary(&self) -> String {
        let lines: usize = self.scene.views.iter().map(|view| view.lines().len()).sum();
        let views = self.scene.views.iter().filter(|view| !view.lines().is_empty()).count();
        let points = self.scene.points.len();
        format!("{lines} lines in {views} images; {points} points")
    }

    fn warnings(&self) -> String {
        let items: String = self.warnings.iter().map(|warning| format!("<li>{}</li>\n", escaped(warning))).collect();
        if items.is_empty() { String::new() } else { format!("<ul class=\"warnings\">\n{items}</ul>\n") }
    }
}

/// The template with each mark `{{NAME}}` replaced. What is filled in is not searched for marks.
fn filled(template: &str, parts: &[(&str, String)]) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        text.push_str(before);
        let (name, after) = after.split_once("}}").unwrap_or((after, ""));
        if let Some((_, part)) = parts.iter().find(|(known, _)| *known == name) {
            text.push_str(part);
        }
        rest = after;
    }
    text + rest
}

/// A table that opens on demand, without a script.
fn folded(shown: &Table) -> String {
    let caption = escaped(&shown.caption);
    let shown = Table { caption: String::new(), ..shown.clone() };
    format!("<details><summary>{caption}</summary>\n{}</details>\n", table(&shown))
}

fn table(table: &Table) -> String {
    let row = |cells: &[String], tag: &str| -> String {
        let cells: String = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = table.rows.iter().map(|cells| row(cells, "td")).collect();
    let (caption, header) = (escaped(&table.caption), row(&table.header, "th"));
    format!(
        "<div class=\"wide\"><table><caption>{caption}</caption>\n<thead>{header}</thead>\n<tbody>{rows}</tbody></table></div>\n"
    )
}
