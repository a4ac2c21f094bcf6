//! The designed styles that ship in `styles/`, read at build time.

use super::file::Style;
use crate::error::{Error, Result};
use crate::order::sort_by_key;
use std::sync::OnceLock;

/// The families in the order in which the page shows them, from ink to prints. A style's family is its first tag.
pub const FAMILIES: [&str; 14] = [
    "ink",
    "noir",
    "manga",
    "comic",
    "pop",
    "halftone",
    "sketch",
    "hatch",
    "woodcut",
    "watercolour",
    "vintage",
    "duotone",
    "blueprint",
    "paper",
];

/// Ids of removed styles in saved projects, each with the style that replaces it.
const REMOVED: [(&str, &str); 1] = [("painter-ornament", "painter-scent")];

include!(concat!(env!("OUT_DIR"), "/styles.rs"));

/// All designed styles in the order of their file names. A test parses every file; one that does not parse
/// is left out here.
#[must_use]
pub fn catalogue() -> &'static [Style] {
    static STYLES: OnceLock<Vec<Style>> = OnceLock::new();
    STYLES
        .get_or_init(|| STYLE_FILES.iter().filter_map(|(file, json)| Style::parse(file, json).ok()).collect())
}

/// All designed styles, family by family.
#[must_use]
pub fn by_family() -> Vec<&'static Style> {
    let family = |style: &Style| {
        FAMILIES.iter().position(|family| style.tags.first().is_some_and(|tag| tag == family))
    };
    let mut styles: Vec<&Style> = catalogue().iter().collect();
    // Styles without a family come last.
    sort_by_key(&mut styles, |style| family(style).unwrap_or(FAMILIES.len()));
    styles
}

/// The designed style with this id, or the style that replaces a removed one.
///
/// # Errors
/// `unknown-style`.
pub fn find(id: &str) -> Result<&'static Style> {
    let id = REMOVED.iter().find(|(removed, _)| *removed == id).map_or(id, |(_, successor)| successor);
    catalogue().iter().find(|style| style.id == id).ok_or_else(|| Error::UnknownStyle(id.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_parses_and_is_called_like_its_id() {
        for (file, json) in STYLE_FILES {
            let style = Style::parse(file, json).unwrap();
            assert_eq!(*file, format!("{}.json", style.id));
            assert!(!style.tags.is_empty(), "{file} has no family");
        }
        assert_eq!(catalogue().len(), STYLE_FILES.len());
    }

    #[test]
    fn removed_styles_have_successors() {
        for (removed, successor) in REMOVED {
            assert_eq!(find(removed).unwrap().id, successor);
            assert!(catalogue().iter().all(|style| style.id != removed));
        }
    }
}
