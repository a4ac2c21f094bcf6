//! Draws photos with faces in styles, without and with face protection, side by side.
//!
//!     cargo run --release --example face_care -- OUT.png WIDTH STYLE,STYLE,... PHOTO...
//!
//! One line per style. For each photo, `WIDTH` pixels wide, it shows the picture without and with face
//! protection.

use std::error::Error;
use std::fs;

use inkpanel_engine::detect::Detectors;
use inkpanel_engine::page::png::encode_rgb;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::style::catalogue::find;
use inkpanel_engine::style::faces::FaceBox;
use inkpanel_engine::style::{Context, stylize};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A photo at the size at which it is drawn, and its faces in pixels.
struct Shown {
    image: Image,
    faces: Vec<FaceBox>,
}

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [out, width, styles, photos @ ..] = arguments.as_slice() else {
        return Err("face_care OUT.png WIDTH STYLE,STYLE,... PHOTO...".into());
    };
    let detectors =
        Detectors::new(&fs::read("www/models/faces.onnx")?, &fs::read("www/models/objects.onnx")?)?;
    let width: usize = width.parse()?;
    let shown = photos.iter().map(|photo| show(&detectors, photo, width)).collect::<Outcome<Vec<_>>>()?;
    let height = shown.iter().map(|shown| shown.image.height()).max().unwrap_or(1);
    let (across, styles) = (2 * shown.len() * width, styles.split(',').collect::<Vec<_>>());
    let mut rgb = vec![255; across * height * styles.len() * 3];
    for (line, style) in styles.iter().enumerate() {
        let style = find(style)?;
        for (i, photo) in shown.iter().enumerate() {
            for (second, faces) in [Vec::new(), photo.faces.clone()].into_iter().enumerate() {
                let mut context = Context::for_image(&photo.image);
                context.show_faces(faces);
                let drawn = stylize(&photo.image, style, &mut context)?;
                paste(&mut rgb, across, ((2 * i + second) * width, line * height), &drawn);
            }
        }
    }
    fs::write(out, encode_rgb(across, height * styles.len(), &rgb, 96)?)?;
    Ok(())
}

fn show(detectors: &Detectors, photo: &str, width: usize) -> Outcome<Shown> {
    let photo = decode_fit(&fs::read(photo)?, &Limits::default(), 1600)?.image;
    let height = photo.height() * width / photo.width();
    let image = resample_image(&photo, Region::whole(photo.width(), photo.height()), width, height);
    let (across, down) = (width as f64, height as f64);
    let faces =
        detectors.detect(&photo)?.into_iter().filter(|found| found.label == "face").map(|found| FaceBox {
            x: found.x * across,
            y: found.y * down,
            width: found.width * across,
            height: found.height * down,
        });
    Ok(Shown { image, faces: faces.collect() })
}

fn paste(rgb: &mut [u8], across: usize, (left, top): (usize, usize), image: &Image) {
    for (y, row) in image.to_rgba().chunks_exact(4 * image.width()).enumerate() {
        for (x, pixel) in row.chunks_exact(4).enumerate() {
            let at = ((top + y) * across + left + x) * 3;
            rgb[at..at + 3].copy_from_slice(&pixel[..3]);
        }
    }
}
