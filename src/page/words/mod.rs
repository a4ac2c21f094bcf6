//! Words on the page: captions, speech balloons and sound effects, set in the fonts of `fonts/` and drawn as patches
//! that lie on the panels. Everything is measured in page widths, so that preview and print break the same lines.
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
//! What text may hold: everything in Unicode. The fonts have Latin with its extensions and accents, also where these come as
//! characters of their own, Greek, Cyrillic, and some signs; other letters (emoji, Hebrew, Chinese) are learnt from
//! pictures, where a browser draws these, or from the font files of a person; for what is in none a question mark in a ring
//! stands, and [`Letters::missing`] names it. Characters without width (joiners, marks of direction, variation selectors) and
//! marks that no letter takes are left out. Text that does not fit the page at the smallest size ends in an ellipsis.

mod balloons;
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
