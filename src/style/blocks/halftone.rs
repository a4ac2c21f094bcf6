//! Halftone: dots of ink on a turned grid, as offset printing lays them.
//!
//! Inks from colour: K = 1 - max, C = (max - R) / max, M and Y alike. A dot of coverage v holds the share v of its
//! cell's pixels that are nearest to its centre, with an edge one pixel soft. Inks multiply.
//!
//! A screen is a lattice whose cells repeat after a whole number of pixels along two turned vectors (rational
//! screening): all its thresholds lie in a short strip, of which every row of the image is a stretch.

use super::{Block, Channels, Kernel};
use crate::error::Result;
use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;
use crate::simd::screen::{self, Ramps};
use crate::style::context::Context;
use crate::style::params::{Kind, Param, Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "halftone",
    label: "Halftone",
    help: "Prints with dots of ink, in four colours or in black.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number("pitch", "Pitch", "Distance between dots.", (8.0, 3.0, 40.0, 0.5), Unit::Pixels),
        Param {
            id: "mode",
            label: "Inks",
            help: "Cyan, magenta, yellow and black, or black alone.",
            kind: Kind::Choice { names: &["cmyk", "mono"] },
        },
    ],
    kernel: Kernel::Image(|args, image, context| {
        // Below two pixels a grid of dots aliases into nonsense.
        let pitch = args.pixels(0).max(2.0);
        if image.is_luma() || args.choice(1) == 1 {
            mono(&image, pitch, context)
        } else {
            cmyk(image, pitch, context)
        }
    }),
};

/// Angles of the inks in degrees: the ones that printers use, so that no two grids beat visibly.
const CYAN: f32 = 15.0;
const MAGENTA: f32 = 75.0;
const YELLOW: f32 = 0.0;
const BLACK: f32 = 45.0;

fn mono(image: &Image, pitch: f32, context: &mut Context<'_>) -> Result<Image> {
    let was_luma = image.is_luma();
    let mut y = luma_plane(image);
    let screen = Screen::new(BLACK, pitch, y.width());
    let mut ink = context.take_plane(y.width(), 1);
    for row in 0..y.height() {
        let samples = y.row_mut(row);
        for (ink, &sample) in ink.samples_mut().iter_mut().zip(samples.iter()) {
            *ink = 255 - sample;
        }
        samples.fill(255);
        screen::print(ink.samples(), screen.row(row), samples);
    }
    context.give_plane(ink);
    if was_luma {
        return Ok(Image::from_luma(y));
    }
    let copies = [context.copy_plane(&y), context.copy_plane(&y)];
    let [g, b] = copies;
    Image::from_rgb([y, g, b])
}

fn cmyk(mut image: Image, pitch: f32, context: &mut Context<'_>) -> Result<Image> {
    let (width, height) = (image.width(), image.height());
    let [cyan, magenta, yellow, black] =
        [CYAN, MAGENTA, YELLOW, BLACK].map(|angle| Screen::new(angle, pitch, width));
    let mut inks = [0; 4].map(|_| context.take_plane(width, 1));
    let mut key = context.take_plane(width, 1);
    let [r, g, b] = image.planes_mut() else { return Ok(image) };
    for y in 0..height {
        if y % 64 == 0 {
            context.check_cancelled()?;
        }
        let [c, m, yellows, k] = inks.each_mut().map(Plane::samples_mut);
        screen::separate([r.row(y), g.row(y), b.row(y)], [c, m, yellows, k]);
        key.samples_mut().fill(255);
        screen::print(inks[3].samples(), black.row(y), key.samples_mut());
        let rows = [r.row_mut(y), g.row_mut(y), b.row_mut(y)];
        for ((row, ink), screen) in rows.into_iter().zip(&inks).zip([&cyan, &magenta, &yellow]) {
            row.copy_from_slice(key.samples());
            screen::print(ink.samples(), screen.row(y), row);
        }
    }
    for plane in inks.into_iter().chain([key]) {
        context.give_plane(plane);
    }
    Ok(image)
}

/// A turned grid of dots, as thresholds. Row y begins at `shift * (y / rows)` in the strip `y % rows`, modulo `period`.
struct Screen {
    rows: usize,
    period: usize,
    shift: usize,
    /// Samples of a strip: the period, and an image's width more.
    length: usize,
    start: Vec<u8>,
    width: Vec<u8>,
    slope: Vec<i16>,
}

/// Side of the square that repeats, in pixels, at most: finer angles and pitches are not visible.
const MAX_SIDE: f32 = 72.0;

impl Screen {
    fn new(degrees: f32, pitch: f32, width: usize) -> Self {
        let (cells, (a, b)) = lattice(degrees, pitch);
        // Rows repeat after a multiple of g; i and j lead from one such row to the next.
        let (g, i, j) = extended_gcd(b, a);
        let (area, rows) = ((a * a + b * b) as usize, g as usize);
        let period = area / rows;
        let shift = (j * b - i * a).rem_euclid(period as i64) as usize;
        let side = (area as f32).sqrt();
        let distances = distances((a as f32, b as f32), cells as f32, (period, rows));
        let ramps = ramps(&distances, side / cells as f32);
        let length = period + width;
        let strip = |i: usize| (i / length) * period + (i % length) % period;
        let all = || (0..length * rows).map(strip);
        Self {
            rows,
            period,
            shift,
            length,
            start: all().map(|i| ramps[i].0).collect(),
            width: all().map(|i| ramps[i].1).collect(),
            slope: all().map(|i| slope(ramps[i].1)).collect(),
        }
    }

    /// The ramps of image row `y`.
    fn row(&self, y: usize) -> Ramps<'_> {
        let from = (y % self.rows) * self.length + (self.shift * (y / self.rows)) % self.period;
        let to = from + self.length - self.period;
        Ramps { start: &self.start[from..to], width: &self.width[from..to], slope: &self.slope[from..to] }
    }
}

fn slope(width: u8) -> i16 {
    (255i16 << screen::SLOPE_BITS) / i16::from(width) + 1
}

/// The whole numbers of cells and pixels that come nearest to an angle and a pitch: a square of `cells` x `cells`
/// dots has the side (a, b).
fn lattice(degrees: f32, pitch: f32) -> (usize, (i64, i64)) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let most = ((MAX_SIDE / pitch) as usize).max(1);
    let choice = (1..=most).map(|cells| {
        let (x, y) = (cells as f32 * pitch * cos, cells as f32 * pitch * sin);
        let (a, b) = (x.round().max(1.0), y.round());
        let error = (a - x).hypot(b - y) / cells as f32;
        (error, cells, (a as i64, b as i64))
    });
    // Small squares first: a larger one has to be better by more than rounding.
    let best = choice.reduce(|best, next| if next.0 < best.0 - 0.001 * pitch { next } else { best });
    best.map_or((1, (1, 0)), |(_, cells, side)| (cells, side))
}

/// The greatest common divisor of two numbers, and i, j with i x + j y equal to it.
fn extended_gcd(x: i64, y: i64) -> (i64, i64, i64) {
    if y == 0 {
        return (x, 1, 0);
    }
    let (g, i, j) = extended_gcd(y, x % y);
    (g, j, i - (x / y) * j)
}

/// Distance of each pixel of the strips to the nearest centre of a dot, in cells.
fn distances((a, b): (f32, f32), cells: f32, (period, rows): (usize, usize)) -> Vec<f32> {
    let (area, mut distances) = (a * a + b * b, Vec::with_capacity(period * rows));
    for y in 0..rows {
        for x in 0..period {
            let (x, y) = (x as f32, y as f32);
            // A corner of a cell on a pixel would make many pixels alike: a quarter of a pixel aside they differ.
            let (u, v) = ((x * a + y * b) * cells / area + 0.03, (y * a - x * b) * cells / area + 0.01);
            distances.push((u - u.floor() - 0.5).hypot(v - v.floor() - 0.5));
        }
    }
    distances
}

/// Begin and width of each pixel's ramp. The middle is the pixel's rank among all by distance, so that any
/// coverage inks that share of them; the width is what the radius grows by within a pixel.
fn ramps(distances: &[f32], pitch: f32) -> Vec<(u8, u8)> {
    let mut order: Vec<usize> = (0..distances.len()).collect();
    order.sort_by(|&i, &j| distances[i].total_cmp(&distances[j]));
    let mut ramps = vec![(0, 1); distances.len()];
    for (rank, &i) in order.iter().enumerate() {
        let middle = 255.0 * (rank as f32 + 0.5) / distances.len() as f32;
        // No ink at a coverage of 0 and none missing at 255.
        let half = (127.5 * growth(distances[i]) / pitch).min(middle).min(255.0 - middle);
        let start = (middle - half).round().clamp(0.0, 254.0);
        ramps[i] = (start as u8, (middle + half - start).round().clamp(1.0, 255.0 - start) as u8);
    }
    // The ramps of small dots are long for the scale and need it twice.
    for _ in 0..if pitch < 7.9 { 2 } else { 1 } {
        calibrate(&mut ramps);
    }
    ramps
}

/// Moves the ramps' ends so that together they lay as much ink as is asked for: ramps that are cut short at
/// the ends of the scale lay less or more.
fn calibrate(ramps: &mut [(u8, u8)]) {
    // A ramp is a bend up at its start and one down at its end; summed twice they are the ink of all.
    let mut bends = [0.0f32; 256];
    for &(start, width) in ramps.iter() {
        let slope = 255.0 / (f32::from(width) * ramps.len() as f32);
        bends[usize::from(start)] += slope;
        bends[usize::from(start) + usize::from(width)] -= slope;
    }
    let (mut slope, mut ink) = (0.0, 0.0);
    let inked = bends.map(|bend| {
        let before = ink;
        slope += bend;
        ink += slope;
        before
    });
    for (start, width) in ramps {
        let end = inked[usize::from(*start) + usize::from(*width)].round().clamp(1.0, 255.0) as u8;
        *start = inked[usize::from(*start)].round().clamp(0.0, f32::from(end) - 1.0) as u8;
        *width = end - *start;
    }
}

/// Change of a dot's coverage with its radius (in cells): the length of its edge inside the cell.
fn growth(radius: f32) -> f32 {
    let circle = std::f32::consts::TAU * radius;
    if radius <= 0.5 { circle } else { circle - 8.0 * radius * (0.5 / radius).acos() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_gray_is_covered_as_it_should_be() {
        for pitch in [6.0, 8.0, 13.5, 40.0] {
            for gray in (0..=255).step_by(15) {
                let image = Image::from_luma(Plane::filled(400, 400, gray as u8));
                let out = mono(&image, pitch, &mut Context::default()).unwrap();
                let sum: f64 = out.planes()[0].samples().iter().map(|&v| f64::from(v)).sum();
                let paper = sum / (400.0 * 400.0 * 255.0);
                let error = (paper - f64::from(gray) / 255.0).abs();
                assert!(error <= 0.025, "pitch {pitch} gray {gray}: {error}");
            }
        }
    }

    #[test]
    fn white_stays_white_and_black_black() {
        for (value, expected) in [(255, 255), (0, 0)] {
            let plane = || Plane::filled(50, 50, value);
            let image = Image::from_rgb([plane(), plane(), plane()]).unwrap();
            let out = cmyk(image, 7.0, &mut Context::default()).unwrap();
            assert!(out.planes().iter().all(|p| p.samples().iter().all(|&v| v == expected)));
        }
    }
}
