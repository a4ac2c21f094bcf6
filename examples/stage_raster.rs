//! Stage `raster`: a file decoded within limits, reduced, and written as PNG.
//!
//!     cargo run --example stage_raster -- PHOTO OUT.png

use std::error::Error;

use inkpanel_engine::page::png::encode_rgb;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, fit, resample_image};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [photo, out] = arguments.as_slice() else { return Err("usage: stage_raster PHOTO OUT.png".into()) };
    let decoded = decode(&std::fs::read(photo)?, &Limits::default())?;
    let image = decoded.image;
    println!("{}, {} x {} pixels, taken {:?}", decoded.format, image.width(), image.height(), decoded.taken);
    let (width, height) = fit(image.width(), image.height(), 400);
    let small = resample_image(&image, Region::whole(image.width(), image.height()), width, height);
    std::fs::write(out, encode_rgb(width, height, &small.to_rgb(), 96)?)?;
    Ok(())
}
