//! What holds for every block of the registry, whatever it does: sizes, determinism, every extreme of its
//! parameters, and that no pixel depends on how wide the row is that a lane kernel happens to work on.

#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

use inkpanel::raster::{Image, Plane};
use inkpanel::style::blocks::{ALL, Block, Channels};
use inkpanel::style::context::Context;
use inkpanel::style::file::Step;
use inkpanel::style::{chain, params::Kind};

/// Odd and even, thin and square, below, at and above a group of lanes.
const SIZES: &[(usize, usize)] =
    &[(1, 1), (2, 1), (1, 2), (3, 5), (1, 67), (67, 1), (8, 8), (15, 17), (16, 16), (33, 31), (67, 67)];

/// Noise over a ramp: every tone, edges, no symmetry.
fn plane(width: usize, height: usize, seed: u64) -> Plane {
    let mut random = oorandom::Rand32::new(seed);
    Plane::from_fn(width, height, |x, y| ((x * 5 + y * 3) as u32 + random.rand_range(0..60)) as u8)
}

/// What a block takes: luma or colour, both where it takes either.
fn inputs(block: &Block, width: usize, height: usize) -> Vec<Image> {
    let luma = Image::from_luma(plane(width, height, 1));
    let color = Image::from_rgb([2, 3, 4].map(|seed| plane(width, height, seed))).unwrap();
    match block.input {
        Channels::Luma => vec![luma],
        Channels::Color => vec![color],
        Channels::Any => vec![luma, color],
    }
}

/// The defaults, and every parameter at either end with the others at theirs or all of them at one end.
fn settings(block: &Block) -> Vec<Vec<f32>> {
    let defaults: Vec<f32> = block.params.iter().map(|param| param.kind.default()).collect();
    let end = |high: bool| -> Vec<f32> {
        let pick = |kind: &Kind| if high { kind.range().1 } else { kind.range().0 };
        block.params.iter().map(|param| pick(&param.kind)).collect()
    };
    let mut all = vec![defaults.clone(), end(false), end(true)];
    for (i, param) in block.params.iter().enumerate() {
        let (low, high) = param.kind.range();
        let values = match param.kind {
            Kind::Choice { names } => (0..names.len()).map(|choice| choice as f32).collect(),
            _ => vec![low, high],
        };
        all.extend(values.into_iter().map(|value| {
            let mut values = defaults.clone();
            values[i] = value;
            values
        }));
    }
    all
}

fn run(block: &'static Block, values: &[f32], image: &Image, context: &mut Context<'_>) -> Image {
    let step = Step { block, values: values.to_vec(), bypass: false };
    chain::run_owned(&[step], image.clone(), context).unwrap()
}

fn samples(image: &Image) -> Vec<&[u8]> {
    image.planes().iter().map(Plane::samples).collect()
}

#[test]
fn every_block_bears_every_extreme_at_every_size() {
    for &block in ALL {
        // One context for all: what one size leaves in the scratch memory must not reach the next.
        let mut worn = Context::default();
        for &(width, height) in SIZES {
            for image in inputs(block, width, height) {
                for values in settings(block) {
                    let scales: &[f32] = if (width, height) == (33, 31) { &[0.02, 1.0, 3.0] } else { &[1.0] };
                    for &scale in scales {
                        worn.set_scale(scale);
                        let mut fresh = Context::default();
                        fresh.set_scale(scale);
                        let name = format!("{} {values:?} {width} x {height} at {scale}", block.id);
                        let out = run(block, &values, &image, &mut worn);
                        if block.id != "size" {
                            assert_eq!((out.width(), out.height()), (width, height), "{name}");
                        }
                        let again = run(block, &values, &image, &mut fresh);
                        assert_eq!(samples(&out), samples(&again), "{name}");
                        match block.output {
                            Channels::Luma => assert!(out.is_luma(), "{name}"),
                            Channels::Color => assert!(!out.is_luma(), "{name}"),
                            Channels::Any => {}
                        }
                    }
                }
            }
        }
    }
}

/// A pixel far from both borders is the same in a row of any width: groups of lanes and the rest behind them agree.
#[test]
fn no_pixel_depends_on_the_width_of_its_row() {
    for &block in ALL {
        let values: Vec<f32> = block.params.iter().map(|param| param.kind.default()).collect();
        let full = inputs(block, 67, 3);
        for width in 1..=67 {
            for whole in &full {
                let cut = |plane: &Plane| Plane::from_fn(width, 3, |x, y| plane.at(x, y));
                let planes: Vec<Plane> = whole.planes().iter().map(cut).collect();
                let image = match <[Plane; 3]>::try_from(planes) {
                    Ok(planes) => Image::from_rgb(planes).unwrap(),
                    Err(mut planes) => Image::from_luma(planes.remove(0)),
                };
                let mut context = Context::default();
                context.set_scale(1.0);
                let reach = match block.id {
                    // The percentiles are those of the whole image, and a grid of cells or of pixels depends on its size.
                    "equalize" | "dynamic_range" | "size" => continue,
                    _ => reach(block, &values),
                };
                let out = run(block, &values, &image, &mut context);
                let expected = run(block, &values, whole, &mut context);
                let upto = if reach == 0 { width } else { width.saturating_sub(reach) };
                for (out, expected) in out.planes().iter().zip(expected.planes()) {
                    for y in 0..3 {
                        assert_eq!(out.row(y)[..upto], expected.row(y)[..upto], "{} width {width}", block.id);
                    }
                }
            }
        }
    }
}

/// Pixels that a block looks aside for at its defaults.
fn reach(block: &Block, values: &[f32]) -> usize {
    match block.id {
        "sobel" => 1,
        // Sigmas and iterations, and the coarse grid that they may go through.
        "gaussian" => (4.0 * values[0]) as usize + 6,
        "xdog" => (8.0 * values[0]) as usize + 12,
        "tvf" => 24,
        "etf" => 40,
        "detail" => 60,
        _ => 0,
    }
}
