//! The subject of a photo inside a panel: the area that a text item would cover at any position.
//!
//! A mask marks the pixels of the subject. A summed-area table holds the sum of all pixels above and left of
//! each corner. Four look-ups give the subject area in any box. Pixels on the border of the box count in
//! proportion.
//!
//! Source: Franklin Crow, "Summed-area tables for texture mapping" (1984).

use super::center;
use crate::layout::Bounds;
use crate::raster::Matte;

/// Bands of a balloon from top to bottom, each a fifth of its height. Values are widths relative to its
/// width, for a superellipse with the exponent 2.4 at the middle of the band.
const BANDS: [f64; 5] = [0.693, 0.952, 1.0, 0.952, 0.693];

/// The subject of a photo on the page. Lengths are in page widths.
#[derive(Debug, Clone)]
pub(super) struct Figure {
    /// Pixels of the mask, across and down.
    size: (usize, usize),
    /// Number of subject pixels above and left of each corner, row by row. There is one more corner than
    /// pixels per side.
    sums: Vec<u32>,
    /// The photo without cropping.
    photo: Bounds,
    /// Bounds of its panel on the page.
    panel: Bounds,
    /// The area of the subject there.
    pub(super) area: f64,
    /// Whether it is a person or an animal.
    pub(super) alive: bool,
}

impl Figure {
    /// Returns the subject of a photo in a panel, if the full photo would cover `photo`. `None` if the mask
    /// is vague, or if the panel shows nothing of the subject.
    pub(super) fn of(mask: &Matte, photo: Bounds, panel: Bounds) -> Option<Self> {
        if mask.facts().is_vague() {
            return None;
        }
        let (within, width) = mask.within();
        let height = within.len() / width.max(1);
        let mut sums = vec![0; (width + 1) * (height + 1)];
        for y in 0..height {
            let mut row = 0;
            for x in 0..width {
                row += u32::from(within[y * width + x]);
                sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + row;
            }
        }
        let mut figure = Self { size: (width, height), sums, photo, panel, area: 0.0, alive: false };
        figure.area = figure.inside(panel);
        (figure.area > 0.0).then_some(figure)
    }

    /// Returns the visible area of the subject in a box.
    pub(super) fn inside(&self, area: Bounds) -> f64 {
        let Self { photo, panel, .. } = self;
        let left = area.x.max(panel.x);
        let top = area.y.max(panel.y);
        let right = (area.x + area.width).min(panel.x + panel.width);
        let bottom = (area.y + area.height).min(panel.y + panel.height);
        if right <= left || bottom <= top {
            return 0.0;
        }
        let (across, down) = (self.size.0 as f64 / photo.width, self.size.1 as f64 / photo.height);
        let [left, right] = [left, right].map(|x| (x - photo.x) * across);
        let [top, bottom] = [top, bottom].map(|y| (y - photo.y) * down);
        let pixels = self.before(right, bottom) - self.before(left, bottom) - self.before(right, top)
            + self.before(left, top);
        // Ignore rounding errors.
        if pixels < 1e-6 { 0.0 } else { pixels / across / down }
    }

    /// Returns the area of the subject below a text item. `round`: a balloon, whose corners are free.
    pub(super) fn under(&self, area: Bounds, round: bool) -> f64 {
        if !round {
            return self.inside(area);
        }
        let (middle, height) = (center(area).x, area.height / BANDS.len() as f64);
        let band = |(i, part): (usize, &f64)| {
            let width = part * area.width;
            let (x, y) = (middle - width / 2.0, area.y + i as f64 * height);
            self.inside(Bounds { x, y, width, height })
        };
        BANDS.iter().enumerate().map(band).sum()
    }

    /// How many pixels are above and left of a point of the mask. The sums are linear along either side of a pixel.
    fn before(&self, x: f64, y: f64) -> f64 {
        let (width, height) = self.size;
        let (x, y) = (x.clamp(0.0, width as f64), y.clamp(0.0, height as f64));
        let (column, row) = ((x as usize).min(width - 1), (y as usize).min(height - 1));
        let (right, low) = (x - column as f64, y - row as f64);
        let sum = |x: usize, y: usize| f64::from(self.sums[y * (width + 1) + x]);
        let between = |row: usize| {
            let (near, far) = (sum(column, row), sum(column + 1, row));
            near + right * (far - near)
        };
        let (upper, lower) = (between(row), between(row + 1));
        upper + low * (lower - upper)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    const WIDTH: usize = 60;
    const HEIGHT: usize = 40;

    fn is_figure(x: usize, y: usize) -> bool {
        let disc = (x as f64 - 20.0).hypot(y as f64 - 15.0) < 11.0;
        disc || (35..50).contains(&x) && y > 12 && (x + y) % 7 > 1
    }

    fn mask() -> Matte {
        Matte::new(
            &Plane::from_fn(WIDTH, HEIGHT, |x, y| if is_figure(x, y) { 255 } else { 0 }),
            (WIDTH, HEIGHT),
        )
    }

    /// A pixel of the mask is .01 wide and .02 high here.
    const PHOTO: Bounds = Bounds { x: 0.2, y: 0.1, width: 0.6, height: 0.8 };
    const PIXEL: f64 = 0.01 * 0.02;

    /// Counts the pixels of the mask whose middle is in a shape on the page.
    fn counted(shape: impl Fn(f64, f64) -> bool) -> f64 {
        // Each pixel by 10 x 10 places in it.
        let mut sum = 0;
        for y in 0..HEIGHT * 10 {
            for x in 0..WIDTH * 10 {
                let at = (PHOTO.x + (x as f64 + 0.5) * 0.001, PHOTO.y + (y as f64 + 0.5) * 0.002);
                sum += usize::from(is_figure(x / 10, y / 10) && shape(at.0, at.1));
            }
        }
        sum as f64 * PIXEL / 100.0
    }

    fn holds(bounds: Bounds) -> impl Fn(f64, f64) -> bool {
        move |x, y| {
            x >= bounds.x && x < bounds.x + bounds.width && y >= bounds.y && y < bounds.y + bounds.height
        }
    }

    /// Boxes inside and outside of the photo, without edges at pixel centres.
    fn boxes() -> Vec<Bounds> {
        let part = |i: usize, k: usize, modulus: usize| ((i * k) % modulus) as f64;
        let place = |i: usize| Bounds {
            x: 0.1 + 0.02 * part(i, 7, 37) + 0.0038,
            y: 0.04 * part(i, 11, 23) + 0.0031,
            width: 0.013 + 0.03 * part(i, 5, 13),
            height: 0.017 + 0.04 * part(i, 3, 11),
        };
        (0..120).map(place).collect()
    }

    #[test]
    fn the_area_in_a_box_is_what_counting_gives() {
        let figure = Figure::of(&mask(), PHOTO, PHOTO).unwrap();
        assert!((figure.area - counted(|_, _| true)).abs() < 1e-9, "{}", figure.area);
        let mut some = 0;
        for area in boxes() {
            let (found, expected) = (figure.inside(area), counted(holds(area)));
            // Counting is as fine as a tenth of a pixel along each edge.
            let fine = 0.0005 * area.height * 2.0 + 0.001 * area.width * 2.0 + 1e-9;
            assert!((found - expected).abs() <= fine, "{found}, not {expected}: {area:?}");
            some += usize::from(expected > 0.0);
        }
        assert!(some > 60, "{some} boxes hold some of the figure");
    }

    #[test]
    fn a_panel_shows_what_is_in_it() {
        let panel = Bounds { x: 0.305, y: 0.205, width: 0.25, height: 0.3 };
        let figure = Figure::of(&mask(), PHOTO, panel).unwrap();
        let whole = Figure::of(&mask(), PHOTO, PHOTO).unwrap();
        assert!((figure.area - whole.inside(panel)).abs() < 1e-12);
        for area in boxes() {
            let expected = counted(|x, y| holds(panel)(x, y) && holds(area)(x, y));
            assert!((figure.inside(area) - expected).abs() < 0.002, "{area:?}");
        }
        let beside = Bounds { x: 0.72, y: 0.1, width: 0.08, height: 0.8 };
        assert!(Figure::of(&mask(), PHOTO, beside).is_none(), "the panel shows none of it");
    }

    #[test]
    fn a_balloon_covers_what_is_in_its_oval() {
        let figure = Figure::of(&mask(), PHOTO, PHOTO).unwrap();
        for area in boxes().into_iter().filter(|area| area.width > 0.08 && area.height > 0.08) {
            let middle = center(area);
            let inside = |x: f64, y: f64| {
                let (x, y) = ((x - middle.x) * 2.0 / area.width, (y - middle.y) * 2.0 / area.height);
                x.abs().powf(2.4) + y.abs().powf(2.4) < 1.0
            };
            let (found, expected) = (figure.under(area, true), counted(inside));
            assert!(
                (found - expected).abs() < 0.06 * area.width * area.height,
                "{found}, not {expected}: {area:?}"
            );
            assert!(found <= figure.under(area, false) + 1e-12);
        }
    }

    #[test]
    fn a_vague_mask_is_none() {
        let of = |shares: Plane| Figure::of(&Matte::new(&shares, (WIDTH, HEIGHT)), PHOTO, PHOTO);
        assert!(of(Plane::filled(WIDTH, HEIGHT, 0)).is_none());
        assert!(of(Plane::from_fn(WIDTH, HEIGHT, |x, y| if x + y == 0 { 255 } else { 0 })).is_none());
        assert!(of(Plane::from_fn(WIDTH, HEIGHT, |x, _| (x * 4) as u8)).is_none());
        assert!(of(Plane::filled(WIDTH, HEIGHT, 255)).is_some());
    }
}
