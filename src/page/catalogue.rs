//! What there is to choose from, as JSON: the same answers for the page and the command line.

use crate::error::{Error, Result};
use crate::layout;
use crate::select::{self, Measures};
use crate::style::blocks::{self, Block, Channels};
use crate::style::catalogue;
use crate::style::params::{Kind, Param};
use serde::Deserialize;
use serde_json::{Map, Value, json};

/// Descriptors of all filter blocks.
#[must_use]
pub fn blocks() -> Value {
    blocks::ALL.iter().copied().map(block).collect()
}

/// All page templates.
#[must_use]
pub fn layouts() -> Value {
    layout::catalogue().iter().map(layout::Template::descriptor).collect()
}

/// All designed styles, family by family.
#[must_use]
pub fn styles() -> Value {
    catalogue::by_family().into_iter().map(crate::style::Style::to_value).collect()
}

fn block(block: &Block) -> Value {
    json!({
        "id": block.id,
        "label": block.label,
        "help": block.help,
        "input": channels(block.input),
        "output": channels(block.output),
        "params": block.params.iter().map(param).collect::<Vec<_>>(),
    })
}

fn channels(channels: Channels) -> &'static str {
    match channels {
        Channels::Luma => "luma",
        Channels::Color => "color",
        Channels::Any => "any",
    }
}

fn param(param: &Param) -> Value {
    let mut map = Map::new();
    let mut set = |key: &str, value: Value| map.insert(key.to_owned(), value);
    set("id", json!(param.id));
    set("label", json!(param.label));
    set("help", json!(param.help));
    match param.kind {
        Kind::Number { default, min, max, step, unit } => {
            set("kind", json!("number"));
            for (key, value) in [("default", default), ("min", min), ("max", max), ("step", step)] {
                set(key, decimal(value));
            }
            set("unit", json!(unit.sign()));
        }
        Kind::Integer { default, min, max } => {
            set("kind", json!("integer"));
            for (key, value) in [("default", default), ("min", min), ("max", max), ("step", 1)] {
                set(key, json!(value));
            }
        }
        Kind::Flag { default } => {
            set("kind", json!("boolean"));
            set("default", json!(default));
        }
        Kind::Choice { names } => {
            set("kind", json!("choice"));
            set("default", json!(names.first()));
            set("choices", json!(names));
        }
    }
    Value::Object(map)
}

/// An f32 as the decimal that a person wrote.
fn decimal(value: f32) -> Value {
    json!(value.to_string().parse::<f64>().unwrap_or(f64::from(value)))
}

/// A photo's measures.
#[must_use]
pub fn measures(measures: &Measures) -> Value {
    json!({
        "fingerprint": format!("{:016x}", measures.fingerprint),
        "gradient": measures.gradient,
        "paper": measures.paper,
        "laplacian": measures.laplacian,
    })
}

/// Which photos of `{photos: [{id, name, fingerprint, gradient, paper, laplacian}], threshold}` are worth a
/// panel: `[{id, group, kept, why}]`.
///
/// # Errors
/// `invalid-document` for JSON of another shape.
pub fn choose(json: &str) -> Result<String> {
    #[derive(Deserialize)]
    struct Wanted {
        photos: Vec<Photo>,
        #[serde(default)]
        threshold: Option<u32>,
    }
    #[derive(Deserialize)]
    struct Photo {
        id: String,
        name: String,
        fingerprint: String,
        gradient: f32,
        paper: f32,
        laplacian: f32,
    }
    let invalid = |reason: String| Error::InvalidDocument { location: "photos".into(), reason };
    let wanted: Wanted = serde_json::from_str(json).map_err(|error| invalid(error.to_string()))?;
    let mut settings = select::Settings::default();
    if let Some(threshold) = wanted.threshold {
        settings.threshold = threshold;
    }
    let names: Vec<&str> = wanted.photos.iter().map(|photo| photo.name.as_str()).collect();
    let measures: Vec<Measures> = wanted
        .photos
        .iter()
        .map(|photo| {
            let fingerprint = u64::from_str_radix(&photo.fingerprint, 16)
                .map_err(|_| invalid(format!("\"{}\" is no fingerprint", photo.fingerprint)))?;
            let Photo { gradient, paper, laplacian, .. } = *photo;
            Ok(Measures { fingerprint, gradient, paper, laplacian })
        })
        .collect::<Result<_>>()?;
    let verdicts = select::choose(&names, &measures, &settings);
    let answer: Value = wanted
        .photos
        .iter()
        .zip(verdicts)
        .map(|(photo, verdict)| {
            json!({ "id": photo.id, "group": verdict.group, "kept": verdict.kept, "why": verdict.why })
        })
        .collect();
    Ok(answer.to_string())
}
