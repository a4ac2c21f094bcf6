//! Averages of pixels at places that change from cell to cell: along an edge, across it, around it.
//!
//! A cell of [`CELL`] x [`CELL`] pixels reads all of its pixels at the same offsets, so a row of it is one load.

use super::fine::Fine;
use crate::raster::Plane;
use bytemuck::cast;
use wide::i16x8;

/// Side of a cell, in pixels.
pub const CELL: usize = 4;

/// Fraction bits of a sample of a [`Wide`] that holds grey steps.
pub const FRACTION: u32 = 5;

/// A plane of 16-bit samples with `margin` repeats of its border on each side.
#[derive(Debug, Clone, Default)]
pub struct Wide {
    width: usize,
    height: usize,
    margin: usize,
    stride: usize,
    samples: Vec<i16>,
}

impl Wide {
    /// Room for `width` x `height` samples, all 0. The sides grow to whole cells within the margin.
    #[must_use]
    pub fn new(width: usize, height: usize, margin: usize) -> Self {
        let stride = width.next_multiple_of(CELL) + 2 * margin;
        let rows = height.next_multiple_of(CELL) + 2 * margin;
        Self { width, height, margin, stride, samples: vec![0; stride * rows] }
    }

    /// The samples of a plane in 1/32 grey steps.
    #[must_use]
    pub fn of(plane: &Plane, margin: usize) -> Self {
        let mut wide = Self::new(plane.width(), plane.height(), margin);
        for y in 0..plane.height() {
            for (out, &sample) in wide.row_mut(y).iter_mut().zip(plane.row(y)) {
                *out = i16::from(sample) << FRACTION;
            }
        }
        wide.pad();
        wide
    }

    /// Every sample of a fine plane through a table.
    #[must_use]
    pub fn mapped(plane: &Fine, margin: usize, map: impl Fn(i16) -> i16) -> Self {
        let mut wide = Self::new(plane.width(), plane.height(), margin);
        for y in 0..plane.height() {
            for (out, &sample) in wide.row_mut(y).iter_mut().zip(plane.row_clamped(y as isize)) {
                *out = map(sample);
            }
        }
        wide.pad();
        wide
    }

    /// One row without its margins.
    #[must_use]
    pub fn row(&self, y: usize) -> &[i16] {
        let start = (y + self.margin) * self.stride + self.margin;
        &self.samples[start..start + self.width]
    }

    /// Returns a row for writing. [`Self::pad`] updates the margins.
    pub fn row_mut(&mut self, y: usize) -> &mut [i16] {
        let start = (y + self.margin) * self.stride + self.margin;
        &mut self.samples[start..start + self.width]
    }

    /// Repeats the border in the margins.
    pub fn pad(&mut self) {
        let Self { width, height, margin, stride, .. } = *self;
        for y in 0..height {
            let row = &mut self.samples[(y + margin) * stride..(y + margin + 1) * stride];
            let (first, last) = (row[margin], row[margin + width - 1]);
            row[..margin].fill(first);
            row[margin + width..].fill(last);
        }
        let rows = self.samples.len() / stride;
        for y in 0..margin {
            self.samples.copy_within(margin * stride..(margin + 1) * stride, y * stride);
        }
        let last = (margin + height - 1) * stride;
        for y in margin + height..rows {
            self.samples.copy_within(last..last + stride, y * stride);
        }
    }
}

impl Wide {
    /// Offset in samples for a step to the right and down, limited to the margin.
    fn step(&self, (x, y): (isize, isize)) -> isize {
        let most = self.margin as isize;
        y.clamp(-most, most) * self.stride as isize + x.clamp(-most, most)
    }
}

/// Two rows of a cell: the four samples at `at`, and those `stride` further.
#[inline]
fn two_rows(samples: &[i16], at: usize, stride: usize) -> i16x8 {
    // As one number of 64 bits: four of 16 would be loaded one by one.
    let four = |at: usize| {
        let four = samples.get(at..at + CELL).and_then(|four| four.first_chunk::<CELL>());
        four.map_or(0, |&four| cast::<[i16; CELL], u64>(four))
    };
    cast([four(at), four(at + stride)])
}

/// Weighted sums of samples at the offsets of each cell's direction. `turns` has a direction for each cell,
/// row by row; `offsets` the steps (right, down) of each direction; `weights` are Q15, one for each step.
/// Steps beyond the margin are cut to it. Writes the sums to `out`, which has the size of `source`, including
/// margins.
pub fn average(
    source: &Wide,
    out: &mut Wide,
    turns: &[u8],
    offsets: &[Vec<(isize, isize)>],
    weights: &[i16],
) {
    let Wide { width, height, margin, stride, .. } = *source;
    let offsets: Vec<Vec<isize>> =
        offsets.iter().map(|steps| steps.iter().map(|&step| source.step(step)).collect()).collect();
    let weights: Vec<i16x8> = weights.iter().map(|&weight| i16x8::splat(weight)).collect();
    let columns = width.div_ceil(CELL);
    for (cell_row, turns) in turns.chunks_exact(columns).take(height.div_ceil(CELL)).enumerate() {
        for (column, &turn) in turns.iter().enumerate() {
            let Some(offsets) = offsets.get(usize::from(turn)) else { continue };
            let first = (cell_row * CELL + margin) * stride + column * CELL + margin;
            for at in [first, first + 2 * stride] {
                let mut sum = i16x8::splat(0);
                for (&offset, &weight) in offsets.iter().zip(&weights) {
                    let pixels = two_rows(&source.samples, at.wrapping_add_signed(offset), stride);
                    sum += pixels.mul_scale_round(weight);
                }
                let [a, b, c, d, e, f, g, h] = sum.to_array();
                if let Some(row) = out.samples.get_mut(at..at + CELL) {
                    row.copy_from_slice(&[a, b, c, d]);
                }
                if let Some(row) = out.samples.get_mut(at + stride..at + stride + CELL) {
                    row.copy_from_slice(&[e, f, g, h]);
                }
            }
        }
    }
    out.pad();
}

/// Sectors that [`choose`] chooses among.
pub const SECTORS: usize = 8;

/// Fraction bits of the weight of a sector.
const WEIGHT: u32 = 12;

/// At every pixel a mean of the samples of `planes` at eight places about it, by how calm it is there:
///
/// ```text
/// w_k = (1 - min(reach, spread_k - min spread) / reach)^4
/// out = sum of w_k sample_k / sum of w_k
/// ```
///
/// `shapes` has a shape for each cell, row by row; `places` the eight steps (right, down) of each shape. All
/// planes and `spread` have one size and one margin; `reach` is 1 to 32767, in the units of `spread`. Rounded
/// to whole grey levels.
pub fn choose(
    planes: &[Wide],
    spread: &Wide,
    shapes: &[u8],
    places: &[[(isize, isize); SECTORS]],
    reach: i16,
    out: &mut [Plane],
) {
    let Wide { width, height, margin, stride, .. } = *spread;
    let places: Vec<[isize; SECTORS]> =
        places.iter().map(|steps| steps.map(|step| spread.step(step))).collect();
    let (far, slope) = (i16x8::splat(reach), i16x8::splat(i16::MAX / reach.max(1)));
    let columns = width.div_ceil(CELL);
    for (cell_row, shapes) in shapes.chunks_exact(columns).take(height.div_ceil(CELL)).enumerate() {
        for (column, &shape) in shapes.iter().enumerate() {
            let Some(places) = places.get(usize::from(shape)) else { continue };
            for pair in [0, 2] {
                let (x, y) = (column * CELL, cell_row * CELL + pair);
                let at = (y + margin) * stride + x + margin;
                let spreads =
                    places.map(|place| two_rows(&spread.samples, at.wrapping_add_signed(place), stride));
                let calmest = spreads.iter().fold(far.max(spreads[0]), |least, &spread| least.min(spread));
                let weights = spreads.map(|spread| {
                    // In Q15, except for the remainder of the division of reach, which all weights share.
                    let near = (far - (spread - calmest).min(far)) * slope;
                    let square = near.mul_scale_round(near);
                    square.mul_scale_round(square) >> (15 - WEIGHT)
                });
                let total = weights.iter().fold(i16x8::splat(0), |sum, &weight| sum + weight).to_array();
                // A sample of 1/32 grey steps times a weight of 12 bits is 1/4 grey steps.
                let share = total.map(|total| 1024.0 / f32::from(total.max(1)));
                for (plane, out) in planes.iter().zip(out.iter_mut()) {
                    let mut sum = i16x8::splat(0);
                    for (&place, &weight) in places.iter().zip(&weights) {
                        let pixels = two_rows(&plane.samples, at.wrapping_add_signed(place), stride);
                        sum += pixels.mul_scale_round(weight);
                    }
                    let sum = sum.to_array();
                    let tones: [u8; 2 * CELL] =
                        std::array::from_fn(|i| (f32::from(sum[i]) * share[i] + 0.5) as u8);
                    for (row, tones) in
                        tones.chunks_exact(CELL).enumerate().filter(|(row, _)| y + row < height)
                    {
                        let out = &mut out.row_mut(y + row)[x..];
                        for (out, &tone) in out.iter_mut().zip(tones) {
                            *out = tone;
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_plain_loops_and_borders_repeat() {
        let plane = Plane::from_fn(19, 11, |x, y| (x * 13 + y * 29) as u8);
        let wide = Wide::of(&plane, 6);
        let mut out = wide.clone();
        let turns: Vec<u8> = (0..15).map(|i| i % 2).collect();
        let offsets = [vec![(0, 0), (3, -2)], vec![(-5, 1), (1, 6)]];
        average(&wide, &mut out, &turns, &offsets, &[16384, 8192]);
        for y in 0..11 {
            for x in 0..19 {
                let turn = usize::from(turns[y / 4 * 5 + x / 4]);
                let at = |(dx, dy): (isize, isize)| {
                    let x = (x as isize + dx).clamp(0, 18) as usize;
                    let y = (y as isize + dy).clamp(0, 10) as usize;
                    f64::from(plane.at(x, y)) * 32.0
                };
                let expected = 0.5 * at(offsets[turn][0]) + 0.25 * at(offsets[turn][1]);
                assert!((f64::from(out.row(y)[x]) - expected).abs() <= 1.0, "{x}, {y}");
            }
        }
    }

    #[test]
    fn the_calm_side_is_chosen() {
        let plane = Plane::from_fn(24, 12, |x, _| if x < 12 { 40 } else { 200 });
        let spread = Plane::from_fn(24, 12, |x, _| if (9..15).contains(&x) { 90 } else { 1 });
        let mut out = vec![Plane::filled(24, 12, 0)];
        let places = [[(-6, 0), (6, 0), (0, 4), (0, -4), (-4, 4), (4, 4), (-4, -4), (4, -4)]];
        choose(&[Wide::of(&plane, 8)], &Wide::of(&spread, 8), &[0; 18], &places, 600, &mut out);
        // At the border both sides are calm; away from it only one side is.
        let row: Vec<u8> = out[0].row(6).to_vec();
        assert!(row[..9].iter().all(|&v| v == 40) && row[15..].iter().all(|&v| v == 200), "{row:?}");
    }
}
