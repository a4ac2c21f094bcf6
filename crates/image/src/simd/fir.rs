//! Symmetric convolutions of rows and columns of fine samples.
//!
//! Weights are Q15 and sum to exactly 1 (32768), so a flat row keeps its value. Two samples at the same
//! distance are added before they are multiplied: half the multiplications.

use wide::i16x8;

use super::lanes::{even_lanes, interleave_high, interleave_low, odd_lanes};

/// Samples an operation.
pub const LANES: usize = 8;

/// Groups of lanes per loop, which hide the latency of the products. Measured: native code runs out of registers at 8.
const GROUP: usize = if cfg!(target_arch = "wasm32") { 8 } else { 4 };

/// Longest reach of a kernel; wider blurs run on a coarser grid.
pub const MAX_RADIUS: usize = 12;

/// One half of a symmetric kernel: the weight of the centre and of each distance.
#[derive(Clone, Debug)]
pub struct Kernel {
    centre: i16,
    pairs: Vec<i16>,
}

impl Kernel {
    /// A sampled, normalised Gaussian, cut at 3.5 sigma (the tail beyond holds .05 % of the weight).
    #[must_use]
    pub fn gaussian(sigma: f32) -> Self {
        let radius = (3.5 * sigma).ceil().clamp(1.0, MAX_RADIUS as f32) as usize;
        Self::normalised(&Self::bell(sigma, 0..=radius))
    }

    /// The two phases of a Gaussian that fills in every other sample: weights at distances 0, 2, 4... and at
    /// distances 1, 3, 5... The second has no centre.
    #[must_use]
    pub fn gaussian_phases(sigma: f32) -> (Self, Self) {
        let radius = (3.5 * sigma).ceil().max(2.0) as usize;
        let even = Self::bell(sigma, (0..=radius).step_by(2));
        let mut odd = Self::bell(sigma, (1..=radius).step_by(2));
        odd.insert(0, 0.0);
        (Self::normalised(&even), Self::normalised(&odd))
    }

    /// Distance of the farthest sample.
    #[must_use]
    pub fn radius(&self) -> usize {
        self.pairs.len()
    }

    fn bell(sigma: f32, distances: impl Iterator<Item = usize>) -> Vec<f64> {
        let sigma = f64::from(sigma);
        distances.map(|d| (-0.5 * (d as f64 / sigma).powi(2)).exp()).collect()
    }

    fn normalised(weights: &[f64]) -> Self {
        let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
        let mut pairs: Vec<i16> = weights[1..].iter().map(|w| (w / sum * 32768.0).round() as i16).collect();
        let rest = |pairs: &[i16]| 32768 - 2 * pairs.iter().map(|&w| i32::from(w)).sum::<i32>();
        if weights[0] == 0.0 {
            // Without a centre, the nearest pair gets the rounding error, which is even.
            pairs[0] += (rest(&pairs) / 2) as i16;
        }
        Self { centre: rest(&pairs).min(i32::from(i16::MAX)) as i16, pairs }
    }
}

/// `out[x] = sum of weights * padded[x + radius +- k]`. `padded` extends one lane beyond the needed samples.
pub fn horizontal(kernel: &Kernel, padded: &[i16], out: &mut [i16]) {
    let radius = kernel.radius();
    convolve(kernel, out, |x, k| &padded[x + radius - k..], |x, k| &padded[x + radius + k..]);
}

/// The same down columns: `row(k)` is the row at the signed distance `k`, as long as `out`.
pub fn vertical<'a>(kernel: &Kernel, row: impl Fn(isize) -> &'a [i16], out: &mut [i16]) {
    let radius = kernel.radius() as isize;
    let mut rows = Rows::default();
    for (slot, k) in rows.iter_mut().zip(-radius..=radius) {
        *slot = row(k);
    }
    vertical_rows(kernel, &rows, out);
}

/// A kernel on every other row of a grid: `even` distances for rows that exist, `odd` for rows between two.
/// `row(j)` is the coarse row `j`; the result is fine row `y`.
pub fn vertical_between<'a>(
    (even, odd): (&Kernel, &Kernel),
    y: usize,
    row: impl Fn(isize) -> &'a [i16],
    out: &mut [i16],
) {
    let j = (y / 2) as isize;
    if y.is_multiple_of(2) {
        vertical(even, |k| row(j + k), out);
    } else {
        // The odd phase has distance 2k - 1 at pair k: rows j + k and j + 1 - k.
        let radius = odd.radius() as isize;
        let mut rows = Rows::default();
        for (slot, k) in rows.iter_mut().zip(-radius..=radius) {
            *slot = if k < 0 { row(j + 1 + k) } else { row(j + k) };
        }
        vertical_rows(odd, &rows, out);
    }
}

/// Every other sample of a row, convolved: `out[j]` is centred on `padded[2 j + 2 * ceil(radius / 2)]`.
pub fn decimate(kernel: &Kernel, padded: &[i16], out: &mut [i16], split: &mut [Vec<i16>; 2]) {
    let [even, odd] = split;
    let half = padded.len() / 2 / LANES * LANES;
    even.resize(half + 2 * LANES, 0);
    odd.resize(half + 2 * LANES, 0);
    let (groups, rest) = padded.as_chunks::<{ 2 * LANES }>();
    for (i, group) in groups.iter().enumerate() {
        let (a, b) = (i16x8::from(&group[..LANES]), i16x8::from(&group[LANES..]));
        even[i * LANES..][..LANES].copy_from_slice(even_lanes(a, b).as_array());
        odd[i * LANES..][..LANES].copy_from_slice(odd_lanes(a, b).as_array());
    }
    // The last group is not complete. Lanes beyond the row are computed, but not stored.
    for (i, pair) in rest.chunks(2).enumerate() {
        even[half + i] = pair[0];
        odd[half + i] = pair[pair.len() - 1];
    }
    let centre = kernel.radius().div_ceil(2);
    let sample = |position: usize| -> (&[i16], usize) {
        if position.is_multiple_of(2) { (even, position / 2) } else { (odd, position / 2) }
    };
    convolve(
        kernel,
        out,
        |x, k| {
            let (row, i) = sample(2 * centre - k);
            &row[x + i..]
        },
        |x, k| {
            let (row, i) = sample(2 * centre + k);
            &row[x + i..]
        },
    );
}

/// Fills in between coarse samples along a row: `out[x]` for all x, where `padded[j + before]` is coarse
/// sample `j` at position 2 j.
pub fn interpolate((even, odd): (&Kernel, &Kernel), padded: &[i16], before: usize, out: &mut [i16]) {
    const TWO: usize = 2 * LANES;
    let mut chunks = out.chunks_exact_mut(GROUP / 2 * TWO);
    let mut j = before;
    for chunk in &mut chunks {
        let evens = weighted::<{ GROUP / 2 }>(even, |k| (&padded[j - k..], &padded[j + k..]));
        let odds = weighted::<{ GROUP / 2 }>(odd, |k| (&padded[j + 1 - k..], &padded[j + k..]));
        for (out, (even, odd)) in chunk.as_chunks_mut::<TWO>().0.iter_mut().zip(evens.into_iter().zip(odds)) {
            out[..LANES].copy_from_slice(interleave_low(even, odd).as_array());
            out[LANES..].copy_from_slice(interleave_high(even, odd).as_array());
        }
        j += GROUP / 2 * LANES;
    }
    for out in chunks.into_remainder().chunks_mut(TWO) {
        let [evens] = weighted::<1>(even, |k| (&padded[j - k..], &padded[j + k..]));
        let [odds] = weighted::<1>(odd, |k| (&padded[j + 1 - k..], &padded[j + k..]));
        let both = [interleave_low(evens, odds), interleave_high(evens, odds)];
        out.copy_from_slice(&bytemuck::cast_slice(&both)[..out.len()]);
        j += LANES;
    }
}

/// The rows that a vertical kernel sees, from the topmost; the array is as long as the longest kernel.
type Rows<'a> = [&'a [i16]; 2 * MAX_RADIUS + 1];

fn vertical_rows(kernel: &Kernel, rows: &Rows<'_>, out: &mut [i16]) {
    let radius = kernel.radius();
    let whole = out.len() - out.len() % LANES;
    let (body, tail) = out.split_at_mut(whole);
    convolve(kernel, body, |x, k| &rows[radius - k][x..], |x, k| &rows[radius + k][x..]);
    for (x, out) in tail.iter_mut().enumerate() {
        let sample = |i: usize| i32::from(rows[i][whole + x]);
        let mut sum = scaled(sample(radius), kernel.centre);
        for (k, &weight) in (1..).zip(&kernel.pairs) {
            sum += scaled(sample(radius - k) + sample(radius + k), weight);
        }
        *out = sum as i16;
    }
}

/// The rounding product that [`i16x8::mul_scale_round_n`] gives a lane.
fn scaled(sample: i32, weight: i16) -> i32 {
    (sample * i32::from(weight) + 0x4000) >> 15
}

/// The first `N` groups of lanes of a row: one bounds check for all of them.
#[inline]
fn groups<const N: usize>(row: &[i16]) -> [i16x8; N] {
    let (groups, _) = row[..N * LANES].as_chunks::<LANES>();
    std::array::from_fn(|g| i16x8::new(groups[g]))
}

/// The loop of most of them. The last, incomplete group is computed completely, and only the valid part is stored.
#[inline]
fn convolve<'a>(
    kernel: &Kernel,
    out: &mut [i16],
    left: impl Fn(usize, usize) -> &'a [i16],
    right: impl Fn(usize, usize) -> &'a [i16],
) {
    let mut x = 0;
    while x + GROUP * LANES <= out.len() {
        let sums = weighted::<GROUP>(kernel, |k| (left(x, k), right(x, k)));
        for sum in sums {
            out[x..x + LANES].copy_from_slice(sum.as_array());
            x += LANES;
        }
    }
    while x < out.len() {
        let [sum] = weighted::<1>(kernel, |k| (left(x, k), right(x, k)));
        let keep = LANES.min(out.len() - x);
        out[x..x + keep].copy_from_slice(&sum.as_array()[..keep]);
        x += keep;
    }
}

/// The weighted sums of `N` groups of lanes.
#[inline]
fn weighted<'a, const N: usize>(
    kernel: &Kernel,
    pair: impl Fn(usize) -> (&'a [i16], &'a [i16]),
) -> [i16x8; N] {
    let centre = i16x8::splat(kernel.centre);
    let mut sums = groups::<N>(pair(0).0).map(|samples| samples.mul_scale_round(centre));
    for (k, &weight) in (1..).zip(&kernel.pairs) {
        let weight = i16x8::splat(weight);
        let (left, right) = pair(k);
        let (left, right) = (groups::<N>(left), groups::<N>(right));
        for g in 0..N {
            sums[g] += (left[g] + right[g]).mul_scale_round(weight);
        }
    }
    sums
}
