//! The file `NAME.template.toml`: an elimination template as a person reads it.

use std::fmt::Write as _;

use serde::Deserialize;

use super::{EliminationTemplate, RootMethod, Shift};
use crate::algebra::{MAX_UNKNOWNS, Monomial};
use crate::presolve::Presolve;

/// The content of a template file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TemplateFile {
    /// Name of the problem.
    pub problem: String,
    /// [`crate::problem::Problem::fingerprint`] of the problem that the template was found for.
    pub fingerprint: u64,
    /// Number of different complex solutions; verified by [`crate::generate::plan`].
    pub solutions: usize,
    /// The presolved form that the template is for.
    pub presolve: Presolve,
    /// How real roots are found.
    pub roots: RootMethod,
    /// The template.
    pub template: EliminationTemplate,
    /// Sets of unknowns that are 0 together at a solution: increasing indices. Unknowns are read
    /// from monomials that do not all vanish there.
    pub zero_sets: Vec<Vec<usize>>,
    /// How the template was found: keys and values, which nothing interprets.
    pub provenance: Vec<(String, String)>,
}

/// Why a template file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TemplateFileError {
    /// The text is not TOML of the right form; the message names line and column.
    #[error("{0}")]
    Syntax(String),
    /// A malformed monomial.
    #[error("`{key}` holds `{text}`, which is not a monomial in {unknowns} (such as `x^2*y` or `1/x`)")]
    Monomial {
        /// The key of the file.
        key: &'static str,
        /// Its value in the file.
        text: String,
        /// The names of the unknowns.
        unknowns: String,
    },
    /// A count that contradicts the lists.
    #[error("`{key}` is {found}, but the lists of the file {expected}")]
    Count {
        /// The key of the file.
        key: &'static str,
        /// Its value in the file.
        found: usize,
        /// The counts of the lists.
        expected: String,
    },
    /// A word that is not allowed.
    #[error("`{key}` is `{text}`; expected one of {expected}")]
    Word {
        /// The key of the file.
        key: &'static str,
        /// Its value in the file.
        text: String,
        /// The values that are allowed.
        expected: String,
    },
}

/// The file before its monomials are read.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    problem: String,
    fingerprint: String,
    solutions: usize,
    presolve: String,
    roots: String,
    action: String,
    rows: usize,
    columns: usize,
    basis: Vec<String>,
    reducible: Vec<String>,
    excess: Vec<String>,
    /// Products of the unknowns of a set.
    #[serde(default)]
    zeros: Vec<String>,
    shifts: Vec<RawShifts>,
    #[serde(default)]
    provenance: toml::Table,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawShifts {
    /// Counted from 1.
    equation: usize,
    multipliers: Vec<String>,
}

const ROOTS: [(&str, RootMethod); 2] = [
    (RootMethod::Eigenvalues.name(), RootMethod::Eigenvalues),
    (RootMethod::Determinant.name(), RootMethod::Determinant),
];

impl TemplateFile {
    /// Reads a file; `unknowns` are the names of the problem.
    pub fn parse(text: &str, unknowns: &[String]) -> Result<Self, TemplateFileError> {
        let raw: Raw = toml::from_str(text).map_err(|error| TemplateFileError::Syntax(error.to_string()))?;
        let fingerprint = u64::from_str_radix(&raw.fingerprint, 16)
            .map_err(|_| word("fingerprint", &raw.fingerprint, "16 hexadecimal digits"))?;
        let monomial = |key: &'static str, text: &str| {
            parse_monomial(text, unknowns).ok_or_else(|| TemplateFileError::Monomial {
                key,
                text: text.to_owned(),
                unknowns: unknowns.join(", "),
            })
        };
        let all = |key, texts: &[String]| texts.iter().map(|text| monomial(key, text)).collect::<Result<Vec<_>, _>>();
        let mut shifts = Vec::new();
        for group in &raw.shifts {
            let equation = group.equation.checked_sub(1).ok_or_else(|| word("equation", "0", "1, 2, ..."))?;
            let multipliers = all("multipliers", &group.multipliers)?;
            shifts.extend(multipliers.into_iter().map(|multiplier| Shift { equation, multiplier }));
        }
        shifts.sort_unstable();
        let template = EliminationTemplate {
            shifts,
            action: monomial("action", &raw.action)?,
            excess: all("excess", &raw.excess)?,
            reducible: all("reducible", &raw.reducible)?,
            basis: all("basis", &raw.basis)?,
        };
        check_counts(&raw, &template)?;
        let zeros = all("zeros", &raw.zeros)?;
        let factors = |product: &Monomial| (0..unknowns.len()).filter(|&x| product.exponent(x) != 0).collect();
        Ok(Self {
            problem: raw.problem,
            fingerprint,
            solutions: raw.solutions,
            presolve: choose("presolve", &raw.presolve, &presolves(unknowns.len()))?,
            roots: choose("roots", &raw.roots, &ROOTS)?,
            template,
            zero_sets: zeros.iter().map(factors).collect(),
            provenance: raw
                .provenance
                .into_iter()
                .map(|(key, value)| (key, value.as_str().map_or_else(|| value.to_string(), str::to_owned)))
                .collect(),
        })
    }

    /// The text of the file.
    pub fn to_text(&self, unknowns: &[String]) -> String {
        let show = |m: &Monomial| format!("{:?}", m.display(unknowns).to_string());
        let list = |monomials: &[Monomial]| monomials.iter().map(show).collect::<Vec<_>>().join(", ");
        let t = &self.template;
        let mut text = String::new();
        // Writing to a string cannot fail.
        let mut line = |content: String| {
            let _ = writeln!(text, "{content}");
        };
        let name = self.problem.escape_default();
        line(format!("# Elimination template of the problem `{name}`: {} x {}.", t.rows(), t.columns()));
        line(format!("# Found by `eliminant search {name}.rs`; checked against the problem whenever it is used."));
        line(format!("problem = {}", toml_text(&self.problem)));
        line(format!("fingerprint = \"{:016x}\"", self.fingerprint));
        line(format!("solutions = {}", self.solutions));
        line(format!("presolve = {:?}", self.presolve.name()));
        line(format!("roots = {:?}", name_of(self.roots, &ROOTS)));
        line(format!("rows = {}", t.rows()));
        line(format!("columns = {}", t.columns()));
        line(format!("action = {}", show(&t.action)));
        line(format!("basis = [{}]", list(&t.basis)));
        line(format!("reducible = [{}]", list(&t.reducible)));
        line(format!("excess = [{}]", list(&t.excess)));
        if !self.zero_sets.is_empty() {
            let product = |set: &Vec<usize>| set.iter().fold(Monomial::ONE, |m, &x| m.times(&Monomial::unknown(x)));
            line(format!("zeros = [{}]", list(&self.zero_sets.iter().map(product).collect::<Vec<_>>())));
        }
        for group in t.shifts.chunk_by(|a, b| a.equation == b.equation) {
            let multipliers: Vec<Monomial> = group.iter().map(|shift| shift.multiplier).collect();
            line(format!("\n[[shifts]]\nequation = {}", group[0].equation + 1));
            line(format!("multipliers = [{}]", list(&multipliers)));
        }
        line("\n[provenance]".to_owned());
        for (key, value) in &self.provenance {
            line(format!("{} = {}", toml_key(key), toml_text(value)));
        }
        text
    }
}

/// A string as TOML writes it, in double quotes whatever it holds.
fn toml_text(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        '\n' => "\\n".to_owned(),
        '\t' => "\\t".to_owned(),
        _ if c.is_control() => format!("\\u{:04x}", u32::from(c)),
        _ => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}

/// A key as TOML writes it: in quotes unless it is a plain word.
fn toml_key(key: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.chars().all(is_plain) { key.to_owned() } else { toml_text(key) }
}

/// Checks the counts that stand in the file for its readers.
fn check_counts(raw: &Raw, template: &EliminationTemplate) -> Result<(), TemplateFileError> {
    let (rows, columns, basis) = (template.rows(), template.columns(), template.basis.len());
    let count = |key, found, is_true: bool, expected: String| match is_true {
        true => Ok(()),
        false => Err(TemplateFileError::Count { key, found, expected }),
    };
    count("rows", raw.rows, raw.rows == rows, format!("have {rows} multipliers"))?;
    count("columns", raw.columns, raw.columns == columns, format!("have {columns} monomials"))?;
    // With sign changes a basis monomial stands for several solutions. The exact number is verified
    // with the plan.
    let possible = (1..=basis << MAX_UNKNOWNS).contains(&raw.solutions);
    count("solutions", raw.solutions, possible, format!("have {basis} basis monomials"))
}

fn word(key: &'static str, text: &str, expected: &str) -> TemplateFileError {
    TemplateFileError::Word { key, text: text.to_owned(), expected: expected.to_owned() }
}

/// The ways to presolve a problem of so many unknowns, by name.
fn presolves(unknowns: usize) -> Vec<(String, Presolve)> {
    Presolve::all(unknowns).into_iter().map(|presolve| (presolve.name(), presolve)).collect()
}

fn choose<T: Copy, N: AsRef<str>>(key: &'static str, text: &str, choices: &[(N, T)]) -> Result<T, TemplateFileError> {
    let expected = || choices.iter().map(|(name, _)| format!("`{}`", name.as_ref())).collect::<Vec<_>>().join(", ");
    let found = choices.iter().find(|(name, _)| name.as_ref() == text).map(|&(_, value)| value);
    found.ok_or_else(|| word(key, text, &expected()))
}

fn name_of<T: PartialEq>(value: T, choices: &[(&'static str, T)]) -> &'static str {
    choices.iter().find(|(_, choice)| *choice == value).map_or("", |(name, _)| name)
}

/// Reads a monomial such as `x^2*y/z` or `1/x`, as [`Monomial::display`] prints it.
fn parse_monomial(text: &str, unknowns: &[String]) -> Option<Monomial> {
    let mut exponents = [0i8; MAX_UNKNOWNS];
    for (at, quotient) in text.split('/').enumerate() {
        for factor in quotient.split('*') {
            if factor == "1" {
                continue;
            }
            let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
            let unknown = unknowns.iter().position(|unknown| unknown == name)?;
            let power: i8 = power.parse().ok().filter(|&power| power > 0)?;
            let signed = if at == 0 { power } else { -power };
            exponents[unknown] = exponents[unknown].checked_add(signed)?;
        }
    }
    Some(Monomial::from_exponents(&exponents))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> Vec<String> {
        ["x", "y", "z"].map(String::from).to_vec()
    }

    #[test]
    fn monomials_survive_a_round_trip() {
        for exponents in [[0, 0, 0], [1, 0, 0], [2, 1, 0], [-1, 0, 0], [2, -3, 1], [0, -1, -1]] {
            let monomial = Monomial::from_exponents(&exponents);
            let text = monomial.display(&names()).to_string();
            assert_eq!(parse_monomial(&text, &names()), Some(monomial), "{text}");
        }
        for bad in ["", "w", "x^", "x^a", "x**y", "x^-1", "x^0", "2", "x^200", "/x"] {
            assert_eq!(parse_monomial(bad, &names()), None, "{bad}");
        }
    }

    #[test]
    fn files_survive_a_round_trip() {
        let m = |e: &[i8]| Monomial::from_exponents(e);
        let shift = |equation, e: &[i8]| Shift { equation, multiplier: m(e) };
        let file = TemplateFile {
            problem: "some".into(),
            fingerprint: 0x1234,
            solutions: 2,
            presolve: Presolve::Linear,
            roots: RootMethod::Determinant,
            template: EliminationTemplate {
                shifts: vec![shift(0, &[0]), shift(0, &[1]), shift(2, &[0, 1])],
                action: m(&[-1]),
                excess: vec![m(&[2, 1])],
                reducible: vec![m(&[1, 1]), m(&[0, 1])],
                basis: vec![m(&[1]), m(&[0])],
            },
            zero_sets: vec![vec![0], vec![0, 2]],
            // Keys and values that TOML writes in quotes, and those that it must escape.
            provenance: [("", ""), ("a \"b\"", "\\ \u{7f}\0"), ("generator", "0.1.0"), ("growth", "a \"b\"\t\n\u{e9}")]
                .map(|(key, value)| (key.into(), value.into()))
                .to_vec(),
        };
        let text = file.to_text(&names());
        assert_eq!(TemplateFile::parse(&text, &names()).unwrap(), file);
    }

    /// x^2 = 3 x - 2, times 1 and y.
    const TEXT: &str = r#"
problem = "some"
fingerprint = "00000000000012ab"
solutions = 2
presolve = "none"
roots = "eigenvalues"
rows = 2
columns = 6
action = "x"
basis = ["x", "x*y", "1", "y"]
reducible = ["x^2", "x^2*y"]
excess = []
[[shifts]]
equation = 1
multipliers = ["y", "1"]
[provenance]
seed = 7
"#;

    #[test]
    fn what_is_read_is_what_stands_there() {
        let file = TemplateFile::parse(TEXT, &names()).unwrap();
        assert_eq!((file.fingerprint, file.solutions), (0x12ab, 2));
        assert_eq!((file.presolve, file.roots), (Presolve::None, RootMethod::Eigenvalues));
        assert_eq!(file.provenance, [("seed".to_owned(), "7".to_owned())]);
        // Shifts are sorted, so that their order in the file does not matter.
        let other = TEXT.replace(r#"["y", "1"]"#, r#"["1", "y"]"#);
        assert_eq!(TemplateFile::parse(&other, &names()).unwrap(), file);
        assert_eq!(file.template.shifts.iter().map(|shift| shift.equation).collect::<Vec<_>>(), [0, 0]);
    }

    #[test]
    fn each_contradiction_is_refused_and_named() {
        // With sign changes of all unknowns a basis monomial stands for 2^16 solutions.
        let most = 4 << MAX_UNKNOWNS;
        let (too_many, just) = (format!("solutions = {}", most + 1), format!("solutions = {most}"));
        for (from, to, message) in [
            ("rows = 2", "rows = 3", "`rows` is 3, but the lists of the file have 2 multipliers"),
            ("columns = 6", "columns = 5", "`columns` is 5, but the lists of the file have 6 monomials"),
            ("solutions = 2", "solutions = 0", "`solutions` is 0, but the lists of the file have 4 basis monomials"),
            ("solutions = 2", &too_many, "but the lists of the file have 4 basis monomials"),
            ("00000000000012ab", "12ag", "`fingerprint` is `12ag`; expected one of 16 hexadecimal digits"),
            ("equation = 1", "equation = 0", "`equation` is `0`; expected one of 1, 2, ..."),
            (r#""none""#, r#""all""#, "`presolve` is `all`; expected one of `none`, `constant`, "),
            (r#""eigenvalues""#, r#""qr""#, "expected one of `eigenvalues`, `determinant`"),
            (r#"action = "x""#, r#"action = "u""#, "`action` holds `u`, which is not a monomial in x, y, z "),
            (r#""x*y", "#, r#""x**y", "#, "`basis` holds `x**y`"),
            (r#""x^2", "#, r#""x^", "#, "`reducible` holds `x^`"),
            ("excess = []", r#"excess = ["2"]"#, "`excess` holds `2`"),
            (r#"["y", "1"]"#, r#"["y", "v"]"#, "`multipliers` holds `v`"),
            ("rows = 2", "rows = 2\nsize = 2", "unknown field `size`"),
            ("equation = 1", "equation = 1\nrow = 1", "unknown field `row`"),
        ] {
            let text = TEXT.replace(from, to);
            let error = TemplateFile::parse(&text, &names()).expect_err(message).to_string();
            assert!(error.contains(message), "`{message}` is not in `{error}`");
        }
        assert!(TemplateFile::parse(&TEXT.replace("solutions = 2", &just), &names()).is_ok());
    }

    #[test]
    fn all_words_survive_a_round_trip() {
        let mut file = TemplateFile::parse(TEXT, &names()).unwrap();
        for (presolve, roots) in Presolve::all(2).into_iter().flat_map(|p| ROOTS.iter().map(move |(_, r)| (p, *r))) {
            (file.presolve, file.roots) = (presolve, roots);
            assert_eq!(TemplateFile::parse(&file.to_text(&names()), &names()).unwrap(), file);
        }
    }
}
