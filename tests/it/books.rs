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
