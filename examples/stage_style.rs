//! Stage `style`: a chain of filter blocks, written as a style file writes it, run on a photo.
//!
//!     cargo run --example stage_style -- PHOTO OUT.png

use std::error::Error;

use inkpanel_engine::page::png::encode_rgb;
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::style::{Context, Style, stylize};

/// Flat colours below, ink lines above.
const STYLE: &str = r##"{
    "id": "example", "name": "Example",
    "background": [{ "block": "tvf" }, { "block": "luma_posterize", "levels": 5 }],
    "foreground": [{ "block": "to_gray" }, { "block": "xdog" }, { "block": "soft_threshold" }],
    "ink": "#101014"
}"##;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [photo, out] = arguments.as_slice() else { return Err("usage: stage_style PHOTO OUT.png".into()) };
    let image = decode_fit(&std::fs::read(photo)?, &Limits::default(), 1200)?.image;
    let style = Style::parse("example", STYLE)?;
    // Parameters in pixels are of a 1920 x 1080 image; the context scales them to this one.
    let drawn = stylize(&image, &style, &mut Context::for_image(&image))?;
    std::fs::write(out, encode_rgb(drawn.width(), drawn.height(), &drawn.to_rgb(), 96)?)?;
    Ok(())
}
