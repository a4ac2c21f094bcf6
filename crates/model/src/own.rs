//! Lists that all projects share: custom styles, favourites and custom layouts.

use super::invalid;
use super::limits::{MOST_LAYOUTS, MOST_STYLES, PROJECT};
use super::project::List;
use crate::error::Result;
use crate::json::{self, Fields, Read, Writer};
use crate::reference::CustomFile;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Items of any of them.
const MOST: usize = if MOST_STYLES < MOST_LAYOUTS { MOST_STYLES } else { MOST_LAYOUTS };

/// Applies the changes between two states of a list to another state of the list.
#[must_use]
pub fn carried(
    list: &List<CustomFile>,
    before: &List<CustomFile>,
    after: &List<CustomFile>,
) -> List<CustomFile> {
    if list == before {
        return after.clone();
    }
    let was = by_id(before);
    let is: HashSet<&str> = after.iter().map(|item| item.id()).collect();
    let fresh = after.iter().filter(|item| was.get(item.id()) != Some(item));
    let gone = before.iter().filter(|item| !is.contains(item.id()));
    let touched: HashSet<&str> = fresh.clone().chain(gone).map(|item| item.id()).collect();
    if touched.is_empty() {
        return list.clone();
    }
    // A longer list could not be opened again.
    fresh.chain(list.iter().filter(|item| !touched.contains(item.id()))).take(MOST).cloned().collect()
}

/// [`carried`] of lists in JSON: `{list, before, after}`.
///
/// # Errors
/// Returns `invalid-document` if a list is invalid.
pub fn carried_json(lists: &str) -> Result<String> {
    let read = || -> Read<String> {
        let mut fields = Fields::of(json::parse(lists, PROJECT)?)?;
        let mut list = |name| {
            fields
                .list(name, usize::MAX)
                .map(|list| list.into_iter().map(CustomFile::new).map(Arc::new).collect())
        };
        let (list, before, after) = (list("list")?, list("before")?, list("after")?);
        let mut out = Writer::default();
        out.list(&carried(&list, &before, &after), &|out, item| out.value(item.json()));
        Ok(out.finish())
    };
    read().map_err(|wrong| invalid(&wrong))
}

/// The list that items make: of each id the first.
#[must_use]
pub fn first_of_each(mut items: Vec<Arc<CustomFile>>) -> List<CustomFile> {
    let mut seen = HashSet::new();
    items.retain(|item| seen.insert(item.id().to_owned()));
    items.into()
}

/// Returns the list with equal items replaced by the objects of `before`.
#[must_use]
pub fn reusing(before: &List<CustomFile>, list: &List<CustomFile>) -> List<CustomFile> {
    let known = by_id(before);
    let same = |item: &Arc<CustomFile>| known.get(item.id()).copied().filter(|known| *known == item).cloned();
    list.iter().map(|item| same(item).unwrap_or_else(|| item.clone())).collect()
}

/// Merges the lists of a project into existing lists. For equal ids the existing item stays.
#[must_use]
pub fn joined(own: &List<CustomFile>, there: &List<CustomFile>) -> List<CustomFile> {
    let known: HashSet<&str> = there.iter().map(|item| item.id()).collect();
    there.iter().chain(own.iter().filter(|item| !known.contains(item.id()))).take(MOST).cloned().collect()
}

fn by_id(list: &List<CustomFile>) -> HashMap<&str, &Arc<CustomFile>> {
    list.iter().map(|item| (item.id(), item)).collect()
}
