//! Detection for the command line: finds the model files and processes photos in parallel.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use inkpanel_engine::detect::{Aesthetics, Detection, Detectors, Segmenter};
use inkpanel_engine::native;
use inkpanel_engine::page::import::Imported;
use inkpanel_engine::places::Places;
use inkpanel_engine::style::Style;
use inkpanel_engine::style::painters::Painters;
use serde_json::{Value, json};

use crate::CliError;
use crate::report::Report;
use crate::run::Run;

/// Reads the models from `folder`, or from the default folder. The landmark model is optional.
pub(crate) fn load(folder: Option<&Path>) -> Result<Detectors, CliError> {
    let folder = folder
        .map(Path::to_path_buf)
        .or_else(find)
        .ok_or_else(|| missing("the detectors' models are", "them", "their"))?;
    let read = |name: &str| {
        let file = folder.join(name);
        std::fs::read(&file).map_err(|error| CliError::new("no-models", error.to_string()).at(file.display()))
    };
    let (faces, objects) = (read("faces.onnx")?, read("objects.onnx")?);
    let detectors = Detectors::new(&faces, &objects);
    let detectors = match read("landmarks.onnx") {
        Ok(landmarks) => detectors.and_then(|detectors| detectors.with_landmarks(&landmarks)),
        Err(_) => detectors,
    };
    detectors.map_err(|error| CliError::from(error).at(folder.display()))
}

/// Reads the model that rates pictures, from `folder` or the default folder.
pub(crate) fn load_aesthetics(folder: Option<&Path>) -> Result<Aesthetics, CliError> {
    let name = "aesthetics.onnx";
    Aesthetics::new(&model(folder, name)?).map_err(|error| CliError::from(error).at(name))
}

/// Reads the model that finds the subject of a photo, from `folder` or the default folder.
pub(crate) fn load_segmenter(folder: Option<&Path>) -> Result<Segmenter, CliError> {
    let name = "subject.onnx";
    Segmenter::new(&model(folder, name)?).map_err(|error| CliError::from(error).at(name))
}

/// Reads a model from `folder` or the default folder.
fn model(folder: Option<&Path>, name: &str) -> Result<Vec<u8>, CliError> {
    let file = folder.map(Path::to_path_buf).or_else(find).map(|folder| folder.join(name));
    let missing = || missing(&format!("{name} is"), "it", "its");
    file.and_then(|file| std::fs::read(file).ok()).ok_or_else(missing)
}

/// The error of missing models, which are `it` and have `its` folder.
fn missing(models: &str, it: &str, its: &str) -> CliError {
    let advice = format!("make {it} with `cargo xtask models`, or name {its} folder with --models");
    CliError::new("no-models", format!("{models} missing: {advice}"))
}

/// Reads the model of the block Painter from the default folder. Prints why it is missing, and returns `None`.
fn load_painters(report: &Report) -> Option<Arc<Painters>> {
    let file = find().map(|folder| folder.join("painters.onnx"));
    let read = || {
        let onnx = file.and_then(|file| std::fs::read(file).ok());
        let onnx = onnx.ok_or("it is missing: make it with `cargo xtask models`")?;
        Painters::new(&onnx).map_err(|error| error.to_string())
    };
    match read() {
        Ok(painters) => Some(Arc::new(painters)),
        Err(complaint) => {
            report.note(Some("painters.onnx"), &format!("{complaint}; the block Painter changes nothing"));
            None
        }
    }
}

/// Sets the model of the block Painter: a file of the user, or the model of the default folder.
pub(crate) fn set_painters(run: &mut Run, file: Option<&Path>) -> Result<(), CliError> {
    let Some(file) = file else {
        let report = run.report.clone();
        native::read_painters_with(move || load_painters(&report));
        return Ok(());
    };
    let onnx = std::fs::read(file).map_err(|error| CliError::reading(&error).at(file.display()))?;
    let painters = Painters::new(&onnx).map_err(|error| CliError::from(error).at(file.display()))?;
    // As in `www/painters/own-painters.ts`: the CRC-32 of the file, and its length in bytes.
    run.painters = Some(format!("{:08x}{:08x}", crc32fast::hash(&onnx), onnx.len()));
    let painters = Arc::new(painters);
    native::read_painters_with(move || Some(painters.clone()));
    Ok(())
}

/// Warns about models that styles name, if the Painter uses another model.
pub(crate) fn warn_about_models<'s>(run: &Run, styles: impl IntoIterator<Item = &'s Style>) {
    let given = run.painters.as_ref();
    let painted = match given {
        Some(_) => "the file of --painters",
        None => "the built-in model",
    };
    let named: BTreeSet<&str> = styles.into_iter().flat_map(Style::models).collect();
    for (id, file) in named.into_iter().filter_map(|reference| reference.split_once(' ')) {
        if given.is_none_or(|given| given != id) {
            run.report
                .note(Some(file), &format!("a style names this model of painters; {painted} replaces it"));
        }
    }
}

/// Reads the table of places, from `folder` or the default folder.
pub(crate) fn load_places(folder: Option<&Path>) -> Result<Places, CliError> {
    let name = "places.bin";
    Places::read(&model(folder, name)?).map_err(|error| CliError::from(error).at(name))
}

/// Searches `models` next to the program, `www/models` in the working folder, then `www/models` in the
/// checkout of the build.
fn find() -> Option<PathBuf> {
    let beside = std::env::current_exe().ok().and_then(|program| Some(program.parent()?.join("models")));
    let here = std::env::current_dir().unwrap_or_default();
    let above = here.ancestors().map(|folder| folder.join("www/models"));
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../www/models");
    beside.into_iter().chain(above).chain([built]).find(|folder| folder.join("faces.onnx").is_file())
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
        if let Some(expression) = &d.expression {
            row["expression"] = json!(expression);
        }
        row
    };
    found.iter().map(row).collect()
}
