//! Subject masks for the command line: one mask per photo, as large as the photo.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use inkpanel_engine::detect::Segmenter;
use inkpanel_engine::page::cutout::full_mask;
use inkpanel_engine::page::import::Imported;
use inkpanel_engine::page::png;
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::destination::print_lines;
use crate::photos::Photos;
use crate::run::Run;
use crate::{CliError, detectors, input};

/// Writes a mask for each photo into a folder, and creates the folder if necessary.
pub(crate) fn segment(run: &Run, asked: &SegmentArgs) -> Result<(), CliError> {
    let net = detectors::load_segmenter(asked.models.as_deref())?;
    let folder = asked.output.as_path();
    let photos = Photos::read(run, input::files(run, &asked.files)?)?;
    if photos.album.imported().is_empty() {
        return Err(inkpanel_engine::Error::NoPhotos.into());
    }
    std::fs::create_dir_all(folder).map_err(|error| CliError::writing(folder, &error))?;
    let masks = names(&photos, folder);
    let cut = |((place, photo), mask): (&(usize, Imported), &PathBuf)| {
        cut_out(&net, photos.file(*place), photo, mask)
    };
    let made: Vec<Result<Value, CliError>> =
        photos.album.imported().par_iter().zip(&masks).map(cut).collect();
    let mut rows = Vec::new();
    for ((path, _), made) in photos.iter().zip(made) {
        match made {
            Ok(row) => rows.push(row),
            Err(complaint) => run.report.note(Some(&input::told(path)), &format!("{complaint}; left out")),
        }
    }
    if rows.is_empty() {
        return Err(CliError::new("detector", "no mask could be made"));
    }
    if asked.json {
        return crate::destination::print_json(&Value::Array(rows));
    }
    print_lines(rows.iter().map(|row| {
        let text = |key: &str| row[key].as_str().unwrap_or_default();
        let share = row["coverage"].as_f64().unwrap_or_default() * 100.0;
        format!("{}  {share:.0} % of {}", text("mask"), text("file"))
    }))
}

/// Adds the subject mask of each photo. A failure is reported, and the photo gets no mask.
pub(crate) fn add_masks(photos: &mut Photos<'_>, models: Option<&Path>) -> Result<(), CliError> {
    let run = photos.run;
    let net = detectors::load_segmenter(models)?;
    let files: Vec<String> = photos.iter().map(|(path, _)| input::told(path)).collect();
    photos.album.imported_mut().par_iter_mut().zip(files).for_each(|((_, photo), file)| {
        match net.look(&photo.work) {
            Ok(mask) => photo.meta.mask = Some(mask),
            Err(error) => run.report.note(Some(&file), &error.to_string()),
        }
    });
    Ok(())
}

/// Returns `DIR/NAME.png` for each photo. A repeated name gets a number.
fn names(photos: &Photos<'_>, folder: &Path) -> Vec<PathBuf> {
    let mut taken = HashSet::new();
    let name = |(path, _): (&Path, &Imported)| {
        let stem = path.file_stem().map_or_else(|| "photo".into(), |stem| stem.to_string_lossy());
        let numbered = |n: usize| if n < 2 { stem.to_string() } else { format!("{stem}-{n}") };
        let mut free = numbered(1);
        for n in 2.. {
            if taken.insert(free.clone()) {
                break;
            }
            free = numbered(n);
        }
        folder.join(format!("{free}.png"))
    };
    photos.iter().map(name).collect()
}

/// Makes one mask, and reports it.
fn cut_out(net: &Segmenter, path: &Path, photo: &Imported, file: &Path) -> Result<Value, CliError> {
    let matte = net.look(&photo.work)?;
    let facts = matte.facts();
    let (width, height) = (photo.meta.width, photo.meta.height);
    let plane = full_mask(&matte, &photo.work, (width as usize, height as usize));
    let png = png::encode_gray(&plane)?;
    std::fs::write(file, png).map_err(|error| CliError::writing(file, &error))?;
    let digits = |share: f64| (share * 1e4).round() / 1e4;
    let pixels = |share: f64, side: u32| (share * f64::from(side) * 10.0).round() / 10.0;
    let [x, y, w, h] = facts.bounds;
    let bounds = json!({
        "x": pixels(x, width), "y": pixels(y, height), "width": pixels(w, width), "height": pixels(h, height),
    });
    Ok(json!({
        "file": path.display().to_string(),
        "mask": file.display().to_string(),
        "coverage": digits(facts.coverage),
        "box": if w > 0.0 { bounds } else { Value::Null },
        "confidence": digits(facts.confidence),
    }))
}

/// Arguments of `inkpanel segment`.
#[derive(clap::Args)]
pub(crate) struct SegmentArgs {
    /// Photos, or folders with photos.
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Folder for the masks, one NAME.png per photo.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains subject.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
}
