//! Edits of projects that plan pages, and texts that become lettering. The crate `inkpanel-model` has the project itself,
//! and the other edits.
//!
//! | module | for |
//! |---|---|
//! | [`carrying_out`] | the pages that intents ask for |
//! | [`editor`] | applies edits, undo and redo |
//! | [`page_edits`] | edits of planned pages by programs |
//! | [`planning`] | planning of pages from unused photos |
//! | [`spreading`] | distribution of an album over pages |
//! | [`booking`] | a book of an album, which replaces the pages |
//! | [`upkeep`] | pages that lost a photo |
//! | [`speech`] | dialogue, split into balloons |
//! | [`subtitles`] | subtitles, assigned to video frames |
//! | [`script`] | plain-text scripts |
//! | [`listing`] | the shots of a project file, in order |

pub mod booking;
pub mod carrying_out;
pub mod editor;
pub mod listing;
pub mod page_edits;
pub mod planning;
pub mod script;
pub mod speech;
pub mod spreading;
pub mod subtitles;
mod text_lines;
pub mod upkeep;

#[cfg(feature = "files")]
pub use inkpanel_model::saved;
pub use inkpanel_model::{
    Dropped, VERSION, draft, edit, file, following, history, intent, invalid, kept, limits, own, project,
    sheets, shots, validation,
};
