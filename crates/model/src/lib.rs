//! # The typed document of Inkpanel
//!
//! This crate contains the data of a project: pages, layouts, text, photos, edits, history and file formats. It reads, checks, changes
//! and writes them, without pixels and without planning. The crate `inkpanel-engine` plans and draws pages. **Its API changes between
//! versions without notice.** The crate [`inkpanel`](https://docs.rs/inkpanel) has the stable API.
//!
//! A document is plain data. It is checked completely when it is read, or rejected with a message and its location.
//!
//! | module | for |
//! |---|---|
//! | [`json`] | JSON with limits |
//! | [`limits`] | all limits, in one place |
//! | [`layout`] | page templates, their geometry, and changes of them |
//! | [`page`] | a page: layout, style, photos, crops, text and settings |
//! | [`reference`](mod@reference) | a layout or a style by its id, or in full |
//! | [`crop`], [`subject`] | the shown part of a photo, and its detected faces and objects |
//! | [`text`] | text items |
//! | [`text_links`] | the photos of text items |
//! | [`validation`] | whether a page can be drawn |
//! | [`project`] | one state of a project |
//! | [`sheets`] | access to the pages of a project |
//! | [`own`] | lists shared by all projects |
//! | [`shots`], [`timecode`] | shot metadata of photos, and the layout of a storyboard |
//! | [`draft`] | a style while it is designed |
//! | [`choice`] | the user's preferences for random choices |
//! | [`intent`] | edits of pages that the planner carries out |
//! | [`edit`] | all edits, and the pure function that applies them to a state |
//! | [`following`] | text items that follow their photos |
//! | [`history`] | undo and redo states, and the versions of pages |
//! | [`kept`] | a history in the format of the browser's database, which stores shared parts once |
//! | [`mod@file`] | the text of a project file and of a page PNG: `project.json` |
//! | `saved` | reads the project and its photos from a file (feature `files`) |
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

pub mod choice;
pub mod crop;
pub mod draft;
pub mod edit;
pub mod file;
pub mod following;
pub mod history;
pub mod intent;
pub mod json;
pub mod kept;
pub mod layout;
pub mod limits;
pub mod own;
pub mod page;
pub mod project;
pub mod reference;
#[cfg(feature = "files")]
pub mod saved;
pub mod sheets;
pub mod shots;
pub mod subject;
pub mod text;
pub mod text_links;
pub mod timecode;
pub mod validation;

pub use inkpanel_image::error::{self, Error, Result};
use inkpanel_image::{order, raster};
use inkpanel_style as style;

use json::{Fields, Kind, Read, Wrong};

/// Version of the saved format.
pub const VERSION: u64 = 1;

/// Dropped parts, as sentences with their location.
pub type Dropped = Vec<String>;

/// Reports a dropped part, unless the list is already too long.
pub(crate) fn leave_out(dropped: &mut Dropped, wrong: &Wrong) {
    if dropped.len() < limits::MOST_TOLD {
        dropped.push(wrong.to_string());
    }
}

/// Returns the version of saved data after migration. Only the current version exists so far.
pub(crate) fn version(fields: &mut Fields) -> Read<()> {
    let version = fields.count("version", 1, u64::MAX)?;
    if version > VERSION {
        return Err(Wrong::newer(version, VERSION).at("version"));
    }
    Ok(())
}

/// Error returned to the front end for an invalid edit.
#[cold]
#[must_use]
pub fn invalid(wrong: &Wrong) -> Error {
    Error::InvalidDocument { location: wrong.place().into(), reason: wrong.reason().into() }
}

/// Error returned to the front end for invalid saved data.
#[cold]
pub(crate) fn refusal(wrong: &Wrong) -> Error {
    let location = if wrong.place().is_empty() { "project" } else { wrong.place() }.to_owned();
    let reason = wrong.reason().to_owned();
    match wrong.kind() {
        Kind::Damaged => Error::DamagedProject { location, reason },
        Kind::Newer => Error::NewerProject { location, reason },
        Kind::Beyond => Error::TooLargeProject { location, reason },
    }
}
