//! How many altered copies of a photo are found, and how many different photos are taken for copies.
//! `cargo test --test near_duplicates -- --nocapture` prints the table.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

use std::fs;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use inkpanel::raster::decode::{Limits, decode_fit};
use inkpanel::raster::resize::{Region, resample, resample_image};
use inkpanel::raster::{Image, Plane};
use inkpanel::select::fingerprint::{distance, fingerprint};
use inkpanel::select::{Settings, sharpness};
use inkpanel::simd::point::luma_plane;

fn photos() -> Vec<Image> {
    let folders = ["tests/photos", "www/public/samples"]
        .map(|folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder));
    let mut paths: Vec<_> = folders
        .iter()
        .flat_map(|folder| fs::read_dir(folder).unwrap())
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "jpg"));
    paths.sort();
    let photo = |path| decode_fit(&fs::read(path).unwrap(), &Limits::default(), 320).unwrap().image;
    paths.iter().map(photo).collect()
}

fn bits_of(image: &Image) -> u64 {
    fingerprint(&luma_plane(image))
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
    Image::from_rgb(planes).unwrap()
}

fn blurred(image: &Image, part: f64) -> Image {
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
        .unwrap();
    decode_fit(&file, &Limits::default(), usize::MAX).unwrap().image
}

fn with_noise(image: &Image, sigma: f64) -> Image {
    let mut random = oorandom::Rand64::new(7);
    // The sum of twelve uniform numbers is near enough to a normal one of sigma 1 about 6.
    each_sample(image, |v| f64::from(v) + sigma * ((0..12).map(|_| random.rand_float()).sum::<f64>() - 6.0))
}

fn variants(image: &Image) -> Vec<(&'static str, Image)> {
    let whole = Region::whole(image.width(), image.height());
    let half = resample_image(image, whole, image.width() / 2, image.height() / 2);
    let third = resample_image(image, whole, image.width() / 3, image.height() / 3);
    vec![
        ("JPEG at quality 25", as_jpeg(image, 25)),
        ("half the size", half),
        ("a third of the size", third),
        ("darker, x .8", each_sample(image, |v| f64::from(v) * 0.8)),
        ("brighter, x 1.2", each_sample(image, |v| f64::from(v) * 1.2)),
        ("gamma .8", each_sample(image, |v| 255.0 * (f64::from(v) / 255.0).powf(0.8))),
        ("noise, sigma 12", with_noise(image, 12.0)),
        ("blurred to a sixth", blurred(image, 1.0 / 6.0)),
        ("cut by 5 %", cut(image, 0.025, 0.025, 0.95)),
        ("cut by 10 %", cut(image, 0.05, 0.05, 0.9)),
        ("cut by 10 % at a corner", cut(image, 0.0, 0.0, 0.9)),
        ("turned by 1 degree", turned(image, 1.0)),
        ("turned by 3 degrees", turned(image, 3.0)),
    ]
}

#[test]
fn altered_copies_are_found_and_different_photos_are_not() {
    let photos = photos();
    let bits: Vec<u64> = photos.iter().map(bits_of).collect();
    let threshold = Settings::default().threshold;

    let mut table: Vec<(&str, usize, u32)> = Vec::new();
    for (photo, &original) in photos.iter().zip(&bits) {
        for (i, (name, variant)) in variants(photo).into_iter().enumerate() {
            let distance = distance(original, bits_of(&variant));
            if table.len() == i {
                table.push((name, 0, 0));
            }
            table[i].1 += usize::from(distance <= threshold);
            table[i].2 = table[i].2.max(distance);
        }
    }
    // A corner cut off moves everything by a twentieth: beyond what the fingerprint is for, but good to know.
    let meant = || table.iter().filter(|row| !row.0.contains("corner"));
    let found: usize = meant().map(|row| row.1).sum();
    let recall = found as f64 / (meant().count() * photos.len()) as f64;
    println!("| altered copy of {} photos | found | farthest |\n|---|---|---|", photos.len());
    for (name, found, farthest) in &table {
        println!("| {name} | {:.1} % | {farthest} |", 100.0 * *found as f64 / photos.len() as f64);
    }
    println!("| all but the corner | {:.1} % | |", 100.0 * recall);

    let pairs: Vec<u32> = (0..bits.len())
        .flat_map(|i| (0..i).map(move |j| (i, j)))
        .map(|(i, j)| distance(bits[i], bits[j]))
        .collect();
    let near = |threshold: u32| pairs.iter().filter(|&&distance| distance <= threshold).count();
    println!(
        "different pairs within 10, 12, 16: {}, {}, {} of {}; nearest {}",
        near(10),
        near(12),
        near(16),
        pairs.len(),
        pairs.iter().min().unwrap()
    );
    assert!(recall >= 0.97, "{recall}");
    assert_eq!(near(threshold), 0);
}

#[test]
fn the_sharpest_of_a_group_is_the_one_that_was_not_blurred() {
    let mut right = 0;
    let photos = photos();
    for photo in &photos {
        let gradient = |image: &Image| sharpness::gradient(&luma_plane(image));
        let copies = [photo.clone(), blurred(photo, 0.6), blurred(photo, 0.3), blurred(photo, 0.15)]
            .map(|copy| gradient(&copy));
        right += usize::from(copies.is_sorted_by(|a, b| a > b));
        let small = resample(
            &photo.planes()[1],
            Region::whole(photo.width(), photo.height()),
            photo.width() / 2,
            photo.height() / 2,
        );
        assert!(sharpness::gradient(&small) < sharpness::gradient(&photo.planes()[1]));
    }
    assert_eq!(right, photos.len());
}
