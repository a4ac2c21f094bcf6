//! The parameters of [`plan`](super::shuffle::plan).

use super::document::Document;
use super::reference::{LayoutRef, StyleRef};
use crate::framing::PhotoMeta;
use crate::layout::PageSettings;
pub use inkpanel_model::choice::{Styling, Taste};
use serde::Deserialize;
use serde_json::Value;

/// A request for a page. The result depends on nothing else.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
pub struct Request {
    /// Seed of all random choices.
    pub seed: u32,
    /// Photos in use, in order of time.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub photos: Vec<PhotoMeta>,
    /// Size, gutters and colours of the page.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub page: PageSettings,
    /// The current page; `None` before the first page.
    #[serde(default)]
    pub current: Option<Document>,
    /// Parts of the current page to retain.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub keep: Keep,
    /// The layout, by id or in full. Default: chosen automatically.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<crate::page::document::LayoutChoice>"))]
    pub layout: Option<LayoutRef>,
    /// The style, by id or in full. Default: chosen automatically.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<crate::page::document::StyleChoice>"))]
    pub style: Option<StyleRef>,
    /// Options of the random choice of a style.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub styling: Styling,
    /// Wanted number of panels if no layout is set.
    #[serde(default)]
    pub panels: Option<usize>,
    /// How new photos are chosen.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub mode: Mode,
    /// Maximum fingerprint distance of near-duplicates, in bits of 64. A page avoids two photos that are this close. Default: 10.
    #[serde(default)]
    pub duplicate_threshold: Option<u32>,
    /// Whether the photos stay in their order along the page. Default: whether all are dated, at different times, or all are
    /// frames of videos.
    #[serde(default)]
    pub ordered: Option<bool>,
    /// The photos of pages that were shown before, by id: the photo of the largest panel first, the last page last. Photos
    /// that they do not show have their turn.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub recent: Vec<Vec<String>>,
    /// Whether panels of a new layout share images: `true` always, `false` never. By default the choice is
    /// random. If the request sets a layout or a number of panels, each panel has a separate image by
    /// default.
    #[serde(default)]
    pub merge: Option<bool>,
    /// Exactly these groups of panels share one image each.
    #[serde(default)]
    pub merges: Option<Vec<Vec<usize>>>,
    /// Whether a subject breaks its panel border, if the photos have masks and one of them fits: `true`
    /// always, `false` never. By default the choice is random.
    #[serde(default)]
    pub figures: Option<bool>,
    /// The user's learned preferences.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub taste: Taste,
    /// Families to choose from.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub within: Families,
    /// Recent results to avoid, besides the current page.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub avoid: Avoid,
    /// Randomness of the choice. Default: 1. Larger values give more surprising pages, and 0 takes the best candidate.
    #[serde(default)]
    pub surprise: Option<f64>,
}

/// Families for a random choice: of layouts, from [`FAMILIES`](crate::layout::FAMILIES), and of styles, from
/// [`FAMILIES`](crate::style::catalogue::FAMILIES). An empty list allows all. An explicit layout or style may
/// be in any family.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Families {
    /// Families of layouts.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub layouts: Vec<String>,
    /// Families of styles.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub styles: Vec<String>,
}

/// Layouts and styles that were shown just now, by id.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(from = "Value")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Avoid {
    /// Layouts.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub layouts: Vec<String>,
    /// Styles.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub styles: Vec<String>,
}

impl From<Value> for Avoid {
    fn from(value: Value) -> Self {
        let read = |key: &str| {
            let ids = value[key].as_array().into_iter().flatten();
            ids.filter_map(|id| id.as_str().map(str::to_owned)).collect()
        };
        Self { layouts: read("layouts"), styles: read("styles") }
    }
}

/// Retained parts of the current page.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Keep {
    /// The layout.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub layout: bool,
    /// The style.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub style: bool,
    /// The photos and their order.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub photos: bool,
}

/// How new photos are chosen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Mode {
    /// A new selection of photos, in time order if all times are known.
    #[default]
    Shuffle,
    /// Any order: the strongest photo gets the most prominent panel.
    Photos,
}
