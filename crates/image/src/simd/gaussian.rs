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

use super::fine::{Fine, pad_row};
use super::fir::{self, Kernel};

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
        Fine::reusing(self.planes.pop().unwrap_or_default(), width, height)
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
    if sigma < COARSE_FROM {
        return blur_direct(source, sigma, buffers);
    }
    let low_pass = Kernel::gaussian(BRIDGE);
    let half = decimate(source, &low_pass, buffers);
    let rest = ((sigma * sigma - 2.0 * BRIDGE * BRIDGE) / 4.0).sqrt();
    let smooth = blur(&half, rest, buffers);
    buffers.give(half);
    let out = interpolate(&smooth, margin(&low_pass), (source.width(), source.height()), buffers);
    buffers.give(smooth);
    out
}

fn blur_direct(source: &Fine, sigma: f32, buffers: &mut Buffers) -> Fine {
    let kernel = Kernel::gaussian(sigma);
    let (width, height) = (source.width(), source.height());
    let mut rows = buffers.take(width, height);
    for y in 0..height {
        let length = width + 2 * kernel.radius();
        pad_row(source.row_clamped(y as isize), kernel.radius(), length, &mut buffers.padded);
        fir::horizontal(&kernel, &buffers.padded, rows.row_mut(y));
    }
    let mut out = buffers.take(width, height);
    for y in 0..height {
        fir::vertical(&kernel, |k| rows.row_clamped(y as isize + k), out.row_mut(y));
    }
    buffers.give(rows);
    out
}

/// Coarse samples that stand outside of the image, on each side.
fn margin(low_pass: &Kernel) -> usize {
    low_pass.radius().div_ceil(2) + 1
}

/// Coarse sample (i, j) is the low-passed image at (2 (i - margin), 2 (j - margin)).
fn decimate(source: &Fine, low_pass: &Kernel, buffers: &mut Buffers) -> Fine {
    let margin = margin(low_pass);
    let coarse = |side: usize| side.div_ceil(2) + 2 * margin;
    let mut columns = buffers.take(source.width(), coarse(source.height()));
    for j in 0..columns.height() {
        let y = 2 * (j as isize - margin as isize);
        fir::vertical(low_pass, |k| source.row_clamped(y + k), columns.row_mut(j));
    }
    let mut half = buffers.take(coarse(source.width()), columns.height());
    // The first centre stands 2 * ceil(radius / 2) into the padded row and 2 * margin before the image.
    let before = 2 * margin + 2 * low_pass.radius().div_ceil(2);
    let length = 2 * half.width() + 4 * low_pass.radius();
    for j in 0..half.height() {
        pad_row(columns.row_clamped(j as isize), before, length, &mut buffers.padded);
        fir::decimate(low_pass, &buffers.padded, half.row_mut(j), &mut buffers.split);
    }
    buffers.give(columns);
    half
}

fn interpolate(half: &Fine, margin: usize, (width, height): (usize, usize), buffers: &mut Buffers) -> Fine {
    let (even, odd) = Kernel::gaussian_phases(BRIDGE);
    let reach = even.radius().max(odd.radius());
    let mut rows = buffers.take(width, half.height());
    for j in 0..half.height() {
        let length = half.width() + 2 * reach;
        pad_row(half.row_clamped(j as isize), reach, length, &mut buffers.padded);
        let (padded, split) = (&buffers.padded, &mut buffers.split);
        fir::interpolate((&even, &odd), padded, reach + margin, rows.row_mut(j), split);
    }
    let mut out = buffers.take(width, height);
    for y in 0..height {
        let row = |j: isize| rows.row_clamped(j + margin as isize);
        fir::vertical_between((&even, &odd), y, row, out.row_mut(y));
    }
    buffers.give(rows);
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

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
