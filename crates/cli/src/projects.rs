//! Projects made on the command line: files that the page opens, and PNG files of pages that carry their project.

use crate::CliError;
use crate::input::{self, name};
use crate::photos::Photos;
use inkpanel_engine::document::file::ProjectFile;
use inkpanel_engine::page::Document;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Length of the PNG signature and of the first chunk: length, type, 13 bytes of data and checksum.
const HEAD: usize = 8 + 4 + 4 + 13 + 4;
/// The last chunk of a PNG file, which is empty.
const TAIL: usize = 12;
/// Bytes of a chunk, by the format.
const LONGEST_CHUNK: usize = i32::MAX as usize;

/// An album with its pages.
pub(crate) struct Album<'a> {
    /// Name.
    pub(crate) name: String,
    /// Its pages, whose photos have the ids of those below.
    pub(crate) pages: &'a [Document],
    /// All that was read.
    pub(crate) photos: &'a Photos<'a>,
    /// Ids of photos that pages may show.
    pub(crate) used: &'a [String],
    /// Whether detection ran.
    pub(crate) looked: bool,
}

impl Album<'_> {
    /// A project file: the project, and the unchanged files of its photos.
    ///
    /// # Errors
    /// A sentence for a photo that can be read no more, and for more than a project may be.
    pub(crate) fn packed(&self) -> Result<Vec<u8>, CliError> {
        let text = self.text(0)?;
        self.archive(Some(&text))
    }

    /// Returns a PNG of a page with its project, and with the photos if requested.
    ///
    /// # Errors
    /// The errors of [`packed`](Self::packed), and if the photos are too large for a PNG file.
    pub(crate) fn inside(&self, png: &[u8], page: usize, with_photos: bool) -> Result<Vec<u8>, CliError> {
        if png.len() < HEAD + TAIL {
            return Err("the page is not a PNG file".into());
        }
        let (head, rest) = png.split_at(HEAD);
        let (pixels, tail) = rest.split_at(rest.len() - TAIL);
        // Keyword, its end, not deflated, no language, no translation of the keyword.
        let text = [b"inkpanel\0\0\0\0\0", self.text(page)?.as_bytes()].concat();
        let photos = if with_photos { chunk(*b"ipPh", &self.archive(None)?)? } else { Vec::new() };
        Ok([head, &chunk(*b"iTXt", &text)?, pixels, &photos, tail].concat())
    }

    /// The text of the project, open on a page.
    fn text(&self, at: usize) -> Result<String, CliError> {
        let sheets: Vec<Value> = self
            .pages
            .iter()
            .enumerate()
            .map(|(i, page)| {
                let page: Value = serde_json::from_str(&page.to_json()).map_err(CliError::fault)?;
                Ok(json!({ "page": page, "pageId": i + 1, "sheet": i }))
            })
            .collect::<Result<_, CliError>>()?;
        let shown: Vec<Value> = sheets
            .iter()
            .map(|sheet| json!({ "id": sheet["pageId"], "page": sheet["page"], "sheet": sheet["sheet"] }))
            .collect();
        let others: Vec<&Value> =
            sheets.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, sheet)| sheet).collect();
        let own = sheets.get(at).ok_or("the project has no page")?;
        let tray: Vec<Value> = self
            .photos
            .iter()
            .map(|(_, photo)| {
                let id = photo.meta.id.as_str();
                let mut item = json!({ "id": id, "use": self.used.iter().any(|used| used == id) });
                if photo.meta.starred {
                    item["starred"] = true.into();
                }
                item
            })
            .collect();
        let mut times: Vec<&String> =
            self.photos.iter().filter_map(|(_, photo)| photo.meta.taken.as_ref()).collect();
        times.sort_unstable();
        times.dedup();
        let places = self.places();
        let photos: Vec<Value> = self
            .photos
            .iter()
            .map(|(path, photo)| {
                let meta = &photo.meta;
                json!({
                    "id": meta.id, "name": name(path), "path": places[meta.id.as_str()],
                    "type": kind(photo.format), "measured": true,
                    "subjects": self.looked.then_some(&meta.subjects),
                    "rank": meta.taken.as_ref().and_then(|taken| times.binary_search(&taken).ok()),
                    "like": {
                        "hash": "", "fingerprint": format!("{:016x}", meta.fingerprint),
                        "width": meta.width, "height": meta.height,
                    },
                })
            })
            .collect();
        let told = json!({
            "format": "inkpanel", "version": inkpanel_engine::document::VERSION,
            "history": {
                "present": {
                    "name": self.name, "tray": tray, "settings": own["page"]["page"], "page": own["page"],
                    "pageId": own["pageId"], "sheet": own["sheet"], "others": others, "at": at,
                },
                "shown": shown,
            },
            "photos": photos, "videos": [],
        });
        let text = told.to_string();
        // Never write a project that the app would reject.
        ProjectFile::parse(&text)?;
        Ok(text)
    }

    /// Paths of the photos in the archive, by id.
    fn places(&self) -> HashMap<&str, String> {
        let place = |i: usize, path: &Path| {
            let plain = |c: char| if c.is_alphanumeric() || "._-".contains(c) { c } else { '-' };
            let short: String =
                name(path).chars().rev().take(60).collect::<Vec<_>>().into_iter().rev().map(plain).collect();
            format!("photos/{:03}-{short}", i + 1)
        };
        self.photos
            .iter()
            .enumerate()
            .map(|(i, (path, photo))| (photo.meta.id.as_str(), place(i, path)))
            .collect()
    }

    fn archive(&self, text: Option<&str>) -> Result<Vec<u8>, CliError> {
        let unpacked = |error: zip::result::ZipError| CliError::new("encode", error.to_string());
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        // Photos are packed already.
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        let places = self.places();
        let mut put = |name: &str, bytes: &[u8]| {
            writer.start_file(name, stored).map_err(unpacked)?;
            writer.write_all(bytes).map_err(|error| unpacked(error.into()))
        };
        if let Some(text) = text {
            put("project.json", text.as_bytes())?;
        }
        for (path, photo) in self.photos.iter() {
            let bytes = self.photos.run.read(path).map_err(|error| error.at(input::told(path)))?;
            put(&places[photo.meta.id.as_str()], &bytes)?;
        }
        writer.finish().map(Cursor::into_inner).map_err(unpacked)
    }
}

/// Title of an album: the name of the only input folder, or of the output file.
pub(crate) fn called(given: &[PathBuf], output: &Path) -> String {
    let folder = match given {
        [folder] if folder.is_dir() => std::fs::canonicalize(folder).ok(),
        _ => None,
    };
    let name = folder.as_deref().and_then(Path::file_name).or_else(|| output.file_stem());
    name.map(|name| name.to_string_lossy().chars().take(80).collect()).unwrap_or_default()
}

/// A chunk of a PNG file. Source: PNG Specification (Third Edition), 5.3.
fn chunk(kind: [u8; 4], data: &[u8]) -> Result<Vec<u8>, CliError> {
    if data.len() > LONGEST_CHUNK {
        let why = "the photos are too large for a PNG file; write an .inkpanel file instead";
        return Err(CliError::new("too-large", why));
    }
    let body = [&kind[..], data].concat();
    let length = (data.len() as u32).to_be_bytes();
    Ok([&length[..], &body, &crc32fast::hash(&body).to_be_bytes()].concat())
}

/// The type of a file by the name of its format.
fn kind(format: &str) -> &'static str {
    match format {
        "JPEG" => "image/jpeg",
        "PNG" => "image/png",
        "WebP" => "image/webp",
        "GIF" => "image/gif",
        "BMP" => "image/bmp",
        "TIFF" => "image/tiff",
        _ => "",
    }
}
