//! Layout: page templates and their geometry.
//!
//! A [`Template`] comes from a file of `layouts/` ([`catalogue`]), from the user or from a generator. It is
//! in unit coordinates, without gutters and pixels. [`resolve`] places it on a page with [`PageSettings`].

mod aesthetics;
mod catalogue;
mod change;
pub mod edit;
mod enlarge;
mod generate;
pub mod join;
mod json;
pub mod merge;
mod paper;
mod parse;
pub mod polygon;
mod reading;
mod resolve;
mod settings;
mod template;
pub mod tree;
mod whole;
mod write;

pub use aesthetics::score;
pub use catalogue::{catalogue, find, good_for};
pub use change::LayoutChange;
pub use enlarge::enlarged;
pub use generate::generate;
pub use paper::PaperSize;
pub use polygon::{Bounds, Point};
pub use reading::reading_order;
pub use resolve::{ResolvedPanel, ResolvedShape, resolve};
pub use settings::{
    COARSE, DEFAULT_GUTTER, DPI, Field, MOST_PIXELS, PRESETS, PagePreset, PageSettings, Purpose, SETTINGS,
    SIDES, Setting, preset,
};
pub use template::{Body, LEAST_THICKNESS, Panel, Shape, Template};
pub use whole::{Whole, whole};
pub use write::{Circle, Descriptor, LayoutPanel, Outline, PlacedPanel};

/// The families of templates, in the order in which they are listed. `custom` contains the user's layouts,
/// `generated` the layouts of the generator.
pub const FAMILIES: [&str; 18] = [
    "splash",
    "hero",
    "cinema",
    "grid",
    "rows",
    "columns",
    "slanted",
    "manga",
    "inset",
    "circle",
    "mosaic",
    "overlap",
    "strip",
    "landscape",
    "square",
    "tall",
    "custom",
    "generated",
];
