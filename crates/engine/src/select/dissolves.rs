//! Dissolves: transitions in which one scene of a video fades out while the next one fades in.
//!
//! A dissolve mixes two pictures in a share that rises evenly from 0 to 1. Two pictures that have nothing in
//! common cancel out in part, so their mixture has less contrast than the pictures themselves. A moving
//! camera also changes the picture, but its contrast does not drop. Source: Truong, Dorai, Venkatesh, "New
//! Enhancements to Cut, Fade, and Dissolve Detection Processes in Video Segmentation", ACM Multimedia 2000.

use super::look::{Coarse, Look};

/// Seconds between two frames that are compared; frames between them are skipped.
const STEP: f64 = 0.095;
/// Shortest and longest dissolve, in seconds.
const MIN_LENGTH: f64 = 0.28;
const MAX_LENGTH: f64 = 2.6;
/// Maximum gap between two frames of a dissolve, in seconds.
const MAX_GAP: f64 = 0.5;
/// Frames of a dissolve, without the two clean ones.
const MIN_FRAMES: usize = 2;
/// Minimum root mean square difference between the two scenes, in grey steps.
const MIN_DIFFERENCE: f64 = 14.0;
/// Maximum correlation of the two scenes. A lamp that is switched on changes the light, but not the picture.
const MAX_CORRELATION: f64 = 0.6;
/// Maximum deviation of the share of the second scene from a straight line.
const MAX_BEND: f64 = 0.25;
/// Maximum root mean square difference between a frame and the nearest mixture of the two scenes, as a part of the
/// difference between the scenes.
const MAX_MISFIT: f64 = 0.45;
/// Seconds before and after a dissolve in which the share must stay near 0 and near 1, and the tolerance.
const REST: [f64; 2] = [0.3, 0.6];
const MAX_DRIFT: f64 = 0.3;
/// Minimum loss of contrast, as a part of the loss in a mixture of the two scenes.
const MIN_LOSS: f64 = 0.7;

/// A dissolve, by the numbers of its frames.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dissolve {
    /// The last frame that shows only the first scene.
    pub before: usize,
    /// The first frame that shows more of the second scene than of the first.
    pub middle: usize,
    /// The first frame that shows only the second scene.
    pub after: usize,
}

impl Dissolve {
    /// Whether a frame shows both scenes.
    pub(super) fn mixes(&self, frame: usize) -> bool {
        self.before < frame && frame < self.after
    }
}

/// Returns the dissolves of a video in time order, without overlap.
pub(super) fn find(times: &[f64], looks: &[Look]) -> Vec<Dissolve> {
    let frames = Frames::of(times, looks);
    let mut found: Vec<(f64, [usize; 2])> = Vec::new();
    for first in 0..frames.numbers.len() {
        for last in frames.ends(first) {
            found.extend(frames.fit(first, last).map(|misfit| (misfit, [first, last])));
        }
    }
    crate::order::sort_by(&mut found, |a, b| a.0.total_cmp(&b.0));
    let mut best: Vec<[usize; 2]> = Vec::new();
    for (_, [first, last]) in found {
        if best.iter().all(|&[from, to]| last <= from || to <= first) {
            best.push([first, last]);
        }
    }
    crate::order::sort_by_key(&mut best, |pair| *pair);
    best.into_iter().map(|[first, last]| frames.dissolve(first, last)).collect()
}

/// The frames that are compared.
struct Frames<'f> {
    times: Vec<f64>,
    looks: Vec<&'f Look>,
    coarse: Vec<Coarse>,
    /// Their indices among all frames of the video.
    numbers: Vec<usize>,
}

impl<'f> Frames<'f> {
    fn of(times: &[f64], looks: &'f [Look]) -> Self {
        let mut numbers: Vec<usize> = Vec::new();
        for (i, time) in times.iter().enumerate() {
            if numbers.last().is_none_or(|&last| time - times[last] >= STEP) {
                numbers.push(i);
            }
        }
        let looks: Vec<&Look> = numbers.iter().map(|&i| &looks[i]).collect();
        let coarse = looks.iter().map(|look| look.coarse()).collect();
        Self { times: numbers.iter().map(|&i| times[i]).collect(), looks, coarse, numbers }
    }

    /// The frames at which a dissolve that begins at `first` may end.
    fn ends(&self, first: usize) -> impl Iterator<Item = usize> + '_ {
        let joined = move |&i: &usize| {
            !self.looks[i].flat
                && self.times[i] - self.times[i - 1] <= MAX_GAP
                && self.times[i] - self.times[first] <= MAX_LENGTH
        };
        let long =
            move |&i: &usize| i - first > MIN_FRAMES && self.times[i] - self.times[first] >= MIN_LENGTH;
        let open = if self.looks[first].flat { self.times.len() } else { first + 1 };
        (open..self.times.len()).take_while(joined).filter(long)
    }

    /// How far the frames from `first` to `last` are from an even dissolve; `None` if they are not a dissolve.
    fn fit(&self, first: usize, last: usize) -> Option<f64> {
        if !self.loses_contrast(first, last) {
            return None;
        }
        let scale = self.coarse[first].squared_distance(&self.coarse[last]);
        if scale < MIN_DIFFERENCE * MIN_DIFFERENCE * Coarse::CELLS as f64 {
            return None;
        }
        let share = |i: usize| self.coarse[i].share(&self.coarse[first], &self.coarse[last]) / scale;
        let (mut bend, mut misfit) = (0.0_f64, 0.0);
        for i in first + 1..last {
            let share = share(i);
            bend = bend.max((share - self.part([first, last], i)).abs());
            misfit += self.coarse[i].squared_distance(&self.coarse[first]) / scale - share * share;
        }
        let between = (last - first - 1) as f64;
        if bend > MAX_BEND || misfit > MAX_MISFIT * MAX_MISFIT * between {
            return None;
        }
        let [from, to] = [self.times[first], self.times[last]];
        let rest = ((to - from) / 2.0).clamp(REST[0], REST[1]);
        let before = (0..first).rev().take_while(|&i| i + 1 == first || from - self.times[i] <= rest);
        let after = (last + 1..self.times.len()).take_while(|&i| i == last + 1 || self.times[i] - to <= rest);
        let early = before.map(|i| share(i).abs()).fold(0.0, f64::max);
        let late = after.map(|i| (share(i) - 1.0).abs()).fold(0.0, f64::max);
        (early.max(late) <= MAX_DRIFT).then_some(bend + early + late)
    }

    /// How far a frame is on the way from the first frame to the last one, by time: 0 to 1.
    fn part(&self, [first, last]: [usize; 2], i: usize) -> f64 {
        (self.times[i] - self.times[first]) / (self.times[last] - self.times[first])
    }

    /// Whether the frames in between have as little contrast as mixtures of the first and the last frame.
    fn loses_contrast(&self, first: usize, last: usize) -> bool {
        let contrast = |i: usize| f64::from(self.looks[i].deviation);
        let (a, b) = (contrast(first), contrast(last));
        let (mut lost, mut product) = (0.0, 0.0);
        for i in first + 1..last {
            let part = self.part([first, last], i);
            lost += (1.0 - part) * a * a + part * b * b - contrast(i).powi(2);
            product += part * (1.0 - part);
        }
        // The variance of a mixture is less than the mean of the variances by this.
        let expected = |correlation: f64| product * (a * a + b * b - 2.0 * correlation * a * b);
        // Cheap numbers exclude most frames.
        if lost < MIN_LOSS * expected(MAX_CORRELATION) {
            return false;
        }
        let correlation = self.looks[first].correlation(self.looks[last]);
        correlation <= MAX_CORRELATION && lost >= MIN_LOSS * expected(correlation)
    }

    fn dissolve(&self, first: usize, last: usize) -> Dissolve {
        let half = |&i: &usize| self.part([first, last], i) >= 0.5;
        let middle = (first + 1..last).find(half).unwrap_or(last);
        Dissolve { before: self.numbers[first], middle: self.numbers[middle], after: self.numbers[last] }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shots::tests::{dissolving, look};
    use super::*;

    fn found(looks: impl IntoIterator<Item = Look>, rate: f64) -> Vec<Dissolve> {
        let looks: Vec<Look> = looks.into_iter().collect();
        let times: Vec<f64> = (0..looks.len()).map(|i| i as f64 / rate).collect();
        find(&times, &looks)
    }

    #[test]
    fn a_dissolve_is_found_at_any_rate() {
        // 24 frames per second, sampled 24, 12, 6 and 4 times per second.
        for every in [1, 2, 4, 6] {
            let looks = dissolving(24, 0).step_by(every);
            let all = found(looks, 24.0 / every as f64);
            let [dissolve] = all.as_slice() else { panic!("every {every}: {all:?}") };
            let at = |frame: usize| frame * every;
            assert!((18..=28).contains(&at(dissolve.before)), "every {every}: {dissolve:?}");
            assert!((30..=42).contains(&at(dissolve.middle)), "every {every}: {dissolve:?}");
            assert!((44..=54).contains(&at(dissolve.after)), "every {every}: {dissolve:?}");
        }
        // Key frames of a long video do not show the frames between them.
        assert!(found(dissolving(24, 0).step_by(12), 1.0).is_empty());
    }

    #[test]
    fn other_changes_are_not_dissolves() {
        let none = |name: &str, looks: Vec<Look>| assert_eq!(found(looks, 12.0), [], "{name}");
        let ramp = |i: usize| ((i as f32 - 24.0) / 12.0).clamp(0.0, 1.0);
        none("a still picture", (0..60).map(|_| look(1, 0, 1.0)).collect());
        none("a moving camera", (0..60).map(|i| look(1, i, 1.0)).collect());
        none(
            "a camera that moves and rests",
            (0..60).map(|i| look(1, (80.0 * ramp(i)) as usize, 1.0)).collect(),
        );
        none("a lamp", (0..60).map(|i| look(1, 0, 0.3 + 0.7 * ramp(i))).collect());
        none("a cut", (0..60).map(|i| look(1 + u64::from(i >= 30), 0, 1.0)).collect());
        none("a flash", (0..60).map(|i| look(1 + u64::from((30..33).contains(&i)), 0, 1.0)).collect());
        none("black", (0..60).map(|_| look(0, 0, 1.0)).collect());
        let through_black =
            |i: usize| look(1 + u64::from(i >= 30), 0, ((i as f32 - 30.0).abs() / 12.0).min(1.0));
        none("a fade through black", (0..60).map(through_black).collect());
        none("nothing", Vec::new());
    }
}
