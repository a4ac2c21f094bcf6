//! Counts detected altered copies of a photo, and different photos that count as copies. `cargo test --test
//! near_duplicates -- --nocapture` prints the table.

#[path = "../../examples/duplicate_table/variants.rs"]
mod variants;

use std::fs;

use inkpanel::raster::Image;
use inkpanel::raster::decode::{Limits, decode_fit};
use inkpanel::raster::resize::{Region, resample};
use inkpanel::select::fingerprint::{distance, fingerprint};
use inkpanel::select::{Settings, sharpness};
use inkpanel::simd::point::luma_plane;
use variants::{blurred, variants};

fn photos() -> Vec<Image> {
    let folders = ["tests/photos", "www/public/samples"].map(crate::root);
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
    // Cropping a corner moves everything by a twentieth. The fingerprint is not made for that, but the result
    // is reported.
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
