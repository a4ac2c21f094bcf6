//! Pages of a project planned from its photos. A photo is on one page of a storyboard only: a page is planned from its own
//! photos and from those that no other page shows; where these are too few to fill it, from all.

use super::project::Project;
use super::sheets::photos_on;
use crate::error::Result;
use crate::framing::PhotoMeta;
use crate::page::Document;
use crate::page::document::template_of;
use crate::page::request::{Keep, Request};
use crate::page::shuffle;
use oorandom::Rand64;
use std::collections::HashSet;

/// A page of more panels than this is a page of stamps, unless a person asks for it.
const MOST_PANELS: usize = 9;

/// All parts of the page stay.
pub const KEEP_ALL: Keep = Keep { layout: true, style: true, photos: true };

/// A state of a project, and what is known of the photos in use.
#[derive(Debug, Clone, Copy)]
pub struct Planning<'p> {
    /// The state.
    pub project: &'p Project,
    /// The photos in use, in their order.
    pub photos: &'p [PhotoMeta],
}

/// Seeds one after the other, all of one.
#[derive(Debug, Clone)]
pub struct Seeds(Rand64);

impl Seeds {
    /// Those that follow from a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Rand64::new(u128::from(seed)))
    }

    /// Another one.
    pub fn next_seed(&mut self) -> u32 {
        self.0.rand_u64() as u32
    }
}

impl Planning<'_> {
    /// A request for the page of the project as it is, all of it kept.
    #[must_use]
    pub fn request(&self, seed: u32) -> Request {
        Request {
            seed,
            page: self.project.settings.as_ref().clone(),
            current: self.project.page.as_deref().cloned(),
            keep: KEEP_ALL,
            ..Request::default()
        }
    }

    /// A new page from the photos of the request, or, where it has none, from those in use that are free for it; none
    /// while there are none.
    ///
    /// # Errors
    /// Those of [`shuffle::plan`].
    pub fn plan(&self, mut request: Request) -> Result<Option<Document>> {
        if self.photos.is_empty() {
            return Ok(None);
        }
        let project = self.project;
        if !request.keep.layout && request.layout.is_none() && request.panels.is_none() {
            // A layout that is free has the number of panels that a person wants, or else a place for each locked photo.
            let locked = project.page.as_ref().filter(|_| project.locks.photos).map(|page| places_of(page));
            request.panels = project.panels.map(|panels| panels as usize).or(locked);
        }
        if request.photos.is_empty() {
            let elsewhere: Vec<&Document> = project.others.iter().map(|sheet| &*sheet.page).collect();
            cast(&mut request, self.photos, &elsewhere)?;
        }
        shuffle::plan(&request).map(Some)
    }

    /// The page after the photos in use changed: as it was where it can be. `grow`: there are more photos than before.
    ///
    /// # Errors
    /// Those of [`shuffle::plan`].
    pub fn refitted(&self, grow: bool, seed: u32) -> Result<Option<Document>> {
        let Project { page, locks, panels, others, .. } = self.project;
        if let Some(page) = page.as_ref().filter(|_| !others.is_empty()) {
            return self.refitted_among(page);
        }
        let enough = page.as_ref().is_some_and(|page| self.photos.len() >= page.panels.len());
        let wanted =
            panels.is_some_and(|count| page.as_ref().is_some_and(|page| page.panels.len() == count as usize));
        let layout = locks.layout || wanted || (enough && !grow);
        let mut request = self.request(seed);
        request.keep = Keep { layout, style: true, photos: locks.photos || !grow };
        // A photo that was just added is looked for on the page, so each gets a panel.
        if grow && !layout && panels.is_none() {
            request.panels = Some(self.photos.len().min(MOST_PANELS));
        }
        self.plan(request)
    }

    /// The same for a page among others: what is new goes to no page by itself, and a page loses but what is gone.
    fn refitted_among(&self, page: &Document) -> Result<Option<Document>> {
        let elsewhere: Vec<&Document> = self.project.others.iter().map(|sheet| &*sheet.page).collect();
        let free = photos_for(self.photos, &elsewhere, Some(page)).len();
        let layout = free == 0 || free >= places_of(page);
        let mut request = self.request(page.seed);
        request.keep.layout = layout;
        if !layout {
            request.panels = Some(free);
        }
        self.plan(request)
    }
}

/// The photos in use that are free for a page, in the same order; all where it is the only page.
#[must_use]
pub fn photos_for<'a>(
    all: &'a [PhotoMeta],
    elsewhere: &[&Document],
    current: Option<&Document>,
) -> Vec<&'a PhotoMeta> {
    if elsewhere.is_empty() {
        return all.iter().collect();
    }
    let taken = photos_on(elsewhere.iter().copied());
    let own = photos_on(current);
    all.iter().filter(|photo| own.contains(photo.id.as_str()) || !taken.contains(photo.id.as_str())).collect()
}

/// Tells a request which photos it has.
///
/// # Errors
/// `unknown-layout`, `invalid-layout`.
pub fn cast(request: &mut Request, all: &[PhotoMeta], elsewhere: &[&Document]) -> Result<()> {
    let photos = photos_for(all, elsewhere, request.current.as_ref());
    if elsewhere.is_empty() {
        request.photos = all.to_vec();
        return Ok(());
    }
    if photos.len() < needed(request)? {
        request.photos = all.to_vec();
        return Ok(());
    }
    let free = !request.keep.layout && request.layout.is_none() && request.panels.is_none();
    let own: HashSet<&str> = photos_on(request.current.as_ref());
    // Where no photo is left over, a page with fewer panels would leave some on no page: its photos keep their places.
    let panels = (free && photos.iter().all(|photo| own.contains(photo.id.as_str()))).then_some(photos.len());
    let photos = photos.into_iter().cloned().collect();
    request.panels = panels.or(request.panels);
    request.photos = photos;
    Ok(())
}

/// The photos that fill the page without repeats; one where its layout is still to be drawn.
fn needed(request: &Request) -> Result<usize> {
    Ok(match (&request.layout, request.panels, &request.current) {
        (Some(layout), ..) => template_of(layout)?.panels().len(),
        (None, Some(panels), _) => panels,
        (None, None, Some(current)) if request.keep.layout => places_of(current),
        _ => 1,
    })
}

/// The images on a page: merged panels share one.
#[must_use]
pub fn places_of(page: &Document) -> usize {
    page.merges.iter().fold(page.panels.len(), |places, group| places + 1 - group.len())
}
