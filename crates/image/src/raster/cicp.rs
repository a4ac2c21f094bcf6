//! ICC profiles for colour codes of video (ITU-T H.273), which HEIC files have in place of a profile.

/// Columns of red, green and blue in XYZ under D50. Source: ICC profiles "Display P3" and "Rec. 2020" with the primaries of SMPTE EG
/// 432-1 and ITU-R BT.2020, adapted by Bradford.
const SRGB: [[f64; 3]; 3] = [[0.4360, 0.2225, 0.0139], [0.3851, 0.7169, 0.0971], [0.1431, 0.0606, 0.7139]];
const P3: [[f64; 3]; 3] = [[0.5151, 0.2412, -0.0011], [0.2920, 0.6922, 0.0419], [0.1571, 0.0666, 0.7841]];
const BT2020: [[f64; 3]; 3] = [[0.6735, 0.2790, -0.0019], [0.1657, 0.6753, 0.0300], [0.1251, 0.0456, 0.7969]];
/// Entries of a curve.
const ENTRIES: u32 = 1024;
/// Brightness of white in nits and the peak of PQ (ITU-R BT.2408); brighter light is cut.
const WHITE: f64 = 203.0;
const PEAK: f64 = 10_000.0;
/// Signal of white in HLG (ITU-R BT.2408).
const HLG_WHITE: f64 = 0.75;

/// Returns an ICC profile for primaries and a transfer function; `None` if both belong to sRGB, or are
/// unknown.
///
/// HDR signals are clipped at white. The transfer functions of BT.709 count as the sRGB function, as in photo
/// viewers.
pub(super) fn profile(primaries: u16, transfer: u16) -> Option<Vec<u8>> {
    let matrix = match primaries {
        9 => BT2020,
        11 | 12 => P3,
        _ => SRGB,
    };
    let light: fn(f64) -> f64 = match transfer {
        4 => |signal| signal.powf(2.2),
        5 => |signal| signal.powf(2.8),
        8 => |signal| signal,
        16 => |signal| pq(signal) * PEAK / WHITE,
        18 => |signal| hlg(signal) / hlg(HLG_WHITE),
        _ if matrix == SRGB => return None,
        _ => srgb,
    };
    Some(written(matrix, light))
}

fn srgb(signal: f64) -> f64 {
    if signal <= 0.040_45 { signal / 12.92 } else { ((signal + 0.055) / 1.055).powf(2.4) }
}

/// SMPTE ST 2084: the share of the peak.
fn pq(signal: f64) -> f64 {
    let power = signal.powf(32.0 / 2523.0);
    ((power - 0.835_937_5).max(0.0) / (18.851_562_5 - 18.6875 * power)).powf(16_384.0 / 2610.0)
}

/// ARIB STD-B67: the light of the scene.
fn hlg(signal: f64) -> f64 {
    let (a, b, c) = (0.178_832_77, 0.284_668_92, 0.559_910_73);
    if signal <= 0.5 { signal * signal / 3.0 } else { (((signal - c) / a).exp() + b) / 12.0 }
}

fn written(matrix: [[f64; 3]; 3], light: fn(f64) -> f64) -> Vec<u8> {
    let mut tags: Vec<([u8; 4], Vec<u8>)> = Vec::new();
    for (name, column) in [*b"rXYZ", *b"gXYZ", *b"bXYZ"].into_iter().zip(matrix) {
        let numbers = column.map(|value| ((value * 65_536.0).round() as i32).to_be_bytes()).concat();
        tags.push((name, [b"XYZ \0\0\0\0", numbers.as_slice()].concat()));
    }
    let entry = |i: u32| {
        let light = light(f64::from(i) / f64::from(ENTRIES - 1)).clamp(0.0, 1.0);
        ((light * 65_535.0).round() as u16).to_be_bytes()
    };
    let entries: Vec<u8> = (0..ENTRIES).flat_map(entry).collect();
    let curve = [b"curv\0\0\0\0", &ENTRIES.to_be_bytes()[..], &entries].concat();
    for name in [*b"rTRC", *b"gTRC", *b"bTRC"] {
        tags.push((name, curve.clone()));
    }
    let mut profile = vec![0; 128];
    profile[12..24].copy_from_slice(b"mntrRGB XYZ ");
    profile[36..40].copy_from_slice(b"acsp");
    profile.extend((tags.len() as u32).to_be_bytes());
    let mut at = profile.len() + 12 * tags.len();
    for (name, data) in &tags {
        profile.extend([&name[..], &(at as u32).to_be_bytes(), &(data.len() as u32).to_be_bytes()].concat());
        at += data.len();
    }
    profile.extend(tags.iter().flat_map(|(_, data)| data));
    let length = (profile.len() as u32).to_be_bytes();
    profile[..4].copy_from_slice(&length);
    profile
}

#[cfg(test)]
mod tests {
    use super::super::channels::Channels;
    use super::super::icc::{Correction, correction};
    use super::super::{Image, Plane};
    use super::*;

    fn converted(codes: (u16, u16), rgb: [u8; 3]) -> [u8; 3] {
        let planes = || rgb.iter().map(|&value| Plane::from_samples(1, 1, vec![value]).unwrap()).collect();
        let found = profile(codes.0, codes.1).and_then(|bytes| correction(&bytes, Channels::Rgb).unwrap());
        let image =
            found.map_or_else(|| Image::from_planes(planes()), |found: Correction| found.image(planes()));
        [0, 1, 2].map(|i| image.as_ref().unwrap().planes()[i].samples()[0])
    }

    /// Values of colour-science 0.4.7: `RGB_to_RGB`, `eotf_ST2084` and `oetf_inverse_BT2100_HLG`, white at 203 nits and at 75 % of HLG.
    #[test]
    fn colours_are_those_of_an_independent_library() {
        let near = |found: [u8; 3], expected: [u8; 3]| {
            assert!(found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 2), "{found:?} {expected:?}");
        };
        for grey in [0, 64, 128, 255] {
            near(converted((12, 13), [grey; 3]), [grey; 3]);
            near(converted((1, 13), [grey; 3]), [grey; 3]);
        }
        near(converted((12, 13), [200, 100, 50]), [215, 93, 31]);
        near(converted((9, 16), [128; 3]), [181; 3]);
        near(converted((9, 16), [200; 3]), [255; 3]);
        near(converted((9, 18), [128; 3]), [153; 3]);
        near(converted((9, 18), [100; 3]), [122; 3]);
        assert_eq!(converted((1, 1), [10, 200, 30]), [10, 200, 30]);
    }
}
