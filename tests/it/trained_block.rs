//! A block of a trained operator consists of a data file and a descriptor. The chain runs this one without
//! other code.

use std::fs;
use std::sync::LazyLock;

use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::blade::Trained;
use inkpanel_engine::style::blade::bank::{Bank, Shape, WEIGHTS};
use inkpanel_engine::style::blocks::{Block, Channels, Kernel};
use inkpanel_engine::style::file::Step;
use inkpanel_engine::style::params::{Unit, number};
use inkpanel_engine::style::{Context, chain};

static BLOCK: Block = Block {
    id: "mean",
    label: "Mean",
    help: "The mean of 3 x 3 pixels.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number("radius", "Radius", "Of the mean.", (1.0, 0.1, 4.0, 0.1), Unit::Pixels)],
    kernel: Kernel::Image(|args, image, context| BANK.run(args.pixels(0), image, context)),
    ..Block::PLAIN
};

/// The bytes of a file, like `include_bytes!`.
static BANK: LazyLock<Trained> = LazyLock::new(|| Trained::new("mean", mean_of_nine().leak()));

/// Weights of 1/9 on the four neighbours before the centre: 910 of 8192.
fn mean_of_nine() -> Vec<u8> {
    let mut weights = [0; WEIGHTS];
    for i in [16, 17, 18, 23] {
        weights[i] = 910;
    }
    let shape = Shape { strengths: vec![8.0], coherences: vec![] };
    let filters = vec![weights; shape.buckets()];
    Bank::new("mean", shape, vec![(1.0, filters)]).unwrap().to_bytes()
}

fn noise(width: usize, height: usize, seed: u64) -> Plane {
    let mut random = oorandom::Rand32::new(seed);
    Plane::from_fn(width, height, |_, _| random.rand_u32() as u8)
}

fn run(radius: f32, image: Image) -> Image {
    let mut context = Context::default();
    context.set_scale(1.0);
    let step =
        Step { block: &BLOCK, values: vec![radius], texture: None, model: None, bypass: false, part: None };
    chain::run_owned(&[step], image, &mut context).unwrap()
}

fn naive(plane: &Plane, x: usize, y: usize, times: usize) -> f64 {
    let side =
        |at: usize, by: isize, length: usize| (at as isize + by).clamp(0, length as isize - 1) as usize;
    let neighbours = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)));
    let sum: f64 = neighbours
        .map(|(dx, dy)| {
            let (x, y) = (side(x, dx, plane.width()), side(y, dy, plane.height()));
            if times > 1 { naive(plane, x, y, times - 1) } else { f64::from(plane.at(x, y)) }
        })
        .sum();
    sum / 9.0
}

#[test]
fn a_new_operator_needs_a_data_file_and_a_descriptor() {
    for (width, height) in [(1, 1), (2, 1), (1, 5), (33, 18), (64, 67)] {
        let planes = [1, 2, 3].map(|seed| noise(width, height, seed));
        for image in [Image::from_luma(planes[0].clone()), Image::from_rgb(planes.clone()).unwrap()] {
            // Strength 1 is one pass, twice the square of it two.
            for (radius, passes, tolerance) in [(1.0, 1, 1.0), (2f32.sqrt(), 2, 1.6)] {
                let out = run(radius, image.clone());
                for (before, after) in image.planes().iter().zip(out.planes()) {
                    for (i, &sample) in after.samples().iter().enumerate() {
                        let exact = naive(before, i % width, i / width, passes);
                        assert!((f64::from(sample) - exact).abs() < tolerance, "{sample} {exact} at {i}");
                    }
                }
            }
        }
    }
}

#[test]
fn strengths_beyond_the_most_passes_run_smaller() {
    let image = Image::from_luma(noise(90, 61, 4));
    let out = run(4.0, image);
    assert_eq!((out.width(), out.height()), (90, 61));
    let mean = out.planes()[0].samples().iter().map(|&v| f64::from(v)).sum::<f64>() / (90.0 * 61.0);
    assert!((mean - 127.5).abs() < 4.0, "{mean}");
}

#[test]
fn every_bank_can_be_read() {
    let folder = crate::root("crates/style/src/banks");
    let mut banks = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "blade") {
            let name = path.file_stem().unwrap().to_str().unwrap();
            let bank = Bank::parse(name, &fs::read(&path).unwrap()).unwrap();
            assert!(bank.strongest() > 0.0);
            banks += 1;
        }
    }
    assert!(banks > 0);
}
