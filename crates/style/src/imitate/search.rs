//! The search for styles that look like a picture. It requests trials and receives their results. The caller
//! decides where to draw them, how many to draw at once, and when to stop:
//!
//! ```text
//! survey   every designed style as it is
//! dress    the twelve nearest in the colours of the picture, each in a few ways (dressing.rs)
//! evolve   rounds of children of the best: values moved at random, or towards what is missing; layers crossed
//! tune     the pitch of screens, seen close
//! ```
//!
//! All chance comes from the seed. Trials are reported in the order of the requests, so the same picture,
//! photo and seed give the same styles.
//!
//! Source: Rechenberg, "Evolutionsstrategie", 1973 (steps that shrink, and the best of parents and children kept).

use super::Trial;
use super::apart::{Apart, apart, screens};
use super::dressing::{ALL, Wanted, dressed, layers, scaled};
use super::features::{AREA, Features};
use crate::Style;
use crate::catalogue::catalogue;
use crate::order::sort_by;
use crate::params::{Kind, Param};
use oorandom::Rand64;
use std::collections::HashSet;

/// Effort of a search.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Designed styles that are dressed.
    pub nearest: usize,
    /// Rounds of children,
    pub rounds: usize,
    /// and children a round.
    pub children: usize,
    /// Styles whose screens are tuned.
    pub tuned: usize,
}

impl Effort {
    /// The effort for interactive use: 300 to 350 trials.
    pub const FULL: Self = Self { nearest: 12, rounds: 5, children: 24, tuned: 8 };
    /// The effort for tests.
    pub const BRIEF: Self = Self { nearest: 6, rounds: 3, children: 12, tuned: 4 };
}

/// Styles that have children.
const PARENTS: usize = 12;

/// How often screens are tuned.
const TUNINGS: usize = 2;

/// Proposals, at least and at most.
const PROPOSALS: (usize, usize) = (3, 6);

/// Minimum number of pixels of a trial: lines cannot be measured in a smaller picture.
const SMALLEST: usize = 40_000;

/// Maximum mean difference of two signatures at which two pictures look identical.
const ALIKE: f32 = 7.0;

/// A style to be tried.
#[derive(Debug, Clone)]
pub struct Ask {
    /// The style.
    pub style: Style,
    /// Pixels at which the photo is drawn, as many as the picture was measured at.
    pub area: usize,
    /// Whether the trial uses a close-up of the photo, to measure its screen.
    pub close: bool,
}

/// Returns the first trials of each search whose picture was reduced for measuring: every built-in style,
/// unchanged. They do not depend on the picture, so they can run before the user chooses one.
#[must_use]
pub fn survey() -> Vec<Ask> {
    catalogue().iter().map(|style| Ask { style: style.clone(), area: AREA, close: false }).collect()
}

/// Number of pixels of a trial for a picture that was measured at the given number of pixels.
fn trial_area(measured: usize) -> usize {
    // Whole sides of a reduced picture make some pixels more or less.
    if measured > AREA / 64 * 63 { AREA } else { measured.max(SMALLEST) }
}

/// The phase of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    Survey,
    Dress,
    Evolve(usize),
    Tune(usize),
    Done,
}

#[derive(Clone)]
struct Candidate {
    style: Style,
    /// Index of the built-in style, and the variant.
    origin: (usize, usize),
    apart: Apart,
    found: Features,
    signature: Vec<u8>,
}

/// A search under way.
pub struct Search {
    wanted: Wanted,
    random: Rand64,
    seed: u32,
    effort: Effort,
    stage: Stage,
    asked: Vec<(Ask, (usize, usize))>,
    known: Vec<Candidate>,
    tried: HashSet<String>,
    done: usize,
}

impl Search {
    /// A search for styles that look like a picture with these features.
    #[must_use]
    pub fn new(features: Features, seed: u32) -> Self {
        let random =
            Rand64::new(u128::from(seed).wrapping_mul(0x9e37_79b9_7f4a_7c15_f39c_c060_5ced_c835) | 1);
        Self {
            wanted: Wanted::new(features),
            random,
            seed,
            effort: Effort::FULL,
            stage: Stage::Survey,
            asked: Vec::new(),
            known: Vec::new(),
            tried: HashSet::new(),
            done: 0,
        }
    }

    /// Returns this search with another effort.
    #[must_use]
    pub fn with(self, effort: Effort) -> Self {
        Self { effort, ..self }
    }

    /// Progress, 0 to 1, with the given number of trials of the last request completed.
    #[must_use]
    pub fn progress(&self, tried: usize) -> f64 {
        // As many as there are of most pictures.
        let Effort { nearest, rounds, children, tuned } = self.effort;
        let total = catalogue().len() + 5 * nearest + rounds * children + tuned * TUNINGS;
        if self.stage == Stage::Done { 1.0 } else { ((self.done + tried) as f64 / total as f64).min(0.99) }
    }

    /// The next styles to try, all at once; empty at the end. Report each batch before the next request.
    pub fn ask(&mut self) -> Vec<Ask> {
        self.asked.clear();
        while self.asked.is_empty() && self.stage != Stage::Done {
            match self.stage {
                Stage::Survey => self.survey(),
                Stage::Dress => self.dress(),
                Stage::Evolve(round) => self.evolve(round),
                Stage::Tune(_) => self.tune(),
                Stage::Done => {}
            }
            if self.asked.is_empty() {
                self.advance();
            }
        }
        self.asked.iter().map(|(ask, _)| ask.clone()).collect()
    }

    /// Receives the results of the requested styles, in their order; `None` for a style that was not drawn.
    pub fn tell(&mut self, trials: Vec<Option<Trial>>) {
        self.done += self.asked.len();
        for ((ask, origin), trial) in std::mem::take(&mut self.asked).into_iter().zip(trials) {
            let Some(Trial { features, signature }) = trial else { continue };
            if ask.close {
                self.tuned(&ask.style, &features);
                continue;
            }
            let apart = apart(&self.wanted.features, &features);
            self.known.push(Candidate { style: ask.style, origin, apart, found: features, signature });
        }
        sort_by(&mut self.known, |a, b| a.apart.total().total_cmp(&b.apart.total()));
        self.advance();
    }

    /// Three to six styles that differ, the best first, each with a score from 0 to 1.
    #[must_use]
    pub fn proposals(&self) -> Vec<Style> {
        let mut chosen: Vec<&Candidate> = Vec::new();
        let Some(best) = self.known.first().map(|best| best.apart.total()) else { return Vec::new() };
        // First one proposal per kind, then more per kind, then any others.
        for (kinds, alike, most) in [(1, ALIKE, PROPOSALS.1), (2, ALIKE, PROPOSALS.0), (9, 0.5, PROPOSALS.0)]
        {
            for candidate in &self.known {
                let far = candidate.apart.total() > (1.7 * best).max(best + 2.5);
                let like =
                    chosen.iter().any(|other| difference(&other.signature, &candidate.signature) <= alike);
                let same = chosen.iter().filter(|other| other.origin == candidate.origin).count();
                if chosen.len() < most && !like && same < kinds && (!far || chosen.len() < PROPOSALS.0) {
                    chosen.push(candidate);
                }
            }
        }
        sort_by(&mut chosen, |a, b| a.apart.total().total_cmp(&b.apart.total()));
        chosen.iter().enumerate().map(|(i, candidate)| self.proposal(i, candidate)).collect()
    }

    fn proposal(&self, place: usize, candidate: &Candidate) -> Style {
        let origin = &catalogue()[candidate.origin.0];
        let score = f64::from((-candidate.apart.total() / 10.0).exp());
        Style {
            id: format!("imitated-{}-{}", self.seed, place + 1),
            name: format!("After {}", origin.name),
            tags: origin.tags.clone(),
            score: Some((score * 1000.0).round() / 1000.0),
            ..candidate.style.clone()
        }
    }

    fn advance(&mut self) {
        self.stage = match self.stage {
            Stage::Survey => Stage::Dress,
            Stage::Dress => Stage::Evolve(0),
            Stage::Evolve(round) if round + 1 < self.effort.rounds => Stage::Evolve(round + 1),
            Stage::Evolve(_) if self.wanted.features.screen.pitch > 0.0 => Stage::Tune(0),
            Stage::Tune(round) if round + 1 < TUNINGS => Stage::Tune(round + 1),
            _ => Stage::Done,
        };
    }

    /// Asks for a style, once.
    fn want(&mut self, style: Style, origin: (usize, usize), close: bool) {
        let chain = format!("{:?}{:?}{:?}{close}", style.background, style.foreground, style.ink);
        if self.tried.insert(chain) {
            let area = trial_area(self.wanted.features.area);
            self.asked.push((Ask { style, area, close }, origin));
        }
    }

    fn survey(&mut self) {
        for (i, ask) in survey().into_iter().enumerate() {
            self.want(ask.style, (i, ALL.len()), false);
        }
    }

    /// Takes half of the styles by total distance, and the other half by features other than colour.
    fn dress(&mut self) {
        let mut nearest: Vec<usize> =
            self.known.iter().take(self.effort.nearest / 2).map(|near| near.origin.0).collect();
        let mut by_shape: Vec<&Candidate> = self.known.iter().collect();
        let shape = |candidate: &Candidate| candidate.apart.shape + candidate.apart.screen;
        sort_by(&mut by_shape, |a, b| shape(a).total_cmp(&shape(b)));
        for candidate in by_shape {
            if nearest.len() < self.effort.nearest && !nearest.contains(&candidate.origin.0) {
                nearest.push(candidate.origin.0);
            }
        }
        for origin in nearest {
            for (i, dress) in ALL.into_iter().enumerate() {
                if let Some(style) = dressed(&catalogue()[origin], dress, &self.wanted) {
                    self.want(style, (origin, i), false);
                }
            }
        }
    }

    fn evolve(&mut self, round: usize) {
        let mut parents: Vec<Candidate> = Vec::with_capacity(PARENTS);
        for candidate in &self.known {
            let same = parents.iter().filter(|parent| parent.origin == candidate.origin).count();
            if parents.len() < PARENTS && same < 2 {
                parents.push(candidate.clone());
            }
        }
        let step = 0.55 * 0.75f64.powi(round as i32);
        for i in 0..self.effort.children {
            // The better, the more children.
            let rank = (self.random.rand_float().powi(2) * parents.len() as f64) as usize;
            let Some(parent) = parents.get(if i < parents.len() / 2 { i } else { rank }) else { continue };
            let mut child = parent.style.clone();
            if self.random.rand_float() < 0.15 {
                let other = &parents[self.random.rand_range(0..parents.len() as u64) as usize];
                child.foreground.clone_from(&other.style.foreground);
                child.ink = other.style.ink;
            }
            if self.random.rand_float() < 0.6 {
                nudge(&mut child, &Gaps::between(&self.wanted.features, &parent.found), &mut self.random);
            }
            mutate(&mut child, step, &mut self.random);
            self.want(child, parent.origin, false);
        }
    }

    /// Asks to see the best close.
    fn tune(&mut self) {
        let mut seen: Vec<(usize, usize)> = Vec::new();
        let mut styles = Vec::new();
        for candidate in &self.known {
            let same = seen.iter().filter(|origin| **origin == candidate.origin).count();
            if styles.len() < self.effort.tuned && same < 2 {
                seen.push(candidate.origin);
                styles.push((candidate.style.clone(), candidate.origin));
            }
        }
        for (style, origin) in styles {
            self.want(style, origin, true);
        }
    }

    /// Stores the screen that was measured in a close-up, and corrects the pitch of the style.
    fn tuned(&mut self, style: &Style, close: &Features) {
        let same = |candidate: &&mut Candidate| same_chain(&candidate.style, style);
        let Some(candidate) = self.known.iter_mut().find(same) else { return };
        let wanted = &self.wanted.features;
        candidate.apart.screen = screens(wanted, close);
        let ratio = wanted.screen.pitch / close.screen.pitch.max(1e-3);
        // A distant value belongs to another periodic pattern, for example a harmonic.
        if close.screen.pitch > 0.0 && (ratio - 1.0).abs() > 0.03 && (0.4..2.5).contains(&ratio) {
            scaled(&mut candidate.style, ratio);
        }
    }
}

fn same_chain(a: &Style, b: &Style) -> bool {
    a.ink == b.ink
        && format!("{:?}{:?}", a.background, a.foreground) == format!("{:?}{:?}", b.background, b.foreground)
}

/// Mean difference of two signatures.
fn difference(a: &[u8], b: &[u8]) -> f32 {
    let sum: u32 = a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
    sum as f32 / a.len().max(1) as f32
}

/// The deficits of a style, as factors on a logarithmic scale; values above 0 require an increase.
struct Gaps {
    lines: f32,
    width: f32,
    tone: f32,
    texture: f32,
}

impl Gaps {
    fn between(wanted: &Features, found: &Features) -> Self {
        let ratio = |a: f32, b: f32| ((a + 0.01) / (b + 0.01)).ln().clamp(-1.5, 1.5);
        let fine = |features: &Features| features.texture[0] + features.texture[1];
        Self {
            lines: ratio(wanted.dark.density, found.dark.density),
            width: if found.dark.width > 0.0 && wanted.dark.width > 0.0 {
                ratio(wanted.dark.width, found.dark.width)
            } else {
                0.0
            },
            tone: 2.0 * (wanted.tone() - found.tone()),
            texture: ratio(fine(wanted) + 1.0, fine(found) + 1.0),
        }
    }
}

/// Moves values towards what is missing, some of the way or beyond.
fn nudge(style: &mut Style, gaps: &Gaps, random: &mut Rand64) {
    let gaps = [gaps.lines, gaps.width, gaps.tone, gaps.texture];
    for step in layers(style).flatten() {
        for (at, param) in step.block.params.iter().enumerate() {
            let Some(wanted) = param.gaps else { continue };
            let powers = [wanted.lines, wanted.width, wanted.tone, wanted.texture];
            let power: f32 = powers.iter().zip(gaps).map(|(power, gap)| power * gap).sum();
            let far = 1.3 * random.rand_float() as f32;
            step.values[at] = param.rounded(step.values[at] * (power * far).exp());
        }
    }
}

/// Moves about two values of a style. `far` is the usual step, as a share of the value or of its range.
fn mutate(style: &mut Style, far: f64, random: &mut Rand64) {
    let free =
        |param: &Param| matches!(param.kind, Kind::Number { .. } | Kind::Integer { .. }) && !param.is_fixed;
    let count: usize = layers(style)
        .flatten()
        .map(|step| step.block.params.iter().filter(|param| free(param)).count())
        .sum();
    for step in layers(style).flatten() {
        for (param, value) in step.block.params.iter().zip(&mut step.values) {
            if !free(param) || random.rand_float() * count as f64 > 2.2 {
                continue;
            }
            let push = far * ((random.rand_float() + random.rand_float() + random.rand_float()) * 2.0 - 3.0);
            let (least, most) = param.kind.range();
            let moved = match param.kind {
                Kind::Integer { .. } => {
                    *value + (push * 4.0).signum() as f32 * (1.0 + (push * 2.0).abs() as f32).floor()
                }
                _ if least >= 0.0 && *value > 0.0 => *value * (push as f32).exp(),
                _ => *value + push as f32 * 0.15 * (most - least),
            };
            *value = param.rounded(moved);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Image, Plane};

    #[test]
    fn the_survey_is_what_is_asked_first_of_pictures_of_any_shape() {
        let shown = |asks: &[Ask]| format!("{asks:?}");
        for (width, height) in [(1600, 1200), (723, 411), (400, 900)] {
            let plane =
                |shift: usize| Plane::from_fn(width, height, |x, y| ((x / 9 + y / 7) * 31 + shift) as u8);
            let picture = Image::from_rgb([0, 40, 90].map(plane)).unwrap();
            let asked = Search::new(Features::of(&picture), 3).ask();
            assert_eq!(shown(&asked), shown(&survey()), "{width} x {height}");
        }
    }
}
