//! The table of places, from the tab-separated file `cities500` of `GeoNames` (CC BY 4.0, <https://www.geonames.org>).
//! `crates/engine/src/places.rs` of the crate defines its format.

use std::io::Write;

use anyhow::{Context, Result, ensure};
use flate2::{Compression, write::ZlibEncoder};

const MARK: &[u8] = b"inkpanel places 1\n";
/// Places with fewer inhabitants are left out, except seats of government.
const LEAST: u32 = 1000;
/// Codes of `GeoNames`: places, and places that are seats. Sections of cities, and former, destroyed and historical places
/// are left out.
const KINDS: [&str; 4] = ["PPL", "PPLL", "PPLS", "STLMT"];
const SEATS: [&str; 5] = ["PPLC", "PPLG", "PPLA", "PPLA2", "PPLA3"];
const OTHER_SEATS: [&str; 2] = ["PPLA4", "PPLA5"];
/// Columns of the file.
const NAME: usize = 1;
const LATITUDE: usize = 4;
const LONGITUDE: usize = 5;
const KIND: usize = 7;
const POPULATION: usize = 14;
/// Height of a band in which places are sorted by longitude, in degrees. Sorted places take less space.
const BAND: f64 = 0.5;

struct Place<'a> {
    name: &'a str,
    latitude: f64,
    longitude: f64,
    people: u32,
}

/// Converts the file to the compressed table.
///
/// # Errors
/// If a line is not a place of `GeoNames`.
pub(crate) fn convert(file: &str) -> Result<Vec<u8>> {
    let mut places = Vec::new();
    for (number, line) in file.lines().enumerate().filter(|(_, line)| !line.is_empty()) {
        places.extend(place(line).with_context(|| format!("line {}", number + 1))?);
    }
    places.sort_by(|a, b| {
        let band = |place: &Place| (place.latitude / BAND).floor();
        band(a).total_cmp(&band(b)).then(a.longitude.total_cmp(&b.longitude)).then(a.name.cmp(b.name))
    });
    let mut table = MARK.to_vec();
    table.extend(u32::try_from(places.len())?.to_be_bytes());
    table.extend(column(places.iter().map(|place| (place.latitude + 90.0) / 180.0)));
    table.extend(column(places.iter().map(|place| (place.longitude + 180.0) / 360.0)));
    table.extend(places.iter().map(|place| (8.0 * f64::from(place.people.max(1)).log2()).round() as u8));
    for place in &places {
        table.extend(place.name.bytes());
        table.push(b'\n');
    }
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&table)?;
    Ok(encoder.finish()?)
}

/// The place of a line, if it is in the table.
fn place(line: &str) -> Result<Option<Place<'_>>> {
    let fields: Vec<&str> = line.split('\t').collect();
    ensure!(fields.len() > POPULATION, "the line has too few columns");
    let people: u32 = fields[POPULATION].parse().context("the population")?;
    let kind = fields[KIND];
    let large = people >= LEAST && (KINDS.contains(&kind) || OTHER_SEATS.contains(&kind));
    if !large && !SEATS.contains(&kind) {
        return Ok(None);
    }
    let (latitude, longitude) = (fields[LATITUDE].parse()?, fields[LONGITUDE].parse()?);
    Ok(Some(Place { name: fields[NAME], latitude, longitude, people }))
}

/// A column of 16-bit steps as differences, the high bytes before the low bytes.
fn column(parts: impl Iterator<Item = f64>) -> Vec<u8> {
    let mut last = 0;
    let steps: Vec<[u8; 2]> = parts
        .map(|part| {
            let step = (part * 65535.0).round() as u16;
            let by = step.wrapping_sub(last);
            last = step;
            by.to_be_bytes()
        })
        .collect();
    steps.iter().map(|step| step[0]).chain(steps.iter().map(|step| step[1])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(name: &str, latitude: f64, kind: &str, people: u32) -> String {
        format!(
            "1\t{name}\t{name}\t\t{latitude}\t9.5\tP\t{kind}\tIT\t\t\t\t\t\t{people}\t\t1\tEurope/Rome\t2024-01-01"
        )
    }

    fn names(lines: &[String]) -> Vec<String> {
        let packed = convert(&lines.join("\n")).unwrap();
        let mut table = Vec::new();
        std::io::Read::read_to_end(&mut flate2::read::ZlibDecoder::new(packed.as_slice()), &mut table)
            .unwrap();
        let count = u32::from_be_bytes(table[MARK.len()..][..4].try_into().unwrap()) as usize;
        let names = String::from_utf8(table[MARK.len() + 4 + 5 * count..].to_vec()).unwrap();
        assert_eq!(names.lines().count(), count);
        names.lines().map(str::to_owned).collect()
    }

    #[test]
    fn small_places_are_left_out_except_seats() {
        let lines = [
            line("North", 45.9, "PPL", 2000),
            line("Hamlet", 44.1, "PPL", 900),
            line("Vernazza", 44.1, "PPLA3", 506),
            line("Quarter", 44.2, "PPLX", 50_000),
        ];
        assert_eq!(names(&lines), ["Vernazza", "North"]);
    }

    #[test]
    fn a_wrong_line_is_an_error() {
        assert!(format!("{:#}", convert("1\tName").unwrap_err()).contains("line 1"));
    }
}
