//! Undo and redo as lists of complete states, and the page history. Undo does not remove pages from the page
//! history.

use super::limits::{GREATEST_ID, MOST_SHOWN, MOST_STEPS};
use super::project::{Parts, Project};
use super::{Dropped, leave_out};
use crate::json::{Fields, Read, Wrong};
use crate::page::Document;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// The states of a project.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(test, derive(ts_rs::TS))]
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
#[cfg_attr(test, derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Shown {
    /// Names it.
    pub id: u64,
    /// Its last state.
    pub page: Arc<Document>,
    /// The page that it was made from.
    #[cfg_attr(test, ts(optional))]
    pub from: Option<u64>,
    /// Its place in the storyboard; 0 in a project of one page.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub sheet: u64,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(test, ts(skip))]
    pub rest: Map<String, Value>,
}

impl History {
    /// Reads a history. The present state must be valid. Other invalid parts are dropped and reported.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub(super) fn read(value: Value, parts: &mut dyn Parts, dropped: &mut Dropped) -> Read<Self> {
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
pub(super) fn keep(
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
