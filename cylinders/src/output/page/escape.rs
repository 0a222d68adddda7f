//! Text and numbers that may stand in HTML.

/// The text as content of an element or of an attribute in double quotes. Control characters, which
/// HTML does not have, are replaced.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            control if control.is_control() && !matches!(control, '\n' | '\t') => escaped.push('\u{fffd}'),
            other => escaped.push(other),
        }
    }
    escaped
}

/// JSON as content of a `script` element: no tag and no comment can start or end in it.
pub(super) fn escaped_json(json: &serde_json::Value) -> String {
    json.to_string().replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_tag_gets_through() {
        assert_eq!(
            escaped("<script>a && \"b\"</script>\u{0}"),
            "&lt;script&gt;a &amp;&amp; &quot;b&quot;&lt;/script&gt;\u{fffd}"
        );
        let json = serde_json::json!({ "label": "</script><!--" });
        let text = escaped_json(&json);
        assert!(!text.contains('<') && serde_json::from_str::<serde_json::Value>(&text).is_ok_and(|read| read == json));
    }
}
