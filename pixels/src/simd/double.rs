//! Rows of bytes made twice as long, and rows between two: Catmull-Rom (1974) at a quarter, where all weights are whole
//! parts of 128 and sums fit into 16 bits.

use super::lanes::{widen_high, widen_low};
use super::mix::{LANES, load};
use wide::{i16x8, u8x16};

/// Weights of four samples in a row for the place a quarter past the second, in 1/128.
const WEIGHTS: [i16; 4] = [-9, 111, 29, -3];
const BITS: u32 = 7;
/// Sums go from -12 * 255 to 140 * 255: less by half of all, they fit, whatever their parts do on the way.
const LESS: i16 = 128 << BITS;

/// Samples of a row before its first pixel and after its last one that [`double_row`] reads.
pub const AROUND: usize = 2;

/// Rows of four, of which the place a quarter past the second is asked for.
///
/// Panics where one is shorter than `out`, or `out` than [`LANES`].
pub fn quarter_row(rows: [&[u8]; 4], out: &mut [u8]) {
    for x in starts(out.len()) {
        let row = quarter(rows.map(|row| load(row, x)));
        out[x..x + LANES].copy_from_slice(row.as_array());
    }
}

/// A row twice as long: two samples for each, a quarter before its middle and a quarter after. `row` has [`AROUND`] samples
/// more at both ends.
///
/// Panics where it is shorter, or `out` than twice [`LANES`].
pub fn double_row(row: &[u8], out: &mut [u8]) {
    for x in starts(out.len() / 2) {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| load(row, x + k));
        let [before, after] = [[d, c, b, a], [b, c, d, e]].map(quarter);
        let out = &mut out[2 * x..][..2 * LANES];
        out[..LANES].copy_from_slice(u8x16::unpack_low(before, after).as_array());
        out[LANES..].copy_from_slice(u8x16::unpack_high(before, after).as_array());
    }
}

/// Where each stretch of a row begins; the last one overlaps the one before.
fn starts(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by(LANES).map(move |x| x.min(count - LANES))
}

#[inline]
fn quarter(samples: [u8x16; 4]) -> u8x16 {
    let sums = |widen: fn(u8x16) -> i16x8| {
        let [a, b, c, d] = samples.map(widen);
        let [of_a, of_b, of_c, of_d] = WEIGHTS.map(i16x8::splat);
        let sum = i16x8::splat((1 << (BITS - 1)) - LESS) + a * of_a + b * of_b + c * of_c + d * of_d;
        sum.unbounded_shr_scalar(BITS) + i16x8::splat(LESS >> BITS)
    };
    u8x16::narrow_i16x8(sums(widen_low), sums(widen_high))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain([a, b, c, d]: [u8; 4]) -> u8 {
        let sum = [a, b, c, d].iter().zip(WEIGHTS).map(|(&v, w)| i32::from(v) * i32::from(w)).sum::<i32>();
        ((sum + 64) >> 7).clamp(0, 255) as u8
    }

    fn noise(count: usize, random: &mut oorandom::Rand32) -> Vec<u8> {
        // Most are at the ends, where sums are largest.
        (0..count).map(|_| (random.rand_range(0..1024) as i32 - 384).clamp(0, 255) as u8).collect()
    }

    #[test]
    fn a_row_between_rows_is_as_in_plain_arithmetic_at_every_width() {
        let mut random = oorandom::Rand32::new(5);
        for count in LANES..70 {
            let rows: [Vec<u8>; 4] = std::array::from_fn(|_| noise(count, &mut random));
            let mut out = vec![0; count];
            quarter_row(rows.each_ref().map(Vec::as_slice), &mut out);
            for x in 0..count {
                assert_eq!(out[x], plain(rows.each_ref().map(|row| row[x])));
            }
        }
    }

    #[test]
    fn a_doubled_row_is_as_in_plain_arithmetic_at_every_width() {
        let mut random = oorandom::Rand32::new(6);
        for count in LANES..70 {
            let row = noise(count + 2 * AROUND, &mut random);
            let mut out = vec![0; 2 * count];
            double_row(&row, &mut out);
            for x in 0..count {
                let at = |k: usize| row[x + k];
                assert_eq!(out[2 * x], plain([at(3), at(2), at(1), at(0)]));
                assert_eq!(out[2 * x + 1], plain([at(1), at(2), at(3), at(4)]));
            }
        }
    }
}
