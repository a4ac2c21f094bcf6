//! Markup in the text of subtitles: tags, line breaks, character references and ruby.

use crate::document::text_lines::{is_space, lines};

/// Kinds of markup.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Dialect {
    /// Tags in angle brackets, and places in `{\…}`.
    Tags,
    /// All text in braces is markup.
    SubStation,
    /// As `Tags`, with `[br]` between lines.
    YouTube,
}

/// Names of tags in subtitles. Other text in angle brackets is text.
const TAGS: [&str; 28] = [
    "b", "i", "u", "s", "c", "v", "p", "em", "rt", "rp", "rb", "tt", "br", "div", "sub", "sup", "big", "del",
    "ins", "bdo", "lang", "font", "ruby", "span", "small", "strong", "strike", "center",
];

/// A tag, or a time in the text.
struct Tag<'t> {
    /// In lower case, with the slash of a closing tag.
    name: String,
    rest: &'t str,
}

/// The lines of a text without markup and without empty lines, and whether its words have times. A voice of `WebVTT`
/// begins as with a dash. Each character is looked at a bounded number of times.
pub(super) fn plain(text: &str, dialect: Dialect) -> (Vec<String>, bool) {
    let mut out = String::with_capacity(text.len());
    let mut ruby = Ruby::default();
    let (mut stamped, mut drawing, mut braces) = (false, false, true);
    let mut skips = false;
    let mut rest = text;
    while let Some(letter) = rest.chars().next() {
        let after = &rest[letter.len_utf8()..];
        let mut kept = Some(letter);
        let mut next = after;
        match letter {
            '<' if dialect != Dialect::SubStation => {
                if let Some(tag) = tag(after) {
                    (kept, next) = (None, tag.rest);
                    match tag.name.as_str() {
                        "br" | "/br" | "p" | "/p" | "div" | "/div" => kept = Some('\n'),
                        "v" => out.push_str("\n- "),
                        "rp" => skips = true,
                        "/rp" => skips = false,
                        "" => stamped = true,
                        name => ruby.tag(name, &mut out),
                    }
                }
            }
            '{' if braces && (dialect == Dialect::SubStation || after.starts_with('\\')) => {
                match after.split_once('}') {
                    Some((inside, beyond)) => {
                        (kept, next) = (None, beyond);
                        drawing = draws(inside).unwrap_or(drawing);
                    }
                    // No later brace is closed either.
                    None => braces = false,
                }
            }
            '\\' => {
                let escaped = after.chars().next().unwrap_or(' ');
                let now = match escaped {
                    'N' => Some('\n'),
                    'h' => Some(' '),
                    'n' if dialect == Dialect::SubStation => Some(' '),
                    _ => None,
                };
                if now.is_some() {
                    (kept, next) = (now, &after[1..]);
                }
            }
            '[' if dialect == Dialect::YouTube => {
                if let Some(beyond) = after.strip_prefix("br]") {
                    (kept, next) = (Some('\n'), beyond);
                }
            }
            _ => {}
        }
        if !(skips || drawing && dialect == Dialect::SubStation) {
            out.extend(kept);
        }
        rest = next;
    }
    ruby.tag("/ruby", &mut out);
    let out: String = html_escape::decode_html_entities(&out).chars().map(from_windows).collect();
    let bare =
        |line: &str| line.split(is_space).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
    let lines = lines(&out).into_iter().map(bare);
    let is_mark = |letter: char| matches!(letter, '\u{200e}' | '\u{200f}');
    (lines.filter(|line| !line.chars().all(is_mark)).collect(), stamped)
}

/// The characters of Windows-1252 from 0x80. As HTML has it, references to control characters mean these.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

fn from_windows(letter: char) -> char {
    match u32::from(letter).checked_sub(0x80) {
        Some(at) if at < 32 => WINDOWS[at as usize],
        _ => letter,
    }
}

/// Reads the tag after `<`. `None` for text.
fn tag(text: &str) -> Option<Tag<'_>> {
    let end = text.find(['<', '>']).filter(|&end| text[end..].starts_with('>'))?;
    let (inside, rest) = (&text[..end], &text[end + 1..]);
    if inside.starts_with(|letter: char| letter.is_ascii_digit()) {
        let is_time =
            inside.contains(':') && !inside.contains(|letter: char| !matches!(letter, '0'..='9' | ':' | '.'));
        return is_time.then(|| Tag { name: String::new(), rest });
    }
    let (slash, bare) = inside.strip_prefix('/').map_or(("", inside), |bare| ("/", bare));
    let length = bare.find(|letter: char| !letter.is_ascii_alphanumeric()).unwrap_or(bare.len());
    let (name, more) = bare.split_at(length);
    let name = name.to_ascii_lowercase();
    // `a<b and c>d` is a comparison.
    let told = more.trim();
    let is_known = TAGS.contains(&name.as_str());
    let is_bare = told.is_empty() || told == "/" || told.starts_with('.');
    let has_values =
        more.starts_with(is_space) && (told.contains('=') || ["v", "lang"].contains(&name.as_str()));
    (is_known && (is_bare || has_values)).then(|| Tag { name: format!("{slash}{name}"), rest })
}

/// Whether a block of overrides switches a vector drawing on or off, whose text is a path.
fn draws(inside: &str) -> Option<bool> {
    let (_, after) = inside.rsplit_once("\\p")?;
    let digits: String = after.chars().take_while(char::is_ascii_digit).collect();
    digits.parse::<u32>().ok().map(|scale| scale > 0)
}

/// Ruby in the notation of the lettering, `漢字《かんじ》`.
#[derive(Default)]
struct Ruby {
    /// Start of the base text.
    base: Option<usize>,
    /// Start of its reading.
    reading: Option<usize>,
}

impl Ruby {
    fn tag(&mut self, name: &str, out: &mut String) {
        match name {
            "ruby" => {
                self.close(out);
                self.base = Some(out.len());
            }
            "rt" => {
                self.close(out);
                self.reading = self.base.map(|_| out.len());
            }
            "/rt" => self.close(out),
            "/ruby" => {
                self.close(out);
                self.base = None;
            }
            _ => {}
        }
    }

    fn close(&mut self, out: &mut String) {
        let (Some(base), Some(reading)) = (self.base, self.reading.take()) else { return };
        if base >= reading || reading > out.len() {
            return;
        }
        let read = out.split_off(reading);
        if !read.trim().is_empty() && !out[base..].trim().is_empty() {
            // The bar marks where the base text begins, whatever is before it.
            let is_han = |letter: char| matches!(u32::from(letter), 0x3400..=0x9fff | 0xf900..=0xfaff | 0x2_0000..=0x3_ffff);
            let before = out[..base].chars().next_back().is_some_and(is_han);
            if before || !out[base..].chars().all(is_han) || read.is_ascii() {
                out.insert(base, '｜');
            }
            out.push('《');
            out.push_str(read.trim());
            out.push('》');
        }
        self.base = Some(out.len());
    }
}
