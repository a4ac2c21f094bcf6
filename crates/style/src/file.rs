//! The style file: two layers of blocks with their parameters, in the format to save, share and edit.
//!
//! The schema is `styles/README.md`. Nothing is guessed: an unknown block or parameter, a wrong type or a value
//! out of range is an error that names the file, the block's position and the parameter.

use super::blocks::{self, Block, Channels};
use super::painters;
use super::params::{Args, Kind, Param, colour_of, colour_value};
use super::part::{Part, Parts};
use super::texture::Texture;
use crate::error::{Error, Result};
use serde_json::{Map, Value, json};
use std::sync::Arc;

/// Maximum number of blocks in a layer: more than any useful style has, and a limit on the work of a file.
pub const MOST_BLOCKS: usize = 32;

/// A style: a background layer and an optional foreground layer of lines.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(optional_fields))]
pub struct Style {
    /// Name for programs.
    pub id: String,
    /// Name for people.
    pub name: String,
    /// Families it belongs to; the first is the main one.
    pub tags: Vec<String>,
    /// The colour layer. An empty layer leaves the photo unchanged.
    pub background: Vec<Step>,
    /// The line layer; its luma is the alpha of the background over the ink.
    pub foreground: Option<Vec<Step>>,
    /// The parts of the picture that the layers are for.
    #[cfg_attr(feature = "typescript", ts(rename = "where", as = "Option<Parts>"))]
    pub parts: Parts,
    /// Colour of the lines.
    #[cfg_attr(feature = "typescript", ts(as = "Option<String>"))]
    pub ink: [u8; 3],
    /// Whether faces are protected. Default: true.
    #[cfg_attr(feature = "typescript", ts(as = "Option<bool>"))]
    pub faces: bool,
    /// Whether pages in this style have dark paper. Default: false.
    #[cfg_attr(feature = "typescript", ts(as = "Option<bool>"))]
    pub dark: bool,
    /// Score from 0 to 1 of a generated style.
    pub score: Option<f64>,
}

/// One block of a layer with its values.
#[derive(Debug, Clone)]
#[cfg_attr(
    feature = "typescript",
    derive(ts_rs::TS),
    ts(
        rename = "StyleStep",
        type = "{ block: string; bypass?: boolean; where?: StylePart } & Record<string, ParamValue>"
    )
)]
pub struct Step {
    /// The kind of the block.
    pub block: &'static Block,
    /// Its values in the order of the descriptor.
    pub values: Vec<f32>,
    /// The picture of the texture parameter, if the block has one and the user chose a picture.
    pub texture: Option<Arc<Texture>>,
    /// The model of the user, if the block has this parameter and the user chose a model.
    pub model: Option<Arc<str>>,
    /// The block stays in the file but is left out of the chain.
    pub bypass: bool,
    /// The part of the picture that it applies to; the whole picture if no part is defined.
    pub part: Option<Part>,
}

impl Step {
    /// The input of its block at the scale of a render.
    #[must_use]
    pub fn args(&self, scale: f32) -> Args<'_> {
        Args::new(&self.values, scale).with_texture(self.texture.as_ref()).with_model(self.model.as_deref())
    }
}

impl Style {
    /// Reads a style file. `file` names it in errors, and is the id of a style without one.
    ///
    /// # Errors
    /// `invalid-style`, naming file, place and reason.
    pub fn parse(file: &str, json: &str) -> Result<Self> {
        let value: Value = serde_json::from_str(json)
            .map_err(|error| invalid(file, "file", format!("is not valid JSON: {error}")))?;
        Self::from_value(file, &value)
    }

    /// Reads a style file from JSON that is parsed already.
    ///
    /// # Errors
    /// `invalid-style`, naming file, place and reason.
    pub fn from_value(file: &str, value: &Value) -> Result<Self> {
        let Value::Object(map) = value else {
            return Err(invalid(file, "file", "must be an object with a \"background\" list"));
        };
        for key in map.keys() {
            if !["id", "name", "tags", "background", "foreground", "where", "ink", "faces", "dark", "score"]
                .contains(&key.as_str())
            {
                return Err(invalid(file, key, "is not a field of a style"));
            }
        }
        let stem = file.rsplit('/').next().unwrap_or(file).trim_end_matches(".json");
        let id = text(file, map, "id")?.unwrap_or_else(|| stem.to_owned());
        let background = layer(file, map, "background")?
            .ok_or_else(|| invalid(file, "background", "is missing; it must be a list of blocks"))?;
        Ok(Self {
            name: text(file, map, "name")?.unwrap_or_else(|| id.clone()),
            id,
            tags: tags(file, map)?,
            background,
            foreground: layer(file, map, "foreground")?,
            parts: parts(file, map)?,
            ink: ink(file, map)?,
            faces: flag(file, map, "faces")?.unwrap_or(true),
            dark: flag(file, map, "dark")?.unwrap_or(false),
            score: match map.get("score") {
                None => None,
                Some(score) => {
                    Some(score.as_f64().ok_or_else(|| invalid(file, "score", "must be a number"))?)
                }
            },
        })
    }

    /// The file's JSON. Values that are the default are left out.
    #[must_use]
    pub fn to_value(&self) -> Value {
        let mut map = Map::new();
        map.insert("id".into(), json!(self.id));
        map.insert("name".into(), json!(self.name));
        map.insert("tags".into(), json!(self.tags));
        map.insert("background".into(), self.background.iter().map(Step::to_value).collect());
        if let Some(foreground) = &self.foreground {
            map.insert("foreground".into(), foreground.iter().map(Step::to_value).collect());
        }
        let parts = [("background", self.parts.background), ("foreground", self.parts.foreground)];
        let told = parts.into_iter().filter_map(|(layer, part)| Some((layer.to_owned(), json!(part?.id()))));
        let told: Map<String, Value> = told.collect();
        if !told.is_empty() {
            map.insert("where".into(), told.into());
        }
        if self.ink != [0; 3] {
            let [r, g, b] = self.ink;
            map.insert("ink".into(), json!(format!("#{r:02x}{g:02x}{b:02x}")));
        }
        if !self.faces {
            map.insert("faces".into(), json!(false));
        }
        if self.dark {
            map.insert("dark".into(), json!(true));
        }
        if let Some(score) = self.score {
            map.insert("score".into(), json!(score));
        }
        Value::Object(map)
    }

    /// Whether pictures in this style have the colours of the photo, if stronger or paler ones.
    #[must_use]
    pub fn keeps_colours(&self) -> bool {
        !recolours(&self.background)
    }

    /// Returns whether an active layer or block applies to a part of the picture, so that the subject mask is
    /// needed.
    #[must_use]
    pub fn has_parts(&self) -> bool {
        let steps = self.background.iter().chain(self.foreground.iter().flatten());
        self.parts != Parts::default() || steps.filter(|step| !step.bypass).any(|step| step.part.is_some())
    }

    /// Whether a layer runs this block.
    #[must_use]
    pub fn has_block(&self, id: &str) -> bool {
        self.running().any(|step| step.block.id == id)
    }

    /// The references of the user's models that the layers name ([`painters::is_reference`]).
    pub fn models(&self) -> impl Iterator<Item = &str> {
        self.running().filter_map(|step| step.model.as_deref())
    }

    /// The blocks of both layers without bypassed blocks.
    fn running(&self) -> impl Iterator<Item = &Step> {
        let steps = self.background.iter().chain(self.foreground.iter().flatten());
        steps.filter(|step| !step.bypass)
    }
}

impl Step {
    /// A block with its default values.
    #[must_use]
    pub fn new(block: &'static Block) -> Self {
        let values = block.params.iter().map(|param| param.kind.default()).collect();
        Self { block, values, texture: None, model: None, bypass: false, part: None }
    }

    /// Returns the value of a parameter that is a text, unless it is empty.
    #[must_use]
    pub fn text(&self, param: &Param) -> Option<&str> {
        match param.kind {
            Kind::Texture => self.texture.as_ref().map(|texture| texture.url()),
            Kind::Model => self.model.as_deref(),
            _ => None,
        }
    }

    fn to_value(&self) -> Value {
        let mut map = Map::new();
        map.insert("block".into(), json!(self.block.id));
        for (param, &value) in self.block.params.iter().zip(&self.values) {
            if matches!(param.kind, Kind::Texture | Kind::Model) {
                map.extend(self.text(param).map(|text| (param.id.to_owned(), json!(text))));
            } else if (value - param.kind.default()).abs() > f32::EPSILON {
                map.insert(param.id.into(), param.value_to_json(value));
            }
        }
        if self.bypass {
            map.insert("bypass".into(), json!(true));
        }
        if let Some(part) = self.part {
            map.insert("where".into(), json!(part.id()));
        }
        Value::Object(map)
    }
}

/// Returns an f32 as its shortest decimal: 1.2, not 1.2000000476837158. It uses the parser of the JSON
/// reader, because the parser of the standard library adds a table of 10 kB.
#[must_use]
pub fn decimal(value: f32) -> f64 {
    serde_json::from_str(&value.to_string()).unwrap_or(f64::from(value))
}

impl Param {
    /// A value as style files and the page have it.
    #[must_use]
    pub fn value_to_json(&self, value: f32) -> Value {
        match self.kind {
            Kind::Number { .. } => json!(decimal(value)),
            Kind::Integer { .. } => json!(value as i64),
            Kind::Flag { .. } => json!(value != 0.0),
            Kind::Choice { names } => json!(names.get(value as usize)),
            Kind::Colour { .. } => {
                let [r, g, b] = colour_of(value);
                json!(format!("#{r:02x}{g:02x}{b:02x}"))
            }
            Kind::Texture | Kind::Model => json!(""),
        }
    }

    /// A value as it is written: 2 and 2.0 are the same.
    ///
    /// # Errors
    /// The expected value, if the value is invalid.
    pub fn normalized(&self, value: &Value) -> std::result::Result<Value, String> {
        match self.kind {
            Kind::Texture => texture(value).map(|texture| json!(texture.map_or("", |(url, _)| url))),
            Kind::Model => model(value).map(|model| json!(model.unwrap_or_default())),
            _ => self.value_from_json(value).map(|value| self.value_to_json(value)),
        }
    }

    /// Reads a value. The error describes valid values.
    pub(crate) fn value_from_json(&self, value: &Value) -> std::result::Result<f32, String> {
        let in_range = |number: f64| {
            let (min, max) = self.kind.range();
            let max = self.most.unwrap_or(max);
            // Compared as f32, like the limits, so that 0.3 is accepted if the minimum is 0.3.
            let value = number as f32;
            if (min..=max).contains(&value) {
                Ok(value)
            } else {
                Err(format!("is {number}, it must be from {min} to {max}"))
            }
        };
        match self.kind {
            Kind::Number { .. } => {
                in_range(value.as_f64().ok_or(format!("is {value}, it must be a number"))?)
            }
            Kind::Integer { .. } => {
                let number = value.as_f64().filter(|number| number.fract() == 0.0);
                in_range(number.ok_or(format!("is {value}, it must be a whole number"))?)
            }
            Kind::Flag { .. } => {
                let flag = value.as_bool().ok_or(format!("is {value}, it must be true or false"))?;
                Ok(f32::from(u8::from(flag)))
            }
            Kind::Choice { names } => {
                let position = value.as_str().and_then(|name| names.iter().position(|n| *n == name));
                Ok(position.ok_or(format!("is {value}, it must be one of: {}", names.join(", ")))? as f32)
            }
            Kind::Texture => texture(value).map(|_| 0.0),
            Kind::Model => model(value).map(|_| 0.0),
            Kind::Colour { .. } => {
                let colour = value.as_str().and_then(crate::raster::color::parse_hex);
                let bad = || format!("is {value}, it must be a colour like \"#101014\"");
                Ok(colour_value(colour.ok_or_else(bad)?))
            }
        }
    }
}

/// A texture and its data URL; `None` for an empty text.
fn texture(value: &Value) -> std::result::Result<Option<(&str, Texture)>, String> {
    match value.as_str() {
        Some("") => Ok(None),
        Some(url) => Texture::read(url).map(|texture| Some((url, texture))),
        None => Err("must be a text, the data URL of a PNG or JPEG picture".into()),
    }
}

/// The reference of a model; `None` for an empty text.
fn model(value: &Value) -> std::result::Result<Option<&str>, String> {
    let text = value.as_str().filter(|text| text.is_empty() || painters::is_reference(text));
    let wrong = "must be a text, 16 hexadecimal digits and the name of a file";
    text.map(|text| Some(text).filter(|text| !text.is_empty())).ok_or_else(|| wrong.into())
}

/// Whether a layer replaces or removes the colours of the photo. Faces then have the colours of the style.
pub(super) fn recolours(steps: &[Step]) -> bool {
    let mut colour = true;
    let of_subject = |step: &&Step| !step.bypass && step.part != Some(Part::Background);
    for step in steps.iter().filter(of_subject) {
        if (step.block.recolors)(&step.values) {
            return true;
        }
        if step.block.restores_color {
            colour = true;
        } else if step.block.output == Channels::Luma && step.part.is_none() {
            colour = false;
        }
    }
    !colour
}

fn invalid(file: &str, location: &str, reason: impl Into<String>) -> Error {
    Error::InvalidStyle { file: file.to_owned(), location: location.to_owned(), reason: reason.into() }
}

fn text(file: &str, map: &Map<String, Value>, key: &str) -> Result<Option<String>> {
    match map.get(key) {
        None => Ok(None),
        Some(Value::String(text)) if !text.trim().is_empty() && text.len() <= 200 => Ok(Some(text.clone())),
        Some(_) => Err(invalid(file, key, "must be a text of 1 to 200 letters")),
    }
}

fn flag(file: &str, map: &Map<String, Value>, key: &str) -> Result<Option<bool>> {
    match map.get(key) {
        None => Ok(None),
        Some(Value::Bool(flag)) => Ok(Some(*flag)),
        Some(_) => Err(invalid(file, key, "must be true or false")),
    }
}

fn tags(file: &str, map: &Map<String, Value>) -> Result<Vec<String>> {
    let bad = || invalid(file, "tags", "must be a list of at most 20 words");
    match map.get("tags") {
        None => Ok(Vec::new()),
        Some(Value::Array(tags)) if tags.len() <= 20 => {
            tags.iter().map(|tag| tag.as_str().map(str::to_owned).ok_or_else(bad)).collect()
        }
        Some(_) => Err(bad()),
    }
}

fn ink(file: &str, map: &Map<String, Value>) -> Result<[u8; 3]> {
    let Some(value) = map.get("ink") else { return Ok([0; 3]) };
    value
        .as_str()
        .and_then(crate::raster::color::parse_hex)
        .ok_or_else(|| invalid(file, "ink", format!("is {value}, it must be a colour like \"#101014\"")))
}

fn parts(file: &str, map: &Map<String, Value>) -> Result<Parts> {
    let mut parts = Parts::default();
    let Some(value) = map.get("where") else { return Ok(parts) };
    let Value::Object(told) = value else {
        return Err(invalid(file, "where", "must be an object like { \"foreground\": \"subject\" }"));
    };
    for (layer, value) in told {
        let place = format!("where, {layer}");
        let part = match layer.as_str() {
            "background" => &mut parts.background,
            "foreground" => &mut parts.foreground,
            _ => return Err(invalid(file, &place, "must be background or foreground")),
        };
        *part = Some(part_of(value).map_err(|reason| invalid(file, &place, reason))?);
    }
    Ok(parts)
}

fn part_of(value: &Value) -> std::result::Result<Part, String> {
    let part = value.as_str().and_then(Part::of);
    part.ok_or_else(|| format!("is {value}, it must be \"subject\" or \"background\""))
}

fn layer(file: &str, map: &Map<String, Value>, key: &str) -> Result<Option<Vec<Step>>> {
    let Some(value) = map.get(key) else { return Ok(None) };
    let Value::Array(items) = value else {
        return Err(invalid(file, key, "must be a list of blocks"));
    };
    if items.len() > MOST_BLOCKS {
        return Err(invalid(
            file,
            key,
            format!("has {} blocks, at most {MOST_BLOCKS} are allowed", items.len()),
        ));
    }
    let mut steps = Vec::with_capacity(items.len());
    let mut channels = Channels::Color;
    for (i, item) in items.iter().enumerate() {
        let step = step(file, &format!("{key}[{i}]"), item)?;
        if !step.bypass {
            channels = check_channels(file, &format!("{key}[{i}]"), &step, channels)?;
        }
        steps.push(step);
    }
    Ok(Some(steps))
}

fn step(file: &str, place: &str, value: &Value) -> Result<Step> {
    let Value::Object(map) = value else {
        return Err(invalid(file, place, "must be an object like { \"block\": \"posterize\" }"));
    };
    let Some(id) = map.get("block").and_then(Value::as_str) else {
        return Err(invalid(file, place, "needs a \"block\" with the id of a filter block"));
    };
    let block =
        blocks::find(id).ok_or_else(|| invalid(file, place, format!("there is no block \"{id}\"")))?;
    let mut step = Step::new(block);
    for (key, value) in map {
        let place = format!("{place} ({id}), {key}");
        if key == "block" {
            continue;
        }
        if key == "bypass" {
            step.bypass = value.as_bool().ok_or_else(|| invalid(file, &place, "must be true or false"))?;
            continue;
        }
        if key == "where" {
            step.part = Some(part_of(value).map_err(|reason| invalid(file, &place, reason))?);
            continue;
        }
        // A pattern that is a picture is a custom texture.
        let is_picture = value.as_str().is_some_and(|text| text.starts_with("data:"));
        let key = if key == "pattern" && is_picture { "texture" } else { key.as_str() };
        let Some(i) = block.params.iter().position(|param| param.id == key) else {
            let known: Vec<&str> = block.params.iter().map(|param| param.id).collect();
            let known = if known.is_empty() { "no parameters".to_owned() } else { known.join(", ") };
            return Err(invalid(file, &place, format!("is not a parameter of this block ({known})")));
        };
        if matches!(block.params[i].kind, Kind::Texture) {
            let read = texture(value).map_err(|reason| invalid(file, &place, reason))?;
            step.texture = read.map(|(_, texture)| Arc::new(texture));
            continue;
        }
        if matches!(block.params[i].kind, Kind::Model) {
            step.model = model(value).map_err(|reason| invalid(file, &place, reason))?.map(Arc::from);
            continue;
        }
        step.values[i] =
            block.params[i].value_from_json(value).map_err(|reason| invalid(file, &place, reason))?;
    }
    Ok(step)
}

/// Returns the output channels of a block for the given input channels, or an error if the block cannot
/// process them.
fn check_channels(file: &str, place: &str, step: &Step, channels: Channels) -> Result<Channels> {
    let block = step.block;
    let place = format!("{place} ({})", block.id);
    match (block.input, channels) {
        (Channels::Luma, Channels::Color) => {
            Err(invalid(file, &place, "needs gray: put To GrayScale (to_gray) before it"))
        }
        (Channels::Color, Channels::Luma) => {
            Err(invalid(file, &place, "needs colour: put To Color (to_color) or Colorize before it"))
        }
        _ => Ok(step.block.given(channels, step.part)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(json: &str) -> String {
        let error = Style::parse("bad.json", json).unwrap_err();
        assert_eq!(error.code(), "invalid-style");
        error.to_string()
    }

    #[test]
    fn a_missing_parameter_is_its_default() {
        let style = Style::parse("x.json", r#"{"background":[{"block":"xdog","sigma":2}]}"#).unwrap();
        assert_eq!((style.id.as_str(), style.background[0].values.as_slice()), ("x", [2.0, 20.0].as_slice()));
        assert!(style.foreground.is_none());
    }

    #[test]
    fn a_block_for_the_background_keeps_the_colours_of_the_subject() {
        let keeps = |part: &str| {
            let json = format!(r#"{{"background":[{{"block":"painter","colours":0{part}}}]}}"#);
            Style::parse("x.json", &json).unwrap().keeps_colours()
        };
        assert!(keeps(r#","where":"background""#));
        assert!(!keeps(r#","where":"subject""#) && !keeps(""));
    }

    #[test]
    fn the_ends_of_every_range_are_in_it() {
        for block in blocks::ALL {
            for param in block.params.iter().filter(|param| matches!(param.kind, Kind::Number { .. })) {
                let (min, max) = param.kind.range();
                for end in [min, max] {
                    // The shortest decimal of this f32.
                    let value: Value = serde_json::from_str(&end.to_string()).unwrap();
                    assert_eq!(param.value_from_json(&value), Ok(end), "{} {}", block.id, param.id);
                }
            }
        }
    }

    #[test]
    fn what_is_written_reads_back_the_same() {
        let json = r##"{"id":"a","name":"A","tags":["ink"],"background":[{"block":"posterize","levels":5,
            "bypass":true},{"block":"gaussian","sigma":1.2,"where":"background"},
            {"block":"painter","painter":12.5,"model":"00112233445566ff my own.onnx"}],
            "foreground":[{"block":"sobel","invert":true}],"where":{"foreground":"subject"},"ink":"#101014"}"##;
        let value = Style::parse("a.json", json).unwrap().to_value();
        assert_eq!(value, serde_json::from_str::<Value>(json).unwrap());
    }

    #[test]
    fn errors_name_the_file_the_place_and_the_reason() {
        let cases = [
            ("", "is not valid JSON"),
            ("[]", "must be an object"),
            ("{}", "background: is missing"),
            (r#"{"background":5}"#, "background: must be a list"),
            (r#"{"background":[5]}"#, "background[0]: must be an object"),
            (r#"{"background":[{}]}"#, "background[0]: needs a \"block\""),
            (r#"{"background":[{"block":"nope"}]}"#, "there is no block \"nope\""),
            (
                r#"{"background":[{"block":"posterize","level":4}]}"#,
                "background[0] (posterize), level: is not a parameter of this block (levels)",
            ),
            (r#"{"background":[{"block":"posterize","levels":1}]}"#, "is 1, it must be from 2 to 64"),
            (r#"{"background":[{"block":"posterize","levels":2.5}]}"#, "must be a whole number"),
            (r#"{"background":[{"block":"gaussian","sigma":"2"}]}"#, "must be a number"),
            (r#"{"background":[{"block":"gaussian","sigma":1e9}]}"#, "must be from 0.3 to 50"),
            (r#"{"background":[{"block":"sobel","invert":1}]}"#, "must be true or false"),
            (r#"{"background":[{"block":"sobel","bypass":1}]}"#, "bypass: must be true or false"),
            (r#"{"background":[{"block":"sobel","where":"left"}]}"#, "must be \"subject\" or \"background\""),
            (r#"{"background":[{"block":"sobel","where":null}]}"#, "background[0] (sobel), where: is null"),
            (r#"{"background":[],"where":"subject"}"#, "where: must be an object"),
            (
                r#"{"background":[],"where":{"middle":"subject"}}"#,
                "where, middle: must be background or foreground",
            ),
            (r#"{"background":[],"where":{"foreground":1}}"#, "where, foreground: is 1, it must be"),
            (
                r#"{"background":[{"block":"to_gray","where":"subject"},{"block":"pattern"}]}"#,
                "background[1] (pattern): needs gray",
            ),
            (
                r#"{"background":[{"block":"painter","model":5}]}"#,
                "model: must be a text, 16 hexadecimal digits",
            ),
            (r#"{"background":[{"block":"painter","model":"own.onnx"}]}"#, "model: must be a text"),
            (r#"{"background":[{"block":"painter","painter":65}]}"#, "is 65, it must be from 1 to 64"),
            (r#"{"background":[],"ink":"red"}"#, "ink: is \"red\", it must be a colour"),
            (r#"{"background":[],"id":""}"#, "id: must be a text"),
            (r#"{"background":[],"tags":[1]}"#, "tags: must be a list"),
            (r#"{"background":[],"layers":[]}"#, "layers: is not a field of a style"),
            (
                r#"{"background":[{"block":"to_gray"},{"block":"saturation"}]}"#,
                "background[1] (saturation): needs colour",
            ),
        ];
        for (json, expected) in cases {
            let message = error(json);
            assert!(message.contains("bad.json") && message.contains(expected), "{json}: {message}");
        }
    }

    #[test]
    fn a_bypassed_block_does_not_count_for_the_channel_rules() {
        let json = r#"{"background":[{"block":"to_gray","bypass":true},{"block":"saturation"}]}"#;
        assert!(Style::parse("x", json).is_ok());
    }
}
