//! Analysis of one photo, cached for all plans: a crop for each of twelve panel shapes, and the strength of
//! the photo.

use std::cell::OnceCell;
use std::rc::Rc;

use super::best_first;
use super::moments::Moment;
use crate::framing::{Crop, FACE, FIGURE, LETTERING, PERSON_HEAD, PhotoMeta, SURE, Subject, Target, sketch};
use crate::layout::Bounds;
use crate::select::fingerprint::distance;

/// Number of cached crops. Their panel shapes range from 1:3 to 3:1 in equal steps of the logarithm.
pub const ASPECTS: usize = 12;
/// Aspect ratio of the widest one.
const WIDEST: f64 = 3.0;
/// Maximum number of subjects; the largest ones count.
const MOST_MARKS: usize = 16;
/// Number of photos that fill any page.
const MANY: usize = 24;
/// Panels of a page with hardly anything to see.
const FEWEST: usize = 3;
/// Labels of vehicles.
const VEHICLES: [&str; 8] = ["bicycle", "car", "motorcycle", "airplane", "bus", "train", "truck", "boat"];
/// Labels that detectors give to pages of text and to screenshots.
const SCREENS: [&str; 7] = ["cell phone", "tv", "laptop", "remote", "book", "keyboard", "refrigerator"];
/// Labels of screens that show pictures, and the value of people on them, relative to others.
const DISPLAYS: [&str; 3] = ["tv", "laptop", "cell phone"];
const DISPLAYED: f64 = 0.25;
/// Distance from the edge of a box that still counts as inside, in sides of the photo.
const NEAR: f64 = 0.02;
/// Minimum value of a person or animal in a photo of kind `Alive`.
const ALIVE: f64 = 0.3;
/// Value of a person without a known face as a lead, and for the kind of photo. Such people are seen from behind or from far
/// away.
const BEHIND: (f64, f64) = (0.5, 0.7);
/// The part of the value of a body that does not depend on how clear its face is.
const UNCLEAR: f64 = 0.4;
/// Number of people without a known face that make a photo a street scene, and the factor of their value.
const CROWD: (usize, f64) = (4, 0.6);
/// Factor of the value of a photo that cuts the head of a person.
const HEADLESS: f64 = 0.85;
/// A photo with this part of its pixels in the two darkest of sixteen tones starts to lose value. The second part costs the
/// third number, as a part of the value. Styles draw such photos as black areas.
const GLOOM: (f64, f64, f64) = (0.5, 0.85, 0.5);
/// The value of a face rises from the first score to the second. The back of a head can have 0.5.
const DOUBTFUL: (f64, f64) = (0.35, 0.96);
/// Minimum score of a face that plans know.
const KNOWN: f64 = 0.56;
/// The part of the value of a face that a profile loses.
const PROFILE: f64 = 0.2;
/// The part that shut eyes lose.
const SHUT: f64 = 0.25;
/// Bonus of each face of a group after the first, and the number of faces with a bonus.
const GROUP: (f64, usize) = (0.06, 4);
/// The part of a photo that lettering covers on a document, and on a photo of a sign.
const TEXT: f64 = 0.04;
const SIGN: f64 = 0.02;
/// The part of a document that has its two commonest tones.
const FLAT: f64 = 0.5;
/// Minimum sides of a book or screen that fills a photo, and its minimum flat part.
const SHEET: (f64, f64) = (0.85, 0.65);
/// Maximum aspect ratio of a screenshot of a phone, and its minimum flat part. Photos of phones are wider.
const PHONE: (f64, f64) = (0.52, 0.7);
/// The part of an animal, from the top, that contains the head.
const ANIMAL_HEAD: f64 = 0.38;
/// Side of a face, as a part of the photo's side, that makes a tall picture with bars a portrait, not a screenshot.
const PORTRAIT: f64 = 0.1;
/// Minimum score of a person, and minimum overlap with an animal, at which the detector is unsure about the animal.
const RIVAL: (f64, f64) = (0.4, 0.6);
/// The share of edges, and the chroma, below which a photo without subjects shows a wall or a grey sky.
const BARE: f64 = 0.26;
const GREY: f64 = 60.0;

/// Two photos certainly show one moment up to the first value, and certainly do not from the second value on: differences of
/// fingerprints in bits, mean differences of colours in grey levels, and times between them in seconds.
const BITS: (f64, f64) = (12.0, 26.0);
const COLOURS: (f64, f64) = (5.0, 13.0);
const SECONDS: (f64, f64) = (10.0, 120.0);

/// A photo, ready to be put into many panels.
#[derive(Debug, Clone, PartialEq)]
pub struct Prepared {
    /// Width and height in pixels, at least 1.
    pub(super) sides: (f64, f64),
    /// The best crop for each aspect, and the part of the photo's energy that it holds.
    pub(super) sketches: Vec<(Crop, f64)>,
    /// Its subjects, faces first.
    pub(super) marks: Vec<Mark>,
    /// Interest of the subjects, from 0: a face has 1, a group more.
    pub(super) care: f64,
    /// The kind of photo.
    pub(super) kind: Kind,
    /// Quality of its tones, 0 to 1.
    pub(super) tonal: f64,
}

/// Kind of photo. Each kind has rules in the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// People or animals.
    Alive,
    /// Things, and scenes with something to see.
    Scene,
    /// Sky, a wall or a sign.
    Bare,
    /// A page of text: a letter, a receipt, a screenshot.
    Document,
}

/// Kind of subject. Each kind has rules for crops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Face,
    Lettering,
    Animal,
    /// The body of a person whose face is known.
    Body,
    Other,
}

/// A subject as plans see it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mark {
    /// The box with hair and ears, in fractions of the photo.
    pub(super) grown: Bounds,
    /// The box itself.
    pub(super) bare: Bounds,
    pub(super) part: Part,
    /// The upper part of an animal, or of a person whose face is not known, with the head.
    pub(super) head: Option<Bounds>,
    /// Penalty for cutting it: 0 for surroundings, and low for a body whose face is known.
    pub(super) whole: f64,
    /// Importance, 0 and more.
    pub(super) weight: f64,
}

impl Prepared {
    /// Looks at a photo.
    #[must_use]
    pub fn of(photo: &PhotoMeta) -> Self {
        let aspect = |i: usize| WIDEST.powf(2.0 * i as f64 / (ASPECTS - 1) as f64 - 1.0);
        let sketches = (0..ASPECTS).map(|i| sketch(photo, &Target::of_aspect(aspect(i)))).collect();
        let marks: Vec<Mark> =
            photo.marked().filter(|s| !photo.is_headless(s)).filter_map(|s| mark(&s, photo)).collect();
        let ratings: Vec<f64> =
            marks.iter().map(|mark| mark.weight + if mark.part == Part::Face { 1e3 } else { 0.0 }).collect();
        let marks: Vec<Mark> =
            best_first(&ratings).into_iter().take(MOST_MARKS).map(|at| marks[at]).collect();
        let (care, kind) = care(photo);
        let tonal = photo.facts.as_ref().map_or(0.5, |facts| {
            let (mean, spread) = facts.spread();
            let lively = (spread / 0.22).min(1.0);
            let lit = 1.0 - ((mean - 0.48).abs() / 0.48).powi(2);
            let colourful = f64::from(facts.chroma) / 76.0;
            0.45 * lively + 0.3 * lit.max(0.0) + 0.25 * colourful.min(1.0)
        });
        let sides = (f64::from(photo.width.max(1)), f64::from(photo.height.max(1)));
        Self { sides, sketches, marks, care, kind, tonal }
    }

    /// Returns the cached crop of the shape nearest to `aspect`, adapted to it, and its energy.
    pub(super) fn crop_for(&self, photo: &PhotoMeta, aspect: f64) -> (Crop, f64) {
        let at = f64::midpoint(aspect.max(1e-3).ln() / WIDEST.ln(), 1.0) * (ASPECTS - 1) as f64;
        let at = (at.round().max(0.0) as usize).min(ASPECTS - 1);
        let (crop, energy) = self.sketches[at];
        let refitted = photo.refitted(&crop, aspect);
        let shrunk = (refitted.width * refitted.height) / (crop.width * crop.height).max(1e-9);
        (refitted, (energy * shrunk.min(1.0)).min(1.0))
    }
}

/// Whether a photo is a page of text, such as a letter, a receipt or a screenshot.
#[must_use]
pub fn is_document(photo: &PhotoMeta) -> bool {
    care(photo).1 == Kind::Document
}

/// The value of a face, 0 to 1: a look at the camera in good light comes before a profile, shut eyes, and a face in the shade.
fn face_value(face: &Subject) -> f64 {
    let shut = if face.is_shut() { SHUT } else { 0.0 };
    (1.0 - PROFILE * face.gaze().abs()) * (1.0 - shut) * face.lit()
}

/// The part of its value that a photo without faces loses because it is dark.
fn gloom(photo: &PhotoMeta) -> f64 {
    let (from, to, cost) = GLOOM;
    photo.facts.as_ref().map_or(0.0, |facts| {
        let dark = f64::from(facts.tones[0]) + f64::from(facts.tones[1]);
        cost * ((dark / 255.0 - from) / (to - from)).clamp(0.0, 1.0)
    })
}

/// Returns the interest of a photo, and its kind.
fn care(photo: &PhotoMeta) -> (f64, Kind) {
    let subjects: Vec<_> = photo.marked().filter(|s| is_sound(s) && is_clear(s)).collect();
    let side = |s: &Subject| (s.width * s.height).sqrt();
    let faces = || subjects.iter().filter(|s| s.label == FACE);
    let people = || subjects.iter().filter(|s| s.label == "person");
    let displays = || subjects.iter().filter(|s| DISPLAYS.contains(&s.label.as_str()));
    // A photo of a video call. The body of a person in front of a television is not inside of it.
    let on_display = |s: &Subject| {
        displays().any(|display| {
            let inside = |s: &Subject| {
                s.x >= display.x - NEAR
                    && s.y >= display.y - NEAR
                    && s.x + s.width <= display.x + display.width + NEAR
                    && s.y + s.height <= display.y + display.height + NEAR
            };
            s.label != display.label
                && inside(s)
                && people().filter(|person| person.surrounds(s)).all(|person| inside(person))
        })
    };
    // A starfish is a bird and a person to detectors.
    let is_doubtful = |s: &Subject| {
        let area = |s: &Subject| Crop { x: s.x, y: s.y, width: s.width, height: s.height };
        s.is_animal()
            && people().any(|person| person.score >= RIVAL.0 && area(s).overlap(&area(person)) >= RIVAL.1)
    };
    let is_known = |person: &Subject| faces().any(|face| person.surrounds(face));
    let strangers = people().filter(|person| !is_known(person)).count();
    let is_crowd = strangers >= CROWD.0 && strangers == people().count();
    let certain =
        |face: &Subject| ((face.score - DOUBTFUL.0) / (DOUBTFUL.1 - DOUBTFUL.0)).clamp(0.0, 1.0).sqrt();
    let clearest = |person: &Subject| {
        let known = faces().filter(|face| person.surrounds(face));
        known.map(|face| certain(face) * face_value(face)).fold(0.0, f64::max)
    };
    let value = |s: &Subject| {
        let score = if s.label == FACE { certain(s) } else { s.score.clamp(0.0, 1.0).sqrt() };
        let sure = score * if on_display(s) { DISPLAYED } else { 1.0 };
        let size = |full: f64| (side(s) / full).min(1.0);
        sure * match s.label.as_str() {
            // A small face without a person can be a false detection.
            FACE => {
                let owned = s.score > SURE || side(s) > 0.12 || people().any(|person| person.surrounds(s));
                // A portrait comes before a figure in a landscape.
                (if owned { 1.0 } else { 0.4 }) * face_value(s) * (0.4 + 0.4 * size(0.14) + 0.2 * size(0.28))
            }
            // A person without a face is seen from behind, or is a passer-by.
            "person" if is_known(s) => {
                0.85 * (UNCLEAR + (1.0 - UNCLEAR) * clearest(s)) * size(0.42).powf(0.7)
            }
            "person" => BEHIND.0 * (if is_crowd { CROWD.1 } else { 1.0 }) * size(0.42).powf(0.7),
            _ if s.is_alive() => 0.95 * (if is_doubtful(s) { 0.4 } else { 1.0 }) * (0.15 + 0.85 * size(0.35)),
            label if VEHICLES.contains(&label) => 0.5 * size(0.45),
            // A sign must be readable, but is rarely the main subject.
            LETTERING => 0.0,
            // The mask shows a subject of unknown kind.
            FIGURE => 0.4 * size(0.4),
            _ => 0.3 * size(0.45),
        }
    };
    let lit = if faces().next().is_some() { 1.0 } else { 1.0 - gloom(photo) };
    let best = lit * subjects.iter().map(|s| value(s)).fold(0.0, f64::max);
    let least = |s: &Subject| match s.label.as_str() {
        "person" if is_known(s) => ALIVE,
        "person" => ALIVE * BEHIND.0 / BEHIND.1 * if is_crowd { CROWD.1 } else { 1.0 },
        _ => ALIVE,
    };
    let alive = subjects.iter().any(|s| s.is_alive() && value(s) >= least(s));
    let tallest = faces().map(|face| face.height).fold(0.0, f64::max);
    let group = faces().filter(|face| face.height >= 0.5 * tallest && side(face) >= 0.03);
    let mut group: Vec<f64> =
        group.map(|face| certain(face) * (1.0 - face.gaze().abs()) * face.light.unwrap_or(1.0)).collect();
    group.sort_by(|a, b| b.total_cmp(a));
    let bonus = GROUP.0 * group.iter().skip(1).take(GROUP.1).sum::<f64>();
    // Detectors report screenshots and receipts as a phone or television that fills the photo, and see faces in them.
    let is_screen = |s: &Subject| SCREENS.contains(&s.label.as_str()) && side(s) > 0.95;
    let sure = subjects.iter().any(|s| s.is_alive() && (s.label != FACE || s.score > SURE));
    // A screenshot of a phone has a status line or a bar of buttons. The picture in it may show people.
    let is_tall = photo.aspect() <= PHONE.0;
    let has_bar = photo.facts.as_ref().is_some_and(|facts| facts.bars[1] > 0 || facts.bars[3] > 0);
    let sure_face = faces().any(|face| face.score > SURE && side(face) > PORTRAIT);
    if !sure && subjects.iter().any(|s| is_screen(s)) || is_tall && has_bar && !sure_face {
        return (0.0, Kind::Document);
    }
    if alive {
        let cut = if photo.subjects.iter().any(|s| photo.is_headless(s)) { HEADLESS } else { 1.0 };
        return (cut * (best + bonus), Kind::Alive);
    }
    let lettering = || subjects.iter().filter(|s| s.label == LETTERING);
    let text: f64 = lettering().map(|s| s.width * s.height).sum();
    // The two commonest of sixteen tones, and the share of pixels on an edge: paper and screens are flat.
    let (flat, edges, chroma) = photo.facts.as_ref().map_or((0.0, 0.3, GREY), |facts| {
        let shares = facts.tones.map(|share| f64::from(share) / 255.0);
        let first = (0..shares.len()).fold(0, |most, at| if shares[at] > shares[most] { at } else { most });
        let second = (0..shares.len()).filter(|&at| at != first).map(|at| shares[at]).fold(0.0, f64::max);
        (shares[first] + second, f64::from(facts.edges[1]) / 255.0, f64::from(facts.chroma))
    });
    let printed = text >= TEXT && lettering().count() > 1 && flat >= FLAT;
    let is_sheet = |s: &Subject| SCREENS.contains(&s.label.as_str()) && side(s) > SHEET.0 && flat >= SHEET.1;
    let on_phone = is_tall && flat >= PHONE.1 && best < ALIVE;
    if printed || on_phone || subjects.iter().any(|s| is_sheet(s)) {
        return (0.0, Kind::Document);
    }
    if text >= SIGN && best < 0.25 {
        return (0.05, Kind::Bare);
    }
    let scene = 0.25 * lit * (edges / 0.3).min(1.0);
    if best < 0.15 && edges < BARE && chroma < GREY {
        return (0.0, Kind::Bare);
    }
    (best.max(scene), Kind::Scene)
}

/// Counts the photos that differ from each other and show something: no documents, walls and gray skies. At least
/// three, if there are so many, and all if every photo is a document.
/// `duplicate_threshold`: maximum fingerprint distance of near-duplicates, in bits.
#[must_use]
pub fn worth_showing(photos: &[PhotoMeta], duplicate_threshold: u32) -> usize {
    if photos.len() > MANY {
        return photos.len();
    }
    let mut shown: Vec<&PhotoMeta> = Vec::new();
    let mut bare = 0;
    for photo in photos {
        // A photo that was never measured is like no other.
        let known = photo.fingerprint != 0
            && shown.iter().any(|other| are_duplicates(other, photo, duplicate_threshold));
        let kind = care(photo).1;
        if !known && kind != Kind::Document {
            shown.push(photo);
            bare += usize::from(kind == Kind::Bare);
        }
    }
    if shown.is_empty() { photos.len() } else { (shown.len() - bare).max(shown.len().min(FEWEST)) }
}

/// Whether two photos are near-duplicates: their fingerprints differ in at most `threshold` bits.
pub(super) fn are_duplicates(a: &PhotoMeta, b: &PhotoMeta, threshold: u32) -> bool {
    distance(a.fingerprint, b.fingerprint) <= threshold
}

/// How certainly two photos show one moment, 0 to 1: similar fingerprints, and similar colours or close times. Frames of a
/// video show an action, so they are exempt.
pub(super) fn likeness(a: &PhotoMeta, b: &PhotoMeta) -> f64 {
    if a.frame && b.frame || a.fingerprint == 0 || b.fingerprint == 0 {
        return 0.0;
    }
    let near = |(same, other): (f64, f64), apart: f64| ((other - apart) / (other - same)).clamp(0.0, 1.0);
    let bits = near(BITS, f64::from(distance(a.fingerprint, b.fingerprint)));
    if bits <= 0.0 {
        return 0.0;
    }
    let colours = match (&a.facts, &b.facts) {
        (Some(a), Some(b)) => {
            let apart = a.colours.iter().zip(b.colours).map(|(a, b)| f64::from(a.abs_diff(b)));
            near(COLOURS, apart.sum::<f64>() / a.colours.len() as f64)
        }
        _ => 0.0,
    };
    let moment = |photo: &PhotoMeta| photo.taken.as_deref().and_then(Moment::parse);
    let time = match (moment(a), moment(b)) {
        (Some(a), Some(b)) => near(SECONDS, a.seconds.abs_diff(b.seconds) as f64),
        _ => 0.0,
    };
    (bits * colours.max(time)).sqrt()
}

fn is_sound(s: &Subject) -> bool {
    let sound = [s.x, s.y, s.width, s.height, s.score].iter().all(|value| value.is_finite());
    sound && s.width > 0.0 && s.height > 0.0
}

/// Whether plans know a subject. They value a person with an unclear face like one without: crops and styles protect the face,
/// and no photo leads or stays out because of it.
fn is_clear(s: &Subject) -> bool {
    s.label != FACE || s.score >= KNOWN
}

fn mark(s: &Subject, photo: &PhotoMeta) -> Option<Mark> {
    if !is_sound(s) || !is_clear(s) {
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
    let is_face_of = |o: &Subject| o.label == FACE && is_clear(o) && s.surrounds(o);
    let portrait = s.label == "person" && photo.subjects.iter().any(is_face_of);
    let whole = if s.is_scenery() {
        0.0
    } else if portrait {
        0.4
    } else {
        1.0
    };
    let head = (s.is_animal() || s.label == "person" && !portrait).then(|| Bounds {
        height: if s.is_animal() { ANIMAL_HEAD } else { PERSON_HEAD } * s.height,
        ..bounds(s)
    });
    let part = match s.label.as_str() {
        FACE => Part::Face,
        LETTERING => Part::Lettering,
        _ if s.is_animal() => Part::Animal,
        _ if portrait => Part::Body,
        _ => Part::Other,
    };
    Some(Mark { part, head, grown: bounds(&grown), bare: bounds(s), whole, weight })
}

/// The analysis of one photo, computed on the first request. Clones share it.
pub type Place = Rc<OnceCell<Prepared>>;

/// A place for each photo of a request, in their order.
#[derive(Debug, Clone, Default)]
pub struct Shelf {
    places: Vec<Place>,
}

impl Shelf {
    /// Creates `count` empty places.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self { places: (0..count).map(|_| Place::default()).collect() }
    }

    /// Places that were in use before, one for each photo.
    #[must_use]
    pub fn of(places: Vec<Place>) -> Self {
        Self { places }
    }

    /// Places of some of the photos, which share what is found out.
    #[must_use]
    pub fn some(&self, photos: &[usize]) -> Self {
        Self { places: photos.iter().map(|&photo| self.places[photo].clone()).collect() }
    }

    /// The photo at a place, prepared now if it was not before.
    pub(super) fn get(&self, at: usize, photo: &PhotoMeta) -> &Prepared {
        self.places[at].get_or_init(|| Prepared::of(photo))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framing::Expression;

    fn subject(label: &str, score: f64, [x, y, width, height]: [f64; 4]) -> Subject {
        Subject {
            label: label.into(),
            score,
            x,
            y,
            width,
            height,
            points: None,
            expression: None,
            light: None,
        }
    }

    /// A photo of this size whose two commonest tones cover `flat` of it.
    fn photo(width: u32, height: u32, flat: u8) -> PhotoMeta {
        let rest = (255 - flat) / 14;
        let tones: [u8; 16] = std::array::from_fn(|i| if i < 2 { flat / 2 } else { rest });
        let digits = tones.map(|share| format!("{share:02x}")).concat();
        let facts = serde_json::from_str(&format!("\"{digits}606018808080808080\"")).unwrap();
        PhotoMeta { facts: Some(facts), ..PhotoMeta::unmeasured("photo", width, height) }
    }

    #[test]
    fn a_dark_photo_without_faces_is_worth_less() {
        let worth = |dark: u8, score: f64| {
            let mut photo = photo(1600, 1200, dark);
            photo.find([
                subject("person", 0.9, [0.2, 0.2, 0.4, 0.7]),
                subject(FACE, score, [0.3, 0.25, 0.15, 0.2]),
            ]);
            care(&photo).0
        };
        let (light, dark) = (worth(60, 0.2), worth(240, 0.2));
        assert!(dark < 0.6 * light, "{dark} {light}");
        assert!((worth(60, 0.95) - worth(240, 0.95)).abs() < 1e-9, "a face in the dark is lit");
    }

    #[test]
    fn screenshots_are_documents_even_with_a_false_face() {
        let map = |score: f64, face: f64| {
            let mut map = photo(864, 1600, 210);
            map.find([
                subject(FACE, face, [0.53, 0.28, 0.26, 0.14]),
                subject("refrigerator", score, [0.0, 0.01, 1.0, 0.99]),
            ]);
            care(&map).1
        };
        assert_eq!(map(0.7, 0.56), Kind::Document);
        assert_eq!(map(0.7, 0.95), Kind::Alive);
        assert_eq!(care(&photo(785, 1600, 210)).1, Kind::Document, "a screenshot without lettering");
        assert_ne!(care(&photo(900, 1600, 210)).1, Kind::Document, "an upright photo of a phone");
        assert_ne!(care(&photo(785, 1600, 120)).1, Kind::Document, "a tall photo");
    }

    #[test]
    fn a_tall_picture_with_a_bar_is_a_screenshot_unless_it_is_a_portrait() {
        let kind = |width: u32, bar: &str, face: f64| {
            let mut phone = photo(width, 1600, 60);
            let facts = format!("\"{}{bar}\"", "20".repeat(25));
            phone.facts = Some(serde_json::from_str(&facts).unwrap());
            phone.find([
                subject("person", 0.9, [0.2, 0.2, 0.6, 0.6]),
                subject(FACE, 0.9, [0.3, 0.3, face, face]),
            ]);
            care(&phone).1
        };
        assert_eq!(kind(735, "0c000000", 0.05), Kind::Alive, "a bar at the side");
        assert_eq!(kind(735, "000c0000", 0.05), Kind::Document);
        assert_eq!(kind(735, "0000000c", 0.05), Kind::Document);
        assert_eq!(kind(735, "000c0000", 0.3), Kind::Alive, "a portrait");
        assert_eq!(kind(900, "000c0000", 0.05), Kind::Alive, "an upright photo");
    }

    #[test]
    fn two_photos_of_one_moment_are_alike_by_bits_and_colours_or_times() {
        let shot = |bits: u32, colours: &str, second: u32| {
            let mut shot = photo(1600, 1067, 60);
            let facts = format!("\"{}606018{colours}\"", "10".repeat(16));
            shot.facts = Some(serde_json::from_str(&facts).unwrap());
            shot.fingerprint = u64::MAX << bits;
            shot.taken = Some(format!("2024:05:17 10:{:02}:{:02}", second / 60, second % 60));
            shot
        };
        let first = shot(0, "808080808080", 0);
        let to_first = |bits, colours, second| likeness(&first, &shot(bits, colours, second));
        assert!(to_first(16, "808080848484", 900) > 0.7);
        assert!(to_first(16, "c0c0c0c0c0c0", 8) > 0.7, "seconds later, in other light");
        assert!(to_first(16, "c0c0c0c0c0c0", 900) < 1e-9, "other light, later");
        assert!(to_first(30, "808080808080", 3) < 1e-9, "another view");
        assert!(to_first(20, "808080848484", 900) < to_first(16, "808080848484", 900));
        let frame = |bits| PhotoMeta { frame: true, ..shot(bits, "808080808080", 0) };
        assert!(likeness(&frame(0), &frame(16)) < 1e-9, "frames of an action");
    }

    #[test]
    fn people_from_behind_count_less_and_are_still_people() {
        let person = |score: f64| {
            let mut photo = photo(1600, 1067, 60);
            let face = (score > 0.0).then(|| subject(FACE, score, [0.45, 0.15, 0.06, 0.09]));
            photo.find([subject("person", 0.9, [0.35, 0.1, 0.25, 0.8])].into_iter().chain(face));
            care(&photo)
        };
        let ((behind, kind), (doubtful, _), (known, _)) = (person(0.0), person(0.52), person(0.9));
        assert!(behind < 0.7 * known && doubtful < 0.7 * known, "{behind} {doubtful} {known}");
        assert_eq!(kind, Kind::Alive);
    }

    #[test]
    fn a_crowd_from_behind_is_worth_less_than_one_person_and_still_shows_people() {
        let crowd = |count: usize, face: bool| {
            let mut photo = photo(1600, 1067, 60);
            let people = (0..count).map(|i| subject("person", 0.9, [0.15 * i as f64, 0.4, 0.14, 0.5]));
            let face = face.then(|| subject(FACE, 0.9, [0.02, 0.42, 0.08, 0.12]));
            photo.find(people.chain(face));
            care(&photo)
        };
        let ((one, _), (many, kind), (known, _)) = (crowd(1, false), crowd(6, false), crowd(6, true));
        assert!(many < 0.7 * one && known > one, "{one} {many} {known}");
        assert_eq!(kind, Kind::Alive);
    }

    #[test]
    fn unclear_faces_add_less_to_a_group() {
        let group = |score: f64| {
            let mut photo = photo(1600, 1067, 60);
            let others = (1..5).map(|i| subject(FACE, score, [0.18 * f64::from(i), 0.3, 0.1, 0.15]));
            photo.find(std::iter::once(subject(FACE, 0.9, [0.0, 0.3, 0.1, 0.15])).chain(others));
            care(&photo).0
        };
        assert!(group(0.6) < group(0.9) - 0.05, "{} {}", group(0.6), group(0.9));
    }

    #[test]
    fn a_person_whose_head_the_photo_cuts_is_no_subject() {
        let stage = |top: f64| {
            let mut photo = photo(3600, 2400, 60);
            photo.find([
                subject(FACE, 0.92, [0.565, 0.3, 0.113, 0.17]),
                subject("person", 0.99, [0.458, 0.169, 0.391, 0.831]),
                subject("person", 0.49, [0.1, top, 0.3, 0.8]),
            ]);
            (care(&photo).0, Prepared::of(&photo).marks.len())
        };
        let ((cut, marks), (whole, all)) = (stage(0.03), stage(0.15));
        assert!(cut < 0.9 * whole && (marks, all) == (2, 3), "{cut} {whole} {marks} {all}");
    }

    #[test]
    fn a_face_with_shut_eyes_counts_less() {
        let value = |eyes: Option<f64>| {
            let mut portrait = photo(1600, 1067, 60);
            let expression =
                eyes.map(|eye| Expression { right_eye: eye, left_eye: eye, mouth: 0.0, smile: 0.0 });
            portrait.find([Subject { expression, ..subject(FACE, 0.95, [0.3, 0.2, 0.3, 0.5]) }]);
            care(&portrait)
        };
        let ((shut, kind), (open, _), (unknown, _)) = (value(Some(0.05)), value(Some(0.3)), value(None));
        assert!(shut < 0.8 * open && shut > 0.7 * open, "{shut} {open}");
        assert!((unknown - open).abs() < 1e-12, "{unknown} {open}");
        assert_eq!(kind, Kind::Alive);
    }

    #[test]
    fn a_face_in_the_shade_counts_less() {
        let value = |light: Option<f64>, others: usize| {
            let mut group = photo(1600, 1067, 60);
            let face =
                |i: usize| Subject { light, ..subject(FACE, 0.95, [0.02 + 0.24 * i as f64, 0.2, 0.2, 0.3]) };
            group.find((0..=others).map(face));
            care(&group).0
        };
        let (shade, half, lit) = (value(Some(0.0), 0), value(Some(0.5), 0), value(Some(1.0), 0));
        assert!(shade < 0.7 * lit && shade < half && half < lit, "{shade} {half} {lit}");
        assert!((value(None, 0) - lit).abs() < 1e-12);
        // A group in the shade is worth no more than one person in it.
        assert!((value(Some(0.0), 3) - shade).abs() < 1e-12);
    }

    #[test]
    fn an_animal_that_may_be_a_person_counts_less() {
        let value = |score: f64, x: f64| {
            let mut starfish = photo(1600, 1067, 60);
            starfish.find([
                subject("bird", 0.81, [0.3, 0.2, 0.4, 0.6]),
                subject("person", score, [x, 0.2, 0.4, 0.6]),
            ]);
            care(&starfish).0
        };
        assert!(value(0.51, 0.3) < 0.6, "{}", value(0.51, 0.3));
        assert!(value(0.3, 0.3) > 0.8 && value(0.51, 0.6) > 0.8);
    }

    #[test]
    fn walls_need_no_panel() {
        // Without edges and colours.
        let mut wall = photo(1600, 1067, 120);
        wall.facts = Some(serde_json::from_str(&format!("\"{}\"", "10".repeat(25))).unwrap());
        let person = |i: u64| {
            let mut person = photo(1600, 1067, 60);
            person.fingerprint = (i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            person.find([subject("person", 0.9, [0.3, 0.1, 0.3, 0.8])]);
            person
        };
        let album: Vec<PhotoMeta> = (0..4).map(person).chain([wall.clone(), wall.clone()]).collect();
        assert_eq!(care(&wall).1, Kind::Bare);
        assert_eq!(worth_showing(&album, 4), 4);
        assert_eq!(worth_showing(&[wall.clone(), wall.clone(), wall.clone(), wall], 4), FEWEST);
    }

    #[test]
    fn people_on_a_display_are_no_people_of_the_photo() {
        let call = |person: [f64; 4]| {
            let mut call = photo(1600, 1067, 60);
            call.find([
                subject("tv", 0.9, [0.1, 0.1, 0.8, 0.7]),
                subject("person", 0.95, person),
                subject(FACE, 0.9, [0.4, 0.25, 0.2, 0.3]),
            ]);
            care(&call)
        };
        assert_eq!(call([0.3, 0.2, 0.4, 0.6]).1, Kind::Scene);
        // In front of the television.
        let (value, kind) = call([0.25, 0.2, 0.5, 0.8]);
        assert!(kind == Kind::Alive && value > 0.7, "{value}");
    }

    #[test]
    fn a_page_of_a_notebook_is_a_document_and_a_book_on_a_table_is_not() {
        let book = |flat: u8, side: f64| {
            let mut book = photo(1600, 1067, flat);
            book.find([subject("book", 0.85, [0.0, 0.0, side, side])]);
            care(&book).1
        };
        assert_eq!(book(184, 0.91), Kind::Document);
        assert_ne!(book(90, 0.91), Kind::Document);
        assert_ne!(book(184, 0.7), Kind::Document);
    }
}
