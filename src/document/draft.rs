//! What is done to a style while it is designed. Every block keeps its key wherever it is moved, and has all of its values,
//! so that a control never guesses.

use super::limits::{GREATEST_ID, LONGEST_ID, LONGEST_NAME, MOST_BLOCKS};
use super::project::{Draft, DraftStep};
use crate::json::{Fields, Read, Wrong, text_of};
use crate::raster::color::parse_hex;
use crate::style::Style;
use crate::style::blocks::{self, Block, Channels};
use crate::style::file::Step;
use serde_json::{Map, Value, json};

/// A layer of a style.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layer {
    /// The colours.
    Background,
    /// The lines.
    Foreground,
}

/// What is done.
#[derive(Debug, Clone, PartialEq)]
pub enum DraftEdit {
    /// Blocks come in at a place.
    Add {
        /// Ids of blocks.
        blocks: Vec<String>,
    },
    /// A block goes to another place.
    Move {
        /// The layer that it goes to.
        to_layer: Layer,
        /// Its place there; the end where that is beyond it.
        to: usize,
    },
    /// A block goes.
    Remove,
    /// A second one comes behind it.
    Duplicate,
    /// It is left out of the chain, or no longer.
    Bypass(bool),
    /// A parameter gets a value.
    Set {
        /// Its id.
        param: String,
        /// The value.
        value: Value,
    },
    /// All values are usual again.
    Reset,
    /// The style gets a name.
    Name(String),
    /// The lines get a colour.
    Ink(String),
}

/// Where something is done: a layer, and a position in it.
pub type Place = (Layer, usize);

/// What a block needs and does not get.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Misfit {
    /// Gray: [`Misfit::remedy`] gives it.
    Luma,
    /// Colour.
    Color,
}

impl Misfit {
    /// The block that gives what is lacking.
    #[must_use]
    pub fn remedy(self) -> &'static str {
        match self {
            Self::Luma => "to_gray",
            Self::Color => "to_color",
        }
    }
}

impl Draft {
    /// A style of nothing.
    #[must_use]
    pub fn empty(id: &str, name: &str) -> Self {
        Self {
            id: id.into(),
            name: name.into(),
            tags: Vec::new(),
            background: Vec::new(),
            foreground: Vec::new(),
            ink: BLACK.into(),
            rest: Map::new(),
        }
    }

    /// A style taken apart.
    #[must_use]
    pub fn of(style: &Style) -> Self {
        let mut key = 0;
        let mut layer = |steps: &[Step]| {
            let step = |step: &Step| {
                key += 1;
                let values = step.block.params.iter().zip(&step.values);
                let values = values.map(|(param, value)| (param.id.to_owned(), param.value_to_json(*value)));
                let values = values.collect();
                DraftStep { key, block: step.block.id.into(), values, bypass: step.bypass, rest: Map::new() }
            };
            steps.iter().map(step).collect()
        };
        let background = layer(&style.background);
        let foreground = layer(style.foreground.as_deref().unwrap_or_default());
        let [r, g, b] = style.ink;
        let tags = style.tags.clone();
        let (id, name) = (style.id.clone(), style.name.clone());
        Self {
            id,
            name,
            tags,
            background,
            foreground,
            ink: format!("#{r:02x}{g:02x}{b:02x}"),
            rest: Map::new(),
        }
    }

    /// The style file of a draft, without what is usual. `tolerant`: blocks that cannot take what comes before them are
    /// bypassed.
    #[must_use]
    pub fn style(&self, tolerant: bool) -> Value {
        let layer = |steps: &[DraftStep]| -> Vec<Value> {
            let wrong = if tolerant { misfits(steps) } else { vec![None; steps.len()] };
            let step = |(step, wrong): (&DraftStep, Option<Misfit>)| {
                let mut file = Map::from_iter([("block".to_owned(), json!(step.block))]);
                let usual = defaults(&step.block);
                let told = step.values.iter().filter(|(name, value)| usual.get(*name) != Some(value));
                file.extend(told.map(|(name, value)| (name.clone(), value.clone())));
                if step.bypass || wrong.is_some() {
                    file.insert("bypass".into(), json!(true));
                }
                Value::Object(file)
            };
            steps.iter().zip(wrong).map(step).collect()
        };
        let name = if self.name.trim().is_empty() { &self.id } else { self.name.trim() };
        let mut file = json!({
            "id": self.id, "name": name, "tags": self.tags, "background": layer(&self.background),
        });
        if !self.foreground.is_empty() {
            file["foreground"] = json!(layer(&self.foreground));
        }
        if self.ink != BLACK {
            file["ink"] = json!(self.ink);
        }
        file
    }

    /// The draft after an edit; none where nothing changes, or where it cannot be done.
    #[must_use]
    pub fn after(&self, edit: &DraftEdit, (layer, at): Place) -> Option<Self> {
        let mut next = self.clone();
        let fresh =
            self.background.iter().chain(&self.foreground).map(|step| step.key).max().unwrap_or_default() + 1;
        let most = MOST_BLOCKS;
        let steps = next.layer_mut(layer);
        match edit {
            DraftEdit::Name(name) => next.name.clone_from(name),
            DraftEdit::Ink(ink) => {
                parse_hex(ink)?;
                next.ink.clone_from(ink);
            }
            DraftEdit::Add { blocks } => {
                if steps.len() + blocks.len() > most || blocks.iter().any(|id| blocks::find(id).is_none()) {
                    return None;
                }
                let made = (fresh..).zip(blocks).map(|(key, id)| DraftStep {
                    key,
                    block: id.clone(),
                    values: defaults(id),
                    bypass: false,
                    rest: Map::new(),
                });
                let at = at.min(steps.len());
                steps.splice(at..at, made);
            }
            DraftEdit::Move { to_layer, to } => {
                if at >= steps.len() {
                    return None;
                }
                let step = steps.remove(at);
                let target = next.layer_mut(*to_layer);
                let place = (*to).min(target.len());
                if (*to_layer == layer && place == at) || target.len() >= most {
                    return None;
                }
                target.insert(place, step);
            }
            DraftEdit::Remove => drop((at < steps.len()).then(|| steps.remove(at))?),
            DraftEdit::Duplicate => {
                let copy = DraftStep { key: fresh, ..steps.get(at)?.clone() };
                if steps.len() >= most {
                    return None;
                }
                steps.insert(at + 1, copy);
            }
            DraftEdit::Bypass(on) => steps.get_mut(at)?.bypass = *on,
            DraftEdit::Set { param, value } => {
                let step = steps.get_mut(at)?;
                let known = blocks::find(&step.block)?.params.iter().find(|known| known.id == *param)?;
                // 2 and 2.0 are the same value.
                let value = known.value_to_json(known.value_from_json(value).ok()?);
                if step.values.get(param) == Some(&value) {
                    return None;
                }
                step.values.insert(param.clone(), value);
            }
            DraftEdit::Reset => {
                let step = steps.get_mut(at)?;
                step.values = defaults(&step.block);
            }
        }
        Some(next)
    }

    fn layer_mut(&mut self, layer: Layer) -> &mut Vec<DraftStep> {
        match layer {
            Layer::Background => &mut self.background,
            Layer::Foreground => &mut self.foreground,
        }
    }
}

/// The ink of a style that says none.
const BLACK: &str = "#000000";

/// What each block lacks. A bypassed block lacks nothing, and one that lacks something is passed over by those behind it.
#[must_use]
pub fn misfits(steps: &[DraftStep]) -> Vec<Option<Misfit>> {
    let mut channels = Channels::Color;
    let one = |step: &DraftStep| {
        let block = blocks::find(&step.block).filter(|_| !step.bypass)?;
        if block.input != Channels::Any && block.input != channels {
            return Some(if block.input == Channels::Luma { Misfit::Luma } else { Misfit::Color });
        }
        if block.output != Channels::Any {
            channels = block.output;
        }
        None
    };
    steps.iter().map(one).collect()
}

/// What must stand before a block at the end of some steps, so that it can work there: the id of a block.
#[must_use]
pub fn remedy(steps: &[DraftStep], block: &str) -> Option<&'static str> {
    let end = DraftStep { key: 0, block: block.into(), values: Map::new(), bypass: false, rest: Map::new() };
    let all: Vec<_> = steps.iter().cloned().chain([end]).collect();
    misfits(&all).pop().flatten().map(Misfit::remedy)
}

/// The usual values of a block.
#[must_use]
pub fn defaults(block: &str) -> Map<String, Value> {
    let params = blocks::find(block).map_or(&[][..], |block: &Block| block.params);
    params.iter().map(|param| (param.id.to_owned(), param.value_to_json(param.kind.default()))).collect()
}

impl DraftEdit {
    /// Reads an edit of a draft: `{type, layer, at, ...}`.
    ///
    /// # Errors
    /// With the place of what is wrong.
    pub fn read(value: Value) -> Read<(Self, Place)> {
        let mut fields = Fields::of(value)?;
        let kind = fields.name("type", LONGEST_ID)?;
        let layer = fields.part("layer", &mut layer)?.unwrap_or(Layer::Background);
        let at = fields.whole("at", 0, GREATEST_ID)?.unwrap_or_default() as usize;
        let edit = match kind.as_str() {
            "add" => {
                Self::Add { blocks: fields.each("blocks", MOST_BLOCKS, &|block| text_of(block, LONGEST_ID))? }
            }
            "move" => Self::Move {
                to_layer: fields.part("toLayer", &mut self::layer)?.unwrap_or(layer),
                to: fields.count("to", 0, GREATEST_ID)? as usize,
            },
            "remove" => Self::Remove,
            "duplicate" => Self::Duplicate,
            "bypass" => Self::Bypass(fields.flag("on")?),
            "set" => Self::Set { param: fields.name("param", LONGEST_ID)?, value: fields.required("value")? },
            "reset" => Self::Reset,
            "name" => Self::Name(fields.text("name", LONGEST_NAME)?.unwrap_or_default()),
            "ink" => Self::Ink(fields.name("ink", LONGEST_ID)?),
            _ => return Err(Wrong::new("is nothing that can be done").at("type")),
        };
        Ok((edit, (layer, at)))
    }
}

fn layer(value: Value) -> Read<Layer> {
    match text_of(value, LONGEST_ID)?.as_str() {
        "background" => Ok(Layer::Background),
        "foreground" => Ok(Layer::Foreground),
        _ => Err(Wrong::new("is none of background, foreground")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BACK: Layer = Layer::Background;

    fn add(draft: &Draft, layer: Layer, blocks: &[&str]) -> Draft {
        let blocks = blocks.iter().map(|&id| id.to_owned()).collect();
        draft.after(&DraftEdit::Add { blocks }, (layer, 99)).unwrap()
    }

    fn made(blocks: &[&str]) -> Draft {
        add(&Draft::empty("my-1", "Mine"), BACK, blocks)
    }

    fn names(steps: &[DraftStep]) -> Vec<&str> {
        steps.iter().map(|step| step.block.as_str()).collect()
    }

    #[test]
    fn it_is_built_ordered_and_taken_apart_and_its_cards_keep_their_keys() {
        let draft = made(&["gaussian", "to_gray", "pattern"]);
        let keys: Vec<_> = draft.background.iter().map(|step| step.key).collect();
        assert_eq!(
            (names(&draft.background), keys.as_slice()),
            (vec!["gaussian", "to_gray", "pattern"], &[1, 2, 3][..])
        );
        let moved = draft.after(&DraftEdit::Move { to_layer: BACK, to: 2 }, (BACK, 0)).unwrap();
        assert_eq!(
            (names(&moved.background), moved.background[2].key),
            (vec!["to_gray", "pattern", "gaussian"], 1)
        );
        let across = moved.after(&DraftEdit::Move { to_layer: Layer::Foreground, to: 0 }, (BACK, 2)).unwrap();
        assert_eq!(
            (names(&across.background), names(&across.foreground)),
            (vec!["to_gray", "pattern"], vec!["gaussian"])
        );
        let twice = across.after(&DraftEdit::Duplicate, (Layer::Foreground, 0)).unwrap();
        assert_ne!(twice.foreground[1].key, twice.foreground[0].key);
        assert_eq!(names(&twice.after(&DraftEdit::Remove, (BACK, 0)).unwrap().background), ["pattern"]);
    }

    #[test]
    fn nothing_changes_where_an_edit_changes_nothing_or_cannot() {
        let draft = made(&["posterize"]);
        let set = |param: &str, value: Value| DraftEdit::Set { param: param.into(), value };
        let idle = [
            (DraftEdit::Move { to_layer: BACK, to: 5 }, 0),
            (set("levels", json!(10)), 0),
            (set("levels", json!(1)), 0),
            (set("level", json!(5)), 0),
            (DraftEdit::Remove, 7),
            (DraftEdit::Add { blocks: vec!["nope".into()] }, 0),
            (DraftEdit::Add { blocks: vec!["sobel".into(); 32] }, 0),
            (DraftEdit::Ink("red".into()), 0),
        ];
        for (edit, at) in idle {
            assert_eq!(draft.after(&edit, (BACK, at)), None, "{edit:?}");
        }
        let full = made(&["posterize"; 32]);
        assert_eq!(full.after(&DraftEdit::Duplicate, (BACK, 0)), None);
        let other = add(&full, Layer::Foreground, &["sobel"]);
        assert_eq!(other.after(&DraftEdit::Move { to_layer: BACK, to: 0 }, (Layer::Foreground, 0)), None);
        // Within a full layer there is room.
        assert!(full.after(&DraftEdit::Move { to_layer: BACK, to: 3 }, (BACK, 0)).is_some());
    }

    #[test]
    fn it_becomes_a_style_file_without_what_is_usual_and_comes_back() {
        let draft = made(&["posterize", "saturation"]);
        let draft =
            draft.after(&DraftEdit::Set { param: "levels".into(), value: json!(3) }, (BACK, 0)).unwrap();
        let draft = draft.after(&DraftEdit::Bypass(true), (BACK, 1)).unwrap();
        let draft = draft.after(&DraftEdit::Ink("#102030".into()), (BACK, 0)).unwrap();
        let draft = add(&draft, Layer::Foreground, &["to_gray"]);
        let style = draft.style(false);
        let expected = json!({
            "id": "my-1", "name": "Mine", "tags": [], "background": [{ "block": "posterize", "levels": 3 }, { "block": "saturation", "bypass": true }],
            "foreground": [{ "block": "to_gray" }], "ink": "#102030",
        });
        assert_eq!(style, expected);
        assert_eq!(Draft::of(&Style::from_value("x", &style).unwrap()).style(false), style);
        let reset = draft.after(&DraftEdit::Reset, (BACK, 0)).unwrap();
        assert_eq!(reset.style(false)["background"][0], json!({ "block": "posterize" }));
        let unnamed = draft.after(&DraftEdit::Name("  ".into()), (BACK, 0)).unwrap();
        assert_eq!(unnamed.style(false)["name"], json!("my-1"));
    }

    #[test]
    fn every_designed_style_can_be_taken_apart_and_put_together() {
        for style in crate::style::catalogue::catalogue() {
            let again = Style::from_value("again", &Draft::of(style).style(false)).unwrap();
            assert_eq!((again.to_value(), again.ink), (style.to_value(), style.ink));
        }
    }

    #[test]
    fn channel_rules_are_told_before_they_bite() {
        let draft = made(&["pattern", "to_gray", "saturation", "pattern"]);
        assert_eq!(misfits(&draft.background), [Some(Misfit::Luma), None, Some(Misfit::Color), None]);
        let bypassed = json!([
            { "block": "pattern", "bypass": true }, { "block": "to_gray" }, { "block": "saturation", "bypass": true }, { "block": "pattern" },
        ]);
        let style = draft.style(true);
        assert_eq!(style["background"], bypassed);
        assert!(
            Style::from_value("x", &style).is_ok() && Style::from_value("x", &draft.style(false)).is_err()
        );
        assert_eq!(remedy(&[], "pattern"), Some("to_gray"));
        assert_eq!(remedy(&draft.background, "saturation"), Some("to_color"));
        assert_eq!(remedy(&draft.background, "pattern"), None);
    }
}
