//! The report as a page of its own: figures in a script, drawn by the browser without any other
//! file.

use super::report::StabilityReport;
use crate::command::report::to_json;

const PAGE: &str = include_str!("page.html");
/// Where the figures stand in the page.
const PLACE: &str = "REPORT_AS_JSON";

/// The page of a report.
pub(super) fn page(report: &StabilityReport) -> String {
    PAGE.replacen(PLACE, &in_script(&to_json(report)), 1)
}

/// JSON that ends no script: `<` is written as an escape, which strings may hold.
fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_ends_the_script() {
        assert_eq!(in_script("\"</script>\""), "\"\\u003c/script>\"");
        assert_eq!(PAGE.matches(PLACE).count(), 1);
        for outside in ["http://", "https://", " src=", "@import"] {
            assert!(!PAGE.replace("http://www.w3.org/2000/svg", "").contains(outside), "{outside}");
        }
    }
}
