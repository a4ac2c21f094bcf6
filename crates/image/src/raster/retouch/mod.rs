//! Manual corrections of a subject mask: strokes of a soft brush, a moved or softened border, and the choice
//! of one of several figures. All functions work on planes from 0 (outside the subject) to 255 (inside).
//! Lengths are in pixels of the plane.
//!
//! Sources: growing and shrinking are grey-scale dilation and erosion by a flat disc (Serra, "Image Analysis
//! and Mathematical Morphology", 1982). Figures are connected components with joined labels
//! ([`super::sets`]). Their soft borders come from flooding from all components at once (Meyer, "Topographic
//! distance and watershed lines", 1994, without heights).

mod session;
mod view;

pub use session::{Mending, Session};
pub use view::View;

use super::Plane;
use super::guided::softened;
use super::plane::neighbours;
use super::sets::Sets;
use std::cmp::Reverse;

/// From here on a pixel counts as the subject, as in [`super::matte`].
const WITHIN: u8 = 128;
/// Minimum value of the soft border of a figure.
const FAINT: u8 = 8;
/// The part of a brush's radius that paints in full at least.
const HARD: f32 = 0.6;
/// Pixels along which a brush fades at most: a wide border would count as unsure, and the whole mask as vague.
const SOFT: f32 = 4.0;

/// A soft round brush.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Brush {
    /// In pixels of the mask. Nothing changes outside of it.
    pub radius: f32,
    /// Whether it adds to the subject instead of removing from it.
    pub adds: bool,
}

impl Brush {
    /// How far from its path it paints in full.
    fn full(self) -> f32 {
        (self.radius - SOFT).max(HARD * self.radius)
    }

    /// Opacity of the brush at a distance from its path, 0 to 255: constant inside, then falling to 0 along a
    /// smooth curve.
    fn strength(self, distance: f32) -> u8 {
        let full = self.full();
        let beyond = (distance - full) / (self.radius - full);
        let fade = 1.0 - beyond.clamp(0.0, 1.0);
        (255.0 * fade * fade * (3.0 - 2.0 * fade)).round() as u8
    }

    /// Draws along a path of at least one point. Overlapping strokes do not add up, so a stroke may be drawn
    /// in pieces that share their ends.
    pub fn paint(self, mask: &mut Plane, path: &[[f32; 2]]) {
        if self.radius <= 0.0 || path.iter().flatten().any(|at| !at.is_finite()) {
            return;
        }
        if let [dot] = path {
            self.line(mask, *dot, *dot);
        }
        path.windows(2).for_each(|ends| self.line(mask, ends[0], ends[1]));
    }

    fn line(self, mask: &mut Plane, from: [f32; 2], to: [f32; 2]) {
        // Pixels that may be within reach, clipped to the mask.
        let reach = |axis: usize, length: usize| {
            let first = from[axis].min(to[axis]) - self.radius;
            let end = from[axis].max(to[axis]) + self.radius;
            (first.max(0.0) as usize)..(end.max(0.0).ceil() as usize).min(length)
        };
        let (across, down) = (reach(0, mask.width()), reach(1, mask.height()));
        for y in down {
            let row = mask.row_mut(y);
            for x in across.clone() {
                let strength = self.strength(distance([x as f32 + 0.5, y as f32 + 0.5], from, to));
                row[x] = if self.adds { row[x].max(strength) } else { row[x].min(255 - strength) };
            }
        }
    }
}

/// How far a point is from the line between two others.
fn distance(point: [f32; 2], from: [f32; 2], to: [f32; 2]) -> f32 {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let [px, py] = [point[0] - from[0], point[1] - from[1]];
    let along = ((px * dx + py * dy) / (dx * dx + dy * dy).max(f32::EPSILON)).clamp(0.0, 1.0);
    (px - along * dx).hypot(py - along * dy)
}

/// The mask with its border moved outward: of each pixel the most in a disc about it.
#[must_use]
pub fn grown(mask: &Plane, radius: f32) -> Plane {
    extreme(mask, radius, u8::max)
}

/// The mask with its border moved inward: of each pixel the least in a disc about it. The border does not
/// move inward at the edges of the photo, because the figure may continue there.
#[must_use]
pub fn shrunk(mask: &Plane, radius: f32) -> Plane {
    extreme(mask, radius, u8::min)
}

fn extreme(mask: &Plane, radius: f32, pick: fn(u8, u8) -> u8) -> Plane {
    let (width, height) = (mask.width(), mask.height());
    let reach = radius.max(0.0) as usize;
    let mut out = mask.clone();
    for dy in 0..=reach {
        // Half the width of the disc in rows at this distance.
        let half = (radius * radius - (dy * dy) as f32).max(0.0).sqrt() as usize;
        for y in 0..height {
            for from in [y.checked_sub(dy), Some(y + dy).filter(|from| *from < height)].into_iter().flatten()
            {
                let row = mask.row(from);
                let target = out.row_mut(y);
                for (x, best) in target.iter_mut().enumerate() {
                    let run = &row[x.saturating_sub(half)..(x + half + 1).min(width)];
                    *best = run.iter().fold(*best, |best, share| pick(best, *share));
                }
            }
        }
    }
    out
}

/// The mask with a softer border: the mean of windows twice, which is a tent.
#[must_use]
pub fn feathered(mask: &Plane, radius: usize) -> Plane {
    softened(&softened(mask, radius), radius)
}

/// Inverts the mask.
#[must_use]
pub fn inverted(mask: &Plane) -> Plane {
    mapped(mask, |_, share| 255 - share)
}

/// At each pixel the more of two masks of one size.
#[must_use]
pub fn joined(mask: &Plane, other: &Plane) -> Plane {
    mapped(mask, |at, share| share.max(other.samples()[at]))
}

/// Computes each value of a mask from its index and its old value.
fn mapped(mask: &Plane, share: impl Fn(usize, u8) -> u8) -> Plane {
    let mut out = mask.clone();
    out.samples_mut().iter_mut().enumerate().for_each(|(at, sample)| *sample = share(at, *sample));
    out
}

/// The connected components of a mask, each with the soft border around it.
pub struct Figures {
    /// Number of the figure of each pixel; [`NONE`] outside all figures.
    labels: Vec<u32>,
    /// Pixels of each figure.
    areas: Vec<usize>,
}

/// Label of pixels outside all figures.
const NONE: u32 = u32::MAX;

impl Figures {
    /// Finds the subjects of a mask. Subject 0 is the largest. Among equal ones, the one with the higher top
    /// comes first.
    #[must_use]
    pub fn of(mask: &Plane) -> Self {
        let mut labels = vec![NONE; mask.samples().len()];
        let mut sets = Sets::default();
        let width = mask.width();
        for (at, _) in mask.samples().iter().enumerate().filter(|(_, share)| **share >= WITHIN) {
            let left = (at % width > 0).then(|| labels[at - 1]).filter(|label| *label != NONE);
            let above = at.checked_sub(width).map(|at| labels[at]).filter(|label| *label != NONE);
            labels[at] = match (left, above) {
                (Some(left), Some(above)) => sets.join(left, above),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => sets.add(),
            };
        }
        let mut areas = vec![0; sets.len()];
        for label in labels.iter_mut().filter(|label| **label != NONE) {
            *label = sets.root(*label);
            areas[*label as usize] += 1;
        }
        let mut order: Vec<usize> = (0..areas.len()).filter(|label| areas[*label] > 0).collect();
        order.sort_by_key(|label| Reverse(areas[*label]));
        let mut numbers = vec![NONE; areas.len()];
        order.iter().enumerate().for_each(|(number, label)| numbers[*label] = number as u32);
        labels.iter_mut().filter(|label| **label != NONE).for_each(|label| *label = numbers[*label as usize]);
        flood(mask, &mut labels);
        Self { labels, areas: order.into_iter().map(|label| areas[label]).collect() }
    }

    /// The pixels of each, from the largest on.
    #[must_use]
    pub fn areas(&self) -> &[usize] {
        &self.areas
    }

    /// Number of the figure at a pixel, or `None` outside all figures.
    #[must_use]
    pub fn at(&self, pixel: usize) -> Option<usize> {
        self.labels.get(pixel).filter(|label| **label != NONE).map(|label| *label as usize)
    }

    /// Returns the mask with only the wanted figures. `mask` must be the mask in which the figures were
    /// found.
    #[must_use]
    pub fn only(&self, mask: &Plane, wanted: impl Fn(usize) -> bool) -> Plane {
        mapped(mask, |at, share| if self.at(at).is_some_and(&wanted) { share } else { 0 })
    }
}

/// Assigns faint pixels to the closest figure, through faint pixels.
fn flood(mask: &Plane, labels: &mut [u32]) {
    let size = (mask.width(), mask.height());
    let mut front: Vec<usize> = (0..labels.len()).filter(|at| labels[*at] != NONE).collect();
    while !front.is_empty() {
        let mut next = Vec::new();
        for at in front {
            for beside in neighbours(at, size) {
                if labels[beside] == NONE && mask.samples()[beside] >= FAINT {
                    labels[beside] = labels[at];
                    next.push(beside);
                }
            }
        }
        front = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Discs of given middles and radii, with a border of a pixel.
    fn discs(discs: &[(f32, f32, f32)]) -> Plane {
        Plane::from_fn(80, 60, |x, y| {
            let share = |(cx, cy, r): &(f32, f32, f32)| {
                let far = (x as f32 + 0.5 - cx).hypot(y as f32 + 0.5 - cy);
                ((r - far + 0.5).clamp(0.0, 1.0) * 255.0) as u8
            };
            discs.iter().map(share).max().unwrap_or_default()
        })
    }

    fn area(mask: &Plane) -> usize {
        mask.samples().iter().filter(|share| **share >= WITHIN).count()
    }

    proptest! {
        #[test]
        fn paint_stays_within_its_radius(
            ends in prop::array::uniform4(-20.0f32..100.0),
            radius in 0.5f32..30.0,
            adds: bool,
        ) {
            let before = discs(&[(40.0, 30.0, 20.0)]);
            let mut after = before.clone();
            let [from, to] = [[ends[0], ends[1]], [ends[2], ends[3]]];
            let brush = Brush { radius, adds };
            brush.paint(&mut after, &[from, to]);
            for (at, (was, is)) in before.samples().iter().zip(after.samples()).enumerate() {
                let far = distance([(at % 80) as f32 + 0.5, (at / 80) as f32 + 0.5], from, to);
                let grows = if adds { is >= was } else { is <= was };
                prop_assert!(grows);
                prop_assert!(far < radius || is == was, "{far} of {radius}");
                let full = if adds { 255 } else { 0 };
                prop_assert!(far > brush.full() || *is == full, "{far} of {radius}: {is}");
            }
        }

        #[test]
        fn growing_and_then_shrinking_keeps_what_was_there(
            x in 0.0f32..80.0,
            y in 0.0f32..60.0,
            radius in 2.0f32..25.0,
            by in 0.5f32..6.0,
        ) {
            let mask = discs(&[(x, y, radius)]);
            let (larger, smaller) = (grown(&mask, by), shrunk(&mask, by));
            let closed = shrunk(&larger, by);
            let opened = grown(&smaller, by);
            for at in 0..mask.samples().len() {
                let of = |plane: &Plane| plane.samples()[at];
                prop_assert!(of(&smaller) <= of(&mask) && of(&mask) <= of(&larger));
                // Closing never takes away, opening never adds.
                prop_assert!(of(&opened) <= of(&mask) && of(&mask) <= of(&closed));
            }
            let middle = (y as usize).min(59) * 80 + (x as usize).min(79);
            prop_assert_eq!(closed.samples()[middle], mask.samples()[middle]);
        }

        #[test]
        fn figures_are_parts_of_the_mask_that_give_it_together(
            all in prop::collection::vec((0.0f32..80.0, 0.0f32..60.0, 2.0f32..12.0), 0..5),
        ) {
            let mask = discs(&all);
            let figures = Figures::of(&mask);
            let mut together = Plane::filled(80, 60, 0);
            for number in 0..figures.areas().len() {
                let one = figures.only(&mask, |other| other == number);
                prop_assert_eq!(area(&one), figures.areas()[number]);
                prop_assert_eq!(Figures::of(&one).areas().len(), 1);
                together = joined(&together, &one);
            }
            prop_assert!(figures.areas().is_sorted_by(|a, b| a >= b));
            // Faint pixels without a connection to a figure are lost.
            for (was, is) in mask.samples().iter().zip(together.samples()) {
                prop_assert!(is == was || *was < WITHIN && *is == 0, "{was} {is}");
            }
        }
    }

    #[test]
    fn a_stroke_in_pieces_is_the_stroke() {
        let path: Vec<[f32; 2]> = (0..9).map(|i| [8.0 * i as f32, 30.0 + 12.0 * (i as f32).sin()]).collect();
        let brush = Brush { radius: 7.0, adds: true };
        let mut whole = Plane::filled(80, 60, 0);
        let mut pieces = whole.clone();
        brush.paint(&mut whole, &path);
        path.windows(2).for_each(|piece| brush.paint(&mut pieces, piece));
        assert_eq!(whole, pieces);
        // An invalid position paints nothing.
        brush.paint(&mut pieces, &[[f32::NAN, 3.0]]);
        Brush { radius: 0.0, ..brush }.paint(&mut pieces, &path);
        assert_eq!(whole, pieces);
    }

    #[test]
    fn a_border_moves_by_the_distance_that_is_told() {
        let mask = discs(&[(40.0, 30.0, 12.0)]);
        for (moved, radius) in [(grown(&mask, 4.0), 16.0f64), (shrunk(&mask, 4.0), 8.0)] {
            let expected = std::f64::consts::PI * radius * radius;
            assert!((area(&moved) as f64 / expected - 1.0).abs() < 0.08, "{} of {expected}", area(&moved));
        }
        // A figure that the photo cuts off stays at the photo's edge.
        let cut = discs(&[(0.0, 30.0, 20.0)]);
        assert_eq!(shrunk(&cut, 4.0).at(0, 30), 255);
        assert_eq!((grown(&mask, 0.0), shrunk(&mask, 0.0)), (mask.clone(), mask));
    }

    #[test]
    fn feathering_softens_and_keeps_the_area_and_inverting_twice_is_nothing() {
        let mask = discs(&[(40.0, 30.0, 16.0)]);
        let soft = feathered(&mask, 3);
        let unsure = |mask: &Plane| mask.samples().iter().filter(|share| (26..230).contains(*share)).count();
        assert!(unsure(&soft) > 3 * unsure(&mask), "{} {}", unsure(&soft), unsure(&mask));
        assert!((area(&soft) as f64 / area(&mask) as f64 - 1.0).abs() < 0.05);
        assert_eq!((soft.at(40, 30), soft.at(2, 2)), (255, 0));
        assert_eq!(inverted(&inverted(&soft)), soft);
    }

    #[test]
    fn a_figure_takes_its_own_border_with_it() {
        let mask = feathered(&discs(&[(20.0, 30.0, 12.0), (60.0, 30.0, 9.0)]), 2);
        let figures = Figures::of(&mask);
        assert_eq!(figures.areas().len(), 2);
        assert_eq!(
            (figures.at(30 * 80 + 20), figures.at(30 * 80 + 60), figures.at(0)),
            (Some(0), Some(1), None)
        );
        let right = figures.only(&mask, |number| number == 1);
        assert_eq!(right.at(20, 30), 0);
        for x in 45..80 {
            let share = mask.at(x, 30);
            assert_eq!(right.at(x, 30), if share < FAINT { 0 } else { share });
        }
    }
}
