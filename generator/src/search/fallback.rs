//! What is tried where a search within the first limit on columns gives nothing that solves well.

use super::error::SearchError;

/// What a search within one limit on columns came to.
pub type Attempt<T> = Result<T, SearchError>;

/// A template that was chosen.
pub trait Chosen {
    /// Whether it passed its measurements.
    fn solves_well(&self) -> bool;

    /// Whether the search for it ended before its end.
    fn is_cut(&self) -> bool;
}

/// What follows on a first attempt. `E` are errors that end the search at once.
pub struct Fallback<'a, T, E> {
    /// Searches within a wider limit on columns, if there is one.
    pub wider: Option<&'a dyn Fn() -> Result<Attempt<T>, E>>,
    /// Takes the trace of a Gröbner basis, if this is wanted.
    pub traced: Option<&'a dyn Fn() -> Result<T, E>>,
    /// Hears that a first template is kept because the wider limit, where the time may have ended,
    /// gave nothing better.
    pub keep: &'a dyn Fn(&mut T),
    /// Whether the search must end.
    pub is_over: &'a dyn Fn() -> bool,
}

impl<T: Chosen, E> Fallback<'_, T, E> {
    /// The best of a first attempt and of what follows on it.
    ///
    /// If nothing that solves well was found and the time is not over, the wider limit is tried.
    /// What it gives is taken if it solves well, or if the first limit gave nothing. Where both
    /// give nothing, even for lack of time, the trace gives a template of any size. It is tried,
    /// too, where there is time and nothing solves well.
    ///
    /// # Errors
    /// Those of what is tried.
    pub fn after(&self, first: Attempt<T>) -> Result<Attempt<T>, E> {
        let Some(wider) = self.wider.filter(|_| needs_more_columns(&first)) else { return self.or_traced(first) };
        let second = wider()?;
        match first {
            Ok(mut first) if !second.as_ref().is_ok_and(T::solves_well) => {
                (self.keep)(&mut first);
                self.or_traced(Ok(first))
            }
            _ => self.or_traced(second),
        }
    }

    fn or_traced(&self, attempt: Attempt<T>) -> Result<Attempt<T>, E> {
        let Some(traced) = self.traced else { return Ok(attempt) };
        match attempt {
            Ok(outcome) if !outcome.solves_well() && !(self.is_over)() => {
                Ok(Ok(traced().ok().filter(T::solves_well).unwrap_or(outcome)))
            }
            Err(SearchError::NotFound { .. } | SearchError::TooFewColumns { .. }) => traced().map(Ok),
            attempt => Ok(attempt),
        }
    }
}

/// Whether nothing that solves well was found although there was time.
fn needs_more_columns<T: Chosen>(attempt: &Attempt<T>) -> bool {
    match attempt {
        Ok(outcome) => !outcome.solves_well() && !outcome.is_cut(),
        Err(error) => matches!(error, SearchError::NotFound { is_over: false, .. } | SearchError::TooFewColumns { .. }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a template came from, whether it solves well, whether its search was cut.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    struct Template(&'static str, bool, bool);

    impl Chosen for Template {
        fn solves_well(&self) -> bool {
            self.1
        }

        fn is_cut(&self) -> bool {
            self.2
        }
    }

    const GOOD: Template = Template("first", true, false);
    const BAD: Template = Template("first", false, false);
    const CUT: Template = Template("first", false, true);

    /// Where the template comes from in the end, with an asterisk where one was kept, if the wider
    /// limit and the trace give templates that do or do not solve well, or nothing.
    fn source(first: Attempt<Template>, wider: Option<bool>, trace: Option<bool>, is_over: bool) -> Option<String> {
        let of = |name: &'static str, gives: Option<bool>| gives.map(|is_good| Template(name, is_good, false));
        let wider = || Ok(of("wider", wider).ok_or_else(|| nothing(is_over)));
        let traced = || of("trace", trace).ok_or("no trace");
        let fallback = Fallback {
            wider: Some(&wider),
            traced: Some(&traced),
            keep: &|template: &mut Template| template.0 = "first*",
            is_over: &|| is_over,
        };
        fallback.after(first).ok().and_then(Result::ok).map(|template| template.0.to_owned())
    }

    fn nothing(is_over: bool) -> SearchError {
        SearchError::NotFound { max_columns: 600, failed: Vec::new(), untried: 0, is_over }
    }

    #[test]
    fn what_solves_well_is_taken_and_then_what_there_is() {
        let from = |first, wider, trace| source(first, wider, trace, false).unwrap_or_default();
        assert_eq!(from(Ok(GOOD), Some(true), Some(true)), "first");
        assert_eq!(from(Ok(BAD), Some(true), Some(true)), "wider");
        assert_eq!(from(Ok(BAD), Some(false), Some(true)), "trace");
        assert_eq!(from(Ok(BAD), None, Some(false)), "first*");
        assert_eq!(from(Ok(CUT), Some(true), None), "first");
        assert_eq!(from(Err(nothing(false)), Some(false), None), "wider");
        assert_eq!(from(Err(nothing(false)), None, Some(false)), "trace");
        assert_eq!(from(Err(SearchError::TooFewColumns { max_columns: 6, least: 7 }), Some(true), None), "wider");
        assert_eq!(from(Err(SearchError::NoInstance), Some(true), Some(true)), "");
        assert_eq!(from(Err(nothing(false)), None, None), "");
    }

    #[test]
    fn without_time_only_the_trace_is_taken_and_only_for_want_of_anything_else() {
        assert_eq!(source(Err(nothing(true)), Some(true), Some(false), true).as_deref(), Some("trace"));
        assert_eq!(source(Ok(CUT), Some(true), Some(true), true).as_deref(), Some("first"));
    }
}
