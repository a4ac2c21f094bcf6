//! Lines and white space of texts.

/// Splits lines at the line ends of any system. `\r\r\n` is one line end, which a faulty conversion writes.
pub(super) fn lines(text: &str) -> Vec<&str> {
    let mut lines = Vec::new();
    let mut rest = text;
    while let Some(end) = rest.find(['\r', '\n']) {
        lines.push(&rest[..end]);
        let after = &rest[end..];
        let whole = ["\r\r\n", "\r\n"].iter().find_map(|mark| after.strip_prefix(mark));
        rest = whole.unwrap_or(&after[1..]);
    }
    lines.push(rest);
    lines
}

/// As JavaScript has white space.
pub(super) fn is_space(letter: char) -> bool {
    letter == '\u{feff}' || (letter.is_whitespace() && letter != '\u{85}')
}

/// The text without white space at its ends.
pub(super) fn trimmed(text: &str) -> &str {
    text.trim_matches(is_space)
}
