//! Rotated halftone grids on SIMD lanes. The dot size follows the tone. The output is the remaining white
//! paper.
//!
//! Everything about a dot is an area here. With d the distance of a pixel from the centre of its dot, in
//! cells, and r the radius of the dot for the ink coverage:
//!
//! ```text
//! phase  = frac of the turned position, 2^16 for a cell, about the centre        (wraps by itself)
//! reach  = 2^15 d^2          size = 2^15 r^2
//! ink    = clamp((r^2 - d^2) pitch / 2r + 1/2)
//! ```
//!
//! The ramp is a pixel wide, and linear in the area rather than in the distance: no roots, and it covers what
//! the dot without a ramp does. Before dots meet, r^2 is v / pi for the ink v. After that a polynomial
//! corrects for their overlap.

use super::lanes::{narrow, widen_high, widen_low};
use super::mix::load;
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16, u16x8};

/// Pixels a step.
const STEP: usize = 16;

/// Pixels whose phases are stored relative to the first of them.
const SEGMENT: usize = 64;

/// A cell, in the units of a position.
const CELL: f64 = 4_294_967_296.0;

/// 2^15 / (255 pi): the area of one step of ink.
const AREA: i16 = 41;

/// The sharpness of the ramp: at half of its width the product with the slope is this.
const HALF: f32 = 1024.0;

/// From this ink level on, sizes differ from v / pi: dots begin to overlap, and their ramps meet in the
/// corners between four dots.
const MEETING: u8 = 180;

/// A grid of dots. Positions are in cells, as 32-bit fractions of one, which wrap.
pub struct Screen {
    /// Steps of both turned coordinates for a pixel to the right.
    across: [u32; 2],
    /// The phase step for one pixel down.
    down: [u32; 2],
    /// Phases of a segment's pixels relative to its first, both coordinates in turn, for four pixels at a time; even.
    phases: [[[i16; 8]; STEP / 4]; SEGMENT / STEP],
    /// Larger differences of area mean full ink or no ink.
    limit: i16,
    /// A power of two that brings the limit near the largest lane.
    zoom: i16,
    /// Slope of the ramp for inks of 0..16 and, by sixteens, for the others; units of 1/128 of the steepest.
    slopes: [u8x16; 2],
    /// Size added for ink above [`MEETING`], in 1/128, and for its fourth power, in 1/2^26.
    meeting: [i16; 2],
}

impl Screen {
    /// A grid turned by an angle, given by its cosine and sine, with `pitch` pixels (at least 2) between dots.
    #[must_use]
    pub fn new((cos, sin): (f64, f64), pitch: f64) -> Self {
        let fraction = |step: f64| (step / pitch * CELL).round() as i64 as u32;
        let across = [fraction(cos), fraction(-sin)];
        // Half of the ramp at the largest radius, 1 / sqrt(2), is the widest.
        let widest = std::f64::consts::FRAC_1_SQRT_2 / pitch * f64::from(1 << 15);
        let zoom = (32767.0 / widest).log2().floor().clamp(0.0, 14.0) as u32;
        let slope = |ink: f32| {
            let radius = (ink / (255.0 * std::f32::consts::PI)).sqrt();
            let half = radius / pitch as f32 * 32768.0 * (1 << zoom) as f32;
            (HALF * 128.0 / half).round().clamp(1.0, 127.0) as u8
        };
        let low = std::array::from_fn(|ink| slope(ink.max(1) as f32));
        let high = std::array::from_fn(
            |sixteens| if sixteens == 0 { 0 } else { slope(sixteens as f32 * 16.0 + 8.0) },
        );
        Self {
            across,
            down: [fraction(sin), fraction(cos)],
            phases: std::array::from_fn(|step| {
                std::array::from_fn(|group| {
                    let x = (step * STEP + group * 4) as u32;
                    std::array::from_fn(|i| phase(across[i % 2].wrapping_mul(x + i as u32 / 2)) & !1)
                })
            }),
            limit: (32767 >> zoom) as i16,
            zoom: 1 << zoom,
            slopes: [u8x16::new(low), u8x16::new(high)],
            meeting: meeting(pitch),
        }
    }

    /// Writes the paper of row `y`: 255 without ink. `ink` is 0..=255; both have one length.
    pub fn print(&self, y: usize, ink: &[u8], paper: &mut [u8]) {
        self.run::<false>(y, ink, paper);
    }

    /// Multiplies a row by the paper of row `y`.
    pub fn overprint(&self, y: usize, ink: &[u8], row: &mut [u8]) {
        self.run::<true>(y, ink, row);
    }

    /// Writes the paper, or multiplies the existing values by it if `OVER`.
    fn run<const OVER: bool>(&self, y: usize, ink: &[u8], out: &mut [u8]) {
        for (i, (ink, out)) in ink.chunks(SEGMENT).zip(out.chunks_mut(SEGMENT)).enumerate() {
            self.segment::<OVER>(self.start(i * SEGMENT, y), 0, ink, out);
        }
    }

    /// Draws pixels of a segment, beginning `at` pixels into it. `start` are the phases of its first.
    fn segment<const OVER: bool>(&self, start: i16x8, at: usize, ink: &[u8], out: &mut [u8]) {
        let (inks, ink_tail) = ink.as_chunks::<STEP>();
        let (outs, out_tail) = out.as_chunks_mut::<STEP>();
        for (k, (&ink, out)) in inks.iter().zip(outs).enumerate() {
            // One colour ink in three is in no pixel, often for many pixels in a row.
            if u128::from_ne_bytes(ink) == 0 {
                if !OVER {
                    *out = [255; STEP];
                }
                continue;
            }
            let (ink, at) = (u8x16::new(ink), at + k * STEP);
            let over = ink.saturating_sub(u8x16::splat(MEETING));
            let white = if cast::<u8x16, u128>(over) == 0 {
                self.white(start, at, ink, |ink, _| ink * i16x8::splat(AREA))
            } else {
                let over = [raise_low(over), raise_high(over)];
                self.white(start, at, ink, |ink, half| self.size(ink, over[half]))
            };
            *out = if OVER { multiply(u8x16::new(*out), white) } else { white }.to_array();
        }
        if !ink_tail.is_empty() {
            let [mut ink, mut last] = [[0; STEP]; 2];
            ink[..ink_tail.len()].copy_from_slice(ink_tail);
            last[..out_tail.len()].copy_from_slice(out_tail);
            // Through the same loop: a second copy of it would only make the module larger.
            self.segment::<OVER>(start, at + inks.len() * STEP, &ink, &mut last);
            out_tail.copy_from_slice(&last[..out_tail.len()]);
        }
    }

    /// Both phases of a pixel, in turn.
    fn start(&self, x: usize, y: usize) -> i16x8 {
        let [u, v] = [0, 1].map(|i| {
            let position =
                self.across[i].wrapping_mul(x as u32).wrapping_add(self.down[i].wrapping_mul(y as u32));
            // A cell's centre is at half of it, so there the phase is 0. An odd phase is never the least lane: the sum
            // of two squares fits.
            phase(position.wrapping_add(1 << 31)) | 1
        });
        i16x8::new([u, v, u, v, u, v, u, v])
    }

    /// The paper of sixteen pixels, `at` pixels into the segment that begins with the phases `start`. `size` gives
    /// 2^15 r^2 of the radius that covers an ink, for the lower and the upper eight.
    #[inline]
    fn white(&self, start: i16x8, at: usize, ink: u8x16, size: impl Fn(i16x8, usize) -> i16x8) -> u8x16 {
        let slope =
            self.slopes[0].shuffle_zeroing(ink) | self.slopes[1].shuffle_zeroing(ink.unbounded_shr_scalar(4));
        let groups = &self.phases[at / STEP % (SEGMENT / STEP)];
        let half = |half: usize, ink: i16x8, slope: i16x8| {
            let four = |group: usize| {
                let phases = start + i16x8::new(groups[group]);
                phases.dot(phases) >> 17u32
            };
            let reach = narrow(four(2 * half), four(2 * half + 1));
            let beyond =
                (reach - size(ink, half)).max(i16x8::splat(-self.limit)).min(i16x8::splat(self.limit))
                    * i16x8::splat(self.zoom);
            beyond.mul_scale_round(slope).saturating_add(i16x8::splat(HALF as i16)) >> 3u32
        };
        let low = half(0, widen_low(ink), raise_low(slope));
        let high = half(1, widen_high(ink), raise_high(slope));
        // No ink leaves no dot, also in the middle of a cell, and full ink no gap in its corners.
        let white = u8x16::narrow_i16x8(low, high) | ink.simd_eq(u8x16::ZERO);
        ink.simd_eq(u8x16::splat(255)).bitselect(u8x16::ZERO, white)
    }

    /// 2^15 r^2 of the radius that covers an ink. `over` is the ink above [`MEETING`], in 1/256.
    #[inline]
    fn size(&self, ink: i16x8, over: i16x8) -> i16x8 {
        let [first, fourth] = self.meeting;
        let half = over.mul_scale_round(over);
        let square = half + half;
        ink * i16x8::splat(AREA)
            + over.mul_scale_round(i16x8::splat(first))
            + square.mul_scale_round(square).mul_scale_round(i16x8::splat(fourth))
    }
}

/// The polynomial for inks above [`MEETING`], fitted to the coverage at pitches of 4 to 120: wide ramps meet
/// earlier. The covered area is then within 2.5 of 255 steps of the ink.
fn meeting(pitch: f64) -> [i16; 2] {
    let ramps = 1.0 / (pitch * pitch);
    let first = (500.0 * ramps - 0.7).min(40.0) * 128.0;
    let fourth = 1.31e-4 * (1.0 - 5.5 * ramps).max(0.0) * f64::from(1 << 26);
    [first.round() as i16, fourth.round() as i16]
}

/// The lower eight bytes, all below 128, as the upper halves of lanes.
#[inline]
fn raise_low(bytes: u8x16) -> i16x8 {
    cast(u8x16::unpack_low(u8x16::ZERO, bytes))
}

/// Like the other function, for the upper eight bytes.
#[inline]
fn raise_high(bytes: u8x16) -> i16x8 {
    cast(u8x16::unpack_high(u8x16::ZERO, bytes))
}

/// The upper half of a position, as a phase about 0.
fn phase(position: u32) -> i16 {
    ((position.wrapping_add(1 << 15)) >> 16) as u16 as i16
}

/// a b / 255, rounded.
#[inline]
fn multiply(a: u8x16, b: u8x16) -> u8x16 {
    // The byte twice is 257 b; half of that is 32767 for 255, a Q15 of one.
    let share = |twice: u8x16| cast::<u16x8, i16x8>(cast::<u8x16, u16x8>(twice) >> 1u32);
    let low = widen_low(a).mul_scale_round(share(u8x16::unpack_low(b, b)));
    let high = widen_high(a).mul_scale_round(share(u8x16::unpack_high(b, b)));
    u8x16::narrow_i16x8(low, high)
}

/// Converts a row to C, M, Y and K (0..=255): K = 255 - max, C = 255 (max - R) / max, and M and Y in the same
/// way. All rows have one length.
pub fn separate(colors: [&[u8]; 3], inks: &mut [Vec<u8>; 4]) {
    let width = colors[0].len();
    for x in (0..width - width % STEP).step_by(STEP) {
        let out = separate_lanes(colors.map(|row| load(row, x)));
        for (ink, out) in inks.iter_mut().zip(out) {
            ink[x..x + STEP].copy_from_slice(&out.to_array());
        }
    }
    let done = width - width % STEP;
    if done < width {
        let out = separate_lanes(colors.map(|row| {
            let mut last = [0; STEP];
            last[..width - done].copy_from_slice(&row[done..]);
            u8x16::new(last)
        }));
        for (ink, out) in inks.iter_mut().zip(out) {
            ink[done..width].copy_from_slice(&out.to_array()[..width - done]);
        }
    }
}

#[inline]
fn separate_lanes([r, g, b]: [u8x16; 3]) -> [u8x16; 4] {
    let most = r.max(g).max(b);
    let (low, high) = (share(widen_low(most)), share(widen_high(most)));
    let ink = |channel: u8x16| {
        // At most 255 in steps of 1/256, and the half that rounds: this fits without a sign.
        let missing = most - channel;
        let part = |missing: i16x8, share: u16x8| {
            let product = cast::<i16x8, u16x8>(missing) * share + u16x8::splat(128);
            cast::<u16x8, i16x8>(product >> 8u32)
        };
        u8x16::narrow_i16x8(part(widen_low(missing), low), part(widen_high(missing), high))
    };
    [ink(r), ink(g), ink(b), !most]
}

/// 255 * 256 / most, rounded; anything where that is 0.
#[inline]
fn share(most: i16x8) -> u16x8 {
    /// A float of this size has units of 1, so that adding it rounds into the low bits.
    const UNITS: f32 = (1 << 23) as f32;
    let pairs = cast::<i16x8, i32x4>(most);
    let divided = |most: i32x4| {
        let quotient = f32x4::splat(255.0 * 256.0) / f32x4::from_i32x4(most) + f32x4::splat(UNITS);
        cast::<f32x4, i32x4>(quotient)
    };
    let low = i32x4::splat(0xffff);
    cast((divided(pairs & low) & low) | (divided(pairs >> 16u32) << 16u32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_1_SQRT_2;

    fn noise(n: usize, seed: u64) -> Vec<u8> {
        let mut random = oorandom::Rand32::new(seed);
        (0..n).map(|_| random.rand_u32() as u8).collect()
    }

    /// White share of a pixel, in plain floats: the formulas of the module's documentation, with size and
    /// slope of an ink like the SIMD code.
    fn white(turn: (f64, f64), pitch: f64, (x, y): (usize, usize), ink: u8) -> f64 {
        match ink {
            0 => return 255.0,
            255 => return 0.0,
            _ => {}
        }
        let (x, y) = (x as f64, y as f64);
        let from_center = |position: f64| (position / pitch).rem_euclid(1.0) - 0.5;
        let (u, v) = (from_center(turn.0 * x + turn.1 * y), from_center(turn.0 * y - turn.1 * x));
        let over = f64::from(ink.saturating_sub(MEETING));
        let [first, fourth] = meeting(pitch).map(f64::from);
        let more = first / 128.0 * over + fourth / f64::from(1 << 26) * over.powi(4);
        let square = (f64::from(AREA) * f64::from(ink) + more) / 32768.0;
        let stored = if ink < 16 { f64::from(ink) } else { f64::from(ink / 16 * 16 + 8) };
        let radius = (stored / (255.0 * std::f64::consts::PI)).sqrt();
        255.0 - (((square - u * u - v * v) * pitch / (2.0 * radius) + 0.5) * 255.0).clamp(0.0, 255.0)
    }

    #[test]
    fn lanes_print_what_the_formulas_say_at_every_width() {
        let turns = [(1.0, 0.0), (FRAC_1_SQRT_2, FRAC_1_SQRT_2), (0.8, 0.6)];
        for ((width, turn), pitch) in
            (1..=67).zip(turns.into_iter().cycle()).zip([6.0, 8.0, 11.3].into_iter().cycle())
        {
            let (width, screen) = (if width == 67 { 4000 } else { width }, Screen::new(turn, pitch));
            let ink = noise(width, width as u64);
            for y in [0, 1, 3999] {
                let mut paper = vec![9; width];
                screen.print(y, &ink, &mut paper);
                for x in 0..width {
                    let exact = white(turn, pitch, (x, y), ink[x]);
                    assert!(
                        (f64::from(paper[x]) - exact).abs() <= 14.0,
                        "{width} {pitch} {y} {x}: {} {exact} {}",
                        paper[x],
                        ink[x]
                    );
                }
                let before = noise(width, 5);
                let mut row = before.clone();
                screen.overprint(y, &ink, &mut row);
                for x in 0..width {
                    let exact = f64::from(before[x]) * f64::from(paper[x]) / 255.0;
                    assert!((f64::from(row[x]) - exact).abs() <= 0.51);
                }
            }
        }
    }

    #[test]
    fn colours_come_apart_in_inks_at_every_width() {
        for width in (1..=67).chain([2000]) {
            let colors = [1, 2, 3].map(|seed| noise(width, seed * 100 + width as u64));
            let mut inks = [0; 4].map(|_| vec![0; width]);
            separate(colors.each_ref().map(Vec::as_slice), &mut inks);
            for x in 0..width {
                let most = colors.iter().map(|row| row[x]).max().unwrap();
                assert_eq!(inks[3][x], 255 - most);
                for (ink, color) in inks.iter().zip(&colors) {
                    let exact = 255.0 * f64::from(most - color[x]) / f64::from(most.max(1));
                    assert!((f64::from(ink[x]) - exact).abs() <= 1.0, "{} {most} {exact}", ink[x]);
                }
            }
        }
    }
}
