//! Gradient magnitudes of rows.

use super::lanes::{interleave_high, interleave_low, narrow, widen_high, widen_low};
use super::mix::load;
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16};

/// Pixels a step.
const STEP: usize = 16;

/// A float of this size has units of 1, so that adding it rounds.
const UNITS: f32 = (1 << 23) as f32;

/// Sobel magnitudes times `gain`, xored with `flip`, of the pixels that have both neighbours: `out[i]` belongs to
/// column `i + 1` of the three rows, which are two longer than `out`.
pub fn sobel(rows: [&[u8]; 3], gain: f32, flip: u8, out: &mut [u8]) {
    let n = out.len();
    if n < STEP {
        let mut padded = [[0; STEP + 2]; 3];
        for (padded, row) in padded.iter_mut().zip(rows) {
            padded[..n + 2].copy_from_slice(&row[..n + 2]);
        }
        let [above, here, below] = &padded;
        out.copy_from_slice(&step([above, here, below], 0, gain, flip).as_array()[..n]);
        return;
    }
    for x in (0..n - STEP).step_by(STEP).chain([n - STEP]) {
        out[x..x + STEP].copy_from_slice(step(rows, x, gain, flip).as_array());
    }
}

#[inline]
fn step(rows: [&[u8]; 3], x: usize, gain: f32, flip: u8) -> u8x16 {
    let [above, here, below] = rows;
    let corners = [load(above, x), load(above, x + 2), load(below, x), load(below, x + 2)];
    let sides = [load(above, x + 1), load(below, x + 1), load(here, x), load(here, x + 2)];
    let low = magnitudes(corners.map(widen_low), sides.map(widen_low), gain);
    let high = magnitudes(corners.map(widen_high), sides.map(widen_high), gain);
    u8x16::narrow_i16x8(low, high) ^ u8x16::splat(flip)
}

#[inline]
fn magnitudes([a, c, g, i]: [i16x8; 4], [b, h, d, f]: [i16x8; 4], gain: f32) -> i16x8 {
    let (falling, rising) = (i - a, c - g);
    let (across, down) = (f - d, h - b);
    let dx = falling + rising + across + across;
    let dy = falling - rising + down + down;
    let root = |pairs: i16x8| {
        let squares = f32x4::from_i32x4(pairs.dot(pairs));
        let sum = squares.sqrt() * f32x4::splat(gain) + f32x4::splat(UNITS);
        cast::<f32x4, i32x4>(sum) - i32x4::splat(UNITS.to_bits() as i32)
    };
    narrow(root(interleave_low(dx, dy)), root(interleave_high(dx, dy)))
}

/// The magnitude of one gradient.
#[must_use]
pub fn magnitude(dx: i16, dy: i16, gain: f32) -> u8 {
    let (dx, dy) = (i32::from(dx), i32::from(dy));
    let sum = ((dx * dx + dy * dy) as f32).sqrt() * gain + UNITS;
    (sum.to_bits() as i32 - UNITS.to_bits() as i32).clamp(0, 255) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_equal_scalars_at_every_width() {
        let mut random = oorandom::Rand32::new(2);
        for n in 0..=67 {
            let rows = [0; 3].map(|_| (0..n + 2).map(|_| random.rand_u32() as u8).collect::<Vec<_>>());
            for (gain, flip) in [(0.25, 0), (0.025, 255), (2.0, 0)] {
                let mut out = vec![0; n];
                sobel([&rows[0], &rows[1], &rows[2]], gain, flip, &mut out);
                for (x, &out) in out.iter().enumerate() {
                    let v = |row: usize, x: usize| i16::from(rows[row][x]);
                    let dx = v(0, x + 2) - v(0, x) + 2 * (v(1, x + 2) - v(1, x)) + v(2, x + 2) - v(2, x);
                    let dy = v(2, x) - v(0, x) + 2 * (v(2, x + 1) - v(0, x + 1)) + v(2, x + 2) - v(0, x + 2);
                    assert_eq!(out, magnitude(dx, dy, gain) ^ flip);
                }
            }
        }
    }
}
