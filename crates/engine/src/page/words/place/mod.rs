//! Automatic placement of text items, by the rules in `letterer`. They avoid the subjects of photos
//! (`figure`). The document stores positions as fractions of the panel's bounds.

mod figure;
mod letterer;

use super::layout::{Ground, Laid, extent, joined};
use super::letters::Letters;
use super::model::{Tail, TextItem};
use crate::error::Result;
use crate::framing::{Crop, FACE, LETTERING, PhotoMeta, Subject};
use crate::layout::{Bounds, Point, ResolvedPanel, ResolvedShape};
use crate::page::Document;
use crate::raster::Matte;
use figure::Figure;

/// Distance between a text item and the edge of its panel, in page widths.
const INSET: f64 = 0.008;

/// Number of sample points in each direction for the overlap of a text item with overlays.
const SAMPLES: usize = 8;

/// Minimum covered part of a face or text item at which a text item counts as in the way.
const FAR: f64 = 0.12;

/// If a box contains more than this part of a subject, it is the box of that subject. Then the mask replaces
/// it.
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

/// Class of a detected object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Class {
    Face,
    Person,
    Animal,
    Thing,
}

/// A detected object, in page coordinates.
#[derive(Debug, Clone, Copy)]
struct Seen {
    bounds: Bounds,
    class: Class,
    score: f64,
    /// The middle of its mouth.
    mouth: Point,
    /// Distance of its lips, in widths of the mouth; 0 if it is unknown.
    lips: f64,
    /// A mask covers it, so its box is not needed for the cover of text.
    masked: bool,
}

/// Content that text is placed around.
#[derive(Debug, Default)]
struct Scenery {
    seen: Vec<Seen>,
    /// The subjects of photos with masks.
    figures: Vec<Figure>,
}

/// Adds text items to a page. Items without a position are placed away from faces. `known` returns the
/// properties of a photo.
///
/// # Errors
/// As [`settle`].
pub fn add<'s>(
    document: &mut Document,
    words: Vec<TextItem>,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<()> {
    document.words = words;
    settle(document, known, letters)
}

/// Places every automatic text item of a document. Items hide no face, and as little of bodies as possible.
/// `known` returns the properties of a photo.
///
/// # Errors
/// `invalid-document` for an invalid text item; layout errors.
pub fn settle<'s>(
    document: &mut Document,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<()> {
    placed_on(document, known, letters, false)
}

/// As [`settle`], after a change of the layout. Text items that the user placed move too, if they now cover a face or are on
/// another panel. They stay close, and still count as placed by the user.
///
/// # Errors
/// As [`settle`].
pub fn resettle<'s>(
    document: &mut Document,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<()> {
    placed_on(document, known, letters, true)
}

/// Places an automatic text item at its earlier place after its text changed. It may grow from `before`, its earlier area, but
/// shares an edge or the middle with it. Returns false and changes nothing if the item would cover a face or another item, or
/// leave its panel.
///
/// # Errors
/// As [`settle`].
pub fn stay<'s>(
    document: &mut Document,
    index: usize,
    before: Bounds,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<bool> {
    let mut words = document.effective_words();
    if !words.get(index).is_some_and(TextItem::is_auto) {
        return Ok(false);
    }
    let ground = Ground::new(document)?;
    for (i, word) in words.iter_mut().enumerate() {
        word.auto = Some(i == index);
    }
    let scenery = scenery(document, &words[index], &ground, &known);
    let page = letterer::Page {
        joins: &joined(&words.iter()),
        taken: &fixed(&words, &ground, letters),
        words: &words,
        wanted: &[(index, center(before))],
        stays: Some(before),
        ground: &ground,
        letters,
    };
    let placed = letterer::place(page, &[index], &scenery);
    put(document, &placed, (&words, &ground), &[]);
    Ok(!placed.is_empty())
}

fn placed_on<'s>(
    document: &mut Document,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
    again: bool,
) -> Result<()> {
    let mut words = document.effective_words();
    if !again && !words.iter().any(TextItem::is_auto) {
        return Ok(());
    }
    let ground = Ground::new(document)?;
    let mut wanted: Vec<(usize, Point)> = Vec::new();
    if again {
        for (i, word) in words.iter().enumerate().filter(|(_, word)| !word.is_auto()) {
            let laid = ground.lay(word.clone(), letters);
            if is_in_the_way(covered(&laid), &scenery(document, word, &ground, &known), &above(word, &ground))
            {
                wanted.push((i, laid.middle));
            }
        }
        for (i, _) in &wanted {
            words[*i].auto = Some(true);
        }
        if !words.iter().any(TextItem::is_auto) {
            return Ok(());
        }
    }
    unlink(&mut words);
    // Items that the user placed come first.
    let mut taken = fixed(&words, &ground, letters);
    let mut all: Vec<Placed> = Vec::new();
    let joins = joined(&words.iter());
    for group in letterer::groups(&words, &ground) {
        let scenery =
            words.get(group[0]).map(|word| scenery(document, word, &ground, &known)).unwrap_or_default();
        let page = letterer::Page {
            words: &words,
            joins: &joins,
            taken: &taken,
            wanted: &wanted,
            stays: None,
            ground: &ground,
            letters,
        };
        let placed = letterer::place(page, &group, &scenery);
        taken.extend(placed.iter().map(|(i, place, _)| (*i, place.area)));
        all.extend(placed);
    }
    put(document, &all, (&words, &ground), &wanted);
    Ok(())
}

/// The index of a text item, its place, and the balloon that it is linked to.
type Placed = (usize, letterer::Place, Option<usize>);

/// Stores the places of text items. `wanted`: items that the user placed, which only move.
fn put(
    document: &mut Document,
    placed: &[Placed],
    (words, ground): (&[TextItem], &Ground),
    wanted: &[(usize, Point)],
) {
    for (i, place, _) in placed {
        let spot = fractions(ground.frame(&words[*i]), center(place.area), place.tip);
        let by_hand = wanted.iter().any(|(other, _)| other == i);
        let word = &mut document.words[*i];
        (word.x, word.y) = (Some(spot.x), Some(spot.y));
        word.tail = spot.tail.filter(|_| !by_hand || words[*i].tail.is_some());
        word.room = place.room.map(|(width, height)| (rounded(width), rounded(height)));
        word.linked = None;
        word.auto = Some(!by_hand);
    }
    for (later, before) in placed.iter().filter_map(|(i, _, link)| link.map(|to| (*i, to))) {
        let name = named(&mut document.words, before);
        document.words[later].linked = Some(name);
    }
}

/// The areas of the text items with a fixed position, with their indices.
fn fixed(words: &[TextItem], ground: &Ground, letters: &Letters) -> Vec<(usize, Bounds)> {
    let fixed = words.iter().enumerate().filter(|(_, word)| !word.is_auto());
    fixed.map(|(i, word)| (i, covered(&ground.lay(word.clone(), letters)))).collect()
}

/// The content of the panel of a text item, or of all panels.
fn scenery<'s>(
    document: &Document,
    word: &TextItem,
    ground: &Ground,
    known: &impl Fn(&str) -> Known<'s>,
) -> Scenery {
    let panels = match panel_of(word, ground) {
        Some(panel) => panel..panel + 1,
        None => 0..ground.panels.len(),
    };
    let mut scenery = Scenery::default();
    for panel in panels {
        see(document, ground, panel, known, &mut scenery);
    }
    scenery
}

/// A new place of a text item, in fractions of its frame.
struct Spot {
    x: f64,
    y: f64,
    tail: Option<Tail>,
}

/// Removes automatic links, except to balloons with a fixed position.
fn unlink(words: &mut [TextItem]) {
    let targets = joined(&words.iter());
    let free: Vec<bool> =
        targets.iter().map(|to| to.is_none_or(|to| words.get(to).is_none_or(TextItem::is_auto))).collect();
    for (word, free) in words.iter_mut().zip(free) {
        if word.is_auto() && free {
            word.linked = None;
        }
    }
}

/// The id of a text item for links, unique on the page.
fn named(words: &mut [TextItem], index: usize) -> String {
    let holder = |name: &str| words.iter().position(|word| word.id.as_deref() == Some(name));
    if let Some(own) = words[index].id.clone().filter(|name| holder(name) == Some(index)) {
        return own;
    }
    // One more name than text items, so that one is free.
    let free = (1..=words.len() + 1).map(|number| format!("b{number}")).find(|name| holder(name).is_none());
    let name = free.unwrap_or_default();
    words[index].id = Some(name.clone());
    name
}

/// The panel of a text item: the last one if the page has fewer.
fn panel_of(word: &TextItem, ground: &Ground) -> Option<usize> {
    word.panel.map(|panel| panel.min(ground.panels.len().saturating_sub(1)))
}

/// A place in fractions of a frame.
fn fractions(frame: Bounds, middle: Point, tip: Option<Point>) -> Spot {
    let part =
        |at: Point| (rounded((at.x - frame.x) / frame.width), rounded((at.y - frame.y) / frame.height));
    let (x, y) = part(middle);
    Spot { x, y, tail: tip.map(part).map(|(x, y)| Tail { x, y }) }
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

/// Adds the visible subjects and the mask of a panel.
fn see<'s>(
    document: &Document,
    ground: &Ground,
    panel: usize,
    known: &impl Fn(&str) -> Known<'s>,
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
    let mut figure = mask.and_then(|mask| Figure::of(mask, place(0.0, 0.0, 1.0, 1.0), own));
    for subject in subjects {
        let bounds = place(subject.x, subject.y, subject.width, subject.height);
        let seen = shared(bounds, own);
        if seen <= 0.3 * bounds.width * bounds.height {
            continue;
        }
        let class = match subject.label.as_str() {
            FACE => Class::Face,
            "person" => Class::Person,
            _ if subject.is_alive() => Class::Animal,
            _ => Class::Thing,
        };
        let held = figure.as_mut().filter(|figure| figure.inside(bounds) > SAME * seen);
        // Lettering in the photo is never a body.
        let masked = held.is_some() && class != Class::Face && subject.label != LETTERING;
        if let Some(figure) = held {
            figure.alive |= subject.is_alive();
        }
        let [x, y] = subject.mouth();
        let Bounds { x, y, .. } = place(x, y, 0.0, 0.0);
        let mouth = Point::new(x, y);
        let lips = subject.expression.map_or(0.0, |expression| expression.mouth.max(0.0));
        scenery.seen.push(Seen { bounds, class, score: subject.score, mouth, lips, masked });
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
    reaches(shape, point, 0.0)
}

/// Whether a panel with a ring around it holds a point.
fn reaches(shape: &ResolvedShape, point: Point, ring: f64) -> bool {
    match shape {
        ResolvedShape::Circle { center, radius } => center.distance(point) <= *radius + ring,
        ResolvedShape::Polygon(points) => points.iter().zip(points.iter().cycle().skip(1)).all(|(a, b)| {
            let inside = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
            inside >= -1e-9 - ring * a.distance(*b)
        }),
    }
}

/// Returns the panels above the panel of a text item.
fn above<'g>(word: &TextItem, ground: &'g Ground) -> Vec<&'g ResolvedPanel> {
    let own = panel_of(word, ground).unwrap_or(ground.panels.len());
    ground.panels.iter().skip(own + 1).filter(|panel| panel.overlay).collect()
}

/// Returns the part of a text item that is over other panels. Corners of a balloon are free.
fn hidden(area: Bounds, round: bool, above: &[&ResolvedPanel]) -> f64 {
    if above.is_empty() {
        return 0.0;
    }
    let (mut all, mut on_others) = (0.0, 0.0);
    for row in 0..SAMPLES {
        for column in 0..SAMPLES {
            let part = |at: usize| (at as f64 + 0.5) / SAMPLES as f64;
            let (x, y) = (part(column), part(row));
            if round && (2.0 * x - 1.0).abs().powf(2.4) + (2.0 * y - 1.0).abs().powf(2.4) > 1.0 {
                continue;
            }
            let point = Point::new(area.x + x * area.width, area.y + y * area.height);
            all += 1.0;
            on_others += f64::from(above.iter().any(|panel| reaches(&panel.shape, point, panel.halo)));
        }
    }
    on_others / f64::max(all, 1.0)
}

/// Returns whether a text item hides a face, or is over another panel.
fn is_in_the_way(area: Bounds, scenery: &Scenery, above: &[&ResolvedPanel]) -> bool {
    let faces = scenery.seen.iter().filter(|seen| seen.class == Class::Face).map(|seen| seen.bounds);
    let mut covers = faces.map(|face| shared(area, face) / (face.width * face.height).max(1e-12));
    hidden(area, true, above) > FAR || covers.any(|part| part > FAR)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framing::Expression;
    use crate::page::words::layout::measured;
    use serde_json::{Value, json};

    fn page(layout: &str, panels: usize, words: &Value, settings: &Value) -> Document {
        let photo = json!({ "photo": "a" });
        let value = json!({
            "version": 1, "seed": 1, "style": "noir", "merges": [], "order": ["a"], "words": words,
            "layout": layout, "panels": vec![photo; panels], "page": settings,
        });
        Document::parse(&value.to_string()).unwrap()
    }

    fn balloon(panel: usize, text: &str) -> Value {
        json!({ "kind": "balloon", "text": text, "panel": panel, "auto": true })
    }

    fn placed_words(document: &Document, letters: &Letters) -> Vec<(TextItem, Bounds)> {
        let ground = Ground::new(document).unwrap();
        let words = document.effective_words();
        words.into_iter().map(|word| (word.clone(), covered(&ground.lay(word, letters)))).collect()
    }

    #[test]
    fn text_stands_on_the_visible_part_of_its_panel() {
        let letters = Letters::bundled().unwrap();
        for layout in ["inset-middle-4", "circle-middle-4", "inset-corner"] {
            let panels = crate::layout::find(layout).unwrap().panels().len();
            let base = crate::layout::find(layout).unwrap().base_count();
            let words: Vec<Value> = (0..base)
                .flat_map(|panel| ["Over there, I said!", "Honk!"].map(|text| balloon(panel, text)))
                .collect();
            let mut document = page(layout, panels, &json!(words), &json!({ "forScreens": true }));
            settle(&mut document, |_| Known::default(), &letters).unwrap();
            let ground = Ground::new(&document).unwrap();
            for (word, area) in placed_words(&document, &letters) {
                let part = hidden(area, true, &above(&word, &ground));
                assert!(part <= 0.0, "{layout}, panel {:?}: {part} of {:?} is hidden", word.panel, word.text);
                let laid = ground.lay(word.clone(), &letters);
                let Some(tip) = laid.tip else { continue };
                let covers = |point: Point| {
                    above(&word, &ground).iter().any(|panel| reaches(&panel.shape, point, panel.halo))
                };
                assert!(!covers(tip), "{layout}, panel {:?}: the tail is on another panel", word.panel);
            }
        }
    }

    #[test]
    fn the_face_with_open_lips_speaks() {
        let letters = Letters::bundled().unwrap();
        let tip = |lips: [f64; 2]| {
            let face = |(x, mouth)| Subject {
                x,
                y: 0.4,
                width: 0.2,
                height: 0.25,
                label: FACE.to_owned(),
                score: 0.9,
                points: None,
                expression: Some(Expression { right_eye: 0.3, left_eye: 0.3, mouth, smile: 0.0 }),
                light: None,
            };
            let subjects = [face((0.15, lips[0])), face((0.65, lips[1]))];
            let mut document = page("splash", 1, &json!([balloon(0, "It was me!")]), &json!({}));
            settle(&mut document, |_| Known::from(&subjects[..]), &letters).unwrap();
            document.words[0].tail.unwrap().x
        };
        assert!(tip([0.5, 0.02]) < 0.45 && tip([0.02, 0.5]) > 0.55);
        // Nearly closed lips do not count.
        assert!((tip([0.0, 0.05]) - tip([0.05, 0.0])).abs() < 1e-9);
    }

    #[test]
    fn a_tail_stays_in_its_panel_if_the_crop_cuts_off_the_head() {
        let letters = Letters::bundled().unwrap();
        let person = Subject {
            x: 0.3,
            y: 0.1,
            width: 0.4,
            height: 0.9,
            label: "person".to_owned(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        };
        for (x, y) in [(0.0, 0.55), (0.55, 0.3), (0.0, 0.7)] {
            let mut document = page("grid-4", 4, &json!([balloon(0, "Hello!")]), &json!({}));
            document.panels[0].crop = Some(Crop { x, y, width: 1.0 - x, height: 1.0 - y });
            let subjects = [person.clone()];
            settle(&mut document, |_| Known::from(&subjects[..]), &letters).unwrap();
            let ground = Ground::new(&document).unwrap();
            let word = document.words[0].clone();
            let frame = ground.frame(&word);
            let Some(tip) = ground.lay(word, &letters).tip else { continue };
            let inside = |at: f64, start: f64, length: f64| at >= start && at <= start + length;
            assert!(
                inside(tip.x, frame.x, frame.width) && inside(tip.y, frame.y, frame.height),
                "{x} {y}: {tip:?} {frame:?}"
            );
        }
    }

    #[test]
    fn text_placed_by_hand_moves_off_a_face_only_when_the_layout_changes() {
        let letters = Letters::bundled().unwrap();
        let face = Subject {
            x: 0.35,
            y: 0.3,
            width: 0.3,
            height: 0.3,
            label: FACE.to_owned(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        };
        let subjects = [face];
        let known = |_: &str| Known::from(&subjects[..]);
        let by_hand = json!({
            "kind": "balloon", "text": "Hello!", "panel": 0, "auto": false, "x": 0.5, "y": 0.45,
        });
        let mut document = page("grid-4", 4, &json!([by_hand]), &json!({}));
        let before = document.words.clone();
        settle(&mut document, known, &letters).unwrap();
        assert_eq!(document.words, before);
        resettle(&mut document, known, &letters).unwrap();
        assert_eq!(document.words[0].auto, Some(false));
        assert_eq!(document.words[0].tail, None);
        let [(word, area)] = &placed_words(&document, &letters)[..] else { panic!() };
        let frame = Ground::new(&document).unwrap().frame(word);
        let seen = Bounds {
            x: frame.x + 0.35 * frame.width,
            y: frame.y + 0.3 * frame.height,
            width: 0.3 * frame.width,
            height: 0.3 * frame.height,
        };
        assert!(shared(*area, seen) <= 0.0, "{area:?} on {seen:?}");
        // Text that covers nothing stays.
        let again = document.words.clone();
        resettle(&mut document, known, &letters).unwrap();
        assert_eq!(document.words, again);
    }

    fn face(x: f64, y: f64, size: f64) -> Subject {
        Subject {
            x,
            y,
            width: size,
            height: 1.2 * size,
            label: FACE.to_owned(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        }
    }

    #[test]
    fn a_balloon_stays_while_its_text_grows_until_it_would_cover_a_face() {
        let letters = Letters::bundled().unwrap();
        let subjects = [face(0.55, 0.45, 0.25)];
        let known = |_: &str| Known::from(&subjects[..]);
        let mut document = page("splash", 1, &json!([balloon(0, "Look!")]), &json!({ "forScreens": true }));
        settle(&mut document, known, &letters).unwrap();
        let long = "There is something moving in the dark behind that door";
        let mut stays = 0;
        for count in 2..=10 {
            let before = placed_words(&document, &letters)[0].1;
            let text: Vec<&str> = long.split(' ').take(count).collect();
            document.words[0].text = text.join(" ");
            stays += usize::from(stay(&mut document, 0, before, known, &letters).unwrap());
            let (word, area) = &placed_words(&document, &letters)[0];
            assert!(
                shared(before, *area) > 0.8 * before.width * before.height,
                "{count}: {before:?} {area:?}"
            );
            assert!(word.tail.is_some() && word.is_auto());
        }
        assert_eq!(stays, 9);
        // There is no place for a novel next to the face.
        let (before, words) = (placed_words(&document, &letters)[0].1, document.words.clone());
        document.words[0].text = long.repeat(12);
        let moved = document.words.clone();
        assert!(!stay(&mut document, 0, before, known, &letters).unwrap());
        assert_eq!(document.words, moved);
        // An item that the user placed is not automatic.
        document.words = words;
        document.words[0].auto = Some(false);
        assert!(!stay(&mut document, 0, before, known, &letters).unwrap());
    }

    #[test]
    fn balloons_of_a_panel_point_at_its_faces_in_turn() {
        let letters = Letters::bundled().unwrap();
        let nearest = |document: &Document, faces: &[Subject]| -> Vec<usize> {
            let away =
                |tail: Tail, face: &Subject| (tail.x - face.mouth()[0]).hypot(tail.y - face.mouth()[1]);
            let face = |word: &TextItem| {
                let tail = word.tail.unwrap();
                (0..faces.len()).min_by(|&a, &b| away(tail, &faces[a]).total_cmp(&away(tail, &faces[b])))
            };
            document.words.iter().filter_map(face).collect()
        };
        let subjects = [face(0.1, 0.5, 0.22), face(0.65, 0.45, 0.26)];
        let known = |_: &str| Known::from(&subjects[..]);
        let named = |text: &str, by: &str| json!({ "kind": "balloon", "text": text, "panel": 0, "by": by });
        let cases = [
            (json!([balloon(0, "Did you hear that?"), balloon(0, "It came from below.")]), vec![0, 1]),
            (json!([named("Did you hear that?", "a"), named("It came from below.", "b")]), vec![0, 1]),
        ];
        for (words, expected) in cases {
            let mut document = page("splash", 1, &words, &json!({}));
            settle(&mut document, known, &letters).unwrap();
            assert_eq!(nearest(&document, &subjects), expected, "{words}");
        }
        let words = json!([named("Hear that?", "a"), named("Below.", "b"), named("Run!", "a")]);
        let mut document = page("splash", 1, &words, &json!({}));
        settle(&mut document, known, &letters).unwrap();
        let [one, two, three] = nearest(&document, &subjects)[..] else { panic!() };
        assert!(one != two && one == three, "{one} {two} {three}");
        // The second one is added later, after a balloon that points at the right or at the left face.
        for first in [0, 1] {
            let [x, y] = subjects[first].mouth();
            let fixed = json!({
                "kind": "balloon", "text": "Did you hear that?", "panel": 0, "auto": false,
                "x": 0.4 + 0.2 * first as f64, "y": 0.1, "tail": { "x": x, "y": y - 0.1 },
            });
            let mut document = page("splash", 1, &json!([fixed, balloon(0, "No.")]), &json!({}));
            settle(&mut document, known, &letters).unwrap();
            assert_eq!(nearest(&document, &subjects), [first, 1 - first]);
        }
    }

    #[test]
    fn a_new_balloon_can_be_read_on_screens() {
        let letters = Letters::bundled().unwrap();
        let size = |settings: Value| {
            let mut document =
                page("grid-6", 6, &json!([balloon(0, "Where have you been all day?")]), &settings);
            settle(&mut document, |_| Known::default(), &letters).unwrap();
            measured(&document, &letters).unwrap()[0].size
        };
        // 10 pixels on a page that is 435 pixels wide, and 10 points on A4.
        assert!(size(json!({ "forScreens": true })) * 435.0 >= 10.0);
        assert!((size(json!({})) * 210.0 / 25.4 * 72.0 - 10.0).abs() < 0.1);
    }
}
