//! Selects styles that preserve the content of the photos. Each style has a mark and a tone curve, so that a
//! night scene does not become a black page.

use std::sync::OnceLock;

use super::slots::{Assignment, Slot};
use crate::framing::{FACE, Facts, PhotoMeta};
use crate::style::Style;
use crate::style::context::scale_of;
use crate::style::file::Step;
use inkpanel_model::choice::Taste;

/// A line per style, best first: its id, its mark, the luma that it makes of each sixteenth of luma, two
/// hexadecimal digits each, and its uses. The marks are manual ratings from 0 to 10, on faces, groups and
/// animals that are not in the repository. `first` is for the first page. The example
/// `style_tones` writes the third column.
const MARKS: &str = include_str!("marks.txt");

/// Styles that the first page is drawn from.
#[cfg(test)]
const FIRST: usize = 20;
/// Mark of an unrated style.
const USUAL: f64 = 6.5;
/// Minimum mark of a style in a random choice. Styles with lower marks need a request for their family.
const LEAST: f64 = 7.0;
/// How fast weight grows with liking.
const GROWTH: f64 = 0.75;
/// Luma below and above which there is only ink, or only paper.
const ENDS: (u8, u8) = (20, 236);
/// The part of a page that may be blank or black.
const MOST_BLANK: f64 = 0.6;
/// Number of dark tones, in sixteenths of luma, and the middle tones that turn them into haze.
const DARK: usize = 4;
const HAZE: std::ops::RangeInclusive<u8> = 72..=150;
/// The part of a page that may be hazy, and the loss of a page that is hazy all over.
const MOST_HAZY: f64 = 0.1;
const HAZY: f64 = 4.0;
/// The least standard deviation of tones, 0 to 1.
const LEAST_SPREAD: f64 = 0.15;
/// Cells of a screen or pattern that a face has to be high.
const CELLS: f64 = 14.0;
/// Pixels of a cell of a pattern at scale 1.
const PATTERN_CELL: f32 = 5.0;
/// Smallest areas of a style that a face has to be high. Faces are drawn with half of them, see [`crate::style::faces`].
const AREAS: f64 = 6.0;
/// Block, parameter, and the side of the smallest area that it leaves, in parts of the parameter.
const AREA: &[(&str, &str, f32)] = &[
    ("flatten", "detail", 1.0),
    ("kuwahara", "radius", 1.6),
    ("painter", "brush", 3.0),
    ("tvf", "time", 0.3),
    ("etf", "sigma", 2.0),
    ("flow_lines", "sigma", 5.0),
    ("xdog", "sigma", 5.0),
    ("engrave", "pitch", 2.5),
    ("strokes", "width", 4.0),
];
/// Share of edges above which dots and hatching become unclear.
const ROUGH: f64 = 0.3;

/// Content of a page that a style could hide.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Shown {
    /// The share of each sixteenth of luma; `None` if no photo was measured.
    tones: Option<[f64; 16]>,
    /// The mean share of edges between neighbours.
    texture: f64,
    /// Heights of faces, in page widths.
    face: Option<f64>,
    /// Pixels of a page as wide as 1 for a pixel of a style, over the page's pixels.
    scale: f64,
}

impl Shown {
    /// Measures the content of the slots of a page.
    #[must_use]
    pub fn of(slots: &[Slot], panels: &[Assignment], photos: &[PhotoMeta], page_aspect: f64) -> Self {
        let (mut tones, mut texture, mut area) = ([0.0; 16], 0.0, 0.0);
        let mut face: Option<f64> = None;
        for (slot, panel) in slots.iter().zip(panels) {
            let photo = &photos[panel.photo];
            if let Some(Facts { tones: counted, edges, .. }) = &photo.facts {
                for (sum, &count) in tones.iter_mut().zip(counted) {
                    *sum += slot.area * f64::from(count) / 255.0;
                }
                texture += slot.area * f64::from(edges[0]) / 255.0;
                area += slot.area;
            }
            // The main face of each panel must be recognisable. Faces in a crowd are optional.
            let faces = photo.subjects.iter().filter(|s| s.label == FACE);
            let highest =
                faces.map(|s| s.height / panel.crop.height * slot.bounds.height).fold(0.0, f64::max);
            if highest > 0.0 {
                face = Some(face.map_or(highest, |least| least.min(highest)));
            }
        }
        // The scale of a style follows the mean panel of the page.
        let scale = f64::from(scale_of(1.0 / page_aspect.max(0.05) / slots.len().max(1) as f64));
        let tones = (area > 0.0).then(|| tones.map(|sum| sum / area));
        Self { tones, texture: if area > 0.0 { texture / area } else { 0.0 }, face, scale }
    }
}

struct Look {
    id: &'static str,
    rating: f64,
    response: Option<[u8; 16]>,
    /// The keywords after the tone curve.
    uses: &'static str,
}

fn looks() -> &'static [Look] {
    static READ: OnceLock<Vec<Look>> = OnceLock::new();
    READ.get_or_init(|| {
        let line = |line: &'static str| {
            let mut words = line.splitn(4, ' ');
            let (id, rating) = (words.next()?, serde_json::from_str::<f64>(words.next()?).ok()?);
            let response = words.next().and_then(response);
            Some(Look { id, rating, response, uses: words.next().unwrap_or_default() })
        };
        MARKS.lines().filter_map(line).collect()
    })
}

fn look(id: &str) -> Option<&'static Look> {
    looks().iter().find(|look| look.id == id)
}

fn response(digits: &str) -> Option<[u8; 16]> {
    let mut response = [0; 16];
    for (i, value) in response.iter_mut().enumerate() {
        *value = u8::from_str_radix(digits.get(2 * i..2 * i + 2)?, 16).ok()?;
    }
    Some(response)
}

/// Returns the mark of a style, 0 to 10, if it is rated.
#[must_use]
pub fn rating(id: &str) -> Option<f64> {
    look(id).map(|look| look.rating)
}

/// The uses of a style, as `MARKS` has them.
#[must_use]
pub fn uses(id: &str) -> &'static str {
    look(id).map_or("", |look| look.uses)
}

fn is_for(id: &str, wanted: &str) -> bool {
    uses(id).split(' ').any(|word| word == wanted)
}

/// Whether the first page may have the style.
#[must_use]
pub fn is_for_first_page(id: &str) -> bool {
    is_for(id, "first")
}

/// Returns the weight of a custom style.
#[must_use]
pub fn weight_of_own(id: &str, taste: &Taste) -> f64 {
    (GROWTH * (7.0 - USUAL)).exp() * Taste::factor(&taste.styles, id)
}

/// Whether the mark of a style is too low for chance.
#[must_use]
pub fn is_retired(id: &str) -> bool {
    rating(id).is_some_and(|rating| rating < LEAST)
}

/// The weight of a designed style on a page: its mark, less what it would lose of the photos.
#[must_use]
pub fn weight(style: &Style, page: &Shown, taste: &Taste) -> f64 {
    let look = look(&style.id);
    let rating = look.map_or(USUAL, |look| look.rating);
    let response = look.and_then(|look| look.response.as_ref());
    let loss = tonal_loss(response, page) + cell_loss(style, page) + area_loss(style, page);
    (GROWTH * (rating - USUAL) - loss).exp() * Taste::factor(&taste.styles, &style.id)
}

fn tonal_loss(response: Option<&[u8; 16]>, page: &Shown) -> f64 {
    let (Some(response), Some(tones)) = (response, &page.tones) else { return 0.0 };
    let total: f64 = tones.iter().sum::<f64>().max(1e-9);
    let pairs = || response.iter().zip(tones).map(|(&to, share)| (to, share / total));
    let share = |lost: &dyn Fn(u8) -> bool| -> f64 {
        pairs().filter(|(to, _)| lost(*to)).map(|(_, share)| share).sum()
    };
    let blank = share(&|to| to > ENDS.1).max(share(&|to| to < ENDS.0));
    let level = |to: u8| f64::from(to) / 255.0;
    let mean: f64 = pairs().map(|(to, share)| level(to) * share).sum();
    let spread = pairs().map(|(to, share)| (level(to) - mean).powi(2) * share).sum::<f64>().sqrt();
    // A style that draws blacks in a middle grey makes dark photos dull.
    let haze: f64 = pairs().take(DARK).filter(|(to, _)| HAZE.contains(to)).map(|(_, share)| share).sum();
    4.0 * (blank - MOST_BLANK).max(0.0) / (1.0 - MOST_BLANK)
        + HAZY * (haze - MOST_HAZY).max(0.0)
        + 3.0 * (LEAST_SPREAD - spread).max(0.0) / LEAST_SPREAD
}

fn cell_loss(style: &Style, page: &Shown) -> f64 {
    let Some(cell) = cell(style) else { return 0.0 };
    let rough = 6.0 * (page.texture - ROUGH).max(0.0);
    let small = page.face.map_or(0.0, |face| {
        let cells = face / (cell * page.scale).max(1e-9);
        (CELLS / cells.max(1.0) - 1.0).clamp(0.0, 2.5)
    });
    rough + small
}

/// Loss of a face in areas as large as its features.
fn area_loss(style: &Style, page: &Shown) -> f64 {
    let (Some(face), Some(area)) = (page.face, area(style)) else { return 0.0 };
    let areas = face / (area * page.scale).max(1e-9);
    (AREAS / areas.max(1.0) - 1.0).clamp(0.0, 2.5)
}

/// The blocks of both layers that run.
fn steps(style: &Style) -> impl Iterator<Item = &Step> {
    style.background.iter().chain(style.foreground.iter().flatten()).filter(|step| !step.bypass)
}

fn value(step: &Step, id: &str) -> Option<f32> {
    let at = step.block.params.iter().position(|param| param.id == id)?;
    step.values.get(at).copied()
}

/// The largest cell of a style's screens and patterns, in its pixels.
fn cell(style: &Style) -> Option<f64> {
    let cells = steps(style).filter_map(|step| match step.block.id {
        "halftone" => value(step, "pitch"),
        "plates" => value(step, "pitch").filter(|pitch| *pitch > 0.0),
        "pattern" => value(step, "scale").map(|scale| scale * PATTERN_CELL),
        _ => None,
    });
    cells.map(f64::from).reduce(f64::max)
}

/// Side of the smallest area of a style, in its pixels: the block with the largest areas decides.
fn area(style: &Style) -> Option<f64> {
    let areas = steps(style).flat_map(|step| {
        let own = AREA.iter().filter(|(block, ..)| *block == step.block.id);
        own.filter_map(|(_, id, part)| value(step, id).map(|value| part * value))
    });
    areas.map(f64::from).reduce(f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::catalogue;

    fn page(tones: [f64; 16]) -> Shown {
        Shown { tones: Some(tones), texture: 0.1, face: None, scale: 1e-3 }
    }

    #[test]
    fn every_designed_style_is_rated_and_measured() {
        for style in catalogue::catalogue() {
            let look = look(style.id.as_str()).unwrap_or_else(|| panic!("{} is not in marks.txt", style.id));
            assert!((0.0..=10.0).contains(&look.rating) && look.response.is_some(), "{}", style.id);
        }
        assert_eq!(looks().len(), MARKS.lines().count());
        let first = || looks().iter().filter(|look| is_for_first_page(look.id));
        assert_eq!(first().count(), FIRST);
        assert!(first().all(|look| look.rating >= 7.0), "the first page has only good styles");
    }

    #[test]
    fn what_would_be_black_or_blank_is_hardly_drawn() {
        let taste = Taste::default();
        let (mut night, mut even) = ([0.0; 16], [1.0 / 16.0; 16]);
        (night[0], night[1], night[2]) = (0.5, 0.3, 0.2);
        even[0] += 0.0;
        let falls = |id: &str| {
            let style = catalogue::find(id).unwrap();
            weight(style, &page(night), &taste) / weight(style, &page(even), &taste)
        };
        let worst = catalogue::catalogue().iter().map(|style| style.id.as_str());
        let worst = worst.filter(|id| !is_retired(id)).map(falls).fold(1.0, f64::min);
        assert!(worst < 0.3, "{worst}");
    }

    #[test]
    fn styles_without_black_keep_away_from_dark_photos() {
        let taste = Taste::default();
        let mut dark = [0.04; 16];
        dark[..4].fill(0.13);
        let falls = |id: &str| {
            let style = catalogue::find(id).unwrap();
            weight(style, &page(dark), &taste) / weight(style, &page([1.0 / 16.0; 16]), &taste)
        };
        for id in ["picture-book", "pen-and-wash", "pastel"] {
            assert!(falls(id) < 0.5, "{id} {}", falls(id));
        }
        for id in ["comic-bold", "graphic-novel", "wood-engraving"] {
            assert!((falls(id) - 1.0).abs() < 1e-9, "{id} {}", falls(id));
        }
    }

    #[test]
    fn large_areas_keep_away_from_small_faces() {
        let taste = Taste::default();
        let with = |id: &str, face| {
            let style = catalogue::find(id).unwrap();
            weight(style, &Shown { face, ..page([1.0 / 16.0; 16]) }, &taste)
        };
        for id in ["gouache-studio", "oil", "copperplate"] {
            assert!(with(id, Some(0.04)) < 0.6 * with(id, Some(0.5)), "{id}");
            assert!((with(id, Some(0.5)) - with(id, None)).abs() < 1e-9, "{id}");
        }
    }

    #[test]
    fn large_dots_keep_away_from_small_faces() {
        let taste = Taste::default();
        let style = catalogue::find("newsprint").unwrap();
        let with = |face| weight(style, &Shown { face, ..page([1.0 / 16.0; 16]) }, &taste);
        assert!(with(Some(0.05)) < 0.5 * with(Some(0.5)));
        assert!((with(Some(0.5)) - with(None)).abs() < 1e-9);
    }
}
