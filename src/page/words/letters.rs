//! The table of letters: outlines, advances and kerning of the fonts, as `fonts/pack.rs` writes them.

use crate::error::{Error, Result};
use crate::layout::Point;

/// The fonts of the page, and which accents their letters take.
#[derive(Default)]
pub struct Letters {
    /// The composed character, its base and its mark, in ascending order of the first.
    compositions: Vec<[u32; 3]>,
    fonts: Vec<Font>,
}

/// One font. Lengths are in ems, y up.
pub struct Font {
    pub(super) id: String,
    /// Units of the font an em: what all its lengths are whole numbers of.
    pub(super) units: u16,
    /// Ascent of the highest letters over the baseline.
    pub ascent: f64,
    /// Descent of the lowest, positive.
    pub descent: f64,
    /// Height of the capitals.
    pub capitals: f64,
    glyphs: Vec<Glyph>,
    /// `left << 16 | right` and the change of the advance, in ascending order.
    kerning: Vec<(u32, f64)>,
}

pub(super) struct Glyph {
    letter: u32,
    pub(super) advance: f64,
    pub(super) contours: Vec<Contour>,
}

/// A closed line: where it starts, and its segments with the control point where they are curves.
pub(super) struct Contour {
    pub(super) start: Point,
    pub(super) segments: Vec<(Option<Point>, Point)>,
}

impl Letters {
    /// Reads a table.
    ///
    /// # Errors
    /// `damaged` for anything but a whole table.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        Reader { bytes }.letters().ok_or_else(|| Error::damaged("letters", "the table is not whole"))
    }

    /// The table of the fonts that come with the program.
    ///
    /// # Errors
    /// None but a broken build.
    #[cfg(any(not(target_arch = "wasm32"), feature = "words"))]
    pub fn bundled() -> Result<Self> {
        Self::parse(include_bytes!(concat!(env!("OUT_DIR"), "/letters.bin")))
    }

    /// A font by its id; the first where there is none of it.
    #[must_use]
    pub fn font(&self, id: &str) -> Option<&Font> {
        self.fonts.iter().find(|font| font.id == id).or_else(|| self.fonts.first())
    }

    /// Text as the fonts take it: marks joined with their letters, controls and what has no width left out, line ends
    /// as `\n`.
    #[must_use]
    pub fn cleaned(&self, text: &str) -> Vec<char> {
        let mut out: Vec<char> = Vec::new();
        for letter in text.chars() {
            match letter {
                '\n' | '\u{2028}' | '\u{2029}' => out.push('\n'),
                '\t' | '\u{2000}'..='\u{200a}' => out.push(' '),
                '\u{300}'..='\u{36f}' => {
                    let composed = out.last().and_then(|&base| self.composed(base, letter));
                    if let (Some(last), Some(composed)) = (out.last_mut(), composed) {
                        *last = composed;
                    }
                }
                '\u{200b}'..='\u{200f}'
                | '\u{202a}'..='\u{202e}'
                | '\u{2060}'..='\u{206f}'
                | '\u{fe00}'..='\u{fe0f}'
                | '\u{feff}'
                | '\u{ad}'
                | '\u{e0000}'..='\u{e0fff}' => {}
                _ if letter.is_control() => {}
                _ => out.push(letter),
            }
        }
        out
    }

    fn composed(&self, base: char, mark: char) -> Option<char> {
        let wanted = [u32::from(base), u32::from(mark)];
        self.compositions.iter().find(|entry| entry[1..] == wanted).and_then(|entry| char::from_u32(entry[0]))
    }

    /// The letter without its accent.
    fn base(&self, letter: char) -> u32 {
        let code = u32::from(letter);
        self.compositions
            .binary_search_by_key(&code, |entry| entry[0])
            .map_or(code, |at| self.compositions[at][1])
    }

    /// How far the pen moves from `left` to `right`, in ems.
    #[must_use]
    pub fn advance(&self, font: &Font, left: char, right: Option<char>) -> f64 {
        let kern = right.map_or(0.0, |right| {
            let pair = self.base(left) << 16 | (self.base(right) & 0xffff);
            font.kerning.binary_search_by_key(&pair, |entry| entry.0).map_or(0.0, |at| font.kerning[at].1)
        });
        font.step(left) + kern
    }

    /// Width of a run of letters in ems.
    #[must_use]
    pub fn width(&self, font: &Font, run: &[char]) -> f64 {
        (0..run.len()).map(|i| self.advance(font, run[i], run.get(i + 1).copied())).sum()
    }
}

impl Font {
    /// The glyph of a letter, or the box for what is missing.
    pub(super) fn glyph(&self, letter: char) -> Option<&Glyph> {
        let code = match letter {
            '\u{a0}' | '\u{202f}' => 32,
            '\u{2011}' => 0x2d,
            _ => u32::from(letter),
        };
        self.glyphs.get(self.glyphs.binary_search_by_key(&code, |glyph| glyph.letter).unwrap_or(0))
    }

    /// Its name among those of the table.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// How far the pen moves over a letter that stands alone, in ems.
    #[must_use]
    pub fn step(&self, letter: char) -> f64 {
        self.glyph(letter).map_or(0.0, |glyph| glyph.advance)
    }

    /// The contours of a letter in ems, y up, curves cut into segments that are off by `within` ems at most.
    #[must_use]
    pub fn outline(&self, letter: char, within: f64) -> Vec<Vec<Point>> {
        let contours = self.glyph(letter).map_or(&[][..], |glyph| &glyph.contours);
        contours.iter().map(|contour| contour.flattened(within)).collect()
    }
}

impl Contour {
    fn flattened(&self, within: f64) -> Vec<Point> {
        let mut points = vec![self.start];
        let mut from = self.start;
        for &(control, end) in &self.segments {
            let Some(control) = control else {
                points.push(end);
                from = end;
                continue;
            };
            // A quadratic curve is off its chords by an eighth of its second difference over their number squared.
            let bend = (from.x - 2.0 * control.x + end.x).hypot(from.y - 2.0 * control.y + end.y);
            let steps = (bend / (4.0 * within)).sqrt().ceil().clamp(1.0, 32.0);
            for i in 1..=steps as usize {
                let t = i as f64 / steps;
                let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
                points.push(Point::new(
                    a * from.x + b * control.x + c * end.x,
                    a * from.y + b * control.y + c * end.y,
                ));
            }
            from = end;
        }
        points
    }
}

/// Reads numbers off the front; `None` at the end.
struct Reader<'b> {
    bytes: &'b [u8],
}

impl Reader<'_> {
    fn take(&mut self, count: usize) -> Option<&[u8]> {
        let (front, rest) = self.bytes.split_at_checked(count)?;
        self.bytes = rest;
        Some(front)
    }

    fn unsigned(&mut self) -> Option<u32> {
        let mut value = 0;
        for shift in [0, 7, 14, 21, 28] {
            let byte = u32::from(*self.take(1)?.first()?);
            value |= (byte & 0x7f) << shift;
            if byte < 0x80 {
                return Some(value);
            }
        }
        None
    }

    fn signed(&mut self) -> Option<i32> {
        self.unsigned().map(|value| (value >> 1) as i32 ^ -((value & 1) as i32))
    }

    /// A number of things of at least one byte each.
    fn count(&mut self) -> Option<usize> {
        self.unsigned().map(|count| count as usize).filter(|count| *count <= self.bytes.len())
    }

    fn letters(mut self) -> Option<Letters> {
        if self.take(5)? != b"INKL\x01" {
            return None;
        }
        let mut letters = Letters::default();
        for _ in 0..self.count()? {
            letters.compositions.push([self.unsigned()?, self.unsigned()?, self.unsigned()?]);
        }
        for _ in 0..self.count()? {
            letters.fonts.push(self.font()?);
        }
        Some(letters)
    }

    fn font(&mut self) -> Option<Font> {
        let length = self.count()?;
        let id = String::from_utf8(self.take(length)?.to_vec()).ok()?;
        let units = u16::try_from(self.unsigned()?.max(1)).ok()?;
        let em = f64::from(units);
        let [ascent, descent, capitals] = [self.signed()?, self.signed()?, self.signed()?];
        let mut font = Font {
            id,
            units,
            ascent: f64::from(ascent) / em,
            descent: f64::from(descent) / em,
            capitals: f64::from(capitals) / em,
            glyphs: Vec::new(),
            kerning: Vec::new(),
        };
        let mut letter = 0u32;
        for _ in 0..self.count()? {
            letter = letter.checked_add(self.unsigned()?)?;
            let advance = f64::from(self.unsigned()?) / em;
            font.glyphs.push(Glyph { letter, advance, contours: self.contours(em)? });
        }
        let mut pair = 0u32;
        for _ in 0..self.count()? {
            pair = pair.checked_add(self.unsigned()?)?;
            font.kerning.push((pair, f64::from(self.signed()?) / em));
        }
        Some(font)
    }

    fn contours(&mut self, em: f64) -> Option<Vec<Contour>> {
        let mut pen = (0i32, 0i32);
        let mut contours = Vec::new();
        for _ in 0..self.count()? {
            let count = self.count()?;
            let start = self.step(&mut pen, em, None)?;
            let mut segments = Vec::new();
            for _ in 0..count {
                let x = self.signed()?;
                let first = self.step(&mut pen, em, Some(x >> 1))?;
                segments.push(if x & 1 == 1 {
                    (Some(first), self.step(&mut pen, em, None)?)
                } else {
                    (None, first)
                });
            }
            contours.push(Contour { start, segments });
        }
        Some(contours)
    }

    /// The next point, a step from the one before.
    fn step(&mut self, pen: &mut (i32, i32), em: f64, x: Option<i32>) -> Option<Point> {
        let x = x.map_or_else(|| self.signed(), Some)?;
        *pen = (pen.0.checked_add(x)?, pen.1.checked_add(self.signed()?)?);
        Some(Point::new(f64::from(pen.0) / em, f64::from(pen.1) / em))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fonts_have_their_letters_and_kern_them() {
        let letters = Letters::bundled().unwrap();
        for id in ["comic-neue", "comic-neue-bold", "bangers"] {
            let font = letters.font(id).unwrap();
            assert_eq!(font.id, id);
            for letter in ('!'..='~').chain("äéñßŁőŽş¿¡—“”’…€".chars()) {
                assert_ne!(font.glyph(letter).unwrap().letter, 0, "{id} lacks {letter}");
            }
            assert!((0.5..1.0).contains(&font.capitals), "{id} {}", font.capitals);
            let apart = letters.width(font, &['A']) + letters.width(font, &['V']);
            let together = letters.width(font, &['A', 'V']);
            assert!(together < apart - 0.01, "{id}: {together} {apart}");
            // Accents do not change how close letters stand.
            let accented = letters.advance(font, 'Á', Some('V')) - letters.advance(font, 'Á', None);
            assert!((accented - (together - apart)).abs() < 1e-9);
        }
    }

    #[test]
    fn marks_join_their_letters_and_what_has_no_width_goes() {
        let letters = Letters::bundled().unwrap();
        assert_eq!(
            letters.cleaned("e\u{301}a\u{308}\tx\u{200d}\u{fe0f}\r\n\u{7}n"),
            "éä x\nn".chars().collect::<Vec<_>>()
        );
        assert_eq!(letters.cleaned("\u{301}x\u{36f}"), ['x']);
    }

    #[test]
    fn what_is_missing_is_a_box() {
        let letters = Letters::bundled().unwrap();
        let font = letters.font("bangers").unwrap();
        assert_eq!(font.outline('😀', 0.01), font.outline('א', 0.01));
        assert_eq!(font.outline('😀', 0.01).len(), 2);
        assert!(font.outline(' ', 0.01).is_empty());
    }

    #[test]
    fn a_table_that_is_cut_short_is_an_error() {
        let whole: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/letters.bin"));
        for length in (0..whole.len()).step_by(997).chain([whole.len() - 1]) {
            assert_eq!(Letters::parse(&whole[..length]).err().unwrap().code(), "damaged", "{length}");
        }
    }
}
