//! Checks that a page can be drawn: its layout and style are known or valid, its panels match the layout, and
//! its text and settings are valid.

use super::invalid;
use crate::error::Result;
use crate::json::{Read, Wrong};
use crate::layout::PageSettings;
use crate::page::Document;
use crate::text::TextItem;
use crate::text_links::tie;
use serde_json::Value;
use std::sync::Arc;

/// Reads a page and checks all that is needed to draw it.
///
/// # Errors
/// Returns the location of the error.
pub fn page(value: Value) -> Read<Arc<Document>> {
    let mut page = Document::read(value)?;
    check(&page)?;
    let Document { words, panels, .. } = &mut page;
    for word in words.iter_mut() {
        tie(word, panels);
    }
    Ok(Arc::new(page))
}

/// Checks a planned page as [`page`] checks one that is read.
///
/// # Errors
/// Returns `invalid-document` with the location.
pub fn planned(page: Document) -> Result<Arc<Document>> {
    let mut page = page.validated()?;
    check(&page).map_err(|wrong| invalid(&wrong))?;
    let Document { words, panels, .. } = &mut page;
    for word in words.iter_mut() {
        tie(word, panels);
    }
    Ok(Arc::new(page))
}

/// Whether a page can be drawn.
///
/// # Errors
/// Returns the location of the error.
pub fn check(page: &Document) -> Read<()> {
    page.page.validate().map_err(Wrong::of)?;
    let template = page.template().map_err(|error| Wrong::of(error).at("layout"))?;
    page.style().map_err(|error| Wrong::of(error).at("style"))?;
    let (has, wants) = (page.panels.len(), template.panels().len());
    if has != wants {
        return Err(Wrong::new(&format!("has {has} entries, the layout has {wants} panels")).at("panels"));
    }
    Ok(())
}

/// Reads an unplaced text item.
///
/// # Errors
/// With the field that is wrong.
pub fn waiting(value: Value) -> Read<Arc<TextItem>> {
    TextItem::read(value).map(Arc::new)
}

/// Reads page settings and checks their ranges.
///
/// # Errors
/// With the field that is wrong.
pub fn settings(value: Value) -> Read<Arc<PageSettings>> {
    let page = PageSettings::read(value)?;
    page.validate().map_err(|error| Wrong::of(error).without("page."))?;
    Ok(Arc::new(page))
}
