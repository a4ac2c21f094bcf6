//! Automatic placement of text items.
//!
//! Items of old pages use the rules in `first`. Items of letterers use the rules in `letterer`, which avoid
//! the subjects of photos (`figure`) if masks exist. Both return fractions of the panel's bounds, which the
//! document stores.

mod figure;
mod first;
mod letterer;

use super::layout::{Ground, Laid, extent, joined};
use super::letters::Letters;
use super::model::{Craft, Word};
use crate::error::Result;
use crate::framing::{Crop, FACE, LETTERING, PhotoMeta, Subject};
use crate::layout::{Bounds, Point, ResolvedShape};
use crate::page::Document;
use crate::raster::Matte;
use figure::Figure;
use serde_json::{Value, json};

/// Room between a word and the edge of its panel, in page widths.
const INSET: f64 = 0.008;

/// A box that holds more of a figure than this part of it is the box of that figure: the mask says better where it is.
const SAME: f64 = 0.15;

/// Properties of a photo for placement.
#[derive(Debug, Clone, Copy, Default)]
pub struct Known<'s> {
    /// Lettering, faces and objects in it.
    pub subjects: &'s [Subject],
    /// Subject mask, after detection.
    pub mask: Option<&'s Matte>,
}

impl<'s> From<&'s [Subject]> for Known<'s> {
    fn from(subjects: &'s [Subject]) -> Self {
        Self { subjects, mask: None }
    }
}

impl<'s> From<&'s PhotoMeta> for Known<'s> {
    fn from(photo: &'s PhotoMeta) -> Self {
        Self { subjects: &photo.subjects, mask: photo.mask.as_ref() }
    }
}

/// Something in a photo, where it is on the page.
#[derive(Debug, Clone, Copy)]
struct Seen {
    bounds: Bounds,
    face: bool,
    person: bool,
    score: f64,
    /// A mask covers it, so its box is not needed for the cover of text.
    masked: bool,
}

/// Content that text is placed around.
#[derive(Debug, Default)]
struct Scenery {
    seen: Vec<Seen>,
    /// The figures of photos that have masks.
    figures: Vec<Figure>,
}

/// Adds text items to a page. Items without a position get the rules of letterers and are placed away from
/// faces. `known` returns the properties of a photo.
///
/// # Errors
/// As [`settle`].
pub fn add<'s>(
    document: &mut Document,
    words: Vec<Value>,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<()> {
    document.words = words;
    for word in document.words.iter_mut().filter_map(Value::as_object_mut) {
        if !["x", "y", "craft"].iter().any(|field| word.contains_key(*field)) {
            word.insert("craft".to_owned(), 2.into());
        }
    }
    settle(document, known, letters)
}

/// Places every automatic text item of a document. Items hide no face, and as little of bodies as possible.
/// `known` returns the properties of a photo. Items of old pages ignore masks, so their positions do not
/// change.
///
/// # Errors
/// `invalid-document` for an invalid text item; layout errors.
pub fn settle<'s>(
    document: &mut Document,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<()> {
    let mut words = Word::parse_all(&document.words)?;
    if !words.iter().any(|word| word.auto) {
        return Ok(());
    }
    unlink(&mut words);
    let ground = Ground::new(document)?;
    let scenery = |word: &Word| {
        let panels = match panel_of(word, &ground) {
            Some(panel) => panel..panel + 1,
            None => 0..ground.panels.len(),
        };
        let mut scenery = Scenery::default();
        for panel in panels {
            see(document, &ground, panel, &known, word.craft, &mut scenery);
        }
        scenery
    };
    // Items that the user placed come first.
    let mut taken: Vec<(usize, Bounds)> = words
        .iter()
        .enumerate()
        .filter(|(_, word)| !word.auto)
        .map(|(i, word)| (i, covered(&ground.lay(word.clone(), letters))))
        .collect();
    let mut spoken: Vec<Point> = Vec::new();
    let mut news: Vec<(usize, Value)> = Vec::new();
    for (i, word) in words.iter().enumerate().filter(|(_, word)| word.auto && word.craft == Craft::First) {
        let (frame, Scenery { seen, .. }) = (ground.frame(word), scenery(word));
        let shape =
            panel_of(word, &ground).and_then(|panel| ground.panels.get(panel)).map(|panel| &panel.shape);
        let laid = ground.lay(word.clone(), letters);
        let stands: Vec<Bounds> = taken.iter().map(|(_, area)| *area).collect();
        let (area, tip) = first::place(&laid, frame, shape, &seen, &stands, &mut spoken);
        taken.push((i, area));
        news.push((i, placed(frame, center(area), tip)));
    }
    let joins = joined(&words.iter());
    let mut links: Vec<(usize, usize)> = Vec::new();
    for group in letterer::groups(&words, &ground) {
        let scenery = words.get(group[0]).map(&scenery).unwrap_or_default();
        let page = letterer::Page { words: &words, joins: &joins, taken: &taken, ground: &ground, letters };
        for (i, place, link) in letterer::place(page, &group, &scenery) {
            let mut value = placed(ground.frame(&words[i]), center(place.area), place.tip);
            value["room"] = match place.room {
                Some((width, height)) => json!([rounded(width), rounded(height)]),
                None => Value::Null,
            };
            taken.push((i, place.area));
            news.push((i, value));
            links.extend(link.map(|to| (i, to)));
        }
    }
    for (i, value) in news {
        let word = &mut document.words[i];
        for name in ["x", "y", "tail", "room"] {
            if let Some(value) = value.get(name) {
                // Items without a room omit the field, for compatibility.
                if name == "room" && value.is_null() {
                    if let Some(fields) = word.as_object_mut() {
                        fields.remove(name);
                    }
                } else {
                    word[name] = value.clone();
                }
            }
        }
        if let Some(fields) = word.as_object_mut() {
            fields.remove("linked");
        }
        word["auto"] = json!(true);
    }
    for (later, before) in links {
        let name = named(&mut document.words, before);
        document.words[later]["linked"] = json!(name);
    }
    Ok(())
}

/// Removes automatic links, except to balloons with a fixed position.
fn unlink(words: &mut [Word]) {
    let targets = joined(&words.iter());
    let free: Vec<bool> =
        targets.iter().map(|to| to.is_none_or(|to| words.get(to).is_none_or(|to| to.auto))).collect();
    for (word, free) in words.iter_mut().zip(free) {
        if word.auto && free {
            word.linked = None;
        }
    }
}

/// The id of a text item for links, unique on the page.
fn named(words: &mut [Value], index: usize) -> String {
    let holder = |name: &str| words.iter().position(|word| word["id"] == name);
    let own = words[index]["id"].as_str().filter(|name| !name.is_empty());
    if let Some(own) = own.filter(|name| holder(name) == Some(index)) {
        return own.to_owned();
    }
    // There are as many names as words, and one more.
    let free = (1..=words.len() + 1).map(|number| format!("b{number}")).find(|name| holder(name).is_none());
    let name = free.unwrap_or_default();
    words[index]["id"] = json!(name);
    name
}

/// The panel of a text item: the last one if the page has fewer.
fn panel_of(word: &Word, ground: &Ground) -> Option<usize> {
    word.panel.map(|panel| panel.min(ground.panels.len().saturating_sub(1)))
}

/// Stored fields of a placement.
fn placed(frame: Bounds, middle: Point, tip: Option<Point>) -> Value {
    let part =
        |at: Point| (rounded((at.x - frame.x) / frame.width), rounded((at.y - frame.y) / frame.height));
    let (x, y) = part(middle);
    let tail = tip.map(part).map_or(Value::Null, |(x, y)| json!({ "x": x, "y": y }));
    json!({ "x": x, "y": y, "tail": tail })
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

/// Adds the visible subjects of a panel, and its figure for items with the rules of letterers.
fn see<'s>(
    document: &Document,
    ground: &Ground,
    panel: usize,
    known: &impl Fn(&str) -> Known<'s>,
    craft: Craft,
    scenery: &mut Scenery,
) {
    let group = document.merge_of(panel).unwrap_or(&[]);
    let leader = group.first().copied().unwrap_or(panel);
    let Some(content) = document.panels.get(leader) else { return };
    let bounds = |panel: usize| ground.panels.get(panel).map(|panel| panel.bounds);
    let image = group.iter().filter_map(|&i| bounds(i)).reduce(Bounds::union).or_else(|| bounds(panel));
    let (Some(photo), Some(image), Some(own)) = (&content.photo, image, bounds(panel)) else { return };
    let Known { subjects, mask } = known(photo);
    let crop = content.crop.unwrap_or(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 });
    let (across, down) = (image.width / crop.width, image.height / crop.height);
    let place = |x: f64, y: f64, width: f64, height: f64| Bounds {
        x: image.x + (x - crop.x) * across,
        y: image.y + (y - crop.y) * down,
        width: width * across,
        height: height * down,
    };
    let mut figure = mask
        .filter(|_| craft != Craft::First)
        .and_then(|mask| Figure::of(mask, place(0.0, 0.0, 1.0, 1.0), own));
    for subject in subjects {
        let bounds = place(subject.x, subject.y, subject.width, subject.height);
        let seen = shared(bounds, own);
        if seen <= 0.3 * bounds.width * bounds.height {
            continue;
        }
        let face = subject.label == FACE;
        let held = figure.as_mut().filter(|figure| figure.inside(bounds) > SAME * seen);
        // Lettering in the photo is never a body.
        let masked = held.is_some() && !face && subject.label != LETTERING;
        if let Some(figure) = held {
            figure.alive |= subject.is_alive();
        }
        let person = subject.label == "person";
        scenery.seen.push(Seen { bounds, face, person, score: subject.score, masked });
    }
    scenery.figures.extend(figure);
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
