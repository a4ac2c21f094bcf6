//! JSON writer. Fields keep the order of the calls, because the app compares some of the output as text.

use serde::Serialize;
use serde_json::{Map, Value};

/// Text that grows. The caller must close what it opens.
#[derive(Debug, Default, Clone)]
pub struct Writer(Vec<u8>);

impl Writer {
    /// Opens an object, or begins with `[` a list.
    pub fn open(&mut self, bracket: u8) {
        self.0.push(bracket);
    }

    /// Closes it with `}` or `]`.
    pub fn close(&mut self, bracket: u8) {
        self.0.push(bracket);
    }

    /// Begins the next item of a list.
    pub fn item(&mut self) {
        if !matches!(self.0.last(), Some(b'[') | None) {
            self.0.push(b',');
        }
    }

    /// Begins a field.
    #[inline(never)]
    pub fn key(&mut self, name: &str) -> &mut Self {
        if self.0.last() != Some(&b'{') {
            self.0.push(b',');
        }
        self.text(name);
        self.0.push(b':');
        self
    }

    /// A text.
    #[inline(never)]
    pub fn text(&mut self, text: &str) {
        self.put(&text);
    }

    /// A whole number.
    #[inline(never)]
    pub fn whole(&mut self, number: u64) {
        self.put(&number);
    }

    /// Writes a number; null if it is not finite.
    #[inline(never)]
    pub fn number(&mut self, number: f64) {
        // As in JavaScript: whole numbers without a decimal point.
        if number.fract() == 0.0 && number.abs() < 1e15 {
            self.put(&(number as i64));
        } else {
            self.put(&number);
        }
    }

    /// True or false.
    #[inline(never)]
    pub fn flag(&mut self, flag: bool) {
        self.0.extend(if flag { &b"true"[..] } else { b"false" });
    }

    /// Writes null.
    #[inline(never)]
    pub fn null(&mut self) {
        self.0.extend(b"null");
    }

    /// Anything.
    #[inline(never)]
    pub fn value(&mut self, value: &Value) {
        self.put(value);
    }

    /// Unknown fields.
    #[inline(never)]
    pub fn rest(&mut self, rest: &Map<String, Value>) {
        for (name, value) in rest {
            self.key(name).value(value);
        }
    }

    /// Texts, as a list.
    #[inline(never)]
    pub fn texts(&mut self, texts: &[String]) {
        self.open(b'[');
        for text in texts {
            self.item();
            self.text(text);
        }
        self.close(b']');
    }

    /// Each item of a list.
    pub fn list<T>(&mut self, items: &[T], write: &dyn Fn(&mut Self, &T)) {
        self.open(b'[');
        for item in items {
            self.item();
            write(self, item);
        }
        self.close(b']');
    }

    /// Whether the output is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Appends the output of another writer.
    pub fn append(&mut self, other: &Self) {
        self.0.extend(&other.0);
    }

    /// All that was written.
    #[must_use]
    pub fn finish(self) -> String {
        // All input was text.
        String::from_utf8(self.0).unwrap_or_default()
    }

    /// Writes any serialisable value.
    pub fn put(&mut self, value: &impl Serialize) {
        // Writing into memory cannot fail, and all keys are text.
        let _: serde_json::Result<()> = serde_json::to_writer(&mut self.0, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_written_is_json_in_its_order() {
        let mut out = Writer::default();
        out.open(b'{');
        out.key("z").text("a\"\n");
        out.key("list").list(&[1, 2], &|out, number| out.whole(*number));
        out.key("none").list(&[0u8; 0], &|_, _| {});
        for number in [0.5, 2.0, -0.0, 1e300, f64::NAN] {
            out.key("n").number(number);
        }
        out.key("flag").flag(true);
        out.key("null").null();
        out.rest(json!({ "a": [{}], "b": 1.5 }).as_object().unwrap());
        out.close(b'}');
        let text = out.finish();
        assert_eq!(
            text,
            r#"{"z":"a\"\n","list":[1,2],"none":[],"n":0.5,"n":2,"n":0,"n":1e+300,"n":null,"flag":true,"null":null,"a":[{}],"b":1.5}"#
        );
        serde_json::from_str::<Value>(&text).unwrap();
    }
}
