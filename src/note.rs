//! Warnings of the public API.

#![allow(clippy::needless_pass_by_value, reason = "callers make the text for it")]

use std::fmt;

/// A warning: a damaged or skipped photo, or characters without a glyph.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    photo: Option<String>,
    message: String,
}

impl Note {
    pub(crate) fn new(message: impl fmt::Display) -> Self {
        Self { photo: None, message: message.to_string() }
    }

    pub(crate) fn of(photo: &str, message: impl fmt::Display) -> Self {
        Self { photo: Some(photo.to_owned()), message: message.to_string() }
    }

    /// Name of the photo, if the warning is about one.
    #[must_use]
    pub fn photo(&self) -> Option<&str> {
        self.photo.as_deref()
    }

    /// The warning without the name of the photo.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Note {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(photo) = &self.photo {
            write!(out, "{photo}: ")?;
        }
        out.write_str(&self.message)
    }
}
