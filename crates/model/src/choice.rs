//! The user's preferences and wishes for random choices of layouts and styles.

use super::reference::StyleRef;
use serde::Deserialize;
use serde_json::Value;

/// Maximum effect of a preference on a weight, in both directions.
const MOST_LIKING: f64 = 1.6;

/// The user's learned preferences, as natural logarithms of the factors for the weights of families and
/// styles. As JSON: `{families: {ID: NUMBER}, styles: {ID: NUMBER}}`. Both fields are optional, and values
/// that are not numbers are ignored.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(from = "Value")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Taste {
    /// By family of layouts.
    #[cfg_attr(feature = "typescript", ts(as = "Option<std::collections::HashMap<String, f64>>", optional))]
    pub families: Vec<(String, f64)>,
    /// By id of a style.
    #[cfg_attr(feature = "typescript", ts(as = "Option<std::collections::HashMap<String, f64>>", optional))]
    pub styles: Vec<(String, f64)>,
}

impl From<Value> for Taste {
    fn from(value: Value) -> Self {
        let read = |key: &str| -> Vec<(String, f64)> {
            let entries = value[key].as_object().into_iter().flatten();
            entries.filter_map(|(id, liking)| Some((id.clone(), liking.as_f64()?))).collect()
        };
        Self { families: read("families"), styles: read("styles") }
    }
}

impl Taste {
    /// Returns the factor of a preference; 1 without a preference.
    #[must_use]
    pub fn factor(likings: &[(String, f64)], id: &str) -> f64 {
        let liking = likings.iter().find(|(other, _)| other == id).map_or(0.0, |(_, liking)| *liking);
        if liking.is_finite() { liking.clamp(-MOST_LIKING, MOST_LIKING).exp() } else { 1.0 }
    }
}

/// Options of the random choice of a style. As JSON
/// `{extra, invented, inventions, keepLines, keepColours, quick}`; all fields are optional.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(from = "Value")]
#[cfg_attr(
    feature = "typescript",
    derive(ts_rs::TS),
    ts(rename = "StylingRequest", rename_all = "camelCase")
)]
pub struct Styling {
    /// Complete custom and favourite styles. They are chosen like built-in ones.
    #[cfg_attr(feature = "typescript", ts(as = "Option<Vec<crate::style::Style>>", optional))]
    pub extra: Vec<StyleRef>,
    /// Probability of a generated style, 0 to 1.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub invented: f64,
    /// Generated styles that passed a test. If the list is present, even if it is empty, only its styles are used.
    #[cfg_attr(feature = "typescript", ts(as = "Option<Vec<crate::style::Style>>", optional))]
    pub inventions: Option<Vec<StyleRef>>,
    /// Retain the line layer and its ink.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub keep_lines: bool,
    /// Retain the colour layer.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub keep_colours: bool,
    /// Leave out styles with the block Painter, because a page in such a style takes seconds.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub quick: bool,
}

impl From<Value> for Styling {
    fn from(mut value: Value) -> Self {
        let flag = |key: &str| value[key].as_bool().unwrap_or_default();
        let (keep_lines, keep_colours) = (flag("keepLines"), flag("keepColours"));
        let quick = flag("quick");
        let invented = value["invented"].as_f64().unwrap_or_default();
        let mut list = |key: &str| match value.get_mut(key).map(Value::take) {
            Some(Value::Array(styles)) => Some(
                styles.into_iter().filter_map(|style| serde_json::from_value(style).ok()).collect::<Vec<_>>(),
            ),
            _ => None,
        };
        let (extra, inventions) = (list("extra").unwrap_or_default(), list("inventions"));
        Self { extra, invented, inventions, keep_lines, keep_colours, quick }
    }
}
