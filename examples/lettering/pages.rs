//! Pages of the bundled photos with automatically placed balloons.

use inkpanel_engine::Error;
use inkpanel_engine::framing::{PhotoMeta, Subject};
use inkpanel_engine::page::Document;
use inkpanel_engine::page::words::place::{self, Known as Of};
use inkpanel_engine::page::words::{Letters, TextItem, TextKind};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::path::Path;

/// Stored detection results of a photo.
#[derive(Serialize, Deserialize)]
pub(crate) struct Known {
    /// Name of the file.
    pub(crate) id: String,
    /// Its folder, from the root.
    pub(crate) folder: String,
    /// Size in pixels.
    pub(crate) size: (u32, u32),
    /// Faces and objects.
    pub(crate) subjects: Vec<Subject>,
}

/// Pages that are measured, and balloons on them.
pub(crate) const PAGES: u32 = 40;
/// Balloons of a page.
pub(crate) const BALLOONS: usize = 3;

const STYLES: [&str; 8] =
    ["comic", "noir", "clear-line", "riso-red", "watercolour", "golden-age", "ballpoint", "ben-day"];

/// Typical lengths of speech: a word, a sentence, two.
const SPEECHES: [&str; 15] = [
    "Look!",
    "Did you hear that?",
    "I told you it was the *other* road.",
    "Don't move. Whatever happens, don't move.",
    "We could have taken the train, you know. Trains have seats.",
    "No.",
    "So this is where you've been hiding all summer?",
    "It's the oldest trick in the book, and we fell for it like children.",
    "Who wants ice cream?",
    "Nobody will ever believe us.",
    "Wait — is that *ours*?",
    "I never thought we would see the lighthouse again, not after such a night.",
    "Quick, before anyone notices!",
    "That's what she said yesterday, and the day before that.",
    "Smile!",
];

/// Returns the analysed photos.
///
/// # Errors
/// The file is missing or broken.
pub(crate) fn known(root: &Path) -> Result<Vec<Known>, Box<dyn std::error::Error>> {
    Ok(serde_json::from_str(&std::fs::read_to_string(root.join("tests/data/lettering.json"))?)?)
}

/// The photos as the planner takes them.
pub(crate) fn photos(known: &[Known]) -> Vec<PhotoMeta> {
    let meta = |known: &Known| {
        let mut meta = PhotoMeta::unmeasured(&known.id, known.size.0, known.size.1);
        meta.subjects.clone_from(&known.subjects);
        meta
    };
    known.iter().map(meta).collect()
}

/// Returns a stored page with two balloons on the panel with most faces and one on another panel. The layouts, photos and crops
/// are stored, so the measurements depend on the placement of text and not on the planner.
///
/// # Errors
/// `invalid-document` if the stored pages cannot be read; layout errors.
pub(crate) fn page(
    photos: &[PhotoMeta],
    number: u32,
    letters: &Letters,
) -> inkpanel_engine::Result<Document> {
    let start = number as usize;
    // The tests of another package also compile this file.
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let top = package.ancestors().find(|folder| folder.join("Cargo.lock").is_file());
    let file = top.unwrap_or(package).join("tests/data/lettering-pages.json");
    let unreadable =
        |reason: String| Error::InvalidDocument { location: "lettering-pages.json".into(), reason };
    let text = std::fs::read_to_string(file).map_err(|error| unreadable(error.to_string()))?;
    let stored: Vec<Value> = serde_json::from_str(&text).map_err(|error| unreadable(error.to_string()))?;
    let mut stored = stored.get(start).cloned().ok_or_else(|| unreadable(format!("has no page {start}")))?;
    stored["version"] = json!(1);
    stored["style"] = json!(STYLES[start % STYLES.len()]);
    let mut page = Document::parse(&stored.to_string())?;
    let of = |id: &str| photos.iter().find(|photo| photo.id == id).map(Of::from).unwrap_or_default();
    let faces = |panel: usize| {
        let photo = page.panels[panel].photo.as_deref().unwrap_or_default();
        of(photo).subjects.iter().filter(|s| s.label == "face").count()
    };
    let mut panels: Vec<usize> = (0..page.panels.len()).collect();
    panels.sort_by_key(|&panel| (usize::MAX - faces(panel), panel));
    let on = [panels[0], panels[0], panels[1 % panels.len()]];
    let words = on.iter().enumerate().map(|(i, panel)| {
        let text = SPEECHES[(start * BALLOONS + i) % SPEECHES.len()];
        let item = TextItem::new(TextKind::Balloon, text);
        let language = Some("en".into());
        TextItem { panel: Some(*panel), language, ..item }
    });
    page.words = words.collect();
    place::settle(&mut page, of, letters)?;
    Ok(page)
}

/// Places the text items of a page again, with the current detection results.
///
/// # Errors
/// Errors of the layout.
pub(crate) fn placed_again(
    page: &Document,
    photos: &[PhotoMeta],
    letters: &Letters,
) -> inkpanel_engine::Result<Document> {
    let mut page = page.clone();
    let of = |id: &str| photos.iter().find(|photo| photo.id == id).map(Of::from).unwrap_or_default();
    place::settle(&mut page, of, letters)?;
    Ok(page)
}
