//! Screens by the power spectrum: how far dots or lines are apart that repeat over a picture.
//!
//! ```text
//! P(f)  = sum over patches of |FFT(window (patch - mean))|^2
//! E(r)  = mean over the ring of P r^2                             natural pictures fall by about 1 / r^2, so theirs is even
//! peak  = the r where E stands highest above its neighbourhood on a logarithmic axis
//! ```
//!
//! One transform processes two patches as its real and imaginary part. The sum of their powers is the mean of
//! |Z(k)|^2 and
//! |Z(-k)|^2. The transform is a plain radix-2 FFT. The libraries that `tract` uses support any length, with
//! more code than this whole module.
//!
//! Source: Field, "Relations between the statistics of natural images and the response properties of cortical cells", 1987
//! (the spectrum of natural pictures).

use crate::order::sort_by;
use crate::raster::Plane;
use crate::simd::fft;
use serde::{Deserialize, Serialize};
use std::f32::consts::{PI, TAU};

/// Side of a patch.
const SIDE: usize = 128;

/// A row of a patch.
type Row = [f32; SIDE];

/// Patches, at most; an even number.
const PATCHES: usize = 12;

/// Range of rings that can hold a peak: periods from a tenth of a patch down to about two pixels.
const RINGS: (usize, usize) = (4, 60);

/// Minimum height of a peak above its neighbourhood for a screen, as a natural logarithm. Tiles, roofs and
/// fences in photos are below, screens and hatching of built-in styles above.
pub(super) const CLEAR: f32 = 1.35;

/// A repeating pattern, such as a dot screen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Screen {
    /// Distance of the dots or lines, in pixels of a 1920 x 1080 picture; 0 if nothing repeats.
    pub pitch: f32,
    /// Strength of the peak: the natural logarithm of its power relative to its surroundings.
    pub strength: f32,
    /// Share of the power of its ring in the strongest directions, 0 (all equal) to 1. Dots and straight
    /// lines have much, grain and curved lines have little.
    pub directed: f32,
}

/// The screen of a picture. `scale` is pixels of the picture for one of a 1920 x 1080 picture.
pub(super) fn screen(luma: &Plane, scale: f32) -> Screen {
    let power = power(luma);
    let mut energy = [0.0f32; SIDE / 2];
    let mut counts = [0u32; SIDE / 2];
    for_each(|at, radius| {
        let ring = radius.round() as usize;
        if ring < SIDE / 2 {
            energy[ring] += power[at] * radius * radius;
            counts[ring] += 1;
        }
    });
    for (energy, &count) in energy.iter_mut().zip(&counts) {
        *energy = (*energy / count.max(1) as f32 + 1.0).ln();
    }
    let Some((ring, strength)) = peak(&energy) else {
        return Screen { pitch: 0.0, strength: 0.0, directed: 0.0 };
    };
    // A parabola through the three rings around it, on the even scale of logarithms.
    let [before, here, after] = [energy[ring - 1], energy[ring], energy[ring + 1]];
    let bend = before - 2.0 * here + after;
    let exact = ring as f32 + if bend < 0.0 { 0.5 * (before - after) / bend } else { 0.0 }.clamp(-0.5, 0.5);
    let pitch = if strength >= CLEAR { SIDE as f32 / exact / scale } else { 0.0 };
    Screen { pitch, strength, directed: directed(&power, ring) }
}

/// Returns the ring with the highest peak above its neighbourhood, and the height of the peak.
fn peak(energy: &[f32; SIDE / 2]) -> Option<(usize, f32)> {
    let mut best: Option<(usize, f32)> = None;
    for ring in RINGS.0..=RINGS.1 {
        // Frequencies around the peak, without the peak itself: 0.4 to 0.7 times and 1.4 to 1.8 times its
        // frequency.
        let around = |range: std::ops::RangeInclusive<usize>| {
            let rings = &energy[*range.start()..=(*range.end()).min(SIDE / 2 - 1)];
            if rings.is_empty() { f32::INFINITY } else { rings.iter().sum::<f32>() / rings.len() as f32 }
        };
        let below = around((ring * 4 / 10).max(2)..=(ring * 7 / 10).max(2));
        let above = if ring * 14 / 10 < SIDE / 2 - 1 {
            around(ring * 14 / 10..=ring * 18 / 10)
        } else {
            around(SIDE / 2 - 2..=SIDE / 2 - 1)
        };
        let higher = energy[ring] - f32::midpoint(below, above);
        let top = energy[ring] >= energy[ring - 1] && energy[ring] >= energy[ring + 1];
        if top && best.is_none_or(|(_, known)| higher > known) {
            best = Some((ring, higher));
        }
    }
    best
}

/// Returns the share of a ring's power in its strongest eighth of directions, beyond an eighth.
fn directed(power: &[f32], ring: usize) -> f32 {
    const SECTORS: usize = 24;
    let mut sectors = [0.0f32; SECTORS];
    let mut index = 0;
    for_each(|at, radius| {
        if (radius - ring as f32).abs() <= 1.0 {
            let (x, y) = place(index);
            let turn = (y as f32).atan2(x as f32) / PI + 1.0;
            sectors[(turn * SECTORS as f32) as usize % SECTORS] += power[at];
        }
        index += 1;
    });
    let total: f32 = sectors.iter().sum();
    sort_by(&mut sectors, |a, b| b.total_cmp(a));
    let strongest: f32 = sectors[..SECTORS / 8].iter().sum();
    ((strongest / total.max(f32::MIN_POSITIVE) - 0.125) / 0.875).clamp(0.0, 1.0)
}

/// Signed frequencies of the entry that `for_each` visits as its `index`th: half the plane, as the other mirrors it.
fn place(index: usize) -> (isize, isize) {
    let half = SIDE as isize / 2;
    ((index % SIDE) as isize - half, (index / SIDE) as isize)
}

/// Visits half the plane of frequencies: position in the spectrum, and radius.
fn for_each(mut visit: impl FnMut(usize, f32)) {
    let wrapped = |k: isize| k.rem_euclid(SIDE as isize) as usize;
    for index in 0..SIDE * SIDE / 2 {
        let (x, y) = place(index);
        visit(wrapped(y) * SIDE + wrapped(x), ((x * x + y * y) as f32).sqrt());
    }
}

/// The summed power of patches that are spread over a picture.
fn power(luma: &Plane) -> Vec<f32> {
    let mut power = vec![0.0; SIDE * SIDE];
    let window: Vec<f32> = (0..SIDE).map(|i| 0.5 - 0.5 * (TAU * i as f32 / SIDE as f32).cos()).collect();
    let turns = fft::turns(SIDE);
    let places = places(luma.width(), luma.height());
    let (mut re, mut im) = (vec![[0.0; SIDE]; SIDE], vec![[0.0; SIDE]; SIDE]);
    for pair in places.chunks(2) {
        cut(luma, pair[0], &window, &mut re);
        cut(luma, *pair.last().unwrap_or(&pair[0]), &window, &mut im);
        transform(&mut re, &mut im, &turns);
        for (out, (re, im)) in power.iter_mut().zip(re.as_flattened().iter().zip(im.as_flattened())) {
            *out += re * re + im * im;
        }
    }
    // The power of both patches of a pair is the mean of the two mirrored halves.
    let mirrored = |at: usize| (SIDE - at / SIDE) % SIDE * SIDE + (SIDE - at % SIDE) % SIDE;
    (0..SIDE * SIDE).map(|at| f32::midpoint(power[at], power[mirrored(at)])).collect()
}

/// Corners of patches, spread evenly; one where the picture holds no more.
fn places(width: usize, height: usize) -> Vec<(usize, usize)> {
    let count = |length: usize, most: usize| (length / (SIDE * 3 / 4)).clamp(1, most);
    let columns = count(width, 4);
    let rows = count(height, PATCHES / columns);
    let spread = |i: usize, count: usize, length: usize| {
        let room = length.saturating_sub(SIDE);
        if count > 1 { room * i / (count - 1) } else { room / 2 }
    };
    (0..columns * rows)
        .map(|i| (spread(i % columns, columns, width), spread(i / columns, rows, height)))
        .collect()
}

/// Copies a patch without its mean under a window. Pixels outside of the picture have the mean value.
fn cut(luma: &Plane, (left, top): (usize, usize), window: &[f32], out: &mut [Row]) {
    let (width, height) = (SIDE.min(luma.width()), SIDE.min(luma.height()));
    let rows = (top..top + height).map(|y| &luma.row(y)[left..left + width]);
    let sum: u32 = rows.clone().flatten().map(|&tone| u32::from(tone)).sum();
    let mean = sum as f32 / (width * height) as f32;
    out.fill([0.0; SIDE]);
    for (y, row) in rows.enumerate() {
        for (x, &tone) in row.iter().enumerate() {
            out[y][x] = (f32::from(tone) - mean) * window[x] * window[y];
        }
    }
}

/// The transform of a patch, in place: of its rows, as the columns of the transposed, then of its columns.
fn transform(re: &mut [Row], im: &mut [Row], turns: &[[f32; 2]]) {
    for _ in 0..2 {
        for y in 0..SIDE {
            for x in 0..y {
                (re[y][x], re[x][y]) = (re[x][y], re[y][x]);
                (im[y][x], im[x][y]) = (im[x][y], im[y][x]);
            }
        }
        columns(re, im, turns);
    }
}

/// A radix-2 transform of each column, after bit reversal. All columns do each step together, so that SIMD
/// registers hold neighbours.
fn columns(re: &mut [Row], im: &mut [Row], turns: &[[f32; 2]]) {
    for i in 0..SIDE {
        let j = fft::reversed(i, SIDE);
        if i < j {
            re.swap(i, j);
            im.swap(i, j);
        }
    }
    fft::steps(SIDE, |a, b, turn| {
        let ((re_above, re_below), (im_above, im_below)) = (re.split_at_mut(b), im.split_at_mut(b));
        butterfly((&mut re_above[a], &mut im_above[a]), (&mut re_below[0], &mut im_below[0]), turns[turn]);
    });
}

/// Replaces two rows by their sum and difference after rotating the second one. Each row has a real and an
/// imaginary part.
fn butterfly((re_a, im_a): (&mut Row, &mut Row), (re_b, im_b): (&mut Row, &mut Row), [cos, sin]: [f32; 2]) {
    for i in 0..SIDE {
        let (x, y) = (re_b[i] * cos - im_b[i] * sin, re_b[i] * sin + im_b[i] * cos);
        (re_b[i], im_b[i]) = (re_a[i] - x, im_a[i] - y);
        (re_a[i], im_a[i]) = (re_a[i] + x, im_a[i] + y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_is_that_of_its_definition() {
        let signal = |x: usize, y: usize| ((x * 37 + y * y * 11) % 101) as f32;
        let mut re: Vec<Row> = (0..SIDE).map(|y| std::array::from_fn(|x| signal(x, y))).collect();
        let mut im = vec![[0.0; SIDE]; SIDE];
        transform(&mut re, &mut im, &fft::turns(SIDE));
        for (k, l) in [(0, 0), (1, 0), (0, 1), (5, 9), (64, 3), (127, 126)] {
            let term = |i: usize| {
                let (x, y) = (i % SIDE, i / SIDE);
                let turn = std::f64::consts::TAU * (x * k + y * l) as f64 / SIDE as f64;
                f64::from(signal(x, y)) * turn.cos()
            };
            let expected: f64 = (0..SIDE * SIDE).map(term).sum();
            assert!((f64::from(re[l][k]) - expected).abs() < 1.0, "{k} {l}: {} {expected}", re[l][k]);
        }
    }

    #[test]
    fn a_grid_of_dots_has_its_pitch_and_noise_has_none() {
        for pitch in [3.2f32, 5.0, 8.0, 14.5] {
            let wave = |v: f32| (v * TAU / pitch).cos();
            let dots = Plane::from_fn(400, 260, |x, y| {
                let (x, y) = (x as f32, y as f32);
                let (u, v) = (0.8 * x + 0.6 * y, 0.8 * y - 0.6 * x);
                // Hard dots would have harmonics that a grid of pixels folds back to coarse waves.
                (125.0 + 45.0 * (wave(u) + wave(v))) as u8
            });
            let found = screen(&dots, 1.0);
            assert!((found.pitch / pitch - 1.0).abs() < 0.06, "{pitch}: {found:?}");
            assert!(found.directed > 0.4, "{found:?}");
        }
        let mut random = oorandom::Rand32::new(3);
        let noise = Plane::from_fn(400, 260, |_, _| random.rand_range(0..256) as u8);
        assert!(screen(&noise, 1.0).strength < CLEAR, "{:?}", screen(&noise, 1.0));
        assert!(screen(&Plane::filled(50, 20, 90), 1.0).pitch.abs() < f32::EPSILON);
    }
}
