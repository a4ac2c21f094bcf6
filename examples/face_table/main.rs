//! Writes a table of the detected faces in photos and the faces cut by panels, and a sheet to look at. `cargo
//! xtask faces` runs it.
//!
//!     cargo run --example face_table -- TABLE.md SHEET.jpg PHOTOS...
//!
//! Each photo is cropped for nine panels from tall to wide, using only contrast (*before*) or detection
//! (*after*). A face is *cut* if a panel shows only a part of it. *Avoidable* counts cuts after detection if
//! another crop contains a face and cuts none. `truth.json` has the faces as marked by a person, in pixels.
//! It contains faces whose box is at least a thirtieth of the photo's longer side, including profiles.

mod cuts;
#[path = "../sheets/font.rs"]
mod font;
mod pages;
#[path = "../sheets/seen.rs"]
mod seen;
mod sheet;

use std::collections::HashMap;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use cuts::{avoidable, cuts};
use inkpanel_engine::detect::Detectors;
use inkpanel_engine::framing::{FACE, PhotoMeta, Subject, Target, frame, subject_of};
use inkpanel_engine::page::import::import;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::Limits;

const ASPECTS: [f64; 9] = [0.4, 0.5, 0.67, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5];

/// Text above the table.
const ABOUT: &str = "\
# Face detection: found, missed and cut

This report shows how many faces the detector finds, and how many of them panels cut.
`cargo xtask faces` writes it.

- Photos: the sample album, the test photos, and `sample1` to `sample6` of the npm package `@vladmandic/face-api` 1.7.15.
- Faces: a person marked them in `examples/face_table/truth.json`. Each is at least 1/30 of the longer side of its photo.
- Cut before, cut after: each photo is cropped for nine panels with aspect ratios from 0.4 to 2.5. The crop before detection uses contrast only. A face is cut if a panel shows only a part of it.
- Avoidable: cuts after detection, if another crop contains a face and cuts no face.
";

/// Minimum intersection over union of two boxes of the same face.
const SAME: f64 = 0.3;

/// Left, top, width and height in pixels.
type Boxes = HashMap<String, Vec<[f64; 4]>>;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<PathBuf> = std::env::args().skip(1).map(PathBuf::from).collect();
    let [table, sheet, photos @ ..] = arguments.as_slice() else {
        return Err("usage: face_table TABLE.md SHEET.jpg PHOTOS...".into());
    };
    let truth: Boxes = serde_json::from_str(include_str!("truth.json"))?;
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/models");
    let net = |name: &str| std::fs::read(models.join(name)).map_err(|error| format!("{name}: {error}"));
    let detectors = Detectors::new(&net("faces.onnx")?, &net("objects.onnx")?)?;
    let mut rows = Vec::new();
    for path in photos {
        rows.push(Row::measure(path, &detectors, &truth)?);
        eprint!("\r{} of {}", rows.len(), photos.len());
    }
    eprintln!();
    let metas: Vec<&PhotoMeta> = rows.iter().map(|row| &row.meta).collect();
    let text = format!("{}\n{}", written(&rows), pages::table(&metas));
    print!("{text}");
    std::fs::write(table, format!("{ABOUT}\n{text}"))?;
    sheet::draw(&rows, sheet)
}

/// A photo, what is in it and what panels do to it.
struct Row {
    name: String,
    picture: Image,
    meta: PhotoMeta,
    /// Real faces, detected, missed and false faces, objects, cut before, cut after, avoidable.
    counts: [usize; 8],
}

impl Row {
    fn measure(path: &Path, detectors: &Detectors, truth: &Boxes) -> Result<Self, Box<dyn Error>> {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let photo = import("photo", &std::fs::read(path)?, &Limits::default())?;
        let found = detectors.detect(&photo.work)?;
        let blind = photo.meta;
        let meta = PhotoMeta { subjects: found.into_iter().map(subject_of).collect(), ..blind.clone() };
        let faces: Vec<&Subject> = meta.subjects.iter().filter(|subject| subject.label == FACE).collect();
        let (width, height) = (f64::from(meta.width), f64::from(meta.height));
        let none = Vec::new();
        let there = truth.get(&name).unwrap_or(&none);
        let is_there = |face: &&&Subject| {
            let pixels = [face.x * width, face.y * height, face.width * width, face.height * height];
            there.iter().any(|real| overlap(*real, pixels) > SAME)
        };
        let real = faces.iter().filter(is_there).count();
        let (mut before, mut after, mut needless) = (0, 0, 0);
        for aspect in ASPECTS {
            let target = Target::of_aspect(aspect);
            before += cuts(&frame(&blind, &target, 0), &faces);
            let crop = frame(&meta, &target, 0);
            after += cuts(&crop, &faces);
            needless += avoidable(&meta, &crop, aspect, &faces);
        }
        let objects = meta.subjects.len() - faces.len();
        let counts = [
            there.len(),
            real,
            there.len().saturating_sub(real),
            faces.len() - real,
            objects,
            before,
            after,
            needless,
        ];
        Ok(Self { name, picture: photo.work, meta, counts })
    }
}

/// Intersection over union.
fn overlap(a: [f64; 4], b: [f64; 4]) -> f64 {
    let shared = |i: usize| ((a[i] + a[i + 2]).min(b[i] + b[i + 2]) - a[i].max(b[i])).max(0.0);
    let both = shared(0) * shared(1);
    both / (a[2] * a[3] + b[2] * b[3] - both)
}

fn written(rows: &[Row]) -> String {
    let mut text = String::from(
        "| Photo | Faces | Found | Missed | False | Objects | Cut before | Cut after | Avoidable |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    let mut line = |name: &str, counts: [usize; 8]| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {} |", counts.map(|count| count.to_string()).join(" | "));
    };
    let mut total = [0; 8];
    for row in rows {
        line(&row.name, row.counts);
        total.iter_mut().zip(row.counts).for_each(|(sum, count)| *sum += count);
    }
    line(&format!("all {}", rows.len()), total);
    text
}
