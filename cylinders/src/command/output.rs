//! What the subcommands print: text for people, or one JSON object.

use std::fmt;

use serde::Serialize;

use super::error::CommandError;

/// A result in both forms, each with its final line break.
pub(super) struct Output {
    pub(super) text: String,
    pub(super) json: String,
    /// What makes the result doubtful. The text contains them; beside JSON they go to standard
    /// error.
    pub(super) warnings: Vec<String>,
}

impl Output {
    /// Both forms of a report.
    pub(super) fn of(report: &(impl Serialize + fmt::Display)) -> Self {
        Self { text: report.to_string(), json: to_json(report), warnings: Vec::new() }
    }

    /// The same output with warnings.
    pub(super) fn with_warnings(self, warnings: Vec<String>) -> Self {
        Self { warnings, ..self }
    }
}

/// `{"error": ".."}`
pub(super) fn error_json(error: &CommandError) -> String {
    to_json(&serde_json::json!({ "error": error.to_string() }))
}

/// Numbers that are not finite become `null`.
fn to_json(value: &impl Serialize) -> String {
    // Serialisation fails only for maps whose keys are not strings, and there are no such maps.
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}
