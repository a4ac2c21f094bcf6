//! Rows of the dual solver of Total Variation Flow, in 16-bit fixed point.
//!
//! Tones are centred on mid gray, with equal headroom above and below. Both fixed points follow from the
//! time, so that every product of a step stays a Q15 one:
//!
//! ```text
//! u  = f + t div p                        (tones)
//! q  = p + (tau / t) grad u
//! p  = q / max(1, |q|)                    (the dual field, two parts)
//! ```
//!
//! The reciprocal root comes from the exponent of |q|^2 (3 % off at most), which moves the result by a small part of
//! a grey step.

use super::lanes::{interleave_high, interleave_low, narrow, widen_high, widen_low};
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16, u16x8};

/// Samples a step.
const LANES: usize = 8;

/// Padding samples in front of a row. The first pixel reads the last of them.
pub const FRONT: usize = LANES;

/// Largest step of the ascent that converges.
const TAU: f32 = 0.25;

/// One row of an image under way: its tones and its dual field. The field is 0 in front of the row.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Tones, [`FRONT`] samples in.
    pub tones: Vec<i16>,
    /// The field's part along x, [`FRONT`] samples in.
    pub along: Vec<i16>,
    /// The field's part along y, [`FRONT`] samples in.
    pub down: Vec<i16>,
}

impl Row {
    /// Sets the width in pixels, and clears the field to 0.
    pub fn clear(&mut self, width: usize) {
        let length = padded(width);
        self.tones.resize(length, 0);
        for part in [&mut self.along, &mut self.down] {
            part.clear();
            part.resize(length, 0);
        }
    }
}

/// Samples of a row buffer: with one group of lanes before and one after the row.
#[must_use]
pub fn padded(width: usize) -> usize {
    FRONT + width.next_multiple_of(LANES) + LANES
}

/// The fixed-point constants of one time.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Fraction bits of a tone.
    tone_bits: u32,
    /// Fraction bits of the field.
    field_bits: u32,
    /// Half of t, from the field's units to tones, Q15.
    half_time: i16,
    /// tau / t, from tones to the field's units, Q15.
    rate: i16,
}

impl Scale {
    /// Constants for a time of .01 to 1000.
    #[must_use]
    pub fn new(time: f32) -> Self {
        let time = time.clamp(0.01, 1000.0);
        let tone_bits = if time < 60.0 {
            7
        } else if time < 250.0 {
            5
        } else {
            3
        };
        let tone = (1 << tone_bits) as f32;
        // The step of a full range of tones and the field before it fit an i16 together.
        let most = 0.85 * tone * time / TAU;
        let field_bits = most.log2().floor().clamp(0.0, 12.0) as u32;
        let field = (1 << field_bits) as f32;
        let q15 = |value: f32| (value * 32768.0).round().min(32767.0) as i16;
        Self {
            tone_bits,
            field_bits,
            half_time: q15(0.5 * time * tone / field),
            rate: q15(TAU / time * field / tone),
        }
    }
}

/// Reads a row of samples as tones.
pub fn read(samples: &[u8], scale: Scale, tones: &mut [i16]) {
    let one = i16x8::splat(1 << scale.tone_bits);
    let middle = i16x8::splat(128);
    let tones = &mut tones[FRONT..];
    let (chunks, tail) = samples.as_chunks::<16>();
    let (out, _) = tones.as_chunks_mut::<16>();
    for (out, chunk) in out.iter_mut().zip(chunks) {
        let bytes = u8x16::new(*chunk);
        let (low, high) = ((widen_low(bytes) - middle) * one, (widen_high(bytes) - middle) * one);
        out[..8].copy_from_slice(low.as_array());
        out[8..].copy_from_slice(high.as_array());
    }
    let done = samples.len() - tail.len();
    for (out, &sample) in tones[done..].iter_mut().zip(tail) {
        *out = (i16::from(sample) - 128) << scale.tone_bits;
    }
}

/// Reads two rows as one of half the resolution: means of 2 x 2, not rounded. Odd ends repeat the edge.
pub fn read_half(above: &[u8], below: &[u8], scale: Scale, tones: &mut [i16]) {
    let quarter = 1i16 << (scale.tone_bits - 2);
    let tones = &mut tones[FRONT..];
    let (above, above_tail) = above.as_chunks::<16>();
    let (below, below_tail) = below.as_chunks::<16>();
    let pairs = |bytes: &[u8; 16]| -> i16x8 {
        let pairs: u16x8 = cast(u8x16::new(*bytes));
        cast((pairs & u16x8::splat(255)) + (pairs >> 8u32))
    };
    let (groups, _) = tones.as_chunks_mut::<LANES>();
    for ((out, a), b) in groups.iter_mut().zip(above).zip(below) {
        *out = ((pairs(a) + pairs(b) - i16x8::splat(512)) * i16x8::splat(quarter)).to_array();
    }
    let tail = above_tail.chunks(2).zip(below_tail.chunks(2));
    for (out, (a, b)) in tones[above.len() * LANES..].iter_mut().zip(tail) {
        let sum = |pair: &[u8]| i16::from(pair[0]) + i16::from(pair[pair.len() - 1]);
        *out = (sum(a) + sum(b) - 512) * quarter;
    }
}

/// Returns the first field of a row from the row at half resolution, doubled in width and weakened. A field
/// that is too long would have to shrink again.
pub fn spread(coarse: &[i16], from: Scale, to: Scale, fine: &mut [i16]) {
    const SHARE: f32 = 0.7;
    let share = SHARE * 2.0f32.powi(to.field_bits as i32 - from.field_bits as i32) / 2.0;
    let share = i16x8::splat((share * 32768.0).round().min(32767.0) as i16);
    let (pairs, rest) = fine[FRONT..].as_chunks_mut::<{ 2 * LANES }>();
    let (coarse, _) = coarse[FRONT..].as_chunks::<LANES>();
    for (fine, coarse) in pairs.iter_mut().zip(coarse) {
        let half = i16x8::new(*coarse).mul_scale_round(share);
        let value = half + half;
        fine[..8].copy_from_slice(interleave_low(value, value).as_array());
        fine[8..].copy_from_slice(interleave_high(value, value).as_array());
    }
    if let (Some(coarse), [first, ..]) = (coarse.get(pairs.len()), rest.as_chunks_mut::<LANES>().0) {
        let half = i16x8::new(*coarse).mul_scale_round(share);
        *first = interleave_low(half + half, half + half).to_array();
    }
}

/// u of one row. `above` is the field's part along y one row up, zeros for the first row.
pub fn primal(row: &Row, above: &[i16], scale: Scale, u: &mut [i16]) {
    let half_time = i16x8::splat(scale.half_time);
    let n = steps(u);
    let u = groups_mut(u, n);
    let (tones, along) = (groups(&row.tones, FRONT, n), groups(&row.along, FRONT, n));
    let (left, down) = (groups(&row.along, FRONT - 1, n), groups(&row.down, FRONT, n));
    let above = groups(above, FRONT, n);
    for (i, u) in u.iter_mut().enumerate() {
        let divergence = lanes(along, i) - lanes(left, i) + (lanes(down, i) - lanes(above, i));
        *u = raise(lanes(tones, i), divergence, half_time).to_array();
    }
}

/// The last pixel's neighbour to the right repeats it.
pub fn close(u: &mut [i16], width: usize) {
    u[FRONT + width] = u[FRONT + width - 1];
}

/// One step of a row's field, given u here, and u of the row below, which is made in passing.
pub fn ascend(row: &mut Row, next: &Row, here: &[i16], below: &mut [i16], scale: Scale) {
    let half_time = i16x8::splat(scale.half_time);
    let n = steps(below);
    let below = groups_mut(below, n);
    let (tones, next_down) = (groups(&next.tones, FRONT, n), groups(&next.down, FRONT, n));
    let (next_along, next_left) = (groups(&next.along, FRONT, n), groups(&next.along, FRONT - 1, n));
    let (here, right) = (groups(here, FRONT, n), groups(here, FRONT + 1, n));
    let (along, down) = (groups_mut(&mut row.along, n), groups_mut(&mut row.down, n));
    let step = Step::new(scale);
    for i in 0..n {
        let field = (i16x8::new(along[i]), i16x8::new(down[i]));
        let divergence = lanes(next_along, i) - lanes(next_left, i) + (lanes(next_down, i) - field.1);
        let under = raise(lanes(tones, i), divergence, half_time);
        below[i] = under.to_array();
        let u = lanes(here, i);
        let (x, y) = step.apply(field, lanes(right, i).saturating_sub(u), under.saturating_sub(u));
        (along[i], down[i]) = (x.to_array(), y.to_array());
    }
}

/// Like [`ascend`], for the last row. Nothing changes below it.
pub fn ascend_last(row: &mut Row, here: &[i16], scale: Scale) {
    let n = steps(here);
    let (here, right) = (groups(here, FRONT, n), groups(here, FRONT + 1, n));
    let (along, down) = (groups_mut(&mut row.along, n), groups_mut(&mut row.down, n));
    let step = Step::new(scale);
    for i in 0..n {
        let field = (i16x8::new(along[i]), i16x8::new(down[i]));
        let (x, y) = step.apply(field, lanes(right, i).saturating_sub(lanes(here, i)), i16x8::ZERO);
        (along[i], down[i]) = (x.to_array(), y.to_array());
    }
}

/// Rounds u to samples.
pub fn write(u: &[i16], scale: Scale, samples: &mut [u8]) {
    let one = i16x8::splat(1 << (15 - scale.tone_bits));
    let middle = i16x8::splat(128);
    let (pairs, _) = u[FRONT..].as_chunks::<{ 2 * LANES }>();
    let (out, tail) = samples.as_chunks_mut::<16>();
    let sample = |u: &[i16]| lanes(groups(u, 0, 1), 0).mul_scale_round(one) + middle;
    for (out, u) in out.iter_mut().zip(pairs) {
        *out = u8x16::narrow_i16x8(sample(&u[..8]), sample(&u[8..])).to_array();
    }
    let done = out.len() * 16;
    let whole = 1 << scale.tone_bits;
    for (out, &u) in tail.iter_mut().zip(&u[FRONT + done..]) {
        *out = ((i32::from(u) + whole / 2).div_euclid(whole) + 128).clamp(0, 255) as u8;
    }
}

/// Groups of lanes that hold pixels.
#[inline]
fn steps(samples: &[i16]) -> usize {
    (samples.len() - FRONT) / LANES - 1
}

#[inline]
fn groups(samples: &[i16], from: usize, count: usize) -> &[[i16; LANES]] {
    &samples[from..from + count * LANES].as_chunks().0[..count]
}

#[inline]
fn groups_mut(samples: &mut [i16], count: usize) -> &mut [[i16; LANES]] {
    &mut samples[FRONT..FRONT + count * LANES].as_chunks_mut().0[..count]
}

#[inline]
fn lanes(groups: &[[i16; LANES]], i: usize) -> i16x8 {
    i16x8::new(groups[i])
}

#[inline]
fn raise(tones: i16x8, divergence: i16x8, half_time: i16x8) -> i16x8 {
    let half = divergence.mul_scale_round(half_time);
    tones.saturating_add(half).saturating_add(half)
}

/// The constants of the ascent on lanes.
struct Step {
    rate: i16x8,
    magic: i32x4,
}

/// The largest float below 1, in units of Q15.
const ALMOST_ONE: f32 = 1.0 - 1.0 / 32768.0;

/// A float of this size has units of 2^-15, so that adding it leaves a Q15 number in the low bits.
const UNITS: f32 = 256.0;

impl Step {
    fn new(scale: Scale) -> Self {
        Self { rate: i16x8::splat(scale.rate), magic: i32x4::splat(magic(scale.field_bits)) }
    }

    /// The field after a step along the gradient.
    #[inline]
    fn apply(&self, (x, y): (i16x8, i16x8), dx: i16x8, dy: i16x8) -> (i16x8, i16x8) {
        let (x, y) = (x + dx.mul_scale_round(self.rate), y + dy.mul_scale_round(self.rate));
        let (low, high) = (interleave_low(x, y), interleave_high(x, y));
        let shrink = narrow(self.shrink(low.dot(low)), self.shrink(high.dot(high)));
        (x.mul_scale_round(shrink), y.mul_scale_round(shrink))
    }

    /// min(1, 1 / root) of squares, Q15.
    #[inline]
    fn shrink(&self, squares: i32x4) -> i32x4 {
        let bits: i32x4 = cast(f32x4::from_i32x4(squares));
        // Positive floats are in the order of their bits, and the minimum of integers is one instruction.
        let root = (self.magic - (bits >> 1u32)).min(i32x4::splat(ALMOST_ONE.to_bits() as i32));
        let sum: i32x4 = cast(cast::<i32x4, f32x4>(root) + f32x4::splat(UNITS));
        sum - i32x4::splat(UNITS.to_bits() as i32)
    }
}

/// 1 / sqrt(v) has half the exponent of v with the opposite sign. Subtracting half of the bits of v from this
/// constant gives an approximation with a straight line instead of the curve of the mantissa. Multiplied by
/// 2^`field_bits`.
fn magic(field_bits: u32) -> i32 {
    (0x5f37_a000 + (field_bits << 23)) as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rounded(a: i16, b: i16) -> i16 {
        ((i32::from(a) * i32::from(b) + 0x4000) >> 15) as i16
    }

    fn noise(n: usize, most: i16, seed: u64) -> Vec<i16> {
        let mut random = oorandom::Rand32::new(seed);
        (0..n).map(|_| (random.rand_range(0..2 * most as u32) as i32 - i32::from(most)) as i16).collect()
    }

    /// The step of one pixel, without lanes.
    fn step(scale: Scale, (x, y): (i16, i16), dx: i16, dy: i16) -> (i16, i16) {
        let (x, y) = (x + rounded(dx, scale.rate), y + rounded(dy, scale.rate));
        let square = i32::from(x) * i32::from(x) + i32::from(y) * i32::from(y);
        let bits = magic(scale.field_bits).wrapping_sub((square as f32).to_bits() as i32 >> 1);
        let shrink = f32::from_bits(bits as u32).min(ALMOST_ONE) + UNITS;
        let shrink = (shrink.to_bits() - UNITS.to_bits()) as i16;
        (rounded(x, shrink), rounded(y, shrink))
    }

    #[test]
    fn lanes_equal_scalars_at_every_width_and_time() {
        for (width, time) in
            (1..=67).zip([0.05, 0.3, 1.0, 5.0, 7.9, 15.0, 40.0, 100.0, 300.0].into_iter().cycle())
        {
            let scale = Scale::new(time);
            let field = 1i16 << scale.field_bits;
            let length = padded(width);
            let row = |seed: u64| {
                let [mut along, down] = [1, 2].map(|i| noise(length, field, seed + i));
                along[FRONT - 1] = 0;
                Row { tones: noise(length, 128 << scale.tone_bits, seed), along, down }
            };
            let (mut first, second) = (row(3), row(9));
            let (before, zeros) = (first.clone(), vec![0; length]);
            let (mut here, mut below) = (vec![0; length], vec![0; length]);
            primal(&first, &zeros, scale, &mut here);
            close(&mut here, width);
            ascend(&mut first, &second, &here, &mut below, scale);
            let u = |row: &Row, above: &[i16], x: usize| {
                let divergence = row.along[x] - row.along[x - 1] + (row.down[x] - above[x]);
                let half = rounded(divergence, scale.half_time);
                row.tones[x].saturating_add(half).saturating_add(half)
            };
            for x in FRONT..FRONT + width {
                assert_eq!(here[x], u(&before, &zeros, x));
                assert_eq!(below[x], u(&second, &before.down, x));
                let (dx, dy) = (here[x + 1].saturating_sub(here[x]), below[x].saturating_sub(here[x]));
                let (along, down) = step(scale, (before.along[x], before.down[x]), dx, dy);
                assert_eq!((first.along[x], first.down[x]), (along, down), "{width} {time} {x}");
            }
            let mut last = before.clone();
            ascend_last(&mut last, &here, scale);
            let x = FRONT + width - 1;
            assert_eq!(last.along[x], step(scale, (before.along[x], before.down[x]), 0, 0).0);
        }
    }

    #[test]
    fn tones_come_back_as_they_were_and_halves_are_means() {
        let samples: Vec<u8> = (0..=255).collect();
        for time in [1.0, 100.0, 300.0] {
            let scale = Scale::new(time);
            for n in 1..=67 {
                let samples = &samples[n..2 * n];
                let (mut tones, mut out) = (vec![0; padded(n)], vec![0; n]);
                read(samples, scale, &mut tones);
                write(&tones, scale, &mut out);
                assert_eq!(out, samples);
                let half = n.div_ceil(2);
                let (mut tones, mut out) = (vec![0; padded(half)], vec![0; half]);
                read_half(samples, samples, scale, &mut tones);
                write(&tones, scale, &mut out);
                for (out, pair) in out.iter().zip(samples.chunks(2)) {
                    let exact = f32::midpoint(f32::from(pair[0]), f32::from(pair[pair.len() - 1]));
                    assert!((f32::from(*out) - exact).abs() <= 0.5);
                }
            }
        }
    }

    #[test]
    fn a_spread_field_is_the_coarse_one_weakened() {
        let (from, to) = (Scale::new(7.5), Scale::new(15.0));
        for width in 1..=67usize {
            let coarse = noise(padded(width.div_ceil(2)), 1 << from.field_bits, 4);
            let mut fine = vec![0; padded(width)];
            spread(&coarse, from, to, &mut fine);
            for x in 0..width {
                let (fine, coarse) = (f32::from(fine[FRONT + x]), f32::from(coarse[FRONT + x / 2]));
                let (fine, coarse) =
                    (fine / (1 << to.field_bits) as f32, coarse / (1 << from.field_bits) as f32);
                assert!((fine - 0.7 * coarse).abs() < 0.002, "{width} {x}");
            }
        }
    }
}
