//! Gaussian smoothing at a cost that hardly grows with sigma.
//!
//! ```text
//! blur(image, sigma):
//!     if sigma is small: convolve rows, then columns
//!     else:
//!         half  = every other sample of image * G(1.4)          (low-pass, then decimate)
//!         half  = blur(half, sqrt((sigma^2 - 2 * 1.4^2) / 4))
//!         image = half * G(1.4) between its samples             (interpolate)
//! ```
//!
//! Variances add, so the three Gaussians make one of exactly sigma. A sigma of 1.4 samples passes 0.00006 of
//! the frequencies that alias at half the rate. Borders repeat the edge exactly: the coarse grid extends
//! beyond the image as far as the low-pass sees both sides of the edge, and is constant beyond.

use super::fine::{Fine, narrow_row, pad_row, widen_row};
use super::fir::{self, Kernel};
use crate::raster::Plane;

/// Sigma of the low-pass and of the interpolation, in samples of the finer grid.
const BRIDGE: f32 = 1.4;

/// From this sigma on the coarse grid is faster than the direct convolution (measured).
const COARSE_FROM: f32 = 2.4;

/// Buffers that are reused by the next blur, so that moving a slider allocates nothing.
#[derive(Default, Debug)]
pub struct Buffers {
    planes: Vec<Vec<i16>>,
    padded: Vec<i16>,
    split: [Vec<i16>; 2],
}

impl Buffers {
    /// A plane whose samples are arbitrary.
    pub fn take(&mut self, width: usize, height: usize) -> Fine {
        // The buffer of the nearest size, because growth costs time.
        let far = |at: &usize| self.planes[*at].len().abs_diff(width * height);
        let nearest = (0..self.planes.len()).min_by_key(far);
        let samples = nearest.map(|at| self.planes.swap_remove(at));
        Fine::reusing(samples.unwrap_or_default(), width, height)
    }

    /// Takes a plane back.
    pub fn give(&mut self, plane: Fine) {
        self.planes.push(plane.into_samples());
    }
}

/// Smooths a plane by a Gaussian of `sigma` pixels; borders repeat the edge.
///
/// Error against an exact Gaussian: below .5 grey steps for sigma .3 to 50.
#[must_use]
pub fn blur(source: &Fine, sigma: f32, buffers: &mut Buffers) -> Fine {
    let out = buffers.take(source.width(), source.height());
    let mut rows = Copied { source, out };
    smooth(&mut rows, sigma, buffers);
    rows.out
}

/// Smooths a plane of whole grey levels in place, like [`blur`].
pub fn blur_plane(plane: &mut Plane, sigma: f32, buffers: &mut Buffers) {
    smooth(plane, sigma, buffers);
}

/// Rows that are read and replaced in order. A row is read once, before it is replaced.
trait Rows {
    /// Width and height.
    fn size(&self) -> (usize, usize);
    /// Copies a row to `row`, which has its width.
    fn read(&self, y: usize, row: &mut [i16]);
    /// Replaces a row by the output of `make`. `spare` has its width.
    fn write(&mut self, y: usize, spare: &mut [i16], make: impl FnOnce(&mut [i16]));
}

/// A plane, and its copy that is written.
struct Copied<'s> {
    source: &'s Fine,
    out: Fine,
}

impl Rows for Copied<'_> {
    fn size(&self) -> (usize, usize) {
        (self.source.width(), self.source.height())
    }

    fn read(&self, y: usize, row: &mut [i16]) {
        row.copy_from_slice(self.source.row_clamped(y as isize));
    }

    fn write(&mut self, y: usize, _: &mut [i16], make: impl FnOnce(&mut [i16])) {
        make(self.out.row_mut(y));
    }
}

impl Rows for Plane {
    fn size(&self) -> (usize, usize) {
        (self.width(), self.height())
    }

    fn read(&self, y: usize, row: &mut [i16]) {
        widen_row(self.row(y), row);
    }

    fn write(&mut self, y: usize, spare: &mut [i16], make: impl FnOnce(&mut [i16])) {
        make(spare);
        narrow_row(spare, self.row_mut(y));
    }
}

/// The last rows of a plane whose rows are made in order. They stay in the cache.
struct Recent {
    rows: Fine,
    /// Number of rows that were made.
    made: usize,
    /// Number of rows of the whole plane.
    height: usize,
}

impl Recent {
    /// `count`: how many rows are used at a time.
    fn new(width: usize, height: usize, count: usize, buffers: &mut Buffers) -> Self {
        Self { rows: buffers.take(width, count), made: 0, height }
    }

    /// Makes rows up to row `y`, and at least the first row.
    fn make(&mut self, y: isize, mut row: impl FnMut(usize, &mut [i16])) {
        let end = (y + 1).clamp(1, self.height as isize) as usize;
        while self.made < end {
            let count = self.rows.height();
            row(self.made, self.rows.row_mut(self.made % count));
            self.made += 1;
        }
    }

    /// A recent row, where rows above and below the plane repeat its first and last.
    fn row_clamped(&self, y: isize) -> &[i16] {
        let y = y.clamp(0, self.height as isize - 1) as usize;
        self.rows.row_clamped((y % self.rows.height()) as isize)
    }
}

fn smooth(rows: &mut impl Rows, sigma: f32, buffers: &mut Buffers) {
    if sigma < COARSE_FROM {
        smooth_direct(rows, sigma, buffers);
        return;
    }
    let low_pass = Kernel::gaussian(BRIDGE);
    let half = decimate(rows, &low_pass, buffers);
    let rest = ((sigma * sigma - 2.0 * BRIDGE * BRIDGE) / 4.0).sqrt();
    let smooth = blur(&half, rest, buffers);
    buffers.give(half);
    interpolate(&smooth, margin(&low_pass), rows, buffers);
    buffers.give(smooth);
}

fn smooth_direct(rows: &mut impl Rows, sigma: f32, buffers: &mut Buffers) {
    let kernel = Kernel::gaussian(sigma);
    let (width, height) = rows.size();
    let radius = kernel.radius();
    let mut recent = Recent::new(width, height, 2 * radius + 1, buffers);
    let mut spare = buffers.take(width, 1);
    for y in 0..height as isize {
        recent.make(y + radius as isize, |y, row| {
            rows.read(y, spare.row_mut(0));
            pad_row(spare.row_clamped(0), radius, width + 2 * radius, &mut buffers.padded);
            fir::horizontal(&kernel, &buffers.padded, row);
        });
        rows.write(y as usize, spare.row_mut(0), |out| {
            fir::vertical(&kernel, |k| recent.row_clamped(y + k), out);
        });
    }
    buffers.give(spare);
    buffers.give(recent.rows);
}

/// Coarse samples that stand outside of the image, on each side.
fn margin(low_pass: &Kernel) -> usize {
    low_pass.radius().div_ceil(2) + 1
}

/// Coarse sample (i, j) is the low-passed image at (2 (i - margin), 2 (j - margin)).
fn decimate(rows: &impl Rows, low_pass: &Kernel, buffers: &mut Buffers) -> Fine {
    let (width, height) = rows.size();
    let (margin, radius) = (margin(low_pass), low_pass.radius());
    let coarse = |side: usize| side.div_ceil(2) + 2 * margin;
    let mut recent = Recent::new(width, height, 2 * radius + 1, buffers);
    let mut column = buffers.take(width, 1);
    let mut half = buffers.take(coarse(width), coarse(height));
    // The first centre stands 2 * ceil(radius / 2) into the padded row and 2 * margin before the image.
    let before = 2 * margin + 2 * radius.div_ceil(2);
    let length = 2 * half.width() + 4 * radius;
    for j in 0..half.height() {
        let y = 2 * (j as isize - margin as isize);
        recent.make(y + radius as isize, |y, row| rows.read(y, row));
        fir::vertical(low_pass, |k| recent.row_clamped(y + k), column.row_mut(0));
        pad_row(column.row_clamped(0), before, length, &mut buffers.padded);
        fir::decimate(low_pass, &buffers.padded, half.row_mut(j), &mut buffers.split);
    }
    buffers.give(column);
    buffers.give(recent.rows);
    half
}

fn interpolate(half: &Fine, margin: usize, rows: &mut impl Rows, buffers: &mut Buffers) {
    let (even, odd) = Kernel::gaussian_phases(BRIDGE);
    let reach = even.radius().max(odd.radius());
    let (width, height) = rows.size();
    let mut recent = Recent::new(width, half.height(), 2 * reach + 1, buffers);
    let mut spare = buffers.take(width, 1);
    let length = half.width() + 2 * reach;
    for y in 0..height {
        let first = (y / 2 + margin) as isize;
        recent.make(first + reach as isize, |j, row| {
            pad_row(half.row_clamped(j as isize), reach, length, &mut buffers.padded);
            fir::interpolate((&even, &odd), &buffers.padded, reach + margin, row);
        });
        let row = |j: isize| recent.row_clamped(j + margin as isize);
        rows.write(y, spare.row_mut(0), |out| fir::vertical_between((&even, &odd), y, row, out));
    }
    buffers.give(spare);
    buffers.give(recent.rows);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The definition, in f64, cut at 8 sigma.
    fn exact(plane: &Plane, sigma: f64) -> Vec<f64> {
        let radius = (8.0 * sigma).ceil() as isize;
        let weights: Vec<f64> =
            (-radius..=radius).map(|d| (-0.5 * (d as f64 / sigma).powi(2)).exp()).collect();
        let sum: f64 = weights.iter().sum();
        let (w, h) = (plane.width() as isize, plane.height() as isize);
        let pass = |get: &dyn Fn(isize, isize) -> f64, dx: isize, dy: isize| -> Vec<f64> {
            let mut out = Vec::new();
            for y in 0..h {
                for x in 0..w {
                    let value: f64 = (-radius..=radius)
                        .zip(&weights)
                        .map(|(k, weight)| {
                            weight * get((x + k * dx).clamp(0, w - 1), (y + k * dy).clamp(0, h - 1))
                        })
                        .sum();
                    out.push(value / sum);
                }
            }
            out
        };
        let rows = pass(&|x, y| f64::from(plane.at(x as usize, y as usize)), 1, 0);
        pass(&|x, y| rows[(y * w + x) as usize], 0, 1)
    }

    #[test]
    fn error_stays_below_half_a_grey_step() {
        let mut random = oorandom::Rand32::new(7);
        for (width, height) in [(67, 41), (1, 30), (33, 1), (16, 16), (50, 64)] {
            // Hard edges and noise: the worst that a blur can meet.
            let plane = Plane::from_fn(width, height, |x, y| {
                if (x / 9 + y / 7) % 2 == 0 { 255 } else { (random.rand_u32() % 3) as u8 * 60 }
            });
            for sigma in [0.3, 0.5, 1.0, 1.9, 2.39, 2.4, 3.0, 4.7, 8.0, 20.0, 50.0] {
                let mut buffers = Buffers::default();
                let mut fine = buffers.take(width, height);
                fine.widen(&plane);
                let smooth = blur(&fine, sigma, &mut buffers);
                let exact = exact(&plane, f64::from(sigma));
                let worst = smooth
                    .into_samples()
                    .iter()
                    .zip(&exact)
                    .map(|(&a, b)| (f64::from(a) / 64.0 - b).abs())
                    .fold(0.0, f64::max);
                assert!(worst < 0.5, "{width}x{height} sigma {sigma}: {worst}");
            }
        }
    }

    #[test]
    fn a_plane_in_place_has_the_pixels_of_a_copy() {
        let mut random = oorandom::Rand32::new(3);
        let mut buffers = Buffers::default();
        for (width, height) in [(67, 41), (1, 30), (33, 1)] {
            let plane = Plane::from_fn(width, height, |_, _| random.rand_u32() as u8);
            for sigma in [0.7, 2.0, 3.3, 17.0] {
                let mut fine = buffers.take(width, height);
                fine.widen(&plane);
                let mut copy = Plane::filled(width, height, 0);
                blur(&fine, sigma, &mut buffers).narrow(&mut copy);
                let mut same = plane.clone();
                blur_plane(&mut same, sigma, &mut buffers);
                assert_eq!(same.samples(), copy.samples(), "{width}x{height} sigma {sigma}");
            }
        }
    }

    #[test]
    fn a_flat_plane_stays_flat() {
        let mut buffers = Buffers::default();
        let mut fine = buffers.take(40, 23);
        fine.widen(&Plane::filled(40, 23, 201));
        for sigma in [0.7, 2.0, 3.3, 17.0] {
            let smooth = blur(&fine, sigma, &mut buffers);
            let mut out = Plane::filled(40, 23, 0);
            smooth.narrow(&mut out);
            assert!(out.samples().iter().all(|&v| v == 201), "sigma {sigma}");
        }
    }
}
