//! A word as pixels: a patch of straight-alpha RGBA that lies on the panels.

use super::layout::{Ground, Laid, lay_all};
use super::letters::Letters;
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

/// Draws a word on a page of `width` pixels.
#[must_use]
pub fn draw(laid: &Laid, width: f64, letters: &Letters) -> Patch {
    let kind = laid.word.kind;
    let scaled = |point: Point| Point::new(point.x * width, point.y * width);
    let middle = scaled(laid.middle);
    let (a, b) = laid.setting.half;
    let body = shapes::outline(kind, (middle.x, middle.y), (a * width, b * width), laid.tip.map(scaled));
    let text = contours(laid, width, letters);
    let line = if kind == Kind::Effect { RING * laid.setting.size } else { LINE } * width;
    let points = || body.iter().chain(&text).flatten();
    let area = around(points(), line + 1.0);
    let mut rgba = vec![0; area.width * area.height * 4];
    let filled = |shapes: &[Vec<Point>]| coverage(&contoured(shapes), area);
    let ring = |shapes: &[Vec<Point>], radius: f64, dash: Option<(f64, f64)>| {
        let mut mask = vec![0; area.width * area.height];
        for points in shapes {
            stroke(&mut mask, area, points, radius, dash);
        }
        mask
    };
    if kind == Kind::Effect {
        lay_over(&mut rgba, &ring(&text, line, None), laid.word.fill);
    } else {
        let dash = (kind == Kind::Balloon(Shape::Whisper)).then_some((DASH.0 * width, DASH.1 * width));
        lay_over(&mut rgba, &filled(&body), laid.word.fill);
        lay_over(&mut rgba, &ring(&body, line, dash), laid.word.color);
    }
    lay_over(&mut rgba, &filled(&text), laid.word.color);
    Patch { area, rgba }
}

/// The outlines of the letters in pixels.
fn contours(laid: &Laid, width: f64, letters: &Letters) -> Vec<Vec<Point>> {
    let Some(font) = letters.font(&laid.word.font) else { return Vec::new() };
    let setting = &laid.setting;
    let size = setting.size * width;
    let middle = (laid.middle.x * width, laid.middle.y * width);
    let bend = Bend::new(laid, width);
    let last = setting.lines.len().saturating_sub(1) as f64;
    let mut out = Vec::new();
    for (i, (run, length)) in setting.lines.iter().enumerate() {
        let mut pen = -length * width / 2.0;
        let baseline = (i as f64 - last / 2.0) * setting.pitch * width + font.capitals * size / 2.0;
        for (at, &letter) in run.iter().enumerate() {
            for mut points in font.outline(letter, 0.08 / size.max(1.0)) {
                for point in &mut points {
                    let (x, y) = bend.moved(pen + point.x * size, baseline - point.y * size);
                    *point = Point::new(middle.0 + x, middle.1 + y);
                }
                out.push(points);
            }
            pen += letters.advance(font, letter, run.get(at + 1).copied()) * size;
        }
    }
    out
}

/// The arc and the turn of an effect, around its middle.
struct Bend {
    /// Radius of the circle that the line lies on; 0 for a straight one.
    radius: f64,
    sin: f64,
    cos: f64,
}

impl Bend {
    fn new(laid: &Laid, width: f64) -> Self {
        let effect = laid.word.kind == Kind::Effect;
        let (sin, cos) = if effect { laid.word.angle.to_radians().sin_cos() } else { (0.0, 1.0) };
        // The whole line covers a third of the circle at most.
        let turn = laid.word.arc * std::f64::consts::FRAC_PI_3;
        let radius = if effect && turn.abs() > 0.02 { laid.setting.half.0 * width / turn } else { 0.0 };
        Self { radius, sin, cos }
    }

    fn moved(&self, x: f64, y: f64) -> (f64, f64) {
        let (mut x, mut y) = (x, y);
        if self.radius != 0.0 {
            // The bow's middle stays in the middle of the word.
            let rise =
                self.radius * (1.0 - (self.radius.signum() * std::f64::consts::FRAC_PI_3 / 2.0).cos()) * 0.25;
            let (sin, cos) = (x / self.radius).sin_cos();
            (x, y) = ((self.radius - y) * sin, self.radius - (self.radius - y) * cos - rise);
        }
        (x * self.cos - y * self.sin, x * self.sin + y * self.cos)
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
