//! Selects photos and gives the reasons.

use super::Measures;
use super::fingerprint::distance;
use super::groups::leaders_by;
use crate::order::sort_by;
pub use inkpanel_model::limits::{DUPLICATE_THRESHOLD, DUPLICATE_THRESHOLD_RANGE};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// Below this part of the album's median [`laplacian`](super::sharpness::laplacian) a photo counts as
/// blurred. In a set of 150 varied photos, one is below (a bare pyramid in haze). All of them are below this
/// value after blurring with a sigma of 2 pixels of 640.
const BLURRED: f32 = 0.04;
/// Minimum number of photos for a meaningful median.
const FEW: usize = 4;

/// Divisor of the threshold for frames of one video. They were selected for their differences, and movements
/// in a video are often small.
const OF_A_FILM: u32 = 4;
/// Minimum number of frames per video, without exact duplicates. This is about the number of panels of a
/// page.
const FEWEST_OF_FILM: usize = 8;

/// Eyes are shut if they are narrower than this share of the eyes of a near-duplicate, and than this openness. Faces differ, so
/// an openness is not enough to find shut eyes. `tests/oracles/eyes.py` measures both values.
const SHUT: (f64, f64) = (0.9, 0.245);

/// How photos are chosen.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Maximum fingerprint distance of near-duplicates; see [`DUPLICATE_THRESHOLD_RANGE`].
    pub duplicate_threshold: u32,
    /// Index of the video of each photo that is a video frame. Empty without videos.
    pub films: Vec<Option<usize>>,
    /// Openness of the most shut eyes in each photo, if known: the distance of the lids in widths of an eye. May be empty.
    pub openness: Vec<Option<f64>>,
}

impl Default for Settings {
    fn default() -> Self {
        Self { duplicate_threshold: DUPLICATE_THRESHOLD, films: Vec::new(), openness: Vec::new() }
    }
}

impl Settings {
    fn film(&self, photo: usize) -> Option<usize> {
        self.films.get(photo).copied().flatten()
    }

    fn openness(&self, photo: usize) -> Option<f64> {
        self.openness.get(photo).copied().flatten()
    }
}

/// Result of the selection for a photo.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    /// Number of its group of near-duplicates, from 0 in the order of their first members.
    pub group: usize,
    /// Whether it is used.
    pub kept: bool,
    /// The reason.
    pub reason: Reason,
}

/// Why a photo is used or left out. Displays as a few English words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(tag = "code", rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "VerdictReason"))]
pub enum Reason {
    /// No other photo is like it.
    Only,
    /// It is the sharpest of its group.
    Sharpest {
        /// Number of photos in the group, at least 2.
        of: usize,
    },
    /// It is the sharpest photo of its group in which all eyes are open.
    OpenEyes {
        /// Number of photos in the group, at least 2.
        of: usize,
    },
    /// Another photo of its group is used.
    SameAs {
        /// Name of the photo that is used.
        name: String,
    },
    /// It is far blurrier than the album.
    Blurred,
    /// It is another frame of a video with few frames.
    Frame,
}

impl Display for Reason {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Only => f.write_str("only one like it"),
            Self::Sharpest { of } => write!(f, "sharpest of {of}"),
            Self::OpenEyes { of } => write!(f, "open eyes, best of {of}"),
            Self::SameAs { name } => write!(f, "same as {name}"),
            Self::Blurred => f.write_str("blurred"),
            Self::Frame => f.write_str("another frame of the video"),
        }
    }
}

/// Judges photos: of each group of near-duplicates, the sharpest of the photos without shut eyes is selected, unless it
/// is far blurrier than the album. Returns a verdict for each of `measures`, in their order. If all
/// would be rejected, the sharpest is selected.
#[must_use]
pub fn choose(names: &[&str], measures: &[Measures], settings: &Settings) -> Vec<Verdict> {
    let fingerprints: Vec<u64> = measures.iter().map(|measure| measure.fingerprint).collect();
    let threshold = |a: usize, b: usize| {
        let same = settings.film(a).is_some_and(|film| settings.film(b) == Some(film));
        if same { settings.duplicate_threshold / OF_A_FILM } else { settings.duplicate_threshold }
    };
    let groups = leaders_by(&fingerprints, &threshold);
    let count = groups.iter().max().map_or(0, |most| most + 1);
    let floor = blur_floor(measures);
    // Sharp photos rank before blurred ones, even if noise has a higher gradient.
    let clear = |i: usize| (measures[i].laplacian >= floor, measures[i].gradient);
    let mut widest = vec![0.0; count];
    for (i, &group) in groups.iter().enumerate() {
        widest[group] = f64::max(widest[group], settings.openness(i).unwrap_or(0.0));
    }
    let is_shut = |i: usize| {
        settings.openness(i).is_some_and(|openness| openness < (SHUT.0 * widest[groups[i]]).min(SHUT.1))
    };
    let rank = |i: usize| (clear(i).0, !is_shut(i), clear(i).1);
    let mut sizes = vec![0; count];
    let mut best = vec![usize::MAX; count];
    let mut sharpest = vec![usize::MAX; count];
    for (i, &group) in groups.iter().enumerate() {
        sizes[group] += 1;
        if best[group] == usize::MAX || rank(i) > rank(best[group]) {
            best[group] = i;
        }
        if sharpest[group] == usize::MAX || clear(i) > clear(sharpest[group]) {
            sharpest[group] = i;
        }
    }
    let verdict = |i: usize, group: usize| {
        let chosen = best[group];
        let (kept, reason) = if i != chosen {
            let name = names.get(chosen).copied().unwrap_or("another");
            (false, Reason::SameAs { name: name.to_owned() })
        } else if measures[i].laplacian < floor {
            (false, Reason::Blurred)
        } else if i != sharpest[group] {
            (true, Reason::OpenEyes { of: sizes[group] })
        } else if sizes[group] > 1 {
            (true, Reason::Sharpest { of: sizes[group] })
        } else {
            (true, Reason::Only)
        };
        Verdict { group, kept, reason }
    };
    let mut verdicts: Vec<Verdict> = groups.iter().enumerate().map(|(i, &group)| verdict(i, group)).collect();
    keep_some_of_films(&mut verdicts, measures, settings);
    verdicts
}

/// Adds more frames of videos with too few selected frames, the most different ones first.
fn keep_some_of_films(verdicts: &mut [Verdict], measures: &[Measures], settings: &Settings) {
    let floor = blur_floor(measures);
    let count = settings.films.iter().flatten().max().map_or(0, |most| most + 1);
    for film in 0..count {
        let frames = || (0..measures.len()).filter(|&i| settings.film(i) == Some(film));
        loop {
            let kept: Vec<usize> = frames().filter(|&i| verdicts[i].kept).collect();
            let apart = |i: usize| {
                let from = |&other: &usize| distance(measures[other].fingerprint, measures[i].fingerprint);
                kept.iter().map(from).min().unwrap_or(64)
            };
            let other = |i: &usize| kept.iter().all(|&other| measures[other] != measures[*i]);
            let sharp = |i: &usize| measures[*i].laplacian >= floor && !verdicts[*i].kept;
            let next = frames().filter(sharp).filter(other).max_by_key(|&i| (apart(i), usize::MAX - i));
            let Some(next) = next.filter(|_| kept.len() < FEWEST_OF_FILM) else { break };
            verdicts[next].kept = true;
            verdicts[next].reason = Reason::Frame;
        }
    }
}

/// The Laplacian below which a photo of this album counts as blurred.
fn blur_floor(measures: &[Measures]) -> f32 {
    if measures.len() < FEW {
        return 0.0;
    }
    let mut sorted: Vec<f32> = measures.iter().map(|measure| measure.laplacian).collect();
    sort_by(&mut sorted, f32::total_cmp);
    BLURRED * sorted[sorted.len() / 2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn photo(fingerprint: u64, gradient: f32, laplacian: f32) -> Measures {
        Measures { fingerprint, gradient, paper: 1.0, laplacian }
    }

    #[test]
    fn each_verdict_says_why() {
        let names = ["a.jpg", "b.jpg", "c.jpg", "d.jpg", "e.jpg"];
        let measures = [
            photo(0, 1.0, 900.0),
            photo(0xFFFF_FFFF, 2.0, 800.0),
            photo(0b11, 3.0, 900.0),
            photo(0xFFFF_FFFF << 32, 0.1, 20.0),
            photo(0b111, 2.0, 950.0),
        ];
        let verdicts = choose(&names, &measures, &Settings::default());
        let seen: Vec<_> = verdicts.iter().map(|v| (v.group, v.kept, v.reason.to_string())).collect();
        let expected: Vec<_> = [
            (0, false, "same as c.jpg"),
            (1, true, "only one like it"),
            (0, true, "sharpest of 3"),
            (2, false, "blurred"),
            (0, false, "same as c.jpg"),
        ]
        .map(|(group, kept, why)| (group, kept, why.to_owned()))
        .into();
        assert_eq!(seen, expected);
    }

    #[test]
    fn open_eyes_come_before_sharpness_and_after_blur() {
        let names = ["a.jpg", "b.jpg", "c.jpg", "d.jpg", "e.jpg"];
        let measures = [
            photo(0, 3.0, 900.0),
            photo(0b1, 2.0, 900.0),
            photo(0b11, 1.0, 900.0),
            photo(0b111, 4.0, 3.0),
            photo(0xFFFF_FFFF, 2.0, 800.0),
        ];
        let seen = |openness: &[f64]| -> Vec<(bool, String)> {
            let openness = openness.iter().map(|open| Some(*open).filter(|open| *open > 0.0)).collect();
            let settings = Settings { openness, ..Settings::default() };
            choose(&names, &measures, &settings).into_iter().map(|v| (v.kept, v.reason.to_string())).collect()
        };
        let same = |name: &str| (false, format!("same as {name}"));
        let other = (true, "only one like it".to_owned());
        // The fourth photo has open eyes, but it is blurred. The last one has no other choice.
        let best = (true, "open eyes, best of 4".to_owned());
        let expected = [same("b.jpg"), best, same("b.jpg"), same("b.jpg"), other.clone()];
        assert_eq!(seen(&[0.2, 0.29, 0.3, 0.32, 0.1]), expected);
        let sharpest = (true, "sharpest of 4".to_owned());
        let expected = [sharpest, same("a.jpg"), same("a.jpg"), same("a.jpg"), other];
        for openness in [&[][..], &[0.19, 0.2, 0.21, 0.2], &[0.26, 0.35, 0.35, 0.35], &[0.0, 0.3, 0.3, 0.3]] {
            assert_eq!(seen(openness), expected, "narrow, smiling or unknown eyes");
        }
    }

    #[test]
    fn an_album_of_little_detail_is_not_blurred() {
        let measures: Vec<_> = (0..3).map(|i| photo(0xFFFF << (16 * i), 1.0, 0.0)).collect();
        assert!(choose(&["", "", ""], &measures, &Settings::default()).iter().all(|verdict| verdict.kept));
        let flat: Vec<_> = (0..4).map(|i| photo(0xFFFF << (16 * i), 1.0, 0.0)).collect();
        assert!(choose(&[""; 4], &flat, &Settings::default()).iter().all(|verdict| verdict.kept));
    }

    #[test]
    fn frames_of_a_film_are_judged_apart_and_some_are_always_kept() {
        let far = |bits: u64, sharp: f32| photo(bits, sharp, 900.0);
        // Four frames of two videos and a photo, five bits apart or less.
        let measures = [far(0, 1.0), far(0b11111, 2.0), far(0b1, 3.0), far(0b111, 4.0), far(0b1111, 5.0)];
        let films = vec![Some(0), Some(0), Some(1), Some(1), None];
        let kept = |films: Vec<Option<usize>>| -> Vec<bool> {
            let settings = Settings { films, ..Settings::default() };
            choose(&[""; 5], &measures, &settings).iter().map(|verdict| verdict.kept).collect()
        };
        assert_eq!(kept(Vec::new()), [false, false, false, false, true], "photos are the same picture");
        assert!(kept(films)[..2].iter().all(|&kept| kept), "five bits are another picture of a film");
        // A video that hardly moves: all frames that differ are selected, up to the number for one page.
        let still: Vec<Measures> = (0..12).map(|i| far(0, 1.0 + (i / 2) as f32)).collect();
        let settings = Settings { films: vec![Some(0); 12], ..Settings::default() };
        let verdicts = choose(&[""; 12], &still, &settings);
        assert_eq!(verdicts.iter().filter(|verdict| verdict.kept).count(), 6, "no two are the same");
    }

    proptest! {
        #[test]
        fn every_group_keeps_one_or_is_blurred_and_something_is_always_kept(
            photos in prop::collection::vec((0u64..64, 0.0f32..9.0, 0.0f32..2000.0), 1..40), duplicate_threshold in 0u32..17,
        ) {
            let measures: Vec<_> = photos.into_iter().map(|(f, g, l)| photo(f, g, l)).collect();
            let names = vec!["x"; measures.len()];
            let verdicts = choose(&names, &measures, &Settings { duplicate_threshold, ..Settings::default() });
            prop_assert_eq!(verdicts.len(), measures.len());
            prop_assert!(verdicts.iter().any(|verdict| verdict.kept));
            for group in 0..=verdicts.iter().map(|verdict| verdict.group).max().unwrap() {
                let members = verdicts.iter().filter(|verdict| verdict.group == group);
                prop_assert!(members.clone().filter(|verdict| verdict.kept).count() <= 1);
                prop_assert!(members.clone().any(|verdict| verdict.kept || verdict.reason == Reason::Blurred));
            }
        }
    }
}
