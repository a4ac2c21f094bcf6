//! Formats of output files, by the ending of their name.

use crate::CliError;
use inkpanel_engine::output::shots;
use std::path::Path;

/// A format of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    Png,
    Jpeg,
    Webp,
    Pdf,
    /// A project, which the app opens.
    Project,
    Comic(ComicFormat),
    /// The shots of a project as a list.
    Shots(shots::Kind),
}

/// A format of a comic with text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ComicFormat {
    Html,
    Epub,
    Cbz,
}

impl Format {
    /// Format of a file name.
    ///
    /// # Errors
    /// If its ending is unknown.
    pub(crate) fn of(output: &Path) -> Result<Self, CliError> {
        let ending = output.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        if let Some(kind) = ending.as_deref().and_then(shots::Kind::of) {
            return Ok(Self::Shots(kind));
        }
        match ending.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("jpg" | "jpeg") => Ok(Self::Jpeg),
            Some("webp") => Ok(Self::Webp),
            Some("pdf") => Ok(Self::Pdf),
            Some("html" | "htm") => Ok(Self::Comic(ComicFormat::Html)),
            Some("epub") => Ok(Self::Comic(ComicFormat::Epub)),
            Some("cbz") => Ok(Self::Comic(ComicFormat::Cbz)),
            Some("inkpanel") => Ok(Self::Project),
            _ => Err(CliError::from(
                "the name of the page must end in .png, .jpg, .webp, .pdf, .html, .epub, .cbz or .inkpanel",
            )
            .at(output.display())),
        }
    }
}
