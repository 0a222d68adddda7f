//! Messages about a problem file: where, what, what was expected, and a hint.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use crate::problem::{SourceFile, Span};

/// One message about a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong, in one line.
    pub message: String,
    /// Where.
    pub span: Span,
    /// What the underlined part is or what was expected there; may be empty.
    pub label: String,
    /// How to mend it, each a line of its own.
    pub hints: Vec<String>,
}

impl Diagnostic {
    /// A message with its place.
    pub fn new(message: impl Into<String>, span: Span) -> Self {
        Self { message: message.into(), span, label: String::new(), hints: Vec::new() }
    }

    /// Says what the underlined part is or should be.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Says how to mend it.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }
}

/// All messages about one file, in order of place.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{}", self.render())]
pub struct Diagnostics {
    /// The file.
    pub source_file: SourceFile,
    /// At least one message.
    pub messages: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Messages with `file:line:column`, the underlined span and the hints.
    pub fn render(&self) -> String {
        let mut reports = Vec::new();
        for diagnostic in &self.messages {
            let text = &self.source_file.text;
            let end = diagnostic.span.end.min(text.len());
            let span = diagnostic.span.start.min(end)..end;
            let mut annotation = AnnotationKind::Primary.span(span);
            if !diagnostic.label.is_empty() {
                annotation = annotation.label(&diagnostic.label);
            }
            let snippet = Snippet::source(text).path(&self.source_file.path).annotation(annotation);
            let mut group = Level::ERROR.primary_title(&diagnostic.message).element(snippet);
            for hint in &diagnostic.hints {
                group = group.element(Level::HELP.message(hint));
            }
            reports.push(Renderer::plain().render(&[group]));
        }
        reports.join("\n\n")
    }
}
