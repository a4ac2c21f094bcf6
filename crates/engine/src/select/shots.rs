//! Shot detection: cuts, fades and blank frames of a video.
//!
//! Frames at short distances are judged like in `PySceneDetect`'s `AdaptiveDetector`: at a cut, two frames
//! differ far more than their neighbours. So a moving camera is not a cut. Frames at long distances, such as
//! key frames of a long video, have no close neighbours. For them a cut is a change of both the image and its
//! tones.
//!
//! A dissolve separates two shots in its middle (`dissolves`). Frames that show both scenes represent neither of them.

use super::dissolves::{self, Dissolve};
use super::look::Look;

/// Seconds between two frames that count as close.
const CLOSE: f64 = 0.5;
/// How many pairs on either side a close pair is compared with.
const WINDOW: usize = 2;
/// Minimum difference at a cut, relative to neighbouring pairs,
const RATIO: f32 = 3.0;
/// and in total. Both apply to close pairs.
const LEAST: f32 = 10.0;
/// Minimum difference at a cut of a pair that is not close,
const FAR: f32 = 22.0;
/// or this much, if the tones differ too.
const FARTHER: f32 = 14.0;
const OTHER_TONES: f32 = 0.3;
/// Minimum duration of a shot in seconds. Shorter ones are flashes.
const SHORTEST: f64 = 0.5;
/// Maximum difference of the frames before and after a flash, relative to the flash.
const BACK: f32 = 0.4;
/// Part of the deviation of the strongest frame of its shot nearby below which a frame is fading,
const FADED: f32 = 0.5;
/// and how far such a frame may be away, in seconds: half of the longest fade.
const FADE: f64 = 3.0;

/// The samples of a video.
#[derive(Debug, Default)]
pub struct Film {
    times: Vec<f64>,
    looks: Vec<Look>,
}

/// A shot.
#[derive(Debug, Clone, PartialEq)]
pub struct Shot {
    /// Seconds at which it begins.
    pub start: f64,
    /// Seconds at which it ends.
    pub end: f64,
    /// Indices of the sampled frames that may represent the shot. Black and fading frames are excluded.
    pub usable: Vec<usize>,
    /// Whether the shot is a title: text on an even background.
    pub title: bool,
}

impl Film {
    /// A video without samples.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the frame at `time` in seconds, in any order. Ignores a frame that exists or has no finite time.
    pub fn add(&mut self, time: f64, look: Look) {
        let at = self.times.partition_point(|&other| other < time);
        if time.is_finite() && self.times.get(at) != Some(&time) {
            self.times.insert(at, time);
            self.looks.insert(at, look);
        }
    }

    /// Times in seconds of the analysed frames, ascending.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The samples of the frames.
    #[must_use]
    pub fn looks(&self) -> &[Look] {
        &self.looks
    }

    /// Returns the difference of the frames on both sides of a moment; 0 at the ends.
    #[must_use]
    pub fn change(&self, time: f64) -> f32 {
        let at = self.times.partition_point(|&other| other <= time);
        match (at.checked_sub(1).and_then(|before| self.looks.get(before)), self.looks.get(at)) {
            (Some(before), Some(after)) => before.distance(after),
            _ => 0.0,
        }
    }

    /// The shots, in the order of time, the last of them ending at `end`.
    #[must_use]
    pub fn shots(&self, end: f64) -> Vec<Shot> {
        let count = self.times.len();
        let dissolves = dissolves::find(&self.times, &self.looks);
        let mut shots = Vec::new();
        let mut first = 0;
        for cut in self.cuts(&dissolves).into_iter().chain([count]) {
            if cut > first {
                let until = self.times.get(cut).copied().unwrap_or_else(|| end.max(self.times[count - 1]));
                shots.push(self.shot(first..cut, until, &dissolves));
            }
            first = cut;
        }
        shots
    }

    fn shot(&self, range: std::ops::Range<usize>, end: f64, dissolves: &[Dissolve]) -> Shot {
        let start = self.times[range.start];
        let shown: Vec<usize> =
            range.clone().filter(|&i| !self.looks[i].flat && !self.is_fading(i, &range)).collect();
        let clean = |i: &usize| !dissolves.iter().any(|dissolve| dissolve.mixes(*i));
        let seen: Vec<usize> = shown.iter().copied().filter(clean).collect();
        // A shot that contains only mixtures still has a frame.
        let seen = if seen.is_empty() { shown } else { seen };
        let titles = seen.iter().filter(|&&i| self.looks[i].title).count();
        Shot { start, end, title: 2 * titles > seen.len(), usable: seen }
    }

    /// Returns whether a frame is much weaker than another one of the same shot shortly before or after it.
    fn is_fading(&self, i: usize, shot: &std::ops::Range<usize>) -> bool {
        let near = |&j: &usize| (self.times[j] - self.times[i]).abs() <= FADE;
        let before = (shot.start..i).rev().take_while(near);
        let after = (i + 1..shot.end).take_while(near);
        before.chain(after).any(|j| self.looks[i].deviation < FADED * self.looks[j].deviation)
    }

    /// Returns the indices of the first frames of all shots except the first.
    fn cuts(&self, dissolves: &[Dissolve]) -> Vec<usize> {
        let mut cuts = self.hard_cuts();
        // A dissolve contains only its own cut, in the middle.
        cuts.retain(|&cut| !dissolves.iter().any(|dissolve| dissolve.before < cut && cut <= dissolve.after));
        cuts.extend(dissolves.iter().map(|dissolve| dissolve.middle));
        crate::order::sort_by_key(&mut cuts, |cut| *cut);
        cuts
    }

    /// The numbers of the first frames of all shots that begin with a cut or in the dark.
    fn hard_cuts(&self) -> Vec<usize> {
        let count = self.times.len();
        // Between each frame and the one before.
        let apart: Vec<f32> = (0..count)
            .map(|i| if i == 0 { 0.0 } else { self.looks[i - 1].distance(&self.looks[i]) })
            .collect();
        let mut cuts: Vec<usize> = Vec::new();
        let mut i = 1;
        while i < count {
            let lit = self.looks[i - 1].flat && !self.looks[i].flat;
            let last = cuts.last().map_or(self.times[0], |&cut| self.times[cut]);
            if lit {
                // The dark part before is a separate, blank shot.
                cuts.push(i);
            } else if self.is_cut(&apart, i) {
                if let Some(after) = self.flash(apart[i], i) {
                    i = after;
                } else if self.gap(i) > CLOSE || self.times[i] - last >= SHORTEST || cuts.is_empty() {
                    cuts.push(i);
                }
            }
            i += 1;
        }
        cuts
    }

    /// Seconds between a frame and the one before.
    fn gap(&self, i: usize) -> f64 {
        self.times[i] - self.times[i - 1]
    }

    fn is_cut(&self, apart: &[f32], i: usize) -> bool {
        let distance = apart[i];
        let around: Vec<f32> = (i.saturating_sub(WINDOW)..=i + WINDOW)
            .filter(|&j| j != i && j >= 1 && j < apart.len() && self.gap(j) <= CLOSE)
            .map(|j| apart[j])
            .collect();
        if self.gap(i) > CLOSE || around.is_empty() {
            let tones = self.looks[i - 1].tones(&self.looks[i]);
            return distance >= FAR || distance >= FARTHER && tones >= OTHER_TONES;
        }
        let mean = around.iter().sum::<f32>() / around.len() as f32;
        distance >= LEAST && distance >= RATIO * mean
    }

    /// The first frame after a flash that began at `i`, with the image of before.
    fn flash(&self, distance: f32, i: usize) -> Option<usize> {
        let before = &self.looks[i - 1];
        let soon = |&j: &usize| self.times[j] - self.times[i] < SHORTEST;
        (i + 1..self.times.len())
            .take_while(soon)
            .find(|&j| before.distance(&self.looks[j]) < BACK * distance)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::select::look::Samples;

    /// A made-up picture, `moved` pixels on and so bright; `seed` 0 is black.
    pub(in crate::select) fn look(seed: u64, moved: usize, light: f32) -> Look {
        look_at(&picture(seed, moved, light))
    }

    pub(in crate::select) fn picture(seed: u64, moved: usize, light: f32) -> Vec<u8> {
        let mut random = oorandom::Rand32::new(seed);
        let blobs: Vec<[f32; 3]> = (0..9).map(|_| std::array::from_fn(|_| random.rand_float())).collect();
        let mut pixels = Vec::with_capacity(128 * 72);
        for y in 0..72 {
            for x in 0..128 {
                let (x, y) = ((x + moved) as f32 / 128.0, y as f32 / 72.0);
                let light_of =
                    |b: &[f32; 3]| b[2] * (-((x - b[0]).powi(2) + (y - b[1]).powi(2)) / 0.02).exp();
                let sum: f32 = blobs.iter().map(light_of).sum();
                pixels.push(if seed == 0 { 16 } else { ((30.0 + 200.0 * sum) * light).min(250.0) as u8 });
            }
        }
        pixels
    }

    pub(in crate::select) fn look_at(pixels: &[u8]) -> Look {
        let chroma = vec![128; 64 * 36];
        let luma = Samples::new(pixels, [128, 1], [128, 72]).unwrap();
        let grey = Samples::new(&chroma, [64, 1], [64, 36]).unwrap();
        Look::of(&luma, [&grey, &grey])
    }

    pub(in crate::select) fn film(looks: impl IntoIterator<Item = Look>, rate: f64) -> Film {
        let mut film = Film::new();
        for (i, look) in looks.into_iter().enumerate() {
            film.add(i as f64 / rate, look);
        }
        film
    }

    fn starts(film: &Film) -> Vec<f64> {
        film.shots(99.0).iter().map(|shot| shot.start).collect()
    }

    #[test]
    fn a_cut_is_told_from_a_moving_camera() {
        let shot = |seed: u64, speed: usize| (0..24).map(move |i| look(seed, i * speed, 1.0));
        let cut = film(shot(1, 1).chain(shot(2, 3)).chain(shot(3, 0)), 12.0);
        assert_eq!(starts(&cut), [0.0, 2.0, 4.0]);
        assert_eq!(starts(&film(shot(1, 4), 12.0)), [0.0], "a pan is one shot");
    }

    #[test]
    fn a_flash_is_no_cut_and_the_dark_parts_shots() {
        let flash = (0..24).map(|i| look(if i == 12 { 7 } else { 1 }, i, 1.0));
        assert_eq!(starts(&film(flash, 12.0)), [0.0]);
        // Out into the dark and in again, slowly.
        let light = |i: usize| ((i as f32 - 18.0).abs() / 18.0 * 1.2 - 0.2).clamp(0.0, 1.0);
        let faded = film((0..36).map(|i| look(1, i / 3, light(i))), 12.0);
        let shots = faded.shots(3.0);
        assert_eq!(shots.len(), 2, "{:?}", starts(&faded));
        for shot in &shots {
            assert!(shot.usable.iter().all(|&i| light(i) > 0.4), "no frame that fades: {:?}", shot.usable);
        }
    }

    #[test]
    fn scenes_that_dissolve_are_shots_and_no_frame_shows_both() {
        for (length, speed) in [(6, 0), (6, 1), (12, 0), (12, 1), (24, 0), (24, 1)] {
            let film = film(dissolving(length, speed), 12.0);
            let shots = film.shots(6.0);
            assert_eq!(shots.len(), 2, "{length} frames: {:?}", starts(&film));
            let middle = (24 + length / 2) as f64 / 12.0;
            assert!((shots[1].start - middle).abs() < 0.2 * length as f64 / 12.0, "{:?}", starts(&film));
            let half = length / 4..length - length / 4;
            for shot in &shots {
                assert!(shot.usable.len() >= 12, "{length} frames: {:?}", shot.usable);
                assert!(
                    !shot.usable.iter().any(|&i| i >= 24 && half.contains(&(i - 24))),
                    "{:?}",
                    shot.usable
                );
            }
        }
    }

    /// Two seconds of a weak scene, a dissolve of N frames, and two seconds of a strong scene.
    pub(in crate::select) fn dissolving(length: usize, speed: usize) -> impl Iterator<Item = Look> {
        (0..48 + length).map(move |i| {
            let share = (i as f32 - 23.0) / (length as f32 + 1.0);
            let [weak, strong] = [picture(1, i * speed, 0.4), picture(2, i * speed, 1.0)];
            look_at(&mixed(&weak, &strong, share.clamp(0.0, 1.0)))
        })
    }

    fn mixed(first: &[u8], second: &[u8], share: f32) -> Vec<u8> {
        let mix = |(&a, &b): (&u8, &u8)| (f32::from(a) * (1.0 - share) + f32::from(b) * share).round() as u8;
        first.iter().zip(second).map(mix).collect()
    }

    #[test]
    fn a_scene_between_two_dissolves_has_a_frame_even_if_it_is_never_seen_alone() {
        let looks = (0..96).map(|i: usize| {
            let [first, second, third] = [1, 2, 4].map(|seed| picture(seed, 0, 1.0));
            let share = |from: f32| ((i as f32 - from) / 18.0).clamp(0.0, 1.0);
            look_at(&mixed(&mixed(&first, &second, share(24.0)), &third, share(42.0)))
        });
        let film = film(looks, 12.0);
        let shots = film.shots(8.0);
        assert_eq!(shots.len(), 3, "{:?}", starts(&film));
        assert!(shots.iter().all(|shot| !shot.usable.is_empty()));
        // The frame with the least blend.
        let near = |&i: &usize| (40..45).contains(&i);
        assert!(shots[1].usable.iter().any(near), "{:?}", shots[1].usable);
    }

    #[test]
    fn a_weak_scene_is_usable_where_no_strong_one_is_near() {
        // The light fades in over two seconds.
        let light = |i: usize| 0.3 + 0.7 * ((i as f32 - 72.0) / 24.0).clamp(0.0, 1.0);
        let film = film((0..168).map(|i| look(1, 0, light(i))), 12.0);
        let shots = film.shots(14.0);
        assert_eq!(shots.len(), 1, "{:?}", starts(&film));
        let usable = &shots[0].usable;
        assert!(usable.contains(&0) && usable.contains(&160) && !usable.contains(&75), "{usable:?}");
    }

    #[test]
    fn frames_far_apart_are_judged_by_what_they_show() {
        let keys = film([1, 1, 2, 2, 2, 3].map(|seed| look(seed, 0, 1.0)), 0.2);
        assert_eq!(starts(&keys), [0.0, 10.0, 25.0]);
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert!(Film::new().shots(5.0).is_empty());
        let mut film = Film::new();
        film.add(f64::NAN, look(1, 0, 1.0));
        film.add(1.0, look(1, 0, 1.0));
        film.add(1.0, look(2, 0, 1.0));
        assert_eq!(film.times(), [1.0], "a frame is looked at once");
        assert_eq!(film.shots(0.0).len(), 1);
        let black = super::tests::film((0..9).map(|_| look(0, 0, 1.0)), 3.0);
        assert!(black.shots(3.0).iter().all(|shot| shot.usable.is_empty()));
    }
}
