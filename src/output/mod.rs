//! Output: pages as comics that are read, panel by panel and by everybody. Each kind of file is made of the same telling: which
//! panels a page has, in reading order, as polygons, what each shows, and what its words say.
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
//! No picture passes through here: a page at print size has megabytes, which the browser keeps as Blobs. What is written names
//! the picture that belongs in a place, and whoever asked puts it there.

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
