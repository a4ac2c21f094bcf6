//! Reads objects field by field, and lists item by item.

use super::{Read, Wrong};
use serde_json::{Map, Value};

/// The fields of an object that are not read yet. [`Fields::done`] rejects unknown fields.
pub struct Fields(Map<String, Value>);

impl Fields {
    /// The fields of an object.
    ///
    /// # Errors
    /// If the value is not an object.
    #[inline(never)]
    pub fn of(value: Value) -> Read<Self> {
        match value {
            Value::Object(map) => Ok(Self(map)),
            _ => Err(Wrong::new("must be an object")),
        }
    }

    /// Takes a field.
    #[inline(never)]
    pub fn take(&mut self, name: &str) -> Option<Value> {
        self.0.remove(name)
    }

    /// Takes a field. Null counts as missing.
    #[inline(never)]
    pub fn told(&mut self, name: &str) -> Option<Value> {
        self.take(name).filter(|value| !value.is_null())
    }

    /// Takes a required field.
    ///
    /// # Errors
    /// When it is missing.
    #[inline(never)]
    pub fn required(&mut self, name: &str) -> Read<Value> {
        self.take(name).ok_or_else(|| missing(name))
    }

    /// Removes a field that is null, so that it counts as missing.
    #[must_use]
    pub fn nullable(&mut self, name: &str) -> &mut Self {
        if self.0.get(name).is_some_and(Value::is_null) {
            self.0.remove(name);
        }
        self
    }

    /// Takes a text of at most `most` characters.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn text(&mut self, name: &str, most: usize) -> Read<Option<String>> {
        match self.take(name).map(|value| text_of(value, most)) {
            None => Ok(None),
            Some(Ok(text)) => Ok(Some(text)),
            Some(Err(wrong)) => Err(wrong.at(name)),
        }
    }

    /// A text that must be there and not empty.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn name(&mut self, name: &str, most: usize) -> Read<String> {
        match self.text(name, most)? {
            None => Err(missing(name)),
            Some(text) if text.is_empty() => Err(Wrong::new("is empty").at(name)),
            Some(text) => Ok(text),
        }
    }

    /// A whole number in a range.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn whole(&mut self, name: &str, least: u64, most: u64) -> Read<Option<u64>> {
        match self.take(name).map(|value| whole_of(&value, least, most)) {
            None => Ok(None),
            Some(Ok(number)) => Ok(Some(number)),
            Some(Err(wrong)) => Err(wrong.at(name)),
        }
    }

    /// A required whole number.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn count(&mut self, name: &str, least: u64, most: u64) -> Read<u64> {
        self.whole(name, least, most)?.ok_or_else(|| missing(name))
    }

    /// A number in a range.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn number(&mut self, name: &str, least: f64, most: f64) -> Read<Option<f64>> {
        let Some(value) = self.take(name) else { return Ok(None) };
        match value.as_f64() {
            Some(number) if (least..=most).contains(&number) => Ok(Some(number)),
            _ => Err(Wrong::new(&format!("must be a number from {least} to {most}")).at(name)),
        }
    }

    /// Takes a boolean. Default: `false`.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn flag(&mut self, name: &str) -> Read<bool> {
        match self.take(name) {
            None => Ok(false),
            Some(Value::Bool(flag)) => Ok(flag),
            Some(_) => Err(Wrong::new("must be true or false").at(name)),
        }
    }

    /// Takes a list of at most `most` items. Default: empty.
    ///
    /// # Errors
    /// For anything else.
    #[inline(never)]
    pub fn list(&mut self, name: &str, most: usize) -> Read<Vec<Value>> {
        match self.take(name).map(|value| items(value, most)) {
            None => Ok(Vec::new()),
            Some(Ok(list)) => Ok(list),
            Some(Err(wrong)) => Err(wrong.at(name)),
        }
    }

    /// Like [`Self::list`], and reads each item.
    ///
    /// # Errors
    /// The errors of `read`.
    pub fn each<T>(&mut self, name: &str, most: usize, read: &dyn Fn(Value) -> Read<T>) -> Read<Vec<T>> {
        each(self.list(name, most)?, read).map_err(|wrong| wrong.at(name))
    }

    /// Takes a field and reads it with `read`. Returns `None` if the field is missing.
    ///
    /// # Errors
    /// The errors of `read`.
    pub fn part<T>(&mut self, name: &str, read: &mut dyn FnMut(Value) -> Read<T>) -> Read<Option<T>> {
        match self.take(name).map(read) {
            None => Ok(None),
            Some(Ok(part)) => Ok(Some(part)),
            Some(Err(wrong)) => Err(wrong.at(name)),
        }
    }

    /// Checks that no fields are left.
    ///
    /// # Errors
    /// For a field that was not taken.
    #[inline(never)]
    pub fn done(self) -> Read<()> {
        match self.0.keys().next() {
            Some(name) => Err(Wrong::new("is not a known field").at(name)),
            None => Ok(()),
        }
    }

    /// The fields that were not taken.
    #[must_use]
    pub fn rest(self) -> Map<String, Value> {
        self.0
    }
}

#[cold]
#[inline(never)]
fn missing(name: &str) -> Wrong {
    Wrong::new("is missing").at(name)
}

/// Returns a text of at most `most` characters.
///
/// # Errors
/// For anything else.
#[inline(never)]
pub fn text_of(value: Value, most: usize) -> Read<String> {
    match value {
        Value::String(text) => not_longer(&text, most).map(|()| text),
        _ => Err(Wrong::new("must be a string")),
    }
}

/// Checks that a text has at most `most` characters.
///
/// # Errors
/// If it is longer.
#[inline(never)]
pub fn not_longer(text: &str, most: usize) -> Read<()> {
    match text.chars().nth(most) {
        None => Ok(()),
        Some(_) => Err(Wrong::beyond(&format!("is longer than {most} characters"))),
    }
}

/// A whole number in a range. It is the same however it was written: 5, 5.0 and 5e0.
///
/// # Errors
/// For anything else.
#[inline(never)]
pub fn whole_of(value: &Value, least: u64, most: u64) -> Read<u64> {
    let number = value.as_u64().or_else(|| {
        value
            .as_f64()
            .filter(|number| (0.0..9e15).contains(number) && number.fract() == 0.0)
            .map(|number| number as u64)
    });
    match number {
        Some(number) if (least..=most).contains(&number) => Ok(number),
        _ => Err(Wrong::new(&format!("must be a whole number from {least} to {most}"))),
    }
}

/// Returns a list of at most `most` items.
///
/// # Errors
/// For anything else.
#[inline(never)]
pub fn items(value: Value, most: usize) -> Read<Vec<Value>> {
    match value {
        Value::Array(items) => at_most(items.len(), most).map(|()| items),
        _ => Err(Wrong::new("must be a list")),
    }
}

/// Checks that a list has at most `most` items.
///
/// # Errors
/// If it is longer.
#[inline(never)]
pub fn at_most(count: usize, most: usize) -> Read<()> {
    if count <= most {
        return Ok(());
    }
    Err(Wrong::beyond(&format!("has {count} entries, at most {most} are allowed")))
}

/// Reads each item of a list.
///
/// # Errors
/// The errors of `read`, with the index of the item.
pub fn each<T>(items: Vec<Value>, read: &dyn Fn(Value) -> Read<T>) -> Read<Vec<T>> {
    let mut all = Vec::with_capacity(items.len());
    for (i, item) in items.into_iter().enumerate() {
        match read(item) {
            Ok(item) => all.push(item),
            Err(wrong) => return Err(wrong.in_list(i)),
        }
    }
    Ok(all)
}
