//! Detection for the command line: finds the model files and processes photos in parallel.

use std::path::{Path, PathBuf};

use inkpanel::detect::{Aesthetics, Detection, Detectors, Segmenter};
use inkpanel::page::import::Imported;
use inkpanel::places::Places;
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::{Complaint, telling};

/// Reads the models from `folder`, or from the default folder.
pub(crate) fn load(folder: Option<&Path>) -> Result<Detectors, Complaint> {
    let folder = folder.map(Path::to_path_buf).or_else(find).ok_or_else(|| {
        "the detectors' models are missing: make them with `cargo xtask models`, or name their folder \
         with --models"
            .to_owned()
    })?;
    let read = |name: &str| {
        let file = folder.join(name);
        std::fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))
    };
    let (faces, objects) = (read("faces.onnx")?, read("objects.onnx")?);
    Detectors::new(&faces, &objects).map_err(|error| format!("{}: {error}", folder.display()))
}

/// Reads the model that rates pictures, from `folder` or the default folder.
pub(crate) fn load_aesthetics(folder: Option<&Path>) -> Result<Aesthetics, Complaint> {
    let file = folder.map(Path::to_path_buf).or_else(find).map(|folder| folder.join("aesthetics.onnx"));
    let onnx = file.and_then(|file| std::fs::read(file).ok()).ok_or_else(|| {
        "aesthetics.onnx is missing: make it with `cargo xtask models`, or name its folder with --models"
            .to_owned()
    })?;
    Aesthetics::new(&onnx).map_err(|error| format!("aesthetics.onnx: {error}"))
}

/// Reads the model that finds the subject of a photo, from `folder` or the default folder.
pub(crate) fn load_segmenter(folder: Option<&Path>) -> Result<Segmenter, Complaint> {
    let file = folder.map(Path::to_path_buf).or_else(find).map(|folder| folder.join("subject.onnx"));
    let onnx = file.and_then(|file| std::fs::read(file).ok()).ok_or_else(|| {
        "subject.onnx is missing: make it with `cargo xtask models`, or name its folder with --models"
            .to_owned()
    })?;
    Segmenter::new(&onnx).map_err(|error| format!("subject.onnx: {error}"))
}

/// Reads the table of places, from `folder` or the default folder.
pub(crate) fn load_places(folder: Option<&Path>) -> Result<Places, Complaint> {
    let file = folder.map(Path::to_path_buf).or_else(find).map(|folder| folder.join("places.bin"));
    let table = file.and_then(|file| std::fs::read(file).ok()).ok_or_else(|| {
        "places.bin is missing: make it with `cargo xtask models`, or name its folder with --models"
            .to_owned()
    })?;
    Places::read(&table).map_err(|error| format!("places.bin: {error}"))
}

/// Searches `models` next to the program, `www/models` in the working folder, then `www/models` in the
/// checkout of the build.
fn find() -> Option<PathBuf> {
    let beside = std::env::current_exe().ok().and_then(|program| Some(program.parent()?.join("models")));
    let here = std::env::current_dir().unwrap_or_default();
    let above = here.ancestors().map(|folder| folder.join("www/models"));
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/models");
    beside.into_iter().chain(above).chain([built]).find(|folder| folder.join("faces.onnx").is_file())
}

/// Subjects of each photo. A failure is reported and counts as no result.
pub(crate) fn run(detectors: &Detectors, photos: &[(PathBuf, Imported)]) -> Vec<Vec<Detection>> {
    let found = photos.par_iter().map(|(path, photo)| {
        detectors.detect(&photo.work).unwrap_or_else(|error| {
            telling::note(Some(&path.display().to_string()), &error.to_string());
            Vec::new()
        })
    });
    found.collect()
}

/// The boxes of a photo in pixels of the oriented original, with a digit after the point.
pub(crate) fn boxes(photo: &Imported, found: &[Detection]) -> Vec<Value> {
    let (width, height) = (f64::from(photo.meta.width), f64::from(photo.meta.height));
    let pixels = |part: f64, side: f64| (part * side * 10.0).round() / 10.0;
    let row = |d: &Detection| {
        let mut row = json!({
            "label": d.label,
            "score": (d.score * 1e4).round() / 1e4,
            "x": pixels(d.x, width),
            "y": pixels(d.y, height),
            "width": pixels(d.width, width),
            "height": pixels(d.height, height),
        });
        if let Some(points) = &d.points {
            row["points"] =
                points.iter().map(|&[x, y]| json!([pixels(x, width), pixels(y, height)])).collect();
        }
        row
    };
    found.iter().map(row).collect()
}
