//! Errors of the public API.

use inkpanel_engine::error::Error;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// An error: a message, a stable code, and the photo, if any.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    code: &'static str,
    message: String,
    photo: Option<String>,
}

impl Failure {
    pub(crate) fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), photo: None }
    }

    /// An argument that is not what it should be.
    pub(crate) fn argument(name: &str, reason: &str) -> Self {
        Self::new("invalid-argument", format!("{name}: {reason}"))
    }

    /// Adds the name of a photo.
    pub(crate) fn of(self, photo: &str) -> Self {
        Self { photo: Some(photo.to_owned()), ..self }
    }

    /// Returns the message without the name of the photo.
    #[must_use]
    pub fn reason(&self) -> &str {
        &self.message
    }

    /// A name of the kind of failure that stays the same from version to version: `unknown-style`, `damaged`, `not-found`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.code
    }

    /// Name of the photo that caused the error, if any.
    #[must_use]
    pub fn photo(&self) -> Option<&str> {
        self.photo.as_deref()
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(photo) = &self.photo {
            write!(out, "{photo}: ")?;
        }
        out.write_str(&self.message)
    }
}

impl std::error::Error for Failure {}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::new(error.code(), error.to_string())
    }
}

/// Returns the result of `work`. A panic in it, which is a bug or a fault of a decoder, becomes a failure
/// with the code `fault`. One bad photo must not stop the program.
///
/// # Errors
/// Returns the errors of `work`, or `fault`.
pub fn survived<T, F: From<Failure>>(work: impl FnOnce() -> Result<T, F>) -> Result<T, F> {
    // Nothing reads the state that a panic may leave incomplete.
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        let message = "internal error; please report it with the message on standard error";
        Err(Failure::new("fault", message).into())
    })
}
