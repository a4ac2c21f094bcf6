//! The project: its photos, pages, locks, custom styles and layouts, page history and undo. It is plain data.
//! A project is checked completely when it is read, or rejected with a message and its location.
//!
//! | module | for |
//! |---|---|
//! | [`limits`] | all limits, in one place |
//! | [`project`] | one state of a project |
//! | [`pages`] | a page that can be drawn |
//! | [`history`] | undo and redo states, and the versions of pages |
//! | [`mod@file`] | the text of a project file and of a page PNG: `project.json` |
//! | `saved` | reads the project and its photos from a file (feature `files`) |
//! | [`kept`] | a history in the format of the browser's database, which stores shared parts once |
//! | [`edit`] | all edits, and the pure function that applies them to a state |
//! | [`intent`] | edits of pages that the planner carries out |
//! | [`carrying_out`] | the pages that intents ask for |
//! | [`editor`] | applies edits, undo and redo |
//! | [`page_edits`] | edits of planned pages by programs |
//! | [`sheets`] | access to the pages of a storyboard |
//! | [`own`] | lists shared by all projects |
//! | [`planning`] | planning of pages from unused photos |
//! | [`spreading`] | distribution of an album over pages |
//! | [`booking`] | a book of an album, which replaces the pages |
//! | [`upkeep`] | pages that lost a photo |
//! | [`draft`] | a style while it is designed |
//! | [`speech`] | dialogue, split into balloons |
//! | [`subtitles`] | subtitles, assigned to video frames |
//! | [`script`] | plain-text scripts |
//! | [`following`] | text items that follow their photos |
//! | [`listing`] | the shots of a project file, in order |
//! | [`shots`] | shot metadata of photos, and the layout of a storyboard |
//!
//! # Fields that are added, and versions
//!
//! Saved data has a version ([`VERSION`]). A newer version is rejected with `newer-project`. An older version
//! is migrated step by step. Between versions fields may be added:
//!
//! - If older programs still draw and save correctly without a field, it is added with a compatible default
//!   and no new version. Every field may be missing, at every depth. Older programs keep and save unknown
//!   fields at every depth.
//! - A field that changes what is drawn needs a new version, and with it a step from the version before.
//!   Therefore layouts, styles and page settings allow no unknown fields.
//!
//! An error in the present state, its pages or the photos of a file rejects the whole file. Invalid undo
//! states, pages of the page history, and custom styles or layouts are dropped and reported.

pub mod booking;
pub mod carrying_out;
pub mod draft;
pub mod edit;
pub mod editor;
pub mod file;
pub mod following;
pub mod history;
pub mod intent;
pub mod kept;
pub mod limits;
pub mod listing;
pub mod own;
pub mod page_edits;
pub mod pages;
pub mod planning;
pub mod project;
#[cfg(feature = "files")]
pub mod saved;
pub mod script;
pub mod sheets;
pub mod shots;
pub mod speech;
pub mod spreading;
pub mod subtitles;
mod text_lines;
pub mod upkeep;

use crate::error::Error;
use crate::json::{Fields, Kind, Read, Wrong};

/// Version of the saved format.
pub const VERSION: u64 = 1;

/// Dropped parts, as sentences with their location.
pub type Dropped = Vec<String>;

/// Reports a dropped part, unless the list is already too long.
fn leave_out(dropped: &mut Dropped, wrong: &Wrong) {
    if dropped.len() < limits::MOST_TOLD {
        dropped.push(wrong.to_string());
    }
}

/// Returns the version of saved data after migration. Only the current version exists so far.
fn version(fields: &mut Fields) -> Read<()> {
    let version = fields.count("version", 1, u64::MAX)?;
    if version > VERSION {
        return Err(Wrong::newer(version, VERSION).at("version"));
    }
    Ok(())
}

/// Error returned to the front end for an invalid edit.
#[cold]
fn invalid(wrong: &Wrong) -> Error {
    Error::InvalidDocument { location: wrong.place().into(), reason: wrong.reason().into() }
}

/// Error returned to the front end for invalid saved data.
#[cold]
fn refusal(wrong: &Wrong) -> Error {
    let location = if wrong.place().is_empty() { "project" } else { wrong.place() }.to_owned();
    let reason = wrong.reason().to_owned();
    match wrong.kind() {
        Kind::Damaged => Error::DamagedProject { location, reason },
        Kind::Newer => Error::NewerProject { location, reason },
        Kind::Beyond => Error::TooLargeProject { location, reason },
    }
}
