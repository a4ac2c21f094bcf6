//! Page: composes panels, borders and paper, and encodes the result. The last stage; imports all the others.
//!
//! | module | for |
//! |---|---|
//! | [`document`] | the page as plain data: what the front end holds, undoes and saves |
//! | [`import`] | a file turned into what the page needs of a photo |
//! | [`catalogue`] | blocks, layouts and styles as JSON |
//! | [`layouts`] | layouts listed, made and changed, as JSON |
//! | [`carrying`] | words and the photos that they belong to |
//! | [`request`] | what is asked of a new document |
//! | [`shuffle`] | a new document from photos, locks and a seed |
//! | [`storyboard`] | the photos of an album that pages are made of, and its pages |
//! | [`book`] | a book of an album: cover, chapters, captions, numbers, end page |
//! | [`styling`] | the style of a page that leaves it to chance |
//! | `fill` | the panels of a template filled with photos |
//! | [`scene`] | a document resolved to pixels of one size |
//! | [`mask`] | the inside of a panel and its border |
//! | `bleed` | panels that go on beyond the edge of a page that is cut |
//! | [`breaking`] | figures that step out of their panels |
//! | `stepping` | the pixels of such a figure |
//! | [`coverage`] | exact area coverage of pixels |
//! | [`compose`] | panels rendered to patches, patches laid on paper |
//! | [`living`] | panels that move, of a few seconds of a film |
//! | [`cutout`] | the subject of a photo alone |
//! | [`words`] | captions, balloons and sound effects, laid on the panels |
//! | [`png`] | the file that people download |
//! | [`jpeg`] | the smaller one |
//! | `webp` | the one for browsers that make none themselves |
//! | [`srgb`] | the colour space of all files |
//! | [`plates`] | colours as inks, each on a plate of its own |
//! | [`pdf`] | pages as lines, text and pictures |

mod bleed;
pub mod book;
pub mod breaking;
pub mod carrying;
pub mod catalogue;
pub mod compose;
pub mod coverage;
pub mod cutout;
pub mod document;
pub mod fill;
pub mod import;
pub mod jpeg;
pub mod layouts;
pub mod living;
pub mod mask;
pub mod pdf;
pub mod plates;
pub mod png;
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

pub use compose::Patch;
pub use document::Document;
pub use scene::Scene;
