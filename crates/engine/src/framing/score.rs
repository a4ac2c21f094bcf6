//! How good a crop is.
//!
//! The terms follow the paper's framing: coverage of subjects, size of the subject in the crop, enough
//! pixels, faces cut, same subject shown before. Without subjects, energy replaces them. They are computed
//! for the finished crop and all subjects, not for the original box. So crops of any origin are comparable.

use std::borrow::Cow;

use super::Crop;
use super::candidates::{Area, ROOM, View, reach};
use super::sums::Sums;
use super::{FACE, PERSON_HEAD, PhotoMeta, Subject};

/// Maximum enlargement, unless nothing else fits.
const MOST_ENLARGED: f64 = 2.0;
/// Cost of a crop's area relative to its energy. Lower values zoom in less.
const AREA_COST: f64 = 0.35;
/// Total weight of the subjects at which they decide the score. With less weight, the image content counts
/// too. So a false detection, such as a stone as a sheep, does not hide the mountains.
const STRONG: f64 = 0.25;
/// Minimum part of a photo in a crop, if such a crop exists.
const LEAST_KEPT: f64 = 0.44;
/// Height of a recognisable main face in heights of the crop. The crop then shows a figure from the knees up.
const FACE_HEIGHT: f64 = 0.2;
/// Value of a main face of that height.
const FACE_VALUE: f64 = 1.7;
/// Minimum part of a photo in a crop near a small face, and the width in pixels below which the crop becomes soft.
const CLOSE_KEPT: f64 = 0.1;
const CLOSE_WIDTH: f64 = 400.0;
/// Minimum score of a small face without a person around it.
pub(crate) const SURE: f64 = 0.78;
/// Range of the visible part of a body in a medium shot. The lower edge may cut the body there, if the face is complete.
pub(crate) const MEDIUM: (f64, f64) = (0.3, 0.8);
/// Least part of the width of a body in a medium shot. If the body is wider than the crop, least part of the crop.
const ACROSS: f64 = 0.85;
/// The least part of a photo that a subject covers which must not be cut.
const SOME_SIZE: f64 = 0.01;
/// The upper part of an animal that contains the head.
const CROWN: f64 = 0.4;
/// Cost of less room than [`ROOM`] where a face looks, in widths of the crop.
const CRAMPED: f64 = 0.8;
/// Distance of the only face from the middle without cost, in widths of the crop: the first number times the aspect ratio
/// of the crop, at most the second number. A wide panel has room beside a person.
const CENTRED: (f64, f64) = (0.08, 0.17);
/// Cost of more distance, in widths of the crop.
const ASIDE: f64 = 1.5;
/// Room for a shoulder on each side of a face, in widths of the face, and the cost of a face without it.
const SHOULDER: f64 = 1.0;
const SHOULDER_COST: f64 = 0.6;
/// Cost of a person whose head the photo cuts.
const HEADLESS_COST: f64 = 1.5;
/// Cost of one edge through an area of average energy.
const CUT_COST: f64 = 0.022;

/// Scores the crops of one photo for one panel.
pub(super) struct Judge<'a> {
    view: &'a View<'a>,
    sums: Sums,
    /// The weight of each subject of the view; falls when the subject has been shown.
    weights: Vec<f64>,
    /// The role of each subject of the view.
    roles: Vec<Role>,
}

/// Role of a subject for the distance of the crop.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    /// A face that is not a false detection.
    Face,
    /// The body of a person whose face is known.
    Body,
    Other,
}

impl<'a> Judge<'a> {
    pub(super) fn new(photo: &PhotoMeta, view: &'a View<'a>) -> Self {
        let whole = view.width * view.height;
        let weight = |(area, subject): &(Area, Cow<Subject>)| {
            let size = (area.width * area.height / whole).sqrt();
            let kind = match subject.label.as_str() {
                FACE => 1.5,
                "person" => 1.0,
                "cat" | "dog" | "bird" | "horse" => 0.9,
                _ => 0.6,
            };
            kind * (0.2 + size) * subject.score.clamp(0.05, 1.0)
        };
        let weights = view.subjects.iter().map(weight).collect();
        let roles = view.subjects.iter().map(|(_, subject)| Role::of(subject, view)).collect();
        Self { view, sums: photo.energy.sums(), weights, roles }
    }

    /// Returns the candidates that break the fewest rules. The rules, in this order: the focus is visible, a face is included
    /// and none is cut. The same holds for heads, then for most of each head, and for heads of animals and of people without a
    /// known face. No animal is cut. If `wide`, the crop has enough of the photo. No subject is cut, and the enlargement is
    /// limited.
    pub(super) fn admitted(&self, candidates: Vec<Crop>, wide: bool) -> Vec<Crop> {
        let most = candidates.iter().map(|crop| crop.width * crop.height).fold(0.0, f64::max);
        let (faces, heads): (Vec<Area>, Vec<Area>) =
            (self.view.faces().collect(), self.view.heads().collect());
        let sure = self.view.subjects.iter().zip(&self.roles).filter(|(_, role)| **role == Role::Face);
        let tallest = sure.map(|((face, _), _)| face.height).fold(0.0, f64::max);
        let kept =
            if tallest > 0.0 && tallest < FACE_HEIGHT * self.view.height { CLOSE_KEPT } else { LEAST_KEPT };
        let least = if wide { kept.min(0.92 * most) } else { 0.0 };
        let animals: Vec<Area> = self.of_size(Subject::is_animal).map(|(_, grown)| grown).collect();
        let upper = |area: Area, part: f64| Area { height: part * area.height, ..area };
        let mut crowns: Vec<Area> = animals.iter().map(|area| upper(*area, CROWN)).collect();
        if faces.is_empty() {
            let people = self.of_size(|subject| subject.label == "person");
            crowns.extend(people.map(|(_, grown)| upper(grown, PERSON_HEAD)));
        }
        let most_of_heads = self.view.most_of_heads();
        let rules: [&dyn Fn(&Crop) -> bool; 10] = [
            &|crop| self.holds_focus(crop),
            &|crop| self.shows_focus(crop),
            &|crop| self.spares(crop, &faces),
            &|crop| self.spares(crop, &heads),
            &|crop| self.spares(crop, &most_of_heads),
            &|crop| self.spares(crop, &crowns),
            &|crop| self.spares(crop, &animals),
            &|crop| crop.width * crop.height >= least,
            &|crop| self.spares_subjects(crop),
            &|crop| self.enlargement(crop) <= MOST_ENLARGED,
        ];
        let mut rest = candidates;
        for rule in rules {
            let passed: Vec<Crop> = rest.iter().copied().filter(|crop| rule(crop)).collect();
            if !passed.is_empty() {
                rest = passed;
            }
        }
        rest
    }

    /// The subjects of a kind that are not too small, and their boxes with surroundings.
    fn of_size(&self, is: impl Fn(&Subject) -> bool) -> impl Iterator<Item = (Area, Area)> {
        let whole = self.view.width * self.view.height;
        let subjects = self.view.subjects.iter().zip(&self.view.grown);
        subjects
            .filter(move |((area, subject), _)| {
                is(subject.as_ref()) && area.width * area.height >= SOME_SIZE * whole
            })
            .map(|((area, _), grown)| (*area, *grown))
    }

    /// The part of the photo's energy that a crop holds, 0 to 1.
    pub(super) fn energy(&self, crop: &Crop) -> f64 {
        self.sums.share(crop)
    }

    /// The score; higher is better. `shown` are the crops of the photo that the page has already.
    pub(super) fn score(&self, crop: &Crop, shown: &[Crop]) -> f64 {
        let area = self.view.area(crop);
        let part = crop.width * crop.height;
        let (off_x, off_y) = (crop.x + crop.width / 2.0 - 0.5, crop.y + crop.height / 2.0 - 0.5);
        let mut score = self.sums.share(crop) - AREA_COST * part - 0.1 * (off_x * off_x + off_y * off_y);
        score -= CUT_COST * self.sums.cut(crop);
        score += 0.5 * (1.0 / self.enlargement(crop)).min(1.0);
        score += self.subjects(area);
        if let Some((x, y)) = self.view.focus {
            let (cx, cy) = (area.x + area.width / 2.0, area.y + area.height / 2.0);
            score += 1.5 * (1.0 - (x - cx).hypot(y - cy) / area.width.hypot(area.height));
        }
        let headless = self.view.headless.iter().map(|person| self.inside(area, *person)).fold(0.0, f64::max);
        score -= HEADLESS_COST * headless;
        let seen = shown.iter().map(|other| crop.overlap(other)).fold(0.0, f64::max);
        score - 1.5 * seen
    }

    /// Takes note that a crop is on the page, so that the next one prefers other subjects.
    pub(super) fn remember(&mut self, crop: &Crop) {
        let area = self.view.area(crop);
        for ((subject, _), weight) in self.view.subjects.iter().zip(&mut self.weights) {
            let size = subject.width * subject.height;
            if area.shared(*subject) > 0.7 * size && size > 0.03 * area.width * area.height {
                *weight *= 0.25;
            }
        }
    }

    /// Cover of the subjects by weight, comfort of their size, air round faces.
    fn subjects(&self, crop: Area) -> f64 {
        let total: f64 = self.weights.iter().sum();
        if total <= 0.0 {
            return 0.0;
        }
        let (mut cover, mut size, mut cut, mut off_line) = (0.0, 0.0f64, 0.0, 0.0f64);
        let mut cramped = None;
        let mut narrow = 0.0f64;
        let (mut faces, mut off_middle) = (0, 0.0f64);
        let mut face_height = 0.0f64;
        for (((area, subject), weight), role) in self.view.subjects.iter().zip(&self.weights).zip(&self.roles)
        {
            let inside = self.inside(crop, *area);
            // A bust is enough of a person.
            let shown = if *role == Role::Body { (inside / MEDIUM.0).min(1.0) } else { inside };
            cover += shown * weight / total;
            if *role == Role::Face && inside > 0.9 {
                face_height = face_height.max(area.height / crop.height);
                narrow = narrow.max(self.lacks_shoulder(crop, *area));
            }
            // A medium shot shows a part of a body.
            if inside > 0.9 || *role == Role::Body && inside >= MEDIUM.0 {
                size = size.max(inside * area.width * area.height / (crop.width * crop.height));
            }
            if subject.label == FACE {
                cut += f64::from(u8::from(self.view.cuts(crop, *area)));
                let level = (area.y + area.height / 2.0 - crop.y) / crop.height;
                let across = (area.x + area.width / 2.0 - crop.x) / crop.width;
                // In a circle the centre is what one sees.
                let off = if self.view.target.round {
                    9.0 * (level - 0.5).hypot(across - 0.5)
                } else {
                    (level - 0.42).abs()
                };
                off_line = off_line.max(inside * off);
                if inside > 0.9 {
                    faces += 1;
                    off_middle = (across + ROOM * subject.gaze() - 0.5).abs();
                }
                // The main face of the crop.
                if inside > 0.9 && cramped.is_none() && !self.view.target.round {
                    cramped = Some(cramping(subject.gaze(), across));
                }
            }
        }
        let say = (total / STRONG).min(1.0);
        let centred = (CENTRED.0 * crop.width / crop.height).min(CENTRED.1);
        let aside = if faces == 1 { (off_middle - centred).max(0.0) } else { 0.0 };
        let near = (face_height / FACE_HEIGHT).min(1.0) * (crop.width / CLOSE_WIDTH).min(1.0);
        say * (2.0 * cover + 0.6 * comfort(size)) + FACE_VALUE * near
            - 2.0 * cut
            - 0.4 * off_line
            - CRAMPED * cramped.unwrap_or(0.0)
            - ASIDE * aside
            - SHOULDER_COST * narrow
    }

    /// The part of a shoulder beside a face that a crop leaves out, 0 to 1, on the side that lacks more. What is outside
    /// the photo does not count.
    fn lacks_shoulder(&self, crop: Area, face: Area) -> f64 {
        let lacks = |seen: f64, there: f64| {
            let wanted = (SHOULDER * face.width).min(there);
            (wanted - seen).max(0.0) / (SHOULDER * face.width)
        };
        let (right, end) = (face.x + face.width, crop.x + crop.width);
        lacks(face.x - crop.x, face.x).max(lacks(end - right, self.view.width - right))
    }

    /// The part of a subject that the panel shows.
    fn inside(&self, crop: Area, subject: Area) -> f64 {
        if !self.view.target.region.is_plain() {
            return self.view.target.region.shares(View::within(crop, subject)).0.min(1.0);
        }
        if self.view.target.round {
            let (near, far) = reach(crop, subject);
            return ((1.0 - near) / (far - near).max(1e-9)).clamp(0.0, 1.0);
        }
        crop.shared(subject) / (subject.width * subject.height)
    }

    fn holds_focus(&self, crop: &Crop) -> bool {
        let area = self.view.area(crop);
        self.view.focus.is_none_or(|(x, y)| {
            let slack = 1e-9 * (self.view.width + self.view.height);
            let within = |at: f64, low: f64, side: f64| at >= low - slack && at <= low + side + slack;
            within(x, area.x, area.width) && within(y, area.y, area.height)
        })
    }

    /// The focus is not under another panel nor in a gutter.
    fn shows_focus(&self, crop: &Crop) -> bool {
        let area = self.view.area(crop);
        self.view.focus.is_none_or(|(x, y)| {
            let side = area.width.min(area.height) * 0.02;
            let spot = Area { x: x - side / 2.0, y: y - side / 2.0, width: side, height: side };
            self.view.target.region.is_plain()
                || self.view.target.region.shares(View::within(area, spot)).0 > 0.5
        })
    }

    /// No face cut, and at least one in the crop if the photo has any.
    fn spares(&self, crop: &Crop, faces: &[Area]) -> bool {
        if faces.is_empty() {
            return true;
        }
        let area = self.view.area(crop);
        let (mut cut, mut kept) = (false, false);
        for &face in faces {
            let cuts = self.view.cuts(area, face);
            cut |= cuts;
            kept |= !cuts && self.inside(area, face) > 0.95;
        }
        kept && !cut
    }

    /// Returns whether no large subject other than a face is cut, and at least one is included.
    fn spares_subjects(&self, crop: &Crop) -> bool {
        let area = self.view.area(crop);
        let whole = self.view.width * self.view.height;
        let (mut some, mut kept) = (false, false);
        for (((_, subject), grown), role) in self.view.subjects.iter().zip(&self.view.grown).zip(&self.roles)
        {
            if subject.label == FACE || subject.is_scenery() || grown.width * grown.height < SOME_SIZE * whole
            {
                continue;
            }
            let inside = self.inside(area, *grown);
            let medium = *role == Role::Body
                && (MEDIUM.0..MEDIUM.1).contains(&inside)
                && area.across(*grown) >= ACROSS;
            if inside > 0.05 && inside < 0.9 && !medium {
                return false;
            }
            some = true;
            kept |= medium || inside >= 0.9;
        }
        kept || !some
    }

    /// How much the panel enlarges the crop; at least a tiny number.
    fn enlargement(&self, crop: &Crop) -> f64 {
        let width = if self.view.target.width.is_finite() { self.view.target.width } else { 0.0 };
        (width / (crop.width * self.view.width)).max(1e-6)
    }
}

impl Role {
    fn of(subject: &Subject, view: &View) -> Self {
        let of = |label: &'static str| {
            view.subjects.iter().map(|(_, other)| other).filter(move |other| other.label == label)
        };
        match subject.label.as_str() {
            FACE if subject.score > SURE || of("person").any(|person| person.surrounds(subject)) => {
                Self::Face
            }
            "person" if of(FACE).any(|face| subject.surrounds(face)) => Self::Body,
            _ => Self::Other,
        }
    }
}

/// How much room is missing in front of a face, in widths of the crop, by its gaze and the position of its centre.
fn cramping(gaze: f64, across: f64) -> f64 {
    let wanted = 0.5 - ROOM * gaze;
    gaze.abs() * ((across - wanted) * gaze.signum()).max(0.0)
}

/// How well a subject of that share of the crop's area sits in it: lost below a tenth, at ease up to a half,
/// too close when it fills the crop.
fn comfort(share: f64) -> f64 {
    if share < 0.1 {
        share / 0.1
    } else if share < 0.5 {
        1.0
    } else {
        (1.0 - (share - 0.5) / 0.45).max(0.0)
    }
}
