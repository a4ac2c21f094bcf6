//! Colour profiles: conversion of photos from wide-gamut cameras, scanners and presses to sRGB.
//!
//! Profiles of a matrix and three curves (Display P3, Adobe RGB), or of one curve, are read here: within a
//! rounding of the exact colour, and the same on every machine. LUT-based profiles (scanners, presses, inks)
//! are read by `qcms`, the colour management of Firefox. (`moxcms`, which `image` uses, does both. It would
//! add 76 kB to the download, `qcms` a third of that, and both are within 1 of 255 of littlecms on average.)
//!
//! A damaged profile, or one of another device class, is ignored: the samples are used unchanged. Colours are
//! matched relative to the paper (ICC.1:2022, section 6.2.3). Source: ICC.1:2022, sections 7 to 10; sRGB from
//! IEC 61966-2-1, its matrix adapted to D50 like the matrices of profiles.

#[cfg(feature = "rare")]
use qcms::{DataType, Intent, Profile, Transform};

use super::channels::Channels;
use super::{Image, Plane};
#[cfg(not(feature = "rare"))]
use crate::error::Error;
use crate::error::Result;

/// From XYZ under D50 to linear sRGB.
const SRGB_OF_XYZ: [[f32; 3]; 3] = [
    [3.133_856, -1.616_867, -0.490_615],
    [-0.978_768, 1.916_142, 0.033_454],
    [0.071_945, -0.228_991, 1.405_243],
];
const D50: [f32; 3] = [0.9642, 1.0, 0.8249];
/// Maximum distance of a profile's white from D50. Beyond it the profile is invalid.
const WHITE_TOLERANCE: f32 = 0.05;
/// Entries of the table from linear light to sRGB: fine enough for the steep beginning.
const ENTRIES: usize = 8192;
/// Pixels that go through a table at a time.
#[cfg(feature = "rare")]
const PIXELS: usize = 4096;
/// Minimum value of white in each channel of a table. Profiles below it are not for images.
#[cfg(feature = "rare")]
const DARKEST_WHITE: u8 = 200;

/// From the samples of a photo to sRGB.
pub(super) enum Correction {
    /// One sample to one.
    Grey(Box<[u8; 256]>),
    /// Three to three.
    Color(Box<Color>),
    /// Three or four to three, by tables.
    #[cfg(feature = "rare")]
    Tables(Box<Transform>),
}

/// Curves to linear light, a matrix, and the curve of sRGB.
pub(super) struct Color {
    curves: [[f32; 256]; 3],
    /// To linear sRGB, as positions in `encoded`.
    matrix: [[f32; 3]; 3],
    encoded: Vec<u8>,
}

/// Returns the correction for an image with these channels. `None` if the profile is sRGB within rounding, is
/// for other channels, or is invalid.
///
/// # Errors
/// `rare-colours` for a LUT-based profile in a build without the `rare` feature.
pub(super) fn correction(profile: &[u8], channels: Channels) -> Result<Option<Correction>> {
    match wanted(profile, channels) {
        Some(Wanted::Tables) => tables(profile, channels),
        Some(Wanted::Curves) => Ok(by_curves(profile, channels)),
        None => Ok(None),
    }
}

/// Kind of a profile.
enum Wanted {
    Curves,
    Tables,
}

fn wanted(profile: &[u8], channels: Channels) -> Option<Wanted> {
    let space = match channels {
        Channels::Grey => b"GRAY",
        Channels::Rgb => b"RGB ",
        Channels::Cmyk => b"CMYK",
    };
    // Scanners, screens, presses, and spaces of none of them; the others turn colours into names or into each other.
    let of_pictures = matches!(profile.get(12..16)?, b"scnr" | b"mntr" | b"prtr" | b"spac");
    if !of_pictures || profile.get(16..20)? != space || profile.get(36..40)? != b"acsp" {
        return None;
    }
    let has_tables = [*b"A2B0", *b"A2B1", *b"A2B2"].into_iter().any(|name| tag(profile, name).is_some());
    let by_tables = channels == Channels::Cmyk || (channels == Channels::Rgb && has_tables);
    Some(if by_tables { Wanted::Tables } else { Wanted::Curves })
}

fn by_curves(profile: &[u8], channels: Channels) -> Option<Correction> {
    match channels {
        Channels::Grey => {
            let curve = curve(tag(profile, *b"kTRC").filter(|_| profile[20..24] == *b"XYZ ")?)?;
            let table = curve.map(encoded);
            let same = (0..=255u8).zip(table).all(|(value, new)| value.abs_diff(new) <= 1);
            (!same).then(|| Correction::Grey(Box::new(table)))
        }
        Channels::Rgb => {
            let color = Color::read(profile).filter(|_| profile[20..24] == *b"XYZ ")?;
            (!color.changes_nothing()).then(|| Correction::Color(Box::new(color)))
        }
        Channels::Cmyk => None,
    }
}

/// Correction by tables, or by the profile's curves if its tables cannot be read.
#[cfg(feature = "rare")]
#[expect(clippy::unnecessary_wraps, reason = "without tables, it always returns `None`")]
fn tables(profile: &[u8], channels: Channels) -> Result<Option<Correction>> {
    let tables = transform(profile, channels).map(Box::new).map(Correction::Tables);
    Ok(tables.or_else(|| by_curves(profile, channels)))
}

#[cfg(not(feature = "rare"))]
fn tables(_: &[u8], _: Channels) -> Result<Option<Correction>> {
    Err(Error::RareColours)
}

#[cfg(feature = "rare")]
fn transform(profile: &[u8], channels: Channels) -> Option<Transform> {
    let source = Profile::new_from_slice(profile, false)?;
    let mut srgb = Profile::new_sRGB();
    srgb.precache_output_transform();
    let (kind, white) = match channels {
        Channels::Cmyk => (DataType::CMYK, &[0; 4][..]),
        _ => (DataType::RGB8, &[255; 3][..]),
    };
    let transform = Transform::new_to(&source, &srgb, kind, DataType::RGB8, Intent::RelativeColorimetric)?;
    let mut seen = [0; 3];
    transform.convert(white, &mut seen);
    seen.iter().all(|&value| value >= DARKEST_WHITE).then_some(transform)
}

impl Correction {
    /// The picture in sRGB whose planes these are: as many as the channels that it was made for.
    pub(super) fn image(&self, mut planes: Vec<Plane>) -> Result<Image> {
        match self {
            Self::Grey(table) => {
                for value in planes.iter_mut().flat_map(Plane::samples_mut) {
                    *value = table[usize::from(*value)];
                }
            }
            Self::Color(color) => {
                if let [r, g, b] = &mut planes[..] {
                    let samples = r.samples_mut().iter_mut().zip(g.samples_mut()).zip(b.samples_mut());
                    for ((r, g), b) in samples {
                        [*r, *g, *b] = color.corrected([*r, *g, *b]);
                    }
                }
            }
            #[cfg(feature = "rare")]
            Self::Tables(transform) => {
                through_tables(transform, &mut planes);
                planes.truncate(3);
            }
        }
        Image::from_planes(planes)
    }
}

/// Transforms the first three planes, with the values of all planes as input.
#[cfg(feature = "rare")]
fn through_tables(transform: &Transform, planes: &mut [Plane]) {
    let count = planes.len();
    let (mut samples, mut rgb) = (vec![0; PIXELS * count], vec![0; PIXELS * 3]);
    let pixels = planes[0].samples().len();
    for start in (0..pixels).step_by(PIXELS) {
        let length = PIXELS.min(pixels - start);
        for (channel, plane) in planes.iter().enumerate() {
            let values = &plane.samples()[start..start + length];
            for (out, value) in samples[channel..].iter_mut().step_by(count).zip(values) {
                *out = *value;
            }
        }
        let to = &mut rgb[..length * 3];
        transform.convert(&samples[..length * count], to);
        for (channel, plane) in planes.iter_mut().take(3).enumerate() {
            let values = &mut plane.samples_mut()[start..start + length];
            for (value, new) in values.iter_mut().zip(to[channel..].iter().step_by(3)) {
                *value = *new;
            }
        }
    }
}

impl Color {
    fn read(profile: &[u8]) -> Option<Self> {
        let columns = [xyz(profile, *b"rXYZ")?, xyz(profile, *b"gXYZ")?, xyz(profile, *b"bXYZ")?];
        let white = |i: usize| columns[0][i] + columns[1][i] + columns[2][i];
        if !(0..3).all(|i| (white(i) - D50[i]).abs() < WHITE_TOLERANCE) {
            return None;
        }
        let scale = (ENTRIES - 1) as f32;
        let mut matrix = [[0.0; 3]; 3];
        for at in 0..27 {
            let (row, column, i) = (at / 9, at / 3 % 3, at % 3);
            matrix[row][column] += scale * SRGB_OF_XYZ[row][i] * columns[column][i];
        }
        let read = |name: [u8; 4]| curve(tag(profile, name)?);
        let curves = [read(*b"rTRC")?, read(*b"gTRC")?, read(*b"bTRC")?];
        let mut table = vec![0; ENTRIES];
        for (i, entry) in table.iter_mut().enumerate() {
            *entry = encoded(i as f32 / scale);
        }
        Some(Self { curves, matrix, encoded: table })
    }

    fn corrected(&self, rgb: [u8; 3]) -> [u8; 3] {
        let [r, g, b] = [0, 1, 2].map(|i| self.curves[i][usize::from(rgb[i])]);
        // The cast saturates at 0; values above white use the last entry.
        self.matrix.map(|row| {
            let light = row[0] * r + row[1] * g + row[2] * b + 0.5;
            self.encoded[(light as usize).min(ENTRIES - 1)]
        })
    }

    /// Looks at the corners of a grid of 6 x 6 x 6 colours.
    fn changes_nothing(&self) -> bool {
        (0..216u8).all(|i| {
            let rgb = [i / 36, i / 6 % 6, i % 6].map(|step| 51 * step);
            self.corrected(rgb).iter().zip(rgb).all(|(new, old)| new.abs_diff(old) <= 1)
        })
    }
}

/// Linear light of 0 to 1 in sRGB.
fn encoded(light: f32) -> u8 {
    let light = f64::from(light);
    let value = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * power(light, 1.0 / 2.4) - 0.055 };
    (255.0 * value + 0.5) as u8
}

/// The bytes of a tag.
fn tag(profile: &[u8], name: [u8; 4]) -> Option<&[u8]> {
    let count = u32_at(profile, 128)?.min(200) as usize;
    let entry = (0..count).map(|i| 132 + 12 * i).find(|&at| profile.get(at..at + 4) == Some(&name))?;
    let (offset, length) = (u32_at(profile, entry + 4)? as usize, u32_at(profile, entry + 8)? as usize);
    profile.get(offset..)?.get(..length)
}

fn xyz(profile: &[u8], name: [u8; 4]) -> Option<[f32; 3]> {
    let data = tag(profile, name)?.strip_prefix(b"XYZ ")?;
    Some([fixed(data, 4)?, fixed(data, 8)?, fixed(data, 12)?])
}

/// A curve as linear light of 0 to 1 for each of the 256 samples.
fn curve(data: &[u8]) -> Option<[f32; 256]> {
    let read = match data.get(..4)? {
        b"curv" => Curve::sampled(data)?,
        b"para" => Curve::parametric(data)?,
        _ => return None,
    };
    let mut table = [0.0; 256];
    for (i, light) in table.iter_mut().enumerate() {
        *light = read.at(i as f64 / 255.0) as f32;
        if !light.is_finite() {
            return None;
        }
        *light = light.clamp(0.0, 1.0);
    }
    Some(table)
}

/// A curve as a profile has it.
enum Curve<'a> {
    /// Numbers of 16 bits, read between.
    Table(&'a [[u8; 2]]),
    /// `(a x + b)^gamma + e` from `x = d` on, `c x + f` below: gamma, a, b, c, d, e, f.
    Formula([f64; 7]),
}

impl<'a> Curve<'a> {
    /// Nothing (linear), a gamma, or a table.
    fn sampled(data: &'a [u8]) -> Option<Self> {
        let count = u32_at(data, 8)? as usize;
        let entries = data.get(12..)?.as_chunks::<2>().0.get(..count)?;
        Some(match entries {
            [] => Self::Formula([1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
            [gamma] => {
                Self::Formula([f64::from(u16::from_be_bytes(*gamma)) / 256.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
            }
            _ => Self::Table(entries),
        })
    }

    /// The five formulas of section 10.18, in the form of the last. Missing parameters are 0.
    fn parametric(data: &'a [u8]) -> Option<Self> {
        let kind = u16::from_be_bytes(*data.get(8..)?.first_chunk()?);
        let mut values = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let given = *[1, 3, 4, 5, 7].get(usize::from(kind))?;
        for (i, value) in values[..given].iter_mut().enumerate() {
            *value = f64::from(fixed(data, 12 + 4 * i)?);
        }
        if matches!(kind, 1 | 2) {
            // Below the threshold of the power; the fourth parameter is added on both sides.
            let [_, a, b, c, d, e, f] = &mut values;
            (*e, *f) = (*c, *c);
            (*c, *d) = (0.0, -*b / *a);
        }
        Some(Self::Formula(values))
    }

    /// The light of a sample of 0 to 1.
    fn at(&self, x: f64) -> f64 {
        match *self {
            Self::Formula([gamma, a, b, c, d, e, f]) => {
                if x >= d {
                    power(a * x + b, gamma) + e
                } else {
                    c * x + f
                }
            }
            Self::Table(entries) => {
                let at = x * (entries.len() - 1) as f64;
                let i = (at as usize).min(entries.len() - 2);
                let [low, high] =
                    [entries[i], entries[i + 1]].map(|entry| f64::from(u16::from_be_bytes(entry)));
                (low + (high - low) * (at - i as f64)) / 65_535.0
            }
        }
    }
}

#[inline(never)]
fn power(base: f64, exponent: f64) -> f64 {
    base.powf(exponent)
}

/// A signed number with 16 bits behind the point.
fn fixed(data: &[u8], at: usize) -> Option<f32> {
    Some(u32_at(data, at)? as i32 as f32 / 65_536.0)
}

fn u32_at(data: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(*data.get(at..)?.first_chunk()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The profile in a JPEG file of the tests, if it has one part.
    fn embedded(file: &[u8]) -> Vec<u8> {
        let mark = b"ICC_PROFILE\0\x01\x01";
        let start = file.windows(mark.len()).position(|window| window == mark).unwrap() + mark.len();
        let length = u32::from_be_bytes(*file[start..].first_chunk().unwrap()) as usize;
        file[start..start + length].to_vec()
    }

    fn display_p3() -> Vec<u8> {
        embedded(include_bytes!("../../../../tests/oracles/data/files/jpeg-icc-p3.jpg"))
    }

    fn press() -> Vec<u8> {
        embedded(include_bytes!("../../../../tests/oracles/data/files/jpeg-icc-tables-press.jpg"))
    }

    fn corrected(profile: &[u8], samples: &[u8]) -> Option<[u8; 3]> {
        let channels = [Channels::Grey, Channels::Rgb, Channels::Cmyk][samples.len() / 2];
        let planes = samples.iter().map(|&value| Plane::filled(1, 1, value)).collect();
        correction(profile, channels).unwrap()?.image(planes).unwrap().to_rgb().try_into().ok()
    }

    #[test]
    fn greys_stay_and_colours_that_srgb_lacks_end_at_its_edge() {
        let profile = display_p3();
        for value in [0, 1, 40, 128, 254, 255] {
            for channel in corrected(&profile, &[value; 3]).unwrap() {
                assert!(channel.abs_diff(value) <= 1, "{value}: {channel}");
            }
        }
        assert_eq!(corrected(&profile, &[255, 0, 0]).unwrap()[0], 255);
        assert_eq!(corrected(&profile, &[0, 255, 0]).unwrap()[..2], [0, 255]);
    }

    #[test]
    fn no_ink_is_white_and_all_inks_are_dark() {
        let profile = press();
        assert!(corrected(&profile, &[0; 4]).unwrap().iter().all(|&value| value >= 253));
        assert!(corrected(&profile, &[255; 4]).unwrap().iter().all(|&value| value < 60));
        assert!(corrected(&profile, &[0; 3]).is_none(), "four inks are no three lights");
    }

    #[test]
    fn what_is_no_profile_of_light_is_ignored() {
        let mut black = display_p3();
        let column = black.windows(4).rposition(|window| window == b"XYZ ").unwrap();
        black[column + 8..column + 20].fill(0);
        assert!(correction(&black, Channels::Rgb).unwrap().is_none());
        let mut link = display_p3();
        link[12..16].copy_from_slice(b"link");
        assert!(correction(&link, Channels::Rgb).unwrap().is_none());
        assert!(correction(b"", Channels::Rgb).unwrap().is_none());
        assert!(correction(&display_p3()[..200], Channels::Rgb).unwrap().is_none());
        assert!(correction(&display_p3(), Channels::Grey).unwrap().is_none());
    }

    proptest! {
        #[test]
        fn damaged_profiles_never_panic(
            inks: bool,
            changes in prop::collection::vec((any::<usize>(), any::<u8>(), any::<bool>()), 1..8),
            length in 100usize..9000,
        ) {
            let mut profile = if inks { press() } else { display_p3() };
            for (at, value, early) in changes {
                // Half of them where the header and the list of tags are.
                let at = at % if early { 300.min(profile.len()) } else { profile.len() };
                profile[at] = value;
            }
            // Half are cut off, too.
            let length = if length % 2 == 0 { length.min(profile.len()) } else { profile.len() };
            let _ = corrected(&profile[..length], if inks { &[200, 10, 90, 4] } else { &[200, 10, 90] });
        }
    }
}
