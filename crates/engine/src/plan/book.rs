//! The pages of a book, without documents: which photos each page shows, and where chapters begin.
//!
//! ```text
//! cover      the strongest photo that suits the page
//! pages      a chapter per day, cut where time, place or scene change, by dynamic programming
//! full page  only a strong photo, at most one of twenty; the page after it is quiet
//! end page   the last photo
//! ```

use super::assign::Photos;
use super::moments::Moment;
use super::prepared::Kind;
use super::slots::Slot;
use super::spread;
use super::utility::placed;
use crate::framing::{FACE, PhotoMeta, Subject};

/// Maximum number of photos of a page.
pub const MOST_OF_A_PAGE: usize = 9;
/// Minimum number of photos of a book that has an end page, and of one that has full pages.
const MIN_END: usize = 6;
const MIN_FULL: usize = 10;
/// One of this many photos may have a full page.
const FULL_EACH: usize = 20;
/// Minimum distance of two full pages in photos.
const FULL_APART: usize = 6;
/// Minimum number of photos per page on average, with cover and end page, and number of pages that any book may have.
const USUAL: usize = 4;
const MIN_USUAL: usize = 5;
/// Number of photos per page of a book without full pages.
const TIGHT: usize = 5;
/// Minimum number of photos between a full page and the border of its chapter, or 0 photos.
const FEW: usize = 3;
/// Number of photos that the first page has at most, and their loss as the cover, because it would be next to it.
const OPENING: usize = 6;
const NEXT: f64 = 0.2;
/// Gain of a photo with a large face that looks at the camera, height of such a face in photo heights, and its minimum score.
const CLEAR: f64 = 0.3;
const LARGE: f64 = 0.2;
const SURE: f64 = 0.7;
/// Minimum fit of a photo that fills a page.
const FULL_FIT: f64 = 0.45;
/// Loss of a photo that fills a page of whole photos, if the logarithms of their aspect ratios differ more.
const UNLIKE: f64 = 0.25;
const CUT: f64 = 0.6;
/// Cost of a page, so that there are not more than needed.
const PAGE: f64 = 0.8;
/// Cost of a page by its number of photos, from 1, and of a page behind a full page.
const SIZES: [f64; MOST_OF_A_PAGE] = [3.0, 0.9, 0.4, 0.12, 0.0, 0.0, 0.4, 1.3, 2.6];
const QUIET: [f64; MOST_OF_A_PAGE] = [3.0, 0.15, 0.0, 0.2, 0.5, 0.8, 1.2, 1.8, 2.4];
/// Cost of two pages of one size in a row.
const SAME: f64 = 0.12;
/// Cost of a change of day, place or scene within a page.
const DAY: f64 = 1.3;
const PLACE: f64 = 0.6;
const SCENE: f64 = 0.6;
/// Cost of the empty part of a page, if photos are whole, and number of photos that fill any page.
const EMPTY: f64 = 3.0;
const FILLS: usize = 5;
/// Cost of two starred photos on one page: only one of them leads it.
const STARS: f64 = 0.9;
/// Cost that no page may have.
const NEVER: f64 = 1e9;

/// Purpose of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The first page, with the title.
    Cover,
    /// A photo that fills its page.
    Full,
    /// Any other page with photos.
    Page,
    /// The last page.
    End,
}

impl Role {
    /// Its name in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Cover => "cover",
            Self::Full => "full",
            Self::Page => "page",
            Self::End => "end",
        }
    }
}

/// A page of a book.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Leaf {
    /// Its purpose.
    pub role: Role,
    /// Index of the chapter of its first photo.
    pub chapter: usize,
    /// Its photos, as indices of the album, in their order.
    pub photos: Vec<usize>,
}

/// The pages of a book.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outline {
    /// The pages, the cover first.
    pub leaves: Vec<Leaf>,
    /// The chapter of each photo of the album. A chapter is a day, or all photos without a date.
    pub chapters: Vec<usize>,
}

/// Requirements for an outline.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// The place of each photo; empty if it is unknown.
    pub places: &'a [&'a str],
    /// Number of pages with cover and end page. `None`: as many as the photos need.
    pub pages: Option<usize>,
    /// Maximum number of pages.
    pub most: usize,
    /// Numbers of panels that layouts of this page have.
    pub counts: &'a [usize],
    /// A panel that fills the page.
    pub whole: &'a Slot,
    /// Whether no page has photos of two chapters.
    pub apart: bool,
    /// Width over height of the page, if it shows photos whole.
    pub uncropped: Option<f64>,
}

/// Plans the pages of a book. The photos of `album` must be in their order in time.
///
/// Each photo is on one page, except documents, and except the weakest photos of an album that is too large for the pages. The
/// cover repeats a photo. Every starred photo and every chapter has a place.
#[must_use]
pub fn outline(album: &Photos, wanted: &Wanted) -> Outline {
    let photos = album.all;
    let chapters = chapters(photos);
    let fits: Vec<f64> = (0..photos.len())
        .map(|i| {
            let fit = placed(wanted.whole, &photos[i], album.prepared(i)).1.fit();
            let unlike = wanted.uncropped.is_some_and(|page| (photos[i].aspect() / page).ln().abs() > UNLIKE);
            if unlike { fit - CUT } else { fit }
        })
        .collect();
    let rate = |i: usize| strength(album, i) + 0.5 * fits[i].clamp(-1.0, 1.0);
    // Pages of a book of short days get the photos of several days.
    let usual = if wanted.apart { wanted.most } else { photos.len().div_ceil(USUAL).max(MIN_USUAL) };
    let most = wanted.pages.unwrap_or(usual).clamp(1, wanted.most);
    let inner = kept(album, &chapters, most.saturating_sub(2).max(1) * MOST_OF_A_PAGE);
    // The first photos follow the cover, so another photo of nearly equal strength is the cover.
    let as_cover =
        |i: usize| rate(i) - if inner.iter().take(OPENING).any(|&next| next == i) { NEXT } else { 0.0 };
    let Some(cover) = best(&inner, as_cover) else { return Outline { leaves: Vec::new(), chapters } };
    let mut leaves = vec![Leaf { role: Role::Cover, chapter: chapters[cover], photos: vec![cover] }];
    let end = (most > 2).then(|| closing(&inner, &chapters, (album, cover), rate)).flatten();
    let inner: Vec<usize> = inner.into_iter().filter(|photo| Some(*photo) != end).collect();
    let pages = wanted.pages.map(|pages| pages.saturating_sub(1 + usize::from(end.is_some())).max(1));
    // A book of few pages has no room for full pages, unless they are starred.
    let room = most.saturating_sub(1 + usize::from(end.is_some())).max(1);
    let tight = pages.is_some_and(|pages| inner.len() > pages * TIGHT);
    let strongest =
        if tight { Vec::new() } else { full_pages(&inner, &chapters, cover, &|i| fits[i], album) };
    let starred = strongest.iter().filter(|&&at| photos[inner[at]].starred).count();
    let mut count = strongest.len();
    let full = loop {
        let full: Vec<bool> = (0..inner.len()).map(|at| strongest[..count].contains(&at)).collect();
        let free = Spine::new(&inner, &full, &chapters, album, wanted).solved(PAGE).len();
        if count <= starred || pages.is_some() || free <= room {
            break full;
        }
        count -= 1;
    };
    let spine = Spine::new(&inner, &full, &chapters, album, wanted);
    let mut from = 0;
    for size in spine.sizes(pages, room) {
        let own = &inner[from..from + size];
        let role = if size == 1 && full[from] { Role::Full } else { Role::Page };
        leaves.push(Leaf { role, chapter: chapters[own[0]], photos: own.to_vec() });
        from += size;
    }
    leaves.extend(end.map(|photo| Leaf { role: Role::End, chapter: chapters[photo], photos: vec![photo] }));
    Outline { leaves, chapters }
}

/// The chapter of each photo, by its day. Photos without a date follow the photo before.
fn chapters(photos: &[PhotoMeta]) -> Vec<usize> {
    let mut chapter = 0;
    let mut last = None;
    let mut of = |photo: &PhotoMeta| {
        let day = photo.taken.as_deref().and_then(Moment::parse).map(Moment::day);
        if let (Some(before), Some(day)) = (last, day)
            && before != day
        {
            chapter += 1;
        }
        last = day.or(last);
        chapter
    };
    photos.iter().map(&mut of).collect()
}

/// Returns the strength of a photo for a full page.
fn strength(album: &Photos, photo: usize) -> f64 {
    let star = f64::from(u8::from(album.all[photo].starred));
    let sure = |face: &&Subject| face.label == FACE && face.score >= SURE;
    let clear = |face: &Subject| (face.height / LARGE).min(1.0) * face.clearness();
    let face = album.all[photo].subjects.iter().filter(sure).map(clear).fold(0.0, f64::max);
    let kind = match album.kind(photo) {
        Kind::Alive => 0.25,
        Kind::Scene => 0.0,
        Kind::Bare => -0.5,
        Kind::Document => -3.0,
    };
    album.quality[photo] + kind + CLEAR * face + 1.5 * star
}

/// The photo with the highest rate.
fn best(photos: &[usize], rate: impl Fn(usize) -> f64) -> Option<usize> {
    photos.iter().copied().max_by(|a, b| rate(*a).total_cmp(&rate(*b)).then(b.cmp(a)))
}

/// The photos of the pages: documents only if they are starred, or if a chapter has nothing else. At most `most`, the
/// weakest are left out, but no starred photo and no chapter.
fn kept(album: &Photos, chapters: &[usize], most: usize) -> Vec<usize> {
    let all = 0..album.all.len();
    let firm: Vec<bool> = {
        let mut firm: Vec<bool> = album.all.iter().map(|photo| photo.starred).collect();
        for chapter in 0..=chapters.last().copied().unwrap_or(0) {
            let own: Vec<usize> = all.clone().filter(|&i| chapters[i] == chapter).collect();
            if let Some(strongest) = best(&own, |i| strength(album, i)) {
                firm[strongest] = true;
            }
        }
        firm
    };
    let mut kept: Vec<usize> = all.clone().filter(|&i| firm[i] || album.kind(i) != Kind::Document).collect();
    if kept.len() > most {
        let mut free: Vec<usize> = kept.iter().copied().filter(|&i| !firm[i]).collect();
        free.sort_by(|&a, &b| strength(album, a).total_cmp(&strength(album, b)).then(b.cmp(&a)));
        free.truncate(kept.len() - most);
        kept.retain(|photo| !free.contains(photo));
    }
    kept
}

/// The photo of the end page: the best of the last four without the photo of the cover, if its chapter has other photos.
fn closing(
    photos: &[usize],
    chapters: &[usize],
    (album, cover): (&Photos, usize),
    rate: impl Fn(usize) -> f64,
) -> Option<usize> {
    if photos.len() < MIN_END {
        return None;
    }
    let chapter = chapters[*photos.last()?];
    let last: Vec<usize> = photos.iter().rev().take(4).copied().filter(|i| *i != cover).collect();
    let shared = photos.iter().filter(|&&i| chapters[i] == chapter).count() > 1;
    let own: Vec<usize> = if shared {
        last.into_iter().filter(|&i| chapters[i] == chapter && album.kind(i) != Kind::Document).collect()
    } else {
        Vec::new()
    };
    best(&own, rate)
}

/// The photos that fill a page, as places in `photos`, starred ones first, then the strongest.
fn full_pages(
    photos: &[usize],
    chapters: &[usize],
    cover: usize,
    fit: &dyn Fn(usize) -> f64,
    album: &Photos,
) -> Vec<usize> {
    if photos.len() < MIN_FULL {
        return Vec::new();
    }
    let starred = photos.iter().any(|&i| album.all[i].starred);
    let may = |&at: &usize| {
        let i = photos[at];
        let star = album.all[i].starred;
        let strong = star || album.lead(i) > 0.4 && i != cover;
        let scene = matches!(album.kind(i), Kind::Alive | Kind::Scene);
        strong && scene && fit(i) >= FULL_FIT && (star || !starred || album.kind(i) == Kind::Alive)
    };
    let mut some: Vec<usize> = (0..photos.len()).filter(may).collect();
    some.sort_by(|&a, &b| {
        let rate = |at: usize| strength(album, photos[at]) + 0.5 * fit(photos[at]);
        rate(b).total_cmp(&rate(a)).then(a.cmp(&b))
    });
    let mut chosen: Vec<usize> = Vec::new();
    for at in some {
        // The first page of the book shows where the story begins, and no few photos of a chapter are cut off.
        let alone = (1..FEW).any(|few| {
            let changes = |from: usize, to: usize| chapters[photos[from]] != chapters[photos[to]];
            at > few && changes(at - few - 1, at - few) && !changes(at - few, at)
                || at + few + 1 < photos.len() && changes(at + few, at + few + 1) && !changes(at, at + few)
        });
        let late = at + FEW >= photos.len();
        if at > 1 && !alone && !late && chosen.iter().all(|other| other.abs_diff(at) >= FULL_APART) {
            chosen.push(at);
        }
        if chosen.len() == photos.len() / FULL_EACH + usize::from(photos.len() < FULL_EACH) {
            break;
        }
    }
    chosen
}

/// The photos of all pages in a row, with the cost of each place that is not cut.
struct Spine<'a> {
    full: &'a [bool],
    /// Cost of photos `i` and `i + 1` on one page.
    joints: Vec<f64>,
    starred: Vec<bool>,
    sizes: Vec<usize>,
    /// Width over height of the page, and of each photo, if they are shown whole.
    uncropped: Option<(f64, Vec<f64>)>,
}

/// The last page of a row: 0 for a full page, otherwise its number of photos.
type Last = usize;

impl<'a> Spine<'a> {
    fn new(inner: &[usize], full: &'a [bool], chapters: &[usize], album: &Photos, wanted: &Wanted) -> Self {
        let photos: Vec<PhotoMeta> = inner.iter().map(|&i| album.all[i].clone()).collect();
        let scenes = spread::cuts(&photos);
        let joints = (1..inner.len()).map(|at| {
            let (a, b) = (inner[at - 1], inner[at]);
            let (from, to) = (wanted.places[a], wanted.places[b]);
            let place = !from.is_empty() && !to.is_empty() && from != to;
            // Photos without a date come after the dated photos.
            let dated = |i: usize| album.all[i].taken.is_some();
            match chapters[a] != chapters[b] || dated(a) != dated(b) {
                _ if wanted.apart && chapters[a] != chapters[b] => NEVER,
                day => {
                    let cost = |on: bool, cost: f64| if on { cost } else { 0.0 };
                    cost(day, DAY) + cost(place, PLACE) + SCENE * scenes[at - 1]
                }
            }
        });
        let mut sizes: Vec<usize> =
            (1..=MOST_OF_A_PAGE).filter(|size| *size == 1 || wanted.counts.contains(size)).collect();
        sizes.dedup();
        let starred = inner.iter().map(|&i| album.all[i].starred).collect();
        let aspects = || inner.iter().map(|&i| album.all[i].aspect()).collect();
        let uncropped = wanted.uncropped.map(|page| (page, aspects()));
        Self { full, joints: joints.collect(), starred, sizes, uncropped }
    }

    /// The number of photos of each page. `pages`: the wanted number of pages; `most`: their maximum.
    fn sizes(&self, pages: Option<usize>, most: usize) -> Vec<usize> {
        let free = self.solved(PAGE);
        let wanted = match pages {
            Some(pages) => pages.min(self.full.len()),
            None if free.len() <= most => return free,
            None => most,
        };
        // A higher cost of a page gives fewer pages.
        let (mut low, mut high) = (-8.0, 24.0);
        let mut found = free;
        for _ in 0..24 {
            if found.len() == wanted {
                break;
            }
            let price = f64::midpoint(low, high);
            found = self.solved(price);
            if found.len() > wanted {
                low = price;
            } else {
                high = price;
            }
        }
        self.adjusted(found, wanted)
    }

    /// Joins or cuts pages one by one until the number is right.
    fn adjusted(&self, mut sizes: Vec<usize>, wanted: usize) -> Vec<usize> {
        let start = |sizes: &[usize], at: usize| sizes[..at].iter().sum::<usize>();
        while sizes.len() > wanted.max(1) {
            let cost = |at: usize| {
                let from = start(&sizes, at);
                let size = sizes[at] + sizes[at + 1];
                let cost = (size <= MOST_OF_A_PAGE).then(|| self.cost(from, from + size, 1));
                cost.filter(|cost| *cost < NEVER)
            };
            let joined = (0..sizes.len() - 1)
                .filter_map(|at| Some((at, cost(at)?)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            let Some((at, _)) = joined else { break };
            sizes[at] += sizes.remove(at + 1);
        }
        if sizes.len() > wanted.max(1) && self.joints.iter().all(|joint| *joint < NEVER) {
            let count = self.full.len();
            let pages = wanted.max(count.div_ceil(MOST_OF_A_PAGE));
            let even = |page: usize| (page + 1) * count / pages - page * count / pages;
            sizes = (0..pages).map(even).filter(|size| *size > 0).collect();
        }
        while sizes.len() < wanted {
            let largest = (0..sizes.len()).max_by_key(|&at| sizes[at]).filter(|&at| sizes[at] > 1);
            let Some(at) = largest else { break };
            let half = sizes[at] / 2;
            sizes[at] -= half;
            sizes.insert(at + 1, half);
        }
        sizes
    }

    /// Cost of a page with the photos `from..to`, behind a page `last`.
    fn cost(&self, from: usize, to: usize, last: Last) -> f64 {
        let size = to - from;
        if size > 1 && self.full[from..to].contains(&true) {
            return NEVER;
        }
        if self.full[from] {
            return if last == 0 && from > 0 { 0.6 } else { 0.0 };
        }
        let sizes = if last == 0 && from > 0 { QUIET } else { SIZES };
        let stars = self.starred[from..to].iter().filter(|starred| **starred).count().saturating_sub(1);
        let same = if size == last && from > 0 { SAME } else { 0.0 };
        let joints: f64 = self.joints[from..to - 1].iter().sum();
        sizes[size - 1] + same + joints + STARS * stars as f64 + EMPTY * self.unused(from, to)
    }

    /// The part of a page that is empty, if it shows the photos `from..to` whole.
    fn unused(&self, from: usize, to: usize) -> f64 {
        match &self.uncropped {
            Some((page, aspects)) if (2..FILLS).contains(&(to - from)) => {
                let used =
                    arranged(&aspects[from..to]).into_iter().map(|aspect| (aspect / page).min(page / aspect));
                1.0 - used.fold(0.0, f64::max)
            }
            _ => 0.0,
        }
    }

    /// The pages of the least cost, if each page costs `price`.
    fn solved(&self, price: f64) -> Vec<usize> {
        const STATES: usize = MOST_OF_A_PAGE + 1;
        let count = self.full.len();
        // For each end and last page: cost, size, and the page before.
        let mut best = vec![[(f64::INFINITY, 0usize, 0usize); STATES]; count + 1];
        best[0][0].0 = 0.0;
        for end in 1..=count {
            for &size in self.sizes.iter().filter(|&&size| size <= end) {
                let from = end - size;
                let state = if size == 1 && self.full[from] { 0 } else { size };
                for last in 0..STATES {
                    let before = best[from][last].0;
                    if before.is_finite() {
                        let total = before + price + self.cost(from, end, last);
                        if total < best[end][state].0 {
                            best[end][state] = (total, size, last);
                        }
                    }
                }
            }
        }
        let mut sizes = Vec::new();
        let mut end = count;
        let mut state = (0..STATES).min_by(|&a, &b| best[end][a].0.total_cmp(&best[end][b].0)).unwrap_or(0);
        while end > 0 {
            let (_, size, last) = best[end][state];
            sizes.push(size.max(1));
            end -= size.max(1);
            state = last;
        }
        sizes.reverse();
        sizes
    }
}

/// The aspect ratios of all arrangements of photos in rows and columns.
fn arranged(aspects: &[f64]) -> Vec<f64> {
    if let [one] = aspects {
        return vec![*one];
    }
    let mut all = Vec::new();
    for cut in 1..aspects.len() {
        let [first, rest] = [&aspects[..cut], &aspects[cut..]].map(arranged);
        for (a, b) in first.iter().flat_map(|a| rest.iter().map(move |b| (a, b))) {
            all.extend([a + b, a * b / (a + b)]);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::{self, PageSettings};
    use crate::plan::composer::gallery;
    use crate::plan::slots::slots;
    use crate::plan::{Shelf, Slot};
    use proptest::prelude::*;
    use std::collections::HashSet;

    fn whole() -> Slot {
        let settings = PageSettings::default();
        let panels = layout::resolve(layout::find("splash").unwrap(), settings.aspect(), &settings);
        slots(&panels, settings.looked_at()).remove(0)
    }

    fn photo(i: usize, day: usize, minute: usize) -> PhotoMeta {
        PhotoMeta {
            fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
            taken: Some(format!("2026:06:{:02} {:02}:{:02}:00", 1 + day, 9 + minute / 60, minute % 60)),
            ..PhotoMeta::unmeasured(&format!("p{i}"), 3000, if i.is_multiple_of(3) { 4200 } else { 2000 })
        }
    }

    fn made(photos: &[PhotoMeta], pages: Option<usize>, apart: bool) -> Outline {
        let shelf = Shelf::new(photos.len());
        let (places, whole) = (vec![""; photos.len()], whole());
        let wanted = Wanted {
            places: &places,
            pages,
            most: 1000,
            counts: &[1, 2, 3, 4, 5, 6, 7, 8, 9],
            whole: &whole,
            apart,
            uncropped: None,
        };
        outline(&gallery(photos, &shelf), &wanted)
    }

    #[test]
    fn the_cover_shows_a_face_that_looks_at_the_camera() {
        let mut photos = trip();
        // The points of both faces differ in the tip of the nose.
        for (at, nose) in [(19, 0.6), (25, 0.5)] {
            let points = [[0.45, 0.3], [0.55, 0.3], [nose, 0.35], [0.5, 0.42], [0.4, 0.32], [0.6, 0.32]];
            photos[at].find([Subject {
                x: 0.4,
                y: 0.2,
                width: 0.2,
                height: 0.3,
                label: FACE.into(),
                score: 0.95,
                points: Some(points),
                expression: None,
                light: None,
            }]);
        }
        assert_eq!(made(&photos, None, false).leaves[0].photos, [25]);
        // Of two such faces, the one in light is on the cover, not the earlier one in the shade.
        let mut shade = photos[25].subjects.clone();
        photos[29].find(shade.clone());
        shade[0].light = Some(0.0);
        photos[25].find(shade);
        assert_eq!(made(&photos, None, false).leaves[0].photos, [29]);
    }

    #[test]
    fn photos_without_a_date_begin_a_page() {
        let mut photos: Vec<PhotoMeta> = (0..11).map(|i| photo(i, 0, i * 5)).collect();
        for photo in &mut photos[4..] {
            photo.taken = None;
        }
        let outline = made(&photos, None, false);
        assert!(outline.leaves.iter().any(|leaf| leaf.photos.first() == Some(&4)), "{outline:?}");
    }

    #[test]
    fn two_whole_portraits_leave_half_a_page_empty() {
        let all = |aspects: &[f64]| -> Spine {
            Spine {
                full: &[false; 4],
                joints: vec![0.0; 3],
                starred: vec![false; 4],
                sizes: vec![1, 2, 3, 4],
                uncropped: Some((0.7, aspects.to_vec())),
            }
        };
        let portraits = all(&[0.75; 4]);
        assert!(portraits.unused(0, 2) > 0.4 && portraits.unused(0, 4) < 0.1);
        assert_eq!(portraits.sizes(None, 9), [4]);
        assert!(all(&[1.5; 4]).unused(0, 2) < 0.1);
    }

    /// Forty photos of four days.
    fn trip() -> Vec<PhotoMeta> {
        (0..40).map(|i| photo(i, i / 10, (i % 10) * 7 + if i % 10 > 4 { 300 } else { 0 })).collect()
    }

    #[test]
    fn forty_photos_are_eight_to_ten_pages() {
        let outline = made(&trip(), None, false);
        assert!((8..=10).contains(&outline.leaves.len()), "{outline:?}");
        assert_eq!(outline.leaves[0].role, Role::Cover);
        assert_eq!(outline.leaves.last().unwrap().role, Role::End);
        // Pages begin where days do.
        for day in 1..4 {
            assert!(outline.leaves.iter().any(|leaf| leaf.photos[0] == 10 * day), "{outline:?}");
        }
    }

    #[test]
    fn the_cover_has_the_strongest_photo_and_a_quiet_page_follows_a_full_one() {
        let mut photos = trip();
        for (at, height) in [(18, 0.3), (25, 0.24)] {
            photos[at].find([Subject {
                x: 0.4,
                y: 0.2,
                width: 0.2,
                height,
                label: FACE.into(),
                score: 0.95,
                points: None,
                expression: None,
                light: None,
            }]);
        }
        photos[25].starred = true;
        let outline = made(&photos, None, false);
        assert_eq!(outline.leaves[0].photos, [25]);
        let full = outline.leaves.iter().position(|leaf| leaf.role == Role::Full).unwrap();
        assert!(outline.leaves[full + 1].photos.len() <= 4, "{outline:?}");
    }

    #[test]
    fn documents_are_left_out_unless_they_are_all_that_a_day_has() {
        let mut photos: Vec<PhotoMeta> = (0..12).map(|i| photo(i, i / 6, i * 5)).collect();
        photos.push(photo(12, 4, 0));
        for at in [3, 12] {
            let all = Subject {
                x: 0.0,
                y: 0.0,
                width: 1.0,
                height: 1.0,
                label: "cell phone".into(),
                score: 0.9,
                points: None,
                expression: None,
                light: None,
            };
            photos[at].find([all]);
        }
        let outline = made(&photos, None, false);
        let shown: HashSet<usize> = outline.leaves.iter().flat_map(|leaf| leaf.photos.clone()).collect();
        assert!(!shown.contains(&3) && shown.contains(&12));
    }

    #[test]
    fn no_photos_make_no_pages_and_one_makes_two() {
        assert!(made(&[], None, false).leaves.is_empty());
        assert_eq!(made(&trip()[..1], None, false).leaves.len(), 2);
    }

    proptest! {
        #[test]
        fn each_photo_has_one_page_and_every_star_and_day_a_place(
            days in prop::collection::vec((0usize..25, any::<bool>()), 1..120),
            pages in prop::option::of(3usize..20),
            apart: bool,
        ) {
            let mut days = days;
            days.sort_unstable();
            let photos: Vec<PhotoMeta> = days
                .iter()
                .enumerate()
                .map(|(i, (day, star))| PhotoMeta { starred: *star && i % 7 == 0, ..photo(i, *day, i % 600) })
                .collect();
            let outline = made(&photos, pages, apart);
            prop_assert_eq!(outline.leaves[0].role, Role::Cover);
            let inner: Vec<usize> = outline.leaves[1..].iter().flat_map(|leaf| leaf.photos.clone()).collect();
            let shown: HashSet<usize> = inner.iter().copied().collect();
            prop_assert_eq!(shown.len(), inner.len(), "no photo twice");
            for (i, photo) in photos.iter().enumerate() {
                prop_assert!(!photo.starred || shown.contains(&i));
                prop_assert!(pages.is_some() || shown.contains(&i));
            }
            let told: HashSet<usize> = inner.iter().map(|&i| outline.chapters[i]).collect();
            prop_assert_eq!(told.len(), outline.chapters.last().unwrap() + 1, "every day");
            for leaf in &outline.leaves {
                prop_assert!((1..=MOST_OF_A_PAGE).contains(&leaf.photos.len()));
                if apart {
                    prop_assert!(leaf.photos.iter().all(|&i| outline.chapters[i] == leaf.chapter));
                }
            }
            if let (Some(pages), false) = (pages, apart) {
                prop_assert!(outline.leaves.len() <= pages || inner.len() > (pages - 2) * MOST_OF_A_PAGE);
            }
        }
    }
}
