//! A word as pixels: a patch of straight-alpha RGBA that lies on the panels.

use super::layout::{Ground, Laid, lay_all};
use super::letters::{Font, Letters};
use super::model::{Kind, Shape, Word};
use super::shapes;
use crate::error::{Error, Result};
use crate::layout::{Bounds, Point};
use crate::page::Document;
use crate::page::compose::{Patch, Sheet, lay_over};
use crate::page::coverage::{Contour, coverage};
use crate::page::mask::PixelRect;
use crate::page::scene::MAX_SIDE;

/// Half the width of outlines, in page widths.
const LINE: f64 = 0.0014;
/// Lengths of a whisper's dashes and of the gaps between, in page widths.
const DASH: (f64, f64) = (0.0085, 0.007);
/// The line around the letters of an effect, in ems.
const RING: f64 = 0.075;

/// Draws one word of a document whose page is `width` pixels wide.
///
/// # Errors
/// `invalid-document` for a word that is not there or breaks its shape; those of the layout.
pub fn render(document: &Document, index: usize, width: usize, letters: &Letters) -> Result<Patch> {
    let invalid =
        |location: String, reason: &str| Error::InvalidDocument { location, reason: reason.to_owned() };
    if width == 0 || width as f64 > MAX_SIDE {
        return Err(invalid("page".into(), "cannot be rendered at this size"));
    }
    let missing = || invalid(format!("words[{index}]"), "there is no such word");
    let value = document.words.get(index).ok_or_else(missing)?;
    let laid = Ground::new(document)?.lay(Word::parse(value, index)?, letters);
    Ok(draw(&laid, width as f64, letters))
}

/// Lays all words of a document on its sheet, in their order.
///
/// # Errors
/// As [`render`].
pub fn lay_words(sheet: &mut Sheet, document: &Document, letters: &Letters) -> Result<()> {
    let width = sheet.width() as f64;
    for laid in lay_all(document, letters)? {
        let patch = draw(&laid, width, letters);
        sheet.lay(patch.area, &patch.rgba)?;
    }
    Ok(())
}

/// The lines of a word on a page of some width, in its pixels.
pub(in crate::page) struct Lines {
    /// Outline of a balloon or a caption; its tail is a part of it, or follows it.
    pub(in crate::page) body: Vec<Vec<Point>>,
    /// Outlines of the letters.
    pub(in crate::page) text: Vec<Vec<Point>>,
    /// Half the width of the line around the body, or around the letters of an effect.
    pub(in crate::page) half: f64,
    /// Lengths of dashes and gaps of the line, where it has some.
    pub(in crate::page) dash: Option<(f64, f64)>,
}

/// What is drawn of a word on a page of `width` pixels.
pub(in crate::page) fn lines(laid: &Laid, width: f64, letters: &Letters) -> Lines {
    let kind = laid.word.kind;
    let scaled = |point: Point| Point::new(point.x * width, point.y * width);
    let middle = scaled(laid.middle);
    let (a, b) = laid.setting.half;
    let dash = (kind == Kind::Balloon(Shape::Whisper)).then_some((DASH.0 * width, DASH.1 * width));
    Lines {
        body: shapes::outline(kind, (middle.x, middle.y), (a * width, b * width), laid.tip.map(scaled)),
        text: contours(laid, width, letters),
        half: if kind == Kind::Effect { RING * laid.setting.size } else { LINE } * width,
        dash,
    }
}

/// Draws a word on a page of `width` pixels.
#[must_use]
pub fn draw(laid: &Laid, width: f64, letters: &Letters) -> Patch {
    let Lines { body, text, half: line, dash } = lines(laid, width, letters);
    let points = || body.iter().chain(&text).flatten();
    let area = around(points(), line + 1.0);
    let mut rgba = vec![0; area.width * area.height * 4];
    let filled = |shapes: &[Vec<Point>]| coverage(&contoured(shapes), area);
    let ring = |shapes: &[Vec<Point>], dash: Option<(f64, f64)>| {
        let mut mask = vec![0; area.width * area.height];
        for points in shapes {
            stroke(&mut mask, area, points, line, dash);
        }
        mask
    };
    if laid.word.kind == Kind::Effect {
        lay_over(&mut rgba, &ring(&text, None), laid.word.fill);
    } else {
        lay_over(&mut rgba, &filled(&body), laid.word.fill);
        lay_over(&mut rgba, &ring(&body, dash), laid.word.color);
    }
    lay_over(&mut rgba, &filled(&text), laid.word.color);
    Patch { area, rgba }
}

/// A line of text before it is bent and turned, in pixels from the middle of its word.
pub(in crate::page) struct Row<'a> {
    /// Height of the baseline below the middle.
    pub(in crate::page) baseline: f64,
    /// The letters, each with the place of the pen.
    pub(in crate::page) letters: Vec<(char, f64)>,
    /// The font of them all.
    pub(in crate::page) font: &'a Font,
}

/// The lines of a word on a page of `width` pixels.
pub(in crate::page) fn rows<'a>(laid: &Laid, width: f64, letters: &'a Letters) -> Vec<Row<'a>> {
    let Some(font) = letters.font(&laid.word.font) else { return Vec::new() };
    let setting = &laid.setting;
    let size = setting.size * width;
    let last = setting.lines.len().saturating_sub(1) as f64;
    let row = |(i, (run, length)): (usize, &(Vec<char>, f64))| {
        let mut pen = -length * width / 2.0;
        let baseline = (i as f64 - last / 2.0) * setting.pitch * width + font.capitals * size / 2.0;
        let place = |(at, &letter): (usize, &char)| {
            let here = pen;
            pen += letters.advance(font, letter, run.get(at + 1).copied()) * size;
            (letter, here)
        };
        Row { baseline, letters: run.iter().enumerate().map(place).collect(), font }
    };
    setting.lines.iter().enumerate().map(row).collect()
}

/// The outlines of the letters in pixels.
fn contours(laid: &Laid, width: f64, letters: &Letters) -> Vec<Vec<Point>> {
    let size = laid.setting.size * width;
    let bend = Bend::new(laid, width);
    let mut out = Vec::new();
    for row in rows(laid, width, letters) {
        for (letter, pen) in row.letters {
            for mut points in row.font.outline(letter, 0.08 / size.max(1.0)) {
                for point in &mut points {
                    *point = bend.moved(pen + point.x * size, row.baseline - point.y * size);
                }
                out.push(points);
            }
        }
    }
    out
}

/// The place of a word, and the arc and the turn of an effect around it.
pub(in crate::page) struct Bend {
    middle: (f64, f64),
    /// Radius of the circle that the line lies on; 0 for a straight one.
    radius: f64,
    sin: f64,
    cos: f64,
}

impl Bend {
    /// On a page of `width` pixels.
    pub(in crate::page) fn new(laid: &Laid, width: f64) -> Self {
        let effect = laid.word.kind == Kind::Effect;
        let (sin, cos) = if effect { laid.word.angle.to_radians().sin_cos() } else { (0.0, 1.0) };
        // The whole line covers a third of the circle at most.
        let turn = laid.word.arc * std::f64::consts::FRAC_PI_3;
        let radius = if effect && turn.abs() > 0.02 { laid.setting.half.0 * width / turn } else { 0.0 };
        Self { middle: (laid.middle.x * width, laid.middle.y * width), radius, sin, cos }
    }

    /// Whether the line is bent.
    pub(in crate::page) fn is_arc(&self) -> bool {
        self.radius != 0.0
    }

    /// The same without the arc.
    pub(in crate::page) fn straightened(&self) -> Self {
        Self { radius: 0.0, ..*self }
    }

    /// The place on the page of what is at `(x, y)` from the middle of the straight line.
    pub(in crate::page) fn moved(&self, x: f64, y: f64) -> Point {
        let (mut x, mut y) = (x, y);
        if self.radius != 0.0 {
            // The bow's middle stays in the middle of the word.
            let rise =
                self.radius * (1.0 - (self.radius.signum() * std::f64::consts::FRAC_PI_3 / 2.0).cos()) * 0.25;
            let (sin, cos) = (x / self.radius).sin_cos();
            (x, y) = ((self.radius - y) * sin, self.radius - (self.radius - y) * cos - rise);
        }
        let (x, y) = (x * self.cos - y * self.sin, x * self.sin + y * self.cos);
        Point::new(self.middle.0 + x, self.middle.1 + y)
    }
}

/// Outer lines run clockwise on the screen, as the fonts and the shapes have them; what runs the other way is a hole.
fn contoured(shapes: &[Vec<Point>]) -> Vec<Contour> {
    let contour = |points: &Vec<Point>| {
        let next = points.iter().cycle().skip(1);
        let doubled: f64 = points.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum();
        Contour { points: points.clone(), adds: doubled > 0.0 }
    };
    shapes.iter().map(contour).collect()
}

fn around<'p>(points: impl Iterator<Item = &'p Point>, room: f64) -> PixelRect {
    let (mut low, mut high) = ((f64::MAX, f64::MAX), (f64::MIN, f64::MIN));
    for point in points {
        low = (low.0.min(point.x), low.1.min(point.y));
        high = (high.0.max(point.x), high.1.max(point.y));
    }
    if low.0 > high.0 {
        return PixelRect { x: 0, y: 0, width: 1, height: 1 };
    }
    PixelRect::around(Bounds { x: low.0, y: low.1, width: high.0 - low.0, height: high.1 - low.1 }, room)
}

/// Covers a line around a closed shape, with round corners; `dash` gives the lengths of strokes and gaps.
fn stroke(mask: &mut [u8], area: PixelRect, points: &[Point], radius: f64, dash: Option<(f64, f64)>) {
    let mut walked = 0.0;
    for (i, &from) in points.iter().enumerate() {
        let to = points[(i + 1) % points.len()];
        let length = from.distance(to);
        let Some((on, off)) = dash else {
            capsule(mask, area, (from, to), radius);
            continue;
        };
        let mut at = 0.0;
        while at < length {
            let phase = (walked + at) % (on + off);
            let step = if phase < on { on - phase } else { on + off - phase };
            let end = (at + step.max(0.01)).min(length);
            if phase < on {
                capsule(mask, area, (from.toward(to, at / length), from.toward(to, end / length)), radius);
            }
            at = end;
        }
        walked += length;
    }
}

/// Covers what is nearer than `radius` to a segment. What is covered more already stays.
fn capsule(mask: &mut [u8], area: PixelRect, (from, to): (Point, Point), radius: f64) {
    let (x0, y0) = (from.x - area.x as f64, from.y - area.y as f64);
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let squared = (dx * dx + dy * dy).max(1e-12);
    let reach = radius + 1.0;
    let span = |start: f64, step: f64, most: usize| {
        let low = (start.min(start + step) - reach).max(0.0) as usize;
        low.min(most)..((start.max(start + step) + reach).max(0.0) as usize + 1).min(most)
    };
    // A line thinner than a pixel is faint.
    let most = (2.0 * radius).min(1.0);
    for y in span(y0, dy, area.height) {
        for x in span(x0, dx, area.width) {
            let (px, py) = (x as f64 + 0.5 - x0, y as f64 + 0.5 - y0);
            let along = ((px * dx + py * dy) / squared).clamp(0.0, 1.0);
            let distance = ((px - along * dx).powi(2) + (py - along * dy).powi(2)).sqrt();
            let covered = ((radius + 0.5 - distance).clamp(0.0, most) * 255.0 + 0.5) as u8;
            let pixel = &mut mask[y * area.width + x];
            *pixel = (*pixel).max(covered);
        }
    }
}
