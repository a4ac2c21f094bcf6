//! Twenty-four shuffles of ten albums: how often each photo appears, and how varied the pages are.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use inkpanel_engine::document::planning::seen_on;
use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::page::request::{Avoid, Request};
use inkpanel_engine::page::shuffle::planned;
use inkpanel_engine::plan::Shelf;
use inkpanel_engine::plan::prepared::is_document;
use rayon::prelude::*;

use crate::bars::most_frequent;
use crate::{Failure, Photo, page};

const ALBUMS: u32 = 10;
const SHUFFLES: usize = 24;
/// Each photo should appear within this number of shuffles.
const ALL_SEEN: usize = 12;

/// Results of the shuffles of one album.
struct Shown {
    /// For each photo, without pages of text: the number of pages that show it.
    uses: Vec<usize>,
    /// Photos that did not appear in the first [`ALL_SEEN`] shuffles.
    late: usize,
    /// Family of the layout, and style, of each page.
    pages: Vec<(String, String)>,
}

/// Rows of the table.
pub(crate) fn rows(photos: &[Photo]) -> Result<String, Failure> {
    let albums = (1..=ALBUMS).into_par_iter().map(|number| shuffled(photos, number));
    let albums = albums.collect::<Result<Vec<Shown>, Failure>>()?;
    let mut uses: Vec<usize> = albums.iter().flat_map(|album| album.uses.iter().copied()).collect();
    uses.sort_unstable();
    let late: usize = albums.iter().map(|album| album.late).sum();
    let pages = || albums.iter().flat_map(|album| &album.pages);
    let styles: BTreeSet<&str> = pages().map(|(_, style)| style.as_str()).collect();
    let mut text = String::new();
    let mut row = |name: &str, value: String, goal: &str| {
        let _ = writeln!(text, "| {name} | {value} | {goal} |");
    };
    let at = |percent: usize| uses.get(uses.len().saturating_sub(1) * percent / 100).copied().unwrap_or(0);
    row(
        "pages per photo in 24 shuffles of ten albums: fewest, median, most",
        format!("{}, {}, {}", at(0), at(50), at(100)),
        "",
    );
    row("photos that twelve shuffles did not show", format!("{late} of {}", uses.len()), "0");
    row(
        "shuffles of the most frequent family",
        most_frequent(pages().map(|(family, _)| family.as_str())),
        "",
    );
    row("styles of these shuffles", styles.len().to_string(), "");
    Ok(text)
}

/// Shuffles one album as the app does: each page knows the earlier pages.
fn shuffled(photos: &[Photo], number: u32) -> Result<Shown, Failure> {
    let (first, album) = page(photos, number)?;
    let shelf = Shelf::new(album.len());
    let mut current = first.document;
    let mut recent = vec![seen_on(&current)];
    let mut pages = Vec::new();
    for turn in 0..SHUFFLES {
        let id = |name: Option<&str>| name.map(str::to_owned).into_iter().collect();
        let avoid = Avoid { layouts: id(current.layout.built_in()), styles: id(current.style.built_in()) };
        let request = Request {
            seed: 1000 * number + turn as u32,
            photos: album.clone(),
            page: current.page.clone(),
            current: Some(current),
            recent: recent.clone(),
            avoid,
            ..Request::default()
        };
        current = planned(&request, &shelf)?.document;
        recent.push(seen_on(&current));
        let style = current.style.built_in().unwrap_or("own").to_owned();
        pages.push((current.layout.template()?.family().to_owned(), style));
    }
    let wanted = album.iter().filter(|photo| !is_document(photo));
    let uses = |photo: &PhotoMeta, pages: &[Vec<String>]| {
        pages.iter().filter(|page| page.contains(&photo.id)).count()
    };
    Ok(Shown {
        uses: wanted.clone().map(|photo| uses(photo, &recent[1..])).collect(),
        late: wanted.filter(|photo| uses(photo, &recent[1..=ALL_SEEN]) == 0).count(),
        pages,
    })
}
