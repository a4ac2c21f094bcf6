//! Altered copies of a photo, as albums have them: saved again, resized, cut, brightened, noisy, blurred, turned.

#![allow(
    clippy::expect_used,
    reason = "a program for tables may stop at the first thing that is not as expected"
)]

use image::codecs::jpeg::JpegEncoder;
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Plane};

/// The copies, each with its name. The corner is cut off for knowledge's sake: it moves everything by a twentieth.
pub(crate) fn variants(image: &Image) -> Vec<(&'static str, Image)> {
    let whole = Region::whole(image.width(), image.height());
    let half = resample_image(image, whole, image.width() / 2, image.height() / 2);
    let third = resample_image(image, whole, image.width() / 3, image.height() / 3);
    vec![
        ("JPEG at quality 25", as_jpeg(image, 25)),
        ("half the size", half),
        ("1/3 of the size", third),
        ("darker, x 0.8", each_sample(image, |v| f64::from(v) * 0.8)),
        ("brighter, x 1.2", each_sample(image, |v| f64::from(v) * 1.2)),
        ("gamma 0.8", each_sample(image, |v| 255.0 * (f64::from(v) / 255.0).powf(0.8))),
        ("noise, sigma 12", with_noise(image, 12.0)),
        ("blurred to 1/6", blurred(image, 1.0 / 6.0)),
        ("cropped by 5 %", cut(image, 0.025, 0.025, 0.95)),
        ("cropped by 10 %", cut(image, 0.05, 0.05, 0.9)),
        ("cropped by 10 % at a corner", cut(image, 0.0, 0.0, 0.9)),
        ("rotated by 1 degree", turned(image, 1.0)),
        ("rotated by 3 degrees", turned(image, 3.0)),
    ]
}

fn each_sample(image: &Image, mut change: impl FnMut(u8) -> f64) -> Image {
    let mut image = image.clone();
    for plane in image.planes_mut() {
        for sample in plane.samples_mut() {
            *sample = change(*sample).round().clamp(0.0, 255.0) as u8;
        }
    }
    image
}

fn cut(image: &Image, left: f64, top: f64, part: f64) -> Image {
    let (w, h) = (image.width() as f64, image.height() as f64);
    let region = Region { x: left * w, y: top * h, width: part * w, height: part * h };
    resample_image(image, region, (part * w) as usize, (part * h) as usize)
}

/// Turned about the middle and enlarged until no corner is empty.
fn turned(image: &Image, degrees: f64) -> Image {
    let (w, h) = (image.width() as f64, image.height() as f64);
    let (sin, cos) = degrees.to_radians().sin_cos();
    let scale = cos + sin.abs() * (w / h).max(h / w);
    let planes = [0, 1, 2].map(|i| {
        let plane = &image.planes()[i];
        Plane::from_fn(plane.width(), plane.height(), |x, y| {
            let (u, v) = ((x as f64 - w / 2.0) / scale, (y as f64 - h / 2.0) / scale);
            let (x, y) = (w / 2.0 + u * cos - v * sin, h / 2.0 + u * sin + v * cos);
            plane.at(x.clamp(0.0, w - 1.0) as usize, y.clamp(0.0, h - 1.0) as usize)
        })
    });
    Image::from_rgb(planes).expect("the planes are of one size")
}

/// Reduced to a part of its size and enlarged again.
pub(crate) fn blurred(image: &Image, part: f64) -> Image {
    let whole = Region::whole(image.width(), image.height());
    let size = |side: usize| ((side as f64 * part) as usize).max(1);
    let small = resample_image(image, whole, size(image.width()), size(image.height()));
    resample_image(&small, Region::whole(small.width(), small.height()), image.width(), image.height())
}

fn as_jpeg(image: &Image, quality: u8) -> Image {
    let rgb = image.to_rgb();
    let mut file = Vec::new();
    let mut encoder = JpegEncoder::new_with_quality(&mut file, quality);
    encoder
        .encode(&rgb, image.width() as u32, image.height() as u32, image::ExtendedColorType::Rgb8)
        .expect("writing to memory cannot fail");
    decode_fit(&file, &Limits::default(), usize::MAX).expect("the file is whole").image
}

fn with_noise(image: &Image, sigma: f64) -> Image {
    let mut random = oorandom::Rand64::new(7);
    // The sum of twelve uniform numbers is near enough to a normal one of sigma 1 about 6.
    each_sample(image, |v| f64::from(v) + sigma * ((0..12).map(|_| random.rand_float()).sum::<f64>() - 6.0))
}
