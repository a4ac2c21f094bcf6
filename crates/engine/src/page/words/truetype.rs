//! Writes glyphs of the table as a TrueType font, for files with text. The table's curves are quadratic and
//! in integer units, like TrueType, so nothing is lost. The font has only the tables that a PDF file needs.
//!
//! Source: the OpenType specification 1.9.1, tables `glyf`, `head`, `hhea`, `hmtx`, `loca`, `maxp`.

use super::contour::Contour;
use super::letters::Font;

/// Corners of a box in font units: x and y of the lowest, then of the highest.
type Corners = [i16; 4];

/// A font with the missing-glyph box as glyph 0, and `letters[i]` as glyph `i + 1`.
#[must_use]
pub fn subset(font: &Font, letters: &[char]) -> Vec<u8> {
    let mut glyphs = Vec::new();
    let mut places = Bytes::default();
    let mut metrics = Bytes::default();
    let mut all: Corners = [0; 4];
    let (mut most_points, mut most_contours) = (0, 0);
    for letter in std::iter::once('\0').chain(letters.iter().copied()) {
        places.long(glyphs.len() as u32);
        let glyph = font.glyph(letter);
        let contours: Vec<_> =
            glyph.iter().flat_map(|glyph| &glyph.contours).map(|c| points(font, c)).collect();
        let corners = corners(&contours);
        metrics.short(whole(font, glyph.map_or(0.0, |glyph| glyph.advance)));
        metrics.short(corners[0]);
        all = [0, 1, 2, 3].map(|i| if i < 2 { all[i].min(corners[i]) } else { all[i].max(corners[i]) });
        most_points = most_points.max(contours.iter().map(Vec::len).sum());
        most_contours = most_contours.max(contours.len());
        glyphs.extend(glyf(&contours, corners));
    }
    places.long(glyphs.len() as u32);
    let count = letters.len() as i16 + 1;
    let mut most = Bytes::default();
    most.long(0x0001_0000).short(count).short(most_points as i16).short(most_contours as i16);
    // No composites, two zones, no instructions.
    most.shorts(&[0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0]);
    let mut across = Bytes::default();
    across.long(0x0001_0000).short(whole(font, font.ascent)).short(-whole(font, font.descent));
    across.shorts(&[0, all[2], 0, 0, all[2], 1, 0, 0, 0, 0, 0, 0, 0, count]);
    let head = head(font, all);
    let tables = [(b"glyf", glyphs), (b"head", head), (b"hhea", across.0), (b"hmtx", metrics.0)];
    assemble(tables.into_iter().chain([(b"loca", places.0), (b"maxp", most.0)]).collect())
}

fn whole(font: &Font, ems: f64) -> i16 {
    (ems * f64::from(font.units)).round() as i16
}

/// Returns the points of a contour, and whether each is on the curve.
fn points(font: &Font, contour: &Contour) -> Vec<(i16, i16, bool)> {
    let at = |point: crate::layout::Point, on: bool| (whole(font, point.x), whole(font, point.y), on);
    let mut out = vec![at(contour.start, true)];
    for &(control, end) in &contour.segments {
        out.extend(control.map(|control| at(control, false)));
        out.push(at(end, true));
    }
    // Contours are closed implicitly.
    if out.len() > 1 && out.last() == out.first() {
        out.pop();
    }
    out
}

fn corners(contours: &[Vec<(i16, i16, bool)>]) -> Corners {
    let mut points = contours.iter().flatten();
    let Some(&(x, y, _)) = points.next() else { return [0; 4] };
    points.fold([x, y, x, y], |[l, b, r, t], &(x, y, _)| [l.min(x), b.min(y), r.max(x), t.max(y)])
}

/// Returns a glyph, or nothing for a space.
fn glyf(contours: &[Vec<(i16, i16, bool)>], corners: Corners) -> Vec<u8> {
    if contours.is_empty() {
        return Vec::new();
    }
    let mut out = Bytes::default();
    out.short(contours.len() as i16).shorts(&corners);
    let mut end = -1;
    for contour in contours {
        end += contour.len() as i16;
        out.short(end);
    }
    // No instructions.
    out.short(0);
    out.0.extend(contours.iter().flatten().map(|&(.., on)| u8::from(on)));
    for axis in [0, 1] {
        let mut pen = 0i16;
        for &(x, y, _) in contours.iter().flatten() {
            let to = [x, y][axis];
            out.short(to.wrapping_sub(pen));
            pen = to;
        }
    }
    out.0.resize(out.0.len().next_multiple_of(4), 0);
    out.0
}

fn head(font: &Font, all: Corners) -> Vec<u8> {
    let mut out = Bytes::default();
    // Version, revision, checksum (ignored in PDF files), magic number; the baseline is at 0.
    out.long(0x0001_0000).long(0x0001_0000).long(0).long(0x5f0f_3cf5).short(1).short(font.units as i16);
    // No dates, for privacy.
    out.long(0).long(0).long(0).long(0).shorts(&all);
    // No style, any size, places in long numbers.
    out.shorts(&[0, 6, 2, 1, 0]);
    out.0
}

/// Writes the tables after their directory.
fn assemble(tables: Vec<(&[u8; 4], Vec<u8>)>) -> Vec<u8> {
    let count = tables.len();
    let step = count.ilog2();
    let mut out = Bytes::default();
    out.long(0x0001_0000);
    out.shorts(&[count as i16, 16 << step, step as i16, (count as i16) * 16 - (16 << step)]);
    let mut at = 12 + 16 * count;
    for (name, bytes) in &tables {
        let sum = bytes.chunks(4).fold(0u32, |sum, chunk| {
            let mut word = [0; 4];
            word[..chunk.len()].copy_from_slice(chunk);
            sum.wrapping_add(u32::from_be_bytes(word))
        });
        out.0.extend_from_slice(*name);
        out.long(sum).long(at as u32).long(bytes.len() as u32);
        at += bytes.len().next_multiple_of(4);
    }
    for (_, bytes) in tables {
        out.0.extend(bytes);
        out.0.resize(out.0.len().next_multiple_of(4), 0);
    }
    out.0
}

/// Numbers, the highest byte first.
#[derive(Default)]
struct Bytes(Vec<u8>);

impl Bytes {
    fn long(&mut self, value: u32) -> &mut Self {
        self.0.extend(value.to_be_bytes());
        self
    }

    fn short(&mut self, value: i16) -> &mut Self {
        self.0.extend(value.to_be_bytes());
        self
    }

    fn shorts(&mut self, values: &[i16]) -> &mut Self {
        for &value in values {
            self.short(value);
        }
        self
    }
}
