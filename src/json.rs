//! JSON of strangers: parsed within bounds, then taken apart field by field. What is wrong knows its place, which grows
//! on the way up: `size` becomes `words[3].size` becomes `present.page.words[3].size`.

use crate::error::Error;
use serde::de::{DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::fmt;
use std::ops::RangeInclusive;

/// What is wrong with a document, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrong {
    /// Path of the field, empty for the whole.
    pub place: String,
    /// In words that follow the place.
    pub reason: String,
    /// It is not damaged but made by a newer program.
    pub newer: bool,
}

/// What a reader of a part gives.
pub type Read<T> = std::result::Result<T, Wrong>;

/// Bounds of a text of JSON, whatever it says. Nesting ends at 128, as `serde_json` has it.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Bytes of the whole text.
    pub bytes: usize,
    /// Values in it: numbers, texts, lists, objects and all else.
    pub values: usize,
    /// Bytes of one text in it, or of the name of a field.
    pub text: usize,
}

impl Wrong {
    /// A part that is wrong.
    #[must_use]
    pub fn new(reason: impl Into<String>) -> Self {
        Self { place: String::new(), reason: reason.into(), newer: false }
    }

    /// A part of a version that this program does not know.
    #[must_use]
    pub fn newer(version: u64, known: u64) -> Self {
        Self { newer: true, ..Self::new(format!("{version} is newer than {known}")) }
    }

    /// The place and the reason of an error of the engine.
    #[must_use]
    pub fn of(error: Error) -> Self {
        match error {
            Error::InvalidStyle { location, reason, .. }
            | Error::InvalidLayout { location, reason, .. }
            | Error::InvalidDocument { location, reason } => {
                let place = if location == "file" { String::new() } else { location };
                Self { place, ..Self::new(reason) }
            }
            other => Self::new(other.to_string()),
        }
    }

    /// The same, told from the object that has it in that field.
    #[must_use]
    pub fn at(mut self, field: &str) -> Self {
        let dot = if self.place.is_empty() || self.place.starts_with('[') { "" } else { "." };
        self.place = format!("{field}{dot}{}", self.place);
        self
    }

    /// The same, told from the list that has it at that place.
    #[must_use]
    pub fn in_list(self, index: usize) -> Self {
        self.at(&format!("[{index}]"))
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = if self.place.is_empty() { "document" } else { &self.place };
        write!(f, "{place}: {}", self.reason)
    }
}

/// Parses text within bounds. Half a character (a lone surrogate, as cutting a text leaves it) is read as U+FFFD.
///
/// # Errors
/// For what is no JSON, and beyond the bounds, with the place.
pub fn parse(json: &str, bounds: Bounds) -> Read<Value> {
    if json.len() > bounds.bytes {
        return Err(Wrong::new(format!("is longer than {} MB", bounds.bytes >> 20)));
    }
    let json = whole_characters(json);
    let budget =
        Budget { bounds, left: Cell::new(bounds.values), path: RefCell::default(), wrong: Cell::new(false) };
    let mut deserializer = serde_json::Deserializer::from_str(&json);
    let parsed = Seed(&budget).deserialize(&mut deserializer);
    let parsed = parsed.and_then(|value| deserializer.end().map(|()| value));
    parsed.map_err(|error| {
        let text = error.to_string();
        if !budget.wrong.get() {
            return Wrong::new(format!("is no JSON: {text}"));
        }
        let reason = text.split(" at line ").next().unwrap_or_default();
        budget.path.take().into_iter().rev().fold(Wrong::new(reason), |wrong, step| match step {
            Step::Field(name) => wrong.at(&name),
            Step::Item(index) => wrong.in_list(index),
        })
    })
}

/// The text with `\ufffd` in the place of escapes that are half a character.
fn whole_characters(json: &str) -> Cow<'_, str> {
    let bytes = json.as_bytes();
    let unit = |at: usize| {
        let escape = bytes.get(at..at + 6)?.strip_prefix(b"\\u")?;
        u16::from_str_radix(std::str::from_utf8(escape).ok()?, 16).ok()
    };
    let mut mended = String::new();
    let (mut copied, mut at) = (0, 0);
    while let Some(found) = bytes.get(at..).and_then(|rest| rest.iter().position(|byte| *byte == b'\\')) {
        at += found;
        let high = unit(at).is_some_and(|unit| (0xd800..0xdc00).contains(&unit));
        let low = |at| unit(at).is_some_and(|unit| (0xdc00..0xe000).contains(&unit));
        if high && low(at + 6) {
            at += 12;
        } else if high || low(at) {
            mended.push_str(&json[copied..at]);
            mended.push_str("\\ufffd");
            at += 6;
            copied = at;
        } else {
            at += 2;
        }
    }
    if copied == 0 {
        return Cow::Borrowed(json);
    }
    mended.push_str(&json[copied..]);
    Cow::Owned(mended)
}

/// What may still come, and where the reader is.
struct Budget {
    bounds: Bounds,
    left: Cell<usize>,
    path: RefCell<Vec<Step>>,
    wrong: Cell<bool>,
}

enum Step {
    Field(String),
    Item(usize),
}

impl Budget {
    fn error<E: serde::de::Error>(&self, reason: &str) -> E {
        self.wrong.set(true);
        E::custom(reason)
    }

    fn text<E: serde::de::Error>(&self, text: &str) -> Result<(), E> {
        if text.len() <= self.bounds.text {
            return Ok(());
        }
        Err(self.error(&format!("is a text of more than {} KB", self.bounds.text >> 10)))
    }

    /// One more value; what fails inside of it leaves its step on the path.
    fn step<T, E>(&self, step: Step, read: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        self.path.borrow_mut().push(step);
        let value = read()?;
        self.path.borrow_mut().pop();
        Ok(value)
    }
}

/// Reads one value on a budget.
#[derive(Clone, Copy)]
struct Seed<'b>(&'b Budget);

impl<'de> DeserializeSeed<'de> for Seed<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        let left = self.0.left.get().checked_sub(1);
        self.0
            .left
            .set(left.ok_or_else(|| self.0.error::<D::Error>("and all before it are too many values"))?);
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Seed<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Bool(value))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_f64<E>(self, value: f64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Value, E> {
        self.0.text::<E>(text)?;
        Ok(Value::String(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = self.0.step(Step::Item(values.len()), || list.next_element_seed(self))? {
            values.push(value);
        }
        Ok(Value::Array(values))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let mut fields = Map::new();
        while let Some(name) = map.next_key::<Cow<'de, str>>()? {
            self.0.text::<A::Error>(&name)?;
            let name = name.into_owned();
            let value = self.0.step(Step::Field(name.clone()), || map.next_value_seed(self))?;
            fields.insert(name, value);
        }
        Ok(Value::Object(fields))
    }
}

/// An object that is taken apart; what is left over at the end is not known.
pub struct Fields(Map<String, Value>);

impl Fields {
    /// The fields of an object.
    ///
    /// # Errors
    /// When the value is none.
    pub fn of(value: Value) -> Read<Self> {
        match value {
            Value::Object(map) => Ok(Self(map)),
            _ => Err(Wrong::new("is no object")),
        }
    }

    /// Takes a field, which must be there.
    ///
    /// # Errors
    /// When it is missing.
    pub fn required(&mut self, name: &str) -> Read<Value> {
        self.take(name).ok_or_else(|| Wrong::new("is missing").at(name))
    }

    /// Takes a field.
    pub fn take(&mut self, name: &str) -> Option<Value> {
        self.0.remove(name)
    }

    /// Takes a field and reads it; what is wrong with it has its name.
    ///
    /// # Errors
    /// Those of `read`.
    pub fn read<T>(&mut self, name: &str, read: impl FnOnce(Value) -> Read<T>) -> Read<Option<T>> {
        self.take(name).map(read).transpose().map_err(|wrong| wrong.at(name))
    }

    /// The same of a field that may be null, which is as if it were missing.
    ///
    /// # Errors
    /// Those of `read`.
    pub fn nullable<T>(&mut self, name: &str, read: impl FnOnce(Value) -> Read<T>) -> Read<Option<T>> {
        let told = self.take(name).filter(|value| !value.is_null());
        told.map(read).transpose().map_err(|wrong| wrong.at(name))
    }

    /// Nothing else may be there.
    ///
    /// # Errors
    /// For a field that was not taken.
    pub fn done(self) -> Read<()> {
        match self.0.keys().next() {
            Some(name) => Err(Wrong::new("is not known here").at(name)),
            None => Ok(()),
        }
    }

    /// What was not taken.
    #[must_use]
    pub fn rest(self) -> Map<String, Value> {
        self.0
    }
}

/// A text of at most so many characters.
///
/// # Errors
/// For anything else.
pub fn text(most: usize) -> impl Fn(Value) -> Read<String> {
    move |value| match value {
        Value::String(text) if text.chars().nth(most).is_none() => Ok(text),
        Value::String(_) => Err(Wrong::new(format!("is longer than {most} characters"))),
        _ => Err(Wrong::new("is no text")),
    }
}

/// The same, but not empty.
///
/// # Errors
/// For anything else.
pub fn name(most: usize) -> impl Fn(Value) -> Read<String> {
    move |value| match text(most)(value)? {
        text if text.is_empty() => Err(Wrong::new("is empty")),
        text => Ok(text),
    }
}

/// A whole number in a range.
///
/// # Errors
/// For anything else.
pub fn whole(range: RangeInclusive<u64>) -> impl Fn(Value) -> Read<u64> {
    move |value| {
        // A whole number is the same however it was written: 5, 5.0 and 5e0.
        let decimal =
            || value.as_f64().filter(|n| n.fract() == 0.0 && (0.0..9e15).contains(n)).map(|n| n as u64);
        let number = value.as_u64().or_else(decimal).filter(|number| range.contains(number));
        number.ok_or_else(|| {
            Wrong::new(format!("is no whole number from {} to {}", range.start(), range.end()))
        })
    }
}

/// A number in a range.
///
/// # Errors
/// For anything else.
pub fn number(range: RangeInclusive<f64>) -> impl Fn(Value) -> Read<f64> {
    move |value| {
        let number = value.as_f64().filter(|number| range.contains(number));
        number.ok_or_else(|| Wrong::new(format!("is no number from {} to {}", range.start(), range.end())))
    }
}

/// True or false.
///
/// # Errors
/// For anything else.
#[allow(clippy::needless_pass_by_value, reason = "readers take values")]
pub fn flag(value: Value) -> Read<bool> {
    value.as_bool().ok_or_else(|| Wrong::new("is neither true nor false"))
}

/// A list of at most so many, each read.
///
/// # Errors
/// For anything else, and those of `read`.
pub fn list<T>(most: usize, mut read: impl FnMut(Value) -> Read<T>) -> impl FnMut(Value) -> Read<Vec<T>> {
    move |value| {
        let Value::Array(values) = value else { return Err(Wrong::new("is no list")) };
        if values.len() > most {
            return Err(Wrong::new(format!("has {} entries, at most {most} are allowed", values.len())));
        }
        values
            .into_iter()
            .enumerate()
            .map(|(i, value)| read(value).map_err(|wrong| wrong.in_list(i)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const BOUNDS: Bounds = Bounds { bytes: 1 << 20, values: 100, text: 1 << 10 };

    fn parsed(json: &str) -> std::result::Result<Value, String> {
        parse(json, BOUNDS).map_err(|wrong| wrong.to_string())
    }

    #[test]
    fn what_is_in_bounds_is_what_serde_reads() {
        let text = r#"{"a":[1,-2,2.5,"x\n\u00e9\ud83d\ude00",true,null],"b":{"c":[]},"a":[0]}"#;
        assert_eq!(parsed(text).unwrap(), serde_json::from_str::<Value>(text).unwrap());
        assert!(parsed("{\"a\":1} 2").unwrap_err().starts_with("document: is no JSON"));
        assert!(
            parse(&"[".repeat(200), Bounds { values: 1_000, ..BOUNDS })
                .is_err_and(|wrong| wrong.reason.contains("recursion"))
        );
    }

    #[test]
    fn bounds_name_the_place() {
        let long = "x".repeat(2000);
        let cases = [
            (json!({ "a": [{ "b": long }] }), "a[0].b: is a text of more than 1 KB"),
            (json!({ "a": { "x": vec![1; 200] } }), "a.x[97]: and all before it are too many values"),
        ];
        for (value, message) in cases {
            assert_eq!(parsed(&value.to_string()).unwrap_err(), message);
        }
        assert_eq!(parsed(&" ".repeat(2 << 20)).unwrap_err(), "document: is longer than 1 MB");
        assert!(parsed(&json!({ long: 1 }).to_string()).is_err());
    }

    #[test]
    fn half_a_character_is_replaced() {
        let cases = [
            (r#""a\ud800""#, "a\u{fffd}"),
            (r#""\udc00b""#, "\u{fffd}b"),
            (r#""\ud800\ud83d\ude00""#, "\u{fffd}\u{1f600}"),
            (r#""\\ud800""#, "\\ud800"),
            (r#""é\ud83dé\u00e9""#, "é\u{fffd}éé"),
        ];
        for (json, text) in cases {
            assert_eq!(parsed(json).unwrap(), json!(text), "{json}");
        }
        for broken in [r#""\ud8"#, r#""\u"#, r#""\"#] {
            assert!(parsed(broken).is_err());
        }
    }
}
