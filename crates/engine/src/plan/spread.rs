//! An album cut into pages where its time, its place or its scene changes.

use super::moments::Moment;
use crate::framing::PhotoMeta;
use crate::order::sort_by;

/// Cost of a page, which limits the number of pages.
const PAGE: f64 = 0.35;
/// Minimum number of photos of a full page, and the cost of a page with fewer photos.
const FEWEST: usize = 3;
const LEFTOVER: f64 = 1.5;
/// Pauses that count as a possible break and as a certain break, relative to the median.
const PAUSES: (f64, f64) = (3.0, 60.0);
/// Mean differences of colours, in grey levels, within a scene and between two scenes.
const COLOURS: (f64, f64) = (24.0, 90.0);
/// Bits of fingerprints that two photos of one place may differ in, as noise has it.
const ALIKE: f64 = 20.0;

/// Returns the number of photos on each of `pages` pages. With fewer photos, there are fewer pages.
#[must_use]
pub fn into_pages(photos: &[PhotoMeta], pages: usize) -> Vec<usize> {
    let pages = pages.clamp(1, photos.len().max(1));
    let even = photos.len() as f64 / pages as f64;
    // Pages may have up to twice the even number of photos, which also limits the work.
    let most = ((2.0 * even).ceil() as usize).clamp(1, photos.len().max(1));
    let allowed: Vec<usize> = (1..=most).collect();
    solved(&cuts(photos), &allowed, even, pages).unwrap_or_else(|| vec![photos.len()])
}

/// Pages of nearly the same number of photos each, so that no page is a leftover: the photos of each page.
/// `counts`: numbers of panels of the layouts. If it is empty, all numbers are allowed.
#[must_use]
pub fn balanced(count: usize, most: usize, counts: &[usize]) -> Vec<usize> {
    let mut sizes = Vec::new();
    let mut rest = count;
    while rest > 0 {
        let even = rest.div_ceil(rest.div_ceil(most.max(1)));
        // A page leaves out photos beyond its number of panels.
        let size = counts.iter().copied().filter(|count| (1..=even).contains(count)).max().unwrap_or(even);
        sizes.push(size);
        rest -= size;
    }
    sizes
}

/// Score of a page break before each photo, except the first, 0 to 1.
#[must_use]
pub fn cuts(photos: &[PhotoMeta]) -> Vec<f64> {
    let seconds = |taken| Moment::parse(taken).map(|moment| moment.seconds as f64);
    let times: Vec<Option<f64>> =
        photos.iter().map(|photo| photo.taken.as_deref().and_then(seconds)).collect();
    let pause = |i: usize| Some((times[i]? - times[i - 1]?).abs());
    let mut pauses: Vec<f64> = (1..photos.len()).filter_map(pause).collect();
    sort_by(&mut pauses, f64::total_cmp);
    let usual = pauses.get(pauses.len() / 2).copied().unwrap_or(0.0).max(20.0);
    let ramp = |value: f64, (low, high): (f64, f64)| ((value - low) / (high - low)).clamp(0.0, 1.0);
    (1..photos.len())
        .map(|i| {
            let time = pause(i).map_or(0.0, |pause| {
                let (low, high) = PAUSES;
                ramp((pause / usual).max(1e-9).ln(), (low.ln(), high.ln()))
            });
            let (before, after) = (&photos[i - 1], &photos[i]);
            let colour = match (&before.facts, &after.facts) {
                (Some(a), Some(b)) => {
                    let apart = a.colours.iter().zip(b.colours).map(|(a, b)| f64::from(a.abs_diff(b)));
                    ramp(apart.sum::<f64>() / 6.0, COLOURS)
                }
                _ => 0.0,
            };
            let bits = f64::from((before.fingerprint ^ after.fingerprint).count_ones());
            // Similar photos belong together, even if their capture times differ.
            let together = if bits < ALIKE { 0.3 } else { 1.0 };
            (time.max(0.6 * colour) + 0.25 * time.min(colour)).min(1.0) * together
        })
        .collect()
}

/// Returns the sizes with the lowest cost: the best pages of the first `end` photos end with one of the
/// allowed sizes.
fn solved(cuts: &[f64], allowed: &[usize], even: f64, pages: usize) -> Option<Vec<usize>> {
    let count = cuts.len() + 1;
    let cost = |size: usize| {
        let uneven = (size as f64 - even) / even.max(1.0);
        PAGE + uneven * uneven + if size < FEWEST && even >= FEWEST as f64 { LEFTOVER } else { 0.0 }
    };
    // Each layer of the table has one page more than the last.
    let mut best = vec![vec![(f64::INFINITY, 0usize); count + 1]; pages + 1];
    best[0][0].0 = 0.0;
    for layer in 1..=pages {
        for end in 1..=count {
            for &size in allowed.iter().filter(|&&size| size <= end) {
                let gain = if end < count { cuts[end - 1] } else { 0.0 };
                let total = best[layer - 1][end - size].0 + cost(size) - gain;
                if total < best[layer][end].0 {
                    best[layer][end] = (total, size);
                }
            }
        }
    }
    let mut sizes = Vec::new();
    let (mut end, mut layer) = (count, pages);
    while end > 0 {
        let (total, size) = best[layer][end];
        if !total.is_finite() || size == 0 {
            return None;
        }
        sizes.push(size);
        end -= size;
        layer -= 1;
    }
    sizes.reverse();
    Some(sizes)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn at(i: usize, hour: usize, minute: usize) -> PhotoMeta {
        PhotoMeta {
            fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
            taken: Some(format!("2024:05:17 {hour:02}:{minute:02}:00")),
            ..PhotoMeta::unmeasured(&format!("p{i}"), 4000, 3000)
        }
    }

    #[test]
    fn a_pause_begins_a_page() {
        // A walk of five photos, hours later a meal of four, at night seven.
        let minutes = [(10, 5), (14, 4), (22, 7)];
        let photos: Vec<PhotoMeta> = minutes
            .iter()
            .flat_map(|&(hour, count)| (0..count).map(move |i| (hour, i)))
            .enumerate()
            .map(|(i, (hour, minute))| at(i, hour, minute))
            .collect();
        assert_eq!(into_pages(&photos, 3), [5, 4, 7]);
        assert_eq!(into_pages(&photos, 2).len(), 2);
    }

    #[test]
    fn an_even_album_has_even_pages() {
        let photos: Vec<PhotoMeta> = (0..13).map(|i| PhotoMeta { taken: None, ..at(i, 0, 0) }).collect();
        assert_eq!(into_pages(&photos, 2).iter().sum::<usize>(), 13);
        assert!(into_pages(&photos[..2], 9).len() <= 2);
    }

    proptest! {
        #[test]
        fn every_photo_is_on_one_page(
            hours in prop::collection::vec(0usize..24, 1..60),
            pages in 1usize..12,
        ) {
            let photos: Vec<PhotoMeta> = hours.iter().enumerate().map(|(i, &hour)| at(i, hour, i % 60)).collect();
            let told = into_pages(&photos, pages);
            prop_assert_eq!(told.iter().sum::<usize>(), photos.len());
            prop_assert_eq!(told.len(), pages.min(photos.len()));
        }
    }
}
