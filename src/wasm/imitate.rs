//! Styles from a picture: a worker measures the picture and tries styles on a photo, the page leads the search. What is
//! measured crosses as JSON that only the core reads.

use super::{Studio, parse, style_of, thrown};
use crate::error::{Error, Result};
use crate::style::Style;
use crate::style::imitate::{self, Ask, Features, Search, Seen, Trial};
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Studio {
    /// The look of a picture that was imported, as JSON. Throws `small-picture`, `blank-picture` or `plain-photo` where
    /// there is nothing to imitate.
    /// `anyway` takes all but small ones.
    pub fn picture_look(&self, key: &str, anyway: bool) -> std::result::Result<String, JsValue> {
        let reader = if anyway { imitate::read_any } else { imitate::read };
        let read = || -> Result<String> { Ok(told(&reader(self.photo(key)?)?)) };
        read().map_err(thrown)
    }

    /// What comes of a style that a search asked for, as JSON.
    pub fn try_look(&mut self, key: &str, ask: &str) -> std::result::Result<String, JsValue> {
        let mut attempt = || -> Result<String> {
            let wanted: Value = parse(ask, "trial")?;
            let ask = Ask {
                style: style_of(&wanted["style"].to_string())?,
                area: wanted["area"].as_u64().unwrap_or(1) as usize,
                close: wanted["close"].as_bool().unwrap_or_default(),
            };
            let name = format!("{key} {} {}", ask.area, ask.close);
            if self.seen.as_ref().is_none_or(|(known, _)| *known != name) {
                self.seen = Some((name, Seen::of(self.photo(key)?, &ask)));
            }
            let seen = self
                .seen
                .as_ref()
                .map(|(_, seen)| seen)
                .ok_or_else(|| Error::MissingPhoto(key.to_owned()))?;
            Ok(told(&imitate::attempt(seen, &ask.style, &mut self.context)?))
        };
        attempt().map_err(thrown)
    }
}

fn told(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

/// A search for styles that look like a picture.
#[wasm_bindgen]
pub struct Imitation(Search);

#[wasm_bindgen]
impl Imitation {
    /// Begins with the look of a picture as `picture_look` tells it.
    #[wasm_bindgen(constructor)]
    pub fn new(look: &str, seed: u32) -> std::result::Result<Self, JsValue> {
        let look: Features = parse(look, "look").map_err(thrown)?;
        Ok(Self(Search::new(look, seed)))
    }

    /// The next trials, a JSON array for `try_look`; empty when the search is done.
    #[must_use]
    pub fn ask(&mut self) -> String {
        let asks = self.0.ask().into_iter().map(
            |Ask { style, area, close }| json!({ "style": style.to_value(), "area": area, "close": close }),
        );
        Value::Array(asks.collect()).to_string()
    }

    /// What came of them, in their order: a JSON array, null for what failed.
    pub fn tell(&mut self, trials: &str) -> std::result::Result<(), JsValue> {
        let trials: Vec<Option<Trial>> = parse(trials, "trials").map_err(thrown)?;
        self.0.tell(trials);
        Ok(())
    }

    /// How far it is, 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.0.progress()
    }

    /// Three to six styles, the nearest first, a JSON array of style files with scores.
    #[must_use]
    pub fn proposals(&self) -> String {
        self.0.proposals().iter().map(Style::to_value).collect::<Value>().to_string()
    }
}
