//! Options of pages, from the JSON of the arguments of `inkpanel.render`.

use crate::failure::{Done, Failure};
use inkpanel::{BookOptions, PageOptions, Style};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// Options of pages.
pub(crate) struct Settings {
    /// Maximum number of pages. `None`: one page of all photos.
    pub(crate) pages: Option<usize>,
    pub(crate) options: PageOptions,
    /// Places of photos that get the large panel.
    pub(crate) star: Vec<usize>,
    /// Font files, for characters that the bundled fonts lack.
    pub(crate) fonts: Vec<String>,
    /// Folder of the models. `None`: no detection.
    pub(crate) models: Option<String>,
    /// Whether photos that cannot be read are left out, rather than an error.
    pub(crate) skip_broken: bool,
    /// Options of a book. `None`: pages without captions.
    pub(crate) book: Option<BookOptions>,
    /// File of the table of places. `None`: GPS data is not read.
    pub(crate) places: Option<String>,
}

impl Settings {
    pub(crate) fn read(json: &str) -> Done<Self> {
        let told: Map<String, Value> =
            serde_json::from_str(json).map_err(|error| Failure::argument("settings", &error.to_string()))?;
        let mut told = Told(told);
        let places = told.places()?;
        let settings = Self {
            places,
            pages: told.take("pages")?,
            options: told.options()?,
            star: told.take("star")?.unwrap_or_default(),
            fonts: told.take("fonts")?.unwrap_or_default(),
            models: told.take("models")?,
            skip_broken: told.flag("skip_broken")?,
            book: told.book()?,
        };
        match told.0.keys().next() {
            Some(unknown) => Err(Failure::argument(unknown, "is not an argument of render")),
            None => Ok(settings),
        }
    }
}

/// The style of an id, or of a style file.
pub(crate) fn style_of(value: &Value) -> Done<Style> {
    Ok(match value {
        Value::String(id) => Style::designed(id)?,
        file => Style::from_json(&file.to_string())?,
    })
}

struct Told(Map<String, Value>);

impl Told {
    /// Takes a setting by name. Null counts as missing.
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

    /// Takes the table of places out of the options of a book.
    fn places(&mut self) -> Done<Option<String>> {
        let book = self.0.get_mut("book").and_then(Value::as_object_mut);
        let Some(places) = book.and_then(|book| book.remove("places")) else { return Ok(None) };
        serde_json::from_value(places).map_err(|error| Failure::argument("places", &error.to_string()))
    }

    fn book(&mut self) -> Done<Option<BookOptions>> {
        let Some(book) = self.take::<Map<String, Value>>("book")? else { return Ok(None) };
        let mut book = Told(book);
        let mut options = BookOptions::new()
            .title(&book.take::<String>("title")?.unwrap_or_default())
            .language(&book.take::<String>("language")?.unwrap_or_default());
        if let Some(pages) = book.take("pages")? {
            options = options.pages(pages);
        }
        match book.take::<String>("styles")?.as_deref() {
            None | Some("one") => Ok(Some(options)),
            Some("chapters") => Ok(Some(options.style_by_chapter(true))),
            Some(_) => Err(Failure::argument("styles", "must be \"one\" or \"chapters\"")),
        }
    }

    fn options(&mut self) -> Done<PageOptions> {
        let seed = self.take("seed")?.unwrap_or(1);
        let mut options = self.sized(PageOptions::new().seed(seed))?;
        if let Some(layout) = self.take::<Value>("layout")? {
            options = options.layout_from_json(&layout.to_string())?;
        }
        if let Some(style) = self.take::<Value>("style")? {
            options = options.style(&style_of(&style)?);
        }
        if let Some(panels) = self.take("panels")? {
            options = options.panels(panels);
        }
        if let Some(bits) = self.take("duplicate_threshold")? {
            options = options.duplicate_threshold(bits);
        }
        if let Some(words) = self.take::<Value>("words")? {
            options = options.words(&words.to_string())?;
        }
        if let Some(edits) = self.take::<Value>("edits")? {
            options = options.edits(&edits.to_string())?;
        }
        for (name, _) in inkpanel::page_settings() {
            if let Some(value) = self.take::<Value>(&name)? {
                options = options.setting(&name, &value.to_string())?;
            }
        }
        let options = options.merge(self.flag("merge")?);
        Ok(options.keep_all(self.flag("keep_all")?).as_given(self.flag("as_given")?))
    }

    fn sized(&mut self, options: PageOptions) -> Done<PageOptions> {
        let size = self.take::<Value>("page_size")?;
        let (dpi, width) = (self.take("dpi")?, self.take("width")?);
        Ok(match size {
            None => options.size("a4", dpi, width)?,
            Some(Value::String(paper)) => options.size(&paper, dpi, width)?,
            Some(sides) => {
                let [wide, high]: [u32; 2] = serde_json::from_value(sides).map_err(|error| {
                    Failure::argument(
                        "page_size",
                        &format!("is a name, or width and height in pixels: {error}"),
                    )
                })?;
                options.size(&format!("{wide}x{high}"), dpi, width)?
            }
        })
    }
}
