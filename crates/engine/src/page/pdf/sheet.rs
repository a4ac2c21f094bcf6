//! A side of a sheet of paper with its pages: its size and all positions. By default lengths are in points of
//! 1/72 inch, from the upper left corner of the trimmed area.

use super::Leaf;
use super::impose::{Imposition, Side};
use super::options::Options;
use crate::page::document::Document;

/// Points an inch, and a millimetre.
pub(super) const INCH: f64 = 72.0;
const MILLIMETRE: f64 = INCH / 25.4;
/// Longest side that readers of PDF files take, in units.
const LONGEST: f64 = 14_400.0;
/// Minimum distance of a crop mark from the trim edge, and its length.
pub(super) const MARK: (f64, f64) = (3.0 * MILLIMETRE, 5.0 * MILLIMETRE);
/// Beyond the marks.
const RIM: f64 = 1.0 * MILLIMETRE;

/// A page in its place.
pub(super) struct Cell {
    /// Its number among the leaves.
    pub(super) leaf: usize,
    /// Its upper left corner on the sheet.
    place: (f64, f64),
    /// Its size.
    size: (f64, f64),
    /// Whether the page is upside down.
    turned: bool,
    /// Points a pixel.
    scale: f64,
    /// Pixels that are drawn beyond each of its sides: left, top, right, bottom.
    pub(super) room: [f64; 4],
}

/// A side of a sheet.
pub(super) struct Sheet {
    pub(super) cells: Vec<Cell>,
    /// Width and height after cutting.
    pub(super) size: (f64, f64),
    /// How far art reaches beyond.
    pub(super) bleed: f64,
    /// Columns and rows of pages.
    pub(super) grid: (usize, usize),
    /// Width and height of the paper.
    media: (f64, f64),
    /// Scale of the page on the paper.
    fit: f64,
    /// Points that a unit of this page is worth.
    pub(super) unit: f64,
}

/// Width and height of a page.
fn size_of(document: &Document) -> (f64, f64) {
    let scale = scale_of(document);
    (f64::from(document.page.width) * scale, f64::from(document.page.height) * scale)
}

fn scale_of(document: &Document) -> f64 {
    INCH / f64::from(document.page.dpi.max(1))
}

fn bleed_of(document: &Document) -> f64 {
    document.page.bleed * size_of(document).0
}

impl Sheet {
    pub(super) fn new(side: &Side, leaves: &[Leaf], options: &Options) -> Self {
        let there = |number: usize| leaves.get(number).map(|leaf| &leaf.document);
        let seats = || side.iter().flatten().filter_map(|&(number, _)| there(number));
        // A sheet of a book is as large as its others, whatever is on it.
        let all = || leaves.iter().map(|leaf| &leaf.document);
        let most = |of: &dyn Fn(&Document) -> f64| match options.imposition {
            None => seats().map(of).fold(0.0, f64::max),
            Some(_) => all().map(of).fold(0.0, f64::max),
        };
        let cell = (most(&|document| size_of(document).0), most(&|document| size_of(document).1));
        let bleed = most(&bleed_of);
        let grid = (side.first().map_or(0, Vec::len), side.len());
        let mut cells = Vec::new();
        for (row, seats) in side.iter().enumerate() {
            for (column, &(leaf, turned)) in seats.iter().enumerate() {
                let Some(document) = there(leaf) else { continue };
                let (size, scale) = (size_of(document), scale_of(document));
                let place = (
                    column as f64 * cell.0 + (cell.0 - size.0) / 2.0,
                    row as f64 * cell.1 + (cell.1 - size.1) / 2.0,
                );
                // Adjacent pages have no bleed between them.
                let outside = [column == 0, row == 0, column + 1 == grid.0, row + 1 == grid.1];
                let mut room = outside.map(|free| if free { bleed_of(document) / scale } else { 0.0 });
                if turned {
                    room.rotate_left(2);
                }
                cells.push(Cell { leaf, place, size, turned, scale, room });
            }
        }
        let size = (cell.0 * grid.0 as f64, cell.1 * grid.1 as f64);
        let rim = if options.marks { bleed.max(MARK.0) + MARK.1 + RIM } else { bleed };
        let own = (size.0 + 2.0 * rim, size.1 + 2.0 * rim);
        let (media, fit) = match options.paper {
            None => (own, 1.0),
            Some(paper) => fitted(own, paper),
        };
        let unit = (media.0.max(media.1) / LONGEST).ceil().max(1.0);
        Self { cells, size, bleed, grid, media, fit, unit }
    }

    /// From points of the sheet to units of the PDF page, whose origin is the lower left corner.
    pub(super) fn matrix(&self) -> [f32; 6] {
        let scale = self.fit / self.unit;
        let (left, top) = self.corner();
        [scale, 0.0, 0.0, -scale, left, top].map(|value| value as f32)
    }

    /// The upper left corner of the trimmed area, in units.
    fn corner(&self) -> (f64, f64) {
        let rest = |paper: f64, own: f64| (paper - own * self.fit) / 2.0;
        let (left, above) = (rest(self.media.0, self.size.0), rest(self.media.1, self.size.1));
        (left / self.unit, (self.media.1 - above) / self.unit)
    }

    /// From pixels of a page in its place to units.
    pub(super) fn matrix_of(&self, cell: &Cell) -> [f32; 6] {
        let scale = self.fit / self.unit;
        let (left, top) = self.corner();
        let (x, y) = (left + cell.place.0 * scale, top - cell.place.1 * scale);
        let pixel = cell.scale * scale;
        let matrix = if cell.turned {
            let (width, height) = (cell.size.0 * scale, cell.size.1 * scale);
            [-pixel, 0.0, 0.0, pixel, x + width, y - height]
        } else {
            [pixel, 0.0, 0.0, -pixel, x, y]
        };
        matrix.map(|value| value as f32)
    }

    /// The paper in units.
    pub(super) fn media_box(&self) -> pdf_writer::Rect {
        let [width, height] = [self.media.0, self.media.1].map(|length| (length / self.unit) as f32);
        pdf_writer::Rect::new(0.0, 0.0, width, height)
    }

    /// The trimmed area, extended by `more` points on each side, in units.
    pub(super) fn inner_box(&self, more: f64) -> pdf_writer::Rect {
        let (left, top) = self.corner();
        let scale = self.fit / self.unit;
        let more = more * scale;
        let (right, bottom) = (left + self.size.0 * scale + more, top - self.size.1 * scale - more);
        // Numbers are rounded, so boxes are limited to the paper.
        let [x, y, width, height] =
            [left - more, bottom, right, top + more].map(|value| ((value * 1e4).round() / 1e4) as f32);
        let media = self.media_box();
        pdf_writer::Rect::new(x.max(0.0) + 0.0, y.max(0.0) + 0.0, width.min(media.x2), height.min(media.y2))
    }

    /// Fold and cut lines inside the sheet: their end points, and whether they are cuts.
    pub(super) fn lines(&self, how: Option<Imposition>) -> (Vec<[(f64, f64); 2]>, bool) {
        let (width, height) = self.size;
        let (columns, rows) = self.grid;
        let down = (1..columns).map(|i| width * i as f64 / columns as f64).map(|x| [(x, 0.0), (x, height)]);
        let across = (1..rows).map(|i| height * i as f64 / rows as f64).map(|y| [(0.0, y), (width, y)]);
        (down.chain(across).collect(), how == Some(Imposition::TwoUp))
    }
}

/// The paper in the orientation of its content, and the scale of the content.
fn fitted(own: (f64, f64), paper: [f64; 2]) -> ((f64, f64), f64) {
    let [short, long] = {
        let mut sides = paper.map(|side| side.clamp(20.0, 5_000.0) * MILLIMETRE);
        sides.sort_by(f64::total_cmp);
        sides
    };
    let media = if own.0 > own.1 { (long, short) } else { (short, long) };
    (media, (media.0 / own.0).min(media.1 / own.1))
}
