//! JSON of strangers: parsed within bounds, then taken apart field by field; and JSON written in an order that is ours.
//! What is wrong knows its place, which grows on the way up: `size` becomes `words[3].size` becomes
//! `present.page.words[3].size`.
//!
//! Readers and writers are plain functions, generic in nothing but what they give: all of them together are a part of the
//! module that a page waits for.
//!
//! | module | for |
//! |---|---|
//! | [`mod@parse`] | text within bounds |
//! | [`fields`] | objects taken apart |
//! | [`writer`] | text written |

pub mod fields;
pub mod parse;
pub mod writer;

pub use fields::{Fields, each, items, text_of};
pub use parse::{Bounds, parse};
pub use writer::Writer;

use crate::error::Error;
use serde::Deserialize;
use std::fmt;

/// Returns a text without its byte order mark, if it has one.
#[must_use]
pub fn unmarked(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// What the page itself has written, as `serde` reads it.
///
/// # Errors
/// `invalid-document`, which names `location`.
pub fn plain<T: for<'a> Deserialize<'a>>(json: &str, location: &str) -> crate::error::Result<T> {
    serde_json::from_str(json)
        .map_err(|error| Error::InvalidDocument { location: location.into(), reason: error.to_string() })
}

/// What a reader of a part gives.
pub type Read<T> = std::result::Result<T, Wrong>;

/// What is wrong with a document, and where.
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

/// What is the matter with a document as a whole.
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

    /// A part of a version that this program does not know.
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

    /// The same, told from the object that has it in that field.
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

    /// The same, told from the list that has it at that place.
    #[must_use]
    #[cold]
    #[inline(never)]
    pub fn in_list(self, index: usize) -> Self {
        self.at(&format!("[{index}]"))
    }

    /// The same where an object is told of without its name, as `page.width` is `width` of a page.
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

    /// In words that follow the place.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.0.reason
    }

    /// Damaged, or rather newer or larger than what is read.
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
