//! `project.json` of a project file, and the text in a page PNG: the document, the pages shown, and what is told of each
//! photo and video. The undo stays behind. What the photos say themselves is read from them again, so what is told of a
//! photo beyond its id, name and place is a hint: one that is not right is as if it were not told, and fields that are not
//! known are passed over.

use super::history::{self, History};
use super::kept::{self, Interner, ShownOut, StateOut};
use super::limits::{
    LONGEST_ID, LONGEST_NAME, LONGEST_PATH, LONGEST_SIDE, MOST_LAYOUTS, MOST_PHOTOS, MOST_SHEETS,
    MOST_STYLES, MOST_SUBJECTS, MOST_VIDEOS, PROJECT,
};
use super::project::{self, Draft, List, Parts, Sheet, TrayItem};
use super::{Dropped, VERSION, pages, told, version};
use crate::error::Result;
use crate::json::{self, Fields, Read, Wrong, list, name, text, whole};
use crate::layout::PageSettings;
use crate::page::Document;
use serde::Serialize;
use serde_json::Value;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// What says that it is of this program.
const FORMAT: &str = "inkpanel";

/// A project file without its pictures.
#[derive(Debug, Clone)]
pub struct ProjectFile {
    /// The document and the pages shown; nothing to undo.
    pub history: History,
    /// Its photos.
    pub photos: Vec<FilePhoto>,
    /// Its videos.
    pub videos: Vec<FileVideo>,
    /// What was left out.
    pub dropped: Dropped,
}

/// What a file tells of a photo.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FilePhoto {
    /// Its id in the document.
    pub id: String,
    /// The name of its file.
    pub name: String,
    /// Its place in the archive.
    pub path: String,
    /// The type of its file, empty where nobody knows it.
    #[serde(rename = "type")]
    pub kind: String,
    /// Its author.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub credit: Option<String>,
    /// The video that it is a frame of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub video: Option<String>,
    /// Seconds from the beginning of the video.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
    /// Whether it is compared with other photos.
    pub measured: bool,
    /// What was found in it; none when it was not searched.
    pub subjects: Option<Vec<Value>>,
    /// Its place in time among the photos.
    pub rank: Option<u64>,
    /// How it is recognised where its file is not at hand.
    pub like: Option<Likeness>,
    /// An empty frame stands for it.
    pub absent: bool,
}

/// How a photo is recognised.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Likeness {
    /// SHA-256 of its file, or empty.
    pub hash: String,
    /// Its fingerprint.
    pub fingerprint: String,
    /// Width in pixels.
    pub width: u64,
    /// Height in pixels.
    pub height: u64,
}

/// What a file tells of a video.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FileVideo {
    /// Names it.
    pub key: String,
    /// The name of its file.
    pub name: String,
    /// Its place in the archive.
    pub path: String,
    /// The type of its file.
    #[serde(rename = "type")]
    pub kind: String,
    /// Photos that are frames of it.
    pub ids: Vec<String>,
    /// Seconds; none until the file was opened.
    pub duration: Option<f64>,
    /// Frames are taken from here,
    pub start: f64,
    /// to here.
    pub end: Option<f64>,
}

impl ProjectFile {
    /// Reads the text of a project file.
    ///
    /// # Errors
    /// `damaged-project` or `newer-project`, with the place.
    pub fn parse(text: &str) -> Result<Self> {
        told(json::parse(text, PROJECT).map_err(|wrong| wrong.at("project.json")).and_then(Self::read))
    }

    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value).map_err(|wrong| wrong.at("project.json"))?;
        if fields.take("format").as_ref().and_then(Value::as_str) != Some(FORMAT) {
            return Err(Wrong::new("is of another program").at("project.json"));
        }
        version(&mut fields)?;
        let Value::Object(mut history) = fields.required("history")? else {
            return Err(Wrong::new("is no object").at("history"));
        };
        history.remove("past");
        history.remove("future");
        let mut parts = Inline::default();
        let mut dropped = Dropped::new();
        let history = History::read(Value::Object(history), &mut parts, &mut dropped)?;
        let photos =
            list(MOST_PHOTOS, photo)(fields.required("photos")?).map_err(|wrong| wrong.at("photos"))?;
        let videos = fields.nullable("videos", list(MOST_VIDEOS, video))?.unwrap_or_default();
        let mut seen = Seen::default();
        for (i, photo) in photos.iter().enumerate() {
            seen.add("id", &photo.id, &photo.path).map_err(|wrong| wrong.in_list(i).at("photos"))?;
        }
        for (i, video) in videos.iter().enumerate() {
            seen.add("key", &video.key, &video.path).map_err(|wrong| wrong.in_list(i).at("videos"))?;
        }
        dropped.splice(0..0, parts.dropped);
        Ok(Self { history, photos, videos, dropped })
    }

    /// Gives each photo and video an id that no other has: `prefix` and a number. The same file may be opened twice, or be
    /// made by hand; a photo that the pages show and nobody tells of gets one, too.
    #[must_use]
    pub fn renamed(mut self, prefix: &str) -> Self {
        let mut names = Names { prefix, known: HashMap::new() };
        for photo in &mut self.photos {
            photo.id = names.of(&photo.id);
        }
        for video in &mut self.videos {
            video.key = names.of(&video.key);
            video.ids = video.ids.iter().map(|id| names.of(id)).collect();
        }
        for photo in &mut self.photos {
            photo.video = photo.video.as_ref().map(|key| names.of(key));
        }
        let mut page = |page: &Arc<Document>| {
            let mut page = Document::clone(page);
            page.order.iter_mut().for_each(|id| *id = names.of(id));
            page.panels
                .iter_mut()
                .for_each(|panel| panel.photo = panel.photo.as_ref().map(|id| names.of(id)));
            Arc::new(page)
        };
        let mut present = super::project::Project::clone(&self.history.present);
        present.page = present.page.as_ref().map(&mut page);
        present.others = present
            .others
            .iter()
            .map(|sheet| Arc::new(Sheet { page: page(&sheet.page), ..Sheet::clone(sheet) }))
            .collect();
        for shown in &mut self.history.shown {
            let renamed = page(&shown.page);
            Arc::make_mut(shown).page = renamed;
        }
        present.tray = present
            .tray
            .iter()
            .map(|item| Arc::new(TrayItem { id: names.of(&item.id), ..TrayItem::clone(item) }))
            .collect();
        self.history.present = Arc::new(present);
        self
    }

    /// The text in the shape in which it was read, normalised, with what was left out.
    ///
    /// # Errors
    /// `encode`, which cannot be.
    pub fn write(&self) -> Result<String> {
        #[derive(Serialize)]
        struct Out<'a> {
            format: &'static str,
            version: u64,
            history: HistoryOut<'a>,
            photos: &'a [FilePhoto],
            videos: &'a [FileVideo],
            dropped: &'a Dropped,
        }
        #[derive(Serialize)]
        struct HistoryOut<'a> {
            present: StateOut<'a>,
            shown: Vec<ShownOut<'a>>,
        }
        let mut parts = Interner::inline();
        let present = parts.state(&self.history.present);
        let shown = self.history.shown.iter().map(|shown| parts.shown(shown)).collect();
        let history = HistoryOut { present, shown };
        let (photos, videos, dropped) = (&*self.photos, &*self.videos, &self.dropped);
        kept::text(&Out { format: FORMAT, version: VERSION, history, photos, videos, dropped })
    }
}

/// Ids and places that are taken.
#[derive(Default)]
struct Seen<'a> {
    ids: HashSet<&'a str>,
    paths: HashSet<&'a str>,
}

impl<'a> Seen<'a> {
    fn add(&mut self, field: &str, id: &'a str, path: &'a str) -> Read<()> {
        let taken = |field: &str| Err(Wrong::new("is that of another file").at(field));
        if !self.ids.insert(id) {
            return taken(field);
        }
        if self.paths.insert(path) { Ok(()) } else { taken("path") }
    }
}

/// Fresh names in the order in which they are asked for.
struct Names<'p> {
    prefix: &'p str,
    known: HashMap<String, String>,
}

impl Names<'_> {
    fn of(&mut self, id: &str) -> String {
        let next = self.known.len();
        self.known.entry(id.to_owned()).or_insert_with(|| format!("{}{next}", self.prefix)).clone()
    }
}

fn photo(value: Value) -> Read<FilePhoto> {
    let mut fields = Fields::of(value)?;
    let mut told = |field: &str, most| name(most)(fields.required(field)?).map_err(|wrong| wrong.at(field));
    let (id, file, path) =
        (told("id", LONGEST_ID)?, told("name", LONGEST_NAME)?, told("path", LONGEST_PATH)?);
    let mut hint = |field: &str| fields.take(field).unwrap_or_default();
    Ok(FilePhoto {
        id,
        name: file,
        path,
        kind: text(LONGEST_PATH)(hint("type")).unwrap_or_default(),
        credit: text(LONGEST_NAME)(hint("credit")).ok(),
        video: text(LONGEST_ID)(hint("video")).ok(),
        time: hint("time").as_f64(),
        measured: hint("measured").as_bool().unwrap_or(true),
        subjects: list(MOST_SUBJECTS, subject)(hint("subjects")).ok(),
        rank: whole(0..=u64::from(u32::MAX))(hint("rank")).ok(),
        like: likeness(hint("like")).ok(),
        absent: hint("absent").as_bool().unwrap_or_default(),
    })
}

fn subject(value: Value) -> Read<Value> {
    let parts = ["score", "x", "y", "width", "height"];
    let good = value["label"].is_string()
        && parts.iter().all(|part| value[part].as_f64().is_some_and(|part| (-1.0..=2.0).contains(&part)));
    if good { Ok(value) } else { Err(Wrong::new("is nothing that is found in photos")) }
}

fn likeness(value: Value) -> Read<Likeness> {
    let mut fields = Fields::of(value)?;
    let mut digits = |field: &str, counts: &[usize]| {
        let text = text(64)(fields.required(field)?)?;
        let good = counts.contains(&text.len())
            && text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'));
        if good { Ok(text) } else { Err(Wrong::new("are no digits")) }
    };
    let (hash, fingerprint) = (digits("hash", &[0, 64])?, digits("fingerprint", &[16])?);
    let mut side = |field: &str| whole(1..=LONGEST_SIDE)(fields.required(field)?);
    Ok(Likeness { hash, fingerprint, width: side("width")?, height: side("height")? })
}

fn video(value: Value) -> Read<FileVideo> {
    let mut fields = Fields::of(value)?;
    let mut told = |field: &str, most| text(most)(fields.required(field)?).map_err(|wrong| wrong.at(field));
    let (key, file, path) =
        (told("key", LONGEST_ID)?, told("name", LONGEST_NAME)?, told("path", LONGEST_PATH)?);
    let ids =
        list(MOST_PHOTOS, text(LONGEST_ID))(fields.required("ids")?).map_err(|wrong| wrong.at("ids"))?;
    let mut time =
        |field: &str| fields.take(field).and_then(|value| value.as_f64()).filter(|time| *time >= 0.0);
    let (duration, start, end) = (time("duration"), time("start").unwrap_or_default(), time("end"));
    let kind = text(LONGEST_PATH)(fields.take("type").unwrap_or_default()).unwrap_or_default();
    Ok(FileVideo { key, name: file, path, kind, ids, duration, start, end })
}

/// Parts that stand where they are needed.
#[derive(Default)]
struct Inline {
    dropped: Dropped,
}

impl Inline {
    fn own(
        &mut self,
        value: Value,
        field: &str,
        most: usize,
        read: fn(Value) -> Read<Value>,
    ) -> Read<List<Value>> {
        let values = list(most, Ok)(value)?;
        let mut seen = HashSet::new();
        let unique = |value: Value| {
            let value = read(value)?;
            let fresh = value["id"].as_str().is_some_and(|id| seen.insert(id.to_owned()));
            if fresh { Ok(Arc::new(value)) } else { Err(Wrong::new("is that of another").at("id")) }
        };
        Ok(history::kept(values, &format!("present.{field}"), &mut self.dropped, unique).into())
    }
}

impl Parts for Inline {
    fn tray(&mut self, value: Value) -> Read<List<TrayItem>> {
        let items = list(MOST_PHOTOS, project::tray_item)(value)?;
        Ok(project::tray(items.into_iter().map(Arc::new)))
    }

    fn settings(&mut self, value: Value) -> Read<Arc<PageSettings>> {
        pages::settings(value).map(Arc::new)
    }

    fn page(&mut self, value: Value) -> Read<Arc<Document>> {
        pages::page(value).map(Arc::new)
    }

    fn sheets(&mut self, value: Value) -> Read<List<Sheet>> {
        let sheet = |value| project::sheet(value, |page| pages::page(page).map(Arc::new)).map(Arc::new);
        list(MOST_SHEETS, sheet)(value).map(Into::into)
    }

    fn draft(&mut self, value: Value) -> Read<Arc<Draft>> {
        project::draft(value).map(Arc::new)
    }

    fn styles(&mut self, value: Value, field: &str) -> Read<List<Value>> {
        self.own(value, field, MOST_STYLES, project::style)
    }

    fn layouts(&mut self, value: Value, field: &str) -> Read<List<Value>> {
        self.own(value, field, MOST_LAYOUTS, project::layout)
    }
}
