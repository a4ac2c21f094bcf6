//! The glyph table: outlines, advances and kerning of the fonts, as `crates/engine/pack.rs` writes them.

use super::bidi::{self, Seen};
use super::contour::Contour;
use super::learning::{self, Drawing, Learnt};
use crate::error::{Error, Result};
use crate::layout::Point;

/// Private character of a capital I without crossbars, which only some fonts have.
pub const STEM: char = '\u{f8f0}';

/// The character for text output, such as search, copy and screen readers.
#[must_use]
pub fn spoken(letter: char) -> char {
    if letter == STEM { 'I' } else { letter }
}

/// The fonts of the page, and the combinations of characters and accents.
#[derive(Default)]
pub struct Letters {
    /// The composed character, its base and its mark, in ascending order of the first.
    compositions: Vec<[u32; 3]>,
    fonts: Vec<Font>,
    /// Traced glyphs.
    learnt: Vec<Learnt>,
}

/// One font. Lengths are in ems, y up.
pub struct Font {
    pub(super) id: String,
    /// Font units per em. All lengths are integers in these units.
    pub(super) units: u16,
    /// Ascent of the highest glyphs over the baseline.
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

impl Letters {
    /// Reads a table.
    ///
    /// # Errors
    /// `damaged` if the table is not complete and valid.
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        Reader { bytes }.letters().ok_or_else(|| Error::damaged("letters", "the table is truncated"))
    }

    /// The table of the bundled fonts.
    ///
    /// # Errors
    /// Only if the build is broken.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn bundled() -> Result<Self> {
        Self::parse(include_bytes!(concat!(env!("OUT_DIR"), "/letters.bin")))
    }

    /// Returns a font by id, or the first font if the id is unknown.
    #[must_use]
    pub fn font(&self, id: &str) -> Option<&Font> {
        self.fonts.iter().find(|font| font.id == id).or_else(|| self.fonts.first())
    }

    /// The font for emphasis: the bold font of the family, or the same font.
    #[must_use]
    pub fn strong<'a>(&'a self, font: &'a Font) -> &'a Font {
        self.fonts.iter().find(|bold| bold.id.strip_suffix("-bold") == Some(&font.id)).unwrap_or(font)
    }

    /// Normalises text for the fonts: composes marks with their base, removes controls and characters without
    /// width, converts line ends to `\n`.
    #[must_use]
    pub fn cleaned(&self, text: &str) -> Vec<char> {
        self.directed(text).into_iter().filter(|&letter| !bidi::is_director(letter)).collect()
    }

    /// Normalises text like [`Letters::cleaned`], but retains the characters that direct the order of others.
    pub(super) fn directed(&self, text: &str) -> Vec<char> {
        let mut out: Vec<char> = Vec::new();
        let mut rest = text;
        while let Some(letter) = rest.chars().next() {
            if let Some((number, run)) = self.begun(rest) {
                out.extend(learning::letter(number));
                rest = &rest[run.len()..];
                continue;
            }
            rest = &rest[letter.len_utf8()..];
            match letter {
                '\n' | '\u{2028}' | '\u{2029}' => out.push('\n'),
                '\t' | '\u{2000}'..='\u{200a}' => out.push(' '),
                '\u{300}'..='\u{36f}' => {
                    let composed = out.last().and_then(|&base| self.composed(base, letter));
                    if let (Some(last), Some(composed)) = (out.last_mut(), composed) {
                        *last = composed;
                    }
                }
                _ if bidi::is_director(letter) => out.push(letter),
                '\u{200b}'..='\u{200d}'
                | '\u{2060}'..='\u{206f}'
                | '\u{fe00}'..='\u{fe0f}'
                | '\u{feff}'
                | '\u{ad}'
                | '\u{e0000}'..='\u{e0fff}' => {}
                _ if letter.is_control() => {}
                _ => out.push(learning::private(letter)),
            }
        }
        out
    }

    /// Adds a traced run of text as one glyph of all fonts. `leftward` marks right-to-left text.
    ///
    /// Returns whether it is one now.
    pub fn learn(&mut self, run: &str, leftward: bool, drawing: Drawing) -> bool {
        let Some(contours) = drawing.contours() else { return false };
        self.learn_outline(run, leftward, drawing.advance / drawing.em, &contours)
    }

    /// Adds a glyph from its outline and its advance, in ems.
    pub(super) fn learn_outline(
        &mut self,
        run: &str,
        leftward: bool,
        advance: f64,
        contours: &[Contour],
    ) -> bool {
        let Some(letter) = learning::letter(self.learnt.len()).filter(|_| !run.is_empty()) else {
            return false;
        };
        if self.learnt.iter().any(|learnt| learnt.run == run) {
            return true;
        }
        self.add_glyph(letter, advance, contours);
        self.learnt.push(Learnt { run: run.to_owned(), leftward, stands_for: None });
        true
    }

    /// Adds the vertical form of a traced glyph: its outline from the left of a square, on the common
    /// baseline, and its advance in the column, in ems.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn learn_standing(&mut self, run: &str, length: f64, contours: &[Contour]) {
        let of = self.learnt.iter().position(|learnt| learnt.run == run && learnt.stands_for.is_none());
        let Some((of, letter)) = of.zip(learning::letter(self.learnt.len())) else { return };
        if self.learnt.iter().all(|learnt| learnt.stands_for != Some(of)) {
            self.add_glyph(letter, length, contours);
            self.learnt.push(Learnt { run: run.to_owned(), leftward: false, stands_for: Some(of) });
        }
    }

    /// Returns the vertical form of a character, if its font has one.
    pub(super) fn standing(&self, letter: char) -> Option<char> {
        let of = learning::number(letter)?;
        learning::letter(self.learnt.iter().position(|learnt| learnt.stands_for == Some(of))?)
    }

    /// Adds a glyph to all fonts.
    fn add_glyph(&mut self, letter: char, advance: f64, contours: &[Contour]) {
        for font in &mut self.fonts {
            let glyph = Glyph { letter: u32::from(letter), advance, contours: contours.to_vec() };
            let at = font.glyphs.partition_point(|other| other.letter < glyph.letter);
            font.glyphs.insert(at, glyph);
        }
    }

    /// The text of a placeholder character.
    #[must_use]
    pub fn learnt(&self, letter: char) -> Option<&str> {
        self.learnt.get(learning::number(letter)?).map(|learnt| learnt.run.as_str())
    }

    /// The text of a character.
    #[must_use]
    pub fn text_of(&self, letter: char) -> String {
        self.learnt(letter).map_or_else(|| spoken(letter).to_string(), str::to_owned)
    }

    /// Whether a text has traced glyphs.
    #[must_use]
    pub fn foreign(&self, text: &str) -> bool {
        self.cleaned(text)
            .into_iter()
            .any(|letter| learning::number(letter).is_some_and(|at| at < self.learnt.len()))
    }

    /// The longest run that was learnt and that a text begins with.
    fn begun(&self, text: &str) -> Option<(usize, &str)> {
        let of_texts = self.learnt.iter().enumerate().filter(|(_, learnt)| learnt.stands_for.is_none());
        let runs = of_texts.map(|(number, learnt)| (number, learnt.run.as_str()));
        runs.filter(|(_, run)| text.starts_with(run)).max_by_key(|(_, run)| run.len())
    }

    /// The lines of a text item from left to right, by UAX #9.
    pub(in crate::page) fn ordered(&self, lines: &[&[char]]) -> Vec<Vec<Seen>> {
        bidi::ordered(lines, |letter| {
            let Some(learnt) = self.known(letter) else { return letter };
            let strong = || learnt.run.chars().find(|&letter| bidi::is_leftward(letter));
            let first = || learnt.run.chars().next();
            learnt.leftward.then(strong).flatten().or_else(first).unwrap_or(letter)
        })
    }

    /// The text of a character from left to right, as PDF files have it.
    pub(in crate::page) fn seen_text_of(&self, letter: char) -> String {
        match self.known(letter) {
            Some(learnt) if learnt.leftward => bidi::seen(&learnt.run),
            _ => self.text_of(letter),
        }
    }

    /// Whether a character is read from right to left.
    pub(in crate::page) fn is_leftward(&self, letter: char) -> bool {
        self.text_of(letter).chars().any(bidi::is_leftward)
    }

    fn known(&self, letter: char) -> Option<&Learnt> {
        self.learnt.get(learning::number(letter)?)
    }

    /// Characters of a text that a font lacks, without duplicates. Each is drawn as a question mark in a
    /// ring.
    #[must_use]
    pub fn missing(&self, text: &str, font: &Font) -> Vec<char> {
        let mut missing: Vec<char> = Vec::new();
        for letter in self.cleaned(text) {
            let drawn = matches!(letter, '\n' | '\u{a0}' | '\u{202f}' | '\u{2011}') || font.has(letter);
            let letter = learning::private_again(letter);
            if !drawn && !missing.contains(&letter) {
                missing.push(letter);
            }
        }
        missing
    }

    fn composed(&self, base: char, mark: char) -> Option<char> {
        let wanted = [u32::from(base), u32::from(mark)];
        self.compositions.iter().find(|entry| entry[1..] == wanted).and_then(|entry| char::from_u32(entry[0]))
    }

    /// Returns the character without its accent.
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

    /// Width of a run of text in ems.
    #[must_use]
    pub fn width(&self, font: &Font, run: &[char]) -> f64 {
        (0..run.len()).map(|i| self.advance(font, run[i], run.get(i + 1).copied())).sum()
    }
}

impl Font {
    /// The glyph of a character, or the sign for missing glyphs.
    pub(super) fn glyph(&self, letter: char) -> Option<&Glyph> {
        let code = match letter {
            '\u{a0}' | '\u{202f}' => 32,
            '\u{2011}' => 0x2d,
            _ => u32::from(letter),
        };
        self.glyphs.get(self.glyphs.binary_search_by_key(&code, |glyph| glyph.letter).unwrap_or(0))
    }

    /// Whether the font has a character.
    #[must_use]
    pub fn has(&self, letter: char) -> bool {
        self.glyphs.binary_search_by_key(&u32::from(letter), |glyph| glyph.letter).is_ok()
    }

    /// Gives a font whose I has bars a second one without, of the stroke of its l at the height of capitals.
    fn add_stem(&mut self) {
        let reach = |letter: char| {
            let glyph = self.glyph(letter)?;
            let points: Vec<Point> =
                glyph.contours.iter().flat_map(|contour| contour.flattened(0.01)).collect();
            let low = points.iter().fold(f64::MAX, |low, point| low.min(point.x));
            let high = points.iter().fold(f64::MIN, |high, point| high.max(point.x));
            let top = points.iter().fold(0.0, |top: f64, point| top.max(point.y));
            Some((high - low, top))
        };
        let (Some((barred, height)), Some((stroke, tall))) = (reach('I'), reach('l')) else { return };
        if barred < 2.0 * stroke || tall <= 0.0 {
            return;
        }
        let Some(l) = self.glyph('l') else { return };
        // Heights are in whole units, because fonts in PDF files require it.
        let em = f64::from(self.units);
        let lower = |point: Point| Point::new(point.x, (point.y * height / tall * em).round() / em);
        let contour = |contour: &Contour| Contour {
            start: lower(contour.start),
            segments: contour
                .segments
                .iter()
                .map(|&(control, end)| (control.map(lower), lower(end)))
                .collect(),
        };
        let stem = Glyph {
            letter: u32::from(STEM),
            advance: l.advance,
            contours: l.contours.iter().map(contour).collect(),
        };
        let at = self.glyphs.partition_point(|glyph| glyph.letter < stem.letter);
        self.glyphs.insert(at, stem);
    }

    /// Id of the font in the table.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Advance of a single character, in ems.
    #[must_use]
    pub fn step(&self, letter: char) -> f64 {
        if bidi::is_director(letter) {
            return 0.0;
        }
        self.glyph(letter).map_or(0.0, |glyph| glyph.advance)
    }

    /// The contours of a glyph in ems, y up. Curves become segments with an error of at most `within` ems.
    #[must_use]
    pub fn outline(&self, letter: char, within: f64) -> Vec<Vec<Point>> {
        let contours = self.glyph(letter).map_or(&[][..], |glyph| &glyph.contours);
        contours.iter().map(|contour| contour.flattened(within)).collect()
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
        font.add_stem();
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
            // Accents do not change the kerning.
            let accented = letters.advance(font, 'Á', Some('V')) - letters.advance(font, 'Á', None);
            assert!((accented - (together - apart)).abs() < 1e-9);
        }
    }

    #[test]
    fn european_languages_have_all_their_letters() {
        let letters = Letters::bundled().unwrap();
        let said = "Zażółć gęślą jaźń. Příliš žluťoučký kůň. Ķĺģ Ăâîșț Ħġ. Þór ð. Tiếng Việt: Người đã ổn, ưỡn Ẵ. \
            Ξεσκεπάζω την ψυχοφθόρα βδελυγμία; ΐΰ. Съешь ещё этих булок. Ґанок, її Єва, ўсё, Ђорђе, Љиљана, Ѓ Ќ.";
        for id in ["comic-neue", "comic-neue-bold", "bangers"] {
            let font = letters.font(id).unwrap();
            assert_eq!(letters.missing(said, font), [], "{id}");
            assert_eq!(letters.missing("a漢b漢😀", font), ['漢', '😀']);
            // Capitals of a fallback font are as high as capitals of the main font.
            let height = |letter| {
                let points = font.outline(letter, 0.01).into_iter().flatten();
                points.map(|point| point.y).fold(f64::MIN, f64::max)
            };
            // All contours have the same direction, so inner ones are not holes.
            let area = |letter| {
                let lines = font.outline(letter, 0.01).into_iter();
                let around = |line: Vec<Point>| {
                    let next = line.iter().cycle().skip(1);
                    line.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
                };
                lines.map(around).sum::<f64>()
            };
            for letter in "ACoСъешьещётихмягкбулоЖΞεσκπάζωψΠłńợổ".chars()
            {
                assert!(area(letter) < -0.05, "{id}: {letter} {}", area(letter));
            }
            for letter in ['Н', 'Π'] {
                assert!((height(letter) - font.capitals).abs() < 0.03, "{id}: {letter} {}", height(letter));
            }
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
        let directed = "a\u{61c}\u{200e}\u{202b}\u{2067}b";
        assert_eq!((letters.cleaned(directed), letters.directed(directed).len()), (vec!['a', 'b'], 6));
        let font = letters.font("comic-neue").unwrap();
        let width = |text: &str| letters.width(font, &letters.directed(text));
        assert!((width("x\u{200f}.") - width("x.")).abs() < 0.1 && font.step('\u{200f}').abs() < 1e-9);
        assert!(letters.missing(directed, font).is_empty());
    }

    #[test]
    fn letters_for_private_use_are_none_that_were_learnt() {
        let mut letters = Letters::bundled().unwrap();
        let dot = Contour { start: Point::new(0.0, 0.0), segments: vec![(None, Point::new(0.0, 1.0))] };
        assert!(letters.learn_outline("漢", false, 1.0, &[dot]));
        let learnt = letters.cleaned("漢")[0];
        let font = letters.font("comic-neue").unwrap();
        let typed = letters.cleaned(&learnt.to_string());
        assert_ne!(typed, [learnt]);
        assert_eq!(letters.missing(&format!("a{learnt}"), font), [learnt]);
        assert_eq!((letters.learnt(learnt), letters.text_of('a').as_str()), (Some("漢"), "a"));
    }

    #[test]
    fn what_is_missing_is_a_question_mark_in_a_ring() {
        let letters = Letters::bundled().unwrap();
        for id in ["comic-neue", "comic-neue-bold", "bangers"] {
            let font = letters.font(id).unwrap();
            assert_eq!(font.outline('😀', 0.01), font.outline('א', 0.01));
            assert_eq!(font.outline('😀', 0.01).len(), 2 + font.outline('?', 0.01).len());
        }
        let font = letters.font("bangers").unwrap();
        assert!(font.outline(' ', 0.01).is_empty());
    }

    #[test]
    fn a_table_that_is_cut_short_is_an_error() {
        let whole: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/letters.bin"));
        for length in (0..whole.len()).step_by(997).chain([whole.len() - 1]) {
            assert_eq!(Letters::parse(&whole[..length]).err().unwrap().code(), "damaged", "{length}");
        }
    }

    #[test]
    fn words_from_right_to_left_have_their_places_and_their_text_in_files() {
        let mut letters = Letters::bundled().unwrap();
        let contour = Contour { start: Point::new(0.0, 0.0), segments: vec![(None, Point::new(1.0, 1.0))] };
        for run in ["שלום", "עולם"] {
            assert!(letters.learn_outline(run, true, 1.0, std::slice::from_ref(&contour)));
        }
        let line = letters.cleaned("שלום (עולם)! 12");
        let seen = letters.ordered(&[&line]);
        let text: String = seen[0].iter().map(|seen| letters.seen_text_of(seen.letter)).collect();
        assert_eq!(text, "12 !(םלוע) םולש");
        assert!(letters.is_leftward(line[0]) && !letters.is_leftward('1'));
        assert_eq!(letters.text_of(line[0]), "שלום");
    }
}
