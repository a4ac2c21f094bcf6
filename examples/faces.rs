//! A table of the faces in photos and what panels do to them: framed by contrast alone, and by what was found.
//!
//!     cargo xtask models
//!     cargo run --release --example faces -- FILES...
//!
//! Each photo is framed for nine panels from tall to wide, and a round one. A face is *cut* when a panel shows a part
//! of it only; *avoidable* counts the cuts for which a crop exists that holds a face and cuts none.

use std::path::Path;
use std::process::ExitCode;

use inkpanel::detect::Detectors;
use inkpanel::framing::{Crop, FACE, PhotoMeta, Subject, Target, frame};
use inkpanel::page::import::import;
use inkpanel::raster::decode::Limits;

const ASPECTS: [f64; 9] = [0.4, 0.5, 0.67, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5];

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaint) => {
            eprintln!("{complaint}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/models");
    let read = |file: &Path| std::fs::read(file).map_err(|error| format!("{}: {error}", file.display()));
    let (faces, objects) = (read(&models.join("faces.onnx"))?, read(&models.join("objects.onnx"))?);
    let detectors = Detectors::new(&faces, &objects).map_err(|error| error.to_string())?;
    let mut total = [0; 6];
    println!(
        "{:<28}{:>6}{:>8}{:>8}{:>8}{:>8}{:>11}",
        "photo", "faces", "objects", "panels", "before", "after", "avoidable"
    );
    for file in std::env::args().skip(1).map(std::path::PathBuf::from) {
        let photo = match import("photo", &read(&file)?, &Limits::default()) {
            Ok(photo) => photo,
            Err(error) => {
                eprintln!("{}: {error}", file.display());
                continue;
            }
        };
        let found = detectors.detect(&photo.work).map_err(|error| error.to_string())?;
        let blind = photo.meta;
        let seen = PhotoMeta { subjects: found.into_iter().map(Into::into).collect(), ..blind.clone() };
        let faces: Vec<&Subject> = seen.subjects.iter().filter(|s| s.label == FACE).collect();
        let (mut before, mut after, mut avoidable) = (0, 0, 0);
        for aspect in ASPECTS {
            let target = Target::of_aspect(aspect);
            let crop = frame(&seen, &target, 0);
            let cut = cuts(&crop, &faces);
            before += cuts(&frame(&blind, &target, 0), &faces);
            after += cut;
            avoidable += if cut > 0 && possible(&seen, aspect, &faces) { cut } else { 0 };
        }
        let row = [faces.len(), seen.subjects.len() - faces.len(), ASPECTS.len(), before, after, avoidable];
        print_row(&file.file_name().unwrap_or_default().to_string_lossy(), row);
        total.iter_mut().zip(row).for_each(|(sum, value)| *sum += value);
    }
    print_row("all", total);
    Ok(())
}

fn print_row(name: &str, [faces, objects, panels, before, after, avoidable]: [usize; 6]) {
    println!("{name:<28}{faces:>6}{objects:>8}{panels:>8}{before:>8}{after:>8}{avoidable:>11}");
}

/// The part of a face that a crop shows, 0..1.
fn part(crop: &Crop, face: &Subject) -> f64 {
    let shared = |a: f64, al: f64, b: f64, bl: f64| ((a + al).min(b + bl) - a.max(b)).max(0.0);
    shared(crop.x, crop.width, face.x, face.width) * shared(crop.y, crop.height, face.y, face.height)
        / (face.width * face.height)
}

fn cuts(crop: &Crop, faces: &[&Subject]) -> usize {
    faces.iter().filter(|face| (1e-6..1.0 - 1e-6).contains(&part(crop, face))).count()
}

/// Whether some crop of that aspect, from the widest to a third of it, holds a face and cuts none.
fn possible(photo: &PhotoMeta, aspect: f64, faces: &[&Subject]) -> bool {
    let widest = (aspect / photo.aspect()).min(1.0);
    (0..9).any(|step| {
        let width = widest * (1.0 - f64::from(step) / 12.0);
        let height = width * photo.aspect() / aspect;
        (0..41 * 41).any(|at| {
            let place = |i: i32, side: f64| (1.0 - side) * f64::from(i) / 40.0;
            let crop = Crop { x: place(at % 41, width), y: place(at / 41, height), width, height };
            cuts(&crop, faces) == 0 && faces.iter().any(|face| part(&crop, face) > 1.0 - 1e-6)
        })
    })
}
