//! Page: composes panels, borders and paper, and encodes the result. The last stage; imports all the others.
//!
//! | module | for |
//! |---|---|
//! | [`document`] | the page as plain data: the front end stores, undoes and saves it (crate `inkpanel-model`) |
//! | [`import`] | a file turned into what the page needs of a photo |
//! | [`catalogue`] | blocks, layouts and styles as JSON |
//! | [`layouts`] | layouts listed, made and changed, as JSON |
//! | [`text_links`] | text items that follow their photos (crate `inkpanel-model`) |
//! | [`reference`](mod@reference) | the layout and the style of a page, by id or in full (crate `inkpanel-model`) |
//! | [`request`] | parameters for planning a document |
//! | [`shuffle`] | a new document from photos, locks and a seed |
//! | [`storyboard`] | the photos of an album that pages are made of, and its pages |
//! | [`book`] | a book of an album: cover, chapters, captions, numbers, end page |
//! | [`styling`] | the style of a page that leaves it to chance |
//! | `fill` | the panels of a template filled with photos |
//! | [`scene`] | a document resolved to pixels of one size |
//! | [`patch`] | panels as pixels |
//! | [`rect`] | rectangles of whole pixels |
//! | [`mask`] | the inside of a panel and its border |
//! | `bleed` | panels that extend into the bleed |
//! | [`breaking`] | subjects that break their panel border |
//! | `stepping` | the pixels of such a subject |
//! | [`coverage`] | exact area coverage of pixels |
//! | [`compose`] | panels rendered to patches, patches laid on paper |
//! | [`living`] | animated panels: loops of a few seconds of a video |
//! | [`cutout`] | the subject of a photo without its background |
//! | [`words`] | captions, balloons and sound effects, laid on the panels |
//! | [`png`] | the exported PNG file |
//! | [`jpeg`] | the smaller one |
//! | `webp` | WebP encoder for browsers without one |
//! | `language` | texts of several languages |
//! | [`srgb`] | the colour space of all files |
//! | [`plates`] | colour separation into inks, one plate each |
//! | [`pdf`] | pages as lines, text and pictures |

mod bleed;
pub mod book;
pub mod breaking;
pub mod catalogue;
pub mod compose;
pub mod coverage;
pub mod cutout;
pub mod fill;
pub mod import;
pub mod jpeg;
pub(crate) mod language;
pub mod layouts;
pub mod living;
pub mod mask;
pub mod patch;
pub mod pdf;
pub mod plates;
pub mod png;
pub mod rect;
pub mod request;
pub mod scene;
pub mod shuffle;
pub mod srgb;
mod stepping;
pub mod storyboard;
pub mod styling;
#[cfg(feature = "webp")]
pub mod webp;
pub mod words;

pub use inkpanel_model::page::{self as document, Document};
pub use inkpanel_model::reference::{self, CustomFile, LayoutRef, StyleRef};
pub use inkpanel_model::text_links;
pub use patch::Patch;
pub use scene::Scene;
