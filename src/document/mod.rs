//! The project: its photos, pages, locks, custom styles and layouts, page history and undo. It is plain data.
//! A project is checked completely when it is read, or rejected with a message and its location.
//!
//! | module | for |
//! |---|---|
//! | [`limits`] | every bound, in one place |
//! | [`project`] | one state of a project |
//! | [`pages`] | a page that can be drawn |
//! | [`history`] | states before and after, and the pages shown |
//! | [`mod@file`] | the text of a project file and of a page PNG: `project.json` |
//! | `saved` | such a text found in its file, with the photos (feature `files`) |
//! | [`kept`] | a history as the browser's database has it: what states share is told once |
//! | [`edit`] | all that can be done, and the pure function that does it to a state |
//! | [`editor`] | done step by step, undone and redone |
//! | [`sheets`] | the pages of a storyboard as one list |
//! | [`own`] | lists that all projects share |
//! | [`planning`] | pages planned from the photos that are free for them |
//! | [`spreading`] | an album laid out over pages |
//! | [`booking`] | a book of an album, which replaces the pages |
//! | [`upkeep`] | pages that lost a photo |
//! | [`draft`] | a style while it is designed |
//! | [`speech`] | what people say, cut into what balloons hold |
//! | [`subtitles`] | subtitles, and the frames that they go to |
//! | [`script`] | scripts as people write them |
//! | [`following`] | words that stay with their photos |
//! | [`listing`] | the shots of a project file in their order |
//! | [`shots`] | what is told of photos as shots, and how they are laid out as a board |
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
pub mod draft;
pub mod edit;
pub mod editor;
pub mod file;
pub mod following;
pub mod history;
pub mod kept;
pub mod limits;
pub mod listing;
pub mod own;
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

/// The version of something saved, brought up to date. There is no older one so far.
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
