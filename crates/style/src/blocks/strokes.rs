//! Pencil Strokes: tones hatched with the grain of a pencil, along shapes where they have a direction.
//!
//! Noise averaged along a field of directions makes strokes. Their values are spread evenly over 0 to 1, so
//! the share of an area with values below its darkness equals its darkness. Strokes run at the chosen angle
//! in areas without a direction. Darker tones get a second layer of strokes across:
//!
//! ```text
//! u   = F(noise averaged along the field)                  evenly spread, F its distribution
//! ink = clamp((darkness - u) hardness + 1/2)
//! ```
//!
//! In colour the darkness is the darkness of the strongest ink, 1 - min(R, G, B). The stroke has the full
//! colour of this ink. Pale colours are sparse strokes of a full colour, as with coloured pencils.
//!
//! Sources: Mao, Nagasaka and Imamiya, "Automatic generation of pencil drawing using LIC", 2001; Praun et al., "Real-time
//! hatching", 2001 (darker tones keep the strokes of lighter ones).

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::grain::Tile;
use crate::params::{Args, FaceLimit, Gaps, Kind, Repeat, Unit, number, param};
use crate::raster::{Image, Plane};
use crate::simd::oriented::Wide;
use crate::simd::point::luma_plane;
use crate::tangents::{TURNS, Tangents};

pub(super) static BLOCK: Block = Block {
    id: "strokes",
    label: "Pencil Strokes",
    plain: "Pencil",
    help: "Hatches tones with pencil strokes that follow shapes, in gray or in colours.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number("width", "Stroke width", "How thick a stroke is.", (2.2, 0.8, 12.0, 0.1), Unit::Pixels)
            .for_face(FaceLimit::Length(1.0 / 48.0))
            .repeating(Repeat::Size),
        number("length", "Stroke length", "How long strokes are.", (14.0, 2.0, 40.0, 0.5), Unit::Pixels)
            .for_face(FaceLimit::Length(1.0 / 9.0)),
        number(
            "angle",
            "Angle",
            "Direction in areas without edges.",
            (-50.0, -90.0, 90.0, 1.0),
            Unit::Degrees,
        ),
        number(
            "follow",
            "Follow form",
            "How far strokes turn along shapes.",
            (60.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        number(
            "hardness",
            "Hardness",
            "How clearly strokes stand apart.",
            (55.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        number("pressure", "Pressure", "How dark a stroke is.", (80.0, 20.0, 100.0, 1.0), Unit::Percent)
            .correcting(Gaps { tone: -0.5, ..Gaps::NONE }),
        param("cross", "Cross strokes", "Dark tones get strokes across.", Kind::Flag { default: true }),
    ],
    kernel: Kernel::Image(run),
    is_screen: true,
    ..Block::PLAIN
};

/// Over how many pixels the field is smoothed.
const FORM: f32 = 10.0;

/// The second layer of strokes: its angle to the first layer, and the minimum darkness.
const CROSS: (f32, f32) = (58.0, 0.45);

/// Standard deviation of value noise, in grey steps.
const DEVIATION: f32 = 51.0;

fn run(args: Args<'_>, mut image: Image, context: &mut Context<'_>) -> Result<Image> {
    let (width, length) = (args.pixels(0).max(0.7), args.pixels(1).max(1.0));
    let (angle, follow) = (args.number(2), args.number(3) / 100.0);
    let luma = luma_plane(&image);
    let mut field = Tangents::of(&luma, (FORM * context.scale()).max(2.0));
    let second = args.flag(6).then(|| {
        let mut field = field.clone();
        bend(&mut field, angle + CROSS.0, follow * 0.5);
        field
    });
    bend(&mut field, angle, follow);
    context.check_cancelled()?;
    let size = (luma.width(), luma.height());
    let first = hand(&field, size, (width, length, context.scale()), 1);
    context.check_cancelled()?;
    let second = second.map(|field| hand(&field, size, (width, length, context.scale()), 2));
    context.check_cancelled()?;
    let pen = Pen::new(args.number(4) / 100.0, args.number(5) / 100.0);
    let none = vec![0u8; size.0];
    for y in 0..size.1 {
        let second = second.as_ref().map_or(&none[..], |second| second.row(y));
        match image.planes_mut() {
            [r, g, b] => pen.color(first.row(y), second, [r.row_mut(y), g.row_mut(y), b.row_mut(y)]),
            [tones, ..] => pen.gray(first.row(y), second, tones.row_mut(y)),
            [] => {}
        }
    }
    Ok(image)
}

/// Turns a field from one angle toward its own directions as far as they are coherent.
fn bend(field: &mut Tangents, degrees: f32, follow: f32) {
    let half = TURNS as f32;
    let own = degrees / 180.0 * half;
    field.bend(|turn, coherence| {
        let apart = (f32::from(turn) - own + half / 2.0).rem_euclid(half) - half / 2.0;
        // Strokes that would have to turn right round keep their angle.
        let near = 1.0 - (2.0 * apart / half).abs().powi(3);
        let strength = (f32::from(coherence) / 255.0 * 1.5).min(1.0) * follow * near;
        (own + apart * strength).round().rem_euclid(half) as u8 % TURNS as u8
    });
}

/// Strokes as a plane of values that are spread evenly over 0..=255.
fn hand(
    field: &Tangents,
    (width, height): (usize, usize),
    (thick, length, scale): (f32, f32, f32),
    seed: u32,
) -> Plane {
    let grain = Tile::new(seed, thick, (256.0 * thick).min(900.0 * scale.max(0.3)));
    let margin = (3.0 * length).ceil() as usize + 4;
    let mut wide = Wide::new(width, height, margin);
    let mut row = vec![0; width];
    for y in 0..height {
        grain.row(y, 0, &mut row);
        for (out, &noise) in wide.row_mut(y).iter_mut().zip(&row) {
            *out = (i16::from(noise) - 128) << 5;
        }
    }
    wide.pad();
    let mut spare = Wide::new(width, height, margin);
    field.smooth_along(&mut wide, &mut spare, length);
    // Number of spots of noise averaged in one stroke.
    let spots = ((2.0 * std::f32::consts::PI.sqrt() * length) / (1.2 * thick)).max(1.0);
    let deviation = DEVIATION / spots.sqrt();
    let table = spread(deviation);
    let half = table.len() as i32 / 2;
    let mut strokes = Plane::filled(width, height, 0);
    for y in 0..height {
        for (out, &sample) in strokes.row_mut(y).iter_mut().zip(wide.row(y)) {
            *out = table[(i32::from(sample) / 4 + half).clamp(0, 2 * half - 1) as usize];
        }
    }
    strokes
}

/// The distribution of a normal deviation, for every eighth of a grey step, as 0..=255.
fn spread(deviation: f32) -> Vec<u8> {
    let half = 1024;
    (-half..half)
        .map(|eighth| {
            let z = f64::from(eighth) / 8.0 / f64::from(deviation);
            // Page, "Approximations to the cumulative normal function", 1977: within .0002.
            let share = 1.0 / (1.0 + (-1.595_769 * z - 0.071_3 * z * z * z).exp());
            (share * 255.0).round() as u8
        })
        .collect()
}

/// How strokes become ink.
struct Pen {
    /// Slope of the edge relative to a stroke's own values, in 1/256.
    slope: i32,
    /// Share of a stroke's ink for each darkness, in 1/256. Dark strokes have more pressure.
    press: [i32; 256],
    /// `press` divided by the darkness: a factor for the difference to white, in 1/256.
    full: [i32; 256],
}

impl Pen {
    fn new(hardness: f32, pressure: f32) -> Self {
        let shade = |dark: usize| dark as f32 / 255.0;
        let press = |dark: usize| pressure + (1.0 - pressure) * shade(dark) * shade(dark);
        Self {
            slope: ((1.0 + 9.0 * hardness * hardness) * 256.0) as i32,
            press: std::array::from_fn(|dark| (press(dark) * 256.0) as i32),
            full: std::array::from_fn(|dark| (press(dark) * 256.0 * 255.0 / dark.max(48) as f32) as i32),
        }
    }

    /// Returns the ink of a darkness for both layers, 0 to 255.
    #[inline]
    fn ink(&self, dark: u8, first: u8, second: u8) -> i32 {
        const FROM: i32 = (CROSS.1 * 255.0) as i32;
        let dark = i32::from(dark);
        let at =
            |dark: i32, stroke: u8| (((dark - i32::from(stroke)) * self.slope + 32_640) >> 8).clamp(0, 255);
        // The second layer leaves a tenth of the paper white.
        let across = ((dark - FROM) * (65_536 * 255 / (255 - FROM))) >> 16;
        let second = if dark > FROM && second > 0 { (at(across, second) * 230) >> 8 } else { 0 };
        // White areas have no strokes.
        if dark == 0 { 0 } else { at(dark, first).max(second) }
    }

    fn gray(&self, first: &[u8], second: &[u8], tones: &mut [u8]) {
        for ((tone, &first), &second) in tones.iter_mut().zip(first).zip(second) {
            let dark = 255 - *tone;
            *tone = 255 - ((self.ink(dark, first, second) * self.press[usize::from(dark)]) >> 8) as u8;
        }
    }

    fn color(&self, first: &[u8], second: &[u8], [r, g, b]: [&mut [u8]; 3]) {
        let channels = r.iter_mut().zip(g).zip(b);
        for (((r, g), b), (&first, &second)) in channels.zip(first.iter().zip(second)) {
            let dark = 255 - *r.min(g).min(b);
            // The colour of a full stroke: its strongest ink is full.
            let full = self.ink(dark, first, second) * self.full[usize::from(dark)];
            for tone in [r, g, b] {
                *tone = 255 - ((i32::from(255 - *tone) * full + 32_640) / 65_280).min(255) as u8;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::tried;

    fn hatched(image: Image, change: &[(usize, f32)]) -> Image {
        tried(&BLOCK, change, |args, context| run(args, image, context))
    }

    #[test]
    fn ink_covers_about_the_share_that_the_tone_asks_for() {
        for tone in [40u8, 128, 200] {
            let flat = Image::from_luma(Plane::filled(240, 200, tone));
            let out = hatched(flat, &[(5, 100.0), (6, 0.0)]);
            let samples = out.planes()[0].samples();
            let mean = samples.iter().map(|&v| f64::from(v)).sum::<f64>() / samples.len() as f64;
            assert!((mean - f64::from(tone)).abs() < 16.0, "{tone}: {mean}");
        }
    }

    #[test]
    fn paper_stays_white_and_strokes_of_a_colour_have_its_hue() {
        let out = hatched(Image::from_rgb([255; 3].map(|v| Plane::filled(60, 60, v))).unwrap(), &[]);
        assert!(out.planes().iter().all(|plane| plane.samples().iter().all(|&v| v == 255)));
        let out = hatched(Image::from_rgb([255, 205, 155].map(|v| Plane::filled(80, 80, v))).unwrap(), &[]);
        let [r, g, b] = out.planes() else { panic!("three planes") };
        let inked = (0..6400).filter(|&i| b.samples()[i] < 128);
        assert!(inked.clone().count() > 400);
        for i in inked {
            let (r, g, b) = (r.samples()[i], g.samples()[i], b.samples()[i]);
            let twice = 2 * i32::from(255 - g);
            assert!(r > 250 && (twice - i32::from(255 - b)).abs() < 8, "{r} {g} {b}");
        }
    }
}
