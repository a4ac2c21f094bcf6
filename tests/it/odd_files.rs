//! Rare variants of each format, compared with Pillow: 45 dB or more, or a documented reason for the
//! difference. `tests/oracles/odd.py` makes files, pixels and reasons, and writes docs/reference/decoding.md.

use std::fs;

use inkpanel_engine::raster::decode::{Limits, decode};
use serde::Deserialize;

/// Minimum similarity of equal pictures, in decibels.
const SAME: f64 = 45.0;

#[derive(Deserialize)]
struct Row {
    file: String,
    /// Why it is seen otherwise.
    reason: Option<String>,
    width: Option<usize>,
    height: Option<usize>,
    /// Position of Pillow's pixels; `None` if Pillow does not open the file.
    offset: Option<usize>,
}

#[test]
fn what_pillow_opens_is_seen_the_same_or_the_reason_is_told() {
    let data = crate::root("tests/oracles/data");
    let rows: Vec<Row> = serde_json::from_slice(&fs::read(data.join("odd.json")).unwrap()).unwrap();
    let pixels = fs::read(data.join("odd.bin")).unwrap();
    assert_eq!(rows.len(), fs::read_dir(data.join("odd")).unwrap().count());
    let (mut offences, mut same) = (Vec::new(), 0);
    for row in rows {
        let decoded = decode(&fs::read(data.join("odd").join(&row.file)).unwrap(), &Limits::default());
        let Some((offset, size)) = row.offset.zip(row.width.zip(row.height)) else { continue };
        let expected = &pixels[offset..][..size.0 * size.1 * 3];
        let said = match decoded {
            Err(error) => format!("{}: {error}", error.code()),
            Ok(decoded) if (decoded.image.width(), decoded.image.height()) != size => {
                format!("{} x {} instead of {size:?}", decoded.image.width(), decoded.image.height())
            }
            Ok(decoded) => {
                let decibels = likeness(&decoded.image.to_rgb(), expected);
                if decibels >= SAME { String::new() } else { format!("{decibels:.1} dB") }
            }
        };
        same += usize::from(said.is_empty());
        match row.reason {
            None if !said.is_empty() => offences.push(format!("{}: {said}", row.file)),
            Some(_) if said.is_empty() => offences.push(format!("{}: the reason is none any more", row.file)),
            _ => {}
        }
    }
    assert!(offences.is_empty(), "{same} are the same; {offences:#?}");
}

/// The peak signal-to-noise ratio of two pictures.
fn likeness(one: &[u8], other: &[u8]) -> f64 {
    let square = |(a, b): (&u8, &u8)| f64::from(a.abs_diff(*b)).powi(2);
    let mean = one.iter().zip(other).map(square).sum::<f64>() / one.len() as f64;
    10.0 * (255.0 * 255.0 / mean).log10()
}

#[test]
fn half_red_is_half_red() {
    let file = fs::read(crate::root("tests/oracles/data/odd/tiff-half-red.tif"));
    let image = decode(&file.unwrap(), &Limits::default()).unwrap().image;
    assert_eq!(image.to_rgb()[..3], [255, 127, 127]);
}

/// If Pillow decodes a file incorrectly, the file is compared with the same picture in another layout.
#[test]
fn layouts_of_the_same_samples_are_seen_the_same() {
    let folder = crate::root("tests/oracles/data/odd");
    let seen = |name: &str| {
        decode(&fs::read(folder.join(name)).unwrap(), &Limits::default()).unwrap().image.to_rgb()
    };
    let expected = seen("tiff-rgb-16.tif");
    for name in ["", "-lzw", "-tiles", "-tiles-zip", "-big"] {
        assert_eq!(seen(&format!("tiff-planes-16{name}.tif")), expected, "{name}");
    }
    let inverted: Vec<u8> = seen("tiff-grey-inverted.tif");
    assert_eq!(seen("tiff-grey-16-inverted.tif"), inverted);
    assert_eq!(seen("tiff-alpha-planes.tif"), seen("tiff-alpha-associated.tif"));
}
