//! Selection of representative frames: the sharpest of every shot, and more for shots that are long or
//! change. Black frames, fades and titles are used only if there are no others.

use super::look::Look;
use super::shots::{Film, Shot};
use crate::order::sort_by;

/// Minimum number of frames by default. The number follows the number of shots.
pub const FEWEST: usize = 8;
/// See [`FEWEST`].
pub const MOST: usize = 120;
/// Maximum number of automatic frames per shot.
const MOST_OF_SHOT: usize = 6;
/// Seconds of a shot that each further frame of it takes.
const SECONDS: f64 = 2.0;
/// Minimum difference in grey levels of a frame with other content in the same shot.
const ANOTHER: f32 = 10.0;
/// Maximum number of frames per shot for measuring changes.
const ASKED: usize = 60;
/// Below this part of the sharpness of its shot a frame counts as blurred.
const SHARP: f32 = 0.7;
/// Seconds at both ends of a shot that are skipped, because frames there often mix two shots.
const EDGE: f64 = 0.1;
/// Seconds of a shot that must not be left out.
const LONG: f64 = 1.0;

/// Requirements for the frames of a video.
#[derive(Debug, Clone, Copy, Default)]
pub struct Wish<'a> {
    /// Number of frames. `None`: automatic.
    pub count: Option<usize>,
    /// Times in seconds of frames that are already selected. They represent their shots.
    pub taken: &'a [f64],
    /// Times in seconds that should have a frame close to them, such as subtitles.
    pub moments: &'a [f64],
}

/// A frame to extract.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Still {
    /// Seconds.
    pub time: f64,
    /// The number of its shot.
    pub shot: usize,
}

/// Default number of frames of a video with these shots: [`FEWEST`] to [`MOST`].
#[must_use]
pub fn usual(film: &Film, shots: &[Shot]) -> usize {
    shots.iter().map(|shot| asked(film, shot)).sum::<usize>().clamp(FEWEST, MOST)
}

/// Returns the frames for a wish in order of time, including the frames that are already selected. Returns
/// fewer if the video does not have enough usable frames.
#[must_use]
pub fn choose(film: &Film, shots: &[Shot], wish: &Wish) -> Vec<Still> {
    let mut open: Vec<usize> = (0..shots.len()).filter(|&i| !shots[i].usable.is_empty()).collect();
    let pictures = open.iter().filter(|&&i| !shots[i].title).count();
    let count = wish.count.unwrap_or_else(|| usual(film, shots)).max(1);
    // Some videos contain only titles.
    if pictures > 0 {
        open.retain(|&i| !shots[i].title);
    }
    let quotas = quotas(film, shots, &open, count);
    let mut stills: Vec<Still> = Vec::new();
    for (&shot, &quota) in open.iter().zip(&quotas) {
        stills.extend(of_shot(film, &shots[shot], quota, wish).into_iter().map(|time| Still { time, shot }));
    }
    sort_by(&mut stills, |a, b| a.time.total_cmp(&b.time));
    stills
}

/// Number of frames of a shot: one for each distinct image, limited by its duration.
fn asked(film: &Film, shot: &Shot) -> usize {
    if shot.usable.is_empty() || shot.title {
        return 0;
    }
    let every = shot.usable.len().div_ceil(ASKED).max(1);
    let mut leaders: Vec<&Look> = Vec::new();
    for &i in shot.usable.iter().step_by(every) {
        let look = &film.looks()[i];
        if leaders.len() < MOST_OF_SHOT && leaders.iter().all(|leader| leader.distance(look) >= ANOTHER) {
            leaders.push(look);
        }
    }
    leaders.len().min(1 + ((shot.end - shot.start) / SECONDS) as usize)
}

/// Number of frames of each open shot. Each gets one if there are enough, long shots first. The rest is
/// distributed by length and demand, like seats among parties (D'Hondt).
fn quotas(film: &Film, shots: &[Shot], open: &[usize], count: usize) -> Vec<usize> {
    let length = |k: usize| (shots[open[k]].end - shots[open[k]].start).max(0.04);
    let room = |k: usize| shots[open[k]].usable.len();
    let mut quotas = vec![0; open.len()];
    let mut left = count.min((0..open.len()).map(room).sum());
    for k in first_come(film, shots, open, &length) {
        if left == 0 {
            return quotas;
        }
        quotas[k] = 1;
        left -= 1;
    }
    let weights: Vec<f64> =
        (0..open.len()).map(|k| asked(film, &shots[open[k]]) as f64 + length(k).min(60.0) / 8.0).collect();
    while left > 0 {
        let next = (0..open.len()).filter(|&k| quotas[k] < room(k)).max_by(|&a, &b| {
            let share = |k: usize| weights[k] / (quotas[k] + 1) as f64;
            share(a).total_cmp(&share(b)).then(b.cmp(&a))
        });
        let Some(next) = next else { break };
        quotas[next] += 1;
        left -= 1;
    }
    quotas
}

/// Returns the order in which shots get their first frame: long shots with new content, other long shots,
/// short shots.
fn first_come(film: &Film, shots: &[Shot], open: &[usize], length: &dyn Fn(usize) -> f64) -> Vec<usize> {
    let mut seen: Vec<&Look> = Vec::new();
    let mut order: Vec<(u8, usize)> = Vec::with_capacity(open.len());
    for (k, &shot) in open.iter().enumerate() {
        let usable = &shots[shot].usable;
        let middle = &film.looks()[usable[usable.len() / 2]];
        let fresh = seen.iter().all(|other| other.distance(middle) >= ANOTHER);
        if fresh {
            seen.push(middle);
        }
        order.push((if length(k) < LONG { 2 } else { u8::from(!fresh) }, k));
    }
    sort_by(&mut order, |a, b| a.0.cmp(&b.0).then(length(b.1).total_cmp(&length(a.1))));
    order.into_iter().map(|(_, k)| k).collect()
}

/// Returns the times of `quota` frames of a shot. It is divided into as many parts, and each gives a sharp
/// frame that differs from the others. If a part is completely blurred, another part replaces it.
fn of_shot(film: &Film, shot: &Shot, quota: usize, wish: &Wish) -> Vec<f64> {
    let (times, looks) = (film.times(), film.looks());
    let inside = |i: &&usize| times[**i] >= shot.start + EDGE && times[**i] <= shot.end - EDGE;
    let inner: Vec<usize> = shot.usable.iter().filter(inside).copied().collect();
    let usable = if inner.len() >= quota.max(1) { &inner } else { &shot.usable };
    let mut sharpnesses: Vec<f32> = usable.iter().map(|&i| looks[i].sharpness).collect();
    sort_by(&mut sharpnesses, f32::total_cmp);
    // Not the very sharpest: a single frame of noise would make all others blurred.
    let sharp = SHARP * sharpnesses.get(sharpnesses.len() * 9 / 10).copied().unwrap_or(0.0);
    let within = |time: f64| time >= shot.start && time < shot.end;
    let mut chosen: Vec<usize> = shot
        .usable
        .iter()
        .copied()
        .filter(|&i| wish.taken.iter().any(|&time| (time - times[i]).abs() < 1e-3))
        .collect();
    let worth = |i: usize, chosen: &[usize]| {
        let novelty =
            chosen.iter().map(|&other| looks[other].distance(&looks[i])).fold(2.0 * ANOTHER, f32::min);
        let spoken = wish.moments.iter().any(|&time| within(time) && (time - times[i]).abs() < 0.3);
        (looks[i].sharpness / sharp.max(0.01)).min(1.2)
            + 0.5 * novelty / (2.0 * ANOTHER)
            + if spoken { 0.5 } else { 0.0 }
    };
    for part in parts(usable, times, quota) {
        if chosen.len() >= quota || part.iter().any(|i| chosen.contains(i)) {
            continue;
        }
        let good = part.iter().copied().filter(|&i| looks[i].sharpness >= sharp);
        let best = good.max_by(|&a, &b| worth(a, &chosen).total_cmp(&worth(b, &chosen)));
        chosen.extend(best);
    }
    while chosen.len() < quota {
        let rank = |i: usize| (looks[i].sharpness >= sharp, worth(i, &chosen));
        let rest = shot.usable.iter().copied().filter(|i| !chosen.contains(i));
        let best = rest.max_by(|&a, &b| {
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        match best {
            // If the shot has sharp frames, blurred ones are not used.
            Some(best) if looks[best].sharpness >= sharp || chosen.is_empty() => chosen.push(best),
            _ => break,
        }
    }
    chosen.into_iter().map(|i| times[i]).collect()
}

/// Splits frames by equal times, or by equal numbers if a time span would be empty.
fn parts<'a>(usable: &'a [usize], times: &[f64], quota: usize) -> Vec<&'a [usize]> {
    let (Some(&first), Some(&last)) = (usable.first(), usable.last()) else { return Vec::new() };
    let (from, span) = (times[first], times[last] - times[first]);
    let by_time: Vec<&[usize]> = (0..quota)
        .map(|k| {
            let edge = |k: usize| {
                let until = from + span * k as f64 / quota as f64;
                if k == quota { usable.len() } else { usable.partition_point(|&i| times[i] < until) }
            };
            &usable[edge(k)..edge(k + 1)]
        })
        .collect();
    if by_time.iter().all(|part| !part.is_empty()) {
        return by_time;
    }
    let edge = |k: usize| k * usable.len() / quota;
    (0..quota).map(|k| &usable[edge(k)..edge(k + 1)]).collect()
}

#[cfg(test)]
mod tests {
    use super::super::shots::tests::{dissolving, film, look};
    use super::*;

    /// The image without fine detail.
    fn blurred(look: Look) -> Look {
        let mut look = look;
        look.sharpness /= 3.0;
        look
    }

    fn chosen(film: &Film, end: f64, wish: &Wish) -> Vec<Still> {
        choose(film, &film.shots(end), wish)
    }

    #[test]
    fn every_shot_is_there_and_the_dark_is_not() {
        let shots = [(1, 30), (2, 18), (0, 12), (3, 20), (4, 40)];
        let looks = shots.iter().flat_map(|&(seed, count)| (0..count).map(move |i| look(seed, i / 6, 1.0)));
        let film = film(looks, 12.0);
        let stills = chosen(&film, 10.0, &Wish::default());
        assert!((FEWEST..=MOST).contains(&stills.len()), "{stills:?}");
        assert!(stills.is_sorted_by(|a, b| a.time < b.time));
        for (from, to) in [(0.0, 2.5), (2.5, 4.0), (5.0, 6.66), (6.67, 10.0)] {
            assert!(
                stills.iter().any(|still| (from..to).contains(&still.time)),
                "{from} to {to}: {stills:?}"
            );
        }
        assert!(!stills.iter().any(|still| (4.0..5.0).contains(&still.time)));
        let three = chosen(&film, 10.0, &Wish { count: Some(3), ..Wish::default() });
        assert_eq!(three.len(), 3);
    }

    #[test]
    fn a_blurred_frame_is_none_where_the_shot_has_a_sharp_one() {
        let looks = (0..60).map(|i| {
            let look = look(1, i, 1.0);
            if i % 20 < 15 { blurred(look) } else { look }
        });
        let film = film(looks, 12.0);
        for count in [1, 4, 8, 15] {
            let stills = chosen(&film, 5.0, &Wish { count: Some(count), ..Wish::default() });
            assert_eq!(stills.len(), count);
            assert!(stills.iter().all(|still| (still.time * 12.0).round() as usize % 20 >= 15), "{stills:?}");
        }
    }

    #[test]
    fn one_shot_is_spread_over_its_time() {
        let film = film((0..240).map(|i| look(5, i / 4, 1.0)), 12.0);
        let stills = chosen(&film, 20.0, &Wish::default());
        assert!(stills.len() >= FEWEST);
        let gaps = stills.windows(2).map(|pair| pair[1].time - pair[0].time);
        assert!(gaps.fold(0.0, f64::max) < 6.0, "{stills:?}");
    }

    #[test]
    fn what_is_taken_stands_for_its_shot() {
        let looks = (0..96).map(|i| look(1 + i / 24, i as usize % 24 / 6, 1.0));
        let film = film(looks, 12.0);
        let taken = [1.0, 5.0];
        let stills = chosen(&film, 8.0, &Wish { count: Some(8), taken: &taken, ..Wish::default() });
        assert_eq!(stills.len(), 8);
        assert!(taken.iter().all(|&time| stills.iter().any(|still| (still.time - time).abs() < 1e-9)));
        let few = chosen(&film, 8.0, &Wish { count: Some(100_000), ..Wish::default() });
        assert!(few.len() <= 96);
    }

    #[test]
    fn both_scenes_of_a_dissolve_are_there() {
        let film = film(dissolving(12, 0), 12.0);
        for count in [None, Some(2), Some(3)] {
            let stills = chosen(&film, 5.0, &Wish { count, ..Wish::default() });
            let of = |from: f64, to: f64| stills.iter().any(|still| (from..to).contains(&still.time));
            assert!(of(0.0, 2.2) && of(2.8, 5.0) && !of(2.25, 2.75), "{stills:?}");
        }
    }

    #[test]
    fn moments_draw_frames_near() {
        let film = film((0..120).map(|i| look(1, i / 60, 1.0)), 12.0);
        let wish = Wish { count: Some(2), moments: &[1.5, 8.5], ..Wish::default() };
        let near =
            |time: f64| chosen(&film, 10.0, &wish).iter().any(|still| (still.time - time).abs() <= 0.35);
        assert!(near(1.5) && near(8.5), "{:?}", chosen(&film, 10.0, &wish));
    }
}
