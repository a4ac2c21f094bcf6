//! Output: comics with guided view and accessible text. All file types use one description: the panels of a
//! page in reading order, as polygons, with their content and text.
//!
//! | module | for |
//! |---|---|
//! | [`comic`] | what is asked for, and what comes of it: text, and places for pictures |
//! | [`telling`] | pages told: panels in reading order, with their words |
//! | [`phrases`] | what a reader says itself, in six languages |
//! | [`describing`] | what a panel shows, in English, for the command line |
//! | [`html`] | one page of HTML that opens anywhere, with a reader in it |
//! | [`epub`] | an EPUB 3 book of fixed layout |
//! | [`cbz`] | a comic archive with `ComicInfo.xml` and ACBF |
//! | [`board`] | sheets of a board, as pages |
//! | [`animatic`] | the shots of a board in their times: which is seen in a frame, and how the camera moves |
//! | [`motion`] | pages in their times: which panel is read in a frame, and what of it is said |
//! | [`shots`] | the shots of a board as lists that spreadsheets and cutting rooms read |
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
pub mod shots;
pub mod telling;

pub use comic::{Comic, ComicPage, File, PictureKind, Piece};
