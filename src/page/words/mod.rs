//! Words on the page: captions, speech balloons and sound effects, set in the fonts of `fonts/` and drawn as patches
//! that lie on the panels. Everything is measured in page widths, so that preview and print break the same lines.
//!
//! | module | for |
//! |---|---|
//! | [`letters`] | outlines, advances and kerning of the fonts |
//! | [`model`] | a word as plain data, checked |
//! | [`setting`] | text broken into lines and fitted into a shape |
//! | `shapes` | outlines of balloons and captions |
//! | [`layout`] | where a word of a document is, and how large |
//! | [`draw`] | a word as pixels |
//! | [`place`] | where a word goes by itself: away from faces |
//! | [`truetype`] | letters of the table as a font for other programs |
//!
//! What text may hold: everything in Unicode. The fonts have Latin with its accents, also where these come as characters
//! of their own, and some signs; other letters (emoji, Hebrew, Chinese) are drawn as one box each, in the order of the
//! text. Characters without width (joiners, marks of direction, variation selectors) and marks that no letter takes are
//! left out. Text that does not fit the page at the smallest size ends in an ellipsis.

pub mod draw;
pub mod layout;
pub mod letters;
pub mod model;
pub mod place;
pub mod setting;
mod shapes;
pub mod truetype;

pub use letters::Letters;
pub use model::Word;
