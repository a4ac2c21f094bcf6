//! Rates the crop of a photo in a panel by its visible content.

use super::prepared::{Mark, Part, Prepared};
use super::slots::Slot;
use crate::framing::{Crop, MEDIUM, PhotoMeta, Region};
use crate::layout::Bounds;

/// The parts of a face, and of another subject, that make it count as cut.
const FACE_CUT: (f64, f64) = (0.08, 0.9);
const SUBJECT_CUT: (f64, f64) = (0.08, 0.82);
/// The part of a head without a known face that must be seen, its cost in cut faces, and the least part of the
/// photo that its body takes.
const HEAD_SEEN: f64 = 0.85;
const HEAD_CUT: f64 = 0.8;
const HEAD_BODY: f64 = 0.03;
/// The part of a photo that should be seen.
const KEPT: f64 = 0.62;
/// The part of a photo below which hardly anything of it is left.
const LITTLE: f64 = 0.4;
/// The most that a photo should be enlarged.
const ENLARGED: f64 = 2.5;
/// Height of a subject on the page, in page widths, below which it cannot be read, for faces and others.
const READABLE: (f64, f64) = (0.05, 0.055);
/// Minimum height of each face of a group on the page, in page widths. In a smaller face, a style loses the
/// features.
const GROUP_FACE: f64 = 0.05;
/// Minimum height of a face in a group, relative to the largest one. A smaller face is a passer-by.
const OF_THE_GROUP: f64 = 0.5;
/// Number of faces that make a photo a large group. It may lead although each person is small.
const LARGE_GROUP: usize = 5;
/// Total weight of the subjects at which they decide the result entirely.
const STRONG: f64 = 0.25;
/// The part of a head or of lettering that other panels must leave.
const SEEN: f64 = 0.9;
/// Minimum elongation of a strip (width over height, height over width), and the minimum part of a photo in it.
const STRIP: f64 = 2.4;
const STRIP_UPRIGHT: f64 = 2.6;
const STRIP_KEPT: f64 = 0.6;
/// Subjects below this part of the photo's area may be cut.
const SOME_SIZE: f64 = 0.01;

/// Visible content of a photo in a panel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Look {
    /// Visible part of the subjects, or of the image content, 0 to 1.
    pub cover: f64,
    /// Faces cut, counted up to 2.
    pub faces_cut: f64,
    /// Other subjects cut, by their share of all, 0 to 1.
    pub subjects_cut: f64,
    /// The part of the photo that is seen, 0 to 1.
    pub kept: f64,
    /// Page pixels per photo pixel.
    pub enlarged: f64,
    /// Shortfall of the size of the main subject, 0 to 1.
    pub too_small: f64,
    /// Sum of the shortfalls of small faces of a group, up to 3.
    pub small_faces: f64,
    /// Lack of content in an image that several panels share, 0 to 1.
    pub dull: f64,
    /// The part of the subjects that a gutter runs through, 0 to 1.
    pub split: f64,
    /// The part of the panel that the main subject takes; 0 without one.
    pub close: f64,
    /// The longer side of the largest animal, or person with a known face, as a part of that side of the panel: 0 without one,
    /// 1 for a large group.
    pub figure: f64,
    /// Faces, heads and lettering below other panels.
    pub hidden: f64,
    /// Whether it is a close-up of a face in a photo that another panel shows completely.
    pub near: bool,
    /// Whether the panel is a narrow strip that shows less than most of its photo.
    pub strip: bool,
}

impl Look {
    /// Looks at a crop that holds `energy` of the photo. In a `close` crop, other faces may be outside.
    #[must_use]
    pub fn at(slot: &Slot, prepared: &Prepared, crop: &Crop, energy: f64, close: bool) -> Self {
        let target = &slot.target;
        let seen = if target.round && target.region.is_plain() {
            std::f64::consts::FRAC_PI_4
        } else {
            target.region.seen()
        };
        let mut look = Self {
            kept: crop.width * crop.height * seen,
            enlarged: target.width / (crop.width * prepared.sides.0).max(1e-6),
            ..Self::default()
        };
        let mut worst = 0.0f64;
        let mut faces = Vec::new();
        let total: f64 = prepared.marks.iter().map(|mark| mark.weight).sum();
        let tallest = prepared
            .marks
            .iter()
            .filter(|mark| mark.part == Part::Face)
            .map(|mark| mark.bare.height)
            .fold(0.0, f64::max);
        let (mut cover, mut cut, mut split, mut heaviest) = (0.0, 0.0, 0.0, 0.0);
        for mark in &prepared.marks {
            let (grown, inner) = (place(crop, mark.grown), place(crop, mark.bare));
            let (all, most) = shares(slot, grown);
            // A medium shot cuts a body below the waist.
            let medium = mark.part == Part::Body && (MEDIUM.0..MEDIUM.1).contains(&all);
            cover += mark.weight * if mark.part == Part::Body { (all / MEDIUM.0).min(1.0) } else { all };
            if matches!(mark.part, Part::Face | Part::Lettering) && all < SEEN && under_others(slot, grown) {
                look.hidden += 1.0;
            }
            if matches!(mark.part, Part::Animal | Part::Body) {
                look.figure = look.figure.max(all * inner.width.max(inner.height));
            }
            if mark.part == Part::Face {
                let (bare, in_one) = shares(slot, inner);
                if bare > 0.8 {
                    faces.push(inner.height * slot.bounds.height);
                }
                // Only the face of a passer-by may be outside.
                let main = mark.bare.height >= OF_THE_GROUP * tallest;
                let missed = main && !close;
                let cut = in_one < FACE_CUT.1 && (missed || bare > FACE_CUT.0 || under_others(slot, inner));
                let head = 0.5 * f64::from(u8::from(most < 0.85 && all > FACE_CUT.0));
                look.faces_cut += if cut { 1.0 } else { head };
            } else if mark.bare.width * mark.bare.height >= SOME_SIZE
                && all > SUBJECT_CUT.0
                && most < SUBJECT_CUT.1
                && !medium
            {
                worst = mark.whole.max(worst);
                cut += mark.weight * mark.whole;
            }
            if let Some(head) = mark.head
                && all > SUBJECT_CUT.0
                && mark.bare.width * mark.bare.height >= HEAD_BODY
                && shares(slot, place(crop, head)).1 < HEAD_SEEN
            {
                look.faces_cut += HEAD_CUT;
            }
            // If a subject spreads over two windows of a merged panel, the gutter cuts it, even if most of it
            // is visible.
            if all > 0.3 && most < 0.85 * all && mark.whole > 0.0 {
                split += mark.weight;
            }
            if all > 0.8 && mark.weight > heaviest {
                heaviest = mark.weight;
                look.close = (inner.width * inner.height).min(1.0);
                let readable = if mark.part == Part::Face { READABLE.0 } else { READABLE.1 };
                let high = inner.height * slot.bounds.height;
                look.too_small = (1.0 - high / readable).max(0.0);
            }
        }
        if faces.len() >= LARGE_GROUP {
            look.figure = 1.0;
        }
        let say = (total / STRONG).min(1.0);
        let subjects = if total > 0.0 { cover / total } else { 0.0 };
        look.cover = say * subjects + (1.0 - say) * energy * seen.max(0.5);
        look.subjects_cut = if total > 0.0 { (cut / total).max(0.75 * worst) } else { 0.0 };
        look.faces_cut = look.faces_cut.min(2.0);
        look.near = close && !faces.is_empty();
        look.small_faces = small_faces(&faces);
        if !faces.is_empty() {
            // A crop that comes closer to a face leaves the rest out on purpose.
            let photo_aspect = prepared.sides.0 / prepared.sides.1;
            let widest = (target.aspect / photo_aspect).min(photo_aspect / target.aspect).min(1.0);
            look.kept = look.kept.max(widest * seen);
        }
        // Only a photo with important content should span several panels.
        look.dull = if slot.merged { (0.6 - prepared.care).max(0.0) } else { 0.0 };
        look.split = if total > 0.0 { split / total } else { 0.0 };
        if look.near {
            // Another panel shows the complete photo, so only the face counts.
            look.cover = 1.0;
        }
        look.strip = !look.near
            && (target.aspect > STRIP || target.aspect < 1.0 / STRIP_UPRIGHT)
            && look.kept < STRIP_KEPT;
        look
    }

    /// How well the photo sits, whatever the panel's size.
    #[must_use]
    pub fn fit(&self) -> f64 {
        let kept = if self.near { 1.0 } else { self.kept };
        let lacking = (KEPT - kept).max(0.0) / KEPT;
        let little = f64::from(u8::from(kept < LITTLE));
        let soft = (self.enlarged / ENLARGED).log2().max(0.0);
        let blown_up = f64::from(u8::from(self.enlarged > ENLARGED));
        self.cover
            - 2.0 * self.faces_cut
            - 2.2 * self.subjects_cut
            - 1.4 * lacking
            - 0.9 * little
            - 0.4 * soft
            - 5.0 * blown_up
            - 2.5 * self.split
            - 4.0 * self.hidden.min(1.0)
            - 2.0 * f64::from(u8::from(self.strip))
            - self.dull
            - 0.5 * self.too_small
            - 0.25 * self.small_faces
    }
}

/// Adapts the cached crop for the shape of the slot. If a part of the panel is hidden, the crop moves the
/// subjects to the visible part.
#[must_use]
pub fn placed(slot: &Slot, photo: &PhotoMeta, prepared: &Prepared) -> (Crop, Look) {
    let (crop, energy) = prepared.crop_for(photo, slot.target.aspect);
    let look = Look::at(slot, prepared, &crop, energy, false);
    if slot.target.region.is_plain() || prepared.marks.is_empty() {
        return (crop, look);
    }
    let heaviest = prepared.marks.iter().max_by(|a, b| a.weight.total_cmp(&b.weight));
    let all = prepared.marks.iter().map(|mark| mark.grown).reduce(Bounds::union);
    let goals = [all, heaviest.map(|mark: &Mark| mark.grown)];
    let mut best = (crop, look);
    for goal in goals.into_iter().flatten() {
        let core = slot.target.region.core();
        let middle = |at: f64, side: f64| at + side / 2.0;
        let x = middle(goal.x, goal.width) - middle(core.x, core.width) * crop.width;
        let y = middle(goal.y, goal.height) - middle(core.y, core.height) * crop.height;
        let moved = Crop {
            x: x.clamp(0.0, 1.0 - crop.width.min(1.0)),
            y: y.clamp(0.0, 1.0 - crop.height.min(1.0)),
            ..crop
        };
        let look = Look::at(slot, prepared, &moved, energy, false);
        if look.fit() > best.1.fit() {
            best = (moved, look);
        }
    }
    best
}

/// Returns the sum of the shortfalls of the faces of a group, by their heights on the page. A group has two
/// or more faces of similar size. One face has [`Look::too_small`].
fn small_faces(heights: &[f64]) -> f64 {
    let largest = heights.iter().copied().fold(0.0, f64::max);
    let group = heights.iter().filter(|height| **height >= OF_THE_GROUP * largest);
    if group.clone().count() < 2 {
        return 0.0;
    }
    group.map(|height| (1.0 - height / GROUP_FACE).max(0.0)).sum::<f64>().min(3.0)
}

/// A box of the photo in parts of the crop.
fn place(crop: &Crop, inner: Bounds) -> Bounds {
    Bounds {
        x: (inner.x - crop.x) / crop.width,
        y: (inner.y - crop.y) / crop.height,
        width: inner.width / crop.width,
        height: inner.height / crop.height,
    }
}

/// Returns whether a hidden box lies mostly within the panel.
fn under_others(slot: &Slot, inner: Bounds) -> bool {
    // Tested on the panel without hidden parts.
    !slot.target.region.is_plain() && Region::default().shares(inner).0 > 0.5
}

/// Returns the visible parts of a box: in all windows together, and in the window that shows most.
fn shares(slot: &Slot, inner: Bounds) -> (f64, f64) {
    let (all, most) = slot.target.region.shares(inner);
    if slot.target.round && slot.target.region.is_plain() {
        // The part of the box in the circle, by its farthest point, as heads are round.
        let (aspect, half) = (slot.target.aspect, (inner.width / 2.0, inner.height / 2.0));
        let off = (inner.x + half.0 - 0.5).hypot((inner.y + half.1 - 0.5) / aspect.max(1e-3));
        let reach = half.0.max(half.1 / aspect.max(1e-3));
        let part = ((0.5 - off + reach) / (2.0 * reach).max(1e-9)).clamp(0.0, 1.0);
        return (part.min(all), part.min(most));
    }
    (all.min(1.0), most.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framing::{FACE, Subject};
    use crate::layout::{PageSettings, find, resolve};
    use crate::plan::slots;

    #[test]
    fn a_face_under_an_inset_or_beyond_the_crop_is_cut_but_not_by_a_close_look() {
        let page = PageSettings::default();
        let slots =
            slots(&resolve(find("circle-corner").unwrap(), page.aspect(), &page), f64::from(page.width));
        let slot = slots.iter().find(|slot| !slot.target.region.is_plain()).unwrap();
        let face = (0..40).flat_map(|y| (0..40).map(move |x| (x, y))).find_map(|(x, y)| {
            let face = Bounds { x: 0.025 * f64::from(x), y: 0.025 * f64::from(y), width: 0.05, height: 0.05 };
            let hidden = face.x > 0.1 && face.x < 0.9 && slot.target.region.shares(face).0 == 0.0;
            hidden.then_some(face)
        });
        let face = face.unwrap();
        let mut photo = PhotoMeta::unmeasured("photo", 1000, (1000.0 / slot.target.aspect) as u32);
        let Bounds { x, y, width, height } = face;
        photo.find([Subject {
            label: FACE.into(),
            score: 0.95,
            x,
            y,
            width,
            height,
            points: None,
            expression: None,
            light: None,
        }]);
        let prepared = Prepared::of(&photo);
        let cut = |crop: Crop| Look::at(slot, &prepared, &crop, 1.0, false).faces_cut;
        assert!((cut(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 }) - 1.0).abs() < 1e-9);
        // The crop begins to the right of it, or ends to the left.
        let beyond = if face.x < 0.5 { face.x + face.width + 0.1 } else { 0.0 };
        let crop = Crop { x: beyond, y: 0.0, width: 0.35, height: 1.0 };
        assert!((cut(crop) - 1.0).abs() < 1e-9, "{crop:?} {face:?}");
        assert!(Look::at(slot, &prepared, &crop, 1.0, true).faces_cut.abs() < 1e-9);
        assert!(
            Look::at(slot, &prepared, &Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 }, 1.0, true).hidden
                > 0.9
        );
    }

    #[test]
    fn a_crop_that_cuts_the_head_of_an_animal_counts_as_a_cut_face() {
        let page = PageSettings::default();
        let slots = slots(&resolve(find("grid-4").unwrap(), page.aspect(), &page), f64::from(page.width));
        let cut = |label: &str, top: f64, with_face: bool| {
            let mut photo = PhotoMeta::unmeasured("photo", 1000, 1000);
            let body = Subject {
                label: label.into(),
                score: 0.95,
                x: 0.3,
                y: 0.1,
                width: 0.4,
                height: 0.8,
                points: None,
                expression: None,
                light: None,
            };
            let face = Subject { label: FACE.into(), y: 0.5, height: 0.2, ..body.clone() };
            photo.find([body].into_iter().chain(with_face.then_some(face)));
            let crop = Crop { x: 0.0, y: top, width: 1.0, height: 1.0 - top };
            Look::at(&slots[0], &Prepared::of(&photo), &crop, 1.0, false).faces_cut
        };
        assert!((cut("elephant", 0.2, false) - HEAD_CUT).abs() < 1e-9);
        assert!((cut("person", 0.2, false) - HEAD_CUT).abs() < 1e-9);
        assert!(cut("elephant", 0.05, false).abs() < 1e-9, "complete");
        assert!(cut("person", 0.2, true).abs() < 1e-9, "the face is known and complete");
        assert!(cut("bus", 0.2, false).abs() < 1e-9, "a thing has no head");
    }

    #[test]
    fn a_group_of_faces_is_worth_less_where_each_is_too_small() {
        let page = PageSettings::default();
        let slots = slots(&resolve(find("inset-two").unwrap(), page.aspect(), &page), f64::from(page.width));
        let whole = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let small = |slot: &Slot, heights: &[f64]| {
            let mut photo = PhotoMeta::unmeasured("photo", 1500, 1000);
            photo.find(heights.iter().enumerate().map(|(i, &height)| {
                let (label, x) = (FACE.into(), 0.1 + 0.2 * i as f64);
                Subject {
                    label,
                    score: 0.95,
                    x,
                    y: 0.15,
                    width: 0.1,
                    height,
                    points: None,
                    expression: None,
                    light: None,
                }
            }));
            Look::at(slot, &Prepared::of(&photo), &whole, 1.0, false).small_faces
        };
        let by_area = |a: &&Slot, b: &&Slot| a.area.total_cmp(&b.area);
        let (inset, large) = (slots.iter().min_by(by_area).unwrap(), slots.iter().max_by(by_area).unwrap());
        let face = 0.6 * GROUP_FACE / inset.bounds.height;
        let three = small(inset, &[face; 3]);
        assert!((three - 1.2).abs() < 0.01, "{three}");
        assert!(small(inset, &[face]).abs() < 1e-9, "one face has a rule of its own");
        let whole_group = small(large, &[1.3 * GROUP_FACE / large.bounds.height; 3]);
        assert!(whole_group.abs() < 1e-9, "{whole_group}");
        let passers_by = small(inset, &[3.0 * face, face, face]);
        assert!(passers_by.abs() < 1e-9, "{passers_by}");
    }
}
