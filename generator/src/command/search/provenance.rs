//! The `[provenance]` of a template file: the options that repeat its search, and what they led to.
//!
//! [`KEYS`] lists every key that a search writes, in the order of the file.

use clap::Parser;

use super::arguments::Arguments;
use super::settings::{Settings, Tracing};
use crate::command::report::one_decimal;
use crate::command::watch::End;
use crate::search::MOST_COLUMNS;
use crate::search::choose::Measured;
use crate::search::grow::Growth;
use crate::search::measuring::Stability;

/// The version of the generator that searched. A later one may well write the same template.
pub(super) const GENERATOR: &str = "generator";
/// The limit on columns within which nothing was found, if a wider one was tried.
const NOTHING_WITHIN: &str = "nothing_within";
/// What ended the search early. Such a search cannot be repeated.
pub(super) const ENDED_EARLY: &str = "ended_early";

/// The options of `eliminant search` that are recorded: (key, option).
const OPTIONS: [(&str, &str); 7] = [
    ("prefer", "--prefer"),
    ("seed", "--seed"),
    ("max_columns", "--max-columns"),
    ("max_basis", "--max-basis"),
    ("shuffles", "--shuffles"),
    ("trials", "--trials"),
    ("confirm", "--confirm"),
];

/// Every key that a search writes, in the order of the file.
///
/// `max_basis` is written if the option is given, `nothing_within` and `ended_early` where they
/// apply, all others by every search.
pub(super) const KEYS: [&str; 17] = [
    GENERATOR,
    "prefer",
    "seed",
    "max_columns",
    NOTHING_WITHIN,
    "max_basis",
    "shuffles",
    "trials",
    "confirm",
    "prime",
    "growth",
    "operations",
    "instances",
    "verdict",
    "residual_log10",
    "complex_solutions",
    ENDED_EARLY,
];

/// The value of a key.
pub(super) fn value_of<'a>(provenance: &'a [(String, String)], key: &str) -> Option<&'a str> {
    provenance.iter().find(|(name, _)| name == key).map(|(_, value)| value.as_str())
}

/// Adds what the command knows to the provenance of a candidate: how it was measured, and how the
/// search went.
///
/// Figures are rounded, so that the last bits of a machine do not matter.
pub(super) fn complete(
    provenance: &mut Vec<(String, String)>,
    chosen: &Measured,
    settings: &Settings,
    end: Option<End>,
) {
    let Stability { trials, found, expected, incomplete, .. } = &chosen.stability;
    let quantile = |q: f64| one_decimal(chosen.stability.quantile(q));
    let mut add = |key: &str, value: String| provenance.push((key.to_owned(), value));
    add("trials", settings.measuring.trials.to_string());
    add("confirm", settings.measuring.confirm.to_string());
    add("instances", trials.to_string());
    add("verdict", chosen.verdict.name().to_owned());
    add("residual_log10", format!("median {}, p99 {}", quantile(0.5), quantile(0.99)));
    add("complex_solutions", format!("{found} of {expected} found; {incomplete} instances incomplete"));
    if let Some(narrower) = settings.nothing_within {
        add(NOTHING_WITHIN, narrower.to_string());
    }
    if let Some(end) = end {
        add_end(provenance, end);
    }
    provenance.sort_by_key(|(key, _)| position(key));
}

/// Adds that the search ended early, in the place of the key.
pub(super) fn add_end(provenance: &mut Vec<(String, String)>, end: End) {
    provenance.push((ENDED_EARLY.to_owned(), end.name().to_owned()));
    provenance.sort_by_key(|(key, _)| position(key));
}

/// Where a key stands in the file; `None` for a key that nothing writes.
pub(super) fn position(key: &str) -> Option<usize> {
    KEYS.iter().position(|known| *known == key)
}

/// The command line of a recorded search.
#[derive(Debug, Parser)]
#[command(no_binary_name = true)]
struct Recorded {
    #[command(flatten)]
    arguments: Arguments,
}

/// The settings that repeat a recorded search; an option that is not recorded has its default.
///
/// # Errors
/// A sentence that says which value is no value of its option.
pub(super) fn recorded_settings(provenance: &[(String, String)]) -> Result<Settings, String> {
    let mut line = vec!["PROBLEM.rs".to_owned()];
    for (key, option) in OPTIONS {
        line.extend(value_of(provenance, key).map(|value| format!("{option}={value}")));
    }
    let recorded = Recorded::try_parse_from(line).map_err(|error| {
        let text = error.render().to_string();
        text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
    })?;
    let mut settings = recorded.arguments.settings();
    if let Some(narrower) = value_of(provenance, NOTHING_WITHIN) {
        let limit = narrower.parse().ok().filter(|limit| (2..=MOST_COLUMNS).contains(limit));
        let expected = || format!("key {NOTHING_WITHIN} holds `{narrower}`: expected 2 to {MOST_COLUMNS}");
        settings.wider = Some(settings.options.max_columns);
        settings.options.max_columns = limit.ok_or_else(expected)?;
    }
    if value_of(provenance, "growth") == Some(&Growth::Trace.to_string()) {
        settings.tracing = Tracing::AtOnce;
    }
    Ok(settings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::preference::Preference;

    fn settings_of(provenance: &[(&str, &str)]) -> Result<Settings, String> {
        let owned: Vec<_> = provenance.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
        recorded_settings(&owned)
    }

    #[test]
    fn recorded_options_are_read_as_the_command_line_is() {
        let recorded =
            [("prefer", "size"), ("seed", "7"), ("max_columns", "90"), ("max_basis", "5"), ("shuffles", "3")];
        let settings = settings_of(&[&recorded[..], &[("trials", "20"), ("confirm", "30")]].concat()).unwrap();
        let options = &settings.options;
        assert_eq!((options.prefer, options.seed, options.shuffles), (Preference::Size, 7, 3));
        assert_eq!((options.max_columns, options.max_basis, settings.wider), (90, Some(5), None));
        assert_eq!((settings.measuring.trials, settings.measuring.confirm, settings.measuring.seed), (20, 30, 7));
        // Without a record the defaults hold, the second limit among them.
        let defaults = settings_of(&[]).unwrap();
        assert!(defaults.wider.is_some_and(|wider| wider > defaults.options.max_columns), "{defaults:?}");
        // A search that needed the second limit tries the first one again.
        let second = settings_of(&[("max_columns", "1500"), ("nothing_within", "600")]).unwrap();
        assert_eq!((second.options.max_columns, second.wider), (600, Some(1500)));
    }

    #[test]
    fn values_out_of_range_are_refused() {
        for (key, value) in [
            ("prefer", "beauty"),
            ("seed", "-1"),
            ("max_columns", "1"),
            ("trials", "0"),
            ("confirm", "many"),
            ("nothing_within", "1"),
        ] {
            let message = settings_of(&[(key, value)]).unwrap_err();
            assert!(message.contains(&format!("`{value}`")) || message.contains(&format!("'{value}'")), "{message}");
        }
    }
}
