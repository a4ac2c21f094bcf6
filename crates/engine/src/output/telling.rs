//! Description of pages: panels in reading order, as polygons in pixels of the page image, with content and
//! text.

use super::comic::{Comic, ComicPage, wrong};
use super::phrases::Phrases;
use crate::error::Result;
use crate::layout::{Bounds, Point, ResolvedShape, reading_order};
use crate::page::Document;
use crate::page::words::Letters;
use crate::page::words::layout::{Ground, Laid, extent, panel_of, reading};
use crate::page::words::model::Kind;
use crate::page::words::wording::{read, said_apart};
use std::f64::consts::{PI, TAU};

/// How far the polygon of a circle may be from it, in pixels.
const ROUND: f64 = 0.25;
/// Corners that a circle has at least.
const LEAST_CORNERS: f64 = 32.0;

/// A page.
#[derive(Debug, Clone, PartialEq)]
pub struct ToldPage {
    /// Width of its image in pixels.
    pub width: u32,
    /// Height of its image in pixels.
    pub height: u32,
    /// Its panels in the order in which they are read.
    pub panels: Vec<ToldPanel>,
}

/// A panel.
#[derive(Debug, Clone, PartialEq)]
pub struct ToldPanel {
    /// Its outline in pixels.
    pub outline: Vec<(f64, f64)>,
    /// Bounding box of the outline.
    pub bounds: Bounds,
    /// Description of the content; never empty.
    pub shows: String,
    /// Whether subjects were detected. If not, the description only mentions a photo.
    pub known: bool,
    /// Text items in reading order.
    pub words: Vec<ToldWord>,
}

/// A text item.
#[derive(Debug, Clone, PartialEq)]
pub struct ToldWord {
    /// Kind.
    pub kind: WordKind,
    /// Text on one line.
    pub text: String,
    /// Index in the text items of the document.
    pub place: usize,
    /// The text in segments, with a reading for segments that have one.
    pub pieces: Vec<(String, Option<String>)>,
    /// Bounding box in pixels.
    pub bounds: Bounds,
    /// Height of an em in pixels.
    pub size: f64,
}

/// Kind of a text item.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WordKind {
    /// Narration.
    Caption,
    /// Speech or thought.
    Balloon,
    /// A sound.
    Effect,
}

impl Phrases {
    /// Name of a kind of text.
    #[must_use]
    pub fn word(&self, kind: WordKind) -> &str {
        match kind {
            WordKind::Caption => &self.caption,
            WordKind::Balloon => &self.balloon,
            WordKind::Effect => &self.effect,
        }
    }
}

impl ToldPanel {
    /// Area that must be visible to read the panel: its bounds and text items that extend past it, in pixels,
    /// clipped to the page.
    #[must_use]
    pub fn view(&self, page: &ToldPage) -> Bounds {
        let all = self.words.iter().map(|word| word.bounds).fold(self.bounds, Bounds::union);
        within(all, page)
    }
}

/// Clips a rectangle to the page.
pub(super) fn within(bounds: Bounds, page: &ToldPage) -> Bounds {
    let (left, top) = (bounds.x.max(0.0), bounds.y.max(0.0));
    let right = (bounds.x + bounds.width).min(f64::from(page.width));
    let bottom = (bounds.y + bounds.height).min(f64::from(page.height));
    Bounds { x: left, y: top, width: (right - left).max(1.0), height: (bottom - top).max(1.0) }
}

/// All pages of a comic.
///
/// # Errors
/// `invalid-document` for panels that do not fit the layout, or invalid text items; `unknown-layout`,
/// `invalid-layout`.
pub fn tell(comic: &Comic, letters: &Letters, phrases: &Phrases) -> Result<Vec<ToldPage>> {
    comic
        .pages
        .iter()
        .map(|ComicPage { document, shows, .. }| told(document, shows, letters, phrases))
        .collect()
}

/// Returns the text of one page. `shows` has the content of each panel, if it is known.
///
/// # Errors
/// As [`tell`].
pub(super) fn told(
    document: &Document,
    shows: &[String],
    letters: &Letters,
    phrases: &Phrases,
) -> Result<ToldPage> {
    let ground = Ground::new(document)?;
    if ground.panels.len() != document.panels.len() {
        let (has, wants) = (document.panels.len(), ground.panels.len());
        return Err(wrong("panels", format!("has {has} entries, the layout has {wants} panels")));
    }
    let (width, height) = (document.page.width, document.page.height);
    let scale = f64::from(width);
    let mut panels: Vec<ToldPanel> = Vec::new();
    for (i, panel) in ground.panels.iter().enumerate() {
        let leader = document.merge_of(i).and_then(|group| group.first().copied()).unwrap_or(i);
        let photo = document.panels.get(leader).is_some_and(|panel| panel.photo.is_some());
        let found = shows.get(i).map(|text| text.trim()).filter(|text| photo && !text.is_empty());
        let usual = if photo { &phrases.photo } else { &phrases.empty };
        panels.push(ToldPanel {
            outline: outline(&panel.shape, scale),
            bounds: scaled(panel.bounds, scale),
            shows: found.unwrap_or(usual).to_owned(),
            // An empty panel is completely described.
            known: found.is_some() || !photo,
            words: Vec::new(),
        });
    }
    let laid = ground.lay_all(document, letters);
    for word in reading(&laid, &ground) {
        let Some(at) = panel_of(&laid[word], &ground) else { continue };
        panels[at].words.extend(told_word(word, &laid[word], scale));
    }
    let mut panels: Vec<Option<ToldPanel>> = panels.into_iter().map(Some).collect();
    let panels = reading_order(&ground.panels, ground.rtl)
        .into_iter()
        .filter_map(|panel| panels[panel].take())
        .collect();
    Ok(ToldPage { width, height, panels })
}

fn told_word(place: usize, laid: &Laid, scale: f64) -> Option<ToldWord> {
    let text = read(&laid.word);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (a, b) = extent(&laid.word, &laid.setting);
    let Point { x, y } = laid.middle;
    let bounds = scaled(Bounds { x: x - a, y: y - b, width: 2.0 * a, height: 2.0 * b }, scale);
    let kind = match laid.word.kind() {
        Kind::Caption => WordKind::Caption,
        Kind::Effect => WordKind::Effect,
        Kind::Balloon(_) => WordKind::Balloon,
    };
    (!text.is_empty()).then(|| ToldWord {
        kind,
        text,
        place,
        pieces: said_apart(&laid.word),
        bounds,
        size: laid.setting.size * scale,
    })
}

fn scaled(bounds: Bounds, by: f64) -> Bounds {
    Bounds { x: bounds.x * by, y: bounds.y * by, width: bounds.width * by, height: bounds.height * by }
}

/// The outline of a panel in pixels. A circle is a polygon with invisible corners.
fn outline(shape: &ResolvedShape, scale: f64) -> Vec<(f64, f64)> {
    match shape {
        ResolvedShape::Polygon(points) => points.iter().map(|p| (p.x * scale, p.y * scale)).collect(),
        ResolvedShape::Circle { center, radius } => {
            let radius = radius * scale;
            let step = (1.0 - ROUND / radius.max(ROUND)).acos().max(0.01);
            let count = (PI / step).ceil().max(LEAST_CORNERS);
            let at = |i: f64| {
                let (sin, cos) = (TAU * i / count).sin_cos();
                (center.x * scale + radius * cos, center.y * scale + radius * sin)
            };
            (0..count as usize).map(|i| at(i as f64)).collect()
        }
    }
}
