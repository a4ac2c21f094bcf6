//! Vertical strips of the command line, for webtoon readers.

use crate::CliError;
use crate::drawing::{Means, Subjects};
use crate::format::Format;
use inkpanel_engine::output::strip::strip;
use inkpanel_engine::page::Document;

/// Rejects `--strip` for other files than pictures.
pub(crate) fn check(strip: bool, kind: Format) -> Result<(), CliError> {
    if strip && !matches!(kind, Format::Png | Format::Jpeg | Format::Webp) {
        return Err("--strip writes pictures; name the output strip-%03d.png, .jpg or .webp".into());
    }
    Ok(())
}

/// Pages as the pages of a strip. `taken` returns the capture time of a photo, if it is known.
pub(crate) fn pages(
    pages: &[Document],
    means: &Means<'_>,
    taken: &dyn Fn(&str) -> Option<String>,
    subjects: &Subjects<'_>,
) -> Result<Vec<Document>, CliError> {
    let letters = means.fonts.letters(pages.iter().flat_map(|page| &page.words))?;
    Ok(strip(pages, taken, |id| subjects(id).into(), &letters)?)
}
