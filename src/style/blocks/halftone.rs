//! Halftone: dots of ink on a turned grid, as offset printing lays them.
//!
//! Inks from colour: K = 1 - max, C = (max - R) / max, M and Y alike. A dot's radius r (in cells) covers the
//! share v of its cell: v = pi r^2 up to r = 1/2, beyond it the circles overlap and
//! v = pi r^2 - 4 (r^2 acos(1 / 2r) - sqrt(r^2 - 1/4) / 2). A pixel at the distance d (in cells) from its dot's
//! centre takes the ink clamp((r - d) pitch + 1/2): an edge one pixel soft. Inks multiply.

use super::{Block, Channels, Kernel};
use crate::error::Result;
use crate::raster::Image;
use crate::simd::point::luma_plane;
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
            Ok(cmyk(image, pitch))
        }
    }),
};

/// Angles of the inks in degrees: the ones that printers use, so that no two grids beat visibly.
const CYAN: f32 = 15.0;
const MAGENTA: f32 = 75.0;
const YELLOW: f32 = 0.0;
const BLACK: f32 = 45.0;

/// Radii are stored as u8, 255 for a radius of one cell: far enough beyond the corners, at 1/sqrt(2), that solid
/// ink has no soft edge left in them.
const RADIUS_STEPS: f32 = 255.0;

fn mono(image: &Image, pitch: f32, context: &mut Context<'_>) -> Result<Image> {
    let was_luma = image.is_luma();
    let mut y = luma_plane(image);
    let radii = radii();
    let screen = Screen::new(BLACK, pitch);
    let mut row_radii = vec![0; y.width()];
    for row in 0..y.height() {
        let samples = y.row_mut(row);
        for (radius, &sample) in row_radii.iter_mut().zip(samples.iter()) {
            *radius = radii[usize::from(255 - sample)];
        }
        samples.fill(255);
        screen.print(row, &row_radii, samples);
    }
    if was_luma {
        return Ok(Image::from_luma(y));
    }
    let copies = [context.copy_plane(&y), context.copy_plane(&y)];
    let [g, b] = copies;
    Image::from_rgb([y, g, b])
}

fn cmyk(mut image: Image, pitch: f32) -> Image {
    let (width, height) = (image.width(), image.height());
    let radii = radii();
    let [cyan, magenta, yellow, black] = [CYAN, MAGENTA, YELLOW, BLACK].map(|a| Screen::new(a, pitch));
    let mut inks = [0; 4].map(|_| vec![0u8; width]);
    let mut key = vec![0u8; width];
    let [r, g, b] = image.planes_mut() else { return image };
    for y in 0..height {
        let rows = [r.row_mut(y), g.row_mut(y), b.row_mut(y)];
        separate(&rows, &mut inks);
        for ink in &mut inks {
            for value in ink.iter_mut() {
                *value = radii[usize::from(*value)];
            }
        }
        key.fill(255);
        black.print(y, &inks[3], &mut key);
        for ((row, ink), screen) in rows.into_iter().zip(&inks).zip([&cyan, &magenta, &yellow]) {
            row.copy_from_slice(&key);
            screen.print(y, ink, row);
        }
    }
    image
}

/// C, M, Y and K (0..=255) of one row.
fn separate(rows: &[&mut [u8]; 3], inks: &mut [Vec<u8>; 4]) {
    let [c, m, y, k] = inks;
    let inks = c.iter_mut().zip(m).zip(y).zip(k);
    let pixels = rows[0].iter().zip(rows[1].iter()).zip(rows[2].iter());
    for ((((c, m), y), k), ((&r, &g), &b)) in inks.zip(pixels) {
        let most = r.max(g).max(b);
        let share = 255.0 / f32::from(most.max(1));
        let ink = |channel: u8| (f32::from(most - channel) * share + 0.5) as u8;
        (*c, *m, *y, *k) = (ink(r), ink(g), ink(b), 255 - most);
    }
}

/// A turned grid of dots.
struct Screen {
    cos: f32,
    sin: f32,
    pitch: f32,
}

impl Screen {
    fn new(degrees: f32, pitch: f32) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Self { cos: cos / pitch, sin: sin / pitch, pitch }
    }

    /// Multiplies row `y` of a plane by its paper: 255 where no ink falls.
    fn print(&self, y: usize, radii: &[u8], out: &mut [u8]) {
        let (u0, v0) = (self.sin * y as f32, self.cos * y as f32);
        for (x, (out, &radius)) in out.iter_mut().zip(radii).enumerate() {
            let x = x as f32;
            let (u, v) = (u0 + self.cos * x, v0 - self.sin * x);
            let (u, v) = (from_center(u), from_center(v));
            let distance = (u * u + v * v).sqrt();
            let radius = f32::from(radius) / RADIUS_STEPS;
            // A dot of no radius leaves no ink, also in the middle of its cell.
            let edge = if radius > 0.0 { 0.5 } else { -0.5 };
            let ink = ((radius - distance) * self.pitch + edge).clamp(0.0, 1.0);
            *out = (f32::from(*out) * (1.0 - ink) + 0.5) as u8;
        }
    }
}

/// Signed distance from the centre of a cell, -1/2..=1/2. The shift makes the coordinate positive, where a
/// cast is a floor that every processor has lanes for.
#[inline]
fn from_center(position: f32) -> f32 {
    const SHIFT: f32 = 8192.0;
    let shifted = position + SHIFT;
    shifted - (shifted as i32) as f32 - 0.5
}

/// Radius (in [`RADIUS_STEPS`]) of each coverage 0..=255.
fn radii() -> [u8; 256] {
    let mut radius = 0.0f32;
    std::array::from_fn(|coverage| {
        if coverage == 255 {
            return u8::MAX;
        }
        // Coverage grows with the radius, so one walk serves all entries.
        while covered(radius) < coverage as f32 / 255.0 && radius < std::f32::consts::FRAC_1_SQRT_2 {
            radius += 0.25 / RADIUS_STEPS;
        }
        (radius * RADIUS_STEPS).round() as u8
    })
}

/// Share of a cell that a dot of `radius` cells covers.
fn covered(radius: f32) -> f32 {
    let square = radius * radius;
    let disc = std::f32::consts::PI * square;
    if radius <= 0.5 {
        return disc;
    }
    disc - 4.0 * (square * (0.5 / radius).acos() - 0.5 * (square - 0.25).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

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
            let out = cmyk(image, 7.0);
            assert!(out.planes().iter().all(|p| p.samples().iter().all(|&v| v == expected)));
        }
    }
}
