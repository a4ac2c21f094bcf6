//! Reads flatbuffers: tables whose fields are found through a table of offsets. Everything is checked, as the bytes
//! are a stranger's.

use anyhow::{Context, Result};

/// A table in the file.
#[derive(Clone, Copy)]
pub(super) struct Table<'a> {
    file: &'a [u8],
    at: usize,
}

impl<'a> Table<'a> {
    /// The outermost table.
    pub(super) fn root(file: &'a [u8]) -> Result<Self> {
        Ok(Self { file, at: number(file, 0, 4)? as usize })
    }

    /// A number of `size` bytes, sign-extended; `default` where the file leaves it out.
    pub(super) fn integer(&self, field: usize, size: usize, default: i64) -> Result<i64> {
        let Some(at) = self.field(field)? else { return Ok(default) };
        let unused = 64 - 8 * size as u32;
        Ok((number(self.file, at, size)? << unused) as i64 >> unused)
    }

    /// Returns a table, or `None` if the file omits it.
    pub(super) fn table(&self, field: usize) -> Result<Option<Self>> {
        let Some(at) = self.field(field)? else { return Ok(None) };
        Ok(Some(Self { file: self.file, at: self.follow(at)? }))
    }

    /// A list of tables.
    pub(super) fn tables(&self, field: usize) -> Result<Vec<Self>> {
        let Some((start, count)) = self.list(field, 4)? else { return Ok(Vec::new()) };
        (0..count).map(|i| Ok(Self { file: self.file, at: self.follow(start + 4 * i)? })).collect()
    }

    /// A list of 32-bit numbers.
    pub(super) fn integers(&self, field: usize) -> Result<Vec<i32>> {
        let Some((start, count)) = self.list(field, 4)? else { return Ok(Vec::new()) };
        (0..count).map(|i| Ok(number(self.file, start + 4 * i, 4)? as i32)).collect()
    }

    /// A list of bytes, or a text's bytes.
    pub(super) fn bytes(&self, field: usize) -> Result<&'a [u8]> {
        let Some((start, count)) = self.list(field, 1)? else { return Ok(&[]) };
        self.file.get(start..start + count).context("a list goes beyond the file's end")
    }

    /// Returns the position of a list's first entry and the number of entries.
    fn list(&self, field: usize, size: usize) -> Result<Option<(usize, usize)>> {
        let Some(at) = self.field(field)? else { return Ok(None) };
        let at = self.follow(at)?;
        let count = number(self.file, at, 4)? as usize;
        let start = at + 4;
        self.file.get(start..start + count * size).context("a list goes beyond the file's end")?;
        Ok(Some((start, count)))
    }

    fn follow(&self, at: usize) -> Result<usize> {
        Ok(at + number(self.file, at, 4)? as usize)
    }

    /// Returns the position of a field's value, or `None` if the file omits it.
    fn field(&self, field: usize) -> Result<Option<usize>> {
        let back = number(self.file, self.at, 4)? as i32;
        let offsets =
            usize::try_from(self.at as i64 - i64::from(back)).context("an offset before the file")?;
        let entry = 4 + 2 * field;
        if entry >= number(self.file, offsets, 2)? as usize {
            return Ok(None);
        }
        let offset = number(self.file, offsets + entry, 2)? as usize;
        Ok((offset > 0).then_some(self.at + offset))
    }
}

/// A little-endian number of up to 8 bytes.
fn number(file: &[u8], at: usize, size: usize) -> Result<u64> {
    let bytes = file.get(at..at + size).context("an offset beyond the file's end")?;
    Ok(bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A root table with the fields: 0 a byte of -2, 1 absent, 2 the list [7, 8].
    fn file() -> Vec<u8> {
        let mut file = vec![16, 0, 0, 0];
        file.extend([0, 0]);
        file.extend([10, 0, 9, 0, 4, 0, 0, 0, 5, 0]);
        // The table at 16: 10 bytes back to its offsets at 6; then the byte and the list's offset.
        file.extend([10, 0, 0, 0, 0xfe, 7, 0, 0, 0, 0]);
        file[10] = 4;
        file[14] = 5;
        file.extend([0, 0]);
        file.extend([2, 0, 0, 0, 7, 0, 0, 0, 8, 0, 0, 0]);
        file
    }

    #[test]
    fn fields_are_found_and_absent_ones_have_their_default() {
        let file = file();
        let table = Table::root(&file).unwrap();
        assert_eq!(table.integer(0, 1, 5).unwrap(), -2);
        assert_eq!(table.integer(1, 4, 5).unwrap(), 5);
        assert_eq!(table.integers(2).unwrap(), [7, 8]);
        assert_eq!(table.integer(9, 4, 6).unwrap(), 6);
    }

    #[test]
    fn a_file_that_is_cut_short_is_an_error() {
        let file = file();
        let cut = &file[..file.len() - 1];
        assert!(Table::root(cut).unwrap().integers(2).is_err());
        assert!(Table::root(&file[..3]).is_err());
    }
}
