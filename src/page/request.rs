//! What is asked of [`plan`](super::shuffle::plan).

use super::document::Document;
pub use super::styling::Styling;
use crate::framing::PhotoMeta;
use crate::layout::PageSettings;
pub use crate::plan::layouts::Taste;
use serde::Deserialize;
use serde_json::Value;

/// What is asked for. The answer depends on nothing else.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(optional_fields = nullable))]
pub struct Request {
    /// Seed of every choice that is left to chance.
    pub seed: u32,
    /// Photos in use, in order of time.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub photos: Vec<PhotoMeta>,
    /// Size, gutters and colours of the page.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub page: PageSettings,
    /// The page as it is; none when there is none yet.
    #[serde(default)]
    pub current: Option<Document>,
    /// Parts of the page that stay.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub keep: Keep,
    /// A layout to take, by id or in full.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<crate::page::document::LayoutChoice>"))]
    pub layout: Option<Value>,
    /// A style to take, by id or in full.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<crate::page::document::StyleChoice>"))]
    pub style: Option<Value>,
    /// How a style is drawn that is left to chance.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub styling: Styling,
    /// A layout that a free page takes unless another is clearly better.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<crate::page::document::LayoutChoice>"))]
    pub prefer: Option<Value>,
    /// Wanted number of panels where the layout is free.
    #[serde(default)]
    pub panels: Option<usize>,
    /// How photos that do not stay are chosen.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub mode: Mode,
    /// Whether the photos stay in their order along the page. Default: whether all are dated, at different times.
    #[serde(default)]
    pub ordered: Option<bool>,
    /// The photos of pages that were shown before, by id: the photo of the largest panel first, the last page last. Photos
    /// that they do not show have their turn.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub recent: Vec<Vec<String>>,
    /// Whether a new layout gets panels that share one image: always, never, or, where nothing is said, by chance.
    /// Chance has no say in a layout or a number of panels that was asked for: each panel then has its own image.
    #[serde(default)]
    pub merge: Option<bool>,
    /// Exactly these groups of panels share one image each.
    #[serde(default)]
    pub merges: Option<Vec<Vec<usize>>>,
    /// Whether a figure steps out of its panel, where the masks of the photos are there and one can: always, never, or, where nothing
    /// is said, by chance.
    #[serde(default)]
    pub figures: Option<bool>,
    /// What the person liked so far.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub taste: Taste,
    /// Families that chance keeps to.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub within: Families,
    /// What was shown just now and is not to come again at once, beside what the current page has.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub avoid: Avoid,
    /// How bold the draw is: 1 as usual, more to be surprised more, 0 for the best that was found.
    #[serde(default)]
    pub surprise: Option<f64>,
}

/// Families that chance keeps to, any where a list is empty: of layouts, [`FAMILIES`](crate::layout::FAMILIES), and of styles,
/// [`FAMILIES`](crate::style::catalogue::FAMILIES). What is asked for by id is not held to them.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS))]
pub struct Families {
    /// Of layouts.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub layouts: Vec<String>,
    /// Of styles.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub styles: Vec<String>,
}

/// Layouts and styles that were shown just now, by id.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(from = "Value")]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS))]
pub struct Avoid {
    /// Layouts.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub layouts: Vec<String>,
    /// Styles.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
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

/// Parts of the current page that stay.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS))]
pub struct Keep {
    /// The layout.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub layout: bool,
    /// The style.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub style: bool,
    /// The photos and their order.
    #[serde(default)]
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<_>", optional))]
    pub photos: bool,
}

/// How photos that do not stay are chosen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS))]
pub enum Mode {
    /// Another choice of photos, in order of time if that is known.
    #[default]
    Shuffle,
    /// Any order: the strongest photo goes where the eye goes first.
    Photos,
}
