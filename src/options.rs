//! Options of pages.

use crate::failure::Failure;
use crate::style::Style;
use inkpanel_engine::document::page_edits;
use inkpanel_engine::layout::{PageSettings, PaperSize, SETTINGS};
use inkpanel_engine::page::catalogue;
use inkpanel_engine::page::request::{Families, Request};
use inkpanel_engine::page::storyboard::Choice;
use inkpanel_engine::page::words::TextItem;
use inkpanel_engine::page::{LayoutRef, StyleRef};
use serde_json::Value;
use std::collections::HashMap;

/// The most pages that an album is cut into, as on the command line.
const MOST_PAGES: usize = 1_000;

/// Ids of all page templates, each with its number of panels.
pub fn layouts() -> impl Iterator<Item = (&'static str, usize)> {
    catalogue::layouts().into_iter().map(|layout| (layout.id, layout.panels.len()))
}

/// Names of the page settings for [`PageOptions::setting`], each with its help text.
pub fn page_settings() -> impl Iterator<Item = (String, &'static str)> {
    SETTINGS.into_iter().map(|setting| (setting.name.replace('-', "_"), setting.help))
}

/// Options of pages. Default: A4 portrait at 300 DPI, all photos that pass selection, layout and style chosen
/// by photos and seed.
#[derive(Debug, Clone)]
pub struct PageOptions {
    seed: u32,
    panels: Option<usize>,
    merge: bool,
    layout: Option<LayoutRef>,
    style: Option<Style>,
    families: Families,
    figures: Option<bool>,
    page: PageSettings,
    pub(crate) choice: Choice,
    pub(crate) words: Vec<TextItem>,
    pub(crate) edits: Vec<Value>,
}

/// Options of a book, in addition to the options of its pages. Default: a title from the places or days of
/// the photos, English captions, one style, as many pages as the photos need.
#[derive(Debug, Clone, Default)]
pub struct BookOptions {
    pub(crate) title: String,
    pub(crate) language: String,
    pub(crate) pages: Option<usize>,
    pub(crate) by_chapter: bool,
    pub(crate) places: Option<HashMap<String, String>>,
}

impl BookOptions {
    /// As [`Self::default`].
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Title on the cover.
    #[must_use]
    pub fn title(mut self, title: &str) -> Self {
        title.clone_into(&mut self.title);
        self
    }

    /// Language of the captions, such as `en` or `pt-BR`.
    #[must_use]
    pub fn language(mut self, language: &str) -> Self {
        language.clone_into(&mut self.language);
        self
    }

    /// Number of pages with cover and end page, from 3 to 1000.
    #[must_use]
    pub fn pages(mut self, pages: usize) -> Self {
        self.pages = Some(pages);
        self
    }

    /// Places of photos by id. By default, the folders of photos are places.
    #[doc(hidden)]
    #[must_use]
    pub fn places(mut self, places: HashMap<String, String>) -> Self {
        self.places = Some(places);
        self
    }

    /// Whether each day has its own style.
    #[must_use]
    pub fn style_by_chapter(mut self, on: bool) -> Self {
        self.by_chapter = on;
        self
    }
}

impl Default for PageOptions {
    fn default() -> Self {
        Self {
            seed: 1,
            panels: None,
            merge: false,
            layout: None,
            style: None,
            families: Families::default(),
            figures: None,
            page: PageSettings::default(),
            choice: Choice::default(),
            words: Vec::new(),
            edits: Vec::new(),
        }
    }
}

impl PageOptions {
    /// As [`Self::default`], with 1 as the seed.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Random seed. Another seed gives another page.
    #[must_use]
    pub fn seed(mut self, seed: u32) -> Self {
        self.seed = seed;
        self
    }

    /// Number of panels of a page, if no layout is set.
    #[must_use]
    pub fn panels(mut self, panels: usize) -> Self {
        self.panels = Some(panels);
        self
    }

    /// Whether panels may share one photo. Default: no.
    #[must_use]
    pub fn merge(mut self, may: bool) -> Self {
        self.merge = may;
        self
    }

    /// Whether photos are shown whole: the layout follows their aspect ratios. Default: no.
    #[must_use]
    pub fn whole_photos(mut self, whole: bool) -> Self {
        self.page.whole_photos = whole;
        self
    }

    /// The page template of an id, such as `cinema-4`; [`layouts`] lists them.
    ///
    /// # Errors
    /// `unknown-layout`.
    pub fn layout(self, id: &str) -> Result<Self, Failure> {
        self.layout_ref(id.into())
    }

    /// The page template of a layout file.
    ///
    /// # Errors
    /// `invalid-argument` if the text is not valid JSON; `invalid-layout`, with location and reason.
    pub fn layout_from_json(self, json: &str) -> Result<Self, Failure> {
        let file =
            serde_json::from_str(json).map_err(|error| Failure::argument("layout", &error.to_string()))?;
        self.layout_ref(LayoutRef::from_file(file))
    }

    fn layout_ref(mut self, layout: LayoutRef) -> Result<Self, Failure> {
        // Report layout errors before photos are read.
        layout.template()?;
        self.layout = Some(layout);
        Ok(self)
    }

    /// The style.
    #[must_use]
    pub fn style(mut self, style: &Style) -> Self {
        self.style = Some(style.clone());
        self
    }

    /// Families to choose layouts from, if no layout is set. An empty list allows all.
    #[must_use]
    pub fn layout_families(mut self, families: &[String]) -> Self {
        self.families.layouts = families.to_vec();
        self
    }

    /// Families to choose styles from, if no style is set. An empty list allows all.
    #[must_use]
    pub fn style_families(mut self, families: &[String]) -> Self {
        self.families.styles = families.to_vec();
        self
    }

    /// Whether a subject breaks its panel border, if the album has masks of subjects and one of them fits. By default the
    /// choice is random.
    #[must_use]
    pub fn figures(mut self, on: bool) -> Self {
        self.figures = Some(on);
        self
    }

    /// Size, gutters and colours as the engine has them.
    #[doc(hidden)]
    #[must_use]
    pub fn settings(mut self, page: PageSettings) -> Self {
        self.page = page;
        self
    }

    /// The size of the page: a name (`a4`, `a5`, `letter`, `us-comic`, `square`, `webtoon`), pixels
    /// (`1600x2400`), or sides on paper (`210x297mm`, `8.5x11in`). `dpi` sets the resolution of a name or
    /// paper size. `width` sets the width of the page in pixels.
    ///
    /// # Errors
    /// `invalid-document` for an unknown name, sides outside 64 to 14000 pixels, or a resolution outside 36
    /// to 1200 DPI.
    pub fn size(mut self, paper: &str, dpi: Option<u32>, width: Option<u32>) -> Result<Self, Failure> {
        let size = PaperSize::parse(paper)?;
        let PageSettings { width, height, dpi, .. } = PageSettings::sized(Some(size), dpi, width);
        self.page = PageSettings { width, height, dpi, ..self.page };
        self.checked()
    }

    /// A page setting by its name, such as `corner_radius`, with its value as JSON. [`page_settings`] lists the names.
    ///
    /// # Errors
    /// `invalid-argument` if the text is not JSON; `invalid-document` for an unknown name or an invalid value.
    pub fn setting(mut self, name: &str, json: &str) -> Result<Self, Failure> {
        let value =
            serde_json::from_str(json).map_err(|error| Failure::argument(name, &error.to_string()))?;
        self.page.set(&name.replace('_', "-"), &value)?;
        Ok(self)
    }

    /// Distance between two panels, 0 to .1 of the page's width.
    ///
    /// # Errors
    /// `invalid-document`, as all lengths and colours that follow.
    pub fn gutter(mut self, length: f64) -> Result<Self, Failure> {
        self.page.gutter = length;
        self.checked()
    }

    /// Distance between the panels and the edge of the page, 0 to .2 of its width.
    ///
    /// # Errors
    /// `invalid-document`.
    pub fn margin(mut self, length: f64) -> Result<Self, Failure> {
        self.page.margin = length;
        self.checked()
    }

    /// Width of the line round a panel, 0 to .05 of the page's width.
    ///
    /// # Errors
    /// `invalid-document`.
    pub fn border(mut self, length: f64) -> Result<Self, Failure> {
        self.page.border = length;
        self.checked()
    }

    /// Radius of the panels' corners, 0 to .2 of the page's width.
    ///
    /// # Errors
    /// `invalid-document`.
    pub fn corner_radius(mut self, length: f64) -> Result<Self, Failure> {
        self.page.corner_radius = length;
        self.checked()
    }

    /// Colour of the paper, `#rrggbb`.
    ///
    /// # Errors
    /// `invalid-document`.
    pub fn paper(mut self, colour: &str) -> Result<Self, Failure> {
        colour.clone_into(&mut self.page.paper);
        self.checked()
    }

    /// Colour of the line round a panel, `#rrggbb`.
    ///
    /// # Errors
    /// `invalid-document`.
    pub fn border_color(mut self, colour: &str) -> Result<Self, Failure> {
        colour.clone_into(&mut self.page.border_color);
        self.checked()
    }

    /// Captions, balloons and sound effects of the first page, as a JSON list. An item is for example
    /// `{"kind": "balloon", "text": "Look out!", "panel": 0}`. Items without a position are placed
    /// automatically, away from faces.
    ///
    /// # Errors
    /// `invalid-argument` if the text is not a JSON list, `invalid-document` for an invalid text item.
    pub fn words(mut self, json: &str) -> Result<Self, Failure> {
        serde_json::from_str::<Vec<serde::de::IgnoredAny>>(json)
            .map_err(|error| Failure::argument("words", &error.to_string()))?;
        self.words = TextItem::read_all(json)?;
        Ok(self)
    }

    /// Edits of the planned pages, as a JSON list: swap photos, crop, merge or split panels, choose a layout or style, and so
    /// on. An item is for example `{"type": "swap-panels", "panel": 0, "with": 2}`. The reference of formats lists all edits.
    /// Photos are named by their names or ids. An edit that changes nothing adds a note.
    ///
    /// # Errors
    /// `invalid-argument` if the text is not JSON, `invalid-document` if it is not a list. Other errors of edits are errors of
    /// [`Album::pages`](crate::Album::pages).
    pub fn edits(mut self, json: &str) -> Result<Self, Failure> {
        serde_json::from_str::<serde::de::IgnoredAny>(json)
            .map_err(|error| Failure::argument("edits", &error.to_string()))?;
        self.edits = page_edits::parse(json)?;
        Ok(self)
    }

    /// Maximum fingerprint distance, in bits of 64, at which two photos count as duplicates. The command
    /// line has the same default.
    #[must_use]
    pub fn duplicate_threshold(mut self, bits: u32) -> Self {
        self.choice.duplicate_threshold = Some(bits);
        self
    }

    /// Whether all photos are used, including duplicates and blurred photos.
    #[must_use]
    pub fn keep_all(mut self, all: bool) -> Self {
        self.choice.keep_all = all;
        self
    }

    /// Returns whether photos keep the given order even if all have a capture date.
    #[must_use]
    pub fn as_given(mut self, stays: bool) -> Self {
        self.choice.as_given = stays;
        self
    }

    fn checked(self) -> Result<Self, Failure> {
        self.page.validate()?;
        Ok(self)
    }

    /// Checks the maximum number of pages of an album.
    pub(crate) fn check(most: Option<usize>) -> Result<(), Failure> {
        match most {
            Some(pages) if !(1..=MOST_PAGES).contains(&pages) => {
                Err(Failure::argument("pages", &format!("must be from 1 to {MOST_PAGES}")))
            }
            _ => Ok(()),
        }
    }

    /// The request to the planner, without photos.
    pub(crate) fn request(&self) -> Request {
        Request {
            seed: self.seed,
            page: self.page.clone(),
            layout: self.layout.clone(),
            style: self.style.as_ref().map(|style| StyleRef::of(style.chain())),
            panels: self.panels,
            within: self.families.clone(),
            figures: self.figures,
            ordered: self.choice.as_given.then_some(true),
            duplicate_threshold: self.choice.duplicate_threshold,
            merge: Some(self.merge),
            ..Request::default()
        }
    }
}
