//! Saved projects and pages: the command line draws the same pixels as the app, and files of every version
//! still open. `tests/data/saved/README.md` describes how they are made.

use inkpanel_engine::document::listing::ordered_shots;
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

fn folder() -> PathBuf {
    crate::root("tests/data/saved")
}

fn file(name: &str) -> Vec<u8> {
    fs::read(folder().join(name)).unwrap()
}

fn read(name: &str) -> Saved {
    Saved::read(file(name)).unwrap().unwrap()
}

fn render(arguments: &[&str], output: &Path) -> Output {
    let mut command = crate::inkpanel();
    command.arg("render").args(arguments).arg("-o").arg(output).output().unwrap()
}

/// All files of all versions, as `version-1/page.png`.
fn all() -> Vec<String> {
    let mut all = Vec::new();
    for version in
        fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir())
    {
        for file in fs::read_dir(&version).unwrap() {
            all.push(file.unwrap().path().strip_prefix(folder()).unwrap().display().to_string());
        }
    }
    all.sort();
    all
}

/// The greatest difference of two pictures of one size.
fn difference(a: &Image, b: &Image) -> u8 {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    a.to_rgb().iter().zip(b.to_rgb()).map(|(a, b)| a.abs_diff(b)).max().unwrap()
}

fn picture(bytes: &[u8]) -> Image {
    decode(bytes, &Limits::default()).unwrap().image
}

/// Compares the drawn page with the exported one.
fn expect_same(arguments: &[&str], exported: &str) {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out.png");
    let done = render(arguments, &output);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let drawn = fs::read(&output).unwrap();
    let most = difference(&picture(&drawn), &picture(&file(exported)));
    assert!(most <= 1, "{exported}: differs by {most} of 255");
    // The resolution too.
    let dots = |png: &[u8]| {
        let at = png.windows(4).position(|chunk| chunk == b"pHYs").unwrap();
        png[at..at + 13].to_vec()
    };
    assert_eq!(dots(&drawn), dots(&file(exported)));
}

fn path(name: &str) -> String {
    folder().join(name).display().to_string()
}

#[test]
fn a_page_is_drawn_with_the_pixels_of_its_own_export() {
    expect_same(&[&path("version-1/own-style.png")], "version-1/own-style.png");
}

/// The text of this page was set by older rules.
#[test]
fn a_page_with_text_of_older_rules_keeps_its_pictures() {
    let name = "version-1/merged-words.png";
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out.png");
    assert!(render(&[&path(name)], &output).status.success());
    let (drawn, exported) = (picture(&fs::read(&output).unwrap()), picture(&file(name)));
    assert_eq!((drawn.width(), drawn.height()), (exported.width(), exported.height()));
    let (a, b) = (drawn.to_rgb(), exported.to_rgb());
    let same = a.iter().zip(&b).filter(|(a, b)| a.abs_diff(**b) <= 1).count() as f64 / a.len() as f64;
    assert!(same > 0.99, "{same}");
}

#[test]
fn every_page_of_a_project_is_drawn_with_the_pixels_of_its_export() {
    let project = path("version-1/storyboard.inkpanel");
    let (pages, present) = read("version-1/storyboard.inkpanel").pages();
    assert!(pages.len() > 1);
    for page in 1..=pages.len() {
        expect_same(&["--page", &page.to_string(), &project], &format!("version-1/storyboard-{page}.png"));
    }
    expect_same(&[&project], &format!("version-1/storyboard-{}.png", present + 1));
}

#[test]
fn a_name_with_the_place_of_a_number_gets_a_picture_of_each_page() {
    let folder = tempfile::tempdir().unwrap();
    let done = render(&[&path("version-1/storyboard.inkpanel")], &folder.path().join("page-%02d.png"));
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let mut names: Vec<String> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let pages = read("version-1/storyboard.inkpanel").pages().0.len();
    assert_eq!(names, (1..=pages).map(|page| format!("page-{page:02}.png")).collect::<Vec<_>>());
    for (i, name) in names.iter().enumerate() {
        let drawn = picture(&fs::read(folder.path().join(name)).unwrap());
        let exported = picture(&file(&format!("version-1/storyboard-{}.png", i + 1)));
        assert!(difference(&drawn, &exported) <= 1, "{name}");
    }
}

/// Compares the content of a file, ignoring fields that were added later and have default values.
fn holds(is: &Value, was: &Value, place: &str) {
    match (is, was) {
        (Value::Object(is), Value::Object(was)) => {
            for (name, was) in was {
                let field = is.get(name).unwrap_or(&Value::Null);
                holds(field, was, &format!("{place}.{name}"));
            }
        }
        (Value::Array(is), Value::Array(was)) => {
            assert_eq!(is.len(), was.len(), "{place}");
            for (i, (is, was)) in is.iter().zip(was).enumerate() {
                holds(is, was, &format!("{place}[{i}]"));
            }
        }
        (Value::Number(is), Value::Number(was)) => {
            // Page settings are held in single precision.
            let (is, was) = (is.as_f64().unwrap(), was.as_f64().unwrap());
            assert!((is - was).abs() <= was.abs() * 1e-6, "{place}: {is} was {was}");
        }
        (is, was) => assert_eq!(is, was, "{place}"),
    }
}

#[test]
fn what_was_saved_opens_as_it_was() {
    for name in all() {
        let Some(saved) = Saved::read(file(&name)).unwrap() else {
            assert!(name.contains("storyboard-"), "{name} has no project");
            continue;
        };
        assert!(saved.project().dropped.is_empty(), "{name}: {:?}", saved.project().dropped);
        let written: Value = serde_json::from_str(&saved.project().write()).unwrap();
        holds(&written, &serde_json::from_str(saved.text()).unwrap(), &name);
    }
}

#[test]
fn what_is_in_a_project_is_what_was_made() {
    let saved = read("version-1/merged-words.png");
    let page = saved.pages().0[0].clone();
    assert_eq!((page.layout.built_in(), page.style.built_in()), (Some("grid-4"), Some("comic")));
    assert_eq!((page.merges.clone(), page.words.len()), (vec![vec![0, 1]], 3));
    assert_eq!((page.page.width, page.page.height, page.page.dpi), (360, 480, 150));
    let saved = read("version-1/own-style.png");
    let page = saved.pages().0[0].clone();
    assert_eq!(page.style().unwrap().name, "Own");
    assert!(page.layout.custom().is_some() && page.panels[0].edited);
    let saved = read("version-1/storyboard.inkpanel");
    assert_eq!((saved.project().history.present.name.as_str(), saved.pages().1), ("Garden", 1));
    assert_eq!(saved.project().photos.len(), 5);
}

#[test]
fn a_project_with_a_video_is_drawn_and_its_shots_are_listed() {
    let project = read("version-1/film.inkpanel").project().clone();
    // The app makes the key of a video from the id of its first frame.
    let video = &project.videos[0];
    assert_eq!((project.videos.len(), video.ids.len(), &video.key), (1, 8, &video.ids[0]));
    assert!(project.photos.iter().all(|photo| photo.video.as_ref() == Some(&video.key)));
    let folder = tempfile::tempdir().unwrap();
    let made = |name: &str, more: &[&str]| {
        let output = folder.path().join(name);
        let done = render(&[more, &[&path("version-1/film.inkpanel")]].concat(), &output);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        fs::read(output).unwrap()
    };
    let shots = String::from_utf8(made("shots.csv", &[])).unwrap();
    assert_eq!(shots.matches(",album.mp4,").count(), ordered_shots(&project).len(), "{shots}");
    assert!(String::from_utf8(made("shots.edl", &[])).unwrap().contains("album.mp4"));
    assert!(made("board.pdf", &["--board", "4"]).starts_with(b"%PDF"));
}

/// Drawing this is refused with that sentence, and leaves no file.
fn refused(name: &str, bytes: &[u8], more: &[&str], sentence: &str) {
    let folder = tempfile::tempdir().unwrap();
    let (input, output) = (folder.path().join(name), folder.path().join("out.png"));
    fs::write(&input, bytes).unwrap();
    let done = render(&[more, &[input.to_str().unwrap()]].concat(), &output);
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(1), "{name}: {said}");
    assert!(said.contains(sentence), "{name}: {said}");
    assert!(said.contains(name) && !said.contains("panicked"), "{name}: {said}");
    assert!(!output.exists());
}

/// Chunks of a PNG as type and data.
fn chunks(png: &[u8]) -> Vec<([u8; 4], Vec<u8>)> {
    let mut chunks = Vec::new();
    let mut at = 8;
    while at < png.len() {
        let length = u32::from_be_bytes(png[at..at + 4].try_into().unwrap()) as usize;
        chunks.push((png[at + 4..at + 8].try_into().unwrap(), png[at + 8..at + 8 + length].to_vec()));
        at += length + 12;
    }
    chunks
}

/// The page with other chunks.
fn changed(mut change: impl FnMut(&[u8; 4], &mut Vec<u8>) -> bool) -> Vec<u8> {
    let page = file("version-1/own-style.png");
    let mut out = page[..8].to_vec();
    for (kind, mut data) in chunks(&page) {
        if change(&kind, &mut data) {
            let body = [&kind[..], &data].concat();
            out.extend((data.len() as u32).to_be_bytes());
            out.extend(&body);
            out.extend(crc(&body).to_be_bytes());
        }
    }
    out
}

fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, byte| {
        (0..8).fold(
            crc ^ u32::from(*byte),
            |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 },
        )
    })
}

/// The page with another text, not deflated.
fn told(text: &str) -> Vec<u8> {
    changed(|kind, data| {
        if kind == b"iTXt" {
            *data = [b"inkpanel\0\0\0\0\0", text.as_bytes()].concat();
        }
        true
    })
}

#[test]
fn a_page_that_cannot_be_drawn_is_refused_with_a_sentence() {
    let text = read("version-1/own-style.png").text().to_owned();
    // The file is drawn. Only its text is compressed differently.
    let folder = tempfile::tempdir().unwrap();
    let plain = folder.path().join("plain.png");
    fs::write(&plain, told(&text)).unwrap();
    expect_same(&[plain.to_str().unwrap()], "version-1/own-style.png");

    let bare = changed(|kind, _| kind != b"ipPh");
    refused("bare.png", &bare, &[], "3 of its 3 photos are not in it; save it again with the photos");
    let cut = changed(|kind, data| {
        if kind == b"ipPh" {
            data.truncate(data.len() / 2);
        }
        true
    });
    refused("cut.png", &cut, &[], "photos are not in it");
    let mut flipped = file("version-1/own-style.png");
    let at = flipped.windows(4).position(|chunk| chunk == b"iTXt").unwrap();
    flipped[at + 60] ^= 4;
    refused("flipped.png", &flipped, &[], "its project is damaged");
    refused(
        "newer.png",
        &told(&text.replacen("\"version\": 1", "\"version\": 99", 1)),
        &[],
        "version: 99 is newer than 1",
    );
    refused(
        "layout.png",
        &told(&text.replace("\"seed\":", "\"sead\":")),
        &[],
        "present.page.seed: is missing",
    );
    refused("foreign.png", &told("{}"), &[], "was not saved by Inkpanel");
    refused("planned.png", &told(&text), &["--style", "comic"], "a saved page takes only");
    refused("second.png", &told(&text), &["--page", "2"], "page 2 does not exist: the project has 1 page");
}

#[test]
fn a_project_that_cannot_be_drawn_is_refused_with_a_sentence() {
    let project = file("version-1/storyboard.inkpanel");
    refused("words.inkpanel", b"no ZIP file", &[], "not an Inkpanel project");
    refused(
        "empty.inkpanel",
        b"PK\x05\x06\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
        &[],
        "project.json: is missing",
    );
    refused("cut.inkpanel", &project[..project.len() / 2], &[], "is damaged");
    refused("many.inkpanel", &project, &["--page", "9"], "page 9 does not exist: the project has");
    // One byte of the text, of a photo.
    for (part, sentence) in [(&b"\"history\""[..], "project.json: is damaged"), (b"JFIF", "is damaged")] {
        let mut flipped = project.clone();
        let at = flipped.windows(part.len()).position(|window| window == part).unwrap();
        flipped[at + part.len() + 30] ^= 1;
        let pages = read("version-1/storyboard.inkpanel").pages().0.len();
        let refusals = (1..=pages).filter(|page| {
            let folder = tempfile::tempdir().unwrap();
            let (input, output) = (folder.path().join("p.inkpanel"), folder.path().join("out.png"));
            fs::write(&input, &flipped).unwrap();
            let done = render(&["--page", &page.to_string(), input.to_str().unwrap()], &output);
            let said = String::from_utf8_lossy(&done.stderr).into_owned();
            assert_eq!(done.status.success(), output.exists());
            assert!(done.status.success() || said.contains(sentence), "{said}");
            !done.status.success()
        });
        assert!(refusals.count() > 0, "{sentence}");
    }
    let folder = tempfile::tempdir().unwrap();
    let out = |name: &str| folder.path().join(name);
    let project = path("version-1/storyboard.inkpanel");
    for (arguments, output, sentence) in [
        (vec![&project[..], &project], "two.png", "a project cannot be combined with other files"),
        (
            vec![&project[..]],
            "page.bmp",
            "the name of the page must end in .png, .jpg, .webp, .pdf, .html, .epub, .cbz or .inkpanel",
        ),
        (vec!["missing.inkpanel"], "missing.png", "missing.inkpanel: "),
    ] {
        let done = render(&arguments, &out(output));
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert_eq!(done.status.code(), Some(1), "{said}");
        assert!(said.contains(sentence) && !out(output).exists(), "{said}");
    }
}

/// A ZIP file of zeros with correct headers, compressed or stored.
fn zeros(name: &str, length: usize, packed: bool) -> Vec<u8> {
    let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let kind = if packed { zip::CompressionMethod::Deflated } else { zip::CompressionMethod::Stored };
    writer.start_file(name, zip::write::SimpleFileOptions::default().compression_method(kind)).unwrap();
    std::io::Write::write_all(&mut writer, &vec![0; length]).unwrap();
    writer.finish().unwrap().into_inner()
}

#[test]
fn what_unpacks_to_more_than_a_project_has_is_refused() {
    let bomb = zeros("project.json", 40 << 20, true);
    assert!(bomb.len() < 100_000);
    let error = Saved::read(bomb).unwrap_err();
    assert_eq!(error.code(), "too-large-project", "{error}");
    assert_eq!(Saved::read(zeros("project.json", 40 << 20, false)).unwrap_err().code(), "too-large-project");
    assert_eq!(Saved::read(zeros("project.json", 100, true)).unwrap_err().code(), "damaged-project");
}

#[test]
fn a_saved_page_becomes_a_file_of_any_kind() {
    let folder = tempfile::tempdir().unwrap();
    for (name, start) in [("page.jpg", &b"\xFF\xD8"[..]), ("page.pdf", b"%PDF"), ("page.webp", b"RIFF")] {
        let output = folder.path().join(name);
        let done = render(&[&path("version-1/merged-words.png")], &output);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        assert!(fs::read(&output).unwrap().starts_with(start));
    }
}

#[test]
fn an_archive_of_pages_is_drawn_by_the_project_in_it() {
    let project = file("version-1/storyboard.inkpanel");
    let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let stored = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for (name, bytes) in [("page-01.png", &b"a picture"[..]), ("project.inkpanel", &project)] {
        writer.start_file(name, stored).unwrap();
        std::io::Write::write_all(&mut writer, bytes).unwrap();
    }
    let archive = writer.finish().unwrap().into_inner();
    let folder = tempfile::tempdir().unwrap();
    let book = folder.path().join("book.cbz");
    fs::write(&book, &archive).unwrap();
    expect_same(&["--page", "1", book.to_str().unwrap()], "version-1/storyboard-1.png");
    let mut flipped = archive;
    let at = flipped.windows(9).position(|window| window == b"\"history\"").unwrap();
    flipped[at + 40] ^= 1;
    refused("flipped.cbz", &flipped, &[], "is damaged");
}
