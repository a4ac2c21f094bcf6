//! Traced glyphs, for characters that the fonts lack. The browser draws an Arabic word, a Chinese character
//! or an emoji with a system font. Its outline becomes a glyph. Native builds use font files (`given`). So
//! its look is identical in the preview, in images and in PDF files, at any size.
//!
//! The outline is at half coverage, by marching squares (Lorensen and Cline 1987, in the plane), simplified
//! by the Douglas-Peucker algorithm.

use super::contour::Contour;
use crate::layout::Point;

/// Maximum number of traced glyphs. They use private-use characters.
pub const MOST_LEARNT: usize = 6_000;
/// The first of these places.
const FIRST: u32 = 0xe000;
/// Most pixels of a picture.
const MOST_PIXELS: usize = 4_000_000;
/// How far a thinned outline may be off, in pixels of the picture.
const WITHIN: f64 = 0.22;
/// No crossing.
const NONE: usize = usize::MAX;
/// Minimum area of an outline in pixels. Smaller ones are noise.
const DUST: f64 = 1.5;

/// An image of glyphs, with their metrics in pixels.
#[derive(Debug, Clone, Copy)]
pub struct Drawing<'a> {
    /// Its width.
    pub width: usize,
    /// Coverage of each pixel, row by row.
    pub ink: &'a [u8],
    /// Height of an em.
    pub em: f64,
    /// From the top to the baseline.
    pub baseline: f64,
    /// Distance from the left edge to the glyph origin.
    pub left: f64,
    /// How far the pen moves.
    pub advance: f64,
}

/// A run of text with a traced glyph.
#[derive(Debug, Clone)]
pub(super) struct Learnt {
    /// The text.
    pub(super) run: String,
    /// It is read from right to left.
    pub(super) leftward: bool,
    /// Vertical form of the character with this number. It is not in any text.
    pub(super) stands_for: Option<usize>,
}

/// The placeholder character of a run by its number.
pub(super) fn letter(number: usize) -> Option<char> {
    char::from_u32(FIRST + number as u32).filter(|_| number < MOST_LEARNT)
}

/// The run number of a placeholder character.
pub(super) fn number(letter: char) -> Option<usize> {
    u32::from(letter).checked_sub(FIRST).map(|number| number as usize).filter(|number| *number < MOST_LEARNT)
}

/// Offset of private-use characters in a text, so that none collides with a placeholder.
const APART: u32 = 0xf_0000 - FIRST;

/// Replaces characters of text that collide with the placeholders.
pub(super) fn private(letter: char) -> char {
    number(letter).and_then(|_| char::from_u32(u32::from(letter) + APART)).unwrap_or(letter)
}

/// Returns the character in the text.
pub(super) fn private_again(letter: char) -> char {
    let before = u32::from(letter).checked_sub(APART).and_then(char::from_u32);
    before.filter(|&before| number(before).is_some()).unwrap_or(letter)
}

impl Drawing<'_> {
    /// The outlines in ems, y up. `None` if the input is not an image.
    pub(super) fn contours(&self) -> Option<Vec<Contour>> {
        let sound =
            self.em > 0.0 && [self.baseline, self.left, self.advance].iter().all(|length| length.is_finite());
        if self.width == 0
            || self.ink.len() > MOST_PIXELS
            || !self.ink.len().is_multiple_of(self.width)
            || !sound
        {
            return None;
        }
        let place =
            |point: Point| Point::new((point.x - self.left) / self.em, (self.baseline - point.y) / self.em);
        let contour = |points: Vec<Point>| {
            let mut points = points.into_iter().map(place);
            let start = points.next()?;
            Some(Contour { start, segments: points.map(|end| (None, end)).collect() })
        };
        Some(traced(self.width, self.ink).into_iter().filter_map(contour).collect())
    }
}

/// Crossings of a contour with the sides of a square between four pixels.
const TOP: usize = 0;
const RIGHT: usize = 1;
const BOTTOM: usize = 2;
const LEFT: usize = 3;

/// The outlines of the area with at least half coverage, in pixels, outer ones clockwise on the screen.
fn traced(width: usize, ink: &[u8]) -> Vec<Vec<Point>> {
    let height = ink.len() / width;
    // The picture has an empty border.
    let at = |x: usize, y: usize| -> f64 {
        let inside = (1..=width).contains(&x) && (1..=height).contains(&y);
        if inside { f64::from(ink[(y - 1) * width + x - 1]) - 127.5 } else { -127.5 }
    };
    let (columns, rows) = (width + 2, height + 2);
    // A crossing is named by the side that it is on: two for each pixel, to the right of it and below it.
    let side = |x: usize, y: usize, which: usize| match which {
        TOP => 2 * (y * columns + x),
        RIGHT => 2 * (y * columns + x + 1) + 1,
        BOTTOM => 2 * ((y + 1) * columns + x),
        _ => 2 * (y * columns + x) + 1,
    };
    let mut next = vec![NONE; 2 * columns * rows];
    for y in 0..rows - 1 {
        for x in 0..columns - 1 {
            let corners = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            let joined = corners.iter().sum::<f64>() > 0.0;
            for &(from, to) in segments(corners.map(|corner| corner > 0.0), joined) {
                next[side(x, y, from)] = side(x, y, to);
            }
        }
    }
    let point = |crossing: usize| {
        let (pixel, down) = (crossing / 2, crossing % 2 == 1);
        let (x, y) = (pixel % columns, pixel / columns);
        let (one, other) = (at(x, y), if down { at(x, y + 1) } else { at(x + 1, y) });
        let part = one / (one - other);
        // The middle of the first pixel of the picture is at a half.
        let [x, y] = [x as f64 - 0.5, y as f64 - 0.5];
        if down { Point::new(x, y + part) } else { Point::new(x + part, y) }
    };
    let mut outlines = Vec::new();
    for start in 0..next.len() {
        let mut line = Vec::new();
        let mut here = start;
        while next[here] != NONE {
            line.push(point(here));
            here = std::mem::replace(&mut next[here], NONE);
        }
        let line = thinned(&line);
        if area(&line).abs() > DUST {
            outlines.push(line);
        }
    }
    outlines
}

/// Contour segments in a square with covered and uncovered corners, clockwise from the upper left one. The
/// covered area is to the right. `joined`: the centre is covered.
fn segments(covered: [bool; 4], joined: bool) -> &'static [(usize, usize)] {
    match (covered.map(u8::from), joined) {
        ([1, 0, 0, 0], _) => &[(TOP, LEFT)],
        ([0, 1, 0, 0], _) => &[(RIGHT, TOP)],
        ([1, 1, 0, 0], _) => &[(RIGHT, LEFT)],
        ([0, 0, 1, 0], _) => &[(BOTTOM, RIGHT)],
        ([1, 0, 1, 0], false) => &[(TOP, LEFT), (BOTTOM, RIGHT)],
        ([1, 0, 1, 0], true) => &[(TOP, RIGHT), (BOTTOM, LEFT)],
        ([0, 1, 1, 0], _) => &[(BOTTOM, TOP)],
        ([1, 1, 1, 0], _) => &[(BOTTOM, LEFT)],
        ([0, 0, 0, 1], _) => &[(LEFT, BOTTOM)],
        ([1, 0, 0, 1], _) => &[(TOP, BOTTOM)],
        ([0, 1, 0, 1], false) => &[(RIGHT, TOP), (LEFT, BOTTOM)],
        ([0, 1, 0, 1], true) => &[(LEFT, TOP), (RIGHT, BOTTOM)],
        ([1, 1, 0, 1], _) => &[(RIGHT, BOTTOM)],
        ([0, 0, 1, 1], _) => &[(LEFT, RIGHT)],
        ([1, 0, 1, 1], _) => &[(TOP, RIGHT)],
        ([0, 1, 1, 1], _) => &[(LEFT, TOP)],
        _ => &[],
    }
}

fn area(line: &[Point]) -> f64 {
    let next = line.iter().cycle().skip(1);
    line.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>() / 2.0
}

/// A closed line with the points that it cannot do without.
fn thinned(line: &[Point]) -> Vec<Point> {
    let count = line.len();
    if count < 4 {
        return line.to_vec();
    }
    let far = |from: usize| {
        (0..count).max_by(|&a, &b| line[from].distance(line[a]).total_cmp(&line[from].distance(line[b])))
    };
    let middle = far(0).unwrap_or(count / 2).max(1);
    let mut kept = vec![false; count];
    (kept[0], kept[middle]) = (true, true);
    let mut parts = vec![(0, middle), (middle, count)];
    while let Some((from, to)) = parts.pop() {
        let (start, end) = (line[from], line[to % count]);
        let length = start.distance(end);
        let off = |at: usize| {
            let (dx, dy) = (line[at].x - start.x, line[at].y - start.y);
            if length < 1e-9 {
                dx.hypot(dy)
            } else {
                ((end.x - start.x) * dy - (end.y - start.y) * dx).abs() / length
            }
        };
        let worst = (from + 1..to).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        if let Some(at) = worst.filter(|&at| off(at) > WITHIN) {
            kept[at] = true;
            parts.extend([(from, at), (at, to)]);
        }
    }
    line.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

#[cfg(test)]
mod tests {
    use super::super::letters::Letters;
    use super::*;

    /// A disc with a hole, as a picture.
    fn ring(size: usize, outer: f64, inner: f64) -> Vec<u8> {
        let middle = size as f64 / 2.0;
        let pixel = |i: usize| {
            let away = (((i % size) as f64 + 0.5 - middle).hypot((i / size) as f64 + 0.5 - middle)).abs();
            let covered = (outer - away + 0.5).clamp(0.0, 1.0) * (away - inner + 0.5).clamp(0.0, 1.0);
            (covered * 255.0) as u8
        };
        (0..size * size).map(pixel).collect()
    }

    #[test]
    fn an_outline_is_where_half_of_a_pixel_is_covered() {
        let lines = traced(100, &ring(100, 40.0, 20.0));
        let areas: Vec<f64> = lines.iter().map(|line| area(line)).collect();
        assert_eq!(areas.len(), 2);
        let circle = |radius: f64| std::f64::consts::PI * radius * radius;
        assert!(areas.iter().any(|area| (area - circle(40.0)).abs() < 0.01 * circle(40.0)), "{areas:?}");
        assert!(areas.iter().any(|area| (area + circle(20.0)).abs() < 0.02 * circle(20.0)), "{areas:?}");
        for line in &lines {
            assert!(line.len() < 90, "{}", line.len());
        }
        assert!(traced(3, &[0; 9]).is_empty());
        // Up to the edge of the picture.
        assert!((area(&traced(3, &[255; 9])[0]) - 9.0).abs() < 1.5);
    }

    #[test]
    fn what_was_learnt_is_a_letter_of_every_font() {
        let mut letters = Letters::bundled().unwrap();
        let ink = ring(100, 40.0, 20.0);
        let drawing = Drawing { width: 100, ink: &ink, em: 100.0, baseline: 90.0, left: 5.0, advance: 95.0 };
        assert!(letters.learn("漢", false, drawing));
        assert!(letters.learn("漢字", true, drawing));
        assert!(!letters.learn("", false, drawing), "nothing is no letter");
        assert!(!letters.learn("x", false, Drawing { width: 7, ..drawing }), "no picture");
        let cleaned = letters.cleaned("a漢字漢b");
        assert_eq!(cleaned.len(), 4, "the longer one comes first: {cleaned:?}");
        for id in ["comic-neue", "bangers"] {
            let font = letters.font(id).unwrap();
            assert_eq!(letters.missing("a漢字漢b", font), []);
            assert!((letters.width(font, &cleaned[1..3]) - 1.9).abs() < 1e-9);
            let points: Vec<Point> = font.outline(cleaned[1], 0.01).concat();
            let top = points.iter().map(|point| point.y).fold(f64::MIN, f64::max);
            assert!((top - 0.8).abs() < 0.01, "{top}");
        }
        // The first strong letter gives the direction.
        let seen = |line: &[char]| -> Vec<char> {
            letters.ordered(&[line])[0].iter().map(|seen| seen.letter).collect()
        };
        assert_eq!(seen(&cleaned), cleaned);
    }
}
