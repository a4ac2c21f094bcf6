//! Where the words of a document are, and how large. Lengths are in page widths.

use super::letters::Letters;
use super::model::{Kind, Word};
use super::setting::{Setting, Wish, set};
use super::shapes::reach;
use crate::error::Result;
use crate::layout::{Bounds, Point, ResolvedPanel, resolve};
use crate::page::Document;
use serde::Serialize;

/// A word with its place.
pub struct Laid {
    /// What it is.
    pub word: Word,
    /// Its text in lines.
    pub setting: Setting,
    /// Its middle.
    pub middle: Point,
    /// Where its tail ends.
    pub tip: Option<Point>,
}

/// The page that words stand on.
pub struct Ground {
    /// The panels of the page.
    pub panels: Vec<ResolvedPanel>,
    /// Height of the page.
    pub height: f64,
}

impl Ground {
    /// The panels of a document.
    ///
    /// # Errors
    /// `unknown-layout`, `invalid-layout`.
    pub fn new(document: &Document) -> Result<Self> {
        let aspect = document.page.aspect();
        let panels = resolve(&*document.template()?, aspect, &document.page);
        Ok(Self { panels, height: 1.0 / aspect })
    }

    /// What the places of a word are fractions of: its panel, the last one where the page has fewer, or the page.
    #[must_use]
    pub fn frame(&self, word: &Word) -> Bounds {
        let panel = word.panel.and_then(|panel| self.panels.get(panel).or_else(|| self.panels.last()));
        panel.map_or(Bounds { x: 0.0, y: 0.0, width: 1.0, height: self.height }, |panel| panel.bounds)
    }

    /// A word set and put into its place. It never leaves the page.
    #[must_use]
    pub fn lay(&self, word: Word, letters: &Letters) -> Laid {
        let frame = self.frame(&word);
        let point = |(x, y): (f64, f64)| Point::new(frame.x + x * frame.width, frame.y + y * frame.height);
        let reach = reach(word.kind);
        let (across, down) = if word.panel.is_some() { (0.84, 0.62) } else { (0.5, 0.3) };
        let wish = Wish {
            kind: word.kind,
            width: word.width,
            size: word.size,
            room: (across * frame.width / reach, down * frame.height / reach),
            page: (0.96 / reach, 0.96 * self.height / reach),
        };
        // A person's width may be more than the panel's.
        let room = word.width.map_or(wish.room, |_| (wish.page.0, wish.room.1));
        let wish = Wish { room, ..wish };
        let text = letters.cleaned(&word.text);
        let setting = match letters.font(&word.font) {
            Some(font) => set(letters, font, &text, &wish),
            None => Setting { size: 0.0, pitch: 0.0, lines: Vec::new(), half: (0.0, 0.0), cut: true },
        };
        let half = extent(&word, &setting);
        let inside = |at: f64, half: f64, length: f64| at.max(half).min((length - half).max(length / 2.0));
        let middle = point(word.at);
        let middle = Point::new(inside(middle.x, half.0, 1.0), inside(middle.y, half.1, self.height));
        let tip = word
            .tail
            .map(point)
            .map(|tip| Point::new(inside(tip.x, 0.0, 1.0), inside(tip.y, 0.0, self.height)));
        Laid { word, setting, middle, tip }
    }
}

/// Half the width and height that a word takes on the page, without its tail.
#[must_use]
pub fn extent(word: &Word, setting: &Setting) -> (f64, f64) {
    let reach = reach(word.kind);
    let (a, b) = (setting.half.0 * reach, setting.half.1 * reach);
    if word.kind != Kind::Effect {
        return (a, b);
    }
    // The bow of an arched line is up to a quarter of its width high.
    let (sin, cos) = word.angle.to_radians().sin_cos();
    let b = b + 0.25 * a * word.arc.abs();
    (a * cos.abs() + b * sin.abs(), a * sin.abs() + b * cos.abs())
}

/// All words of a document in their places.
///
/// # Errors
/// `invalid-document` for a word that breaks its shape; those of the layout.
pub fn lay_all(document: &Document, letters: &Letters) -> Result<Vec<Laid>> {
    if document.words.is_empty() {
        return Ok(Vec::new());
    }
    let ground = Ground::new(document)?;
    Ok(Word::parse_all(&document.words)?.into_iter().map(|word| ground.lay(word, letters)).collect())
}

/// Where a word is without its tail, in page widths.
#[derive(Debug, Serialize)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS))]
pub struct WordBox {
    /// Left edge.
    pub x: f64,
    /// Top edge.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// Where its tail ends.
    pub tip: Option<Point>,
    /// Height of an em.
    pub size: f64,
    /// The end of its text found no room.
    pub cut: bool,
}

/// Where the words of a document are, in their order.
///
/// # Errors
/// As [`lay_all`].
pub fn measured(document: &Document, letters: &Letters) -> Result<Vec<WordBox>> {
    let boxes = lay_all(document, letters)?.into_iter().map(|laid| {
        let (a, b) = extent(&laid.word, &laid.setting);
        WordBox {
            x: laid.middle.x - a,
            y: laid.middle.y - b,
            width: 2.0 * a,
            height: 2.0 * b,
            tip: laid.tip,
            size: laid.setting.size,
            cut: laid.setting.cut,
        }
    });
    Ok(boxes.collect())
}
