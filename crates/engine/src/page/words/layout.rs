//! Positions and sizes of the text items of a document. Lengths are in page widths.

use super::fitting::set;
use super::letters::Letters;
use super::model::{Kind, TextItem};
use super::palette::{self, Palette};
use super::setting::{Setting, Wish};
use super::shapes::reach;
use super::wording::{marks, readings};
use crate::error::Result;
use crate::layout::{Bounds, Point, ResolvedPanel, reading_order, resolve};
use crate::page::{CustomFile, Document, StyleRef};
use serde::Serialize;
use serde_json::Value;

/// Text items of a panel are read from top to bottom. The left one of two items comes first if it is lower by
/// less than this part of their horizontal distance.
pub const SLANT: f64 = 0.3;

/// A text item with its position.
pub struct Laid {
    /// The text item, see [`TextItem::effective`].
    pub word: TextItem,
    /// Text colour, and outline colour of a balloon.
    pub color: [u8; 3],
    /// Fill colour of a balloon or a box; outline colour of an effect.
    pub fill: [u8; 3],
    /// Its text in lines.
    pub setting: Setting,
    /// Its middle.
    pub middle: Point,
    /// End of the tail.
    pub tip: Option<Point>,
    /// Position in a chain of linked balloons.
    pub chain: Chain,
}

/// Linked balloons are drawn as one shape, by the first of them.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Chain {
    /// Not linked to other balloons.
    #[default]
    None,
    /// It is the first, and draws these outlines with its own.
    First {
        /// The other balloons.
        bodies: Vec<Body>,
        /// Connectors.
        necks: Vec<Neck>,
    },
    /// Another draws its outline.
    Later,
}

/// The outline of a balloon.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Which one.
    pub kind: Kind,
    /// Lettering rules.
    /// Its middle.
    pub middle: Point,
    /// Half the width and height of the shape around its text.
    pub half: (f64, f64),
    /// End of the tail.
    pub tip: Option<Point>,
}

/// Connector of two balloons.
#[derive(Debug, Clone, PartialEq)]
pub struct Neck {
    /// The middle of one.
    pub from: Point,
    /// The middle of the other.
    pub to: Point,
    /// Half its width.
    pub half: f64,
}

/// The page of the text items.
pub struct Ground {
    /// The panels of the page.
    pub panels: Vec<ResolvedPanel>,
    /// Height of the page.
    pub height: f64,
    /// Colours of its style.
    pub palette: Palette,
    /// Its text is read on screens.
    pub screens: bool,
    /// Whether the page is read from right to left.
    pub rtl: bool,
}

include!(concat!(env!("OUT_DIR"), "/palettes.rs"));

/// Returns the text colours of a document's style.
fn palette_of(style: &StyleRef) -> Palette {
    let known = style.built_in().and_then(|id| PALETTES.iter().find(|(known, _)| *known == id));
    match known {
        Some((_, [ink, paper, note, accent, edge])) => {
            Palette { ink: *ink, paper: *paper, note: *note, accent: *accent, edge: *edge }
        }
        None => palette::of(style.custom().map_or(&Value::Null, CustomFile::json)),
    }
}

impl Ground {
    /// The panels of a document.
    ///
    /// # Errors
    /// `unknown-layout`, `invalid-layout`.
    pub fn new(document: &Document) -> Result<Self> {
        let aspect = document.page.aspect();
        let panels = resolve(&*document.template()?, aspect, &document.page);
        let palette = palette_of(&document.style);
        Ok(Self {
            panels,
            height: 1.0 / aspect,
            palette,
            screens: document.page.for_screens,
            rtl: document.page.rtl,
        })
    }

    /// The bounds for relative positions: the item's panel, the last panel if the page has fewer, or the
    /// page.
    #[must_use]
    pub fn frame(&self, word: &TextItem) -> Bounds {
        let panel = word.panel.and_then(|panel| self.panels.get(panel).or_else(|| self.panels.last()));
        panel.map_or(Bounds { x: 0.0, y: 0.0, width: 1.0, height: self.height }, |panel| panel.bounds)
    }

    /// The text colour and the fill colour of an item, with the colours of the page for unset colours.
    fn colors(&self, word: &TextItem) -> ([u8; 3], [u8; 3]) {
        let own = word.colors();
        if word.plain {
            return own;
        }
        let Palette { ink, paper, note, accent, edge } = self.palette;
        let (color, fill) = match word.kind() {
            Kind::Caption if word.boxless => (ink, paper),
            Kind::Caption => (ink, note),
            Kind::Balloon(_) => (ink, paper),
            Kind::Effect => (accent, edge),
        };
        // A colour of the style is used only if it is readable with the custom colour.
        match (word.color.is_some(), word.fill.is_some()) {
            (false, false) => (color, fill),
            (true, false) if palette::contrast(own.0, fill) > 3.0 => (own.0, fill),
            (false, true) if palette::contrast(color, own.1) > 3.0 => (color, own.1),
            _ => own,
        }
    }

    /// Lays out all text items of the document of this ground.
    #[must_use]
    pub fn lay_all(&self, document: &Document, letters: &Letters) -> Vec<Laid> {
        let mut all: Vec<Laid> =
            document.effective_words().into_iter().map(|word| self.lay(word, letters)).collect();
        join(&mut all);
        all
    }

    /// Sets a text item, see [`TextItem::effective`], and computes its position. It never leaves the page.
    #[must_use]
    pub fn lay(&self, word: TextItem, letters: &Letters) -> Laid {
        let (color, fill) = self.colors(&word);
        let frame = self.frame(&word);
        let point = |(x, y): (f64, f64)| Point::new(frame.x + x * frame.width, frame.y + y * frame.height);
        let reach = reach(word.kind());
        let share = match word.panel {
            None => (0.5, 0.3),
            Some(_) if word.vertical => (0.5, 0.62),
            Some(_) => (0.66, 0.4),
        };
        let part = |(across, down): (f64, f64)| (across * frame.width / reach, down * frame.height / reach);
        let own = word.room.map(|(width, height)| (width / reach, height / reach));
        let wish = Wish {
            kind: word.kind(),
            vertical: word.vertical,
            plain: word.plain,
            screens: self.screens,
            width: if word.plain { own.map(|room| room.0) } else { word.width },
            size: word.size,
            room: own.unwrap_or_else(|| part(share)),
            most: own.unwrap_or_else(|| part((0.94, 0.8))),
            page: (0.96 / reach, 0.96 * self.height / reach),
        };
        // A custom width may exceed the panel.
        let width = word.width.filter(|_| !word.plain);
        let room = width.map_or(wish.room, |_| (wish.page.0, wish.room.1));
        let most = width.map_or(wish.most, |_| (wish.page.0, wish.most.1));
        let wish = Wish { room, most, ..wish };
        let setting = match letters.font(word.font()) {
            Some(font) => {
                set(letters, font, (&marks(&word, letters, font), &readings(&word, letters)), &wish)
            }
            None => Setting {
                size: 0.0,
                pitch: 0.0,
                lines: Vec::new(),
                strong: Vec::new(),
                under: Vec::new(),
                readings: Vec::new(),
                flush: false,
                half: (0.0, 0.0),
                cut: true,
            },
        };
        let half = extent(&word, &setting);
        let inside = |at: f64, half: f64, length: f64| at.max(half).min((length - half).max(length / 2.0));
        let middle = point(word.at());
        let middle = if word.plain { Point::new(middle.x + half.0, middle.y + half.1) } else { middle };
        let middle = Point::new(inside(middle.x, half.0, 1.0), inside(middle.y, half.1, self.height));
        let tip = word
            .tail
            .map(|tail| point((tail.x, tail.y)))
            .map(|tip| Point::new(inside(tip.x, 0.0, 1.0), inside(tip.y, 0.0, self.height)));
        Laid { word, color, fill, setting, middle, tip, chain: Chain::None }
    }
}

/// Half the width and height of a text item on the page, without its tail.
#[must_use]
pub fn extent(word: &TextItem, setting: &Setting) -> (f64, f64) {
    let reach = reach(word.kind());
    let (a, b) = (setting.half.0 * reach, setting.half.1 * reach);
    if word.kind() != Kind::Effect {
        return (a, b);
    }
    // The bow of an arched line is up to a quarter of its width high.
    let (sin, cos) = word.angle.to_radians().sin_cos();
    let line = word.outline.map_or(0.0, |line| line * setting.size);
    let b = b + 0.25 * a * word.arc.abs() + line;
    let a = a + b * word.slant.to_radians().tan().abs() + line;
    (a * cos.abs() + b * sin.abs(), a * sin.abs() + b * cos.abs())
}

/// Lays out all text items of a document.
///
/// # Errors
/// Layout errors.
pub fn lay_all(document: &Document, letters: &Letters) -> Result<Vec<Laid>> {
    if document.words.is_empty() {
        return Ok(Vec::new());
    }
    Ok(Ground::new(document)?.lay_all(document, letters))
}

/// Returns the balloon that each text item is linked to.
pub(super) fn joined<'w>(words: &(impl Iterator<Item = &'w TextItem> + Clone)) -> Vec<Option<usize>> {
    let place = |name: &String| {
        let mut balloons =
            words.clone().enumerate().filter(|(_, word)| matches!(word.kind(), Kind::Balloon(_)));
        balloons.find(|(_, word)| word.id.as_ref() == Some(name)).map(|(place, _)| place)
    };
    let of = |(i, word): (usize, &TextItem)| word.hangs_on().and_then(place).filter(|place| *place != i);
    words.clone().enumerate().map(of).collect()
}

/// Connects linked balloons with each other.
fn join(all: &mut [Laid]) {
    let targets = joined(&all.iter().map(|laid| &laid.word));
    let mut first: Vec<usize> = (0..all.len()).collect();
    for (i, to) in targets.iter().enumerate().filter_map(|(i, to)| to.map(|to| (i, to))) {
        let (low, high) = (first[i].min(first[to]), first[i].max(first[to]));
        first.iter_mut().filter(|first| **first == high).for_each(|first| *first = low);
    }
    for root in 0..all.len() {
        let others: Vec<usize> = (root + 1..all.len()).filter(|&i| first[i] == root).collect();
        if first[root] != root || others.is_empty() {
            continue;
        }
        let body = |&i: &usize| {
            let Laid { word, middle, tip, setting, .. } = &all[i];
            Body { kind: word.kind(), middle: *middle, half: setting.half, tip: *tip }
        };
        let bodies = others.iter().map(body).collect();
        let neck = |&i: &usize| {
            let to = targets[i]?;
            let narrow = |i: usize| all[i].setting.half.0.min(all[i].setting.half.1);
            let half = 0.34 * narrow(i).min(narrow(to));
            Some(Neck { from: all[to].middle, to: all[i].middle, half })
        };
        let necks = std::iter::once(&root).chain(&others).filter_map(neck).collect();
        all[root].chain = Chain::First { bodies, necks };
        for i in others {
            all[i].chain = Chain::Later;
        }
    }
}

/// Returns the indices of the text items in reading order: panel by panel.
#[must_use]
pub fn reading(all: &[Laid], ground: &Ground) -> Vec<usize> {
    let panels = reading_order(&ground.panels, ground.rtl);
    let turn = |laid: &Laid| {
        let panel = panel_of(laid, ground);
        panel.and_then(|panel| panels.iter().position(|&other| other == panel))
    };
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| {
        let (one, other) = (&all[a], &all[b]);
        turn(one).cmp(&turn(other)).then(place(one, ground.rtl).total_cmp(&place(other, ground.rtl)))
    });
    order
}

/// Reading position of a text item in its panel. `rtl`: the page is read from right to left.
fn place(laid: &Laid, rtl: bool) -> f64 {
    let across = if rtl { 1.0 - laid.middle.x } else { laid.middle.x };
    laid.middle.y + SLANT * across
}

/// The panel of a text item: its own, or the panel under it, or the closest one.
#[must_use]
pub fn panel_of(laid: &Laid, ground: &Ground) -> Option<usize> {
    let last = ground.panels.len().checked_sub(1)?;
    if let Some(panel) = laid.word.panel {
        return Some(panel.min(last));
    }
    let Point { x, y } = laid.middle;
    let away = |panel: usize| {
        let Bounds { x: left, y: top, width, height } = ground.panels[panel].bounds;
        let (dx, dy) = ((left - x).max(x - left - width).max(0.0), (top - y).max(y - top - height).max(0.0));
        dx.hypot(dy)
    };
    // The last of overlapping panels is the visible one.
    (0..=last).rev().min_by(|&a, &b| away(a).total_cmp(&away(b)))
}

/// Bounds of a text item without its tail, in page widths.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct WordBox {
    /// Left edge.
    pub x: f64,
    /// Top edge.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// End of the tail.
    pub tip: Option<Point>,
    /// Height of an em.
    pub size: f64,
    /// Whether the end of the text was cut off.
    pub cut: bool,
    /// Text colour, `#rrggbb`.
    pub color: String,
    /// Fill colour of its outline, or of the line around its glyphs.
    pub fill: String,
    /// Id of its font.
    pub font: String,
    /// Its place in the reading order of the page, from 0.
    pub turn: usize,
}

/// Bounds of the text items of a document, in order.
///
/// # Errors
/// As [`lay_all`].
pub fn measured(document: &Document, letters: &Letters) -> Result<Vec<WordBox>> {
    if document.words.is_empty() {
        return Ok(Vec::new());
    }
    let ground = Ground::new(document)?;
    let all = ground.lay_all(document, letters);
    let mut turns = vec![0; all.len()];
    for (turn, index) in reading(&all, &ground).into_iter().enumerate() {
        turns[index] = turn;
    }
    let boxes = all.into_iter().zip(turns).map(|(laid, turn)| {
        let (a, b) = extent(&laid.word, &laid.setting);
        WordBox {
            x: laid.middle.x - a,
            y: laid.middle.y - b,
            width: 2.0 * a,
            height: 2.0 * b,
            tip: laid.tip,
            size: laid.setting.size,
            cut: laid.setting.cut,
            color: hexadecimal(laid.color),
            fill: hexadecimal(laid.fill),
            font: laid.word.font().to_owned(),
            turn,
        }
    });
    Ok(boxes.collect())
}

fn hexadecimal([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_on_the_paper_of_every_style() {
        assert!(PALETTES.len() > 100);
        for (id, [ink, paper, note, accent, edge]) in PALETTES {
            for (over, ground, least) in [(ink, paper, 7.0), (ink, note, 7.0), (accent, edge, 3.0)] {
                let contrast = palette::contrast(*over, *ground);
                assert!(contrast >= least, "{id}: {over:?} on {ground:?} is {contrast}");
            }
        }
    }
}
