//! wasm bindings of storyboards in the exports module: sheets as pages, edit lists, and plans of animatics
//! and motion comics.
//!
//! Errors are like in the `words` module.

use crate::letters::Lettering;
use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::output::animatic::{self, Animatic};
use inkpanel_engine::output::board::Request;
use inkpanel_engine::output::motion;
use inkpanel_engine::output::shots::{Kind, ShotList};
use wasm_bindgen::prelude::*;

/// The text of a list of shots (a `ShotList` as JSON) as a file of that ending: csv, edl, otio or xml.
///
/// # Errors
/// `invalid-document` for an invalid list or another file type.
#[wasm_bindgen(js_name = shotFile)]
pub fn shot_file(ending: &str, list: &str) -> Result<String> {
    let kind = Kind::of(ending).ok_or_else(|| Error::InvalidDocument {
        location: "kind".into(),
        reason: format!("{ending} must be one of csv, edl, otio, xml"),
    })?;
    Ok(ShotList::parse(list)?.written(kind))
}

/// The sheets of a board (a `Request` of `output::board` as JSON): a list of pages.
///
/// # Errors
/// `invalid-document` for an invalid request; style errors.
#[wasm_bindgen(js_name = boardSheets)]
pub fn board_sheets(request: &str) -> Result<String> {
    let sheets = Request::parse(request)?.sheets()?;
    let pages: Vec<String> = sheets.iter().map(inkpanel_engine::page::Document::to_json).collect();
    Ok(format!("[{}]", pages.join(",")))
}

/// An animatic: its timed shots, and the content of each frame.
#[wasm_bindgen]
pub struct AnimaticPlan {
    plan: Animatic,
}

#[wasm_bindgen]
impl AnimaticPlan {
    /// Plans an animatic from a `Request` of `output::animatic` as JSON.
    ///
    /// # Errors
    /// `invalid-document` for an invalid request or shots that cannot be shown; style errors.
    #[wasm_bindgen(constructor)]
    pub fn new(request: &str) -> Result<Self> {
        Ok(Self { plan: animatic::Request::parse(request)?.planned()? })
    }

    /// Plans a motion comic from a `Request` of `output::motion` as JSON.
    ///
    /// # Errors
    /// `invalid-document` for an invalid request or pages that cannot be read; layout and text errors.
    pub fn pages(request: &str, letters: &Lettering) -> Result<AnimaticPlan> {
        Ok(Self { plan: motion::Request::parse(request)?.planned(letters.letters())? })
    }

    /// The `Animatic` as JSON.
    ///
    /// # Errors
    /// `invalid-document` if the plan cannot be written.
    pub fn json(&self) -> Result<String> {
        let written = |error: serde_json::Error| Error::InvalidDocument {
            location: "animatic".into(),
            reason: error.to_string(),
        };
        serde_json::to_string(&self.plan).map_err(written)
    }

    /// Content of each frame, see `Animatic::table`.
    #[must_use]
    pub fn table(&self) -> Vec<f32> {
        self.plan.table()
    }
}
