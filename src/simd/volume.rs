//! Blurs of volumes of floats, whatever the axis, and what is made of the base that they give.

use super::lanes::{interleave_high, interleave_low, narrow, widen_high, widen_low};
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16};

/// Floats a step.
const LANES: usize = 4;

/// A float of this size has units of 1, so that adding it rounds.
const UNITS: f32 = (3 << 22) as f32;

/// Every sample moves away from its base by `amount` times its distance, or toward it where that is negative. Both
/// slices have one length; the base is 0..=255, the amount at most 100.
pub fn exaggerate(samples: &mut [u8], base: &[f32], amount: f32) {
    let (chunks, tail) = samples.as_chunks_mut::<16>();
    let (bases, base_tail) = base.as_chunks::<16>();
    for (chunk, base) in chunks.iter_mut().zip(bases) {
        let v = u8x16::new(*chunk);
        let (base, _) = base.as_chunks::<LANES>();
        let part = |lanes: i16x8, i: usize| {
            let halves = [interleave_low(lanes, i16x8::ZERO), interleave_high(lanes, i16x8::ZERO)];
            let [low, high] = [0, 1].map(|k| {
                let v = f32x4::from_i32x4(cast::<i16x8, i32x4>(halves[k]));
                let sum = v + f32x4::splat(amount) * (v - f32x4::new(base[i + k])) + f32x4::splat(UNITS);
                cast::<f32x4, i32x4>(sum) - i32x4::splat(UNITS.to_bits() as i32)
            });
            narrow(low, high)
        };
        *chunk = u8x16::narrow_i16x8(part(widen_low(v), 0), part(widen_high(v), 2)).to_array();
    }
    for (sample, &base) in tail.iter_mut().zip(base_tail) {
        *sample = exaggerate_one(*sample, base, amount);
    }
}

fn exaggerate_one(sample: u8, base: f32, amount: f32) -> u8 {
    let v = f32::from(sample);
    let sum = v + amount * (v - base) + UNITS;
    (sum.to_bits() as i32 - UNITS.to_bits() as i32).clamp(0, 255) as u8
}

/// `target[i]` = [1 4 6 4 1] / 16 of `source` at distances of `shift`; zeros lie beyond the ends. Both have one length.
pub fn binomial(source: &[f32], shift: usize, target: &mut [f32]) {
    let n = source.len();
    let edge = (2 * shift).min(n);
    let at = |i: usize, k: usize| (i + k).checked_sub(2 * shift).and_then(|i| source.get(i)).unwrap_or(&0.0);
    let one = |i: usize| {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| *at(i, k * shift));
        sum(a + e, b + d, c)
    };
    let inner_end = n.saturating_sub(2 * shift).max(edge);
    let whole = edge + (inner_end - edge) / LANES * LANES;
    for i in (0..edge).chain(whole..n) {
        target[i] = one(i);
    }
    let tap = |k: usize| source[k * shift..][..whole - edge].as_chunks::<LANES>().0;
    if whole == edge {
        return;
    }
    let (out, _) = target[edge..whole].as_chunks_mut::<LANES>();
    let taps = tap(0).iter().zip(tap(1)).zip(tap(2)).zip(tap(3)).zip(tap(4));
    for (out, ((((a, b), c), d), e)) in out.iter_mut().zip(taps) {
        let [a, b, c, d, e] = [a, b, c, d, e].map(|tap| f32x4::new(*tap));
        let sum = (a + e) * f32x4::splat(0.0625) + (b + d) * f32x4::splat(0.25) + c * f32x4::splat(0.375);
        *out = sum.to_array();
    }
}

fn sum(far: f32, near: f32, centre: f32) -> f32 {
    far * 0.0625 + near * 0.25 + centre * 0.375
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_equal_scalars_at_every_length_and_shift() {
        let mut random = oorandom::Rand32::new(6);
        for n in 1..=67usize {
            let source: Vec<f32> = (0..n).map(|_| random.rand_float()).collect();
            for shift in [1, 2, 3, 8, 31, 70] {
                let mut target = vec![9.0; n];
                binomial(&source, shift, &mut target);
                for (i, &target) in target.iter().enumerate() {
                    let v = |k: isize| {
                        let i = i as isize + k * shift as isize;
                        if (0..n as isize).contains(&i) { source[i as usize] } else { 0.0 }
                    };
                    let exact = (v(-2) + 4.0 * v(-1) + 6.0 * v(0) + 4.0 * v(1) + v(2)) / 16.0;
                    assert!((target - exact).abs() < 1e-6, "{n} {shift} {i}");
                }
            }
        }
    }

    #[test]
    fn lanes_and_scalars_exaggerate_alike() {
        let mut random = oorandom::Rand32::new(8);
        for n in 1..=67 {
            let before: Vec<u8> = (0..n).map(|_| random.rand_u32() as u8).collect();
            let base: Vec<f32> = (0..n).map(|_| random.rand_float() * 255.0).collect();
            for amount in [-1.0, -0.3, 0.5, 3.0] {
                let mut out = before.clone();
                exaggerate(&mut out, &base, amount);
                for i in 0..n {
                    assert_eq!(out[i], exaggerate_one(before[i], base[i], amount));
                    let exact = f32::from(before[i]) * (1.0 + amount) - amount * base[i];
                    assert!((f32::from(out[i]) - exact.clamp(0.0, 255.0)).abs() <= 0.51);
                }
            }
        }
    }
}
