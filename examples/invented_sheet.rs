//! Makes a contact sheet of generated styles, each on three photos, and counts the unusable ones.
//!
//!     cargo run --release --no-default-features --example invented_sheet -- -o target/invented.png
//!
//! `--from 100 --count 60` chooses the seeds. Faults are named below the pictures of a style.

#[path = "sheets/file.rs"]
mod file;
#[path = "sheets/font.rs"]
mod font;
#[path = "sheets/picture.rs"]
mod picture;

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;

use file::save;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::style::{Context, aesthetic, procedural, stylize};
use picture::paste;
use tiny_skia::{Color, Pixmap};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A face, a bright building, a dark animal.
const PHOTOS: [&str; 3] = [
    "www/public/samples/09-mariachi.jpg",
    "www/public/samples/16-gate.jpg",
    "www/public/samples/07-red-panda.jpg",
];

/// Width and height of a picture: a thumbnail of the explorer.
const CELL: (usize, usize) = (160, 120);
/// Height of a line with a seed.
const LINE: u32 = 16;
/// Styles side by side.
const ACROSS: u32 = 4;

fn main() -> Outcome<()> {
    let (mut out, mut from, mut count) = ("target/invented.png".to_owned(), 0_u32, 60_u32);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let value = words.next().ok_or_else(|| format!("{word} needs a value"))?;
        match word.as_str() {
            "-o" => out = value,
            "--from" => from = value.parse()?,
            "--count" => count = value.parse()?,
            _ => return Err(format!("{word} is unknown").into()),
        }
    }
    let photos: Vec<Image> = PHOTOS.iter().map(|path| photo(path)).collect::<Outcome<_>>()?;
    let (width, height) = (CELL.0 as u32, CELL.1 as u32);
    let strip = photos.len() as u32 * width + 8;
    let mut sheet =
        Pixmap::new(ACROSS * strip, (height + LINE) * count.div_ceil(ACROSS)).ok_or("an empty sheet")?;
    sheet.fill(Color::WHITE);
    let mut faults: BTreeMap<&str, u32> = BTreeMap::new();
    for i in 0..count {
        let style = procedural::invent(from + i);
        let (left, top) = (i % ACROSS * strip, i / ACROSS * (height + LINE));
        for (photo, at) in photos.iter().zip(0..) {
            let drawn = stylize(photo, &style, &mut Context::for_image(photo))?;
            let note = aesthetic::judge(photo, &drawn).fault.map_or("", aesthetic::Fault::id);
            if !note.is_empty() {
                *faults.entry(note).or_default() += 1;
            }
            paste(&mut sheet, &drawn, left + at * width, top + LINE);
            font::write(&mut sheet, note, left + at * width + 60, top + 3);
        }
        font::write(&mut sheet, &(from + i).to_string(), left + 4, top + 3);
    }
    let all = count * photos.len() as u32;
    let wrong: u32 = faults.values().sum();
    println!("{wrong} of {all} pictures ({:.1} %) {faults:?}", f64::from(wrong) / f64::from(all) * 100.0);
    save(&sheet, Path::new(&out), 80)
}

/// The middle of a photo in the shape of a cell.
fn photo(path: &str) -> Outcome<Image> {
    let photo = decode(&fs::read(path)?, &Limits::default())?.image;
    let (w, h) = (photo.width() as f64, photo.height() as f64);
    let scale = (w / CELL.0 as f64).min(h / CELL.1 as f64);
    let (across, down) = (CELL.0 as f64 * scale, CELL.1 as f64 * scale);
    let region = Region { x: (w - across) / 2.0, y: (h - down) / 2.0, width: across, height: down };
    Ok(resample_image(&photo, region, CELL.0, CELL.1))
}
