//! The direction of edges everywhere in a picture, and averages along it.
//!
//! The structure tensor is summed with weights of 1 / |gradient|, so that a strong edge bends the field no further than
//! its contrast deserves, and smoothed by a Gaussian:
//!
//! ```text
//! J = G_rho * (g g^T / |g|)        gradients of means of 2 x 2 pixels, summed over cells of 4 x 4
//! tangent   = eigenvector of the smaller eigenvalue
//! coherence = (l1 - l2) / (l1 + l2)
//! ```
//!
//! Each cell stores one of [`TURNS`] directions, so that four pixels of a row are read at the same offsets.
//!
//! Sources: Kyprianidis and Döllner, "Image abstraction by structure adaptive filtering", 2008 (smoothed structure tensor
//! for a flow field); Kang, Lee and Chui, "Coherent line drawing", 2007 (averages along it).

use crate::raster::Plane;
use crate::simd::blade::halve;
use crate::simd::oriented::{CELL, Wide, average};

/// Directions of half a turn, clockwise on the screen from the x axis.
pub const TURNS: usize = 32;

/// The field: one direction for each cell of 4 x 4 pixels, row by row.
#[derive(Debug, Clone)]
pub struct Tangents {
    columns: usize,
    turns: Vec<u8>,
    coherence: Vec<u8>,
}

impl Tangents {
    /// The field of a luma plane, smoothed by `rho` pixels.
    #[must_use]
    pub fn of(luma: &Plane, rho: f32) -> Self {
        let (columns, rows, mut tensor) = tensors(luma);
        for part in &mut tensor {
            smooth(part, columns, rows, rho / CELL as f32);
        }
        let mut turns = vec![0; columns * rows];
        let mut coherence = vec![0; columns * rows];
        for (i, (turn, coherence)) in turns.iter_mut().zip(&mut coherence).enumerate() {
            let [xx, xy, yy] = [tensor[0][i], tensor[1][i], tensor[2][i]];
            let (along, across) = (xx - yy, 2.0 * xy);
            let (difference, sum) = ((along * along + across * across).sqrt(), xx + yy);
            // Twice the angle of the gradient; the tangent is a quarter turn further.
            let angle = half_turns(across, along) + 0.5;
            *turn = ((angle * TURNS as f32).round() as usize % TURNS) as u8;
            // In nearly flat areas, the direction is noise.
            *coherence = (255.0 * difference / (sum + 1.0)) as u8;
        }
        Self { columns, turns, coherence }
    }

    /// The directions, row by row.
    #[must_use]
    pub fn turns(&self) -> &[u8] {
        &self.turns
    }

    /// Coherence of the direction of each cell, 0 to 255.
    #[must_use]
    pub fn coherence(&self) -> &[u8] {
        &self.coherence
    }

    /// Cells of a row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Every direction replaced by `turn(direction, coherence)`.
    pub fn bend(&mut self, turn: impl Fn(u8, u8) -> u8) {
        for (own, &coherence) in self.turns.iter_mut().zip(&self.coherence) {
            *own = turn(*own, coherence);
        }
    }

    /// Averages `plane` along the field with a Gaussian of `sigma` pixels. Each pass has a step three times
    /// as large and filters the result of the previous pass, which follows bends.
    pub fn smooth_along(&self, plane: &mut Wide, spare: &mut Wide, sigma: f32) {
        for taps in passes(sigma) {
            average(plane, spare, &self.turns, &offsets(&taps), &weights(&taps));
            std::mem::swap(plane, spare);
        }
    }
}

/// Returns the taps of passes whose variances add up to the variance of `sigma`. A pass with gaps needs a
/// previous pass that fills them: a Gaussian of 0.6 gaps.
fn passes(sigma: f32) -> Vec<Vec<(f32, f32)>> {
    const FILL: f32 = 0.6;
    let (mut passes, mut done, mut gap) = (Vec::new(), 0.0f32, 1.0f32);
    while sigma * sigma - done > 0.16 {
        let next = 3.0 * gap;
        let left = (sigma * sigma - done).sqrt();
        let enough = ((FILL * next) * (FILL * next) - done).sqrt();
        // One more pass pays where this one would take many steps.
        let own = if left > 1.6 * next { enough.min(left) } else { left };
        passes.push(gaussian_taps(own, gap));
        done += own * own;
        gap = next;
    }
    passes
}

/// Places on a line and their weights, which add up to 1.
fn gaussian_taps(sigma: f32, gap: f32) -> Vec<(f32, f32)> {
    let reach = (2.5 * sigma / gap).ceil() as i32;
    let weight = |k: i32| (-0.5 * f64::from(k as f32 * gap / sigma).powi(2)).exp();
    let total: f64 = (-reach..=reach).map(weight).sum();
    (-reach..=reach).map(|k| (k as f32 * gap, (weight(k) / total) as f32)).collect()
}

fn weights(taps: &[(f32, f32)]) -> Vec<i16> {
    taps.iter().map(|&(_, weight)| (weight * 32767.0).round() as i16).collect()
}

/// For each direction, the taps as whole steps to the right and down.
fn offsets(taps: &[(f32, f32)]) -> Vec<Vec<(isize, isize)>> {
    let one = |turn: usize| {
        let (x, y) = unit(turn);
        let place = |&(distance, _): &(f32, f32)| {
            ((f64::from(distance) * x).round() as isize, (f64::from(distance) * y).round() as isize)
        };
        taps.iter().map(place).collect()
    };
    (0..TURNS).map(one).collect()
}

/// The unit vector of a direction.
#[must_use]
pub fn unit(turn: usize) -> (f64, f64) {
    let (sin, cos) = (turn as f64 * std::f64::consts::PI / TURNS as f64).sin_cos();
    (cos, sin)
}

/// Sums of g g^T / |g| over cells: columns, rows, and xx, xy, yy.
fn tensors(luma: &Plane) -> (usize, usize, [Vec<f32>; 3]) {
    let (width, height) = (luma.width().div_ceil(2), luma.height().div_ceil(2));
    let half = halved(luma, width, height);
    let (columns, rows) = (luma.width().div_ceil(CELL), luma.height().div_ceil(CELL));
    let mut sums = [(); 3].map(|()| vec![0.0f32; columns * rows]);
    let mut parts = [(); 3].map(|()| vec![0.0f32; width.next_multiple_of(2)]);
    let row = |y: isize| {
        let y = y.clamp(0, height as isize - 1) as usize;
        &half[y * (width + 2)..(y + 1) * (width + 2)]
    };
    for y in 0..height {
        let [above, here, below] = [-1, 0, 1].map(|k| &row(y as isize + k)[..width + 2]);
        let [xx, xy, yy] = parts.each_mut().map(|part| &mut part[..width]);
        for x in 0..width {
            let gx = (above[x + 2] - above[x]) + 2.0 * (here[x + 2] - here[x]) + (below[x + 2] - below[x]);
            let gy =
                (below[x] - above[x]) + 2.0 * (below[x + 1] - above[x + 1]) + (below[x + 2] - above[x + 2]);
            let length = (gx * gx + gy * gy).sqrt() + 1.0;
            xx[x] = gx * gx / length;
            xy[x] = gx * gy / length;
            yy[x] = gy * gy / length;
        }
        for (sums, part) in sums.iter_mut().zip(&parts) {
            let (pairs, _) = part.as_chunks::<2>();
            for (sum, [a, b]) in sums[y / 2 * columns..].iter_mut().zip(pairs) {
                *sum += a + b;
            }
        }
    }
    (columns, rows, sums)
}

/// Means of 2 x 2 pixels, each row with its ends repeated once.
fn halved(luma: &Plane, width: usize, height: usize) -> Vec<f32> {
    let mut half = vec![0.0; (width + 2) * height];
    for (y, row) in half.chunks_exact_mut(width + 2).enumerate() {
        let (above, below) = (luma.row(2 * y), luma.row((2 * y + 1).min(luma.height() - 1)));
        halve(above, below, &mut row[1..=width]);
        (row[0], row[width + 1]) = (row[1], row[width]);
    }
    half
}

/// Gaussian smoothing of a small plane of floats; borders repeat the edge.
pub(crate) fn smooth(plane: &mut [f32], columns: usize, rows: usize, sigma: f32) {
    if sigma < 0.2 {
        return;
    }
    let taps = gaussian_taps(sigma, 1.0);
    let reach = taps.len() / 2;
    let mut padded = vec![0.0; columns + 2 * reach];
    for row in plane.chunks_exact_mut(columns) {
        padded[..reach].fill(row[0]);
        padded[reach..reach + columns].copy_from_slice(row);
        padded[reach + columns..].fill(row[columns - 1]);
        row.fill(0.0);
        for (k, &(_, weight)) in taps.iter().enumerate() {
            for (out, sample) in row.iter_mut().zip(&padded[k..]) {
                *out += weight * sample;
            }
        }
    }
    let source = plane.to_vec();
    for (y, row) in plane.chunks_exact_mut(columns).enumerate() {
        row.fill(0.0);
        for (k, &(_, weight)) in taps.iter().enumerate() {
            let from = (y + k).saturating_sub(reach).min(rows - 1);
            for (out, sample) in row.iter_mut().zip(&source[from * columns..]) {
                *out += weight * sample;
            }
        }
    }
}

/// Half of the angle of (x, y), in half turns: -1/2 to 1/2. Within 1e-4; by a polynomial, so that every platform has the
/// same bits.
fn half_turns(y: f32, x: f32) -> f32 {
    let (ax, ay) = (x.abs(), y.abs());
    let (low, high) = if ax < ay { (ax, ay) } else { (ay, ax) };
    let t = if high > 0.0 { low / high } else { 0.0 };
    // Abramowitz and Stegun, 4.4.49, for atan(t) on 0..1.
    let s = t * t;
    let atan = t * (0.999_866 + s * (-0.330_299_5 + s * (0.180_141 + s * (-0.085_133 + s * 0.020_835_1))));
    let atan = atan * std::f32::consts::FRAC_1_PI;
    let first = if ax < ay { 0.5 - atan } else { atan };
    let upper = if x < 0.0 { 1.0 - first } else { first };
    0.5 * if y < 0.0 { -upper } else { upper }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stripes whose tangent is `turn`.
    fn stripes(turn: usize) -> Plane {
        let (x, y) = unit(turn + TURNS / 2);
        Plane::from_fn(96, 96, |i, j| (128.0 + 100.0 * ((i as f64 * x + j as f64 * y) / 2.5).sin()) as u8)
    }

    #[test]
    fn stripes_have_their_own_direction_and_are_coherent() {
        for turn in 0..TURNS {
            let field = Tangents::of(&stripes(turn), 6.0);
            let middle = 12 * field.columns() + 12;
            let off = (field.turns()[middle] as isize - turn as isize).rem_euclid(TURNS as isize);
            assert!(off.min(TURNS as isize - off) <= 1, "{turn}: {}", field.turns()[middle]);
            assert!(field.coherence()[middle] > 200);
        }
    }

    #[test]
    fn angles_are_those_of_atan2() {
        for i in 0..1000 {
            let angle = f64::from(i) * 0.006_283;
            let found = f64::from(half_turns(angle.sin() as f32, angle.cos() as f32));
            let expected = 0.5 * angle.sin().atan2(angle.cos()) / std::f64::consts::PI;
            let off = (found - expected).abs();
            assert!(off.min(1.0 - off) < 1e-4, "{angle}: {found} {expected}");
        }
    }

    #[test]
    fn an_average_along_stripes_keeps_them_and_removes_what_crosses_them() {
        for turn in [0, 5, 16, 23] {
            let mut plane = stripes(turn);
            let field = Tangents::of(&plane, 6.0);
            let middle = 48 * 96 + 48;
            let before = plane.samples()[middle];
            plane.samples_mut()[middle] = before.wrapping_add(128);
            let mut wide = Wide::of(&plane, 16);
            let mut spare = wide.clone();
            field.smooth_along(&mut wide, &mut spare, 4.0);
            let after = wide.row(48)[48] >> 5;
            assert!((i32::from(after) - i32::from(before)).abs() < 30, "{turn}: {before} {after}");
        }
    }
}
