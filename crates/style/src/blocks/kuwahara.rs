//! Kuwahara: paint. Every pixel gets the colour of the calmest areas around it, so that areas become strokes
//! and edges stay in place.
//!
//! Eight windows, Gaussians of .4 radius, are placed on an ellipse around the pixel, at .6 radius from it.
//! The stretch and the coherence there make the ellipse longer along the tangent of edges and narrower across
//! it. A window's spread is the mean distance of its luma from its mean. [`crate::simd::oriented::choose`]
//! weighs windows by it. Means of windows replace the sectors of the original, at eight reads per pixel and
//! no loop over the radius.
//!
//! Sources: Kyprianidis, Kang and Döllner, "Image and video abstraction by anisotropic Kuwahara filtering", 2009;
//! Kyprianidis, "Image and video abstraction by multi-scale anisotropic Kuwahara filtering", 2011 (several passes).

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::params::{Args, FaceLimit, Gaps, Unit, integer, number};
use crate::raster::{Image, Plane};
use crate::simd::fine::FRACTION;
use crate::simd::gaussian::blur;
use crate::simd::oriented::{FRACTION as WIDE_FRACTION, SECTORS, Wide, choose};
use crate::simd::point::luma_plane;
use crate::tangents::{TURNS, Tangents, unit};

pub(super) static BLOCK: Block = Block {
    id: "kuwahara",
    label: "Anisotropic Kuwahara",
    plain: "Paint",
    help: "Paints over the photo with strokes that follow its shapes, like oil or gouache.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number("radius", "Brush", "Reach of a stroke.", (8.0, 2.0, 30.0, 0.5), Unit::Pixels)
            .for_face(FaceLimit::Length(1.0 / 14.0))
            .correcting(Gaps { texture: -0.7, ..Gaps::NONE }),
        number("sharpness", "Sharpness", "How crisp strokes end.", (70.0, 0.0, 100.0, 1.0), Unit::Percent),
        number(
            "stretch",
            "Stretch",
            "Length of strokes along edges, relative to their width.",
            (70.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        integer("passes", "Passes", "Number of passes.", (2, 1, 4)),
    ],
    kernel: Kernel::Image(run),
    ..Block::PLAIN
};

/// Sigma of a window and its distance from the pixel, in radii.
const WINDOW: (f32, f32) = (0.4, 0.6);

/// Steps of the ellipse's length, from a circle on.
const LENGTHS: usize = 4;

/// Units of spread in an octave.
const OCTAVE: f64 = 256.0;

/// Windows share the weight over this many octaves of spread, at sharpness 0 and 100.
const SHARED: (f32, f32) = (4.0, 0.25);

/// Constant added to every spread, in grey steps: differences within the noise of a photo have no effect.
const NOISE: f64 = 1.0;

fn run(args: Args<'_>, mut image: Image, context: &mut Context<'_>) -> Result<Image> {
    let radius = args.pixels(0);
    if radius < 0.8 {
        return Ok(image);
    }
    let sharpness = args.number(1) / 100.0;
    let reach = (f64::from(SHARED.0 * (SHARED.1 / SHARED.0).powf(sharpness)) * OCTAVE).round() as i16;
    let stretch = args.number(2) / 100.0;
    let places = ellipses(radius * WINDOW.1, stretch);
    let spreads = spread_table();
    for _ in 0..args.number(3) as usize {
        context.check_cancelled()?;
        pass(&mut image, radius, reach, (&places, &spreads), context);
    }
    Ok(image)
}

/// Places about a pixel, as steps to the right and down.
type Ring = [(isize, isize); SECTORS];

/// The eight places of every direction and length.
fn ellipses(distance: f32, stretch: f32) -> Vec<Ring> {
    let one = |shape: usize| {
        let (cos, sin) = unit(shape / LENGTHS);
        let longer = 1.0 + f64::from(stretch) * (shape % LENGTHS) as f64 / (LENGTHS - 1) as f64;
        std::array::from_fn(|k| {
            let (across, along) = (k as f64 * std::f64::consts::PI * 2.0 / SECTORS as f64).sin_cos();
            let (along, across) =
                (along * longer * f64::from(distance), across / longer * f64::from(distance));
            ((along * cos - across * sin).round() as isize, (along * sin + across * cos).round() as isize)
        })
    };
    (0..TURNS * LENGTHS).map(one).collect()
}

/// The logarithm of every spread that a fine plane can hold.
fn spread_table() -> Vec<i16> {
    let unit = f64::from(1 << FRACTION);
    (0..=255 << FRACTION)
        .map(|fine| (OCTAVE * (f64::from(fine) / unit + NOISE).log2()).round() as i16)
        .collect()
}

fn pass(
    image: &mut Image,
    radius: f32,
    reach: i16,
    (places, spreads): (&[Ring], &[i16]),
    context: &mut Context<'_>,
) {
    let luma = luma_plane(image);
    let field = Tangents::of(&luma, (0.8 * radius).max(2.0));
    let lengths = |coherence: u8| usize::from(coherence) * LENGTHS / 256;
    let shapes: Vec<u8> = field
        .turns()
        .iter()
        .zip(field.coherence())
        .map(|(&turn, &coherence)| (usize::from(turn) * LENGTHS + lengths(coherence)) as u8)
        .collect();
    let sigma = radius * WINDOW.0;
    let margin = (2.0 * WINDOW.1 * radius).ceil() as usize + 1;
    let spread = spread_of(&luma, sigma, margin, spreads, context);
    let buffers = &mut context.blurs;
    let means: Vec<Wide> = image
        .planes()
        .iter()
        .map(|plane| {
            let mut fine = buffers.take(plane.width(), plane.height());
            fine.widen(plane);
            let mean = blur(&fine, sigma, buffers);
            let wide = Wide::mapped(&mean, margin, |fine| fine >> (FRACTION - WIDE_FRACTION));
            buffers.give(fine);
            buffers.give(mean);
            wide
        })
        .collect();
    choose(&means, &spread, &shapes, places, reach, image.planes_mut());
}

/// The spread of the window about each pixel: the mean of the distances of luma from its own mean.
fn spread_of(luma: &Plane, sigma: f32, margin: usize, spreads: &[i16], context: &mut Context<'_>) -> Wide {
    let buffers = &mut context.blurs;
    let mut fine = buffers.take(luma.width(), luma.height());
    fine.widen(luma);
    let mean = blur(&fine, sigma, buffers);
    for y in 0..luma.height() {
        for (out, &mean) in fine.row_mut(y).iter_mut().zip(mean.row_clamped(y as isize)) {
            *out = (*out - mean).abs();
        }
    }
    let spread = blur(&fine, sigma, buffers);
    let wide =
        Wide::mapped(&spread, margin, |fine| spreads.get(fine.max(0) as usize).copied().unwrap_or(i16::MAX));
    for fine in [fine, mean, spread] {
        buffers.give(fine);
    }
    wide
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::tried;

    fn painted(image: Image) -> Image {
        tried(&BLOCK, &[], |args, context| run(args, image, context))
    }

    #[test]
    fn an_edge_stays_where_it_is_and_noise_goes() {
        let mut random = oorandom::Rand32::new(9);
        let plane =
            Plane::from_fn(120, 80, |x, _| (if x < 60 { 60 } else { 180 }) + random.rand_range(0..20) as u8);
        let out = painted(Image::from_luma(plane));
        let row = out.planes()[0].row(40);
        assert!(row[..57].iter().all(|&v| v.abs_diff(70) < 6), "{row:?}");
        assert!(row[63..].iter().all(|&v| v.abs_diff(190) < 6), "{row:?}");
    }

    #[test]
    fn flat_colours_stay() {
        let image = Image::from_rgb([250, 128, 3].map(|tone| Plane::filled(50, 30, tone))).unwrap();
        let out = painted(image.clone());
        for (out, before) in out.planes().iter().zip(image.planes()) {
            assert!(out.samples().iter().zip(before.samples()).all(|(&a, &b)| a.abs_diff(b) <= 1));
        }
    }
}
