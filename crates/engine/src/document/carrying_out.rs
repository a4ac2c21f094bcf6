//! Carries out intents: plans the page or the pages that an intent asks for.

use super::intent::{CropChange, Intent};
use super::planning::{KEEP_ALL, Known, Planning};
use super::project::Sheet;
use super::sheets::photos_on;
use crate::error::Result;
use crate::framing::Crop;
use crate::layout::merge::{can_merge, merged_bounds};
use crate::layout::{enlarged, resolve};
use crate::page::document::PanelContent;
use crate::page::layouts::LayoutChange;
use crate::page::{Document, LayoutRef, breaking};
use std::sync::Arc;

/// The result of an intent.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// The current page changes.
    Changed(Document),
    /// Pages of the storyboard change: all pages in order, and the index of the current page.
    Sheets(Vec<Arc<Sheet>>, usize),
}

impl Planning<'_> {
    /// Plans the result of an intent. `None` if the intent is impossible, or if nothing changes.
    ///
    /// # Errors
    /// Errors of the planner, and of a layout that does not allow the change.
    pub fn carry_out(&self, intent: &Intent) -> Result<Option<Outcome>> {
        let Some(page) = self.project.page.as_deref() else { return Ok(None) };
        match intent {
            Intent::CropPanel { panel, crop } => self.cropped(page, *panel, crop),
            Intent::SwapPanels { panel, with } => {
                let (one, other) = (grown(page, &[*panel]), grown(page, &[*with]));
                if !is_free(page, *panel) || !is_free(page, *with) || one == other {
                    return Ok(None);
                }
                let photo = |of: &[usize]| page.panels[of[0]].photo.clone();
                let (mut next, first) = (page.clone(), photo(&one));
                show(&mut next, &one, &photo(&other));
                show(&mut next, &other, &first);
                self.amended(next)
            }
            Intent::PlacePhoto { panel, photo } => {
                let group = grown(page, &[*panel]);
                let shown = page.panels.get(group[0]).and_then(|content| content.photo.as_ref());
                if !is_free(page, *panel) || shown == Some(photo) {
                    return Ok(None);
                }
                let mut next = page.clone();
                show(&mut next, &group, &Some(photo.clone()));
                self.amended(next)
            }
            Intent::LockPanel { panel, on } => self.changed(page, *panel, &|content| content.locked = *on),
            Intent::BreakFrame { panel, mask } => {
                if !is_free(page, *panel) {
                    return Ok(None);
                }
                let next = match mask {
                    Some(mask) => breaking::broken(page, *panel, mask)?,
                    None => {
                        let mut next = page.clone();
                        next.panels[*panel].figure = None;
                        Some(next)
                    }
                };
                Ok(next.map(Outcome::Changed))
            }
            Intent::MergePanels { panels } => {
                let group = grown(page, panels);
                if page.merges.contains(&group) || !can_merge(&*page.template()?, &group) {
                    return Ok(None);
                }
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
            Intent::Recrop => {
                let better = self.recropped(page, None)?.filter(|better| better != page);
                Ok(better.map(Outcome::Changed))
            }
            Intent::RecropPhoto { photo, locked } => self.recropped_photo(photo, *locked),
            Intent::Unknown => Ok(None),
        }
    }

    /// Plans a manually changed page: all its parts stay, and empty panels get photos.
    fn replanned(&self, page: Document, photos: Option<Vec<Known>>) -> Result<Option<Document>> {
        let seed = page.seed;
        let mut request = self.request_for(Some(page), KEEP_ALL, seed);
        request.ordered = self.are_frames().then_some(true);
        self.plan(request, photos)
    }

    fn amended(&self, page: Document) -> Result<Option<Outcome>> {
        Ok(self.replanned(page, None)?.map(Outcome::Changed))
    }

    fn amended_if(&self, page: Option<Document>) -> Result<Option<Outcome>> {
        page.map_or(Ok(None), |page| self.amended(page))
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
        grown(page, &[panel]).iter().for_each(|at| change(&mut next.panels[*at]));
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
        Ok(known.and_then(|known| Crop::fitted(known.meta, bounds.width / bounds.height)))
    }

    fn reshaped(&self, page: &Document, change: &LayoutChange) -> Result<Option<Outcome>> {
        let mut next = page.clone();
        let mut wanted = change.clone();
        match &mut wanted {
            LayoutChange::MoveCut { .. } | LayoutChange::MoveInset { .. } => {}
            LayoutChange::Split { panel, .. } if *panel < page.panels.len() => {
                next = spliced(page, *panel, true);
            }
            LayoutChange::Remove { panel } if *panel < page.panels.len() => {
                next = spliced(page, *panel, false);
            }
            // The layout rejects a panel that does not exist.
            LayoutChange::Split { .. } | LayoutChange::Remove { .. } => {}
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
    pub(super) fn recropped(&self, page: &Document, photos: Option<Vec<Known>>) -> Result<Option<Document>> {
        let Some(mut better) = self.replanned(page.clone(), photos)? else { return Ok(None) };
        for (panel, before) in better.panels.iter_mut().zip(&page.panels) {
            let absent = |photo: &String| self.photos.iter().any(|k| k.id() == photo && k.meta.absent);
            if panel.photo == before.photo && panel.photo.as_ref().is_some_and(absent) {
                *panel = before.clone();
            }
        }
        Ok(Some(better))
    }

    fn recropped_photo(&self, photo: &str, locked: bool) -> Result<Option<Outcome>> {
        let mut sheets = self.project.sheets();
        let mut found = false;
        for (at, sheet) in sheets.iter_mut().enumerate() {
            if !photos_on(&[&sheet.page]).contains(photo) {
                continue;
            }
            let mut next = Document::clone(&sheet.page);
            for content in &mut next.panels {
                if content.photo.as_deref() == Some(photo) && (locked || !content.locked) {
                    (content.crop, content.edited) = (None, false);
                }
            }
            // The photos of another page stay on it.
            let own = (at != self.project.at).then(|| self.own_photos(&next));
            if let Some(page) = self.replanned(next, own)? {
                *sheet = Arc::new(Sheet { page: Arc::new(page), ..Sheet::clone(sheet) });
                found = true;
            }
        }
        Ok(found.then_some(Outcome::Sheets(sheets, self.project.at)))
    }

    /// The photos in use that a page shows.
    pub(super) fn own_photos(&self, page: &Document) -> Vec<Known<'_>> {
        let shown = photos_on(&[page]);
        self.photos.iter().filter(|photo| shown.contains(photo.id())).copied().collect()
    }

    /// Whether all photos in use are frames of videos. Their order has a meaning, which is not true of photos
    /// without dates.
    fn are_frames(&self) -> bool {
        self.photos.iter().all(|photo| photo.meta.frame)
    }
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
fn show(page: &mut Document, panels: &[usize], photo: &Option<String>) {
    for &at in panels {
        let content = &mut page.panels[at];
        content.photo.clone_from(photo);
        (content.crop, content.edited) = (None, false);
    }
}

/// The page without the groups that contain one of the panels, or without any group. `None` if nothing is
/// split.
fn split(page: &Document, panels: &[usize]) -> Option<Document> {
    let parted =
        |group: &[usize]| panels.is_empty() || group.iter().any(|panel| panels.contains(panel));
    let mut next = page.clone();
    next.merges.retain(|group| !parted(group));
    for group in page.merges.iter().filter(|group| parted(group)) {
        show(&mut next, &group[1..], &None);
        next.panels[group[0]].edited = false;
    }
    (next.merges.len() < page.merges.len()).then_some(next)
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
