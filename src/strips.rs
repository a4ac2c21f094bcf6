//! Vertical strips of the command line, for webtoon readers.

use crate::Complaint;
use crate::drawing::{Kind, Means, Subjects};
use inkpanel::output::strip::strip;
use inkpanel::page::Document;

/// Rejects `--strip` for other files than pictures.
pub(crate) fn check(strip: bool, kind: Kind) -> Result<(), Complaint> {
    if strip && !matches!(kind, Kind::Png | Kind::Jpeg | Kind::Webp) {
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
) -> Result<Vec<Document>, Complaint> {
    let complain = |error: inkpanel::Error| error.to_string();
    let letters = means.fonts.letters(pages.iter().flat_map(|page| &page.words)).map_err(complain)?;
    strip(pages, taken, |id| subjects(id).into(), &letters).map_err(complain)
}
