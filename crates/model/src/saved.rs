//! Reads saved projects and pages. Formats:
//!
//! - a project file (`.inkpanel`): a ZIP file with `project.json` and the photos;
//! - a page PNG with its project in the `iTXt` chunk `inkpanel`, and optionally its photos as a ZIP file in
//!   the chunk `ipPh`;
//! - a ZIP or CBZ file of pages that contains a project file.
//!
//! The format is detected by content. The browser does not use this module, because it reads files without
//! loading them into memory.
//!
//! Input is untrusted: the unpacked size is counted during unpacking.

use super::file::{FilePhoto, ProjectFile};
use super::limits::{ARCHIVE_ENTRIES, ENTRY, PAGE_TEXT, PNG_CHUNKS, PNG_TEXTS, PROJECT};
use crate::error::{Error, Result};
use crate::page::Document;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use std::borrow::Cow;
use std::io::{Cursor, Read};
use std::ops::Range;
use std::sync::Arc;
use zip::result::ZipError;
use zip::{CompressionMethod, ZipArchive};

const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
/// First bytes of a ZIP file: of its first file, or of its end record if it is empty.
const ARCHIVES: [&[u8]; 2] = [b"PK\x03\x04", b"PK\x05\x06"];
/// The project file in an archive of pages.
const BESIDE: &str = "project.inkpanel";
const KEYWORD: &[u8] = b"inkpanel";
const TEXT: [u8; 4] = *b"iTXt";
const PHOTOS: [u8; 4] = *b"ipPh";

/// A project out of a file, with its photos.
#[derive(Debug)]
pub struct Saved {
    text: String,
    project: ProjectFile,
    /// None in a page that carries no photos.
    archive: Option<Archive>,
}

type Archive = ZipArchive<Cursor<Vec<u8>>>;

impl Saved {
    /// Reads a project file, or a page with its project.
    ///
    /// Returns `None` if the file is neither, such as an image of another program.
    ///
    /// # Errors
    /// `damaged-project`, `newer-project` or `too-large-project`, with the place.
    pub fn read(bytes: Vec<u8>) -> Result<Option<Self>> {
        if bytes.starts_with(SIGNATURE) {
            return Self::read_page(&bytes);
        }
        if ARCHIVES.iter().any(|start| bytes.starts_with(start)) {
            return Self::read_project(bytes).map(Some);
        }
        Ok(None)
    }

    fn read_project(bytes: Vec<u8>) -> Result<Self> {
        let mut archive = archive(bytes)?;
        if archive.index_for_name(BESIDE).is_some() {
            let inside = entry(&mut archive, BESIDE, ENTRY)?.unwrap_or_default();
            archive = self::archive(inside)?;
        }
        let text = entry(&mut archive, "project.json", PROJECT.bytes as u64)?;
        let text = text.ok_or_else(|| damaged("project.json", "is missing"))?;
        let text = String::from_utf8(text).map_err(|_| damaged("project.json", "is not UTF-8 text"))?;
        let project = ProjectFile::parse(&text)?;
        Ok(Self { text, project, archive: Some(archive) })
    }

    fn read_page(bytes: &[u8]) -> Result<Option<Self>> {
        let Some(chunks) = chunks(bytes) else { return Ok(None) };
        let texts = chunks.iter().filter(|chunk| chunk.kind == TEXT).take(PNG_TEXTS);
        let mut ours = texts.filter(|chunk| {
            chunk.data(bytes).strip_prefix(KEYWORD).is_some_and(|rest| rest.first() == Some(&0))
        });
        let Some(chunk) = ours.next() else { return Ok(None) };
        let text = chunk.is_whole(bytes).then(|| text_of(chunk.data(bytes))).flatten();
        let text = text.ok_or_else(|| damaged("page", "its project is damaged"))?;
        let project = ProjectFile::parse(&text)?;
        if project.history.present.page().is_none() {
            return Err(damaged("present.page", "is missing"));
        }
        // A part that is broken costs the photos, which are then missing.
        let photos = chunks.iter().find(|chunk| chunk.kind == PHOTOS);
        let archive = photos.and_then(|chunk| archive(chunk.data(bytes).to_vec()).ok());
        Ok(Some(Self { text, project, archive }))
    }

    /// The text of the project in the file.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The project in the text.
    #[must_use]
    pub fn project(&self) -> &ProjectFile {
        &self.project
    }

    /// The pages of the storyboard in order, and which of them is the present one.
    #[must_use]
    pub fn pages(&self) -> (Vec<Arc<Document>>, usize) {
        let present = &self.project.history.present;
        (present.sheets().iter().map(|sheet| sheet.page.clone()).collect(), present.pages.active())
    }

    /// Metadata of a photo, or `None` if the file does not list it.
    #[must_use]
    pub fn photo(&self, id: &str) -> Option<&FilePhoto> {
        self.project.photos.iter().find(|photo| photo.id == id)
    }

    /// The file of a photo, or `None` if the project does not contain it.
    ///
    /// # Errors
    /// `damaged-project` if the checksum does not match, `too-large-project` if the file exceeds the limit of
    /// photos.
    pub fn photo_file(&mut self, id: &str) -> Result<Option<Vec<u8>>> {
        let path = self.photo(id).map(|photo| photo.path.clone());
        match (path, &mut self.archive) {
            (Some(path), Some(archive)) => entry(archive, &path, ENTRY),
            _ => Ok(None),
        }
    }
}

/// A chunk of a PNG file: its type, and where its data are. Length and type precede the data, a checksum
/// follows.
struct Chunk {
    kind: [u8; 4],
    at: Range<usize>,
}

impl Chunk {
    fn data<'b>(&self, bytes: &'b [u8]) -> &'b [u8] {
        &bytes[self.at.clone()]
    }

    /// Whether the checksum matches.
    fn is_whole(&self, bytes: &[u8]) -> bool {
        let told = bytes.get(self.at.end..self.at.end + 4);
        told == Some(&crc32fast::hash(&bytes[self.at.start - 4..self.at.end]).to_be_bytes())
    }
}

/// All chunks of a PNG file. `None` if the file is incomplete. Source: PNG Specification (Third Edition),
/// 5.3.
fn chunks(bytes: &[u8]) -> Option<Vec<Chunk>> {
    let mut chunks = Vec::new();
    let mut at = SIGNATURE.len();
    while chunks.len() < PNG_CHUNKS {
        let length = u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as usize;
        let kind: [u8; 4] = bytes.get(at + 4..at + 8)?.try_into().ok()?;
        let data = at + 8..(at + 8).checked_add(length)?;
        at = data.end.checked_add(4)?;
        if at > bytes.len() || !kind.iter().all(u8::is_ascii_alphabetic) {
            return None;
        }
        chunks.push(Chunk { kind, at: data });
        if kind == *b"IEND" {
            return Some(chunks);
        }
    }
    None
}

/// The text of an `iTXt` chunk: keyword, 0, whether it is deflated, 0, language, 0, keyword of that language, 0, text.
fn text_of(data: &[u8]) -> Option<String> {
    let after = |data: &[u8]| data.iter().position(|byte| *byte == 0).map(|end| end + 1);
    let data = &data[after(data)?..];
    let (&deflated, &method, data) = (data.first()?, data.get(1)?, data.get(2..)?);
    let data = &data[after(data)?..];
    let text = &data[after(data)?..];
    let text = match (deflated, method) {
        (0, _) if text.len() <= PAGE_TEXT => Cow::Borrowed(text),
        (1, 0) => Cow::Owned(decompress_to_vec_zlib_with_limit(text, PAGE_TEXT).ok()?),
        _ => return None,
    };
    String::from_utf8(text.into_owned()).ok()
}

fn archive(bytes: Vec<u8>) -> Result<Archive> {
    let archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| damaged("file", &told(&error)))?;
    if archive.len() > ARCHIVE_ENTRIES {
        return Err(too_large("file", "exceeds the maximum number of files in a project"));
    }
    Ok(archive)
}

/// A file of an archive, or `None` if the name does not exist.
fn entry(archive: &mut Archive, name: &str, most: u64) -> Result<Option<Vec<u8>>> {
    let wrong = |error: &ZipError| damaged(name, &told(error));
    let file = match archive.by_name(name) {
        Err(ZipError::FileNotFound) => return Ok(None),
        file => file.map_err(|error| wrong(&error))?,
    };
    // Uncompressed files need no additional memory.
    let most =
        if file.compression() == CompressionMethod::Stored { most.max(file.compressed_size()) } else { most };
    let mut bytes = Vec::new();
    // The ZIP reader checks the checksum at the end.
    file.take(most.saturating_add(1)).read_to_end(&mut bytes).map_err(|error| wrong(&error.into()))?;
    if bytes.len() as u64 > most {
        return Err(too_large(name, &format!("is larger than {} MB", most >> 20)));
    }
    Ok(Some(bytes))
}

fn told(error: &ZipError) -> String {
    match error {
        ZipError::UnsupportedArchive(reason) => {
            format!("uses an unknown compression method: {reason}")
        }
        error => format!("is damaged: {error}"),
    }
}

fn too_large(location: &str, reason: &str) -> Error {
    Error::TooLargeProject { location: location.into(), reason: reason.into() }
}

fn damaged(location: &str, reason: &str) -> Error {
    Error::DamagedProject { location: location.into(), reason: reason.into() }
}
