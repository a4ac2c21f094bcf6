//! The page as plain data. The front end holds these documents, undoes to earlier ones and saves them; a
//! document and the photos that it names make exactly one picture.

use super::words::model::MOST_WORDS;
use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::json::{Fields, Read, Wrong, flag, list, name, number, whole};
use crate::layout::{self, PageSettings, Template};
use crate::style::{Style, catalogue};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::borrow::Cow;

/// Version of the shape below; a newer one is refused.
pub const VERSION: u32 = 1;
/// Most photos of a project, and with it of the order of a page.
pub const MOST_PHOTOS: usize = 5_000;
/// Most panels of a page: more than a layout has.
const MOST_PANELS: usize = 100;
/// Most characters of an id of a photo, a style or a layout.
pub const LONGEST_ID: usize = 200;
/// How far a crop may reach beyond its photo: numbers are rounded. And the least side of a crop.
const SLACK: f64 = 1e-6;

/// A storyboard page.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Document {
    /// [`VERSION`].
    pub version: u32,
    /// Seed of the shuffle that made it.
    pub seed: u32,
    /// Id of a layout, or a template in full.
    pub layout: Value,
    /// Id of a style, or a style in full.
    pub style: Value,
    /// Photos in reading order; there may be more than panels.
    pub order: Vec<String>,
    /// What each panel shows, in paint order.
    pub panels: Vec<PanelContent>,
    /// Groups of panels that share one image.
    pub merges: Vec<Vec<usize>>,
    /// Size, gutters and colours.
    pub page: PageSettings,
    /// Words on the page, as [`Word`](super::words::Word) has them, in paint order. Whoever draws them checks them.
    pub words: Vec<Value>,
    /// Fields that this program does not know, kept for one that does.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

/// What one panel shows.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct PanelContent {
    /// Id of the photo; none leaves the panel empty.
    pub photo: Option<String>,
    /// The part of the photo that fills the panel, or the group it is merged into.
    pub crop: Option<Crop>,
    /// Kept by every shuffle.
    pub locked: bool,
    /// The crop was made by hand: it stays while the photo stays in this panel.
    pub edited: bool,
    /// Fields that this program does not know, kept for one that does.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

impl<'de> Deserialize<'de> for Document {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        Self::read(Value::deserialize(deserializer)?).map_err(serde::de::Error::custom)
    }
}

impl Document {
    /// Reads a document.
    ///
    /// # Errors
    /// `invalid-document` for anything but a document of this version.
    pub fn parse(json: &str) -> Result<Self> {
        let value = serde_json::from_str(json).map_err(|error| invalid("document", error.to_string()))?;
        let document = Self::read(value).map_err(|wrong| invalid(&wrong.place, wrong.reason))?;
        document.page.validate()?;
        Ok(document)
    }

    /// Reads a document that stands in another. Whether its layout, style, words and settings are good is not asked.
    ///
    /// # Errors
    /// With the place of what is wrong.
    pub fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let known = u64::from(VERSION);
        match whole(1..=u64::MAX)(fields.required("version")?).map_err(|wrong| wrong.at("version"))? {
            version if version > known => return Err(Wrong::newer(version, known).at("version")),
            _ => {}
        }
        let seed =
            whole(0..=u64::from(u32::MAX))(fields.required("seed")?).map_err(|wrong| wrong.at("seed"))?;
        let panels = list(MOST_PANELS, PanelContent::read)(fields.required("panels")?);
        let panels = panels.map_err(|wrong| wrong.at("panels"))?;
        let panel = |value| whole(0..=MOST_PANELS as u64)(value).map(|panel| panel as usize);
        let merges = fields.read("merges", list(MOST_PANELS, list(MOST_PANELS, panel)))?;
        let document = Self {
            version: VERSION,
            seed: seed as u32,
            layout: fields.required("layout")?,
            style: fields.required("style")?,
            order: fields.read("order", list(MOST_PHOTOS, name(LONGEST_ID)))?.unwrap_or_default(),
            panels,
            // A panel shares its image with others, or with none.
            merges: merges
                .unwrap_or_default()
                .into_iter()
                .filter(|group: &Vec<usize>| group.len() > 1)
                .collect(),
            page: fields.read("page", PageSettings::read)?.unwrap_or_default(),
            words: fields.read("words", list(MOST_WORDS, Ok))?.unwrap_or_default(),
            rest: fields.rest(),
        };
        document.check_merges().map_err(|wrong| wrong.at("merges"))?;
        Ok(document)
    }

    fn check_merges(&self) -> Read<()> {
        let mut seen = vec![false; self.panels.len()];
        for &panel in self.merges.iter().flatten() {
            match seen.get_mut(panel) {
                Some(seen) if !*seen => *seen = true,
                _ => return Err(Wrong::new(format!("panel {panel} is missing or merged twice"))),
            }
        }
        Ok(())
    }

    /// The template of the page.
    ///
    /// # Errors
    /// `unknown-layout`, `invalid-layout`.
    pub fn template(&self) -> Result<Cow<'static, Template>> {
        template_of(&self.layout)
    }

    /// The style of the page.
    ///
    /// # Errors
    /// `unknown-style`, `invalid-style`.
    pub fn style(&self) -> Result<Cow<'static, Style>> {
        style_of(&self.style)
    }

    /// The group of panels that panel `index` is merged into, itself among them.
    #[must_use]
    pub fn merge_of(&self, index: usize) -> Option<&[usize]> {
        self.merges.iter().find(|group| group.contains(&index)).map(Vec::as_slice)
    }
}

impl PanelContent {
    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        Ok(Self {
            photo: fields.nullable("photo", name(LONGEST_ID))?,
            crop: fields.nullable("crop", crop)?,
            locked: fields.nullable("locked", flag)?.unwrap_or_default(),
            edited: fields.nullable("edited", flag)?.unwrap_or_default(),
            rest: fields.rest(),
        })
    }
}

/// A crop, which must lie inside of its photo.
fn crop(value: Value) -> Read<Crop> {
    let mut fields = Fields::of(value)?;
    let mut side = |name: &str, range| number(range)(fields.required(name)?).map_err(|wrong| wrong.at(name));
    let (x, y) = (side("x", -SLACK..=1.0)?, side("y", -SLACK..=1.0)?);
    let sides = SLACK..=1.0 + SLACK;
    let (width, height) = (side("width", sides.clone())?, side("height", sides)?);
    fields.done()?;
    if x + width > 1.0 + SLACK || y + height > 1.0 + SLACK {
        return Err(Wrong::new("reaches beyond the photo"));
    }
    Ok(Crop { x, y, width, height })
}

/// A template by id, or one given in full.
///
/// # Errors
/// `unknown-layout`, `invalid-layout`.
pub fn template_of(value: &Value) -> Result<Cow<'static, Template>> {
    match value {
        Value::String(id) => layout::find(id).map(Cow::Borrowed),
        other => Template::parse("layout of the page", &other.to_string()).map(Cow::Owned),
    }
}

/// A style by id, or one given in full.
///
/// # Errors
/// `unknown-style`, `invalid-style`.
pub fn style_of(value: &Value) -> Result<Cow<'static, Style>> {
    match value {
        Value::String(id) => catalogue::find(id).map(Cow::Borrowed),
        other => Style::from_value("style of the page", other).map(Cow::Owned),
    }
}

fn invalid(location: &str, reason: impl Into<String>) -> Error {
    Error::InvalidDocument { location: location.to_owned(), reason: reason.into() }
}
