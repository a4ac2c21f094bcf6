//! A cursor in a JSON value that knows its path, so that an error can name the field.

use std::ops::RangeInclusive;

use serde_json::{Map, Value};

use crate::error::{Error, Result};

/// Longest text of a layout file that is read at all, in bytes; the largest sensible one has a tenth.
const LONGEST_FILE: usize = 256 * 1024;

/// A value of a layout file and the path that leads to it.
pub(super) struct Field<'a> {
    file: &'a str,
    path: String,
    value: &'a Value,
}

/// Parses the text of a layout file.
pub(super) fn read(file: &str, json: &str) -> Result<Value> {
    let fail =
        |location: String, reason: String| Error::InvalidLayout { file: file.into(), location, reason };
    if json.len() > LONGEST_FILE {
        return Err(fail("file".into(), format!("is longer than {} KB", LONGEST_FILE / 1024)));
    }
    serde_json::from_str(json).map_err(|error| {
        let place = format!("line {}, column {}", error.line(), error.column());
        let reason = error.to_string();
        // serde_json repeats the place at the end of its sentence.
        fail(place, reason.split(" at line ").next().unwrap_or_default().to_owned())
    })
}

impl<'a> Field<'a> {
    pub(super) fn root(file: &'a str, value: &'a Value) -> Self {
        Self { file, path: String::new(), value }
    }

    /// Returns an error for this field. `reason` follows the path of the field.
    pub(super) fn error(&self, reason: impl Into<String>) -> Error {
        let location = if self.path.is_empty() { "file".into() } else { self.path.clone() };
        Error::InvalidLayout { file: self.file.into(), location, reason: reason.into() }
    }

    /// The object here, after checking that it has no field but those allowed.
    pub(super) fn object(&self, allowed: &[&str]) -> Result<()> {
        let object = self.map(allowed)?;
        for key in object.keys() {
            if !allowed.contains(&key.as_str()) {
                return Err(self
                    .at_key(key, &Value::Null)
                    .error(format!("is not a field of this object; the fields are {}", allowed.join(", "))));
            }
        }
        Ok(())
    }

    fn map(&self, expected: &[&str]) -> Result<&'a Map<String, Value>> {
        self.value.as_object().ok_or_else(|| {
            self.error(format!("must be an object with {}, not {}", expected.join(", "), kind(self.value)))
        })
    }

    /// The field of that name, if it is there.
    pub(super) fn get(&self, key: &str) -> Option<Field<'a>> {
        self.value.as_object()?.get(key).map(|value| self.at_key(key, value))
    }

    /// The field of that name, which must be there.
    pub(super) fn required(&self, key: &str) -> Result<Field<'a>> {
        self.get(key).ok_or_else(|| self.at_key(key, &Value::Null).error("is missing"))
    }

    /// A finite number inside the range.
    pub(super) fn number(&self, range: RangeInclusive<f64>) -> Result<f64> {
        let number = self
            .value
            .as_f64()
            .ok_or_else(|| self.error(format!("must be a number, not {}", kind(self.value))))?;
        if range.contains(&number) {
            return Ok(number);
        }
        Err(self.error(format!("must be from {} to {}, not {number}", range.start(), range.end())))
    }

    /// A whole number below `limit`.
    pub(super) fn index(&self, limit: usize) -> Result<usize> {
        let number = self.value.as_u64().and_then(|n| usize::try_from(n).ok());
        number.filter(|n| *n < limit).ok_or_else(|| {
            self.error(format!("must be a whole number from 0 to {}, not {}", limit - 1, self.value))
        })
    }

    /// A text of 1 to `longest` characters.
    pub(super) fn text(&self, longest: usize) -> Result<&'a str> {
        let text = self
            .value
            .as_str()
            .ok_or_else(|| self.error(format!("must be a text, not {}", kind(self.value))))?;
        let length = text.chars().count();
        if text.trim().is_empty() || length > longest || text.chars().any(char::is_control) {
            return Err(self.error(format!("must be a text of 1 to {longest} printable characters")));
        }
        Ok(text)
    }

    /// True when this is exactly that text.
    pub(super) fn is_text(&self, text: &str) -> bool {
        self.value.as_str() == Some(text)
    }

    /// Reads a list with a length in the range.
    pub(super) fn list(&self, lengths: RangeInclusive<usize>) -> Result<Vec<Field<'a>>> {
        let list = self
            .value
            .as_array()
            .ok_or_else(|| self.error(format!("must be a list, not {}", kind(self.value))))?;
        if !lengths.contains(&list.len()) {
            let (least, most) = (lengths.start(), lengths.end());
            let wanted = if least == most { format!("{least}") } else { format!("{least} to {most}") };
            return Err(self.error(format!("must have {wanted} elements, not {}", list.len())));
        }
        Ok(list
            .iter()
            .enumerate()
            .map(|(i, value)| Field { file: self.file, path: format!("{}[{i}]", self.path), value })
            .collect())
    }

    /// A list of exactly `length` numbers inside the range.
    pub(super) fn numbers(&self, length: usize, range: &RangeInclusive<f64>) -> Result<Vec<f64>> {
        self.list(length..=length)?.iter().map(|field| field.number(range.clone())).collect()
    }

    fn at_key(&self, key: &str, value: &'a Value) -> Field<'a> {
        let path = if self.path.is_empty() { key.into() } else { format!("{}.{key}", self.path) };
        Field { file: self.file, path, value }
    }
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "true or false",
        Value::Number(_) => "a number",
        Value::String(_) => "a text",
        Value::Array(_) => "a list",
        Value::Object(_) => "an object",
    }
}
