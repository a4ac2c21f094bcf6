//! Plans on the command line: printed as JSON, distributed over pages, scored, and rejected if they are
//! invalid.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::{Value, json};

const PHOTOS: [&str; 7] =
    ["bee.jpg", "cat.jpg", "crab.jpg", "gateway.jpg", "macaw.jpg", "palace.jpg", "temple.jpg"];

/// Runs the program in `folder` on the photos of the tests.
fn inkpanel(folder: &Path, arguments: &[&str], photos: &[&str]) -> Output {
    let from = crate::root("tests/photos");
    crate::inkpanel()
        .args(arguments)
        .args(photos.iter().map(|photo| from.join(photo)))
        .current_dir(folder)
        .output()
        .unwrap()
}

fn plan(output: &Output) -> Value {
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    serde_json::from_slice(&output.stdout).unwrap()
}

fn refusal(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn within(value: &Value, low: f64, high: f64) -> bool {
    value.as_f64().is_some_and(|value| (low..=high).contains(&value))
}

fn check_page(page: &Value) {
    let terms = page["terms"].as_object().unwrap();
    let sum: f64 = terms.values().map(|term| term.as_f64().unwrap()).sum();
    assert!((sum - page["score"].as_f64().unwrap()).abs() < 1e-4, "the terms add up: {page}");
    for panel in page["panels"].as_array().unwrap() {
        let crop = &panel["crop"];
        let reach = |at: &str, side: &str| crop[at].as_f64().unwrap() + crop[side].as_f64().unwrap();
        assert!(within(&crop["x"], 0.0, 1.0) && within(&crop["y"], 0.0, 1.0), "{crop}");
        assert!(reach("x", "width") <= 1.0 + 1e-9 && reach("y", "height") <= 1.0 + 1e-9, "{crop}");
        let shape = panel["shape"].as_array().unwrap();
        assert!(
            shape.len() >= 3 && shape.iter().all(|at| within(&at[0], -0.1, 1.1) && within(&at[1], -0.1, 1.1))
        );
        assert_eq!(panel["breaks_frame"], false);
        assert!(panel["group"].is_null() || panel["group"].is_u64());
    }
}

#[test]
fn a_plan_is_told_and_judged_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["render", "--json", "--no-detect", "--panels", "5", "--seed", "3"];
    let told = plan(&inkpanel(folder.path(), &arguments, &PHOTOS));
    assert_eq!(told["pages"].as_array().unwrap().len(), 1);
    let page = &told["pages"][0];
    check_page(page);
    assert_eq!(page["panels"].as_array().unwrap().len(), 5);
    assert_eq!(told, plan(&inkpanel(folder.path(), &arguments, &PHOTOS)), "the same seed, the same page");

    fs::write(folder.path().join("plan.json"), told.to_string()).unwrap();
    let judged = plan(&inkpanel(folder.path(), &["score", "plan.json", "--json", "--no-detect"], &[]));
    let (was, now) =
        (page["terms"]["fit"].as_f64().unwrap(), judged["pages"][0]["terms"]["fit"].as_f64().unwrap());
    assert!((was - now).abs() < 0.02, "{was} {now}");
}

#[test]
fn an_album_becomes_pages_and_no_photo_is_on_two() {
    let folder = tempfile::tempdir().unwrap();
    let told = plan(&inkpanel(
        folder.path(),
        &["render", "--json", "--no-detect", "--pages", "2", "--width", "320", "-o", "out-%02d.png"],
        &PHOTOS,
    ));
    let pages = told["pages"].as_array().unwrap();
    pages.iter().for_each(check_page);
    let styles: Vec<_> = pages.iter().map(|page| &page["style"]).collect();
    assert!(pages.len() == 2 && styles[0] == styles[1]);
    let mut photos: Vec<_> = pages
        .iter()
        .flat_map(|page| page["panels"].as_array().unwrap())
        .map(|panel| &panel["photo"])
        .collect();
    let all = photos.len();
    photos.sort_by_key(ToString::to_string);
    photos.dedup();
    assert_eq!((photos.len(), all), (PHOTOS.len(), PHOTOS.len()), "each photo once");
    for file in ["out-01.png", "out-02.png"] {
        assert!(fs::read(folder.path().join(file)).unwrap().starts_with(b"\x89PNG"));
    }
}

#[test]
fn a_page_that_must_repeat_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let told =
        plan(&inkpanel(folder.path(), &["render", "--json", "--no-detect", "--panels", "9"], &PHOTOS[..1]));
    assert!(told["pages"][0]["why"].as_str().unwrap().contains("photos repeat"), "{told}");
}

#[test]
fn what_is_no_plan_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let square = json!([[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]]);
    let panel =
        json!({ "photo": "gone.jpg", "crop": { "x": 0, "y": 0, "width": 1, "height": 1 }, "shape": square });
    let page =
        |panels: Value| json!({ "pages": [{ "page": { "width": 10, "height": 10 }, "panels": panels }] });
    for (text, word) in [
        ("[1".to_owned(), "not valid JSON"),
        ("{}".to_owned(), "has no list of \"pages\""),
        (json!({ "pages": [{}] }).to_string(), "a width and a height"),
        (page(json!([])).to_string(), "from 1 to"),
        (page(json!([panel])).to_string(), "gone.jpg cannot be read"),
        (page(json!([{ "shape": [[0, 0]] }])).to_string(), "convex polygon"),
    ] {
        fs::write(folder.path().join("plan.json"), &text).unwrap();
        let said = refusal(&inkpanel(folder.path(), &["score", "plan.json", "--json"], &[]));
        assert!(said.contains("plan.json") && said.contains(word), "{text}: {said}");
    }
    let said = refusal(&inkpanel(folder.path(), &["render", "--pages", "2", "-o", "x.tiff"], &PHOTOS));
    assert!(said.contains("x.tiff") && !folder.path().join("x.tiff").exists(), "{said}");
}

#[test]
fn a_star_is_given_by_file_name() {
    let folder = tempfile::tempdir().unwrap();
    let star = |name: &str| {
        let arguments =
            ["render", "--json", "--no-detect", "--layout", "hero-top-3", "--seed", "2", "--star", name];
        let output = inkpanel(folder.path(), &arguments, &PHOTOS);
        (plan(&output), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for name in ["palace.jpg", "./palace.jpg", "photos/palace.jpg"] {
        let (told, said) = star(name);
        assert!(!said.contains("no photo has this name"), "{said}");
        let lead = told["pages"][0]["panels"][0]["photo"].as_str().unwrap();
        assert!(lead.ends_with("palace.jpg"), "{lead}");
    }
    assert!(star("alace.jpg").1.contains("no photo has this name"));
}
