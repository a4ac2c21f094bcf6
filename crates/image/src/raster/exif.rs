//! Reads orientation and capture time from the EXIF record of a photo.
//!
//! This is a separate reader, because the record is a small TIFF file. A full EXIF crate is larger in wasm
//! than all other code here. Wrong records are as good as none: no photo fails for them. Source: CIPA DC-008
//! (Exif 2.32), TIFF 6.0.

#[cfg(feature = "rare")]
use super::limits::MOST_PROFILE;

const ORIENTATION: u16 = 0x0112;
#[cfg(feature = "rare")]
pub(super) const ICC_PROFILE: u16 = 0x8773;
const EXIF_DIRECTORY: u16 = 0x8769;
const DATE_TIME: u16 = 0x0132;
/// When the photo was taken and when it was digitised, each with the tag of the fraction of the second.
const DATES: [(u16, u16); 2] = [(0x9003, 0x9291), (0x9004, 0x9292)];
/// The fraction of the second of [`DATE_TIME`].
const SUB_SECOND: u16 = 0x9290;
/// Digits of a fraction that are read.
const MOST_DIGITS: usize = 9;

/// Types of fields: whole numbers of one, two and four bytes, fractions of two of them, and signed numbers.
const BYTE: u16 = 1;
#[cfg(feature = "rare")]
pub(super) const SHORT: u16 = 3;
pub(super) const LONG: u16 = 4;
const FRACTION: u16 = 5;
const SBYTE: u16 = 6;
const SLONG: u16 = 9;

/// Values of the EXIF record.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Exif {
    /// 1..=8; 1 is upright.
    pub(super) orientation: u8,
    /// `YYYY:MM:DD HH:MM:SS`, with a fraction of the second if there is one: `2019:07:14 18:03:59.25`.
    pub(super) taken: Option<String>,
}

impl Default for Exif {
    fn default() -> Self {
        Self { orientation: 1, taken: None }
    }
}

/// Reads a record: a TIFF file, or one behind the mark that it has in JPEG.
pub(super) fn read(record: &[u8]) -> Exif {
    parse(without_mark(record)).unwrap_or_default()
}

/// The record without the mark that it has in JPEG.
pub(super) fn without_mark(record: &[u8]) -> &[u8] {
    record.strip_prefix(b"Exif\0\0").unwrap_or(record)
}

#[cfg(feature = "rare")]
/// Returns the ICC profile of a TIFF file, or `None` if it is too large.
pub(super) fn profile(file: &[u8]) -> Option<Vec<u8>> {
    let tiff = Tiff::of(file)?;
    let bytes = tiff.bytes(tiff.find(tiff.directory()?, ICC_PROFILE)?)?;
    (bytes.len() <= MOST_PROFILE).then(|| bytes.to_vec())
}

fn parse(record: &[u8]) -> Option<Exif> {
    let tiff = Tiff::of(record)?;
    let main = tiff.directory()?;
    let orientation = tiff.find(main, ORIENTATION).and_then(|field| tiff.integer(field));
    let directory = tiff.find(main, EXIF_DIRECTORY).and_then(|field| tiff.u32(field + 8));
    let text = |tag| directory.and_then(|directory| tiff.find(directory, tag));
    let exact = |date: u32, fraction: u16| {
        let date = tiff.date(date)?;
        let digits = text(fraction).and_then(|field| tiff.digits(field)).unwrap_or_default();
        Some(if digits.is_empty() { date } else { format!("{date}.{digits}") })
    };
    let taken = DATES.iter().find_map(|&(date, fraction)| exact(text(date)?, fraction));
    // Some cameras and programs write only the date of the file.
    let taken = taken.or_else(|| exact(tiff.find(main, DATE_TIME)?, SUB_SECOND));
    let orientation = orientation.filter(|value| (1..=8).contains(value)).unwrap_or(1) as u8;
    Some(Exif { orientation, taken })
}

/// A TIFF file and its byte order.
pub(super) struct Tiff<'a> {
    record: &'a [u8],
    little: bool,
}

impl<'a> Tiff<'a> {
    pub(super) fn of(record: &'a [u8]) -> Option<Self> {
        match record.get(..4)? {
            b"II*\0" => Some(Self { record, little: true }),
            b"MM\0*" => Some(Self { record, little: false }),
            _ => None,
        }
    }

    #[cfg(feature = "rare")]
    /// A field of one whole number of two bytes, or of four where it is larger.
    pub(super) fn field(&self, tag: u16, value: u32) -> [u8; 12] {
        let short = |value: u16| if self.little { value.to_le_bytes() } else { value.to_be_bytes() };
        let long = |value: u32| if self.little { value.to_le_bytes() } else { value.to_be_bytes() };
        let mut field = [0; 12];
        field[..2].copy_from_slice(&short(tag));
        field[4..8].copy_from_slice(&long(1));
        if let Ok(value) = u16::try_from(value) {
            field[2..4].copy_from_slice(&short(SHORT));
            field[8..10].copy_from_slice(&short(value));
        } else {
            field[2..4].copy_from_slice(&short(LONG));
            field[8..].copy_from_slice(&long(value));
        }
        field
    }

    /// Position of the first directory.
    pub(super) fn directory(&self) -> Option<u32> {
        self.u32(4)
    }

    /// Position of the directory after the one at `directory`, whose fields it follows.
    pub(super) fn next_directory(&self, directory: u32) -> Option<u32> {
        let fields = u32::from(self.u16(directory)?);
        self.u32(directory.checked_add(2 + 12 * fields)?).filter(|&next| next > 0)
    }

    pub(super) fn u16(&self, at: u32) -> Option<u16> {
        let bytes = *self.record.get(at as usize..)?.first_chunk()?;
        Some(if self.little { u16::from_le_bytes(bytes) } else { u16::from_be_bytes(bytes) })
    }

    pub(super) fn u32(&self, at: u32) -> Option<u32> {
        let bytes = *self.record.get(at as usize..)?.first_chunk()?;
        Some(if self.little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) })
    }

    /// Positions of the fields of a directory: tag, type, count and value, 2 + 2 + 4 + 4 bytes.
    pub(super) fn fields(&self, directory: u32) -> impl Iterator<Item = u32> {
        let fields = u32::from(self.u16(directory).unwrap_or(0));
        let first = directory.saturating_add(2);
        (0..fields)
            .filter_map(move |i| first.checked_add(12 * i))
            .take_while(|&field| field as usize + 12 <= self.record.len())
    }

    /// Position of the first field of a tag.
    pub(super) fn find(&self, directory: u32, tag: u16) -> Option<u32> {
        self.fields(directory).find(|&field| self.u16(field) == Some(tag))
    }

    /// The first whole number of a field. An unknown type counts as two bytes.
    fn integer(&self, field: u32) -> Option<u32> {
        match self.u16(field + 2)? {
            BYTE | SBYTE => self.record.get(field as usize + 8).map(|&byte| byte.into()),
            LONG | SLONG => self.u32(field + 8),
            _ => self.u16(field + 8).map(u32::from),
        }
    }

    #[cfg(feature = "rare")]
    /// The one whole number of a field.
    pub(super) fn number(&self, field: u32) -> Option<u32> {
        match (self.u16(field + 2)?, self.u32(field + 4)?) {
            (SHORT | LONG, 1) => self.integer(field),
            _ => None,
        }
    }

    #[cfg(feature = "rare")]
    /// The bytes that a field says to be elsewhere in the file.
    pub(super) fn bytes(&self, field: u32) -> Option<&'a [u8]> {
        let length = self.u32(field + 4)? as usize;
        self.record.get(self.u32(field + 8)? as usize..)?.get(..length)
    }

    /// The first byte of a short text.
    pub(super) fn byte(&self, field: u32) -> Option<u8> {
        self.record.get(field as usize + 8).copied()
    }

    /// The angle of a field of three fractions, in degrees: degrees, minutes and seconds.
    pub(super) fn angle(&self, field: u32) -> Option<f64> {
        if (self.u16(field + 2)?, self.u32(field + 4)?) != (FRACTION, 3) {
            return None;
        }
        let at = self.u32(field + 8)?;
        let part = |i: u32| {
            let at = at.checked_add(8 * i)?;
            let (part, whole) = (self.u32(at)?, self.u32(at.checked_add(4)?)?);
            (whole > 0).then(|| f64::from(part) / f64::from(whole))
        };
        Some(part(0)? + part(1)? / 60.0 + part(2)? / 3600.0)
    }

    /// The digits of the fraction of a second, without zeros at their end. Up to four bytes are in the field itself.
    fn digits(&self, field: u32) -> Option<String> {
        let length = self.u32(field + 4)? as usize;
        let at = if length <= 4 { field + 8 } else { self.u32(field + 8)? } as usize;
        let text = self.record.get(at..)?.get(..length.min(MOST_DIGITS))?;
        let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let digits = std::str::from_utf8(&text[..digits]).ok()?;
        Some(digits.trim_end_matches('0').to_owned())
    }

    /// The text of a date field, if it is valid.
    fn date(&self, field: u32) -> Option<String> {
        let at = self.u32(field + 8)? as usize;
        let text = self.record.get(at..at.checked_add(19)?)?;
        let is_date = text.iter().zip(b"0000:00:00 00:00:00").all(|(c, pattern)| match pattern {
            b'0' => c.is_ascii_digit(),
            _ => c == pattern,
        });
        // A camera whose clock was never set writes zeros.
        if !is_date || text.starts_with(b"0000") {
            return None;
        }
        String::from_utf8(text.to_vec()).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A record with an orientation and a date, as a camera writes it.
    fn record(little: bool, orientation: u16, date: &[u8; 19]) -> Vec<u8> {
        let u16 = |v: u16| if little { v.to_le_bytes() } else { v.to_be_bytes() };
        let u32 = |v: u32| if little { v.to_le_bytes() } else { v.to_be_bytes() };
        let mut out = if little { b"II*\0".to_vec() } else { b"MM\0*".to_vec() };
        out.extend(u32(8));
        out.extend([u16(2), u16(ORIENTATION), u16(3)].concat());
        out.extend([u32(1).to_vec(), u16(orientation).to_vec(), vec![0; 2]].concat());
        out.extend([u16(EXIF_DIRECTORY), u16(4)].concat());
        out.extend([u32(1), u32(38), u32(0)].concat());
        out.extend([u16(1), u16(DATES[0].0), u16(2)].concat());
        out.extend([u32(20), u32(56), u32(0)].concat());
        out.extend(date);
        out.push(0);
        out
    }

    #[test]
    fn both_byte_orders_are_read() {
        for little in [false, true] {
            let bytes = record(little, 6, b"2019:07:14 18:03:59");
            let expected = Exif { orientation: 6, taken: Some("2019:07:14 18:03:59".into()) };
            assert_eq!(read(&bytes), expected);
            assert_eq!(read(&[b"Exif\0\0", bytes.as_slice()].concat()), expected);
        }
    }

    #[test]
    fn nonsense_is_as_good_as_nothing() {
        assert_eq!(read(b""), Exif::default());
        assert_eq!(read(&record(true, 9, b"0000:00:00 00:00:00")), Exif::default());
        assert_eq!(read(&record(false, 0, b"yesterday, at noon.")), Exif::default());
    }

    proptest! {
        #[test]
        fn damaged_records_never_panic(at in 0usize..76, value: u8, length in 0usize..77) {
            let mut bytes = record(at % 2 == 0, 3, b"2020:01:01 00:00:00");
            bytes[at] = value;
            let exif = read(&bytes[..length.min(bytes.len())]);
            prop_assert!((1..=8).contains(&exif.orientation));
        }
    }
}
