//! Vertical text (tategaki), from top to bottom and right to left, for Chinese and Japanese. Most characters
//! are upright in a square. Dashes, brackets and words in other scripts are rotated. Full stops and small
//! kana move inside their squares. Two digits or exclamation marks share one square.
//!
//! Vertical alternates of the user's fonts (`given`) are used unchanged. All other glyphs are rotated and
//! moved automatically, including the traced ones, because a canvas does not draw vertical alternates.
//!
//! Sources: Unicode Standard Annex 50, "Vertical Text Layout"; W3C, "Requirements for Japanese Text Layout" (JLREQ), 2.3 and
//! 3.2.5.

use super::letters::{Font, Letters};
use crate::layout::Point;

/// Distance from the top of its square to the baseline of a character, in ems.
pub(super) const BASELINE: f64 = 0.88;
/// Distance of two columns in ems.
pub(super) const PITCH: f64 = 1.24;
/// How far small kana move to the right and up.
const SMALL: (f64, f64) = (0.1, 0.1);
/// Side of the square of a character, in ems.
const SQUARE: f64 = 1.0;

/// Orientation of a character in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stand {
    Upright,
    /// By a quarter, clockwise.
    Turned,
    /// In the upper right corner of its square instead of the lower left one.
    Corner,
    /// A small kana.
    Small,
}

/// Letters that stand together in a column.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cell {
    /// Index of its first character in the column.
    pub(super) start: usize,
    /// The one after the last.
    pub(super) end: usize,
    /// They are turned by a quarter.
    pub(super) turned: bool,
    /// How far they are moved to the right and up, in ems.
    pub(super) off: (f64, f64),
    /// For rotated characters: height of the column's centre over the baseline, in ems.
    pub(super) middle: f64,
    /// Their part of the column, in ems.
    pub(super) length: f64,
    /// Vertical alternate of the font. Its baseline begins at the left of the square.
    pub(super) form: Option<char>,
}

/// Returns whether a character belongs to a script without spaces that supports vertical text. A line may end
/// next to it.
pub(super) fn is_ideographic(letter: char) -> bool {
    matches!(u32::from(letter),
        0x2e80..=0x312f | 0x3190..=0xa4cf | 0xf900..=0xfaff | 0xfe30..=0xfe4f | 0xff01..=0xff9f
        | 0x1_b000..=0x1_b16f | 0x2_0000..=0x3_ffff)
}

/// Returns whether a character must not begin a line: closing marks, small kana, repetition and length marks.
pub(super) fn begins_no_line(letter: char) -> bool {
    small(letter) || "、。，．・：；！？)）」』】〉》〕］｝〟’”ー〜～…‥々ゝゞヽヾ!?.,:;".contains(letter)
}

/// Returns whether a character must not end a line: opening marks.
pub(super) fn ends_no_line(letter: char) -> bool {
    "(（「『【〈《〔［｛〝‘“".contains(letter)
}

fn small(letter: char) -> bool {
    "ぁぃぅぇぉっゃゅょゎゕゖァィゥェォッャュョヮヵヶ".contains(letter)
        || matches!(u32::from(letter), 0x31f0..=0x31ff)
}

fn stand(letter: char) -> Stand {
    let turned = "ー〜～…‥—–―＝｜＿：゠（）［］｛｝".contains(letter)
        || matches!(letter, '\u{3008}'..='\u{3011}' | '\u{3014}'..='\u{301b}');
    // Hangul, symbols and emoji.
    let others = matches!(u32::from(letter),
        0x1100..=0x11ff | 0x3130..=0x318f | 0xa960..=0xa97f | 0xac00..=0xd7ff | 0xffe0..=0xffe7
        | 0x2600..=0x27bf | 0x1_f000..=0x1_faff);
    if "、。，．".contains(letter) {
        Stand::Corner
    } else if small(letter) {
        Stand::Small
    } else if !turned && (others || is_ideographic(letter)) {
        Stand::Upright
    } else {
        Stand::Turned
    }
}

/// Divides the characters of a column into cells, from top to bottom.
pub(super) fn cells(letters: &Letters, font: &Font, column: &[char]) -> Vec<Cell> {
    let seen = |at: usize| letters.text_of(column[at]).chars().next().unwrap_or(' ');
    let alone = |letter: char| letter.is_ascii_digit() || matches!(letter, '!' | '?' | '！' | '？');
    let mut cells = Vec::new();
    let mut at = 0;
    while at < column.len() {
        let run = (at..column.len()).take_while(|&i| alone(seen(i))).count();
        let square = |start: usize, end: usize, off: (f64, f64)| Cell {
            start,
            end,
            turned: false,
            off,
            middle: 0.0,
            length: SQUARE,
            form: None,
        };
        if let Some(form) = letters.standing(column[at]) {
            cells.push(Cell { length: font.step(form), form: Some(form), ..square(at, at + 1, (0.0, 0.0)) });
            at += 1;
            continue;
        }
        // Two narrow digits share a cell. A longer number is set like a word of another script.
        let before =
            at.checked_sub(1).map(seen).is_some_and(|before| before.is_alphanumeric() && !upright(before));
        let after = (at + run < column.len()).then(|| seen(at + run));
        let within = before || after.is_some_and(|after| after.is_alphanumeric() && !upright(after));
        let wide = |i: usize| font.step(column[i]) > 0.8;
        if (1..=2).contains(&run) && !within {
            let end = if run == 2 && !wide(at) && !wide(at + 1) { at + 2 } else { at + 1 };
            cells.push(square(at, end, (0.0, 0.0)));
            at = end;
            continue;
        }
        let kind = stand(seen(at));
        if kind != Stand::Turned {
            let off = match kind {
                Stand::Corner => across(font, column[at]),
                Stand::Small => SMALL,
                _ => (0.0, 0.0),
            };
            cells.push(square(at, at + 1, off));
            at += 1;
            continue;
        }
        let stands = |&i: &usize| stand(seen(i)) != Stand::Turned || letters.standing(column[i]).is_some();
        let end = (at + 1..column.len()).find(stands).unwrap_or(column.len());
        let length = letters.width(font, &column[at..end]);
        let middle = middle(letters, font, &column[at..end]);
        cells.push(Cell { start: at, end, turned: true, off: (0.0, 0.0), middle, length, form: None });
        at = end;
    }
    cells
}

/// The centre of rotated characters: of their square, of capitals, or of a sign.
fn middle(letters: &Letters, font: &Font, run: &[char]) -> f64 {
    if run.iter().any(|&letter| letters.learnt(letter).is_some()) {
        return BASELINE - SQUARE / 2.0;
    }
    if run.iter().any(|letter| letter.is_alphanumeric()) {
        return font.capitals / 2.0;
    }
    let heights = || run.iter().flat_map(|&letter| font.outline(letter, 0.02)).flatten().map(|point| point.y);
    let (low, high) = (heights().fold(f64::MAX, f64::min), heights().fold(f64::MIN, f64::max));
    if low > high { 0.0 } else { f64::midpoint(low, high) }
}

/// Offset of a full stop from its corner of the square to the opposite corner. Chinese full stops stay in the
/// middle.
fn across(font: &Font, letter: char) -> (f64, f64) {
    let points: Vec<Point> = font.outline(letter, 0.02).concat();
    let middle = |axis: fn(&Point) -> f64| {
        let (low, high) = (
            points.iter().map(axis).fold(f64::MAX, f64::min),
            points.iter().map(axis).fold(f64::MIN, f64::max),
        );
        f64::midpoint(low, high)
    };
    if points.is_empty() {
        return (0.0, 0.0);
    }
    (SQUARE - 2.0 * middle(|point| point.x), 2.0 * BASELINE - SQUARE - 2.0 * middle(|point| point.y))
}

fn upright(letter: char) -> bool {
    stand(letter) != Stand::Turned
}

/// Returns the vertical advance of each character of a column, in ems. For a square cell, the first character
/// has all of it.
pub(super) fn steps(letters: &Letters, font: &Font, column: &[char]) -> Vec<f64> {
    let mut steps = vec![0.0; column.len()];
    for Cell { start, end, turned, length, .. } in cells(letters, font, column) {
        if !turned {
            steps[start] = length;
            continue;
        }
        for at in start..end {
            let next = (at + 1 < end).then(|| column[at + 1]);
            steps[at] = letters.advance(font, column[at], next);
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::super::contour::Contour;
    use super::*;

    /// A glyph table with squares for the characters of a text.
    fn knowing(text: &str) -> Letters {
        let mut letters = Letters::bundled().unwrap();
        let corners = [(0.0, 0.8), (0.8, 0.8), (0.8, 0.0)].map(|(x, y)| (None, Point::new(x, y)));
        let square = Contour { start: Point::new(0.0, 0.0), segments: corners.to_vec() };
        for letter in text.chars() {
            letters.learn_outline(&letter.to_string(), false, 1.0, std::slice::from_ref(&square));
        }
        letters
    }

    fn cells_of(text: &str) -> Vec<(String, bool)> {
        let letters = knowing("何だっけ。「」ー漢字！年！");
        let font = letters.font("comic-neue").unwrap();
        let column = letters.cleaned(text);
        let cells = cells(&letters, font, &column);
        let steps: f64 = steps(&letters, font, &column).iter().sum();
        assert!((steps - cells.iter().map(|cell| cell.length).sum::<f64>()).abs() < 1e-9);
        let said = |cell: &Cell| column[cell.start..cell.end].iter().map(|&l| letters.text_of(l)).collect();
        cells.iter().map(|cell| (said(cell), cell.turned)).collect()
    }

    #[test]
    fn letters_stand_and_other_words_are_turned() {
        let told = |text: &str| -> String {
            let cells = cells_of(text).into_iter();
            cells
                .map(|(said, turned)| if turned { format!("<{said}>") } else { format!("[{said}]") })
                .collect()
        };
        assert_eq!(told("何だっけ。"), "[何][だ][っ][け][。]");
        assert_eq!(told("「漢ー字」"), "<「>[漢]<ー>[字]<」>");
        assert_eq!(told("漢24年!?"), "[漢][24][年][!?]");
        assert_eq!(told("漢2026年"), "[漢]<2026>[年]");
        assert_eq!(told("漢OK2字"), "[漢]<OK2>[字]");
        assert_eq!(told("漢！字"), "[漢][！][字]");
        assert_eq!(told(""), "");
    }

    #[test]
    fn stops_and_small_kana_stand_in_their_corners() {
        let letters = knowing("っ。何");
        let font = letters.font("comic-neue").unwrap();
        let column = letters.cleaned("何っ。");
        let off: Vec<(f64, f64)> = cells(&letters, font, &column).iter().map(|cell| cell.off).collect();
        assert_eq!(off[..2], [(0.0, 0.0), SMALL]);
        // The glyphs of this test extend from 0 to 0.8 ems, with equal distances to the other edges.
        assert!((off[2].0 - 0.2).abs() < 1e-9 && (off[2].1 + 0.04).abs() < 1e-9, "{off:?}");
    }
}
