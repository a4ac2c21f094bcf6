//! Placement rules of old pages, kept so that their text items do not move. A grid of positions in the panel
//! is tried, and the cheapest is used. The costs, from worst to mildest: another item is covered, a face is
//! covered, the item extends past a slanted panel, an object is covered, unusual positions.

use super::{INSET, Seen, center, contains, covered, gap, shared};
use crate::layout::{Bounds, Point, ResolvedShape};
use crate::page::words::layout::Laid;
use crate::page::words::model::{Kind, TextItem};

/// Places that are tried along each side of a panel.
const STEPS: usize = 9;
/// Default length of a tail without a face, in page widths.
const TAIL: f64 = 0.035;

/// Returns the position of a text item and the end of its tail. `spoken`: faces that already have a balloon.
/// This one is added.
pub(super) fn place(
    laid: &Laid,
    frame: Bounds,
    shape: Option<&ResolvedShape>,
    seen: &[Seen],
    taken: &[Bounds],
    spoken: &mut Vec<Point>,
) -> (Bounds, Option<Point>) {
    let speaker = speaker(&laid.word, seen, spoken);
    spoken.extend(speaker.map(center));
    let area = best(laid, frame, shape, seen, speaker, taken);
    let tip = matches!(laid.word.kind(), Kind::Balloon(_)).then(|| tip(area, speaker, seen, frame));
    (area, tip)
}

/// The speaking face: the one with the fewest balloons so far, from left to right.
fn speaker(word: &TextItem, seen: &[Seen], spoken: &[Point]) -> Option<Bounds> {
    if !matches!(word.kind(), Kind::Balloon(_)) {
        return None;
    }
    let said = |face: &Bounds| spoken.iter().filter(|point| center(*face).distance(**point) < 1e-6).count();
    let faces = seen.iter().filter(|seen| seen.face).map(|seen| seen.bounds);
    faces.min_by(|a, b| said(a).cmp(&said(b)).then(a.x.total_cmp(&b.x)))
}

/// Returns the best position in the frame, as the box of the text item.
fn best(
    laid: &Laid,
    frame: Bounds,
    shape: Option<&ResolvedShape>,
    seen: &[Seen],
    speaker: Option<Bounds>,
    taken: &[Bounds],
) -> Bounds {
    let Bounds { width, height, .. } = covered(laid);
    let places = |start: f64, length: f64, size: f64| {
        let room = length - size - 2.0 * INSET;
        (0..STEPS).map(move |i| {
            if room <= 0.0 {
                start + (length - size) / 2.0
            } else {
                start + INSET + room * i as f64 / (STEPS - 1) as f64
            }
        })
    };
    let size = frame.width.hypot(frame.height);
    let own = width * height;
    let cost = |place: &Bounds| {
        let middle = center(*place);
        let (right, low) =
            ((middle.x - frame.x) / frame.width.max(1e-9), (middle.y - frame.y) / frame.height.max(1e-9));
        let mut cost = 0.0;
        for other in taken {
            let wider = Bounds {
                x: other.x - INSET,
                y: other.y - INSET,
                width: other.width + 2.0 * INSET,
                height: other.height + 2.0 * INSET,
            };
            cost += 40.0 * shared(*place, wider) / own.min(other.width * other.height);
        }
        let mut nearest = size;
        for Seen { bounds, face, .. } in seen {
            let area = bounds.width * bounds.height;
            let part = shared(*place, *bounds) / own.min(area).max(1e-12);
            cost += if *face { 30.0 * part } else { 0.8 * part };
            if *face {
                nearest = nearest.min(gap(*place, *bounds));
            }
        }
        if let Some(shape) = shape {
            let corners = [(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (-0.8, 0.8)];
            let inside =
                |(x, y)| contains(shape, Point::new(middle.x + x * width / 2.0, middle.y + y * height / 2.0));
            cost += 8.0 * corners.into_iter().filter(|corner| !inside(*corner)).count() as f64;
        }
        let corner = right.min(1.0 - right).hypot(low.min(1.0 - low));
        cost + match laid.word.kind() {
            // The corner that is farthest from faces, or the upper left one without faces.
            Kind::Caption => 3.0 * corner - 2.0 * nearest / size + 0.3 * low + 0.1 * right,
            Kind::Balloon(_) => {
                let far = speaker.map_or(0.0, |face| gap(*place, face) / size);
                0.8 * low + 0.05 * right + (far - 0.06).abs()
            }
            Kind::Effect => (right - 0.5).hypot(low - 0.6) - 1.5 * nearest / size,
        }
    };
    let columns = places(frame.x, frame.width, width);
    let all = columns
        .flat_map(|x| places(frame.y, frame.height, height).map(move |y| Bounds { x, y, width, height }));
    let first = Bounds { x: frame.x, y: frame.y, width, height };
    all.map(|place| (cost(&place), place))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map_or(first, |(_, place)| place)
}

/// End of a balloon's tail: in front of the mouth of its speaker, or a short way towards the largest subject
/// in the panel.
fn tip(place: Bounds, speaker: Option<Bounds>, seen: &[Seen], frame: Bounds) -> Point {
    let from = center(place);
    let Some(face) = speaker else {
        let size = |seen: &&Seen| seen.bounds.width * seen.bounds.height;
        let largest =
            seen.iter().max_by(|a, b| size(a).total_cmp(&size(b))).map_or(frame, |seen| seen.bounds);
        let target = Point::new(largest.x + largest.width / 2.0, largest.y + 0.45 * largest.height);
        let (x, y) = (2.0 * (target.x - from.x) / place.width, 2.0 * (target.y - from.y) / place.height);
        let (distance, inside) = (from.distance(target).max(1e-6), x.hypot(y).max(1e-6));
        return from.toward(target, 1.0 / inside + TAIL / distance);
    };
    let mouth = Point::new(face.x + face.width / 2.0, face.y + 0.72 * face.height);
    let distance = from.distance(mouth);
    let short = 0.62 * face.width.min(face.height);
    from.toward(mouth, (1.0 - short / distance.max(1e-9)).max(0.5))
}
