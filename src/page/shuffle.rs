//! A new document from photos, locks and a seed: the pure function behind every shuffle, choice and refinement.

use super::document::{Document, VERSION, style_of, template_of};
use super::fill::choose_photos;
use super::request::Request;
use super::styling::choose_style;
use crate::error::{Error, Result};
use crate::layout::merge::{can_merge, mergeable};
use crate::layout::{self, Template};
use oorandom::Rand64;
use serde_json::Value;

/// Most panels that a page gets unless more are asked for.
const USUAL_MOST: usize = 9;

/// Share of new layouts that get merged panels.
const MERGE_CHANCE: f64 = 0.3;

/// Makes the page that `request` asks for.
///
/// # Errors
/// `no-photos`; `invalid-document` for page settings out of range; the errors of a layout or style that is
/// asked for and does not exist.
pub fn plan(request: &Request) -> Result<Document> {
    if request.photos.is_empty() {
        return Err(Error::NoPhotos);
    }
    request.page.validate()?;
    let mut random = Rand64::new(u128::from(request.seed));
    let current = request.current.as_ref();
    let layout = choose_layout(request, &mut random)?;
    let template = template_of(&layout)?;
    let style = choose_style(request, &mut random)?;
    style_of(&style)?;
    let same_layout = current.is_some_and(|current| current.layout == layout);
    let merges = choose_merges(request, &template, same_layout, &mut random)?;
    let (order, panels) = choose_photos(request, &template, &merges, same_layout);
    Ok(Document {
        version: VERSION,
        seed: request.seed,
        layout,
        style,
        order,
        panels,
        merges,
        page: request.page.clone(),
        // Words follow their panels into another layout.
        words: current.map(|current| current.words.clone()).unwrap_or_default(),
        rest: current.map(|current| current.rest.clone()).unwrap_or_default(),
    })
}

fn choose_layout(request: &Request, random: &mut Rand64) -> Result<Value> {
    if let Some(layout) = &request.layout {
        return Ok(layout.clone());
    }
    let current = request.current.as_ref();
    if let Some(current) = current.filter(|_| request.keep.layout) {
        return Ok(current.layout.clone());
    }
    let aspect = request.page.aspect();
    let good = layout::good_for(aspect);
    // Every page has at least one template; where none is good the whole list is still better than nothing.
    let good = if good.is_empty() { layout::catalogue().iter().collect() } else { good };
    let wanted = request.panels.unwrap_or_else(|| usual_count(request.photos.len(), &good, random));
    let distance = |template: &&Template| template.panels().len().abs_diff(wanted);
    let nearest = good.iter().map(distance).min().unwrap_or(0);
    let mut fitting: Vec<&Template> = good.into_iter().filter(|t| distance(t) == nearest).collect();
    let shown = current.and_then(|current| current.layout.as_str());
    if fitting.len() > 1 {
        fitting.retain(|template| Some(template.id()) != shown);
    }
    let template = pick(&fitting, random).ok_or_else(|| Error::UnknownLayout("any".into()))?;
    Ok(Value::String(template.id().to_owned()))
}

/// A number of panels that so many photos fill without repeats, neither always the same nor a page of stamps.
fn usual_count(photos: usize, good: &[&Template], random: &mut Rand64) -> usize {
    let most = photos.min(USUAL_MOST);
    let least = photos.min(3).min(most);
    let offered: Vec<usize> = good.iter().map(|t| t.panels().len()).collect();
    // Counts with more templates come more often, so that no template is rare because its count is common.
    let fitting: Vec<&usize> = offered.iter().filter(|count| (least..=most).contains(count)).collect();
    pick(&fitting, random).map_or(most, |count| **count)
}

fn choose_merges(
    request: &Request,
    template: &Template,
    same_layout: bool,
    random: &mut Rand64,
) -> Result<Vec<Vec<usize>>> {
    if let Some(groups) = &request.merges {
        if let Some(bad) = groups.iter().find(|group| !can_merge(template, group)) {
            let reason = format!("panels {bad:?} do not hang together");
            return Err(Error::InvalidDocument { location: "merges".into(), reason });
        }
        return Ok(groups.clone());
    }
    if let Some(current) = request.current.as_ref().filter(|_| same_layout) {
        return Ok(current.merges.clone());
    }
    let groups = mergeable(template);
    let free = request.layout.is_none() && request.panels.is_none();
    let wanted = request.merge.unwrap_or_else(|| free && random.rand_float() < MERGE_CHANCE);
    // A page of two panels that show one image would be a page with a bar across it.
    let wanted = wanted && (template.panels().len() > 3 || request.merge == Some(true));
    Ok(pick(&groups, random).filter(|_| wanted).cloned().into_iter().collect())
}

pub(super) fn pick<'a, T>(items: &'a [T], random: &mut Rand64) -> Option<&'a T> {
    if items.is_empty() {
        return None;
    }
    items.get(random.rand_range(0..items.len() as u64) as usize)
}

#[cfg(test)]
mod tests {
    use super::super::request::{Keep, Mode};
    use super::*;
    use crate::framing::{Crop, Focus, PhotoMeta};
    use crate::layout::PageSettings;

    fn photos(count: usize) -> Vec<PhotoMeta> {
        (0..count)
            .map(|i| PhotoMeta {
                // Far from each other, so that nothing counts as a near-duplicate.
                fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
                ..PhotoMeta::unmeasured(&format!("p{i:02}"), 4000, if i % 3 == 0 { 6000 } else { 3000 })
            })
            .collect()
    }

    fn request(count: usize, seed: u32) -> Request {
        Request {
            seed,
            photos: photos(count),
            page: PageSettings::default(),
            current: None,
            keep: Keep::default(),
            layout: None,
            style: None,
            styling: crate::page::styling::Styling::default(),
            panels: None,
            mode: Mode::Shuffle,
            merge: Some(false),
            merges: None,
        }
    }

    fn shown(document: &Document) -> Vec<String> {
        document.panels.iter().filter_map(|panel| panel.photo.clone()).collect()
    }

    #[test]
    fn the_same_request_gives_the_same_page_and_another_seed_another() {
        for seed in 0..50 {
            let (one, two) = (plan(&request(12, seed)).unwrap(), plan(&request(12, seed)).unwrap());
            assert_eq!(one, two);
            let other = plan(&request(12, seed + 1)).unwrap();
            assert_ne!((&one.layout, &one.style, shown(&one)), (&other.layout, &other.style, shown(&other)));
        }
    }

    #[test]
    fn photos_stay_in_order_and_do_not_repeat_while_there_are_enough() {
        for seed in 0..100 {
            let shown = shown(&plan(&request(12, seed)).unwrap());
            assert!(shown.windows(2).all(|pair| pair[0] < pair[1]), "{shown:?}");
            assert!((3..=USUAL_MOST).contains(&shown.len()));
        }
    }

    #[test]
    fn each_lock_holds_its_part_alone() {
        let current = plan(&request(12, 1)).unwrap();
        for seed in 2..40 {
            let mut next = request(12, seed);
            next.current = Some(current.clone());
            next.keep = Keep { layout: true, style: false, photos: false };
            let page = plan(&next).unwrap();
            assert!(page.layout == current.layout && page.style != current.style);
            next.keep = Keep { layout: false, style: true, photos: false };
            let page = plan(&next).unwrap();
            assert!(page.layout != current.layout && page.style == current.style);
            next.keep = Keep { layout: false, style: false, photos: true };
            let page = plan(&next).unwrap();
            let common = shown(&page).len().min(shown(&current).len());
            assert_eq!(shown(&page)[..common], shown(&current)[..common]);
        }
    }

    #[test]
    fn keeping_all_changes_nothing() {
        let current = plan(&request(12, 5)).unwrap();
        let mut next = request(12, 5);
        next.current = Some(current.clone());
        next.keep = Keep { layout: true, style: true, photos: true };
        assert_eq!(plan(&next).unwrap(), current);
    }

    #[test]
    fn a_smaller_page_forgets_no_photo_of_the_order() {
        let mut large = request(12, 3);
        large.panels = Some(8);
        let large = plan(&large).unwrap();
        let mut small = request(12, 4);
        (small.current, small.panels) = (Some(large.clone()), Some(3));
        small.keep = Keep { layout: false, style: true, photos: true };
        let small = plan(&small).unwrap();
        let mut again = request(12, 6);
        (again.current, again.layout) = (Some(small), Some(large.layout.clone()));
        again.keep = Keep { layout: true, style: true, photos: true };
        assert_eq!(shown(&plan(&again).unwrap()), shown(&large));
    }

    #[test]
    fn a_locked_panel_keeps_photo_and_crop() {
        let mut current = plan(&request(12, 7)).unwrap();
        current.panels[1].locked = true;
        for seed in 8..30 {
            let mut next = request(12, seed);
            next.current = Some(current.clone());
            next.keep = Keep { layout: true, style: false, photos: false };
            next.mode = Mode::Photos;
            assert_eq!(plan(&next).unwrap().panels[1], current.panels[1]);
        }
    }

    #[test]
    fn a_locked_photo_finds_a_panel_in_every_layout() {
        let mut current = plan(&request(12, 7)).unwrap();
        let last = current.panels.len() - 1;
        current.panels[last].locked = true;
        for seed in 8..40 {
            let mut next = request(12, seed);
            (next.current, next.panels) = (Some(current.clone()), Some(2 + seed as usize % 6));
            let page = plan(&next).unwrap();
            let kept: Vec<_> = page.panels.iter().filter(|panel| panel.locked).collect();
            assert_eq!(kept.len(), 1, "seed {seed}");
            assert_eq!(kept[0].photo, current.panels[last].photo);
        }
    }

    #[test]
    fn a_crop_made_by_hand_stays_while_its_photo_does() {
        let mut current = plan(&request(12, 7)).unwrap();
        let half = |c: Crop| Crop { width: c.width / 2.0, height: c.height / 2.0, ..c };
        let by_hand = current.panels[1].crop.map(half);
        (current.panels[1].crop, current.panels[1].edited) = (by_hand, true);
        let mut next = request(12, 7);
        next.current = Some(current.clone());
        next.keep = Keep { layout: true, style: false, photos: true };
        next.photos.iter_mut().for_each(|p| p.focus = Some(Focus { x: 0.9, y: 0.9 }));
        assert_eq!(plan(&next).unwrap().panels[1], current.panels[1]);
        // Wider gutters change the panel's aspect; the crop follows about its centre.
        next.page.gutter = 0.06;
        let (before, after) = (by_hand.unwrap(), plan(&next).unwrap().panels[1].clone());
        let crop = after.crop.unwrap();
        assert!(after.edited && crop != before);
        assert!((crop.width * crop.height / before.width / before.height - 1.0).abs() < 1e-6);
        assert!((crop.x + crop.width / 2.0 - before.x - before.width / 2.0).abs() < 0.02);
        // Other photos and other layouts are framed anew.
        for (layout, photos) in [(true, false), (false, true)] {
            next.keep = Keep { layout, style: true, photos };
            assert!(plan(&next).unwrap().panels.iter().all(|panel| !panel.edited));
        }
    }

    #[test]
    fn merged_panels_share_one_photo_and_the_others_go_on() {
        for seed in 0..40 {
            let mut wanted = request(12, seed);
            (wanted.merge, wanted.panels) = (Some(true), Some(6));
            let page = plan(&wanted).unwrap();
            let Some(group) = page.merges.first() else { continue };
            assert!(group.iter().all(|&i| page.panels[i] == page.panels[group[0]]));
            let photos: std::collections::BTreeSet<String> = shown(&page).into_iter().collect();
            assert_eq!(photos.len(), page.panels.len() + 1 - group.len());
            wanted.current = Some(page.clone());
            wanted.keep = Keep { layout: true, style: true, photos: true };
            assert_eq!(plan(&wanted).unwrap(), page, "keeping all keeps the merge");
            wanted.merges = Some(Vec::new());
            let split = plan(&wanted).unwrap();
            assert!(split.merges.is_empty() && split.layout == page.layout);
        }
    }

    #[test]
    fn chance_merges_panels_of_free_pages_only() {
        let merged = |change: &dyn Fn(&mut Request)| {
            (0..200)
                .filter(|&seed| {
                    let mut wanted = Request { merge: None, ..request(12, seed) };
                    change(&mut wanted);
                    !plan(&wanted).unwrap().merges.is_empty()
                })
                .count()
        };
        assert!((20..100).contains(&merged(&|_| ())));
        assert_eq!(merged(&|wanted| wanted.panels = Some(6)), 0);
        assert_eq!(merged(&|wanted| wanted.layout = Some(Value::String("grid-4".into()))), 0);
    }

    #[test]
    fn only_panels_that_hang_together_merge_on_demand() {
        let mut wanted = request(12, 1);
        wanted.layout = Some(Value::String("grid-4".into()));
        wanted.merges = Some(vec![vec![0, 3]]);
        assert_eq!(plan(&wanted).unwrap_err().code(), "invalid-document");
        wanted.merges = Some(vec![vec![0, 1]]);
        assert_eq!(plan(&wanted).unwrap().merges, [[0, 1]]);
    }

    #[test]
    fn one_photo_fills_any_layout_and_none_is_an_error() {
        let mut one = request(1, 9);
        one.panels = Some(6);
        assert!(plan(&one).unwrap().panels.iter().all(|panel| panel.photo.as_deref() == Some("p00")));
        assert_eq!(plan(&request(0, 9)).unwrap_err().code(), "no-photos");
    }

    #[test]
    fn unknown_layouts_and_styles_are_errors() {
        let mut wrong = request(3, 1);
        wrong.layout = Some(Value::String("nope".into()));
        assert_eq!(plan(&wrong).unwrap_err().code(), "unknown-layout");
        let mut wrong = request(3, 1);
        wrong.style = Some(Value::String("nope".into()));
        assert_eq!(plan(&wrong).unwrap_err().code(), "unknown-style");
    }
}
