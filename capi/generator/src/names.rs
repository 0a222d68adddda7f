//! Names that C, C++ and the functions themselves leave free.

/// Keywords of C and C++ that are names in a problem file, macros of headers that are included, and
/// names that the functions use themselves.
const TAKEN: [&str; 93] = [
    "alignas",
    "alignof",
    "and",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "case",
    "catch",
    "char",
    "class",
    "compl",
    "concept",
    "consteval",
    "constexpr",
    "constinit",
    "default",
    "delete",
    "double",
    "error",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "friend",
    "goto",
    "inline",
    "int",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "nullptr",
    "operator",
    "or",
    "private",
    "protected",
    "public",
    "register",
    "requires",
    "restrict",
    "short",
    "signed",
    "sizeof",
    "static",
    "switch",
    "template",
    "this",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "union",
    "unix",
    "linux",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "xor",
    "std",
    "detail",
    "solutions",
    "solutions_length",
    "capacity",
    "count",
    "counts",
    "codes",
    "instances",
    "batch",
    "max_solutions",
    "unknowns",
    "to_solutions",
    "to_count",
    "data",
    "measurements",
    "mean",
    "mean_length",
    "code",
    "output",
    "second_attempts",
    "solution",
    "solution_length",
    "relative_residual",
    "error_bound",
];

/// The name, with underscores after it until neither a language nor another name has it.
pub(crate) fn free_name(name: &str, used: &[String]) -> String {
    let mut free = name.to_owned();
    while TAKEN.contains(&free.as_str()) || used.contains(&free) || used.contains(&length_name(&free)) {
        free.push('_');
    }
    free
}

/// The name of the length of a list.
pub(crate) fn length_name(list: &str) -> String {
    format!("{list}_length")
}

/// Whether it can begin the names of C functions: lower case letters, digits and underscores.
pub(crate) fn is_prefix(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        && free_name(name, &[]) == name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn taken_names_get_underscores() {
        let used = ["x".to_owned(), "y_length".to_owned()];
        for (name, free) in [("first", "first"), ("double", "double_"), ("x", "x_"), ("y", "y_"), ("count", "count_")] {
            assert_eq!(free_name(name, &used), free);
        }
    }

    #[test]
    fn prefixes_are_words() {
        assert!(["own", "a1", "my_lib"].into_iter().all(is_prefix));
        assert!(!["", "Own", "1a", "a-b", "_a", "int"].into_iter().any(is_prefix));
    }
}
