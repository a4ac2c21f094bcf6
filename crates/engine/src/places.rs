//! Names of places by location, from a table of `GeoNames`. No request leaves the device.
//!
//! `cargo xtask models` makes the table (`tools/models/src/places.rs`). It is compressed with zlib and contains:
//!
//! 1. `MARK`, and the number of places, four bytes (big-endian, like all numbers).
//! 2. The latitudes, then the longitudes: steps of 1/65535 of 180 or 360 degrees from -90 or -180. Each is the
//!    difference to the previous place, modulo 65536. The high bytes of all places come before the low bytes.
//! 3. One byte per place: eight times the binary logarithm of its population.
//! 4. The names, each followed by a line feed.

use crate::error::{Error, Result};
use crate::raster::location::Location;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

/// The beginning of a table.
const MARK: &[u8] = b"inkpanel places 1\n";
/// Maximum size of an unpacked table, and number of places.
const MOST_BYTES: usize = 16 << 20;
const MOST_PLACES: usize = 1 << 18;
/// Kilometres of a degree of latitude.
const DEGREE: f64 = 111.2;
/// The radius of a place with one inhabitant, in kilometres. It grows with the square root of the population.
const RADIUS: f64 = 0.02;
/// Maximum distance from the edge of a place at which a photo is still from there, in kilometres.
const AROUND: f64 = 8.0;

/// A table of places.
#[derive(Debug)]
pub struct Places {
    /// Steps of latitude and longitude.
    at: Vec<[u16; 2]>,
    sizes: Vec<u8>,
    names: String,
}

impl Places {
    /// Reads a compressed table.
    ///
    /// # Errors
    /// `damaged` if it is not a complete table.
    pub fn read(packed: &[u8]) -> Result<Self> {
        let table = decompress_to_vec_zlib_with_limit(packed, MOST_BYTES);
        Self::parse(&table.map_err(|error| damaged(&error.to_string()))?)
    }

    /// Reads a table that is not compressed.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn parse(table: &[u8]) -> Result<Self> {
        Self::parsed(table).ok_or_else(|| damaged("it is not a complete table of places"))
    }

    fn parsed(table: &[u8]) -> Option<Self> {
        let (count, rest) = table.strip_prefix(MARK)?.split_first_chunk::<4>()?;
        let count = u32::from_be_bytes(*count) as usize;
        let (columns, names) = rest.split_at_checked(5 * count.min(MOST_PLACES + 1))?;
        let column = |of: usize| columns.get(of * count..(of + 1) * count);
        let steps = |high: &[u8], low: &[u8]| {
            let step = |last: &mut u16, (&high, &low): (&u8, &u8)| {
                *last = last.wrapping_add(u16::from_be_bytes([high, low]));
                Some(*last)
            };
            high.iter().zip(low).scan(0, step).collect::<Vec<u16>>()
        };
        let (down, across) = (steps(column(0)?, column(1)?), steps(column(2)?, column(3)?));
        let names = String::from_utf8(names.to_vec()).ok().filter(|names| names.lines().count() == count)?;
        let at = down.into_iter().zip(across).map(|(down, across)| [down, across]).collect();
        (count <= MOST_PLACES).then_some(Self { at, sizes: column(4)?.to_vec(), names })
    }

    /// Number of places.
    #[must_use]
    pub fn len(&self) -> usize {
        self.at.len()
    }

    /// Whether the table has no places.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The name of the place at a location. `None` far from all places.
    ///
    /// Large places have a larger radius than small ones. The place wins whose distance is the smallest part of its radius.
    #[must_use]
    pub fn name(&self, location: Location) -> Option<&str> {
        let Location { latitude, longitude } = location;
        let shrink = latitude.to_radians().cos();
        let mut best: Option<(f64, usize)> = None;
        for (i, (&[down, across], &size)) in self.at.iter().zip(&self.sizes).enumerate() {
            let north = (degrees(down, 180.0) - latitude) * DEGREE;
            if north.abs() > 100.0 {
                continue;
            }
            // The shorter way round the earth.
            let east = (degrees(across, 360.0) - longitude + 540.0).rem_euclid(360.0) - 180.0;
            let far = north.hypot(east * DEGREE * shrink);
            let radius = RADIUS * (f64::from(size) / 16.0).exp2();
            if far <= radius + AROUND && best.is_none_or(|(least, _)| far / radius < least) {
                best = Some((far / radius, i));
            }
        }
        self.names.lines().nth(best?.1)
    }

    /// The name of the place where a photo was taken, from the GPS fields of its file. `None` without these fields, or if the
    /// place is unknown.
    #[must_use]
    pub fn of_photo(&self, file: &[u8]) -> Option<&str> {
        self.name(crate::raster::location::location(file)?)
    }
}

fn degrees(step: u16, whole: f64) -> f64 {
    f64::from(step) / 65535.0 * whole - whole / 2.0
}

fn damaged(reason: &str) -> Error {
    Error::Damaged { format: "places", reason: reason.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::deflate::compress_to_vec_zlib;
    use proptest::prelude::*;

    const PLACES: [(&str, f64, f64, u32); 5] = [
        ("Sintra", 38.800_97, -9.378_26, 26_193),
        ("Lisbon", 38.716_67, -9.133_33, 517_802),
        ("Algés", 38.702_45, -9.229_36, 22_273),
        ("Waiyevo", -16.790_3, -179.990_3, 1_000),
        ("Sydney", -33.867_85, 151.207_32, 4_627_345),
    ];

    fn table() -> Vec<u8> {
        let step = |at: f64, whole: f64| ((at + whole / 2.0) / whole * 65535.0).round() as u16;
        let columns = [
            PLACES.map(|(_, latitude, ..)| step(latitude, 180.0)),
            PLACES.map(|(_, _, longitude, _)| step(longitude, 360.0)),
        ];
        let mut out = [MARK, &(PLACES.len() as u32).to_be_bytes()].concat();
        for column in columns {
            let steps = column.iter().scan(0, |last, &step| {
                let by = step.wrapping_sub(*last);
                *last = step;
                Some(by.to_be_bytes())
            });
            let steps: Vec<[u8; 2]> = steps.collect();
            out.extend(steps.iter().map(|step| step[0]));
            out.extend(steps.iter().map(|step| step[1]));
        }
        out.extend(PLACES.map(|(.., people)| (8.0 * f64::from(people).log2()).round() as u8));
        out.extend(PLACES.iter().flat_map(|(name, ..)| format!("{name}\n").into_bytes()));
        out
    }

    #[test]
    fn the_place_is_the_one_that_reaches_the_location() {
        let places = Places::read(&compress_to_vec_zlib(&table(), 6)).unwrap();
        assert_eq!(places.len(), PLACES.len());
        let name = |latitude, longitude| places.name(Location { latitude, longitude });
        assert_eq!(name(38.787_6, -9.390_6), Some("Sintra"), "the Pena Palace is outside of the town");
        // The tower of Belém is closer to Algés than to the centre of Lisbon.
        assert_eq!(name(38.691_6, -9.216), Some("Lisbon"));
        assert_eq!(name(38.702, -9.23), Some("Algés"));
        assert_eq!(name(-16.79, 179.995), Some("Waiyevo"), "the antimeridian is no border");
        assert_eq!(name(-33.89, 151.27), Some("Sydney"));
        assert_eq!(name(38.78, -9.8), None, "at sea");
    }

    #[test]
    fn an_incomplete_table_is_refused() {
        let table = table();
        for length in [0, 5, MARK.len() + 3, MARK.len() + 10, table.len() - 9] {
            assert_eq!(Places::parse(&table[..length]).unwrap_err().code(), "damaged", "{length}");
        }
        assert_eq!(Places::read(b"no table").unwrap_err().code(), "damaged");
    }

    proptest! {
        #[test]
        fn damaged_tables_never_panic(at in 0usize..80, value: u8, latitude in -90.0f64..90.0, longitude in -180.0f64..180.0) {
            let mut table = table();
            table[at] = value;
            if let Ok(places) = Places::parse(&table) {
                let _ = places.name(Location { latitude, longitude });
            }
        }
    }
}
