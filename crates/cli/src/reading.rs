//! Comics that are read, on the command line: HTML with a reader in it, EPUB, comic archives. Their pages are JPEG.

use crate::destination::Output;
use crate::drawing::{Means, Subjects};
use crate::format::ComicFormat;
use crate::{CliError, drawing};
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use inkpanel_engine::output::describing::described;
use inkpanel_engine::output::{Comic, ComicPage, File, PictureKind, Piece, cbz, epub, html};
use inkpanel_engine::page::Document;
use serde_json::json;
use std::io::{Cursor, Write};
use std::path::PathBuf;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// Metadata of a comic.
#[derive(Clone, Copy)]
pub(crate) struct Telling<'t> {
    /// Title.
    pub(crate) title: &'t str,
    /// BCP 47.
    pub(crate) language: &'t str,
}

/// Draws pages, and writes the comic.
///
/// Returns the file.
pub(crate) fn write(
    (kind, told_of): (ComicFormat, Telling<'_>),
    pages: &[Document],
    subjects: &Subjects<'_>,
    means: &Means<'_>,
    output: &Output,
) -> Result<Vec<PathBuf>, CliError> {
    output.write(&made(kind, told_of, pages, subjects, means)?)?;
    Ok(vec![output.path.clone()])
}

/// Makes a comic of pages. `subjects` returns the subjects of a photo id.
fn made(
    kind: ComicFormat,
    told_of: Telling<'_>,
    pages: &[Document],
    subjects: &Subjects<'_>,
    means: &Means<'_>,
) -> Result<Vec<u8>, CliError> {
    // Descriptions of panels exist only in English. In other languages, the text is just the word for photo.
    let english = told_of.language.split('-').next().is_some_and(|code| code.eq_ignore_ascii_case("en"));
    let page = |document: &Document| {
        let shows = if english { described(document, subjects) } else { Vec::new() };
        ComicPage { document: document.clone(), shows, moving: Vec::new() }
    };
    let comic = Comic {
        title: told_of.title.to_owned(),
        language: told_of.language.to_owned(),
        picture: PictureKind::Jpeg,
        pages: pages.iter().map(page).collect(),
    };
    let letters = &means.fonts.letters(pages.iter().flat_map(|page| &page.words))?;
    // Report errors before anything is drawn.
    let told = match kind {
        ComicFormat::Html => Told::Pieces(html::write(&comic, letters)?),
        ComicFormat::Epub => Told::Files(epub::write(&comic, letters)?),
        ComicFormat::Cbz => Told::Files(cbz::write(&comic, letters)?),
    };
    let mut pictures = Vec::new();
    for (i, page) in pages.iter().enumerate() {
        pictures.push(drawing::jpeg_of(page, means)?);
        if pages.len() > 1 {
            let event = json!({ "event": "page", "page": i + 1, "of": pages.len() });
            means.run.report.step(&event, Some(format!("page {} of {}", i + 1, pages.len())));
        }
    }
    match told {
        Told::Pieces(pieces) => Ok(joined(&pieces, &pictures)),
        Told::Files(files) => {
            packed(&files, &pictures).map_err(|error| CliError::new("encode", error.to_string()))
        }
    }
}

enum Told {
    Pieces(Vec<Piece>),
    Files(Vec<File>),
}

/// One file of text and of pictures as data URLs.
fn joined(pieces: &[Piece], pictures: &[Vec<u8>]) -> Vec<u8> {
    let mut out = String::new();
    for piece in pieces {
        match piece {
            Piece::Text(text) => out.push_str(text),
            Piece::Picture(page) => {
                out.push_str("data:");
                out.push_str(PictureKind::Jpeg.media_type());
                out.push_str(";base64,");
                BASE64_STANDARD.encode_string(&pictures[*page], &mut out);
            }
        }
    }
    out.into_bytes()
}

/// A ZIP file with the earliest possible date for all files. The first file is stored uncompressed, as EPUB
/// requires, and so are images.
fn packed(files: &[File], pictures: &[Vec<u8>]) -> Result<Vec<u8>, zip::result::ZipError> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = |method| {
        SimpleFileOptions::default().compression_method(method).last_modified_time(DateTime::default())
    };
    for (i, File { name, content }) in files.iter().enumerate() {
        match content {
            Piece::Picture(page) => {
                archive.start_file(name, options(CompressionMethod::Stored))?;
                archive.write_all(&pictures[*page])?;
            }
            Piece::Text(text) => {
                let method = if i == 0 { CompressionMethod::Stored } else { CompressionMethod::Deflated };
                archive.start_file(name, options(method))?;
                archive.write_all(text.as_bytes())?;
            }
        }
    }
    Ok(archive.finish()?.into_inner())
}
