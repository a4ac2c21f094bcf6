//! Halftone: dots of ink on a turned grid, as offset printing lays them.
//!
//! Inks from colour: K = 1 - max, C = (max - R) / max, and M and Y in the same way. A dot's radius r (in
//! cells) covers the share v of its cell: v = pi r^2 up to r = 1/2. Beyond it the circles overlap and v = pi
//! r^2 - 4 (r^2 acos(1 / 2r) - sqrt(r^2 - 1/4) / 2). A pixel takes its ink by its distance from its dot's
//! centre, with an edge one pixel soft ([`crate::simd::dots`]). Inks multiply.

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::params::{Kind, Unit, number, param};
use crate::raster::Image;
use crate::simd::dots::{Screen, separate};
use crate::simd::point::luma_plane;
use std::f64::consts::FRAC_1_SQRT_2;

pub(super) static BLOCK: Block = Block {
    id: "halftone",
    label: "Halftone",
    plain: "Print dots",
    help: "Prints with dots of ink, in four colours or in black.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number("pitch", "Pitch", "Distance between dots.", (8.0, 3.0, 40.0, 0.5), Unit::Pixels).pitch(),
        param(
            "mode",
            "Inks",
            "Cyan, magenta, yellow and black, or only black.",
            Kind::Choice { names: &["cmyk", "mono"] },
        ),
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
    is_screen: true,
    recolors: |values| values[1] > 0.0,
    ..Block::PLAIN
};

/// Angles of the inks: 15, 75, 0 and 45 degrees, the ones that printers use, so that no two grids beat visibly. Given
/// by cosine and sine, so that every platform has the same.
const CYAN: (f64, f64) = (COS_15, SIN_15);
const MAGENTA: (f64, f64) = (SIN_15, COS_15);
const YELLOW: (f64, f64) = (1.0, 0.0);
const BLACK: (f64, f64) = (FRAC_1_SQRT_2, FRAC_1_SQRT_2);

const COS_15: f64 = 0.965_925_826_289_068_3;
const SIN_15: f64 = 0.258_819_045_102_520_76;

fn mono(image: &Image, pitch: f32, context: &mut Context<'_>) -> Result<Image> {
    let mut y = luma_plane(image);
    let screen = Screen::new(BLACK, f64::from(pitch));
    let mut ink = vec![0; y.width()];
    for row in 0..y.height() {
        let samples = y.row_mut(row);
        for (ink, &sample) in ink.iter_mut().zip(samples.iter()) {
            *ink = 255 - sample;
        }
        screen.print(row, &ink, samples);
    }
    if image.is_luma() {
        return Ok(Image::from_luma(y));
    }
    let [g, b] = [context.copy_plane(&y), context.copy_plane(&y)];
    Image::from_rgb([y, g, b])
}

fn cmyk(mut image: Image, pitch: f32) -> Image {
    let (width, height) = (image.width(), image.height());
    let screens = [CYAN, MAGENTA, YELLOW].map(|turn| Screen::new(turn, f64::from(pitch)));
    let black = Screen::new(BLACK, f64::from(pitch));
    let mut inks = [0; 4].map(|_| vec![0u8; width]);
    let mut key = vec![0u8; width];
    let [r, g, b] = image.planes_mut() else { return image };
    for y in 0..height {
        let rows = [r.row_mut(y), g.row_mut(y), b.row_mut(y)];
        separate(rows.each_ref().map(|row| &**row), &mut inks);
        black.print(y, &inks[3], &mut key);
        for ((row, ink), screen) in rows.into_iter().zip(&inks).zip(&screens) {
            row.copy_from_slice(&key);
            screen.overprint(y, ink, row);
        }
    }
    image
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
