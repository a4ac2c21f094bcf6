//! The templates that ship with the program: every file of `layouts/`, embedded at build time.

use crate::order::sort_by;
use std::sync::OnceLock;

use super::template::Template;
use crate::error::{Error, Result};

include!(concat!(env!("OUT_DIR"), "/layouts.rs"));

/// All templates, sorted by family (in the order of [`FAMILIES`](super::FAMILIES)), number of panels and id.
///
/// Invalid files would be skipped, but a test reads every file.
#[must_use]
pub fn catalogue() -> &'static [Template] {
    static TEMPLATES: OnceLock<Vec<Template>> = OnceLock::new();
    TEMPLATES.get_or_init(|| {
        let parsed = LAYOUT_FILES.iter().map(|(file, json)| Template::parse(file, json));
        let mut templates: Vec<Template> = parsed.filter_map(Result::ok).collect();
        let family = |template: &Template| super::FAMILIES.iter().position(|f| *f == template.family());
        sort_by(&mut templates, |a, b| {
            let key = |t: &Template| (family(t), t.panels().len());
            key(a).cmp(&key(b)).then_with(|| a.id().cmp(b.id()))
        });
        templates
    })
}

/// The templates that are good for a page of that aspect (width over height), in the order of [`catalogue`].
#[must_use]
pub fn good_for(page_aspect: f64) -> Vec<&'static Template> {
    catalogue().iter().filter(|template| template.good_for(page_aspect)).collect()
}

/// The template of that id.
///
/// # Errors
/// `unknown-layout`.
pub fn find(id: &str) -> Result<&'static Template> {
    let found = catalogue().iter().find(|template| template.id() == id);
    found.ok_or_else(|| Error::UnknownLayout(id.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_valid_and_bears_its_id() {
        for (file, json) in LAYOUT_FILES {
            let template = Template::parse(file, json).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(format!("{}.json", template.id()), *file);
        }
        assert_eq!(catalogue().len(), LAYOUT_FILES.len());
    }

    #[test]
    fn names_are_unique() {
        for (i, template) in catalogue().iter().enumerate() {
            for other in &catalogue()[..i] {
                assert_ne!(template.name(), other.name(), "{} and {}", template.id(), other.id());
                assert_ne!(template.id(), other.id());
            }
        }
    }

    #[test]
    fn templates_are_found_by_id() {
        let first = &catalogue()[0];
        assert_eq!(find(first.id()), Ok(first));
        assert_eq!(find("no-such-layout").unwrap_err().code(), "unknown-layout");
    }
}
