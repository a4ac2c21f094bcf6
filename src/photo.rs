//! Photos of the caller.

use crate::failure::{Failure, survived};
use inkpanel_engine::kinds::clearer;
use inkpanel_engine::page::import::{Imported, import, import_image};
use inkpanel_engine::places::Places;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use std::borrow::Cow;
use std::ffi::OsStr;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A photo that is given to an [`Album`](crate::Album), which reads it.
///
/// The bytes may be JPEG, PNG or BMP, and with the feature `rare` also WebP, TIFF or GIF. The content
/// determines the format. The limit is 120 million pixels.
pub struct Photo {
    name: String,
    source: Source,
}

/// Source of its pixels.
enum Source {
    File(PathBuf),
    Bytes(Box<dyn AsRef<[u8]> + Send + Sync>),
    Pixels(Image),
}

impl Photo {
    /// A file, which is called by its path. It is read by the album, and again when a page is drawn.
    #[must_use]
    pub fn open(path: impl Into<PathBuf>) -> Self {
        let path = path.into();
        Self { name: path.display().to_string(), source: Source::File(path) }
    }

    /// Creates a photo from the bytes of a file. `name` appears in failures and notes.
    #[must_use]
    pub fn from_bytes(name: impl Into<String>, bytes: impl AsRef<[u8]> + Send + Sync + 'static) -> Self {
        Self { name: name.into(), source: Source::Bytes(Box::new(bytes)) }
    }

    /// Creates a photo from sRGB pixels, row by row, three bytes each. `name` appears in failures and notes.
    ///
    /// # Errors
    /// `damaged` if a side is 0; `too-large`; `buffer-size` if `rgb` does not have `3 * width * height`
    /// bytes.
    pub fn from_rgb(
        name: impl Into<String>,
        width: usize,
        height: usize,
        rgb: &[u8],
    ) -> Result<Self, Failure> {
        let name = name.into();
        let side = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
        let image = Limits::default()
            .check(side(width), side(height), "pixels")
            .and_then(|()| Image::from_interleaved_rgb(width, height, rgb))
            .map_err(|error| Failure::from(error).of(&name))?;
        Ok(Self { name, source: Source::Pixels(image) })
    }

    /// Pixels as the engine has them.
    #[doc(hidden)]
    #[must_use]
    pub fn from_image(name: impl Into<String>, image: Image) -> Self {
        Self { name: name.into(), source: Source::Pixels(image) }
    }

    /// Name of the photo in failures and notes.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    fn file_name(&self) -> &str {
        Path::new(&self.name).file_name().and_then(OsStr::to_str).unwrap_or(&self.name)
    }

    /// Reads, reduces and measures it.
    pub(crate) fn imported(&self, id: &str) -> Result<Imported, Failure> {
        let limits = Limits::default();
        self.told(|| match &self.source {
            Source::Pixels(image) => Ok(import_image(id, image, &limits)?),
            source => {
                let bytes = source.bytes()?;
                Ok(import(id, &bytes, &limits).map_err(|error| clearer(error, self.file_name(), &bytes))?)
            }
        })
    }

    /// The name of the place where it was taken. `None` without GPS data.
    pub(crate) fn place(&self, names: &Places) -> Option<String> {
        names.of_photo(&self.source.bytes().ok()?).map(str::to_owned)
    }

    /// Its pixels at their full size.
    pub(crate) fn full(&self) -> Result<Image, Failure> {
        self.told(|| match &self.source {
            Source::Pixels(image) => Ok(image.clone()),
            source => {
                let bytes = source.bytes()?;
                let decoded = decode(&bytes, &Limits::default());
                Ok(decoded.map_err(|error| clearer(error, self.file_name(), &bytes))?.image)
            }
        })
    }

    fn told<T>(&self, work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
        survived(work).map_err(|failure| failure.of(&self.name))
    }
}

impl Source {
    fn bytes(&self) -> Result<Cow<'_, [u8]>, Failure> {
        match self {
            Self::File(path) => read(path).map(Cow::Owned),
            Self::Bytes(bytes) => Ok(Cow::Borrowed((**bytes).as_ref())),
            Self::Pixels(_) => Ok(Cow::Borrowed(&[])),
        }
    }
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).map_err(|error| {
        let code = if error.kind() == ErrorKind::NotFound { "not-found" } else { "unreadable" };
        let folder = if path.is_dir() { "; list the files in this folder" } else { "" };
        Failure::new(code, format!("{error}{folder}"))
    })
}

/// Returns the page's id of the photo at a place in the list.
pub(crate) fn id(place: usize) -> String {
    format!("photo-{place}")
}
