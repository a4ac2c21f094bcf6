//! Text items and their photos: an item on a panel belongs to the photo there, and stores its id in the field
//! `photo`.

use super::page::PanelContent;
use super::text::TextItem;

/// The photo of a text item: the photo that it names, or the photo on its panel.
#[must_use]
pub fn photo_of<'a>(word: &'a TextItem, panels: &'a [PanelContent]) -> Option<&'a str> {
    word.panel?;
    word.photo.as_deref().or_else(|| on_panel(word, panels))
}

fn on_panel<'a>(word: &TextItem, panels: &'a [PanelContent]) -> Option<&'a str> {
    // If the layout has fewer panels, the text item is on the last one.
    panels.get(word.panel?).or(panels.last())?.photo.as_deref()
}

/// Stores the photo of its panel in a text item that names no photo.
pub fn tie(word: &mut TextItem, panels: &[PanelContent]) {
    if word.photo.is_none() {
        word.photo = on_panel(word, panels).map(str::to_owned);
    }
}

/// Returns the text item with the id of its photo.
#[must_use]
pub fn tied(word: &TextItem, panels: &[PanelContent]) -> TextItem {
    let mut word = word.clone();
    tie(&mut word, panels);
    word
}

/// Moves a text item to the panel that shows its photo. `None` if no panel shows it. A text item with
/// automatic placement is placed again.
#[must_use]
pub fn belongs(word: &TextItem, panels: &[PanelContent]) -> Option<TextItem> {
    let photo = word.photo.as_deref()?;
    let panel = panels.iter().position(|panel| panel.photo.as_deref() == Some(photo))?;
    let mut word = TextItem { panel: Some(panel), ..word.clone() };
    if word.auto != Some(false) {
        (word.x, word.y, word.tail, word.room) = (None, None, None, None);
    }
    Some(word)
}

/// Splits text items for panels with these photos: items with a panel, moved to the panel of their photo, and
/// items without one.
#[must_use]
pub fn carried(words: &[TextItem], panels: &[PanelContent]) -> (Vec<TextItem>, Vec<TextItem>) {
    let (mut stay, mut leave) = (Vec::new(), Vec::new());
    for word in words {
        let word = tied(word, panels);
        let named = word.panel.and(word.photo.as_deref());
        match named {
            // A photo may be on several panels. A layout with fewer panels lacks the panel of the item.
            Some(photo) if on_panel(&word, panels) != Some(photo) || word.panel >= Some(panels.len()) => {
                match belongs(&word, panels) {
                    Some(word) => stay.push(word),
                    None => leave.push(word),
                }
            }
            _ => stay.push(word),
        }
    }
    (stay, leave)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn item(value: Value) -> TextItem {
        TextItem::read(value).unwrap()
    }

    fn panels(photos: &[&str]) -> Vec<PanelContent> {
        photos
            .iter()
            .map(|&photo| PanelContent { photo: Some(photo.into()), ..PanelContent::default() })
            .collect()
    }

    #[test]
    fn a_word_goes_where_its_photo_is() {
        let word = tied(
            &item(json!({ "kind": "balloon", "text": "Hi", "panel": 1, "x": 0.2, "y": 0.3, "auto": false })),
            &panels(&["a", "b"]),
        );
        assert_eq!(word.photo.as_deref(), Some("b"));
        let (stay, leave) = carried(std::slice::from_ref(&word), &panels(&["b", "c"]));
        assert_eq!((stay[0].panel, stay[0].x, leave.len()), (Some(0), Some(0.2), 0));
        assert_eq!(carried(std::slice::from_ref(&word), &panels(&["a", "c"])).1, std::slice::from_ref(&word));
        // It does not move between two panels of one photo, and an item of the whole page does not move
        // either.
        assert_eq!(carried(std::slice::from_ref(&word), &panels(&["b", "b"])).0, std::slice::from_ref(&word));
        // With fewer panels, the panel of its photo is another one.
        let last = TextItem { panel: Some(4), ..word.clone() };
        assert_eq!(carried(&[last], &panels(&["a", "b"])).0[0].panel, Some(1));
        let page = item(json!({ "kind": "caption", "text": "Title", "photo": "a" }));
        assert_eq!(carried(std::slice::from_ref(&page), &panels(&["c"])).0, [page]);
    }

    #[test]
    fn one_that_nobody_moved_looks_for_its_place_anew() {
        let word = item(
            json!({ "kind": "balloon", "text": "Hi", "panel": 0, "photo": "b", "x": 0.2, "y": 0.3, "auto": true, "tail": { "x": 1, "y": 1 } }),
        );
        let (stay, _) = carried(&[word], &panels(&["a", "b"]));
        assert_eq!(
            stay,
            [item(json!({ "kind": "balloon", "text": "Hi", "panel": 1, "photo": "b", "auto": true }))]
        );
    }
}
