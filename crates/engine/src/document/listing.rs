//! The shots of a project file in order, with all metadata: for lists and storyboards without the app.

use super::file::{FilePhoto, ProjectFile};
use super::limits::LONGEST_FIELD;
use super::project::TrayItem;
use super::shots::{Board, numbers, ordered};
use crate::output::shots::{Film, ListedShot, ShotList};
use crate::page::Document;
use crate::page::words::layout::SLANT;
use crate::page::words::wording::read;
use crate::page::words::{TextItem, TextKind};
use std::collections::{HashMap, HashSet};

/// A photo on the pages. `said`: the text of its panels, in the order of [`KINDS`].
struct Shown {
    place: usize,
    said: [Vec<String>; 3],
}

/// The kinds of text that are dialogue, captions and sounds.
const KINDS: [TextKind; 3] = [TextKind::Balloon, TextKind::Caption, TextKind::Effect];

/// Returns the text of a kind in a panel, in reading order.
fn said_in(page: &Document, panel: usize, kind: TextKind) -> Vec<String> {
    let is_said = |word: &&TextItem| word.panel == Some(panel) && word.kind == kind;
    let mut own: Vec<&TextItem> = page.words.iter().filter(is_said).collect();
    let place = |word: &TextItem| word.at().1 + SLANT * word.at().0;
    own.sort_by(|a, b| place(a).total_cmp(&place(b)));
    let line = |word: &&TextItem| {
        let text = read(word).split_whitespace().collect::<Vec<_>>().join(" ");
        word.by.as_ref().map_or(text.clone(), |name| format!("{name}: {text}"))
    };
    own.iter().map(line).collect()
}

/// Ids of the photos that are shots, in order: photos in use or on a page.
#[must_use]
pub fn ordered_shots(file: &ProjectFile) -> Vec<&str> {
    let present = &file.history.present;
    let sheets = present.sheets();
    let shown: HashSet<&str> = sheets
        .iter()
        .flat_map(|sheet| &sheet.page.panels)
        .filter_map(|panel| panel.photo.as_deref())
        .collect();
    let told: HashSet<&str> = present.board.order.iter().map(String::as_str).collect();
    let used = |item: &TrayItem| {
        let id = item.id.as_str();
        item.used.unwrap_or(shown.contains(id) || told.contains(id) || !item.shot.is_empty())
    };
    let photos: HashMap<&str, &FilePhoto> =
        file.photos.iter().map(|photo| (photo.id.as_str(), photo)).collect();
    let mut own: Vec<&TrayItem> = present.tray.iter().map(AsRef::as_ref).filter(|item| used(item)).collect();
    own.retain(|item| photos.contains_key(item.id.as_str()));
    // If any capture time is missing, the order of the tray stays.
    let rank = |item: &TrayItem| photos.get(item.id.as_str()).and_then(|photo| photo.rank);
    if own.iter().all(|item| rank(item).is_some()) {
        own.sort_by_key(|item| rank(item));
    }
    // The storyboard follows the pages. Photos that no page shows come last.
    let places = on_pages(file);
    own.sort_by_key(|item| places.get(item.id.as_str()).map_or(usize::MAX, |shown| shown.place));
    let own: Vec<&str> = own.iter().map(|item| item.id.as_str()).collect();
    ordered(&present.board.order, &own)
}

/// Returns the photos on the pages, by id: the first place in reading order, and the text of the panels.
fn on_pages(file: &ProjectFile) -> HashMap<String, Shown> {
    let mut all: HashMap<String, Shown> = HashMap::new();
    for sheet in file.history.present.sheets() {
        let page: &Document = &sheet.page;
        for panel in page.reading_order() {
            let Some(photo) = page.panels.get(panel).and_then(|panel| panel.photo.as_deref()) else {
                continue;
            };
            let place = all.len();
            let shown =
                all.entry(photo.to_owned()).or_insert_with(|| Shown { place, said: Default::default() });
            for (said, kind) in shown.said.iter_mut().zip(KINDS) {
                said.extend(said_in(page, panel, kind));
            }
        }
    }
    all
}

/// The shots of a project as a list.
#[must_use]
pub fn shot_list(file: &ProjectFile) -> ShotList {
    let present = &file.history.present;
    let ids = ordered_shots(file);
    let items: HashMap<&str, &TrayItem> =
        present.tray.iter().map(|item| (item.id.as_str(), item.as_ref())).collect();
    let items: Vec<&TrayItem> = ids.iter().filter_map(|id| items.get(id).copied()).collect();
    let numbers = numbers(items.iter().map(|item| item.shot.number.as_str()));
    let pages = on_pages(file);
    let said = |item: &TrayItem| pages.get(item.id.as_str()).map(|shown| &shown.said);
    let listed = |(item, number): (&&TrayItem, String)| listed(file, item, number, said(item));
    let shots = items.iter().zip(numbers).map(listed).collect();
    let Board { fps, pace, columns, .. } = Board::clone(&present.board);
    ShotList { title: present.name.clone(), fps, pace, columns, headings: Vec::new(), shots }
}

/// `said`: the text on the pages, for empty fields of a shot.
fn listed(
    file: &ProjectFile,
    item: &TrayItem,
    number: String,
    said: Option<&[Vec<String>; 3]>,
) -> ListedShot {
    let mut shot = item.shot.clone();
    let fields = [&mut shot.dialogue, &mut shot.caption, &mut shot.sound];
    for (field, said) in fields.into_iter().zip(said.into_iter().flatten()) {
        if field.is_empty() {
            *field = said.join("\n").chars().take(LONGEST_FIELD).collect();
        }
    }
    let photo = file.photos.iter().find(|photo| photo.id == item.id);
    let film = photo.and_then(|photo| {
        let video = file.videos.iter().find(|video| Some(&video.key) == photo.video.as_ref())?;
        Some(Film {
            key: video.key.clone(),
            name: video.name.clone(),
            time: photo.time.unwrap_or_default(),
            length: video.duration,
            timecode: video.timecode,
        })
    });
    let more = shot.more.iter().filter_map(|(name, text)| Some((name.clone(), text.as_str()?.to_owned())));
    ListedShot {
        number,
        more: more.collect(),
        scene: shot.scene,
        action: shot.action,
        dialogue: shot.dialogue,
        caption: shot.caption,
        sound: shot.sound,
        notes: shot.notes,
        frames: shot.frames,
        name: photo.map(|photo| photo.name.clone()).unwrap_or_default(),
        film,
    }
}
