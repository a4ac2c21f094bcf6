//! Output: comics with guided view and accessible text. All file types use one description: the panels of a
//! page in reading order, as polygons, with their content and text.
//!
//! | module | for |
//! |---|---|
//! | [`comic`] | parameters and result of an export: text, with placeholders for pictures |
//! | [`telling`] | text of pages: panels in reading order, with their text items |
//! | [`phrases`] | interface strings of the reader, in six languages |
//! | [`describing`] | English descriptions of panels, for the command line |
//! | [`html`] | one HTML file with a built-in reader |
//! | [`epub`] | an EPUB 3 book with fixed layout |
//! | [`cbz`] | a comic archive with `ComicInfo.xml` and ACBF |
//! | [`board`] | storyboard sheets, as pages |
//! | [`animatic`] | timing of storyboard shots: visible shot and camera position of each frame |
//! | [`motion`] | timing of comic pages: active panel and caption of each frame |
//! | [`reading`] | how a page is read in time |
//! | [`strip`] | panels below each other, for webtoon readers |
//! | [`shots`] | shot lists for spreadsheets and video editors |
//! | `markup` | text in XML and HTML |
//!
//! No image passes through this module: a page at print size has megabytes, which the browser stores as
//! blobs. The output contains placeholders for images, and the caller inserts the image data.

pub mod animatic;
pub mod board;
pub mod cbz;
pub mod comic;
pub mod describing;
pub mod epub;
pub mod html;
mod markup;
pub mod motion;
pub mod phrases;
pub mod reading;
pub mod shots;
pub mod strip;
pub mod telling;

pub use comic::{Comic, ComicPage, File, PictureKind, Piece};
