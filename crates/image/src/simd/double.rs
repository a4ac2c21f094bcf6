//! Doubles an image with Catmull-Rom. Its samples are at a quarter and three quarters between the samples of
//! the source. Four integer weights, in 128ths, are enough.

use super::mix::{LANES, load, load_part};
use bytemuck::cast;
use wide::{i16x8, u8x16, u16x8};

/// Samples before and after a row that its first and last outputs take: see [`double_columns`].
pub const MARGIN: usize = 2;

/// Sixteen samples as two halves of sixteen bits.
type Wide = [u16x8; 2];

#[inline]
fn widen(samples: u8x16) -> Wide {
    [u16x8::from_u8x16_low(samples), u16x8::from_u8x16_high(samples)]
}

/// The two outputs next to the middle one of five samples, a quarter of a sample before and after it.
/// Products of bytes and the weights that are above 0 fit sixteen bits without a sign; taking away the others
/// ends at 0, as clamping would.
#[inline]
fn beside([a, b, c, d, e]: [u8x16; 5]) -> [u8x16; 2] {
    let [a, b, c, d, e] = [a, b, c, d, e].map(widen);
    let times = |wide: Wide, weight: u16| wide.map(|half| half * u16x8::splat(weight));
    let plus = |one: Wide, other: Wide| [one[0] + other[0], one[1] + other[1]];
    let middle = times(c, 111).map(|half| half + u16x8::splat(64));
    let sum = |near: Wide, far: Wide, farther: Wide| {
        let (above, below) = (plus(middle, times(near, 29)), plus(times(far, 9), times(farther, 3)));
        let halves = [0, 1].map(|half| cast::<u16x8, i16x8>(above[half].saturating_sub(below[half]) >> 7u32));
        u8x16::narrow_i16x8(halves[0], halves[1])
    };
    [sum(b, d, a), sum(d, b, e)]
}

/// Between rows: the two about the middle one of five, all of one length.
pub fn double_rows(rows: [&[u8]; 5], [before, after]: [&mut [u8]; 2]) {
    let width = before.len();
    for at in (0..width).step_by(LANES) {
        let count = LANES.min(width - at);
        let loaded = rows.map(|row| if count == LANES { load(row, at) } else { load_part(&row[at..width]) });
        for (out, sums) in [&mut *before, &mut *after].into_iter().zip(beside(loaded)) {
            if count == LANES {
                out[at..at + LANES].copy_from_slice(sums.as_array());
            } else {
                out[at..].copy_from_slice(&sums.as_array()[..count]);
            }
        }
    }
}

/// Doubles the samples of a row. The row starts at [`MARGIN`] in `padded`, with as many samples before and
/// after it, then [`LANES`] samples of any value. `out` is twice as long as the row.
pub fn double_columns(padded: &[u8], out: &mut [u8]) {
    for (out, at) in out.chunks_mut(2 * LANES).zip((0..).step_by(LANES)) {
        let [before, after] = beside([0, 1, 2, 3, 4].map(|k| load(padded, at + k)));
        let pairs = [u8x16::unpack_low(before, after), u8x16::unpack_high(before, after)];
        let pairs: [u8; 2 * LANES] = cast(pairs);
        match <&mut [u8; 2 * LANES]>::try_from(&mut *out) {
            Ok(out) => *out = pairs,
            Err(_) => out.copy_from_slice(&pairs[..out.len()]),
        }
    }
}
