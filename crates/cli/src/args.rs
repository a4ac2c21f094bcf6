//! Options of several commands.

use crate::CliError;
use crate::commands::read_style;
use crate::drawing;
use crate::paper::Paper;
use crate::photos::{BY_CONTRAST, Photos};
use crate::run::Run;
use clap::builder::PossibleValuesParser;
use inkpanel::PageOptions;
use inkpanel_engine::layout::PageSettings;
use inkpanel_engine::select::DUPLICATE_THRESHOLD;
use std::path::PathBuf;

/// Options of every output.
#[derive(clap::Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct How {
    #[command(flatten)]
    pub(crate) printing: drawing::Printing,
    /// Read settings from a JSON or TOML file.
    ///
    /// Keys are the names of options; "files" lists the photos. Paths are relative to the file. Options on the command line take
    /// precedence.
    #[arg(long, value_name = "FILE")]
    #[allow(dead_code, reason = "its settings are options by now")]
    pub(crate) config: Option<PathBuf>,
    /// File format, regardless of the file name.
    #[arg(long, value_name = "KIND", value_parser = ["png", "jpg", "webp", "pdf", "inkpanel"])]
    pub(crate) format: Option<String>,
    /// Treat warnings, such as a skipped photo, as errors and write nothing.
    #[arg(long)]
    pub(crate) strict: bool,
    /// Skip existing output files, to resume a run.
    #[arg(long)]
    pub(crate) skip_existing: bool,
    /// Format of the progress on standard error: text, or one JSON object per line.
    #[arg(long, value_name = "FORM", value_parser = ["text", "json"], default_value = "text")]
    #[allow(dead_code, reason = "`wants_json` reads it, also if other arguments are wrong")]
    pub(crate) progress: String,
    /// Project data to store in a PNG: none, the pages, or the pages and the original photos.
    #[arg(long, value_name = "WHAT", value_parser = ["none", "project", "photos"], default_value = "none")]
    pub(crate) embed: String,
    /// Write the panels below each other as pictures of 800 x 1280 pixels, for webtoon readers (pictures only).
    #[arg(long)]
    pub(crate) strip: bool,
    /// Also write the planned page as JSON, for --document. Several pages become an array.
    #[arg(long, value_name = "FILE")]
    pub(crate) save_document: Option<PathBuf>,
}

/// Options of pages and books: the paper, the photos and the style.
#[derive(clap::Args, Default, PartialEq)]
#[command(next_help_heading = "Planning (photos only)")]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate option")]
pub(crate) struct Chosen {
    #[command(flatten)]
    pub(crate) paper: Paper,
    /// Style id (see `inkpanel styles`) or style file.
    #[arg(long, value_name = "ID|FILE")]
    pub(crate) style: Option<String>,
    /// Use only styles of this family. Can be repeated.
    #[arg(long, value_name = "FAMILY", value_parser = PossibleValuesParser::new(inkpanel_engine::style::catalogue::FAMILIES), conflicts_with = "style")]
    pub(crate) style_family: Vec<String>,
    /// Random seed. [default: 1]
    #[arg(long)]
    pub(crate) seed: Option<u32>,
    // Not `default_value_t`, because options of a plan that equal their defaults count as not given.
    #[arg(long, alias = "alike", value_name = "BITS", help = format!("Maximum fingerprint distance of near-duplicates. Only the best of them is used. [default: {DUPLICATE_THRESHOLD}]"))]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=64))]
    pub(crate) duplicate_threshold: Option<u32>,
    /// Use all photos, including near-duplicates and blurred ones.
    #[arg(long)]
    pub(crate) keep_all: bool,
    /// Keep the order of the command line instead of the order of capture.
    #[arg(long)]
    pub(crate) as_given: bool,
    /// Skip face and object detection. Crops then follow contrast.
    #[arg(long)]
    pub(crate) no_detect: bool,
    /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
    /// Print the plan as JSON: layout, style, panels, crops and score.
    #[arg(long)]
    pub(crate) json: bool,
    /// Photo for the largest panel, by file name or path. Can be repeated.
    #[arg(long, value_name = "FILE")]
    pub(crate) star: Vec<PathBuf>,
}

impl Chosen {
    /// The options of pages with these settings.
    pub(crate) fn options(&self, run: &Run, page: PageSettings) -> Result<PageOptions, CliError> {
        let mut options = PageOptions::new().settings(page).style_families(&self.style_family);
        options = options.keep_all(self.keep_all).as_given(self.as_given);
        if let Some(style) = &self.style {
            options = options.style(&inkpanel::Style::new(read_style(run, style)?));
        }
        if let Some(seed) = self.seed {
            options = options.seed(seed);
        }
        if let Some(bits) = self.duplicate_threshold {
            options = options.duplicate_threshold(bits);
        }
        Ok(options)
    }
    /// Detects faces and subjects, if that is wanted, and marks the starred photos. Returns whether the models were
    /// available.
    pub(crate) fn prepare(&self, photos: &mut Photos<'_>) -> bool {
        let looked = !self.no_detect && photos.add_subjects(self.models.as_deref(), BY_CONTRAST);
        photos.star(&self.star);
        looked
    }
}
