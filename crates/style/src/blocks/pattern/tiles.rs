//! Tile sets drawn by code. Each rule returns the distance of a point to the nearest ink, which gives smooth
//! edges at every scale.

use std::f32::consts::{PI, TAU};

/// Names of the tile sets, in the order of their drawing rules in [`draw`].
pub(super) const NAMES: &[&str] = &["hatch", "cross_hatch", "dots", "lines", "woodcut", "stipple"];

/// Side of a tile in pixels of a 1920 x 1080 image. Every spacing below divides it.
const SIDE: f32 = 48.0;

/// A square image that repeats in both directions, of one or more repeats of the pattern.
pub(super) struct Tile {
    side: usize,
    samples: Vec<u8>,
}

impl Tile {
    /// Rows and columns of one period of the pattern.
    pub(super) fn side(&self) -> usize {
        self.side
    }

    /// Writes row `y` of the endless pattern.
    pub(super) fn repeat_row(&self, y: usize, out: &mut [u8]) {
        let row = &self.samples[(y % self.side) * self.side..][..self.side];
        for chunk in out.chunks_mut(self.side) {
            chunk.copy_from_slice(&row[..chunk.len()]);
        }
    }
}

/// The tiles of a set for `levels` tones, black first, white last. `scale` is pixels of the render for a pixel
/// of the reference.
pub(super) fn draw(pattern: usize, levels: usize, scale: f32) -> Vec<Tile> {
    let (repeats, side) = whole_side(scale);
    (0..levels)
        .map(|level| {
            let darkness = 1.0 - level as f32 / (levels - 1) as f32;
            let by_rule = |distance: &dyn Fn(f32, f32) -> f32| by_rule(side, repeats, distance);
            let samples = match (level, pattern) {
                (0, _) => vec![0; side * side],
                _ if level + 1 == levels => vec![255; side * side],
                (_, 0) => by_rule(&|x, y| hatch(x, y, darkness)),
                (_, 1) => by_rule(&|x, y| cross_hatch(x, y, darkness)),
                (_, 2) => by_rule(&|x, y| dots(x, y, darkness)),
                (_, 3) => by_rule(&|_, y| stroke(y, 6.0, 6.0 * darkness)),
                (_, 4) => by_rule(&|x, y| woodcut(x, y, darkness)),
                _ => stipple(side, repeats, darkness),
            };
            Tile { side, samples }
        })
        .collect()
}

/// Number of repeats of the pattern in a tile, and the tile's side in pixels. With one repeat, rounding the
/// side to whole pixels would change the line spacing between small and large renders. With several repeats
/// the spacing is nearly exact. It is exact if the scale is a multiple of 1/40.
fn whole_side(scale: f32) -> (usize, usize) {
    /// Share of a length that is invisible across a page.
    const DRIFT: f32 = 1e-4;
    /// Longest side that is worth its memory, and most repeats.
    const MOST: (f32, usize) = (600.0, 10);
    let side = (SIDE * scale).max(4.0);
    let most = ((MOST.0 / side) as usize).clamp(1, MOST.1);
    let drift = |repeats: usize| {
        let length = side * repeats as f32;
        (length.round() - length).abs() / length
    };
    let nearest = || (1..=most).min_by(|&a, &b| drift(a).total_cmp(&drift(b))).unwrap_or(1);
    let repeats = (1..=most).find(|&repeats| drift(repeats) < DRIFT).unwrap_or_else(nearest);
    (repeats, (side * repeats as f32).round() as usize)
}

/// Draws a rule that gives the distance to ink in reference pixels, negative inside.
fn by_rule(side: usize, repeats: usize, distance: &dyn Fn(f32, f32) -> f32) -> Vec<u8> {
    let unit = SIDE * repeats as f32 / side as f32;
    let mut samples = Vec::with_capacity(side * side);
    for y in 0..side {
        for x in 0..side {
            let place = |pixel: usize| (pixel as f32 + 0.5) * unit % SIDE;
            let away = distance(place(x), place(y)) / unit;
            samples.push(((away + 0.5).clamp(0.0, 1.0) * 255.0).round() as u8);
        }
    }
    samples
}

/// Distance to parallel strokes of a width, at multiples of a spacing.
fn stroke(position: f32, spacing: f32, width: f32) -> f32 {
    let phase = (position / spacing).rem_euclid(1.0) - 0.5;
    phase.abs().mul_add(spacing, -width / 2.0)
}

/// Strokes at 45 degrees; spacing along an axis, so that it divides the tile.
fn diagonal(x: f32, y: f32, spacing: f32, width: f32) -> f32 {
    const SLOPE: f32 = std::f32::consts::FRAC_1_SQRT_2;
    let axis_width = width / SLOPE;
    stroke(x + y, spacing, axis_width) * SLOPE
}

/// One direction, closer and thicker, then crossed and at last ruled: each level holds the lines of the
/// lighter one, as a draughtsman adds strokes.
fn hatch(x: f32, y: f32, darkness: f32) -> f32 {
    let mut ink = diagonal(x, y, 12.0, 1.3 + darkness);
    if darkness > 0.3 {
        ink = ink.min(diagonal(x + 6.0, y, 12.0, 1.0 + darkness));
    }
    if darkness > 0.55 {
        ink = ink.min(diagonal(x, SIDE - y, 12.0, 0.9 + 1.2 * darkness));
    }
    if darkness > 0.78 {
        ink = ink.min(stroke(y, 6.0, 0.8 + 1.6 * darkness));
    }
    ink
}

/// Both diagonals from the start, with lines that swell.
fn cross_hatch(x: f32, y: f32, darkness: f32) -> f32 {
    // Two families of width w cover 1 - (1 - w)^2.
    let width = (1.0 - (1.0 - darkness).sqrt()) * 8.0 * std::f32::consts::FRAC_1_SQRT_2;
    diagonal(x, y, 8.0, width).min(diagonal(x, SIDE - y, 8.0, width))
}

/// Staggered dots; beyond half coverage, white holes in black.
fn dots(x: f32, y: f32, darkness: f32) -> f32 {
    const SPACING: f32 = 8.0;
    let (coverage, holes) = if darkness <= 0.5 { (darkness, false) } else { (1.0 - darkness, true) };
    // Each cell of SPACING x SPACING has two dots.
    let radius = (coverage * SPACING * SPACING / (2.0 * PI)).sqrt();
    let shift = if holes { SPACING / 2.0 } else { 0.0 };
    let near = |x: f32, y: f32| {
        let offset = |p: f32| ((p + shift) / SPACING).rem_euclid(1.0).mul_add(SPACING, -SPACING / 2.0);
        offset(x).hypot(offset(y))
    };
    let distance = near(x, y).min(near(x + SPACING / 2.0, y + SPACING / 2.0)) - radius;
    if holes { -distance } else { distance }
}

/// Waving cuts whose width breathes along the stroke, as a gouge leaves them.
fn woodcut(x: f32, y: f32, darkness: f32) -> f32 {
    let wave = 1.6 * (x / SIDE * TAU).sin() + 0.7 * (x / SIDE * 2.0 * TAU + 1.0).sin();
    let breath = 1.0 + 0.22 * (x / SIDE * 2.0 * TAU + (y / 8.0).floor() * 2.4).sin() * (1.0 - darkness);
    stroke(y + wave, 8.0, 8.0 * darkness * breath)
}

/// Points at irregular distances. Darker levels keep the points of the lighter ones and add more.
fn stipple(side: usize, repeats: usize, darkness: f32) -> Vec<u8> {
    const RADIUS: f32 = 1.25;
    let unit = SIDE * repeats as f32 / side as f32;
    let mut samples = vec![255u8; side * side];
    // Random discs cover 1 - exp(-n area); these keep apart, so they cover a little more.
    let wanted = (-(1.0 - darkness).ln() * SIDE * SIDE / (PI * RADIUS * RADIUS)) as usize;
    for &(px, py) in points().iter().cycle().take(wanted.clamp(1, MAX_POINTS)) {
        for (i, j) in (0..repeats).flat_map(|j| (0..repeats).map(move |i| (i as f32, j as f32))) {
            let place = ((px + i * SIDE) / unit, (py + j * SIDE) / unit);
            stamp(&mut samples, side, place, RADIUS / unit);
        }
    }
    samples
}

fn stamp(samples: &mut [u8], side: usize, (px, py): (f32, f32), radius: f32) {
    let reach = radius.ceil() as isize + 1;
    let (cx, cy) = (px.floor() as isize, py.floor() as isize);
    for y in cy - reach..=cy + reach {
        for x in cx - reach..=cx + reach {
            let away = (x as f32 + 0.5 - px).hypot(y as f32 + 0.5 - py) - radius;
            let paper = ((away + 0.5).clamp(0.0, 1.0) * 255.0) as u8;
            let wrap = |p: isize| p.rem_euclid(side as isize) as usize;
            let sample = &mut samples[wrap(y) * side + wrap(x)];
            *sample = (*sample).min(paper);
        }
    }
}

/// Enough for the darkest tone but black.
const MAX_POINTS: usize = 900;

/// Points on the tile, each the farthest from those before among a few tries (Mitchell's best candidate), so
/// that every prefix is evenly spread.
fn points() -> Vec<(f32, f32)> {
    const TRIES: usize = 6;
    let mut random = oorandom::Rand32::new(48);
    let mut points: Vec<(f32, f32)> = Vec::with_capacity(MAX_POINTS);
    while points.len() < MAX_POINTS {
        let candidates = [(); TRIES].map(|()| (random.rand_float() * SIDE, random.rand_float() * SIDE));
        let room = |candidate: (f32, f32)| {
            points.iter().map(|&point| square_distance(candidate, point)).fold(f32::MAX, f32::min)
        };
        let best = candidates.into_iter().map(|c| (room(c), c)).max_by(|a, b| a.0.total_cmp(&b.0));
        points.extend(best.map(|(_, point)| point));
    }
    points
}

/// Square of the distance on the torus.
fn square_distance(a: (f32, f32), b: (f32, f32)) -> f32 {
    let along = |a: f32, b: f32| {
        let d = (a - b).abs();
        d.min(SIDE - d)
    };
    along(a.0, b.0).powi(2) + along(a.1, b.1).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_spaced_alike_at_every_scale() {
        for percent in 20..=400u16 {
            let scale = f32::from(percent) / 100.0;
            let (repeats, side) = whole_side(scale);
            let drift = side as f32 / repeats as f32 / (SIDE * scale) - 1.0;
            assert!(drift.abs() < 0.006, "scale {scale}: {side} / {repeats} is off by {drift}");
        }
    }
}
