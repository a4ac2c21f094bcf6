//! Placement rules of letterers. Captions are flush in corners. Balloons are high in the panel, close to the
//! mouth, in reading order, never on a face, and off bodies if possible.
//!
//! The text items of a panel are placed together. For each item, some shapes (natural, flat, narrow, small)
//! are tried on a grid of positions. One cost rates a single position, another rates two positions together.
//! A beam search extends the best sets item by item, so that the first balloon leaves space for the second.
//!
//! Consecutive balloons of one speaker are linked automatically: the search is repeated with each such pair
//! as one. The pair stays if the cost is not higher and the connector covers no subject.
//!
//! Costs have ranks: faces, borders, other items and reading order are more important than conventions and
//! style.
//!
//! Source: Nate Piekos, "Comics Grammar & Tradition" (Blambot); Thawonmas and Shuda, "Comic layout for automatic comic
//! generation from game log" (2008), for faces and order as constraints.

use super::{
    Class, Figure, INSET, Scenery, Seen, above, center, contains, covered, gap, hidden, panel_of, reaches,
    shared,
};
use crate::layout::{Bounds, Point, ResolvedPanel};
use crate::page::words::balloons;
use crate::page::words::fitting::LEGIBLE_ON_SCREENS;
use crate::page::words::layout::{Ground, Laid};
use crate::page::words::letters::Letters;
use crate::page::words::model::{Kind, TextItem};

/// Candidate positions along each side of a panel.
const STEPS: usize = 15;
/// Beam width of the placement search. Smaller for panels with many text items.
const BEAM: usize = 24;
/// Sets for each face beside the best ones.
const LEAST_SHARE: usize = 6;
/// Panels with more text items than this are filled one item after the other.
const CROWD: usize = 12;
/// Candidate positions of one text item that enter the search.
const PLACES: usize = 160;
/// End of the tail, as a share of the way from the balloon to the mouth.
const REACH: f64 = 0.56;
/// Minimum length of a tail that points, and default length without a mouth, in page widths.
const TAIL: (f64, f64) = (0.014, 0.034);
/// Minimum length of a tail, as a share of the way to the mouth outside the face. Closer balloons lean on the
/// head.
const HALF_WAY: f64 = 0.5;
/// Extra cost of a short tail in a panel with subject masks: base, and weight of the missing length.
const LEANING: (f64, f64) = (8.0, 24.0);
/// Cost of breaking a rule.
const FORBIDDEN: f64 = 400.0;
/// Cost of moving a text item across the whole panel, if the user placed it.
const NEAR: f64 = 60.0;
/// Widths and heights of a sound effect, in parts of its panel, if it would cover a face in its usual size.
const SMALLER_EFFECTS: [(f64, f64); 3] = [(0.5, 0.3), (0.34, 0.2), (0.22, 0.14)];
/// Cost of covering a body.
const BODY: f64 = 60.0;
/// Cost of covering an object: a detected one, and one that is the subject of its photo.
const THING: (f64, f64) = (3.0, 12.0);
/// Estimated head of a person or an animal: width, and height, as shares of its width. The head is at most half
/// of its height.
const HEAD_SIZE: (f64, f64) = (0.6, 0.8);
/// Minimum size for easy reading, in page widths: 6 points on A4.
const LEGIBLE: f64 = 0.0101;
/// Maximum number of speaking faces in a panel.
const SPEAKERS: usize = 6;
/// Maximum number of automatically linked balloons.
const LONGEST_CHAIN: usize = 3;
/// Extra placement cost accepted for linking two balloons.
const JOINING: f64 = 3.0;
/// Maximum length of an automatic connector, in page widths.
const LONGEST_NECK: f64 = 0.03;
/// Preferred offset of a linked balloon to the side and down, as shares of the sizes of both, and the cost of
/// less.
const STAGGER: (f64, f64, f64) = (0.2, 0.5, 2.0);
/// Minimum distance of the lips of a face that speaks, in widths of the mouth, and the cost of another face with closed lips.
const SPEAKING: f64 = 0.15;
const SILENT: f64 = 1.5;
/// Cost of one face speaking for two speakers, and of two faces speaking for one speaker.
const TWO_IN_ONE: f64 = 10.0;
/// Cost of one face speaking in two consecutive balloons without names while another face is as likely to speak.
const ALTERNATE: f64 = 12.0;
/// Cost of two faces that speak in another order than they are seen in.
const REVERSED: f64 = 3.0;
/// Maximum extra cost of a face that is as likely to speak.
const LIKELY: f64 = 0.8;

/// Placement of a text item.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// Covered area without the tail.
    pub(super) area: Bounds,
    /// End of the tail.
    pub(super) tip: Option<Point>,
    /// Size of the set text, if it is not the default.
    pub(super) room: Option<(f64, f64)>,
    /// The foot of its tail.
    foot: Point,
    /// Index of the speaking face in the panel.
    speaker: Option<usize>,
    /// Its text is round a balloon: corners are free.
    round: bool,
    cost: f64,
}

impl Place {
    /// The area of the place, without costs.
    fn spot(&self) -> Spot {
        Spot { area: self.area, cost: 0.0, room: self.room, round: self.round }
    }
}

/// Text items that are placed together: the automatic ones of each panel, in order.
pub(super) fn groups(words: &[TextItem], ground: &Ground) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Option<usize>, Vec<usize>)> = Vec::new();
    for (i, word) in words.iter().enumerate() {
        if !word.is_auto() {
            continue;
        }
        let panel = panel_of(word, ground);
        match groups.iter_mut().find(|(other, _)| *other == panel) {
            Some((_, group)) => group.push(i),
            None => groups.push((panel, vec![i])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

/// The page, for the placement of one panel.
#[derive(Clone, Copy)]
pub(super) struct Page<'a> {
    /// All text items of the document.
    pub(super) words: &'a [TextItem],
    /// Link of each item: set manually, or to a balloon with a fixed position.
    pub(super) joins: &'a [Option<usize>],
    /// Occupied areas, with the index of the item.
    pub(super) taken: &'a [(usize, Bounds)],
    /// Position that the user dragged a text item to, with its index.
    pub(super) wanted: &'a [(usize, Point)],
    /// The area of the only item of the group before its text changed. It must stay there.
    pub(super) stays: Option<Bounds>,
    pub(super) ground: &'a Ground,
    pub(super) letters: &'a Letters,
}

/// Positions of the text items of a group, and their cost.
type Places = (f64, Vec<Place>);

/// Places the text items of a group and links balloons. Returns the index, the placement and the linked
/// balloon of each item; empty if an item that must stay does not fit.
pub(super) fn place(
    page: Page<'_>,
    group: &[usize],
    Scenery { seen, figures }: &Scenery,
) -> Vec<(usize, Place, Option<usize>)> {
    let Page { words, ground, .. } = page;
    let Some(word) = group.first().map(|&first| &words[first]) else { return Vec::new() };
    let panel = panel_of(word, ground);
    let room = Room {
        frame: ground.frame(word),
        panel: panel.and_then(|panel| ground.panels.get(panel)),
        seen,
        figures,
        above: above(word, ground),
        speakers: speakers(seen),
        heard: Vec::new(),
        page,
        count: group.len(),
    };
    let room = Room { heard: room.heard(group[0]), ..room };
    let spots: Vec<Vec<Spot>> =
        group.iter().enumerate().map(|(rank, &index)| room.weighed(index, rank)).collect();
    let mut joins = page.joins.to_vec();
    let mut best = room.searched(group, &spots, &joins, 0.0);
    if page.stays.is_some() && best.0 >= 0.5 * FORBIDDEN {
        return Vec::new();
    }
    if group.len() <= CROWD {
        for (later, before) in pairs(words, group, |word| panel_of(word, ground) == panel) {
            if chain(&joins, before) >= LONGEST_CHAIN || joins[later].is_some() {
                continue;
            }
            let at = |index: usize| group.iter().position(|&other| other == index).map(|at| best.1.get(at));
            let (Some(Some(one)), Some(Some(other))) = (at(before), at(later)) else { continue };
            if !one_mouth((&words[before], one), (&words[later], other), &room.speakers) {
                continue;
            }
            let mut tried = joins.clone();
            tried[later] = Some(before);
            let found = room.searched(group, &spots, &tried, 0.0);
            if found.0 <= best.0 + JOINING && room.hang_well(group, &found.1, page.joins, &tried) {
                (joins, best) = (tried, found);
            }
        }
    }
    // The areas are fixed now, and the tails may still turn to other faces.
    let areas: Vec<Vec<Spot>> = best.1.iter().map(|place| vec![place.spot()]).collect();
    let (_, places) = room.searched(group, &areas, &joins, 1.0);
    let linked = |index: usize| joins[index].filter(|_| words[index].joined.is_none());
    group.iter().copied().zip(places).map(|(index, place)| (index, place, linked(index))).collect()
}

/// Returns pairs of consecutive balloons of a group, the later one first. No other balloon of the panel is
/// between them, and both have one look.
fn pairs(words: &[TextItem], group: &[usize], here: impl Fn(&TextItem) -> bool) -> Vec<(usize, usize)> {
    let is_balloon = |word: &TextItem| matches!(word.kind(), Kind::Balloon(_)) && here(word);
    let before = |&later: &usize| {
        let before = (0..later).rev().find(|&before| is_balloon(&words[before]))?;
        let (one, other) = (&words[before], &words[later]);
        let alike =
            one.kind() == other.kind() && (one.colors(), one.vertical) == (other.colors(), other.vertical);
        (alike && !other.apart && group.contains(&before)).then_some((later, before))
    };
    group.iter().filter(|&&later| is_balloon(&words[later])).filter_map(before).collect()
}

/// Number of balloons linked with one.
fn chain(joins: &[Option<usize>], one: usize) -> usize {
    let mut all = vec![one];
    let mut next = 0;
    while let Some(&at) = all.get(next) {
        let tied = |other: usize| joins[other] == Some(at) || joins[at] == Some(other);
        let more: Vec<usize> =
            (0..joins.len()).filter(|&other| tied(other) && !all.contains(&other)).collect();
        all.extend(more);
        next += 1;
    }
    all.len()
}

/// Whether two balloons have the same speaker: by name, or by the assigned face.
fn one_mouth(one: (&TextItem, &Place), other: (&TextItem, &Place), speakers: &[(usize, f64)]) -> bool {
    match (&one.0.by, &other.0.by) {
        (Some(name), Some(second)) => name == second,
        _ => speakers.is_empty() || one.1.speaker.is_some() && one.1.speaker == other.1.speaker,
    }
}

/// The faces that may speak, the likeliest first: large ones with open lips, that were surely seen.
fn speakers(seen: &[Seen]) -> Vec<(usize, f64)> {
    let size = |seen: &Seen| seen.bounds.width * seen.bounds.height * (0.5 + 0.5 * seen.score);
    let faces = || seen.iter().enumerate().filter(|(_, seen)| seen.class == Class::Face);
    let largest = faces().map(|(_, seen)| size(seen)).fold(1e-12, f64::max);
    let widest = faces().map(|(_, seen)| seen.lips).fold(0.0, f64::max);
    let silent = |seen: &Seen| if widest > SPEAKING { SILENT * (1.0 - seen.lips / widest) } else { 0.0 };
    let mut likely: Vec<(usize, f64)> =
        faces().map(|(i, seen)| (i, 2.2 * (1.0 - (size(seen) / largest).sqrt()) + silent(seen))).collect();
    likely.sort_by(|a, b| a.1.total_cmp(&b.1));
    likely.truncate(SPEAKERS);
    likely
}

/// A candidate area for a text item.
struct Spot {
    area: Bounds,
    /// Cost without the tail.
    cost: f64,
    room: Option<(f64, f64)>,
    round: bool,
}

impl Spot {
    /// The spot as a place without a tail.
    fn bare(&self) -> Place {
        let Self { area, cost, room, round } = *self;
        Place { area, tip: None, room, foot: center(area), speaker: None, round, cost }
    }
}

/// A panel during placement.
struct Room<'a> {
    frame: Bounds,
    panel: Option<&'a ResolvedPanel>,
    seen: &'a [Seen],
    figures: &'a [Figure],
    /// The panels above this one.
    above: Vec<&'a ResolvedPanel>,
    /// Faces that may speak, and their costs.
    speakers: Vec<(usize, f64)>,
    /// The faces that balloons with a fixed position point at, with the index of the balloon.
    heard: Vec<(usize, usize)>,
    page: Page<'a>,
    /// Number of text items.
    count: usize,
}

impl Room<'_> {
    /// The best placements of all items of a group together, with links in `joins`. `sharing`: weight of the cost of two speakers
    /// who share a face, 0 to 1.
    fn searched(
        &self,
        group: &[usize],
        spots: &[Vec<Spot>],
        joins: &[Option<usize>],
        sharing: f64,
    ) -> Places {
        let words = self.page.words;
        let mut beam = vec![(0.0, Vec::<Place>::new())];
        for (rank, (&index, spots)) in group.iter().zip(spots).enumerate() {
            let places = self.places(index, spots, joins);
            let mut next: Vec<(f64, usize, usize)> = Vec::new();
            for (set, (cost, before)) in beam.iter().enumerate() {
                for (at, place) in places.iter().enumerate() {
                    let pairs = before.iter().enumerate().map(|(other, placed)| {
                        let joined = joins[index] == Some(group[other]) || joins[group[other]] == Some(index);
                        let pair = (&words[group[other]], &words[index]);
                        let rtl = self.page.ground.rtl;
                        let follow = before[other + 1..].iter().all(|place| place.speaker.is_none());
                        sharing * self.voices(pair, (placed.speaker, place.speaker), follow)
                            + together((pair.0, placed), (pair.1, place), (joined, rtl), other + 1 == rank)
                    });
                    next.push((cost + place.cost + pairs.sum::<f64>(), set, at));
                }
            }
            next.sort_by(|a, b| a.0.total_cmp(&b.0));
            // The best sets, and some for each face, because the last item may need a face that costs the first one more.
            let mut counts = vec![0; self.seen.len()];
            let mut rank = 0;
            next.retain(|&(_, _, at)| {
                rank += 1;
                let share = places[at].speaker.map_or(usize::MAX, |face| {
                    counts[face] += 1;
                    counts[face]
                });
                rank <= BEAM || share <= LEAST_SHARE
            });
            if group.len() > CROWD {
                next.truncate(1);
            }
            let carried = next.into_iter().map(|(cost, set, at)| {
                let mut set = beam[set].1.clone();
                set.push(places[at]);
                (cost, set)
            });
            beam = carried.collect();
        }
        beam.into_iter().next().unwrap_or_default()
    }

    /// The best placements of a single item. Only the first of several linked balloons has a tail.
    fn places(&self, index: usize, spots: &[Spot], joins: &[Option<usize>]) -> Vec<Place> {
        let mut places = Vec::new();
        for spot in spots {
            if spot.round && joins[index].is_none() {
                self.aimed(spot, &mut places);
            } else {
                places.push(spot.bare());
            }
        }
        for place in &mut places {
            place.cost += place.speaker.map_or(0.0, |face| self.unheard(index, face));
        }
        let Page { words, taken, .. } = self.page;
        // A balloon is close to its linked balloons, even if their positions are fixed.
        for (other, area) in taken.iter().filter(|(other, _)| self.tied(index, *other)) {
            let stands = Spot { area: *area, cost: 0.0, room: None, round: true }.bare();
            for place in &mut places {
                let (one, two) = ((&words[*other], &stands), (&words[index], &*place));
                let (first, second) = if *other < index { (one, two) } else { (two, one) };
                place.cost += together(first, second, (true, self.page.ground.rtl), false);
            }
        }
        places.sort_by(|a: &Place, b| a.cost.total_cmp(&b.cost));
        self.varied(places)
    }

    /// Cost of the faces that two balloons point at. The first precedes the second in the text, directly if they `follow`.
    fn voices(
        &self,
        (said, says): (&TextItem, &TextItem),
        (first, second): (Option<usize>, Option<usize>),
        follow: bool,
    ) -> f64 {
        let (Some(first), Some(second)) = (first, second) else { return 0.0 };
        let across = |face: usize| {
            let x = self.seen[face].mouth.x;
            if self.page.ground.rtl { -x } else { x }
        };
        let unlikely =
            |face: usize| self.speakers.iter().find(|(other, _)| *other == face).map(|found| found.1);
        let most = unlikely(second).unwrap_or(0.0) + LIKELY;
        let is_alone = !self.speakers.iter().any(|&(face, cost)| face != second && cost <= most);
        let cost = match (&said.by, &says.by) {
            (Some(name), Some(next)) if (name == next) != (first == second) => TWO_IN_ONE,
            (None, _) | (_, None) if follow && first == second && !is_alone => ALTERNATE,
            _ => 0.0,
        };
        cost + if follow && across(first) > across(second) { REVERSED } else { 0.0 }
    }

    /// The faces that balloons with a fixed position point at, on the panel of an item.
    fn heard(&self, item: usize) -> Vec<(usize, usize)> {
        let Page { words, taken, ground, letters, .. } = self.page;
        let here = taken.iter().filter(|(other, _)| words[*other].panel == words[item].panel);
        let face = |(other, _): &(usize, Bounds)| {
            let tip = ground.lay(words[*other].clone(), letters).tip?;
            Some((*other, self.nearest(tip)?))
        };
        here.filter_map(face).collect()
    }

    /// The face whose mouth is nearest to the end of a tail.
    fn nearest(&self, tip: Point) -> Option<usize> {
        let away = |face: usize| self.seen[face].mouth.distance(tip);
        let faces = self.speakers.iter().map(|(face, _)| *face);
        faces.min_by(|&a, &b| away(a).total_cmp(&away(b)))
    }

    /// Cost of a face after the balloons with a fixed position, and after the face that the item pointed at before.
    fn unheard(&self, index: usize, face: usize) -> f64 {
        let words = self.page.words;
        let is_balloon =
            |word: &TextItem| word.panel == words[index].panel && matches!(word.kind(), Kind::Balloon(_));
        let apart =
            self.heard.iter().filter(|(other, _)| !self.tied(index, *other)).map(|&(other, heard)| {
                let (first, second) = (other.min(index), other.max(index));
                let faces = if other < index { (heard, face) } else { (face, heard) };
                let follow = !words[first + 1..second].iter().any(is_balloon);
                self.voices((&words[first], &words[second]), (Some(faces.0), Some(faces.1)), follow)
            });
        let tip = self.page.stays.and_then(|_| words[index].tail).map(|tail| {
            let Bounds { x, y, width, height } = self.frame;
            Point::new(x + tail.x * width, y + tail.y * height)
        });
        let is_other = tip.and_then(|tip| self.nearest(tip)).is_some_and(|before| before != face);
        apart.sum::<f64>() + if is_other { TWO_IN_ONE } else { 0.0 }
    }

    /// Whether two items are linked in the document.
    fn tied(&self, one: usize, other: usize) -> bool {
        let joins = self.page.joins;
        joins[one] == Some(other) || joins[other] == Some(one)
    }

    /// Whether the balloons that are linked only in `now` look good: close together, and the connector covers
    /// no face and no text.
    fn hang_well(
        &self,
        group: &[usize],
        places: &[Place],
        before: &[Option<usize>],
        now: &[Option<usize>],
    ) -> bool {
        let at = |index: usize| {
            group
                .iter()
                .position(|&other| other == index)
                .and_then(|at| places.get(at))
                .map(|place| place.area)
        };
        let good = |index: usize| {
            let (Some(to), None) = (now[index], before[index]) else { return true };
            let (Some(one), Some(other)) = (at(to), at(index)) else { return false };
            let (from, end) = (edge(one, center(other)), edge(other, center(one)));
            let free = |bounds: Bounds| entry(from, end, bounds) > 1.0;
            let words = group.iter().zip(places).filter(|(i, _)| **i != index && **i != to);
            from.distance(end) <= LONGEST_NECK
                && self
                    .seen
                    .iter()
                    .filter(|seen| seen.class == Class::Face)
                    .all(|seen| free(grown(seen.bounds, 0.006)))
                && self.page.taken.iter().all(|(_, area)| free(*area))
                && words.map(|(_, place)| place.area).all(free)
        };
        group.iter().all(|&index| good(index))
    }

    /// Candidates for an item. `rank`: number of preceding text items of the panel.
    fn weighed(&self, index: usize, rank: usize) -> Vec<Spot> {
        let Page { words, ground, letters, .. } = self.page;
        let word = &words[index];
        let usual = ground.lay(TextItem { room: None, ..word.clone() }, letters);
        let mut shapes = vec![(None, usual)];
        let is_effect = word.kind() == Kind::Effect;
        let rooms: &[(f64, f64)] = match word.width {
            // A custom width does not change.
            Some(_) => &[],
            _ if self.count > CROWD => &[],
            _ if is_effect => &SMALLER_EFFECTS,
            None => &[(0.94, 0.2), (0.94, 0.3), (0.22, 0.8), (0.34, 0.8), (0.46, 0.34), (0.3, 0.3)],
        };
        for (across, down) in rooms {
            let room = (across * self.frame.width, down * self.frame.height);
            let laid = ground.lay(TextItem { room: Some(room), ..word.clone() }, letters);
            let other = |(_, shape): &(_, Laid)| shape.setting != laid.setting;
            if shapes.iter().all(other) {
                shapes.push((Some(room), laid));
            }
        }
        let largest = shapes.iter().map(|(_, laid)| laid.setting.size).fold(0.0, f64::max);
        // A narrow column next to a body is useless if its text is too small.
        let legible = if ground.screens { LEGIBLE_ON_SCREENS } else { LEGIBLE };
        shapes.retain(|(_, laid)| laid.setting.size >= legible.min(largest));
        let round = matches!(word.kind(), Kind::Balloon(_));
        let mut all = Vec::new();
        for (room, laid) in &shapes {
            if is_effect && all.iter().any(|spot: &Spot| spot.cost < FORBIDDEN) {
                break;
            }
            // Letters that are smaller than others of the page are a last resort, all the more where the end is missing.
            let small = 9.0 * (largest / laid.setting.size.max(1e-6)).ln()
                + if laid.setting.cut { 60.0 } else { 0.0 };
            let plain = if room.is_some() { 0.25 } else { 0.0 };
            let spot = |area: Bounds| {
                let cost = small + plain + self.cost(index, laid, area, rank);
                Spot { area, cost, room: *room, round }
            };
            let areas = match self.page.stays {
                Some(_) if laid.setting.cut => Vec::new(),
                Some(before) => Self::grown_from(before, laid),
                None => self.spots(laid),
            };
            all.extend(areas.into_iter().map(spot));
        }
        all
    }

    /// The cheapest placements, with some from each part of the panel, because the best single placement may
    /// not fit the others.
    fn varied(&self, places: Vec<Place>) -> Vec<Place> {
        let mut kept = Vec::with_capacity(PLACES);
        let mut counts = [0; 25];
        let share = PLACES / 25 + 10;
        for place in places {
            let middle = center(place.area);
            let part = |at: f64, start: f64, length: f64| {
                (((at - start) / length.max(1e-9) * 5.0).floor().clamp(0.0, 4.0)) as usize
            };
            let cell = part(middle.x, self.frame.x, self.frame.width)
                + 5 * part(middle.y, self.frame.y, self.frame.height);
            if counts[cell] < share {
                counts[cell] += 1;
                kept.push(place);
            }
        }
        kept
    }

    /// Returns the areas for a text item that share an edge or the middle with its earlier area, in each direction.
    fn grown_from(before: Bounds, laid: &Laid) -> Vec<Bounds> {
        let Bounds { width, height, .. } = covered(laid);
        let along =
            |start: f64, length: f64, size: f64| [0.5, 0.0, 1.0].map(|at| start + at * (length - size));
        let rows = along(before.y, before.height, height);
        let columns = along(before.x, before.width, width);
        rows.iter().flat_map(|&y| columns.map(|x| Bounds { x, y, width, height })).collect()
    }

    /// Returns the candidate areas for a text item.
    fn spots(&self, laid: &Laid) -> Vec<Bounds> {
        let Bounds { width, height, .. } = covered(laid);
        // A caption shares its border with its panel.
        let inset = if laid.word.kind() == Kind::Caption { 0.0 } else { INSET };
        let along = |start: f64, length: f64, size: f64| -> Vec<f64> {
            let room = length - size - 2.0 * inset;
            if room <= 0.0 {
                return vec![start + (length - size) / 2.0];
            }
            (0..STEPS).map(|i| start + inset + room * i as f64 / (STEPS - 1) as f64).collect()
        };
        let rows = along(self.frame.y, self.frame.height, height);
        let columns = along(self.frame.x, self.frame.width, width);
        rows.iter().flat_map(|&y| columns.iter().map(move |&x| Bounds { x, y, width, height })).collect()
    }

    /// Cost of a position without the tail.
    fn cost(&self, index: usize, laid: &Laid, area: Bounds, rank: usize) -> f64 {
        let round = matches!(laid.word.kind(), Kind::Balloon(_));
        let mut cost = self.outside(area, round);
        let part = hidden(area, round, &self.above);
        if part > 0.0 {
            cost += FORBIDDEN * (0.5 + 2.0 * part);
        }
        for (_, place) in self.page.wanted.iter().filter(|(other, _)| *other == index) {
            cost += NEAR * center(area).distance(*place) / self.frame.width.hypot(self.frame.height);
        }
        for (_, other) in self.page.taken.iter().filter(|(other, _)| !self.tied(index, *other)) {
            let touched = shared(area, grown(*other, INSET));
            if touched > 0.0 {
                cost += FORBIDDEN * (1.0 + touched / (area.width * area.height));
            }
        }
        cost += FORBIDDEN * self.misread(index, area) as f64;
        let own = area.width * area.height;
        if let Some(before) = self.page.stays {
            // It grows or shrinks, and does not change its shape.
            cost += NEAR * (1.0 - shared(before, area) / own.min(before.width * before.height).max(1e-12));
        }
        let size = self.frame.width.hypot(self.frame.height);
        let mut nearest = size;
        for seen in self.seen {
            let body = seen.bounds.width * seen.bounds.height;
            let part = cover(
                area,
                if seen.class == Class::Face { grown(seen.bounds, 0.004) } else { seen.bounds },
                round,
            );
            if seen.class == Class::Face {
                if part > 0.0 {
                    cost += FORBIDDEN + 4.0 * FORBIDDEN * part / own.min(body).max(1e-12);
                }
                nearest = nearest.min(gap(area, seen.bounds));
            } else if !seen.masked {
                let weight = if seen.class == Class::Person { BODY } else { THING.0 };
                cost += weight * (part / own + 4.0 * part / body.max(1e-12));
            }
        }
        for figure in self.figures {
            let weight = if figure.alive { BODY } else { THING.1 };
            let part = figure.under(area, round);
            cost += weight * (part / own + 4.0 * part / figure.area);
        }
        cost + self.manners(laid.word.kind(), area, rank, nearest / size)
    }

    /// Number of automatically placed text items of the panel that the eye would read in another order than the
    /// text.
    fn misread(&self, index: usize, area: Bounds) -> usize {
        let Page { words, taken, ground, .. } = self.page;
        let word = &words[index];
        let wrong = |(other, placed): &&(usize, Bounds)| {
            let before = *other < index;
            let (first, second) = if before { (*placed, area) } else { (area, *placed) };
            words[*other].panel == word.panel
                && words[*other].is_auto()
                && [word, &words[*other]].iter().all(|word| word.kind() != Kind::Effect)
                && !reads_after(turned(first, ground.rtl), turned(second, ground.rtl))
        };
        taken.iter().filter(wrong).count()
    }

    /// Cost of unusual positions. Usual are captions in corners, high balloons, and sounds in free areas.
    fn manners(&self, kind: Kind, area: Bounds, rank: usize, nearest: f64) -> f64 {
        let frame = self.frame;
        let part = |at: f64, start: f64, room: f64| if room > 1e-9 { (at - start) / room } else { 0.5 };
        let right = part(area.x, frame.x, frame.width - area.width);
        // Text begins where the eye does.
        let right = if self.page.ground.rtl && kind != Kind::Effect { 1.0 - right } else { right };
        let low = part(area.y, frame.y, frame.height - area.height);
        match kind {
            Kind::Caption => {
                // The first item of a panel is in its upper left corner, the last of several may be in its
                // lower right one.
                let last = rank > 0 && rank + 1 == self.count;
                let wanted = if last { right.min(1.0 - right) } else { right };
                let flush = right.min(1.0 - right) + low.min(1.0 - low);
                3.0 * flush + 0.5 * wanted + if last { 0.1 } else { 1.0 } * low - 0.6 * nearest
            }
            Kind::Balloon(_) => {
                let turn = if self.count > 1 { rank as f64 / (self.count - 1) as f64 } else { 0.0 };
                1.6 * (low - 0.5 * turn).max(0.0) + 0.3 * low + 0.15 * right
            }
            Kind::Effect => 1.2 * (right - 0.5).hypot(low - 0.6) - 1.5 * nearest,
        }
    }

    /// Cost of extending past the panel.
    fn outside(&self, area: Bounds, round: bool) -> f64 {
        let Some(panel) = self.panel else { return 0.0 };
        let middle = center(area);
        let (a, b) = (area.width / 2.0, area.height / 2.0);
        // Places all around a balloon, or the corners of a box; a border that is just touched is not crossed.
        let around: &[(f64, f64)] = if round {
            &[
                (1.0, 0.0),
                (-1.0, 0.0),
                (0.0, 1.0),
                (0.0, -1.0),
                (0.75, 0.75),
                (-0.75, 0.75),
                (0.75, -0.75),
                (-0.75, -0.75),
            ]
        } else {
            &[(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)]
        };
        let out = |&&(x, y): &&(f64, f64)| {
            !contains(&panel.shape, Point::new(middle.x + 0.998 * x * a, middle.y + 0.998 * y * b))
        };
        FORBIDDEN * 0.5 * around.iter().filter(out).count() as f64
    }

    /// Adds a placement with a tail to each face that may speak. Without faces the tail is omitted.
    fn aimed(&self, spot: &Spot, out: &mut Vec<Place>) {
        let (bare, area, cost) = (spot.bare(), spot.area, spot.cost);
        let size = self.frame.width.hypot(self.frame.height);
        for &(face, unlikely) in &self.speakers {
            let head = self.seen[face].bounds;
            let mouth = self.seen[face].mouth;
            let foot = edge(area, mouth);
            let way = foot.distance(mouth);
            // The tail ends before the face, even if the balloon is near.
            let until = entry(foot, mouth, grown(head, 0.003)) - 1e-3;
            let along = REACH.min(until).max(0.0);
            let length = along * way;
            let mut short = if length < TAIL.0 { 14.0 * (1.0 - length / TAIL.0) + 2.0 } else { 0.0 };
            if along < HALF_WAY && !self.figures.is_empty() {
                short += LEANING.0 + LEANING.1 * (1.0 - along / HALF_WAY);
            }
            let tip = foot.toward(mouth, along);
            let ideal = 0.1 * size;
            let far = (way - ideal).max(0.0) / size + 0.5 * (ideal - way).max(0.0) / size;
            let crossed = self.crossed(foot, tip, mouth, face) + self.grazed(area, tip);
            let cost = cost + unlikely + short + 4.5 * far + crossed;
            out.push(Place { tip: Some(tip), foot, speaker: Some(face), cost, ..bare });
        }
        if self.speakers.is_empty() {
            let (target, head) = self.largest();
            let target = target.unwrap_or_else(|| {
                Point::new(self.frame.x + self.frame.width / 2.0, self.frame.y + 0.72 * self.frame.height)
            });
            let foot = edge(area, target);
            let way = foot.distance(target);
            let mut length = TAIL.1.max(REACH.min(0.5) * way).min(0.9 * way).min(3.0 * TAIL.1);
            if let Some(head) = head {
                // As with a face, the tail ends before it. The estimate is too vague to keep balloons off it.
                length = length.min((entry(foot, target, head) * way).max(TAIL.0));
            }
            // A balloon above its target has no tail.
            let inside = ((target.x - center(area).x) / area.width).abs() < 0.5
                && ((target.y - center(area).y) / area.height).abs() < 0.5;
            let tip = (!inside).then(|| foot.toward(target, length / way.max(1e-9)));
            let far = (way - 0.1 * size).abs() / size;
            let grazed = tip.map_or(0.0, |tip| self.grazed(area, tip));
            let cost = cost + 2.0 * far + if inside { 6.0 } else { 0.0 } + grazed;
            out.push(Place { tip, foot, cost, ..bare });
        }
    }

    /// Returns the position of the head of the largest person or animal, or of the largest object without
    /// them, and the estimated bounds of the head. If the crop cuts off the head, the position is on the edge of the panel.
    fn largest(&self) -> (Option<Point>, Option<Bounds>) {
        let size = |seen: &&Seen| {
            seen.bounds.width * seen.bounds.height * if seen.class == Class::Person { 4.0 } else { 1.0 }
        };
        let Some(seen) = self.seen.iter().max_by(|a, b| size(a).total_cmp(&size(b))) else {
            return (None, None);
        };
        let Bounds { x, y, width, height } = seen.bounds;
        let middle = x + width / 2.0;
        let wide = HEAD_SIZE.0 * width;
        let head = Bounds {
            x: middle - wide / 2.0,
            y,
            width: wide,
            height: (height / 2.0).min(HEAD_SIZE.1 * width),
        };
        let frame = self.frame;
        let within = |at: f64, start: f64, length: f64| at.clamp(start, start + length);
        (
            Some(Point::new(
                within(middle, frame.x, frame.width),
                within(y + 0.25 * height, frame.y, frame.height),
            )),
            matches!(seen.class, Class::Person | Class::Animal).then_some(head),
        )
    }

    /// Cost of a tail whose sides touch a face, or that lies on another panel. The line of the tail may pass
    /// next to them.
    fn grazed(&self, area: Bounds, tip: Point) -> f64 {
        let faces = || self.seen.iter().filter(|seen| seen.class == Class::Face);
        if self.above.is_empty() && faces().next().is_none() {
            return 0.0;
        }
        let middle = center(area);
        let (a, b) = (area.width / 2.0, area.height / 2.0);
        let sides = balloons::sides(a, b, Point::new(tip.x - middle.x, tip.y - middle.y))
            .map(|side| side.map(|point| Point::new(middle.x + point.x, middle.y + point.y)));
        let touches = |face: &Seen| {
            // Rounding at the tip is not a touch.
            let within = grown(face.bounds, -1e-4);
            sides.iter().flat_map(|side| side.windows(2)).any(|part| entry(part[0], part[1], within) <= 1.0)
        };
        let covers = |point: &Point| self.above.iter().any(|panel| reaches(&panel.shape, *point, panel.halo));
        let touched = faces().filter(|face| touches(face)).count() as f64;
        FORBIDDEN * (touched + f64::from(sides.iter().flatten().any(covers)))
    }

    /// Cost of everything that a tail crosses, and of pointing at another face first.
    fn crossed(&self, foot: Point, tip: Point, mouth: Point, speaker: usize) -> f64 {
        let mut cost = 0.0;
        let head = self.seen[speaker].bounds;
        for (i, seen) in self.seen.iter().enumerate().filter(|(i, _)| *i != speaker) {
            if seen.class == Class::Face {
                if entry(foot, tip, grown(seen.bounds, 0.004)) < 1.0 {
                    cost += FORBIDDEN;
                } else if entry(foot, mouth, seen.bounds) < 1.0 && shared(seen.bounds, head) <= 0.0 {
                    cost += 30.0;
                } else if seen.mouth.distance(tip) < 0.8 * mouth.distance(tip) {
                    // Readers expect the nearest mouth to speak.
                    cost += 24.0;
                }
            } else if seen.class == Class::Person
                && shared(self.seen[i].bounds, head) < 0.5 * head.width * head.height
            {
                // The tail crosses another subject.
                cost += 4.0 * inside(foot, tip, seen.bounds);
            }
        }
        for (_, other) in self.page.taken {
            cost += if entry(foot, tip, *other) < 1.0 { FORBIDDEN } else { 0.0 };
        }
        cost
    }
}

/// Cost of two items of a panel together. The first precedes the second in the text, directly if they
/// `follow`. `rtl`: the page is read from right to left.
fn together(
    one: (&TextItem, &Place),
    other: (&TextItem, &Place),
    (joined, rtl): (bool, bool),
    follow: bool,
) -> f64 {
    let ((said, first), (says, second)) = (one, other);
    let (a, b) = (first.area, second.area);
    let mut cost = 0.0;
    let near = if joined { 0.002 } else { INSET };
    if shared(grown(a, near), b) > 0.0 && !(first.round && second.round && ovals_apart(a, b, near)) {
        cost += FORBIDDEN * (1.0 + shared(a, b) / (a.width * a.height).min(b.width * b.height));
    }
    for (from, over) in [(first, b), (second, a)] {
        if let Some(tip) = from.tip
            && entry(from.foot, tip, over) < 1.0
        {
            cost += FORBIDDEN;
        }
    }
    if let (Some(one), Some(other)) = (first.tip, second.tip)
        && !joined
        && crossing((first.foot, one), (second.foot, other))
    {
        cost += FORBIDDEN;
    }
    let sound = said.kind() == Kind::Effect || says.kind() == Kind::Effect;
    if !sound && !reads_after(turned(a, rtl), turned(b, rtl)) {
        cost += FORBIDDEN;
    }
    if joined {
        return cost + 60.0 * gap(a, b) + staggered(a, b);
    }
    let (Some(face), Some(other)) = (first.speaker, second.speaker) else { return cost };
    match (&said.by, &says.by) {
        (Some(name), Some(next)) if (name == next) != (face == other) => cost + TWO_IN_ONE,
        // Speakers usually alternate.
        (None, _) | (_, None) if follow && face == other => cost + 1.2,
        _ => cost,
    }
}

/// Cost of a linked balloon directly below or directly next to the previous one. Letterers offset them in
/// both directions.
fn staggered(a: Bounds, b: Bounds) -> f64 {
    let (aside, below, weight) = STAGGER;
    let (from, to) = (center(a), center(b));
    let across = (to.x - from.x).abs() / f64::midpoint(a.width, b.width).max(1e-9);
    let down = (to.y - from.y) / f64::midpoint(a.height, b.height).max(1e-9);
    weight * ((aside - across).max(0.0) / aside + (below - down).max(0.0) / below)
}

/// The mirror image of an area if the page is read from right to left.
fn turned(area: Bounds, rtl: bool) -> Bounds {
    if rtl { Bounds { x: -area.x - area.width, ..area } } else { area }
}

/// Returns whether a reader sees `b` after `a`: it is below, or to the right at about the same height.
fn reads_after(a: Bounds, b: Bounds) -> bool {
    let common = (a.y + a.height).min(b.y + b.height) - a.y.max(b.y);
    let beside = common > 0.25 * a.height.min(b.height);
    if beside {
        let lower = center(b).y - center(a).y;
        b.x + b.width / 2.0 > a.x + a.width / 2.0
            && b.x >= a.x + 0.6 * a.width
            && lower > -0.3 * a.height.max(b.height)
    } else {
        b.y > a.y
    }
}

fn grown(bounds: Bounds, by: f64) -> Bounds {
    Bounds {
        x: bounds.x - by,
        y: bounds.y - by,
        width: bounds.width + 2.0 * by,
        height: bounds.height + 2.0 * by,
    }
}

/// Approximate share of a box that an item covers. The rounded corners of balloons do not count.
fn cover(area: Bounds, other: Bounds, round: bool) -> f64 {
    let part = shared(area, other);
    if part > 0.0 && round {
        // The place of the box that is nearest to the middle, in halves of the balloon.
        let middle = center(area);
        let near = |at: f64, start: f64, length: f64| (at.clamp(start, start + length) - at).abs();
        let x = near(middle.x, other.x, other.width) / (area.width / 2.0);
        let y = near(middle.y, other.y, other.height) / (area.height / 2.0);
        if x.powf(2.4) + y.powf(2.4) >= 1.0 {
            return 0.0;
        }
    }
    part
}

/// Returns whether two ovals have a distance although their boxes overlap.
fn ovals_apart(a: Bounds, b: Bounds, near: f64) -> bool {
    let (one, other) = (center(a), center(b));
    let across = (one.x - other.x).abs() / (f64::midpoint(a.width, b.width) + near);
    let down = (one.y - other.y).abs() / (f64::midpoint(a.height, b.height) + near);
    across.powf(2.4) + down.powf(2.4) >= 1.0
}

/// Intersection of the outline of a balloon with the line from its centre to a point.
fn edge(area: Bounds, to: Point) -> Point {
    let middle = center(area);
    let (x, y) = ((to.x - middle.x) * 2.0 / area.width, (to.y - middle.y) * 2.0 / area.height);
    let inside = (x.abs().powf(2.4) + y.abs().powf(2.4)).powf(1.0 / 2.4);
    middle.toward(to, (1.0 / inside.max(1e-9)).min(1.0))
}

/// How far along a line a box begins, 0 to 1; more than 1 where the line ends before.
fn entry(from: Point, to: Point, bounds: Bounds) -> f64 {
    span(from, to, bounds).map_or(2.0, |(first, _)| first)
}

/// Returns the part of a line inside a box, in lengths of the line.
fn inside(from: Point, to: Point, bounds: Bounds) -> f64 {
    span(from, to, bounds).map_or(0.0, |(first, last)| last - first)
}

/// Returns the part of a line inside a box (Liang and Barsky, 1984).
fn span(from: Point, to: Point, bounds: Bounds) -> Option<(f64, f64)> {
    let (mut first, mut last) = (0.0f64, 1.0f64);
    let sides = [
        (from.x, to.x - from.x, bounds.x, bounds.x + bounds.width),
        (from.y, to.y - from.y, bounds.y, bounds.y + bounds.height),
    ];
    for (start, step, low, high) in sides {
        if step.abs() < 1e-12 {
            if start < low || start > high {
                return None;
            }
            continue;
        }
        let (a, b) = ((low - start) / step, (high - start) / step);
        first = first.max(a.min(b));
        last = last.min(a.max(b));
    }
    (first <= last).then_some((first, last))
}

/// Whether two lines cross.
fn crossing((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}
