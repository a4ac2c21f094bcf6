//! Compares subject masks of photos with manually marked subjects, in a table and on a sheet to look at.
//!
//!     cargo run --release --example subjects -- SHEET.jpg
//!
//! The sheet starts with the worst photo. The background of the mask is dark, the border of the mask is red,
//! and the marked border is green.

#[path = "../sheets/font.rs"]
mod font;
mod measure;

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::{Rgb, RgbImage, imageops};
use inkpanel_engine::detect::Segmenter;
use measure::{HELD_OUT, Measured, TUNED, border, measure};
use tiny_skia::Pixmap;

const COLUMNS: u32 = 4;
/// Width and height of the cell for a picture, and height of the label above it, in pixels.
const ROOM: (u32, u32) = (460, 345);
const LABEL: u32 = 16;
const QUALITY: u8 = 80;
const PAPER: Rgb<u8> = Rgb([232, 232, 228]);
const MASKED: Rgb<u8> = Rgb([255, 40, 40]);
const MARKED: Rgb<u8> = Rgb([60, 255, 60]);

fn main() -> Result<(), Box<dyn Error>> {
    let sheet = std::env::args().nth(1).ok_or("usage: subjects SHEET.jpg")?;
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/models/subject.onnx");
    let net = Segmenter::new(&std::fs::read(model)?)?;
    println!(
        "| photo | overlap | border within 2 px | within 6 px | sure | covers |\n|---|--:|--:|--:|--:|--:|"
    );
    let mut pictures = Vec::new();
    for (half, names) in [("tuned on", &TUNED[..]), ("held out", &HELD_OUT[..])] {
        let mut sums = [0.0; 3];
        for name in names {
            let found = measure(&net, name)?;
            let [overlap, near, nearer] = [found.overlap, found.near[0], found.near[1]];
            let Measured { sure, covers, .. } = found;
            println!("| {name} | {overlap:.3} | {near:.2} | {nearer:.2} | {sure:.2} | {covers:.2} |");
            sums.iter_mut()
                .zip([overlap, near, nearer])
                .for_each(|(sum, value)| *sum += value / names.len() as f64);
            pictures.push((overlap, *name, laid_over(&found)));
        }
        let [overlap, near, nearer] = sums;
        println!("| **{half}, {}** | **{overlap:.3}** | **{near:.2}** | **{nearer:.2}** | | |", names.len());
    }
    pictures.sort_by(|a, b| a.0.total_cmp(&b.0));
    draw(&pictures, Path::new(&sheet))
}

/// The photo, small, with its mask and its mark.
fn laid_over(found: &Measured) -> RgbImage {
    let width = found.picture.width();
    let dark = |i: usize, sample: u8| if found.mask[i] { sample } else { sample / 3 };
    let planes = found.picture.planes();
    let picture = RgbImage::from_fn(width as u32, (found.mask.len() / width) as u32, |x, y| {
        let i = y as usize * width + x as usize;
        Rgb([0, 1, 2].map(|c: usize| dark(i, planes[c.min(planes.len() - 1)].samples()[i])))
    });
    let scale = (f64::from(ROOM.0) / width as f64).min(f64::from(ROOM.1) / f64::from(picture.height()));
    let side = |length: u32| (f64::from(length) * scale).round().max(1.0) as u32;
    let mut small = imageops::resize(
        &picture,
        side(picture.width()),
        side(picture.height()),
        imageops::FilterType::Triangle,
    );
    for (within, color) in [(&found.mark, MARKED), (&found.mask, MASKED)] {
        for (i, _) in border(within, width).iter().enumerate().filter(|(_, is)| **is) {
            let at = |length: usize, most: u32| ((length as f64 * scale) as u32).min(most - 1);
            let (x, y) = (at(i % width, small.width()), at(i / width, small.height()));
            small.put_pixel(x, y, color);
        }
    }
    small
}

fn draw(pictures: &[(f64, &str, RgbImage)], out: &Path) -> Result<(), Box<dyn Error>> {
    let step = (ROOM.0 + 6, ROOM.1 + LABEL);
    let down = (pictures.len() as u32).div_ceil(COLUMNS);
    let mut sheet = RgbImage::from_pixel(step.0 * COLUMNS, step.1 * down, PAPER);
    for (i, (overlap, name, picture)) in (0u32..).zip(pictures) {
        let (left, top) = (step.0 * (i % COLUMNS), step.1 * (i / COLUMNS));
        let mut label = Pixmap::new(step.0, LABEL).ok_or("no room for a label")?;
        font::write(&mut label, &format!("{name} {:.0}", overlap * 1000.0), 2, 2);
        for pixel in 0..step.0 * LABEL {
            let (x, y) = (pixel % step.0, pixel / step.0);
            if label.pixel(x, y).is_some_and(|drawn| drawn.alpha() > 0) {
                sheet.put_pixel(left + x, top + y, Rgb([0, 0, 0]));
            }
        }
        imageops::replace(&mut sheet, picture, left.into(), (top + LABEL).into());
    }
    let mut file = BufWriter::new(File::create(out)?);
    Ok(JpegEncoder::new_with_quality(&mut file, QUALITY).encode_image(&sheet)?)
}
