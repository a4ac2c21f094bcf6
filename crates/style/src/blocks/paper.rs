//! Paper: the sheet under the picture. It has a tint and a tooth, and the tooth affects paint and pencil.
//!
//! ```text
//! t   = the height of the sheet at a place, -1 to 1, from noise of a few sizes
//! c'  = 255 - (255 - c) (1 + .45 pigment t)     paint gathers in the hollows of the sheet
//! out = c' tint / 255 + 16 grain t               light on the tooth
//! ```
//!
//! The heights are drawn once on a tile that repeats, in pixels of the picture's scale.
//!
//! Source: Bousseau et al., "Interactive watercolor rendering with temporal coherence and abstraction", 2006 (paper as a
//! modulation of pigment density).

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::grain::{Grain, chance};
use crate::params::{Args, Gaps, Kind, Unit, colour, number, param};
use crate::raster::Image;

pub(super) static BLOCK: Block = Block {
    id: "paper",
    label: "Paper",
    help: "Lays a tinted sheet with its grain under the picture.",
    input: Channels::Any,
    output: Channels::Color,
    params: &[
        param(
            "sheet",
            "Sheet",
            "The kind of surface.",
            Kind::Choice { names: &["smooth", "cold-press", "laid", "newsprint", "kraft", "canvas"] },
        ),
        param(
            "tint",
            "Tint",
            "Colour of the sheet.",
            Kind::Choice {
                names: &["white", "ivory", "cream", "newsprint", "kraft", "gray", "blue", "rose", "own"],
            },
        ),
        number("grain", "Grain", "How visible the surface is.", (40.0, 0.0, 100.0, 1.0), Unit::Percent)
            .correcting(Gaps { texture: 0.8, ..Gaps::NONE }),
        number(
            "pigment",
            "In the paint",
            "How much the surface breaks up paint.",
            (25.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        number("size", "Grain size", "Size of the surface's grain.", (1.0, 0.4, 4.0, 0.1), Unit::None),
        colour("color", "Sheet colour", "Colour of the sheet with the tint \"own\".", [255; 3]),
    ],
    kernel: Kernel::Image(run),
    is_screen: true,
    is_coloring: true,
    ..Block::PLAIN
};

const TINTS: [[u8; 3]; 8] = [
    [255, 255, 255],
    [253, 250, 241],
    [248, 239, 220],
    [232, 226, 211],
    [206, 173, 133],
    [222, 222, 220],
    [214, 226, 236],
    [246, 226, 224],
];

/// Side of the tile, at 1920 x 1080.
const SIDE: f32 = 420.0;

/// Grey steps of light on the tooth at full grain.
const LIGHT: f32 = 16.0;

/// Share of paint that the deepest hollows gather at full strength.
const PIGMENT: f32 = 0.45;

/// The heights of a sheet on a square that repeats, and the settings of their drawing.
struct Drawn {
    key: (usize, u32, u32),
    side: usize,
    /// -127..=127.
    heights: Vec<i8>,
}

fn run(args: Args<'_>, image: Image, context: &mut Context<'_>) -> Result<Image> {
    let tint = TINTS.get(args.choice(1)).copied().unwrap_or_else(|| args.colour(5));
    let (grain, pigment) = (args.number(2) / 100.0, args.number(3) / 100.0);
    let (size, scale) = (args.number(4), context.scale());
    let key = (args.choice(0), size.to_bits(), scale.to_bits());
    let drawn = context.take().filter(|drawn: &Drawn| drawn.key == key);
    let drawn = drawn.unwrap_or_else(|| draw(key, size, scale));
    let mut image = match image.planes() {
        [y] => Image::from_rgb([context.copy_plane(y), context.copy_plane(y), y.clone()])?,
        _ => image,
    };
    let (width, height) = (image.width(), image.height());
    // In Q14: paint, and light on the tooth, for each height.
    let light = (LIGHT * grain * 64.0 / 127.0 * 16.0) as i32;
    let paint = (PIGMENT * pigment * 16_384.0 / 127.0) as i32;
    let mut line = vec![0i8; width];
    for y in 0..height {
        if y % 256 == 0 {
            context.check_cancelled()?;
        }
        let tile = &drawn.heights[y % drawn.side * drawn.side..][..drawn.side];
        for part in line.chunks_mut(drawn.side) {
            part.copy_from_slice(&tile[..part.len()]);
        }
        for (plane, tint) in image.planes_mut().iter_mut().zip(tint) {
            lay(plane.row_mut(y), &line, (paint, light, i32::from(tint)));
        }
    }
    context.give(drawn);
    Ok(image)
}

fn lay(row: &mut [u8], heights: &[i8], (paint, light, tint): (i32, i32, i32)) {
    // 257 / 65536 divides by 255.
    let tint = tint * 257;
    for (tone, &height) in row.iter_mut().zip(heights) {
        let height = i32::from(height);
        let ink = i32::from(255 - *tone);
        let left = 255 - ((ink * (16_384 + paint * height) + 8192) >> 14).clamp(0, 255);
        *tone = (((left * tint + 32_768) >> 16) + ((light * height) >> 10)).clamp(0, 255) as u8;
    }
}

fn draw(key: (usize, u32, u32), size: f32, scale: f32) -> Drawn {
    let side = ((SIDE * scale).round() as usize).clamp(96, 1536);
    // Noise of the same size everywhere, however the side was rounded.
    let unit = side as f32 / SIDE * size;
    let mut heights = plane_of(key.0, side, unit);
    let mean = heights.iter().sum::<f32>() / heights.len() as f32;
    for height in &mut heights {
        *height -= mean;
    }
    Drawn {
        key,
        side,
        heights: heights.iter().map(|&h| (h.clamp(-1.0, 1.0) * 127.0).round() as i8).collect(),
    }
}

/// Heights of a sheet: sums of noise of some sizes, of ribs, and of fibres. The borders of the tile are faded into each
/// other.
fn plane_of(sheet: usize, side: usize, unit: f32) -> Vec<f32> {
    // Width, height and share of each noise, at the reference size.
    let noises: &[(f32, f32, f32)] = match sheet {
        0 => &[(1.4, 1.4, 0.7), (4.0, 4.0, 0.4)],
        1 => &[(9.0, 8.0, 1.1), (4.2, 4.2, 0.7), (1.6, 1.6, 0.3)],
        2 => &[(30.0, 1.6, 0.5), (1.6, 1.6, 0.4)],
        3 => &[(1.5, 1.5, 0.6), (5.0, 2.0, 0.6), (24.0, 20.0, 0.3)],
        4 => &[(1.6, 1.6, 0.5), (14.0, 1.8, 0.6), (1.8, 11.0, 0.5)],
        _ => &[(1.6, 1.6, 0.3), (40.0, 3.0, 0.3), (3.0, 40.0, 0.3)],
    };
    let overlap = side / 6;
    let long = side + overlap;
    let mut heights = vec![0.0f32; side * side];
    let mut row = vec![0.0; long];
    for (seed, &(width, height, share)) in noises.iter().enumerate() {
        let grain = Grain::new(seed as u32 + 11, (width * unit, height * unit));
        for y in 0..long {
            grain.row(y, &mut row);
            // Beyond the end the tile begins again: there both are mixed.
            let down = if y < overlap { y as f32 / overlap as f32 } else { 1.0 };
            let down = if y >= side { 1.0 - (y - side) as f32 / overlap as f32 } else { down };
            let out = &mut heights[y % side * side..][..side];
            for (x, &noise) in row.iter().enumerate() {
                let right = if x < overlap { x as f32 / overlap as f32 } else { 1.0 };
                let right = if x >= side { 1.0 - (x - side) as f32 / overlap as f32 } else { right };
                out[x % side] += share * 2.0 * (noise - 0.5) * right * down;
            }
        }
    }
    // Ribs and threads per tile: a whole and even number.
    let across = |count: f32| (count * side as f32 / (SIDE * unit) / 2.0).round().max(1.0) * 2.0;
    let (wires, chains, threads) = (across(70.0), across(6.0), across(60.0));
    for (i, out) in heights.iter_mut().enumerate() {
        let (x, y) = ((i % side) as f32, (i / side) as f32);
        *out += match sheet {
            // Wires of a mould.
            2 => 0.35 * wave(y / side as f32 * wires) + 0.5 * wave(x / side as f32 * chains).powi(15),
            // Threads over and under each other.
            5 => {
                let (u, v) = (x / side as f32 * threads, y / side as f32 * threads);
                let over = (u as usize + v as usize).is_multiple_of(2);
                0.55 * if over { bow(u) * 2.0 - 1.0 } else { bow(v) * 2.0 - 1.0 }
            }
            _ => 0.0,
        };
    }
    if matches!(sheet, 3 | 4) {
        fibres(&mut heights, side, unit, if sheet == 4 { 90 } else { 50 });
    }
    heights
}

/// A wave of period 1 by a parabola, -1 to 1.
fn wave(at: f32) -> f32 {
    let t = 2.0 * (at - at.floor()) - 1.0;
    4.0 * t * (1.0 - t.abs())
}

/// How high a thread is across, 0 to 1.
fn bow(at: f32) -> f32 {
    let t = 2.0 * (at - at.floor()) - 1.0;
    1.0 - t * t
}

/// Short bent fibres, some sunk in and some on top.
fn fibres(heights: &mut [f32], side: usize, unit: f32, count: u32) {
    for k in 0..count {
        let random = |part: u32| chance(k, part, 77);
        let (mut x, mut y) = (random(0) * side as f32, random(1) * side as f32);
        let (mut dx, mut dy) = (random(2) - 0.5, random(3) - 0.5);
        let bend = (random(4) - 0.5) * 0.08 / unit;
        let lift = if random(5) < 0.5 { 0.5 } else { -0.6 };
        for _ in 0..(unit * (10.0 + 30.0 * random(6))) as usize {
            let length = (dx * dx + dy * dy).sqrt().max(1e-3);
            (dx, dy) = (dx / length - bend * dy, dy / length + bend * dx);
            (x, y) = (x + dx, y + dy);
            let place = |at: f32| (at.rem_euclid(side as f32) as usize).min(side - 1);
            heights[place(y) * side + place(x)] += lift;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    #[test]
    fn a_sheet_keeps_its_tint_and_its_heights_have_no_mean() {
        for sheet in 0..6 {
            let drawn = draw((sheet, 0, 0), 1.0, 1.0);
            let mean = drawn.heights.iter().map(|&h| f64::from(h)).sum::<f64>() / drawn.heights.len() as f64;
            assert!(mean.abs() < 5.0, "{sheet}: {mean}");
        }
        for (tint, color) in TINTS.iter().enumerate() {
            let mut context = Context::default();
            context.set_scale(1.0);
            let values = [0.0, tint as f32, 0.0, 0.0, 1.0];
            let out =
                run(Args::new(&values, 1.0), Image::from_luma(Plane::filled(20, 20, 255)), &mut context);
            for (plane, &tone) in out.unwrap().planes().iter().zip(color) {
                assert!(plane.samples().iter().all(|&v| v == tone));
            }
        }
    }

    #[test]
    fn the_tile_has_no_seam() {
        for sheet in 0..5 {
            let drawn = draw((sheet, 0, 0), 1.0, 1.0);
            let at =
                |x: usize, y: usize| f64::from(drawn.heights[y % drawn.side * drawn.side + x % drawn.side]);
            let step = |x: usize| (0..drawn.side).map(|y| (at(x + 1, y) - at(x, y)).abs()).sum::<f64>();
            let usual = (0..drawn.side).map(step).sum::<f64>() / drawn.side as f64;
            assert!(step(drawn.side - 1) < 1.6 * usual, "{sheet}: {} {usual}", step(drawn.side - 1));
        }
    }
}
