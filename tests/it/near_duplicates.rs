//! Counts detected altered copies of a photo, and different photos that count as copies. `cargo test --test
//! near_duplicates -- --nocapture` prints the table.

#[path = "../../examples/duplicate_table/variants.rs"]
mod variants;

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use inkpanel::{Album, PageOptions, Photo};
use inkpanel_engine::document::planning::Planning;
use inkpanel_engine::document::project::Project;
use inkpanel_engine::framing::{Expression, FACE, PhotoMeta, Subject};
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::{catalogue, jpeg};
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::raster::resize::{Region, resample};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::select::fingerprint::{distance, fingerprint};
use inkpanel_engine::select::{DUPLICATE_THRESHOLD, sharpness};
use inkpanel_engine::simd::point::luma_plane;
use serde_json::{Value, json};
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
    let threshold = DUPLICATE_THRESHOLD;

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

/// Writes a photo, a near-duplicate and a gradient to a folder. Returns the files, and the distance of the first two.
fn near_album(folder: &Path) -> ([PathBuf; 3], u32) {
    let photos = photos();
    let photo = &photos[0];
    let (width, height) = (photo.width(), photo.height());
    let ramp = Plane::from_fn(width, height, |x, _| (x * 255 / width) as u8);
    let gradient = Image::from_rgb([ramp.clone(), ramp.clone(), ramp]).unwrap();
    let far = |copy: &Image| distance(bits_of(photo), bits_of(copy));
    let copies = variants(photo).into_iter().map(|(_, copy)| copy);
    let copy = copies.filter(|copy| (3..=DUPLICATE_THRESHOLD).contains(&far(copy))).max_by_key(far).unwrap();
    let files = [("a.jpg", photo), ("b.jpg", &copy), ("c.jpg", &gradient)].map(|(name, image)| {
        let file = jpeg::encode_rgb(image.width(), image.height(), &image.to_rgb(), 96, 95).unwrap();
        fs::write(folder.join(name), file).unwrap();
        folder.join(name)
    });
    let limits = Limits::default();
    let bits = |file: &PathBuf| bits_of(&decode_fit(&fs::read(file).unwrap(), &limits, 320).unwrap().image);
    let bits = distance(bits(&files[0]), bits(&files[1]));
    (files, bits)
}

#[test]
fn the_planner_of_the_command_line_follows_the_threshold() {
    let folder = tempfile::tempdir().unwrap();
    let (files, bits) = near_album(folder.path());
    let alike = |options: &[&str]| {
        let mut command = crate::inkpanel();
        command.args(["render", "--json", "--no-detect", "--keep-all", "--panels", "2"]).args(options);
        let output = command.args(&files[..2]).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let plan: Value = serde_json::from_slice(&output.stdout).unwrap();
        plan["pages"][0]["terms"]["alike"].as_f64().unwrap()
    };
    let (strict, loose) = ((bits - 2).to_string(), (bits + 2).to_string());
    assert!(alike(&[]) < 0.0, "near-duplicates by default: {bits} bits");
    for option in ["--duplicate-threshold", "--alike"] {
        assert!(alike(&[option, &strict]) == 0.0 && alike(&[option, &loose]) < 0.0, "{option}");
    }
    let kept = |option: &str, bits: &str| {
        let mut command = crate::inkpanel();
        let output = command.args(["select", "--json", option, bits]).args(&files[..2]).output().unwrap();
        let rows: Value = serde_json::from_slice(&output.stdout).unwrap();
        rows.as_array().unwrap().iter().filter(|row| row["kept"] == true).count()
    };
    for option in ["--duplicate-threshold", "--threshold"] {
        assert_eq!((kept(option, &strict), kept(option, &loose)), (2, 1), "{option}");
    }
}

#[test]
fn the_planner_of_the_facade_follows_the_threshold() {
    let folder = tempfile::tempdir().unwrap();
    let (files, bits) = near_album(folder.path());
    let names = [0, 1].map(|file: usize| files[file].display().to_string());
    let album = Album::read(files.iter().map(Photo::open).collect()).unwrap();
    let shows_both = |threshold: u32| {
        let options = PageOptions::new().keep_all(true).panels(2).duplicate_threshold(threshold);
        (1..=20).any(|seed| {
            let plan: Value =
                serde_json::from_str(&album.page(&options.clone().seed(seed)).unwrap().plan()).unwrap();
            let panels = plan["panels"].as_array().unwrap();
            names.iter().all(|name| panels.iter().any(|panel| panel["photo"] == **name))
        })
    };
    assert!(shows_both(bits - 2), "not near-duplicates, so both are on some page");
    assert!(!shows_both(bits + 2), "near-duplicates are on no page together");
}

#[test]
fn the_planner_of_a_project_follows_its_threshold() {
    let photo = |(i, fingerprint): (usize, u64)| PhotoMeta {
        fingerprint,
        ..PhotoMeta::unmeasured(&format!("p{i}"), 1500, 1000)
    };
    let photos: Vec<PhotoMeta> = [0xff, 0xff00, 0xffff << 40].into_iter().enumerate().map(photo).collect();
    assert_eq!(distance(photos[0].fingerprint, photos[1].fingerprint), 16);
    let shows_both = |bits: u8, request: Request| {
        let project = Project { alike: bits, ..Project::default() };
        let planning = Planning::new(&project, &photos);
        (1..=20).any(|seed| {
            let request = Request { seed, panels: Some(2), ..request.clone() };
            let page = planning.plan(request, None).unwrap().unwrap();
            let shown: HashSet<&str> =
                page.panels.iter().filter_map(|panel| panel.photo.as_deref()).collect();
            shown.contains("p0") && shown.contains("p1")
        })
    };
    assert!(shows_both(10, Request::default()));
    assert!(!shows_both(16, Request::default()));
}

#[test]
fn a_photo_with_open_eyes_is_used_instead_of_a_sharper_one() {
    let folder = tempfile::tempdir().unwrap();
    let (files, _) = near_album(folder.path());
    let mut album = Album::read(files.iter().map(Photo::open).collect()).unwrap();
    let face = |eye: f64| {
        let expression = Expression { right_eye: eye, left_eye: eye, mouth: 0.0, smile: 0.0 };
        let label = FACE.to_owned();
        Subject {
            x: 0.3,
            y: 0.3,
            width: 0.3,
            height: 0.3,
            label,
            score: 0.9,
            points: None,
            expression: Some(expression),
            light: None,
        }
    };
    let kept = |album: &Album| -> Vec<(bool, String)> {
        let verdicts = album.choose(&PageOptions::new()).verdicts;
        verdicts.into_iter().take(2).map(|verdict| (verdict.kept, verdict.reason.to_string())).collect()
    };
    let plain = kept(&album);
    let sharper = plain.iter().position(|(kept, _)| *kept).unwrap();
    assert_eq!(plain[sharper].1, "sharpest of 2");
    let mut see = |eyes: [f64; 2]| {
        let photos = album.imported_mut();
        photos[sharper].1.meta.find([face(eyes[0])]);
        photos[1 - sharper].1.meta.find([face(eyes[1])]);
        kept(&album)
    };
    assert_eq!(see([0.3, 0.3]), plain);
    assert_eq!(see([0.1, 0.1]), plain);
    let awake = see([0.1, 0.3]);
    assert_eq!(awake[1 - sharper], (true, "open eyes, best of 2".to_owned()));
    assert!(!awake[sharper].0);
}

#[test]
fn the_app_sends_the_eyes_with_its_measurements() {
    let photo = |id: &str, gradient: f64, eye: f64| {
        json!({
            "id": id, "name": id, "fingerprint": "0123456789abcdef", "gradient": gradient, "paper": 1, "laplacian": 900,
            "faces": [{ "rightEye": eye, "leftEye": eye, "mouth": 0, "smile": 0 }],
        })
    };
    let kept = |eyes: [f64; 2]| -> Vec<bool> {
        let photos = [photo("a", 2.0, eyes[0]), photo("b", 1.0, eyes[1])];
        let verdicts = catalogue::choose(&json!({ "photos": photos }).to_string()).unwrap();
        let verdicts: Value = serde_json::from_str(&verdicts).unwrap();
        verdicts.as_array().unwrap().iter().map(|verdict| verdict["kept"] == true).collect()
    };
    assert_eq!(kept([0.3, 0.3]), [true, false]);
    assert_eq!(kept([0.1, 0.3]), [false, true]);
}
