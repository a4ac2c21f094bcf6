//! Undo and redo as lists of complete states, and the page history. Undo does not remove pages from the page
//! history.

use super::limits::{GREATEST_ID, MOST_SHOWN, MOST_STEPS};
use super::project::{Parts, Project, Sheet};
use super::{Dropped, leave_out};
use crate::json::{Fields, Read, Wrong};
use crate::page::Document;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// The states of a project.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct History {
    /// The oldest first.
    pub past: Vec<Arc<Project>>,
    /// The state now.
    pub present: Arc<Project>,
    /// The next first.
    pub future: Vec<Arc<Project>>,
    /// The pages shown, in the order in which they came.
    pub shown: Vec<Arc<Shown>>,
}

/// A page that was shown.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Shown {
    /// Names it.
    pub id: u64,
    /// Its last state.
    pub page: Arc<Document>,
    /// The page that it was made from.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub from: Option<u64>,
    /// Its place in the storyboard; 0 in a project of one page.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub sheet: u64,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

impl History {
    /// Reads a history. The present state must be valid. Other invalid parts are dropped and reported.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub(crate) fn read(value: Value, parts: &mut dyn Parts, dropped: &mut Dropped) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let present = fields.required("present")?;
        let present = Arc::new(Project::read(present, parts).map_err(|wrong| wrong.at("present"))?);
        let (mut past, mut future, mut shown) = (Vec::new(), Vec::new(), Vec::new());
        for (name, states) in [("past", &mut past), ("future", &mut future)] {
            let told = fields.nullable(name).list(name, MOST_STEPS)?;
            keep(told, name, dropped, &mut |state| {
                states.push(Arc::new(Project::read(state, parts)?));
                Ok(())
            });
        }
        let mut seen = HashSet::new();
        keep(fields.nullable("shown").list("shown", MOST_SHOWN)?, "shown", dropped, &mut |value| {
            let page = Shown::read(value, parts)?;
            if !seen.insert(page.id) {
                return Err(Wrong::new("is a duplicate page id").at("id"));
            }
            shown.push(Arc::new(page));
            Ok(())
        });
        Ok(Self { past, present, future, shown })
    }

    /// The versions of the present page. In a project of one page, all pages of the page history.
    pub fn versions(&self) -> impl Iterator<Item = &Arc<Shown>> {
        self.shown.iter().filter(|shown| shown.sheet == self.present.sheet())
    }

    /// Index of the present page among its versions.
    #[must_use]
    pub fn position(&self) -> Option<usize> {
        self.present.page()?;
        self.versions().position(|shown| shown.id == self.present.page_id())
    }

    /// A page id that was never used, nor any above it.
    #[must_use]
    pub fn fresh_page_id(&self) -> u64 {
        self.fresh().0
    }

    /// An id for a place in the storyboard that was never used, nor any above it.
    #[must_use]
    pub fn fresh_sheet(&self) -> u64 {
        self.fresh().1
    }

    /// Both of them.
    #[must_use]
    pub fn fresh(&self) -> (u64, u64) {
        let (mut page_id, mut place) = (0, 0);
        let mut used = |id: u64, sheet: u64| (page_id, place) = (page_id.max(id), place.max(sheet));
        for shown in &self.shown {
            used(shown.id, shown.sheet);
        }
        for state in self.states() {
            used(state.page_id(), state.sheet());
            for sheet in state.sheets() {
                used(sheet.page_id, sheet.sheet);
            }
        }
        (page_id + 1, place + 1)
    }

    /// All states of all times.
    pub fn states(&self) -> impl Iterator<Item = &Arc<Project>> {
        self.past.iter().chain([&self.present]).chain(&self.future)
    }

    /// Notes the pages of the present among those shown. Stores the last state of each page. An edited page
    /// replaces its earlier state, a new one is added at the end. `from`: the page before the present one.
    pub fn note(&mut self, from: Option<u64>) {
        let present = self.present.clone();
        let sheets = present.sheets();
        for sheet in sheets {
            let from = from.filter(|_| sheet.sheet == present.sheet());
            if let Some(at) = self.shown.iter().position(|shown| shown.id == sheet.page_id) {
                let shown = &mut self.shown[at];
                if !(Arc::ptr_eq(&shown.page, &sheet.page) || *shown.page == *sheet.page)
                    || shown.sheet != sheet.sheet
                {
                    let entry = Arc::make_mut(shown);
                    (entry.page, entry.sheet) = (sheet.page.clone(), sheet.sheet);
                }
                continue;
            }
            let Sheet { page, page_id, sheet, .. } = &**sheet;
            let entry = Shown { id: *page_id, page: page.clone(), from, sheet: *sheet, rest: Map::new() };
            self.shown.push(Arc::new(entry));
            if self.shown.len() > MOST_SHOWN {
                // Favourites are never removed. Pages of the storyboard are removed only after all others.
                let stay: HashSet<u64> =
                    present.loved.iter().copied().chain(sheets.iter().map(|sheet| sheet.page_id)).collect();
                let oldest = self.shown.iter().position(|shown| !stay.contains(&shown.id));
                self.shown.remove(oldest.unwrap_or(0));
            }
        }
    }
}

impl Shown {
    fn read(value: Value, parts: &mut dyn Parts) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        Ok(Self {
            page: parts.page(fields.required("page")?).map_err(|wrong| wrong.at("page"))?,
            id: fields.count("id", 0, GREATEST_ID)?,
            from: fields.nullable("from").whole("from", 0, GREATEST_ID)?,
            sheet: fields.nullable("sheet").whole("sheet", 0, GREATEST_ID)?.unwrap_or_default(),
            rest: fields.rest(),
        })
    }
}

/// Keeps valid items; reports the others in `dropped`.
pub(crate) fn keep(
    values: Vec<Value>,
    name: &str,
    dropped: &mut Dropped,
    one: &mut dyn FnMut(Value) -> Read<()>,
) {
    for (i, value) in values.into_iter().enumerate() {
        if let Err(wrong) = one(value) {
            leave_out(dropped, &wrong.in_list(i).at(name));
        }
    }
}
