//! Styles from a picture, for the command line.

use std::io::Write;
use std::path::Path;

use inkpanel::raster::Image;
use inkpanel::style::imitate::{self, Search, Trial};
use inkpanel::style::{Context, Style};
use rayon::prelude::*;
use serde_json::Value;

use crate::{Complaint, decode_file_fit};

/// Long side of what is measured: more shows no more of a screen.
const SIDE: usize = 1600;

/// Styles that give `photo` the look of `picture`, as an array of style files with a score each. Progress goes to standard
/// error.
pub(crate) fn imitate(picture: &Path, photo: &Path, seed: u32) -> Result<Value, Complaint> {
    let look = imitate::read(&decode_file_fit(picture, SIDE)?)
        .map_err(|error| format!("{}: {error}", picture.display()))?;
    let photo = decode_file_fit(photo, SIDE)?;
    let mut search = Search::new(look, seed);
    loop {
        eprint!("\rlooking for styles: {:3.0} %", search.progress() * 100.0);
        // Standard error that is gone is no reason to stop.
        let _ = std::io::stderr().flush();
        let asks = search.ask();
        if asks.is_empty() {
            break;
        }
        search.tell(asks.par_iter().map(|ask| attempt(&photo, ask)).collect());
    }
    eprintln!();
    Ok(search.proposals().iter().map(Style::to_value).collect())
}

/// What fails to draw is no candidate.
fn attempt(photo: &Image, ask: &imitate::Ask) -> Option<Trial> {
    imitate::attempt(photo, ask, &mut Context::default()).ok()
}
