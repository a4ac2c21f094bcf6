//! Subject masks of the photos that are drawn.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use inkpanel_engine::detect::Segmenter;
use inkpanel_engine::page::Document;
use inkpanel_engine::raster::{Image, Matte};
use inkpanel_engine::style::Style;

use crate::detectors;
use crate::run::Run;

/// Subject masks for styles that need them: known masks by id, and detected ones. The model is loaded for the
/// first detection. Without the model the whole photo is the subject, with one warning.
pub(crate) struct Masks<'r> {
    pub(crate) run: &'r Run,
    pub(crate) known: HashMap<String, Matte>,
    pub(crate) models: Option<PathBuf>,
    /// Without detection.
    blind: bool,
    net: OnceLock<Option<Segmenter>>,
}

impl<'r> Masks<'r> {
    /// Searches the model in a folder, if given.
    pub(crate) fn new(run: &'r Run, known: HashMap<String, Matte>, models: Option<&Path>) -> Self {
        Self { run, known, models: models.map(Path::to_path_buf), blind: false, net: OnceLock::new() }
    }

    /// Disables detection if `detect` is false: the whole photo is the subject if its mask is unknown.
    pub(crate) fn detecting(self, detect: bool) -> Self {
        Self { blind: !detect, ..self }
    }

    /// Subject mask of a photo, at any size of at least 320 pixels. `None` if the style does not need it.
    pub(crate) fn asked_by(&self, style: &Style, id: &str, photo: &Image) -> Option<Matte> {
        if style.has_parts() { self.of(id, photo) } else { None }
    }

    /// Like `asked_by` for a page, whose effects may be behind a subject as well.
    pub(crate) fn asked_by_page(
        &self,
        page: &Document,
        style: &Style,
        id: &str,
        photo: &Image,
    ) -> Option<Matte> {
        if page.fronts().is_empty() { self.asked_by(style, id, photo) } else { self.of(id, photo) }
    }

    fn of(&self, id: &str, photo: &Image) -> Option<Matte> {
        if let Some(known) = self.known.get(id) {
            return Some(known.clone());
        }
        if self.blind {
            return None;
        }
        let load = || match detectors::load_segmenter(self.models.as_deref()) {
            Ok(net) => Some(net),
            Err(why) => {
                self.run.report.note(None, &format!("{why}; the whole photo counts as the subject"));
                None
            }
        };
        let looked = self.net.get_or_init(load).as_ref()?.look(photo);
        looked.map_err(|error| self.run.report.note(None, &error.to_string())).ok()
    }
}
