//! Styles in the app: design, generation, combination and scores.

use super::{Patch, Studio, parse, style_of};
use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::page::{Document, StyleRef, plates};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::resize::{Region, fit, resample_image};
use inkpanel_engine::style::aesthetic::{Fault, Judgement, judge};
use inkpanel_engine::style::stages::{Layer, Stages};
use inkpanel_engine::style::{Style, breeding, look, procedural, stylize};
use serde::Deserialize;
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Number of photos with cached stages: the visible ones, and the previous one.
const MOST_DESIGNS: usize = 5;

/// Cached stages of designs, most recently used first.
#[derive(Default)]
pub(super) struct Designs(Vec<(String, Stages)>);

impl Designs {
    /// Drops the cached stages of a photo whose subject mask changed.
    pub(super) fn forget(&mut self, key: &str) {
        self.0.retain(|(name, _)| !name.strip_prefix(key).is_some_and(|rest| rest.starts_with(' ')));
    }
}

/// The style of a seed, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn invent_style(seed: u32) -> String {
    procedural::invent(seed).to_value().to_string()
}

/// The inks of a document's style, the strongest last, and the document for drawing plates: `{inks: [{name,
/// rgb}], document}` as JSON. `null` if the style has no printing plates.
#[wasm_bindgen]
pub fn plates_of(document: &str) -> Result<String> {
    let page = Document::parse(document)?;
    let Some(inks) = plates::inks(&*page.style()?) else { return Ok("null".into()) };
    let inks: Vec<Value> = inks.iter().map(|ink| json!({ "name": ink.name, "rgb": ink.rgb })).collect();
    Ok(format!("{{\"inks\":{},\"document\":{}}}", json!(inks), plates::exact(&page)?.to_json()))
}

/// A child of `{a, b, seed, surprise}`, as JSON; `a` and `b` are styles, by id or in full.
#[wasm_bindgen]
pub fn breed_style(json: &str) -> Result<String> {
    #[derive(Deserialize)]
    struct Wanted {
        a: StyleRef,
        b: StyleRef,
        #[serde(default)]
        seed: f64,
        #[serde(default)]
        surprise: f64,
    }
    let Wanted { a, b, seed, surprise } = parse(json, "request")?;
    Ok(breeding::breed(&*a.style()?, &*b.style()?, seed as u32, surprise).to_value().to_string())
}

/// A styled image and its properties.
#[wasm_bindgen]
pub struct Explored {
    judgement: Judgement,
    look: look::Look,
    signature: Vec<u8>,
    picture: Image,
}

#[wasm_bindgen]
impl Explored {
    /// The light score, 0 to 1.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn score(&self) -> f64 {
        self.judgement.score
    }

    /// Factor for any score, 0.5 to 1.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn novelty(&self) -> f64 {
        self.judgement.novelty
    }

    /// Problem of the image, or an empty string.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn fault(&self) -> String {
        self.judgement.fault.map_or("", Fault::id).to_owned()
    }

    /// `line`, `gray`, `flat` or `wild`.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn look(&self) -> String {
        self.look.id().to_owned()
    }

    /// See [`look::signature`].
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn signature(&self) -> Vec<u8> {
        self.signature.clone()
    }

    /// The image.
    #[must_use]
    pub fn patch(&self) -> Patch {
        patch(&self.picture)
    }
}

#[wasm_bindgen]
impl Studio {
    /// Sets a style for a photo at a size. Only changed blocks run again. Call `design_step` until it returns
    /// -1.
    pub fn design(&mut self, key: &str, style: &str, width: usize, height: usize) -> Result<()> {
        let style = style_of(style)?;
        let name = format!("{key} {width} {height}");
        let at = self.designs.0.iter().position(|(known, _)| *known == name);
        let (_, mut stages) = match at {
            Some(at) => self.designs.0.remove(at),
            None => (String::new(), self.staged(key, (width, height))?),
        };
        stages.set(style);
        self.designs.0.truncate(MOST_DESIGNS - 1);
        self.designs.0.insert(0, (name, stages));
        Ok(())
    }

    /// Runs the next block of the design. Returns its index, plus 256 in the foreground, or -1 at the end.
    pub fn design_step(&mut self) -> Result<i32> {
        let Some((_, stages)) = self.designs.0.first_mut() else { return Ok(-1) };
        let step = stages.advance(&mut self.context)?;
        Ok(step.map_or(-1, |(layer, index)| 256 * layer as i32 + index as i32))
    }

    /// Returns the result of the design after the blocks that already ran.
    pub fn design_result(&self) -> Result<Patch> {
        Ok(patch(&self.stages()?.result()))
    }

    /// The image after the block at `place` of `design_step`, at most `side` pixels long.
    pub fn design_stage(&self, place: usize, side: usize) -> Result<Patch> {
        let stages = self.stages()?;
        let layer = if place < 256 { Layer::Background } else { Layer::Foreground };
        let picture = stages.picture(layer, place % 256);
        let (width, height) = fit(picture.width(), picture.height(), side.max(1));
        Ok(patch(&sized(picture, width, height)))
    }

    /// A photo in a style at a size, with its score, its look and its signature.
    pub fn explore(&mut self, key: &str, style: &str, width: usize, height: usize) -> Result<Explored> {
        let (whole, photo) = self.whole(key, (width, height))?;
        self.context.fit_scale(&photo);
        let style: Style = style_of(style)?;
        self.show_subject(key, whole, &photo, &style);
        let picture = stylize(&photo, &style, &mut self.context)?;
        Ok(Explored {
            judgement: judge(&photo, &picture),
            look: look::look(&picture),
            signature: look::signature(&picture),
            picture,
        })
    }
}

impl Studio {
    /// A photo at a size without processed blocks, with its subject mask, because blocks for a part may
    /// follow.
    fn staged(&self, key: &str, size: (usize, usize)) -> Result<Stages> {
        let (whole, picture) = self.whole(key, size)?;
        let subject = self.subject_in(key, whole, &picture);
        Ok(Stages::new(picture, subject))
    }

    /// All of a photo, at its own size and at another.
    fn whole(&self, key: &str, (width, height): (usize, usize)) -> Result<(Region, Image)> {
        let photo = self.photo(key)?;
        Ok((Region::whole(photo.width(), photo.height()), sized(photo, width, height)))
    }

    fn stages(&self) -> Result<&Stages> {
        let first = self.designs.0.first().map(|(_, stages)| stages);
        first.ok_or_else(|| Error::Encode("no design is open".into()))
    }
}

fn sized(image: &Image, width: usize, height: usize) -> Image {
    resample_image(image, Region::whole(image.width(), image.height()), width.max(1), height.max(1))
}

fn patch(image: &Image) -> Patch {
    Patch::whole(image.width(), image.height(), image.to_rgba())
}
