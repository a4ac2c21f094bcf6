//! Reads protocol buffers from untrusted input: fields with a number, each a whole number or bytes.

use crate::error::{Error, Result};

/// The value of a field.
#[derive(Debug, Clone, Copy)]
pub(super) enum Value<'a> {
    Number(u64),
    Bytes(&'a [u8]),
}

/// A message: its fields in their order.
#[derive(Debug)]
pub(super) struct Message<'a>(Vec<(u64, Value<'a>)>);

impl<'a> Message<'a> {
    /// Splits a message into its fields.
    ///
    /// # Errors
    /// `damaged-painters` for truncated bytes.
    pub(super) fn new(mut bytes: &'a [u8]) -> Result<Self> {
        let mut fields = Vec::new();
        while !bytes.is_empty() {
            let tag = number(&mut bytes)?;
            let value = match tag & 7 {
                0 => Value::Number(number(&mut bytes)?),
                1 => Value::Bytes(take(&mut bytes, 8)?),
                2 => {
                    let count = number(&mut bytes)?;
                    Value::Bytes(take(&mut bytes, count)?)
                }
                5 => Value::Bytes(take(&mut bytes, 4)?),
                _ => return Err(truncated()),
            };
            fields.push((tag >> 3, value));
        }
        Ok(Self(fields))
    }

    /// All values of a field.
    fn all(&self, field: u64) -> impl Iterator<Item = Value<'a>> {
        self.0.iter().filter(move |(number, _)| *number == field).map(|(_, value)| *value)
    }

    /// The last bytes of a field, or `None`.
    pub(super) fn bytes(&self, field: u64) -> Option<&'a [u8]> {
        self.all(field).filter_map(bytes_of).last()
    }

    /// A text; empty if the field is missing.
    pub(super) fn text(&self, field: u64) -> &'a str {
        self.bytes(field).and_then(|bytes| std::str::from_utf8(bytes).ok()).unwrap_or_default()
    }

    /// A list of texts.
    pub(super) fn texts(&self, field: u64) -> Vec<&'a str> {
        let text = |bytes| std::str::from_utf8(bytes).unwrap_or_default();
        self.all(field).filter_map(bytes_of).map(text).collect()
    }

    /// The last number of a field, or `None`.
    pub(super) fn number(&self, field: u64) -> Option<u64> {
        let number = |value| if let Value::Number(number) = value { Some(number) } else { None };
        self.all(field).filter_map(number).last()
    }

    /// A list of numbers, single or packed.
    ///
    /// # Errors
    /// `damaged-painters` for truncated bytes.
    pub(super) fn numbers(&self, field: u64) -> Result<Vec<u64>> {
        let mut list = Vec::new();
        for value in self.all(field) {
            match value {
                Value::Number(one) => list.push(one),
                Value::Bytes(mut packed) => {
                    while !packed.is_empty() {
                        list.push(number(&mut packed)?);
                    }
                }
            }
        }
        Ok(list)
    }

    /// A list of messages.
    ///
    /// # Errors
    /// `damaged-painters` for truncated bytes.
    pub(super) fn messages(&self, field: u64) -> Result<Vec<Self>> {
        self.all(field).filter_map(bytes_of).map(Self::new).collect()
    }
}

fn bytes_of(value: Value<'_>) -> Option<&[u8]> {
    if let Value::Bytes(bytes) = value { Some(bytes) } else { None }
}

/// Seven bits per byte, the lowest first.
fn number(bytes: &mut &[u8]) -> Result<u64> {
    let mut value = 0;
    for shift in (0..64).step_by(7) {
        let (&byte, rest) = bytes.split_first().ok_or_else(truncated)?;
        *bytes = rest;
        value |= u64::from(byte & 0x7f) << shift;
        if byte < 0x80 {
            return Ok(value);
        }
    }
    Err(truncated())
}

fn take<'a>(bytes: &mut &'a [u8], count: u64) -> Result<&'a [u8]> {
    let count = usize::try_from(count).map_err(|_| truncated())?;
    let (taken, rest) = bytes.split_at_checked(count).ok_or_else(truncated)?;
    *bytes = rest;
    Ok(taken)
}

fn truncated() -> Error {
    Error::DamagedPainters("it is not an ONNX file, or it is truncated".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_read_as_the_format_defines() {
        // 1: 300, 2: "ab", 3: packed 1 and 300.
        let bytes = [0x08, 0xac, 0x02, 0x12, 2, b'a', b'b', 0x1a, 3, 1, 0xac, 0x02];
        let message = Message::new(&bytes).unwrap();
        assert_eq!(message.number(1), Some(300));
        assert_eq!((message.text(2), message.texts(2)), ("ab", vec!["ab"]));
        assert_eq!(message.numbers(3).unwrap(), [1, 300]);
        assert_eq!(message.number(4), None);
    }

    #[test]
    fn truncated_bytes_are_rejected() {
        for bytes in [&[0x08][..], &[0x12, 5, 1], &[0x0b], &[0xff; 12]] {
            assert!(Message::new(bytes).is_err(), "{bytes:?}");
        }
    }
}
