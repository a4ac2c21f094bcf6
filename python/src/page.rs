//! A page that is planned: drawn when its pixels or a file of it are asked for.

use crate::failure::{Done, Failure, detached};
use crate::photos::{Photo, id, shown};
use crate::{arrays, python_of};
use inkpanel::framing::Subject;
use inkpanel::native::{self, QUALITY};
use inkpanel::page::pdf::{self as book, Options};
use inkpanel::page::words::given::GivenFonts;
use inkpanel::page::{Document, jpeg, png};
use numpy::{PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyBytes;
use std::collections::HashMap;
use std::sync::Arc;

/// Photos, and what is known of them, which all pages of an album share.
pub(crate) struct Album {
    pub(crate) photos: Vec<Photo>,
    /// What was found in photos, by their ids.
    pub(crate) subjects: HashMap<String, Vec<Subject>>,
    /// What letters come from that the program lacks.
    pub(crate) fonts: GivenFonts,
    /// What is not as it was asked for.
    pub(crate) notes: Vec<String>,
}

/// A storyboard page, made by `inkpanel.render`.
///
/// It is drawn from its photos, which are read again at their full size, when `image`, `png`, `jpeg` or `pdf` asks for it, and
/// its pixels are kept. Pages may be used by several threads at once.
#[pyclass(frozen, module = "inkpanel")]
pub(crate) struct Page {
    album: Arc<Album>,
    document: Document,
    drawn: PyOnceLock<Py<PyArray3<u8>>>,
}

impl Page {
    pub(crate) fn new(album: Arc<Album>, document: Document) -> Self {
        Self { album, document, drawn: PyOnceLock::new() }
    }

    /// The pixels, drawn once.
    fn pixels<'py>(&self, py: Python<'py>) -> PyResult<&Bound<'py, PyArray3<u8>>> {
        let drawn = self.drawn.get_or_try_init(py, || {
            let (size, rgb) = detached(py, || {
                let sheet = native::sheet(
                    &self.document,
                    &shown(&self.document, &self.album.photos)?,
                    &self.album.fonts,
                )?;
                Ok(((sheet.width(), sheet.height()), sheet.into_rgb()))
            })?;
            let array = arrays::colour(py, size, rgb)?;
            // All files of a page show the same.
            array.call_method1("setflags", (false,))?;
            Ok::<_, PyErr>(array.unbind())
        })?;
        Ok(drawn.bind(py))
    }

    /// A file of the pixels, as `encode` makes it of their size and of RGB.
    fn encoded<'py>(
        &self,
        py: Python<'py>,
        encode: impl Fn((usize, usize), &[u8]) -> inkpanel::Result<Vec<u8>> + Send + Sync,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let pixels = self.pixels(py)?.try_readonly()?;
        let rgb = pixels.as_slice()?;
        let size = (self.document.page.width as usize, self.document.page.height as usize);
        let file = detached(py, || Ok(encode(size, rgb)?))?;
        Ok(PyBytes::new(py, &file))
    }

    fn leaf(&self) -> Done<book::Leaf> {
        let subjects = |id: &str| self.album.subjects.get(id).map_or(&[][..], Vec::as_slice);
        let alts = native::alts(&self.document, &subjects);
        Ok(native::leaf(&self.document, &shown(&self.document, &self.album.photos)?, alts, (None, QUALITY))?)
    }
}

#[pymethods]
impl Page {
    /// Width in pixels.
    #[getter]
    fn width(&self) -> u32 {
        self.document.page.width
    }

    /// Height in pixels.
    #[getter]
    fn height(&self) -> u32 {
        self.document.page.height
    }

    /// Pixels an inch.
    #[getter]
    fn dpi(&self) -> u32 {
        self.document.page.dpi
    }

    /// What is not as it was asked for: photos that were left out, and why. The pages of an album share it.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.album.notes.clone()
    }

    /// The page as plain data: layout, style, crops, words and settings; the photo of each panel by its path, or as
    /// `photo 3` by its place in the list.
    #[getter]
    fn plan(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let photos = self.album.photos.iter().enumerate();
        let names: HashMap<String, &str> =
            photos.map(|(place, photo)| (id(place), photo.name.as_str())).collect();
        let name_of = |id: &String| names.get(id).map_or_else(|| id.clone(), |name| (*name).to_owned());
        let mut told = self.document.clone();
        for panel in &mut told.panels {
            panel.photo = panel.photo.as_ref().map(name_of);
        }
        told.order = told.order.iter().map(name_of).collect();
        python_of(py, &told.to_json())
    }

    /// The pixels, uint8 of the shape (height, width, 3) in RGB. They are drawn once and cannot be written to; copy them to
    /// change them.
    #[getter]
    fn image<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<u8>>> {
        self.pixels(py).cloned()
    }

    /// A PNG file of the page.
    fn png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.encoded(py, |(width, height), rgb| png::encode_rgb(width, height, rgb, self.document.page.dpi))
    }

    /// A JPEG file of the page, of a quality from 1 to 100.
    // As `native::QUALITY`; a number, so that help tells it.
    #[pyo3(signature = (quality = 90))]
    fn jpeg<'py>(&self, py: Python<'py>, quality: u8) -> PyResult<Bound<'py, PyBytes>> {
        if !(1..=100).contains(&quality) {
            return Err(Failure::argument("quality", "must be from 1 to 100").into());
        }
        self.encoded(py, |(width, height), rgb| {
            jpeg::encode_rgb(width, height, rgb, self.document.page.dpi, quality)
        })
    }

    /// A PDF file of the page: panels as pictures, lines and words as such.
    #[pyo3(signature = (*, title = "", language = "en"))]
    fn pdf<'py>(slf: PyRef<'py, Self>, title: &str, language: &str) -> PyResult<Bound<'py, PyBytes>> {
        bound(slf.py(), &[&*slf], title, language)
    }

    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.png(py)
    }

    fn __repr__(&self) -> String {
        let (width, height) = (self.document.page.width, self.document.page.height);
        format!("<inkpanel.Page {width}x{height}, {} panels>", self.document.panels.len())
    }
}

/// One PDF file of several pages.
#[pyfunction]
pub(crate) fn pdf<'py>(
    py: Python<'py>,
    pages: Vec<PyRef<'py, Page>>,
    title: &str,
    language: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let pages: Vec<&Page> = pages.iter().map(|page| &**page).collect();
    bound(py, &pages, title, language)
}

fn bound<'py>(
    py: Python<'py>,
    pages: &[&Page],
    title: &str,
    language: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let options = Options { title: title.to_owned(), language: language.to_owned(), ..Options::default() };
    let file = detached(py, || {
        if pages.is_empty() {
            return Err(Failure::argument("pages", "there is no page"));
        }
        let leaves = pages.iter().map(|page| page.leaf()).collect::<Done<Vec<_>>>()?;
        // The pages of several albums may have letters of the fonts of each.
        let fonts = GivenFonts::joined(pages.iter().map(|page| &page.album.fonts));
        let letters = fonts.letters(pages.iter().flat_map(|page| &page.document.words))?;
        Ok(book::write(&leaves, &options, &letters)?)
    })?;
    Ok(PyBytes::new(py, &file))
}
