//! The lists that all projects have in common: a person's own styles, favourites and layouts.

use super::limits::{MOST_LAYOUTS, MOST_STYLES};
use super::project::List;
use serde_json::Value;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Items of any of them.
const MOST: usize = if MOST_STYLES < MOST_LAYOUTS { MOST_STYLES } else { MOST_LAYOUTS };

/// What was done between two states of a list, done to another state of it.
#[must_use]
pub fn carried(list: &List<Value>, before: &List<Value>, after: &List<Value>) -> List<Value> {
    if list == before {
        return after.clone();
    }
    let was: HashMap<&str, &Value> = before.iter().map(|item| (id(item), &**item)).collect();
    let is: HashSet<&str> = after.iter().map(|item| id(item)).collect();
    let fresh = after.iter().filter(|item| was.get(id(item)) != Some(&&***item));
    let gone = before.iter().filter(|item| !is.contains(id(item)));
    let touched: HashSet<&str> = fresh.clone().chain(gone).map(|item| id(item)).collect();
    if touched.is_empty() {
        return list.clone();
    }
    // What is longer could not be opened again.
    fresh.chain(list.iter().filter(|item| !touched.contains(id(item)))).take(MOST).cloned().collect()
}

/// The list that items make: of each id the first.
#[must_use]
pub fn first_of_each(mut items: Vec<Arc<Value>>) -> List<Value> {
    let mut seen = HashSet::new();
    items.retain(|item| seen.insert(id(item).to_owned()));
    items.into()
}

/// A list with one more item, in the place of the one with its id; of more than so many the oldest go.
#[must_use]
pub fn with(list: &List<Value>, item: Value, most: usize) -> List<Value> {
    let others = list.iter().filter(|other| id(other) != id(&item)).cloned().collect::<Vec<_>>();
    std::iter::once(item.into()).chain(others).take(most).collect()
}

/// The lists of a project, joined to those that are there: of the same id the latter.
#[must_use]
pub fn joined(own: &List<Value>, there: &List<Value>) -> List<Value> {
    let known: HashSet<&str> = there.iter().map(|item| id(item)).collect();
    there.iter().chain(own.iter().filter(|item| !known.contains(id(item)))).cloned().collect()
}

fn id(item: &Value) -> &str {
    item["id"].as_str().unwrap_or_default()
}
