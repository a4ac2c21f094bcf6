//! Text broken into lines and fitted into a shape.
//!
//! For each number of lines, finds the narrowest shape that contains the text, with each line filled to the
//! width of the shape. This balances the lines. Lines of an ellipse are short at the top and the bottom. The
//! number of lines with the best shape is used. If none fits, a smaller size is tried.

use super::lens;
use super::letters::{Font, Letters};
use super::model::{Kind, Shape};
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
    largest: f64,
    /// Minimum size for easy reading.
    readable: f64,
    smallest: f64,
}

fn manner(kind: Kind, width: Option<f64>, screens: bool) -> Manner {
    if kind == Kind::Effect {
        let largest = if width.is_some() { 0.4 } else { 0.085 };
        let pad = (0.14, 0.14);
        return Manner { round: false, pad, aspect: 20.0, largest, readable: largest, smallest: 0.012 };
    }
    let round = kind != Kind::Caption;
    let (pad, aspect) = if round { ((0.5, 0.46), 1.5) } else { ((0.6, 0.52), 3.2) };
    // On A4, 210 mm wide, 0.0168 are 10 points and 0.0134 are 8. Shouts are larger, whispers are smaller.
    let loud: f64 = match kind {
        Kind::Balloon(Shape::Shout) => 1.15,
        Kind::Balloon(Shape::Whisper) | Kind::Caption => 0.95,
        _ => 1.0,
    };
    if screens {
        let [largest, readable] = ON_SCREENS.map(|size| size * loud.max(1.0));
        return Manner { round, pad, aspect, largest, readable, smallest: LEGIBLE_ON_SCREENS };
    }
    Manner { round, pad, aspect, largest: 0.0168 * loud, readable: 0.0134 * loud, smallest: 0.0098 }
}

/// Sizes of text for screens: the usual one, and the smallest one of a short text. On a page that is 435 pixels wide, as in
/// a small window, these are 12 and 10 pixels, and on a phone 11 and 9.
const ON_SCREENS: [f64; 2] = [0.028, 0.0235];
/// The smallest size of long texts on screens: 10 pixels on a page that is 550 pixels wide.
pub(super) const LEGIBLE_ON_SCREENS: f64 = 0.0182;

/// Each size that is tried is smaller by this factor.
const STEP: f64 = 0.93;
/// Maximum number of lines of a text item.
const MOST_LINES: usize = 60;

/// Sets a text of [`marks`](super::wording::marks), with its [`readings`](super::wording::readings).
#[must_use]
pub fn set(letters: &Letters, font: &Font, text: (&[Mark], &[Vec<char>]), wish: &Wish) -> Setting {
    let mut manner = manner(wish.kind, wish.width, wish.screens);
    if wish.plain {
        manner.pad = (0.0, 0.0);
    }
    if !wish.vertical {
        return lines(letters, font, text, (wish, &manner));
    }
    // Columns are rotated lines.
    let aside = |(across, down): (f64, f64)| (down, across);
    let mut own =
        Wish { width: None, room: aside(wish.room), most: aside(wish.most), page: aside(wish.page), ..*wish };
    let mut aspect = manner.aspect;
    if let Some(width) = wish.width {
        (own.room.1, own.most.1) = (width, width);
        // As high as the text is in a shape of that width, about.
        let size = wish.size.unwrap_or(manner.largest);
        let area = text.0.len() as f64 * vertical::PITCH * size * size * if manner.round { 2.0 } else { 1.3 };
        aspect = (area / (width * width)).clamp(0.3, 8.0);
    }
    let mut setting = lines(letters, font, text, (&own, &Manner { aspect, ..manner }));
    setting.half = aside(setting.half);
    setting.half.0 = setting.half.0.max(wish.width.unwrap_or(0.0) / 2.0);
    setting
}

/// Sets a text in lines, or in columns as if they were lines.
fn lines(
    letters: &Letters,
    font: &Font,
    (text, readings): (&[Mark], &[Vec<char>]),
    (wish, manner): (&Wish, &Manner),
) -> Setting {
    let smallest = wish.size.unwrap_or(manner.smallest);
    let strong = letters.strong(font);
    let column: Vec<char> = text.iter().map(|mark| mark.letter).collect();
    let steps = if wish.vertical { vertical::steps(letters, font, &column) } else { Vec::new() };
    let bare = Setter { letters, font, strong, text, readings, wish, manner, steps: &steps, apart: &[] };
    let apart = bare.apart();
    let setter = Setter { apart: &apart, ..bare };
    if wish.plain {
        return plain(&setter);
    }
    let lens = (wish.kind != Kind::Effect).then(|| lens::Lens::new(&setter));
    let lens = lens.filter(lens::Lens::is_short);
    let at = |setter: &Setter, size: f64, room: (f64, f64)| match &lens {
        Some(lens) => lens.at(size, room, setter.wish.width),
        None => setter.at(size, room, false),
    };
    // Step 1: reduce the text while it stays readable. Step 2: enlarge the shape. Step 3: reduce the text
    // further.
    let readable = wish.size.unwrap_or(manner.readable);
    let stages =
        [(wish.room, wish.size.unwrap_or(manner.largest), readable), (wish.most, readable, smallest)];
    for (room, largest, smallest) in &stages {
        let mut size = *largest;
        loop {
            if setter.may_fit(size, *room)
                && let Some(setting) = at(&setter, size, *room)
            {
                return setting;
            }
            if size <= *smallest {
                break;
            }
            size = (size * STEP).max(*smallest);
        }
    }
    let wider = Wish { width: None, ..*wish };
    let last = Setter { wish: &wider, ..setter };
    at(&last, smallest, wish.page).or_else(|| last.at(smallest, wish.page, true)).unwrap_or(Setting {
        size: smallest,
        pitch: smallest,
        lines: Vec::new(),
        strong: Vec::new(),
        under: Vec::new(),
        readings: Vec::new(),
        flush: false,
        half: (smallest, smallest),
        cut: true,
    })
}

/// Sets left-aligned lines at the requested size, or a little smaller to fit. If they still do not
/// fit, the end is cut off.
fn plain(setter: &Setter) -> Setting {
    let (room, wished) = (setter.wish.room, setter.wish.size.unwrap_or(setter.manner.largest));
    let whole = [1.0, STEP, STEP * STEP].into_iter().find_map(|by| setter.at(wished * by, room, false));
    let set = whole.or_else(|| setter.at(wished * STEP * STEP, room, true));
    let half = (room.0 / 2.0, room.1 / 2.0);
    let empty = Setting {
        size: wished,
        pitch: wished * PITCH,
        lines: Vec::new(),
        strong: Vec::new(),
        under: Vec::new(),
        readings: Vec::new(),
        flush: false,
        half,
        cut: true,
    };
    Setting { half, ..set.unwrap_or(empty) }
}

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
    fn apart(&self) -> Vec<f64> {
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
    fn may_fit(&self, size: f64, room: (f64, f64)) -> bool {
        let area = room.0.max(self.wish.width.unwrap_or(0.0)) * room.1;
        // Only the narrowest glyphs are less than a fifth of an em wide.
        self.text.len() < 200 || self.text.len() as f64 * 0.1 * size * size < area
    }

    /// Returns the characters of a line, and which of them are emphasised.
    pub(super) fn line(&self, part: std::ops::Range<usize>) -> (Vec<char>, Vec<bool>) {
        self.text[part].iter().map(|mark| (mark.letter, mark.strong)).unzip()
    }

    /// Sets the text at a size, if it fits into `room`. `cut` truncates it instead.
    fn at(&self, size: f64, room: (f64, f64), cut: bool) -> Option<Setting> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::words::model::Shape;

    fn wish(kind: Kind) -> Wish {
        let room = (0.42, 0.3);
        Wish {
            kind,
            vertical: false,
            plain: false,
            screens: false,
            width: None,
            size: None,
            room,
            most: room,
            page: (0.94, 1.3),
        }
    }

    fn setting(text: &str, wish: &Wish) -> Setting {
        let letters = Letters::bundled().unwrap();
        let font = letters.font("comic-neue-bold").unwrap();
        let marks: Vec<Mark> = letters.cleaned(text).into_iter().map(Mark::plain).collect();
        set(&letters, font, (&marks, &[]), wish)
    }

    fn text_of(setting: &Setting) -> Vec<String> {
        setting.lines.iter().map(|(run, _)| run.iter().collect()).collect()
    }

    const SPEECH: &str = "I never thought that we would see the lighthouse again, not after such a night.";

    #[test]
    fn a_balloon_is_widest_in_its_middle_and_holds_its_lines() {
        for text in ["Hi", "Where are we?", SPEECH, "Supercalifragilisticexpialidocious"] {
            for width in [None, Some(0.2), Some(0.35)] {
                let set = setting(text, &Wish { width, ..wish(Kind::Balloon(Shape::Oval)) });
                assert!(!set.cut);
                let joined: String = text_of(&set).join(" ");
                assert_eq!(joined.replace(' ', ""), text.replace(' ', ""));
                let (a, b) = set.half;
                assert!(width.is_none_or(|width| (2.0 * a - width).abs() < 1e-9));
                let middle = (set.lines.len() - 1) as f64 / 2.0;
                for (i, (_, width)) in set.lines.iter().enumerate() {
                    let edge = (i as f64 - middle).abs() * set.pitch + 0.34 * set.size;
                    let room = a * (1.0 - (edge / b).powf(FULLNESS)).powf(1.0 / FULLNESS);
                    assert!(width / 2.0 < room, "{text}, line {i}");
                }
            }
        }
    }

    #[test]
    fn lines_are_balanced() {
        let set = setting(SPEECH, &wish(Kind::Caption));
        let widths: Vec<f64> = set.lines.iter().map(|line| line.1).collect();
        let longest = widths.iter().copied().fold(0.0, f64::max);
        assert!(widths.len() > 1 && widths.iter().all(|width| *width > 0.6 * longest), "{widths:?}");
    }

    #[test]
    fn more_text_is_smaller_and_far_too_much_is_cut() {
        let kind = Kind::Balloon(Shape::Oval);
        let sizes: Vec<f64> = [1, 4, 8].map(|n| setting(&SPEECH.repeat(n), &wish(kind)).size).into();
        assert!(sizes.windows(2).all(|pair| pair[1] <= pair[0]) && sizes[2] < sizes[0], "{sizes:?}");
        let endless = setting(&"word ".repeat(800), &Wish { page: (0.3, 0.25), ..wish(kind) });
        assert!(endless.cut && text_of(&endless).last().unwrap().ends_with('…'));
        assert!(2.0 * endless.half.0 <= 0.3 && 2.0 * endless.half.1 <= 0.25);
    }

    #[test]
    fn line_ends_stay_and_odd_text_is_set() {
        assert_eq!(text_of(&setting("one\ntwo three\n", &wish(Kind::Caption))), ["one", "two three"]);
        for text in ["", " ", "\n\n", "\u{200d}", "😀", &"x".repeat(4_000), "שלום עולם", "\u{301}\u{301}"]
        {
            for kind in [Kind::Caption, Kind::Balloon(Shape::Shout), Kind::Effect] {
                for size in [None, Some(0.004), Some(0.5)] {
                    let set = setting(text, &Wish { size, ..wish(kind) });
                    assert!(set.half.0 > 0.0 && set.half.0.is_finite() && set.half.1.is_finite());
                }
            }
        }
    }

    #[test]
    fn an_effect_is_as_large_as_its_width_lets_it_be() {
        let size = |width| setting("KRAKOOM!", &Wish { width, ..wish(Kind::Effect) }).size;
        assert!(size(Some(0.4)) > 1.5 * size(Some(0.2)));
        assert_eq!(text_of(&setting("BAM BAM", &wish(Kind::Effect))), ["BAM BAM"]);
    }
}
