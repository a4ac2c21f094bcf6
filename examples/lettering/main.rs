//! Measures the automatic placement of text, and draws pages to look at.
//!
//!     cargo run --example lettering                       prints the figures of docs/design/lettering.md
//!     cargo run --example lettering -- draw FOLDER [N]    draws the first N pages, in their styles
//!     cargo run --example lettering -- kinds FILE.png     draws one of each kind of word
//!     cargo run --example lettering -- masks              the same by boxes and by the masks of the net: docs/design/subjects.md
//!     cargo run --example lettering -- detect             looks at the photos again: tests/data/lettering.json

mod measure;
mod pages;

use std::collections::HashMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use inkpanel_engine::detect::{Detectors, Segmenter};
use inkpanel_engine::framing::Subject;
use inkpanel_engine::page::words::{Letters, draw};
use inkpanel_engine::page::{Document, Scene, compose, import, png};
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::style::Context;
use measure::{Figures, measure};
use pages::{Known, PAGES, known, page, photos, placed_again};

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        [] => figures(root),
        ["masks"] => by_masks(root),
        ["detect"] => detect(root),
        ["kinds", file] => kinds(Path::new(file)),
        ["draw", folder] => draw_pages(root, Path::new(folder), PAGES),
        ["draw", folder, count] => draw_pages(root, Path::new(folder), count.parse()?),
        _ => Err("usage: lettering [draw FOLDER [N] | kinds FILE.png | masks | detect]".into()),
    }
}

fn figures(root: &Path) -> Result<(), Box<dyn Error>> {
    let (photos, letters) = (photos(&known(root)?), Letters::bundled()?);
    let mut all = Figures::default();
    for number in 0..PAGES {
        let page = page(&photos, number, &letters)?;
        all.add(measure(&page, &photos, &letters, &format!("page {number}"))?);
    }
    for told in &all.told {
        println!("{told}");
    }
    let (least, most) = all.points.unwrap_or_default();
    println!("pages {PAGES}, balloons {}", all.balloons);
    println!("faces seen {}, covered {}", all.faces.0, all.faces.1);
    println!("area of bodies covered {:.2} %", all.covered_bodies());
    println!("balloons that hang on another {}", all.joined);
    println!("tails {}, right {:.1} %", all.tails.0, all.right_tails());
    println!("texts outside of their balloons {}", all.outside);
    println!("overlaps {}, borders crossed {}, out of order {}", all.overlaps, all.crossing, all.disorder);
    println!("letters on A4 from {least:.1} to {most:.1} points");
    Ok(())
}

/// Compares how much of the subjects is covered by text, for placement with boxes and with masks.
fn by_masks(root: &Path) -> Result<(), Box<dyn Error>> {
    let (known, letters) = (known(root)?, Letters::bundled()?);
    let net = Segmenter::new(&fs::read(root.join("www/models/subject.onnx"))?)?;
    let plain = photos(&known);
    let mut masked = plain.clone();
    for (photo, meta) in known.iter().zip(&mut masked) {
        let bytes = fs::read(root.join(&photo.folder).join(&photo.id))?;
        let mask = net.look(&decode_fit(&bytes, &Limits::default(), import::WORK_SIDE)?.image)?;
        meta.mask = (!mask.facts().is_vague()).then_some(mask);
    }
    let (mut by_boxes, mut by_masks) = (Figures::default(), Figures::default());
    for number in 0..PAGES {
        let page = page(&plain, number, &letters)?;
        let again = placed_again(&page, &masked, &letters)?;
        by_boxes.add(measure(&page, &masked, &letters, &format!("page {number}"))?);
        by_masks.add(measure(&again, &masked, &letters, &format!("page {number}"))?);
    }
    println!("masks {} of {}", masked.iter().filter(|photo| photo.mask.is_some()).count(), masked.len());
    for (name, all) in [("boxes", by_boxes), ("masks", by_masks)] {
        println!(
            "by {name}: figures covered {:.2} %, boxes of persons {:.2} %, faces {}, tails right {:.1} %",
            all.covered_figures(),
            all.covered_bodies(),
            all.faces.1,
            all.right_tails()
        );
    }
    Ok(())
}

/// Runs detection on all bundled photos, and stores the results.
fn detect(root: &Path) -> Result<(), Box<dyn Error>> {
    let net =
        |name: &str| fs::read(root.join("www/models").join(name)).map_err(|error| format!("{name}: {error}"));
    let detectors = Detectors::new(&net("faces.onnx")?, &net("objects.onnx")?)?;
    let mut all = Vec::new();
    for folder in ["www/public/samples", "tests/photos"] {
        let mut files: Vec<PathBuf> = fs::read_dir(root.join(folder))?
            .map(|entry| Ok(entry?.path()))
            .collect::<Result<_, std::io::Error>>()?;
        files.retain(|path| path.extension().is_some_and(|extension| extension == "jpg"));
        files.sort();
        for path in files {
            let image = decode_fit(&fs::read(&path)?, &Limits::default(), import::WORK_SIDE)?;
            let rounded = |part: f64| (part * 1e4).round() / 1e4;
            let subject = |found: inkpanel_engine::detect::Detection| Subject {
                x: rounded(found.x),
                y: rounded(found.y),
                width: rounded(found.width),
                height: rounded(found.height),
                label: found.label,
                score: rounded(found.score),
                points: found.points.map(|points| points.map(|point| point.map(rounded))),
                expression: None,
                light: None,
            };
            let subjects: Vec<Subject> = detectors.detect(&image.image)?.into_iter().map(subject).collect();
            let id = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            println!("{id}: {}", subjects.iter().map(|s| s.label.as_str()).collect::<Vec<_>>().join(", "));
            all.push(Known { id, folder: folder.into(), size: (image.width, image.height), subjects });
        }
    }
    fs::write(root.join("tests/data/lettering.json"), serde_json::to_string_pretty(&all)? + "\n")?;
    Ok(())
}

fn draw_pages(root: &Path, folder: &Path, count: u32) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let known = known(root)?;
    let (photos, letters) = (photos(&known), Letters::bundled()?);
    for number in 0..count {
        let page = page(&photos, number, &letters)?;
        let scene = Scene::new(&page, 900)?;
        let mut images = HashMap::new();
        for id in scene.panels.iter().filter_map(|panel| panel.photo.as_deref()) {
            let Some(photo) = known.iter().find(|photo| photo.id == id) else { continue };
            let bytes = fs::read(root.join(&photo.folder).join(id))?;
            images.insert(id, decode_fit(&bytes, &Limits::default(), import::WORK_SIDE)?.image);
        }
        let mut sheet = compose::compose(&scene, |id| images.get(id), &mut Context::default())?;
        draw::lay_words(&mut sheet, &page, &letters)?;
        fs::write(folder.join(format!("page-{number:02}.png")), png::encode(&sheet, 96)?)?;
    }
    Ok(())
}

fn kinds(file: &Path) -> Result<(), Box<dyn Error>> {
    let document = Document::parse(include_str!("kinds.json"))?;
    let scene = Scene::new(&document, 1240)?;
    let mut sheet = compose::compose(&scene, |_| None, &mut Context::default())?;
    draw::lay_words(&mut sheet, &document, &Letters::bundled()?)?;
    fs::write(file, png::encode(&sheet, 150)?)?;
    Ok(())
}
