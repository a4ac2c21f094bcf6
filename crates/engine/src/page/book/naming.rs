//! Titles and places from folder names, for callers that read files.

use std::collections::HashMap;

/// Folder names of cameras, systems and programs, which do not describe the content. The app has the same list.
const EMPTY_NAMES: [&str; 34] = [
    "dcim",
    "camera",
    "camera roll",
    "download",
    "downloads",
    "desktop",
    "document",
    "documents",
    "picture",
    "pictures",
    "photo",
    "photos",
    "image",
    "images",
    "foto",
    "fotos",
    "bilder",
    "imágenes",
    "imagens",
    "descargas",
    "téléchargements",
    "ダウンロード",
    "画像",
    "写真",
    "tmp",
    "temp",
    "new folder",
    "neuer ordner",
    ".",
    "..",
    "/",
    "home",
    "users",
    "untitled folder",
];

/// A folder name that says something: trimmed, or empty.
#[must_use]
pub fn said_by(folder: &str) -> &str {
    let name = folder.trim();
    let lower = name.to_lowercase();
    let camera = lower.len() == 8
        && lower.bytes().take(3).all(|byte| byte.is_ascii_digit())
        && lower.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let numbered = ["new folder", "neuer ordner"].iter().any(|empty| lower.starts_with(empty));
    if camera || numbered || EMPTY_NAMES.contains(&lower.as_str()) { "" } else { name }
}

/// The places of photos by the names of their folders. `folders`: id of a photo, and its folder. A folder that all photos
/// share is not a place of some.
#[must_use]
pub fn places<'a>(folders: impl Iterator<Item = (&'a str, &'a str)>) -> HashMap<String, String> {
    let places: HashMap<String, String> =
        folders.map(|(photo, folder)| (photo.to_owned(), said_by(folder).to_owned())).collect();
    let mut different: Vec<&String> = places.values().collect();
    different.sort_unstable();
    different.dedup();
    if different.len() > 1 { places } else { HashMap::new() }
}

/// Adds places to photos without a place. `located`: id of a photo, and the place where it was taken.
#[allow(clippy::implicit_hasher, reason = "the map of `places`")]
pub fn add_located(places: &mut HashMap<String, String>, located: impl Iterator<Item = (String, String)>) {
    for (photo, place) in located {
        let known = places.entry(photo).or_default();
        if known.is_empty() {
            *known = place;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_cameras_say_nothing() {
        for empty in ["DCIM", " Photos ", "100CANON", "101_PANA", "New folder (2)", "画像", ""] {
            assert_eq!(said_by(empty), "", "{empty}");
        }
        assert_eq!(said_by(" Lisbon 2026 "), "Lisbon 2026");
        let told = places([("a", "Lisbon"), ("b", "DCIM")].into_iter());
        assert_eq!((told["a"].as_str(), told["b"].as_str()), ("Lisbon", ""));
        assert!(places([("a", "Lisbon"), ("b", "Lisbon")].into_iter()).is_empty());
        let mut told = told;
        let located = [("a", "Sintra"), ("b", "Sintra"), ("c", "Évora")];
        add_located(&mut told, located.into_iter().map(|(id, place)| (id.to_owned(), place.to_owned())));
        assert_eq!(["a", "b", "c"].map(|id| told[id].as_str()), ["Lisbon", "Sintra", "Évora"]);
    }
}
