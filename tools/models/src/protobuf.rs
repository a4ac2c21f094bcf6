//! Reads protocol buffers: fields with a number, each a whole number or bytes. Everything is checked, as the bytes are a
//! stranger's.

use anyhow::{Context, Result, bail};

/// A message: its fields in their order.
pub(super) struct Message<'a> {
    fields: Vec<(u64, Value<'a>)>,
}

/// The value of a field.
#[derive(Clone, Copy)]
pub(super) enum Value<'a> {
    Number(u64),
    Bytes(&'a [u8]),
}

impl<'a> Message<'a> {
    /// Takes a message apart.
    pub(super) fn new(mut bytes: &'a [u8]) -> Result<Self> {
        let mut fields = Vec::new();
        while !bytes.is_empty() {
            let tag = number(&mut bytes)?;
            let value = match tag & 7 {
                0 => Value::Number(number(&mut bytes)?),
                1 => Value::Bytes(take(&mut bytes, 8)?),
                2 => {
                    let count = number(&mut bytes)?;
                    Value::Bytes(take(&mut bytes, usize::try_from(count)?)?)
                }
                5 => Value::Bytes(take(&mut bytes, 4)?),
                kind => bail!("a field of the unknown kind {kind}"),
            };
            fields.push((tag >> 3, value));
        }
        Ok(Self { fields })
    }

    /// All values of a field.
    #[allow(clippy::unnecessary_wraps, reason = "it reads like its kin")]
    pub(super) fn all(&self, field: u64) -> Result<Vec<Value<'a>>> {
        Ok(self.fields.iter().filter(|(number, _)| *number == field).map(|(_, value)| *value).collect())
    }

    /// The bytes of a field.
    pub(super) fn bytes(&self, field: u64) -> Result<Option<&'a [u8]>> {
        self.all(field)?.last().map(|value| value.bytes()).transpose()
    }

    /// A text.
    pub(super) fn text(&self, field: u64) -> Result<Option<String>> {
        self.all(field)?.last().map(|value| value.text()).transpose()
    }

    /// A whole number.
    pub(super) fn number(&self, field: u64) -> Result<Option<u64>> {
        match self.all(field)?.last() {
            None => Ok(None),
            Some(Value::Number(number)) => Ok(Some(*number)),
            Some(Value::Bytes(_)) => bail!("field {field} is no number"),
        }
    }

    /// A list of whole numbers, one by one or packed.
    pub(super) fn numbers(&self, field: u64) -> Result<Vec<u64>> {
        let mut list = Vec::new();
        for value in self.all(field)? {
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

    /// A message within.
    pub(super) fn message(&self, field: u64) -> Result<Option<Self>> {
        self.bytes(field)?.map(Self::new).transpose()
    }

    /// A list of messages.
    pub(super) fn messages(&self, field: u64) -> Result<Vec<Self>> {
        self.all(field)?.into_iter().map(|value| Self::new(value.bytes()?)).collect()
    }
}

impl<'a> Value<'a> {
    fn bytes(self) -> Result<&'a [u8]> {
        match self {
            Self::Bytes(bytes) => Ok(bytes),
            Self::Number(_) => bail!("a number in the place of bytes"),
        }
    }

    /// As a text.
    pub(super) fn text(self) -> Result<String> {
        Ok(std::str::from_utf8(self.bytes()?)?.to_owned())
    }
}

/// Seven bits a byte, the lowest first.
fn number(bytes: &mut &[u8]) -> Result<u64> {
    let mut value = 0;
    for shift in (0..64).step_by(7) {
        let (&byte, rest) = bytes.split_first().context("the file ends in a number")?;
        *bytes = rest;
        value |= u64::from(byte & 0x7f) << shift;
        if byte < 0x80 {
            return Ok(value);
        }
    }
    bail!("a number of more than ten bytes")
}

fn take<'a>(bytes: &mut &'a [u8], count: usize) -> Result<&'a [u8]> {
    let (taken, rest) = bytes.split_at_checked(count).context("the file ends in a field")?;
    *bytes = rest;
    Ok(taken)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_read_as_the_format_has_them() {
        // 1: 300, 2: "ab", 3: packed 1 and 300.
        let bytes = [0x08, 0xac, 0x02, 0x12, 2, b'a', b'b', 0x1a, 3, 1, 0xac, 0x02];
        let message = Message::new(&bytes).unwrap();
        assert_eq!(message.number(1).unwrap(), Some(300));
        assert_eq!(message.text(2).unwrap().as_deref(), Some("ab"));
        assert_eq!(message.numbers(3).unwrap(), [1, 300]);
        assert_eq!(message.number(4).unwrap(), None);
    }

    #[test]
    fn what_is_cut_off_is_refused() {
        for bytes in [&[0x08][..], &[0x12, 5, 1], &[0x0b], &[0xff; 12]] {
            assert!(Message::new(bytes).is_err(), "{bytes:?}");
        }
    }
}
