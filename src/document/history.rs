//! Undo and redo as lists of whole states, and the pages shown so far, which are kept even when an undo goes back before
//! them: what was loved a minute ago is never lost.

use super::limits::{GREATEST_ID, MOST_SHOWN, MOST_STEPS};
use super::project::{Parts, Project};
use super::{Dropped, leave_out};
use crate::json::{Fields, Read, Wrong, list, whole};
use crate::page::Document;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// The states of a project.
#[derive(Debug, Clone, PartialEq)]
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
pub struct Shown {
    /// Names it.
    pub id: u64,
    /// Its last state.
    pub page: Arc<Document>,
    /// The page that it was made from.
    pub from: Option<u64>,
    /// Its place in the storyboard; 0 in a project of one page.
    pub sheet: u64,
    /// Fields that this program does not know.
    pub rest: Map<String, Value>,
}

impl History {
    /// Reads a history. The present must be right; what else is not is left out and told.
    ///
    /// # Errors
    /// With the place of what is wrong.
    pub(super) fn read(value: Value, parts: &mut impl Parts, dropped: &mut Dropped) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let present = fields.required("present")?;
        let present = Project::read(present, parts).map_err(|wrong| wrong.at("present"))?;
        let mut states = |name: &str| {
            let states = fields.nullable(name, list(MOST_STEPS, Ok))?.unwrap_or_default();
            Ok(kept(states, name, dropped, |state| Project::read(state, parts).map(Arc::new)))
        };
        let (past, future) = (states("past")?, states("future")?);
        let shown = fields.nullable("shown", list(MOST_SHOWN, Ok))?.unwrap_or_default();
        let mut seen = HashSet::new();
        let shown = kept(shown, "shown", dropped, |value| {
            let shown = Shown::read(value, parts)?;
            if seen.insert(shown.id) {
                Ok(Arc::new(shown))
            } else {
                Err(Wrong::new("is that of another page").at("id"))
            }
        });
        Ok(Self { past, present: Arc::new(present), future, shown })
    }
}

impl Shown {
    fn read(value: Value, parts: &mut impl Parts) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let id = whole(0..=GREATEST_ID);
        let page = fields.required("page")?;
        Ok(Self {
            id: id(fields.required("id")?).map_err(|wrong| wrong.at("id"))?,
            page: parts.page(page).map_err(|wrong| wrong.at("page"))?,
            from: fields.nullable("from", &id)?,
            sheet: fields.nullable("sheet", &id)?.unwrap_or_default(),
            rest: fields.rest(),
        })
    }
}

/// What of a list is right; the rest is told.
pub(super) fn kept<T>(
    values: Vec<Value>,
    name: &str,
    dropped: &mut Dropped,
    mut read: impl FnMut(Value) -> Read<T>,
) -> Vec<T> {
    let one = |(i, value)| match read(value) {
        Ok(value) => Some(value),
        Err(wrong) => {
            leave_out(dropped, &wrong.in_list(i).at(name));
            None
        }
    };
    values.into_iter().enumerate().filter_map(one).collect()
}
