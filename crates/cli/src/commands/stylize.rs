//! `inkpanel stylize`: one photo in a style.

use super::read_style;
use crate::destination::Output;
use crate::format::Format;
use crate::input::decode_file;
use crate::masks::Masks;
use crate::run::Run;
use crate::{CliError, detectors, drawing};
use inkpanel_engine::framing::{Subject, subject_of};
use inkpanel_engine::native::{self, QUALITY};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::resize::Region;
use inkpanel_engine::style::faces::FaceBox;
use inkpanel_engine::style::part::subject_in;
use inkpanel_engine::style::stylize;
use std::collections::HashMap;
use std::path::PathBuf;

/// Arguments of `inkpanel stylize`.
#[derive(clap::Args)]
pub(crate) struct StylizeArgs {
    /// Style id (see `inkpanel styles`) or style file.
    #[arg(long, value_name = "ID|FILE")]
    pub(crate) style: String,
    /// Photo file, or - for standard input.
    pub(crate) input: PathBuf,
    /// Output file (.png, .jpg or .webp), or - for standard output.
    #[arg(short, long)]
    pub(crate) output: PathBuf,
    /// File format, regardless of the file name.
    #[arg(long, value_name = "KIND", value_parser = ["png", "jpg", "webp"])]
    pub(crate) format: Option<String>,
    /// Skip detection of the subject and of faces.
    #[arg(long)]
    pub(crate) no_detect: bool,
}

/// Writes a photo in a style. Unless detection is off, the style protects the faces, and knows the subject if
/// it needs it.
pub(crate) fn stylize_photo(run: &Run, asked: &StylizeArgs) -> Result<(), CliError> {
    let detects = !asked.no_detect;
    let output = Output::new(&asked.output, asked.format.as_deref())?;
    let kind = Format::of(&output.named)?;
    if matches!(kind, Format::Pdf | Format::Project | Format::Comic(_) | Format::Shots(_)) {
        return Err(format!("{}: stylize writes .png, .jpg or .webp", output.path.display()).into());
    }
    let style = read_style(run, &asked.style)?;
    detectors::warn_about_models(run, [&style]);
    let image = decode_file(run, &asked.input)?;
    let mut context = native::context_for(&style, &image);
    if detects && style.faces {
        context.show_faces(faces_in(run, &image)?);
    }
    let masks = Masks::new(run, HashMap::new(), None).detecting(detects);
    if let Some(matte) = masks.asked_by(&style, "", &image) {
        let size = (image.width(), image.height());
        context.show_subject(subject_in(
            &matte,
            Region::whole(size.0, size.1),
            size,
            (&image, context.scale()),
        ));
    }
    let drawn = stylize(&image, &style, &mut context)?;
    let size = (drawn.width(), drawn.height());
    output.write(&drawing::encoded(kind, size, &drawn.to_rgb(), (96, QUALITY))?)
}

/// The faces of a photo in its pixels, or its animals if it has no faces. None without the models, which is printed.
fn faces_in(run: &Run, photo: &Image) -> Result<Vec<FaceBox>, CliError> {
    let detectors = match detectors::load(None) {
        Ok(detectors) => detectors,
        Err(complaint) => {
            run.report.note(None, &format!("{complaint}; the style protects no face"));
            return Ok(Vec::new());
        }
    };
    let found = detectors.detect(photo)?;
    let mut found: Vec<Subject> = found.into_iter().map(subject_of).collect();
    found.sort_by(|a, b| b.height.total_cmp(&a.height));
    let (across, down) = (photo.width() as f64, photo.height() as f64);
    let face = |subject: &Subject| FaceBox {
        x: subject.x * across,
        y: subject.y * down,
        width: subject.width * across,
        height: subject.height * down,
    };
    Ok(Subject::protected(&found).map(face).collect())
}
