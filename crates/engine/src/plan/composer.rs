//! Creates plans, scores their visible content, and selects one at random by rank.
//!
//! ```text
//! for each of 16 layouts:  four assignments with a little chance, each judged on quick crops; the best stays
//! the best of all:         framed in earnest, judged again
//! the page:                drawn with P(rank) ~ exp(-rank / 2.5), so that the next shuffle is another page
//! ```

use oorandom::Rand64;

use super::assign::{MOST_BARE, Order, Photos, Worths, chosen, crops, looks, sizes, uses};
use super::best_first;
use super::prepared::Kind;
use super::slots::{Assignment, LEADS, Slot};
use super::turns::Turns;
use super::utility::Look;
use crate::framing::{FACE, PhotoMeta, closeup};

/// Assignments that are tried for each candidate. Odd ones avoid photos of this likeness, even ones only near-duplicates.
const TRIES: usize = 4;
const APART: f64 = 0.7;
/// Cost of two near-duplicates.
const ALIKE: f64 = 0.8;
/// Plans that are framed in earnest before one is drawn.
const FINALISTS: usize = 4;
/// Maximum number of finalists of one family of layouts.
const OF_A_FAMILY: usize = 1;
/// How fast the chance of a plan falls with its rank, and with its distance from the best score.
const FALL: f64 = 3.0;
const WORSE: f64 = 0.6;
/// Minimum area of a large panel, relative to the mean.
const LARGE: f64 = 1.25;
/// Usual number of panels, and the cost of each panel less. The fit is a mean, so pages with few panels fit best.
const USUAL: usize = 5;
const FEW: f64 = 0.2;
/// The part of a side of the leading panel that its largest person or animal should fill, and the cost if there is none.
const FILLS: f64 = 0.7;
const FAR: f64 = 0.4;
/// Bonus of a close crop next to the complete photo.
const NEARER: f64 = 0.05;
/// Differences in the visible size of a subject that separate close, middle and wide shots.
const SCALES: [f64; 2] = [0.06, 0.22];

/// A layout with its merges, as places for photos.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The places.
    pub slots: Vec<Slot>,
    /// Prior weight of the layout, 0 to 1.
    pub prior: f64,
    /// Group of similar candidates, for example candidates of one layout. Only the best one is used.
    pub layout: usize,
    /// The family of the layout.
    pub family: &'static str,
}

/// A page of one candidate.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Index of the candidate.
    pub candidate: usize,
    /// Photos and crops of its slots.
    pub panels: Vec<Assignment>,
    /// How good it is.
    pub score: Score,
}

/// How good a page is: the sum of its terms.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Score {
    /// Quality of the visible crops; the mean, large panels first.
    pub fit: f64,
    /// Whether the largest panel has one of the best photos.
    pub hero: f64,
    /// Look-alikes and repeats on the page, negative.
    pub alike: f64,
    /// How good the photos are, by the area of their panels.
    pub quality: f64,
    /// Strong photos without a panel, above all people; negative.
    pub missing: f64,
    /// Panels of bare photos, large ones most, and documents; negative.
    pub dull: f64,
    /// Photos that recent pages did not show.
    pub turns: f64,
    /// Prior weight of the layout, and a cost of few panels.
    pub prior: f64,
    /// Whether neighbours differ in scale.
    pub rhythm: f64,
}

impl Score {
    /// The terms with their names.
    #[must_use]
    pub fn terms(&self) -> [(&'static str, f64); 9] {
        [
            ("fit", self.fit),
            ("hero", self.hero),
            ("alike", self.alike),
            ("quality", self.quality),
            ("missing", self.missing),
            ("dull", self.dull),
            ("turns", self.turns),
            ("prior", self.prior),
            ("rhythm", self.rhythm),
        ]
    }

    /// Their sum.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.terms().iter().map(|(_, value)| value).sum()
    }
}

/// The plan of a page. `heat` is 1 for a usual draw and more for a bolder one, 0 for the best. Returns `None`
/// without candidates or photos.
#[must_use]
pub fn compose(
    candidates: &[&Candidate],
    photos: &Photos,
    order: Order,
    heat: f64,
    random: &mut Rand64,
) -> Option<Plan> {
    if photos.all.is_empty() {
        return None;
    }
    let mut best: Vec<(f64, usize, Vec<usize>)> = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let worths = Worths::of(&candidate.slots, photos);
        // If every slot already has its photo, a second try gives the same result.
        let tries = if worths.open.is_empty() { 1 } else { TRIES };
        for turn in 0..tries {
            let apart = if turn % 2 == 1 { APART } else { 1.0 };
            let chosen = chosen(&candidate.slots, &worths, photos, order, apart, random);
            let seen = looks(&candidate.slots, &chosen, photos);
            let score = score(candidate, &chosen, &seen, photos).total();
            match best.iter_mut().find(|(_, other, _)| candidates[*other].layout == candidate.layout) {
                Some(known) if known.0 < score => *known = (score, index, chosen),
                Some(_) => {}
                None => best.push((score, index, chosen)),
            }
        }
    }
    let finalists = (FINALISTS as f64 * heat.clamp(0.5, 2.0)).round().max(1.0) as usize;
    let ratings: Vec<f64> = best.iter().map(|(score, ..)| *score).collect();
    let mut families: Vec<&str> = Vec::new();
    let mut plans: Vec<Plan> = Vec::new();
    for at in best_first(&ratings) {
        let (_, candidate, chosen) = &best[at];
        let family = candidates[*candidate].family;
        if plans.len() >= finalists
            || families.iter().filter(|known| **known == family).count() == OF_A_FAMILY
        {
            continue;
        }
        families.push(family);
        let panels = crops(&candidates[*candidate].slots, chosen, photos);
        let score = judge(candidates[*candidate], &panels, photos);
        let plan = Plan { candidate: *candidate, panels, score };
        plans.push(with_closeup(candidates[*candidate], &plan, photos).unwrap_or(plan));
    }
    let ratings: Vec<f64> = plans.iter().map(|plan| plan.score.total()).collect();
    let order = best_first(&ratings);
    let weight = |(rank, &at): (usize, &usize)| {
        let worse = ratings[order[0]] - ratings[at];
        (-(rank as f64 / FALL + worse / WORSE) / heat.max(1e-3)).exp()
    };
    let weights: Vec<f64> = order.iter().enumerate().map(weight).collect();
    let mut left = random.rand_float() * weights.iter().sum::<f64>();
    let drawn = weights.iter().position(|weight| {
        left -= weight;
        left <= 0.0
    });
    order.get(drawn.unwrap_or(0)).map(|&at| plans.swap_remove(at))
}

/// Replaces the weakest photo of a plan by a close crop of a face. Returns `None` if this is not better, or if the photo must stay.
fn with_closeup(candidate: &Candidate, plan: &Plan, photos: &Photos) -> Option<Plan> {
    let slots = &candidate.slots;
    if photos.drawn.len() <= slots.len() {
        return None;
    }
    let photo = |slot: usize| plan.panels[slot].photo;
    let largest = sizes(slots).into_iter().fold(0.0, f64::max);
    let may_go = |&slot: &usize| {
        let meta = &photos.all[photo(slot)];
        slots[slot].photo().is_none()
            && sizes(slots)[slot] < LEADS * largest
            && photos.kind(photo(slot)) != Kind::Alive
            && photos.need(photo(slot)) < 1.0
            && !(meta.starred || meta.spoken || slots[slot].merged)
    };
    let weakest = (0..slots.len())
        .filter(may_go)
        .min_by(|&a, &b| photos.quality[photo(a)].total_cmp(&photos.quality[photo(b)]))?;
    // Other photos of people and animals come before a second crop of one.
    let shown = |photo: usize| {
        plan.panels.iter().any(|panel| panel.photo == photo || photos.are_duplicates(panel.photo, photo))
    };
    let waits = |&other: &usize| {
        photos.kind(other) == Kind::Alive
            && !shown(other)
            && photos.quality[other] > photos.quality[photo(weakest)]
    };
    if photos.drawn.iter().any(waits) {
        return None;
    }
    let near = (0..slots.len())
        .filter(|&slot| slots[slot].area > slots[weakest].area && photos.kind(photo(slot)) == Kind::Alive);
    // Near the leading photo, a close crop of its only person shows nothing new.
    let is_group = |photo: usize| photos.all[photo].subjects.iter().filter(|s| s.label == FACE).count() > 1;
    let near = near.filter(|&slot| sizes(slots)[slot] < LEADS * largest || is_group(photo(slot)));
    let once = |&slot: &usize| plan.panels.iter().filter(|panel| panel.photo == photo(slot)).count() == 1;
    let better = near.filter(once).filter_map(|slot| {
        let crop = closeup(&photos.all[photo(slot)], &slots[weakest].target, 0)?;
        let mut panels = plan.panels.clone();
        panels[weakest] = Assignment { photo: photo(slot), crop };
        let score = judge(candidate, &panels, photos);
        (score.total() > plan.score.total()).then_some(Plan { candidate: plan.candidate, panels, score })
    });
    better.max_by(|a, b| a.score.total().total_cmp(&b.score.total()))
}

/// Scores the photos and crops of a candidate.
#[must_use]
pub fn judge(candidate: &Candidate, panels: &[Assignment], photos: &Photos) -> Score {
    let seen: Vec<Look> = see(&candidate.slots, panels, photos);
    let chosen: Vec<usize> = panels.iter().map(|panel| panel.photo).collect();
    score(candidate, &chosen, &seen, photos)
}

/// Returns the visible content of the photos in their crops.
#[must_use]
pub fn see(slots: &[Slot], panels: &[Assignment], photos: &Photos) -> Vec<Look> {
    let chosen: Vec<usize> = panels.iter().map(|panel| panel.photo).collect();
    let look = |((slot, panel), turn): ((&Slot, &Assignment), u32)| {
        let prepared = photos.prepared(panel.photo);
        let (crop, energy) = prepared.crop_for(&photos.all[panel.photo], slot.target.aspect);
        let shrunk = panel.crop.width * panel.crop.height / (crop.width * crop.height).max(1e-9);
        Look::at(slot, prepared, &panel.crop, (energy * shrunk.min(1.0)).min(1.0), turn > 0)
    };
    slots.iter().zip(panels).zip(uses(slots, &chosen)).map(look).collect()
}

fn score(candidate: &Candidate, chosen: &[usize], seen: &[Look], photos: &Photos) -> Score {
    let sizes = sizes(&candidate.slots);
    let all: f64 = sizes.iter().map(|size| size.sqrt()).sum();
    let fits = seen.iter().zip(&sizes).map(|(look, size)| size.sqrt() * look.fit());
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    // If several panels are equally large, the one with the best photo leads.
    let leading = (0..sizes.len()).filter(|&i| sizes[i] >= LEADS * largest);
    let leading = leading.max_by(|&a, &b| photos.lead(chosen[a]).total_cmp(&photos.lead(chosen[b])));
    let hero = leading.map_or(0.0, |hero| {
        let photo = chosen[hero];
        let starred = photos.drawn.iter().any(|&i| photos.all[i].starred);
        let leads = ((sizes[hero] - 0.9) / 0.6).clamp(0.3, 1.0);
        let match_ = 0.7 * leads * photos.lead(photo);
        // The user expects to see a starred photo large, so other pages get a penalty.
        let large = if sizes[hero] < LARGE { -1.5 } else { 0.0 };
        let star = if photos.all[photo].starred { 3.0 * leads + large } else { -3.0 };
        let far = (1.0 - seen[hero].figure / FILLS).max(0.0);
        match_ - FAR * far + if starred { star } else { 0.0 }
    });
    let mut alike = 0.0;
    for (i, &a) in chosen.iter().enumerate() {
        for (j, &b) in chosen[..i].iter().enumerate() {
            // A repeated photo costs, unless the second crop is close.
            let again = |look: &Look| if look.near { -NEARER } else { 0.3 };
            alike -=
                if a == b { again(&seen[i]).min(again(&seen[j])) } else { ALIKE * photos.likeness(a, b) };
        }
    }
    let share = |slot: usize| sizes[slot] / sizes.len() as f64;
    let quality = chosen.iter().enumerate().map(|(slot, &photo)| share(slot) * photos.quality[photo]);
    let dull = chosen.iter().enumerate().map(|(slot, &photo)| match photos.kind(photo) {
        Kind::Bare if share(slot) > MOST_BARE => -0.8,
        Kind::Bare => -0.4,
        Kind::Document => -1.0,
        _ => 0.0,
    });
    let turns = chosen.iter().map(|&photo| photos.need(photo));
    // A merged slot has two panels or more.
    let panels = candidate.slots.iter().map(|slot| 1 + usize::from(slot.merged)).sum();
    Score {
        fit: fits.sum::<f64>() / all.max(1e-9),
        hero,
        alike,
        quality: 2.0 * quality.sum::<f64>(),
        missing: missing(chosen, photos),
        dull: dull.sum(),
        turns: 0.4 * turns.sum::<f64>(),
        prior: 0.4 * candidate.prior - few(panels, photos),
        rhythm: 0.06 * rhythm(seen),
    }
}

/// Returns the cost of a page that has few panels although the album has more photos.
fn few(panels: usize, photos: &Photos) -> f64 {
    let usual = USUAL.min(photos.drawn.len());
    FEW * usual.saturating_sub(panels) as f64
}

/// Returns the cost of strong photos without a panel.
fn missing(chosen: &[usize], photos: &Photos) -> f64 {
    let cost = |wanted: &dyn Fn(usize) -> bool, most: f64| {
        let there = photos.drawn.iter().filter(|&&photo| wanted(photo)).count();
        let goal = (there as f64).min(most).max(0.0);
        let shown = photos.drawn.iter().filter(|&&photo| wanted(photo) && chosen.contains(&photo)).count();
        if goal > 0.0 { (1.0 - shown as f64 / goal).max(0.0) } else { 0.0 }
    };
    let panels = chosen.len() as f64;
    let strong = cost(&|photo| photos.rank[photo] > 2.0 / 3.0, 0.7 * panels);
    let alive = cost(&|photo| photos.kind(photo) == Kind::Alive, panels);
    -0.4 * strong - 1.4 * alive
}

/// The part of neighbours in reading order whose scales differ.
fn rhythm(seen: &[Look]) -> f64 {
    let scale = |look: &Look| SCALES.iter().filter(|&&least| look.close >= least).count();
    let pairs = seen.windows(2);
    let count = pairs.len();
    let differ = pairs.filter(|pair| scale(&pair[0]) != scale(&pair[1])).count();
    if count > 0 { differ as f64 / count as f64 } else { 0.0 }
}

/// Returns photos that may repeat on any number of pages. Only for [`judge`].
#[must_use]
pub fn gallery<'a>(photos: &'a [PhotoMeta], shelf: &'a super::Shelf) -> Photos<'a> {
    let every: Vec<usize> = (0..photos.len()).collect();
    Photos::new(photos, &every, Turns::default(), shelf, &mut Rand64::new(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framing::{Crop, Subject};
    use crate::layout::{PageSettings, find, resolve};
    use crate::plan::{Shelf, slots};

    #[test]
    fn a_close_crop_beside_the_leading_photo_needs_a_group() {
        let page = PageSettings::default();
        let slots = slots(&resolve(find("hero-top-3").unwrap(), page.aspect(), &page), f64::from(page.width));
        let candidate = Candidate { slots, prior: 1.0, layout: 0, family: "hero" };
        let repeats = |faces: u32| {
            let mut all: Vec<PhotoMeta> = (0..5)
                .map(|i: u64| PhotoMeta {
                    fingerprint: (i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
                    ..PhotoMeta::unmeasured(&i.to_string(), 4000, 3000)
                })
                .collect();
            let face = |i: u32| Subject {
                x: 0.2 + 0.3 * f64::from(i),
                y: 0.3,
                width: 0.12,
                height: 0.16,
                label: FACE.into(),
                score: 0.95,
                points: None,
                expression: None,
                light: None,
            };
            all[0].find((0..faces).map(face));
            let shelf = Shelf::new(all.len());
            let photos = Photos::new(&all, &[], Turns::default(), &shelf, &mut Rand64::new(1));
            let plan = compose(&[&candidate], &photos, Order::Free, 0.0, &mut Rand64::new(1)).unwrap();
            plan.panels.iter().filter(|panel| panel.photo == 0).count()
        };
        assert_eq!((repeats(1), repeats(2)), (1, 2));
    }

    #[test]
    fn a_leading_photo_shows_people_from_near_or_a_large_group() {
        /// Height of a person, as a part of the photo.
        const HIGH: f64 = 0.28;
        let page = PageSettings::default();
        let slots = slots(&resolve(find("hero-top-3").unwrap(), page.aspect(), &page), f64::from(page.width));
        let candidate = Candidate { slots, prior: 1.0, layout: 0, family: "hero" };
        // The lead term of people in a crop of that part of the photo.
        let hero = |people: u32, with_faces: bool, part: f64| {
            let mut photo = PhotoMeta::unmeasured("people", 4000, 4000);
            let subject = |label: &str, x: f64, side: f64| Subject {
                x,
                y: 0.3,
                width: side / 4.0,
                height: side,
                label: label.into(),
                score: 0.95,
                points: None,
                expression: None,
                light: None,
            };
            let person = |i: u32| {
                let x = 0.3 + 0.08 * f64::from(i);
                let face = with_faces.then(|| subject(FACE, x, HIGH / 5.0));
                std::iter::once(subject("person", x, HIGH)).chain(face)
            };
            photo.find((0..people).flat_map(person));
            let all = [photo];
            let shelf = Shelf::new(1);
            let crop = Crop { x: 0.25, y: 0.25, width: part, height: part };
            let panels = vec![Assignment { photo: 0, crop }; candidate.slots.len()];
            judge(&candidate, &panels, &gallery(&all, &shelf)).hero
        };
        let (far, near) = (hero(1, true, 0.7), hero(1, true, 0.4));
        assert!((near - far - FAR * (1.0 - HIGH / 0.7 / FILLS)).abs() < 0.02, "{far} {near}");
        assert!((near - hero(1, false, 0.4) - FAR).abs() < 0.02, "people without faces do not count");
        let group = hero(5, true, 0.7);
        assert!((near - group).abs() < 0.02, "{near} {group}");
    }

    #[test]
    fn few_panels_cost_if_the_album_has_more_photos() {
        let cost = |count: usize, panels: usize| {
            let album: Vec<PhotoMeta> =
                (0..count).map(|i| PhotoMeta::unmeasured(&i.to_string(), 1600, 1200)).collect();
            let shelf = Shelf::new(count);
            few(panels, &gallery(&album, &shelf))
        };
        assert!(cost(12, 5) == 0.0 && cost(12, 6) == 0.0 && cost(3, 3) == 0.0);
        assert!((cost(12, 3) - 2.0 * FEW).abs() < 1e-9);
    }
}
