//! The editor of a project: applies edits, with undo and redo.

use super::carrying_out::{Obstacles, Outcome, obstacles};
use super::edit::{Edit, How, Shelf, Without};
use super::history::History;
use super::intent::Intent;
use super::kept::Told;
use super::limits::{MOST_STEPS, PROJECT};
use super::planning::{Known, Planning};
use super::project::{List, Project, Sheet};
use super::{Dropped, invalid, kept, own, validation};
use crate::error::{Error, Result};
use crate::json::{self, Read, Wrong, items};
use crate::layout::PageSettings;
use crate::page::{CustomFile, Document};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Maximum number of changes in a journal, and of edits in a change.
const MOST_CHANGES: usize = 10_000;

/// A history that grows, and the edit that its last step belongs to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Editor {
    history: History,
    gesture: Option<String>,
    series: Option<Box<Series>>,
}

/// The last changes, if they are of one gesture, or silent. A later one may include them.
#[derive(Debug, Clone, PartialEq)]
struct Series {
    /// The editor before them.
    before: Editor,
    /// `None` if they are silent.
    gesture: Option<String>,
    count: usize,
}

impl Editor {
    /// Creates an editor with a history.
    #[must_use]
    pub fn new(history: History) -> Self {
        Self { history, ..Self::default() }
    }

    /// Reads the output of [`Editor::save`], and applies the changes of a journal that were made since: a list of
    /// lists of edits in JSON, or an empty text. A list without edits ends the gesture.
    ///
    /// Returns the dropped parts as well.
    ///
    /// # Errors
    /// `damaged-project`, `newer-project` or `too-large-project` for the history. `invalid-document` for an
    /// invalid journal. It contains no intents, because they depend on measurements of photos.
    pub fn load(text: &str, journal: &str) -> Result<(Self, Dropped)> {
        let (history, gesture, dropped) = kept::parse_saved(text)?;
        let mut editor = Self { history, gesture, series: None };
        if !journal.is_empty() {
            editor.replay(journal).map_err(|wrong| invalid(&wrong))?;
        }
        // After loading, names of gestures are used again.
        editor.gesture = None;
        Ok((editor, dropped))
    }

    fn replay(&mut self, journal: &str) -> Read<()> {
        for change in items(json::parse(journal, PROJECT)?, MOST_CHANGES)? {
            let edits = items(change, MOST_CHANGES)?;
            if edits.is_empty() {
                self.gesture = None;
            }
            for edit in edits {
                let (edit, how) = Edit::read(edit, &|id| self.page(id))?;
                if matches!(edit, Edit::Plan(_)) {
                    return Err(Wrong::new("is an intent"));
                }
                self.apply(&edit, &how);
            }
        }
        Ok(())
    }

    /// Writes the history and the gesture of the last edit. Later changes include none of those before.
    pub fn save(&mut self) -> String {
        self.series = None;
        kept::write_saved(&self.history, self.gesture.as_deref(), &Vec::new())
    }

    /// All states, and the pages shown.
    #[must_use]
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The state now.
    #[must_use]
    pub fn project(&self) -> &Project {
        &self.history.present
    }

    /// Does something.
    ///
    /// Returns whether anything changed.
    pub fn apply(&mut self, edit: &Edit, how: &How) -> bool {
        match edit {
            Edit::Undo => return self.undo(),
            Edit::Redo => return self.redo(),
            Edit::Share { lists } => return self.share(lists),
            Edit::Join { lists } => {
                let all = |(shelf, list): &(Shelf, _)| (*shelf, own::joined(shelf.of(self.project()), list));
                return self.share(&lists.iter().map(all).collect::<Vec<_>>());
            }
            Edit::ForgetPhotos { ids } => return self.forget(ids),
            _ => {}
        }
        let history = &mut self.history;
        let Some(next) = history.present.after(edit) else { return false };
        let before = std::mem::replace(&mut history.present, Arc::new(next));
        if *edit == Edit::NoPage && how.silent {
            // A first page without readable photos does not count.
            history.shown.retain(|shown| shown.id != before.page_id());
            return true;
        }
        let same = before.page().is_some() && before.sheet() == history.present.sheet();
        history.note(same.then_some(before.page_id()));
        if how.silent {
            return true;
        }
        let joins = how.gesture.is_some() && how.gesture == self.gesture;
        if !joins {
            history.past.push(before);
            let over = history.past.len().saturating_sub(MOST_STEPS);
            history.past.drain(..over);
        }
        history.future.clear();
        self.gesture.clone_from(&how.gesture);
        true
    }

    /// Plans the result of an intent from the photos in use, and applies it.
    ///
    /// Returns whether anything changed.
    ///
    /// # Errors
    /// Errors of [`Planning::carry_out`], and `invalid-document` for values out of range, without any change.
    pub fn carry_out(&mut self, intent: &Intent, how: &How, photos: Vec<Known>) -> Result<bool> {
        let edits = self.planned(intent, how, photos)?;
        Ok(self.apply_all(&edits))
    }

    fn apply_all(&mut self, edits: &[(Edit, How)]) -> bool {
        let mut changed = false;
        for (edit, how) in edits {
            changed |= self.apply(edit, how);
        }
        changed
    }

    /// The edits that carry out an intent.
    fn planned(&self, intent: &Intent, how: &How, photos: Vec<Known>) -> Result<Vec<(Edit, How)>> {
        let turns = How { silent: true, gesture: None };
        let edits = match self.outcome(intent, photos)? {
            None => Vec::new(),
            Some(Outcome::Shown(page)) if !how.silent => {
                let page_id = self.history.fresh_page_id();
                vec![Edit::ShowPage { page: validation::planned(page)?, page_id }]
            }
            // Without an undo step, the page stays the same version.
            Some(Outcome::Changed(page) | Outcome::Shown(page)) => {
                vec![Edit::ChangePage { page: validation::planned(page)? }]
            }
            Some(Outcome::Sheets(sheets, at)) => vec![Edit::SetSheets { sheets, at }],
            Some(Outcome::Paper(settings, made)) => self.on_paper(settings, made)?,
            Some(Outcome::NoPage) => vec![Edit::NoPage],
            Some(Outcome::Version { page, page_id, at }) => {
                let turn = (at != self.project().pages.active())
                    .then(|| Edit::SetSheets { sheets: self.project().sheets().to_vec(), at });
                let shown = page.map(|page| (Edit::ShowPage { page, page_id }, how.clone()));
                return Ok(turn.map(|turn| (turn, turns)).into_iter().chain(shown).collect());
            }
        };
        let how = |i| if i == 0 { how.clone() } else { turns.clone() };
        Ok(edits.into_iter().enumerate().map(|(i, edit)| (edit, how(i))).collect())
    }

    /// Applies the edits of one change.
    ///
    /// Returns the number of earlier changes that it includes. A journal needs this one in place of them.
    fn change(&mut self, edits: &[(Edit, How)], how: &How) -> usize {
        let before = Self { history: self.history.clone(), gesture: self.gesture.clone(), series: None };
        if !self.apply_all(edits) {
            return 0;
        }
        let gesture = how.gesture.clone().filter(|_| !how.silent);
        let last = self.series.take();
        let Some(mut series) = last.filter(|last| how.silent || gesture.is_some() && gesture == last.gesture)
        else {
            let starts = how.silent || gesture.is_some();
            self.series = starts.then(|| Box::new(Series { before, gesture, count: 1 }));
            return 0;
        };
        let mut alone = series.before.clone();
        alone.apply_all(edits);
        let includes = alone.gesture == self.gesture && kept::same_history(&alone.history, &self.history);
        let count = if includes { std::mem::take(&mut series.count) } else { 0 };
        series.count += 1;
        self.series = Some(series);
        count
    }

    /// The edits that change the page settings and pages, each with its index in the storyboard.
    fn on_paper(&self, settings: PageSettings, made: Vec<(usize, Document)>) -> Result<Vec<Edit>> {
        let at = self.project().pages.active();
        let mut sheets = self.project().sheets().to_vec();
        let several = made.len() > 1;
        for (place, page) in made {
            sheets[place] =
                Arc::new(Sheet { page: validation::planned(page)?, ..Sheet::clone(&sheets[place]) });
        }
        let page = sheets.get(at).map(|sheet| sheet.page.clone());
        let mut edits = vec![Edit::ChangeSettings { settings: Arc::new(settings), page }];
        edits.extend(several.then_some(Edit::SetSheets { sheets, at }));
        Ok(edits)
    }

    /// Returns the page in JSON that an intent in JSON would make the current page, or null if the page stays.
    ///
    /// # Errors
    /// As [`Editor::apply_json_with`].
    pub fn preview_json(&self, edit: &str, photos: Vec<Known>) -> Result<String> {
        let read = json::parse(edit, PROJECT).and_then(|value| Edit::read(value, &|_| None));
        let (Edit::Plan(intent), _) = read.map_err(|wrong| invalid(&wrong))? else {
            return Ok("null".into());
        };
        let page = match self.outcome(&intent, photos)? {
            None | Some(Outcome::NoPage | Outcome::Version { .. }) => return Ok("null".into()),
            Some(Outcome::Changed(page) | Outcome::Shown(page)) => validation::planned(page)?,
            Some(Outcome::Sheets(sheets, at)) => sheets[at].page.clone(),
            Some(Outcome::Paper(_, made)) => {
                match made.into_iter().find(|(at, _)| *at == self.project().pages.active()) {
                    Some((_, page)) => validation::planned(page)?,
                    None => return Ok("null".into()),
                }
            }
        };
        Ok(page.to_json())
    }

    /// Returns why some panels of the current page cannot be merged or joined: [`Obstacles`] in JSON.
    ///
    /// # Errors
    /// `invalid-document` for an invalid list, and errors of [`obstacles`].
    pub fn obstacles_json(&self, panels: &str) -> Result<String> {
        let panels: Vec<usize> = json::plain(panels, "panels")?;
        let page = self.project().page();
        let found = page.map_or_else(|| Ok(Obstacles::default()), |page| obstacles(page, &panels))?;
        serde_json::to_string(&found).map_err(|error| Error::Encode(error.to_string()))
    }

    fn outcome(&self, intent: &Intent, photos: Vec<Known>) -> Result<Option<Outcome>> {
        let planning =
            Planning { project: self.project(), photos, taste: intent.taste(), recent: Vec::new() };
        planning.with_memory(&self.history).carry_out(intent, &self.history)
    }

    /// Applies an edit in JSON, see [`Edit::read`]. Intents are planned without photos, so most change nothing.
    ///
    /// Returns the changes, see [`kept::difference`].
    ///
    /// # Errors
    /// As [`Editor::apply_json_with`].
    pub fn apply_json(&mut self, edit: &str) -> Result<String> {
        self.apply_json_with(edit, &|| Ok(Vec::new()))
    }

    /// Applies an edit in JSON, see [`Edit::read`]. `photos` returns the photos in use, in their order.
    ///
    /// Returns the changes, see [`kept::difference`].
    ///
    /// # Errors
    /// Returns `invalid-document` for an invalid edit, and errors of [`Editor::carry_out`], without any change.
    pub fn apply_json_with<'p>(
        &mut self,
        edit: &str,
        photos: &dyn Fn() -> Result<Vec<Known<'p>>>,
    ) -> Result<String> {
        let read = json::parse(edit, PROJECT).and_then(|value| Edit::read(value, &|id| self.page(id)));
        let (edit, how) = read.map_err(|wrong| invalid(&wrong))?;
        let before = self.history.clone();
        let is_intent = matches!(edit, Edit::Plan(_));
        let edits = match edit {
            Edit::Plan(intent) => self.planned(&intent, &how, photos()?)?,
            edit => vec![(edit, how.clone())],
        };
        let includes = self.change(&edits, &how);
        let told = Told { edits: if is_intent { &edits[..] } else { &[] }, includes, dropped: &[] };
        Ok(kept::difference(&self.history, &before, &told))
    }

    /// Returns the ids of all photos of the states and the page history, in JSON.
    #[must_use]
    pub fn photos_json(&self) -> String {
        let history = &self.history;
        let states = || [&history.present].into_iter().chain(&history.past).chain(&history.future);
        let sheets = states().flat_map(|state| state.sheets()).map(|sheet| &sheet.page);
        // Most states share their tray and their pages.
        let mut seen = HashSet::new();
        let mut ids: Vec<&str> = Vec::new();
        for tray in states().map(|state| &state.tray) {
            if seen.insert(tray.as_ptr().addr()) {
                ids.extend(tray.iter().map(|item| item.id.as_str()));
            }
        }
        for page in sheets.chain(history.shown.iter().map(|shown| &shown.page)) {
            if seen.insert(Arc::as_ptr(page).addr()) {
                ids.extend(page.panels.iter().filter_map(|content| content.photo.as_deref()));
            }
        }
        let mut known = HashSet::new();
        ids.retain(|id| known.insert(*id));
        let mut out = json::Writer::default();
        out.list(&ids, &|out, id| out.text(id));
        out.finish()
    }

    /// Returns the page with this id from the storyboard or the page history, or `None`.
    #[must_use]
    pub fn page(&self, id: u64) -> Option<Arc<Document>> {
        let sheets = self.history.present.sheets();
        let sheet = sheets.iter().find(|sheet| sheet.page_id == id).map(|sheet| sheet.page.clone());
        sheet.or_else(|| {
            self.history.shown.iter().find(|shown| shown.id == id).map(|shown| shown.page.clone())
        })
    }

    fn undo(&mut self) -> bool {
        let history = &mut self.history;
        let Some(before) = history.past.pop() else { return false };
        history.future.insert(0, std::mem::replace(&mut history.present, before));
        history.note(None);
        self.gesture = None;
        true
    }

    fn redo(&mut self) -> bool {
        let history = &mut self.history;
        if history.future.is_empty() {
            return false;
        }
        let next = history.future.remove(0);
        history.past.push(std::mem::replace(&mut history.present, next));
        history.note(None);
        self.gesture = None;
        true
    }

    /// Removes an unreadable photo from all states, so no undo restores it.
    fn forget(&mut self, ids: &[String]) -> bool {
        // Keeps the old parts alive, so that no new part gets the address of an old one.
        let was = self.history.clone();
        let history = &mut self.history;
        let mut without = Without::new(ids);
        let mut changed = false;
        for state in history.past.iter_mut().chain(&mut history.future).chain([&mut history.present]) {
            if let Some(next) = without.state(state) {
                *state = Arc::new(next);
                changed = true;
            }
        }
        for shown in &mut history.shown {
            if let Some(page) = without.page(&shown.page) {
                Arc::make_mut(shown).page = page;
                changed = true;
            }
        }
        // A step that only added such photos is removed.
        while !Arc::ptr_eq(&history.present, &was.present)
            && history.past.last().is_some_and(|last| *last == history.present)
        {
            history.past.pop();
        }
        changed
    }

    /// Applies changes of shared lists by another project or tab to every state, so that undo does not revert
    /// them.
    fn share(&mut self, lists: &[(Shelf, List<CustomFile>)]) -> bool {
        let history = &mut self.history;
        let present = history.present.clone();
        let news: Vec<_> = lists.iter().filter(|(shelf, list)| list != shelf.of(&present)).collect();
        for (shelf, list) in &news {
            // A list that many states share stays shared.
            let mut made: HashMap<usize, List<CustomFile>> = HashMap::new();
            let states = history.past.iter_mut().chain(&mut history.future).chain([&mut history.present]);
            for state in states {
                let was = shelf.of(state).clone();
                let is = made
                    .entry(was.as_ptr().addr())
                    .or_insert_with(|| own::carried(&was, shelf.of(&present), list))
                    .clone();
                *shelf.of_mut(Arc::make_mut(state)) = is;
            }
        }
        !news.is_empty()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;
    use serde_json::{Value, json};

    /// Applies edits; returns how many earlier changes each includes.
    fn played(editor: &mut Editor, edits: &Value) -> Vec<u64> {
        let edits = edits.as_array().unwrap();
        let told = edits.iter().map(|edit| editor.apply_json(&edit.to_string()).unwrap());
        let told = told.map(|told| serde_json::from_str::<Value>(&told).unwrap());
        told.map(|told| told["includes"].as_u64().unwrap()).collect()
    }

    #[test]
    fn a_saved_editor_goes_on_with_a_journal() {
        let mut editor = Editor::default();
        let before = json!([
            { "type": "add-photos", "ids": ["a", "b"] },
            { "type": "rename", "name": "One", "gesture": "g" },
        ]);
        played(&mut editor, &before);
        let saved = editor.save();
        let edits = json!([
            { "type": "rename", "name": "Two", "gesture": "g" },
            { "type": "star-photo", "id": "a", "on": true },
            { "type": "star-photo", "id": "b", "on": true, "silent": true },
            { "type": "undo" },
        ]);
        played(&mut editor, &edits);
        let journal = json!([[edits[0], edits[1]], [edits[2]], [edits[3]]]);
        let (again, dropped) = Editor::load(&saved, &journal.to_string()).unwrap();
        assert_eq!((again.history(), dropped.len()), (editor.history(), 0));
        // The first edit continues the gesture that was saved. After loading, no gesture is continued.
        let (mut again, _) = Editor::load(&saved, "").unwrap();
        let steps = again.history().past.len();
        played(&mut again, &json!([edits[0]]));
        assert_eq!(again.history().past.len(), steps + 1);
        let (ended, _) = Editor::load(&saved, &json!([[], [edits[0]]]).to_string()).unwrap();
        assert_eq!(ended.history(), again.history());
        for wrong in [
            json!([[{ "type": "recrop" }]]),
            json!([[{ "type": "fly" }]]),
            json!([{ "type": "undo" }]),
            json!([[7]]),
            json!({}),
        ] {
            assert_eq!(Editor::load(&saved, &wrong.to_string()).unwrap_err().code(), "invalid-document");
        }
        assert_eq!(Editor::load("{}", "").unwrap_err().code(), "damaged-project");
    }

    #[test]
    fn a_later_change_of_a_gesture_includes_earlier_ones_only_if_it_alone_gives_the_same_history() {
        let mut editor = Editor::default();
        let named = |name: &str, gesture: &str| json!({ "type": "rename", "name": name, "gesture": gesture });
        let star = |id: &str| json!({ "type": "star-photo", "id": id, "on": true, "gesture": "g" });
        let silent = |name: &str| json!({ "type": "rename", "name": name, "silent": true });
        let edits = json!([
            { "type": "add-photos", "ids": ["a", "b"] },
            named("One", "g"), named("Two", "g"), silent("Three"), named("Four", "g"), named("Four", "g"),
            star("a"), star("b"), named("Five", "h"), named("Six", "h"), { "type": "undo" }, named("Seven", "h"),
            silent("Eight"), { "type": "lock", "part": "style", "on": true }, silent("Nine"), silent("Ten"),
        ]);
        assert_eq!(played(&mut editor, &edits), [0, 0, 1, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1]);
        // A journal begins after a save.
        played(&mut editor, &json!([named("One", "g")]));
        editor.save();
        assert_eq!(played(&mut editor, &json!([named("Two", "g"), named("Three", "g")])), [0, 1]);
    }

    #[test]
    fn photos_of_all_times_are_told_once() {
        let mut editor = Editor::default();
        let edits = json!([
            { "type": "add-photos", "ids": ["a", "b"] },
            { "type": "remove-photos", "ids": ["a"] },
            { "type": "add-photos", "ids": ["c"] },
            { "type": "undo" },
        ]);
        played(&mut editor, &edits);
        assert_eq!(editor.photos_json(), r#"["b","a","c"]"#);
    }
}
