//! A new document from photos, locks and a seed: the pure function behind every shuffle, choice and refinement.

use super::breaking;
use super::document::{Document, VERSION};
use super::fill::{Stage, contents};
use super::reference::LayoutRef;
use super::request::{Mode, Request};
use super::styling::{choose_style, papered};
use super::text_links::{carried, tied};
use crate::error::{Error, Result};
use crate::framing::PhotoMeta;
use crate::layout::merge::{mergeable, why_not_merge};
use crate::layout::{Template, Whole, whole};
use crate::plan::assign::Photos;
use crate::plan::layouts::{self, Wanted};
use crate::plan::prepared::worth_showing;
use crate::plan::{Assignment, Candidate, Order, Plan, Score, Shelf, Turns, compose};
use crate::select::DUPLICATE_THRESHOLD;
use oorandom::Rand64;
use std::borrow::Cow;

/// Probability of panels that share an image in a new layout.
const MERGE_CHANCE: f64 = 0.3;
/// Groups of panels that are tried in one layout.
const MERGES_TRIED: usize = 2;
/// Area of a starred photo that is shown whole, relative to the others.
const STARRED: f64 = 2.0;
/// Weight of a layout without merged panels, if merged ones are candidates too.
const UNMERGED: f64 = 0.5;

/// How bold the choice of the first page is: it is nearly always the best one.
const FIRST_HEAT: f64 = 0.3;

/// A document and its score.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned {
    /// The page.
    pub document: Document,
    /// How good it is.
    pub score: Score,
}

/// Plans a page for `request`.
///
/// # Errors
/// `no-photos`; `invalid-document` for page settings out of range; the errors of a requested layout or style
/// that does not exist.
pub fn plan(request: &Request) -> Result<Document> {
    planned(request, &Shelf::new(request.photos.len())).map(|planned| planned.document)
}

/// Like [`plan`], but also returns the score. The shelf has one place per photo and caches their analysis.
///
/// # Errors
/// As [`plan`].
pub fn planned(request: &Request, shelf: &Shelf) -> Result<Planned> {
    if request.photos.is_empty() {
        return Err(Error::NoPhotos);
    }
    request.page.validate()?;
    let mut random = Rand64::new(u128::from(request.seed));
    let current = request.current.as_ref();
    let stages = stages(request, &mut random)?;
    let always: Vec<usize> = stages.first().map(Stage::held).unwrap_or_default();
    let turns = Turns::of(&request.photos, &request.recent);
    let photos = Photos::new(&request.photos, &always, turns, shelf, &mut random)
        .with_duplicate_threshold(duplicate_threshold(request));
    let candidates: Vec<&Candidate> = stages.iter().map(|stage| &stage.candidate).collect();
    let free =
        request.mode == Mode::Photos || !request.ordered.unwrap_or_else(|| is_ordered(&request.photos));
    let order = if free { Order::Free } else { Order::Kept };
    // Merged panels come by chance, which needs a free choice.
    let merges = stages.iter().any(|stage| !stage.merges.is_empty());
    let usual = if current.is_none() && !merges { FIRST_HEAT } else { 1.0 };
    let heat = request.surprise.filter(|heat| heat.is_finite()).map_or(usual, |heat| heat.clamp(0.0, 4.0));
    let plan = compose(&candidates, &photos, order, heat, &mut random)
        .ok_or_else(|| Error::UnknownLayout("any".into()))?;
    let stage = &stages[plan.candidate];
    let whole = if shows_whole(request) { whole_photos(request, stage, &plan, free)? } else { None };
    let (stage, assigned) =
        whole.as_ref().map_or((stage, &plan.panels), |(stage, assigned)| (stage, assigned));
    let (order, panels) = contents(request, stage, assigned);
    let style = choose_style(request, &stages[plan.candidate], &plan, &mut random)?;
    style.style()?;
    // Text items follow their photos. Items of missing photos are left out, and the project stores them.
    let known =
        |current: &Document| current.words.iter().map(|word| tied(word, &current.panels)).collect::<Vec<_>>();
    let (words, _) = carried(&current.map(known).unwrap_or_default(), &panels);
    let mut document = Document {
        version: VERSION,
        seed: request.seed,
        layout: stage.layout.clone(),
        page: papered(&request.page, &style),
        // If only the style or layout changes, the rest of the page does not change.
        balanced: current.is_none_or(|current| current.balanced || !request.keep.photos),
        style,
        order,
        panels,
        merges: stage.merges.clone(),
        words,
        rest: current.map(|current| current.rest.clone()).unwrap_or_default(),
    };
    // Retained parts of the page do not change.
    if !request.keep.photos {
        breaking::by_chance(&mut document, &request.photos, request.figures)?;
    }
    Ok(Planned { document, score: plan.score })
}

/// Returns the threshold of near-duplicates, in bits of a fingerprint.
fn duplicate_threshold(request: &Request) -> u32 {
    request.duplicate_threshold.unwrap_or(DUPLICATE_THRESHOLD)
}

/// Whether the layout follows the photos. A page of one photo in a given layout is an exception, such as the cover of a book.
fn shows_whole(request: &Request) -> bool {
    request.page.whole_photos && (request.layout.is_none() || request.panels != Some(1))
}

/// Returns the planned page in a layout for whole photos, with the photos of its panels. `None` if it is impossible. The slants
/// of the planned layout stay. A layout that fits the photos already stays.
fn whole_photos(
    request: &Request,
    stage: &Stage,
    plan: &Plan,
    free: bool,
) -> Result<Option<(Stage, Vec<Assignment>)>> {
    let photos: Vec<usize> = plan.panels.iter().map(|assigned| assigned.photo).collect();
    let metas: Vec<&PhotoMeta> = photos.iter().map(|&photo| &request.photos[photo]).collect();
    let template = stage.layout.template()?;
    // Slanted panels have other aspect ratios than their photos.
    let stays = request.current.as_ref().is_some_and(|current| {
        let shown = current.panels.iter().map(|panel| panel.photo.as_deref());
        current.layout == stage.layout
            && template.shows_whole()
            && current.page.aspect().to_bits() == request.page.aspect().to_bits()
            && shown.eq(metas.iter().map(|photo| Some(photo.id.as_str())))
    });
    if stays || stage.fits(&metas) {
        return Ok(Some(stage.whole(request, stage.layout.clone(), &template, &photos)));
    }
    let wanted: Vec<Whole> = metas
        .iter()
        .map(|photo| Whole { aspect: photo.aspect(), share: if photo.starred { STARRED } else { 1.0 } })
        .collect();
    let slants = template.slants();
    let made = whole(&wanted, free, request.page.aspect(), &request.page, (&slants, request.seed));
    let Some((template, order)) = made else { return Ok(None) };
    let photos: Vec<usize> = order.into_iter().map(|place| photos[place]).collect();
    Ok(Some(stage.whole(request, LayoutRef::of(&template), &template, &photos)))
}

/// Whether the order of photos means something: they are frames of a video, or all are dated and not all of one moment.
fn is_ordered(photos: &[PhotoMeta]) -> bool {
    let are_dated = photos.iter().all(|photo| photo.taken.is_some())
        && photos.windows(2).any(|pair| pair[0].taken != pair[1].taken);
    are_dated || photos.iter().all(|photo| photo.frame)
}

/// The layouts that may become the page, with the groups of panels that may share an image.
fn stages(request: &Request, random: &mut Rand64) -> Result<Vec<Stage>> {
    let current = request.current.as_ref();
    let kept = current.filter(|_| request.keep.layout).map(|current| &current.layout);
    if let Some(layout) = request.layout.as_ref().or(kept) {
        let template = layout.template()?;
        let same_layout = current.is_some_and(|current| &current.layout == layout);
        let merges = merges_of(request, &template, same_layout, random)?;
        let stages = merges.into_iter().map(|merges| {
            Stage::new(
                request,
                layout.clone(),
                &template,
                merges,
                same_layout,
                (0, layouts::weight(template.family())),
            )
        });
        return Ok(stages.collect());
    }
    let shown: Vec<&str> = current
        .and_then(|current| current.layout.built_in())
        .into_iter()
        .chain(request.avoid.layouts.iter().map(String::as_str))
        .collect();
    let wanted = Wanted {
        aspect: request.page.aspect(),
        panels: request.panels,
        photos: worth_showing(&request.photos, duplicate_threshold(request)),
        shown: &shown,
        families: &request.within.layouts,
        taste: &request.taste,
    };
    let mut stages = Vec::new();
    let chance = request.merge.is_none() && request.panels.is_none() && random.rand_float() < MERGE_CHANCE;
    for (index, drawn) in layouts::draw(&wanted, random).into_iter().enumerate() {
        let template = Cow::Borrowed(drawn.template);
        let layout = LayoutRef::from(template.id());
        let same_layout = current.is_some_and(|current| current.layout == layout);
        let merges = merges_of(request, &template, same_layout, random)?;
        for merges in merges {
            let stage = |merges, prior| {
                Stage::new(request, layout.clone(), &template, merges, same_layout, (index, prior))
            };
            // A page of two panels that show one image would be a page with a bar across it.
            if chance && merges.is_empty() && template.panels().len() > 3 {
                for group in some(&mergeable(&template), MERGES_TRIED, random) {
                    stages.push(stage(vec![group], drawn.prior));
                }
                stages.push(stage(merges, drawn.prior * UNMERGED));
            } else {
                stages.push(stage(merges, drawn.prior));
            }
        }
    }
    Ok(stages)
}

/// Returns groups of panels that share an image: the requested or retained groups, or several alternatives if
/// the page may merge panels automatically.
fn merges_of(
    request: &Request,
    template: &Template,
    same_layout: bool,
    random: &mut Rand64,
) -> Result<Vec<Vec<Vec<usize>>>> {
    if shows_whole(request) {
        return Ok(vec![Vec::new()]);
    }
    if let Some(groups) = &request.merges {
        if let Some(bad) = groups.iter().find(|group| why_not_merge(template, group).is_some()) {
            let reason = format!("panels {bad:?} do not touch each other");
            return Err(Error::InvalidDocument { location: "merges".into(), reason });
        }
        return Ok(vec![groups.clone()]);
    }
    if let Some(current) = request.current.as_ref().filter(|_| same_layout) {
        return Ok(vec![current.merges.clone()]);
    }
    if request.merge != Some(true) {
        return Ok(vec![Vec::new()]);
    }
    let ways: Vec<Vec<Vec<usize>>> =
        some(&mergeable(template), 2 * MERGES_TRIED, random).into_iter().map(|group| vec![group]).collect();
    Ok(if ways.is_empty() { vec![Vec::new()] } else { ways })
}

/// Some of the items, drawn without putting back.
fn some<T: Clone>(items: &[T], count: usize, random: &mut Rand64) -> Vec<T> {
    let mut left: Vec<&T> = items.iter().collect();
    let mut drawn = Vec::new();
    while drawn.len() < count && !left.is_empty() {
        drawn.push(left.swap_remove(random.rand_range(0..left.len() as u64) as usize).clone());
    }
    drawn
}

#[cfg(test)]
mod tests {
    use super::super::request::{Keep, Mode};
    use super::*;
    use crate::framing::{Crop, Focus, PhotoMeta, Subject};
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

    #[test]
    fn photos_are_shown_whole_in_a_layout_of_their_own() {
        let mut wanted = request(14, 3);
        wanted.page.whole_photos = true;
        wanted.panels = Some(6);
        wanted.photos[2].starred = true;
        let page = plan(&wanted).unwrap();
        let part = |crop: &Crop| crop.width * crop.height;
        assert_eq!(page.panels.len(), 6);
        assert!(page.merges.is_empty());
        for panel in &page.panels {
            assert!(part(&panel.crop.unwrap()) > 0.9, "{panel:?}");
        }
        let ids = |page: &Document| page.panels.iter().map(|panel| panel.photo.clone()).collect::<Vec<_>>();
        // Another style does not change the layout.
        let keep = Keep { layout: true, style: false, photos: true };
        let again = plan(&Request { current: Some(page.clone()), keep, seed: 4, ..wanted.clone() }).unwrap();
        assert_eq!((&again.layout, ids(&again)), (&page.layout, ids(&page)));
        // Other photos get another layout, and a locked panel stays locked.
        let mut current = page.clone();
        current.panels[1].locked = true;
        let held = current.panels[1].photo.clone();
        let keep = Keep { layout: true, style: true, photos: false };
        let other = plan(&Request { current: Some(current), keep, seed: 9, ..wanted.clone() }).unwrap();
        assert!(other.panels.iter().any(|panel| panel.locked && panel.photo == held));
        assert!(other.panels.iter().all(|panel| part(&panel.crop.unwrap()) > 0.9));
        // A full page of a book stays full.
        let full = Request { layout: Some("splash-bleed".into()), panels: Some(1), ..wanted };
        assert_eq!(plan(&full).unwrap().layout, "splash-bleed".into());
    }

    fn request(count: usize, seed: u32) -> Request {
        Request {
            seed,
            photos: photos(count),
            page: PageSettings::default(),
            merge: Some(false),
            ..Request::default()
        }
    }

    fn shown(document: &Document) -> Vec<String> {
        document.panels.iter().filter_map(|panel| panel.photo.clone()).collect()
    }

    fn subject(label: &str, [x, y, width, height]: [f64; 4]) -> Subject {
        Subject {
            x,
            y,
            width,
            height,
            label: label.to_owned(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        }
    }

    #[test]
    fn a_person_beside_a_known_face_has_a_supposed_face() {
        let known = subject("face", [0.2, 0.3, 0.06, 0.08]);
        let faces = |others: &[Subject]| {
            let mut request = request(8, 3);
            for photo in &mut request.photos {
                photo.find(others.iter().cloned());
            }
            plan(&request).unwrap().panels[0].faces.clone()
        };
        let person = subject("person", [0.14, 0.25, 0.2, 0.7]);
        let neighbour = subject("person", [0.5, 0.3, 0.2, 0.65]);
        let passer_by = subject("person", [0.9, 0.4, 0.03, 0.1]);
        let found = faces(&[known.clone(), person.clone(), neighbour.clone(), passer_by.clone()]);
        assert_eq!(found.len(), 2, "{found:?}");
        let supposed = found.iter().find(|face| face.x > 0.4).unwrap();
        assert!((supposed.x + supposed.width / 2.0 - 0.6).abs() < 1e-3, "{supposed:?}");
        assert!(supposed.y > 0.3 && supposed.y + supposed.height < 0.5, "{supposed:?}");
        // Without a known face, the sizes of faces are not known.
        assert!(faces(&[person, neighbour, passer_by]).is_empty());
    }

    #[test]
    fn panels_know_the_faces_of_their_photos_and_a_page_of_before_has_none() {
        let face = |height: f64, label: &str| subject(label, [0.123_456, 0.2, 0.1, height]);
        let mut request = request(8, 3);
        for photo in &mut request.photos {
            photo.find([face(0.1, "face"), face(0.5, "person"), face(0.3, "face")]);
        }
        let page = plan(&request).unwrap();
        for panel in &page.panels {
            assert_eq!(panel.faces.iter().map(|face| face.height).collect::<Vec<_>>(), [0.3, 0.1]);
            assert!((panel.faces[0].x - 0.1235).abs() < 1e-12);
        }
        assert_eq!(Document::parse(&page.to_json()).unwrap(), page);
        let mut before: serde_json::Value = serde_json::from_str(&page.to_json()).unwrap();
        for panel in before["panels"].as_array_mut().unwrap() {
            panel.as_object_mut().unwrap().remove("faces");
        }
        let before = Document::parse(&before.to_string()).unwrap();
        assert!(before.panels.iter().all(|panel| panel.faces.is_empty()));
        assert!(!before.to_json().contains("faces"));
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
            let request = Request { ordered: Some(true), ..request(12, seed) };
            let shown = shown(&plan(&request).unwrap());
            assert!(shown.windows(2).all(|pair| pair[0] < pair[1]), "{shown:?}");
            assert!((3..=layouts::USUAL_MOST).contains(&shown.len()));
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
    fn a_lock_on_a_merged_page_repeats_no_photo_in_another_layout() {
        let mut wanted = request(8, 3);
        wanted.layout = Some("grid-4".into());
        let mut current = plan(&wanted).unwrap();
        current.merges = vec![vec![0, 1]];
        (wanted.current, wanted.layout) = (Some(current), None);
        wanted.keep = Keep { layout: true, style: true, photos: true };
        let merged = plan(&wanted).unwrap();
        for (locked, layout) in
            (0..4).flat_map(|i| ["grid-6", "hero-left-3", "grid-3", "cinema-4"].map(|id| (i, id)))
        {
            let mut current = merged.clone();
            current.panels[locked].locked = true;
            (wanted.current, wanted.layout) = (Some(current), Some(layout.into()));
            let page = plan(&wanted).unwrap();
            let photos: std::collections::BTreeSet<String> = shown(&page).into_iter().collect();
            assert_eq!(photos.len(), page.panels.len(), "panel {locked} locked, then {layout}");
            // A photo of the old page never makes room for a new one.
            let places = merged.panels.len() - 1;
            let stays = shown(&merged).into_iter().filter(|id| photos.contains(id));
            let stays: std::collections::BTreeSet<String> = stays.collect();
            assert_eq!(stays.len(), places.min(page.panels.len()), "panel {locked} locked, then {layout}");
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
        // With other photos or another layout, crops are computed again.
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
        assert_eq!(merged(&|wanted| wanted.layout = Some("grid-4".into())), 0);
    }

    #[test]
    fn only_panels_that_hang_together_merge_on_demand() {
        let mut wanted = request(12, 1);
        wanted.layout = Some("grid-4".into());
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
        wrong.layout = Some("nope".into());
        assert_eq!(plan(&wrong).unwrap_err().code(), "unknown-layout");
        let mut wrong = request(3, 1);
        wrong.style = Some("nope".into());
        assert_eq!(plan(&wrong).unwrap_err().code(), "unknown-style");
    }
}
