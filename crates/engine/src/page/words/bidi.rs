//! Order of characters on a line, by the Unicode Bidirectional Algorithm (UAX #9). Levels are computed for a
//! whole text item, whose first strong character sets the direction. Each line is reordered separately.

use unicode_bidi::{BidiClass, BidiInfo, Level, bidi_class};
use unicode_bidi_mirroring::get_mirrored;

/// A letter in its place on a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::page) struct Seen {
    /// Its index in the line as it is read.
    pub(in crate::page) at: usize,
    /// The letter, mirrored if it is a bracket in text from right to left.
    pub(in crate::page) letter: char,
}

/// Whether a letter is read from right to left.
pub(super) fn is_leftward(letter: char) -> bool {
    matches!(bidi_class(letter), BidiClass::R | BidiClass::AL)
}

/// Whether a character only directs the order of others: marks, embeddings, overrides and isolates. It is not drawn.
pub(super) fn is_director(letter: char) -> bool {
    matches!(letter, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Whether a letter is a part of words, and no digit or sign.
#[cfg(not(target_arch = "wasm32"))]
pub(super) fn is_of_words(letter: char) -> bool {
    matches!(bidi_class(letter), BidiClass::L | BidiClass::R | BidiClass::AL | BidiClass::NSM | BidiClass::BN)
}

/// The lines of a text item from left to right, without characters that only direct the order. `sign` gives the character that decides the direction of a letter.
pub(super) fn ordered(lines: &[&[char]], sign: impl Fn(char) -> char) -> Vec<Vec<Seen>> {
    let unturned =
        |line: &&[char]| line.iter().enumerate().map(|(at, &letter)| Seen { at, letter }).collect();
    let signs: Vec<Vec<char>> =
        lines.iter().map(|line| line.iter().map(|&letter| sign(letter)).collect()).collect();
    if !signs.iter().flatten().any(|&letter| is_leftward(letter) || is_director(letter)) {
        return lines.iter().map(unturned).collect();
    }
    // Lines part at spaces.
    let text = signs.iter().map(|line| line.iter().collect::<String>()).collect::<Vec<_>>().join(" ");
    let info = BidiInfo::new(&text, None);
    let mut start = 0;
    let line = |(letters, signs): (&&[char], &Vec<char>)| -> Vec<Seen> {
        let end = start + signs.iter().map(|letter| letter.len_utf8()).sum::<usize>();
        let levels = levels(&info, start..end);
        start = end + 1;
        let seen = |at: usize| Seen { at, letter: mirrored(letters[at], levels[at]) };
        let order = BidiInfo::reorder_visual(&levels).into_iter();
        order.filter(|&at| !is_director(letters[at])).map(seen).collect()
    };
    lines.iter().zip(&signs).map(line).collect()
}

/// A text from right to left as it is seen from left to right. Readers of PDF files expect text in this order.
pub(in crate::page) fn seen(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let info = BidiInfo::new(text, Some(Level::rtl()));
    let levels = levels(&info, 0..text.len());
    BidiInfo::reorder_visual(&levels).into_iter().map(|at| mirrored(letters[at], levels[at])).collect()
}

/// The level of each letter of a line, by its bytes in the text.
fn levels(info: &BidiInfo<'_>, line: std::ops::Range<usize>) -> Vec<Level> {
    let Some(paragraph) = info.paragraphs.iter().find(|paragraph| paragraph.range.contains(&line.start))
    else {
        return vec![Level::ltr(); info.text[line].chars().count()];
    };
    let levels = info.reordered_levels(paragraph, line.clone());
    let text = &info.text[line.clone()];
    text.char_indices().map(|(at, _)| levels[line.start + at]).collect()
}

fn mirrored(letter: char, level: Level) -> char {
    get_mirrored(letter).filter(|_| level.is_rtl()).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(text: &str) -> String {
        let letters: Vec<char> = text.chars().collect();
        ordered(&[&letters], |letter| letter)[0].iter().map(|seen| seen.letter).collect()
    }

    #[test]
    fn lines_are_ordered_as_by_another_library() {
        // Made by tests/oracles/direction.py.
        let cases = include_str!("../../../../../tests/oracles/data/direction.tsv");
        let mut count = 0;
        for (logical, visual) in cases.lines().filter_map(|case| case.split_once('\t')) {
            assert_eq!(line(logical), visual, "{logical}");
            count += 1;
        }
        assert!(count > 300, "{count}");
    }

    #[test]
    fn marks_and_embeddings_direct_the_order_as_in_fribidi_and_are_not_drawn() {
        // Made by tests/oracles/directors.py.
        let cases = include_str!("../../../../../tests/oracles/data/directors.tsv");
        let mut count = 0;
        for (logical, visual) in cases.lines().filter_map(|case| case.split_once('\t')) {
            assert_eq!(line(logical), visual, "{}", logical.escape_unicode());
            count += 1;
        }
        assert!(count > 300, "{count}");
    }

    #[test]
    fn an_override_goes_on_in_the_next_line() {
        let lines: Vec<Vec<char>> = ["\u{202e}abc", "def\u{202c}"].map(|line| line.chars().collect()).into();
        let seen = ordered(&[&lines[0], &lines[1]], |letter| letter);
        let text = |at: usize| seen[at].iter().map(|seen| seen.letter).collect::<String>();
        assert_eq!([text(0), text(1)], ["cba", "fed"]);
        assert_eq!(seen[0].iter().map(|seen| seen.at).collect::<Vec<_>>(), [3, 2, 1]);
    }

    #[test]
    fn the_first_strong_letter_of_all_lines_gives_the_direction() {
        let lines: Vec<Vec<char>> =
            ["12!", "שלום", "abc."].iter().map(|line| line.chars().collect()).collect();
        let lines: Vec<&[char]> = lines.iter().map(Vec::as_slice).collect();
        let seen = ordered(&lines, |letter| letter);
        let text = |at: usize| seen[at].iter().map(|seen| seen.letter).collect::<String>();
        assert_eq!([text(0), text(1), text(2)], ["!12", "םולש", ".abc"]);
        assert_eq!(seen[1].iter().map(|seen| seen.at).collect::<Vec<_>>(), [3, 2, 1, 0]);
    }

    #[test]
    fn words_in_files_are_in_the_order_of_the_page() {
        assert_eq!(seen("שלום"), "םולש");
        assert_eq!(seen("(12ש"), "ש12)");
    }
}
