//! A text item: a caption, a balloon or a sound effect. Storyboard sheets have captions that are `plain`, or
//! `ruled` for handwriting. For these `x` and `y` are the upper left corner, and `room` is the size.

use crate::error::Error;
use crate::json::fields::at_most;
use crate::json::typed::{is_default, nullable, typed};
use crate::json::{Read, Wrong, each};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};

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
/// Ids of the fonts.
const FONTS: [&str; 3] = ["comic-neue", "comic-neue-bold", "bangers"];

/// Kind of a text item.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum TextKind {
    /// A box of narration.
    #[default]
    Caption,
    /// Speech or thought.
    Balloon,
    /// A sound effect: large text without a box.
    Effect,
}

/// Kind of a text item with the outline of a balloon.
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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

/// The end of a tail, in fractions of the frame of its text item.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Tail {
    /// From the left. Default: the middle.
    #[serde(default = "middle", deserialize_with = "middle_or_null")]
    pub x: f64,
    /// From the top. Default: the middle.
    #[serde(default = "middle", deserialize_with = "middle_or_null")]
    pub y: f64,
}

/// A caption, a balloon or a sound effect. Omitted fields have defaults. Positions are fractions of the
/// bounds of its panel, or of the page without a panel.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate field of the file")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "Word"))]
pub struct TextItem {
    /// Kind.
    #[cfg_attr(feature = "typescript", ts(inline))]
    pub kind: TextKind,
    /// Text; `\n` ends a line.
    #[serde(default, deserialize_with = "nullable")]
    pub text: String,
    /// The outline of a balloon. Default: oval.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(inline, optional))]
    pub shape: Option<Shape>,
    /// Its panel. Default: positions are fractions of the page.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub panel: Option<usize>,
    /// Its middle from the left. Default: 0.5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub x: Option<f64>,
    /// Its middle from the top. Default: 0.5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub y: Option<f64>,
    /// Width of the box or balloon in page widths. Default: fits the text.
    #[serde(default, deserialize_with = "number_or_auto", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub width: Option<f64>,
    /// Height of an em in page widths. Default: as large as fits, between two limits.
    #[serde(default, deserialize_with = "number_or_auto", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(type = "number | 'auto' | null", optional))]
    pub size: Option<f64>,
    /// End of the tail of a balloon.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(type = "Focus | null", optional))]
    pub tail: Option<Tail>,
    /// Id of a font.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub font: Option<String>,
    /// Text colour, and outline colour of a balloon, `#rrggbb`. Default: follows the style.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub color: Option<String>,
    /// Fill colour of a balloon or a box; outline colour of an effect, `#rrggbb`. Default: follows the style.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub fill: Option<String>,
    /// Degrees that an effect is turned clockwise.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub angle: f64,
    /// Arc of a sound effect: 1 bends up by a third of a circle, -1 bends down by the same angle.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub arc: f64,
    /// Whether the item is placed automatically, away from faces. Default: true without a position.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub auto: Option<bool>,
    /// Whether a shuffle made it. The next shuffle replaces it.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub made: bool,
    /// Whether it belongs to a book. A shuffle keeps it, another book replaces it.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub book: bool,
    /// Whether it is a page number, which follows the position of the page.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub number: bool,
    /// Whether it names a place by the location in a photo.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub located: bool,
    /// The photo that it belongs to. The item follows this photo. Default: the photo on its panel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub photo: Option<String>,
    /// The subtitle of origin, so that it is not added twice.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub cue: Option<String>,
    /// Whether a caption has no box. Its text is on the image, with an outline.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub boxless: bool,
    /// Whether the caption is only left-aligned text from the top of its area.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub plain: bool,
    /// Whether ruled lines replace the text of a caption.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub ruled: bool,
    /// Whether it is set in capitals. Default: true by the rules of letterers, except effects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub capitals: Option<bool>,
    /// Slant of a sound effect in degrees to the right, -45 to 45.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub slant: f64,
    /// Half the width of the outline of a sound effect, in ems, 0 to 0.4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub outline: Option<f64>,
    /// Whether an effect is behind the subject of its panel, if the subject is known.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub behind: bool,
    /// Id, for links of other balloons.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub id: Option<String>,
    /// The id of the balloon that this one is linked to; both have one speaker.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub joined: Option<String>,
    /// Automatically linked balloon. It is found again at each automatic placement.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub linked: Option<String>,
    /// Whether this balloon is never linked automatically.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub apart: bool,
    /// Name of the speaker, if known. Balloons of different speakers are never linked automatically.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub by: Option<String>,
    /// Language of the text, such as `en` or `pt-BR`, for hyphenation. Default: no hyphenation.
    #[serde(default, deserialize_with = "name", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub language: Option<String>,
    /// Its lines are columns, read from the top down and from right to left.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub vertical: bool,
    /// Width and height in page widths for an item without a set width, found during placement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(
        feature = "typescript",
        ts(type = "readonly [width: number, height: number] | null", optional)
    )]
    pub room: Option<(f64, f64)>,
    /// Unknown fields, preserved for newer programs.
    #[serde(flatten)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// A text item that is not on a page yet.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct NewText {
    /// The text item.
    #[serde(flatten)]
    pub item: TextItem,
    /// Id of its place in the storyboard.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<u64>,
    /// Whether it continues the text item before.
    #[serde(skip_serializing_if = "is_default")]
    pub joins: bool,
    /// Index of the video frame of a subtitle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame: Option<usize>,
    /// Index among the panels of all pages.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<usize>,
}

impl NewText {
    /// Reads a text item with its `sheet` and `joins`. Invalid values of these two count as missing.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn read(value: Value) -> Read<Self> {
        let mut item = TextItem::read(value)?;
        let sheet = item.rest.remove("sheet").and_then(|sheet| sheet.as_u64());
        let joins = item.rest.remove("joins") == Some(Value::Bool(true));
        Ok(Self { item, sheet, joins, ..Self::default() })
    }
}

fn middle() -> f64 {
    0.5
}

fn middle_or_null<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or_else(middle))
}

/// Reads a number; `auto` counts as missing.
fn number_or_auto<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f64>, D::Error> {
    match Value::deserialize(deserializer)? {
        Value::Null => Ok(None),
        Value::String(auto) if auto == "auto" => Ok(None),
        value => value.as_f64().map(Some).ok_or_else(|| serde::de::Error::custom("must be a number or auto")),
    }
}

/// Reads a short text; an empty one counts as missing.
fn name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<String>, D::Error> {
    Ok(Option::deserialize(deserializer)?.filter(|name: &String| !name.is_empty()))
}

impl TextItem {
    /// A text item with defaults for everything else.
    #[must_use]
    pub fn new(kind: TextKind, text: impl Into<String>) -> Self {
        Self { kind, text: text.into(), ..Self::default() }
    }

    /// Reads a text item.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn read(value: Value) -> Read<Self> {
        let item: Self = typed(value)?;
        item.validate().map(|()| item)
    }

    /// Reads a list of text items in JSON.
    ///
    /// # Errors
    /// `invalid-document` with the item and the field, or for more than [`MOST_WORDS`].
    pub fn read_all(json: &str) -> crate::error::Result<Vec<Self>> {
        let read = || {
            let values: Vec<Value> =
                serde_json::from_str(json).map_err(|error| Wrong::new(&error.to_string()))?;
            at_most(values.len(), MOST_WORDS)?;
            each(values, &Self::read)
        };
        read().map_err(|wrong| {
            let wrong = wrong.at("words");
            Error::InvalidDocument { location: wrong.place().into(), reason: wrong.reason().into() }
        })
    }

    /// Checks lengths and ranges.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn validate(&self) -> Read<()> {
        if self.text.chars().nth(MOST_LETTERS).is_some() {
            return Err(Wrong::new(&format!("is longer than {MOST_LETTERS} characters")).at("text"));
        }
        if self.font.as_ref().is_some_and(|font| !FONTS.contains(&font.as_str())) {
            return Err(Wrong::new(&format!("must be one of {}", FONTS.join(", "))).at("font"));
        }
        let place = (-FARTHEST, FARTHEST);
        let numbers = [
            ("x", self.x, place),
            ("y", self.y, place),
            ("width", self.width, (0.02, 1.0)),
            ("size", self.size, (0.004, 0.5)),
            ("angle", Some(self.angle), (-180.0, 180.0)),
            ("arc", Some(self.arc), (-1.0, 1.0)),
            ("slant", Some(self.slant), (-STEEPEST, STEEPEST)),
            ("outline", self.outline, (0.0, WIDEST_OUTLINE)),
            ("room", self.room.map(|room| room.0), (0.02, FARTHEST)),
            ("room", self.room.map(|room| room.1), (0.02, FARTHEST)),
        ];
        in_ranges(&numbers)?;
        if let Some(Tail { x, y }) = self.tail {
            in_ranges(&[("x", Some(x), place), ("y", Some(y), place)]).map_err(|wrong| wrong.at("tail"))?;
        }
        let names = [
            ("id", &self.id),
            ("joined", &self.joined),
            ("linked", &self.linked),
            ("by", &self.by),
            ("language", &self.language),
        ];
        let is_long = |name: &String| name.chars().nth(LONGEST_ID).is_some();
        if let Some((field, _)) = names.iter().find(|(_, name)| name.as_ref().is_some_and(is_long)) {
            return Err(Wrong::new(&format!("is longer than {LONGEST_ID} characters")).at(field));
        }
        for (field, color) in [("color", &self.color), ("fill", &self.fill)] {
            if color.as_ref().is_some_and(|color| rgb(color).is_none()) {
                return Err(Wrong::new("is not a colour like #ffffff").at(field));
            }
        }
        Ok(())
    }

    /// The kind, with the outline of a balloon.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self.kind {
            TextKind::Caption => Kind::Caption,
            TextKind::Balloon => Kind::Balloon(self.shape.unwrap_or(Shape::Oval)),
            TextKind::Effect => Kind::Effect,
        }
    }

    /// The item without the fields that its kind does not have, for example the tail of a caption. Lettering
    /// needs this form. The page keeps all fields, so that a change of the kind can be reverted.
    #[must_use]
    pub fn effective(&self) -> Self {
        let (caption, balloon) = (self.kind == TextKind::Caption, self.kind == TextKind::Balloon);
        Self {
            boxless: self.boxless && caption,
            plain: (self.plain || self.ruled) && caption,
            ruled: self.ruled && caption,
            tail: self.tail.filter(|_| balloon),
            joined: self.joined.clone().filter(|_| balloon),
            linked: self.linked.clone().filter(|_| balloon),
            ..self.clone()
        }
    }

    /// Its middle, in fractions of its frame.
    #[must_use]
    pub fn at(&self) -> (f64, f64) {
        (self.x.unwrap_or(0.5), self.y.unwrap_or(0.5))
    }

    /// Id of its font.
    #[must_use]
    pub fn font(&self) -> &str {
        self.font.as_deref().unwrap_or(match self.kind() {
            Kind::Caption | Kind::Balloon(Shape::Whisper) => "comic-neue",
            Kind::Balloon(_) => "comic-neue-bold",
            Kind::Effect => "bangers",
        })
    }

    /// Text colour and fill colour: set ones, or defaults of its kind.
    #[must_use]
    pub fn colors(&self) -> ([u8; 3], [u8; 3]) {
        let (color, fill) = match self.kind {
            TextKind::Caption => ([0x11; 3], [0xff, 0xf6, 0xd6]),
            TextKind::Balloon => ([0x11; 3], [0xff; 3]),
            TextKind::Effect => ([0xff, 0xd2, 0x1f], [0x11; 3]),
        };
        let set = |own: &Option<String>| own.as_deref().and_then(rgb);
        (set(&self.color).unwrap_or(color), set(&self.fill).unwrap_or(fill))
    }

    /// Whether it is placed automatically.
    #[must_use]
    pub fn is_auto(&self) -> bool {
        self.auto.unwrap_or(self.x.is_none() && self.y.is_none())
    }

    /// Whether it is set in capitals.
    #[must_use]
    pub fn in_capitals(&self) -> bool {
        // Letterers write everything in capitals, except sound effects.
        self.capitals.unwrap_or(self.kind != TextKind::Effect)
    }

    /// Id of the balloon that it is linked to, manually or automatically.
    #[must_use]
    pub fn hangs_on(&self) -> Option<&String> {
        self.joined.as_ref().or(self.linked.as_ref())
    }

    /// Index of the foreground that covers an effect, in [`Document::fronts`](crate::page::Document::fronts).
    #[must_use]
    pub fn front(&self, fronts: &[usize]) -> Option<usize> {
        let panel = self.panel.filter(|_| self.behind && self.kind == TextKind::Effect)?;
        fronts.iter().position(|front| *front == panel)
    }
}

/// Checks that set numbers are in their ranges.
fn in_ranges(numbers: &[(&str, Option<f64>, (f64, f64))]) -> Read<()> {
    let is_out = |number: &Option<f64>, (least, most): (f64, f64)| {
        number.is_some_and(|number| !(least..=most).contains(&number))
    };
    match numbers.iter().find(|(_, number, range)| is_out(number, *range)) {
        None => Ok(()),
        Some((field, _, (least, most))) => {
            Err(Wrong::new(&format!("is not a number from {least} to {most}")).at(field))
        }
    }
}

fn rgb(text: &str) -> Option<[u8; 3]> {
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6)?;
    let value = u32::from_str_radix(digits, 16).ok()?;
    Some([(value >> 16) as u8, (value >> 8) as u8, value as u8])
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_left_out_is_usual() {
        let word =
            TextItem::read(json!({ "kind": "balloon", "text": "Hi", "shape": "shout", "size": "auto" }))
                .unwrap();
        assert_eq!((word.kind(), word.at(), word.size), (Kind::Balloon(Shape::Shout), (0.5, 0.5), None));
        assert_eq!((word.colors().1, word.font()), ([255; 3], "comic-neue-bold"));
        assert_eq!((word.in_capitals(), word.outline), (true, None));
        assert_eq!((word.joined.is_none(), word.is_auto()), (true, true));
    }

    #[test]
    fn only_effects_keep_their_case() {
        let word = |value: Value| TextItem::read(value).unwrap().effective();
        assert!(word(json!({ "kind": "balloon" })).in_capitals());
        assert!(!word(json!({ "kind": "balloon", "capitals": false })).in_capitals());
        assert!(!word(json!({ "kind": "effect" })).in_capitals());
        let joined =
            word(json!({ "kind": "balloon", "shape": "radio", "id": "b", "joined": "a", "boxless": true }));
        assert_eq!((joined.id.as_deref(), joined.joined.as_deref()), (Some("b"), Some("a")));
        assert!(!joined.boxless, "only captions have a box to lose");
    }

    #[test]
    fn what_is_wrong_is_named() {
        let cases = [
            (json!({}), "kind"),
            (json!({ "kind": "poem" }), "kind"),
            (json!({ "kind": "balloon", "shape": "square" }), "shape"),
            (json!({ "kind": "caption", "text": 7 }), "text"),
            (json!({ "kind": "caption", "text": "x".repeat(10_001) }), "text"),
            (json!({ "kind": "caption", "boxless": 1 }), "boxless"),
            (json!({ "kind": "caption", "capitals": "yes" }), "capitals"),
            (json!({ "kind": "effect", "slant": 60 }), "slant"),
            (json!({ "kind": "effect", "outline": -1 }), "outline"),
            (json!({ "kind": "effect", "behind": 0 }), "behind"),
            (json!({ "kind": "balloon", "vertical": "yes" }), "vertical"),
            (json!({ "kind": "balloon", "joined": 1 }), "joined"),
            (json!({ "kind": "balloon", "linked": ["a"] }), "linked"),
            (json!({ "kind": "balloon", "apart": "yes" }), "apart"),
            (json!({ "kind": "balloon", "by": "x".repeat(65) }), "by"),
            (json!({ "kind": "balloon", "id": "x".repeat(65) }), "id"),
            (json!({ "kind": "balloon", "room": [0.5] }), "room"),
            (json!({ "kind": "balloon", "language": ["en"] }), "language"),
            (json!({ "kind": "caption", "x": 1e300 }), "x"),
            (json!({ "kind": "caption", "size": 0 }), "size"),
            (json!({ "kind": "caption", "panel": -1 }), "panel"),
            (json!({ "kind": "caption", "font": "papyrus" }), "font"),
            (json!({ "kind": "caption", "color": "#é12345" }), "color"),
            (json!({ "kind": "balloon", "tail": { "x": "left" } }), "tail.x"),
        ];
        for (value, place) in cases {
            assert_eq!(TextItem::read(value.clone()).unwrap_err().place(), place, "{value}");
        }
    }

    #[test]
    fn a_text_item_is_written_as_it_was_read() {
        let item = json!({
            "kind": "balloon", "text": "Hi", "shape": "thought", "panel": 2, "x": 0.25, "y": 0.5, "width": 0.5,
            "size": 0.25, "tail": { "x": 0.5, "y": 0.25 }, "font": "bangers", "color": "#101010",
            "fill": "#ffffff", "angle": 5.5, "arc": 0.5, "auto": false, "made": true, "book": true,
            "number": true, "located": true, "photo": "p", "cue": "1.0/0", "boxless": true, "plain": true,
            "ruled": true, "capitals": false, "slant": 5.5, "outline": 0.25, "behind": true, "id": "a",
            "joined": "b", "linked": "c", "apart": true, "by": "anna", "language": "en", "vertical": true,
            "room": [0.5, 0.25], "fresh": { "a": [1, 2] },
        });
        let read = TextItem::read(item.clone()).unwrap();
        assert_eq!(serde_json::to_value(&read).unwrap(), item);
        let short = json!({ "kind": "caption", "text": "" });
        assert_eq!(serde_json::to_value(TextItem::read(short.clone()).unwrap()).unwrap(), short);
        assert_eq!(serde_json::to_value(TextItem::new(TextKind::Caption, "")).unwrap(), short);
    }
}
