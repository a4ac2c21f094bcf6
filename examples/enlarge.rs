//! A photo enlarged well, for `tests/oracles/enlarge.py`: `enlarge PHOTO WIDTH HEIGHT OUT.png`.

use inkpanel_engine::page::png;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::enlarge::enlarged;
use inkpanel_engine::raster::resize::Region;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [photo, width, height, out] = &arguments[..] else {
        return Err("enlarge PHOTO WIDTH HEIGHT OUT.png".into());
    };
    let photo = decode(&std::fs::read(photo)?, &Limits::default())?.image;
    let whole = Region::whole(photo.width(), photo.height());
    let large = enlarged(&photo, whole, width.parse()?, height.parse()?);
    std::fs::write(out, png::encode_rgb(large.width(), large.height(), &large.to_rgb(), 96)?)?;
    Ok(())
}
