//! Fuzzing entry points: one function per parser of untrusted input, called by the fuzz targets and by
//! `tests/regressions.rs`. Each may reject its input. A panic, a hang or unlimited memory use is a bug.

use inkpanel_engine::Error;
use inkpanel_engine::document::edit::{Edit, How};
use inkpanel_engine::document::editor::Editor;
use inkpanel_engine::document::file::ProjectFile;
use inkpanel_engine::document::kept;
use inkpanel_engine::document::page_edits;
use inkpanel_engine::document::planning::Known;
use inkpanel_engine::document::project::Project;
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::document::script;
use inkpanel_engine::document::sheets::photos_on;
use inkpanel_engine::document::subtitles::Subtitles;
use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::layout::{self, PageSettings, Template};
use inkpanel_engine::page::document::Document;
use inkpanel_engine::page::import::import;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::{Scene, catalogue, shuffle};
use inkpanel_engine::raster::decode::{Limits, decode_reduced};
use inkpanel_engine::raster::header::Header;
use inkpanel_engine::raster::location::location;
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::painters::{Choice, Painters};
use inkpanel_engine::style::{Context, Style, stylize};
use inkpanel_engine::texts;
use serde_json::Value;
use std::collections::HashSet;

/// An entry point accepts any bytes.
pub type Entry = fn(&[u8]);

/// All entry points, by the name of their target and of their folder in `tests/regressions`.
pub const ENTRIES: &[(&str, Entry)] = &[
    ("photo", photo),
    ("style", style),
    ("layout", layout),
    ("document", document),
    ("project", project),
    ("saved", saved),
    ("edits", edits),
    ("plan", plan),
    ("choice", choice),
    ("texts", texts),
    ("painters", painters),
];

/// Small limits, so that runs are fast and large requests are rejected.
const LIMITS: Limits = Limits { max_pixels: 1_000_000, max_side: 4096, max_bytes: 1 << 24 };
/// The page that documents are laid out on, in pixels.
const WIDTH: usize = 200;
/// Edits of one run.
const MOST_EDITS: usize = 100;

/// Reads a model of painters, and paints with it.
pub fn painters(bytes: &[u8]) {
    let Ok(painters) = Painters::new(bytes) else { return };
    let image = Image::from_luma(Plane::from_fn(16, 16, |x, y| (x * y) as u8));
    let choice = Choice { first: 0, second: painters.count() - 1, share: 0.5 };
    let painting = painters.paint(&image, choice, None, &|| Ok(()));
    assert!(painting.is_ok_and(|(painting, _)| painting.width() == 16));
}

/// Decodes and measures an image file.
pub fn photo(bytes: &[u8]) {
    if let Ok(photo) = import("photo", bytes, &LIMITS) {
        assert!(u64::from(photo.meta.width) * u64::from(photo.meta.height) <= LIMITS.max_pixels);
    }
    if let Some(found) = location(bytes) {
        assert!(found.latitude.abs() <= 90.0 && found.longitude.abs() <= 180.0);
    }
    if let Some(header) = Header::read(bytes) {
        assert!(header.width > 0 && header.height > 0);
    }
    // As a photo that is many times as large is decoded.
    if let Ok(photo) = decode_reduced(bytes, &LIMITS, 16) {
        assert!(photo.image.width().max(photo.image.height()) <= 16);
    }
}

/// A style file, and a picture in that style.
pub fn style(bytes: &[u8]) {
    let Some(style) = text(bytes).and_then(|json| Style::parse("fuzz", json).ok()) else { return };
    let plane = |i: usize| Plane::from_fn(13, 9, |x, y| (x * 19 + y * 27 * i) as u8);
    let Ok(image) = Image::from_rgb([plane(0), plane(1), plane(2)]) else { return };
    let mut context = Context::default();
    context.fit_scale(&image);
    let _: Result<_, Error> = stylize(&image, &style, &mut context);
}

/// A layout file, and its panels on a page.
pub fn layout(bytes: &[u8]) {
    if let Some(Ok(template)) = text(bytes).map(|json| Template::parse("fuzz", json)) {
        let page = PageSettings::default();
        let _ = layout::resolve(&template, page.aspect(), &page);
        assert!(Template::parse("again", &template.to_json()).is_ok());
    }
}

/// A saved page.
pub fn document(bytes: &[u8]) {
    if let Some(Ok(document)) = text(bytes).map(Document::parse) {
        let _ = Scene::new(&document, WIDTH);
    }
}

/// Reads a project file, the text of a page PNG, or a history with its tables. An accepted project can be
/// drawn and saved again.
pub fn project(bytes: &[u8]) {
    let Some(json) = text(bytes) else { return };
    if let Ok(project) = ProjectFile::parse(json) {
        let shown = project.history.shown.iter().map(|shown| &shown.page);
        for page in shown.chain(project.history.present.sheets().iter().map(|sheet| &sheet.page)) {
            assert!(Scene::new(page, WIDTH).is_ok());
        }
        let written = project.renamed("q").write();
        assert!(ProjectFile::parse(&written).is_ok());
    }
    if let Ok((history, dropped)) = kept::parse(json) {
        let written = kept::write(&history, &dropped);
        assert!(kept::parse(&written).is_ok_and(|(again, _)| again == history));
    }
}

/// A project file, or a PNG that may carry a project, with the photos of its pages.
pub fn saved(bytes: &[u8]) {
    let Ok(Some(mut saved)) = Saved::read(bytes.to_vec()) else { return };
    let (pages, present) = saved.pages();
    assert!(pages.is_empty() || present < pages.len());
    for page in &pages {
        for id in photos_on(&[page]) {
            let _: Result<_, Error> = saved.photo_file(id);
        }
    }
}

/// Applies edits from a JSON array in the format of the app, and skips invalid ones. The result can be
/// undone, redone and saved. Applies the same edits to pages, as the command line does.
pub fn edits(bytes: &[u8]) {
    let Some(Ok(Value::Array(told))) = text(bytes).map(serde_json::from_str) else { return };
    edited_pages(&told[..told.len().min(MOST_EDITS)]);
    let mut editor = Editor::default();
    for edit in told.iter().take(MOST_EDITS) {
        let before = editor.history().clone();
        let tray = editor.project().tray.clone();
        let photos: Vec<_> = tray.iter().map(|item| PhotoMeta::unmeasured(&item.id, 3000, 2000)).collect();
        let known = || Ok(photos.iter().map(|meta| Known { meta, place: None }).collect());
        if editor.apply_json_with(&edit.to_string(), &known).is_err() {
            assert!(*editor.history() == before, "what was refused did something");
        }
        editor.history().states().for_each(|state| whole(state));
    }
    let end = editor.history().clone();
    let written = kept::write(&end, &Vec::new());
    assert!(kept::parse(&written).is_ok_and(|(again, dropped)| again == end && dropped.is_empty()));
    let step = |editor: &mut Editor, edit: &Edit| editor.apply(edit, &How::default());
    while step(&mut editor, &Edit::Undo) {}
    assert!(
        end.states().next() == Some(&editor.history().present),
        "undone to the start it is not the start"
    );
    for _ in 0..end.past.len() {
        assert!(step(&mut editor, &Edit::Redo));
    }
    assert!(
        *editor.project() == *end.present && editor.history().past == end.past,
        "done again it is another"
    );
    assert!(editor.history().future == end.future);
}

/// Applies edits to a page, with four photos in use. Valid edits give pages that can be drawn.
fn edited_pages(edits: &[Value]) {
    let photos = ["a", "b", "c", "d"].map(|id| PhotoMeta::unmeasured(id, 3000, 2000));
    let page = Document::parse(include_str!("seeds/document/page.json")).expect("the seed is a page");
    let Ok(edited) = page_edits::apply(vec![page], &photos, edits, &|_| None) else { return };
    for page in &edited.pages {
        assert!(Scene::new(page, WIDTH).is_ok(), "an edit made a page that cannot be drawn");
    }
}

/// Checks the invariants of every state: the tray lists each photo once, pages show only photos of the tray,
/// and each text item has a position.
fn whole(state: &Project) {
    let table: HashSet<&str> = state.tray.iter().map(|item| item.id.as_str()).collect();
    assert!(table.len() == state.tray.len(), "a photo is on the table twice");
    let sheets = state.sheets();
    for sheet in sheets {
        assert!(photos_on(&[&sheet.page]).is_subset(&table), "a page shows a photo that is not there");
        assert!(sheet.page.order.iter().all(|id| table.contains(id.as_str())));
    }
    let places: HashSet<u64> = sheets.iter().map(|sheet| sheet.sheet).collect();
    assert!(places.len() == sheets.len(), "two pages claim one place");
}

/// A request for a page.
pub fn plan(bytes: &[u8]) {
    if let Ok(request) = serde_json::from_slice::<Request>(bytes) {
        let _ = shuffle::plan(&request);
    }
}

/// A request to choose among photos.
pub fn choice(bytes: &[u8]) {
    if let Some(json) = text(bytes) {
        let _ = catalogue::choose(json);
    }
}

/// A text file in any encoding, as subtitles and as a script.
pub fn texts(bytes: &[u8]) {
    let Some(read) = texts::decode(bytes, "en") else { return };
    for vtt in [false, true] {
        if let Ok(subtitles) = Subtitles::parse(&read.text, vtt) {
            assert!(!subtitles.cues.is_empty() && subtitles.cues.is_sorted_by(|a, b| a.start <= b.start));
        }
    }
    let _ = script::read(&read.text);
}

fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}
