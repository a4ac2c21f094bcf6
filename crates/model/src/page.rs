//! The page as plain data. The front end stores, undoes and saves these documents. A document and its photos
//! give exactly one image.

use super::reference::{LayoutRef, StyleRef};
use super::text::{MOST_WORDS, TextItem, TextKind};
use crate::crop::Crop;
use crate::error::{Error, Result};
use crate::json::fields::{at_most, not_longer};
use crate::json::typed::{self, is_default, nullable, typed_by};
use crate::json::{Read, Writer, Wrong};
use crate::layout::{self, PageSettings, Template};
use crate::raster::Matte;
use crate::style::Style;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "PageDocument"))]
pub struct Document {
    /// [`VERSION`].
    #[serde(deserialize_with = "typed::whole::<_, _, 1, { u32::MAX as u64 }>")]
    pub version: u32,
    /// Seed of the shuffle that made it.
    #[serde(deserialize_with = "typed::whole::<_, _, 0, { u32::MAX as u64 }>")]
    pub seed: u32,
    /// Id of a layout, or a template in full.
    #[cfg_attr(feature = "typescript", ts(as = "LayoutChoice"))]
    pub layout: LayoutRef,
    /// Id of a style, or a style in full.
    #[cfg_attr(feature = "typescript", ts(as = "StyleChoice"))]
    pub style: StyleRef,
    /// Photos in reading order, possibly more than panels.
    #[serde(default)]
    pub order: Vec<String>,
    /// Content of each panel, in paint order.
    pub panels: Vec<PanelContent>,
    /// Groups of panels that share one image.
    #[serde(default)]
    pub merges: Vec<Vec<usize>>,
    /// Size, gutters and colours.
    #[serde(default)]
    pub page: PageSettings,
    /// The photos get one white point. Pages that were saved before this field have the colours of each photo.
    #[serde(default, deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub balanced: bool,
    /// Text items on the page, in paint order.
    #[serde(default)]
    pub words: Vec<TextItem>,
    /// Unknown fields, preserved for newer programs.
    #[serde(flatten)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// A layout by its id, or in full.
#[cfg(feature = "typescript")]
#[derive(ts_rs::TS)]
#[ts(untagged)]
#[allow(dead_code, reason = "only for the TypeScript types")]
pub enum LayoutChoice {
    /// A built-in layout.
    Id(String),
    /// A layout in full.
    Full(Template),
}

/// A style by its id, or in full.
#[cfg(feature = "typescript")]
#[derive(ts_rs::TS)]
#[ts(untagged)]
#[allow(dead_code, reason = "only for the TypeScript types")]
pub enum StyleChoice {
    /// A built-in style.
    Id(String),
    /// A style in full.
    Full(Style),
}

/// Content of a panel.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "PanelUse"))]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate field of the file")]
pub struct PanelContent {
    /// Id of the photo; `None` for an empty panel.
    pub photo: Option<String>,
    /// The part of the photo that fills the panel, or the group it is merged into.
    pub crop: Option<Crop>,
    /// Faces of the photo, in fractions of it, which the style protects. Old pages have no faces here, and look unchanged.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<Vec<Crop>>", optional))]
    pub faces: Vec<Crop>,
    /// Subject mask of the photo for a panel breakout. `None` disables the breakout.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(type = "string", optional))]
    pub figure: Option<Matte>,
    /// Whether the panel is a logo: no style, no border, and described as a logo.
    #[serde(deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub plain: bool,
    /// Whether a gray photo gets a warm tone, because other photos of the page have colours.
    #[serde(deserialize_with = "nullable", skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub toned: bool,
    /// Whether every shuffle preserves the panel.
    #[serde(deserialize_with = "nullable")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub locked: bool,
    /// Whether the crop is manual. It stays as long as the photo stays in this panel.
    #[serde(deserialize_with = "nullable")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub edited: bool,
    /// Unknown fields, preserved for newer programs.
    #[serde(flatten)]
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

impl<'de> Deserialize<'de> for Document {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        Self::deserialize(deserializer)?.checked().map_err(serde::de::Error::custom)
    }
}

impl Serialize for Document {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        Self::serialize(self, serializer)
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

    /// A page of this layout and style without panels.
    #[must_use]
    pub fn new(layout: LayoutRef, style: StyleRef, page: PageSettings) -> Self {
        Self {
            version: VERSION,
            seed: 0,
            layout,
            style,
            order: Vec::new(),
            panels: Vec::new(),
            merges: Vec::new(),
            page,
            balanced: false,
            words: Vec::new(),
            rest: Map::new(),
        }
    }

    /// Checks a document that the program made, as [`parse`](Self::parse) does.
    ///
    /// # Errors
    /// Returns `invalid-document` with the location.
    pub fn validated(self) -> Result<Self> {
        let document = self.checked().map_err(|wrong| invalid(wrong.place(), wrong.reason()))?;
        document.page.validate()?;
        Ok(document)
    }

    /// Reads a document inside another document. Layout, style and settings are not checked.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn read(value: Value) -> Read<Self> {
        // A newer document may have another shape.
        let version = value.get("version").and_then(Value::as_u64).unwrap_or_default();
        if version > u64::from(VERSION) {
            return Err(Wrong::newer(version, u64::from(VERSION)).at("version"));
        }
        typed_by(value, &|deserializer| Self::deserialize(deserializer))?.checked()
    }

    /// Checks the limits and text items of a document that was read.
    fn checked(mut self) -> Read<Self> {
        if self.version > VERSION {
            return Err(Wrong::newer(u64::from(self.version), u64::from(VERSION)).at("version"));
        }
        let lists = [
            ("order", self.order.len(), MOST_PHOTOS),
            ("panels", self.panels.len(), MOST_PANELS),
            ("merges", self.merges.len(), MOST_PANELS),
            ("words", self.words.len(), MOST_WORDS),
        ];
        for (name, count, most) in lists {
            at_most(count, most).map_err(|wrong| wrong.at(name))?;
        }
        for (i, id) in self.order.iter().enumerate() {
            not_longer(id, LONGEST_ID).map_err(|wrong| wrong.in_list(i).at("order"))?;
        }
        for (i, panel) in self.panels.iter().enumerate() {
            panel.validate().map_err(|wrong| wrong.in_list(i).at("panels"))?;
        }
        for (i, word) in self.words.iter().enumerate() {
            word.validate().map_err(|wrong| wrong.in_list(i).at("words"))?;
        }
        // A panel shares its image with others, or with none.
        self.merges.retain(|group| group.len() > 1);
        self.check_merges().map_err(|wrong| wrong.at("merges"))?;
        Ok(self)
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

    /// The document as JSON, which [`parse`](Self::parse) reads.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut out = Writer::default();
        out.put(self);
        out.finish()
    }

    /// The text items as JSON.
    #[must_use]
    pub fn words_json(&self) -> String {
        let mut out = Writer::default();
        out.put(&self.words);
        out.finish()
    }

    /// The template of the page.
    ///
    /// # Errors
    /// `unknown-layout`, `invalid-layout`.
    pub fn template(&self) -> Result<Cow<'static, Template>> {
        self.layout.template()
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
        self.style.style()
    }

    /// Whether a panel has a breakout.
    #[must_use]
    pub fn breaks_frame(&self, index: usize) -> bool {
        self.panels.get(index).is_some_and(|panel| panel.figure.is_some() && panel.photo.is_some())
            && self.merge_of(index).is_none()
    }

    /// Panels whose subjects are in front of an effect, see [`TextItem::behind`]; sorted,
    /// without duplicates.
    #[must_use]
    pub fn fronts(&self) -> Vec<usize> {
        let behind = self.words.iter().filter(|word| word.behind && word.kind == TextKind::Effect);
        let mut fronts: Vec<usize> =
            behind.filter_map(|word| word.panel).filter(|panel| *panel < self.panels.len()).collect();
        fronts.sort_unstable();
        fronts.dedup();
        fronts
    }

    /// The text items in the form that lettering needs, see [`TextItem::effective`].
    #[must_use]
    pub fn effective_words(&self) -> Vec<TextItem> {
        self.words.iter().map(TextItem::effective).collect()
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
        if let Some(photo) = &self.photo {
            not_longer(photo, LONGEST_ID).map_err(|wrong| wrong.at("photo"))?;
        }
        if let Some(crop) = &self.crop {
            within_photo(crop).map_err(|wrong| wrong.at("crop"))?;
        }
        at_most(self.faces.len(), MOST_FACES).map_err(|wrong| wrong.at("faces"))?;
        // Faces may extend past the photo.
        let limits = [(-1.0, 2.0), (0.0, 2.0)];
        let mut faces = self.faces.iter().enumerate();
        faces.try_for_each(|(i, face)| in_limits(face, limits).map_err(|wrong| wrong.in_list(i).at("faces")))
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
    let sides = [
        ("x", area.x, place),
        ("y", area.y, place),
        ("width", area.width, size),
        ("height", area.height, size),
    ];
    match sides.iter().find(|(_, side, (least, most))| !(*least..=*most).contains(side)) {
        None => Ok(()),
        Some((name, _, (least, most))) => {
            Err(Wrong::new(&format!("must be a number from {least} to {most}")).at(name))
        }
    }
}

fn invalid(location: &str, reason: impl Into<String>) -> Error {
    Error::InvalidDocument { location: location.to_owned(), reason: reason.into() }
}
