//! Styles from a picture, for the command line.

use inkpanel_engine::native;
use inkpanel_engine::style::Style;
use inkpanel_engine::style::imitate::{self, Ask, Search, Seen};
use rayon::prelude::*;
use serde_json::Value;
use std::path::PathBuf;

use crate::input::decode_file_fit;
use crate::run::Run;
use crate::{CliError, report};

/// Long side of the measured image. More pixels add no information about a screen pattern.
const SIDE: usize = 1600;

/// Styles that give a photo the look of a picture, as an array of style files with a score each. Prints
/// progress to standard error.
pub(crate) fn imitate(run: &Run, asked: &ImitateArgs) -> Result<Value, CliError> {
    let ImitateArgs { picture, photo, seed, anyway, .. } = asked;
    let read = if *anyway { imitate::read_any } else { imitate::read };
    let look = read(&decode_file_fit(run, picture, SIDE)?)
        .map_err(|error| CliError::from(error).at(picture.display()))?;
    let photo = decode_file_fit(run, photo, SIDE)?;
    let mut search = Search::new(look, *seed);
    loop {
        report::print(&format!("\rlooking for styles: {:3.0} %", search.progress(0) * 100.0));
        let asks = search.ask();
        if asks.is_empty() {
            break;
        }
        let seen = Seen::of(&photo, &asks[0]);
        // Failed attempts are skipped.
        let attempt = |ask: &Ask| imitate::attempt(&seen, &ask.style, &mut native::context(&ask.style)).ok();
        search.tell(asks.par_iter().map(attempt).collect());
    }
    report::print("\n");
    Ok(search.proposals().iter().map(Style::to_value).collect())
}

/// Arguments of `inkpanel imitate`.
#[derive(clap::Args)]
pub(crate) struct ImitateArgs {
    /// Picture to imitate: a comic page, a print or a painting.
    pub(crate) picture: PathBuf,
    /// Photo to stylise.
    pub(crate) photo: PathBuf,
    /// Print JSON: an array of style files, best first, each with a score from 0 to 1.
    #[arg(long)]
    pub(crate) json: bool,
    /// Accept a picture that is blank or looks like a plain photo.
    #[arg(long)]
    pub(crate) anyway: bool,
    /// Random seed of the search.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u32,
}
