//! Pages of a project planned from its photos. A photo is on only one page of a storyboard. A page is planned
//! from its photos and the unplaced ones. If they do not fill it, all photos are used.

use super::following;
use super::history::History;
use super::project::{Order, Project};
use super::sheets::photos_on;
use crate::error::Result;
use crate::framing::PhotoMeta;
use crate::json::Writer;
use crate::layout::PageSettings;
use crate::page::Document;
use crate::page::request::{Keep, Request, Taste};
use crate::page::shuffle;
use crate::page::text_links::photo_of;
use crate::plan::prepared::{Place, is_document};
use crate::plan::{Shelf, turns};
use oorandom::Rand64;
use std::collections::HashSet;

/// Maximum number of panels of a page, unless the user requests more.
const MOST_PANELS: usize = 9;

/// A photo narrower than this part of the page's width in pixels is too coarse for any panel.
const SMALL: f64 = 0.1;

/// All parts of the page stay.
pub const KEEP_ALL: Keep = Keep { layout: true, style: true, photos: true };

/// A photo with cached results of plans.
#[derive(Debug, Clone, Copy)]
pub struct Known<'p> {
    /// Measurements of the photo.
    pub meta: &'p PhotoMeta,
    /// Cached results of earlier plans.
    pub place: Option<&'p Place>,
}

impl<'p> Known<'p> {
    /// Its id.
    #[must_use]
    pub fn id(&self) -> &'p str {
        &self.meta.id
    }
}

/// A state of a project, and the measurements of the photos in use.
#[derive(Debug, Clone)]
pub struct Planning<'p> {
    /// The state.
    pub project: &'p Project,
    /// The photos in use, in their order.
    pub photos: Vec<Known<'p>>,
    /// Learned preferences.
    pub taste: Taste,
    /// The photos of the pages shown so far, as [`Request::recent`] has them.
    pub recent: Vec<Vec<String>>,
}

/// Why no page has shown a photo yet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unseen {
    /// The photo is a page of text, such as a letter or a screenshot.
    Text,
    /// The photo has too few pixels for any panel.
    Small,
    /// It is chosen later.
    Waits,
}

impl Unseen {
    /// Its name in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Small => "small",
            Self::Waits => "waits",
        }
    }
}

/// Seeds one after the other, all of one.
#[derive(Debug, Clone)]
pub struct Seeds(Rand64);

impl Seeds {
    /// The sequence of seeds from a first seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Rand64::new(u128::from(seed)))
    }

    /// Another one.
    pub fn next_seed(&mut self) -> u32 {
        self.0.rand_u64() as u32
    }
}

impl<'p> Planning<'p> {
    /// Creates a plan context from photos without cached results.
    #[must_use]
    pub fn new(project: &'p Project, photos: &'p [PhotoMeta]) -> Self {
        let photos = photos.iter().map(|meta| Known { meta, place: None }).collect();
        Self { project, photos, taste: Taste::default(), recent: Vec::new() }
    }

    /// Adds the other pages of the storyboard and the earlier versions of the current page to the memory.
    #[must_use]
    pub fn with_memory(mut self, history: &History) -> Self {
        let others = self.project.pages.others().map(|sheet| &*sheet.page);
        let versions: Vec<&Document> = history.versions().map(|shown| &*shown.page).collect();
        let from = versions.len().saturating_sub(turns::PAGES);
        self.recent = others.chain(versions[from..].iter().copied()).map(seen_on).collect();
        self
    }

    /// The photos in use that no page has shown yet, and why.
    #[must_use]
    pub fn unseen(&self) -> Vec<(&'p str, Unseen)> {
        let seen: HashSet<&str> = self.recent.iter().flatten().map(String::as_str).collect();
        let width = self.project.settings.looked_at();
        let why = |photo: &Known| {
            if is_document(photo.meta) {
                Unseen::Text
            } else if f64::from(photo.meta.width) < SMALL * width {
                Unseen::Small
            } else {
                Unseen::Waits
            }
        };
        let unseen = self.photos.iter().filter(|photo| !seen.contains(photo.id()));
        unseen.map(|photo| (photo.id(), why(photo))).collect()
    }

    /// [`Planning::unseen`] as JSON: a list of `{photo, why}`.
    #[must_use]
    pub fn unseen_json(&self) -> String {
        let mut out = Writer::default();
        out.list(&self.unseen(), &|out, (photo, why)| {
            out.open(b'{');
            out.key("photo").text(photo);
            out.key("why").text(why.name());
            out.close(b'}');
        });
        out.finish()
    }

    /// A request for the current page, with everything locked.
    #[must_use]
    pub fn request(&self, seed: u32) -> Request {
        self.request_for(self.project.page().cloned(), KEEP_ALL, seed)
    }

    /// A request for a page, or for a new one, with the settings of the project.
    #[inline(never)]
    pub(super) fn request_for(&self, current: Option<Document>, keep: Keep, seed: u32) -> Request {
        Request {
            seed,
            page: self.project.settings.as_ref().clone(),
            current,
            keep,
            taste: self.taste.clone(),
            ..Request::default()
        }
    }

    /// Plans a new page from `photos`, or from the photos in use that are free for it. `None` without photos
    /// in use.
    ///
    /// # Errors
    /// Errors of [`shuffle::plan`].
    #[inline(never)]
    pub fn plan(&self, mut request: Request, photos: Option<Vec<Known>>) -> Result<Option<Document>> {
        if self.photos.is_empty() {
            return Ok(None);
        }
        let project = self.project;
        request.recent.splice(0..0, self.recent.iter().cloned());
        request.duplicate_threshold = Some(u32::from(project.alike));
        // The order of photos without dates has no meaning, unless they are sorted by name.
        if project.order == Order::Name {
            request.ordered = request.ordered.or(Some(true));
        }
        if !request.keep.layout && request.layout.is_none() && request.panels.is_none() {
            // Without a fixed layout, the page has the requested number of panels, or a panel for each locked
            // photo.
            let locked = project.page().filter(|_| project.locks.photos).map(places_of);
            request.panels = project.panels.map(|panels| panels as usize).or(locked);
        }
        let photos = match photos {
            Some(photos) => photos,
            None => self.cast(&mut request)?,
        };
        planned_of(request, &photos).map(|page| Some(following::gathered(project, page)))
    }

    /// Returns the page after the photos in use changed, with as few changes as possible. `grow`: there are
    /// more photos than before.
    ///
    /// # Errors
    /// Errors of [`shuffle::plan`].
    pub fn refitted(&self, grow: bool, seed: u32) -> Result<Option<Document>> {
        let Project { locks, panels, .. } = self.project;
        let page = self.project.page();
        if let Some(page) = page.filter(|_| self.project.has_several_pages()) {
            return self.refitted_among(page);
        }
        let enough = page.is_some_and(|page| self.photos.len() >= page.panels.len());
        let wanted = panels.is_some_and(|count| page.is_some_and(|page| page.panels.len() == count as usize));
        let layout = locks.layout || wanted || (enough && !grow);
        let mut request = self.request(seed);
        request.keep = Keep { layout, style: true, photos: locks.photos || !grow };
        // Users expect to see a new photo on the page, so each gets a panel.
        if grow && !layout && panels.is_none() {
            request.panels = Some(self.photos.len().min(MOST_PANELS));
        }
        self.plan(request, None)
    }

    /// Same for one page of several: never adds new photos, removes only deleted ones.
    fn refitted_among(&self, page: &Document) -> Result<Option<Document>> {
        let free = self.free(&self.elsewhere(), Some(page)).len();
        let layout = free == 0 || free >= places_of(page);
        let mut request = self.request(page.seed);
        request.keep.layout = layout;
        request.panels = (!layout).then_some(free);
        self.plan(request, None)
    }

    /// Returns a page of the project with other paper.
    ///
    /// # Errors
    /// Errors of [`shuffle::plan`].
    pub fn on_paper(&self, page: &Document, settings: &PageSettings) -> Result<Document> {
        let was = &page.page;
        let resized = u64::from(settings.width) * u64::from(was.height)
            != u64::from(settings.height) * u64::from(was.width);
        // Another aspect may not suit the layout; the planner then takes one that does, unless it is locked.
        let layout = !resized || self.project.locks.layout || suits(page, settings)?;
        let shown = photos_on(&[page]);
        let own: Vec<Known> =
            self.photos.iter().filter(|photo| shown.contains(photo.id())).copied().collect();
        // The photos of a page among others stay on it, whatever layout it gets.
        let own = (self.project.has_several_pages() && !own.is_empty()).then_some(own);
        let count = own.as_ref().map_or_else(|| places_of(page), Vec::len);
        let planned = |layout: bool| {
            let mut request = self.request_for(Some(page.clone()), Keep { layout, ..KEEP_ALL }, page.seed);
            request.page = settings.clone();
            // As many panels as there were, or a page would lose photos by a change of its paper.
            request.panels = (!layout).then_some(count);
            self.plan(request, own.clone())
        };
        let found = planned(layout)?;
        // If no layout of that aspect ratio has enough panels, the present one is better than losing a photo.
        let found = match found {
            Some(other) if !layout && places_of(&other) < count => planned(true)?,
            found => found,
        };
        Ok(found.unwrap_or_else(|| Document { page: settings.clone(), ..page.clone() }))
    }

    /// Returns a page of the page history on the current paper of the storyboard. Other photos replace photos
    /// that are no longer in use. In a project of one page, the old paper is restored.
    ///
    /// # Errors
    /// Errors of [`shuffle::plan`].
    pub fn brought_back(&self, page: &Document) -> Result<Document> {
        let table: HashSet<&str> = self.project.tray.iter().map(|item| item.id.as_str()).collect();
        let there = |photo: &Option<String>| photo.as_deref().is_some_and(|photo| table.contains(photo));
        let mut page = page.clone();
        if !page.panels.iter().all(|panel| there(&panel.photo)) {
            let request = self.request_for(Some(page.clone()), KEEP_ALL, page.seed);
            page = self.plan(request, None)?.unwrap_or(page);
        }
        let settings = &*self.project.settings;
        if !self.project.has_several_pages() || page.page == *settings {
            return Ok(page);
        }
        self.on_paper(&page, settings)
    }

    /// The photos in use that are free for a page, in the same order. For the only page, all photos in use.
    #[must_use]
    #[inline(never)]
    pub fn free(&self, elsewhere: &[&Document], current: Option<&Document>) -> Vec<Known<'p>> {
        if elsewhere.is_empty() {
            return self.photos.clone();
        }
        let mut taken = photos_on(elsewhere);
        for own in current.iter().flat_map(|page| &page.panels).filter_map(|panel| panel.photo.as_deref()) {
            taken.remove(own);
        }
        self.photos.iter().filter(|photo| !taken.contains(photo.id())).copied().collect()
    }

    /// All pages except the current one.
    #[must_use]
    pub fn elsewhere(&self) -> Vec<&'p Document> {
        self.project.pages.others().map(|sheet| &*sheet.page).collect()
    }

    /// Returns the photos of a page. If no photo is left over, sets the number of panels too.
    fn cast(&self, request: &mut Request) -> Result<Vec<Known<'p>>> {
        let elsewhere = self.elsewhere();
        let photos = self.free(&elsewhere, request.current.as_ref());
        if elsewhere.is_empty() || photos.len() < needed(request)? {
            return Ok(self.photos.clone());
        }
        let free = !request.keep.layout && request.layout.is_none() && request.panels.is_none();
        let own = photos_on(request.current.as_ref().as_slice());
        // Without spare photos, fewer panels would leave photos on no page. All photos keep their places.
        if free && photos.iter().all(|photo| own.contains(photo.id())) {
            request.panels = Some(photos.len());
        }
        Ok(photos)
    }
}

/// Plans a request with these photos.
///
/// # Errors
/// Errors of [`shuffle::plan`].
#[inline(never)]
pub fn planned_of(mut request: Request, photos: &[Known]) -> Result<Document> {
    // Photos with text items stay with them.
    let spoken = request.current.as_ref().map(spoken_on).unwrap_or_default();
    let meta = |photo: &Known| PhotoMeta { spoken: spoken.contains(photo.id()), ..photo.meta.clone() };
    request.photos = photos.iter().map(meta).collect();
    let shelf = Shelf::of(photos.iter().map(|photo| photo.place.cloned().unwrap_or_default()).collect());
    shuffle::planned(&request, &shelf).map(|planned| planned.document)
}

/// Returns the photos of a page. The photo of the largest panel is first.
#[must_use]
pub fn seen_on(page: &Document) -> Vec<String> {
    let shares = page.template().map_or_else(|_| Vec::new(), |template| template.shares(page.page.aspect()));
    let share = |at: usize| shares.get(at).copied().unwrap_or(0.0);
    let largest = (0..page.panels.len()).fold(0, |most, at| if share(at) > share(most) { at } else { most });
    let mut seen: Vec<String> = Vec::new();
    for panel in page.panels.get(largest).into_iter().chain(&page.panels) {
        seen.extend(panel.photo.iter().filter(|photo| !seen.contains(photo)).cloned().collect::<Vec<_>>());
    }
    seen
}

/// Returns the photos with text items on a page.
fn spoken_on(page: &Document) -> HashSet<String> {
    page.words.iter().filter_map(|word| photo_of(word, &page.panels)).map(str::to_owned).collect()
}

/// Returns whether the layout suits the new paper as well as the old one.
fn suits(page: &Document, settings: &PageSettings) -> Result<bool> {
    let template = page.template()?;
    Ok(template.good_for(settings.aspect()) || !template.good_for(page.page.aspect()))
}

/// The photos that fill the page without repeats; one where its layout is still to be drawn.
fn needed(request: &Request) -> Result<usize> {
    Ok(match (&request.layout, request.panels, &request.current) {
        (Some(layout), ..) => layout.template()?.panels().len(),
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
