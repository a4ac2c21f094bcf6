//! Photos to panels, by exact assignment: along the order of the album by dynamic programming, in any order
//! by the Hungarian method. The small random term lets two plans of one layout differ.

use oorandom::Rand64;

use super::best_first;
use super::prepared::{Kind, Prepared, Shelf, are_duplicates, likeness};
use super::slots::{Assignment, LEADS, Slot, touch};
use super::turns::Turns;
use super::utility::{Look, placed};
use crate::framing::{PhotoMeta, Subject, frame};
use crate::raster::balance::GRAY;
use crate::select::DUPLICATE_THRESHOLD;

/// The most photos that one plan chooses from; of larger albums some are drawn.
const MOST: usize = 60;
/// Weight of the random term.
const NOISE: f64 = 0.12;
/// Bonus of one of the best photos in the largest panel, and the quality gap at which the bonus ends.
const HERO: f64 = 1.2;
const GAP: f64 = 0.22;
/// Value of the quality of a photo in any panel, however small. A dull photo fits small panels well, so its fit is no
/// reason to show it.
const SHOWN: f64 = 0.9;
/// Cost of a bare photo in a panel above a fifth of the page and in a smaller one, and of a document in any panel.
const BARE: f64 = 3.0;
const SMALL_BARE: f64 = 0.6;
const DOCUMENT: f64 = 4.0;
/// Minimum sharpness as a fraction of the sharpest photo, and minimum tonal range. Photos below lose quality.
const LEAST_SHARP: f64 = 0.5;
const LEAST_TONAL: f64 = 0.35;
/// The part of its quality that a completely blurred photo loses.
const BLURRED: f64 = 0.65;
/// Factor of the quality of gray photos among photos with colours.
const GRAY_QUALITY: f64 = 0.7;
/// Number of photos of an album that can leave some out: two more than a usual page shows.
const TO_SPARE: usize = 7;
/// Number of photos whose mean quality leads are compared with.
const TOP: usize = 2;
/// Maximum share of the page for a bare photo.
pub(super) const MOST_BARE: f64 = 0.2;
/// Bonus of a starred photo in the largest panel.
const STAR: f64 = 6.0;
/// Bonus of a photo with text items in any panel, so that the text stays visible on the next page.
const SPOKEN: f64 = 6.0;
/// A pair that must not be.
const NEVER: f64 = -1e6;

/// Whether the photos must keep the order in which they are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Along the reading order of the panels, photos keep the order in which they are given.
    Kept,
    /// Photos may have any order.
    Free,
}

/// The photos that a plan chooses from, with their analysis data.
pub struct Photos<'a> {
    /// All photos of the request, in their order.
    pub all: &'a [PhotoMeta],
    /// Indices of the photos that may be chosen, ascending. Large albums are sampled.
    pub drawn: Vec<usize>,
    /// For each of all: how good it is, 0 to 1.
    pub quality: Vec<f64>,
    /// For each of all: the part of the album that is no better, 0 to 1.
    pub rank: Vec<f64>,
    /// Turns of the photos.
    pub turns: Turns,
    /// Mean quality of the best photos.
    top: f64,
    /// Maximum fingerprint distance of near-duplicates, in bits.
    duplicate_threshold: u32,
    shelf: &'a Shelf,
}

impl<'a> Photos<'a> {
    /// Samples a large album. It prefers good photos, and always includes starred photos, photos with text,
    /// and `always`.
    #[must_use]
    pub fn new(
        all: &'a [PhotoMeta],
        always: &[usize],
        turns: Turns,
        shelf: &'a Shelf,
        random: &mut Rand64,
    ) -> Self {
        let sharpest =
            all.iter().map(|p| p.sharpness).filter(|s| s.is_finite()).fold(f32::MIN_POSITIVE, f32::max);
        let sharp = |photo: &PhotoMeta| {
            let sharp = f64::from(photo.sharpness.max(0.0) / sharpest);
            if sharp.is_nan() { 0.0 } else { sharp.min(1.0).powf(0.4) }
        };
        let mut drawn: Vec<usize> = (0..all.len()).collect();
        if all.len() > MOST {
            // Takes one photo from every stretch of the album. Cheap measures decide within a stretch.
            let stretch = all.len() as f64 / MOST as f64;
            let rated = |i: usize, random: &mut Rand64| {
                let alive = 0.9 * f64::from(u8::from(all[i].subjects.iter().any(Subject::is_alive)));
                0.5 * sharp(&all[i]) + alive + turns.need(i) + random.rand_float()
            };
            let mut some: Vec<usize> = (0..MOST)
                .filter_map(|k| {
                    let (from, to) = ((k as f64 * stretch) as usize, ((k + 1) as f64 * stretch) as usize);
                    let rates: Vec<(f64, usize)> =
                        (from..to.clamp(from + 1, all.len())).map(|i| (rated(i, random), i)).collect();
                    rates.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
                })
                .collect();
            some.extend(always);
            some.extend((0..all.len()).filter(|&i| all[i].starred).take(8));
            some.extend((0..all.len()).filter(|&i| all[i].spoken));
            drawn.retain(|i| some.contains(i));
        }
        let mut quality = vec![0.0; all.len()];
        // On a page with colours, a gray photo looks like an accident.
        let colourful = 2 * drawn.iter().filter(|&&i| is_gray(&all[i])).count() < drawn.len();
        for &i in &drawn {
            let prepared = shelf.get(i, &all[i]);
            let (sharp, tonal) = (sharp(&all[i]), prepared.tonal);
            // Sharpness and tones are minimum requirements: beyond them people look at what is shown.
            let poor = 1.0
                - BLURRED * (1.0 - sharp / LEAST_SHARP).max(0.0)
                - 0.4 * (1.0 - tonal / LEAST_TONAL).max(0.0);
            let text = if prepared.kind == Kind::Document { 0.3 } else { 1.0 };
            let gray = if colourful && is_gray(&all[i]) { GRAY_QUALITY } else { 1.0 };
            quality[i] = gray * text * poor * (0.68 * prepared.care + 0.21 * tonal + 0.11 * sharp);
        }
        let below = |q: f64| drawn.iter().filter(|&&other| quality[other] <= q).count();
        let mut rank = vec![0.0; all.len()];
        for &i in &drawn {
            rank[i] = below(quality[i]) as f64 / drawn.len() as f64;
        }
        let known: Vec<f64> = drawn.iter().map(|&i| quality[i]).collect();
        let best: Vec<f64> = best_first(&known).into_iter().take(TOP).map(|at| known[at]).collect();
        let top = best.iter().sum::<f64>() / best.len().max(1) as f64;
        Self { all, drawn, quality, rank, turns, top, duplicate_threshold: DUPLICATE_THRESHOLD, shelf }
    }

    /// A photo, ready to be placed.
    #[must_use]
    pub fn prepared(&self, photo: usize) -> &Prepared {
        self.shelf.get(photo, &self.all[photo])
    }

    /// The kind of a photo.
    #[must_use]
    pub fn kind(&self, photo: usize) -> Kind {
        self.prepared(photo).kind
    }

    /// Rates a photo as the lead of a page: 1 for the best photos of the album, negative for clearly worse photos.
    #[must_use]
    pub fn lead(&self, photo: usize) -> f64 {
        let gap = (self.top - self.quality[photo] - 0.04).max(0.0);
        (1.0 - gap / GAP).max(-2.0) - self.turns.led(photo)
    }

    /// Returns the turn of a photo, see [`Turns::need`]. Documents are excluded from turns.
    #[must_use]
    pub fn need(&self, photo: usize) -> f64 {
        if self.kind(photo) == Kind::Document { 0.0 } else { self.turns.need(photo) }
    }

    /// The photos with another maximum fingerprint distance of near-duplicates, in bits.
    #[must_use]
    pub fn with_duplicate_threshold(self, duplicate_threshold: u32) -> Self {
        Self { duplicate_threshold, ..self }
    }

    /// Whether two photos are near-duplicates.
    #[must_use]
    pub fn are_duplicates(&self, a: usize, b: usize) -> bool {
        are_duplicates(&self.all[a], &self.all[b], self.duplicate_threshold)
    }

    /// How much alike two photos are: 1 for near-duplicates, less for two photos of one moment. Photos of one moment
    /// count only on the first page of an album with photos to spare. On later pages, each photo gets its turn.
    #[must_use]
    pub fn likeness(&self, a: usize, b: usize) -> f64 {
        if self.are_duplicates(a, b) {
            1.0
        } else if self.turns.is_first_page() && self.drawn.len() >= TO_SPARE {
            likeness(&self.all[a], &self.all[b])
        } else {
            0.0
        }
    }
}

/// Whether a photo is gray.
#[must_use]
pub fn is_gray(photo: &PhotoMeta) -> bool {
    photo.facts.as_ref().is_some_and(|facts| facts.chroma < GRAY)
}

/// The value of each photo in each open slot of a page.
pub struct Worths {
    /// Slots without a photo, in reading order.
    pub open: Vec<usize>,
    /// Photos that no slot has, ascending.
    pub fresh: Vec<usize>,
    /// A row for each open slot, a column for each fresh photo.
    pub values: Vec<Vec<f64>>,
    /// Rows of the panels that lead the page.
    leads: Vec<usize>,
}

impl Worths {
    /// Looks at every fresh photo in every open slot.
    #[must_use]
    pub fn of(slots: &[Slot], photos: &Photos) -> Self {
        let taken: Vec<usize> = slots.iter().filter_map(Slot::photo).collect();
        let open: Vec<usize> = (0..slots.len()).filter(|&i| slots[i].photo().is_none()).collect();
        let fresh: Vec<usize> = photos.drawn.iter().copied().filter(|i| !taken.contains(i)).collect();
        let prepared: Vec<&Prepared> = fresh.iter().map(|&photo| photos.prepared(photo)).collect();
        let sizes = sizes(slots);
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let values = open.iter().map(|&slot| {
            let (size, share) = (sizes[slot], sizes[slot] / sizes.len() as f64);
            let pairs = fresh.iter().zip(&prepared);
            let worth = |(&photo, prepared): (&usize, &&Prepared)| {
                let (_, look) = placed(&slots[slot], &photos.all[photo], prepared);
                size.sqrt() * look.fit() + presence((size, largest, share), photo, photos)
            };
            pairs.map(worth).collect()
        });
        let values = values.collect();
        let leads = (0..open.len()).filter(|&row| sizes[open[row]] >= LEADS * largest).collect();
        Self { open, fresh, values, leads }
    }

    /// Returns the best assignment of unused photos to the open slots, with a small random term and without
    /// photos whose likeness is at least `alike`, if possible. The result is the index of a photo for each open slot, or
    /// `None` if there are too few photos.
    #[must_use]
    pub fn solve(
        &self,
        photos: &Photos,
        order: Order,
        alike: f64,
        random: &mut Rand64,
    ) -> Option<Vec<usize>> {
        if self.fresh.len() < self.open.len() {
            return None;
        }
        let mut values = self.values.clone();
        for value in values.iter_mut().flatten() {
            *value += NOISE * gumbel(random);
        }
        let solved = |values: &[Vec<f64>]| {
            let chosen = solved(values, order);
            self.with_star(values, &chosen, photos).unwrap_or(chosen)
        };
        let mut chosen = solved(&values);
        for _ in 0..self.fresh.len() - self.open.len() {
            let pairs = (0..chosen.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
            let twins = |&(a, b): &(usize, usize)| {
                photos.likeness(self.fresh[chosen[a]], self.fresh[chosen[b]]) >= alike
            };
            let Some((a, b)) = pairs.rev().find(twins) else { break };
            let weaker = if values[a][chosen[a]] < values[b][chosen[b]] { a } else { b };
            let column = chosen[weaker];
            for row in &mut values {
                row[column] = NEVER;
            }
            chosen = solved(&values);
        }
        Some(chosen.into_iter().map(|column| self.fresh[column]).collect())
    }

    /// If photos keep their order, a starred photo may be too early or too late for the leading panel. Then
    /// it leaves the order, and the others keep it. Returns `None` if no leading panel is open, or if one
    /// already has a starred photo.
    fn with_star(&self, values: &[Vec<f64>], chosen: &[usize], photos: &Photos) -> Option<Vec<usize>> {
        let starred = |column: usize| photos.all[self.fresh[column]].starred;
        if self.leads.iter().any(|&row| starred(chosen[row])) {
            return None;
        }
        let stars = (0..self.fresh.len()).filter(|&column| starred(column));
        let places = stars.flat_map(|column| self.leads.iter().map(move |&row| (row, column)));
        let (row, column) = places.max_by(|a, b| values[a.0][a.1].total_cmp(&values[b.0][b.1]))?;
        let mut rest = values.to_vec();
        rest.remove(row);
        for row in &mut rest {
            row.remove(column);
        }
        let mut others = monotone(&rest);
        for other in &mut others {
            *other += usize::from(*other >= column);
        }
        others.insert(row, column);
        Some(others)
    }
}

/// Areas of the slots over their mean.
pub(super) fn sizes(slots: &[Slot]) -> Vec<f64> {
    let mean = slots.iter().map(|slot| slot.area).sum::<f64>() / slots.len().max(1) as f64;
    slots.iter().map(|slot| slot.area / mean.max(1e-9)).collect()
}

/// Returns the value of a photo's strength in a panel of this size.
pub(super) fn presence((size, largest, share): (f64, f64, f64), photo: usize, photos: &Photos) -> f64 {
    let leads = size >= LEADS * largest;
    let hero = if leads { HERO * photos.lead(photo).max(-1.5) } else { 0.0 };
    let star =
        if photos.all[photo].starred { STAR * if leads { 1.0 } else { 0.4 * size / largest } } else { 0.0 };
    let spoken = if photos.all[photo].spoken { SPOKEN } else { 0.0 };
    let dull = match photos.kind(photo) {
        Kind::Bare if share > MOST_BARE => BARE,
        Kind::Bare => SMALL_BARE,
        Kind::Document => DOCUMENT,
        _ => 0.0,
    };
    (1.4 * (size - 0.4) + SHOWN) * photos.quality[photo] + photos.need(photo) + hero + star + spoken - dull
}

/// Assigns a photo and a crop to every panel; empty without photos. The result depends only on the arguments.
/// Another `seed` gives another assignment.
///
/// With fewer photos than panels, photos repeat with other crops, if possible not in panels that touch.
/// Locked panels retain their photos. Other panels use these photos only after all others.
#[must_use]
pub fn assign(photos: &[PhotoMeta], slots: &[Slot], order: Order, seed: u64) -> Vec<Assignment> {
    if photos.is_empty() {
        return Vec::new();
    }
    let mut random = Rand64::new(u128::from(seed) ^ 0x6c61_796f_7574);
    let shelf = Shelf::new(photos.len());
    let photos = Photos::new(photos, &[], Turns::default(), &shelf, &mut random);
    let worths = Worths::of(slots, &photos);
    let chosen = chosen(slots, &worths, &photos, order, 1.0, &mut random);
    crops(slots, &chosen, &photos)
}

/// A photo for every slot.
pub(super) fn chosen(
    slots: &[Slot],
    worths: &Worths,
    photos: &Photos,
    order: Order,
    alike: f64,
    random: &mut Rand64,
) -> Vec<usize> {
    let mut chosen: Vec<Option<usize>> = slots.iter().map(Slot::photo).collect();
    match worths.solve(photos, order, alike, random) {
        Some(found) => {
            for (&slot, photo) in worths.open.iter().zip(found) {
                chosen[slot] = Some(photo);
            }
        }
        None => repeat(slots, &worths.open, photos, order, &mut chosen, random),
    }
    chosen.into_iter().map(|photo| photo.unwrap_or(0)).collect()
}

/// Returns the crops of the chosen photos. A photo with two panels is complete in the larger one.
pub(super) fn crops(slots: &[Slot], chosen: &[usize], photos: &Photos) -> Vec<Assignment> {
    let turns = uses(slots, chosen);
    let assignment = |((slot, &photo), turn): ((&Slot, &usize), u32)| {
        let framed = || Assignment { photo, crop: frame(&photos.all[photo], &slot.target, turn) };
        slot.locked.unwrap_or_else(framed)
    };
    slots.iter().zip(chosen).zip(turns).map(assignment).collect()
}

/// Counts, for each slot, the earlier slots with the same photo: locked slots first, then by area.
pub(super) fn uses(slots: &[Slot], chosen: &[usize]) -> Vec<u32> {
    let first = |a: usize, b: usize| {
        let locked = (slots[a].locked.is_some(), slots[b].locked.is_some());
        match locked {
            (true, false) => true,
            (false, true) => false,
            _ => {
                slots[a].area > slots[b].area + 1e-9
                    || ((slots[a].area - slots[b].area).abs() <= 1e-9 && a < b)
            }
        }
    };
    let before =
        |i: usize| (0..slots.len()).filter(|&j| j != i && chosen[j] == chosen[i] && first(j, i)).count();
    (0..slots.len()).map(|i| before(i) as u32).collect()
}

/// Returns a quick crop for each chosen photo, and the visible content.
pub(super) fn looks(slots: &[Slot], chosen: &[usize], photos: &Photos) -> Vec<Look> {
    let look = |(slot, &photo): (&Slot, &usize)| {
        let prepared = photos.prepared(photo);
        let (_, look) = placed(slot, &photos.all[photo], prepared);
        slot.locked.map_or(look, |locked| Look::at(slot, prepared, &locked.crop, look.cover, false))
    };
    slots.iter().zip(chosen).map(look).collect()
}

/// With fewer photos than panels, the list repeats, but not in adjacent panels.
fn repeat(
    slots: &[Slot],
    open: &[usize],
    photos: &Photos,
    order: Order,
    chosen: &mut [Option<usize>],
    random: &mut Rand64,
) {
    let n = photos.all.len();
    let mut uses = vec![0u32; n];
    for &photo in chosen.iter().flatten() {
        uses[photo.min(n - 1)] += 1;
    }
    let mut next = if order == Order::Free { random.rand_range(0..n as u64) as usize } else { 0 };
    for &slot in open {
        let touching: Vec<usize> = (0..slots.len())
            .filter(|&other| other != slot && touch(slots[slot].bounds, slots[other].bounds))
            .filter_map(|other| chosen[other])
            .collect();
        let ahead = |photo: usize| (photo + n - next % n) % n;
        let cost = |photo: &usize| (touching.contains(photo), uses[*photo], ahead(*photo));
        let best = (0..n).min_by_key(cost).unwrap_or(0);
        chosen[slot] = Some(best);
        uses[best] += 1;
        next = best + 1;
    }
}

/// A number drawn from Gumbel's distribution: the largest of `ln(weight) + gumbel` is drawn by its weight.
pub(super) fn gumbel(random: &mut Rand64) -> f64 {
    -(-random.rand_float().clamp(1e-12, 1.0 - 1e-12).ln()).ln()
}

/// The column of each row; there are at least as many columns as rows.
fn solved(values: &[Vec<f64>], order: Order) -> Vec<usize> {
    match order {
        Order::Kept => monotone(values),
        Order::Free => hungarian(values),
    }
}

/// Returns the columns, ascending, with the largest sum. The best of the first `k` rows in the first `j`
/// columns either leaves column `j` out or assigns it to row `k`.
fn monotone(values: &[Vec<f64>]) -> Vec<usize> {
    let (rows, columns) = (values.len(), values.first().map_or(0, Vec::len));
    let mut best = vec![vec![f64::NEG_INFINITY; columns + 1]; rows + 1];
    best[0].fill(0.0);
    for row in 1..=rows {
        for column in row..=columns {
            let takes = best[row - 1][column - 1] + values[row - 1][column - 1];
            best[row][column] = takes.max(best[row][column - 1]);
        }
    }
    let mut chosen = vec![0; rows];
    let mut column = columns;
    for row in (1..=rows).rev() {
        while column > row && best[row][column] <= best[row][column - 1] {
            column -= 1;
        }
        column -= 1;
        chosen[row - 1] = column;
    }
    chosen
}

/// Returns different columns with the largest sum: the Hungarian method with potentials (Kuhn 1955, Munkres
/// 1957, in the form of shortest augmenting paths by Jonker and Volgenant 1987).
fn hungarian(values: &[Vec<f64>]) -> Vec<usize> {
    let (rows, columns) = (values.len(), values.first().map_or(0, Vec::len));
    let cost = |row: usize, column: usize| -values[row - 1][column - 1];
    let (mut u, mut v) = (vec![0.0; rows + 1], vec![0.0; columns + 1]);
    // The row of each column. Column 0 holds the row that is being placed.
    let mut row_of = vec![0usize; columns + 1];
    for row in 1..=rows {
        row_of[0] = row;
        let (mut least, mut from) = (vec![f64::INFINITY; columns + 1], vec![0usize; columns + 1]);
        let mut done = vec![false; columns + 1];
        let mut at = 0;
        while row_of[at] != 0 {
            done[at] = true;
            let (here, mut delta, mut next) = (row_of[at], f64::INFINITY, 0);
            for column in 1..=columns {
                if done[column] {
                    continue;
                }
                let reduced = cost(here, column) - u[here] - v[column];
                if reduced < least[column] {
                    (least[column], from[column]) = (reduced, at);
                }
                if least[column] < delta {
                    (delta, next) = (least[column], column);
                }
            }
            for column in 0..=columns {
                if done[column] {
                    u[row_of[column]] += delta;
                    v[column] -= delta;
                } else {
                    least[column] -= delta;
                }
            }
            at = next;
        }
        while at != 0 {
            row_of[at] = row_of[from[at]];
            at = from[at];
        }
    }
    let mut chosen = vec![0; rows];
    for column in 1..=columns {
        if row_of[column] > 0 {
            chosen[row_of[column] - 1] = column - 1;
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::framing::{Crop, FACE, Subject};
    use crate::layout::{PageSettings, catalogue, find, resolve};
    use crate::plan::slots;

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

    /// Returns the largest sum over all ways to give each row a separate column.
    fn exhaustive(values: &[Vec<f64>], ascending: bool) -> f64 {
        fn best(values: &[Vec<f64>], row: usize, used: &mut Vec<usize>, ascending: bool) -> f64 {
            if row == values.len() {
                return 0.0;
            }
            let mut most = f64::NEG_INFINITY;
            for column in 0..values[row].len() {
                let later = used.last().is_none_or(|&last| column > last);
                if used.contains(&column) || (ascending && !later) {
                    continue;
                }
                used.push(column);
                most = most.max(values[row][column] + best(values, row + 1, used, ascending));
                used.pop();
            }
            most
        }
        best(values, 0, &mut Vec::new(), ascending)
    }

    #[test]
    fn chronology_is_kept_and_pages_differ() {
        let (photos_given, slots) = (album(40), page("grid-8"));
        let mut pages = Vec::new();
        for seed in 0..20 {
            let used = photos(&assign(&photos_given, &slots, Order::Kept, seed));
            assert!(used.windows(2).all(|pair| pair[0] < pair[1]), "{used:?}");
            pages.push(used);
        }
        pages.sort();
        pages.dedup();
        assert!(pages.len() > 15, "{} different pages of 20", pages.len());
    }

    #[test]
    fn a_large_album_is_drawn_from_end_to_end_with_its_stars() {
        let mut photos_given = album(1000);
        photos_given[777].starred = true;
        let shelf = Shelf::new(photos_given.len());
        let photos = Photos::new(&photos_given, &[5], Turns::default(), &shelf, &mut Rand64::new(3));
        assert!(photos.drawn.len() <= MOST + 9 && photos.drawn.is_sorted());
        assert!(photos.drawn.contains(&777) && photos.drawn.contains(&5));
        assert!(photos.drawn[0] < 20 && photos.drawn[photos.drawn.len() - 1] >= 980);
    }

    #[test]
    fn a_starred_photo_gets_the_large_panel() {
        for order in [Order::Kept, Order::Free] {
            for starred in 1..8 {
                let mut photos_given = album(9);
                photos_given[starred].starred = true;
                let slots = page("hero-top-3");
                let hero = (0..slots.len()).max_by(|&a, &b| slots[a].area.total_cmp(&slots[b].area)).unwrap();
                let mut used = photos(&assign(&photos_given, &slots, order, 1));
                assert_eq!(used.remove(hero), starred, "{starred}: {used:?}");
                assert!(order == Order::Free || used.is_sorted(), "the others keep their order: {used:?}");
            }
        }
    }

    #[test]
    fn a_photo_with_words_is_on_the_page() {
        for order in [Order::Kept, Order::Free] {
            for (seed, spoken) in (0..9).enumerate() {
                let mut photos_given = album(9);
                photos_given[spoken].spoken = true;
                let used = photos(&assign(&photos_given, &page("hero-top-3"), order, seed as u64));
                assert!(used.contains(&spoken), "{spoken}: {used:?}");
            }
        }
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
    fn photos_of_one_moment_cost_on_the_first_page_of_an_album_with_photos_to_spare() {
        let likeness = |count: usize| {
            let mut all = album(count);
            let facts = format!("\"{}\"", "40".repeat(25));
            for photo in &mut all[..2] {
                photo.facts = Some(serde_json::from_str(&facts).unwrap());
            }
            all[1].fingerprint = all[0].fingerprint ^ 0x3fff;
            let shelf = Shelf::new(count);
            Photos::new(&all, &[], Turns::default(), &shelf, &mut Rand64::new(1)).likeness(0, 1)
        };
        assert!(likeness(8) > 0.7 && likeness(5) < 1e-9, "{} {}", likeness(8), likeness(5));
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
        const HERO_MIDDLE: usize = 2;
        let mut photos_given = album(5);
        let face = Subject {
            x: 0.35,
            y: 0.35,
            width: 0.15,
            height: 0.25,
            label: FACE.into(),
            score: 0.95,
            points: None,
            expression: None,
            light: None,
        };
        // The hero panel is landscape, so a portrait photo would be cut there.
        photos_given[4].subjects.push(face);
        let slots = page("hero-middle-4");
        for seed in 0..10 {
            assert_eq!(assign(&photos_given, &slots, Order::Free, seed)[HERO_MIDDLE].photo, 4);
        }
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
        fn assignments_are_the_best_there_are(
            rows in 1usize..5,
            more in 0usize..4,
            numbers in prop::collection::vec(-5.0f64..5.0, 40),
        ) {
            let columns = rows + more;
            let values: Vec<Vec<f64>> = (0..rows).map(|row| numbers[row * columns..(row + 1) * columns].to_vec()).collect();
            for (order, ascending) in [(Order::Kept, true), (Order::Free, false)] {
                let chosen = solved(&values, order);
                let mut apart = chosen.clone();
                apart.sort_unstable();
                apart.dedup();
                prop_assert_eq!(apart.len(), rows);
                prop_assert!(!ascending || chosen.is_sorted());
                let sum: f64 = chosen.iter().enumerate().map(|(row, &column)| values[row][column]).sum();
                prop_assert!((sum - exhaustive(&values, ascending)).abs() < 1e-9, "{:?} {:?}", values, chosen);
            }
        }

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
            // No photo repeats before every photo has appeared once, as far as neighbours allow.
            let most = uses.iter().max().copied().unwrap_or(0);
            prop_assert!(count < slots.len() || most == 1, "{:?}", uses);
        }
    }
}
