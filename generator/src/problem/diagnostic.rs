//! Messages about a problem file: where, what, what was expected, and a hint.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use super::{SourceFile, Span};

/// One message about a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong, in one line.
    pub message: String,
    /// Where.
    pub span: Span,
    /// What the underlined part is or what was expected there; may be empty.
    pub label: String,
    /// Other places that matter, with what they are: the operands of a product, the call that led
    /// here.
    pub context: Vec<(Span, String)>,
    /// How to mend it, each a line of its own.
    pub hints: Vec<String>,
}

impl Diagnostic {
    /// A message with its place.
    pub fn new(message: impl Into<String>, span: Span) -> Self {
        Self { message: message.into(), span, label: String::new(), context: Vec::new(), hints: Vec::new() }
    }

    /// Says what the underlined part is or should be.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Shows another place, underlined with dashes.
    #[must_use]
    pub fn context(mut self, span: Span, label: impl Into<String>) -> Self {
        self.context.push((span, label.into()));
        self
    }

    /// Says how to mend it.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }

    /// The same message at another place.
    #[must_use]
    pub fn at(mut self, span: Span) -> Self {
        self.span = span;
        self
    }

    fn render(&self, file: &SourceFile, renderer: &Renderer) -> String {
        // Only the lines from the first place to the last are looked at: the file may be long, and
        // the messages many.
        let lines = self.lines(&file.text);
        let (text, before) = (&file.text[lines.clone()], &file.text[..lines.start]);
        let within = |span: &Span| {
            let Span { start, end } = clamp(&file.text, span);
            start - lines.start..end - lines.start
        };
        let primary = AnnotationKind::Primary.span(within(&self.span)).label(non_empty(&self.label));
        let context =
            self.context.iter().map(|(span, label)| AnnotationKind::Context.span(within(span)).label(non_empty(label)));
        let snippet = Snippet::source(text).path(file.path.as_str()).annotation(primary).annotations(context);
        let snippet = snippet.line_start(1 + before.bytes().filter(|&byte| byte == b'\n').count());
        let group = Level::ERROR
            .primary_title(self.message.as_str())
            .element(snippet)
            .elements(self.hints.iter().map(|hint| Level::HELP.message(hint.as_str())));
        // Trailing blanks are of no use in a terminal and a nuisance in golden files.
        let report = renderer.render(&[group]);
        report.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
    }

    /// The whole lines in which the places of the message are.
    fn lines(&self, text: &str) -> Span {
        let others = self.context.iter().map(|(span, _)| span);
        let places: Vec<Span> = [&self.span].into_iter().chain(others).map(|span| clamp(text, span)).collect();
        let start = places.iter().map(|place| place.start).min().unwrap_or(0);
        let end = places.iter().map(|place| place.end).max().unwrap_or(0);
        text[..start].rfind('\n').map_or(0, |at| at + 1)..text[end..].find('\n').map_or(text.len(), |at| end + at)
    }
}

fn non_empty(label: &str) -> Option<&str> {
    Some(label).filter(|label| !label.is_empty())
}

/// The span within the text and on character boundaries.
fn clamp(text: &str, span: &Span) -> Span {
    let boundary = |at: usize| (0..=at.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0);
    let end = boundary(span.end);
    boundary(span.start).min(end)..end
}

/// Most messages about one file that are kept.
pub(super) const MAX_MESSAGES: usize = 100;

/// All messages about one file, in order of place; the first hundred if there are more.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{}", self.render())]
pub struct Diagnostics {
    /// The file.
    pub source_file: SourceFile,
    /// At least one message.
    pub messages: Vec<Diagnostic>,
}

impl Diagnostics {
    /// The messages about `source_file`, sorted by place.
    pub fn new(source_file: SourceFile, mut messages: Vec<Diagnostic>) -> Self {
        messages.sort_by_key(|diagnostic| (diagnostic.span.start, diagnostic.span.end));
        if messages.len() > MAX_MESSAGES {
            let next = messages[MAX_MESSAGES].span.clone();
            messages.truncate(MAX_MESSAGES);
            let rest = Diagnostic::new(format!("there are more than {MAX_MESSAGES} mistakes"), next);
            messages.push(rest.label("the next one").hint("mend the others first"));
        }
        Self { source_file, messages }
    }

    /// Messages with `file:line:column`, the underlined span and the hints.
    pub fn render(&self) -> String {
        self.render_by(&Renderer::plain())
    }

    /// The same in colours, for a terminal.
    pub fn render_in_colour(&self) -> String {
        self.render_by(&Renderer::styled())
    }

    fn render_by(&self, renderer: &Renderer) -> String {
        let of = |diagnostic: &Diagnostic| diagnostic.render(&self.source_file, renderer);
        self.messages.iter().map(of).collect::<Vec<_>>().join("\n\n")
    }
}
