//! A contact sheet of all filter blocks on a few photos, with their ids.
//!
//!     cargo run --release --example block_sheet -- OUT.jpg CELL_WIDTH PHOTOS...
//!
//! Cells are small, so spatial parameters are scaled up: by sqrt(w h / (1920 * 1080)) they would vanish.

#[path = "sheets/file.rs"]
mod file;
#[path = "sheets/font.rs"]
mod font;
#[path = "sheets/picture.rs"]
mod picture;

use std::error::Error;
use std::path::Path;

use file::save;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::style::{Context, Style, blocks, chain};
use picture::paste;
use serde_json::{Value, json};
use tiny_skia::{Color, Pixmap};

/// Blocks side by side.
const COLUMNS: usize = 2;

/// Height of a line with an id, and space between blocks.
const LINE: u32 = 20;

/// Quality of the JPEG file.
const QUALITY: u8 = 80;

/// Pixels of a cell for a pixel of a parameter.
const SCALE: f32 = 0.4;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [out, width, photos @ ..] = arguments.as_slice() else {
        return Err("usage: block_sheet OUT.jpg CELL_WIDTH PHOTOS...".into());
    };
    let width: u32 = width.parse()?;
    let height = width * 3 / 4;
    let photos: Vec<Image> = photos.iter().map(|path| cell(path, width, height)).collect::<Result<_, _>>()?;
    let strip = width * photos.len() as u32 + LINE;
    let rows = blocks::ALL.len().div_ceil(COLUMNS) as u32;
    let mut sheet =
        Pixmap::new(strip * COLUMNS as u32 + LINE, rows * (height + LINE) + LINE).ok_or("too large")?;
    sheet.fill(Color::WHITE);
    for (i, block) in blocks::ALL.iter().enumerate() {
        let left = LINE + (i % COLUMNS) as u32 * strip;
        let top = (i / COLUMNS) as u32 * (height + LINE);
        font::write(&mut sheet, &block.id.replace('_', "-"), left, top + LINE / 2 - 4);
        for (column, photo) in photos.iter().enumerate() {
            let steps = json!({ "background": steps(block.id) }).to_string();
            let mut context = Context::default();
            context.set_scale(SCALE);
            let drawn = chain::run(&Style::parse(block.id, &steps)?.background, photo, &mut context)?;
            paste(&mut sheet, &drawn, left + column as u32 * width, top + LINE);
        }
    }
    save(&sheet, Path::new(out), QUALITY)
}

/// Returns the block with parameters that show its effect, after the blocks that it needs.
fn steps(block: &str) -> Vec<Value> {
    let gray = json!({"block": "to_gray"});
    match block {
        "to_color" => vec![gray, json!({"block": "posterize", "levels": 3}), json!({"block": block})],
        "pattern" | "colorize" => vec![gray, json!({"block": block})],
        "posterize" | "luma_posterize" => vec![json!({"block": block, "levels": 4})],
        "brightness" => vec![json!({"block": block, "gain": 1.6})],
        "saturation" => vec![json!({"block": block, "amount": 2.2})],
        "hue" => vec![json!({"block": block, "angle": 120})],
        "gaussian" => vec![json!({"block": block, "sigma": 6})],
        "etf" => vec![json!({"block": block, "sigma": 8})],
        "tvf" => vec![json!({"block": block, "time": 60})],
        "detail" => vec![json!({"block": block, "delta": 150})],
        "sobel" => vec![json!({"block": block, "gain": 2})],
        "xdog" => vec![json!({"block": block, "sigma": 2.5})],
        "size" => vec![json!({"block": block, "percent": 15})],
        "halftone" => vec![json!({"block": block, "pitch": 10})],
        "dynamic_range" => vec![json!({"block": block, "range": 255})],
        _ => vec![json!({"block": block})],
    }
}

/// The middle of a photo in the shape of a cell.
fn cell(path: &str, width: u32, height: u32) -> Result<Image, Box<dyn Error>> {
    let photo = decode(&std::fs::read(path)?, &Limits::default())?.image;
    let (w, h) = (photo.width() as f64, photo.height() as f64);
    let scale = (w / f64::from(width)).min(h / f64::from(height));
    let (across, down) = (f64::from(width) * scale, f64::from(height) * scale);
    let region = Region { x: (w - across) / 2.0, y: (h - down) / 2.0, width: across, height: down };
    Ok(resample_image(&photo, region, width as usize, height as usize))
}
