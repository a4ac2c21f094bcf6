//! A text item as plain data. In JSON, with optional fields in brackets: `{kind, text, [shape], [panel],
//! [x], [y], [width], [size], [tail], [font], [color], [fill], [angle], [arc], [auto], [craft], [boxless],
//! [capitals], [slant], [outline], [behind], [id], [joined], [linked], [apart], [by], [language], [room],
//! [vertical]}`. Storyboard sheets have captions that are `plain`, or `ruled` for handwriting. For these `x`
//! and `y` are the upper left corner, and `room` is the size.

use crate::error::{Error, Result};
use serde_json::Value;

/// Maximum number of characters of one text item, far more than a page holds.
pub const MOST_LETTERS: usize = 10_000;
/// Maximum number of text items per page.
pub const MOST_WORDS: usize = 200;
/// Maximum length of the id of a text item, and of its language, in characters.
pub const LONGEST_ID: usize = 64;
/// Maximum slant of an effect to either side, in degrees.
pub const STEEPEST: f64 = 45.0;
/// Maximum width of the outline of an effect, in ems.
pub const WIDEST_OUTLINE: f64 = 0.4;
/// Maximum distance of a position from its panel, in widths and heights of the panel.
pub const FARTHEST: f64 = 10.0;

/// Kind of a text item.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A box of narration.
    Caption,
    /// Speech or thought.
    Balloon(Shape),
    /// A sound effect: large text without a box.
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
    /// Out of a loudspeaker: a jagged line, its tail a bolt.
    Radio,
}

/// Lettering rules: how text items are set, drawn and placed. Items of old pages keep their look.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Craft {
    /// The first rules: `craft` is missing, or 1.
    First,
    /// The rules of letterers: 2, for all new items.
    Letterer,
}

/// A caption, a balloon or a sound effect.
#[derive(Debug, Clone, PartialEq)]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate field of the file")]
pub struct Word {
    /// Kind.
    pub kind: Kind,
    /// Text; `\n` ends a line.
    pub text: String,
    /// The panel: positions are fractions of its bounds. `None`: fractions of the page.
    pub panel: Option<usize>,
    /// Its middle.
    pub at: (f64, f64),
    /// Width of the box or balloon in page widths; `None` fits the text.
    pub width: Option<f64>,
    /// Height of an em in page widths; `None` is as large as fits, between two limits.
    pub size: Option<f64>,
    /// Target of the tail of a balloon.
    pub tail: Option<(f64, f64)>,
    /// Id of a font of the table.
    pub font: String,
    /// Text colour, and outline colour of a balloon.
    pub color: [u8; 3],
    /// Fill colour of a balloon or a box; outline colour of an effect.
    pub fill: [u8; 3],
    /// Degrees that an effect is turned clockwise.
    pub angle: f64,
    /// Arc of a sound effect: 1 bends up by a third of a circle, -1 bends down by the same angle.
    pub arc: f64,
    /// Whether the item is placed automatically, away from faces. Default: true without a position.
    pub auto: bool,
    /// The conventions that it follows.
    pub craft: Craft,
    /// Whether a caption has no box. Its text is on the image, with an outline.
    pub boxless: bool,
    /// Whether the caption is only left-aligned text from the top of its area.
    pub plain: bool,
    /// Whether ruled lines replace the text.
    pub ruled: bool,
    /// Whether it is set in capitals.
    pub capitals: bool,
    /// Slant of an effect to the right in degrees, up to [`STEEPEST`].
    pub slant: f64,
    /// Half the width of the outline around the glyphs of an effect, in ems; `None` for the default.
    pub outline: Option<f64>,
    /// Whether an effect is behind the subject of its panel, if the subject is known.
    pub behind: bool,
    /// Id, for links of other balloons.
    pub id: Option<String>,
    /// The name of the balloon that this one is linked to; both have one speaker.
    pub joined: Option<String>,
    /// Automatically linked balloon. It is found again at each automatic placement.
    pub linked: Option<String>,
    /// Whether this balloon is never linked automatically.
    pub apart: bool,
    /// Name of the speaker, if known. Balloons of different speakers are never linked automatically.
    pub by: Option<String>,
    /// Language of the text, such as `en` or `pt-BR`, for hyphenation. `None`: no hyphenation.
    pub language: Option<String>,
    /// Its lines are columns, read from the top down and from right to left.
    pub vertical: bool,
    /// Width and height in page widths for an item without a set width, found during placement.
    pub room: Option<(f64, f64)>,
    /// Whether the text colour and the fill colour are set. Other colours may follow the style.
    pub chosen: (bool, bool),
}

impl Word {
    /// Reads one text item; `index` is its index, for the message.
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
            "radio" => Shape::Radio,
            _ => return Err(field.wrong("shape", "must be one of oval, thought, shout, whisper, radio")),
        };
        let kind = match field.text("kind", "")? {
            "caption" => Kind::Caption,
            "balloon" => Kind::Balloon(shape),
            "effect" => Kind::Effect,
            _ => return Err(field.wrong("kind", "must be one of caption, balloon, effect")),
        };
        let craft = match field.number("craft", 1.0, 2.0)? {
            None | Some(1.0) => Craft::First,
            Some(2.0) => Craft::Letterer,
            Some(_) => return Err(field.wrong("craft", "must be 1 or 2")),
        };
        let (font, color, fill) = match kind {
            Kind::Caption => ("comic-neue", "#111111", "#fff6d6"),
            Kind::Balloon(Shape::Whisper) => ("comic-neue", "#111111", "#ffffff"),
            Kind::Balloon(_) => ("comic-neue-bold", "#111111", "#ffffff"),
            Kind::Effect => ("bangers", "#ffd21f", "#111111"),
        };
        let capitals = field.truth("capitals")?;
        let ruled = field.truth("ruled")?.unwrap_or(false) && kind == Kind::Caption;
        let text = field.text("text", "")?;
        if text.chars().nth(MOST_LETTERS).is_some() {
            return Err(field.wrong("text", "is longer than 10000 characters"));
        }
        let font = field.text("font", font)?;
        if !["comic-neue", "comic-neue-bold", "bangers"].contains(&font) {
            return Err(field.wrong("font", "must be one of comic-neue, comic-neue-bold, bangers"));
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
            craft,
            boxless: field.truth("boxless")?.unwrap_or(false) && kind == Kind::Caption,
            plain: (field.truth("plain")?.unwrap_or(false) || ruled) && kind == Kind::Caption,
            ruled,
            // By default, letterers write everything in capitals, except sound effects.
            capitals: capitals.unwrap_or(craft == Craft::Letterer && kind != Kind::Effect),
            slant: field.number("slant", -STEEPEST, STEEPEST)?.unwrap_or(0.0),
            outline: field.number("outline", 0.0, WIDEST_OUTLINE)?,
            behind: field.truth("behind")?.unwrap_or(false),
            id: field.name("id")?,
            joined: field.name("joined")?.filter(|_| matches!(kind, Kind::Balloon(_))),
            linked: field.name("linked")?.filter(|_| matches!(kind, Kind::Balloon(_))),
            apart: field.truth("apart")?.unwrap_or(false),
            by: field.name("by")?,
            language: field.name("language")?,
            vertical: field.truth("vertical")?.unwrap_or(false),
            room: field.pair("room", 0.02, FARTHEST)?,
            chosen: (!value["color"].is_null(), !value["fill"].is_null()),
        })
    }

    /// Id of the balloon that it is linked to, manually or automatically.
    #[must_use]
    pub fn hangs_on(&self) -> Option<&String> {
        self.joined.as_ref().or(self.linked.as_ref())
    }

    /// Index of the foreground that covers an effect, in [`Document::fronts`](crate::page::Document::fronts).
    #[must_use]
    pub fn front(&self, fronts: &[usize]) -> Option<usize> {
        let panel = self.panel.filter(|_| self.behind && self.kind == Kind::Effect)?;
        fronts.iter().position(|front| *front == panel)
    }

    /// Reads the text items of a document.
    ///
    /// # Errors
    /// `invalid-document` with the item and the field, or for more than [`MOST_WORDS`].
    pub fn parse_all(values: &[Value]) -> Result<Vec<Self>> {
        if values.len() > MOST_WORDS {
            let reason = "has more than 200 entries".to_owned();
            return Err(Error::InvalidDocument { location: "words".into(), reason });
        }
        values.iter().enumerate().map(|(i, value)| Self::parse(value, i)).collect()
    }
}

/// Reads fields of one text item.
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

    /// Reads two numbers, or nothing if the field is missing.
    fn pair(&self, name: &str, least: f64, most: f64) -> Result<Option<(f64, f64)>> {
        let value = &self.value[name];
        if value.is_null() {
            return Ok(None);
        }
        let number = |i: usize| value[i].as_f64().filter(|number| (least..=most).contains(number));
        match (value.as_array().map(Vec::len), number(0), number(1)) {
            (Some(2), Some(first), Some(second)) => Ok(Some((first, second))),
            _ => Err(self.wrong(name, &format!("is not two numbers from {least} to {most}"))),
        }
    }

    /// Reads a boolean, or nothing if the field is missing.
    fn truth(&self, name: &str) -> Result<Option<bool>> {
        match &self.value[name] {
            Value::Null => Ok(None),
            Value::Bool(truth) => Ok(Some(*truth)),
            _ => Err(self.wrong(name, "must be true or false")),
        }
    }

    /// Reads a short text, such as an id, or nothing if it is empty.
    fn name(&self, name: &str) -> Result<Option<String>> {
        let text = self.text(name, "")?;
        if text.chars().nth(LONGEST_ID).is_some() {
            return Err(self.wrong(name, "is longer than 64 characters"));
        }
        Ok((!text.is_empty()).then(|| text.to_owned()))
    }

    /// Reads a coordinate. Default: the middle.
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
        assert_eq!((word.craft, word.capitals, word.outline, word.joined), (Craft::First, false, None, None));
    }

    #[test]
    fn new_words_are_a_letterers() {
        let word = |value: Value| Word::parse(&value, 0).unwrap();
        assert!(word(json!({ "kind": "balloon", "craft": 2 })).capitals);
        assert!(!word(json!({ "kind": "balloon", "craft": 2, "capitals": false })).capitals);
        assert!(!word(json!({ "kind": "effect", "craft": 2 })).capitals);
        let joined =
            word(json!({ "kind": "balloon", "shape": "radio", "id": "b", "joined": "a", "boxless": true }));
        assert_eq!((joined.id.as_deref(), joined.joined.as_deref()), (Some("b"), Some("a")));
        assert!(!joined.boxless, "only captions have a box to lose");
    }

    #[test]
    fn what_is_wrong_is_named() {
        let cases = [
            (json!({}), "words[3].kind"),
            (json!({ "kind": "poem" }), "words[3].kind"),
            (json!({ "kind": "balloon", "shape": "square" }), "words[3].shape"),
            (json!({ "kind": "caption", "text": 7 }), "words[3].text"),
            (json!({ "kind": "caption", "text": "x".repeat(10_001) }), "words[3].text"),
            (json!({ "kind": "caption", "boxless": 1 }), "words[3].boxless"),
            (json!({ "kind": "caption", "capitals": "yes" }), "words[3].capitals"),
            (json!({ "kind": "caption", "craft": 1.5 }), "words[3].craft"),
            (json!({ "kind": "effect", "slant": 60 }), "words[3].slant"),
            (json!({ "kind": "effect", "outline": -1 }), "words[3].outline"),
            (json!({ "kind": "effect", "behind": 0 }), "words[3].behind"),
            (json!({ "kind": "balloon", "vertical": "yes" }), "words[3].vertical"),
            (json!({ "kind": "balloon", "joined": 1 }), "words[3].joined"),
            (json!({ "kind": "balloon", "linked": ["a"] }), "words[3].linked"),
            (json!({ "kind": "balloon", "apart": "yes" }), "words[3].apart"),
            (json!({ "kind": "balloon", "by": "x".repeat(65) }), "words[3].by"),
            (json!({ "kind": "balloon", "id": "x".repeat(65) }), "words[3].id"),
            (json!({ "kind": "balloon", "room": [0.5] }), "words[3].room"),
            (json!({ "kind": "balloon", "language": ["en"] }), "words[3].language"),
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
