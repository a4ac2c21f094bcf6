//! Which photo goes into which panel.

use oorandom::Rand64;

use super::frame::{Target, frame};
use super::photo::{Crop, PhotoMeta};
use crate::layout::{Bounds, ResolvedPanel, ResolvedShape};

/// Fingerprints at this distance or below are of nearly the same picture.
const NEAR_DUPLICATE: u32 = 10;
/// A panel this much heavier than the middle one is a hero.
const HERO: f32 = 1.5;

/// Whether the photos must keep the order in which they are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Along the reading order of the panels, photos keep the order in which they are given.
    Kept,
    /// Photos may go anywhere: the strongest into the panel of the greatest weight, upright ones into tall
    /// panels, otherwise by chance.
    Free,
}

/// A panel that wants a photo, in reading order.
#[derive(Debug, Clone, PartialEq)]
pub struct Slot {
    /// The crop that is wanted.
    pub target: Target,
    /// How much the panel draws the eye.
    pub weight: f32,
    /// Where it is, in page widths; panels that touch avoid the same photo.
    pub bounds: Bounds,
    /// What the panel shows in any case.
    pub locked: Option<Assignment>,
}

/// A panel's photo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assignment {
    /// Index of the photo in the list given.
    pub photo: usize,
    /// The part of it that is shown.
    pub crop: Crop,
}

/// The panels of a page as slots; `page_width` is the width of the exported page in pixels.
#[must_use]
pub fn slots(panels: &[ResolvedPanel], page_width: f64) -> Vec<Slot> {
    let slot = |panel: &ResolvedPanel| {
        let round = matches!(panel.shape, ResolvedShape::Circle { .. });
        let target = Target { aspect: panel.bounds.aspect(), width: panel.bounds.width * page_width, round };
        Slot { target, weight: panel.weight, bounds: panel.bounds, locked: None }
    };
    panels.iter().map(slot).collect()
}

/// Gives every panel a photo and a crop; empty when there are no photos. The answer depends on the arguments
/// alone.
///
/// With more photos than panels, those used are spread over the whole list, one from each stretch of it, and
/// chosen there by chance, sharpness, subjects and fit, avoiding near-duplicates; another `seed` chooses
/// others. With fewer, photos repeat with other crops, not in panels that touch if that can be avoided.
/// Locked panels keep what they have, and their photos are used elsewhere only when others run out.
#[must_use]
pub fn assign(photos: &[PhotoMeta], slots: &[Slot], order: Order, seed: u64) -> Vec<Assignment> {
    if photos.is_empty() {
        return Vec::new();
    }
    let mut random = Rand64::new(u128::from(seed) ^ 0x6c61_796f_7574);
    let sharpest = photos.iter().map(|p| p.sharpness).fold(f32::MIN_POSITIVE, f32::max);
    let strength: Vec<f64> = photos.iter().map(|photo| strength(photo, sharpest)).collect();
    let mut album = Album { photos, strength, uses: vec![0; photos.len()] };
    for locked in slots.iter().filter_map(|slot| slot.locked) {
        album.uses[locked.photo.min(photos.len() - 1)] += 1;
    }
    let open: Vec<usize> = (0..slots.len()).filter(|&i| slots[i].locked.is_none()).collect();
    let wanted: Vec<&Slot> = open.iter().map(|&i| &slots[i]).collect();
    let fresh: Vec<usize> = (0..photos.len()).filter(|&i| album.uses[i] == 0).collect();
    let mut chosen: Vec<Option<usize>> = slots.iter().map(|s| s.locked.map(|l| l.photo)).collect();
    if fresh.len() >= wanted.len() {
        let mut picked = album.pick(&fresh, &wanted, order, &mut random);
        if order == Order::Free {
            album.arrange(&mut picked, &wanted, &mut random);
        }
        for (&slot, photo) in open.iter().zip(picked) {
            chosen[slot] = Some(photo);
        }
    } else {
        let start = if order == Order::Free { random.rand_range(0..photos.len() as u64) as usize } else { 0 };
        album.repeat(slots, &open, &mut chosen, start);
    }
    album.crops(slots, &chosen)
}

struct Album<'a> {
    photos: &'a [PhotoMeta],
    strength: Vec<f64>,
    /// How often each photo is on the page.
    uses: Vec<u32>,
}

impl Album<'_> {
    /// One photo from each stretch of the list.
    fn pick(&self, fresh: &[usize], slots: &[&Slot], order: Order, random: &mut Rand64) -> Vec<usize> {
        let mut picked: Vec<usize> = Vec::with_capacity(slots.len());
        let stretch = fresh.len() as f64 / slots.len() as f64;
        for (i, slot) in slots.iter().enumerate() {
            let from = (i as f64 * stretch).floor() as usize;
            let to = (((i + 1) as f64 * stretch).floor() as usize).clamp(from + 1, fresh.len());
            let worth = |&photo: &usize, chance: f64| {
                let near = |other: &&usize| self.distance(photo, **other) <= NEAR_DUPLICATE;
                let fit = if order == Order::Kept { 0.6 * self.fit(photo, slot) } else { 0.0 };
                let twin = if picked.iter().any(|other| near(&other)) { 3.0 } else { 0.0 };
                chance + 0.5 * self.strength[photo] + fit - twin
            };
            let rated = fresh[from..to].iter().map(|photo| (worth(photo, random.rand_float()), *photo));
            let best = rated.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(fresh[from], |(_, photo)| photo);
            picked.push(best);
        }
        picked
    }

    /// Shuffles photos among panels: the strongest to the hero, the rest by chance and fit.
    fn arrange(&self, picked: &mut [usize], slots: &[&Slot], random: &mut Rand64) {
        for i in (1..picked.len()).rev() {
            picked.swap(i, random.rand_range(0..i as u64 + 1) as usize);
        }
        let n = picked.len();
        // Chance stays part of the matter, else every shuffle would find the same best order.
        let chance: Vec<f64> = (0..n * self.photos.len()).map(|_| random.rand_float() * 0.5).collect();
        let liking = |photo: usize, slot: usize| {
            let hero = f64::from(slots[slot].weight) * self.strength[photo];
            self.fit(photo, slots[slot]) + hero + chance[slot * self.photos.len() + photo]
        };
        for _ in 0..4 {
            for i in 0..n {
                for j in i + 1..n {
                    let (a, b) = (picked[i], picked[j]);
                    if liking(a, j) + liking(b, i) > liking(a, i) + liking(b, j) + 1e-9 {
                        picked.swap(i, j);
                    }
                }
            }
        }
        let Some(hero) = hero(slots) else { return };
        let strongest = (0..n).max_by(|&a, &b| self.strength[picked[a]].total_cmp(&self.strength[picked[b]]));
        if let Some(strongest) = strongest {
            picked.swap(hero, strongest);
        }
    }

    /// Fewer photos than panels: round the list again and again, but not into panels that touch.
    fn repeat(&mut self, slots: &[Slot], open: &[usize], chosen: &mut [Option<usize>], start: usize) {
        let n = self.photos.len();
        let mut next = start;
        for &slot in open {
            let touching: Vec<usize> = (0..slots.len())
                .filter(|&other| other != slot && touch(slots[slot].bounds, slots[other].bounds))
                .filter_map(|other| chosen[other])
                .collect();
            let ahead = |photo: usize| (photo + n - next % n) % n;
            let cost = |photo: &usize| (touching.contains(photo), self.uses[*photo], ahead(*photo));
            let best = (0..n).min_by_key(cost).unwrap_or(0);
            chosen[slot] = Some(best);
            self.uses[best] += 1;
            next = best + 1;
        }
    }

    fn crops(&self, slots: &[Slot], chosen: &[Option<usize>]) -> Vec<Assignment> {
        let mut shown = vec![0u32; self.photos.len()];
        for locked in slots.iter().filter_map(|slot| slot.locked) {
            shown[locked.photo.min(self.photos.len() - 1)] += 1;
        }
        let assignment = |(slot, photo): (&Slot, &Option<usize>)| {
            if let Some(locked) = slot.locked {
                return locked;
            }
            let photo = photo.unwrap_or(0);
            let crop = frame(&self.photos[photo], &slot.target, shown[photo]);
            shown[photo] += 1;
            Assignment { photo, crop }
        };
        slots.iter().zip(chosen).map(assignment).collect()
    }

    fn distance(&self, a: usize, b: usize) -> u32 {
        (self.photos[a].fingerprint ^ self.photos[b].fingerprint).count_ones()
    }

    /// How well a photo's shape suits a panel: 1 for the same aspect, 0 for four times.
    fn fit(&self, photo: usize, slot: &Slot) -> f64 {
        let ratio = (self.photos[photo].aspect() / slot.target.aspect.clamp(1e-3, 1e3)).ln().abs();
        (1.0 - ratio / 4f64.ln()).max(-1.0)
    }
}

/// What a photo has to offer, 0..1: sharpness within the album and subjects of a good size.
fn strength(photo: &PhotoMeta, sharpest: f32) -> f64 {
    let sharp = f64::from(photo.sharpness.max(0.0) / sharpest).min(1.0);
    let subject = photo.subjects.iter().map(|s| s.score * (s.width * s.height).sqrt().min(0.5) * 2.0);
    let subject = subject.fold(0.0, f64::max).clamp(0.0, 1.0);
    if sharp.is_nan() || subject.is_nan() { 0.0 } else { 0.4 * sharp + 0.6 * subject }
}

/// The panel of the greatest weight, when it stands out.
fn hero(slots: &[&Slot]) -> Option<usize> {
    let mut weights: Vec<f32> = slots.iter().map(|slot| slot.weight).collect();
    weights.sort_by(f32::total_cmp);
    let middle = weights.get(weights.len() / 2)?;
    let hero = (0..slots.len()).max_by(|&a, &b| slots[a].weight.total_cmp(&slots[b].weight))?;
    (slots[hero].weight > middle * HERO).then_some(hero)
}

/// Panels less than a generous gutter apart along an edge, or one on top of the other; corners do not count.
fn touch(a: Bounds, b: Bounds) -> bool {
    let apart = |a: f64, al: f64, b: f64, bl: f64| (b - a - al).max(a - b - bl);
    let (across, down) = (apart(a.x, a.width, b.x, b.width), apart(a.y, a.height, b.y, b.height));
    across.max(down) < 0.05 && across.min(down) < -0.01
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::framing::{FACE, Subject};
    use crate::layout::{PageSettings, catalogue, find, resolve};

    fn album(count: usize) -> Vec<PhotoMeta> {
        let photo = |i: usize| {
            let (width, height) = if i.is_multiple_of(3) { (3000, 4000) } else { (4000, 3000) };
            PhotoMeta {
                fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
                ..PhotoMeta::unmeasured(&format!("photo-{i}"), width, height)
            }
        };
        (0..count).map(photo).collect()
    }

    fn page(id: &str) -> Vec<Slot> {
        let settings = PageSettings::default();
        slots(&resolve(find(id).unwrap(), settings.aspect(), &settings), f64::from(settings.width))
    }

    fn photos(assignments: &[Assignment]) -> Vec<usize> {
        assignments.iter().map(|a| a.photo).collect()
    }

    #[test]
    fn chronology_is_kept_and_every_stretch_of_the_album_is_used() {
        let (photos_given, slots) = (album(40), page("grid-8"));
        let mut pages = Vec::new();
        for seed in 0..20 {
            let used = photos(&assign(&photos_given, &slots, Order::Kept, seed));
            assert!(used.windows(2).all(|pair| pair[0] < pair[1]), "{used:?}");
            assert!(used.iter().enumerate().all(|(i, photo)| photo / 5 == i), "{used:?}");
            pages.push(used);
        }
        pages.sort();
        pages.dedup();
        assert!(pages.len() > 15, "{} different pages of 20", pages.len());
    }

    #[test]
    fn as_many_photos_as_panels_are_all_used_in_order() {
        let used = photos(&assign(&album(6), &page("grid-6"), Order::Kept, 3));
        assert_eq!(used, [0, 1, 2, 3, 4, 5]);
        let mut used = photos(&assign(&album(6), &page("grid-6"), Order::Free, 3));
        used.sort_unstable();
        assert_eq!(used, [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn near_duplicates_are_passed_over() {
        let mut photos_given = album(8);
        for pair in photos_given.chunks_mut(2).take(2) {
            pair[1].fingerprint = 5;
        }
        for seed in 0..30 {
            let used = photos(&assign(&photos_given, &page("grid-4"), Order::Kept, seed));
            assert!(!(used.contains(&1) && used.contains(&3)), "{used:?}");
        }
    }

    #[test]
    fn few_photos_repeat_with_other_crops_and_not_side_by_side() {
        let slots = page("grid-6");
        let assignments = assign(&album(3), &slots, Order::Kept, 0);
        for (i, a) in assignments.iter().enumerate() {
            for (j, b) in assignments[..i].iter().enumerate() {
                if a.photo == b.photo {
                    assert!(!touch(slots[i].bounds, slots[j].bounds), "{i} and {j} touch");
                    assert!(a.crop.overlap(&b.crop) < 0.9, "{i} and {j} show the same");
                }
            }
        }
        assert_eq!(assign(&album(1), &slots, Order::Free, 0).len(), 6);
        assert!(assign(&[], &slots, Order::Free, 0).is_empty());
    }

    #[test]
    fn the_strongest_photo_is_the_hero_when_the_order_is_free() {
        let mut photos_given = album(5);
        let face = Subject { x: 0.3, y: 0.2, width: 0.3, height: 0.4, label: FACE.into(), score: 0.95 };
        photos_given[3].subjects.push(face);
        let slots = page("hero-middle-4");
        for seed in 0..10 {
            assert_eq!(assign(&photos_given, &slots, Order::Free, seed)[2].photo, 3);
        }
        assert_eq!(assign(&photos_given, &slots, Order::Kept, 0)[2].photo, 2);
    }

    #[test]
    fn locked_panels_keep_their_photo_and_no_other_panel_takes_it() {
        let mut slots = page("grid-4");
        let locked = Assignment { photo: 0, crop: Crop { x: 0.1, y: 0.1, width: 0.5, height: 0.5 } };
        slots[2].locked = Some(locked);
        for seed in 0..10 {
            let assignments = assign(&album(6), &slots, Order::Free, seed);
            assert_eq!(assignments[2], locked);
            assert_eq!(assignments.iter().filter(|a| a.photo == 0).count(), 1);
        }
    }

    proptest! {
        #[test]
        fn every_page_is_filled_the_same_way_twice(
            count in 1usize..30,
            layout in 0usize..1000,
            free: bool,
            seed: u64,
        ) {
            let template = &catalogue()[layout % catalogue().len()];
            let settings = PageSettings::default();
            let slots = slots(&resolve(template, settings.aspect(), &settings), 2480.0);
            let order = if free { Order::Free } else { Order::Kept };
            let photos_given = album(count);
            let assignments = assign(&photos_given, &slots, order, seed);
            prop_assert_eq!(assignments.len(), slots.len());
            prop_assert_eq!(&assignments, &assign(&photos_given, &slots, order, seed));
            let mut uses = vec![0usize; count];
            for a in &assignments {
                uses[a.photo] += 1;
            }
            // Nobody comes a second time before everybody has come once, as far as neighbours allow.
            let most = uses.iter().max().copied().unwrap_or(0);
            prop_assert!(count < slots.len() || most == 1, "{:?}", uses);
        }
    }
}
