//! Operations on the three channels of each pixel, in place, sixteen pixels at a time.
//!
//! A closure processes eight pixels as 16-bit lanes. Narrowing to u8 saturates, which is the clipping of the
//! formulas.

use super::lanes::{widen_high, widen_low};
use crate::raster::{Image, Plane};
use bytemuck::cast;
use wide::{i16x8, u8x16, u16x8};

/// Pixels a step.
const STEP: usize = 16;

/// Fixed-point weights of luma, Q15, summing to exactly 1: Y = .299 R + .587 G + .114 B.
const LUMA: [i16; 3] = [9798, 19235, 3735];

/// Applies `f` to the channels of all pixels. The three slices have one length.
#[inline]
pub fn map3(
    a: &mut [u8],
    b: &mut [u8],
    c: &mut [u8],
    f: impl Fn(i16x8, i16x8, i16x8) -> (i16x8, i16x8, i16x8),
) {
    map3_bytes(a, b, c, |x, y, z| {
        let low = f(widen_low(x), widen_low(y), widen_low(z));
        let high = f(widen_high(x), widen_high(y), widen_high(z));
        let narrow = u8x16::narrow_i16x8;
        [narrow(low.0, high.0), narrow(low.1, high.1), narrow(low.2, high.2)]
    });
}

/// Like `map3`, on sixteen bytes.
#[inline]
fn map3_bytes(a: &mut [u8], b: &mut [u8], c: &mut [u8], f: impl Fn(u8x16, u8x16, u8x16) -> [u8x16; 3]) {
    let step = |a: &mut [u8; STEP], b: &mut [u8; STEP], c: &mut [u8; STEP]| {
        let [x, y, z] = f(u8x16::new(*a), u8x16::new(*b), u8x16::new(*c));
        (*a, *b, *c) = (x.to_array(), y.to_array(), z.to_array());
    };
    let (a, a_tail) = a.as_chunks_mut::<STEP>();
    let (b, b_tail) = b.as_chunks_mut::<STEP>();
    let (c, c_tail) = c.as_chunks_mut::<STEP>();
    for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
        step(a, b, c);
    }
    let rest = a_tail.len();
    if rest > 0 {
        let (mut a, mut b, mut c) = ([0; STEP], [0; STEP], [0; STEP]);
        a[..rest].copy_from_slice(a_tail);
        b[..rest].copy_from_slice(b_tail);
        c[..rest].copy_from_slice(c_tail);
        step(&mut a, &mut b, &mut c);
        a_tail.copy_from_slice(&a[..rest]);
        b_tail.copy_from_slice(&b[..rest]);
        c_tail.copy_from_slice(&c[..rest]);
    }
}

/// Luma of eight pixels in 1/128 steps.
#[inline]
#[must_use]
pub fn luma_q7(r: i16x8, g: i16x8, b: i16x8) -> i16x8 {
    let term = |channel: i16x8, weight: i16| (channel << 7u32).mul_scale_round_n(weight);
    term(r, LUMA[0]) + term(g, LUMA[1]) + term(b, LUMA[2])
}

/// Rounds a fixed-point value of `BITS` fraction bits to an integer.
#[inline]
#[must_use]
pub fn round<const BITS: u32>(value: i16x8) -> i16x8 {
    value.saturating_add(i16x8::splat(1 << (BITS - 1))) >> BITS
}

/// The upper bytes of lanes. Saturated values need no clamp here. LLVM would add one to the saturation of the
/// narrowing instruction.
#[inline]
fn upper(low: i16x8, high: i16x8) -> u8x16 {
    let byte = |lanes: i16x8| cast::<u16x8, i16x8>(cast::<i16x8, u16x8>(lanes) >> 8u32);
    u8x16::narrow_i16x8(byte(low), byte(high))
}

/// Luma in 1/128 steps, rounded.
#[inline]
fn luma_bytes(low: i16x8, high: i16x8) -> u8x16 {
    // Doubled it still fits, without a sign.
    let doubled = |y: i16x8| y + y + i16x8::splat(128);
    upper(doubled(low), doubled(high))
}

/// Writes the luma of R, G, B into `y`. All slices have one length.
pub fn luma(r: &[u8], g: &[u8], b: &[u8], y: &mut [u8]) {
    let step = |r: &[u8; STEP], g: &[u8; STEP], b: &[u8; STEP], y: &mut [u8; STEP]| {
        let (r, g, b) = (u8x16::new(*r), u8x16::new(*g), u8x16::new(*b));
        let low = luma_q7(widen_low(r), widen_low(g), widen_low(b));
        let high = luma_q7(widen_high(r), widen_high(g), widen_high(b));
        *y = luma_bytes(low, high).to_array();
    };
    let (y_steps, y_tail) = y.as_chunks_mut::<STEP>();
    let (r_steps, r_tail) = r.as_chunks::<STEP>();
    let (g_steps, g_tail) = g.as_chunks::<STEP>();
    let (b_steps, b_tail) = b.as_chunks::<STEP>();
    for (((r, g), b), y) in r_steps.iter().zip(g_steps).zip(b_steps).zip(y_steps) {
        step(r, g, b, y);
    }
    let rest = y_tail.len();
    if rest > 0 {
        let padded = |tail: &[u8]| {
            let mut chunk = [0; STEP];
            chunk[..rest].copy_from_slice(tail);
            chunk
        };
        let mut y = [0; STEP];
        step(&padded(r_tail), &padded(g_tail), &padded(b_tail), &mut y);
        y_tail.copy_from_slice(&y[..rest]);
    }
}

/// The luma plane of an image.
#[must_use]
pub fn luma_plane(image: &Image) -> Plane {
    let [r, g, b] = image.planes() else { return image.planes()[0].clone() };
    let mut y = Plane::filled(image.width(), image.height(), 0);
    luma(r.samples(), g.samples(), b.samples(), y.samples_mut());
    y
}

/// R, G, B to luma in the first slice and, where `keep_chroma`, U and V around 128 in the others.
pub fn to_gray(r: &mut [u8], g: &mut [u8], b: &mut [u8], keep_chroma: bool) {
    // 1 / 1.772 and 1 / 1.402, Q15.
    const U: i16 = 18492;
    const V: i16 = 23372;
    map3_bytes(r, g, b, |r, g, b| {
        let low = luma_q7(widen_low(r), widen_low(g), widen_low(b));
        let high = luma_q7(widen_high(r), widen_high(g), widen_high(b));
        let y = luma_bytes(low, high);
        if !keep_chroma {
            return [y, g, b];
        }
        // 1/256 steps about neutral.
        let difference = |channel: i16x8, y: i16x8, weight: i16| {
            let half = ((channel << 7u32) - y).mul_scale_round_n(weight);
            half.saturating_add(half).saturating_add(i16x8::splat(128))
        };
        let chroma = |channel: u8x16, weight: i16| {
            let low = difference(widen_low(channel), low, weight);
            upper(low, difference(widen_high(channel), high, weight)) ^ u8x16::splat(NEUTRAL)
        };
        [y, chroma(b, U), chroma(r, V)]
    });
}

/// Neutral U and V, which is also the sign of a byte about them.
const NEUTRAL: u8 = 128;

/// Luma, U and V (around 128) to R, G, B: BT.601, full range. U and V must be real colours: if both are at an
/// end, which no colour has, G may be a few steps off.
pub fn to_color(y: &mut [u8], u: &mut [u8], v: &mut [u8]) {
    // 1.402 / 2, .344136, .714136 and 1.772 / 2, Q15.
    const RV: i16 = 22970;
    const GU: i16 = 11277;
    const GV: i16 = 23401;
    const BU: i16 = 29032;
    // In 1/256 steps around mid gray, saturation is the required clipping.
    let eight = |y: i16x8, u: i16x8, v: i16x8| {
        let (red, blue) = (v.mul_scale_round_n(RV), u.mul_scale_round_n(BU));
        let green = u.mul_scale_round_n(GU).saturating_add(v.mul_scale_round_n(GV));
        let twice = |part: i16x8| y.saturating_add(part).saturating_add(part);
        (twice(red), y.saturating_sub(green), twice(blue))
    };
    map3_bytes(y, u, v, |y, u, v| {
        let [y, u, v] = [y, u, v].map(|bytes| bytes ^ u8x16::splat(NEUTRAL));
        // The lower byte of luma is the half that rounds.
        let (half, zero) = (u8x16::splat(128), u8x16::ZERO);
        let low = |below: u8x16, bytes: u8x16| cast::<u8x16, i16x8>(u8x16::unpack_low(below, bytes));
        let high = |below: u8x16, bytes: u8x16| cast::<u8x16, i16x8>(u8x16::unpack_high(below, bytes));
        let first = eight(low(half, y), low(zero, u), low(zero, v));
        let last = eight(high(half, y), high(zero, u), high(zero, v));
        let colors = [upper(first.0, last.0), upper(first.1, last.1), upper(first.2, last.2)];
        colors.map(|bytes| bytes ^ u8x16::splat(NEUTRAL))
    });
}

/// Luma to R, G, B: Y + share * (255 - |2 Y - 255|), the shares as Q15. This is HSL with a fixed hue and
/// saturation: full colour in the middle tones, no colour in black and white.
pub fn tint(y: &mut [u8], g: &mut [u8], b: &mut [u8], shares: [i16; 3]) {
    let white = i16x8::splat(255);
    map3(y, g, b, |y, _, _| {
        let chroma = (white - (y + y - white).abs()) << 7u32;
        let channel = |share: i16| y + round::<7>(chroma.mul_scale_round_n(share));
        (channel(shares[0]), channel(shares[1]), channel(shares[2]))
    });
}

/// Moves every channel by the change of luma from `before` to `after`: new brightness, same colour
/// differences. All slices have one length.
pub fn shift_luma(channel: &mut [u8], before: &[u8], after: &[u8]) {
    zip3(channel, before, after, |channel, before, after| channel + (after - before));
}

/// Lays ink over a plane: `ink + (plane - ink) * lines / 255`. Both slices have one length.
pub fn lay_ink(plane: &mut [u8], lines: &[u8], ink: u8) {
    let ink = i16x8::splat(i16::from(ink));
    zip3(plane, lines, &[], |plane, lines, _| {
        // 128.5 * 255 is 32767: white lines do not change the plane.
        let share = (lines << 7u32) + (lines >> 1u32);
        ink + round::<7>(((plane - ink) << 7u32).mul_scale_round(share))
    });
}

/// `a = f(a, b, c)` for eight pixels at a time. `c` may be empty, which reads as zeros.
#[inline]
fn zip3(a: &mut [u8], b: &[u8], c: &[u8], f: impl Fn(i16x8, i16x8, i16x8) -> i16x8) {
    let step = |a: &mut [u8; STEP], b: &[u8; STEP], c: &[u8; STEP]| {
        let (x, y, z) = (u8x16::new(*a), u8x16::new(*b), u8x16::new(*c));
        let low = f(widen_low(x), widen_low(y), widen_low(z));
        let high = f(widen_high(x), widen_high(y), widen_high(z));
        *a = u8x16::narrow_i16x8(low, high).to_array();
    };
    let nothing = [0; STEP];
    let (a, a_tail) = a.as_chunks_mut::<STEP>();
    let (b, b_tail) = b.as_chunks::<STEP>();
    let (c, c_tail) = c.as_chunks::<STEP>();
    for (i, (a, b)) in a.iter_mut().zip(b).enumerate() {
        step(a, b, c.get(i).unwrap_or(&nothing));
    }
    let rest = a_tail.len();
    let padded = |tail: &[u8]| {
        let mut chunk = nothing;
        chunk[..tail.len()].copy_from_slice(tail);
        chunk
    };
    let mut last = padded(a_tail);
    step(&mut last, &padded(b_tail), &padded(c_tail));
    a_tail.copy_from_slice(&last[..rest]);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(n: usize, seed: u32) -> Vec<u8> {
        let mut random = oorandom::Rand32::new(u64::from(seed));
        (0..n).map(|_| random.rand_u32() as u8).collect()
    }

    #[test]
    fn luma_is_the_rounded_sum_at_every_width() {
        for n in 1..=67 {
            let (r, g, b) = (noise(n, 1), noise(n, 2), noise(n, 3));
            let mut y = vec![0; n];
            luma(&r, &g, &b, &mut y);
            for i in 0..n {
                let exact = 0.299 * f64::from(r[i]) + 0.587 * f64::from(g[i]) + 0.114 * f64::from(b[i]);
                assert!((f64::from(y[i]) - exact).abs() < 0.52, "{n} {i}: {} {exact}", y[i]);
            }
        }
        let mut y = [0; 2];
        luma(&[0, 255], &[0, 255], &[0, 255], &mut y);
        assert_eq!(y, [0, 255]);
    }

    #[test]
    fn ink_and_shifted_luma_follow_their_formulas_at_every_width() {
        for n in 1..=67 {
            let (plane, lines) = (noise(n, 8), noise(n, 9));
            for ink in [0, 16, 200, 255] {
                let mut out = plane.clone();
                lay_ink(&mut out, &lines, ink);
                for i in 0..n {
                    let ink = f64::from(ink);
                    let exact = ink + (f64::from(plane[i]) - ink) * f64::from(lines[i]) / 255.0;
                    assert!((f64::from(out[i]) - exact).abs() <= 1.0);
                }
            }
            let mut out = plane.clone();
            lay_ink(&mut out, &vec![255; n], 7);
            assert_eq!(out, plane);
            shift_luma(&mut out, &lines, &noise(n, 10));
            let after = noise(n, 10);
            let naive = |i: usize| i16::from(plane[i]) + i16::from(after[i]) - i16::from(lines[i]);
            assert!((0..n).all(|i| i16::from(out[i]) == naive(i).clamp(0, 255)));
        }
    }

    #[test]
    fn colours_come_back_from_luma_and_chroma_at_every_width() {
        let corners = [0, 255].repeat(4);
        for n in 1..=67 {
            let [r, g, b] = [1, 2, 3].map(|seed| {
                let mut channel = noise(n, seed * 100);
                let period = 1 << (seed - 1);
                channel.iter_mut().take(8).enumerate().for_each(|(i, v)| *v = corners[i / period % 2]);
                channel
            });
            let (mut y, mut u, mut v) = (r.clone(), g.clone(), b.clone());
            to_gray(&mut y, &mut u, &mut v, true);
            let mut gray = r.clone();
            to_gray(&mut gray, &mut g.clone(), &mut b.clone(), false);
            assert_eq!(gray, y);
            for i in 0..n {
                let [r, g, b] = [r[i], g[i], b[i]].map(f64::from);
                let exact = 0.299 * r + 0.587 * g + 0.114 * b;
                let chroma = [(b - exact) / 1.772 + 128.0, (r - exact) / 1.402 + 128.0];
                for (found, exact) in [y[i], u[i], v[i]].into_iter().zip([exact, chroma[0], chroma[1]]) {
                    assert!((f64::from(found) - exact.min(255.0)).abs() < 0.53, "{n} {i}: {found} {exact}");
                }
            }
            let before = [y.clone(), u.clone(), v.clone()];
            to_color(&mut y, &mut u, &mut v);
            for i in 0..n {
                let [luma, u_, v_] = [&before[0], &before[1], &before[2]].map(|plane| f64::from(plane[i]));
                let (u_, v_) = (u_ - 128.0, v_ - 128.0);
                let exact = [luma + 1.402 * v_, luma - 0.344_136 * u_ - 0.714_136 * v_, luma + 1.772 * u_];
                for (found, exact) in [y[i], u[i], v[i]].into_iter().zip(exact) {
                    assert!(
                        (f64::from(found) - exact.clamp(0.0, 255.0)).abs() < 0.53,
                        "{n} {i}: {found} {exact}"
                    );
                }
            }
        }
    }

    #[test]
    fn map3_treats_the_tail_like_the_rest() {
        for n in 1..=67 {
            let (mut a, mut b, mut c) = (noise(n, 4), noise(n, 5), noise(n, 6));
            let naive: Vec<u8> = (0..n)
                .map(|i| (i16::from(a[i]) + i16::from(b[i]) - i16::from(c[i])).clamp(0, 255) as u8)
                .collect();
            map3(&mut a, &mut b, &mut c, |a, b, c| (a + b - c, b, c));
            assert_eq!(a, naive);
        }
    }
}
