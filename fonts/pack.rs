//! Turns the fonts of this folder into the table of letters that `page::words::letters` reads.
//!
//! Numbers are LEB128; signed ones are zigzagged first. Lengths are in font units, y up.
//!
//! - `INKL`, version 1
//! - compositions: count, then per entry the composed character, its base and its mark
//! - fonts: count, then per font: id (length, UTF-8), units per em, ascent, descent, height of capitals; glyphs: count,
//!   per glyph the step to its character from the one before (the first is 0, a box for what is missing), advance,
//!   contours: count, per contour its number of segments, its start, then per segment twice the x of its first point
//!   plus 1 where it is a curve, the y, and for a curve its end; all points as steps from the one before; kerning:
//!   count, per pair the step from the pair before (left character << 16 | right one), and the change of the advance

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use ttf_parser::gpos::{PairAdjustment, PositioningSubtable};
use ttf_parser::{Face, GlyphId, OutlineBuilder, Tag};
use unicode_normalization::char::compose;

/// Id in a word's `font`, and file.
const FONTS: [(&str, &str); 3] = [
    ("comic-neue", "ComicNeue-Regular.ttf"),
    ("comic-neue-bold", "ComicNeue-Bold.ttf"),
    ("bangers", "Bangers-Regular.ttf"),
];

/// Accents that text may bring as characters of their own.
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
    for (id, file) in FONTS {
        let bytes = fs::read(folder.join(file)).map_err(|error| format!("{file}: {error}"))?;
        let face = Face::parse(&bytes, 0).map_err(|error| format!("{file}: {error}"))?;
        out.count(id.len());
        out.0.extend(id.as_bytes());
        out.font(&face, &compositions);
    }
    Ok(out.0)
}

fn charset() -> BTreeSet<char> {
    let ranges = [(0x20, 0x7e), (0xa1, 0x17f), (0x218, 0x21b), (0x2010, 0x2015), (0x2018, 0x201f)];
    let signs = "†‡•…‰′″‹›⁄€™−≈≠≤≥←↑→↓★☆♠♣♥♦♩♪♫♬❤ẞ";
    let letters = ranges.into_iter().flat_map(|(first, last)| (first..=last).filter_map(char::from_u32));
    letters.chain(signs.chars()).collect()
}

/// Letters with an accent: what they are made of.
fn compositions() -> BTreeMap<char, (char, char)> {
    let letters = charset();
    let pairs = letters.iter().flat_map(|&base| MARKS.map(move |mark| (base, mark)));
    pairs
        .filter_map(|(base, mark)| Some((compose(base, mark)?, (base, mark))))
        .filter(|(composed, _)| letters.contains(composed))
        .collect()
}

/// How much closer two glyphs stand, by the `kern` feature.
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

    fn font(&mut self, face: &Face, compositions: &BTreeMap<char, (char, char)>) {
        let capitals = face.capital_height().unwrap_or(face.ascender());
        self.unsigned(u32::from(face.units_per_em()));
        self.signed(i32::from(face.ascender()));
        self.signed(-i32::from(face.descender()));
        self.signed(i32::from(capitals));
        let glyphs: BTreeMap<char, GlyphId> =
            charset().into_iter().filter_map(|letter| Some((letter, face.glyph_index(letter)?))).collect();
        self.count(glyphs.len() + 1);
        self.missing(i32::from(capitals));
        let mut before = 0;
        for (&letter, &glyph) in &glyphs {
            self.unsigned(u32::from(letter) - before);
            before = u32::from(letter);
            self.unsigned(u32::from(face.glyph_hor_advance(glyph).unwrap_or(0)));
            let mut outline = Outline::default();
            // A glyph without an outline is a space.
            let _ = face.outline_glyph(glyph, &mut outline);
            self.outline(outline);
        }
        let plain: Vec<_> = glyphs.iter().filter(|(letter, _)| !compositions.contains_key(letter)).collect();
        let mut pairs = Vec::new();
        for &(&a, &left) in &plain {
            for &(&b, &right) in &plain {
                if let Some(change) = kern(face, left, right).filter(|change| *change != 0) {
                    pairs.push((u32::from(a) << 16 | u32::from(b), change));
                }
            }
        }
        self.count(pairs.len());
        let mut before = 0;
        for (pair, change) in pairs {
            self.unsigned(pair - before);
            before = pair;
            self.signed(i32::from(change));
        }
    }

    /// An empty box as high as a capital.
    fn missing(&mut self, height: i32) {
        let (width, line) = (height * 3 / 5, height / 12);
        let (left, right) = (line * 2, line * 2 + width);
        let ring = |a: i32, b: i32, c: i32, d: i32| vec![(a, b), (a, d), (c, d), (c, b)];
        let mut inner = ring(left + line, line, right - line, height - line);
        inner.reverse();
        let contours = [ring(left, 0, right, height), inner].map(|corners| Contour {
            start: corners[0],
            segments: corners[1..].iter().map(|&end| (None, end)).collect(),
        });
        self.unsigned(0);
        self.unsigned((right + line * 2) as u32);
        self.outline(Outline { contours: contours.into() });
    }

    fn outline(&mut self, Outline { contours }: Outline) {
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

#[derive(Default)]
struct Outline {
    contours: Vec<Contour>,
}

impl Outline {
    fn add(&mut self, control: Option<Place>, end: Place) {
        if let Some(contour) = self.contours.last_mut() {
            contour.segments.push((control, end));
        }
    }
}

fn whole(x: f32, y: f32) -> Place {
    (x.round() as i32, y.round() as i32)
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.contours.push(Contour { start: whole(x, y), segments: Vec::new() });
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add(None, whole(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.add(Some(whole(x1, y1)), whole(x, y));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        // None of these fonts has cubic curves; the nearest quadratic one stands for it.
        self.add(Some(whole(x1.midpoint(x2), y1.midpoint(y2))), whole(x, y));
    }

    fn close(&mut self) {}
}
