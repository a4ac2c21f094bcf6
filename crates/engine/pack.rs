//! Turns the fonts of `fonts/` into the table of glyphs that `page::words::letters` reads.
//!
//! Numbers are LEB128; signed ones are zigzagged first. Lengths are in font units, y up.
//!
//! - `INKL`, version 1
//! - compositions: count, then per entry the composed character, its base and its mark
//! - fonts: count, then per font: id (length, UTF-8), units per em, ascent, descent, height of capitals,
//!   glyphs, kerning
//!   - glyphs: count, then per glyph: difference to the previous character (the first glyph is 0, a box for
//!     missing glyphs), advance, contours
//!   - contours: count, then per contour: number of segments, start, and per segment: twice the x of its
//!     first point, plus 1 for a curve, the y, and the end of a curve. All points are differences to the
//!     previous one
//!   - kerning: count, then per pair: difference to the previous pair (left character << 16 | right one), and
//!     the change of the advance

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use ttf_parser::gpos::{PairAdjustment, PositioningSubtable};
use ttf_parser::{Face, GlyphId, OutlineBuilder, Tag};
use unicode_normalization::char::compose;

/// A font of the table: its id in the `font` of a text item, its file, and its fallback files, in order of
/// preference. The last value is the slant of their glyphs to match this font, in ems per em.
const FONTS: [(&str, &str, &[&str], f64); 3] = [
    (
        "comic-neue",
        "ComicNeue-Regular.ttf",
        &[
            "ComicRelief-LatinExtended-Regular.ttf",
            "Mali-Vietnamese-Regular.ttf",
            "ComicRelief-Greek-Regular.ttf",
            "ComicRelief-Cyrillic-Regular.ttf",
        ],
        0.0,
    ),
    ("comic-neue-bold", "ComicNeue-Bold.ttf", &BOLD, 0.0),
    ("bangers", "Bangers-Regular.ttf", &BOLD, 0.16),
];
const BOLD: [&str; 4] = [
    "ComicRelief-LatinExtended-Bold.ttf",
    "Mali-Vietnamese-Bold.ttf",
    "ComicRelief-Greek-Bold.ttf",
    "ComicRelief-Cyrillic-Bold.ttf",
];

/// A file with glyphs. Glyphs of a fallback font are scaled to the size of the main font.
struct Source<'a> {
    face: Face<'a>,
    scale: f64,
    lean: f64,
}

impl Source<'_> {
    fn scaled(&self, length: impl Into<f64>) -> i32 {
        (length.into() * self.scale).round() as i32
    }
}

/// Combining marks that text may contain as separate characters.
const MARKS: std::ops::RangeInclusive<char> = '\u{300}'..='\u{36f}';

/// The table as bytes, from the fonts in `folder`.
///
/// # Errors
/// A sentence that names the file.
pub(crate) fn pack(folder: &Path) -> Result<Vec<u8>, String> {
    let mut out = Writer(b"INKL\x01".to_vec());
    let compositions = compositions();
    out.count(compositions.len());
    for (composed, (base, mark)) in &compositions {
        for &letter in [composed, base, mark] {
            out.unsigned(u32::from(letter));
        }
    }
    out.count(FONTS.len());
    for (id, file, others, lean) in FONTS {
        let files: Vec<&str> = [file].into_iter().chain(others.iter().copied()).collect();
        let read = |file: &&str| fs::read(folder.join(file)).map_err(|error| format!("{file}: {error}"));
        let bytes = files.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let mut sources: Vec<Source> = Vec::new();
        for (file, bytes) in files.iter().zip(&bytes) {
            let face = Face::parse(bytes, 0).map_err(|error| format!("{file}: {error}"))?;
            let (scale, lean) =
                sources.first().map_or((1.0, 0.0), |first| (matched(&first.face, &face), lean));
            sources.push(Source { face, scale, lean });
        }
        out.count(id.len());
        out.0.extend(id.as_bytes());
        out.font(&sources, &compositions);
    }
    Ok(out.0)
}

/// Factor from units of the other font to units of the first, for equal height of capitals.
fn matched(first: &Face, other: &Face) -> f64 {
    let capitals = |face: &Face| f64::from(face.capital_height().unwrap_or(face.ascender()));
    capitals(first) / capitals(other)
}

fn charset() -> BTreeSet<char> {
    let latin = [(0x20, 0x7e), (0xa1, 0x24f), (0x1e80, 0x1e85), (0x1ea0, 0x1ef9)];
    let others = [(0x370, 0x3ff), (0x400, 0x52f), (0x2010, 0x2015), (0x2018, 0x201f)];
    let signs = "†‡•…‰′″‹›⁄€₴₽₫№™−≈≠≤≥←↑→↓★☆♠♣♥♦♩♪♫♬❤ẞ";
    let letters =
        latin.into_iter().chain(others).flat_map(|(first, last)| (first..=last).filter_map(char::from_u32));
    letters.chain(signs.chars()).collect()
}

/// Accented characters with their base and mark.
fn compositions() -> BTreeMap<char, (char, char)> {
    let letters = charset();
    let pairs = letters.iter().flat_map(|&base| MARKS.map(move |mark| (base, mark)));
    pairs
        .filter_map(|(base, mark)| Some((compose(base, mark)?, (base, mark))))
        .filter(|(composed, _)| letters.contains(composed))
        .collect()
}

/// Returns the change of the distance between two glyphs, by the `kern` feature.
fn kern(face: &Face, left: GlyphId, right: GlyphId) -> Option<i16> {
    let table = face.tables().gpos?;
    let features = table.features.into_iter().filter(|feature| feature.tag == Tag::from_bytes(b"kern"));
    let mut lookups: Vec<u16> = features.flat_map(|feature| feature.lookup_indices).collect();
    lookups.sort_unstable();
    lookups.dedup();
    for lookup in lookups.into_iter().filter_map(|index| table.lookups.get(index)) {
        for subtable in lookup.subtables.into_iter::<PositioningSubtable>() {
            let PositioningSubtable::Pair(pairs) = subtable else { continue };
            let Some(place) = pairs.coverage().get(left) else { continue };
            let found = match pairs {
                PairAdjustment::Format1 { sets, .. } => sets.get(place).and_then(|set| set.get(right)),
                PairAdjustment::Format2 { classes, matrix, .. } => {
                    matrix.get((classes.0.get(left), classes.1.get(right)))
                }
            };
            if let Some((first, _)) = found {
                return Some(first.x_advance);
            }
        }
    }
    None
}

struct Writer(Vec<u8>);

impl Writer {
    fn unsigned(&mut self, mut value: u32) {
        while value >= 0x80 {
            self.0.push((value & 0x7f) as u8 | 0x80);
            value >>= 7;
        }
        self.0.push(value as u8);
    }

    fn signed(&mut self, value: i32) {
        self.unsigned(((value << 1) ^ (value >> 31)) as u32);
    }

    fn count(&mut self, count: usize) {
        self.unsigned(count as u32);
    }

    fn font(&mut self, sources: &[Source], compositions: &BTreeMap<char, (char, char)>) {
        let face = &sources[0].face;
        let capitals = face.capital_height().unwrap_or(face.ascender());
        self.unsigned(u32::from(face.units_per_em()));
        self.signed(i32::from(face.ascender()));
        self.signed(-i32::from(face.descender()));
        self.signed(i32::from(capitals));
        let first = |letter| {
            let has = |(i, source): (usize, &Source)| Some((i, source.face.glyph_index(letter)?));
            sources.iter().enumerate().find_map(has)
        };
        let glyphs: BTreeMap<char, (usize, GlyphId)> =
            charset().into_iter().filter_map(|letter| Some((letter, first(letter)?))).collect();
        self.count(glyphs.len() + 1);
        self.missing(face, i32::from(capitals));
        let mut before = 0;
        for (&letter, &(source, glyph)) in &glyphs {
            let Source { face, scale, lean } = &sources[source];
            self.unsigned(u32::from(letter) - before);
            before = u32::from(letter);
            let advance = f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) * scale;
            self.unsigned(advance.round() as u32);
            let mut outline = Outline { scale: *scale as f32, lean: *lean as f32, ..Outline::default() };
            // A glyph without an outline is a space.
            let _ = face.outline_glyph(glyph, &mut outline);
            if source > 0 {
                outline.turn_clockwise();
            }
            self.outline(outline);
        }
        let plain: Vec<_> = glyphs.iter().filter(|(letter, _)| !compositions.contains_key(letter)).collect();
        let mut pairs = Vec::new();
        for &(&a, &(one, left)) in &plain {
            for &(&b, &(other, right)) in &plain {
                // Fonts have no kerning pairs with glyphs of another font.
                if one != other {
                    continue;
                }
                let source = &sources[one];
                let change = kern(&source.face, left, right).map_or(0, |change| source.scaled(change));
                if change != 0 {
                    pairs.push((u32::from(a) << 16 | u32::from(b), change));
                }
            }
        }
        self.count(pairs.len());
        let mut before = 0;
        for (pair, change) in pairs {
            self.unsigned(pair - before);
            before = pair;
            self.signed(change);
        }
    }

    /// Adds the glyph for missing characters: a question mark in a ring, as high as a capital. Unlike an
    /// empty box, it is recognisable as a replacement.
    fn missing(&mut self, face: &Face, height: i32) {
        let radius = f64::from(height) * 0.56;
        let line = f64::from(height) / 14.0;
        let middle = (radius + line * 1.5, f64::from(height) / 2.0);
        let mut contours = vec![circle(middle, radius, true), circle(middle, radius - line, false)];
        let mut mark = Outline { scale: 0.62, ..Outline::default() };
        if let Some(glyph) = face.glyph_index('?') {
            let _ = face.outline_glyph(glyph, &mut mark);
        }
        let places = || mark.contours.iter().flat_map(Contour::places);
        let reach = |axis: fn(Place) -> i32| {
            let (low, high) = (places().map(axis).min(), places().map(axis).max());
            f64::midpoint(f64::from(low.unwrap_or(0)), f64::from(high.unwrap_or(0)))
        };
        let off = (middle.0 - reach(|place| place.0), middle.1 - reach(|place| place.1));
        mark.contours
            .iter_mut()
            .for_each(|contour| contour.shift((off.0.round() as i32, off.1.round() as i32)));
        contours.append(&mut mark.contours);
        self.unsigned(0);
        self.unsigned((2.0 * middle.0).round() as u32);
        self.outline(Outline { contours, ..Outline::default() });
    }

    fn outline(&mut self, Outline { contours, .. }: Outline) {
        self.count(contours.len());
        let mut pen = (0, 0);
        for Contour { start, segments } in contours {
            self.count(segments.len());
            let mut step = |this: &mut Self, to: (i32, i32), flag: Option<bool>| {
                let (x, y) = (to.0 - pen.0, to.1 - pen.1);
                this.signed(flag.map_or(x, |curve| x * 2 + i32::from(curve)));
                this.signed(y);
                pen = to;
            };
            step(self, start, None);
            for (control, end) in segments {
                step(self, control.unwrap_or(end), Some(control.is_some()));
                if control.is_some() {
                    step(self, end, None);
                }
            }
        }
    }
}

/// In font units.
type Place = (i32, i32);

struct Contour {
    start: Place,
    /// The control point where the segment is a curve, and its end.
    segments: Vec<(Option<Place>, Place)>,
}

impl Contour {
    /// About twice its signed area: positive for counterclockwise contours, as y points up.
    fn area(&self) -> f64 {
        let ends = self.segments.iter().map(|(_, end)| *end);
        let points: Vec<Place> = [self.start].into_iter().chain(ends).collect();
        let next = points.iter().cycle().skip(1);
        points
            .iter()
            .zip(next)
            .map(|(a, b)| f64::from(a.0) * f64::from(b.1) - f64::from(b.0) * f64::from(a.1))
            .sum()
    }

    /// All its points.
    fn places(&self) -> impl Iterator<Item = Place> + '_ {
        let ends = self.segments.iter().flat_map(|(control, end)| control.iter().chain([end]).copied());
        [self.start].into_iter().chain(ends)
    }

    fn shift(&mut self, by: Place) {
        let moved = |(x, y): Place| (x + by.0, y + by.1);
        self.start = moved(self.start);
        for (control, end) in &mut self.segments {
            (*control, *end) = (control.map(moved), moved(*end));
        }
    }

    fn reverse(&mut self) {
        let mut end = self.start;
        for (_, point) in &mut self.segments {
            std::mem::swap(point, &mut end);
        }
        self.start = end;
        self.segments.reverse();
    }
}

/// A circle of eight curves.
fn circle((x, y): (f64, f64), radius: f64, clockwise: bool) -> Contour {
    let eighth = std::f64::consts::FRAC_PI_4;
    let place = |turn: f64, radius: f64| {
        let (sin, cos) = if clockwise { (-turn).sin_cos() } else { turn.sin_cos() };
        ((x + radius * cos).round() as i32, (y + radius * sin).round() as i32)
    };
    let curve = |i: u32| {
        let turn = f64::from(i) * eighth;
        (Some(place(turn + eighth / 2.0, radius / (eighth / 2.0).cos())), place(turn + eighth, radius))
    };
    Contour { start: place(0.0, radius), segments: (0..8).map(curve).collect() }
}

struct Outline {
    contours: Vec<Contour>,
    scale: f32,
    lean: f32,
}

impl Default for Outline {
    fn default() -> Self {
        Self { contours: Vec::new(), scale: 1.0, lean: 0.0 }
    }
}

impl Outline {
    /// Some fonts draw their outer lines the other way round, where what is inside would be a hole.
    fn turn_clockwise(&mut self) {
        let areas = self.contours.iter().map(Contour::area);
        let largest = areas.max_by(|a, b| a.abs().total_cmp(&b.abs()));
        if largest.is_some_and(|area| area > 0.0) {
            self.contours.iter_mut().for_each(Contour::reverse);
        }
    }

    fn add(&mut self, control: Option<Place>, end: Place) {
        if let Some(contour) = self.contours.last_mut() {
            contour.segments.push((control, end));
        }
    }

    fn whole(&self, x: f32, y: f32) -> Place {
        let [x, y] = [(x + y * self.lean) * self.scale, y * self.scale];
        (x.round() as i32, y.round() as i32)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let start = self.whole(x, y);
        self.contours.push(Contour { start, segments: Vec::new() });
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let end = self.whole(x, y);
        self.add(None, end);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (control, end) = (self.whole(x1, y1), self.whole(x, y));
        self.add(Some(control), end);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        // None of these fonts has cubic curves. If one had, this approximates it by a quadratic curve.
        let (control, end) = (self.whole(x1.midpoint(x2), y1.midpoint(y2)), self.whole(x, y));
        self.add(Some(control), end);
    }

    fn close(&mut self) {}
}
