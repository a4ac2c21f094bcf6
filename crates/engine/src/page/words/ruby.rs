//! Ruby: small readings next to their base text, common in Japanese and Chinese comics. `漢字《かんじ》` gives the
//! preceding Han characters a reading in kana. `|base《reading》` gives any text a reading. A backslash escapes
//! these signs.
//!
//! Lines never break between base text and reading. If a reading is longer than its base text, the base text
//! is spaced out, so that readings do not touch. If it is shorter, it is spread over the base text, with half
//! the gap at its ends.
//!
//! Sources: the manual of Aozora Bunko for its input files, for the notation; W3C, "Requirements for Japanese
//! Text Layout" (JLREQ), 3.3, for the positions.

use super::letters::{Font, Letters};
use super::vertical;
use std::ops::Range;

/// Size of a reading, relative to its base characters.
pub(super) const SIZE: f64 = 0.5;
/// Distance between characters and their reading, in ems.
const AIR: f64 = 0.05;
/// Maximum length of a reading and of its base text, in characters. Longer text in such brackets is a title
/// or a quotation.
const LONGEST: usize = 40;
/// Extra space between lines of a text with ruby, and between columns, in ems.
pub(super) const ROOM: (f64, f64) = (0.46, 0.36);
/// Extra thickness of a text with ruby above its lines, and next to its columns, in ems.
pub(super) const THICKER: (f64, f64) = (0.7, SIZE + AIR);

/// The part of a reading that belongs to a glyph.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Under {
    /// Number of its reading, from 1; 0 without a reading.
    pub reading: u16,
    /// Extra advance of the character in ems: half before it, half after it.
    pub apart: f64,
}

/// Base characters of a text, and their reading.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Note {
    base: Range<usize>,
    reading: Range<usize>,
    /// The vertical bar before the base characters.
    bar: Option<usize>,
}

/// Notation of a text, separate from its characters.
struct Notes {
    notes: Vec<Note>,
    /// Backslashes that escape a sign.
    escapes: Vec<usize>,
}

/// Role of a character in a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// It is set; with the number of its reading, from 1, or 0.
    Base(u16),
    /// A character of the reading with this number.
    Reading(u16),
    /// A sign of the notation.
    Sign,
}

/// Returns whether a character is Han, so that a following reading belongs to it.
fn is_han(letter: char) -> bool {
    "々〆〇ヶ".contains(letter)
        || matches!(u32::from(letter), 0x3400..=0x4dbf | 0x4e00..=0x9fff | 0xf900..=0xfaff | 0x2_0000..=0x3_ffff)
}

/// Whether a character is phonetic: kana or bopomofo. Other text in such brackets is a title in Chinese.
fn is_phonetic(letter: char) -> bool {
    matches!(u32::from(letter), 0x3041..=0x309f | 0x30a0..=0x30ff | 0x3105..=0x312f | 0x31f0..=0x31ff | 0xff66..=0xff9f)
}

/// The readings of a text.
fn notes(text: &[char]) -> Notes {
    let (mut notes, mut escapes) = (Vec::new(), Vec::new());
    // Characters before this index belong to another reading.
    let (mut free, mut bar) = (0, None);
    let mut at = 0;
    while at < text.len() {
        match text[at] {
            '\\' if text.get(at + 1).is_some_and(|next| "《》|｜".contains(*next)) => {
                escapes.push(at);
                at += 2;
                free = at;
                continue;
            }
            '|' | '｜' => bar = Some(at),
            '\n' => bar = None,
            '《' => {
                if let Some(note) = note(text, at, free, bar) {
                    at = note.reading.end;
                    free = at + 1;
                    notes.push(note);
                }
                bar = None;
            }
            _ => {}
        }
        at += 1;
    }
    Notes { notes, escapes }
}

/// The reading whose bracket opens at a position. `None` for other brackets.
fn note(text: &[char], open: usize, free: usize, bar: Option<usize>) -> Option<Note> {
    let length = text[open + 1..].iter().take(LONGEST + 1).position(|&letter| "》《\n".contains(letter))?;
    let reading = open + 1..open + 1 + length;
    let said = &text[reading.clone()];
    if text[reading.end] != '》' || said.iter().all(|letter| letter.is_whitespace()) {
        return None;
    }
    let told = bar
        .map(|bar| bar + 1..open)
        .filter(|base| (1..=LONGEST).contains(&base.len()) && !text[base.start].is_whitespace());
    if let Some(base) = told {
        return Some(Note { base, reading, bar });
    }
    let start = (free..open).rev().take_while(|&at| is_han(text[at])).last()?;
    said.iter().all(|&letter| is_phonetic(letter)).then_some(Note { base: start..open, reading, bar: None })
}

/// The role of each character of a text.
pub(super) fn parts(text: &[char]) -> Vec<Part> {
    let mut parts = vec![Part::Base(0); text.len()];
    let Notes { notes, escapes } = notes(text);
    for at in escapes {
        parts[at] = Part::Sign;
    }
    for (number, Note { base, reading, bar }) in (1..=u16::MAX).zip(notes) {
        parts[reading.start - 1] = Part::Sign;
        parts[reading.end] = Part::Sign;
        if let Some(bar) = bar {
            parts[bar] = Part::Sign;
        }
        // Escape signs do not change.
        let set = |part: &mut Part, to: Part| *part = if *part == Part::Sign { Part::Sign } else { to };
        parts[base].iter_mut().for_each(|part| set(part, Part::Base(number)));
        parts[reading].iter_mut().for_each(|part| set(part, Part::Reading(number)));
    }
    parts
}

/// A text in segments, with a reading for segments that have one.
#[must_use]
pub fn stretches(text: &str) -> Vec<(String, Option<String>)> {
    let letters: Vec<char> = text.chars().collect();
    let mut out: Vec<(u16, String, Option<String>)> = Vec::new();
    for (&letter, part) in letters.iter().zip(parts(&letters)) {
        match part {
            Part::Sign => {}
            Part::Reading(_) => {
                if let Some((_, _, reading)) = out.last_mut() {
                    reading.get_or_insert_default().push(letter);
                }
            }
            Part::Base(number) => match out.last_mut() {
                Some((last, base, _)) if *last == number => base.push(letter),
                _ => out.push((number, letter.to_string(), None)),
            },
        }
    }
    out.into_iter().map(|(_, base, reading)| (base, reading)).collect()
}

/// Returns the length of a reading in ems of its base characters, in a line or a column.
fn length(letters: &Letters, font: &Font, reading: &[char], columns: bool) -> f64 {
    SIZE * if columns {
        vertical::steps(letters, font, reading).iter().sum::<f64>()
    } else {
        letters.width(font, reading)
    }
}

/// Returns the letter spacing of characters with a total width of `wide`, so that their reading fits.
pub(super) fn apart(
    letters: &Letters,
    font: &Font,
    reading: &[char],
    columns: bool,
    (wide, count): (f64, usize),
) -> f64 {
    (length(letters, font, reading, columns) - wide).max(0.0) / count.max(1) as f64
}

/// The start of a reading within its base text, and the extra space between the characters of the reading, in
/// ems of its characters.
pub(super) fn spread(
    letters: &Letters,
    font: &Font,
    reading: &[char],
    columns: bool,
    wide: f64,
) -> (f64, f64) {
    let left = (wide - length(letters, font, reading, columns)).max(0.0);
    let gap = left / reading.len().max(1) as f64;
    (gap / 2.0, gap)
}

/// Height of the ruby baseline over the baseline of the base text, in ems.
pub(super) fn rise() -> f64 {
    vertical::BASELINE + AIR + SIZE * (1.0 - vertical::BASELINE)
}

/// Distance between the centre of a ruby column and the centre of its base text, in ems.
pub(super) fn aside() -> f64 {
    0.5 + AIR + SIZE / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn told(text: &str) -> String {
        let part = |(base, reading): (String, Option<String>)| match reading {
            Some(reading) => format!("[{base}/{reading}]"),
            None => base,
        };
        stretches(text).into_iter().map(part).collect()
    }

    #[test]
    fn letters_of_han_have_the_reading_behind_them_and_others_that_behind_their_bar() {
        for (text, says) in [
            ("漢字《かんじ》", "[漢字/かんじ]"),
            ("お茶《ちゃ》を飲《の》む", "お[茶/ちゃ]を[飲/の]む"),
            ("|お茶《おちゃ》", "[お茶/おちゃ]"),
            ("｜OK《オーケー》だ", "[OK/オーケー]だ"),
            ("人々《ひとびと》", "[人々/ひとびと]"),
            ("東《ひがし》京《きょう》", "[東/ひがし][京/きょう]"),
            ("|本気《まじ》と|書《か》いて", "[本気/まじ]と[書/か]いて"),
            // An explicit reading may contain any text.
            ("|宇宙《うちゅう foo》", "[宇宙/うちゅう foo]"),
        ] {
            assert_eq!(told(text), says);
        }
    }

    #[test]
    fn what_is_no_reading_stays_as_it_is_written() {
        for text in [
            "我读《红楼梦》",
            "《かな》",
            "かな《かな》",
            "漢字《》",
            "漢字《 》",
            "漢字《かんじ",
            "漢字《か\nんじ》",
            "a | b",
            "a \\ b",
            "》漢字",
        ] {
            assert_eq!(told(text), text);
        }
        assert_eq!(told("漢字\\《かんじ\\》"), "漢字《かんじ》");
        assert_eq!(told("\\|本気《まじ》"), "|[本気/まじ]");
        assert_eq!(told("|a\\|b《x》"), "[a|b/x]");
    }

    proptest! {
        #[test]
        fn any_text_has_an_answer(text in "[漢字かな|｜《》\\\\a \n]{0,40}") {
            let letters: Vec<char> = text.chars().collect();
            let parts = parts(&letters);
            prop_assert_eq!(parts.len(), letters.len());
            let signs = parts.iter().filter(|part| **part == Part::Sign).count();
            let said: usize = stretches(&text)
                .iter()
                .map(|(base, reading)| base.chars().count() + reading.as_ref().map_or(0, |r| r.chars().count()))
                .sum();
            prop_assert_eq!(said + signs, letters.len());
        }
    }
}
