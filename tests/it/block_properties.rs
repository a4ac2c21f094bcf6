//! Properties of every block of the registry: sizes, determinism, extreme parameters, and independence of the
//! row width that SIMD kernels process.

use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::blocks::{ALL, Block, Channels};
use inkpanel_engine::style::context::Context;
use inkpanel_engine::style::file::Step;
use inkpanel_engine::style::{chain, params::Kind};

/// Odd and even, thin and square, below, at and above a group of lanes.
const SIZES: &[(usize, usize)] =
    &[(1, 1), (2, 1), (1, 2), (3, 5), (1, 67), (67, 1), (8, 8), (15, 17), (16, 16), (33, 31), (67, 67)];

/// Noise over a ramp: every tone, edges, no symmetry.
fn plane(width: usize, height: usize, seed: u64) -> Plane {
    let mut random = oorandom::Rand32::new(seed);
    Plane::from_fn(width, height, |x, y| ((x * 5 + y * 3) as u32 + random.rand_range(0..60)) as u8)
}

/// Input images of a block: luma, colour, or both if it accepts both.
fn inputs(block: &Block, width: usize, height: usize) -> Vec<Image> {
    let luma = Image::from_luma(plane(width, height, 1));
    let color = Image::from_rgb([2, 3, 4].map(|seed| plane(width, height, seed))).unwrap();
    match block.input {
        Channels::Luma => vec![luma],
        Channels::Color => vec![color],
        Channels::Any => vec![luma, color],
    }
}

/// The defaults, and every parameter at both ends with the others at their defaults or all at one end.
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
    let step = Step { block, values: values.to_vec(), texture: None, model: None, bypass: false, part: None };
    if block.id == "painter" {
        context.show_painters(Some(crate::painters::painters()));
    }
    chain::run_owned(&[step], image.clone(), context).unwrap()
}

fn samples(image: &Image) -> Vec<&[u8]> {
    image.planes().iter().map(Plane::samples).collect()
}

#[test]
fn every_block_bears_every_extreme_at_every_size() {
    for &block in ALL {
        // All sizes share one context: scratch memory of one size must not affect the next.
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

/// A pixel far from both borders does not depend on the width of the row: SIMD groups and the scalar rest
/// agree.
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
                    // Percentiles and the pixels of another size depend on the whole image, and have
                    // reference implementations below. Palettes, the phase of lines and the length of a line
                    // do so too, and have oracles.
                    "equalize" | "dynamic_range" | "size" | "flatten" | "engrave" | "flow_lines"
                    | "painter" => {
                        continue;
                    }
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

/// Percentile of luma by sorting (inverted CDF).
fn percentile(image: &Image, percent: f64) -> f64 {
    let mut luma = inkpanel_engine::simd::point::luma_plane(image).into_samples();
    luma.sort_unstable();
    let rank = (percent / 100.0 * luma.len() as f64).ceil().max(1.0) as usize;
    f64::from(luma[rank - 1])
}

/// A tone with a knee at the end of the range: the hyperbola through (start, start) with slope 1 and through (most, 1).
fn bent(v: f64, most: f64, knee: f64) -> f64 {
    let start = 1.0 - knee;
    let (x, end) = (v - start, most - start);
    if x <= 0.0 || most <= 1.0 { v } else { start + knee * x * end / (knee * end + x * (end - knee)) }
}

/// The percentile blocks follow their formulas without SIMD, at every width.
#[test]
fn tones_are_stretched_as_the_formulas_say_at_every_width() {
    for (id, values) in [
        ("equalize", [5.0, 95.0, 0.0]),
        ("equalize", [20.0, 60.5, 0.0]),
        ("equalize", [20.0, 60.5, 30.0]),
        ("dynamic_range", [128.0, 0.0, 0.0]),
        ("dynamic_range", [250.0, 0.0, 0.0]),
    ] {
        let block = inkpanel_engine::style::blocks::find(id).unwrap();
        for width in 1..=67 {
            for image in inputs(block, width, 3) {
                let stretch: Box<dyn Fn(f64) -> f64> = if id == "equalize" {
                    let [low, high] = [values[0], values[1]].map(|percent| percentile(&image, percent));
                    let bend = move |v: f64, most: f64| bent(v, most, values[2] / 100.0);
                    let part = move |v: f64| (v - low) / (high - low);
                    Box::new(move |v| {
                        let upper = bend(part(v), part(255.0));
                        if high > low { 255.0 * (1.0 - bend(1.0 - upper, 1.0 - part(0.0))) } else { v }
                    })
                } else {
                    let ([low, high], range) =
                        ([5.0, 95.0].map(|percent| percentile(&image, percent)), values[0]);
                    let start = (f64::midpoint(low, high) - range / 2.0).clamp(0.0, 255.0 - range);
                    let flat = high <= low || high - low >= range;
                    Box::new(move |v| if flat { v } else { start + (v - low) * range / (high - low) })
                };
                let mut numbers = values.map(|value| value as f32).to_vec();
                if id == "equalize" {
                    // Tested per channel, because luma is rounded separately.
                    numbers.insert(2, 1.0);
                }
                let out = run(block, &numbers[..block.params.len()], &image, &mut Context::default());
                for (out, before) in out.planes().iter().zip(image.planes()) {
                    for (&out, &before) in out.samples().iter().zip(before.samples()) {
                        let exact = stretch(f64::from(before)).clamp(0.0, 255.0);
                        // Halves may be rounded either way.
                        assert!(
                            (f64::from(out) - exact).abs() < 0.5001,
                            "{id} {values:?} width {width}: {out} {exact}"
                        );
                    }
                }
            }
        }
    }
}

/// A line of samples at another length: the area that each covers, or Catmull-Rom on replicated borders.
fn line(samples: &[f64], count: usize) -> Vec<f64> {
    let step = samples.len() as f64 / count as f64;
    let at = |i: isize| samples[i.clamp(0, samples.len() as isize - 1) as usize];
    let one = |i: usize| {
        let (from, to) = (i as f64 * step, (i + 1) as f64 * step);
        if step >= 1.0 {
            let part = |x: usize| (to.min(x as f64 + 1.0) - from.max(x as f64)).max(0.0);
            return (0..samples.len()).map(|x| part(x) * samples[x]).sum::<f64>() / step;
        }
        let centre = f64::midpoint(from, to) - 0.5;
        let (k, t) = (centre.floor() as isize, centre - centre.floor());
        let [a, b, c, d] = [-1, 0, 1, 2].map(|i| at(k + i));
        b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))
    };
    (0..count).map(one).collect()
}

/// Size against the same without lanes, at every width.
#[test]
fn sizes_are_those_of_plain_sums_at_every_width() {
    let block = inkpanel_engine::style::blocks::find("size").unwrap();
    for percent in [10.0f32, 35.0, 50.0, 75.0, 140.0, 200.0, 300.0] {
        for (width, height) in (1..=67).map(|width| (width, if width % 2 == 0 { 34 } else { 5 })) {
            // Far from black and white, Catmull-Rom is not clipped between the axes.
            let calm = |plane: &Plane| Plane::from_fn(width, height, |x, y| 64 + plane.at(x, y) / 2);
            let image = Image::from_luma(calm(&plane(width, height, width as u64)));
            let out = run(block, &[percent], &image, &mut Context::default());
            let (columns, rows) = (out.width(), out.height());
            let scaled = |side: usize| ((side as f64 * f64::from(percent) / 100.0).round() as usize).max(1);
            assert_eq!((columns, rows), (scaled(width), scaled(height)));
            let across: Vec<Vec<f64>> = (0..height)
                .map(|y| {
                    line(&image.planes()[0].row(y).iter().map(|&v| f64::from(v)).collect::<Vec<_>>(), columns)
                })
                .collect();
            for x in 0..columns {
                let column: Vec<f64> = across.iter().map(|row| row[x]).collect();
                for (y, exact) in line(&column, rows).into_iter().enumerate() {
                    let found = f64::from(out.planes()[0].at(x, y));
                    // Rounded once for each axis.
                    assert!(
                        (found - exact).abs() <= 1.14,
                        "{percent} % of {width} at {x}, {y}: {found} {exact}"
                    );
                }
            }
        }
    }
}

/// Returns the number of neighbouring pixels that a block reads with default parameters.
fn reach(block: &'static Block, values: &[f32]) -> usize {
    match block.id {
        "sobel" => 1,
        // Sigmas and iterations, and the coarse grid that they may use.
        "gaussian" => (4.0 * values[0]) as usize + 6,
        "xdog" => (8.0 * values[0]) as usize + 12,
        "tvf" => 24,
        "etf" => 40,
        "detail" => 60,
        // The reach includes the field of directions, positions on it, and the offset of a plate.
        "kuwahara" | "strokes" | "plates" => 66,
        _ if looks_aside(block, values) => 60,
        _ => 0,
    }
}

/// Whether other pixels change with one.
fn looks_aside(block: &'static Block, values: &[f32]) -> bool {
    let at = (33, 1);
    let image = |other: u8| {
        let plane = |own: u8| {
            Plane::from_fn(67, 3, |x, y| {
                let tone = (x * 7 + y * 31 + usize::from(own)) as u8;
                if (x, y) == at { tone.wrapping_add(other) } else { tone }
            })
        };
        match block.input {
            Channels::Color => Image::from_rgb([0, 50, 100].map(plane)).unwrap(),
            _ => Image::from_luma(plane(0)),
        }
    };
    let drawn = |other| run(block, values, &image(other), &mut Context::default());
    let (one, other) = (drawn(0), drawn(90));
    one.planes()
        .iter()
        .zip(other.planes())
        .any(|(one, other)| (0..3).any(|y| (0..67).any(|x| (x, y) != at && one.at(x, y) != other.at(x, y))))
}
