//! Flatten: areas of few colours with clean borders, as cut paper or a colourist's flats.
//!
//! ```text
//! palette  = k means of the photo's colours in Oklab, one that is named, or a person's own
//! labels   = argmin of distance to the palette - smoothness * equal neighbours     (iterated conditional modes)
//! areas smaller than `detail` join the neighbour with the longest border
//! borders  = the larger of two Gaussian counts of labels, one pixel soft
//! ```
//!
//! Labels are found on half the resolution.
//!
//! Sources: Ottosson, "A perceptual color space for image processing", 2020 (Oklab); Besag, "On the statistical analysis of
//! dirty pictures", 1986 (iterated conditional modes).

mod areas;
mod palette;

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::params::{Args, FaceLimit, Gaps, Kind, Param, Unit, colour, integer, number, param};
use crate::raster::resize::{Region, resample_image};
use crate::raster::{Image, Plane};
use crate::simd::blade::halve;
pub(crate) use palette::{CELLS, cell_of, cells, distance, histogram, means, oklab};
use palette::{Costs, NAMES, OWN};

pub(super) static BLOCK: Block = Block {
    id: "flatten",
    label: "Flat Areas",
    plain: "Flat colours",
    help: "Turns the photo into areas of few colours with clean borders, like cut paper.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        integer("colors", "Colours", "How many colours there are.", (8, 2, 32)).fixed(),
        param("palette", "Palette", "Source of the colours.", Kind::Choice { names: NAMES }),
        number(
            "detail",
            "Smallest area",
            "Smaller areas join a neighbour.",
            (12.0, 0.0, 80.0, 1.0),
            Unit::Pixels,
        )
        .for_face(FaceLimit::Length(1.0 / 9.0))
        .correcting(Gaps { texture: -0.8, ..Gaps::NONE }),
        number(
            "smoothness",
            "Smooth borders",
            "How far borders are straightened.",
            (50.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        number(
            "own",
            "Own colours",
            "How much of its mean colour an area retains.",
            (0.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        own_color("color_1", "Colour 1", [24, 22, 34]),
        own_color("color_2", "Colour 2", [252, 248, 238]),
        own_color("color_3", "Colour 3", [196, 40, 44]),
        own_color("color_4", "Colour 4", [44, 120, 180]),
        own_color("color_5", "Colour 5", [248, 200, 60]),
        own_color("color_6", "Colour 6", [60, 130, 80]),
        own_color("color_7", "Colour 7", [198, 146, 106]),
        own_color("color_8", "Colour 8", [128, 128, 136]),
    ],
    kernel: Kernel::Image(run),
    is_coloring: true,
    recolors: has_own_palette,
    adapt_to_face,
    ..Block::PLAIN
};

/// Index of the first colour parameter of the palette "own", and the number of its colours.
const OWN_COLORS: (usize, usize) = (5, 8);

/// Most colours of flat areas in a face: skin in light and shade, hair, lips and eyes.
const FACE_COLORS: f32 = 6.0;

/// Whether areas mostly have the colours of a palette.
fn has_own_palette(values: &[f32]) -> bool {
    values[1] > 0.0 && values[4] < 50.0
}

fn adapt_to_face(values: &mut [f32]) {
    if !has_own_palette(values) {
        values[0] = values[0].min(FACE_COLORS);
        values[1] = 0.0;
    }
}

const fn own_color(id: &'static str, label: &'static str, default: [u8; 3]) -> Param {
    colour(id, label, "A colour of the palette \"own\".", default)
}

/// Side of the squares of pixels that share a label.
const STEP: usize = 2;

/// Scale of the picture whose colours make the palette.
const SAMPLE: f32 = 0.125;

fn run(args: Args<'_>, mut image: Image, context: &mut Context<'_>) -> Result<Image> {
    let small = halved(&image);
    let reduced = |length: usize| {
        ((length as f32 * SAMPLE / (context.scale().max(0.05) / STEP as f32)).round() as usize)
            .clamp(1, length)
    };
    let whole = Region::whole(small.width(), small.height());
    let sample = resample_image(&small, whole, reduced(small.width()), reduced(small.height()));
    let count = args.number(0) as usize;
    let costs = if args.choice(1) == OWN {
        let (first, most) = OWN_COLORS;
        Costs::of_palette(&small, (first..first + count.min(most)).map(|i| args.colour(i)).collect())
    } else {
        Costs::new(&small, &sample, args.choice(1), count)
    };
    context.check_cancelled()?;
    let (width, height) = (small.width(), small.height());
    let mut labels = costs.nearest(&small);
    areas::settle(&mut labels, (width, height), &small, &costs, args.number(3) / 100.0);
    context.check_cancelled()?;
    let side = args.pixels(2) / STEP as f32;
    let areas = areas::merge_small(&mut labels, (width, height), (side * side) as usize);
    context.check_cancelled()?;
    let own = args.number(4) / 100.0;
    let colors = areas::colors(&areas, &labels, &small, costs.palette(), own);
    let blur = (0.6 + args.number(3) / 100.0 * 1.6 * context.scale().max(0.3)).min(3.0);
    areas::paint(&areas, (width, height), &colors, blur, image.planes_mut());
    Ok(image)
}

/// Means of 2 x 2 pixels, as R, G and B.
fn halved(image: &Image) -> Image {
    let last = image.planes().len() - 1;
    let half = |plane: &Plane| {
        let (width, height) = (plane.width().div_ceil(STEP), plane.height().div_ceil(STEP));
        let mut small = Plane::filled(width, height, 0);
        let mut means = vec![0.0; width];
        for y in 0..height {
            let (above, below) = (plane.row(y * STEP), plane.row((y * STEP + 1).min(plane.height() - 1)));
            halve(above, below, &mut means);
            for (out, mean) in small.row_mut(y).iter_mut().zip(&means) {
                *out = (mean + 0.5) as u8;
            }
        }
        small
    };
    let planes = [0, 1, 2].map(|i| half(&image.planes()[i.min(last)]));
    // Three planes of one size are always an image.
    Image::from_rgb(planes).unwrap_or_else(|_| image.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::tried;
    use crate::params::colour_value;
    use std::collections::BTreeSet;

    fn flattened(image: Image, change: &[(usize, f32)]) -> Image {
        tried(&BLOCK, change, |args, context| run(args, image, context))
    }

    #[test]
    fn noisy_areas_become_flat_and_their_borders_stay() {
        let mut random = oorandom::Rand32::new(5);
        let mut tone = |own: u8| own.saturating_add(random.rand_range(0..24) as u8);
        let inside = |x: usize, y: usize| (x as i32 - 60).pow(2) + (y as i32 - 50).pow(2) < 900;
        let plane = |inner: u8, outer: u8, tone: &mut dyn FnMut(u8) -> u8| {
            Plane::from_fn(120, 100, |x, y| tone(if inside(x, y) { inner } else { outer }))
        };
        let planes = [plane(200, 30, &mut tone), plane(60, 90, &mut tone), plane(40, 160, &mut tone)];
        let out = flattened(Image::from_rgb(planes).unwrap(), &[(0, 2.0)]);
        let at = |x: usize, y: usize| [0, 1, 2].map(|c: usize| out.planes()[c].at(x, y));
        let mut seen = BTreeSet::new();
        for y in 0..100 {
            for x in 0..120 {
                let far = ((x as f64 - 60.0).hypot(y as f64 - 50.0) - 30.0).abs();
                if far > 3.0 {
                    seen.insert(at(x, y));
                    let expected: [i32; 3] = if inside(x, y) { [212, 72, 52] } else { [42, 102, 172] };
                    for (found, expected) in at(x, y).iter().zip(expected) {
                        assert!((i32::from(*found) - expected).abs() < 10, "{x}, {y}: {:?}", at(x, y));
                    }
                }
            }
        }
        assert_eq!(seen.len(), 2, "{seen:?}");
    }

    #[test]
    fn a_speck_joins_what_is_around_it() {
        let plane = Plane::from_fn(80, 80, |x, y| {
            let speck = (30..42).contains(&x) && (30..42).contains(&y);
            if speck || x > 60 { 220 } else { 40 }
        });
        let out = flattened(Image::from_luma(plane.clone()), &[(0, 2.0), (2, 40.0)]);
        assert!(out.planes()[0].at(36, 36) < 60 && out.planes()[0].at(75, 33) > 200);
        let out = flattened(Image::from_luma(plane), &[(0, 2.0), (2, 0.0)]);
        assert!(out.planes()[0].at(36, 36) > 200);
    }

    #[test]
    fn named_palettes_give_their_colours_alone() {
        let image = Image::from_rgb(
            [0, 1, 2].map(|c| Plane::from_fn(64, 64, |x, y| (x * 3 + y + 30 * c).min(255) as u8)),
        )
        .unwrap();
        for (choice, name) in NAMES.iter().enumerate().take(OWN).skip(1) {
            let out = flattened(image.clone(), &[(1, choice as f32), (3, 0.0)]);
            let costs = Costs::new(&halved(&image), &halved(&image), choice, 8);
            let flat = (0..63).flat_map(|y| (0..63).map(move |x| (x, y)));
            let known = flat.filter(|&(x, y)| {
                let at = |x: usize, y: usize| [0, 1, 2].map(|c: usize| out.planes()[c].at(x, y));
                costs.palette().contains(&at(x, y))
            });
            assert!(known.count() > 2400, "{name}");
        }
    }

    #[test]
    fn a_palette_of_ones_own_gives_its_first_colours_alone() {
        let image =
            Image::from_rgb([0, 1, 2].map(|c| Plane::from_fn(64, 64, |x, y| (x * 3 + y + 30 * c) as u8)));
        let own = [[200, 30, 40], [20, 40, 90]];
        let values = [colour_value(own[0]), colour_value(own[1])];
        let change = [(0, 2.0), (1, OWN as f32), (3, 0.0), (5, values[0]), (6, values[1])];
        let out = flattened(image.unwrap(), &change);
        let at = |x: usize, y: usize| [0, 1, 2].map(|c: usize| out.planes()[c].at(x, y));
        assert_eq!((at(60, 60), at(2, 2)), (own[0], own[1]));
    }
}
