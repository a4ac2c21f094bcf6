//! Palettes, and the distance of each colour of a picture from their colours.

use crate::order::sort_by_key;
use crate::raster::Image;
use std::sync::OnceLock;

/// The palettes; the first is taken from the photo, the last is defined by parameters.
pub(super) const NAMES: &[&str] =
    &["photo", "comic", "gouache", "pastel", "retro", "earth", "night", "sunset", "poster", "own"];

/// Index of the palette "own".
pub(super) const OWN: usize = 9;

/// Colours of the named palettes, dark to light.
fn named(choice: usize) -> &'static [[u8; 3]] {
    match choice {
        1 => &[
            [24, 22, 34],
            [46, 58, 110],
            [44, 120, 180],
            [120, 190, 220],
            [196, 40, 44],
            [230, 110, 50],
            [248, 200, 60],
            [60, 130, 80],
            [130, 180, 90],
            [120, 76, 54],
            [198, 146, 106],
            [242, 206, 170],
            [128, 128, 136],
            [206, 204, 200],
            [252, 248, 238],
        ],
        2 => &[
            [38, 40, 52],
            [70, 84, 96],
            [104, 128, 128],
            [150, 168, 158],
            [110, 66, 58],
            [168, 94, 72],
            [206, 142, 100],
            [226, 184, 138],
            [92, 96, 60],
            [146, 148, 92],
            [196, 190, 140],
            [62, 92, 130],
            [130, 158, 184],
            [232, 220, 196],
            [248, 242, 228],
        ],
        3 => &[
            [88, 84, 112],
            [134, 124, 160],
            [178, 164, 200],
            [214, 202, 230],
            [226, 150, 160],
            [244, 186, 186],
            [250, 214, 204],
            [150, 190, 186],
            [186, 218, 206],
            [222, 236, 220],
            [240, 214, 154],
            [252, 236, 194],
            [150, 178, 214],
            [190, 210, 234],
            [255, 250, 244],
        ],
        4 => &[
            [42, 34, 38],
            [84, 58, 50],
            [146, 62, 44],
            [206, 96, 48],
            [232, 154, 68],
            [242, 206, 128],
            [36, 84, 92],
            [62, 136, 132],
            [142, 180, 156],
            [250, 238, 208],
        ],
        5 => &[
            [36, 30, 26],
            [68, 54, 42],
            [108, 82, 58],
            [148, 116, 80],
            [188, 158, 116],
            [218, 198, 160],
            [80, 84, 60],
            [122, 124, 88],
            [146, 74, 48],
            [242, 232, 210],
        ],
        6 => &[
            [10, 14, 30],
            [22, 32, 60],
            [38, 56, 96],
            [58, 88, 134],
            [92, 128, 168],
            [146, 176, 200],
            [60, 40, 70],
            [118, 72, 88],
            [222, 158, 82],
            [248, 224, 156],
        ],
        7 => &[
            [34, 20, 48],
            [74, 32, 78],
            [128, 44, 92],
            [188, 62, 84],
            [228, 98, 74],
            [246, 146, 78],
            [252, 196, 106],
            [255, 236, 180],
        ],
        _ => &[[18, 18, 22], [206, 38, 38], [240, 190, 50], [30, 86, 140], [250, 244, 226]],
    }
}

/// Cells of each channel in the table of costs.
pub(crate) const CELLS: usize = 32;

/// Rounds of k-means.
const ROUNDS: usize = 14;

/// Units of a distance: of 1 in Oklab.
const UNIT: f32 = 8192.0;

/// The distance of every colour to each of a palette.
pub(super) struct Costs {
    palette: Vec<[u8; 3]>,
    /// For each of 32 x 32 x 32 cells, its index among the photo's cells.
    places: Vec<u16>,
    /// For each of these, the distance to each colour.
    table: Vec<u16>,
    /// For each of these, the nearest colour.
    nearest: Vec<u8>,
}

impl Costs {
    /// The costs of a palette for the colours of a picture; of the photo's own colours there are `count`, of a named one at
    /// most as many. `sample` is the picture at a size that does not change with the render, so that a preview and its
    /// print have one palette.
    pub(super) fn new(picture: &Image, sample: &Image, choice: usize, count: usize) -> Self {
        let counts = histogram(sample);
        let cells = cells();
        let palette = if choice == 0 {
            means(&counts, cells, count)
        } else {
            wanted(&counts, cells, named(choice), count)
        };
        Self::of_palette(picture, palette)
    }

    /// The costs of these colours, at least one.
    pub(super) fn of_palette(picture: &Image, palette: Vec<[u8; 3]>) -> Self {
        let seen = seen(picture);
        let cells = cells();
        let points: Vec<[f32; 3]> = palette.iter().map(|&color| oklab(color.map(f32::from))).collect();
        let mut costs =
            Self { places: vec![0; cells.len()], table: Vec::new(), nearest: Vec::new(), palette };
        for (cell, &point) in cells.iter().enumerate().filter(|&(cell, _)| seen[cell]) {
            costs.places[cell] = costs.nearest.len() as u16;
            let start = costs.table.len();
            costs.table.extend(points.iter().map(|&own| (distance(point, own).sqrt() * UNIT) as u16));
            let best = costs.table[start..].iter().enumerate().min_by_key(|&(_, &cost)| cost);
            costs.nearest.push(best.map_or(0, |(i, _)| i as u8));
        }
        costs
    }

    pub(super) fn palette(&self) -> &[[u8; 3]] {
        &self.palette
    }

    /// The distances of a colour to each of the palette's.
    #[inline]
    pub(super) fn of(&self, rgb: [u8; 3]) -> &[u16] {
        let start = usize::from(self.places[cell_of(rgb)]) * self.palette.len();
        &self.table[start..start + self.palette.len()]
    }

    /// The nearest colour for every pixel.
    pub(super) fn nearest(&self, image: &Image) -> Vec<u8> {
        let [r, g, b] = image.planes() else { return Vec::new() };
        let pixels = r.samples().iter().zip(g.samples()).zip(b.samples());
        pixels.map(|((&r, &g), &b)| self.nearest[usize::from(self.places[cell_of([r, g, b])])]).collect()
    }
}

pub(crate) fn cell_of([r, g, b]: [u8; 3]) -> usize {
    (usize::from(r >> 3) * CELLS + usize::from(g >> 3)) * CELLS + usize::from(b >> 3)
}

/// Oklab of the middle of every cell.
pub(crate) fn cells() -> &'static [[f32; 3]] {
    static CELLS_IN_OKLAB: OnceLock<Vec<[f32; 3]>> = OnceLock::new();
    CELLS_IN_OKLAB.get_or_init(|| (0..CELLS.pow(3)).map(|cell| oklab(color_of(cell))).collect())
}

/// The middle of a cell.
fn color_of(cell: usize) -> [f32; 3] {
    [cell / (CELLS * CELLS), cell / CELLS % CELLS, cell % CELLS].map(|part| part as f32 * 8.0 + 3.5)
}

/// Cells that any pixel is in.
fn seen(image: &Image) -> Vec<bool> {
    let mut seen = vec![false; CELLS.pow(3)];
    let [r, g, b] = image.planes() else { return seen };
    for ((&r, &g), &b) in r.samples().iter().zip(g.samples()).zip(b.samples()) {
        seen[cell_of([r, g, b])] = true;
    }
    seen
}

/// Pixels of each cell, and the sum of their colours.
pub(crate) struct Counts {
    pub(crate) pixels: Vec<u32>,
    sums: Vec<[u32; 3]>,
}

pub(crate) fn histogram(image: &Image) -> Counts {
    let cells = CELLS.pow(3);
    let mut counts = Counts { pixels: vec![0; cells], sums: vec![[0; 3]; cells] };
    let [r, g, b] = image.planes() else { return counts };
    let pixels = r.samples().iter().zip(g.samples()).zip(b.samples());
    for ((&r, &g), &b) in pixels {
        let cell = cell_of([r, g, b]);
        counts.pixels[cell] += 1;
        for (sum, tone) in counts.sums[cell].iter_mut().zip([r, g, b]) {
            *sum += u32::from(tone);
        }
    }
    counts
}

/// k-means of the colours of a photo, from starts that are far apart and common. Common colours count by the root of
/// their number, so that a large sky does not take every colour.
pub(crate) fn means(counts: &Counts, cells: &[[f32; 3]], count: usize) -> Vec<[u8; 3]> {
    struct Own {
        cell: usize,
        weight: f32,
        point: [f32; 3],
    }
    let used: Vec<Own> = counts
        .pixels
        .iter()
        .enumerate()
        .filter(|&(_, &pixels)| pixels > 0)
        .map(|(cell, &pixels)| Own { cell, weight: (pixels as f32).sqrt(), point: cells[cell] })
        .collect();
    let mut centres: Vec<[f32; 3]> = Vec::with_capacity(count);
    let mut apart: Vec<f32> = vec![f32::INFINITY; used.len()];
    while centres.len() < count.min(used.len()) {
        let score = |i: usize| if centres.is_empty() { used[i].weight } else { apart[i] * used[i].weight };
        let mut best = 0;
        for i in 1..used.len() {
            if score(i) > score(best) {
                best = i;
            }
        }
        let centre = used[best].point;
        centres.push(centre);
        for (apart, own) in apart.iter_mut().zip(&used) {
            *apart = apart.min(distance(own.point, centre));
        }
    }
    let mut members = vec![0; used.len()];
    for _ in 0..ROUNDS {
        for (member, own) in members.iter_mut().zip(&used) {
            *member = closest(&centres, own.point);
        }
        for (k, centre) in centres.iter_mut().enumerate() {
            let (mut sum, mut total) = ([0.0f32; 3], 0.0f32);
            for own in used.iter().zip(&members).filter(|(_, member)| **member == k).map(|(own, _)| own) {
                (0..3).for_each(|c| sum[c] += own.weight * own.point[c]);
                total += own.weight;
            }
            if total > 0.0 {
                *centre = sum.map(|sum| sum / total);
            }
        }
    }
    // The colour of each is the mean of its pixels.
    let mut sums = vec![([0u64; 3], 0u64); centres.len()];
    for (own, &member) in used.iter().zip(&members) {
        let (sum, total) = &mut sums[member];
        (0..3).for_each(|c| sum[c] += u64::from(counts.sums[own.cell][c]));
        *total += u64::from(counts.pixels[own.cell]);
    }
    sums.iter()
        .filter(|(_, total)| *total > 0)
        .map(|(sum, total)| sum.map(|sum| ((sum + total / 2) / total) as u8))
        .collect()
}

/// The colours of a named palette that the photo has most use for.
fn wanted(counts: &Counts, cells: &[[f32; 3]], palette: &[[u8; 3]], count: usize) -> Vec<[u8; 3]> {
    let points: Vec<[f32; 3]> = palette.iter().map(|&color| oklab(color.map(f32::from))).collect();
    let mut uses = vec![0u32; palette.len()];
    for (cell, &pixels) in counts.pixels.iter().enumerate().filter(|&(_, &pixels)| pixels > 0) {
        uses[closest(&points, cells[cell])] += pixels;
    }
    let mut order: Vec<usize> = (0..palette.len()).collect();
    sort_by_key(&mut order, |&i| std::cmp::Reverse(uses[i]));
    order.truncate(count.max(2));
    order.sort_unstable();
    order.into_iter().map(|i| palette[i]).collect()
}

fn closest(points: &[[f32; 3]], point: [f32; 3]) -> usize {
    let mut best = (0, f32::INFINITY);
    for (i, &own) in points.iter().enumerate() {
        let apart = distance(own, point);
        if apart < best.1 {
            best = (i, apart);
        }
    }
    best.0
}

pub(crate) fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let part = |i: usize| (a[i] - b[i]) * (a[i] - b[i]);
    part(0) + part(1) + part(2)
}

/// Oklab of an sRGB colour, 0..=255 each.
pub(crate) fn oklab(rgb: [f32; 3]) -> [f32; 3] {
    let [r, g, b] = rgb.map(|tone| {
        let tone = f64::from(tone) / 255.0;
        if tone <= 0.040_45 { tone / 12.92 } else { ((tone + 0.055) / 1.055).powf(2.4) }
    });
    let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
    let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
    let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
    [
        (0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s) as f32,
        (1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s) as f32,
        (0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s) as f32,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn oklab_is_that_of_its_author() {
        let near = |a: [f32; 3], b: [f32; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-3);
        assert!(near(oklab([255.0, 255.0, 255.0]), [1.0, 0.0, 0.0]));
        assert!(near(oklab([255.0, 0.0, 0.0]), [0.627_96, 0.224_86, 0.125_85]));
    }
}
