//! Tables as text, CSV and JSON.

use std::fmt;

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

/// A table of results.
#[derive(Clone, Debug)]
pub struct Table {
    /// Name of the table and of its file.
    pub name: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// A cell for each column.
    pub rows: Vec<Vec<Cell>>,
}

/// An entry of a table.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Cell {
    /// A name.
    Text(String),
    /// A count.
    Count(usize),
    /// A measured number; not finite if the measurement failed.
    Number(f64),
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl Table {
    pub(super) fn new(name: &str, columns: &[&str]) -> Self {
        let columns = columns.iter().map(|&column| column.to_owned()).collect();
        Self { name: name.to_owned(), columns, rows: Vec::new() }
    }

    pub(super) fn push(&mut self, row: impl IntoIterator<Item = Cell>) {
        let row: Vec<_> = row.into_iter().collect();
        debug_assert_eq!(row.len(), self.columns.len());
        self.rows.push(row);
    }

    pub(super) fn to_csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.columns)?;
        for row in &self.rows {
            writer.write_record(row.iter().map(|cell| match cell {
                Cell::Text(text) => text.clone(),
                Cell::Count(count) => count.to_string(),
                // All digits are written, so that the number is read back exactly.
                Cell::Number(number) => format!("{number:e}"),
            }))?;
        }
        writer.into_inner().map_err(|error| error.into_error().into())
    }
}

/// Three digits, with an exponent if the number is small or large.
impl fmt::Display for Cell {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cell = match self {
            Self::Text(name) => return text.pad(name),
            Self::Count(count) => count.to_string(),
            Self::Number(number) if !number.is_finite() => "-".to_owned(),
            Self::Number(0.0) => "0".to_owned(),
            Self::Number(number) => match number.abs().log10().floor() {
                magnitude @ -3.0..=4.0 => format!("{number:.*}", (2.0 - magnitude).max(0.0) as usize),
                _ => format!("{number:.2e}"),
            },
        };
        text.pad(&cell)
    }
}

/// Aligned columns under the name of the table.
impl fmt::Display for Table {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows: Vec<Vec<String>> = self.rows.iter().map(|row| row.iter().map(Cell::to_string).collect()).collect();
        let width = |column: usize| {
            let cells = rows.iter().map(|row| row[column].len());
            cells.fold(self.columns[column].len(), usize::max)
        };
        let widths: Vec<_> = (0..self.columns.len()).map(width).collect();
        writeln!(text, "{}", self.name)?;
        for row in [&self.columns].into_iter().chain(&rows) {
            for (cell, width) in row.iter().zip(&widths) {
                write!(text, "  {cell:>width$}")?;
            }
            writeln!(text)?;
        }
        Ok(())
    }
}

/// An object with the name and a list of rows, each an object.
impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        struct Row<'a>(&'a [String], &'a [Cell]);
        impl Serialize for Row<'_> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_map(self.0.iter().zip(self.1))
            }
        }
        let rows: Vec<_> = self.rows.iter().map(|row| Row(&self.columns, row)).collect();
        let mut map = serializer.serialize_map(Some(2))?;
        map.serialize_entry("name", &self.name)?;
        map.serialize_entry("rows", &rows)?;
        map.end()
    }
}
