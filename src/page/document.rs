//! The page as plain data. The front end stores, undoes and saves these documents. A document and its photos
//! give exactly one image.

use super::words::model::MOST_WORDS;
use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::json::typed::{is_default, nullable, typed};
use crate::json::{Fields, Read, Writer, Wrong, each, fields, items};
use crate::layout::{self, PageSettings, Template};
use crate::raster::Matte;
use crate::style::{Style, catalogue, earlier};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::borrow::Cow;

/// Version of the shape below; a newer one is refused.
pub const VERSION: u32 = 1;
/// Most photos of a project, and with it of the order of a page.
pub const MOST_PHOTOS: usize = 5_000;
/// Most panels of a page: more than a layout has.
const MOST_PANELS: usize = 100;
/// Maximum number of faces of a panel. With more, faces are too small to protect.
pub const MOST_FACES: usize = 64;
/// Most characters of an id of a photo, a style or a layout.
pub const LONGEST_ID: usize = 200;
/// How far a crop may reach beyond its photo: numbers are rounded. And the least side of a crop.
const SLACK: f64 = 1e-6;

/// A storyboard page.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(rename = "PageDocument"))]
pub struct Document {
    /// [`VERSION`].
    pub version: u32,
    /// Seed of the shuffle that made it.
    pub seed: u32,
    /// Id of a layout, or a template in full.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "LayoutChoice"))]
    pub layout: Value,
    /// Id of a style, or a style in full.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "StyleChoice"))]
    pub style: Value,
    /// Photos in reading order, possibly more than panels.
    pub order: Vec<String>,
    /// Content of each panel, in paint order.
    pub panels: Vec<PanelContent>,
    /// Groups of panels that share one image.
    pub merges: Vec<Vec<usize>>,
    /// Size, gutters and colours.
    pub page: PageSettings,
    /// The photos get one white point. Pages that were saved before this field have the colours of each photo.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub balanced: bool,
    /// Text items on the page, see [`Word`](super::words::Word), in paint order. The renderer checks them.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Vec<crate::typescript::Word>"))]
    pub words: Vec<Value>,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(all(test, feature = "cli"), ts(skip))]
    pub rest: Map<String, Value>,
}

/// A layout by its id, or in full.
#[cfg(all(test, feature = "cli"))]
#[derive(ts_rs::TS)]
#[ts(untagged)]
#[allow(dead_code, reason = "only for the TypeScript types")]
pub(crate) enum LayoutChoice {
    Id(String),
    Full(Template),
}

/// A style by its id, or in full.
#[cfg(all(test, feature = "cli"))]
#[derive(ts_rs::TS)]
#[ts(untagged)]
#[allow(dead_code, reason = "only for the TypeScript types")]
pub(crate) enum StyleChoice {
    Id(String),
    Full(Style),
}

/// Content of a panel.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(rename = "PanelUse"))]
pub struct PanelContent {
    /// Id of the photo; `None` for an empty panel.
    pub photo: Option<String>,
    /// The part of the photo that fills the panel, or the group it is merged into.
    pub crop: Option<Crop>,
    /// Faces of the photo, in fractions of it, which the style protects. Old pages have no faces here, and look unchanged.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<Vec<Crop>>", optional))]
    pub faces: Vec<Crop>,
    /// Subject mask of the photo for a panel breakout. `None` disables the breakout.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(all(test, feature = "cli"), ts(type = "string", optional))]
    pub figure: Option<Matte>,
    /// Whether the panel is a logo: no style, no border, and described as a logo.
    #[serde(deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub plain: bool,
    /// Whether every shuffle preserves the panel.
    #[serde(deserialize_with = "nullable")]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub locked: bool,
    /// Whether the crop is manual. It stays as long as the photo stays in this panel.
    #[serde(deserialize_with = "nullable")]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub edited: bool,
    /// Unknown fields, preserved for newer programs.
    #[serde(flatten)]
    #[cfg_attr(all(test, feature = "cli"), ts(skip))]
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
    /// Returns `invalid-document` if the JSON is not a document of this version.
    pub fn parse(json: &str) -> Result<Self> {
        let value = serde_json::from_str(json).map_err(|error| invalid("document", error.to_string()))?;
        let document = Self::read(value).map_err(|wrong| invalid(wrong.place(), wrong.reason()))?;
        document.page.validate()?;
        Ok(document)
    }

    /// Reads a document inside another document. Layout, style, text items and settings are not checked.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let known = u64::from(VERSION);
        let version = fields.count("version", 1, u64::MAX)?;
        if version > known {
            return Err(Wrong::newer(version, known).at("version"));
        }
        let page = fields.part("page", &mut PageSettings::read)?.unwrap_or_default();
        let mut order = Vec::new();
        for (i, id) in fields.list("order", MOST_PHOTOS)?.into_iter().enumerate() {
            order.push(fields::text_of(id, LONGEST_ID).map_err(|wrong| wrong.in_list(i).at("order"))?);
        }
        let panels = items(fields.required("panels")?, MOST_PANELS).and_then(|panels| {
            each(panels, &|panel| {
                let panel: PanelContent = typed(panel)?;
                panel.validate().map(|()| panel)
            })
        });
        let panels = panels.map_err(|wrong| wrong.at("panels"))?;
        let merges = fields.each("merges", MOST_PANELS, &|group| {
            let panel = |panel| fields::whole_of(&panel, 0, MOST_PANELS as u64).map(|panel| panel as usize);
            each(items(group, MOST_PANELS)?, &panel)
        })?;
        let document = Self {
            version: VERSION,
            seed: fields.count("seed", 0, u64::from(u32::MAX))? as u32,
            layout: fields.required("layout")?,
            style: earlier::told(fields.required("style")?),
            order,
            panels,
            // A panel shares its image with others, or with none.
            merges: merges.into_iter().filter(|group| group.len() > 1).collect(),
            page,
            balanced: fields.nullable("balanced").flag("balanced")?,
            words: fields.list("words", MOST_WORDS)?,
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
                _ => return Err(Wrong::new(&format!("panel {panel} is missing or merged twice"))),
            }
        }
        Ok(())
    }

    /// Writes the document, its fields in the order in which they are declared.
    pub fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("version").whole(u64::from(self.version));
        out.key("seed").whole(u64::from(self.seed));
        out.key("layout").value(&self.layout);
        out.key("style").value(&self.style);
        out.key("order").texts(&self.order);
        out.key("panels").put(&self.panels);
        out.key("merges")
            .list(&self.merges, &|out, group| out.list(group, &|out, panel| out.whole(*panel as u64)));
        out.key("page").put(&self.page);
        if self.balanced {
            out.key("balanced").flag(true);
        }
        out.key("words").list(&self.words, &|out, word| out.value(word));
        out.rest(&self.rest);
        out.close(b'}');
    }

    /// The document as JSON, which [`parse`](Self::parse) reads.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut out = Writer::default();
        self.write(&mut out);
        out.finish()
    }

    /// The template of the page.
    ///
    /// # Errors
    /// `unknown-layout`, `invalid-layout`.
    pub fn template(&self) -> Result<Cow<'static, Template>> {
        template_of(&self.layout)
    }

    /// The panels in the order in which they are read. Without a valid layout, it is the order of the document.
    #[must_use]
    pub fn reading_order(&self) -> Vec<usize> {
        let resolved =
            self.template().map(|template| layout::resolve(&template, self.page.aspect(), &self.page));
        resolved.map_or_else(
            |_| (0..self.panels.len()).collect(),
            |panels| layout::reading_order(&panels, self.page.rtl),
        )
    }

    /// The style of the page.
    ///
    /// # Errors
    /// `unknown-style`, `invalid-style`.
    pub fn style(&self) -> Result<Cow<'static, Style>> {
        style_of(&self.style)
    }

    /// Whether a panel has a breakout.
    #[must_use]
    pub fn breaks_frame(&self, index: usize) -> bool {
        self.panels.get(index).is_some_and(|panel| panel.figure.is_some() && panel.photo.is_some())
            && self.merge_of(index).is_none()
    }

    /// Panels whose subjects are in front of an effect, see [`Word::behind`](super::words::Word::behind);
    /// sorted, without duplicates. It uses plain data, so drawing panels does not need the `words` module.
    #[must_use]
    pub fn fronts(&self) -> Vec<usize> {
        let behind = |word: &Value| word["kind"] == "effect" && word["behind"] == true;
        let panels = self.words.iter().filter(|word| behind(word)).filter_map(|word| word["panel"].as_u64());
        let mut fronts: Vec<usize> =
            panels.map(|panel| panel as usize).filter(|panel| *panel < self.panels.len()).collect();
        fronts.sort_unstable();
        fronts.dedup();
        fronts
    }

    /// Index of the first foreground. Lower indices are the panels and the panel breakouts.
    #[must_use]
    pub fn first_front(&self) -> usize {
        self.panels.len() + (0..self.panels.len()).filter(|&i| self.breaks_frame(i)).count()
    }

    /// The group of panels that panel `index` is merged into, itself among them.
    #[must_use]
    pub fn merge_of(&self, index: usize) -> Option<&[usize]> {
        self.merges.iter().find(|group| group.contains(&index)).map(Vec::as_slice)
    }
}

impl PanelContent {
    /// Checks ids, crops and faces.
    ///
    /// # Errors
    /// Returns the location of the error.
    fn validate(&self) -> Read<()> {
        if self.photo.as_ref().is_some_and(|photo| photo.chars().nth(LONGEST_ID).is_some()) {
            return Err(Wrong::beyond(&format!("is longer than {LONGEST_ID} characters")).at("photo"));
        }
        if let Some(crop) = &self.crop {
            within_photo(crop).map_err(|wrong| wrong.at("crop"))?;
        }
        if self.faces.len() > MOST_FACES {
            let reason = format!("has {} entries, at most {MOST_FACES} are allowed", self.faces.len());
            return Err(Wrong::beyond(&reason).at("faces"));
        }
        // Faces may extend past the photo.
        let limits = [(-1.0, 2.0), (0.0, 2.0)];
        let faces = self.faces.iter().enumerate();
        faces.map(|(i, face)| in_limits(face, limits).map_err(|wrong| wrong.in_list(i).at("faces"))).collect()
    }
}

/// Checks that a crop is inside its photo.
fn within_photo(crop: &Crop) -> Read<()> {
    in_limits(crop, [(-SLACK, 1.0 + SLACK), (SLACK, 1.0 + SLACK)])?;
    if crop.x + crop.width > 1.0 + SLACK || crop.y + crop.height > 1.0 + SLACK {
        return Err(Wrong::new("reaches beyond the photo"));
    }
    Ok(())
}

/// Checks the position and the size of a rectangle.
fn in_limits(area: &Crop, [place, size]: [(f64, f64); 2]) -> Read<()> {
    let sides =
        [("x", area.x, place), ("y", area.y, place), ("width", area.width, size), ("height", area.height, size)];
    match sides.iter().find(|(_, side, (least, most))| !(*least..=*most).contains(side)) {
        None => Ok(()),
        Some((name, _, (least, most))) => {
            Err(Wrong::new(&format!("must be a number from {least} to {most}")).at(name))
        }
    }
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
