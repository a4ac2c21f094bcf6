//! Lettering: captions, speech balloons and sound effects, set in the fonts of `fonts/` and drawn as patches
//! above the panels. Everything is measured in page widths, so that preview and print break the same lines.
//!
//! | module | for |
//! |---|---|
//! | [`letters`] | outlines, advances and kerning of the fonts |
//! | [`learning`] | traced glyphs of characters that the fonts lack |
//! | `given` | fonts from the user's files, in native builds |
//! | `vertical` | placement of glyphs in vertical text |
//! | [`model`] | a text item as plain data, validated (crate `inkpanel-model`) |
//! | [`wording`] | text as letterers write it: capitals, quotes, emphasis, hyphens |
//! | [`ruby`] | ruby: small readings next to the characters |
//! | [`setting`] | text broken into lines and fitted into a shape |
//! | `lens` | line breaking by lettering rules: a lens shape |
//! | `shapes` | outlines of balloons and captions in pages of version 1 |
//! | `balloons` | outlines of balloons by lettering rules |
//! | [`layout`] | position, size and reading order of the text items of a document |
//! | [`draw`] | rendering of a text item |
//! | [`palette`] | text colours from the style of the page |
//! | [`place`] | automatic placement of text items: away from faces and subjects |
//! | [`truetype`] | bundled glyphs as a TrueType font for other programs |
//!
//! Text may contain any Unicode character. The bundled fonts have extended Latin with accents and combining
//! marks, Greek, Cyrillic, and some signs. Other characters (emoji, Hebrew, Chinese) are traced from images
//! in the browser, or from the user's font files. Missing glyphs are drawn as a question mark in a ring, and
//! [`Letters::missing`] lists them. Characters without width (joiners, direction marks, variation selectors)
//! and marks without a base are removed. Text that does not fit the page at the smallest size ends in an
//! ellipsis.

mod balloons;
mod bidi;
mod contour;
mod curves;
pub mod draw;
mod fitting;
#[cfg(not(target_arch = "wasm32"))]
pub mod given;
pub mod layout;
pub mod learning;
mod lens;
pub mod letters;
pub mod palette;
pub mod place;
pub mod ruby;
pub mod setting;
mod shapes;
pub mod truetype;
mod vertical;
pub mod wording;

pub use inkpanel_model::text::{self as model, TextItem, TextKind};
pub use letters::Letters;
