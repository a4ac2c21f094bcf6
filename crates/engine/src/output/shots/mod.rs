//! Edit lists for video editors: source frames and durations of shots, in sequence. All formats are made from
//! one [`ShotList`] and are exact to the frame. A time in a video is rounded to the nearest frame of the
//! storyboard's rate.
//!
//! | module | for |
//! |---|---|
//! | `csv` | a table for people and spreadsheets |
//! | `edl` | an edit decision list, CMX 3600 |
//! | `otio` | `OpenTimelineIO` |
//! | `xmeml` | XML of Final Cut Pro 7, which most programs of today still read |
//! | [`timecode`] | frames as hours, minutes, seconds and frames (crate `inkpanel-model`) |

mod csv;
mod edl;
mod otio;
mod xmeml;

use crate::error::{Error, Result};
pub use inkpanel_model::timecode;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;
use timecode::{Pace, Rate, StartTimecode};

/// Shots in their order. In JSON, empty fields may be missing.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ShotList {
    /// Title of the album.
    pub title: String,
    /// Frames per counted second, 1 to 60. Default: 24.
    pub fps: u32,
    /// Timecode pace. Default: real time.
    #[cfg_attr(test, ts(as = "Option<Pace>", optional))]
    pub pace: Pace,
    /// Names of custom columns.
    pub columns: Vec<String>,
    /// Headings of the table, in the order of [`HEADINGS`]. English headings replace missing ones.
    pub headings: Vec<String>,
    /// The shots.
    pub shots: Vec<ListedShot>,
}

/// One of them.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ListedShot {
    /// Its number, counted or its own.
    pub number: String,
    /// The scene that it belongs to.
    pub scene: String,
    /// Action.
    pub action: String,
    /// Dialogue.
    pub dialogue: String,
    /// Captions.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub caption: String,
    /// Sounds.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub sound: String,
    /// Notes.
    pub notes: String,
    /// Duration in frames. Default: two seconds.
    pub frames: Option<u32>,
    /// Values of custom columns.
    pub more: BTreeMap<String, String>,
    /// File name of the photo.
    pub name: String,
    /// The video, if the photo is a frame.
    pub film: Option<Film>,
}

/// Tolerance in frames at the end of a source, because its length was rounded to milliseconds.
const ROUNDED: f64 = 0.1;

/// A position in a video.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Film {
    /// Identifies the video, because others may have the same name. Without keys, videos with one name are one video.
    pub key: String,
    /// The name of its file.
    pub name: String,
    /// Seconds from the first frame.
    pub time: f64,
    /// Duration in seconds, if known.
    pub length: Option<f64>,
    /// Timecode of the first frame.
    pub timecode: Option<StartTimecode>,
}

/// Standard columns of the table, without custom columns. A table has the last two only if a shot has them.
pub const HEADINGS: [&str; 12] = [
    "Scene",
    "Shot",
    "Picture",
    "Film",
    "Time code",
    "Duration",
    "Frames",
    "Action",
    "Dialogue",
    "Notes",
    "Caption",
    "Sound",
];

/// A kind of list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A table of values apart by commas.
    Csv,
    /// An edit decision list.
    Edl,
    /// `OpenTimelineIO`.
    Otio,
    /// XML of Final Cut Pro 7.
    Xml,
}

impl Kind {
    /// All kinds, by file extension.
    pub const ALL: [(&str, Self); 4] =
        [("csv", Self::Csv), ("edl", Self::Edl), ("otio", Self::Otio), ("xml", Self::Xml)];

    /// The kind that the ending of a file names.
    #[must_use]
    pub fn of(ending: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| ending.eq_ignore_ascii_case(known)).map(|(_, kind)| *kind)
    }
}

impl ShotList {
    /// Reads a list.
    ///
    /// # Errors
    /// Returns `invalid-document` if the JSON is not a valid list.
    pub fn parse(json: &str) -> Result<Self> {
        let invalid = |reason: String| Error::InvalidDocument { location: "shots".into(), reason };
        let list: Self = serde_json::from_str(json).map_err(|error| invalid(error.to_string()))?;
        if list.fps > 60 {
            return Err(invalid("must have at most 60 frames per second".into()));
        }
        if !list.pace.fits(list.rate().base) {
            return Err(invalid("pace: is not valid for this frame rate".into()));
        }
        let mut starts = list.shots.iter().filter_map(|shot| shot.film.as_ref()?.timecode);
        if !starts.all(StartTimecode::is_valid) {
            return Err(invalid("timecode: must be a frame of a day at 1 to 120 frames per second".into()));
        }
        Ok(list)
    }

    /// The text of the file of a kind.
    #[must_use]
    pub fn written(&self, kind: Kind) -> String {
        match kind {
            Kind::Csv => csv::write(self),
            Kind::Edl => edl::write(self),
            Kind::Otio => otio::write(self),
            Kind::Xml => xmeml::write(self),
        }
    }

    /// How its frames are counted.
    #[must_use]
    pub fn rate(&self) -> Rate {
        Rate { base: if self.fps == 0 { 24 } else { self.fps }, pace: self.pace }
    }

    /// The shots with their positions in their source and in the list.
    fn cuts(&self) -> Vec<Cut<'_>> {
        let rate = self.rate();
        let mut sources = Sources::default();
        let mut at = 0;
        let mut cuts = Vec::with_capacity(self.shots.len());
        for (i, shot) in self.shots.iter().enumerate() {
            let cut = sources.cut(i, shot, rate, at);
            at += cut.frames;
            cuts.push(cut);
        }
        cuts
    }
}

/// The files that shots are from.
#[derive(Default)]
struct Sources<'a> {
    /// The first shot of each video.
    films: HashMap<&'a str, Source>,
    /// Number of files with a name.
    names: HashMap<&'a str, u64>,
}

/// A file that shots are from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Source {
    /// The number of the first shot that is from it.
    first: usize,
    /// 1 for the first file of its name, 2 for the second.
    namesake: u64,
}

impl<'a> Sources<'a> {
    fn cut(&mut self, i: usize, shot: &'a ListedShot, rate: Rate, at: u64) -> Cut<'a> {
        let usual = 2 * u64::from(rate.base);
        let wanted = shot.frames.map_or(usual, u64::from).max(1);
        let Some(film) = &shot.film else {
            let source = self.add(i, &shot.name);
            return Cut {
                shot,
                source,
                start: 0,
                wanted,
                frames: wanted,
                length: Some(wanted),
                origin: 0,
                counting: rate,
                at,
            };
        };
        let key = if film.key.is_empty() { &film.name } else { &film.key };
        let known = self.films.get(key.as_str()).copied();
        let source = known.unwrap_or_else(|| {
            let source = self.add(i, &film.name);
            self.films.insert(key, source);
            source
        });
        let counting = film.timecode.map_or(rate, |start| start.counting_at(rate));
        let origin = film.timecode.map_or(0, |start| start.frame_in(counting));
        let length = film.length.map(|seconds| rate.whole_frames(seconds, ROUNDED).max(1));
        let start = rate.frame_at(film.time).min(length.map_or(u64::MAX, |length| length - 1));
        let frames = wanted.min(length.map_or(u64::MAX, |length| length - start));
        Cut { shot, source, start, wanted, frames, length, origin, counting, at }
    }

    fn add(&mut self, first: usize, name: &'a str) -> Source {
        let namesake = self.names.entry(name).or_default();
        *namesake += 1;
        Source { first, namesake: *namesake }
    }
}

/// A shot in its place, in frames of the list's rate.
struct Cut<'a> {
    shot: &'a ListedShot,
    source: Source,
    /// Start in its source; 0 for a photo.
    start: u64,
    /// Length on the board.
    wanted: u64,
    /// Length, limited by the rest of its source.
    frames: u64,
    /// Length of its source, if known.
    length: Option<u64>,
    /// The timecode of the first frame of its source, in frames since midnight.
    origin: u64,
    /// Rate and drop-frame flag of the timecode of its source.
    counting: Rate,
    /// Start among the other shots.
    at: u64,
}

impl Cut<'_> {
    /// The file that it is of.
    fn file(&self) -> &str {
        self.shot.film.as_ref().map_or(&self.shot.name, |film| &film.name)
    }

    /// Path of its file relative to the list. If several files have one name, the first is next to the list, and each of the
    /// others is in a folder with its number.
    fn url(&self) -> String {
        let name = encoded(self.file());
        match self.source.namesake {
            1 => name,
            number => format!("{number}/{name}"),
        }
    }

    /// The timecode of a frame of its source.
    fn timecode(&self, frame: u64) -> String {
        self.counting.timecode(self.origin + frame)
    }

    /// Title: scene and number.
    fn title(&self) -> String {
        let ListedShot { scene, number, .. } = self.shot;
        if scene.is_empty() { number.clone() } else { format!("{} / {number}", line(scene)) }
    }
}

/// A name of a file as a part of a URL.
fn encoded(name: &str) -> String {
    let mut out = String::new();
    for byte in name.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            out.push(char::from(byte));
        } else {
            // Writing into text never fails.
            let _ = write!(out, "%{byte:02X}");
        }
    }
    out
}

/// A text in one line.
fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    pub(super) fn list(fps: u32) -> ShotList {
        let shot = |number: &str, frames, film: Option<(&str, f64)>| ListedShot {
            number: number.into(),
            scene: "1".into(),
            action: format!("She opens \"{number}\",\nthe door."),
            frames,
            name: format!("{number} ä.jpg"),
            film: film.map(|(name, time)| Film {
                name: name.into(),
                time,
                length: Some(60.0),
                ..Film::default()
            }),
            ..ListedShot::default()
        };
        let shots = vec![
            shot("1", Some(36), None),
            shot("4A", None, Some(("night.mp4", 12.52))),
            shot("2", Some(1), None),
        ];
        let columns = vec!["Lens".into()];
        ShotList { title: "One & two".into(), fps, columns, shots, ..ShotList::default() }
    }

    #[test]
    fn shots_stand_one_behind_the_other_and_where_they_are_in_their_film() {
        let list = list(25);
        let cuts: Vec<_> = list.cuts().iter().map(|cut| (cut.at, cut.frames, cut.start)).collect();
        assert_eq!(cuts, [(0, 36, 0), (36, 50, 313), (86, 1, 0)]);
    }

    #[test]
    fn no_shot_is_longer_than_the_rest_of_its_film() {
        let film = |key: &str, time| Film { key: key.into(), name: "a.mp4".into(), time, ..Film::default() };
        let shot = |frames, film: Film| ListedShot { frames, film: Some(film), ..ListedShot::default() };
        let of = |frames, time, length| shot(frames, Film { length: Some(length), ..film("a", time) });
        let shots = vec![
            of(None, 1.2, 2.0),
            of(Some(500), 1.2, 2.0),
            of(Some(3), 1.2, 2.0),
            // Beyond the end, without a length, and a length that was rounded down.
            of(None, 9.0, 2.0),
            of(None, 1.0, 0.0),
            shot(None, film("a", 9.0)),
            of(None, 1.0, 1.999),
            // A frame and a half of the list: the second one is not there.
            of(None, 0.0, 0.06),
        ];
        let list = ShotList { fps: 25, shots, ..ShotList::default() };
        let cuts: Vec<_> = list.cuts().iter().map(|cut| (cut.start, cut.frames, cut.length)).collect();
        let two = Some(50);
        assert_eq!(
            cuts,
            [
                (30, 20, two),
                (30, 20, two),
                (30, 3, two),
                (49, 1, two),
                (0, 1, Some(1)),
                (225, 50, None),
                (25, 25, two),
                (0, 1, Some(1)),
            ]
        );
    }

    #[test]
    fn files_of_one_name_are_as_many_sources_as_they_are() {
        let film = |key: &str| Some(Film { key: key.into(), name: "C0001.MP4".into(), ..Film::default() });
        let shot = |name: &str, film| ListedShot { name: name.into(), film, ..ListedShot::default() };
        let shots = vec![
            shot("frame", film("v1")),
            shot("frame", film("v2")),
            shot("frame", film("v1")),
            shot("a b.jpg", None),
            shot("a b.jpg", None),
            shot("frame", film("")),
            shot("frame", film("")),
        ];
        let list = ShotList { shots, ..ShotList::default() };
        let cuts = list.cuts();
        let sources: Vec<_> = cuts.iter().map(|cut| (cut.source.first, cut.source.namesake)).collect();
        assert_eq!(sources, [(0, 1), (1, 2), (0, 1), (3, 1), (4, 2), (5, 3), (5, 3)]);
        let urls: Vec<_> = cuts.iter().map(Cut::url).collect();
        let of = |number: usize| ["C0001.MP4", "2/C0001.MP4", "3/C0001.MP4"][number].to_owned();
        assert_eq!(urls, [of(0), of(1), of(0), "a%20b.jpg".into(), "2/a%20b.jpg".into(), of(2), of(2)]);
    }

    #[test]
    fn a_list_of_anything_else_is_refused() {
        assert!(ShotList::parse("{\"fps\":25,\"shots\":[{\"frames\":-1}]}").is_err());
        assert!(ShotList::parse("{\"fps\":2500}").is_err() && ShotList::parse("[").is_err());
        assert_eq!(ShotList::parse("{}").unwrap().rate(), Rate { base: 24, pace: Pace::Clock });
        for (fps, pace, fits) in
            [(24, "ntsc", true), (30, "drop", true), (24, "drop", false), (25, "ntsc", false)]
        {
            let list = format!("{{\"fps\":{fps},\"pace\":\"{pace}\"}}");
            assert_eq!(ShotList::parse(&list).is_ok(), fits, "{list}");
        }
        for (start, valid) in [
            (r#"{"frame":0,"fps":25}"#, true),
            (r#"{"frame":2160000,"fps":25}"#, false),
            (r#"{"frame":0,"fps":0}"#, false),
            (r#"{"frame":0,"fps":25,"drop":true}"#, false),
            (r#"{"frame":-1,"fps":25}"#, false),
            (r#""10:00:00:00""#, false),
        ] {
            let list = format!("{{\"shots\":[{{\"film\":{{\"timecode\":{start}}}}}]}}");
            assert_eq!(ShotList::parse(&list).is_ok(), valid, "{list}");
        }
    }

    proptest! {
        #[test]
        fn no_text_breaks_a_list(text in "\\PC{0,40}", time in -1e300_f64..1e300) {
            let film = Film { name: text.clone(), time, ..Film::default() };
            let shot = ListedShot { number: text.clone(), notes: text.clone(), film: Some(film), ..ListedShot::default() };
            let list = ShotList { title: text, shots: vec![shot], ..ShotList::default() };
            for (_, kind) in Kind::ALL {
                prop_assert!(!list.written(kind).is_empty());
            }
        }
    }
}
