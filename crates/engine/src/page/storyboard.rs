//! Pages of an album: selects the photos, and the number of pages.

use super::import::Imported;
use super::request::{Avoid, Request};
use super::shuffle::{Planned, planned};
use crate::error::Result;
use crate::framing::PhotoMeta;
use crate::plan::{Shelf, spread};
use crate::select::{self, DUPLICATE_THRESHOLD, Measures, Verdict};

/// Maximum number of photos per page. Larger pages do not show all of their photos.
const MOST_OF_A_PAGE: usize = 9;

/// Selection and order of the photos.
#[derive(Debug, Clone, Copy, Default)]
pub struct Choice {
    /// Maximum fingerprint distance of near-duplicates, in bits of 64. `None`: default.
    pub duplicate_threshold: Option<u32>,
    /// Whether near-duplicates and blurred photos are used as well.
    pub keep_all: bool,
    /// Whether to keep the given order instead of sorting by capture time.
    pub as_given: bool,
}

/// The photos that pages are made of, in their order, and the verdict on each that was given. `names` are the
/// names in the verdicts.
#[must_use]
pub fn chosen(names: &[&str], photos: &[&Imported], choice: Choice) -> (Vec<PhotoMeta>, Vec<Verdict>) {
    let measures: Vec<Measures> = photos.iter().map(|photo| photo.measures.clone()).collect();
    let duplicate_threshold = choice.duplicate_threshold.unwrap_or(DUPLICATE_THRESHOLD);
    let openness = photos.iter().map(|photo| photo.meta.openness()).collect();
    let settings = select::Settings { duplicate_threshold, openness, ..select::Settings::default() };
    let mut verdicts = select::choose(names, &measures, &settings);
    for verdict in &mut verdicts {
        verdict.kept |= choice.keep_all;
    }
    let kept = photos.iter().zip(&verdicts).filter(|(_, verdict)| verdict.kept);
    let mut used: Vec<PhotoMeta> = kept.map(|(photo, _)| photo.meta.clone()).collect();
    if !choice.as_given && used.iter().all(|meta| meta.taken.is_some()) {
        used.sort_by(|a, b| a.taken.cmp(&b.taken));
    }
    (used, verdicts)
}

/// Pages of an album in one style: one page of all photos, or several pages, split at changes of time or
/// scene.
///
/// # Errors
/// As [`planned`].
pub fn pages(request: &Request, count: Option<usize>) -> Result<Vec<Planned>> {
    let Some(count) = count else {
        return planned(request, &Shelf::new(request.photos.len())).map(|page| vec![page]);
    };
    let mut made: Vec<Planned> = Vec::new();
    let mut rest = &request.photos[..];
    for (number, size) in spread::into_pages(&request.photos, count).into_iter().enumerate() {
        let (own, later) = rest.split_at(size.min(rest.len()));
        rest = later;
        let shown = made.iter().rev().take(2).filter_map(|page| page.document.layout.built_in());
        let wanted = Request {
            seed: request.seed.wrapping_add(number as u32),
            photos: own.to_vec(),
            // Each photo once, as far as a page can hold them.
            panels: request.panels.or(Some(size).filter(|size| *size <= MOST_OF_A_PAGE)),
            style: made.first().map(|page| page.document.style.clone()).or_else(|| request.style.clone()),
            avoid: Avoid { layouts: shown.map(str::to_owned).collect(), styles: Vec::new() },
            ..request.clone()
        };
        made.push(planned(&wanted, &Shelf::new(size))?);
    }
    Ok(made)
}
