//! Stage `detect`: faces and objects in a photo. `cargo xtask models` makes the models.
//!
//!     cargo run --example stage_detect -- www/models PHOTO

use std::error::Error;
use std::fs::read;
use std::path::Path;

use inkpanel_engine::detect::Detectors;
use inkpanel_engine::raster::decode::{Limits, decode_fit};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [models, photo] = arguments.as_slice() else { return Err("usage: stage_detect MODELS PHOTO".into()) };
    let models = Path::new(models);
    let detectors = Detectors::new(&read(models.join("faces.onnx"))?, &read(models.join("objects.onnx"))?)?;
    let image = decode_fit(&read(photo)?, &Limits::default(), 1600)?.image;
    for found in detectors.detect(&image)? {
        // Places are fractions of the photo, so that they hold for the original as well.
        let [x, y, width, height] =
            [found.x, found.y, found.width, found.height].map(|part| (100.0 * part).round());
        println!("{} ({:.2}): {width} x {height} % at {x}, {y}", found.label, found.score);
    }
    Ok(())
}
