//! Text items that stay with their photos. A text item on a panel belongs to the photo of that panel, and
//! stores its id in the field `photo`. It moves with that photo to another panel, layout or page of the
//! storyboard. If no page shows the photo, the text item is stored as unplaced in the project.

use super::limits::{MOST_WAITING, MOST_WORDS};
use super::project::Project;
use crate::page::Document;
use crate::page::carrying::{belongs, carried, photo_of, tie, tied};
use serde_json::{Value, json};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// After an edit of pages, moves each text item to the page of its photo. `before`: the state that was
/// edited.
pub(super) fn follow(before: &Project, next: &mut Project) {
    let sheets = before.sheets();
    let has_words = |project: &Project| {
        let mut own = project.page.iter().chain(project.others.iter().map(|sheet| &sheet.page));
        own.any(|page| !page.words.is_empty())
    };
    if next.waiting.is_empty() && !has_words(next) && !has_words(before) {
        return;
    }
    let mut away: Vec<Arc<Value>> = next.waiting.to_vec();
    next.each_page(&mut |page| {
        let (stay, leave) = carried(&page.words, &page.panels);
        away.extend(leave.into_iter().filter(|word| !is_made(word)).map(Arc::new));
        (stay != page.words).then(|| Arc::new(Document { words: stay, ..Document::clone(page) }))
    });
    let seen = places(next);
    // Restores text items whose photo was on no page. If the photo stayed, the user deleted the item.
    for sheet in &sheets {
        for word in sheet.page.words.iter().filter(|word| !is_made(word)) {
            let gone = photo_of(word, &sheet.page.panels).is_some_and(|photo| !seen.contains_key(photo));
            if gone {
                let word = tied(word, &sheet.page.panels);
                if !away.iter().any(|other| alike(other, &word)) {
                    away.push(Arc::new(word));
                }
            }
        }
    }
    settle(next, away, &seen);
}

/// Whether Shuffle made the text. The next page gets its own.
fn is_made(word: &Value) -> bool {
    word["made"] == json!(true)
}

/// Moves text items to the pages that show their photos. The others become unplaced.
fn settle(next: &mut Project, away: Vec<Arc<Value>>, seen: &HashMap<String, usize>) {
    let mut waiting = Vec::new();
    let mut coming: Vec<(usize, Arc<Value>)> = Vec::new();
    for word in away {
        match word["photo"].as_str().and_then(|photo| seen.get(photo)) {
            Some(&page) => coming.push((page, word)),
            None => waiting.push(word),
        }
    }
    if !coming.is_empty() {
        next.each_numbered_page(&mut |place, page| {
            let own: Vec<Value> = coming
                .iter()
                .filter(|(page, _)| *page == place)
                .map(|(_, word)| Value::clone(word))
                .collect();
            let (page, left) = with(page, own)?;
            waiting.extend(left.into_iter().map(Arc::new));
            Some(Arc::new(page))
        });
    }
    // The oldest are removed.
    waiting.drain(..waiting.len().saturating_sub(MOST_WAITING));
    let same = waiting.len() == next.waiting.len()
        && waiting.iter().zip(next.waiting.iter()).all(|(a, b)| Arc::ptr_eq(a, b) || a == b);
    if !same {
        next.waiting = waiting.into();
    }
}

/// The page with the text items for its photos, and the items that do not fit. `None` without new items.
fn with(page: &Document, words: Vec<Value>) -> Option<(Document, Vec<Value>)> {
    if words.is_empty() {
        return None;
    }
    let mut page = page.clone();
    let mut left = Vec::new();
    for word in words {
        if page.words.iter().any(|other| alike(other, &word)) {
            continue;
        }
        match belongs(&word, &page.panels) {
            Some(word) if page.words.len() < MOST_WORDS => page.words.push(word),
            _ => left.push(word),
        }
    }
    Some((page, left))
}

/// Returns a planned page with the unplaced text items of its photos.
#[must_use]
pub(super) fn gathered(project: &Project, page: Document) -> Document {
    if project.waiting.is_empty() {
        return page;
    }
    let shown: HashSet<&str> = page.panels.iter().filter_map(|panel| panel.photo.as_deref()).collect();
    let own = |word: &&Arc<Value>| word["photo"].as_str().is_some_and(|photo| shown.contains(photo));
    let words = project.waiting.iter().filter(own).map(|word| Value::clone(word)).collect();
    match with(&page, words) {
        Some((page, _)) => page,
        None => page,
    }
}

/// The number of the first page that shows each photo.
fn places(project: &Project) -> HashMap<String, usize> {
    let mut seen = HashMap::new();
    for (i, sheet) in project.sheets().iter().enumerate() {
        for photo in sheet.page.panels.iter().filter_map(|panel| panel.photo.as_ref()) {
            seen.entry(photo.clone()).or_insert(i);
        }
    }
    seen
}

/// Returns whether two text items are the same one, because an earlier version of a page and the unplaced
/// list may both have it.
fn alike(a: &Value, b: &Value) -> bool {
    ["photo", "kind", "text", "cue"].into_iter().all(|name| a[name] == b[name])
}

impl Project {
    /// Adds new text items: on the page and the panel in `sheet` and `panel`, or at its `photo`. Text items
    /// without a page or space stay unplaced. A text item of a known `cue` is not added again. Returns `None`
    /// without new text items.
    pub(super) fn with_words(&self, words: &[Value]) -> Option<Self> {
        let mut known: HashSet<String> = HashSet::new();
        let mut number = 0;
        let mut note = |word: &Value| {
            known.extend(word["cue"].as_str().map(str::to_owned));
            let said = word["id"]
                .as_str()
                .and_then(|id| id.strip_prefix("said-"))
                .and_then(|id| id.parse::<u64>().ok());
            number = number.max(said.unwrap_or_default());
        };
        let sheets = self.sheets();
        sheets.iter().flat_map(|sheet| &sheet.page.words).for_each(&mut note);
        self.waiting.iter().for_each(|word| note(word));
        let mut pages: Vec<Vec<Value>> = vec![Vec::new(); sheets.len()];
        let mut away: Vec<Arc<Value>> = Vec::new();
        let mut mouth: Option<Value> = None;
        for (i, word) in words.iter().enumerate() {
            let mut word = word.clone();
            let (sheet, joins) = match word.as_object_mut() {
                Some(word) => (word.remove("sheet"), word.remove("joins") == Some(json!(true))),
                None => continue,
            };
            if word["cue"].as_str().is_some_and(|cue| known.contains(cue)) {
                mouth = None;
                continue;
            }
            number += 1;
            word["id"] = json!(format!("said-{number}"));
            // Parts of one speech have the same speaker, even without a name. They are linked if possible.
            let parted = joins || words.get(i + 1).is_some_and(|next| next["joins"] == json!(true));
            if parted && word["by"].is_null() {
                word["by"] = mouth.filter(|_| joins).unwrap_or_else(|| word["id"].clone());
            }
            mouth = Some(word["by"].clone()).filter(Value::is_string);
            let place = sheet.and_then(|sheet| sheet.as_u64());
            match sheets.iter().position(|sheet| Some(sheet.sheet) == place) {
                Some(at) => {
                    tie(&mut word, &sheets[at].page.panels);
                    pages[at].push(word);
                }
                None => away.push(Arc::new(word)),
            }
        }
        if away.is_empty() && pages.iter().all(Vec::is_empty) {
            return None;
        }
        let mut next = self.clone();
        next.each_numbered_page(&mut |place, page| {
            let mut own = pages.get_mut(place).map(std::mem::take).filter(|own| !own.is_empty())?;
            let mut page = Document::clone(page);
            let room = MOST_WORDS.saturating_sub(page.words.len());
            away.extend(own.drain(room.min(own.len())..).map(Arc::new));
            page.words.append(&mut own);
            Some(Arc::new(page))
        });
        // Text without a photo stays unplaced until the user places it. Text beyond the limit is left out.
        let mut room = MOST_WAITING.saturating_sub(next.waiting.len());
        away.retain(|word| {
            if word["photo"].is_string() {
                return true;
            }
            let fits = room > 0;
            room = room.saturating_sub(1);
            fits
        });
        let waiting = next.waiting.iter().cloned().chain(away).collect();
        let seen = places(&next);
        settle(&mut next, waiting, &seen);
        (next != *self).then_some(next)
    }

    /// Removes unplaced text items by index. `None` if none of them exist.
    pub(super) fn without_waiting(&self, gone: &[usize]) -> Option<Self> {
        let stay =
            self.waiting.iter().enumerate().filter(|(i, _)| !gone.contains(i)).map(|(_, word)| word.clone());
        let waiting: super::project::List<Value> = stay.collect();
        (waiting.len() < self.waiting.len()).then(|| Self { waiting, ..self.clone() })
    }

    /// Text items move to the photo that replaces their photo.
    pub(super) fn words_exchanged(&mut self, id: &str, by: &str) {
        let changed = |word: &Value| (word["photo"] == id).then(|| renamed(word, by));
        self.each_page(&mut |page| {
            page.words.iter().any(|word| word["photo"] == id).then(|| {
                let words =
                    page.words.iter().map(|word| changed(word).unwrap_or_else(|| word.clone())).collect();
                Arc::new(Document { words, ..Document::clone(page) })
            })
        });
        if self.waiting.iter().any(|word| word["photo"] == id) {
            self.waiting = self
                .waiting
                .iter()
                .map(|word| changed(word).map_or_else(|| word.clone(), Arc::new))
                .collect();
        }
    }
}

/// Returns the text item with another photo.
fn renamed(word: &Value, photo: &str) -> Value {
    let mut word = word.clone();
    word["photo"] = json!(photo);
    word
}
