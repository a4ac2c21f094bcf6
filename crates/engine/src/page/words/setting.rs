//! Text broken into lines and fitted into a shape.
//!
//! For each number of lines, finds the narrowest shape that contains the text, with each line filled to the
//! width of the shape. This balances the lines. Lines of an ellipse are short at the top and the bottom. The
//! number of lines with the best shape is used. If none fits, a smaller size is tried.

use super::letters::{Font, Letters};
use super::model::Kind;
use super::ruby::{self, Under};
use super::vertical;
use super::wording::Mark;

/// Exponent of the superellipse that balloons are: a little fuller than an ellipse, as drawn ones are.
pub(super) const FULLNESS: f64 = 2.4;

/// Distance of two baselines in ems.
pub(super) const PITCH: f64 = 1.12;

/// Requirements of a set text.
#[derive(Debug, Clone, Copy)]
pub struct Wish {
    /// Kind of the text item.
    pub kind: Kind,
    /// Its lines are columns, from right to left.
    pub vertical: bool,
    /// Whether the text is only left-aligned lines.
    pub plain: bool,
    /// It is read on screens.
    pub screens: bool,
    /// Width of the shape in page widths, if the user set it.
    pub width: Option<f64>,
    /// Height of an em in page widths, if the user set it.
    pub size: Option<f64>,
    /// Width and height that the shape should not exceed, in page widths.
    pub room: (f64, f64),
    /// Maximum width and height before the text becomes too small for easy reading.
    pub most: (f64, f64),
    /// Width and height that it must not exceed.
    pub page: (f64, f64),
}

/// Text that is set. Lengths are in page widths.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Height of an em.
    pub size: f64,
    /// Distance of two baselines, or of the middles of two columns.
    pub pitch: f64,
    /// The lines, each with its width; the columns, each with its height.
    pub lines: Vec<(Vec<char>, f64)>,
    /// Emphasised characters of each line.
    pub strong: Vec<Vec<bool>>,
    /// Ruby of each line by character; empty without readings.
    pub under: Vec<Vec<Under>>,
    /// The readings, by number minus one.
    pub readings: Vec<Vec<char>>,
    /// Whether columns begin at the same height. If not, lines are centred.
    pub flush: bool,
    /// Half the width and height of the shape around.
    pub half: (f64, f64),
    /// The text did not fit even at the smallest size: its end is missing.
    pub cut: bool,
}

/// Values of a kind: lengths in ems, sizes in page widths.
pub(super) struct Manner {
    pub(super) round: bool,
    /// Space left and right of the glyphs, and above and below them.
    pub(super) pad: (f64, f64),
    /// Preferred width over height.
    pub(super) aspect: f64,
    pub(super) largest: f64,
    /// Minimum size for easy reading.
    pub(super) readable: f64,
    pub(super) smallest: f64,
}

/// Maximum number of lines of a text item.
const MOST_LINES: usize = 60;

/// A text with all that it is set by.
#[derive(Clone, Copy)]
pub(super) struct Setter<'a> {
    pub(super) letters: &'a Letters,
    pub(super) font: &'a Font,
    /// The font for emphasis.
    pub(super) strong: &'a Font,
    pub(super) text: &'a [Mark],
    /// The readings of its characters.
    pub(super) readings: &'a [Vec<char>],
    pub(super) wish: &'a Wish,
    pub(super) manner: &'a Manner,
    /// Advance of each character in a column; empty for horizontal text.
    pub(super) steps: &'a [f64],
    /// Extra advance of each character because of its reading, in ems; empty without readings.
    pub(super) apart: &'a [f64],
}

/// Cost of a shape, the first token of each line and the token after its last, and half the size of the shape
/// in ems.
type Candidate = (f64, Vec<(usize, usize)>, (f64, f64));

/// Characters that stay together: a word, or a part of a word that is longer than any line.
struct Token {
    start: usize,
    end: usize,
    width: f64,
    /// Space before it unless it begins a line: a space, or nothing within a word.
    gap: f64,
    /// It begins a line.
    fresh: bool,
}

impl Setter<'_> {
    /// Returns the advance of a character of the text, in ems.
    pub(super) fn advance(&self, at: usize, next: Option<char>) -> f64 {
        let apart = self.apart.get(at).copied().unwrap_or_default();
        if let Some(step) = self.steps.get(at) {
            return *step + apart;
        }
        let mark = self.text[at];
        self.letters.advance(if mark.strong { self.strong } else { self.font }, mark.letter, next) + apart
    }

    /// Returns the additional advance of each character because of its reading, in ems.
    pub(super) fn apart(&self) -> Vec<f64> {
        if self.readings.is_empty() {
            return Vec::new();
        }
        let mut apart = vec![0.0; self.text.len()];
        let mut at = 0;
        while at < self.text.len() {
            let number = self.text[at].reading;
            let count = self.text[at..].iter().take_while(|mark| mark.reading == number).count();
            let reading = usize::from(number).checked_sub(1).and_then(|number| self.readings.get(number));
            if let Some(reading) = reading {
                let base = (self.width(at..at + count), count);
                let more = ruby::apart(self.letters, self.font, reading, self.wish.vertical, base);
                apart[at..at + count].fill(more);
            }
            at += count;
        }
        apart
    }

    /// Ruby of the characters of a line.
    pub(super) fn under(&self, part: std::ops::Range<usize>) -> Vec<Under> {
        let under = |at: usize| Under { reading: self.text[at].reading, apart: self.apart[at] };
        if self.apart.is_empty() { Vec::new() } else { part.map(under).collect() }
    }

    /// Returns the space between two words of a line, in ems.
    pub(super) fn space(&self) -> f64 {
        self.letters.advance(self.font, ' ', None)
    }

    /// Distance of two lines in ems.
    pub(super) fn pitch(&self) -> f64 {
        let room = if self.readings.is_empty() { (0.0, 0.0) } else { ruby::ROOM };
        match (self.wish.vertical, self.wish.kind) {
            (true, _) => vertical::PITCH + room.1,
            (false, Kind::Effect) => 0.95 + room.0,
            (false, _) => PITCH + room.0,
        }
    }

    /// Height of a line in ems, including its ruby.
    pub(super) fn thickness(&self) -> f64 {
        let more = if self.readings.is_empty() { (0.0, 0.0) } else { ruby::THICKER };
        if self.wish.vertical { 1.0 + more.1 } else { self.font.capitals + more.0 }
    }

    /// Width of a part of the text on one line, in ems.
    pub(super) fn width(&self, part: std::ops::Range<usize>) -> f64 {
        let next = |at: usize| (at + 1 < part.end).then(|| self.text[at + 1].letter);
        part.clone().map(|at| self.advance(at, next(at))).sum()
    }

    /// A quick test: `false` if the text is certainly too long.
    pub(super) fn may_fit(&self, size: f64, room: (f64, f64)) -> bool {
        let area = room.0.max(self.wish.width.unwrap_or(0.0)) * room.1;
        // Only the narrowest glyphs are less than a fifth of an em wide.
        self.text.len() < 200 || self.text.len() as f64 * 0.1 * size * size < area
    }

    /// Returns the characters of a line, and which of them are emphasised.
    pub(super) fn line(&self, part: std::ops::Range<usize>) -> (Vec<char>, Vec<bool>) {
        self.text[part].iter().map(|mark| (mark.letter, mark.strong)).unzip()
    }

    /// Sets the text at a size, if it fits into `room`. `cut` truncates it instead.
    pub(super) fn at(&self, size: f64, room: (f64, f64), cut: bool) -> Option<Setting> {
        let (pitch, capitals) = (self.pitch(), self.thickness());
        let (pad_x, pad_y) = self.manner.pad;
        let wide = self.wish.width.unwrap_or(room.0) / size / 2.0;
        let high = room.1 / size / 2.0;
        let tokens = self.tokens((2.0 * (wide - pad_x) * if self.manner.round { 0.8 } else { 1.0 }).max(0.6));
        let most = tokens.len().clamp(1, MOST_LINES);
        let mut best: Option<Candidate> = None;
        for count in 1..=most {
            let block = f64::midpoint((count - 1) as f64 * pitch, capitals);
            let b = if self.manner.round { block * 1.18 + pad_y } else { block + pad_y };
            if b > high {
                break;
            }
            // Relative half width of the shape at the height of a line.
            let share = |line: usize| {
                let edge = (line as f64 - (count - 1) as f64 / 2.0).abs() * pitch + capitals / 2.0;
                let inside = 1.0 - (edge / b).powf(FULLNESS);
                if self.manner.round { inside.max(0.0).powf(1.0 / FULLNESS) } else { 1.0 }
            };
            let shares: Vec<f64> = (0..count).map(share).collect();
            let fill = |a: f64| fill(&tokens, &shares, |share| 2.0 * (a * share - pad_x), cut);
            let Some(mut lines) = fill(wide) else { continue };
            let (mut low, mut a) = (0.0, wide);
            for _ in 0..if cut { 0 } else { 20 } {
                let middle = f64::midpoint(low, a);
                match fill(middle) {
                    Some(found) => (a, lines) = (middle, found),
                    None => low = middle,
                }
            }
            // Fewer lines than expected would not be centred in the shape.
            if lines.len() < count && !cut && !tokens.is_empty() {
                continue;
            }
            // A balloon with one short word must not become a pill shape.
            if self.manner.round {
                a = a.max(b * 1.1).min(wide);
            }
            let badness = if cut {
                -(count as f64)
            } else if self.wish.width.is_some() {
                count as f64
            } else {
                (a / b / self.manner.aspect).ln().abs()
            };
            if best.as_ref().is_none_or(|(least, ..)| badness < *least) {
                best = Some((badness, lines, (self.wish.width.map_or(a, |_| wide), b)));
            }
        }
        let (_, lines, half) = best?;
        let missing = lines.last().is_some_and(|line| line.1 < tokens.len());
        let mut strong = Vec::with_capacity(lines.len());
        let under = lines.iter().map(|&(first, end)| self.under(tokens[first].start..tokens[end - 1].end));
        let under = under.collect();
        let runs = lines.iter().enumerate().map(|(i, &(first, end))| {
            let part = tokens[first].start..tokens[end - 1].end;
            let mut width = self.width(part.clone());
            let (mut run, mut marks) = self.line(part.clone());
            if missing && i + 1 == lines.len() {
                width += self.advance(part.end - 1, Some('…')) - self.advance(part.end - 1, None);
                width += self.letters.advance(self.font, '…', None);
                run.push('…');
                marks.push(false);
            }
            strong.push(marks);
            (run, width * size)
        });
        let lines = runs.collect();
        let half = (half.0 * size, half.1 * size);
        Some(Setting {
            size,
            pitch: pitch * size,
            lines,
            strong,
            under,
            readings: self.readings.to_vec(),
            flush: false,
            half,
            cut: missing,
        })
    }

    /// The text in tokens no wider than `most` ems. In a sound effect, words break only at line ends.
    fn tokens(&self, most: f64) -> Vec<Token> {
        let space = self.space();
        let whole = matches!(self.wish.kind, Kind::Effect) && self.wish.size.is_none();
        let mut tokens: Vec<Token> = Vec::new();
        let (mut open, mut fresh) = (false, false);
        for (i, letter) in self.text.iter().map(|mark| mark.letter).enumerate() {
            if letter == '\n' || (letter == ' ' && !(whole && open)) {
                open = false;
                fresh |= letter == '\n' && !tokens.is_empty();
                continue;
            }
            let next = self.text.get(i + 1).map(|next| next.letter).filter(|next| *next != '\n');
            let advance = self.advance(i, next);
            match tokens.last_mut() {
                Some(token) if open && (token.width + advance <= most || whole) => {
                    token.end = i + 1;
                    token.width += advance;
                }
                _ => {
                    let gap = if open { 0.0 } else { space };
                    tokens.push(Token { start: i, end: i + 1, width: advance, gap, fresh });
                    (open, fresh) = (true, false);
                }
            }
        }
        tokens
    }
}

/// Fills lines with tokens one after the other; `None` when they are not enough. With `cut`, text that does
/// not fit is removed. Gives the first token and the one after the last of each line.
fn fill(
    tokens: &[Token],
    shares: &[f64],
    capacity: impl Fn(f64) -> f64,
    cut: bool,
) -> Option<Vec<(usize, usize)>> {
    let mut lines = Vec::with_capacity(shares.len());
    let mut at = 0;
    for &share in shares {
        if at == tokens.len() {
            break;
        }
        let room = capacity(share);
        let first = at;
        let mut width = 0.0;
        while let Some(token) = tokens.get(at) {
            let more = token.width + if at > first { token.gap } else { 0.0 };
            if width + more > room + 1e-9 || (token.fresh && at > first) {
                break;
            }
            width += more;
            at += 1;
        }
        if at == first {
            return None;
        }
        lines.push((first, at));
    }
    (cut || at == tokens.len()).then_some(lines)
}
