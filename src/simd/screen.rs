//! Screens on lanes: the separation of inks, the printing of a row through its thresholds, and the choice of a
//! pattern for each tone.

use super::lanes::{narrow, widen_high, widen_low};
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16};

/// Pixels a step.
const STEP: usize = 16;

/// Fraction bits of a ramp's slope.
pub const SLOPE_BITS: u32 = 4;

/// How each pixel of a row takes ink: none up to a coverage of `start`, all of it `width` later. The slices have
/// one length, which is that of the row or more.
#[derive(Clone, Copy, Debug)]
pub struct Ramps<'a> {
    /// Coverages at which ink begins, 0..=255.
    pub start: &'a [u8],
    /// Coverages from there to solid ink, at least 1.
    pub width: &'a [u8],
    /// 255 / width, with [`SLOPE_BITS`] fraction bits, rounded up.
    pub slope: &'a [i16],
}

/// Multiplies a row by its paper: `out * (255 - ink) / 255`, where ink follows the ramps of the wanted `coverage`.
pub fn print(coverage: &[u8], ramps: Ramps<'_>, out: &mut [u8]) {
    let n = out.len();
    let (chunks, tail) = out.as_chunks_mut::<STEP>();
    let (coverages, coverage_tail) = coverage[..n].as_chunks::<STEP>();
    let (starts, start_tail) = ramps.start[..n].as_chunks::<STEP>();
    let (widths, width_tail) = ramps.width[..n].as_chunks::<STEP>();
    let (slopes, slope_tail) = ramps.slope[..n].as_chunks::<STEP>();
    let parts = coverages.iter().zip(starts).zip(widths).zip(slopes);
    for (out, (((coverage, start), width), slope)) in chunks.iter_mut().zip(parts) {
        let depth = u8x16::new(*coverage).saturating_sub(u8x16::new(*start)).min(u8x16::new(*width));
        let [low, high] = halves(slope);
        let print = |paper: i16x8, depth: i16x8, slope: i16x8| {
            let ink = (depth * slope) >> SLOPE_BITS;
            let rest = i16x8::splat(255) - ink.min(i16x8::splat(255));
            // 128.5 * 255 is 32767: bare paper stays exactly as it is.
            paper.mul_scale_round((rest << 7u32) + (rest >> 1u32))
        };
        let paper = u8x16::new(*out);
        let low = print(widen_low(paper), widen_low(depth), low);
        let high = print(widen_high(paper), widen_high(depth), high);
        *out = u8x16::narrow_i16x8(low, high).to_array();
    }
    let parts = coverage_tail.iter().zip(start_tail).zip(width_tail).zip(slope_tail);
    for (out, (((&coverage, &start), &width), &slope)) in tail.iter_mut().zip(parts) {
        *out = print_one(coverage, (start, width, slope), *out);
    }
}

fn print_one(coverage: u8, (start, width, slope): (u8, u8, i16), paper: u8) -> u8 {
    let depth = i32::from(coverage.saturating_sub(start).min(width));
    let rest = 255 - ((depth * i32::from(slope)) >> SLOPE_BITS).min(255);
    ((i32::from(paper) * ((rest << 7) + (rest >> 1)) + 0x4000) >> 15) as u8
}

/// Samples in `row` become those of their level's row in `patterns`: level floor(sample * levels / 256). The rows
/// are as long as `row` or longer, and there are at most 255.
pub fn select(row: &mut [u8], patterns: &[Vec<u8>]) {
    let levels = patterns.len();
    // The smallest sample with floor(sample * levels / 256) >= level.
    let from = |level: usize| (256 * level).div_ceil(levels) as u8;
    let (chunks, tail) = row.as_chunks_mut::<STEP>();
    let whole = chunks.len() * STEP;
    for (i, chunk) in chunks.iter_mut().enumerate() {
        let samples = u8x16::new(*chunk);
        let mut out = super::mix::load(&patterns[0], i * STEP);
        for (level, pattern) in patterns.iter().enumerate().skip(1) {
            let reached = samples.simd_ge(u8x16::splat(from(level)));
            out = reached.bitselect(super::mix::load(pattern, i * STEP), out);
        }
        *chunk = out.to_array();
    }
    for (x, sample) in (whole..).zip(tail) {
        *sample = patterns[usize::from(*sample) * levels / 256][x];
    }
}

fn halves(slope: &[i16; STEP]) -> [i16x8; 2] {
    let (halves, _) = slope.as_chunks::<8>();
    [0, 1].map(|i| i16x8::new(halves[i]))
}

/// Coverages of cyan, magenta, yellow and black for a row of R, G and B: black is what white lacks of the
/// brightest channel, the others what the channels lack of it, as shares of it. All slices have one length.
pub fn separate([r, g, b]: [&[u8]; 3], [c, m, y, k]: [&mut [u8]; 4]) {
    let n = r.len();
    let whole = n - n % STEP;
    let steps = |row: &'_ [u8], i: usize| -> u8x16 {
        let mut lanes = [0; STEP];
        lanes.copy_from_slice(&row[i..i + STEP]);
        u8x16::new(lanes)
    };
    for i in (0..whole).step_by(STEP) {
        let [r, g, b] = [r, g, b].map(|row| steps(row, i));
        let inks = separate_step(r, g, b);
        for (row, ink) in [&mut *c, &mut *m, &mut *y, &mut *k].into_iter().zip(inks) {
            row[i..i + STEP].copy_from_slice(ink.as_array());
        }
    }
    if whole < n {
        let padded = |row: &[u8]| {
            let mut lanes = [0; STEP];
            lanes[..n - whole].copy_from_slice(&row[whole..]);
            u8x16::new(lanes)
        };
        let inks = separate_step(padded(r), padded(g), padded(b));
        for (row, ink) in [c, m, y, k].into_iter().zip(inks) {
            row[whole..].copy_from_slice(&ink.as_array()[..n - whole]);
        }
    }
}

#[inline]
fn separate_step(r: u8x16, g: u8x16, b: u8x16) -> [u8x16; 4] {
    let most = r.max(g).max(b);
    let (low, high) = (shares(widen_low(most)), shares(widen_high(most)));
    let ink = |channel: u8x16| {
        let lack = most - channel;
        // Half of the share at first: 255 / 1 in Q7 just fits.
        let part = |lack: i16x8, share: i16x8| {
            let half = (lack << 7u32).mul_scale_round(share);
            half + half
        };
        u8x16::narrow_i16x8(part(widen_low(lack), low), part(widen_high(lack), high))
    };
    [ink(r), ink(g), ink(b), u8x16::splat(255) - most]
}

/// 255 / v in Q7, for v of 1 to 255; 0 counts as 1.
#[inline]
fn shares(v: i16x8) -> i16x8 {
    const UNIT: f32 = (1 << 23) as f32;
    let v = v.max(i16x8::splat(1));
    let share = |v: i32x4| {
        let quotient = f32x4::splat(255.0 * 128.0) / f32x4::from_i32x4(v);
        // Rounds to a whole number in the low bits.
        cast::<f32x4, i32x4>(quotient + f32x4::splat(UNIT)) - i32x4::splat(UNIT.to_bits() as i32)
    };
    let zero = i16x8::ZERO;
    let low: i32x4 = cast(super::lanes::interleave_low(v, zero));
    let high: i32x4 = cast(super::lanes::interleave_high(v, zero));
    narrow(share(low), share(high))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(n: usize, seed: u64) -> Vec<u8> {
        let mut random = oorandom::Rand32::new(seed);
        (0..n).map(|_| random.rand_u32() as u8).collect()
    }

    #[test]
    fn printing_on_lanes_equals_printing_one_by_one() {
        for n in 1..=67 {
            let (coverage, start, paper) = (noise(n, 1), noise(n, 2), noise(n, 3));
            let width: Vec<u8> = noise(n, 4).iter().map(|&w| w.max(1)).collect();
            let slope: Vec<i16> =
                width.iter().map(|&w| (255 << SLOPE_BITS as i16) / i16::from(w) + 1).collect();
            let mut out = paper.clone();
            print(&coverage, Ramps { start: &start, width: &width, slope: &slope }, &mut out);
            for i in 0..n {
                let one = print_one(coverage[i], (start[i], width[i], slope[i]), paper[i]);
                assert_eq!(out[i], one);
                let ink = f32::from(coverage[i].saturating_sub(start[i]).min(width[i])) / f32::from(width[i]);
                let exact = f32::from(paper[i]) * (1.0 - ink);
                assert!((f32::from(one) - exact).abs() <= 17.0 * f32::from(width[i]) / 255.0 + 2.0);
            }
        }
    }

    #[test]
    fn inks_are_what_the_channels_lack() {
        for n in 1..=67 {
            let rows = [noise(n, 5), noise(n, 6), noise(n, 7)];
            let mut inks = [0; 4].map(|_| vec![0; n]);
            let [c, m, y, k] = &mut inks;
            separate([&rows[0], &rows[1], &rows[2]], [c, m, y, k]);
            for i in 0..n {
                let most = rows.iter().map(|row| row[i]).max().unwrap();
                assert_eq!(inks[3][i], 255 - most);
                for (ink, row) in inks.iter().zip(&rows) {
                    let exact = f32::from(most - row[i]) * 255.0 / f32::from(most.max(1));
                    assert!((f32::from(ink[i]) - exact).abs() <= 1.5, "{} {exact}", ink[i]);
                }
            }
        }
    }

    #[test]
    fn each_sample_takes_the_pattern_of_its_level() {
        for (levels, n) in (2..=8usize).cycle().zip(1..=67).chain((2..=8).map(|levels| (levels, 256))) {
            let patterns: Vec<Vec<u8>> = (0..levels).map(|level| vec![level as u8; n]).collect();
            let before: Vec<u8> = (0..n).map(|x| (x * 255 / n.max(255) * 7 % 256) as u8 ^ x as u8).collect();
            let mut row = before.clone();
            select(&mut row, &patterns);
            for (&level, &y) in row.iter().zip(&before) {
                assert_eq!(usize::from(level), usize::from(y) * levels / 256);
            }
        }
    }
}
