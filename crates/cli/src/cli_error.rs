//! Errors of the command line: a message for people, and a stable code for programs.

#![allow(clippy::needless_pass_by_value, reason = "it is what map_err and callers hand over")]

use inkpanel::Failure;
use inkpanel_engine::Error;
use std::fmt::{self, Display};
use std::io::{self, ErrorKind};
use std::path::Path;

/// An error with the codes of the public API. Text without a code is an invalid argument.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CliError {
    code: &'static str,
    message: String,
}

impl CliError {
    pub(crate) fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self { code, message: message.into() }
    }

    /// A file that cannot be read.
    pub(crate) fn reading(error: &io::Error) -> Self {
        let code = if error.kind() == ErrorKind::NotFound { "not-found" } else { "unreadable" };
        Self::new(code, error.to_string())
    }

    /// A file or folder that cannot be written.
    pub(crate) fn writing(path: &Path, error: &io::Error) -> Self {
        Self::new("unwritable", error.to_string()).at(path.display())
    }

    /// Text that is not JSON.
    pub(crate) fn not_json(error: serde_json::Error) -> Self {
        Self::new("invalid-document", format!("not valid JSON: {error}"))
    }

    /// A bug.
    pub(crate) fn fault(error: impl Display) -> Self {
        Self::new("fault", format!("internal error; please report it: {error}"))
    }

    /// Adds the file or the part of the input to the message.
    pub(crate) fn at(self, place: impl Display) -> Self {
        Self { message: format!("{place}: {}", self.message), ..self }
    }

    /// Stable name of the kind of error.
    pub(crate) fn code(&self) -> &'static str {
        self.code
    }
}

impl Display for CliError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.message)
    }
}

impl From<Error> for CliError {
    fn from(error: Error) -> Self {
        Self::new(error.code(), error.to_string())
    }
}

impl From<Failure> for CliError {
    fn from(failure: Failure) -> Self {
        Self::new(failure.code(), failure.to_string())
    }
}

impl From<String> for CliError {
    fn from(message: String) -> Self {
        Self::new("invalid-argument", message)
    }
}

impl From<&str> for CliError {
    fn from(message: &str) -> Self {
        message.to_owned().into()
    }
}
