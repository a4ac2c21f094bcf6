//! Lists of blocks, styles and layouts as JSON, for the app and the command line.

use crate::error::{Error, Result};
use crate::framing::Expression;
use crate::layout;
use crate::select::{self, Measures};
use crate::style::blocks::{self, Block, Channels};
use crate::style::catalogue;
use crate::style::file::decimal;
use crate::style::params::{Kind, Param};
use serde::{Deserialize, Serialize};
use serde_json::{Number, Value};

/// A filter block, as data for its controls.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Block"))]
pub struct BlockEntry {
    /// Name in style files.
    pub id: &'static str,
    /// Display name: the technical term.
    pub label: &'static str,
    /// Plain name, if the label is a technical term.
    #[serde(skip_serializing_if = "str::is_empty")]
    #[cfg_attr(test, ts(as = "Option<String>", optional))]
    pub plain: &'static str,
    /// Description in one line.
    pub help: &'static str,
    /// Channels of the input.
    pub input: Channels,
    /// Channels of the output.
    pub output: Channels,
    /// Its parameters.
    pub params: Vec<ParamEntry>,
}

/// A parameter of a block.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BlockParam", optional_fields))]
pub struct ParamEntry {
    /// Key in a style file.
    pub id: &'static str,
    /// Name of the control.
    pub label: &'static str,
    /// Description in one line.
    pub help: &'static str,
    /// Type and range.
    pub kind: ParamKind,
    /// Default value in style files.
    #[cfg_attr(test, ts(type = "ParamValue"))]
    pub default: Value,
    /// Smallest value of a number.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub min: Option<Number>,
    /// Its largest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub max: Option<Number>,
    /// Step of its slider.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub step: Option<Number>,
    /// Unit symbol.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<&'static str>,
    /// The names to choose from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub choices: Option<&'static [&'static str]>,
}

/// Type of a parameter.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ParamKind {
    /// A number.
    Number,
    /// A whole number.
    Integer,
    /// True or false.
    Boolean,
    /// One of some names.
    Choice,
    /// A custom image: its data URL, or an empty text.
    Texture,
    /// A model of the user: a reference, or an empty text.
    Model,
    /// `#rrggbb`.
    Colour,
}

/// All filter blocks.
#[must_use]
pub fn blocks() -> Vec<BlockEntry> {
    blocks::ALL.iter().copied().map(block).collect()
}

/// All page templates.
#[must_use]
pub fn layouts() -> Vec<layout::Descriptor<'static>> {
    layout::catalogue().iter().map(layout::Template::descriptor).collect()
}

/// All designed styles, family by family, as style files.
#[must_use]
pub fn styles() -> Value {
    catalogue::by_family().into_iter().map(crate::style::Style::to_value).collect()
}

fn block(block: &Block) -> BlockEntry {
    BlockEntry {
        id: block.id,
        label: block.label,
        plain: block.plain,
        help: block.help,
        input: block.input,
        output: block.output,
        params: block.params.iter().map(param).collect(),
    }
}

fn param(param: &Param) -> ParamEntry {
    let entry = ParamEntry {
        id: param.id,
        label: param.label,
        help: param.help,
        kind: ParamKind::Boolean,
        default: Value::Null,
        min: None,
        max: None,
        step: None,
        unit: None,
        choices: None,
    };
    let range = |entry, [min, max, step]: [Option<Number>; 3]| ParamEntry { min, max, step, ..entry };
    match param.kind {
        Kind::Number { default, min, max, step, unit } => {
            let entry = range(entry, [min, max, step].map(|value| Number::from_f64(decimal(value))));
            let default = decimal(default).into();
            ParamEntry { kind: ParamKind::Number, default, unit: Some(unit.sign()), ..entry }
        }
        Kind::Integer { default, min, max } => {
            let entry = range(entry, [min, max, 1].map(|value| Some(value.into())));
            ParamEntry { kind: ParamKind::Integer, default: default.into(), ..entry }
        }
        Kind::Flag { default } => ParamEntry { default: default.into(), ..entry },
        Kind::Choice { names } => {
            let default = names.first().copied().into();
            ParamEntry { kind: ParamKind::Choice, default, choices: Some(names), ..entry }
        }
        Kind::Texture => ParamEntry { kind: ParamKind::Texture, default: "".into(), ..entry },
        Kind::Model => ParamEntry { kind: ParamKind::Model, default: "".into(), ..entry },
        Kind::Colour { .. } => ParamEntry {
            kind: ParamKind::Colour,
            default: param.value_to_json(param.kind.default()),
            ..entry
        },
    }
}

/// Measurements for the selection, as JSON.
#[derive(Debug, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Measures"))]
pub struct MeasuresEntry {
    /// The 64-bit fingerprint in 16 hexadecimal digits.
    pub fingerprint: String,
    /// Sharpness, comparable between photos that show the same.
    pub gradient: f32,
    /// Sharpness by the measure of Garcia-Dorado et al., see `select::sharpness::paper`.
    pub paper: f32,
    /// Sharpness, comparable across an album.
    pub laplacian: f32,
}

impl From<&Measures> for MeasuresEntry {
    fn from(measures: &Measures) -> Self {
        let Measures { fingerprint, gradient, paper, laplacian } = *measures;
        Self { fingerprint: format!("{fingerprint:016x}"), gradient, paper, laplacian }
    }
}

/// Request of a selection.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ChoiceRequest {
    /// All photos.
    photos: Vec<Candidate>,
    /// Maximum fingerprint distance of near-duplicates, in bits of 64.
    #[serde(default)]
    #[cfg_attr(test, ts(optional))]
    duplicate_threshold: Option<u32>,
}

/// A photo that may be worth a panel.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Candidate {
    /// Its id.
    id: String,
    /// Display name.
    name: String,
    /// See [`MeasuresEntry`].
    fingerprint: String,
    /// See [`MeasuresEntry`].
    gradient: f32,
    /// See [`MeasuresEntry`].
    paper: f32,
    /// See [`MeasuresEntry`].
    laplacian: f32,
    /// The video that it is a frame of.
    #[serde(default)]
    #[cfg_attr(test, ts(optional = nullable))]
    film: Option<String>,
    /// The faces whose eyes are known.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    faces: Vec<Expression>,
}

/// The selection's verdict on a photo.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Verdict"))]
pub struct VerdictEntry<'a> {
    /// Id of the photo.
    pub id: &'a str,
    /// Number of its group of look-alikes.
    pub group: usize,
    /// Whether it is used.
    pub kept: bool,
    /// The reason in a few English words.
    pub why: String,
    /// The reason.
    pub reason: select::Reason,
}

/// Which photos of a `ChoiceRequest` are worth a panel: a list of [`VerdictEntry`] in their order.
///
/// # Errors
/// `invalid-document` for JSON of another shape.
pub fn choose(json: &str) -> Result<String> {
    let invalid = |reason: String| Error::InvalidDocument { location: "photos".into(), reason };
    let wanted: ChoiceRequest = serde_json::from_str(json).map_err(|error| invalid(error.to_string()))?;
    let mut settings = select::Settings::default();
    if let Some(bits) = wanted.duplicate_threshold {
        settings.duplicate_threshold = bits;
    }
    let names: Vec<&str> = wanted.photos.iter().map(|photo| photo.name.as_str()).collect();
    let measures: Vec<Measures> = wanted
        .photos
        .iter()
        .map(|photo| {
            let fingerprint = u64::from_str_radix(&photo.fingerprint, 16)
                .map_err(|_| invalid(format!("\"{}\" is not a valid fingerprint", photo.fingerprint)))?;
            let Candidate { gradient, paper, laplacian, .. } = *photo;
            Ok(Measures { fingerprint, gradient, paper, laplacian })
        })
        .collect::<Result<_>>()?;
    let films: Vec<Option<&str>> = wanted.photos.iter().map(|photo| photo.film.as_deref()).collect();
    // A video is identified by the index of its first frame.
    let first = |film: Option<&str>| film.and_then(|_| films.iter().position(|other| *other == film));
    settings.films = films.iter().copied().map(first).collect();
    let openness = |photo: &Candidate| photo.faces.iter().map(Expression::openness).min_by(f64::total_cmp);
    settings.openness = wanted.photos.iter().map(openness).collect();
    let verdicts = select::choose(&names, &measures, &settings);
    let entry = |(photo, verdict)| {
        let select::Verdict { group, kept, reason } = verdict;
        VerdictEntry { id: photo, group, kept, why: reason.to_string(), reason }
    };
    let ids = wanted.photos.iter().map(|photo| photo.id.as_str());
    let answer: Vec<_> = ids.zip(verdicts).map(entry).collect();
    serde_json::to_string(&answer).map_err(|error| Error::Encode(error.to_string()))
}
