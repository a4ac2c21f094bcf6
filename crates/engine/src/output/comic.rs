//! Request and result of a comic export.

use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::page::Document;
use serde::{Deserialize, Serialize};

/// Most pages of a comic, as many as a storyboard may have.
pub const MOST_PAGES: usize = 1_000;

/// Pages that become one file.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Comic {
    /// Title.
    pub title: String,
    /// BCP 47 tag, such as `en`. The reader's interface uses this language, or English if it is not
    /// available.
    pub language: String,
    /// File format of the images.
    pub picture: PictureKind,
    /// Its pages in order.
    pub pages: Vec<ComicPage>,
}

impl Comic {
    /// Whether the comic is read from right to left.
    #[must_use]
    pub fn is_rtl(&self) -> bool {
        self.pages.first().is_some_and(|page| page.document.page.rtl)
    }
}

/// A page of a comic.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ComicPage {
    /// The page. Its image has the page's size.
    pub document: Document,
    /// Content of each panel, such as `two people and a dog`, in paint order. Empty if unknown.
    pub shows: Vec<String>,
    /// Areas of animated panels, in fractions of the page, in paint order. Only HTML comics show them.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub moving: Vec<Crop>,
}

/// An image format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum PictureKind {
    /// Without loss.
    Png,
    /// Small.
    Jpeg,
    /// Smaller.
    Webp,
}

impl PictureKind {
    /// File name extension.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Jpeg => "jpg",
            Self::Webp => "webp",
        }
    }

    /// Its media type.
    #[must_use]
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Png => "image/png",
            Self::Jpeg => "image/jpeg",
            Self::Webp => "image/webp",
        }
    }
}

/// A part of a file: text, or the image of the page with this index. The animated panels follow after the
/// images of all pages, page by page.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Piece {
    /// Text.
    Text(String),
    /// Image of the page with this index.
    Picture(usize),
}

/// A file of an archive.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ComicFile"))]
pub struct File {
    /// Its name, with the folders that it is in.
    pub name: String,
    /// Content.
    pub content: Piece,
}

impl File {
    pub(super) fn text(name: impl Into<String>, text: String) -> Self {
        Self { name: name.into(), content: Piece::Text(text) }
    }
}

impl Comic {
    /// Reads a request of the app.
    ///
    /// # Errors
    /// `invalid-document` for anything else, for a page whose settings are out of range, for a comic without pages, and for one
    /// of more than [`MOST_PAGES`].
    pub fn parse(json: &str) -> Result<Self> {
        let comic: Self = serde_json::from_str(json).map_err(|error| wrong("comic", error.to_string()))?;
        comic.pages.iter().try_for_each(|page| page.document.page.validate())?;
        if comic.pages.is_empty() || comic.pages.len() > MOST_PAGES {
            return Err(wrong("pages", format!("must be from 1 to {MOST_PAGES}")));
        }
        Ok(comic)
    }

    /// The name of a page without its ending, `page-01`, so that the order of names is the order of pages.
    #[must_use]
    pub fn page_name(&self, page: usize) -> String {
        let digits = self.pages.len().to_string().len().max(2);
        format!("page-{:0digits$}", page + 1)
    }
}

pub(super) fn wrong(location: &str, reason: String) -> Error {
    Error::InvalidDocument { location: location.to_owned(), reason }
}
