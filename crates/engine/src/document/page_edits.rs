//! Edits of planned pages by programs: the command line, the public API and its Python package. The app applies
//! the same edits to projects.

use super::edit::{Edit, How};
use super::editor::Editor;
use super::history::History;
use super::invalid;
use super::limits::{MOST_STEPS, PROJECT};
use super::planning::Known;
use super::project::{Pages, Project, Sheet, TrayItem};
use crate::error::Result;
use crate::framing::PhotoMeta;
use crate::json::{self, Read, Wrong, items};
use crate::page::Document;
use serde_json::{Map, Value};
use std::sync::Arc;

/// Fields of edits that contain ids of photos.
const PHOTO_FIELDS: [&str; 6] = ["photo", "photos", "id", "ids", "by", "alike"];

/// Pages after edits.
#[derive(Debug, Clone)]
pub struct Edited {
    /// The pages in reading order.
    pub pages: Vec<Document>,
    /// Indices of the edits that changed nothing, for example of a locked panel.
    pub unchanged: Vec<usize>,
}

/// Reads edits from a JSON array of objects with a `type`. The edits themselves are checked by [`apply`].
///
/// # Errors
/// `invalid-document` with the location.
pub fn parse(edits: &str) -> Result<Vec<Value>> {
    let list = json::parse(edits, PROJECT).and_then(|value| items(value, MOST_STEPS));
    list.map_err(|wrong| invalid(&wrong.at("edits")))
}

/// Applies edits to pages, one after the other. The first page is the current page. `photos` are the photos in
/// use, in their order. `id_of` returns the id of a photo by the name that the edits have.
///
/// # Errors
/// `invalid-document` with the location, such as `edits[2].panel`; the errors of the planner.
pub fn apply(
    pages: Vec<Document>,
    photos: &[PhotoMeta],
    edits: &[Value],
    id_of: &dyn Fn(&str) -> Option<String>,
) -> Result<Edited> {
    let known: Vec<Known> = photos.iter().map(|meta| Known { meta, place: None }).collect();
    let mut editor = Editor::new(History { present: Arc::new(project(pages, photos)), ..History::default() });
    let mut unchanged = Vec::new();
    for (i, edit) in edits.iter().enumerate() {
        let located = |wrong: Wrong| invalid(&wrong.in_list(i).at("edits"));
        let (edit, how) = read(edit.clone(), &editor, id_of).map_err(located)?;
        let changed = match &edit {
            Edit::Plan(intent) => editor.carry_out(intent, &how, known.clone())?,
            edit => editor.apply(edit, &how),
        };
        if !changed {
            unchanged.push(i);
        }
    }
    let pages = editor.project().sheets().iter().map(|sheet| Document::clone(&sheet.page)).collect();
    Ok(Edited { pages, unchanged })
}

/// A project of these pages and photos.
fn project(pages: Vec<Document>, photos: &[PhotoMeta]) -> Project {
    let tray = photos
        .iter()
        .map(|photo| Arc::new(TrayItem { starred: photo.starred, ..TrayItem::new(photo.id.clone()) }));
    let mut project = Project { tray: tray.collect(), ..Project::default() };
    let sheet = |(i, page): (u64, Document)| {
        Arc::new(Sheet { page: Arc::new(page), page_id: i + 1, sheet: i, rest: Map::new() })
    };
    if let Some(pages) = Pages::new((0..).zip(pages).map(sheet).collect(), 0) {
        project.pages = pages;
        project.follow_paper();
    }
    project
}

fn read(mut edit: Value, editor: &Editor, id_of: &dyn Fn(&str) -> Option<String>) -> Read<(Edit, How)> {
    for field in PHOTO_FIELDS {
        match edit.get_mut(field) {
            Some(Value::Array(names)) => names.iter_mut().for_each(|name| rename(name, id_of)),
            Some(name) => rename(name, id_of),
            None => {}
        }
    }
    Edit::read(edit, &|id| editor.page(id))
}

fn rename(name: &mut Value, id_of: &dyn Fn(&str) -> Option<String>) {
    if let Some(id) = name.as_str().and_then(id_of) {
        *name = id.into();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::planning::Planning;
    use serde_json::json;

    fn photos() -> Vec<PhotoMeta> {
        (0..6).map(|i| PhotoMeta::unmeasured(&format!("photo-{i}"), 600, 400)).collect()
    }

    fn page(photos: &[PhotoMeta]) -> Document {
        let project = Project::default();
        let planning = Planning::new(&project, photos);
        let mut request = planning.request(1);
        request.panels = Some(3);
        planning.plan(request, None).unwrap().unwrap()
    }

    fn shown(page: &Document) -> Vec<&str> {
        page.panels.iter().filter_map(|panel| panel.photo.as_deref()).collect()
    }

    #[test]
    fn edits_change_pages_in_their_order() {
        let photos = photos();
        let page = page(&photos);
        let before = shown(&page);
        let edits = json!([
            { "type": "swap-panels", "panel": 0, "with": 2 },
            { "type": "place-photo", "panel": 1, "photo": "five.jpg" },
            { "type": "choose-style", "style": "noir", "seed": 1 },
            { "type": "add-page", "draw": { "seed": 2 } },
        ]);
        let id_of = |name: &str| (name == "five.jpg").then(|| "photo-5".to_owned());
        let edited = apply(vec![page.clone()], &photos, &parse(&edits.to_string()).unwrap(), &id_of).unwrap();
        assert_eq!(edited.unchanged, [0; 0]);
        assert_eq!(edited.pages.len(), 2);
        assert_eq!(shown(&edited.pages[0]), [before[2], "photo-5", before[0]]);
        assert_eq!(edited.pages[0].style.id(), Some("noir"));
    }

    #[test]
    fn an_edit_that_changes_nothing_is_reported() {
        let photos = photos();
        let edits = json!([
            { "type": "lock-panel", "panel": 0, "on": true },
            { "type": "swap-panels", "panel": 0, "with": 1 },
        ]);
        let edited =
            apply(vec![page(&photos)], &photos, &parse(&edits.to_string()).unwrap(), &|_| None).unwrap();
        assert_eq!(edited.unchanged, [1]);
    }

    #[test]
    fn an_invalid_edit_has_a_location() {
        let photos = photos();
        let fails = |edits: Value| {
            let parsed = parse(&edits.to_string());
            parsed
                .and_then(|edits| apply(vec![page(&photos)], &photos, &edits, &|_| None))
                .unwrap_err()
                .to_string()
        };
        for (edits, location) in [
            (json!({}), "edits: must be a list"),
            (json!([{ "type": "undo" }, 7]), "edits[1]: must be an object"),
            (json!([{ "type": "swap" }]), "edits[0].type: is not a known edit"),
            (json!([{ "type": "swap-panels", "panel": "a", "with": 1 }]), "edits[0]: must be a whole number"),
        ] {
            let message = fails(edits);
            assert!(message.contains(location), "{message}");
        }
    }
}
