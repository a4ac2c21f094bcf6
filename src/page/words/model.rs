//! A word of the page as plain data. In JSON, with what may be left out in brackets:
//! `{kind, text, [shape], [panel], [x], [y], [width], [size], [tail], [font], [color], [fill], [angle], [arc], [auto]}`.

use crate::error::{Error, Result};
use serde_json::Value;

/// Most characters of one word: far more than a page holds.
pub const MOST_LETTERS: usize = 4_000;
/// Most words of a page.
pub const MOST_WORDS: usize = 200;
/// A place of a word, in widths and heights of its panel to either side.
pub const FARTHEST: f64 = 10.0;

/// What a word is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A box of narration.
    Caption,
    /// What somebody says or thinks.
    Balloon(Shape),
    /// A sound, in large letters without a box.
    Effect,
}

/// The outline of a balloon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Said.
    Oval,
    /// Thought: a cloud, its tail a row of bubbles.
    Thought,
    /// Shouted: spikes.
    Shout,
    /// Whispered: dashes.
    Whisper,
}

/// A caption, a balloon or a sound effect.
#[derive(Debug, Clone, PartialEq)]
pub struct Word {
    /// What it is.
    pub kind: Kind,
    /// What it says; `\n` ends a line.
    pub text: String,
    /// The panel that it stands on: places are fractions of that panel's bounds. None: of the page.
    pub panel: Option<usize>,
    /// Its middle.
    pub at: (f64, f64),
    /// Width of its box or balloon in page widths; none fits the text.
    pub width: Option<f64>,
    /// Height of an em in page widths; none is as large as fits, between two limits.
    pub size: Option<f64>,
    /// Where the tail of a balloon points.
    pub tail: Option<(f64, f64)>,
    /// Id of a font of the table.
    pub font: String,
    /// Colour of the letters, and of the outline of a balloon.
    pub color: [u8; 3],
    /// Colour inside of a balloon or a box; of the line around the letters of an effect.
    pub fill: [u8; 3],
    /// Degrees that an effect is turned clockwise.
    pub angle: f64,
    /// How far the line of an effect bends: 1 arches up by a third of a circle, -1 sags as much.
    pub arc: f64,
    /// Nobody has moved it: it goes where it hides no face. True unless told where it has no place.
    pub auto: bool,
}

impl Word {
    /// Reads one word; `index` is its place, for the message.
    ///
    /// # Errors
    /// `invalid-document` naming the field.
    pub fn parse(value: &Value, index: usize) -> Result<Self> {
        let field = Field { value, index };
        let shape = match field.text("shape", "oval")? {
            "oval" => Shape::Oval,
            "thought" => Shape::Thought,
            "shout" => Shape::Shout,
            "whisper" => Shape::Whisper,
            _ => return Err(field.wrong("shape", "is none of oval, thought, shout, whisper")),
        };
        let kind = match field.text("kind", "")? {
            "caption" => Kind::Caption,
            "balloon" => Kind::Balloon(shape),
            "effect" => Kind::Effect,
            _ => return Err(field.wrong("kind", "is none of caption, balloon, effect")),
        };
        let (font, color, fill) = match kind {
            Kind::Caption => ("comic-neue", "#111111", "#fff6d6"),
            Kind::Balloon(Shape::Whisper) => ("comic-neue", "#111111", "#ffffff"),
            Kind::Balloon(_) => ("comic-neue-bold", "#111111", "#ffffff"),
            Kind::Effect => ("bangers", "#ffd21f", "#111111"),
        };
        let text = field.text("text", "")?;
        if text.chars().nth(MOST_LETTERS).is_some() {
            return Err(field.wrong("text", "is longer than 4000 characters"));
        }
        let font = field.text("font", font)?;
        if !["comic-neue", "comic-neue-bold", "bangers"].contains(&font) {
            return Err(field.wrong("font", "is none of comic-neue, comic-neue-bold, bangers"));
        }
        let panel = match &value["panel"] {
            Value::Null => None,
            panel => {
                Some(panel.as_u64().ok_or_else(|| field.wrong("panel", "is not the number of a panel"))?)
            }
        };
        let tail = match &value["tail"] {
            Value::Null => None,
            tail => {
                let tail = Field { value: tail, index };
                Some((tail.place("x")?, tail.place("y")?))
            }
        };
        Ok(Self {
            kind,
            text: text.to_owned(),
            panel: panel.map(|panel| panel as usize),
            at: (field.place("x")?, field.place("y")?),
            width: field.number("width", 0.02, 1.0)?,
            size: field.number("size", 0.004, 0.5)?,
            tail: tail.filter(|_| matches!(kind, Kind::Balloon(_))),
            font: font.to_owned(),
            color: field.color("color", color)?,
            fill: field.color("fill", fill)?,
            angle: field.number("angle", -180.0, 180.0)?.unwrap_or(0.0),
            arc: field.number("arc", -1.0, 1.0)?.unwrap_or(0.0),
            auto: value["auto"].as_bool().unwrap_or(value["x"].is_null() && value["y"].is_null()),
        })
    }

    /// Reads the words of a document.
    ///
    /// # Errors
    /// `invalid-document` naming the word and the field; for more than [`MOST_WORDS`].
    pub fn parse_all(values: &[Value]) -> Result<Vec<Self>> {
        if values.len() > MOST_WORDS {
            let reason = "has more than 200 entries".to_owned();
            return Err(Error::InvalidDocument { location: "words".into(), reason });
        }
        values.iter().enumerate().map(|(i, value)| Self::parse(value, i)).collect()
    }
}

/// Reads fields of one word.
struct Field<'v> {
    value: &'v Value,
    index: usize,
}

impl<'v> Field<'v> {
    #[inline(never)]
    fn wrong(&self, name: &str, reason: &str) -> Error {
        Error::InvalidDocument { location: format!("words[{}].{name}", self.index), reason: reason.into() }
    }

    fn text(&self, name: &str, usual: &'static str) -> Result<&'v str> {
        match &self.value[name] {
            Value::Null => Ok(usual),
            Value::String(text) => Ok(text),
            _ => Err(self.wrong(name, "is not text")),
        }
    }

    /// A coordinate; the middle where it is missing.
    fn place(&self, name: &str) -> Result<f64> {
        Ok(self.number(name, -FARTHEST, FARTHEST)?.unwrap_or(0.5))
    }

    #[inline(never)]
    fn number(&self, name: &str, least: f64, most: f64) -> Result<Option<f64>> {
        match &self.value[name] {
            Value::Null => Ok(None),
            Value::String(auto) if auto == "auto" => Ok(None),
            value => match value.as_f64().filter(|number| (least..=most).contains(number)) {
                Some(number) => Ok(Some(number)),
                None => Err(self.wrong(name, &format!("is not a number from {least} to {most}"))),
            },
        }
    }

    fn color(&self, name: &str, usual: &'static str) -> Result<[u8; 3]> {
        let text = self.text(name, usual)?;
        let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6);
        let value = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        let value = value.ok_or_else(|| self.wrong(name, "is not a colour like #ffffff"))?;
        Ok([(value >> 16) as u8, (value >> 8) as u8, value as u8])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_left_out_is_usual() {
        let word =
            Word::parse(&json!({ "kind": "balloon", "text": "Hi", "shape": "shout", "size": "auto" }), 0)
                .unwrap();
        assert_eq!((word.kind, word.at, word.size), (Kind::Balloon(Shape::Shout), (0.5, 0.5), None));
        assert_eq!((word.fill, word.font.as_str()), ([255; 3], "comic-neue-bold"));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let cases = [
            (json!({}), "words[3].kind"),
            (json!({ "kind": "poem" }), "words[3].kind"),
            (json!({ "kind": "balloon", "shape": "square" }), "words[3].shape"),
            (json!({ "kind": "caption", "text": 7 }), "words[3].text"),
            (json!({ "kind": "caption", "text": "x".repeat(10_000) }), "words[3].text"),
            (json!({ "kind": "caption", "x": 1e300 }), "words[3].x"),
            (json!({ "kind": "caption", "size": 0 }), "words[3].size"),
            (json!({ "kind": "caption", "panel": -1 }), "words[3].panel"),
            (json!({ "kind": "caption", "font": "papyrus" }), "words[3].font"),
            (json!({ "kind": "caption", "color": "#é12345" }), "words[3].color"),
            (json!({ "kind": "balloon", "tail": { "x": "left" } }), "words[3].x"),
        ];
        for (value, place) in cases {
            match Word::parse(&value, 3).unwrap_err() {
                Error::InvalidDocument { location, .. } => assert_eq!(location, place, "{value}"),
                other => panic!("{other}"),
            }
        }
        assert!(Word::parse_all(&vec![json!({ "kind": "caption" }); MOST_WORDS + 1]).is_err());
    }
}
