//! wasm bindings of the module for styles from a picture, loaded with the first such picture. A worker
//! measures the picture and tries styles on a photo. The main thread controls the search. Photos come from
//! the core as planes. The measurements are JSON that only this module reads.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use inkpanel_engine::error::Result;
use inkpanel_engine::json::plain as parse;
use inkpanel_engine::raster::Image;
use inkpanel_engine::style::imitate::{self, Ask, Features, Search, Seen, Trial};
use inkpanel_engine::style::painters::Painters;
use inkpanel_engine::style::{Context, Style};
use serde_json::{Value, json};
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The look of a picture as JSON. Throws `small-picture`, `blank-picture` or `plain-photo` if the image has
/// no style.
///
/// `planes` are its red, green and blue samples, one plane after the other. `anyway` accepts all images that
/// are large enough.
#[wasm_bindgen]
pub fn picture_look(width: usize, height: usize, planes: &[u8], anyway: bool) -> Result<String> {
    let reader = if anyway { imitate::read_any } else { imitate::read };
    Ok(told(&reader(&Image::from_rgb_planes(width, height, planes)?)?))
}

/// A photo on which a worker tries styles, and its scratch memory.
#[wasm_bindgen]
pub struct Sitter {
    photo: Image,
    context: Context<'static>,
    /// The photo as the last trial saw it, and how that was.
    seen: Option<((usize, bool), Seen)>,
}

#[wasm_bindgen]
impl Sitter {
    /// `planes` are the photo's red, green and blue samples, one plane after the other.
    #[wasm_bindgen(constructor)]
    pub fn new(width: usize, height: usize, planes: &[u8]) -> Result<Sitter> {
        let photo = Image::from_rgb_planes(width, height, planes)?;
        Ok(Self { photo, context: Context::default(), seen: None })
    }

    /// Sets the model of the block Painter, if it is unknown. Throws `invalid-painters`.
    pub fn know_painters(&mut self, onnx: &[u8]) -> Result<()> {
        if !self.context.has_painters() {
            let painters = Painters::new(onnx)?;
            self.context.show_painters(Some(Arc::new(painters)));
        }
        Ok(())
    }

    /// Result of a style that the search requested, as JSON.
    pub fn try_look(&mut self, ask: &str) -> Result<String> {
        let wanted: Value = parse(ask, "trial")?;
        let ask = Ask {
            style: Style::from_value("trial", &wanted["style"])?,
            area: wanted["area"].as_u64().unwrap_or(1) as usize,
            close: wanted["close"].as_bool().unwrap_or_default(),
        };
        let how = (ask.area, ask.close);
        let seen = match self.seen.take() {
            Some((known, seen)) if known == how => seen,
            _ => Seen::of(&self.photo, &ask),
        };
        let trial = imitate::attempt(&seen, &ask.style, &mut self.context);
        self.seen = Some((how, seen));
        Ok(told(&trial?))
    }
}

fn told(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

fn asked(asks: Vec<Ask>) -> String {
    let asks = asks
        .into_iter()
        .map(|Ask { style, area, close }| json!({ "style": style.to_value(), "area": area, "close": close }));
    Value::Array(asks.collect()).to_string()
}

/// The first trials of most searches, in the form of [`Imitation::ask`]. They do not depend on the image.
#[wasm_bindgen]
#[must_use]
pub fn survey() -> String {
    asked(imitate::survey())
}

/// A search for styles that look like a picture.
#[wasm_bindgen]
pub struct Imitation(Search);

#[wasm_bindgen]
impl Imitation {
    /// Begins a search with the result of [`picture_look`].
    #[wasm_bindgen(constructor)]
    pub fn new(look: &str, seed: u32) -> Result<Self> {
        let look: Features = parse(look, "look")?;
        Ok(Self(Search::new(look, seed)))
    }

    /// The next trials, a JSON array for `try_look`; empty when the search is done.
    #[must_use]
    pub fn ask(&mut self) -> String {
        asked(self.0.ask())
    }

    /// Passes the results of the trials, in order: a JSON array, null for failures.
    pub fn tell(&mut self, trials: &str) -> Result<()> {
        let trials: Vec<Option<Trial>> = parse(trials, "trials")?;
        self.0.tell(trials);
        Ok(())
    }

    /// Progress of the search, 0 to 1, after `tried` of the last requested trials.
    #[must_use]
    pub fn progress(&self, tried: usize) -> f64 {
        self.0.progress(tried)
    }

    /// Three to six styles, the nearest first, a JSON array of style files with scores.
    #[must_use]
    pub fn proposals(&self) -> String {
        self.0.proposals().iter().map(Style::to_value).collect::<Value>().to_string()
    }
}
