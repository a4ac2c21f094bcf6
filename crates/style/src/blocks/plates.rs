//! Plates: a picture printed in a few inks, one plate each, as a risograph or a screen printer does.
//!
//! Each ink takes its share of the difference to white, (1 - R, 1 - G, 1 - B), by least squares. The shares
//! are scaled so that black is full ink on its plate. No tone is lost with any set of inks. In addition to
//! black, a spot colour has no share in grays and has a separate scale. The plates are grained or screened
//! and shifted against each other by a seed. Their inks multiply:
//!
//! ```text
//! a    = clamp(M (1 - rgb))                M: pseudo-inverse of the inks' own (1 - rgb), each row scaled to a sum of 1
//! out  = product over inks of (1 - a_i (1 - ink_i))
//! ```
//!
//! Sources: Kubelka-like overprints by multiplication as printers' simulations have them; the pseudo-inverse is Penrose's.

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::file::Step;
use crate::grain::{Tile, chance};
use crate::order::sort_by_key;
use crate::params::{Args, Gaps, Kind, Unit, colour, integer, number, param};
use crate::raster::{Image, Plane};
use crate::simd::dots::Screen;

/// Inks, by their places, that together print all colours.
const PROCESS_INKS: [f32; 3] = [4.0, 5.0, 6.0];

pub(super) static BLOCK: Block = Block {
    id: "plates",
    label: "Printing Plates",
    plain: "Inks",
    help: "Prints with two or three inks that do not quite fit, like a risograph or a screen print.",
    input: Channels::Any,
    output: Channels::Color,
    params: &[
        param("inks", "Inks", "Which inks are on the plates.", Kind::Choice { names: NAMES }),
        number("shift", "Misfit", "How far plates miss each other.", (3.0, 0.0, 20.0, 0.5), Unit::Pixels),
        number("grain", "Grain", "How coarse and broken the ink is.", (35.0, 0.0, 100.0, 1.0), Unit::Percent)
            .correcting(Gaps { texture: 0.8, ..Gaps::NONE }),
        number(
            "pitch",
            "Dots",
            "Distance between dots of a screen. Values below 3 turn the screen off.",
            (0.0, 0.0, 30.0, 0.5),
            Unit::Pixels,
        )
        .pitch(),
        integer("steps", "Steps", "Tones of a plate, paper among them; 1 keeps all.", (1, 1, 6)),
        number("density", "Density", "How much ink is laid.", (100.0, 40.0, 160.0, 1.0), Unit::Percent)
            .correcting(Gaps { tone: -0.8, ..Gaps::NONE }),
        integer("seed", "Chance", "Random seed for the shift of the plates.", (1, 0, 99)).fixed(),
        colour("ink_1", "Ink 1", "An ink of the set \"own\". White turns it off.", ink::RED.rgb),
        colour("ink_2", "Ink 2", "An ink of the set \"own\". White turns it off.", ink::BLUE.rgb),
        colour("ink_3", "Ink 3", "An ink of the set \"own\". White turns it off.", [255; 3]),
    ],
    kernel: Kernel::Image(|args, image, context| run(args, &image, context)),
    is_screen: true,
    is_coloring: true,
    recolors: |values| !PROCESS_INKS.contains(&values[0]),
    ..Block::PLAIN
};

const NAMES: &[&str] = &[
    "red-blue",
    "pink-teal",
    "orange-navy",
    "coral-green",
    "yellow-blue-red",
    "pink-yellow-teal",
    "cyan-magenta-yellow",
    "red-black",
    "yellow-black",
    "teal-black",
    "violet-orange-black",
    "own",
];

/// Index of the first parameter of the inks of the set "own".
const OWN: usize = 7;

/// An ink with its name in print and its solid colour on white paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ink {
    /// Its name, in English, fit for a file.
    pub name: &'static str,
    /// Its colour.
    pub rgb: [u8; 3],
}

/// Colours of printing inks, as they look on white paper.
mod ink {
    use super::Ink;

    const fn ink(name: &'static str, rgb: [u8; 3]) -> Ink {
        Ink { name, rgb }
    }

    pub(super) const RED: Ink = ink("red", [241, 80, 60]);
    pub(super) const BLUE: Ink = ink("blue", [0, 98, 172]);
    pub(super) const PINK: Ink = ink("pink", [255, 72, 160]);
    pub(super) const TEAL: Ink = ink("teal", [0, 131, 138]);
    pub(super) const ORANGE: Ink = ink("orange", [255, 122, 42]);
    pub(super) const NAVY: Ink = ink("navy", [34, 44, 96]);
    pub(super) const CORAL: Ink = ink("coral", [255, 116, 108]);
    pub(super) const GREEN: Ink = ink("green", [0, 120, 86]);
    pub(super) const YELLOW: Ink = ink("yellow", [255, 224, 0]);
    pub(super) const CYAN: Ink = ink("cyan", [0, 160, 220]);
    pub(super) const MAGENTA: Ink = ink("magenta", [224, 20, 130]);
    pub(super) const VIOLET: Ink = ink("violet", [116, 88, 170]);
    pub(super) const BLACK: Ink = ink("black", [28, 26, 30]);
}

/// The inks that a step of this block prints with, the strongest last: it is the plate that fits, and the others miss it.
#[must_use]
pub fn inks_of(step: &Step) -> Option<Vec<Ink>> {
    (step.block.id == BLOCK.id && !step.bypass).then(|| inks(Args::new(&step.values, 1.0)))
}

/// Returns the step for plates that are printed on a press: misregistration and grain then come from the
/// press.
#[must_use]
pub fn exact(step: &Step) -> Step {
    let mut step = step.clone();
    for (param, value) in BLOCK.params.iter().zip(&mut step.values) {
        if matches!(param.id, "shift" | "grain") {
            *value = 0.0;
        }
    }
    step
}

fn inks(args: Args<'_>) -> Vec<Ink> {
    let named: &[Ink] = match args.choice(0) {
        0 => &[ink::RED, ink::BLUE],
        1 => &[ink::PINK, ink::TEAL],
        2 => &[ink::ORANGE, ink::NAVY],
        3 => &[ink::CORAL, ink::GREEN],
        4 => &[ink::YELLOW, ink::RED, ink::BLUE],
        5 => &[ink::YELLOW, ink::PINK, ink::TEAL],
        6 => &[ink::YELLOW, ink::MAGENTA, ink::CYAN],
        7 => &[ink::RED, ink::BLACK],
        8 => &[ink::YELLOW, ink::BLACK],
        9 => &[ink::TEAL, ink::BLACK],
        10 => &[ink::VIOLET, ink::ORANGE, ink::BLACK],
        _ => return own_inks(args),
    };
    named.to_vec()
}

/// The inks that parameters tell, the darkest last; black where all are white.
fn own_inks(args: Args<'_>) -> Vec<Ink> {
    const NAMES: [&str; 3] = ["ink-1", "ink-2", "ink-3"];
    let light = |ink: &Ink| ink.rgb.iter().map(|&tone| u32::from(tone)).sum::<u32>();
    let told = NAMES.iter().enumerate().map(|(i, &name)| Ink { name, rgb: args.colour(OWN + i) });
    let mut inks: Vec<Ink> = told.filter(|ink| light(ink) < 740).collect();
    sort_by_key(&mut inks, |ink| std::cmp::Reverse(light(ink)));
    if inks.is_empty() { vec![ink::BLACK] } else { inks }
}

/// Angles of the screens, as cosine and sine: 75, 15 and 45 degrees.
const ANGLES: [(f64, f64); 3] = [
    (0.258_819_045_102_520_76, 0.965_925_826_289_068_3),
    (0.965_925_826_289_068_3, 0.258_819_045_102_520_76),
    (std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2),
];

/// Size of the grain's spots, at 1920 x 1080.
const SPOT: f32 = 1.6;

/// Size of the places where the roller left more or less, at 1920 x 1080.
const CLOUD: f32 = 40.0;

fn run(args: Args<'_>, image: &Image, context: &mut Context<'_>) -> Result<Image> {
    let inks = inks(args);
    let shift = args.pixels(1);
    let grain = args.number(2) / 100.0;
    // Below two pixels a grid of dots aliases into nonsense.
    let pitch = (args.number(3) >= 3.0).then(|| args.pixels(3).max(2.0));
    let steps = args.number(4) as i32;
    let seed = args.number(6) as u32;
    let shares = shares(&inks, args.number(5) / 100.0);
    let (width, height) = (image.width(), image.height());
    let mut out = [(); 3].map(|()| Plane::filled(width, height, 255));
    let mut coverage = vec![0u8; width];
    let mut printed = vec![0u8; width];
    let mut noise = vec![0u8; width];
    let mut cloud = vec![0u8; width];
    let tile = |seed: u32, size: f32, spots: f32| {
        Tile::new(seed, size * context.scale(), (size * spots * context.scale()).max(24.0))
    };
    let (spots, clouds) = (tile(seed + 31, SPOT, 256.0), tile(seed + 57, CLOUD, 16.0));
    for (i, (ink, share)) in inks.iter().zip(&shares).enumerate() {
        let fits = i + 1 == inks.len();
        let (dx, dy) = if fits { (0, 0) } else { misfit(shift, seed, i as u32) };
        let screen = pitch.map(|pitch| Screen::new(ANGLES[i + 3 - inks.len()], f64::from(pitch)));
        // The grain of each plate has a separate offset.
        let apart = i * height / 3 + i * 57;
        for y in 0..height {
            if y % 128 == 0 {
                context.check_cancelled()?;
            }
            let from = (y as isize - dy).clamp(0, height as isize - 1) as usize;
            cover(image, from, share, steps, &mut coverage);
            if grain > 0.0 {
                spots.row(from + apart, apart, &mut noise);
                clouds.row(from + apart, apart, &mut cloud);
                let strength = (grain * 256.0) as i32;
                for ((tone, &noise), &cloud) in coverage.iter_mut().zip(&noise).zip(&cloud) {
                    *tone = grained(*tone, noise, cloud, strength);
                }
            }
            // Shifted, with the border repeated.
            let last = width as isize - 1;
            if dx == 0 {
                printed.copy_from_slice(&coverage);
            } else {
                for (x, out) in printed.iter_mut().enumerate() {
                    *out = coverage[(x as isize - dx).clamp(0, last) as usize];
                }
            }
            if let Some(screen) = &screen {
                coverage.copy_from_slice(&printed);
                screen.print(y, &coverage, &mut printed);
                for tone in &mut printed {
                    *tone = 255 - *tone;
                }
            }
            for (plane, ink) in out.iter_mut().zip(ink.rgb) {
                multiply(plane.row_mut(y), &printed, ink);
            }
        }
    }
    Image::from_rgb(out)
}

/// Offset of a plate from the plate that fits.
fn misfit(shift: f32, seed: u32, plate: u32) -> (isize, isize) {
    let random = |part: u32| 2.0 * chance(seed, plate, part) - 1.0;
    let (x, y) = (random(1), random(2));
    // A direction by chance, and between half and all of the distance.
    let length = (x * x + y * y).sqrt().max(0.05);
    let far = shift * (0.75 + 0.25 * random(3));
    ((x / length * far).round() as isize, (y / length * far).round() as isize)
}

/// For each ink its shares of 1 - R, 1 - G and 1 - B, in Q12.
fn shares(inks: &[Ink], density: f32) -> Vec<[i32; 3]> {
    let colors: Vec<[f64; 3]> =
        inks.iter().map(|ink| ink.rgb.map(|tone| 1.0 - f64::from(tone) / 255.0)).collect();
    let n = colors.len();
    // (C C^T + small)^-1 C by elimination. The added diagonal keeps two similar inks from pulling against
    // each other.
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let product = |j: usize| (0..3).map(|c| colors[i][c] * colors[j][c]).sum::<f64>();
            let left = (0..n).map(|j| product(j) + if i == j { 0.06 } else { 0.0 });
            left.chain(colors[i]).collect()
        })
        .collect();
    for pivot in 0..n {
        let divisor = rows[pivot][pivot];
        rows[pivot].iter_mut().for_each(|value| *value /= divisor);
        let own = rows[pivot].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != pivot) {
            let factor = row[pivot];
            row.iter_mut().zip(&own).for_each(|(value, own)| *value -= factor * own);
        }
    }
    rows.iter()
        .map(|row| {
            let weights = [row[n], row[n + 1], row[n + 2]];
            let sum: f64 = weights.iter().sum();
            weights.map(|weight| (weight / sum.max(0.2) * f64::from(density) * 4096.0).round() as i32)
        })
        .collect()
}

/// The ink of a row: its share of the difference to white, in steps if the plate has steps.
fn cover(image: &Image, y: usize, share: &[i32; 3], steps: i32, out: &mut [u8]) {
    match image.planes() {
        [r, g, b] => {
            let pixels = r.row(y).iter().zip(g.row(y)).zip(b.row(y));
            for (out, ((&r, &g), &b)) in out.iter_mut().zip(pixels) {
                let missing = share[0] * i32::from(255 - r)
                    + share[1] * i32::from(255 - g)
                    + share[2] * i32::from(255 - b);
                *out = ((missing + 2048) >> 12).clamp(0, 255) as u8;
            }
        }
        [tones, ..] => {
            let share: i32 = share.iter().sum();
            for (out, &tone) in out.iter_mut().zip(tones.row(y)) {
                *out = ((share * i32::from(255 - tone) + 2048) >> 12).clamp(0, 255) as u8;
            }
        }
        [] => {}
    }
    if steps > 1 {
        for out in out {
            let step = (i32::from(*out) * steps / 256).min(steps - 1);
            *out = (step * 255 / (steps - 1)) as u8;
        }
    }
}

/// Coverage of ink that missed some fibres and was rolled on unevenly.
/// It is (a + 3.2 grain (noise - 1/2) a (1.25 - a)) (1 - .3 grain cloud^2). `grain` is in 1/256.
#[inline]
fn grained(tone: u8, noise: u8, cloud: u8, grain: i32) -> u8 {
    let (a, noise, cloud) = (i32::from(tone), i32::from(noise) - 128, i32::from(cloud));
    // a (1.25 - a) in 1/256; 819 is 3.2 in 1/256.
    let broken = (a * (319 - a)) >> 8;
    let a = (a + ((((broken * grain) >> 8) * noise * 819) >> 16)).clamp(0, 255);
    // 77 is .3 in 1/256.
    let rolled = 65_536 - ((((cloud * cloud) >> 8) * 77 * grain) >> 8);
    ((a * rolled + 32_768) >> 16) as u8
}

/// Lays ink of some coverage over a row.
fn multiply(row: &mut [u8], coverage: &[u8], ink: u8) {
    let missing = u32::from(255 - ink);
    for (tone, &covered) in row.iter_mut().zip(coverage) {
        let left = 65_025 - missing * u32::from(covered);
        // tone left / 65025, rounded to nearest within a step.
        *tone = ((u32::from(*tone) * (left >> 2) + 8128) / 16_256) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::tried;

    fn printed(image: &Image, change: &[(usize, f32)]) -> Image {
        tried(&BLOCK, change, |args, context| run(args, image, context))
    }

    #[test]
    fn white_is_paper_and_black_is_dark_whatever_the_inks() {
        for (choice, name) in NAMES.iter().enumerate().take(NAMES.len() - 1) {
            let image = Image::from_luma(Plane::from_fn(40, 20, |x, _| if x < 20 { 255 } else { 0 }));
            let out = printed(&image, &[(0, choice as f32), (1, 0.0), (2, 0.0)]);
            let tones: Vec<u8> = out.planes().iter().map(|plane| plane.at(33, 3)).collect();
            assert!(out.planes().iter().all(|plane| plane.at(3, 3) == 255), "{name}");
            assert!(tones.iter().map(|&tone| u32::from(tone)).sum::<u32>() < 150, "{name}: {tones:?}");
        }
    }

    #[test]
    fn an_ink_of_the_set_is_printed_mostly_by_itself() {
        for (choice, name) in NAMES.iter().enumerate().take(2) {
            let set = inks(Args::new(&[choice as f32], 1.0));
            for (i, ink) in set.iter().enumerate() {
                let shares = shares(&set, 1.0);
                let covered = |k: usize| -> i32 {
                    (0..3)
                        .map(|c| shares[k][c] * i32::from(255 - ink.rgb[c]))
                        .sum::<i32>()
                        .clamp(0, 255 << 12)
                };
                assert!(covered(i) > 2 * covered(1 - i), "{name} {i}");
            }
        }
    }

    #[test]
    fn inks_of_ones_own_are_printed_without_the_white_ones() {
        let own = |inks: [[u8; 3]; 3]| -> Vec<[u8; 3]> {
            let mut values: Vec<f32> = BLOCK.params.iter().map(|param| param.kind.default()).collect();
            values[OWN..].copy_from_slice(&inks.map(crate::params::colour_value));
            own_inks(Args::new(&values, 1.0)).iter().map(|ink| ink.rgb).collect()
        };
        assert_eq!(own([[20, 30, 80], [255; 3], [240, 120, 90]]), [[240, 120, 90], [20, 30, 80]]);
        assert_eq!(own([[255; 3]; 3]), [ink::BLACK.rgb]);
    }

    #[test]
    fn the_last_plate_fits_and_the_others_miss_by_the_distance() {
        for seed in 0..20 {
            let (x, y) = misfit(8.0, seed, 0);
            let length = ((x * x + y * y) as f64).sqrt();
            assert!((3.0..=9.0).contains(&length), "{seed}: {x} {y}");
        }
    }
}
