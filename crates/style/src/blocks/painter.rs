//! Painter: repaints a picture in the way of a painter that a network has learned ([`crate::painters`]).
//!
//! The network runs on a reduced picture, so a stroke has the same share of the picture at every size: thumbnail,
//! preview and print agree. The painting is enlarged, and details of the photo that the reduction lost return
//! where the painting follows the photo's luma:
//!
//! ```text
//! painting = enlarged(softened(network(small))) + gain (luma(photo) - enlarged(luma(small)))
//! gain     = covariance(luma(small), luma(network(small))) / variance(luma(small)), in windows of 3 x 3 pixels
//! ```
//!
//! The latest output of the network is stored with its input. It is used again if only the strength or the colours differ:
//! in the block for the other part of a picture, and while a user moves one of these sliders.
//!
//! Without a model of painters, the block changes nothing. A model of the user may have more painters than the built-in
//! one. Numbers beyond the last painter of a model mean this painter.
//!
//! Source of the gain: He, Sun and Tang, "Guided Image Filtering", 2013.

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::painters::{Choice, MAX_PAINTERS, Norms, Painters};
use crate::params::{Args, FaceLimit, Gaps, Kind, Unit, number, param};
use crate::raster::resize::{Region, resample, resample_image};
use crate::raster::{Image, Plane};
use crate::simd::point::{luma_plane, shift_luma};
use std::sync::Arc;

/// Number of painters of the built-in model.
pub const PAINTERS: u8 = 10;

pub(super) static BLOCK: Block = Block {
    id: "painter",
    label: "Painter",
    plain: "Learned painting",
    help: "Repaints the photo in the way of a painter, learned from paintings.",
    input: Channels::Color,
    output: Channels::Color,
    params: &[
        number(
            "painter",
            "Painter",
            "Number of the painter; values between two numbers mix both.",
            (1.0, 1.0, PAINTERS as f32, 0.1),
            Unit::None,
        )
        .up_to(MAX_PAINTERS as f32),
        // Only halved in a face that is drawn again: a finer brush everywhere would take four times as long.
        number("brush", "Brush", "Size of a dab of paint.", (3.0, 2.0, 8.0, 0.1), Unit::Pixels)
            .for_face(FaceLimit::Length(1.0))
            .correcting(Gaps { texture: -0.7, ..Gaps::NONE }),
        number(
            "strength",
            "Strength",
            "How much of the painting replaces the photo.",
            (100.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        number(
            "colours",
            "Photo colours",
            "How much of the photo's colours remains.",
            (0.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        param("model", "Model", "The file that painters come from.", Kind::Model),
    ],
    kernel: Kernel::Image(run),
    recolors: |values| values[3] < RECOLOURED,
    adapt_to_face: spare,
    adapts_to_large_faces: true,
    ..Block::PLAIN
};

/// Photo colours in percent below which the painting has the painter's colours, faces included.
const RECOLOURED: f32 = 50.0;
/// Most paint in a face that keeps its colours, in percent. More paint draws wrinkles.
const FACE_STRENGTH: f32 = 38.0;
/// Largest enlargement of a small picture for the network.
const ENLARGED: f32 = 2.0;
/// Least side of a picture for the network, and the common divisor of its sides.
const SIDE: (usize, usize) = (16, 4);
/// Most pixels for the network. Only pictures above the size of a page exceed it.
const PIXELS: f32 = 1.2e6;
/// Twice the enlargement from which a painting is softened: enlarged, its grain of single pixels is visible.
const SOFTENED: usize = 3;
/// Variance of luma that counts as noise, in squared grey steps.
const NOISE: i32 = 40;

fn run(args: Args<'_>, mut image: Image, context: &mut Context<'_>) -> Result<Image> {
    let strength = (args.number(2) * 2.56).round() as i32;
    let Some(painters) = context.painters(args.model()).filter(|_| strength > 0) else { return Ok(image) };
    let mut painted = match context.known_painting() {
        Some((_, Some(painting))) => painting,
        known => {
            let norms = known.map(|(norms, _)| norms);
            let (painted, norms) = paint(args, &image, &painters, norms, context)?;
            context.note_painting(norms, &painted);
            painted
        }
    };
    let colours = (args.number(3) * 2.56).round() as i32;
    if colours > 0 {
        let (before, after) = (luma_plane(&image), luma_plane(&painted));
        let mut kept = image.clone();
        for plane in kept.planes_mut() {
            shift_luma(plane.samples_mut(), before.samples(), after.samples());
        }
        mix(&mut painted, &kept, colours);
    }
    mix(&mut image, &painted, strength);
    Ok(image)
}

/// The latest output of the network, and its input.
struct Stored {
    small: Image,
    choice: Choice,
    painters: Arc<Painters>,
    /// The given statistics.
    norms: Option<Arc<Norms>>,
    painting: Image,
    /// The statistics that it was painted with.
    used: Arc<Norms>,
}

/// The painting of an image at its size, and the statistics that it was painted with. `norms`: known statistics.
fn paint(
    args: Args<'_>,
    image: &Image,
    painters: &Arc<Painters>,
    norms: Option<Arc<Norms>>,
    context: &mut Context<'_>,
) -> Result<(Image, Arc<Norms>)> {
    let small = reduced(image, args.pixels(1));
    let place = (args.number(0) - 1.0).clamp(0.0, (painters.count() - 1) as f32);
    let choice =
        Choice { first: place as usize, second: place.ceil() as usize, share: place - place.floor() };
    let is_same = |stored: &Stored| {
        let same_norms = match (&stored.norms, &norms) {
            (Some(stored), Some(norms)) => Arc::ptr_eq(stored, norms),
            (stored, norms) => stored.is_none() && norms.is_none(),
        };
        same_norms
            && Arc::ptr_eq(&stored.painters, painters)
            && stored.choice == choice
            && stored.small == small
    };
    let stored = if let Some(stored) = context.take::<Stored>().filter(is_same) {
        stored
    } else {
        let (painting, measured) =
            painters.paint(&small, choice, norms.as_deref(), &|| context.check_cancelled())?;
        let used = norms.clone().unwrap_or_else(|| Arc::new(measured));
        Stored { small, choice, painters: painters.clone(), norms, painting, used }
    };
    let painted = if (stored.small.width(), stored.small.height()) == (image.width(), image.height()) {
        stored.painting.clone()
    } else {
        detailed(&stored.painting, &stored.small, image)
    };
    let used = stored.used.clone();
    context.give(stored);
    Ok((painted, used))
}

/// Less paint for a face that keeps its colours.
fn spare(values: &mut [f32]) {
    if values[3] >= RECOLOURED {
        values[2] = values[2].min(FACE_STRENGTH);
    }
}

/// The picture at the size for the network: a pixel for each `brush` x `brush` pixels.
fn reduced(image: &Image, brush: f32) -> Image {
    let (width, height) = (image.width() as f32, image.height() as f32);
    let most = (PIXELS / (width * height)).sqrt();
    let factor = (1.0 / brush.max(f32::MIN_POSITIVE)).min(ENLARGED).min(most);
    let side = |length: f32| {
        let side = (length * factor / SIDE.1 as f32).round() as usize * SIDE.1;
        side.max(SIDE.0)
    };
    let whole = Region::whole(image.width(), image.height());
    resample_image(image, whole, side(width), side(height))
}

/// The painting of a small picture at the size of the photo, with details of the photo.
fn detailed(painting: &Image, small: &Image, photo: &Image) -> Image {
    let (width, height) = (photo.width(), photo.height());
    let whole = Region::whole(small.width(), small.height());
    if width <= small.width() {
        return resample_image(painting, whole, width, height);
    }
    let mut painting = painting.clone();
    if 2 * width >= SOFTENED * small.width() {
        painting.planes_mut().iter_mut().for_each(soften);
    }
    let mut painted = resample_image(&painting, whole, width, height);
    let small_luma = luma_plane(small);
    let gains = resample(&gains(&small_luma, &luma_plane(&painting)), whole, width, height);
    let (smooth, luma) = (resample(&small_luma, whole, width, height), luma_plane(photo));
    for plane in painted.planes_mut() {
        let details = gains.samples().iter().zip(smooth.samples()).zip(luma.samples());
        for (sample, ((&gain, &smooth), &luma)) in plane.samples_mut().iter_mut().zip(details) {
            let detail = (i32::from(gain) * (i32::from(luma) - i32::from(smooth)) + 128) >> 8;
            *sample = (i32::from(*sample) + detail).clamp(0, 255) as u8;
        }
    }
    painted
}

/// How far a painting follows the luma of its photo at each pixel: 0 not at all, 255 fully.
fn gains(luma: &Plane, painted: &Plane) -> Plane {
    let (width, height) = (luma.width(), luma.height());
    let near = |at: usize, length: usize| at.saturating_sub(1)..(at + 2).min(length);
    Plane::from_fn(width, height, |x, y| {
        let [mut count, mut sum, mut other, mut square, mut product] = [0_i32; 5];
        for y in near(y, height) {
            let columns = near(x, width);
            for (&a, &b) in luma.row(y)[columns.clone()].iter().zip(&painted.row(y)[columns]) {
                let (a, b) = (i32::from(a), i32::from(b));
                count += 1;
                sum += a;
                other += b;
                square += a * a;
                product += a * b;
            }
        }
        let variance = count * square - sum * sum + NOISE * count * count;
        let covariance = count * product - sum * other;
        (i64::from(covariance.max(0)) * 255 / i64::from(variance.max(1))).min(255) as u8
    })
}

/// Means of 3 x 3 pixels with the weights 1, 2, 1 per axis.
fn soften(plane: &mut Plane) {
    let (width, height) = (plane.width(), plane.height());
    let mean = |plane: &Plane, [a, b, c]: [(usize, usize); 3]| {
        let [a, b, c] = [a, b, c].map(|(x, y)| u16::from(plane.at(x, y)));
        ((a + 2 * b + c + 2) >> 2) as u8
    };
    let near = |at: usize, side: usize| [at.saturating_sub(1), at, (at + 1).min(side - 1)];
    let across = Plane::from_fn(width, height, |x, y| mean(plane, near(x, width).map(|x| (x, y))));
    *plane = Plane::from_fn(width, height, |x, y| mean(&across, near(y, height).map(|y| (x, y))));
}

/// Moves an image toward another one by `share` of 256.
fn mix(image: &mut Image, other: &Image, share: i32) {
    for (plane, other) in image.planes_mut().iter_mut().zip(other.planes()) {
        for (sample, &other) in plane.samples_mut().iter_mut().zip(other.samples()) {
            let value = i32::from(*sample);
            *sample = (value + ((share * (i32::from(other) - value) + 128) >> 8)) as u8;
        }
    }
}
