//! JSON with limits, for untrusted input: a parser, readers of fields, and a writer with a fixed order of
//! fields. Errors have a path that grows on the way up: `size` becomes `words[3].size` and then
//! `present.page.words[3].size`.
//!
//! Readers and writers are plain functions, generic only in their result. This keeps the core module small,
//! which the app loads first.
//!
//! | module | for |
//! |---|---|
//! | [`mod@parse`] | text within bounds |
//! | [`fields`] | reading of object fields |
//! | [`mod@typed`] | types with `serde` |
//! | [`writer`] | text written |

pub mod fields;
pub mod parse;
pub mod typed;
pub mod writer;

pub use fields::{Fields, each, items, text_of};
pub use parse::{Bounds, parse};
pub use typed::typed;
pub use writer::Writer;

use crate::error::Error;
use serde::Deserialize;
use std::fmt;

/// Returns a text without its byte order mark, if it has one.
#[must_use]
pub fn unmarked(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Parses JSON that the app itself wrote, with `serde`.
///
/// # Errors
/// `invalid-document`, which names `location`.
pub fn plain<T: for<'a> Deserialize<'a>>(json: &str, location: &str) -> crate::error::Result<T> {
    serde_json::from_str(json)
        .map_err(|error| Error::InvalidDocument { location: location.into(), reason: error.to_string() })
}

/// Result of a reader.
pub type Read<T> = std::result::Result<T, Wrong>;

/// An error in a document, with its path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrong(Box<Fault>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct Fault {
    /// Path of the field, empty for the whole.
    place: String,
    /// In words that follow the place.
    reason: String,
    kind: Kind,
}

/// Kind of an error in a document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// It breaks its schema.
    Damaged,
    /// It is made by a newer program.
    Newer,
    /// It has more of something than any document may.
    Beyond,
}

impl Wrong {
    /// A part that is wrong.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn new(reason: &str) -> Self {
        Self::of_kind(Kind::Damaged, reason)
    }

    /// A part that is larger than its bound.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn beyond(reason: &str) -> Self {
        Self::of_kind(Kind::Beyond, reason)
    }

    fn of_kind(kind: Kind, reason: &str) -> Self {
        Self(Box::new(Fault { place: String::new(), reason: reason.to_owned(), kind }))
    }

    /// An error for a newer version.
    #[must_use]
    pub fn newer(version: u64, known: u64) -> Self {
        Self::of_kind(Kind::Newer, &format!("{version} is newer than {known}"))
    }

    /// The place and the reason of an error of the engine.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn of(error: Error) -> Self {
        match error {
            Error::InvalidStyle { location, reason, .. }
            | Error::InvalidLayout { location, reason, .. }
            | Error::InvalidDocument { location, reason } => {
                let place = if location == "file" { String::new() } else { location };
                Self(Box::new(Fault { place, reason, kind: Kind::Damaged }))
            }
            other => Self::new(&other.to_string()),
        }
    }

    /// Returns the error with the name of the parent's field in front of the path.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn at(mut self, field: &str) -> Self {
        let place = &mut self.0.place;
        if !place.is_empty() && !place.starts_with('[') {
            place.insert(0, '.');
        }
        place.insert_str(0, field);
        self
    }

    /// Returns the error with the index of the list item in front of the path.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn in_list(self, index: usize) -> Self {
        self.at(&format!("[{index}]"))
    }

    /// Returns the error without the prefix of the path, for example `width` instead of `page.width`.
    #[must_use]
    pub fn without(mut self, prefix: &str) -> Self {
        if self.0.place.starts_with(prefix) {
            self.0.place.drain(..prefix.len());
        }
        self
    }

    /// Path of the field, empty for the whole.
    #[must_use]
    pub fn place(&self) -> &str {
        &self.0.place
    }

    /// The reason, a phrase that follows the path.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.0.reason
    }

    /// Whether the document is damaged, too new, or exceeds a limit.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.0.kind
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = if self.0.place.is_empty() { "document" } else { &self.0.place };
        write!(f, "{place}: {}", self.0.reason)
    }
}
