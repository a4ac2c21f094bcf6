//! Lens-shaped line breaking: lines are long in the middle and short at the ends, so that a round balloon
//! fits closely. Hourglass shapes are avoided, and hyphens are a last resort.
//!
//! For each number of lines the best breaks are found for all lines together, like `TeX` does for paragraphs
//! (Knuth and Plass, "Breaking Paragraphs into Lines", 1981). The target lengths follow the lens. The
//! smallest shape with enough distance from the corners of the lines is used.

use super::setting::{FULLNESS, Setter, Setting};
use super::wording::Part;

/// Maximum number of pieces for optimal breaks. Longer texts are filled line by line.
const MOST_PIECES: usize = 220;
/// Most lines.
const MOST_LINES: usize = 24;
/// Cost of a hyphen: like a line that is two fifths off its length.
const HYPHEN: f64 = 1.6;
/// Cost of breaking a word at a forbidden position.
const TORN: f64 = 12.0;
/// Cost of a line that is longer than the line before, after lines have become shorter.
const HOURGLASS: f64 = 9.0;
/// Invisible differences of lengths, as a share of the longest line.
const UNSEEN: f64 = 0.04;

/// A text in pieces that lines are made of.
pub(super) struct Lens<'a> {
    setter: Setter<'a>,
    pieces: Vec<Piece>,
    /// Width of a hyphen.
    hyphen: f64,
    /// Width of all pieces in one line.
    total: f64,
}

/// Characters that stay together; lengths in ems.
struct Piece {
    start: usize,
    end: usize,
    width: f64,
    /// Room before it when it is not the first of its line.
    gap: f64,
    /// It begins a line.
    fresh: bool,
    /// How the word is divided after it, if the text continues without a space.
    after: After,
}

#[derive(Clone, Copy, PartialEq)]
enum After {
    Space,
    Hyphen,
    Dash,
    Torn,
}

/// Line breaks and their cost.
struct Broken {
    cost: f64,
    /// The first piece and the one after the last of each line.
    lines: Vec<(usize, usize)>,
    widths: Vec<f64>,
}

impl<'a> Lens<'a> {
    pub(super) fn new(setter: &Setter<'a>) -> Self {
        let setter = *setter;
        let hyphen = setter.letters.advance(setter.font, '-', None);
        let mut lens = Self { setter, pieces: Vec::new(), hyphen, total: 0.0 };
        let text = setter.text;
        let mut at = 0;
        let mut fresh = false;
        while at < text.len() && lens.is_short() {
            if text[at].letter.is_whitespace() && text[at].letter != '\u{a0}' {
                fresh |= text[at].letter == '\n' && !lens.pieces.is_empty();
                at += 1;
                continue;
            }
            let ends = |mark: &super::wording::Mark| mark.letter.is_whitespace() && mark.letter != '\u{a0}';
            let end = at + text[at..].iter().position(ends).unwrap_or(text.len() - at);
            lens.add_word(at, end, fresh);
            fresh = false;
            at = end;
        }
        lens.total = lens.pieces.iter().skip(1).map(|piece| piece.gap).sum::<f64>()
            + lens.pieces.iter().map(|piece| piece.width).sum::<f64>();
        lens
    }

    /// Returns whether the text is short enough for line breaking in a lens shape.
    pub(super) fn is_short(&self) -> bool {
        self.pieces.len() <= MOST_PIECES
    }

    /// Adds the pieces of one word.
    fn add_word(&mut self, start: usize, end: usize, fresh: bool) {
        let text = self.setter.text;
        let space = self.setter.space();
        // Longer words are not readable text and are broken at the line end.
        let longest = 24;
        let mut from = start;
        for at in start + 1..=end {
            let after = if at == end {
                After::Space
            } else {
                match text.get(at).map_or(Part::No, |mark| mark.part) {
                    Part::Hyphen => After::Hyphen,
                    Part::Free => After::Dash,
                    Part::No if at - from >= longest => After::Torn,
                    Part::No => continue,
                }
            };
            let (gap, fresh) = if from == start { (space, fresh) } else { (0.0, false) };
            let width = self.setter.width(from..at);
            self.pieces.push(Piece { start: from, end: at, width, gap, fresh, after });
            from = at;
        }
    }

    /// Sets the text at a size, if it fits into `room`. `width` is the width of the shape that the user set.
    pub(super) fn at(&self, size: f64, room: (f64, f64), width: Option<f64>) -> Option<Setting> {
        let manner = self.setter.manner;
        let (wide, high) = (width.unwrap_or(room.0) / size / 2.0, room.1 / size / 2.0);
        let (pad_x, pad_y) = manner.pad;
        let widest = 2.0 * (wide - pad_x);
        let most = self.pieces.len().clamp(1, MOST_LINES);
        let mut best: Option<(f64, Broken, (f64, f64))> = None;
        for count in 1..=most {
            let block = f64::midpoint((count - 1) as f64 * self.setter.pitch(), self.setter.thickness());
            if block + pad_y > high {
                break;
            }
            let Some(broken) = self.broken(count, widest, width.is_some()) else { continue };
            let shape = if manner.round {
                self.around(&broken.widths, width.map(|_| wide), (wide, high))
            } else {
                let longest = broken.widths.iter().copied().fold(0.0, f64::max);
                Some((width.map_or(longest / 2.0 + pad_x, |_| wide), block + pad_y))
            };
            let Some((a, b)) = shape.filter(|(a, b)| *a <= wide + 1e-9 && *b <= high + 1e-9) else {
                continue;
            };
            let off = (a / b / manner.aspect).ln();
            // The smallest shape around the lines fits closest. With a set width, the lowest one is
            // best.
            let waste = (4.0 * a * b / (self.total + 1.0) / self.setter.pitch()).max(0.1).ln();
            let cost =
                broken.cost + if width.is_some() { 4.0 * waste } else { 2.0 * off * off + 1.5 * waste };
            if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                best = Some((cost, broken, (a, b)));
            }
        }
        let (_, broken, (a, b)) = best?;
        Some(self.setting(&broken, size, (a, b)))
    }

    fn setting(&self, broken: &Broken, size: f64, (a, b): (f64, f64)) -> Setting {
        let mut strong = Vec::new();
        let mut lines = Vec::new();
        let mut under = Vec::new();
        for (&(first, end), width) in broken.lines.iter().zip(&broken.widths) {
            let part = self.pieces[first].start..self.pieces[end - 1].end;
            under.push(self.setter.under(part.clone()));
            let (mut run, mut marks) = self.setter.line(part);
            if self.pieces[end - 1].after == After::Hyphen {
                run.push('-');
                marks.push(false);
            }
            lines.push((run, width * size));
            strong.push(marks);
        }
        let (pitch, flush) = (self.setter.pitch() * size, self.setter.wish.vertical);
        let readings = self.setter.readings.to_vec();
        Setting { size, pitch, lines, strong, under, readings, flush, half: (a * size, b * size), cut: false }
    }

    /// Whether lines are longest in the middle. Columns begin at the same height, whatever is around them.
    fn is_lens(&self) -> bool {
        self.setter.manner.round && !self.setter.wish.vertical
    }

    /// How long each of `count` lines should be, as a part of the longest.
    fn profile(&self, count: usize) -> Vec<f64> {
        let middle = (count as f64 - 1.0) / 2.0;
        let reach = count as f64 / 2.0 + 0.35;
        let part = |i: usize| {
            let off = (i as f64 - middle) / reach;
            if self.is_lens() { (1.0 - off * off).sqrt() } else { 1.0 }
        };
        (0..count).map(part).collect()
    }

    /// The best breaks into `count` lines, at most `widest` wide. `None` if there are no such breaks. With a
    /// set width, lines are as long as the width allows.
    fn broken(&self, count: usize, widest: f64, chosen: bool) -> Option<Broken> {
        if self.pieces.is_empty() {
            return (count == 1).then(|| Broken { cost: 0.0, lines: Vec::new(), widths: Vec::new() });
        }
        let profile = self.profile(count);
        let usual = self.total / profile.iter().sum::<f64>();
        let scale = if chosen { usual.max(0.8 * widest) } else { usual };
        let mut rows: Vec<Vec<State>> =
            vec![vec![State { start: 0, end: 0, width: 0.0, cost: 0.0, fell: false, from: 0 }]];
        for (line, part) in profile.iter().enumerate() {
            let goal = Goal { length: scale * part, scale, widest, last: line + 1 == count };
            let row = self.next_row(&rows[line], &goal, count - line - 1);
            if row.is_empty() {
                return None;
            }
            rows.push(row);
        }
        let (mut at, state) =
            rows.last()?.iter().enumerate().min_by(|(_, a), (_, b)| a.cost.total_cmp(&b.cost))?;
        let mut broken = Broken { cost: state.cost, lines: Vec::new(), widths: Vec::new() };
        for row in rows[1..].iter().rev() {
            let state = &row[at];
            broken.lines.push((state.start, state.end));
            broken.widths.push(state.width);
            at = state.from;
        }
        broken.lines.reverse();
        broken.widths.reverse();
        Some(broken)
    }

    /// All possible next lines after a row of states. `left`: number of following lines.
    fn next_row(&self, before: &[State], goal: &Goal, left: usize) -> Vec<State> {
        let mut row: Vec<State> = Vec::new();
        let count = self.pieces.len();
        let mut at = 0;
        while at < before.len() {
            // States that end at the same piece have the same next lines. Only the length of their last line
            // differs.
            let start = before[at].end;
            let same = before[at..].iter().take_while(|state| state.end == start).count();
            let mut width = 0.0;
            for end in start + 1..=count.saturating_sub(left) {
                let piece = &self.pieces[end - 1];
                if piece.fresh && end - 1 > start {
                    break;
                }
                width += piece.width + if end - 1 > start { piece.gap } else { 0.0 };
                let hyphen = if piece.after == After::Hyphen { self.hyphen } else { 0.0 };
                let whole = width + hyphen;
                if whole > goal.widest + 1e-9 || (whole > 1.7 * goal.length && end - 1 > start) {
                    break;
                }
                if (goal.last && end < count) || (end == count && !goal.last) {
                    continue;
                }
                let own = self.line_cost(whole, goal, piece.after);
                for fell in [false, true] {
                    let from = before[at..at + same].iter().enumerate().filter_map(|(i, state)| {
                        let (cost, falls) = goal.follow(state, whole, self.is_lens());
                        (falls == fell).then_some((state.cost + cost + own, at + i))
                    });
                    if let Some((cost, from)) = from.min_by(|a, b| a.0.total_cmp(&b.0)) {
                        row.push(State { start, end, width: whole, cost, fell, from });
                    }
                }
            }
            at += same;
        }
        row.sort_by_key(|state| state.end);
        row
    }

    fn line_cost(&self, width: f64, goal: &Goal, after: After) -> f64 {
        let off = (width - goal.length) / goal.scale;
        let parted = match after {
            After::Space | After::Dash => 0.0,
            After::Hyphen => HYPHEN,
            After::Torn => TORN,
        };
        // The last line of a box may be short. Only a single lost word is a fault.
        let short = goal.last && !self.is_lens() && off < 0.0 && off > -0.6;
        parted + if short { 2.0 * off * off } else { 10.0 * off * off }
    }

    /// Returns the smallest superellipse with a minimum distance to lines of the given widths. `fixed` is
    /// half its width, if the user chose it.
    fn around(&self, widths: &[f64], fixed: Option<f64>, most: (f64, f64)) -> Option<(f64, f64)> {
        let (pad_x, pad_y) = self.setter.manner.pad;
        let middle = (widths.len() as f64 - 1.0) / 2.0;
        let longest = widths.iter().copied().fold(0.0, f64::max);
        let corner = |(i, width): (usize, &f64)| {
            let y = (i as f64 - middle).abs() * self.setter.pitch() + self.setter.thickness() / 2.0 + pad_y;
            // Each column begins where the longest does.
            (if self.is_lens() { *width } else { longest } / 2.0 + pad_x, y)
        };
        let mut corners: Vec<(f64, f64)> = widths.iter().enumerate().map(corner).collect();
        if corners.is_empty() {
            corners.push((pad_x, pad_y + self.setter.thickness() / 2.0));
        }
        let other = |own: f64, half: f64| (1.0 - (own / half).powf(FULLNESS)).powf(1.0 / FULLNESS);
        if let Some(a) = fixed {
            if corners.iter().any(|(x, _)| *x >= a) {
                return None;
            }
            return Some((a, corners.iter().map(|&(x, y)| y / other(x, a)).fold(0.0, f64::max)));
        }
        let lowest = corners.iter().map(|corner| corner.1).fold(0.0, f64::max);
        let shapes = (1..36).map(|i| lowest * (1.0 + 0.03 * f64::from(i))).map(|b| {
            let a = corners.iter().map(|&(x, y)| x / other(y, b)).fold(0.0, f64::max);
            // Speech balloons are never taller than wide, unless the user sets a width.
            (a.max(0.8 * b), b)
        });
        let cost = |(a, b): (f64, f64)| {
            let off = (a / b / self.setter.manner.aspect).ln();
            (a * b).ln() + 0.25 * off * off
        };
        let fits = shapes.filter(|(a, b)| *a <= most.0 && *b <= most.1);
        fits.min_by(|one, other| cost(*one).total_cmp(&cost(*other)))
    }
}

/// A line that ends at a piece, the best among lines with the same start, end and trend.
struct State {
    start: usize,
    end: usize,
    width: f64,
    cost: f64,
    /// A line was shorter than the one before it.
    fell: bool,
    /// The line before, in its row.
    from: usize,
}

/// Target of a line.
struct Goal {
    length: f64,
    /// The longest line should be as long.
    scale: f64,
    widest: f64,
    last: bool,
}

impl Goal {
    /// Cost of a line after another, and whether lines have become shorter.
    fn follow(&self, before: &State, width: f64, round: bool) -> (f64, bool) {
        let first = before.end == 0;
        let grown = (width - before.width) / self.scale;
        if first || !round {
            return (0.0, false);
        }
        if before.fell && grown > UNSEEN {
            return (HOURGLASS * (1.0 + grown), true);
        }
        (0.0, before.fell || grown < -UNSEEN)
    }
}

#[cfg(test)]
mod tests {
    use crate::page::words::Letters;
    use crate::page::words::fitting::set;
    use crate::page::words::model::{Kind, Shape, TextItem};
    use crate::page::words::setting::{FULLNESS, Setting, Wish};
    use crate::page::words::wording::marks;
    use serde_json::json;

    fn setting(text: &str, kind: Kind, width: Option<f64>) -> Setting {
        let letters = Letters::bundled().unwrap();
        let name = if kind == Kind::Caption { "caption" } else { "balloon" };
        let word = json!({ "kind": name, "text": text, "language": "en" });
        let word = TextItem::read(word).unwrap();
        let font = letters.font(word.font()).unwrap();
        let room = (0.3, 0.22);
        let vertical = false;
        let wish = Wish {
            kind,
            vertical,
            plain: false,
            screens: false,
            width,
            size: None,
            room,
            most: (0.44, 0.4),
            page: (0.94, 1.3),
        };
        set(&letters, font, (&marks(&word, &letters, font), &[]), &wish)
    }

    fn text_of(setting: &Setting) -> Vec<String> {
        setting.lines.iter().map(|(run, _)| run.iter().collect()).collect()
    }

    const SPEECHES: [&str; 8] = [
        "I never thought that we would see the lighthouse again, not after such a night.",
        "Where are we?",
        "You said nobody would come here. You said it was safe!",
        "It is the oldest trick in the book, and we have fallen for it all the same, every one of us, like children.",
        "No.",
        "Wait — did you hear that?",
        "Take the boat. Row until you cannot see the harbour any more, then row as far again.",
        "Congratulations! Your extraordinary misunderstanding has consequences.",
    ];

    #[test]
    fn lines_are_a_lens_and_never_an_hourglass() {
        for text in SPEECHES {
            let set = setting(text, Kind::Balloon(Shape::Oval), None);
            let widths: Vec<f64> = set.lines.iter().map(|line| line.1).collect();
            let longest = widths.iter().copied().fold(0.0, f64::max);
            for line in 1..widths.len().saturating_sub(1) {
                let waist = widths[line - 1].min(widths[line + 1]) - widths[line];
                assert!(waist < 0.1 * longest, "{:?}", text_of(&set));
            }
            assert!(!set.cut && set.size >= 0.0134, "{text}: {}", set.size);
        }
    }

    #[test]
    fn a_balloon_keeps_about_a_letters_height_around_its_text() {
        for text in SPEECHES {
            for width in [None, Some(0.3)] {
                let set = setting(text, Kind::Balloon(Shape::Oval), width);
                let (a, b) = set.half;
                assert!(width.is_none_or(|width| (2.0 * a - width).abs() < 1e-9));
                let middle = (set.lines.len() as f64 - 1.0) / 2.0;
                for (i, (_, width)) in set.lines.iter().enumerate() {
                    let y = (i as f64 - middle).abs() * set.pitch + 0.35 * set.size;
                    let room = a * (1.0 - (y / b).powf(FULLNESS)).powf(1.0 / FULLNESS) - width / 2.0;
                    assert!(room > 0.45 * set.size, "{text}: {}", room / set.size);
                }
            }
        }
    }

    #[test]
    fn hyphens_are_rare_and_in_long_words() {
        for text in &SPEECHES[..7] {
            let set = setting(text, Kind::Balloon(Shape::Oval), None);
            assert!(text_of(&set).iter().all(|line| !line.ends_with('-')), "{:?}", text_of(&set));
        }
        let narrow = setting("International misinformation", Kind::Balloon(Shape::Oval), Some(0.115));
        let lines = text_of(&narrow);
        assert!(lines.iter().any(|line| line.ends_with('-') && line.chars().count() > 5), "{lines:?}");
    }

    #[test]
    fn emphasis_and_narration_are_set_too() {
        let set = setting("That is *not* what I said", Kind::Balloon(Shape::Oval), None);
        let strong: usize = set.strong.iter().flatten().filter(|strong| **strong).count();
        assert_eq!(strong, 3);
        let caption = setting(SPEECHES[3], Kind::Caption, None);
        let longest = caption.lines.iter().map(|line| line.1).fold(0.0, f64::max);
        assert!(2.0 * caption.half.0 > longest && caption.half.0 > caption.half.1);
    }
}
