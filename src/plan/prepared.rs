//! What is found out about a photo once, for all plans: a crop for each of twelve shapes of panel, and how strong the
//! photo is.

use std::cell::OnceCell;
use std::rc::Rc;

use super::best_first;
use crate::framing::{Crop, FACE, LETTERING, PhotoMeta, Subject, Target, sketch};
use crate::layout::Bounds;

/// Shapes of panels for which crops are kept, from 1:3 to 3:1 in equal steps of their logarithm.
pub const ASPECTS: usize = 12;
/// The widest of them.
const WIDEST: f64 = 3.0;
/// Subjects that are looked at; the largest count.
const MOST_MARKS: usize = 16;

/// A photo, ready to be put into many panels.
#[derive(Debug, Clone, PartialEq)]
pub struct Prepared {
    /// Width and height in pixels, at least 1.
    pub(super) sides: (f64, f64),
    /// The best crop for each aspect, and the part of the photo's energy that it holds.
    pub(super) sketches: Vec<(Crop, f64)>,
    /// Its subjects, faces first.
    pub(super) marks: Vec<Mark>,
    /// What its subjects have to offer, 0 to 1.
    pub(super) subject: f64,
    /// What its tones have to offer, 0 to 1.
    pub(super) tonal: f64,
}

/// A subject as plans see it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mark {
    /// The box with hair and ears, in fractions of the photo.
    pub(super) grown: Bounds,
    /// The box itself.
    pub(super) bare: Bounds,
    pub(super) face: bool,
    /// How bad it is to cut it: 0 for what only surrounds, less for a body whose face is known.
    pub(super) whole: f64,
    /// How much it matters, 0 and more.
    pub(super) weight: f64,
}

impl Prepared {
    /// Looks at a photo.
    #[must_use]
    pub fn of(photo: &PhotoMeta) -> Self {
        let aspect = |i: usize| WIDEST.powf(2.0 * i as f64 / (ASPECTS - 1) as f64 - 1.0);
        let sketches = (0..ASPECTS).map(|i| sketch(photo, &Target::of_aspect(aspect(i)))).collect();
        let marks: Vec<Mark> = photo.marked().filter_map(|s| mark(&s, photo)).collect();
        let ratings: Vec<f64> =
            marks.iter().map(|mark| mark.weight + if mark.face { 1e3 } else { 0.0 }).collect();
        let marks: Vec<Mark> =
            best_first(&ratings).into_iter().take(MOST_MARKS).map(|at| marks[at]).collect();
        let subject = photo.marked().map(|s| {
            // A face of a fifth of the photo's side is a portrait; of a thing it takes more.
            let size = (s.width * s.height).max(0.0).sqrt();
            let full = if s.label == FACE { 0.2 } else { 0.45 };
            let kind = match s.label.as_str() {
                FACE => 1.0,
                // A sign is to be read whole, and seldom what a page is about.
                LETTERING => 0.3,
                _ => 0.85,
            };
            kind * s.score.clamp(0.0, 1.0).sqrt() * (size / full).min(1.0)
        });
        let subject = subject.filter(|value| value.is_finite()).fold(0.0, f64::max);
        let tonal = photo.facts.as_ref().map_or(0.5, |facts| {
            let (mean, spread) = facts.spread();
            let lively = (spread / 0.22).min(1.0);
            let lit = 1.0 - ((mean - 0.48).abs() / 0.48).powi(2);
            let colourful = f64::from(facts.chroma) / 76.0;
            0.45 * lively + 0.3 * lit.max(0.0) + 0.25 * colourful.min(1.0)
        });
        let sides = (f64::from(photo.width.max(1)), f64::from(photo.height.max(1)));
        Self { sides, sketches, marks, subject, tonal }
    }

    /// The crop that is kept for the shape nearest to `aspect`, brought to it, and the energy that it holds.
    pub(super) fn crop_for(&self, photo: &PhotoMeta, aspect: f64) -> (Crop, f64) {
        let at = f64::midpoint(aspect.max(1e-3).ln() / WIDEST.ln(), 1.0) * (ASPECTS - 1) as f64;
        let at = (at.round().max(0.0) as usize).min(ASPECTS - 1);
        let (crop, energy) = self.sketches[at];
        let refitted = crop.refitted(photo, aspect);
        let shrunk = (refitted.width * refitted.height) / (crop.width * crop.height).max(1e-9);
        (refitted, (energy * shrunk.min(1.0)).min(1.0))
    }
}

fn mark(s: &Subject, photo: &PhotoMeta) -> Option<Mark> {
    let sound = [s.x, s.y, s.width, s.height, s.score].iter().all(|value| value.is_finite());
    if !sound || s.width <= 0.0 || s.height <= 0.0 {
        return None;
    }
    let grown = s.grown();
    let bounds = |s: &Subject| Bounds { x: s.x, y: s.y, width: s.width, height: s.height };
    let kind = match s.label.as_str() {
        FACE => 1.5,
        "person" => 1.0,
        "cat" | "dog" | "bird" | "horse" => 0.9,
        _ => 0.6,
    };
    let weight = kind * (0.2 + (s.width * s.height).sqrt()) * s.score.clamp(0.05, 1.0);
    // A portrait may end at the waist.
    let portrait = s.label == "person" && photo.subjects.iter().any(|o| o.label == FACE && s.surrounds(o));
    let whole = if s.is_scenery() {
        0.0
    } else if portrait {
        0.4
    } else {
        1.0
    };
    Some(Mark { grown: bounds(&grown), bare: bounds(s), face: s.label == FACE, whole, weight })
}

/// What was found out about one photo, once somebody asked; copies share it.
pub type Place = Rc<OnceCell<Prepared>>;

/// A place for each photo of a request, in their order.
#[derive(Debug, Clone, Default)]
pub struct Shelf {
    places: Vec<Place>,
}

impl Shelf {
    /// Empty places for so many photos.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self { places: (0..count).map(|_| Place::default()).collect() }
    }

    /// Places that were in use before, one for each photo.
    #[must_use]
    pub fn of(places: Vec<Place>) -> Self {
        Self { places }
    }

    /// The photo at a place, prepared now if it was not before.
    pub(super) fn get(&self, at: usize, photo: &PhotoMeta) -> &Prepared {
        self.places[at].get_or_init(|| Prepared::of(photo))
    }
}
