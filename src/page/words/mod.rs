//! Lettering: captions, speech balloons and sound effects, set in the fonts of `fonts/` and drawn as patches
//! above the panels. Everything is measured in page widths, so that preview and print break the same lines.
//!
//! | module | for |
//! |---|---|
//! | [`letters`] | outlines, advances and kerning of the fonts |
//! | [`learning`] | letters that the fonts do not have, from pictures of them |
//! | `given` | the same from font files of a person, natively |
//! | `vertical` | how letters stand in columns |
//! | [`model`] | a word as plain data, checked |
//! | [`wording`] | text as letterers write it: capitals, quotes, emphasis, hyphens |
//! | [`ruby`] | readings small beside their letters |
//! | [`setting`] | text broken into lines and fitted into a shape |
//! | `lens` | the same by the conventions of letterers |
//! | `shapes` | outlines of balloons and captions, those of the first pages |
//! | `balloons` | those of letterers |
//! | [`layout`] | where a word of a document is, and how large |
//! | [`draw`] | a word as pixels |
//! | [`palette`] | colours of words from the style of their page |
//! | [`place`] | where a word goes by itself: away from faces, off the figures of photos |
//! | [`truetype`] | letters of the table as a font for other programs |
//!
//! Text may contain any Unicode character. The bundled fonts have extended Latin with accents and combining
//! marks, Greek, Cyrillic, and some signs. Other characters (emoji, Hebrew, Chinese) are traced from images
//! in the browser, or from the user's font files. Missing glyphs are drawn as a question mark in a ring, and
//! [`Letters::missing`] lists them. Characters without width (joiners, direction marks, variation selectors)
//! and marks without a base are removed. Text that does not fit the page at the smallest size ends in an
//! ellipsis.

mod balloons;
mod bidi;
pub mod draw;
#[cfg(not(target_arch = "wasm32"))]
pub mod given;
pub mod layout;
pub mod learning;
mod lens;
pub mod letters;
pub mod model;
pub mod palette;
pub mod place;
pub mod ruby;
pub mod setting;
mod shapes;
pub mod truetype;
mod vertical;
pub mod wording;

pub use letters::Letters;
pub use model::Word;
