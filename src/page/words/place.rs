//! Where a word goes by itself: away from faces and other words, a caption into a corner, a balloon near its speaker
//! with the tail to the face.
//!
//! A grid of places in the panel is tried, and the cheapest is taken. The costs say what is worst: another word is
//! covered, a face is covered, the word hangs out of a slanted panel, an object is covered; then what is usual.

use super::layout::{Ground, Laid, extent};
use super::letters::Letters;
use super::model::{Kind, Word};
use crate::error::Result;
use crate::framing::{Crop, FACE, Subject};
use crate::layout::{Bounds, Point, ResolvedShape};
use crate::page::Document;
use serde_json::{Value, json};

/// Places that are tried along each side of a panel.
const STEPS: usize = 9;
/// Length of a tail that no face asks for, in page widths.
const TAIL: f64 = 0.035;
/// Room between a word and the edge of its panel, in page widths.
const INSET: f64 = 0.008;

/// Something in a photo, where it is on the page.
#[derive(Clone, Copy)]
struct Seen {
    bounds: Bounds,
    face: bool,
}

/// Puts every word of a document that is placed by itself where it hides no face. `subjects` knows what is in a photo.
///
/// # Errors
/// `invalid-document` for a word that breaks its shape; those of the layout.
pub fn settle<'s>(
    document: &mut Document,
    subjects: impl Fn(&str) -> &'s [Subject],
    letters: &Letters,
) -> Result<()> {
    let words = Word::parse_all(&document.words)?;
    if !words.iter().any(|word| word.auto) {
        return Ok(());
    }
    let ground = Ground::new(document)?;
    // What a person has placed is there first.
    let mut taken: Vec<Bounds> = words
        .iter()
        .filter(|word| !word.auto)
        .map(|word| covered(&ground.lay(word.clone(), letters)))
        .collect();
    let mut spoken: Vec<Point> = Vec::new();
    for (i, word) in words.into_iter().enumerate().filter(|(_, word)| word.auto) {
        let frame = ground.frame(&word);
        let panel = word.panel.map(|panel| panel.min(ground.panels.len().saturating_sub(1)));
        let seen: Vec<Seen> = match panel {
            Some(panel) => seen_in(document, &ground, panel, &subjects),
            None => (0..ground.panels.len())
                .flat_map(|panel| seen_in(document, &ground, panel, &subjects))
                .collect(),
        };
        let laid = ground.lay(word, letters);
        let speaker = speaker(&laid.word, &seen, &spoken);
        spoken.extend(speaker.map(center));
        let shape = panel.and_then(|panel| ground.panels.get(panel)).map(|panel| &panel.shape);
        let area = best(&laid, frame, shape, &seen, speaker, &taken);
        let part = |at: Point| json!({ "x": rounded((at.x - frame.x) / frame.width), "y": rounded((at.y - frame.y) / frame.height) });
        let at = part(center(area));
        let tail = matches!(laid.word.kind, Kind::Balloon(_)).then(|| part(tip(area, speaker, &seen, frame)));
        taken.push(area);
        let value = &mut document.words[i];
        (value["x"], value["y"]) = (at["x"].clone(), at["y"].clone());
        value["tail"] = tail.unwrap_or(Value::Null);
        value["auto"] = json!(true);
    }
    Ok(())
}

/// Finer than any pixel, and short as text.
fn rounded(part: f64) -> f64 {
    (part * 1e5).round() / 1e5
}

fn center(bounds: Bounds) -> Point {
    Point::new(bounds.x + bounds.width / 2.0, bounds.y + bounds.height / 2.0)
}

fn covered(laid: &Laid) -> Bounds {
    let (a, b) = extent(&laid.word, &laid.setting);
    Bounds { x: laid.middle.x - a, y: laid.middle.y - b, width: 2.0 * a, height: 2.0 * b }
}

/// What is seen of the subjects in a panel.
fn seen_in<'s>(
    document: &Document,
    ground: &Ground,
    panel: usize,
    subjects: &impl Fn(&str) -> &'s [Subject],
) -> Vec<Seen> {
    let group = document.merge_of(panel).unwrap_or(&[]);
    let leader = group.first().copied().unwrap_or(panel);
    let Some(content) = document.panels.get(leader) else { return Vec::new() };
    let bounds = |panel: usize| ground.panels.get(panel).map(|panel| panel.bounds);
    let image = group.iter().filter_map(|&i| bounds(i)).reduce(Bounds::union).or_else(|| bounds(panel));
    let (Some(photo), Some(image), Some(own)) = (&content.photo, image, bounds(panel)) else {
        return Vec::new();
    };
    let crop = content.crop.unwrap_or(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 });
    let (across, down) = (image.width / crop.width, image.height / crop.height);
    let found = subjects(photo).iter().map(|subject| Seen {
        bounds: Bounds {
            x: image.x + (subject.x - crop.x) * across,
            y: image.y + (subject.y - crop.y) * down,
            width: subject.width * across,
            height: subject.height * down,
        },
        face: subject.label == FACE,
    });
    found.filter(|seen| shared(seen.bounds, own) > 0.3 * seen.bounds.width * seen.bounds.height).collect()
}

/// The area that two boxes share.
fn shared(a: Bounds, b: Bounds) -> f64 {
    let across = (a.x + a.width).min(b.x + b.width) - a.x.max(b.x);
    let down = (a.y + a.height).min(b.y + b.height) - a.y.max(b.y);
    across.max(0.0) * down.max(0.0)
}

/// How far apart two boxes are; 0 where they touch.
fn gap(a: Bounds, b: Bounds) -> f64 {
    let across = (a.x.max(b.x) - (a.x + a.width).min(b.x + b.width)).max(0.0);
    let down = (a.y.max(b.y) - (a.y + a.height).min(b.y + b.height)).max(0.0);
    across.hypot(down)
}

/// The face that says it: one that has said least so far, from left to right.
fn speaker(word: &Word, seen: &[Seen], spoken: &[Point]) -> Option<Bounds> {
    if !matches!(word.kind, Kind::Balloon(_)) {
        return None;
    }
    let said = |face: &Bounds| spoken.iter().filter(|point| center(*face).distance(**point) < 1e-6).count();
    let faces = seen.iter().filter(|seen| seen.face).map(|seen| seen.bounds);
    faces.min_by(|a, b| said(a).cmp(&said(b)).then(a.x.total_cmp(&b.x)))
}

/// The best place in the frame, as the box that the word covers there.
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
        for Seen { bounds, face } in seen {
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
        cost + match laid.word.kind {
            // The corner that is farthest from faces; the upper left one where there is none.
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

/// Whether a panel holds a point.
fn contains(shape: &ResolvedShape, point: Point) -> bool {
    match shape {
        ResolvedShape::Circle { center, radius } => center.distance(point) <= *radius,
        ResolvedShape::Polygon(points) => points
            .iter()
            .zip(points.iter().cycle().skip(1))
            .all(|(a, b)| (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x) >= -1e-9),
    }
}

/// Where the tail of a balloon ends: before the mouth of its speaker, or a little out of it towards what is largest in
/// the panel.
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
