//! Fills the panels of a template with photos, keeping what a person locked.

use super::document::{Document, PanelContent};
use super::request::{Mode, Request};
use crate::framing::{Assignment, Order, PhotoMeta, Slot, Target, assign, frame, slots};
use crate::layout::merge::merged_bounds;
use crate::layout::{PageSettings, ResolvedPanel, Template, resolve};

/// The photos of all panels, framed: locked panels and photos that stay first, the gaps by chance. Also their
/// order, with the photos that have no panel now at its end.
pub(super) fn choose_photos(
    request: &Request,
    template: &Template,
    merges: &[Vec<usize>],
    same_layout: bool,
) -> (Vec<String>, Vec<PanelContent>) {
    let page = &request.page;
    let resolved = resolve(template, page.aspect(), page);
    let leader = |i: usize| leader_of(merges, i);
    let heads: Vec<usize> = (0..resolved.len()).filter(|&i| leader(i) == i).collect();
    let current = request.current.as_ref();
    let mut slots = merged_slots(&resolved, merges, page);
    if let Some(current) = current {
        lock_slots(&mut slots, current, request, merges, same_layout);
    }
    let mut slots: Vec<Slot> = heads.iter().map(|&i| slots[i].clone()).collect();
    let locked: Vec<bool> = slots.iter().map(|slot| slot.locked.is_some()).collect();
    let photos = &request.photos;
    let mut assigned: Vec<Option<Assignment>> = match current.filter(|_| request.keep.photos) {
        Some(current) => kept(current, &slots, photos, same_layout),
        None => vec![None; slots.len()],
    };
    if assigned.iter().any(Option::is_none) {
        // What is already decided counts as locked, so that only the gaps are filled.
        for (slot, assigned) in slots.iter_mut().zip(&assigned) {
            slot.locked = slot.locked.or(*assigned);
        }
        let order = if request.mode == Mode::Photos { Order::Free } else { Order::Kept };
        assigned = assign(photos, &slots, order, u64::from(request.seed)).into_iter().map(Some).collect();
    }
    let before = |i: usize| current.filter(|_| same_layout).and_then(|current| current.panels.get(i));
    // A crop made by hand stays so while its panel keeps the photo, which a locked one always does.
    let edited = |i: usize, photo: &str| {
        let stays = |panel: &&PanelContent| request.keep.photos || panel.locked;
        before(i).filter(stays).is_some_and(|p| p.edited && p.photo.as_deref() == Some(photo))
    };
    let panels: Vec<PanelContent> = (0..resolved.len())
        .map(|i| {
            let head = heads.iter().position(|&head| head == leader(i));
            let assigned = head.and_then(|head| assigned[head]);
            PanelContent {
                photo: assigned.map(|a| photos[a.photo].id.clone()),
                crop: assigned.map(|a| a.crop),
                // An empty panel may be locked too.
                locked: head.is_some_and(|head| locked[head]) || before(i).is_some_and(|panel| panel.locked),
                edited: assigned.is_some_and(|a| edited(leader(i), &photos[a.photo].id)),
                rest: before(i).map(|panel| panel.rest.clone()).unwrap_or_default(),
            }
        })
        .collect();
    (order_of(&panels, current, photos), panels)
}

/// The panel that stands for `panel`: the first of its group.
fn leader_of(merges: &[Vec<usize>], panel: usize) -> usize {
    merges.iter().find(|group| group.contains(&panel)).map_or(panel, |group| group[0])
}

/// The panels as slots; the leader of a merged group wants a crop for the whole group, gutters included.
fn merged_slots(resolved: &[ResolvedPanel], merges: &[Vec<usize>], page: &PageSettings) -> Vec<Slot> {
    let width = f64::from(page.width);
    let mut slots = slots(resolved, width);
    for group in merges {
        if let (Some(bounds), Some(slot)) = (merged_bounds(resolved, group), slots.get_mut(group[0])) {
            slot.target = Target { aspect: bounds.aspect(), width: bounds.width * width, round: false };
            slot.bounds = bounds;
        }
    }
    slots
}

/// Panels that a person locked keep photo and crop. In another layout the photo goes to the panel of the same
/// place in the reading order, or to the nearest that is free.
fn lock_slots(
    slots: &mut [Slot],
    current: &Document,
    request: &Request,
    merges: &[Vec<usize>],
    same_layout: bool,
) {
    let heads: Vec<usize> = (0..slots.len()).filter(|&i| leader_of(merges, i) == i).collect();
    let locked = current.panels.iter().enumerate().filter(|(_, panel)| panel.locked);
    // Those that share an image have one place.
    for (i, panel) in locked.filter(|(i, _)| leader_of(&current.merges, *i) == *i) {
        let photo = panel.photo.as_ref().and_then(|id| request.photos.iter().position(|p| &p.id == id));
        let (Some(photo), Some(crop)) = (photo, panel.crop) else { continue };
        let free = heads.iter().filter(|&&head| slots[head].locked.is_none());
        let nearest = free.min_by_key(|head| head.abs_diff(i)).copied();
        let Some(place) = (if same_layout { Some(leader_of(merges, i)) } else { nearest }) else { continue };
        // The page's lengths may have changed since.
        let crop = crop.refitted(&request.photos[photo], slots[place].target.aspect);
        slots[place].locked = Some(Assignment { photo, crop });
    }
}

/// The photos of the current page in their order, framed anew for these panels, but where a person made the crop
/// and the layout is the same. A panel beyond the order, and one whose photo is gone, stays open.
fn kept(
    current: &Document,
    slots: &[Slot],
    photos: &[PhotoMeta],
    same_layout: bool,
) -> Vec<Option<Assignment>> {
    let position = |id: &str| photos.iter().position(|photo| photo.id == id);
    let mut used = vec![0u32; photos.len()];
    let heads = current.panels.iter().enumerate().filter(|(i, _)| leader_of(&current.merges, *i) == *i);
    let heads: Vec<&PanelContent> = heads.map(|(_, panel)| panel).collect();
    let shown: Vec<Option<&str>> = heads.iter().map(|panel| panel.photo.as_deref()).collect();
    // The panels say what is shown; the order goes on with what a page of fewer panels left out.
    let rest = current.order.iter().map(String::as_str).filter(|id| !shown.contains(&Some(id))).map(Some);
    let mut sequence = shown.iter().copied().chain(rest);
    slots
        .iter()
        .enumerate()
        .map(|(i, slot)| {
            let photo = sequence.next().flatten().and_then(position);
            if slot.locked.is_some() {
                return slot.locked;
            }
            let photo = photo?;
            let by_hand = heads.get(i).filter(|head| same_layout && head.edited).and_then(|head| head.crop);
            let crop = match by_hand {
                Some(crop) => crop.refitted(&photos[photo], slot.target.aspect),
                None => frame(&photos[photo], &slot.target, used[photo]),
            };
            used[photo] += 1;
            Some(Assignment { photo, crop })
        })
        .collect()
}

/// The photos of the panels, then those of the order before that have no panel now.
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
