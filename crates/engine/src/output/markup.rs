//! Text in XML and HTML.

use std::fmt::Write as _;

/// Escapes text for an element or an attribute. Characters that XML 1.0 does not allow are removed, because
/// they would make the file invalid.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(' '),
            '\0'..'\u{20}' | '\u{7f}'..'\u{a0}' | '\u{fffe}' | '\u{ffff}' => {}
            other => out.push(other),
        }
    }
    out
}

/// Text of a text item, with readings as ruby. Readers without ruby show the readings in brackets.
pub(super) fn with_readings(pieces: &[(String, Option<String>)]) -> String {
    let piece = |(base, reading): &(String, Option<String>)| match reading {
        Some(reading) => {
            format!("<ruby>{}<rp>（</rp><rt>{}</rt><rp>）</rp></ruby>", escaped(base), escaped(reading))
        }
        None => escaped(base),
    };
    let text: String = pieces.iter().map(piece).collect();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Writes a length with two significant digits, as short as possible.
pub(super) fn short(value: f64) -> String {
    let rounded = (value * 100.0).round() / 100.0;
    // There is one nought.
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}

/// Points as `x,y x,y`, each coordinate written by `number`.
pub(super) fn points(points: &[(f64, f64)], number: &dyn Fn(f64) -> String) -> String {
    let mut out = String::new();
    for (i, &(x, y)) in points.iter().enumerate() {
        let space = if i == 0 { "" } else { " " };
        // Writing into text never fails.
        let _ = write!(out, "{space}{},{}", number(x), number(y));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_text_says_is_markup() {
        assert_eq!(
            escaped("<b a=\"x\" c='y'>&\u{0}\u{1b}\n"),
            "&lt;b a=&quot;x&quot; c=&#39;y&#39;&gt;&amp; "
        );
        assert_eq!(escaped("Ärger 🦊 שלום"), "Ärger 🦊 שלום");
    }

    #[test]
    fn readings_are_ruby_and_no_markup() {
        let piece = |base: &str, reading: Option<&str>| (base.to_owned(), reading.map(str::to_owned));
        let pieces = [piece("漢<字>", Some("か&じ")), piece(" \n&  c", None)];
        assert_eq!(
            with_readings(&pieces),
            "<ruby>漢&lt;字&gt;<rp>（</rp><rt>か&amp;じ</rt><rp>）</rp></ruby> &amp; c"
        );
    }

    #[test]
    fn lengths_are_short() {
        assert_eq!([1.0, 2.345_6, -0.001].map(short), ["1", "2.35", "0"]);
        assert_eq!(points(&[(1.0, 2.5), (3.0, 4.0)], &short), "1,2.5 3,4");
    }
}
