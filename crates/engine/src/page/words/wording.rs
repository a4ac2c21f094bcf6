//! Typography by lettering rules: capitals, curly quotes, crossbar I only for the pronoun, emphasis for
//! `*stars*`, readings (`ruby`), and hyphenation points of long words.
//!
//! Source: Nate Piekos, "Comics Grammar & Tradition" (Blambot); the patterns of `TeX` by way of `hypher`.

use super::bidi::is_director;
use super::letters::{Font, Letters, STEM};
use super::model::TextItem;
use super::ruby;
use super::vertical;
use hypher::Lang;

/// Minimum number of characters before and after a hyphen in a word.
const AROUND_HYPHEN: (usize, usize) = (5, 3);
/// Marks a soft hyphen of the text during processing.
const SOFT: char = '\u{f8f1}';

/// Whether a word may be broken before a character.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// It may not.
    No,
    /// With a hyphen.
    Hyphen,
    /// Without a hyphen: after a hyphen or a dash of the text.
    Free,
}

/// A character to set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// The drawn character.
    pub letter: char,
    /// It is emphasised.
    pub strong: bool,
    /// Whether the word may be broken before it.
    pub part: Part,
    /// Number of its reading in the text, from 1; 0 without a reading.
    pub reading: u16,
}

impl Mark {
    /// A character without special properties.
    #[must_use]
    pub fn plain(letter: char) -> Self {
        Self { letter, strong: false, part: Part::No, reading: 0 }
    }
}

/// The characters of a text item. A plain item is set as it is written.
#[must_use]
pub fn marks(word: &TextItem, letters: &Letters, font: &Font) -> Vec<Mark> {
    if word.plain {
        return letters.directed(&word.text).into_iter().map(Mark::plain).collect();
    }
    let language = word.language.as_deref().unwrap_or_default().get(..2).unwrap_or_default().to_lowercase();
    let (written, directors) = directed_apart(written(word, letters));
    let (mut marks, _) = read_apart(written, letters);
    quotes(&mut marks, &language);
    parts(&mut marks, &language);
    beside(&mut marks, letters);
    // Columns have no order to direct, and ruby is by place.
    let plain = word.vertical || directors.is_empty() || word.text.contains('《');
    let sizes: Vec<usize> = if word.in_capitals() {
        let sizes = marks.iter().map(|mark| mark.letter.to_uppercase().count()).collect();
        marks = capitals(&marks, &language, font);
        sizes
    } else {
        vec![1; marks.len()]
    };
    if plain { marks } else { directed(marks, &sizes, &directors) }
}

/// Separates the characters that direct the order of others, each with the number of characters before it.
fn directed_apart(marks: Vec<Mark>) -> (Vec<Mark>, Vec<(usize, Mark)>) {
    let (mut out, mut directors) = (Vec::with_capacity(marks.len()), Vec::new());
    for mark in marks {
        if is_director(mark.letter) {
            directors.push((out.len(), mark));
        } else {
            out.push(mark);
        }
    }
    (out, directors)
}

/// Puts the characters that direct the order back. `sizes` are the numbers of characters that each character has become.
fn directed(marks: Vec<Mark>, sizes: &[usize], directors: &[(usize, Mark)]) -> Vec<Mark> {
    let mut out = Vec::with_capacity(marks.len() + directors.len());
    let mut marks = marks.into_iter();
    let mut directors = directors.iter().peekable();
    for at in 0..=sizes.len() {
        let here = std::iter::from_fn(|| directors.next_if(|(place, _)| *place == at));
        out.extend(here.map(|(_, mark)| *mark));
        out.extend(marks.by_ref().take(sizes.get(at).copied().unwrap_or_default()));
    }
    out
}

/// The readings of a text item, by number minus one.
#[must_use]
pub fn readings(word: &TextItem, letters: &Letters) -> Vec<Vec<char>> {
    if word.plain || !word.text.contains('《') {
        return Vec::new();
    }
    let (_, mut readings) = read_apart(directed_apart(written(word, letters)).0, letters);
    if word.in_capitals() {
        for reading in &mut readings {
            *reading = reading.iter().flat_map(|letter| letter.to_uppercase()).collect();
        }
    }
    readings
}

/// Returns the characters of a text item as they are written, with emphasis.
fn written(word: &TextItem, letters: &Letters) -> Vec<Mark> {
    let own = |letter: char| if matches!(letter, STEM | SOFT) { '\u{fffd}' } else { letter };
    let text: String =
        word.text.chars().map(|letter| if letter == '\u{ad}' { SOFT } else { own(letter) }).collect();
    emphasised(&letters.directed(&text))
}

/// Separates the visible characters from their readings.
fn read_apart(marks: Vec<Mark>, letters: &Letters) -> (Vec<Mark>, Vec<Vec<char>>) {
    let seen: Vec<char> =
        marks.iter().map(|mark| letters.text_of(mark.letter).chars().next().unwrap_or(' ')).collect();
    let (mut out, mut readings) = (Vec::with_capacity(marks.len()), Vec::<Vec<char>>::new());
    for (mark, part) in marks.into_iter().zip(ruby::parts(&seen)) {
        match part {
            ruby::Part::Sign => {}
            ruby::Part::Base(reading) => out.push(Mark { reading, ..mark }),
            ruby::Part::Reading(number) => {
                readings.resize(readings.len().max(number.into()), Vec::new());
                if let Some(reading) = readings.last_mut() {
                    reading.push(mark.letter);
                }
            }
        }
    }
    (out, readings)
}

/// Text of a text item for screen readers and copying: without emphasis marks, in the original case, with
/// readings in brackets.
#[must_use]
pub fn read(word: &TextItem) -> String {
    let said = |(base, reading): (String, Option<String>)| match reading {
        Some(reading) => format!("{base}（{reading}）"),
        None => base,
    };
    said_apart(word).into_iter().map(said).collect()
}

/// Text of a text item in segments, with a reading for segments that have one.
#[must_use]
pub fn said_apart(word: &TextItem) -> Vec<(String, Option<String>)> {
    if word.plain {
        return vec![(word.text.clone(), None)];
    }
    let text: Vec<char> = word.text.chars().filter(|&letter| letter != '\u{ad}').collect();
    ruby::stretches(&emphasised(&text).into_iter().map(|mark| mark.letter).collect::<String>())
}

/// Removes the emphasis marks, and marks the emphasised text.
fn emphasised(text: &[char]) -> Vec<Mark> {
    let opens = |at: usize| {
        let before = at.checked_sub(1).and_then(|i| text.get(i));
        before.is_none_or(|letter| !letter.is_alphanumeric() && *letter != '*')
            && text.get(at + 1).is_some_and(|letter| !letter.is_whitespace() && *letter != '*')
    };
    let closes = |at: usize| {
        !text[at - 1].is_whitespace() && text.get(at + 1).is_none_or(|letter| !letter.is_alphanumeric())
    };
    let mut marks = Vec::with_capacity(text.len());
    let (mut end, mut soft) = (None, false);
    let mut looked = 0;
    for (at, &letter) in text.iter().enumerate() {
        if letter == '*' {
            if end == Some(at) {
                end = None;
                continue;
            }
            // If a mark has no partner, later marks on the line are not searched. So the text is scanned at
            // most twice.
            if end.is_none() && at >= looked && opens(at) {
                let line = text[at + 1..].iter().position(|&l| l == '\n').map_or(text.len(), |i| at + 1 + i);
                end = (at + 2..line).find(|&i| text[i] == '*' && closes(i));
                if end.is_some() {
                    continue;
                }
                looked = line;
            }
        }
        if letter == SOFT {
            soft = !marks.is_empty();
            continue;
        }
        let part = if soft { Part::Hyphen } else { Part::No };
        soft = false;
        marks.push(Mark { letter, strong: end.is_some(), part, reading: 0 });
    }
    marks
}

/// Turns straight quotes and apostrophes into curly ones.
fn quotes(marks: &mut [Mark], language: &str) {
    let double = match language {
        "de" => ['„', '“'],
        _ => ['“', '”'],
    };
    let single = match language {
        "de" => ['‚', '‘'],
        _ => ['‘', '’'],
    };
    let mut open = false;
    for at in 0..marks.len() {
        let before = at.checked_sub(1).map(|i| marks[i].letter);
        let opening = before.is_none_or(|letter| letter.is_whitespace() || "([{¿¡—–-/„“‚‘".contains(letter));
        let after = marks.get(at + 1).map(|mark| mark.letter);
        marks[at].letter = match marks[at].letter {
            '"' => double[usize::from(!opening)],
            '\'' if opening && !elided(&marks[at + 1..]) && after.is_some_and(char::is_alphabetic) => {
                open = true;
                single[0]
            }
            '\'' if open && !after.is_some_and(char::is_alphanumeric) => {
                open = false;
                single[1]
            }
            // An omission is an apostrophe: '90s, 'em, don't.
            '\'' => '’',
            letter => letter,
        };
    }
}

/// Whether a text begins with an elided word, whose first characters are omitted.
fn elided(marks: &[Mark]) -> bool {
    let word: String = marks
        .iter()
        .take(8)
        .map(|mark| mark.letter)
        .take_while(|letter| letter.is_alphanumeric())
        .flat_map(char::to_lowercase)
        .collect();
    ["em", "tis", "twas", "til", "cause", "bout", "round", "n", "neath", "ere"].contains(&word.as_str())
}

/// Marks break opportunities of words: after hyphens and dashes, and hyphenation points of long words in
/// their language.
fn parts(marks: &mut [Mark], language: &str) {
    for at in 1..marks.len() {
        let (before, here) = (marks[at - 1].letter, marks[at].letter);
        let dash = "-–—/".contains(before) && here.is_alphanumeric();
        if (dash && at > 1 && marks[at - 2].letter.is_alphanumeric())
            || (before == '…' && here.is_alphabetic())
        {
            marks[at].part = Part::Free;
        }
    }
    let mut at = 0;
    while at < marks.len() {
        let length = marks[at..].iter().take_while(|mark| mark.letter.is_alphabetic()).count();
        if length >= AROUND_HYPHEN.0 + AROUND_HYPHEN.1 {
            let run = &mut marks[at..at + length];
            let word: String = run.iter().flat_map(|mark| mark.letter.to_lowercase()).collect();
            if word.chars().count() == length {
                let good = |place: &usize| *place >= AROUND_HYPHEN.0 && place + AROUND_HYPHEN.1 <= length;
                for place in breaks(&word, language).into_iter().filter(good) {
                    run[place].part = Part::Hyphen;
                }
            }
        }
        at += length.max(1);
    }
}

/// Marks line break opportunities for scripts without spaces (JLREQ, 3.1.7 and 3.1.8).
fn beside(marks: &mut [Mark], letters: &Letters) {
    let ends = |letter: char| {
        let text = letters.learnt(letter).map_or(letter.to_string(), str::to_owned);
        (text.chars().next().unwrap_or(letter), text.chars().next_back().unwrap_or(letter))
    };
    for at in 1..marks.len() {
        let (before, here) = (ends(marks[at - 1].letter).1, ends(marks[at].letter).0);
        let spaced = before.is_whitespace() || here.is_whitespace();
        // Base characters and their reading stay on one line.
        let bound = marks[at].reading != 0 && marks[at].reading == marks[at - 1].reading;
        let own = vertical::is_ideographic(before) || vertical::is_ideographic(here);
        if bound {
            marks[at].part = Part::No;
        } else if own && !spaced && !vertical::begins_no_line(here) && !vertical::ends_no_line(before) {
            marks[at].part = Part::Free;
        }
    }
}

/// Hyphenation points of a word by the rules of its language, in characters from its start.
fn breaks(word: &str, language: &str) -> Vec<usize> {
    if language == "en" {
        return english(word);
    }
    let mut code = [0; 2];
    code.iter_mut().zip(language.bytes()).for_each(|(to, from)| *to = from);
    let Some(language) = Lang::from_iso(code) else { return Vec::new() };
    let syllables = hypher::hyphenate(word, language).map(|syllable| syllable.chars().count());
    syllables
        .scan(0, |place, length| {
            *place += length;
            Some(*place)
        })
        .collect()
}

/// English words break after long prefixes and before long suffixes. Full patterns would take a tenth of the
/// size of the `words` module, for hyphens that letterers avoid.
fn english(word: &str) -> Vec<usize> {
    const BEGINNINGS: [&str; 7] = ["counter", "under", "super", "inter", "hyper", "trans", "after"];
    const ENDINGS: [&str; 7] = ["tion", "sion", "ment", "ness", "less", "ship", "hood"];
    let consonant = |rest: &str| !rest.starts_with(['a', 'e', 'i', 'o', 'u', 'y', 's']);
    let beginnings = BEGINNINGS.iter().filter_map(|part| {
        let rest = word.strip_prefix(part)?;
        consonant(rest).then(|| part.chars().count())
    });
    let one = word.strip_suffix('s').unwrap_or(word);
    let endings = ENDINGS.iter().filter_map(|part| {
        let rest = word.strip_suffix(part).or_else(|| one.strip_suffix(part))?;
        Some(rest.chars().count())
    });
    beginnings.chain(endings).collect()
}

/// Converts to capitals. If the font has both forms of I, the pronoun gets serifs and other words get a plain
/// stem.
fn capitals(marks: &[Mark], language: &str, font: &Font) -> Vec<Mark> {
    let letter = |at: usize| marks.get(at).map(|mark| mark.letter);
    let within = |letter: Option<char>| letter.is_some_and(char::is_alphanumeric);
    let mut out = Vec::with_capacity(marks.len());
    for (at, mark) in marks.iter().enumerate() {
        let alone = !within(at.checked_sub(1).and_then(letter)) && !within(letter(at + 1));
        let push = |out: &mut Vec<Mark>, letter: char, first: bool| {
            let letter = if letter == 'I' && !alone && font.has(STEM) { STEM } else { letter };
            out.push(Mark { letter, part: if first { mark.part } else { Part::No }, ..*mark });
        };
        match mark.letter {
            'i' if matches!(language, "tr" | "az") => push(&mut out, 'İ', true),
            other => {
                for (i, capital) in other.to_uppercase().enumerate() {
                    push(&mut out, capital, i == 0);
                }
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn marked(text: &str, language: &str) -> Vec<Mark> {
        let letters = Letters::bundled().unwrap();
        let word = json!({ "kind": "balloon", "text": text, "language": language, "capitals": false });
        let word = TextItem::read(word).unwrap();
        marks(&word, &letters, letters.font(word.font()).unwrap())
    }

    fn text(marks: &[Mark]) -> String {
        marks.iter().map(|mark| mark.letter).collect()
    }

    #[test]
    fn plain_items_are_set_as_they_are_written() {
        let letters = Letters::bundled().unwrap();
        let text = "\"2*3*4\" 漢字《かんじ》";
        let word = TextItem::read(json!({ "kind": "caption", "plain": true, "text": text })).unwrap();
        let marks = marks(&word, &letters, letters.font(word.font()).unwrap());
        assert_eq!(marks.iter().map(|mark| letters.text_of(mark.letter)).collect::<String>(), text);
        assert!(readings(&word, &letters).is_empty() && read(&word) == text);
    }

    #[test]
    fn quotes_are_curly() {
        let cases = [
            ("\"Don't,\" he said.", "en", "“Don’t,” he said."),
            ("Give 'em rock 'n' roll of the '90s", "en", "Give ’em rock ’n’ roll of the ’90s"),
            ("He said 'no way'.", "en", "He said ‘no way’."),
            ("(\"Ja\")", "de", "(„Ja“)"),
            ("5'", "en", "5’"),
        ];
        for (from, language, to) in cases {
            assert_eq!(text(&marked(from, language)), to);
        }
    }

    #[test]
    fn characters_that_direct_the_order_stay_and_change_no_other() {
        for (from, to) in [
            ("\u{200f}\"Ha\"\u{200f} *yes*!\u{200e}", "\u{200f}“Ha”\u{200f} yes!\u{200e}"),
            ("\u{2067}a\u{2069}", "\u{2067}a\u{2069}"),
            ("漢《\u{200f}かん》字", "漢字"),
        ] {
            let letters = Letters::bundled().unwrap();
            let read: String = marked(from, "en").iter().map(|mark| letters.text_of(mark.letter)).collect();
            assert_eq!(read, to);
        }
        let letters = Letters::bundled().unwrap();
        let word = json!({ "kind": "balloon", "text": "aß\u{200e}ß!", "capitals": true });
        let word = TextItem::read(word).unwrap();
        let font = letters.font(word.font()).unwrap();
        assert_eq!(text(&marks(&word, &letters, font)), "ASS\u{200e}SS!");
        let standing = TextItem { vertical: true, ..word };
        assert_eq!(text(&marks(&standing, &letters, font)), "ASSSS!");
    }

    #[test]
    fn stars_emphasise_what_is_between_them() {
        let strong = |from: &str| {
            let marks = marked(from, "en");
            let strong: Vec<Mark> = marks.iter().copied().filter(|mark| mark.strong).collect();
            (text(&marks), text(&strong))
        };
        assert_eq!(strong("I *really* mean it"), ("I really mean it".into(), "really".into()));
        assert_eq!(strong("*All of it.*"), ("All of it.".into(), "All of it.".into()));
        for plain in ["2 * 3 * 4", "a*b*c", "*", "**", "half *open", "*over\nlines*"] {
            assert_eq!(strong(plain), (plain.into(), String::new()));
        }
    }

    #[test]
    fn long_words_part_by_their_language() {
        let parted = |from: &str, language: &str| {
            let mut out = String::new();
            for mark in marked(from, language) {
                match mark.part {
                    Part::Hyphen => out.push('|'),
                    Part::Free => out.push('+'),
                    Part::No => {}
                }
                out.push(mark.letter);
            }
            out
        };
        assert_eq!(parted("international", "en"), "inter|national");
        assert_eq!(parted("Misinformation", "en"), "Misinforma|tion");
        assert_eq!(parted("kindnesses transatlantic", "en"), "kindnesses transatlantic");
        assert_eq!(parted("lighthouse table", "en"), "lighthouse table");
        assert_eq!(parted("international", ""), "international", "no language, no rules");
        assert_eq!(parted("well-known", "en"), "well-+known");
        assert_eq!(parted("super\u{ad}man", ""), "super|man");
        assert!(parted("extraordinario", "pt").contains('|'));
    }

    #[test]
    fn the_i_with_bars_is_the_pronoun() {
        let letters = Letters::bundled().unwrap();
        let word = TextItem::read(json!({ "kind": "balloon", "text": "I’m in it, am I?" })).unwrap();
        let set = marks(&word, &letters, letters.font(word.font()).unwrap());
        assert_eq!(text(&set), format!("I’M {STEM}N {STEM}T, AM I?"));
    }
}
