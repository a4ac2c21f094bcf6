//! Texts of several languages, one JSON file each.

use crate::error::{Error, Result};
use serde::de::DeserializeOwned;

/// Reads the texts of a language, a BCP 47 tag such as `pt-BR`. `files` are the codes of the languages, with their files; the
/// first one replaces languages that are not available.
///
/// # Errors
/// `invalid-document` if a file does not have the texts. Tests check all files.
pub(crate) fn texts_in<T: DeserializeOwned>(language: &str, files: &[(&str, &str)]) -> Result<T> {
    let wanted = language.split('-').next().unwrap_or_default();
    let found = files.iter().find(|(code, _)| code.eq_ignore_ascii_case(wanted)).or(files.first());
    let (code, json) = found.copied().unwrap_or_default();
    serde_json::from_str(json)
        .map_err(|error| Error::InvalidDocument { location: code.to_owned(), reason: error.to_string() })
}
