//! Applies small filters that change from place to place: one 7 x 7 filter for each block of 2 x 2 pixels, chosen
//! by the structure tensor.
//!
//! ```text
//! for each block of two rows and two columns
//!     for each of the eight rows of pixels that its filter can touch
//!         dot products of eight pixels with the filter's row, for both columns and both rows of the block
//!     four sums across lanes, rounded and clipped to u8
//! ```
//!
//! A filter's row is loaded once for four pixels, and a row of pixels once for two filter rows.

use super::lanes::{interleave_high, interleave_low, narrow};
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16, u16x8, u32x4, u64x2};

/// Side of a filter.
pub const SIDE: usize = 7;

/// Fraction bits of a weight.
pub const FRACTION: u32 = 13;

/// Samples before the first pixel of a widened row.
pub const LEAD: usize = SIDE / 2;

/// Extra samples of a widened row: the reach of the filter on both sides, and padding that the last lanes
/// read with weight 0.
pub const MARGIN: usize = LEAD + 8;

/// Rows of weights; the eighth of a row is 0.
pub type Filter = [i16x8; SIDE];

/// Copies a row of pixels to 16 bits and repeats its ends. `out` holds [`MARGIN`] samples more than `row`.
pub fn widen(row: &[u8], out: &mut [i16]) {
    let (first, last) = (row.first().copied().unwrap_or(0), row.last().copied().unwrap_or(0));
    let (lead, rest) = out.split_at_mut(LEAD);
    let (body, tail) = rest.split_at_mut(row.len());
    lead.fill(i16::from(first));
    for (out, &sample) in body.iter_mut().zip(row) {
        *out = i16::from(sample);
    }
    tail.fill(i16::from(last));
}

/// Filters two rows of pixels. `rows` are the eight widened rows from three above the first to four below it.
/// `places` is the filter of each block of two columns. `second` may be empty at the end of the image.
pub fn filter_rows(
    rows: [&[i16]; 8],
    places: &[u8],
    filters: &[Filter],
    first: &mut [u8],
    second: &mut [u8],
) {
    let width = first.len();
    // Equal lengths, so that one bounds check per block is enough for all rows.
    let rows = rows.map(|row| &row[..width + MARGIN]);
    // Pairs with a known length, because a copy with an unknown length is a slow function call in wasm.
    let ((pairs, last), (second_pairs, second_last)) =
        (first.as_chunks_mut::<2>(), second.as_chunks_mut::<2>());
    for (block, &place) in places.iter().enumerate() {
        let Some(filter) = filters.get(usize::from(place)) else { continue };
        let [a, b, c, d] = filter_block(rows, block * 2, filter);
        if let Some(pair) = pairs.get_mut(block) {
            *pair = [a, b];
            if let Some(pair) = second_pairs.get_mut(block) {
                *pair = [c, d];
            }
        } else {
            for (out, value) in last.iter_mut().zip([a]).chain(second_last.iter_mut().zip([c])) {
                *out = value;
            }
        }
    }
}

/// The four pixels of the block whose filter begins at sample `x` of the rows: first row, then second.
#[inline]
fn filter_block(rows: [&[i16]; 8], x: usize, filter: &Filter) -> [u8; 4] {
    let mut sums = [i32x4::splat(0); 4];
    for (k, row) in rows.iter().enumerate() {
        let [left, right] = eight_twice(row, x);
        if let Some(&weights) = filter.get(k) {
            sums[0] += left.dot(weights);
            sums[1] += right.dot(weights);
        }
        if let Some(&weights) = k.checked_sub(1).and_then(|k| filter.get(k)) {
            sums[2] += left.dot(weights);
            sums[3] += right.dot(weights);
        }
    }
    // Halves added crosswise, twice, leave the sum of each in its own lane.
    let across = |a: i32x4, b: i32x4| {
        let (a, b) = (cast::<i32x4, u32x4>(a), cast::<i32x4, u32x4>(b));
        cast::<u32x4, u64x2>(a.unpack_lo(b) + a.unpack_hi(b))
    };
    let (first, second) = (across(sums[0], sums[1]), across(sums[2], sums[3]));
    let [even, odd] = [first.unpack_lo(second), first.unpack_hi(second)].map(cast::<u64x2, i32x4>);
    let total = (even + odd + i32x4::splat(1 << (FRACTION - 1))) >> FRACTION;
    let pixels = narrow(total, total);
    cast::<u8x16, [[u8; 4]; 4]>(u8x16::narrow_i16x8(pixels, pixels))[0]
}

/// Eight samples from `x` on, and eight from the next one on.
#[inline]
fn eight_twice(row: &[i16], x: usize) -> [i16x8; 2] {
    match row.get(x..x + 9).and_then(|nine| nine.first_chunk::<8>().zip(nine.last_chunk::<8>())) {
        Some((left, right)) => [i16x8::new(*left), i16x8::new(*right)],
        None => [i16x8::splat(0); 2],
    }
}

/// Means of 2 x 2 pixels of two rows; odd ends repeat the edge. `out` has half the length, rounded up.
pub fn halve(above: &[u8], below: &[u8], out: &mut [f32]) {
    let (above, above_tail) = above.as_chunks::<16>();
    let (below, below_tail) = below.as_chunks::<16>();
    let pairs = |bytes: &[u8; 16]| {
        let pairs: u16x8 = cast(u8x16::new(*bytes));
        (pairs & u16x8::splat(255)) + (pairs >> 8u32)
    };
    let (groups, _) = out.as_chunks_mut::<8>();
    for ((out, a), b) in groups.iter_mut().zip(above).zip(below) {
        let sums: i16x8 = cast(pairs(a) + pairs(b));
        let halves = [interleave_low(sums, i16x8::ZERO), interleave_high(sums, i16x8::ZERO)];
        let [low, high] = halves
            .map(|sums| (f32x4::from_i32x4(cast::<i16x8, i32x4>(sums)) * f32x4::splat(0.25)).to_array());
        out[..4].copy_from_slice(&low);
        out[4..].copy_from_slice(&high);
    }
    let tail = above_tail.chunks(2).zip(below_tail.chunks(2));
    for (out, (a, b)) in out[above.len() * 8..].iter_mut().zip(tail) {
        let sum = |pair: &[u8]| f32::from(pair[0]) + f32::from(pair[pair.len() - 1]);
        *out = (sum(a) + sum(b)) * 0.25;
    }
}

/// Taps of the smoothing of the structure tensor.
pub const TAPS: usize = 14;

/// The taps up to the middle, a binomial: a Gaussian of 1.8 samples.
const SMOOTHING: [f32; TAPS / 2] = [
    1.0 / 8192.0,
    13.0 / 8192.0,
    78.0 / 8192.0,
    286.0 / 8192.0,
    715.0 / 8192.0,
    1287.0 / 8192.0,
    1716.0 / 8192.0,
];

/// Products d1 d1, d1 d2 and d2 d2 of Roberts' differences between two rows, in three stretches of equal
/// length. Each is divided by the gradient and scaled. The first and the last add up to the gradient.
pub fn products(upper: &[f32], lower: &[f32], out: &mut [f32]) {
    /// Avoids division by zero in constant areas.
    const TINY: f32 = 1e-3;
    let count = upper.len() - 1;
    let (a, rest) = out.split_at_mut(upper.len());
    let (b, c) = rest.split_at_mut(upper.len());
    let (a, b, c) = (&mut a[..count], &mut b[..count], &mut c[..count]);
    let (u0, u1, l0, l1) = (&upper[..count], &upper[1..], &lower[..count], &lower[1..=count]);
    for i in 0..count {
        let (d1, d2) = (l1[i] - u0[i], l0[i] - u1[i]);
        let share = 0.5 / ((0.5 * (d1 * d1 + d2 * d2)).sqrt() + TINY);
        (a[i], b[i], c[i]) = (d1 * d1 * share, d1 * d2 * share, d2 * d2 * share);
    }
}

/// The weighted sum of rows.
pub fn smooth_columns(rows: [&[f32]; TAPS], out: &mut [f32]) {
    let n = out.len();
    let rows = rows.map(|row| &row[..n]);
    for i in 0..n {
        let mut sum = 0.0;
        for (k, &weight) in SMOOTHING.iter().enumerate() {
            sum += (rows[k][i] + rows[TAPS - 1 - k][i]) * weight;
        }
        out[i] = sum;
    }
}

/// The limits of features in the form in which they are compared.
pub struct Limits {
    /// Twice the limits of strength.
    strengths: Vec<f32>,
    /// Squares of (1 + c) / (1 - c): (s1 - s2) / (s1 + s2) > c, of the roots, is l1 > that times l2.
    coherences: Vec<f32>,
}

impl Limits {
    /// From the limits of strength (above 0) and coherence (within 0..1).
    #[must_use]
    pub fn new(strengths: &[f32], coherences: &[f32]) -> Self {
        Self {
            strengths: strengths.iter().map(|limit| 2.0 * limit).collect(),
            coherences: coherences.iter().map(|c| ((1.0 + c) / (1.0 - c)).powi(2)).collect(),
        }
    }
}

/// Buckets of a row from its tensor, whose rows hold [`TAPS`] + 2 values more: smoothed along the row, then
/// orientation, strength and coherence quantised.
///
/// The orientation is coded by four compares of (x, y) = (a - c, 2 b): 8 (y < 0) + 4 (x < 0) + 2 (|y| > |x|)
/// + (the smaller > tan(22.5 deg) of the larger).
pub fn quantise(tensor: [&[f32]; 3], limits: &Limits, out: &mut [u8]) {
    let zero = f32x4::splat(0.0);
    let (strengths, coherences) = (limits.strengths.len() as i32 + 1, limits.coherences.len() as i32 + 1);
    for (group, out) in out.chunks_mut(4).enumerate() {
        let [a, b, c] = tensor.map(|row| smooth_row(row, group * 4));
        let (x, y, sum) = (a - c, b + b, a + c);
        let root = (x * x + y * y).sqrt();
        // Both are twice the eigenvalue; the smaller one may come out below 0 by rounding.
        let (l1, l2) = (sum + root, (sum - root).max(zero));
        let (across, along) = (x.abs(), y.abs());
        let orientation = count(y.simd_lt(zero)) * i32x4::splat(8)
            + count(x.simd_lt(zero)) * i32x4::splat(4)
            + count(along.simd_gt(across)) * i32x4::splat(2)
            + count(along.min(across).simd_gt(along.max(across) * f32x4::splat(TAN_22_5)));
        let mut strength = i32x4::splat(0);
        for &limit in &limits.strengths {
            strength += count(l1.simd_gt(f32x4::splat(limit)));
        }
        let mut coherence = i32x4::splat(0);
        for &limit in &limits.coherences {
            coherence += count(l1.simd_gt(l2 * f32x4::splat(limit)));
        }
        let bucket =
            (orientation * i32x4::splat(strengths) + strength) * i32x4::splat(coherences) + coherence;
        for (out, bucket) in out.iter_mut().zip(bucket.to_array()) {
            *out = bucket as u8;
        }
    }
}

/// tan(22.5 degrees).
const TAN_22_5: f32 = 0.414_213_56;

/// 1 where a compare held.
#[inline]
fn count(mask: f32x4) -> i32x4 {
    -cast::<f32x4, i32x4>(mask)
}

/// Four sums along a row, the first over the values from `x` on.
#[inline]
fn smooth_row(row: &[f32], x: usize) -> f32x4 {
    const WINDOW: usize = TAPS + 3;
    // One check of the window's place for all taps.
    let Some(window) = row.get(x..x + WINDOW).and_then(|window| window.first_chunk::<WINDOW>()) else {
        return f32x4::splat(0.0);
    };
    let four = |k: usize| window[k..].first_chunk().map_or(f32x4::splat(0.0), |four| f32x4::new(*four));
    let mut sum = f32x4::splat(0.0);
    for (k, &weight) in SMOOTHING.iter().enumerate() {
        sum += (four(k) + four(TAPS - 1 - k)) * f32x4::splat(weight);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn naive(rows: &[Vec<u8>; 8], x: usize, top: usize, filter: &[[i16; 7]; 7]) -> u8 {
        let width = rows[0].len() as isize;
        let mut sum = 0i64;
        for (dy, weights) in filter.iter().enumerate() {
            for (dx, &weight) in weights.iter().enumerate() {
                let x = (x as isize + dx as isize - 3).clamp(0, width - 1) as usize;
                sum += i64::from(rows[top + dy][x]) * i64::from(weight);
            }
        }
        ((sum + 4096) >> 13).clamp(0, 255) as u8
    }

    #[test]
    fn halves_are_means_at_every_width() {
        let mut random = oorandom::Rand32::new(12);
        for width in 1..=67usize {
            let [above, below] =
                [(); 2].map(|()| (0..width).map(|_| random.rand_u32() as u8).collect::<Vec<u8>>());
            let mut out = vec![0.0; width.div_ceil(2)];
            halve(&above, &below, &mut out);
            for (i, &out) in out.iter().enumerate() {
                let columns = [2 * i, (2 * i + 1).min(width - 1)];
                let sum: f32 = columns.iter().map(|&x| f32::from(above[x]) + f32::from(below[x])).sum();
                assert!((out - sum / 4.0).abs() < 1e-6, "{width} {i}");
            }
        }
    }

    #[test]
    fn lanes_equal_plain_sums_at_every_width() {
        let mut random = oorandom::Rand32::new(11);
        let filters: Vec<[[i16; 7]; 7]> = (0..5)
            .map(|_| [(); 7].map(|()| [(); 7].map(|()| random.rand_range(0..1200) as i16 - 430)))
            .collect();
        let lanes: Vec<Filter> = filters
            .iter()
            .map(|filter| filter.map(|[a, b, c, d, e, f, g]| i16x8::new([a, b, c, d, e, f, g, 0])))
            .collect();
        for width in 1..=67usize {
            let rows = [(); 8].map(|()| (0..width).map(|_| random.rand_u32() as u8).collect::<Vec<u8>>());
            let places: Vec<u8> = (0..width.div_ceil(2)).map(|_| random.rand_range(0..5) as u8).collect();
            let wide = rows.each_ref().map(|row| {
                let mut out = vec![0; width + MARGIN];
                widen(row, &mut out);
                out
            });
            let (mut first, mut second) = (vec![0; width], vec![0; width]);
            filter_rows(wide.each_ref().map(Vec::as_slice), &places, &lanes, &mut first, &mut second);
            for x in 0..width {
                let filter = &filters[usize::from(places[x / 2])];
                assert_eq!(first[x], naive(&rows, x, 0, filter), "{width} {x}");
                assert_eq!(second[x], naive(&rows, x, 1, filter), "{width} {x}, second row");
            }
            let mut last = vec![0; width];
            filter_rows(wide.each_ref().map(Vec::as_slice), &places, &lanes, &mut last, &mut []);
            assert_eq!(last, first);
        }
    }
}
