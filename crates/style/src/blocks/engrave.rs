//! Engrave: lines that follow form and swell with tone, as a burin cuts them.
//!
//! A screen of lines has a phase whose gradient is its density and direction. The target gradient bends from
//! the chosen angle toward the tangent of edges and over the relief from light and shade. The phase nearest
//! to the target (least squares) has no seam anywhere:
//!
//! ```text
//! v   = (normal of the bent direction) / pitch + relief grad H        |bend| <= 45 degrees
//! phi = argmin of the sum of |grad phi - v|^2                        a Poisson equation, on a coarse grid
//! ink where |2 frac(phi) - 1| < darkness                              one pixel soft
//! ```
//!
//! Darker tones get a second and a third screen across. The white shares left by the screens multiply.
//!
//! Sources: Ostromoukhov, "Digital facial engraving", 1999 (lines of swelling width over form, laid in layers by tone);
//! Kyprianidis and Döllner, 2008 (the field, see [`crate::tangents`]).

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::params::{Args, Gaps, Unit, integer, number};
use crate::raster::Plane;
use crate::raster::resize::{Region, resample};
use crate::tangents::{TURNS, Tangents, smooth};

pub(super) static BLOCK: Block = Block {
    id: "engrave",
    label: "Engraving",
    plain: "Cut lines",
    help: "Cuts tones into lines that follow shapes and swell in the shade.",
    input: Channels::Any,
    output: Channels::Luma,
    params: &[
        number("pitch", "Pitch", "Distance between lines.", (7.0, 3.0, 40.0, 0.5), Unit::Pixels).pitch(),
        number("angle", "Angle", "Direction of the first lines.", (20.0, -90.0, 90.0, 1.0), Unit::Degrees),
        number(
            "follow",
            "Follow form",
            "How far lines bend over shapes.",
            (70.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        integer("layers", "Layers", "How many directions dark tones get.", (2, 1, 3)),
        number("ink", "Ink", "Wider lines and blacker shade.", (100.0, 40.0, 200.0, 1.0), Unit::Percent)
            .correcting(Gaps { lines: 0.3, width: 0.4, tone: -0.8, ..Gaps::NONE }),
    ],
    kernel: Kernel::Luma(run),
    is_screen: true,
    ..Block::PLAIN
};

/// Distance between points of the coarse grid, at 1920 x 1080.
const GRID: f32 = 8.0;

/// Scale of the picture on which form is measured.
const WORK: f32 = 0.5;

/// Over how many pixels the relief and the field are smoothed.
const FORM: f32 = 14.0;

/// Height of the relief per whole step of tone, in lines, and the maximum bend relative to the density of
/// lines.
const RELIEF: (f32, f32) = (9.0, 0.45);

/// Angles of the screens against the first, and the darkness at which they begin.
const LAYERS: [(f32, f32); 3] = [(0.0, 0.0), (62.0, 0.42), (-48.0, 0.7)];

/// Below this darkness the paper stays white.
const WHITE: f32 = 0.05;

/// Sweeps of the solver on every level, and its over-relaxation.
const SWEEPS: usize = 20;
const RELAXATION: f32 = 1.8;

fn run(args: Args<'_>, mut plane: Plane, context: &mut Context<'_>) -> Result<Plane> {
    let pitch = args.pixels(0).max(2.0);
    let (angle, follow, ink) = (args.number(1), args.number(2) / 100.0, args.number(4) / 100.0);
    let form = Form::of(&plane, context.scale());
    let dark: Vec<f32> = (0..=255u8)
        .map(|tone| (((1.0 - f32::from(tone) / 255.0) * ink - WHITE) / (1.0 - WHITE)).clamp(0.0, 1.0))
        .collect();
    let layers = args.number(3) as usize;
    let mut screens = Vec::with_capacity(layers);
    for &(turn, from) in LAYERS.iter().take(layers) {
        context.check_cancelled()?;
        screens.push((Screen::new(&form, pitch, angle + turn, follow), from));
    }
    let mut phases = vec![0.0; plane.width()];
    let mut shades = vec![0.0f32; plane.width()];
    // Share of the tone still to be covered, and share left white.
    let mut rest = vec![0.0f32; plane.width()];
    let mut white = vec![1.0f32; plane.width()];
    for y in 0..plane.height() {
        if y % 64 == 0 {
            context.check_cancelled()?;
        }
        let row = plane.row_mut(y);
        for (shade, &tone) in shades.iter_mut().zip(row.iter()) {
            *shade = dark[usize::from(tone)];
        }
        rest.fill(1.0);
        white.fill(1.0);
        for (i, (screen, from)) in screens.iter().enumerate() {
            screen.row(y, &mut phases);
            // The next screen takes over from its start darkness. Up to this tone, this screen covers
            // everything.
            let limit = screens.get(i + 1).map_or(1.0, |(_, next)| next.max(0.5));
            cut(&phases, &shades, (*from, limit, 0.5 * pitch), &mut rest, &mut white);
        }
        for (tone, white) in row.iter_mut().zip(&white) {
            *tone = (255.0 * white + 0.5) as u8;
        }
    }
    Ok(plane)
}

/// Cuts the lines of one screen into a row of pixels: darkness beyond `from`, up to `limit`.
fn cut(
    phases: &[f32],
    shades: &[f32],
    (from, limit, sharp): (f32, f32, f32),
    rest: &mut [f32],
    white: &mut [f32],
) {
    let lines = phases.iter().zip(shades).zip(rest.iter_mut().zip(white.iter_mut()));
    for ((&phase, &shade), (rest, white)) in lines {
        let wanted = if shade > from { 1.0 - (1.0 - shade) / rest.max(1e-6) } else { 0.0 };
        let wanted = wanted.clamp(0.0, limit);
        let distance = (2.0 * (phase - phase.floor()) - 1.0).abs();
        let paper = ((distance - wanted) * sharp + 0.5).clamp(0.0, 1.0);
        // Pixels that need no ink stay unchanged.
        *white *= if wanted > 0.0 { paper } else { 1.0 };
        *rest *= 1.0 - wanted;
    }
}

/// The guides of lines on the coarse grid: directions, and the relief of light and shade.
struct Form {
    columns: usize,
    rows: usize,
    /// Pixels of the render between two points.
    gap: f32,
    turns: Vec<u8>,
    coherence: Vec<u8>,
    /// Grey steps / 255.
    relief: Vec<f32>,
}

impl Form {
    /// Directions add up along the phase, so that the smallest difference between a preview and its print would become
    /// another line: both are measured on a picture of one size.
    fn of(plane: &Plane, scale: f32) -> Self {
        let reduced = (scale > WORK).then(|| {
            let side = |length: usize| ((length as f32 * WORK / scale).round() as usize).max(1);
            let (width, height) = (side(plane.width()), side(plane.height()));
            resample(plane, Region::whole(plane.width(), plane.height()), width, height)
        });
        let work = reduced.as_ref().unwrap_or(plane);
        let work_scale = scale.min(WORK);
        let (gap, step) = ((GRID * scale).max(2.0), (GRID * work_scale).max(2.0 * work_scale / scale));
        let points = |length: usize| (length as f32 / gap).ceil() as usize + 2;
        let (columns, rows) = (points(plane.width()), points(plane.height()));
        let form = FORM * work_scale;
        let field = Tangents::of(work, form.max(2.0));
        let mut relief = vec![0.0; columns * rows];
        let (mut turns, mut coherence) = (vec![0; columns * rows], vec![0; columns * rows]);
        for j in 0..rows {
            for i in 0..columns {
                let place = |k: usize, length: usize| ((k as f32 * step) as usize).min(length - 1);
                let (x, y) = (place(i, work.width()), place(j, work.height()));
                let cell = y / 4 * field.columns() + x / 4;
                turns[j * columns + i] = field.turns()[cell];
                coherence[j * columns + i] = field.coherence()[cell];
                relief[j * columns + i] = mean(work, (x, y), step as usize);
            }
        }
        smooth(&mut relief, columns, rows, form / step);
        Self { columns, rows, gap, turns, coherence, relief }
    }
}

/// Mean tone, 0 to 1, of the square of `side` pixels about a place.
fn mean(plane: &Plane, (x, y): (usize, usize), side: usize) -> f32 {
    let span = |at: usize, length: usize| at.saturating_sub(side / 2)..(at + side / 2 + 1).min(length);
    let (across, down) = (span(x, plane.width()), span(y, plane.height()));
    let count = across.len() * down.len();
    let sum: u32 =
        down.map(|y| plane.row(y)[across.clone()].iter().map(|&v| u32::from(v)).sum::<u32>()).sum();
    sum as f32 / (255 * count) as f32
}

/// One screen of lines: a plane wave and its deviation, in lines, on the points of the coarse grid.
struct Screen {
    wave: (f32, f32),
    columns: usize,
    gap: f32,
    deviation: Vec<f32>,
}

impl Screen {
    fn new(form: &Form, pitch: f32, degrees: f32, follow: f32) -> Self {
        let angle = f64::from(degrees).to_radians();
        // The normal of lines that run along the angle.
        let (sin, cos) = angle.sin_cos();
        let wave = ((-sin / f64::from(pitch)) as f32, (cos / f64::from(pitch)) as f32);
        let mut deviation = vec![0.0; form.columns * form.rows];
        if follow > 0.0 {
            let (across, down) = wanted(form, pitch, degrees, follow);
            deviation = solve(form.columns, form.rows, &across, &down);
            // Differences leave the mean open: without one, a preview and its print have their lines in one place.
            let mean = deviation.iter().sum::<f32>() / deviation.len() as f32;
            for value in &mut deviation {
                *value -= mean;
            }
        }
        Self { wave, columns: form.columns, gap: form.gap, deviation }
    }

    /// The phases of the middles of a row of pixels.
    fn row(&self, y: usize, phases: &mut [f32]) {
        let middle = y as f32 + 0.5;
        let line = (middle / self.gap) as usize;
        let between = middle / self.gap - line as f32;
        let points = |line: usize| &self.deviation[line * self.columns..(line + 1) * self.columns];
        let (above, below) = (points(line), points(line + 1));
        let point = |i: usize| above[i] + between * (below[i] - above[i]);
        let start = middle * self.wave.1;
        // The integer part has no effect, and would cost precision far from the corner.
        let start = start - start.floor();
        let (mut x, mut i) = (0, 0);
        while x < phases.len() {
            let next = (((i + 1) as f32 * self.gap - 0.5).ceil() as usize).min(phases.len());
            let (from, to) = (point(i), point(i + 1));
            let step = (to - from) / self.gap;
            let first = start + from - i as f32 * self.gap * step;
            for (k, phase) in phases[x..next].iter_mut().enumerate() {
                let middle = (x + k) as f32 + 0.5;
                *phase = first + middle * (step + self.wave.0);
            }
            (x, i) = (next.max(x + 1), i + 1);
        }
    }
}

/// The gradient that the deviation should have, in lines for each step of the grid, to the right and down.
fn wanted(form: &Form, pitch: f32, degrees: f32, follow: f32) -> (Vec<f32>, Vec<f32>) {
    let Form { columns, rows, gap, .. } = *form;
    let lines = gap / pitch;
    let bends: Vec<[(f32, f32); TURNS]> = (0..=8).map(|c| bends(degrees, follow * c as f32 / 8.0)).collect();
    let mut across = vec![0.0; columns * rows];
    let mut down = vec![0.0; columns * rows];
    for j in 0..rows {
        for i in 0..columns {
            let at = |i: usize, j: usize| form.relief[j.min(rows - 1) * columns + i.min(columns - 1)];
            let here = j * columns + i;
            let slope = |ahead: f32, behind: f32| 0.5 * (ahead - behind) * RELIEF.0 * follow;
            let x = slope(at(i + 1, j), at(i.saturating_sub(1), j));
            let y = slope(at(i, j + 1), at(i, j.saturating_sub(1)));
            // Steep relief would fold the lines over each other.
            let most = RELIEF.1 * lines;
            let length = (x * x + y * y).sqrt();
            let held = most / (most + length);
            let bend = bends[usize::from(form.coherence[here]) / 31][usize::from(form.turns[here]) % TURNS];
            across[here] = bend.0 * lines + x * held;
            down[here] = bend.1 * lines + y * held;
        }
    }
    (across, down)
}

/// For each direction of the field, how the normal of lines changes when they bend toward it.
fn bends(degrees: f32, strength: f32) -> [(f32, f32); TURNS] {
    std::array::from_fn(|turn| {
        let half = std::f64::consts::PI;
        let own = f64::from(degrees).to_radians();
        let apart = (turn as f64 * half / TURNS as f64 - own + half / 2.0).rem_euclid(half) - half / 2.0;
        // A direction across the lines could pull either way, so it does not pull at all.
        let bent = own + f64::from(strength) * apart * apart.cos().powi(2) * 1.6;
        ((own.sin() - bent.sin()) as f32, (bent.cos() - own.cos()) as f32)
    })
}

/// Returns the function on a grid whose differences are nearest to the given differences. It uses successive
/// over-relaxation, from a coarse grid down to this one.
fn solve(columns: usize, rows: usize, across: &[f32], down: &[f32]) -> Vec<f32> {
    let mut result = vec![0.0; columns * rows];
    if columns > 3 && rows > 3 {
        let (half_columns, half_rows) = (columns.div_ceil(2), rows.div_ceil(2));
        let halve = |wanted: &[f32]| -> Vec<f32> {
            let at = |i: usize, j: usize| wanted[j.min(rows - 1) * columns + i.min(columns - 1)];
            let row =
                |i: usize, j: usize| 0.25 * (at(i.saturating_sub(1), j) + 2.0 * at(i, j) + at(i + 1, j));
            let places = (0..half_columns * half_rows).map(|k| (k % half_columns * 2, k / half_columns * 2));
            // Twice the weighted mean: a step is twice as long.
            places
                .map(|(i, j)| 0.5 * (row(i, j.saturating_sub(1)) + 2.0 * row(i, j) + row(i, j + 1)))
                .collect()
        };
        let coarse = solve(half_columns, half_rows, &halve(across), &halve(down));
        for (j, row) in result.chunks_exact_mut(columns).enumerate() {
            for (i, out) in row.iter_mut().enumerate() {
                let at = |i: usize, j: usize| {
                    coarse[j.min(half_rows - 1) * half_columns + i.min(half_columns - 1)]
                };
                let (x, y) = (i / 2, j / 2);
                let (right, below) = ((i % 2) as f32 * 0.5, (j % 2) as f32 * 0.5);
                let line = |y: usize| at(x, y) + right * (at(x + 1, y) - at(x, y));
                *out = line(y) + below * (line(y + 1) - line(y));
            }
        }
    }
    for _ in 0..SWEEPS {
        for j in 0..rows {
            for i in 0..columns {
                let here = j * columns + i;
                let (mut sum, mut count) = (0.0f32, 0.0f32);
                let mut pull = |other: usize, difference: f32| {
                    sum += result[other] + difference;
                    count += 1.0;
                };
                if i > 0 {
                    pull(here - 1, 0.5 * (across[here - 1] + across[here]));
                }
                if i + 1 < columns {
                    pull(here + 1, -0.5 * (across[here + 1] + across[here]));
                }
                if j > 0 {
                    pull(here - columns, 0.5 * (down[here - columns] + down[here]));
                }
                if j + 1 < rows {
                    pull(here + columns, -0.5 * (down[here + columns] + down[here]));
                }
                result[here] += RELAXATION * (sum / count.max(1.0) - result[here]);
            }
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::tried;

    fn engraved(plane: Plane, change: &[(usize, f32)]) -> Plane {
        tried(&BLOCK, change, |args, context| run(args, plane, context))
    }

    #[test]
    fn ink_covers_the_share_that_the_tone_asks_for() {
        for layers in 1..=3 {
            for tone in [20u8, 90, 128, 170, 230] {
                let out = engraved(Plane::filled(300, 300, tone), &[(3, layers as f32)]);
                let mean = out.samples().iter().map(|&v| f64::from(v)).sum::<f64>() / 90_000.0;
                let dark = ((1.0 - f64::from(tone) / 255.0) - 0.05) / 0.95;
                assert!((mean - 255.0 * (1.0 - dark)).abs() < 9.0, "{layers} layers, {tone}: {mean}");
            }
        }
    }

    #[test]
    fn a_gradient_that_exists_is_found_exactly() {
        let (columns, rows) = (37, 21);
        let field = |i: usize, j: usize| (0.1 * i as f32).sin() * 3.0 + 0.02 * (j * j) as f32;
        let at = |i: usize, j: usize| field(i, j);
        let mut across = vec![0.0; columns * rows];
        let mut down = vec![0.0; columns * rows];
        for j in 0..rows {
            for i in 0..columns {
                across[j * columns + i] = 0.3 * (0.1 * i as f32).cos();
                down[j * columns + i] = 0.04 * j as f32;
            }
        }
        let found = solve(columns, rows, &across, &down);
        let shift = found[0] - at(0, 0);
        for j in 0..rows {
            for i in 0..columns {
                assert!(
                    (found[j * columns + i] - shift - at(i, j)).abs() < 0.15,
                    "{i}, {j}: {}",
                    found[j * columns + i] - shift - at(i, j)
                );
            }
        }
    }

    #[test]
    fn straight_lines_keep_their_pitch_and_angle() {
        let out = engraved(Plane::filled(200, 200, 128), &[(0, 10.0), (1, 0.0), (2, 0.0), (3, 1.0)]);
        for y in 0..190 {
            assert!((0..200).all(|x| out.at(x, y) == out.at(0, y)));
            assert!(out.at(0, y).abs_diff(out.at(0, y + 10)) <= 1);
        }
    }
}
