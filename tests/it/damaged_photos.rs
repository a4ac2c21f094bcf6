//! Damaged and incomplete photos: the readable part is decoded, and the damage is reported or the file is refused.

use std::fs;
use std::process::Output;

use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Decoded, Limits, decode};

fn file(name: &str) -> Vec<u8> {
    fs::read(crate::root("tests/oracles/data/files").join(name)).unwrap()
}

fn decoded(bytes: &[u8]) -> Decoded {
    decode(bytes, &Limits::default()).unwrap()
}

/// A photo without restart markers.
fn photo() -> Vec<u8> {
    fs::read(crate::root("tests/photos/bee.jpg")).unwrap()
}

/// Position of the coded data of the first scan.
fn scan(jpeg: &[u8]) -> usize {
    jpeg.windows(2).position(|pair| pair == [0xFF, 0xDA]).unwrap() + 14
}

/// Share of rows at the top that are the same in both pictures.
fn same_rows(one: &Image, other: &Image) -> f64 {
    let (a, b) = (one.to_rgb(), other.to_rgb());
    let row = 3 * one.width();
    let same = a.chunks(row).zip(b.chunks(row)).take_while(|(a, b)| a == b).count();
    same as f64 / one.height() as f64
}

#[test]
fn a_jpeg_without_its_end_marker_is_complete_if_all_pixels_are_there() {
    for name in ["jpeg-444.jpg", "jpeg-420.jpg", "jpeg-progressive.jpg", "jpeg-restarts.jpg"] {
        let bytes = file(name);
        let whole = decoded(&bytes);
        let end = bytes.windows(2).rposition(|pair| pair == [0xFF, 0xD9]).unwrap();
        for tail in [&b""[..], &[0; 200], b"a trailer of a camera"] {
            let open = decoded(&[&bytes[..end], tail].concat());
            assert_eq!(open.image.to_rgb(), whole.image.to_rgb(), "{name}");
            assert!(open.damage.is_none(), "{name}: {:?}", open.damage);
        }
    }
}

#[test]
fn a_png_without_its_end_chunk_is_complete_if_all_pixels_are_there() {
    let bytes = file("png-grey.png");
    let end = bytes.windows(4).rposition(|name| name == b"IEND").unwrap() - 4;
    let open = decoded(&bytes[..end]);
    assert_eq!(open.image.to_rgb(), decoded(&bytes).image.to_rgb());
    assert!(open.damage.is_none());
}

#[test]
fn a_truncated_jpeg_is_decoded_up_to_its_end_or_refused() {
    let bytes = photo();
    let (start, whole) = (scan(&bytes), decoded(&bytes));
    let mut refused = 0;
    for part in [20, 35, 65, 80, 95] {
        let cut = start + (bytes.len() - start) * part / 100;
        match decode(&bytes[..cut], &Limits::default()) {
            Ok(found) => {
                let damage = found.damage.expect("a truncated file is damaged");
                let same = same_rows(&whole.image, &found.image);
                assert!(damage.missing < 0.5, "{part} %: {damage:?}");
                // The share of the rows differs from the share of the blocks by at most the last row of blocks.
                assert!(
                    (1.0 - damage.missing - same).abs() < 0.1,
                    "{part} %: {damage:?}, {same} is the same"
                );
            }
            Err(error) => {
                refused += 1;
                assert_eq!(error.code(), "damaged");
                assert!(error.to_string().contains(" % of this JPEG can be decoded"), "{error}");
            }
        }
    }
    assert!((1..=3).contains(&refused), "{refused} of 5 were refused");
}

#[test]
fn damage_ends_at_the_next_restart_marker() {
    let bytes = file("jpeg-restarts.jpg");
    let whole = decoded(&bytes);
    let start = scan(&bytes);
    let is_restart = |at: &usize| bytes[*at] == 0xFF && (0xD0..=0xD7).contains(&bytes[at + 1]);
    let restarts: Vec<usize> = (start..bytes.len() - 1).filter(is_restart).collect();
    let (from, to) = (restarts[0] + 2, restarts[1]);
    let mut damaged = bytes.clone();
    damaged[from..to].iter_mut().for_each(|byte| *byte = 0);
    let found = decoded(&damaged);
    let damage = found.damage.expect("the damage is reported");
    assert!(damage.missing > 0.0 && damage.missing < 0.5, "{damage:?}");
    let (a, b) = (whole.image.to_rgb(), found.image.to_rgb());
    let different = a.chunks(3).zip(b.chunks(3)).filter(|(a, b)| a != b).count() as f64;
    let share = different / (whole.image.width() * whole.image.height()) as f64;
    assert!(share < damage.missing + 0.1, "{share} differs, {damage:?}");
}

fn render(photo: &[u8], options: &[&str]) -> Output {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("photo.jpg"), photo).unwrap();
    let mut command = crate::inkpanel();
    command.args(["render", "--width", "300", "-o", "page.png", "photo.jpg"]).args(options);
    command.current_dir(folder.path()).output().unwrap()
}

#[test]
fn the_command_line_warns_of_damage_and_refuses_it_with_strict() {
    let bytes = photo();
    let cut = &bytes[..scan(&bytes) + (bytes.len() - scan(&bytes)) * 85 / 100];
    let warned = render(cut, &[]);
    let text = String::from_utf8_lossy(&warned.stderr).into_owned();
    assert!(warned.status.success(), "{text}");
    assert!(text.contains("photo.jpg") && text.contains(" % of the picture is damaged"), "{text}");
    assert!(!render(cut, &["--strict"]).status.success());
    assert!(render(&bytes, &["--strict"]).status.success());
}

/// Transparency with a wrong checksum is skipped, unless the pixels are damaged as well: then checksums are
/// ignored, and the same file has a fourth channel.
#[test]
fn a_damaged_png_may_have_damaged_transparency() {
    let mut bytes = file("png-palette-clear.png");
    let chunk = |bytes: &[u8], name: &[u8; 4]| bytes.windows(4).position(|four| four == name).unwrap();
    let transparency = chunk(&bytes, b"tRNS");
    bytes[transparency + 4 + 4] ^= 1;
    let end = chunk(&bytes, b"IEND");
    bytes[end - 20] ^= 1;
    let found = decoded(&bytes);
    assert!(found.damage.is_some());
}

#[test]
fn random_damage_never_panics() {
    let mut random = oorandom::Rand64::new(6);
    for name in
        ["jpeg-444.jpg", "jpeg-progressive.jpg", "jpeg-restarts.jpg", "png-grey.png", "png-palette-clear.png"]
    {
        let bytes = file(name);
        for _ in 0..crate::trials(60, 600) {
            let mut damaged = bytes.clone();
            for _ in 0..random.rand_range(1..6) {
                let at = random.rand_range(0..damaged.len() as u64) as usize;
                damaged[at] = random.rand_u64() as u8;
            }
            if random.rand_float() < 0.3 {
                damaged.truncate(random.rand_range(2..damaged.len() as u64) as usize);
            }
            if let Ok(found) = decode(&damaged, &Limits::default()) {
                let missing = found.damage.map_or(0.0, |damage| damage.missing);
                assert!((0.0..=0.5).contains(&missing), "{name}: {missing}");
            }
        }
    }
}
