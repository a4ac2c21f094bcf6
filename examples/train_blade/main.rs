//! Fits a bank of filters to an image operator, measures it on photos that were not used for fitting, and
//! writes it to `crates/style/src/banks/`. `cargo xtask train OPERATOR` runs it. See
//! `crates/style/src/banks/README.md`.
//!
//!     cargo run --release --example train_blade -- OPERATOR BANK.blade HELD_OUT_FOLDER PHOTO_FOLDER...

mod etf;
mod fit;
mod photos;

use std::error::Error;
use std::path::Path;

use inkpanel_engine::raster::Image;
use inkpanel_engine::style::blade::bank::{Bank, Shape};
use inkpanel_engine::style::context::scale_of;
use inkpanel_engine::style::{Context, blade};
use photos::{Photo, read_folder};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// The operator that a bank approximates.
struct Operator {
    name: &'static str,
    /// Strengths with separate filters.
    levels: &'static [f32],
    /// Limits of strength and coherence.
    shape: (&'static [f32], &'static [f32]),
    /// Strengths to measure, in pixels of a 1920 x 1080 image.
    measured: &'static [f32],
    /// The exact result for a luma plane at each strength, at every pixel whose x + y divides by the last number.
    exact: fn(&Photo, &[f32], usize) -> Vec<Vec<f32>>,
}

const OPERATORS: &[Operator] = &[Operator {
    name: "etf",
    levels: &[0.5, 1.0, 2.0, 4.0],
    shape: (&[3.0, 10.0], &[0.2, 0.4, 0.6, 0.8]),
    measured: &[1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0],
    exact: etf::smooth,
}];

/// One pixel in this many is used for fitting, because neighbours are similar.
const EVERY: usize = 3;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, out, held_out, folders @ ..] = arguments.as_slice() else {
        return Err("usage: train_blade OPERATOR BANK.blade HELD_OUT_FOLDER PHOTO_FOLDER...".into());
    };
    let Some(operator) = OPERATORS.iter().find(|operator| operator.name == name) else {
        let known: Vec<_> = OPERATORS.iter().map(|operator| operator.name).collect();
        return Err(format!("there is no operator {name}; there are: {}", known.join(", ")).into());
    };
    let mut photos = Vec::new();
    for folder in folders {
        photos.extend(read_folder(Path::new(folder))?);
    }
    let held_out = read_folder(Path::new(held_out))?;
    if photos.is_empty() || held_out.is_empty() {
        return Err("there are no photos to fit to, or none to measure with".into());
    }
    let bank = train(operator, &photos)?;
    std::fs::write(out, bank.to_bytes())?;
    println!("{out}: {} bytes, fitted to {} photos", bank.to_bytes().len(), photos.len());
    measure(operator, &bank, &held_out)
}

fn train(operator: &Operator, photos: &[Photo]) -> Outcome<Bank> {
    let shape = Shape { strengths: operator.shape.0.to_vec(), coherences: operator.shape.1.to_vec() };
    let mut sums = fit::Sums::new(shape.buckets(), operator.levels.len());
    for photo in photos {
        let exact = (operator.exact)(photo, operator.levels, EVERY);
        sums.add(photo, &photo.places(&shape), &exact, EVERY);
        eprintln!("{}: seen", photo.name);
    }
    let filters = sums.solve();
    Ok(Bank::new(operator.name, shape, operator.levels.iter().copied().zip(filters).collect())?)
}

/// Prints the mean PSNR over the photos at each strength, for the bank and without any filter. Strengths are
/// scaled to the size of the photo, as in a render.
fn measure(operator: &Operator, bank: &Bank, photos: &[Photo]) -> Outcome<()> {
    let mut rows = vec![(0.0, 0.0, f64::MAX); operator.measured.len()];
    for photo in photos {
        let scale = scale_of((photo.luma.width() * photo.luma.height()) as f64);
        let strengths: Vec<f32> = operator.measured.iter().map(|strength| strength * scale).collect();
        let exact = (operator.exact)(photo, &strengths, 1);
        for ((row, exact), &strength) in rows.iter_mut().zip(&exact).zip(&strengths) {
            let image = Image::from_luma(photo.luma.clone());
            let drawn = blade::run(bank, strength, image, &mut Context::default())?;
            let decibels = psnr(drawn.planes()[0].samples(), exact);
            row.0 += psnr(photo.luma.samples(), exact) / photos.len() as f64;
            row.1 += decibels / photos.len() as f64;
            row.2 = row.2.min(decibels);
        }
    }
    println!("| strength | unfiltered, dB | bank, dB | worst photo, dB |\n|--:|--:|--:|--:|");
    for ((before, after, worst), strength) in rows.iter().zip(operator.measured) {
        println!("| {strength} | {before:.1} | {after:.1} | {worst:.1} |");
    }
    Ok(())
}

/// Peak signal to noise ratio in decibels, against values that were not rounded.
fn psnr(samples: &[u8], exact: &[f32]) -> f64 {
    let square = |(&a, &b): (&u8, &f32)| (f64::from(a) - f64::from(b)).powi(2);
    let mean = samples.iter().zip(exact).map(square).sum::<f64>() / samples.len() as f64;
    10.0 * (255.0f64.powi(2) / mean.max(1e-9)).log10()
}
