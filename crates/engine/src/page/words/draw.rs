//! A text item as pixels: a patch of straight-alpha RGBA above the panels.

use super::balloons::neck;
use super::bidi::Seen;
use super::layout::{Body, Chain, Ground, Laid, lay_all};
use super::letters::{Font, Letters};
use super::model::{Kind, Shape};
use super::ruby;
use super::setting::Setting;
use super::shapes;
use super::vertical;
use crate::error::{Error, Result};
use crate::layout::{Bounds, Point};
use crate::page::Document;
use crate::page::compose::Sheet;
use crate::page::coverage::{Contour, coverage};
use crate::page::patch::{Patch, lay_over};
use crate::page::rect::PixelRect;
use crate::page::scene::MAX_SIDE;

/// Half the width of outlines, in page widths: about half a millimetre in total on A4.
const LINE: f64 = 0.0011;
/// Outline of the glyphs of a caption without a box, in ems.
const HALO: f64 = 0.1;
/// Slant of emphasised glyphs, as a fraction of their height.
pub(in crate::page) const LEAN: f64 = 0.21;
/// Half of the additional stroke width of emphasised glyphs, in ems, for fonts without a bolder style.
const HEAVIER: f64 = 0.016;
/// Lengths of a whisper's dashes and of the gaps between, in page widths.
const DASH: (f64, f64) = (0.0085, 0.007);
/// Distance of ruled lines for handwriting, in ems. Handwriting needs more space than print.
const RULES: f64 = 2.1;
/// Half their width, in page widths.
const RULE: f64 = 0.0003;
/// Outline of the glyphs of a sound effect, in ems.
const RING: f64 = 0.075;

/// Draws one text item of a document whose page is `width` pixels wide.
///
/// # Errors
/// `invalid-document` for a missing or invalid text item; layout errors.
pub fn render(document: &Document, index: usize, width: usize, letters: &Letters) -> Result<Patch> {
    let invalid =
        |location: String, reason: &str| Error::InvalidDocument { location, reason: reason.to_owned() };
    if width == 0 || width as f64 > MAX_SIDE {
        return Err(invalid("page".into(), "cannot be rendered at this size"));
    }
    let missing = || invalid(format!("words[{index}]"), "there is no such word");
    let word = document.words.get(index).ok_or_else(missing)?.effective();
    // Linked balloons are drawn with the first one, which needs all of them.
    if word.id.is_some() || word.hangs_on().is_some() {
        let all = lay_all(document, letters)?;
        return all.get(index).map(|laid| draw(laid, width as f64, letters)).ok_or_else(missing);
    }
    let laid = Ground::new(document)?.lay(word, letters);
    Ok(draw(&laid, width as f64, letters))
}

/// Draws all text items of a document on its sheet, in order.
///
/// # Errors
/// As [`render`].
pub fn lay_words(sheet: &mut Sheet, document: &Document, letters: &Letters) -> Result<()> {
    lay_words_behind(sheet, document, letters, &[])
}

/// Draws all text items of a document on its sheet, in the order of [`drawn_behind`].
///
/// # Errors
/// As [`render`].
pub fn lay_words_behind(
    sheet: &mut Sheet,
    document: &Document,
    letters: &Letters,
    fronts: &[Patch],
) -> Result<()> {
    let width = sheet.width();
    drawn_behind((document, width), letters, fronts, &mut |_, patch| sheet.lay(patch.area, &patch.rgba))
}

/// Draws all text items of a document whose page is `width` pixels wide, and passes each with its index to
/// `give`. Items behind subjects come first, in order. `fronts`: the subjects of the panels that
/// [`Document::fronts`] names, as [`render_panel`](crate::page::compose::render_panel) draws them.
///
/// # Errors
/// As [`render`], and the errors of `give`.
pub fn drawn_behind(
    (document, width): (&Document, usize),
    letters: &Letters,
    fronts: &[Patch],
    give: &mut dyn FnMut(usize, Patch) -> Result<()>,
) -> Result<()> {
    let panels = document.fronts();
    let all = lay_all(document, letters)?;
    let (behind, before): (Vec<_>, Vec<_>) =
        all.iter().enumerate().partition(|(_, laid)| laid.word.front(&panels).is_some());
    for (place, laid) in behind.into_iter().chain(before) {
        let mut patch = draw(laid, width as f64, letters);
        if let Some(front) = laid.word.front(&panels).and_then(|at| fronts.get(at)) {
            patch.stand_behind(front.area, &front.rgba);
        }
        give(place, patch)?;
    }
    Ok(())
}

/// The outlines of a text item on a page of some width, in its pixels.
pub(in crate::page) struct Lines {
    /// Outline of a balloon or a caption; its tail is a part of it, or follows it. Linked balloons share
    /// their outlines.
    pub(in crate::page) body: Vec<Vec<Point>>,
    /// The outlines overlap and are one shape: their lines are drawn below what fills them, twice as wide.
    pub(in crate::page) united: bool,
    /// Outlines of the glyphs.
    pub(in crate::page) text: Vec<Vec<Point>>,
    /// Outlines of bold glyphs, with half the width of the stroke that makes them bold.
    pub(in crate::page) heavy: (Vec<Vec<Point>>, f64),
    /// An outline separates the glyphs from the background, because the item has no body.
    pub(in crate::page) ringed: bool,
    /// Half the width of the outline of the body, or of the glyphs.
    pub(in crate::page) half: f64,
    /// Lengths of dashes and gaps of the line, or `None` for a solid line.
    pub(in crate::page) dash: Option<(f64, f64)>,
}

/// Vector shapes of a text item on a page of `width` pixels.
pub(in crate::page) fn lines(laid: &Laid, width: f64, letters: &Letters) -> Lines {
    let word = &laid.word;
    let ringed = word.kind() == Kind::Effect || word.boxless;
    let outline = |body: &Body| {
        let scaled = |point: Point| Point::new(point.x * width, point.y * width);
        let middle = scaled(body.middle);
        let half = (body.half.0 * width, body.half.1 * width);
        shapes::outline(body.kind, (middle.x, middle.y), half, body.tip.map(scaled))
    };
    let own = || {
        let Laid { middle, tip, setting, .. } = laid;
        outline(&Body { kind: word.kind(), middle: *middle, half: setting.half, tip: *tip })
    };
    if word.plain {
        return plain(laid, width, letters);
    }
    let mut body = if ringed || laid.chain == Chain::Later { Vec::new() } else { own() };
    let united = matches!(laid.chain, Chain::First { .. });
    if let Chain::First { bodies, necks } = &laid.chain {
        body.extend(bodies.iter().flat_map(outline));
        let scaled = |point: Point| Point::new(point.x * width, point.y * width);
        body.extend(necks.iter().map(|tie| neck(scaled(tie.from), scaled(tie.to), tie.half * width)));
    }
    let size = laid.setting.size;
    let half = match word.kind() {
        Kind::Effect => word.outline.unwrap_or(RING) * size,
        _ if word.boxless => HALO * size,
        _ => LINE,
    };
    let dash = (word.kind() == Kind::Balloon(Shape::Whisper)).then_some((DASH.0 * width, DASH.1 * width));
    let (text, heavy) = contours(laid, width, letters);
    let heavy = (heavy, HEAVIER * size * width);
    Lines { body, united, text, heavy, ringed, half: half * width, dash }
}

/// A plain text item: only its glyphs, or ruled lines.
fn plain(laid: &Laid, width: f64, letters: &Letters) -> Lines {
    let Laid { middle, setting, .. } = laid;
    let count =
        if laid.word.ruled { (2.0 * setting.half.1 / (RULES * setting.size)).floor() as usize } else { 0 };
    let rule = |i: usize| {
        let y = (middle.y - setting.half.1 + (i as f64 + 1.0) * RULES * setting.size) * width;
        [-1.0, 1.0].map(|side| Point::new((middle.x + side * setting.half.0) * width, y)).to_vec()
    };
    let body = (0..count).map(rule).collect();
    let (text, heavy) = contours(laid, width, letters);
    let heavy = (heavy, HEAVIER * setting.size * width);
    Lines { body, united: false, text, heavy, ringed: false, half: RULE * width, dash: None }
}

/// Draws a text item on a page of `width` pixels.
#[must_use]
pub fn draw(laid: &Laid, width: f64, letters: &Letters) -> Patch {
    let Lines { body, united, text, heavy, ringed, half: line, dash } = lines(laid, width, letters);
    let points = || body.iter().chain(&text).flatten();
    let area = around(points(), if united { 2.0 * line } else { line } + 1.0);
    let mut rgba = vec![0; area.width * area.height * 4];
    let filled = |shapes: &[Vec<Point>]| coverage(&contoured(shapes), area);
    let ring = |shapes: &[Vec<Point>], line: f64, dash: Option<(f64, f64)>| {
        let mut mask = vec![0; area.width * area.height];
        for points in shapes {
            stroke(&mut mask, area, points, line, dash);
        }
        mask
    };
    if ringed {
        // A line width of 0 draws no outline.
        if line > 0.0 {
            lay_over(&mut rgba, &ring(&text, line, None), laid.fill);
        }
    } else if united {
        lay_over(&mut rgba, &ring(&body, 2.0 * line, dash), laid.color);
        lay_over(&mut rgba, &filled(&body), laid.fill);
    } else {
        lay_over(&mut rgba, &filled(&body), laid.fill);
        lay_over(&mut rgba, &ring(&body, line, dash), laid.color);
    }
    if !heavy.0.is_empty() {
        lay_over(&mut rgba, &ring(&heavy.0, heavy.1, None), laid.color);
    }
    lay_over(&mut rgba, &filled(&text), laid.color);
    Patch { area, rgba }
}

/// Glyphs of one line with the same orientation, before bending and rotation, in pixels from the middle of
/// their text item.
pub(in crate::page) struct Row<'a> {
    /// Distance of the baseline below the middle. For rotated glyphs, its distance to the right.
    pub(in crate::page) baseline: f64,
    /// Whether it runs down, with glyphs rotated by a quarter turn.
    pub(in crate::page) turned: bool,
    /// The characters with their pen positions.
    pub(in crate::page) letters: Vec<(char, f64)>,
    /// Their common font.
    pub(in crate::page) font: &'a Font,
    /// They are emphasised: they lean by [`LEAN`].
    pub(in crate::page) strong: bool,
    /// Whether the glyphs are drawn bolder, if no bold font is available for emphasis.
    pub(in crate::page) heavy: bool,
    /// Their size relative to the text item. Ruby is smaller.
    pub(in crate::page) scale: f64,
}

impl Row<'_> {
    /// Position of a point relative to the centre of the text item: `along` the row and `up` from the
    /// baseline.
    pub(in crate::page) fn at(&self, along: f64, up: f64) -> (f64, f64) {
        if self.turned { (self.baseline + up, along) } else { (along, self.baseline - up) }
    }
}

/// Returns the lines of a text item on a page of `width` pixels, with ruby readings.
pub(in crate::page) fn rows<'a>(laid: &Laid, width: f64, letters: &'a Letters) -> Vec<Row<'a>> {
    let Some(font) = letters.font(laid.word.font()) else { return Vec::new() };
    if laid.word.vertical {
        return columns(laid, width, (letters, font));
    }
    let setting = &laid.setting;
    let size = setting.size * width;
    let last = setting.lines.len().saturating_sub(1) as f64;
    let bold = letters.strong(font);
    // Readings are a part of the first line's height.
    let lift = if setting.readings.is_empty() { 0.0 } else { ruby::THICKER.0 * size };
    let mut rows = Vec::with_capacity(setting.lines.len());
    let texts: Vec<&[char]> = setting.lines.iter().map(|(run, _)| run.as_slice()).collect();
    let lines = letters.ordered(&texts).into_iter().zip(&setting.lines);
    for (i, (run, (_, length))) in lines.enumerate() {
        let marks = setting.strong.get(i).map_or(&[][..], Vec::as_slice);
        let under = setting.under.get(i).map_or(&[][..], Vec::as_slice);
        let (mut pen, first) = if laid.word.plain {
            (-setting.half.0 * width, font.capitals * size - setting.half.1 * width)
        } else {
            (-length * width / 2.0, (font.capitals * size - last * setting.pitch * width) / 2.0)
        };
        let baseline = first + lift / 2.0 + i as f64 * setting.pitch * width;
        // By their places in the text, as are emphasis and readings.
        let mut spans = vec![(0.0, 0.0); if under.is_empty() { 0 } else { run.len() }];
        let mut at = 0;
        while at < run.len() {
            let strong = |at: usize| marks.get(run[at].at).copied().unwrap_or(false);
            let alike = (at..run.len()).take_while(|&i| strong(i) == strong(at)).count();
            let font = if strong(at) { bold } else { font };
            let mut row = Row {
                baseline,
                turned: false,
                letters: Vec::with_capacity(alike),
                font,
                strong: strong(at),
                heavy: strong(at) && font.id() == laid.word.font(),
                scale: 1.0,
            };
            for i in at..at + alike {
                let start = pen;
                let Seen { at, letter } = run[i];
                let apart = under.get(at).map_or(0.0, |under| under.apart * size);
                row.letters.push((letter, pen + apart / 2.0));
                let next = run.get(i + 1).map(|seen| seen.letter);
                pen += letters.advance(font, letter, next) * size + apart;
                if let Some(span) = spans.get_mut(at) {
                    *span = (start, pen);
                }
            }
            rows.push(row);
            at += alike;
        }
        for (reading, (start, end)) in read(setting, i, &spans) {
            let (begin, gap) = ruby::spread(letters, font, reading, false, (end - start) / size);
            let mut pen = start + begin * size;
            let mut row = small(font, baseline - ruby::rise() * size);
            for (at, &letter) in reading.iter().enumerate() {
                row.letters.push((letter, pen));
                let next = reading.get(at + 1).copied();
                pen += (letters.advance(font, letter, next) * ruby::SIZE + gap) * size;
            }
            rows.push(row);
        }
    }
    rows
}

/// A row of a reading.
fn small(font: &Font, baseline: f64) -> Row<'_> {
    let letters = Vec::new();
    Row { baseline, turned: false, letters, font, strong: false, heavy: false, scale: ruby::SIZE }
}

/// The readings over a line, each with the start and end of its base text. `spans` are the spans of all
/// characters.
fn read<'s>(setting: &'s Setting, line: usize, spans: &[(f64, f64)]) -> Vec<(&'s [char], (f64, f64))> {
    let Some(under) = setting.under.get(line).filter(|under| !under.is_empty()) else { return Vec::new() };
    let mut all = Vec::new();
    for run in (0..under.len().min(spans.len()))
        .collect::<Vec<_>>()
        .chunk_by(|&a, &b| under[a].reading == under[b].reading)
    {
        let (Some(&first), Some(&last)) = (run.first(), run.last()) else { continue };
        let number = usize::from(under[first].reading);
        if let Some(reading) = number.checked_sub(1).and_then(|number| setting.readings.get(number)) {
            all.push((
                reading.as_slice(),
                (spans[first].0.min(spans[last].0), spans[first].1.max(spans[last].1)),
            ));
        }
    }
    all
}

/// Returns the cells of the columns of vertical text on a page of `width` pixels, from right to left, with
/// their ruby readings. Emphasised text is bolder and not slanted.
fn columns<'a>(laid: &Laid, width: f64, (letters, font): (&'a Letters, &'a Font)) -> Vec<Row<'a>> {
    let setting = &laid.setting;
    let size = setting.size * width;
    let last = setting.lines.len().saturating_sub(1) as f64;
    let longest = setting.lines.iter().map(|line| line.1).fold(0.0, f64::max);
    let bold = letters.strong(font);
    // Readings are a part of the width of the column at the right.
    let shift = if setting.readings.is_empty() { 0.0 } else { ruby::THICKER.1 * size / 2.0 };
    let mut rows = Vec::new();
    for (i, (run, length)) in setting.lines.iter().enumerate() {
        let across = (last / 2.0 - i as f64) * setting.pitch * width - shift;
        let start = -if setting.flush { longest } else { *length } * width / 2.0;
        let strong =
            |at: usize| setting.strong.get(i).and_then(|marks| marks.get(at)).copied().unwrap_or(false);
        let apart = |at: usize| {
            setting.under.get(i).and_then(|under| under.get(at)).map_or(0.0, |under| under.apart * size)
        };
        let column = Column { letters, across, start, size };
        let spans = column.stand(
            run,
            &apart,
            |at| {
                let font = if strong(at) { bold } else { font };
                Row { heavy: strong(at) && font.id() == laid.word.font(), scale: 1.0, ..small(font, 0.0) }
            },
            font,
            &mut rows,
        );
        for (reading, (from, to)) in read(setting, i, &spans) {
            let (begin, gap) = ruby::spread(letters, font, reading, true, (to - from) / size);
            let beside = Column {
                across: across + ruby::aside() * size,
                // Half of the extra space is before the first character.
                start: from + (begin - gap / 2.0) * size,
                size: size * ruby::SIZE,
                ..column
            };
            beside.stand(reading, &|_| gap * size, |_| small(font, 0.0), font, &mut rows);
        }
    }
    rows
}

/// A column of characters, in pixels.
#[derive(Clone, Copy)]
struct Column<'a> {
    letters: &'a Letters,
    /// Its middle.
    across: f64,
    /// Its top.
    start: f64,
    /// Height of an em.
    size: f64,
}

impl<'a> Column<'a> {
    /// Adds the rows of a column, and returns the start and end of each character. `apart`: extra advance of
    /// each character, half of it before the character. `row` returns the other fields of the row that begins
    /// with a character.
    fn stand(
        &self,
        run: &[char],
        apart: &dyn Fn(usize) -> f64,
        row: impl Fn(usize) -> Row<'a>,
        font: &Font,
        rows: &mut Vec<Row<'a>>,
    ) -> Vec<(f64, f64)> {
        let Self { letters, across, start, size } = *self;
        let mut spans = Vec::with_capacity(run.len());
        let mut down = start;
        for cell in vertical::cells(letters, font, run) {
            let part = &run[cell.start..cell.end];
            let mut row = row(cell.start);
            let font = row.font;
            let wide = letters.width(font, part) * size;
            row.turned = cell.turned;
            if cell.turned {
                row.baseline = across - cell.middle * size;
                for (at, &letter) in part.iter().enumerate() {
                    let (top, more) = (down, apart(cell.start + at));
                    row.letters.push((letter, down + more / 2.0));
                    down += letters.advance(font, letter, part.get(at + 1).copied()) * size + more;
                    spans.push((top, down));
                }
                rows.push(row);
                continue;
            }
            let more: f64 = (cell.start..cell.end).map(apart).sum();
            row.baseline = down + more / 2.0 + (vertical::BASELINE - cell.off.1) * size;
            if let Some(form) = cell.form {
                row.letters.push((form, across - size / 2.0));
            } else {
                let mut pen = across - wide / 2.0 + cell.off.0 * size;
                for (at, &letter) in part.iter().enumerate() {
                    row.letters.push((letter, pen));
                    pen += letters.advance(font, letter, part.get(at + 1).copied()) * size;
                }
            }
            let end = down + cell.length * size + more;
            spans.extend(part.iter().map(|_| (down, end)));
            down = end;
            rows.push(row);
        }
        spans
    }
}

/// The outlines of all glyphs in pixels, and the outlines of bolder glyphs separately.
fn contours(laid: &Laid, width: f64, letters: &Letters) -> (Vec<Vec<Point>>, Vec<Vec<Point>>) {
    let size = laid.setting.size * width;
    let bend = Bend::new(laid, width);
    let (mut out, mut heavy) = (Vec::new(), Vec::new());
    for row in rows(laid, width, letters) {
        let size = size * row.scale;
        let lean = if row.strong { LEAN } else { 0.0 };
        for &(letter, pen) in &row.letters {
            for mut points in row.font.outline(letter, 0.08 / size.max(1.0)) {
                for point in &mut points {
                    let (x, y) = row.at(pen + (point.x + lean * point.y) * size, point.y * size);
                    *point = bend.moved(x, y);
                }
                if row.heavy {
                    heavy.push(points.clone());
                }
                out.push(points);
            }
        }
    }
    (out, heavy)
}

/// Bounds of the visible glyphs of a text item on a page of `width` pixels: scale, then left, top, right and
/// bottom.
#[must_use]
pub fn boxes(laid: &Laid, width: f64, letters: &Letters) -> Vec<(f64, (f64, f64, f64, f64))> {
    let bend = Bend::new(laid, width);
    let mut boxes = Vec::new();
    for row in rows(laid, width, letters) {
        let size = laid.setting.size * width * row.scale;
        for &(letter, pen) in &row.letters {
            let points = row.font.outline(letter, 0.01).concat();
            let around = points.iter().map(|point| row.at(pen + point.x * size, point.y * size));
            let around = around.map(|(x, y)| bend.moved(x, y)).fold(None, |around, at| {
                let (left, top, right, bottom) = around.unwrap_or((at.x, at.y, at.x, at.y));
                Some((left.min(at.x), top.min(at.y), right.max(at.x), bottom.max(at.y)))
            });
            boxes.extend(around.map(|around| (row.scale, around)));
        }
    }
    boxes
}

/// The position of a text item, with arc and rotation of a sound effect.
pub(in crate::page) struct Bend {
    middle: (f64, f64),
    /// Radius of the circle of the baseline; 0 for a straight line.
    radius: f64,
    sin: f64,
    cos: f64,
    /// Slant of the glyphs, as a fraction of their height.
    slant: f64,
}

impl Bend {
    /// On a page of `width` pixels.
    pub(in crate::page) fn new(laid: &Laid, width: f64) -> Self {
        let effect = laid.word.kind() == Kind::Effect;
        let (sin, cos) = if effect { laid.word.angle.to_radians().sin_cos() } else { (0.0, 1.0) };
        // The line covers a third of the circle at most.
        let turn = laid.word.arc * std::f64::consts::FRAC_PI_3;
        let radius = if effect && turn.abs() > 0.02 && !laid.word.vertical {
            laid.setting.half.0 * width / turn
        } else {
            0.0
        };
        let slant = if effect { laid.word.slant.to_radians().tan() } else { 0.0 };
        Self { middle: (laid.middle.x * width, laid.middle.y * width), radius, sin, cos, slant }
    }

    /// Whether the line is bent.
    pub(in crate::page) fn is_arc(&self) -> bool {
        self.radius != 0.0
    }

    /// The same without the arc.
    pub(in crate::page) fn straightened(&self) -> Self {
        Self { radius: 0.0, ..*self }
    }

    /// Position on the page of the point `(x, y)` relative to the centre of the straight line.
    pub(in crate::page) fn moved(&self, x: f64, y: f64) -> Point {
        let (mut x, mut y) = (x - self.slant * y, y);
        if self.radius != 0.0 {
            // The middle of the arc stays in the middle of the text item.
            let rise =
                self.radius * (1.0 - (self.radius.signum() * std::f64::consts::FRAC_PI_3 / 2.0).cos()) * 0.25;
            let (sin, cos) = (x / self.radius).sin_cos();
            (x, y) = ((self.radius - y) * sin, self.radius - (self.radius - y) * cos - rise);
        }
        let (x, y) = (x * self.cos - y * self.sin, x * self.sin + y * self.cos);
        Point::new(self.middle.0 + x, self.middle.1 + y)
    }
}

/// Outer contours are clockwise on the screen, in fonts and in shapes. Counter-clockwise contours are holes.
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

/// Covers the pixels within `radius` of a segment. A higher existing coverage stays.
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
