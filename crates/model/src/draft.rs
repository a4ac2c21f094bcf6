//! Edits of a style in the designer. Every block keeps its key wherever it is moved, and has all of its
//! values, so that a control never guesses.

use super::invalid;
use super::limits::{GREATEST_ID, LONGEST_ID, LONGEST_NAME, MOST_BLOCKS, MOST_TAGS, PROJECT};
use crate::error::Result;
use crate::json::{self, Fields, Read, Writer, Wrong, text_of};
use crate::raster::color::parse_hex;
use crate::reference::StyleRef;
use crate::style::Style;
use crate::style::blocks::{self, Block, Channels};
use crate::style::file::Step;
use crate::style::part::{Part, Parts};
use serde_json::{Map, Value, json};
use std::sync::Arc;

/// A style while it is designed. Every block has a key, so that its card stays the same card wherever it is moved, and all
/// of its values.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Draft {
    /// Id of the style.
    pub id: String,
    /// Display name.
    pub name: String,
    /// Families that it belongs to.
    pub tags: Vec<String>,
    /// The colour layer.
    pub background: Vec<DraftStep>,
    /// The line layer.
    pub foreground: Vec<DraftStep>,
    /// Colour of the lines, `#rrggbb`.
    pub ink: String,
    /// Whether face protection is off.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub careless: bool,
    /// Whether pages in this style have dark paper.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub dark: bool,
    /// The parts of the image that the layers apply to.
    #[cfg_attr(feature = "typescript", ts(rename = "where", as = "Option<Parts>", optional))]
    pub parts: Parts,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// A block of a draft.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct DraftStep {
    /// Names it within the draft.
    pub key: u64,
    /// Id of the block.
    pub block: String,
    /// Its values by the ids of the parameters.
    #[cfg_attr(feature = "typescript", ts(type = "Record<string, ParamValue>"))]
    pub values: Map<String, Value>,
    /// Whether the block is bypassed.
    pub bypass: bool,
    /// The part of the image that it applies to. `None`: the whole image.
    #[cfg_attr(feature = "typescript", ts(rename = "where", optional))]
    pub part: Option<Part>,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// A layer of a style.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Layer {
    /// The colours.
    Background,
    /// The lines.
    Foreground,
}

/// Position of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Place {
    /// The layer,
    pub layer: Layer,
    /// and a position in it.
    pub at: usize,
}

/// An edit of a draft. In JSON, an object with the name of the edit as `type`, its fields and the fields of
/// its position.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "typescript",
    derive(ts_rs::TS),
    ts(tag = "type", rename_all = "kebab-case", rename_all_fields = "camelCase")
)]
pub enum DraftEdit {
    /// Adds blocks.
    Add {
        /// Before which block.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
        /// Ids of blocks.
        blocks: Vec<String>,
    },
    /// Moves a block.
    Move {
        /// Which.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
        /// The target layer.
        to_layer: Layer,
        /// Index in the target layer, limited to its end.
        to: usize,
    },
    /// Removes a block.
    Remove {
        /// Which.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
    },
    /// Duplicates a block. The copy follows it.
    Duplicate {
        /// Position to insert after.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
    },
    /// Bypasses a block, or enables it again.
    Bypass {
        /// Which.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
        /// Whether it is bypassed.
        on: bool,
    },
    /// A parameter gets a value.
    Set {
        /// The block.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
        /// Its id.
        param: String,
        /// The value.
        #[cfg_attr(feature = "typescript", ts(type = "ParamValue"))]
        value: Value,
    },
    /// Sets the part of the image for a block.
    Where {
        /// Which block.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
        /// `null` for the whole image.
        part: Option<Part>,
    },
    /// Sets the part of the image for a layer.
    LayerWhere {
        /// Which layer.
        layer: Layer,
        /// `null` for the whole image.
        part: Option<Part>,
    },
    /// All values are usual again.
    Reset {
        /// The block.
        #[cfg_attr(feature = "typescript", ts(flatten))]
        place: Place,
    },
    /// The style gets a name.
    Name {
        /// It.
        name: String,
    },
    /// Turns face protection on or off.
    Faces {
        /// Whether it does.
        on: bool,
    },
    /// Chooses dark or white paper for pages in this style.
    Dark {
        /// Whether it is dark.
        on: bool,
    },
    /// The lines get a colour.
    Ink {
        /// `#rrggbb`.
        ink: String,
    },
}

/// Missing input of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "Lack", rename_all = "lowercase"))]
pub enum Misfit {
    /// Grayscale input: [`Misfit::remedy`] provides it.
    Luma,
    /// Colour.
    Color,
}

impl Misfit {
    /// The block that provides the missing input.
    #[must_use]
    pub fn remedy(self) -> &'static str {
        match self {
            Self::Luma => "to_gray",
            Self::Color => "to_color",
        }
    }

    /// Its name in JSON.
    fn id(self) -> &'static str {
        match self {
            Self::Luma => "luma",
            Self::Color => "color",
        }
    }

    fn write(misfit: Option<Self>, out: &mut Writer) {
        let Some(misfit) = misfit else { return out.null() };
        out.open(b'{');
        out.key("lacks").text(misfit.id());
        out.key("remedy").text(misfit.remedy());
        out.close(b'}');
    }
}

impl Draft {
    /// A style without blocks.
    #[must_use]
    pub fn empty(id: &str, name: &str) -> Self {
        Self {
            id: id.into(),
            name: name.into(),
            tags: Vec::new(),
            background: Vec::new(),
            foreground: Vec::new(),
            ink: BLACK.into(),
            careless: false,
            dark: false,
            parts: Parts::default(),
            rest: Map::new(),
        }
    }

    /// Returns the editable draft of a style.
    #[must_use]
    pub fn of(style: &Style) -> Self {
        let mut key = 0;
        let mut layer = |steps: &[Step]| {
            let step = |step: &Step| {
                key += 1;
                let values = step.block.params.iter().zip(&step.values);
                let values = values.map(|(param, value)| {
                    let value =
                        step.text(param).map_or_else(|| param.value_to_json(*value), |text| json!(text));
                    (param.id.to_owned(), value)
                });
                let values = values.collect();
                DraftStep {
                    key,
                    block: step.block.id.into(),
                    values,
                    bypass: step.bypass,
                    part: step.part,
                    rest: Map::new(),
                }
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
            careless: !style.faces,
            dark: style.dark,
            parts: style.parts,
            rest: Map::new(),
        }
    }

    /// The style file of a draft, without default values. `tolerant`: blocks that cannot process their input
    /// are bypassed.
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
                if let Some(part) = step.part {
                    file.insert("where".into(), json!(part.id()));
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
        let parts = part_of_layers(self.parts);
        let told: Map<String, Value> =
            parts.into_iter().filter_map(|(layer, part)| Some((layer.into(), json!(part?.id())))).collect();
        if !told.is_empty() {
            file["where"] = told.into();
        }
        if self.ink != BLACK {
            file["ink"] = json!(self.ink);
        }
        if self.careless {
            file["faces"] = json!(false);
        }
        if self.dark {
            file["dark"] = json!(true);
        }
        file
    }

    /// Returns the draft after an edit, or `None` if nothing changes or the edit is impossible.
    #[must_use]
    pub fn after(&self, edit: &DraftEdit) -> Option<Self> {
        let mut next = self.clone();
        let fresh =
            self.background.iter().chain(&self.foreground).map(|step| step.key).max().unwrap_or_default() + 1;
        let most = MOST_BLOCKS;
        match edit {
            DraftEdit::Name { name } => next.name.clone_from(name),
            DraftEdit::Faces { on } => next.careless = !on,
            DraftEdit::Dark { on } => next.dark = *on,
            DraftEdit::Ink { ink } => {
                parse_hex(ink)?;
                next.ink.clone_from(ink);
            }
            DraftEdit::Add { place, blocks } => {
                let steps = next.layer_mut(place.layer);
                if steps.len() + blocks.len() > most || blocks.iter().any(|id| blocks::find(id).is_none()) {
                    return None;
                }
                let made = (fresh..).zip(blocks).map(|(key, id)| DraftStep {
                    key,
                    block: id.clone(),
                    values: defaults(id),
                    bypass: false,
                    part: None,
                    rest: Map::new(),
                });
                let at = place.at.min(steps.len());
                steps.splice(at..at, made);
            }
            DraftEdit::Move { place, to_layer, to } => {
                let step = next.without(*place)?;
                let target = next.layer_mut(*to_layer);
                let at = (*to).min(target.len());
                if (*to_layer, at) == (place.layer, place.at) || target.len() >= most {
                    return None;
                }
                target.insert(at, step);
            }
            DraftEdit::Remove { place } => drop(next.without(*place)?),
            DraftEdit::Duplicate { place } => {
                let copy = DraftStep { key: fresh, ..next.step_mut(*place)?.clone() };
                let steps = next.layer_mut(place.layer);
                if steps.len() >= most {
                    return None;
                }
                steps.insert(place.at + 1, copy);
            }
            DraftEdit::Bypass { place, on } => next.step_mut(*place)?.bypass = *on,
            DraftEdit::Where { place, part } => {
                let step = next.step_mut(*place)?;
                if step.part == *part {
                    return None;
                }
                step.part = *part;
            }
            DraftEdit::LayerWhere { layer, part } => {
                let now = match layer {
                    Layer::Background => &mut next.parts.background,
                    Layer::Foreground => &mut next.parts.foreground,
                };
                if now == part {
                    return None;
                }
                *now = *part;
            }
            DraftEdit::Set { place, param, value } => {
                let step = next.step_mut(*place)?;
                let known = blocks::find(&step.block)?.params.iter().find(|known| known.id == *param)?;
                // 2 and 2.0 are the same value.
                let value = known.normalized(value).ok()?;
                if step.values.get(param) == Some(&value) {
                    return None;
                }
                step.values.insert(param.clone(), value);
            }
            DraftEdit::Reset { place } => {
                let step = next.step_mut(*place)?;
                step.values = defaults(&step.block);
            }
        }
        Some(next)
    }

    /// Takes a block out.
    fn without(&mut self, place: Place) -> Option<DraftStep> {
        let steps = self.layer_mut(place.layer);
        (place.at < steps.len()).then(|| steps.remove(place.at))
    }

    fn step_mut(&mut self, place: Place) -> Option<&mut DraftStep> {
        self.layer_mut(place.layer).get_mut(place.at)
    }

    fn layer_mut(&mut self, layer: Layer) -> &mut Vec<DraftStep> {
        match layer {
            Layer::Background => &mut self.background,
            Layer::Foreground => &mut self.foreground,
        }
    }
}

/// The default ink of a style.
const BLACK: &str = "#000000";

/// [`Draft::empty`] in JSON.
#[must_use]
pub fn empty_json(id: &str, name: &str) -> String {
    written(&Draft::empty(id, name))
}

/// [`Draft::of`] in JSON.
///
/// # Errors
/// `invalid-style`, `unknown-style`.
pub fn of_json(style: &StyleRef) -> Result<String> {
    Ok(written(&Draft::of(&*style.style()?)))
}

/// [`Draft::after`] in JSON; null if nothing changes or the edit is impossible.
///
/// # Errors
/// Returns `invalid-document` if the draft or the edit is invalid.
pub fn after_json(draft: &str, edit: &str) -> Result<String> {
    let read = || -> Read<String> {
        let draft = Draft::read(json::parse(draft, PROJECT)?)?;
        let edit = DraftEdit::read(json::parse(edit, PROJECT)?)?;
        Ok(draft.after(&edit).map_or_else(|| "null".to_owned(), |after| written(&after)))
    };
    read().map_err(|wrong| invalid(&wrong))
}

/// Analyses a draft, in JSON: `{style, shown, whole, background, foreground}`.
///
/// - `style` is its style file, and `shown` the same with unusable blocks bypassed. `whole` is `true` if all
///   blocks are usable.
/// - Each layer is `{misfits, brings}`. `misfits` has `{lacks, remedy}` or null for each block of the layer.
///   `brings` has the same by id for each block that could be added at the end.
///
/// # Errors
/// Returns `invalid-document` if the draft is invalid.
pub fn facts_json(draft: &str) -> Result<String> {
    let draft = json::parse(draft, PROJECT).and_then(Draft::read).map_err(|wrong| invalid(&wrong))?;
    let mut out = Writer::default();
    out.open(b'{');
    out.key("style").value(&draft.style(false));
    out.key("shown").value(&draft.style(true));
    let mut whole = true;
    for (name, steps) in [("background", &draft.background), ("foreground", &draft.foreground)] {
        let misfits = misfits(steps);
        whole &= misfits.iter().all(Option::is_none);
        out.key(name).open(b'{');
        out.key("misfits").list(&misfits, &|out, misfit| Misfit::write(*misfit, out));
        out.key("brings").open(b'{');
        for block in blocks::ALL {
            Misfit::write(misfit_at_end(steps, block.id), out.key(block.id));
        }
        out.close(b'}');
        out.close(b'}');
    }
    out.key("whole").flag(whole);
    out.close(b'}');
    Ok(out.finish())
}

fn written(draft: &Draft) -> String {
    let mut out = Writer::default();
    draft.write(&mut out);
    out.finish()
}

/// Missing input of each block. A bypassed block needs nothing. A block without its input is skipped for the
/// blocks after it.
#[must_use]
pub fn misfits(steps: &[DraftStep]) -> Vec<Option<Misfit>> {
    let mut channels = Channels::Color;
    let one = |step: &DraftStep| {
        let block = blocks::find(&step.block).filter(|_| !step.bypass)?;
        if block.input != Channels::Any && block.input != channels {
            return Some(if block.input == Channels::Luma { Misfit::Luma } else { Misfit::Color });
        }
        channels = block.given(channels, step.part);
        None
    };
    steps.iter().map(one).collect()
}

/// Missing input of a block after some steps.
fn misfit_at_end(steps: &[DraftStep], block: &str) -> Option<Misfit> {
    let (values, rest) = (Map::new(), Map::new());
    let end = DraftStep { key: 0, block: block.into(), values, bypass: false, part: None, rest };
    let all: Vec<_> = steps.iter().cloned().chain([end]).collect();
    misfits(&all).pop().flatten()
}

/// The layers by their names, with the part that each is for.
pub(crate) fn part_of_layers(parts: Parts) -> [(&'static str, Option<Part>); 2] {
    [("background", parts.background), ("foreground", parts.foreground)]
}

/// Reads a part by name. `None` if it is missing or null.
pub(crate) fn read_part(fields: &mut Fields, name: &str) -> Read<Option<Part>> {
    let Some(told) = fields.nullable(name).text(name, LONGEST_ID)? else { return Ok(None) };
    let part = Part::of(&told).ok_or_else(|| Wrong::new("must be subject or background").at(name))?;
    Ok(Some(part))
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
    /// Returns the location of the error.
    pub fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let kind = fields.name("type", LONGEST_ID)?;
        let layer = fields.part("layer", &mut layer)?.unwrap_or(Layer::Background);
        let at = fields.whole("at", 0, GREATEST_ID)?.unwrap_or_default() as usize;
        let place = Place { layer, at };
        Ok(match kind.as_str() {
            "add" => {
                let blocks = fields.each("blocks", MOST_BLOCKS, &|block| text_of(block, LONGEST_ID))?;
                Self::Add { place, blocks }
            }
            "move" => Self::Move {
                place,
                to_layer: fields.part("toLayer", &mut self::layer)?.unwrap_or(layer),
                // Moving a block up subtracts one.
                to: fields.required("to")?.as_f64().unwrap_or_default() as usize,
            },
            "remove" => Self::Remove { place },
            "duplicate" => Self::Duplicate { place },
            "bypass" => Self::Bypass { place, on: fields.flag("on")? },
            "set" => {
                let (param, value) = (fields.name("param", LONGEST_ID)?, fields.required("value")?);
                Self::Set { place, param, value }
            }
            "where" => Self::Where { place, part: read_part(&mut fields, "part")? },
            "layer-where" => Self::LayerWhere { layer, part: read_part(&mut fields, "part")? },
            "reset" => Self::Reset { place },
            "name" => {
                // A name has an end, wherever it is written.
                let name = fields.text("name", usize::MAX)?.unwrap_or_default();
                Self::Name { name: name.chars().take(LONGEST_NAME).collect() }
            }
            "faces" => Self::Faces { on: fields.flag("on")? },
            "dark" => Self::Dark { on: fields.flag("on")? },
            "ink" => Self::Ink { ink: fields.name("ink", LONGEST_ID)? },
            _ => return Err(Wrong::new("is not a known edit").at("type")),
        })
    }
}

fn layer(value: Value) -> Read<Layer> {
    match text_of(value, LONGEST_ID)?.as_str() {
        "background" => Ok(Layer::Background),
        "foreground" => Ok(Layer::Foreground),
        _ => Err(Wrong::new("must be one of background, foreground")),
    }
}

impl Draft {
    pub(crate) fn read(value: Value) -> Read<Arc<Self>> {
        let mut fields = Fields::of(value)?;
        let ink = fields.text("ink", 7)?.unwrap_or_else(|| "#000000".into());
        if parse_hex(&ink).is_none() {
            return Err(Wrong::new("must be a colour like #101014").at("ink"));
        }
        Ok(Arc::new(Self {
            id: fields.name("id", LONGEST_ID)?,
            name: fields.text("name", LONGEST_NAME)?.unwrap_or_default(),
            tags: fields.each("tags", MOST_TAGS, &|tag| text_of(tag, LONGEST_NAME))?,
            background: fields.each("background", MOST_BLOCKS, &DraftStep::read)?,
            foreground: fields.each("foreground", MOST_BLOCKS, &DraftStep::read)?,
            ink,
            careless: fields.flag("careless")?,
            dark: fields.flag("dark")?,
            parts: fields.part("where", &mut read_parts)?.unwrap_or_default(),
            rest: fields.rest(),
        }))
    }

    pub(crate) fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("id").text(&self.id);
        out.key("name").text(&self.name);
        out.key("tags").texts(&self.tags);
        for (name, layer) in [("background", &self.background), ("foreground", &self.foreground)] {
            out.key(name).list(layer, &|out, step| step.write(out));
        }
        out.key("ink").text(&self.ink);
        if self.careless {
            out.key("careless").flag(true);
        }
        if self.dark {
            out.key("dark").flag(true);
        }
        if self.parts != Parts::default() {
            out.key("where").open(b'{');
            for (layer, part) in part_of_layers(self.parts) {
                if let Some(part) = part {
                    out.key(layer).text(part.id());
                }
            }
            out.close(b'}');
        }
        out.rest(&self.rest);
        out.close(b'}');
    }
}

fn read_parts(value: Value) -> Read<Parts> {
    let mut fields = Fields::of(value)?;
    let background = read_part(&mut fields, "background")?;
    let foreground = read_part(&mut fields, "foreground")?;
    fields.done()?;
    Ok(Parts { background, foreground })
}

impl DraftStep {
    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let id = fields.name("block", LONGEST_ID)?;
        let block = blocks::find(&id).ok_or_else(|| Wrong::new("is not a known block").at("block"))?;
        let mut values = match fields.take("values") {
            None => Map::new(),
            Some(Value::Object(values)) => values,
            Some(_) => return Err(Wrong::new("must be an object").at("values")),
        };
        for (name, value) in &mut values {
            let wrong = |reason: &str| Wrong::new(reason).at(name).at("values");
            let param = block.params.iter().find(|param| param.id == name);
            let param = param.ok_or_else(|| wrong("is not a parameter of this block"))?;
            // 2 and 2.0 are the same value.
            *value = param.normalized(value).map_err(|reason| wrong(&reason))?;
        }
        let (key, bypass) = (fields.count("key", 0, GREATEST_ID)?, fields.flag("bypass")?);
        let part = read_part(&mut fields, "where")?;
        Ok(Self { key, block: id, values, bypass, part, rest: fields.rest() })
    }

    fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("key").whole(self.key);
        out.key("block").text(&self.block);
        out.key("values").open(b'{');
        out.rest(&self.values);
        out.close(b'}');
        out.key("bypass").flag(self.bypass);
        if let Some(part) = self.part {
            out.key("where").text(part.id());
        }
        out.rest(&self.rest);
        out.close(b'}');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BACK: Layer = Layer::Background;

    fn back(at: usize) -> Place {
        Place { layer: BACK, at }
    }

    fn fore(at: usize) -> Place {
        Place { layer: Layer::Foreground, at }
    }

    fn add(draft: &Draft, layer: Layer, blocks: &[&str]) -> Draft {
        let blocks = blocks.iter().map(|&id| id.to_owned()).collect();
        draft.after(&DraftEdit::Add { place: Place { layer, at: 99 }, blocks }).unwrap()
    }

    fn made(blocks: &[&str]) -> Draft {
        add(&Draft::empty("my-1", "Mine"), BACK, blocks)
    }

    fn names(steps: &[DraftStep]) -> Vec<&str> {
        steps.iter().map(|step| step.block.as_str()).collect()
    }

    #[test]
    fn a_block_and_a_layer_are_for_a_part_of_the_picture() {
        let subject = Some(Part::Subject);
        let draft = made(&["to_gray", "saturation"]);
        assert_eq!(misfits(&draft.background)[1], Some(Misfit::Color));
        // Gray in one part leaves colours in the other.
        let parted = draft.after(&DraftEdit::Where { place: back(0), part: subject }).unwrap();
        assert_eq!(misfits(&parted.background), [None, None]);
        assert_eq!(parted.after(&DraftEdit::Where { place: back(0), part: subject }), None);
        let lines = DraftEdit::LayerWhere { layer: Layer::Foreground, part: Some(Part::Background) };
        let parted = parted.after(&lines).unwrap();
        assert_eq!(parted.after(&lines), None);
        let file = parted.style(false);
        assert_eq!(file["background"][0]["where"], "subject");
        assert_eq!(file["where"], json!({ "foreground": "background" }));
        let style = Style::from_value("x", &file).unwrap();
        assert_eq!(Draft::of(&style).style(false), file);
        let kept = json::parse(&written(&parted), PROJECT).and_then(Draft::read).unwrap();
        assert_eq!(*kept, parted);
        let undone = parted.after(&DraftEdit::LayerWhere { layer: Layer::Foreground, part: None }).unwrap();
        assert!(undone.style(false).get("where").is_none());
    }

    #[test]
    fn it_is_built_ordered_and_taken_apart_and_its_cards_keep_their_keys() {
        let draft = made(&["gaussian", "to_gray", "pattern"]);
        let keys: Vec<_> = draft.background.iter().map(|step| step.key).collect();
        assert_eq!(
            (names(&draft.background), keys.as_slice()),
            (vec!["gaussian", "to_gray", "pattern"], &[1, 2, 3][..])
        );
        let moved = draft.after(&DraftEdit::Move { place: back(0), to_layer: BACK, to: 2 }).unwrap();
        assert_eq!(
            (names(&moved.background), moved.background[2].key),
            (vec!["to_gray", "pattern", "gaussian"], 1)
        );
        let across =
            moved.after(&DraftEdit::Move { place: back(2), to_layer: Layer::Foreground, to: 0 }).unwrap();
        assert_eq!(
            (names(&across.background), names(&across.foreground)),
            (vec!["to_gray", "pattern"], vec!["gaussian"])
        );
        let twice = across.after(&DraftEdit::Duplicate { place: fore(0) }).unwrap();
        assert_ne!(twice.foreground[1].key, twice.foreground[0].key);
        assert_eq!(
            names(&twice.after(&DraftEdit::Remove { place: back(0) }).unwrap().background),
            ["pattern"]
        );
    }

    #[test]
    fn nothing_changes_where_an_edit_changes_nothing_or_cannot() {
        let draft = made(&["posterize"]);
        let set = |param: &str, value: Value| DraftEdit::Set { place: back(0), param: param.into(), value };
        let begin = |blocks: Vec<String>| DraftEdit::Add { place: back(0), blocks };
        let idle = [
            DraftEdit::Move { place: back(0), to_layer: BACK, to: 5 },
            set("levels", json!(10)),
            set("levels", json!(1)),
            set("level", json!(5)),
            DraftEdit::Remove { place: back(7) },
            begin(vec!["nope".into()]),
            begin(vec!["sobel".into(); 32]),
            DraftEdit::Ink { ink: "red".into() },
        ];
        for edit in idle {
            assert_eq!(draft.after(&edit), None, "{edit:?}");
        }
        let full = made(&["posterize"; 32]);
        assert_eq!(full.after(&DraftEdit::Duplicate { place: back(0) }), None);
        let other = add(&full, Layer::Foreground, &["sobel"]);
        assert_eq!(other.after(&DraftEdit::Move { place: fore(0), to_layer: BACK, to: 0 }), None);
        // Moving within a full layer is allowed.
        assert!(full.after(&DraftEdit::Move { place: back(0), to_layer: BACK, to: 3 }).is_some());
    }

    #[test]
    fn it_becomes_a_style_file_without_what_is_usual_and_comes_back() {
        let draft = made(&["posterize", "saturation"]);
        let draft =
            draft.after(&DraftEdit::Set { place: back(0), param: "levels".into(), value: json!(3) }).unwrap();
        let draft = draft.after(&DraftEdit::Bypass { place: back(1), on: true }).unwrap();
        let draft = draft.after(&DraftEdit::Ink { ink: "#102030".into() }).unwrap();
        let draft = draft.after(&DraftEdit::Dark { on: true }).unwrap();
        let draft = add(&draft, Layer::Foreground, &["to_gray"]);
        let style = draft.style(false);
        let expected = json!({
            "id": "my-1", "name": "Mine", "tags": [], "background": [{ "block": "posterize", "levels": 3 }, { "block": "saturation", "bypass": true }],
            "foreground": [{ "block": "to_gray" }], "ink": "#102030", "dark": true,
        });
        assert_eq!(style, expected);
        assert_eq!(*json::parse(&written(&draft), PROJECT).and_then(Draft::read).unwrap(), draft);
        assert_eq!(Draft::of(&Style::from_value("x", &style).unwrap()).style(false), style);
        let reset = draft.after(&DraftEdit::Reset { place: back(0) }).unwrap();
        assert_eq!(reset.style(false)["background"][0], json!({ "block": "posterize" }));
        let unnamed = draft.after(&DraftEdit::Name { name: "  ".into() }).unwrap();
        assert_eq!(unnamed.style(false)["name"], json!("my-1"));
    }

    #[test]
    fn edits_in_json_are_read_with_their_bounds() {
        let draft = written(&made(&["posterize", "sobel"]));
        let edited = |edit: Value| -> Value {
            serde_json::from_str(&after_json(&draft, &edit.to_string()).unwrap()).unwrap()
        };
        let up = |at: usize| json!({ "type": "move", "layer": "background", "at": at, "toLayer": "background", "to": at as i64 - 1 });
        assert_eq!(edited(up(1))["background"][0]["block"], json!("sobel"));
        assert_eq!(edited(up(0)), Value::Null);
        let named = edited(json!({ "type": "name", "name": "n".repeat(LONGEST_NAME + 1) }));
        assert_eq!(named["name"].as_str().map(str::len), Some(LONGEST_NAME));
        assert_eq!(edited(json!({ "type": "dark", "on": true }))["dark"], json!(true));
        assert!(after_json(&draft, r#"{"type":"nothing"}"#).is_err() && after_json("[]", "{}").is_err());
        let begun: Value = serde_json::from_str(&empty_json("my-2", "New")).unwrap();
        assert_eq!(
            begun,
            json!({ "id": "my-2", "name": "New", "tags": [], "background": [], "foreground": [], "ink": "#000000" })
        );
        assert!(of_json(&"noir".into()).is_ok() && of_json(&"none such".into()).is_err());
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
        assert_eq!(misfit_at_end(&[], "pattern"), Some(Misfit::Luma));
        assert_eq!(misfit_at_end(&draft.background, "saturation"), Some(Misfit::Color));
        assert_eq!(misfit_at_end(&draft.background, "pattern"), None);
        let facts: Value = serde_json::from_str(&facts_json(&written(&draft)).unwrap()).unwrap();
        let luma = json!({ "lacks": "luma", "remedy": "to_gray" });
        let color = json!({ "lacks": "color", "remedy": "to_color" });
        assert_eq!(facts["background"]["misfits"], json!([luma, null, color, null]));
        assert_eq!(facts["background"]["brings"]["saturation"], color);
        assert_eq!(facts["foreground"]["brings"]["pattern"], luma);
        assert_eq!((&facts["shown"], &facts["whole"]), (&style, &json!(false)));
    }
}
