//! Reads typed values with `serde`. Errors have the path of the field, and a reason in the words of the other
//! readers. Ranges of lengths and lists are left to the `validate` of each type.

use super::{Read, Wrong};
use serde::de::{Deserialize, DeserializeOwned, Deserializer, Error};
use serde_json::Value;
use serde_path_to_error::{Path, Segment, Track};

/// Deserializer that tracks the path of the field.
pub type Tracked<'a> = serde_path_to_error::Deserializer<'a, 'a, Value>;

/// Reads a value.
///
/// # Errors
/// Returns the location of the error.
pub fn typed<T: DeserializeOwned>(value: Value) -> Read<T> {
    typed_by(value, &|deserializer| T::deserialize(deserializer))
}

/// [`typed`] with another function than the `Deserialize` of the type.
///
/// # Errors
/// Returns the location of the error.
pub fn typed_by<T>(value: Value, read: &dyn Fn(Tracked<'_>) -> serde_json::Result<T>) -> Read<T> {
    let mut track = Track::new();
    let read = read(Tracked::new(value, &mut track));
    read.map_err(|error| wrong(&track.path(), &error.to_string()))
}

#[cold]
#[inline(never)]
fn wrong(path: &Path, message: &str) -> Wrong {
    let mut steps: Vec<&Segment> = path.iter().collect();
    let quoted = |prefix: &str| message.strip_prefix(prefix)?.split('`').next();
    let expected = || message.split_once(", expected ").map(|(_, expected)| expected);
    let (mut wrong, field) = match (quoted("missing field `"), quoted("unknown field `")) {
        (Some(field), _) => (Wrong::new("is missing"), Some(field)),
        (_, Some(field)) => (Wrong::new("is not a known field"), Some(field)),
        _ if message.starts_with("unknown variant") => {
            let names = expected()
                .unwrap_or_default()
                .trim_start_matches("one of ")
                .replace('`', "")
                .replace(" or ", ", ");
            (Wrong::new(&format!("must be one of {names}")), None)
        }
        _ if message.starts_with("invalid ") => {
            (expected().map_or_else(|| Wrong::new(message), |expected| Wrong::new(&must_be(expected))), None)
        }
        _ => (Wrong::new(message), None),
    };
    if let Some(field) = field {
        // The path may already end with the field.
        if matches!(steps.last(), Some(Segment::Map { key }) if key == field) {
            steps.pop();
        }
        wrong = wrong.at(field);
    }
    steps.into_iter().rev().fold(wrong, |wrong, step| match step {
        Segment::Seq { index } => wrong.in_list(*index),
        Segment::Map { key } => wrong.at(key),
        Segment::Enum { .. } | Segment::Unknown => wrong,
    })
}

/// The expectation of `serde` in plain words.
fn must_be(expected: &str) -> String {
    let plain = match expected {
        "u8" | "u32" | "u64" | "usize" | "i64" => "a whole number",
        "f64" | "f32" => "a number",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => "an object",
        _ if expected.starts_with("struct ") => "an object",
        other => other,
    };
    format!("must be {plain}")
}

/// A whole number from `LEAST` to `MOST`. It is the same number however it was written: 5, 5.0 and 5e0.
///
/// # Errors
/// For anything else.
pub fn whole<'de, D, T, const LEAST: u64, const MOST: u64>(deserializer: D) -> Result<T, D::Error>
where
    D: Deserializer<'de>,
    T: TryFrom<u64>,
{
    let value = Value::deserialize(deserializer)?;
    let number =
        super::fields::whole_of(&value, LEAST, MOST).map_err(|wrong| Error::custom(wrong.reason()))?;
    T::try_from(number).map_err(|_| Error::custom("is too large"))
}

/// A value, or the default of its type for null.
///
/// # Errors
/// The errors of the type.
pub fn nullable<'de, D: Deserializer<'de>, T: Deserialize<'de> + Default>(
    deserializer: D,
) -> Result<T, D::Error> {
    Option::deserialize(deserializer).map(Option::unwrap_or_default)
}

/// Returns whether a field has its default value, which is not written.
pub fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[derive(Debug, PartialEq, serde::Deserialize)]
    #[serde(rename_all = "lowercase")]
    enum Side {
        Left,
        Right,
    }

    #[derive(Debug, PartialEq, serde::Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Item {
        #[serde(deserialize_with = "whole::<_, _, 1, 64>")]
        bits: u8,
        #[serde(default, deserialize_with = "nullable")]
        on: bool,
        side: Side,
        #[serde(default)]
        items: Vec<Item>,
        #[serde(default)]
        gap: Option<f64>,
    }

    #[test]
    fn a_whole_number_and_null_are_read_however_they_are_written() {
        let item: Item = typed(json!({ "bits": 5.0, "on": null, "side": "left" })).unwrap();
        assert_eq!((item.bits, item.on, item.side), (5, false, Side::Left));
    }

    #[test]
    fn errors_name_the_field_and_what_it_must_be() {
        let cases = [
            (json!({ "side": "left" }), "bits: is missing"),
            (json!({ "bits": 1, "side": "up" }), "side: must be one of left, right"),
            (json!({ "bits": 65, "side": "left" }), "bits: must be a whole number from 1 to 64"),
            (json!({ "bits": 1.5, "side": "left" }), "bits: must be a whole number from 1 to 64"),
            (json!({ "bits": 1, "side": "left", "on": 1 }), "on: must be true or false"),
            (json!({ "bits": 1, "side": "left", "gap": "1" }), "gap: must be a number"),
            (json!({ "bits": 1, "side": "left", "items": {} }), "items: must be a list"),
            (json!({ "bits": 1, "side": "left", "items": [4] }), "items[0]: must be an object"),
            (json!({ "bits": 1, "side": "left", "items": [{ "bits": 1 }] }), "items[0].side: is missing"),
            (json!({ "bits": 1, "side": "left", "top": 1 }), "top: is not a known field"),
            (
                json!({ "bits": 1, "side": "left", "items": [{ "bits": 1, "side": "right", "gap": [] }] }),
                "items[0].gap: must be a number",
            ),
            (json!([1]), "document: must be an object"),
        ];
        for (value, message) in cases {
            assert_eq!(typed::<Item>(value.clone()).unwrap_err().to_string(), message, "{value}");
        }
    }
}
