//! What is asked of pages, read from the JSON that `inkpanel.render` makes of its arguments.

use crate::failure::{Done, Failure};
use crate::styling::style_of;
use inkpanel::layout::{PageSettings, PaperSize};
use inkpanel::page::document::template_of;
use inkpanel::page::storyboard::Choice;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// The most pages, as on the command line.
const MOST_PAGES: usize = 1_000;

/// What is asked of pages.
pub(crate) struct Settings {
    pub(crate) seed: u32,
    /// How many pages an album is cut into; none makes one of all photos.
    pub(crate) pages: Option<usize>,
    pub(crate) page: PageSettings,
    pub(crate) layout: Option<Value>,
    pub(crate) style: Option<Value>,
    pub(crate) panels: Option<usize>,
    pub(crate) merge: bool,
    /// Places of photos that get the large panel.
    pub(crate) star: Vec<usize>,
    pub(crate) choice: Choice,
    pub(crate) words: Vec<Value>,
    /// Files of fonts, for letters of words that the program lacks.
    pub(crate) fonts: Vec<String>,
    /// The folder of the nets; none where nothing is looked for.
    pub(crate) models: Option<String>,
    /// Whether photos that cannot be read are left out, rather than an error.
    pub(crate) skip_broken: bool,
}

impl Settings {
    pub(crate) fn read(json: &str) -> Done<Self> {
        let told: Map<String, Value> =
            serde_json::from_str(json).map_err(|error| Failure::argument("settings", &error.to_string()))?;
        let mut told = Told(told);
        let pages = told.take::<usize>("pages")?;
        if pages.is_some_and(|pages| !(1..=MOST_PAGES).contains(&pages)) {
            return Err(Failure::argument("pages", &format!("must be from 1 to {MOST_PAGES}")));
        }
        let layout: Option<Value> = told.take("layout")?;
        let style: Option<Value> = told.take("style")?;
        // What cannot be drawn is said before any photo is read.
        if let Some(layout) = &layout {
            template_of(layout)?;
        }
        let style = style.map(|style| style_of(&style).map(|style| style.to_value())).transpose()?;
        let settings = Self {
            seed: told.take("seed")?.unwrap_or(1),
            pages,
            page: told.page()?,
            layout,
            style,
            panels: told.take("panels")?,
            merge: told.flag("merge")?,
            star: told.take("star")?.unwrap_or_default(),
            choice: Choice {
                alike: told.take("alike")?,
                keep_all: told.flag("keep_all")?,
                as_given: told.flag("as_given")?,
            },
            words: told.take("words")?.unwrap_or_default(),
            fonts: told.take("fonts")?.unwrap_or_default(),
            models: told.take("models")?,
            skip_broken: told.flag("skip_broken")?,
        };
        match told.0.keys().next() {
            Some(unknown) => Err(Failure::argument(unknown, "is no argument of render")),
            None => Ok(settings),
        }
    }
}

struct Told(Map<String, Value>);

impl Told {
    /// What is told under a name; null is as good as nothing.
    fn take<T: DeserializeOwned>(&mut self, name: &str) -> Done<Option<T>> {
        match self.0.remove(name) {
            None | Some(Value::Null) => Ok(None),
            Some(value) => serde_json::from_value(value)
                .map(Some)
                .map_err(|error| Failure::argument(name, &error.to_string())),
        }
    }

    fn flag(&mut self, name: &str) -> Done<bool> {
        Ok(self.take(name)?.unwrap_or(false))
    }

    fn page(&mut self) -> Done<PageSettings> {
        let size = match self.take::<Value>("page_size")? {
            None => None,
            Some(Value::String(text)) => Some(PaperSize::parse(&text)?),
            Some(sides) => {
                let [width, height] = serde_json::from_value(sides).map_err(|error| {
                    Failure::argument(
                        "page_size",
                        &format!("is a name, or width and height in pixels: {error}"),
                    )
                })?;
                Some(PaperSize::Pixels(width, height))
            }
        };
        let mut page = PageSettings::sized(size, self.take("dpi")?, self.take("width")?);
        let lengths = [
            ("gutter", &mut page.gutter),
            ("margin", &mut page.margin),
            ("border", &mut page.border),
            ("corner_radius", &mut page.corner_radius),
        ];
        for (name, length) in lengths {
            *length = self.take(name)?.unwrap_or(*length);
        }
        for (name, colour) in [("paper", &mut page.paper), ("border_color", &mut page.border_color)] {
            if let Some(told) = self.take(name)? {
                *colour = told;
            }
        }
        page.validate()?;
        Ok(page)
    }
}
