//! Weighted sums of rows of bytes, sixteen bytes at a time, and the transposition of 16 x 16 tiles.
//!
//! Two sources are interleaved and multiplied in pairs by one 16-bit dot product, which sums them in 32 bits:
//! nothing is lost before the one rounding at the end.

use super::lanes::{narrow, widen_high, widen_low};
use bytemuck::cast;
use wide::{i16x8, i32x4, u8x16, u16x8};

/// Bytes an operation.
pub const LANES: usize = 16;

/// The weights of two neighbouring sources, repeated over the lanes; units of a [`Precision`].
#[derive(Clone, Copy, Debug)]
pub struct Pair(i16x8);

impl Pair {
    /// Weights of the first and the second source.
    #[must_use]
    pub fn new(first: i16, second: i16) -> Self {
        Self(i16x8::new([first, second, first, second, first, second, first, second]))
    }
}

/// Fraction bits of the weights: of two precisions, since only shifts by a constant are one instruction
/// everywhere.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Precision {
    /// The weights sum to 2^14.
    Coarse,
    /// The weights sum to 2^19.
    Fine,
}

impl Precision {
    /// The finest precision at which `largest` (a part of the sum) fits into an i16.
    #[must_use]
    pub fn for_weight(largest: f64) -> Self {
        if largest < 1.0 / 17.0 { Self::Fine } else { Self::Coarse }
    }

    /// Fraction bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::Coarse => 14,
            Self::Fine => 19,
        }
    }
}

/// Sixteen rounded, clamped weighted sums of the sources, which come in pairs. The weights must sum to 1 in
/// the given precision.
#[must_use]
pub fn mix(sources: impl Iterator<Item = (Pair, [u8x16; 2])>, precision: Precision) -> u8x16 {
    match precision {
        Precision::Coarse => mix_at::<{ Precision::Coarse.bits() }>(sources),
        Precision::Fine => mix_at::<{ Precision::Fine.bits() }>(sources),
    }
}

fn mix_at<const BITS: u32>(sources: impl Iterator<Item = (Pair, [u8x16; 2])>) -> u8x16 {
    let start = i32x4::splat(1 << (BITS - 1));
    // Four names rather than an array, which would live on the stack.
    let (mut sum0, mut sum1, mut sum2, mut sum3) = (start, start, start, start);
    for (Pair(weights), [a, b]) in sources {
        let (low, high) = (u8x16::unpack_low(a, b), u8x16::unpack_high(a, b));
        sum0 += widen_low(low).dot(weights);
        sum1 += widen_high(low).dot(weights);
        sum2 += widen_low(high).dot(weights);
        sum3 += widen_high(high).dot(weights);
    }
    let [a, b, c, d] = [sum0, sum1, sum2, sum3].map(|sum| sum.unbounded_shr_scalar(BITS));
    // The rest is far inside an i16, and the last step clamps.
    u8x16::narrow_i16x8(narrow(a, b), narrow(c, d))
}

/// Writes the sum of weighted rows to `out`. The rows start at the given offsets in `source`, two per pair.
/// Each is at least as long as `out`.
pub fn mix_rows(source: &[u8], offsets: &[usize], pairs: &[Pair], precision: Precision, out: &mut [u8]) {
    let (offsets, _) = offsets.as_chunks::<2>();
    let whole = out.len() - out.len() % LANES;
    let (chunks, rest) = out.as_chunks_mut::<LANES>();
    for (i, chunk) in chunks.iter_mut().enumerate() {
        let loaded = |rows: &[usize; 2]| rows.map(|row| load(source, row + i * LANES));
        *chunk =
            mix(pairs.iter().zip(offsets).map(|(&pair, rows)| (pair, loaded(rows))), precision).to_array();
    }
    if !rest.is_empty() {
        let loaded = |rows: &[usize; 2]| rows.map(|row| load_part(&source[row + whole..][..rest.len()]));
        let sums = mix(pairs.iter().zip(offsets).map(|(&pair, rows)| (pair, loaded(rows))), precision);
        rest.copy_from_slice(&sums.as_array()[..rest.len()]);
    }
}

/// Means of 2 x 2 bytes of two rows, halves rounded up. The rows are twice as long as `out`.
pub fn halve_row(above: &[u8], below: &[u8], out: &mut [u8]) {
    let (above, above_tail) = above.as_chunks::<{ 2 * LANES }>();
    let (below, below_tail) = below.as_chunks::<{ 2 * LANES }>();
    let (out, tail) = out.as_chunks_mut::<LANES>();
    for ((out, above), below) in out.iter_mut().zip(above).zip(below) {
        *out = halve(above, below).to_array();
    }
    if !tail.is_empty() {
        let padded = |rest: &[u8]| {
            let mut bytes = [0; 2 * LANES];
            bytes[..rest.len()].copy_from_slice(rest);
            bytes
        };
        tail.copy_from_slice(&halve(&padded(above_tail), &padded(below_tail)).as_array()[..tail.len()]);
    }
}

#[inline]
fn halve(above: &[u8; 2 * LANES], below: &[u8; 2 * LANES]) -> u8x16 {
    let sums = |at: usize| {
        let pairs = |bytes: &[u8]| {
            let pairs: u16x8 = cast(load(bytes, at));
            (pairs & u16x8::splat(255)) + (pairs >> 8u32)
        };
        cast::<u16x8, i16x8>((pairs(above) + pairs(below) + u16x8::splat(2)) >> 2u32)
    };
    u8x16::narrow_i16x8(sums(0), sums(LANES))
}

/// Sixteen bytes of `source` from `at`. Panics when it holds fewer.
#[must_use]
pub fn load(source: &[u8], at: usize) -> u8x16 {
    let mut lanes = [0; LANES];
    lanes.copy_from_slice(&source[at..at + LANES]);
    u8x16::new(lanes)
}

/// Fewer than sixteen bytes, the rest zeros.
#[must_use]
pub fn load_part(source: &[u8]) -> u8x16 {
    let mut lanes = [0; LANES];
    lanes[..source.len()].copy_from_slice(source);
    u8x16::new(lanes)
}

/// Turns rows into columns: four rounds in which every vector meets the one half a tile away.
#[must_use]
pub fn transpose(tile: [u8x16; LANES]) -> [u8x16; LANES] {
    // Written out, because in a loop over arrays the compiler puts the tile into memory.
    let round = |[a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]: [u8x16; LANES]| {
        let (low, high) = (u8x16::unpack_low, u8x16::unpack_high);
        let first =
            [low(a, i), high(a, i), low(b, j), high(b, j), low(c, k), high(c, k), low(d, l), high(d, l)];
        let last =
            [low(e, m), high(e, m), low(f, n), high(f, n), low(g, o), high(g, o), low(h, p), high(h, p)];
        cast::<[[u8x16; LANES / 2]; 2], [u8x16; LANES]>([first, last])
    };
    round(round(round(round(tile))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn rows_are_mixed_as_in_plain_arithmetic(
            length in 1usize..70,
            bytes in proptest::collection::vec(any::<u8>(), 70 * 4..70 * 4 + 1),
            first in -4000i16..16000,
            second in -4000i16..16000,
            third in -4000i16..16000,
        ) {
            let fourth = 16384 - i32::from(first) - i32::from(second) - i32::from(third);
            prop_assume!((-32768..32768).contains(&fourth));
            let weights = [first, second, third, fourth as i16];
            let pairs = [Pair::new(first, second), Pair::new(third, fourth as i16)];
            let mut out = vec![0; length];
            mix_rows(&bytes, &[0, 70, 140, 210], &pairs, Precision::Coarse, &mut out);
            for (x, &out) in out.iter().enumerate() {
                let sum: i32 = weights.iter().enumerate().map(|(k, &w)| i32::from(w) * i32::from(bytes[k * 70 + x])).sum();
                prop_assert_eq!(i32::from(out), ((sum + 8192) >> 14).clamp(0, 255));
            }
        }
    }

    #[test]
    fn halves_are_rounded_means_at_every_width() {
        let mut random = oorandom::Rand32::new(2);
        for n in 1..=67usize {
            let [above, below] =
                [(); 2].map(|()| (0..2 * n).map(|_| random.rand_u32() as u8).collect::<Vec<u8>>());
            let mut out = vec![0; n];
            halve_row(&above, &below, &mut out);
            for (x, &out) in out.iter().enumerate() {
                let sum: u32 = [&above, &below]
                    .iter()
                    .flat_map(|row| &row[2 * x..2 * x + 2])
                    .map(|&v| u32::from(v))
                    .sum();
                assert_eq!(u32::from(out), (sum + 2) / 4);
            }
        }
    }

    #[test]
    fn a_tile_is_transposed() {
        let tile = std::array::from_fn(|y| u8x16::new(std::array::from_fn(|x| (y * 16 + x) as u8)));
        for (x, column) in transpose(tile).into_iter().enumerate() {
            assert_eq!(column.to_array(), std::array::from_fn(|y| (y * 16 + x) as u8));
        }
    }
}
