//! Text parsed within bounds: its length, the number of its values, the length of each text in it.

use super::{Read, Wrong, unmarked};
use serde::de::{DeserializeSeed, Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::fmt;

/// Limits of a JSON text. Nesting ends at 128, as `serde_json` has it.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Bytes of the whole text.
    pub bytes: usize,
    /// Maximum number of values: numbers, texts, lists, objects, booleans and nulls.
    pub values: usize,
    /// Bytes of one text in it, or of the name of a field.
    pub text: usize,
}

/// Parses text within bounds, with or without a byte order mark. Half a character (a lone surrogate, as cutting a text leaves it) is read as U+FFFD.
///
/// # Errors
/// Returns an error with its location if the text is not valid JSON or exceeds `bounds`.
pub fn parse(json: &str, bounds: Bounds) -> Read<Value> {
    if json.len() > bounds.bytes {
        return Err(Wrong::beyond(&format!("is longer than {} MB", bounds.bytes >> 20)));
    }
    let json = whole_characters(unmarked(json));
    let budget =
        Budget { bounds, left: Cell::new(bounds.values), path: RefCell::default(), over: Cell::new(false) };
    let mut deserializer = serde_json::Deserializer::from_str(&json);
    let parsed = Seed(&budget).deserialize(&mut deserializer);
    let parsed = parsed.and_then(|value| deserializer.end().map(|()| value));
    parsed.map_err(|error| {
        let text = error.to_string();
        if !budget.over.get() {
            let reason = format!("is not valid JSON: {text}");
            let deep = text.starts_with("recursion limit");
            return if deep { Wrong::beyond(&reason) } else { Wrong::new(&reason) };
        }
        let reason = text.split(" at line ").next().unwrap_or_default();
        budget.path.take().into_iter().rev().fold(Wrong::beyond(reason), |wrong, step| match step {
            Step::Field(name) => wrong.at(&name),
            Step::Item(index) => wrong.in_list(index),
        })
    })
}

/// The text with `\ufffd` instead of lone surrogates.
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

/// Remaining limits, and the position of the reader.
struct Budget {
    bounds: Bounds,
    left: Cell<usize>,
    path: RefCell<Vec<Step>>,
    /// Whether a bound was passed.
    over: Cell<bool>,
}

enum Step {
    Field(String),
    Item(usize),
}

impl Budget {
    fn error<E: serde::de::Error>(&self, reason: &str) -> E {
        self.over.set(true);
        E::custom(reason)
    }

    fn text<E: serde::de::Error>(&self, text: &str) -> Result<(), E> {
        if text.len() <= self.bounds.text {
            return Ok(());
        }
        Err(self.error(&format!("is a text of more than {} KB", self.bounds.text >> 10)))
    }

    /// Counts one value. On an error its step stays on the path.
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
            .set(left.ok_or_else(|| self.0.error::<D::Error>("exceeds the maximum number of values"))?);
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
        assert!(parsed("{\"a\":1} 2").unwrap_err().starts_with("document: is not valid JSON"));
        assert!(
            parse(&"[".repeat(200), Bounds { values: 1_000, ..BOUNDS })
                .is_err_and(|wrong| wrong.reason().contains("recursion"))
        );
    }

    #[test]
    fn bounds_name_the_place() {
        let long = "x".repeat(2000);
        let cases = [
            (json!({ "a": [{ "b": long }] }), "a[0].b: is a text of more than 1 KB"),
            (json!({ "a": { "x": vec![1; 200] } }), "a.x[97]: exceeds the maximum number of values"),
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
