//! A planned page. It is drawn when the caller requests its pixels or a file.

use crate::failure::{Failure, detached};
use crate::{arrays, python_of};
use inkpanel::Pixels;
use numpy::{PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyBytes;

/// A storyboard page, made by `inkpanel.render`.
///
/// Its photos are read again at full size when `image`, `png`, `jpeg` or `pdf` first draws it. The pixels are
/// cached. Pages may be used by several threads at once.
#[pyclass(frozen, module = "inkpanel")]
pub(crate) struct Page {
    page: inkpanel::Page,
    drawn: PyOnceLock<Py<PyArray3<u8>>>,
}

impl Page {
    pub(crate) fn new(page: inkpanel::Page) -> Self {
        Self { page, drawn: PyOnceLock::new() }
    }

    /// The pixels, drawn once.
    fn drawn<'py>(&self, py: Python<'py>) -> PyResult<&Bound<'py, PyArray3<u8>>> {
        let drawn = self.drawn.get_or_try_init(py, || {
            let pixels = detached(py, || Ok(self.page.pixels()?))?;
            let array = arrays::colour(py, (pixels.width, pixels.height), pixels.rgb)?;
            // All files of a page show the same.
            array.call_method1("setflags", (false,))?;
            Ok::<_, PyErr>(array.unbind())
        })?;
        Ok(drawn.bind(py))
    }

    /// A file of the pixels.
    fn encoded<'py>(
        &self,
        py: Python<'py>,
        encode: impl Fn(&Pixels) -> Result<Vec<u8>, inkpanel::Failure> + Send + Sync,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let drawn = self.drawn(py)?.try_readonly()?;
        let rgb = drawn.as_slice()?;
        let file = detached(py, || {
            let (width, height) = (self.page.width() as usize, self.page.height() as usize);
            let mut pixels = Pixels::new(width, height, rgb.to_vec())?;
            pixels.dpi = self.page.dpi();
            Ok(encode(&pixels)?)
        })?;
        Ok(PyBytes::new(py, &file))
    }
}

#[pymethods]
impl Page {
    /// Width in pixels.
    #[getter]
    fn width(&self) -> u32 {
        self.page.width()
    }

    /// Height in pixels.
    #[getter]
    fn height(&self) -> u32 {
        self.page.height()
    }

    /// Resolution in pixels per inch.
    #[getter]
    fn dpi(&self) -> u32 {
        self.page.dpi()
    }

    /// Warnings: photos that were left out, and why. All pages of an album share them.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.page.notes().iter().map(ToString::to_string).collect()
    }

    /// The page as plain data: layout, style, crops, text items and settings. The photo of each panel is its
    /// path, or `photo 3` for an index in the list.
    #[getter]
    fn plan(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        python_of(py, &self.page.plan())
    }

    /// The pixels, uint8 of the shape (height, width, 3) in RGB. They are drawn once and cannot be written to; copy them to
    /// change them.
    #[getter]
    fn image<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<u8>>> {
        self.drawn(py).cloned()
    }

    /// A PNG file of the page.
    fn png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.encoded(py, Pixels::png)
    }

    /// A JPEG file of the page, of a quality from 1 to 100.
    // Equal to `native::QUALITY`; a literal, so that help shows it.
    #[pyo3(signature = (quality = 90))]
    fn jpeg<'py>(&self, py: Python<'py>, quality: u8) -> PyResult<Bound<'py, PyBytes>> {
        self.encoded(py, |pixels| pixels.jpeg(quality))
    }

    /// Returns a PDF file of the page, with pictures, vector lines and text.
    #[pyo3(signature = (*, title = "", language = "en"))]
    fn pdf<'py>(slf: PyRef<'py, Self>, title: &str, language: &str) -> PyResult<Bound<'py, PyBytes>> {
        bound(slf.py(), &[&slf.page], title, language)
    }

    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.png(py)
    }

    fn __repr__(&self) -> String {
        let page = &self.page;
        format!("<inkpanel.Page {}x{}, {} panels>", page.width(), page.height(), page.panels())
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
    let pages: Vec<&inkpanel::Page> = pages.iter().map(|page| &page.page).collect();
    bound(py, &pages, title, language)
}

fn bound<'py>(
    py: Python<'py>,
    pages: &[&inkpanel::Page],
    title: &str,
    language: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let file = detached(py, || inkpanel::pdf(pages, title, language).map_err(Failure::from))?;
    Ok(PyBytes::new(py, &file))
}
