//! `project.json` of a project file, and the text in a page PNG: the document, the page history, and metadata
//! of each photo and video. Undo states are not included. Photos are measured again after opening. Except id,
//! name and place, their metadata is a hint: invalid values and unknown fields are ignored.

use super::draft::Draft;
use super::history::{History, keep};
use super::kept::Interner;
use super::limits::{
    ARCHIVE_ENTRIES, LONGEST_ID, LONGEST_NAME, LONGEST_PATH, LONGEST_SIDE, MOST_LAYOUTS, MOST_PHOTOS,
    MOST_SHEETS, MOST_STYLES, MOST_SUBJECTS, MOST_VIDEOS, MOST_WAITING, PROJECT,
};
use super::project::{self, List, Parts, Sheet, TrayItem};
use super::shots::Board;
use super::{Dropped, VERSION, refusal, validation, version};
use crate::error::Result;
use crate::json::{self, Fields, Read, Writer, Wrong, each, items, text_of};
use crate::layout::PageSettings;
use crate::page::Document;
use crate::raster::Matte;
use crate::raster::matte::MOST_TEXT as LONGEST_MASK;
use crate::reference::CustomFile;
use crate::subject::{Expression, Subject};
use crate::text::TextItem;
use crate::timecode::StartTimecode;
use serde_json::Value;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Identifies files of this program.
const FORMAT: &str = "inkpanel";

/// A project file without its images.
#[derive(Debug, Clone)]
pub struct ProjectFile {
    /// The document and the page history, without undo states.
    pub history: History,
    /// Its photos.
    pub photos: Vec<FilePhoto>,
    /// Its videos.
    pub videos: Vec<FileVideo>,
    /// Parts that were dropped.
    pub dropped: Dropped,
}

/// Metadata of a photo in a file.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct FilePhoto {
    /// Its id in the document.
    pub id: String,
    /// The name of its file.
    pub name: String,
    /// Its place in the archive.
    pub path: String,
    /// Media type of the file, empty if unknown.
    #[cfg_attr(feature = "typescript", ts(rename = "type"))]
    pub kind: String,
    /// Its author.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub credit: Option<String>,
    /// The video that it is a frame of.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub video: Option<String>,
    /// Seconds from the beginning of the video.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub time: Option<f64>,
    /// The number of its shot in the video, from 1.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub shot: Option<u64>,
    /// Whether it is compared with other photos.
    pub measured: bool,
    /// Detected subjects; `None` before detection.
    pub subjects: Option<Vec<Subject>>,
    /// Subject mask.
    #[cfg_attr(feature = "typescript", ts(type = "string", optional))]
    pub mask: Option<Matte>,
    /// Its place in time among the photos.
    pub rank: Option<u64>,
    /// Identity, to find the photo without its file.
    pub like: Option<Likeness>,
    /// Whether an empty frame replaces the photo.
    pub absent: bool,
}

/// How a photo is recognised.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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

/// Metadata of a video in a file.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct FileVideo {
    /// Names it.
    pub key: String,
    /// The name of its file.
    pub name: String,
    /// Its place in the archive.
    pub path: String,
    /// The type of its file.
    #[cfg_attr(feature = "typescript", ts(rename = "type"))]
    pub kind: String,
    /// Ids of photos that are frames of the video.
    pub ids: Vec<String>,
    /// Duration in seconds; `None` until the file was opened.
    pub duration: Option<f64>,
    /// Frames are taken from here,
    pub start: f64,
    /// to here.
    pub end: Option<f64>,
    /// Timecode of the first frame.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub timecode: Option<StartTimecode>,
}

impl ProjectFile {
    /// Reads the text of a project file.
    ///
    /// # Errors
    /// `damaged-project`, `newer-project` or `too-large-project`, with the place.
    pub fn parse(text: &str) -> Result<Self> {
        let read = json::parse(text, PROJECT).map_err(|wrong| wrong.at("project.json")).and_then(Self::read);
        read.map_err(|wrong| refusal(&wrong))
    }

    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value).map_err(|wrong| wrong.at("project.json"))?;
        if fields.take("format").as_ref().and_then(Value::as_str) != Some(FORMAT) {
            return Err(Wrong::new("was not saved by Inkpanel").at("project.json"));
        }
        version(&mut fields)?;
        let mut history = fields.required("history")?;
        if let Value::Object(history) = &mut history {
            history.remove("past");
            history.remove("future");
        }
        let mut parts = Inline::default();
        let mut dropped = Dropped::new();
        let history =
            History::read(history, &mut parts, &mut dropped).map_err(|wrong| match wrong.place() {
                "" => wrong.at("history"),
                _ => wrong,
            })?;
        let photos = items(fields.required("photos")?, ARCHIVE_ENTRIES)
            .and_then(|photos| each(photos, &FilePhoto::read));
        let photos = photos.map_err(|wrong| wrong.at("photos"))?;
        let videos = fields.nullable("videos").each("videos", MOST_VIDEOS, &FileVideo::read)?;
        let mut paths = HashSet::new();
        let files = photos.iter().map(|photo| [photo.id.as_str(), photo.path.as_str()]);
        distinct(files, "id", &mut paths).map_err(|wrong| wrong.at("photos"))?;
        let files = videos.iter().map(|video| [video.key.as_str(), video.path.as_str()]);
        distinct(files, "key", &mut paths).map_err(|wrong| wrong.at("videos"))?;
        parts.dropped.append(&mut dropped);
        Ok(Self { history, photos, videos, dropped: parts.dropped })
    }

    /// Gives each photo a new id, `prefix` and a number, and each video a new key, `prefix`, `v` and a
    /// number. The same file may be opened twice. Photos that are on pages, but not in the list of the file,
    /// get new ids as well.
    #[must_use]
    pub fn renamed(mut self, prefix: &str) -> Self {
        let mut names = Names { prefix: prefix.to_owned(), known: HashMap::new() };
        let mut keys = Names { prefix: format!("{prefix}v"), known: HashMap::new() };
        for photo in &mut self.photos {
            photo.id = names.of(&photo.id);
        }
        for video in &mut self.videos {
            video.key = keys.of(&video.key);
            video.ids = video.ids.iter().map(|id| names.of(id)).collect();
        }
        for photo in &mut self.photos {
            photo.video = photo.video.as_ref().map(|key| keys.of(key));
        }
        let present = Arc::make_mut(&mut self.history.present);
        present.pages.each(&mut |_, page| {
            let mut page = page.clone();
            names.on(&mut page);
            Some(page)
        });
        let mut waiting = present.waiting.to_vec();
        for word in &mut waiting {
            names.of_word(Arc::make_mut(word));
        }
        present.waiting = waiting.into();
        let board = Arc::make_mut(&mut present.board);
        board.order = board.order.iter().map(|id| names.of(id)).collect();
        let mut tray = present.tray.to_vec();
        for item in &mut tray {
            let item = Arc::make_mut(item);
            item.id = names.of(&item.id);
        }
        present.tray = tray.into();
        for shown in &mut self.history.shown {
            names.on(&mut Arc::make_mut(shown).page);
        }
        self
    }

    /// Subject masks of the photos by id: corrected masks, or detected ones.
    pub fn masks(&self) -> impl Iterator<Item = (&str, &Matte)> {
        self.photos.iter().filter_map(|FilePhoto { id, mask, .. }| {
            let mask = self.history.present.corrected_mask(id).or(mask.as_ref())?;
            Some((id.as_str(), mask))
        })
    }

    /// Writes the normalised text in the format of the input, with the list of dropped parts.
    #[must_use]
    pub fn write(&self) -> String {
        let mut parts = Interner::inline();
        let mut out = Writer::default();
        out.open(b'{');
        out.key("format").text(FORMAT);
        out.key("version").whole(VERSION);
        out.key("history").open(b'{');
        parts.state(out.key("present"), &self.history.present);
        parts.shown(out.key("shown"), &self.history.shown);
        out.close(b'}');
        out.key("photos").list(&self.photos, &|out, photo| photo.write(out));
        out.key("videos").list(&self.videos, &|out, video| video.write(out));
        out.key("dropped").texts(&self.dropped);
        out.close(b'}');
        out.finish()
    }
}

/// Checks that the names in a list of files differ, and that no file shares its path with another or with one of `paths`.
/// Keys of videos and ids of photos are separate: the key of a video is usually the id of its first frame.
///
/// # Errors
/// The first name or path that repeats, with its place in the list.
fn distinct<'f>(
    files: impl Iterator<Item = [&'f str; 2]>,
    field: &str,
    paths: &mut HashSet<&'f str>,
) -> Read<()> {
    let mut names = HashSet::new();
    for (i, [name, path]) in files.enumerate() {
        for (field, fresh) in [(field, names.insert(name)), ("path", paths.insert(path))] {
            if !fresh {
                return Err(Wrong::new("is used twice").at(field).in_list(i));
            }
        }
    }
    Ok(())
}

/// Generates short names in the order of the requests.
struct Names {
    prefix: String,
    known: HashMap<String, usize>,
}

impl Names {
    #[inline(never)]
    fn of(&mut self, id: &str) -> String {
        let next = self.known.len();
        let number = *self.known.entry(id.to_owned()).or_insert(next);
        format!("{}{number}", self.prefix)
    }

    fn on(&mut self, page: &mut Arc<Document>) {
        let page = Arc::make_mut(page);
        for id in page.order.iter_mut().chain(page.panels.iter_mut().filter_map(|panel| panel.photo.as_mut()))
        {
            *id = self.of(id);
        }
        for word in &mut page.words {
            self.of_word(word);
        }
    }

    fn of_word(&mut self, word: &mut TextItem) {
        if let Some(photo) = &mut word.photo {
            *photo = self.of(photo);
        }
    }
}

impl FilePhoto {
    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let (id, name) = (fields.name("id", LONGEST_ID)?, fields.name("name", LONGEST_NAME)?);
        let path = fields.name("path", LONGEST_PATH)?;
        let time = fields.take("time").and_then(|time| time.as_f64());
        let shot = fields.whole("shot", 1, u64::from(u32::MAX)).unwrap_or_default();
        let measured = !matches!(fields.take("measured"), Some(Value::Bool(false)));
        let absent = matches!(fields.take("absent"), Some(Value::Bool(true)));
        let subjects = fields.take("subjects").and_then(|all| items(all, MOST_SUBJECTS).ok());
        let mask = fields.take("mask").and_then(|mask| text_of(mask, LONGEST_MASK).ok());
        let mut text = |name: &str, most| fields.take(name).and_then(|value| text_of(value, most).ok());
        Ok(Self {
            id,
            name,
            path,
            kind: text("type", LONGEST_PATH).unwrap_or_default(),
            credit: text("credit", LONGEST_NAME),
            video: text("video", LONGEST_ID),
            time,
            shot,
            measured,
            subjects: subjects.and_then(|subjects| subjects.into_iter().map(subject).collect()),
            mask: mask.and_then(|mask| Matte::try_from(mask).ok()),
            rank: fields.whole("rank", 0, u64::from(u32::MAX)).unwrap_or_default(),
            like: fields.take("like").and_then(|like| Likeness::read(like).ok()),
            absent,
        })
    }

    fn write(&self, out: &mut Writer) {
        out.open(b'{');
        let texts = [("id", &self.id), ("name", &self.name), ("path", &self.path), ("type", &self.kind)];
        for (name, text) in texts {
            out.key(name).text(text);
        }
        for (name, text) in [("credit", &self.credit), ("video", &self.video)] {
            if let Some(text) = text {
                out.key(name).text(text);
            }
        }
        if let Some(time) = self.time {
            out.key("time").number(time);
        }
        if let Some(shot) = self.shot {
            out.key("shot").whole(shot);
        }
        out.key("measured").flag(self.measured);
        match &self.subjects {
            Some(subjects) => out.key("subjects").list(subjects, &|out, subject| out.put(subject)),
            None => out.key("subjects").null(),
        }
        if let Some(mask) = &self.mask {
            out.key("mask").text(mask.text());
        }
        match self.rank {
            Some(rank) => out.key("rank").whole(rank),
            None => out.key("rank").null(),
        }
        match &self.like {
            Some(like) => like.write(out.key("like")),
            None => out.key("like").null(),
        }
        out.key("absent").flag(self.absent);
        out.close(b'}');
    }
}

fn subject(value: Value) -> Option<Subject> {
    serde_json::from_value(value).ok().filter(is_valid)
}

fn is_valid(subject: &Subject) -> bool {
    let Subject { x, y, width, height, score, points, expression, light, .. } = subject;
    let mut numbers =
        [x, y, width, height, score].into_iter().chain(points.iter().flatten().flatten()).chain(light);
    numbers.all(|number| (-1.0..=2.0).contains(number))
        && expression.as_ref().is_none_or(Expression::is_sound)
}

impl Likeness {
    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let mut digits = |name: &str, count: usize| {
            let text = fields.text(name, 64)?.unwrap_or_default();
            let good = (text.len() == count || (text.is_empty() && count == 64))
                && text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'));
            if good { Ok(text) } else { Err(Wrong::new("must be hexadecimal digits")) }
        };
        let (hash, fingerprint) = (digits("hash", 64)?, digits("fingerprint", 16)?);
        let (width, height) =
            (fields.count("width", 1, LONGEST_SIDE)?, fields.count("height", 1, LONGEST_SIDE)?);
        Ok(Self { hash, fingerprint, width, height })
    }

    fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("hash").text(&self.hash);
        out.key("fingerprint").text(&self.fingerprint);
        out.key("width").whole(self.width);
        out.key("height").whole(self.height);
        out.close(b'}');
    }
}

impl FileVideo {
    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let (key, name) = (fields.name("key", LONGEST_ID)?, fields.name("name", LONGEST_NAME)?);
        let path = fields.name("path", LONGEST_PATH)?;
        let ids = items(fields.required("ids")?, MOST_PHOTOS)
            .and_then(|ids| each(ids, &|id| text_of(id, LONGEST_ID)));
        let ids = ids.map_err(|wrong| wrong.at("ids"))?;
        let kind = fields.take("type").and_then(|kind| text_of(kind, LONGEST_PATH).ok()).unwrap_or_default();
        let mut time = |name: &str| fields.take(name)?.as_f64().filter(|time| *time >= 0.0);
        let (duration, start, end) = (time("duration"), time("start").unwrap_or_default(), time("end"));
        let timecode = fields.take("timecode").and_then(|start| serde_json::from_value(start).ok());
        let timecode = timecode.filter(|start: &StartTimecode| start.is_valid());
        Ok(Self { key, name, path, kind, ids, duration, start, end, timecode })
    }

    fn write(&self, out: &mut Writer) {
        out.open(b'{');
        let texts = [("key", &self.key), ("name", &self.name), ("path", &self.path), ("type", &self.kind)];
        for (name, text) in texts {
            out.key(name).text(text);
        }
        out.key("ids").texts(&self.ids);
        for (name, time) in [("duration", self.duration), ("start", Some(self.start)), ("end", self.end)] {
            // Nothing has no end, and is written as null.
            out.key(name).number(time.unwrap_or(f64::NAN));
        }
        if let Some(StartTimecode { frame, fps, drop }) = self.timecode {
            out.key("timecode").open(b'{');
            out.key("frame").whole(u64::from(frame));
            out.key("fps").whole(u64::from(fps));
            out.key("drop").flag(drop);
            out.close(b'}');
        }
        out.close(b'}');
    }
}

/// Parts that are inside the state.
#[derive(Default)]
struct Inline {
    dropped: Dropped,
}

impl Inline {
    fn own(
        &mut self,
        values: Vec<Value>,
        field: &str,
        read: fn(Value) -> Read<Arc<CustomFile>>,
    ) -> List<CustomFile> {
        let mut seen = HashSet::new();
        let mut all = Vec::new();
        keep(values, &format!("present.{field}"), &mut self.dropped, &mut |value| {
            let value = read(value)?;
            if !seen.insert(value.id().to_owned()) {
                return Err(Wrong::new("is used twice").at("id"));
            }
            all.push(value);
            Ok(())
        });
        all.into()
    }
}

impl Parts for Inline {
    fn tray(&mut self, value: Value) -> Read<List<TrayItem>> {
        Ok(project::tray(each(items(value, MOST_PHOTOS)?, &TrayItem::read)?))
    }

    fn settings(&mut self, value: Value) -> Read<Arc<PageSettings>> {
        validation::settings(value)
    }

    fn page(&mut self, value: Value) -> Read<Arc<Document>> {
        validation::page(value)
    }

    fn sheets(&mut self, value: Value) -> Read<List<Sheet>> {
        Ok(each(items(value, MOST_SHEETS)?, &|value| Sheet::read(value, &validation::page))?.into())
    }

    fn draft(&mut self, value: Value) -> Read<Arc<Draft>> {
        Draft::read(value)
    }

    fn board(&mut self, value: Value) -> Read<Arc<Board>> {
        Board::shared(value)
    }

    fn waiting(&mut self, value: Value) -> Read<List<TextItem>> {
        Ok(each(items(value, MOST_WAITING)?, &validation::waiting)?.into())
    }

    fn styles(&mut self, value: Value, field: &str) -> Read<List<CustomFile>> {
        Ok(self.own(items(value, MOST_STYLES)?, field, CustomFile::style))
    }

    fn layouts(&mut self, value: Value, field: &str) -> Read<List<CustomFile>> {
        Ok(self.own(items(value, MOST_LAYOUTS)?, field, CustomFile::layout))
    }
}
