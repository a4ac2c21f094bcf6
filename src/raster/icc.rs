//! Colour profiles: what a photo of a wide-gamut camera or screen looks like in sRGB.
//!
//! A reader of our own for the profiles that photos carry (Display P3, Adobe RGB, grey gammas): three
//! curves and a matrix, or one curve. Profiles of tables (printers, CMYK) and damaged ones are as good as none: the
//! samples are then taken as they are. Source: ICC.1:2022, sections 7 to 10; sRGB from IEC 61966-2-1, its matrix
//! adapted to D50 as the profiles' own are.

use super::Image;

/// From XYZ under D50 to linear sRGB.
const SRGB_OF_XYZ: [[f32; 3]; 3] = [
    [3.133_856, -1.616_867, -0.490_615],
    [-0.978_768, 1.916_142, 0.033_454],
    [0.071_945, -0.228_991, 1.405_243],
];
const D50: [f32; 3] = [0.9642, 1.0, 0.8249];
/// How far a profile's white may lie from that; further away it is no colour of light.
const WHITE_TOLERANCE: f32 = 0.05;
/// Entries of the table from linear light to sRGB: fine enough for the steep beginning.
const ENTRIES: usize = 8192;

/// From the samples of a photo to sRGB.
pub(super) enum Correction {
    /// One sample to one.
    Grey(Box<[u8; 256]>),
    /// Three to three.
    Color(Box<Color>),
}

/// Curves to linear light, a matrix, and the curve of sRGB.
pub(super) struct Color {
    curves: [[f32; 256]; 3],
    /// To linear sRGB, as positions in `encoded`.
    matrix: [[f32; 3]; 3],
    encoded: Vec<u8>,
}

/// What a profile asks for; none where it is sRGB itself within a rounding, or cannot be read.
pub(super) fn correction(profile: &[u8]) -> Option<Correction> {
    if profile.get(36..40)? != b"acsp" || profile.get(20..24)? != b"XYZ " {
        return None;
    }
    match profile.get(16..20)? {
        b"GRAY" => {
            let curve = curve(tag(profile, *b"kTRC")?)?;
            let table = curve.map(encoded);
            let same = (0..=255u8).zip(table).all(|(value, new)| value.abs_diff(new) <= 1);
            (!same).then(|| Correction::Grey(Box::new(table)))
        }
        b"RGB " => {
            let color = Color::read(profile)?;
            (!color.changes_nothing()).then(|| Correction::Color(Box::new(color)))
        }
        _ => None,
    }
}

impl Correction {
    /// Corrects an image of three planes; `grey` says whether the file had one sample a pixel. A profile for the
    /// other kind says nothing about this one.
    pub(super) fn apply(&self, image: &mut Image, grey: bool) {
        match self {
            Self::Grey(table) if grey => {
                for plane in image.planes_mut() {
                    plane.samples_mut().iter_mut().for_each(|value| *value = table[usize::from(*value)]);
                }
            }
            Self::Color(color) if !grey => {
                let [r, g, b] = image.planes_mut() else { return };
                let samples = r.samples_mut().iter_mut().zip(g.samples_mut()).zip(b.samples_mut());
                for ((r, g), b) in samples {
                    [*r, *g, *b] = color.corrected([*r, *g, *b]);
                }
            }
            _ => {}
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
        // The cast ends at 0; what is brighter than white ends at the last entry.
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

    /// The five formulas of section 10.18, all of the form of the last: what a formula lacks is 0.
    fn parametric(data: &'a [u8]) -> Option<Self> {
        let kind = u16::from_be_bytes(*data.get(8..)?.first_chunk()?);
        let mut values = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let given = *[1, 3, 4, 5, 7].get(usize::from(kind))?;
        for (i, value) in values[..given].iter_mut().enumerate() {
            *value = f64::from(fixed(data, 12 + 4 * i)?);
        }
        if matches!(kind, 1 | 2) {
            // Below the zero of the power; the fourth number, where there is one, is added on both sides.
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
    use crate::raster::Plane;
    use proptest::prelude::*;

    /// Display P3 out of a test file.
    fn display_p3() -> Vec<u8> {
        let file = include_bytes!("../../tests/oracles/data/files/jpeg-icc-p3.jpg");
        let mark = b"ICC_PROFILE\0\x01\x01";
        let start = file.windows(mark.len()).position(|window| window == mark).unwrap() + mark.len();
        let length = u32_at(file, start).unwrap() as usize;
        file[start..start + length].to_vec()
    }

    fn corrected(profile: &[u8], rgb: [u8; 3]) -> Option<[u8; 3]> {
        let mut image = Image::from_rgb(rgb.map(|value| Plane::filled(1, 1, value))).unwrap();
        correction(profile)?.apply(&mut image, false);
        image.to_rgb().try_into().ok()
    }

    #[test]
    fn greys_stay_and_colours_that_srgb_lacks_end_at_its_edge() {
        let profile = display_p3();
        for value in [0, 1, 40, 128, 254, 255] {
            for channel in corrected(&profile, [value; 3]).unwrap() {
                assert!(channel.abs_diff(value) <= 1, "{value}: {channel}");
            }
        }
        assert_eq!(corrected(&profile, [255, 0, 0]).unwrap()[0], 255);
        assert_eq!(corrected(&profile, [0, 255, 0]).unwrap()[..2], [0, 255]);
    }

    #[test]
    fn what_is_no_profile_of_light_is_ignored() {
        let mut black = display_p3();
        let column = black.windows(4).rposition(|window| window == b"XYZ ").unwrap();
        black[column + 8..column + 20].fill(0);
        assert!(correction(&black).is_none());
        assert!(correction(b"").is_none());
        assert!(correction(&display_p3()[..200]).is_none());
    }

    proptest! {
        #[test]
        fn damaged_profiles_never_panic(changes in prop::collection::vec((any::<usize>(), any::<u8>()), 1..8), length in 100usize..700) {
            let mut profile = display_p3();
            for (at, value) in changes {
                let at = at % profile.len();
                profile[at] = value;
            }
            let _ = corrected(&profile[..length.min(profile.len())], [200, 10, 90]);
        }
    }
}
