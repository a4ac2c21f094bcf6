//! Carries out intents: plans the page or the pages that an intent asks for.

use super::history::History;
use super::intent::{CropChange, Draw, Intent, Shuffled};
use super::planning::{KEEP_ALL, Known, Planning, Seeds};
use super::project::Sheet;
use super::sheets::photos_on;
use super::validation;
use crate::error::Result;
use crate::framing::Crop;
use crate::layout::LayoutChange;
use crate::layout::join::join_panels;
use crate::layout::merge::{Obstacle, merged_bounds, why_not_merge};
use crate::layout::{PageSettings, enlarged, resolve};
use crate::page::document::PanelContent;
use crate::page::request::{Keep, Mode, Request};
use crate::page::{Document, LayoutRef, StyleRef, breaking};
use serde::Serialize;
use serde_json::Map;
use std::sync::Arc;

/// Number of seeds that are tried for another arrangement of photos. A single photo has only one arrangement.
const MOST_TRIES: usize = 5;

/// The result of an intent.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// The current page changes.
    Changed(Document),
    /// A new page replaces the current page.
    Shown(Document),
    /// Pages of the storyboard change: all pages in order, and the index of the current page.
    Sheets(Vec<Arc<Sheet>>, usize),
    /// The page settings change, and with them some pages, each with its index in the storyboard.
    Paper(PageSettings, Vec<(usize, Document)>),
    /// The page is removed.
    NoPage,
    /// Another page becomes the current page, without an undo step. A version of the page history then
    /// replaces it, unless the page is this version already.
    Version {
        /// The version in its current form.
        page: Option<Arc<Document>>,
        /// Its id.
        page_id: u64,
        /// Index of its place in the storyboard.
        at: usize,
    },
}

impl Planning<'_> {
    /// Plans the result of an intent. `None` if the intent is impossible, or if nothing changes. `history`: of
    /// the project.
    ///
    /// # Errors
    /// Errors of the planner, and of a layout that does not allow the change.
    #[allow(clippy::too_many_lines, reason = "an arm for each intent")]
    pub fn carry_out(&self, intent: &Intent, history: &History) -> Result<Option<Outcome>> {
        match intent {
            Intent::SetPaper { settings, held, .. } => return self.with_paper(settings, *held),
            Intent::Refit { grow, draw } => {
                let before = self.project.page();
                return Ok(match self.refitted(*grow, draw.seed)? {
                    None => before.map(|_| Outcome::NoPage),
                    Some(next) => (before != Some(&next)).then_some(Outcome::Shown(next)),
                });
            }
            Intent::RestoreVersion { page_id, .. } => return self.restored(*page_id, history),
            _ => {}
        }
        let Some(page) = self.project.page() else { return Ok(None) };
        match intent {
            Intent::CropPanel { panel, crop } => self.cropped(page, *panel, crop),
            Intent::SwapPanels { panel, with } => {
                let (one, other) = (grown(page, &[*panel]), grown(page, &[*with]));
                if !is_free(page, *panel) || !is_free(page, *with) || one == other {
                    return Ok(None);
                }
                let photo = |of: &[usize]| page.panels[of[0]].photo.as_deref();
                let mut next = page.clone();
                show(&mut next, &one, photo(&other));
                show(&mut next, &other, photo(&one));
                self.amended(next)
            }
            Intent::PlacePhoto { panel, photo } => {
                let group = grown(page, &[*panel]);
                let shown = page.panels.get(group[0]).and_then(|content| content.photo.as_ref());
                if !is_free(page, *panel) || shown == Some(photo) {
                    return Ok(None);
                }
                let mut next = page.clone();
                show(&mut next, &group, Some(photo));
                self.amended(next)
            }
            Intent::LockPanel { panel, on } => self.changed(page, *panel, &|content| content.locked = *on),
            Intent::BreakFrame { panel, mask } => {
                if !is_free(page, *panel) {
                    return Ok(None);
                }
                let next = if let Some(mask) = mask {
                    breaking::broken(page, *panel, mask)?
                } else {
                    let mut next = page.clone();
                    next.panels[*panel].figure = None;
                    Some(next)
                };
                Ok(next.map(Outcome::Changed))
            }
            Intent::MergePanels { panels } => {
                if obstacles(page, panels)?.merge.is_some() {
                    return Ok(None);
                }
                let group = grown(page, panels);
                let mut next = page.clone();
                next.merges.retain(|other| !other.iter().any(|panel| group.contains(panel)));
                next.merges.push(group);
                self.amended(next)
            }
            Intent::SplitPanels { panels } => self.amended_if(split(page, panels)),
            Intent::Reshape { change } => self.reshaped(page, change),
            Intent::EnlargePanel { panel } => {
                if self.project.locks.layout || !is_free(page, *panel) {
                    return Ok(None);
                }
                let locked: Vec<bool> = page.panels.iter().map(|content| content.locked).collect();
                let layout = enlarged(&*page.template()?, &page.page, &grown(page, &[*panel]), &locked)?;
                self.amended_if(
                    layout.map(|layout| Document { layout: LayoutRef::of(&layout), ..page.clone() }),
                )
            }
            Intent::Recrop { sheet } => self.recropped_sheet(sheet.unwrap_or(self.project.sheet())),
            Intent::RecropPhoto { photo, everywhere } => self.recropped_photo(photo, *everywhere),
            Intent::Shuffle { part, draw } => self.shuffled(page, *part, draw),
            Intent::FitLayout { draw } => {
                self.shown(self.drawn(page, Keep { layout: false, ..KEEP_ALL }, draw))
            }
            Intent::ChooseLayout { layout, seed } => {
                let request = self.request_for(Some(page.clone()), KEEP_ALL, *seed);
                self.shown(Request { layout: Some(layout.clone()), ..request })
            }
            Intent::ChooseStyle { style, seed } => {
                let request = self.request_for(Some(page.clone()), KEEP_ALL, *seed);
                self.shown(Request { style: Some(style.clone()), ..request })
            }
            Intent::Restyle { style } => self.amended(Document { style: style.clone(), ..page.clone() }),
            Intent::SortPhotos => {
                if self.project.locks.photos {
                    return Ok(None);
                }
                Ok(self.replanned(self.sorted(page), None)?.map(Outcome::Shown))
            }
            Intent::UseDuplicate { photo, alike } => {
                Ok(self.replanned(with_duplicate(page, photo, alike), None)?.map(Outcome::Shown))
            }
            Intent::Compose { photos, panels, layout, style, surprise, draw } => {
                let own: Vec<Known> = photos
                    .iter()
                    .filter_map(|id| self.photos.iter().find(|photo| photo.id() == id).copied())
                    .collect();
                let request = Request {
                    current: None,
                    panels: Some(*panels),
                    layout: layout.clone(),
                    style: style.clone(),
                    surprise: *surprise,
                    ..self.drawn(page, Keep::default(), draw)
                };
                Ok(self.plan(request, Some(own))?.map(Outcome::Shown))
            }
            Intent::AddPage { draw } => {
                let Some(page) = self.another(&mut Seeds::new(u64::from(draw.seed)))? else {
                    return Ok(None);
                };
                let (page_id, sheet) = history.fresh();
                let at = self.project.pages.active() + 1;
                let mut sheets = self.project.sheets().to_vec();
                let rest = Map::new();
                sheets.insert(at, Arc::new(Sheet { page: Arc::new(page), page_id, sheet, rest }));
                Ok(Some(Outcome::Sheets(sheets, at)))
            }
            Intent::RemovePage => {
                let (mut sheets, at) = (self.project.sheets().to_vec(), self.project.pages.active());
                if sheets.len() < 2 {
                    return Ok(None);
                }
                sheets.remove(at);
                let last = sheets.len() - 1;
                Ok(Some(Outcome::Sheets(sheets, at.min(last))))
            }
            Intent::MovePage { from, to } => {
                let mut sheets = self.project.sheets().to_vec();
                if from == to || *from >= sheets.len() || *to >= sheets.len() {
                    return Ok(None);
                }
                let moved = sheets.remove(*from);
                sheets.insert(*to, moved);
                let at = sheets.iter().position(|sheet| sheet.sheet == self.project.sheet());
                Ok(at.map(|at| Outcome::Sheets(sheets, at)))
            }
            Intent::GoToPage { at } => {
                let sheets = self.project.sheets();
                Ok((*at != self.project.pages.active() && *at < sheets.len())
                    .then(|| Outcome::Sheets(sheets.to_vec(), *at)))
            }
            Intent::SpreadAlbum { draw } => {
                if self.project.locks.photos {
                    return Ok(None);
                }
                let spread = self.spread(history.fresh(), &mut Seeds::new(u64::from(draw.seed)))?;
                let spread = spread.filter(|sheets| !sheets.is_empty());
                Ok(spread.map(|sheets| Outcome::Sheets(sheets, 0)))
            }
            Intent::StylePages => Ok(self.styled(&page.style, history.fresh().0)),
            Intent::RepairPages { groups, .. } => {
                Ok(self.repaired(groups)?.map(|(sheets, at)| Outcome::Sheets(sheets, at)))
            }
            Intent::SetPaper { .. }
            | Intent::Refit { .. }
            | Intent::RestoreVersion { .. }
            | Intent::Unknown => Ok(None),
        }
    }

    /// Plans a manually changed page: all its parts stay, and empty panels get photos.
    fn replanned(&self, page: Document, photos: Option<Vec<Known>>) -> Result<Option<Document>> {
        let seed = page.seed;
        self.plan(self.request_for(Some(page), KEEP_ALL, seed), photos)
    }

    /// A request for a page with random parts.
    fn drawn(&self, page: &Document, keep: Keep, draw: &Draw) -> Request {
        Request { styling: draw.styling.clone(), ..self.request_for(Some(page.clone()), keep, draw.seed) }
    }

    fn shown(&self, request: Request) -> Result<Option<Outcome>> {
        Ok(self.plan(request, None)?.map(Outcome::Shown))
    }

    fn shuffled(&self, page: &Document, part: Shuffled, draw: &Draw) -> Result<Option<Outcome>> {
        let locks = &self.project.locks;
        let keep = match part {
            // A locked panel does not move.
            Shuffled::All => {
                let layout = locks.layout || page.panels.iter().any(|content| content.locked);
                Keep { layout, style: locks.style, photos: locks.photos }
            }
            Shuffled::Layout if !locks.layout => Keep { layout: false, ..KEEP_ALL },
            Shuffled::Style if !locks.style => Keep { style: false, ..KEEP_ALL },
            Shuffled::Photos if !locks.photos => return self.other_photos(page, draw),
            _ => return Ok(None),
        };
        self.shown(self.drawn(page, keep, draw))
    }

    /// Avoids the previous arrangement of photos, which would not look like a shuffle.
    fn other_photos(&self, page: &Document, draw: &Draw) -> Result<Option<Outcome>> {
        let places = |page: &Document| -> Vec<Option<String>> {
            page.panels.iter().map(|content| content.photo.clone()).collect()
        };
        let mut seeds = Seeds::new(u64::from(draw.seed));
        let mut seed = draw.seed;
        let mut next = None;
        for _ in 0..MOST_TRIES {
            let request = self.drawn(page, Keep { photos: false, ..KEEP_ALL }, draw);
            next = self.plan(Request { seed, mode: Mode::Photos, ..request }, None)?;
            if next.as_ref().is_none_or(|next| places(next) != places(page)) {
                break;
            }
            seed = seeds.next_seed();
        }
        Ok(next.map(Outcome::Shown))
    }

    fn with_paper(&self, settings: &PageSettings, held: bool) -> Result<Option<Outcome>> {
        settings.validate()?;
        let Some(page) = self.project.page() else {
            return Ok(Some(Outcome::Paper(settings.clone(), Vec::new())));
        };
        let mut pages = Vec::new();
        if held && self.project.has_several_pages() {
            let own = self.own_photos(page);
            let mut request = self.request_for(Some(page.clone()), KEEP_ALL, page.seed);
            request.page = settings.clone();
            let Some(next) = self.plan(request, (!own.is_empty()).then_some(own))? else { return Ok(None) };
            pages.push((self.project.pages.active(), next));
        } else {
            for (at, sheet) in self.project.sheets().iter().enumerate() {
                pages.push((at, self.on_paper(&sheet.page, settings)?));
            }
        }
        Ok(Some(Outcome::Paper(settings.clone(), pages)))
    }

    /// The page with its photos in the order of the photos in use. Locked panels stay.
    fn sorted(&self, page: &Document) -> Document {
        let rank = |id: &str| self.photos.iter().position(|photo| photo.id() == id);
        // Empty panels are last, and photos that are not in use are first.
        let key =
            |id: &Option<String>| id.as_deref().map_or((2, 0), |id| rank(id).map_or((0, 0), |at| (1, at)));
        let leader = |at: usize| page.merge_of(at).map_or(at, |group| group[0]);
        let free: Vec<usize> =
            (0..page.panels.len()).filter(|&at| leader(at) == at && !page.panels[at].locked).collect();
        let mut photos: Vec<Option<String>> = free.iter().map(|&at| page.panels[at].photo.clone()).collect();
        photos.sort_by_key(key);
        let mut next = page.clone();
        for at in 0..page.panels.len() {
            let place = free.iter().position(|&other| other == leader(at));
            if let Some(photo) =
                place.map(|place| &photos[place]).filter(|photo| **photo != page.panels[at].photo)
            {
                show(&mut next, &[at], photo.as_deref());
            }
        }
        next.order.sort_by_key(|id| rank(id).map_or((0, 0), |at| (1, at)));
        next
    }

    fn amended(&self, page: Document) -> Result<Option<Outcome>> {
        Ok(self.replanned(page, None)?.map(Outcome::Changed))
    }

    fn amended_if(&self, page: Option<Document>) -> Result<Option<Outcome>> {
        page.map_or(Ok(None), |page| self.amended(page))
    }

    /// The pages, all in one style. Changed pages get new ids from `fresh` on.
    fn styled(&self, style: &StyleRef, fresh: u64) -> Option<Outcome> {
        let mut sheets = self.project.sheets().to_vec();
        let mut changed = false;
        for (i, sheet) in sheets.iter_mut().enumerate().filter(|(_, sheet)| sheet.page.style != *style) {
            let page = Document { style: style.clone(), ..Document::clone(&sheet.page) };
            let page_id = fresh + i as u64;
            *sheet = Arc::new(Sheet { page: Arc::new(page), page_id, ..Sheet::clone(sheet) });
            changed = true;
        }
        changed.then_some(Outcome::Sheets(sheets, self.project.pages.active()))
    }

    /// An earlier version in its current form, in its place.
    fn restored(&self, page_id: u64, history: &History) -> Result<Option<Outcome>> {
        let Some(version) = history.shown.iter().find(|shown| shown.id == page_id) else { return Ok(None) };
        let sheets = self.project.sheets();
        let own = |sheet: &Arc<Sheet>| sheet.page_id == page_id || sheet.sheet == version.sheet;
        let at = sheets.iter().position(own).unwrap_or(self.project.pages.active());
        let shows = sheets.get(at).is_some_and(|sheet| sheet.page_id == page_id);
        let page = if shows {
            None
        } else {
            let back = self.brought_back(&version.page)?;
            // A version that needs no changes stays the same object, so its drawing can be reused.
            let same = back == *version.page;
            Some(if same { version.page.clone() } else { validation::planned(back)? })
        };
        Ok(Some(Outcome::Version { page, page_id, at }))
    }

    /// The page with a change of all panels that share an image.
    fn changed(
        &self,
        page: &Document,
        panel: usize,
        change: &dyn Fn(&mut PanelContent),
    ) -> Result<Option<Outcome>> {
        if panel >= page.panels.len() {
            return Ok(None);
        }
        let mut next = page.clone();
        for at in grown(page, &[panel]) {
            change(&mut next.panels[at]);
        }
        self.amended(next)
    }

    fn cropped(&self, page: &Document, panel: usize, change: &CropChange) -> Result<Option<Outcome>> {
        if !is_free(page, panel) {
            return Ok(None);
        }
        let group = grown(page, &[panel]);
        let content = &page.panels[group[0]];
        let (Some(photo), Some(now)) = (&content.photo, content.crop) else { return Ok(None) };
        let crop = match change {
            CropChange::Pan { from, x, y } => Some(from.unwrap_or(now).panned((*x, *y))),
            CropChange::Zoom { from, factor, at } => {
                let [u, v] = at.unwrap_or([0.5, 0.5]);
                Some(from.unwrap_or(now).zoomed(*factor, (u, v)))
            }
            CropChange::Fit => self.fitted(page, &group, photo)?,
            CropChange::Reset => None,
        };
        let Some(crop) = crop else {
            return self.changed(page, panel, &|content| (content.crop, content.edited) = (None, false));
        };
        // Each tick of a drag comes here, and nothing else of the page changes. So it is not planned again.
        let mut next = page.clone();
        for at in group {
            (next.panels[at].crop, next.panels[at].edited) = (Some(crop), true);
        }
        Ok(Some(Outcome::Changed(next)))
    }

    /// Returns the crop that shows the subject of a photo large. `None` if no subject is known.
    fn fitted(&self, page: &Document, group: &[usize], photo: &str) -> Result<Option<Crop>> {
        let panels = resolve(&*page.template()?, page.page.aspect(), &page.page);
        let Some(bounds) = merged_bounds(&panels, group) else { return Ok(None) };
        let known = self.photos.iter().find(|known| known.id() == photo);
        Ok(known.and_then(|known| known.meta.subject_crop(bounds.width / bounds.height)))
    }

    fn reshaped(&self, page: &Document, change: &LayoutChange) -> Result<Option<Outcome>> {
        let mut next = page.clone();
        let mut wanted = change.clone();
        match &mut wanted {
            LayoutChange::Split { panel, .. } if *panel < page.panels.len() => {
                next = spliced(page, *panel, true);
            }
            LayoutChange::Remove { panel } if *panel < page.panels.len() => {
                next = spliced(page, *panel, false);
            }
            // The contents stay. The layout rejects a panel that does not exist.
            LayoutChange::MoveCut { .. }
            | LayoutChange::MoveInset { .. }
            | LayoutChange::Split { .. }
            | LayoutChange::Remove { .. } => {}
            LayoutChange::Join { panels } => {
                *panels = grown(page, panels);
                if panels.iter().any(|panel| *panel >= page.panels.len()) {
                    return Ok(None);
                }
                next = joined(page, panels);
            }
        }
        next.layout = LayoutRef::of(&wanted.of(&*page.template()?, &page.page)?);
        self.amended(next)
    }

    /// Plans the crops of a page again. The panel of a missing photo stays, because the measurements of its
    /// placeholder are not the measurements of the photo.
    fn recropped(&self, page: &Document, photos: Option<Vec<Known>>) -> Result<Option<Document>> {
        let Some(mut better) = self.replanned(page.clone(), photos)? else { return Ok(None) };
        for (panel, before) in better.panels.iter_mut().zip(&page.panels) {
            let absent = |photo: &String| self.photos.iter().any(|k| k.id() == photo && k.meta.absent);
            if panel.photo == before.photo && panel.photo.as_ref().is_some_and(absent) {
                *panel = before.clone();
            }
        }
        Ok(Some(better))
    }

    fn recropped_sheet(&self, place: u64) -> Result<Option<Outcome>> {
        let mut sheets = self.project.sheets().to_vec();
        let Some(at) = sheets.iter().position(|sheet| sheet.sheet == place) else { return Ok(None) };
        let page = &*sheets[at].page;
        let own = (at != self.project.pages.active()).then(|| self.own_photos(page));
        let Some(better) = self.recropped(page, own)?.filter(|better| better != page) else {
            return Ok(None);
        };
        if at == self.project.pages.active() {
            return Ok(Some(Outcome::Changed(better)));
        }
        sheets[at] = Arc::new(Sheet { page: Arc::new(better), ..Sheet::clone(&sheets[at]) });
        Ok(Some(Outcome::Sheets(sheets, self.project.pages.active())))
    }

    fn recropped_photo(&self, photo: &str, everywhere: bool) -> Result<Option<Outcome>> {
        let mut sheets = self.project.sheets().to_vec();
        let mut found = false;
        for (at, sheet) in sheets.iter_mut().enumerate() {
            let edited = at == self.project.pages.active();
            if !(edited || everywhere) || !photos_on(&[&sheet.page]).contains(photo) {
                continue;
            }
            let mut next = Document::clone(&sheet.page);
            for content in &mut next.panels {
                if content.photo.as_deref() == Some(photo) && (everywhere || !content.locked) {
                    (content.crop, content.edited) = (None, false);
                }
            }
            // The photos of another page stay on it.
            let own = (!edited).then(|| self.own_photos(&next));
            if let Some(page) = self.replanned(next, own)? {
                *sheet = Arc::new(Sheet { page: Arc::new(page), ..Sheet::clone(sheet) });
                found = true;
            }
        }
        Ok(found.then_some(Outcome::Sheets(sheets, self.project.pages.active())))
    }

    /// The photos in use that a page shows.
    fn own_photos(&self, page: &Document) -> Vec<Known<'_>> {
        let shown = photos_on(&[page]);
        self.photos.iter().filter(|photo| shown.contains(photo.id())).copied().collect()
    }
}

/// Why the user cannot combine some panels of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Obstacles {
    /// Why they cannot share one image. Null if they can.
    pub merge: Option<Obstacle>,
    /// Why they cannot become one panel. Null if they can.
    pub join: Option<Obstacle>,
}

impl Default for Obstacles {
    fn default() -> Self {
        Self { merge: Some(Obstacle::Few), join: Some(Obstacle::Few) }
    }
}

/// Returns why the panels, with the panels that share an image with them, cannot be merged or joined.
///
/// # Errors
/// `unknown-layout` and `invalid-layout`, if the page has no valid layout.
pub fn obstacles(page: &Document, panels: &[usize]) -> Result<Obstacles> {
    let group = grown(page, panels);
    if panels.len() < 2 || group.len() < 2 {
        return Ok(Obstacles::default());
    }
    let template = page.template()?;
    let is_group = |other: &Vec<usize>| other.len() == group.len() && other.contains(&group[0]);
    let merged = page.merges.iter().any(is_group).then_some(Obstacle::Already);
    let merge = merged.or_else(|| why_not_merge(&template, &group));
    let join = join_panels(&template, &group).is_err().then_some(Obstacle::Uneven);
    Ok(Obstacles { merge, join })
}

/// The given panels, and all panels that share an image with one of them, in ascending order.
fn grown(page: &Document, panels: &[usize]) -> Vec<usize> {
    let groups = page.merges.iter().filter(|group| group.iter().any(|panel| panels.contains(panel)));
    let mut all: Vec<usize> = panels.iter().chain(groups.flatten()).copied().collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Whether the panel exists and is not locked.
fn is_free(page: &Document, panel: usize) -> bool {
    page.panels.get(panel).is_some_and(|content| !content.locked)
}

/// Shows a photo in some panels, with an automatic crop.
fn show(page: &mut Document, panels: &[usize], photo: Option<&str>) {
    for &at in panels {
        let content = &mut page.panels[at];
        content.photo = photo.map(str::to_owned);
        (content.crop, content.edited) = (None, false);
    }
}

/// The page without the groups that contain one of the panels, or without any group. `None` if nothing is
/// split.
fn split(page: &Document, panels: &[usize]) -> Option<Document> {
    let parted = |group: &[usize]| panels.is_empty() || group.iter().any(|panel| panels.contains(panel));
    let mut next = page.clone();
    next.merges.retain(|group| !parted(group));
    for group in page.merges.iter().filter(|group| parted(group)) {
        show(&mut next, &group[1..], None);
        next.panels[group[0]].edited = false;
    }
    (next.merges.len() < page.merges.len()).then_some(next)
}

/// The page with one photo instead of its near-duplicates. Locked panels stay.
fn with_duplicate(page: &Document, photo: &str, alike: &[String]) -> Document {
    let mut next = page.clone();
    for at in 0..page.panels.len() {
        let content = &page.panels[at];
        if !content.locked && content.photo.as_ref().is_some_and(|shown| alike.contains(shown)) {
            show(&mut next, &[at], Some(photo));
        }
    }
    next.order.clear();
    for id in &page.order {
        let id = if alike.contains(id) { photo } else { id };
        if !next.order.iter().any(|other| other == id) {
            next.order.push(id.to_owned());
        }
    }
    next
}

/// The page with an empty panel after the panel, or without it. Groups with the panel are split, because the
/// remaining panels of a group may not be adjacent any more.
fn spliced(page: &Document, panel: usize, more: bool) -> Document {
    let mut next = page.clone();
    if more {
        next.panels.insert(panel + 1, PanelContent::default());
    } else {
        next.panels.remove(panel);
    }
    let moved = |other: usize| match (other > panel, more) {
        (false, _) => other,
        (true, true) => other + 1,
        (true, false) => other - 1,
    };
    next.merges = without_merges(page, &[panel], &moved);
    next
}

/// The page with one panel instead of the joined ones. It shows the photo of a locked panel, or else of the
/// first panel with a photo.
fn joined(page: &Document, group: &[usize]) -> Document {
    let Some(&first) = group.first() else { return page.clone() };
    let mut shown = group.iter().copied().filter(|panel| page.panels[*panel].photo.is_some());
    let locked = shown.clone().find(|panel| page.panels[*panel].locked);
    let stays = locked.or_else(|| shown.next()).unwrap_or(first);
    let left: Vec<usize> =
        (0..page.panels.len()).filter(|panel| *panel == first || !group.contains(panel)).collect();
    let mut next = page.clone();
    next.panels = left
        .iter()
        .map(|&panel| {
            // The shape of the panel changes, so its crop is computed again.
            if panel == first {
                PanelContent { edited: false, ..page.panels[stays].clone() }
            } else {
                page.panels[panel].clone()
            }
        })
        .collect();
    let moved = |panel: usize| left.iter().position(|other| *other == panel).unwrap_or_default();
    next.merges = without_merges(page, group, &moved);
    next
}

/// The groups without one of the panels, with the new indices of their panels.
fn without_merges(page: &Document, panels: &[usize], moved: &dyn Fn(usize) -> usize) -> Vec<Vec<usize>> {
    let stay = page.merges.iter().filter(|group| !group.iter().any(|panel| panels.contains(panel)));
    stay.map(|group| group.iter().map(|panel| moved(*panel)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::super::edit::{Edit, How};
    use super::super::editor::Editor;
    use super::*;
    use crate::framing::{FACE, PhotoMeta, Subject};
    use serde_json::{Value, json};

    /// Photos `a`, `b`, ... that look different.
    fn album(count: usize) -> Vec<PhotoMeta> {
        let photo = |i: usize| PhotoMeta {
            fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
            ..PhotoMeta::unmeasured(&char::from(b'a' + i as u8).to_string(), 3000, 2000)
        };
        (0..count).map(photo).collect()
    }

    struct Desk {
        editor: Editor,
        photos: Vec<PhotoMeta>,
    }

    impl Desk {
        /// A page of four panels with the photos `a` to `d`.
        fn new() -> Self {
            let mut desk = Self { editor: Editor::default(), photos: album(4) };
            let ids = desk.photos.iter().map(|photo| photo.id.clone()).collect();
            desk.editor.apply(&Edit::AddPhotos { ids }, &How::default());
            let planning = Planning::new(desk.editor.project(), &desk.photos);
            let request =
                Request { layout: Some("grid-4".into()), ..planning.request_for(None, Keep::default(), 1) };
            let mut page = planning.plan(request, None).unwrap().unwrap();
            for (content, photo) in page.panels.iter_mut().zip(["a", "b", "c", "d"]) {
                content.photo = Some(photo.into());
            }
            desk.editor.apply(&Edit::ShowPage { page: Arc::new(page), page_id: 1 }, &How::default());
            desk
        }

        fn does(&mut self, edit: &Value) -> bool {
            let before = self.editor.project().clone();
            let known = || Ok(self.photos.iter().map(|meta| Known { meta, place: None }).collect());
            self.editor.apply_json_with(&edit.to_string(), &known).unwrap();
            *self.editor.project() != before
        }

        fn page(&self) -> Document {
            self.editor.project().page().unwrap().clone()
        }

        fn photos(&self) -> String {
            self.page().panels.iter().map(|content| content.photo.clone().unwrap_or_default()).collect()
        }

        fn steps(&self) -> usize {
            self.editor.history().past.len()
        }
    }

    #[test]
    fn a_drag_crops_all_merged_panels_in_one_undo_step() {
        let mut desk = Desk::new();
        desk.does(&json!({ "type": "merge-panels", "panels": [1, 0] }));
        assert_eq!(desk.page().merges, [[0, 1]]);
        let from = Crop { x: 0.2, y: 0.2, width: 0.4, height: 0.4 };
        let steps = desk.steps();
        for x in [0.1, 0.25] {
            let crop = json!({ "type": "pan", "from": from, "x": x, "y": 0 });
            assert!(desk.does(&json!({ "type": "crop-panel", "panel": 1, "crop": crop, "gesture": "g" })));
        }
        let page = desk.page();
        assert!((page.panels[0].crop.unwrap().x - 0.1).abs() < 1e-9);
        assert_eq!((page.panels[1].crop, page.panels[1].edited), (page.panels[0].crop, true));
        assert!(!page.panels[2].edited);
        assert_eq!(desk.steps(), steps + 1);
        assert!(desk.does(&json!({ "type": "crop-panel", "panel": 0, "crop": { "type": "reset" } })));
        assert!(!desk.page().panels[1].edited && desk.page().panels[0].crop.is_some());
        let zoom = json!({ "type": "zoom", "factor": 2 });
        let before = desk.page().panels[2].crop.unwrap();
        assert!(desk.does(&json!({ "type": "crop-panel", "panel": 2, "crop": zoom })));
        assert!((desk.page().panels[2].crop.unwrap().width - before.width / 2.0).abs() < 1e-9);
    }

    #[test]
    fn a_crop_fits_the_subject_or_is_automatic() {
        let mut desk = Desk::new();
        let face = Subject {
            x: 0.6,
            y: 0.2,
            width: 0.1,
            height: 0.2,
            label: FACE.into(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        };
        desk.photos[1].subjects = vec![face];
        let fit = |panel: usize| json!({ "type": "crop-panel", "panel": panel, "crop": { "type": "fit" } });
        desk.does(&fit(1));
        desk.does(&fit(2));
        let page = desk.page();
        assert!(page.panels[1].edited && page.panels[1].crop.unwrap().width < 0.4);
        assert!(!page.panels[2].edited);
    }

    #[test]
    fn invalid_crops_are_errors_and_impossible_intents_change_nothing() {
        let mut desk = Desk::new();
        let before = desk.editor.clone();
        let from = json!({ "x": 0.9, "y": 0, "width": 0, "height": 0 });
        let crop = json!({ "type": "pan", "from": from, "x": 0, "y": 0 });
        let edit = json!({ "type": "crop-panel", "panel": 0, "crop": crop }).to_string();
        assert_eq!(desk.editor.apply_json(&edit).unwrap_err().code(), "invalid-document");
        let unknown = json!({ "type": "fold-page" }).to_string();
        assert_eq!(desk.editor.apply_json(&unknown).unwrap_err().code(), "invalid-document");
        for edit in [
            json!({ "type": "swap-panels", "panel": 0, "with": 9 }),
            json!({ "type": "swap-panels", "panel": 0, "with": 0 }),
            json!({ "type": "place-photo", "panel": 9, "photo": "a" }),
            json!({ "type": "place-photo", "panel": 0, "photo": "a" }),
            json!({ "type": "lock-panel", "panel": 9, "on": true }),
            json!({ "type": "merge-panels", "panels": [0] }),
            json!({ "type": "merge-panels", "panels": [0, 9] }),
            json!({ "type": "split-panels", "panels": [] }),
            json!({ "type": "enlarge-panel", "panel": 9 }),
            json!({ "type": "break-frame", "panel": 9, "mask": null }),
            json!({ "type": "recrop", "sheet": 99 }),
            json!({ "type": "crop-panel", "panel": 9, "crop": { "type": "fit" } }),
        ] {
            assert!(!desk.does(&edit), "{edit}");
        }
        let remove = json!({ "type": "reshape", "change": { "type": "remove", "panel": 9 } }).to_string();
        assert_eq!(desk.editor.apply_json(&remove).unwrap_err().code(), "invalid-layout");
        assert_eq!(desk.editor, before);
    }

    #[test]
    fn photos_are_swapped_and_placed_and_a_locked_panel_keeps_its_photo() {
        let mut desk = Desk::new();
        assert!(desk.does(&json!({ "type": "swap-panels", "panel": 0, "with": 2 })));
        assert_eq!(desk.photos(), "cbad");
        assert!(desk.does(&json!({ "type": "place-photo", "panel": 0, "photo": "b" })));
        assert_eq!(desk.photos(), "bbad");
        assert!(desk.does(&json!({ "type": "lock-panel", "panel": 0, "on": true })));
        let crop = json!({ "type": "zoom", "factor": 2 });
        for edit in [
            json!({ "type": "place-photo", "panel": 0, "photo": "c" }),
            json!({ "type": "swap-panels", "panel": 1, "with": 0 }),
            json!({ "type": "crop-panel", "panel": 0, "crop": crop }),
            json!({ "type": "enlarge-panel", "panel": 0 }),
        ] {
            assert!(!desk.does(&edit));
        }
        assert!(desk.does(&json!({ "type": "lock-panel", "panel": 0, "on": false })));
        assert!(desk.does(&json!({ "type": "enlarge-panel", "panel": 0 })));
        desk.does(&json!({ "type": "lock", "part": "layout", "on": true }));
        assert!(!desk.does(&json!({ "type": "enlarge-panel", "panel": 1 })));
    }

    #[test]
    fn merged_panels_are_split_and_the_others_get_photos() {
        let mut desk = Desk::new();
        assert!(!desk.does(&json!({ "type": "merge-panels", "panels": [0, 3] })), "they do not touch");
        assert!(desk.does(&json!({ "type": "merge-panels", "panels": [0, 1] })));
        assert!(!desk.does(&json!({ "type": "merge-panels", "panels": [0, 1] })));
        assert!(desk.does(&json!({ "type": "merge-panels", "panels": [1, 3] })));
        assert_eq!(desk.page().merges, [vec![0, 1, 3]]);
        assert!(desk.does(&json!({ "type": "split-panels", "panels": [3] })));
        assert!(desk.page().merges.is_empty());
        assert!(desk.page().panels.iter().all(|content| content.photo.is_some() && content.crop.is_some()));
    }

    #[test]
    fn panels_that_cannot_be_combined_have_reasons() {
        let mut page = Desk::new().page();
        let why = |page: &Document, panels: &[usize]| {
            let Obstacles { merge, join } = obstacles(page, panels).unwrap();
            (merge, join)
        };
        let (few, uneven) = (Some(Obstacle::Few), Some(Obstacle::Uneven));
        assert_eq!(why(&page, &[0]), (few, few));
        assert_eq!(why(&page, &[2, 0]), (None, None));
        assert_eq!(why(&page, &[0, 3]), (Some(Obstacle::Apart), uneven));
        assert_eq!(why(&page, &[0, 9]), (Some(Obstacle::Overlay), uneven));
        // Panels that share an image count together, also if the file lists them in another order.
        page.merges = vec![vec![1, 0]];
        assert_eq!(why(&page, &[0, 1]), (Some(Obstacle::Already), None));
        assert_eq!(why(&page, &[1, 3]), (None, uneven));
        assert_eq!(why(&page, &[1]), (few, few));
    }

    #[test]
    fn a_panel_is_split_and_removed_and_the_others_keep_their_photos() {
        let mut page = Desk::new().page();
        page.merges = vec![vec![0, 1], vec![2, 3]];
        let shown = |page: &Document| -> Vec<Option<String>> {
            page.panels.iter().map(|content| content.photo.clone()).collect()
        };
        let photo = |id: &str| Some(id.to_owned());
        let more = spliced(&page, 1, true);
        assert_eq!(shown(&more), [photo("a"), photo("b"), None, photo("c"), photo("d")]);
        assert_eq!(more.merges, [[3, 4]]);
        let fewer = spliced(&page, 2, false);
        assert_eq!(shown(&fewer), [photo("a"), photo("b"), photo("d")]);
        assert_eq!(fewer.merges, [[0, 1]]);
        let mut desk = Desk::new();
        let steps = desk.steps();
        assert!(desk.does(&json!({ "type": "reshape", "change": { "type": "remove", "panel": 0 } })));
        assert_eq!((desk.page().panels.len(), desk.steps()), (3, steps + 1));
    }

    #[test]
    fn joined_panels_show_the_first_photo_or_the_photo_of_a_locked_panel() {
        let mut page = Desk::new().page();
        page.panels.push(PanelContent { photo: Some("e".into()), ..PanelContent::default() });
        page.panels[1].photo = None;
        page.panels[3].locked = true;
        page.panels.iter_mut().for_each(|content| content.edited = true);
        let shown = |page: &Document| -> String {
            page.panels.iter().map(|content| content.photo.clone().unwrap_or("-".into())).collect()
        };
        page.merges = vec![vec![3, 4]];
        let apart = joined(&page, &[0, 2]);
        assert_eq!((shown(&apart).as_str(), &apart.merges), ("a-de", &vec![vec![2, 3]]));
        assert_eq!(apart.panels.iter().filter(|content| content.edited).count(), 3);
        page.merges = vec![vec![0, 1], vec![3, 4]];
        let held = joined(&page, &[1, 2, 3]);
        assert_eq!((shown(&held).as_str(), held.merges.len()), ("ade", 0));
        let mut desk = Desk::new();
        assert!(desk.does(&json!({ "type": "reshape", "change": { "type": "join", "panels": [0, 2] } })));
        assert_eq!(desk.page().panels.len(), 3);
    }

    #[test]
    fn a_missing_photo_keeps_its_panel_and_new_measurements_change_the_others() {
        let mut desk = Desk::new();
        desk.does(&json!({ "type": "recrop", "silent": true }));
        let before = desk.page();
        for photo in &mut desk.photos[..2] {
            (photo.width, photo.height) = (1000, 4000);
        }
        desk.photos[0].absent = true;
        let steps = desk.steps();
        assert!(desk.does(&json!({ "type": "recrop", "silent": true })));
        assert_eq!(desk.page().panels[0], before.panels[0]);
        assert_ne!(desk.page().panels[1], before.panels[1]);
        assert_eq!((desk.page().panels[2].clone(), desk.steps()), (before.panels[2].clone(), steps));
    }

    #[test]
    fn a_composed_page_is_another_version_only_with_a_step() {
        let mut desk = Desk::new();
        let compose = |seed: u32, silent: bool| {
            json!({
                "type": "compose", "photos": ["a", "b", "c"], "panels": 3, "surprise": 1, "draw": { "seed": seed },
                "silent": silent,
            })
        };
        let version = |desk: &Desk| desk.editor.project().page_id();
        let (first, steps) = (version(&desk), desk.steps());
        assert!(desk.does(&compose(5, true)));
        assert_eq!((version(&desk), desk.steps()), (first, steps));
        assert!(desk.does(&compose(6, false)));
        assert!(version(&desk) != first && desk.steps() == steps + 1);
    }

    #[test]
    fn a_photo_gets_new_crops_here_or_everywhere() {
        let mut desk = Desk::new();
        let page = desk.editor.project().page().cloned().unwrap();
        let edited = |locked: bool| {
            let mut page = page.clone();
            page.panels[0].crop = Some(Crop { x: 0.1, y: 0.1, width: 0.3, height: 0.3 });
            (page.panels[0].edited, page.panels[0].locked) = (true, locked);
            Arc::new(page)
        };
        let sheet = |id: u64, locked: bool| {
            let rest = serde_json::Map::new();
            Arc::new(Sheet { page: edited(locked), page_id: id, sheet: id, rest })
        };
        let sheets = vec![sheet(1, true), sheet(2, false)];
        desk.editor.apply(&Edit::SetSheets { sheets, at: 0 }, &How::default());
        let kept = |desk: &Desk| -> Vec<bool> {
            desk.editor.project().sheets().iter().map(|sheet| sheet.page.panels[0].edited).collect()
        };
        desk.does(&json!({ "type": "recrop-photo", "photo": "a", "everywhere": false }));
        assert_eq!(kept(&desk), [true, true]);
        desk.does(&json!({ "type": "recrop-photo", "photo": "a", "everywhere": true }));
        assert_eq!(kept(&desk), [false, false]);
    }

    #[test]
    fn a_shuffle_keeps_locked_parts_and_depends_only_on_its_seed() {
        let mut desk = Desk::new();
        let shuffle =
            |part: &str, seed: u32| json!({ "type": "shuffle", "part": part, "draw": { "seed": seed } });
        let before = desk.page();
        let mut other = Desk { editor: desk.editor.clone(), photos: desk.photos.clone() };
        assert!(desk.does(&shuffle("photos", 5)) && other.does(&shuffle("photos", 5)));
        assert_eq!(desk.page(), other.page());
        assert_eq!((&desk.page().layout, &desk.page().style), (&before.layout, &before.style));
        assert_ne!(desk.photos(), "abcd");
        assert_eq!(desk.editor.project().page_id(), 2);
        desk.does(&json!({ "type": "lock", "part": "style", "on": true }));
        assert!(!desk.does(&shuffle("style", 6)));
        assert!(desk.does(&shuffle("all", 7)));
        assert_eq!(desk.page().style, before.style);
        assert!(desk.does(&json!({ "type": "choose-layout", "layout": "grid-3", "seed": 8 })));
        assert!(desk.does(&json!({ "type": "choose-style", "style": "comic", "seed": 9 })));
        assert_eq!((desk.page().layout, desk.page().style), ("grid-3".into(), "comic".into()));
    }

    #[test]
    fn photos_are_sorted_and_a_photo_replaces_its_near_duplicates() {
        let mut desk = Desk::new();
        desk.does(&json!({ "type": "lock-panel", "panel": 1, "on": true }));
        desk.photos.reverse();
        assert!(desk.does(&json!({ "type": "sort-photos" })));
        assert_eq!(desk.photos(), "dbca");
        assert!(desk.does(&json!({ "type": "use-duplicate", "photo": "a", "alike": ["b", "c"] })));
        assert_eq!(desk.photos(), "dbaa");
    }

    #[test]
    fn new_paper_changes_all_pages_or_only_the_current_one_during_a_drag() {
        let mut desk = Desk::new();
        let page = desk.editor.project().page().cloned().unwrap();
        let sheet = |id: u64| {
            Arc::new(Sheet {
                page: Arc::new(page.clone()),
                page_id: id,
                sheet: id,
                rest: serde_json::Map::new(),
            })
        };
        desk.editor.apply(&Edit::SetSheets { sheets: vec![sheet(1), sheet(2)], at: 1 }, &How::default());
        let steps = desk.steps();
        let gutters = |desk: &Desk| -> Vec<f64> {
            desk.editor.project().sheets().iter().map(|sheet| sheet.page.page.gutter).collect()
        };
        let was = page.page.gutter;
        for (gutter, held, then) in [(0.03, true, [was, 0.03]), (0.04, false, [0.04, 0.04])] {
            let settings = PageSettings { gutter, ..page.page.clone() };
            desk.does(&json!({ "type": "set-paper", "settings": settings, "held": held, "gesture": "g" }));
            assert_eq!(gutters(&desk), then);
        }
        assert_eq!(desk.steps(), steps + 1);
    }

    #[test]
    fn without_photos_in_use_a_refit_removes_the_page() {
        let mut desk = Desk::new();
        let refit = json!({ "type": "refit", "grow": false, "draw": { "seed": 1 } });
        desk.photos.pop();
        assert!(desk.does(&refit));
        assert!(!desk.photos().contains('d'));
        let photos = std::mem::take(&mut desk.photos);
        assert!(desk.does(&refit));
        assert!(desk.editor.project().page().is_none());
        desk.photos = photos;
        assert!(desk.does(&refit));
        assert!(desk.editor.project().page().is_some());
    }

    #[test]
    fn pages_are_added_moved_styled_and_removed() {
        let mut desk = Desk::new();
        desk.photos = album(9);
        let ids = desk.photos.iter().map(|photo| photo.id.clone()).collect();
        desk.editor.apply(&Edit::AddPhotos { ids }, &How::default());
        let places = |desk: &Desk| -> (Vec<u64>, usize) {
            let project = desk.editor.project();
            (project.sheets().iter().map(|sheet| sheet.sheet).collect(), project.pages.active())
        };
        assert!(!desk.does(&json!({ "type": "remove-page" })));
        assert!(desk.does(&json!({ "type": "add-page", "draw": { "seed": 4 } })));
        assert_eq!(places(&desk), (vec![0, 1], 1));
        assert!(desk.photos().chars().all(|photo| !"abcd".contains(photo)), "{}", desk.photos());
        let steps = desk.steps();
        assert!(desk.does(&json!({ "type": "go-to-page", "at": 0, "silent": true })));
        assert!(!desk.does(&json!({ "type": "go-to-page", "at": 2, "silent": true })));
        assert_eq!((places(&desk), desk.steps()), ((vec![0, 1], 0), steps));
        assert!(desk.does(&json!({ "type": "move-page", "from": 0, "to": 1 })));
        assert!(!desk.does(&json!({ "type": "move-page", "from": 0, "to": 2 })));
        assert_eq!(places(&desk), (vec![1, 0], 1));
        assert!(!desk.does(&json!({ "type": "style-pages" })));
        desk.does(&json!({ "type": "choose-style", "style": "noir", "seed": 1 }));
        let before: Vec<u64> = desk.editor.project().sheets().iter().map(|sheet| sheet.page_id).collect();
        assert!(desk.does(&json!({ "type": "style-pages" })));
        let sheets = desk.editor.project().sheets();
        assert!(sheets.iter().all(|sheet| sheet.page.style == "noir".into()));
        assert!(sheets[0].page_id > before[0] && sheets[1].page_id == before[1]);
        assert!(desk.does(&json!({ "type": "remove-page" })));
        assert_eq!(places(&desk), (vec![1], 0));
        assert!(desk.does(&json!({ "type": "spread-album", "draw": { "seed": 4 } })));
        assert_eq!(desk.editor.project().sheets().len(), 2);
        desk.does(&json!({ "type": "lock", "part": "photos", "on": true }));
        assert!(!desk.does(&json!({ "type": "spread-album", "draw": { "seed": 5 } })));
    }

    #[test]
    fn an_intent_tells_the_edits_that_carried_it_out() {
        let mut desk = Desk::new();
        let mut told = |edit: Value| -> Vec<Value> {
            let known = || Ok(desk.photos.iter().map(|meta| Known { meta, place: None }).collect());
            let told = desk.editor.apply_json_with(&edit.to_string(), &known).unwrap();
            serde_json::from_str::<Value>(&told).unwrap()["edits"].as_array().unwrap().clone()
        };
        let zoom = json!({ "type": "zoom", "factor": 2 });
        assert_eq!(
            told(json!({ "type": "crop-panel", "panel": 0, "crop": zoom, "gesture": "g" })),
            [json!({ "type": "change-page", "page": 2, "gesture": "g" })]
        );
        let kinds = |edits: Vec<Value>| -> Vec<Value> {
            edits.iter().map(|edit| json!([edit["type"], edit["silent"]])).collect()
        };
        let shuffle = json!({ "type": "shuffle", "part": "photos", "draw": { "seed": 5 } });
        assert_eq!(kinds(told(shuffle)), [json!(["show-page", null])]);
        assert_eq!(
            kinds(told(json!({ "type": "add-page", "draw": { "seed": 4 } }))),
            [json!(["set-sheets", null])]
        );
        let settings = PageSettings { gutter: 0.03, ..PageSettings::default() };
        let paper = json!({ "type": "set-paper", "settings": settings, "held": false });
        assert_eq!(kinds(told(paper)), [json!(["change-settings", null]), json!(["set-sheets", true])]);
        let version = json!({ "type": "restore-version", "pageId": 1 });
        assert_eq!(kinds(told(version)), [json!(["set-sheets", true]), json!(["show-page", null])]);
        assert!(told(json!({ "type": "lock-panel", "panel": 9, "on": true })).is_empty());
    }

    #[test]
    fn a_version_comes_back_in_its_place() {
        let mut desk = Desk::new();
        let first = desk.page();
        desk.does(&json!({ "type": "shuffle", "part": "photos", "draw": { "seed": 5 } }));
        desk.does(&json!({ "type": "add-page", "draw": { "seed": 4 } }));
        assert_eq!(desk.editor.project().pages.active(), 1);
        let steps = desk.steps();
        assert!(desk.does(&json!({ "type": "restore-version", "pageId": 1 })));
        assert_eq!((desk.page(), desk.editor.project().pages.active(), desk.steps()), (first, 0, steps + 1));
        assert!(!desk.does(&json!({ "type": "restore-version", "pageId": 1 })));
        assert!(!desk.does(&json!({ "type": "restore-version", "pageId": 99 })));
    }
}
