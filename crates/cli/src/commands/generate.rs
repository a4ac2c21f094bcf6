//! Invented styles for the command line, with scores where a photo is given.

use std::path::Path;
use std::path::PathBuf;

use inkpanel_engine::detect::Aesthetics;
use inkpanel_engine::native;
use inkpanel_engine::raster::Image;
use inkpanel_engine::style::{Style, aesthetic, procedural, stylize};
use rayon::prelude::*;
use serde_json::Value;

use crate::input::decode_file_fit;
use crate::run::Run;
use crate::{CliError, detectors};

/// Long side of the picture that is scored.
const SIDE: usize = 256;

/// Styles of successive seeds, as an array of style files. With a photo, each style has a score from 0 to 1:
/// from the model, or from simple measurements without a model.
pub(crate) fn invent(run: &Run, asked: &GenerateArgs) -> Result<Value, CliError> {
    let photo = asked.photo.as_deref().map(|path| decode_file_fit(run, path, SIDE)).transpose()?;
    let net = photo.as_ref().and_then(|_| judge(run, asked.models.as_deref()));
    let styles = (0..asked.count).into_par_iter().map(|i| {
        let mut style = procedural::invent(asked.seed.wrapping_add(i));
        style.score = photo.as_ref().map(|photo| score(photo, &style, net.as_ref()));
        style.to_value()
    });
    Ok(Value::Array(styles.collect()))
}

fn judge(run: &Run, models: Option<&Path>) -> Option<Aesthetics> {
    match detectors::load_aesthetics(models) {
        Ok(net) => Some(net),
        Err(complaint) => {
            run.report.note(None, &format!("{complaint}; the light score is given"));
            None
        }
    }
}

/// A style that cannot be drawn or scored gets 0.
fn score(photo: &Image, style: &Style, net: Option<&Aesthetics>) -> f64 {
    let Ok(drawn) = stylize(photo, style, &mut native::context_for(style, photo)) else { return 0.0 };
    let judgement = aesthetic::judge(photo, &drawn);
    let rank = |net: &Aesthetics| net.score(&drawn).map_or(0.0, |mean| aesthetic::rank(mean, &judgement));
    net.map_or(judgement.score, rank)
}

/// Arguments of `inkpanel generate`.
#[derive(clap::Args)]
pub(crate) struct GenerateArgs {
    /// Random seed of the first style. Each further style adds 1.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u32,
    /// Number of styles.
    #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) count: u32,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains aesthetics.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
    /// Photo to score each style on, from 0 to 1.
    pub(crate) photo: Option<PathBuf>,
}
