//! Books of the command line, in every format.

use crate::root;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Output;

const PHOTOS: [&str; 7] = ["bee", "cat", "macaw", "horses", "pagoda", "wine", "temple"];

/// A folder with two places.
fn album() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (i, photo) in PHOTOS.iter().enumerate() {
        let place = folder.path().join("Iberia").join(if i < 4 { "Lisbon" } else { "Sintra" });
        fs::create_dir_all(&place).unwrap();
        fs::copy(root(format!("tests/photos/{photo}.jpg")), place.join(format!("{i}.jpg"))).unwrap();
    }
    folder
}

fn book(folder: &Path, arguments: &[&str]) -> Output {
    let usual = ["book", "Iberia", "--no-detect", "--keep-all", "--width", "200"];
    crate::inkpanel().args([&usual[..], arguments].concat()).current_dir(folder).output().unwrap()
}

fn plan(folder: &Path, arguments: &[&str]) -> Value {
    let output = book(folder, &[&["--json"], arguments].concat());
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    serde_json::from_slice(&output.stdout).unwrap()
}

fn texts(plan: &Value) -> Vec<String> {
    let pages = plan["pages"].as_array().unwrap().iter();
    pages
        .flat_map(|page| page["texts"].as_array().unwrap())
        .map(|text| text.as_str().unwrap().into())
        .collect()
}

#[test]
fn a_folder_becomes_a_book_with_every_photo() {
    let folder = album();
    let plan = plan(folder.path(), &[]);
    let pages = plan["pages"].as_array().unwrap();
    assert_eq!((&plan["title"], &pages[0]["role"]), (&"Iberia".into(), &"cover".into()));
    assert_eq!(pages.last().unwrap()["role"], "end");
    let panels = pages[1..].iter().flat_map(|page| page["panels"].as_array().unwrap());
    let mut shown: Vec<&str> = panels.map(|panel| panel["photo"].as_str().unwrap()).collect();
    shown.sort_unstable();
    shown.dedup();
    assert_eq!(shown.len(), PHOTOS.len());
    let texts = texts(&plan);
    assert!(
        ["Iberia", "Lisbon.", "Sintra.", "The end"].iter().all(|text| texts.contains(&(*text).into())),
        "{texts:?}"
    );
}

#[test]
fn names_of_several_folders_are_places() {
    let folder = album();
    let output = crate::inkpanel()
        .args(["book", "Iberia/Lisbon", "Iberia/Sintra", "--no-detect", "--keep-all", "--json"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let plan: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(plan["title"], "Lisbon and Sintra");
    let texts = texts(&plan);
    assert!(["Lisbon.", "Sintra."].iter().all(|text| texts.contains(&(*text).into())), "{texts:?}");
}

#[test]
fn title_language_style_and_pages_are_options() {
    let folder = album();
    let plan = plan(
        folder.path(),
        &["--title", "Sommer", "--language", "de", "--style", "noir", "--pages", "4", "--as-given"],
    );
    let texts = texts(&plan);
    assert!(texts.contains(&"Sommer".into()) && texts.contains(&"Ende".into()), "{texts:?}");
    let pages = plan["pages"].as_array().unwrap();
    assert_eq!(pages.len(), 4);
    assert!(pages.iter().all(|page| page["style"] == "noir"));
}

#[test]
fn a_book_is_a_file_of_any_kind() {
    let folder = album();
    for (file, start) in [("b.pdf", &b"%PDF"[..]), ("b.cbz", b"PK"), ("b.epub", b"PK"), ("b.inkpanel", b"PK")]
    {
        let output = book(folder.path(), &["--style", "noir", "-o", file]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(fs::read(folder.path().join(file)).unwrap().starts_with(start), "{file}");
    }
    assert_eq!(book(folder.path(), &["--style", "noir", "-o", "p-%02d.png"]).status.code(), Some(0));
    assert!(folder.path().join("p-03.png").is_file());
}

#[test]
fn bad_wishes_are_errors() {
    let folder = album();
    for (arguments, code, told) in [
        (&["--pages", "2", "-o", "b.pdf"][..], 2, "--pages"),
        (&["--style", "nope", "-o", "b.pdf"], 1, "nope"),
        (&["-o", "b.edl"], 1, "shot list"),
        (&["--styles", "many", "-o", "b.pdf"], 2, "--styles"),
    ] {
        let output = book(folder.path(), arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{said}");
        assert!(said.contains(told), "{said}");
    }
}

/// A copy of a photo with GPS data: degrees, minutes and seconds north and west.
fn located(photo: &str, [north, west]: [[u32; 3]; 2]) -> Vec<u8> {
    let field = |tag: u16, kind: u16, count: u32, value: [u8; 4]| {
        [&tag.to_le_bytes()[..], &kind.to_le_bytes(), &count.to_le_bytes(), &value].concat()
    };
    let mut record = [&b"II*\0"[..], &8u32.to_le_bytes(), &1u16.to_le_bytes()].concat();
    record.extend(field(0x8825, 4, 1, 26u32.to_le_bytes()));
    record.extend([0; 4]);
    record.extend(4u16.to_le_bytes());
    for (tag, reference, at) in [(1, b'N', 80u32), (3, b'W', 104)] {
        record.extend(field(tag, 2, 2, [reference, 0, 0, 0]));
        record.extend(field(tag + 1, 5, 3, at.to_le_bytes()));
    }
    record.extend([0; 4]);
    for part in north.into_iter().chain(west) {
        record.extend([part.to_le_bytes(), 1u32.to_le_bytes()].concat());
    }
    let segment = [&b"Exif\0\0"[..], &record].concat();
    let length = (segment.len() as u16 + 2).to_be_bytes();
    let file = fs::read(root(format!("tests/photos/{photo}.jpg"))).unwrap();
    [&file[..2], &[0xff, 0xe1], &length, &segment, &file[2..]].concat()
}

/// A table of two places, as `cargo xtask models` makes it.
fn places() -> Vec<u8> {
    let places = [("Lisbon", 38.716_67, -9.133_33, 152u8), ("Sintra", 38.800_97, -9.378_26, 117)];
    let mut table = [&b"inkpanel places 1\n"[..], &2u32.to_be_bytes()].concat();
    let step = |degrees: f64, whole: f64| ((degrees + whole / 2.0) / whole * 65535.0).round() as u16;
    let columns = [places.map(|place| step(place.1, 180.0)), places.map(|place| step(place.2, 360.0))];
    for [one, two] in columns {
        let steps = [one, two.wrapping_sub(one)].map(u16::to_be_bytes);
        table.extend(steps.map(|step| step[0]));
        table.extend(steps.map(|step| step[1]));
    }
    table.extend(places.map(|place| place.3));
    table.extend(b"Lisbon\nSintra\n");
    miniz_oxide::deflate::compress_to_vec_zlib(&table, 6)
}

#[test]
fn gps_data_names_places_and_stays_in_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let photos = folder.path().join("Iberia");
    fs::create_dir_all(&photos).unwrap();
    for (i, photo) in PHOTOS.iter().enumerate() {
        let at = if i < 4 { [[38, 42, 50], [9, 8, 20]] } else { [[38, 48, 0], [9, 22, 40]] };
        fs::write(photos.join(format!("{i}.jpg")), located(photo, at)).unwrap();
    }
    let models = folder.path().join("models");
    fs::create_dir_all(&models).unwrap();
    fs::write(models.join("places.bin"), places()).unwrap();
    let models = models.to_str().unwrap();
    let found = texts(&plan(folder.path(), &["--models", models]));
    assert!(["Lisbon.", "Sintra."].iter().all(|text| found.contains(&(*text).into())), "{found:?}");
    let without = texts(&plan(folder.path(), &["--models", models, "--no-places"]));
    assert!(!without.iter().any(|text| text.contains("Sintra")), "{without:?}");
    // No book has the location.
    for file in ["b.html", "b.pdf"] {
        let output = book(folder.path(), &["--models", models, "--style", "noir", "-o", file]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let bytes = fs::read(folder.path().join(file)).unwrap();
        let gps = [0x25u8, 0x88, 4, 0, 1, 0, 0, 0];
        assert!(!bytes.windows(gps.len()).any(|window| window == gps), "{file}");
    }
}

#[test]
fn a_strip_is_pictures_for_webtoon_readers() {
    let folder = album();
    let output = book(folder.path(), &["--style", "noir", "--strip", "-o", "s-%02d.png"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let mut heights = Vec::new();
    for number in 1.. {
        let Ok(file) = fs::read(folder.path().join(format!("s-{number:02}.png"))) else { break };
        let side = |at: usize| u32::from_be_bytes(file[at..at + 4].try_into().unwrap());
        assert_eq!(side(16), 800);
        heights.push(side(20));
    }
    assert!(heights.len() > 2 && heights.iter().all(|height| *height <= 1280), "{heights:?}");
    let refused = book(folder.path(), &["--strip", "-o", "s.pdf"]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--strip"));
}
