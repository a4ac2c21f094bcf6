//! The editor of a project: applies edits, with undo and redo.

use super::carrying_out::{Obstacles, Outcome, obstacles};
use super::edit::{Edit, How, Shelf, Without};
use super::history::History;
use super::intent::Intent;
use super::limits::{MOST_STEPS, PROJECT};
use super::planning::{Known, Planning};
use super::project::{List, Project, Sheet};
use super::{invalid, kept, own, validation};
use crate::error::{Error, Result};
use crate::json;
use crate::layout::PageSettings;
use crate::page::{CustomFile, Document};
use std::collections::HashMap;
use std::sync::Arc;

/// A history that grows, and the edit that its last step belongs to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Editor {
    history: History,
    gesture: Option<String>,
}

impl Editor {
    /// Creates an editor with a history.
    #[must_use]
    pub fn new(history: History) -> Self {
        Self { history, gesture: None }
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
        let turns = How { silent: true, gesture: None };
        let edits = match self.outcome(intent, photos)? {
            None => return Ok(false),
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
                let mut changed = false;
                if at != self.project().pages.active() {
                    changed |=
                        self.apply(&Edit::SetSheets { sheets: self.project().sheets().to_vec(), at }, &turns);
                }
                return Ok(
                    page.is_some_and(|page| self.apply(&Edit::ShowPage { page, page_id }, how)) || changed
                );
            }
        };
        let mut changed = false;
        for (i, edit) in edits.iter().enumerate() {
            changed |= self.apply(edit, if i == 0 { how } else { &turns });
        }
        Ok(changed)
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
        if let Edit::Plan(intent) = &edit {
            self.carry_out(intent, &how, photos()?)?;
        } else {
            self.apply(&edit, &how);
        }
        Ok(kept::difference(&self.history, &before))
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
