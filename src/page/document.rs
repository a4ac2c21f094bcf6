//! The page as plain data. The front end holds these documents, undoes to earlier ones and saves them; a
//! document and the photos that it names make exactly one picture.

use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::layout::{self, PageSettings, Template};
use crate::style::{Style, catalogue};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::borrow::Cow;

/// Version of the shape below; a newer one is refused.
pub const VERSION: u32 = 1;

/// A storyboard page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
    #[serde(default)]
    pub order: Vec<String>,
    /// What each panel shows, in paint order.
    pub panels: Vec<PanelContent>,
    /// Groups of panels that share one image.
    #[serde(default)]
    pub merges: Vec<Vec<usize>>,
    /// Size, gutters and colours.
    #[serde(default)]
    pub page: PageSettings,
    /// Words on the page, as [`Word`](super::words::Word) has them, in paint order. Whoever draws them checks them.
    #[serde(default)]
    pub words: Vec<Value>,
}

/// What one panel shows.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct PanelContent {
    /// Id of the photo; none leaves the panel empty.
    #[serde(default)]
    pub photo: Option<String>,
    /// The part of the photo that fills the panel, or the group it is merged into.
    #[serde(default)]
    pub crop: Option<Crop>,
    /// Kept by every shuffle.
    #[serde(default)]
    pub locked: bool,
    /// The crop was made by hand: it stays while the photo stays in this panel.
    #[serde(default)]
    pub edited: bool,
}

impl Document {
    /// Reads a document.
    ///
    /// # Errors
    /// `invalid-document` for anything but a document of this version.
    pub fn parse(json: &str) -> Result<Self> {
        let document: Self =
            serde_json::from_str(json).map_err(|error| invalid("document", error.to_string()))?;
        document.check()?;
        Ok(document)
    }

    fn check(&self) -> Result<()> {
        if self.version != VERSION {
            let reason = format!("is {}, this Inkpanel reads version {VERSION}", self.version);
            return Err(invalid("version", reason));
        }
        self.page.validate()?;
        let panels = self.panels.len();
        let mut seen = vec![false; panels];
        for &panel in self.merges.iter().flatten() {
            match seen.get_mut(panel) {
                Some(seen) if !*seen => *seen = true,
                _ => return Err(invalid("merges", format!("panel {panel} is missing or merged twice"))),
            }
        }
        for (i, crop) in self.panels.iter().enumerate().filter_map(|(i, panel)| Some((i, panel.crop?))) {
            let inside = crop.x >= -1e-6
                && crop.y >= -1e-6
                && crop.width > 0.0
                && crop.height > 0.0
                && crop.x + crop.width <= 1.0 + 1e-6
                && crop.y + crop.height <= 1.0 + 1e-6;
            if !inside {
                return Err(invalid(&format!("panels[{i}].crop"), "reaches beyond the photo"));
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
