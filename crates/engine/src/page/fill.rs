//! The panels of a template as places for photos, with locked and preserved content, and their new content.

use super::document::{Document, MOST_FACES, PanelContent};
use super::reference::LayoutRef;
use super::request::Request;
use crate::framing::{Crop, FACE, PhotoMeta, Subject, Target, frame};
use crate::json::Writer;
use crate::layout::{FAMILIES, ResolvedPanel, Template, resolve};
use crate::order::sort_by;
use crate::plan::assign::is_gray;
use crate::plan::slots::slot;
use crate::plan::{Assignment, Candidate, Slot};

/// Difference of two aspect ratios, as a logarithm, at which a photo counts as whole.
const ALIKE: f64 = 0.02;

/// Width of a face in widths of its person, and its distance from the top in heights of the face: medians of 177 persons of
/// six albums are 0.31 and 0.57. A larger box covers more of the heads that are not in the middle.
const IN_PERSON: (f64, f64) = (0.38, 0.4);
/// Minimum score of a person without a known face, and heights of the face relative to the largest known one.
const CERTAIN: f64 = 0.5;
const OF_THE_GROUP: (f64, f64) = (0.4, 1.6);

/// A layout that may become the page.
pub(super) struct Stage {
    /// Its id, or it in full.
    pub(super) layout: LayoutRef,
    /// Groups of panels that share an image.
    pub(super) merges: Vec<Vec<usize>>,
    /// The places for photos: a slot for each panel, or group of panels.
    pub(super) candidate: Candidate,
    /// The panel of each slot.
    heads: Vec<usize>,
    /// Slots that the user locked.
    locked: Vec<bool>,
    panels: usize,
    same_layout: bool,
}

impl Stage {
    /// Returns the stage of a layout on the page of `request`. `place` has its index and its prior weight.
    pub(super) fn new(
        request: &Request,
        layout: LayoutRef,
        template: &Template,
        merges: Vec<Vec<usize>>,
        same_layout: bool,
        place: (usize, f64),
    ) -> Self {
        let page = &request.page;
        let resolved = resolve(template, page.aspect(), page);
        let panels = resolved.len();
        let heads: Vec<usize> = (0..panels).filter(|&i| leader_of(&merges, i) == i).collect();
        let mut slots = merged_slots(&resolved, &merges, &heads, page.looked_at());
        let current = request.current.as_ref();
        let placed = current.map_or_else(Vec::new, |current| {
            let own = |panel: usize| heads.iter().position(|&head| head == leader_of(&merges, panel));
            lock_slots(&mut slots, current, request, same_layout.then_some(&own))
        });
        let locked = slots.iter().map(|slot| slot.locked.is_some()).collect();
        if let Some(current) = current.filter(|_| request.keep.photos) {
            keep_photos(&mut slots, current, &placed, &request.photos, same_layout);
        }
        let family =
            FAMILIES.iter().find(|family| **family == template.family()).copied().unwrap_or_default();
        let candidate = Candidate { slots, prior: place.1, layout: place.0, family };
        Self { layout, merges, candidate, heads, locked, panels, same_layout }
    }

    /// Returns the stage of a layout in which each photo has the panel of its place, and shows as much of it as fits.
    pub(super) fn whole(
        &self,
        request: &Request,
        layout: LayoutRef,
        template: &Template,
        photos: &[usize],
    ) -> (Self, Vec<Assignment>) {
        let fresh = Request { current: None, page: request.page.clone(), ..Request::default() };
        let same_layout = layout == self.layout && self.same_layout;
        let mut stage = Self::new(&fresh, layout, template, Vec::new(), false, (0, 1.0));
        let locked = |photo: usize| {
            let id = &request.photos[photo].id;
            let panels = request.current.iter().flat_map(|current| &current.panels);
            panels.filter(|panel| panel.locked).any(|panel| panel.photo.as_ref() == Some(id))
        };
        stage.locked = photos.iter().map(|&photo| locked(photo)).collect();
        stage.same_layout = same_layout;
        let everything = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let shown = photos.iter().zip(&stage.candidate.slots).map(|(&photo, slot)| {
            let crop = request.photos[photo].refitted(&everything, slot.target.aspect);
            Assignment { photo, crop }
        });
        let shown = shown.collect();
        (stage, shown)
    }

    /// Whether the panels have the aspect ratios of these photos.
    pub(super) fn fits(&self, photos: &[&PhotoMeta]) -> bool {
        let slots = &self.candidate.slots;
        slots.len() == photos.len()
            && slots
                .iter()
                .zip(photos)
                .all(|(slot, photo)| (slot.target.aspect / photo.aspect()).ln().abs() < ALIKE)
    }

    /// Photos that the page retains.
    pub(super) fn held(&self) -> Vec<usize> {
        self.candidate.slots.iter().filter_map(Slot::photo).collect()
    }
}

/// Returns the order of the photos, with unplaced photos at the end, and the content of each panel.
pub(super) fn contents(
    request: &Request,
    stage: &Stage,
    assigned: &[Assignment],
) -> (Vec<String>, Vec<PanelContent>) {
    let Stage { heads, locked, merges, same_layout, .. } = stage;
    let (photos, current) = (&request.photos, request.current.as_ref());
    let before = |i: usize| current.filter(|_| *same_layout).and_then(|current| current.panels.get(i));
    // A manual crop stays while its panel keeps the photo. Locked panels always keep it.
    let edited = |i: usize, photo: &str| {
        let stays = |panel: &&PanelContent| request.keep.photos || panel.locked;
        before(i).filter(stays).is_some_and(|p| p.edited && p.photo.as_deref() == Some(photo))
    };
    let stays_broken = |i: usize| {
        before(i).is_some_and(|panel| panel.figure.is_some() && (request.keep.photos || panel.locked))
    };
    let has_colours = assigned.iter().any(|panel| !is_gray(&photos[panel.photo]));
    let panels: Vec<PanelContent> = (0..stage.panels)
        .map(|i| {
            let head = heads.iter().position(|&head| head == leader_of(merges, i));
            let assigned = head.and_then(|head| assigned.get(head));
            PanelContent {
                photo: assigned.map(|a| photos[a.photo].id.clone()),
                crop: assigned.map(|a| a.crop),
                faces: assigned.map_or_else(Vec::new, |a| faces_of(&photos[a.photo])),
                // Whatever photo is here now, the mask is its own.
                figure: assigned.filter(|_| stays_broken(i)).and_then(|a| photos[a.photo].mask.clone()),
                // An empty panel may be locked too.
                locked: head.is_some_and(|head| locked[head]) || before(i).is_some_and(|panel| panel.locked),
                edited: assigned.is_some_and(|a| edited(leader_of(merges, i), &photos[a.photo].id)),
                toned: has_colours && assigned.is_some_and(|a| is_gray(&photos[a.photo])),
                plain: before(i).is_some_and(|panel| panel.plain),
                rest: before(i).map(|panel| panel.rest.clone()).unwrap_or_default(),
            }
        })
        .collect();
    (order_of(&panels, current, photos), panels)
}

/// Crops of photos for an aspect ratio, in JSON: a list of `{photo, crop, faces}`.
#[must_use]
pub fn framed_json<'p>(photos: impl Iterator<Item = &'p PhotoMeta>, aspect: f64) -> String {
    let target = Target::of_aspect(aspect.clamp(0.05, 20.0));
    let mut out = Writer::default();
    out.open(b'[');
    for photo in photos {
        out.item();
        out.open(b'{');
        out.key("photo").text(&photo.id);
        out.key("crop").put(&frame(photo, &target, 0));
        out.key("faces").list(&faces_of(photo), &|out, face| out.put(face));
        out.close(b'}');
    }
    out.close(b']');
    out.finish()
}

/// The faces of a photo, or its animals if it has no faces, the largest first. Beside known faces, also the heads of persons
/// whose faces were not found.
pub(super) fn faces_of(photo: &PhotoMeta) -> Vec<Crop> {
    // Rounded to the precision of a pixel, because a project has many crops.
    let rounded = |part: f64| (part.clamp(-1.0, 2.0) * 1e4).round() / 1e4;
    let mut faces: Vec<Crop> = Subject::protected(&photo.subjects)
        .map(|face| Crop { x: face.x, y: face.y, width: face.width, height: face.height })
        .chain(supposed_faces(photo))
        .map(|face| Crop {
            x: rounded(face.x),
            y: rounded(face.y),
            width: rounded(face.width),
            height: rounded(face.height),
        })
        .filter(|face| face.width > 0.0 && face.height > 0.0)
        .collect();
    sort_by(&mut faces, |a, b| b.height.total_cmp(&a.height));
    faces.truncate(MOST_FACES);
    faces
}

/// Estimates the faces of persons without a known face, in a photo with faces. A face that is much smaller or larger than the
/// largest known one belongs to a passer-by or to a false detection.
fn supposed_faces(photo: &PhotoMeta) -> Vec<Crop> {
    let faces: Vec<&Subject> = photo.subjects.iter().filter(|subject| subject.label == FACE).collect();
    let Some(largest) = faces.iter().map(|face| face.height).reduce(f64::max) else { return Vec::new() };
    let shape = faces.iter().map(|face| face.width / face.height).sum::<f64>() / faces.len() as f64;
    let unknown = |person: &&Subject| {
        person.label == "person"
            && person.score >= CERTAIN
            && !photo.is_headless(person)
            && !faces.iter().any(|face| person.surrounds(face))
    };
    let face = |person: &Subject| {
        let width = IN_PERSON.0 * person.width;
        let height = width / shape;
        Crop { x: person.x + (person.width - width) / 2.0, y: person.y + IN_PERSON.1 * height, width, height }
    };
    let is_alike = |face: &Crop| (OF_THE_GROUP.0..=OF_THE_GROUP.1).contains(&(face.height / largest));
    photo.subjects.iter().filter(unknown).map(face).filter(is_alike).collect()
}

/// The first panel of the group of `panel`.
fn leader_of(merges: &[Vec<usize>], panel: usize) -> usize {
    merges.iter().find(|group| group.contains(&panel)).map_or(panel, |group| group[0])
}

/// A slot for each panel or group. The crop of a group covers all its panels and gutters.
fn merged_slots(resolved: &[ResolvedPanel], merges: &[Vec<usize>], heads: &[usize], width: f64) -> Vec<Slot> {
    let group = |head: usize| merges.iter().find(|group| group.first() == Some(&head));
    let wanted = |&head: &usize| match group(head) {
        Some(group) => slot(resolved, group, width, false),
        None => slot(resolved, &[head], width, false),
    };
    heads.iter().filter_map(wanted).collect()
}

/// Single panels and first panels of groups, in reading order.
fn heads_of(page: &Document) -> Vec<(usize, &PanelContent)> {
    let all = page.panels.iter().enumerate();
    all.filter(|(i, _)| leader_of(&page.merges, *i) == *i).collect()
}

/// Panels that the user locked keep photo and crop. In another layout, the photo moves to the panel with the
/// same index in reading order, or to the nearest free one.
///
/// `own` returns the index of a panel if the layout is the same. Returns which heads of the page have one.
fn lock_slots(
    slots: &mut [Slot],
    current: &Document,
    request: &Request,
    own: Option<&dyn Fn(usize) -> Option<usize>>,
) -> Vec<usize> {
    let mut placed = Vec::new();
    for (rank, (i, panel)) in heads_of(current).into_iter().enumerate().filter(|(_, (_, panel))| panel.locked)
    {
        let photo = panel.photo.as_ref().and_then(|id| request.photos.iter().position(|p| &p.id == id));
        let (Some(photo), Some(crop)) = (photo, panel.crop) else { continue };
        let mut free = (0..slots.len()).filter(|&place| slots[place].locked.is_none());
        let place = match own {
            Some(own) => own(i).filter(|own| free.any(|place| place == *own)),
            None => free.min_by_key(|place| place.abs_diff(rank)),
        };
        let Some(place) = place else { continue };
        // The page's lengths may have changed since.
        let crop = request.photos[photo].refitted(&crop, slots[place].target.aspect);
        slots[place].locked = Some(Assignment { photo, crop });
        placed.push(rank);
    }
    placed
}

/// Places the photos of the current page in their order, with new crops for these panels. Manual crops stay
/// if the layout is the same. Panels beyond the order, and panels with removed photos, stay empty. The heads
/// in `placed` already have their panel.
fn keep_photos(
    slots: &mut [Slot],
    current: &Document,
    placed: &[usize],
    photos: &[PhotoMeta],
    same_layout: bool,
) {
    let position = |id: &str| photos.iter().position(|photo| photo.id == id);
    let heads = heads_of(current);
    let shown: Vec<Option<&str>> = heads.iter().map(|(_, panel)| panel.photo.as_deref()).collect();
    // The panels determine the order, followed by photos of the old order without a panel.
    let rest = current
        .order
        .iter()
        .map(String::as_str)
        .filter(|id| !shown.contains(&Some(id)))
        .map(|id| (Some(id), None));
    let free = heads.iter().enumerate().filter(|(rank, _)| !placed.contains(rank));
    let mut sequence = free.map(|(_, (_, head))| (head.photo.as_deref(), Some(*head))).chain(rest);
    for slot in slots.iter_mut().filter(|slot| slot.locked.is_none()) {
        let Some((Some(id), head)) = sequence.next() else { continue };
        let Some(photo) = position(id) else { continue };
        match head.filter(|head| same_layout && head.edited).and_then(|head| head.crop) {
            Some(crop) => {
                let crop = photos[photo].refitted(&crop, slot.target.aspect);
                slot.locked = Some(Assignment { photo, crop });
            }
            None => slot.keeps = Some(photo),
        }
    }
}

/// The photos of the panels, then the other photos of the old order.
fn order_of(panels: &[PanelContent], current: Option<&Document>, photos: &[PhotoMeta]) -> Vec<String> {
    let before = current.map(|current| current.order.clone()).unwrap_or_default();
    let in_use = |id: &String| photos.iter().any(|photo| &photo.id == id);
    let mut order: Vec<String> = Vec::new();
    for id in panels.iter().filter_map(|panel| panel.photo.clone()).chain(before.into_iter().filter(in_use)) {
        if !order.contains(&id) {
            order.push(id);
        }
    }
    order
}
