//! Glyphs from the user's font files, for characters that the bundled fonts lack. The command line and Python
//! use them. The app uses system fonts instead (`www/engine/shaping.ts`).
//!
//! The first font with all characters of a text run shapes it. Text in joining or complex scripts is shaped
//! by word. Other text is shaped character by character. The outlines become glyphs like those traced from
//! images, so images and PDF files look the same. Glyphs of vertical text are shaped again with vertical
//! alternates (`vert`).
//!
//! No wasm module contains this code.

use super::TextItem;
use super::bidi;
use super::contour::Contour;
use super::learning::number;
use super::letters::Letters;
use super::vertical;
use crate::error::Result;
use crate::layout::Point;
use rustybuzz::ttf_parser::{GlyphId, OutlineBuilder, fonts_in_collection};
use rustybuzz::{Direction, Face, GlyphBuffer, UnicodeBuffer};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// Bytes of a font file: the largest of Chinese and Japanese have some 20 MB.
const MOST_BYTES: usize = 64 << 20;
/// Font files.
const MOST_FONTS: usize = 16;
/// Maximum number of corners in the outlines of a run.
const MOST_CORNERS: usize = 40_000;
/// Maximum number of characters in a word.
const LONGEST: usize = 60;
/// Bundled font with the widest coverage, used to decide whether a glyph is missing.
const OWN: &str = "comic-neue";

/// Blocks of scripts that are shaped by word. They include Hebrew to Myanmar, Tagalog to Mongolian, other South and Southeast Asian scripts, and presentation forms of Hebrew and Arabic.
const JOINED: [(u32, u32); 10] = [
    (0x0590, 0x109f),
    (0x1700, 0x18af),
    (0x1a00, 0x1cff),
    (0xa840, 0xa8ff),
    (0xa980, 0xaaff),
    (0xabc0, 0xabff),
    (0xfb1d, 0xfdff),
    (0xfe70, 0xfefe),
    (0x1_0800, 0x1_1fff),
    (0x1_e800, 0x1_efff),
];

/// The user's font files, in order of priority.
#[derive(Clone, Default)]
pub struct GivenFonts {
    files: Vec<Arc<[u8]>>,
}

impl GivenFonts {
    /// Adds a file: TrueType or OpenType, or the first font of a collection.
    ///
    /// # Errors
    /// A sentence, if the file is not a font, is damaged, has no outlines, or is too large.
    pub fn add(&mut self, file: Vec<u8>) -> std::result::Result<(), &'static str> {
        if self.files.len() == MOST_FONTS {
            return Err("there are more than 16 fonts");
        }
        if file.len() > MOST_BYTES {
            return Err("it is larger than 64 MB");
        }
        if fonts_in_collection(&file) == Some(0) {
            return Err("it is a collection without a font");
        }
        match guarded(|| face(&file).map(|face| face.tables().glyf.is_some() || face.tables().cff.is_some()))
        {
            Some(true) => {}
            Some(false) => {
                return Err("it has no outlines; use a font with outlines");
            }
            None => return Err("it is not a valid TrueType or OpenType font"),
        }
        self.files.push(file.into());
        Ok(())
    }

    /// Combines several sets. Each file is added once.
    #[must_use]
    pub fn joined<'f>(all: impl IntoIterator<Item = &'f Self>) -> Self {
        let mut files: Vec<Arc<[u8]>> = Vec::new();
        for file in all.into_iter().flat_map(|fonts| &fonts.files) {
            if !files.iter().any(|known| Arc::ptr_eq(known, file)) {
                files.push(Arc::clone(file));
            }
        }
        Self { files }
    }

    /// The glyphs for text items: bundled ones, and missing ones from the files.
    ///
    /// # Errors
    /// Only if the build is broken.
    pub fn letters<'w>(&self, words: impl IntoIterator<Item = &'w TextItem>) -> Result<Letters> {
        let mut letters = Letters::bundled()?;
        if self.files.is_empty() {
            return Ok(letters);
        }
        let mut faces: Vec<Option<Face<'_>>> = self.files.iter().map(|file| face(file)).collect();
        for word in words {
            for said in word.text.split_whitespace() {
                for stretch in stretches(&letters, said) {
                    learn(&mut letters, &mut faces, &stretch);
                }
                if word.vertical {
                    stand(&mut letters, &faces, said);
                }
            }
        }
        Ok(letters)
    }
}

/// Characters of text items that no font has, without duplicates, in display form.
#[must_use]
pub fn missing<'w>(letters: &Letters, words: impl IntoIterator<Item = &'w TextItem>) -> Vec<String> {
    let Some(font) = letters.font(OWN) else { return Vec::new() };
    let mut all: Vec<char> = Vec::new();
    for word in words {
        for letter in letters.missing(&word.text, font) {
            if !all.contains(&letter) {
                all.push(letter);
            }
        }
    }
    let private = |letter: char| matches!(u32::from(letter), 0xe000..=0xf8ff | 0xf_0000..=0x10_ffff);
    let named = |letter: char| {
        if private(letter) { format!("U+{:04X}", u32::from(letter)) } else { letter.to_string() }
    };
    all.into_iter().map(named).collect()
}

fn face(file: &[u8]) -> Option<Face<'_>> {
    Face::from_slice(file, 0)
}

/// Result of `work` on an untrusted file. `None` if the font reader panics.
fn guarded<T>(work: impl FnOnce() -> Option<T>) -> Option<T> {
    // Nothing reads the state that a panic may leave incomplete.
    catch_unwind(AssertUnwindSafe(work)).ok().flatten()
}

/// Returns the parts of a text that the fonts lack. In joining scripts, words are separate from digits, signs
/// and other text, because digits and signs have other positions on a line.
fn stretches(letters: &Letters, word: &str) -> Vec<String> {
    let Some(font) = letters.font(OWN) else { return Vec::new() };
    let mut out: Vec<((bool, bool), String)> = Vec::new();
    let mut open = false;
    for letter in word.chars() {
        // It has an effect of its own on the order.
        if bidi::is_director(letter) {
            open = false;
            continue;
        }
        // A character without width belongs to the character before it.
        let bound = letters.cleaned(letter.encode_utf8(&mut [0; 4])).is_empty();
        let lacks = !bound && !font.has(letter) || number(letter).is_some();
        if bound && open {
            if let Some((_, stretch)) = out.last_mut() {
                stretch.push(letter);
            }
            continue;
        }
        if !lacks {
            open = false;
            continue;
        }
        let joined = (is_joined(letter), bidi::is_of_words(letter));
        match out.last_mut() {
            Some((other, stretch)) if open && *other == joined && stretch.chars().count() < LONGEST => {
                stretch.push(letter);
            }
            _ => out.push((joined, letter.to_string())),
        }
        open = true;
    }
    out.into_iter().map(|(_, stretch)| stretch).collect()
}

fn is_joined(letter: char) -> bool {
    JOINED.iter().any(|(first, last)| (*first..=*last).contains(&u32::from(letter)))
}

/// Adds the glyphs of a run: as a whole for joining scripts, otherwise by character. A font with errors is
/// dropped.
fn learn(letters: &mut Letters, faces: &mut [Option<Face<'_>>], stretch: &str) {
    let mut left = vec![stretch.to_owned()];
    for slot in faces {
        let Some(face) = slot.as_ref() else { continue };
        let mut still = Vec::new();
        for text in std::mem::take(&mut left) {
            let Some(runs) = guarded(|| Some(shaped(face, &text))) else {
                *slot = None;
                still.push(text);
                break;
            };
            for (run, outline) in runs {
                let learnt = outline.is_some_and(|Outline { contours, advance, leftward, .. }| {
                    letters.learn_outline(run, leftward, advance, &contours)
                });
                if !learnt {
                    still.push(run.to_owned());
                }
            }
        }
        left = still;
    }
}

/// Adds the vertical forms of the characters of a word, each from the first font with a glyph.
fn stand(letters: &mut Letters, faces: &[Option<Face<'_>>], word: &str) {
    let mut buffer = [0; 4];
    for letter in word.chars().filter(|&letter| !letter.is_ascii() && !is_joined(letter)) {
        let run: &str = letter.encode_utf8(&mut buffer);
        let face = faces.iter().flatten().find(|face| face.glyph_index(letter).is_some());
        let form = face.and_then(|face| guarded(|| standing(face, run)));
        if let Some(Outline { contours, length, .. }) = form {
            letters.learn_standing(run, length, &contours);
        }
    }
}

/// Vertical alternate of a character in ems, from the left of its square and over the baseline. `None` if the
/// font has no separate form.
fn standing(face: &Face<'_>, run: &str) -> Option<Outline> {
    let shaped = |direction: Direction| {
        let mut buffer = UnicodeBuffer::new();
        buffer.push_str(run);
        buffer.guess_segment_properties();
        buffer.set_direction(direction);
        rustybuzz::shape(face, &[], buffer)
    };
    let (lying, upright) = (shaped(Direction::LeftToRight), shaped(Direction::TopToBottom));
    let ids = |glyphs: &GlyphBuffer| -> Vec<u32> {
        glyphs.glyph_infos().iter().map(|info| info.glyph_id).collect()
    };
    if ids(&lying) == ids(&upright) {
        return None;
    }
    let mut form = outline(face, &upright, 0..upright.len(), false)?;
    // The pen of a column starts in the middle of its top, and moves down.
    let moved = |point: Point| Point::new(point.x + 0.5, point.y + vertical::BASELINE);
    for contour in &mut form.contours {
        contour.start = moved(contour.start);
        for (control, end) in &mut contour.segments {
            (*control, *end) = (control.map(moved), moved(*end));
        }
    }
    (0.2..3.0).contains(&form.length).then_some(form)
}

/// The runs of a text, each with its outline where the font has all of it.
fn shaped<'t>(face: &Face<'_>, text: &'t str) -> Vec<(&'t str, Option<Outline>)> {
    let mut buffer = UnicodeBuffer::new();
    buffer.push_str(text);
    buffer.guess_segment_properties();
    // Digits of Arabic are read from left to right.
    let leftward = text.chars().any(bidi::is_leftward);
    if !leftward && buffer.direction() == Direction::RightToLeft {
        buffer.set_direction(Direction::LeftToRight);
    }
    let glyphs = rustybuzz::shape(face, &[], buffer);
    if text.chars().any(is_joined) {
        let all = 0..glyphs.len();
        return vec![(text, outline(face, &glyphs, all, leftward))];
    }
    let mut starts: Vec<usize> = glyphs.glyph_infos().iter().map(|info| info.cluster as usize).collect();
    starts.sort_unstable();
    starts.dedup();
    let run = |(i, &start): (usize, &usize)| {
        let end = starts.get(i + 1).copied().unwrap_or(text.len());
        let run = text.get(start..end)?;
        let infos = glyphs.glyph_infos();
        let first = infos.iter().position(|info| info.cluster as usize == start)?;
        let count = infos[first..].iter().take_while(|info| info.cluster as usize == start).count();
        Some((run, outline(face, &glyphs, first..first + count, leftward)))
    };
    starts.iter().enumerate().filter_map(run).collect()
}

/// Outline of some glyphs in ems. `None` if the font lacks one of them or nothing is visible.
fn outline(
    face: &Face<'_>,
    glyphs: &GlyphBuffer,
    which: std::ops::Range<usize>,
    leftward: bool,
) -> Option<Outline> {
    let em = f64::from(face.units_per_em()).max(1.0);
    let mut out = Outline {
        em,
        contours: Vec::new(),
        advance: 0.0,
        length: 0.0,
        pen: (0.0, 0.0),
        corners: 0,
        leftward,
    };
    for i in which {
        let (info, place) = (glyphs.glyph_infos().get(i)?, glyphs.glyph_positions().get(i)?);
        if info.glyph_id == 0 {
            return None;
        }
        out.pen = (out.advance * em + f64::from(place.x_offset), f64::from(place.y_offset) - out.length * em);
        let from = out.contours.len();
        face.outline_glyph(GlyphId(u16::try_from(info.glyph_id).ok()?), &mut out);
        turn_clockwise(&mut out.contours[from..]);
        out.advance += f64::from(place.x_advance) / em;
        out.length -= f64::from(place.y_advance) / em;
    }
    let sound = out.corners <= MOST_CORNERS && (0.0..100.0).contains(&out.advance);
    (sound && !out.contours.is_empty()).then_some(out)
}

/// Builds contours in ems, y up.
struct Outline {
    em: f64,
    contours: Vec<Contour>,
    /// How far the pen has moved, in ems.
    advance: f64,
    /// How far it has moved down, in ems.
    length: f64,
    /// Position of the current glyph, in font units.
    pen: (f64, f64),
    corners: usize,
    leftward: bool,
}

impl Outline {
    fn place(&self, x: f32, y: f32) -> Point {
        // Limit coordinates far outside the glyph, which would cross the page and may be invalid in other
        // programs.
        let part = |at: f32, pen: f64| ((f64::from(at) + pen) / self.em).clamp(-30.0, 30.0);
        Point::new(part(x, self.pen.0), part(y, self.pen.1))
    }

    fn add(&mut self, control: Option<Point>, end: Point) {
        self.corners += 1;
        if self.corners > MOST_CORNERS {
            return;
        }
        if let Some(contour) = self.contours.last_mut() {
            contour.segments.push((control, end));
        }
    }

    fn end(&self) -> Option<Point> {
        let contour = self.contours.last()?;
        Some(contour.segments.last().map_or(contour.start, |(_, end)| *end))
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.corners += 1;
        if self.corners <= MOST_CORNERS {
            let start = self.place(x, y);
            self.contours.push(Contour { start, segments: Vec::new() });
        }
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add(None, self.place(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.add(Some(self.place(x1, y1)), self.place(x, y));
    }

    /// Splits a cubic curve into four quadratic curves. The error is below a thousandth of an em.
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        const PARTS: i32 = 4;
        let Some(a) = self.end() else { return };
        let (b, c, d) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        let at = |t: f64| {
            let [ab, bc, cd] = [a.toward(b, t), b.toward(c, t), c.toward(d, t)];
            let (left, right) = (ab.toward(bc, t), bc.toward(cd, t));
            (left.toward(right, t), left, right)
        };
        for part in 0..PARTS {
            let [from, to] = [part, part + 1].map(|i| f64::from(i) / f64::from(PARTS));
            let (start, _, ahead) = at(from);
            let (end, behind, _) = at(to);
            // The handles of the part are as long as the way that is left of it.
            let out = start.toward(ahead, if from < 1.0 { (to - from) / (1.0 - from) } else { 0.0 });
            let back = end.toward(behind, (to - from) / to);
            let mean = |s: f64, p: f64, q: f64, e: f64| (3.0 * (p + q) - s - e) / 4.0;
            let control =
                Point::new(mean(start.x, out.x, back.x, end.x), mean(start.y, out.y, back.y, end.y));
            self.add(Some(control), end);
        }
    }

    fn close(&mut self) {}
}

/// Makes outer contours clockwise, as in the bundled glyphs. Some fonts have the opposite direction.
fn turn_clockwise(contours: &mut [Contour]) {
    let area = |contour: &Contour| {
        let ends: Vec<Point> =
            std::iter::once(contour.start).chain(contour.segments.iter().map(|(_, end)| *end)).collect();
        let next = ends.iter().cycle().skip(1);
        ends.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
    };
    let areas = contours.iter().map(area);
    if areas.max_by(|a, b| a.abs().total_cmp(&b.abs())).is_some_and(|area| area > 0.0) {
        contours.iter_mut().for_each(reverse);
    }
}

fn reverse(contour: &mut Contour) {
    let mut end = contour.start;
    let mut segments: Vec<(Option<Point>, Point)> = Vec::with_capacity(contour.segments.len());
    for (control, to) in &contour.segments {
        segments.push((*control, end));
        end = *to;
    }
    segments.reverse();
    contour.start = end;
    contour.segments = segments;
}
