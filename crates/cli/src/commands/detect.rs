//! `inkpanel detect`: faces and objects.

use crate::destination::{print_json, print_lines};
use crate::photos::Photos;
use crate::run::Run;
use crate::{CliError, detectors, input};
use inkpanel_engine::Error;
use inkpanel_engine::detect::{Detection, Detectors};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::path::PathBuf;

/// Arguments of `inkpanel detect`.
#[derive(clap::Args)]
pub(crate) struct DetectArgs {
    /// Photos, or folders with photos.
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains faces.onnx, objects.onnx and optionally landmarks.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
}

pub(crate) fn detect_photos(run: &Run, asked: &DetectArgs) -> Result<(), CliError> {
    let detectors = detectors::load(asked.models.as_deref())?;
    let photos = Photos::read(run, input::files(run, &asked.files)?)?;
    if photos.album.imported().is_empty() {
        return Err(Error::NoPhotos.into());
    }
    let found = detected(&detectors, &photos);
    let rows = photos.iter().zip(&found).map(|((path, photo), found)| {
        json!({ "file": path.display().to_string(), "boxes": detectors::boxes(photo, found) })
    });
    if asked.json {
        return print_json(&Value::Array(rows.collect()));
    }
    print_lines(photos.iter().zip(&found).map(|((path, _), found)| {
        let words: Vec<String> =
            found.iter().map(|d| format!("{} {:.0} %", d.label, d.score * 100.0)).collect();
        format!("{}  {}", path.display(), words.join(", "))
    }))
}

/// Boxes of each photo. A failure is reported and counts as no result.
fn detected(detectors: &Detectors, photos: &Photos<'_>) -> Vec<Vec<Detection>> {
    let found = photos.album.imported().par_iter().map(|(place, photo)| {
        detectors.detect(&photo.work).unwrap_or_else(|error| {
            photos.run.report.note(Some(&photos.file(*place).display().to_string()), &error.to_string());
            Vec::new()
        })
    });
    found.collect()
}
