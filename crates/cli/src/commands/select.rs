//! `inkpanel select`: the photos that are worth a panel.

use crate::destination::{print_json, print_lines};
use crate::photos::Photos;
use crate::run::Run;
use crate::{CliError, input};
use inkpanel::PageOptions;
use inkpanel_engine::Error;
use inkpanel_engine::select::DUPLICATE_THRESHOLD;
use serde_json::{Value, json};
use std::path::PathBuf;

/// Arguments of `inkpanel select`.
#[derive(clap::Args)]
pub(crate) struct SelectArgs {
    /// Photos, or folders with photos.
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Maximum fingerprint distance of near-duplicates.
    #[arg(long, alias = "threshold", value_name = "BITS", default_value_t = DUPLICATE_THRESHOLD)]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=64))]
    pub(crate) duplicate_threshold: u32,
    /// Skip face detection. Photos with shut eyes are then not recognised.
    #[arg(long)]
    pub(crate) no_detect: bool,
    /// Folder that contains faces.onnx, objects.onnx and landmarks.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
}

pub(crate) fn select_photos(run: &Run, asked: &SelectArgs) -> Result<(), CliError> {
    let mut photos = Photos::read(run, input::files(run, &asked.files)?)?;
    if photos.album.imported().is_empty() {
        return Err(Error::NoPhotos.into());
    }
    if !asked.no_detect {
        photos.add_subjects(asked.models.as_deref(), "eyes are not compared");
    }
    let options = PageOptions::new().duplicate_threshold(asked.duplicate_threshold);
    let verdicts = photos.album.choose(&options).verdicts;
    let rows: Vec<Value> = photos
        .iter()
        .zip(&verdicts)
        .map(|((path, photo), verdict)| {
            json!({
                "file": path.display().to_string(),
                "fingerprint": format!("{:016x}", photo.measures.fingerprint),
                "sharpness": photo.measures.gradient,
                "eyes": photo.meta.openness(),
                "group": verdict.group,
                "kept": verdict.kept,
                "why": verdict.reason.to_string(),
            })
        })
        .collect();
    if asked.json {
        return print_json(&Value::Array(rows));
    }
    print_lines(photos.iter().zip(&verdicts).map(|((path, _), verdict)| {
        let mark = if verdict.kept { "keep" } else { "skip" };
        format!("{mark}  {}  {}", path.display(), verdict.reason)
    }))
}
