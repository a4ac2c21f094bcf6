//! Text items that stay with their photos. A text item on a panel belongs to the photo of that panel, and
//! stores its id in the field `photo`. It moves with that photo to another panel, layout or page of the
//! storyboard. If no page shows the photo, the text item is stored as unplaced in the project.

use super::limits::{MOST_WAITING, MOST_WORDS};
use super::project::Project;
use crate::page::Document;
use crate::text::NewText;
use crate::text::TextItem;
use crate::text_links::{belongs, carried, photo_of, tie, tied};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// After an edit of pages, moves each text item to the page of its photo. `before`: the state that was
/// edited.
pub(crate) fn follow(before: &Project, next: &mut Project) {
    let has_words = |project: &Project| project.sheets().iter().any(|sheet| !sheet.page.words.is_empty());
    if next.waiting.is_empty() && !has_words(next) && !has_words(before) {
        return;
    }
    let mut away: Vec<Arc<TextItem>> = next.waiting.to_vec();
    next.pages.each(&mut |_, page| {
        let (stay, leave) = carried(&page.words, &page.panels);
        away.extend(leave.into_iter().filter(|word| !word.made).map(Arc::new));
        (stay != page.words).then(|| Arc::new(Document { words: stay, ..Document::clone(page) }))
    });
    let seen = places(next);
    // Restores text items whose photo was on no page. If the photo stayed, the user deleted the item.
    for sheet in before.sheets() {
        for word in sheet.page.words.iter().filter(|word| !word.made) {
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

/// Moves text items to the pages that show their photos. The others become unplaced.
fn settle(next: &mut Project, away: Vec<Arc<TextItem>>, seen: &HashMap<String, usize>) {
    let mut waiting = Vec::new();
    let mut coming: Vec<(usize, Arc<TextItem>)> = Vec::new();
    for word in away {
        match word.photo.as_ref().and_then(|photo| seen.get(photo)) {
            Some(&page) => coming.push((page, word)),
            None => waiting.push(word),
        }
    }
    if !coming.is_empty() {
        next.pages.each(&mut |place, page| {
            let own: Vec<TextItem> = coming
                .iter()
                .filter(|(page, _)| *page == place)
                .map(|(_, word)| TextItem::clone(word))
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
fn with(page: &Document, words: Vec<TextItem>) -> Option<(Document, Vec<TextItem>)> {
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
pub fn gathered(project: &Project, page: Document) -> Document {
    if project.waiting.is_empty() {
        return page;
    }
    let shown: HashSet<&str> = page.panels.iter().filter_map(|panel| panel.photo.as_deref()).collect();
    let own = |word: &&Arc<TextItem>| word.photo.as_deref().is_some_and(|photo| shown.contains(photo));
    let words = project.waiting.iter().filter(own).map(|word| TextItem::clone(word)).collect();
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
fn alike(a: &TextItem, b: &TextItem) -> bool {
    (&a.photo, a.kind, &a.text, &a.cue) == (&b.photo, b.kind, &b.text, &b.cue)
}

impl Project {
    /// Adds new text items: on the page and the panel in `sheet` and `panel`, or at its `photo`. Text items
    /// without a page or space stay unplaced. A text item of a known `cue` is not added again. Returns `None`
    /// without new text items.
    pub(crate) fn with_words(&self, words: &[NewText]) -> Option<Self> {
        let mut known: HashSet<String> = HashSet::new();
        let mut number = 0;
        let mut note = |word: &TextItem| {
            known.extend(word.cue.clone());
            let said = word.id.as_deref().and_then(|id| id.strip_prefix("said-"));
            number = number.max(said.and_then(|id| id.parse::<u64>().ok()).unwrap_or_default());
        };
        let sheets = self.sheets();
        sheets.iter().flat_map(|sheet| &sheet.page.words).for_each(&mut note);
        self.waiting.iter().for_each(|word| note(word));
        let mut pages: Vec<Vec<TextItem>> = vec![Vec::new(); sheets.len()];
        let mut away: Vec<Arc<TextItem>> = Vec::new();
        let mut mouth: Option<String> = None;
        for (i, NewText { item, sheet, joins, .. }) in words.iter().enumerate() {
            if item.cue.as_ref().is_some_and(|cue| known.contains(cue)) {
                mouth = None;
                continue;
            }
            number += 1;
            let id = format!("said-{number}");
            let mut word = TextItem { id: Some(id.clone()), ..item.clone() };
            // Parts of one speech have the same speaker, even without a name. They are linked if possible.
            let parted = *joins || words.get(i + 1).is_some_and(|next| next.joins);
            if parted && word.by.is_none() {
                word.by = Some(mouth.take().filter(|_| *joins).unwrap_or(id));
            }
            mouth.clone_from(&word.by);
            match sheets.iter().position(|place| Some(place.sheet) == *sheet) {
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
        next.pages.each(&mut |place, page| {
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
            if word.photo.is_some() {
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
    pub(crate) fn without_waiting(&self, gone: &[usize]) -> Option<Self> {
        let stay =
            self.waiting.iter().enumerate().filter(|(i, _)| !gone.contains(i)).map(|(_, word)| word.clone());
        let waiting: super::project::List<TextItem> = stay.collect();
        (waiting.len() < self.waiting.len()).then(|| Self { waiting, ..self.clone() })
    }

    /// Text items move to the photo that replaces their photo.
    pub(crate) fn words_exchanged(&mut self, id: &str, by: &str) {
        let changed = |word: &TextItem| {
            let renamed = || TextItem { photo: Some(by.to_owned()), ..word.clone() };
            (word.photo.as_deref() == Some(id)).then(renamed)
        };
        self.pages.each(&mut |_, page| {
            page.words.iter().any(|word| changed(word).is_some()).then(|| {
                let words =
                    page.words.iter().map(|word| changed(word).unwrap_or_else(|| word.clone())).collect();
                Arc::new(Document { words, ..Document::clone(page) })
            })
        });
        if self.waiting.iter().any(|word| changed(word).is_some()) {
            self.waiting = self
                .waiting
                .iter()
                .map(|word| changed(word).map_or_else(|| word.clone(), Arc::new))
                .collect();
        }
    }
}
