//! Shots of a board as lists that cutting rooms read: which frames of which film, for how long, one behind the other. All are
//! made of one [`ShotList`], and exact to the frame: a place in a film is the frame of the board's rate that is nearest to it.
//!
//! | module | for |
//! |---|---|
//! | `csv` | a table for people and spreadsheets |
//! | `edl` | an edit decision list, CMX 3600 |
//! | `otio` | `OpenTimelineIO` |
//! | `xmeml` | XML of Final Cut Pro 7, which most programs of today still read |
//! | [`timecode`] | frames as hours, minutes, seconds and frames |

mod csv;
mod edl;
mod otio;
pub mod timecode;
mod xmeml;

use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use timecode::{Pace, Rate};

/// Shots in their order. In JSON what is empty may be missing.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(optional_fields))]
pub struct ShotList {
    /// What the album is called.
    pub title: String,
    /// Frames of a counted second, from 1 to 60; 24 where nothing is told.
    pub fps: u32,
    /// How fast such a second passes; as the clock's where nothing is told.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<Pace>", optional))]
    pub pace: Pace,
    /// Columns of one's own.
    pub columns: Vec<String>,
    /// What the columns of a table are called, in the order of [`HEADINGS`]; English where there are not as many.
    pub headings: Vec<String>,
    /// The shots.
    pub shots: Vec<ListedShot>,
}

/// One of them.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(optional_fields))]
pub struct ListedShot {
    /// Its number, counted or its own.
    pub number: String,
    /// The scene that it belongs to.
    pub scene: String,
    /// What happens.
    pub action: String,
    /// What is said.
    pub dialogue: String,
    /// What else is to be known.
    pub notes: String,
    /// How long it is, in frames; what says nothing is two seconds long.
    pub frames: Option<u32>,
    /// What stands in columns of one's own.
    pub more: BTreeMap<String, String>,
    /// The name of its picture.
    pub name: String,
    /// The film that it is a frame of.
    pub film: Option<Film>,
}

/// A place in a film.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(optional_fields))]
pub struct Film {
    /// The name of its file.
    pub name: String,
    /// Seconds from its beginning.
    pub time: f64,
    /// How long it is, in seconds, where that is known.
    pub length: Option<f64>,
}

/// The columns of a table, those of one's own apart.
pub const HEADINGS: [&str; 10] =
    ["Scene", "Shot", "Picture", "Film", "Time code", "Duration", "Frames", "Action", "Dialogue", "Notes"];

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
    /// All of them, by the endings of their files.
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
    /// `invalid-document` for what is none.
    pub fn parse(json: &str) -> Result<Self> {
        let invalid = |reason: String| Error::InvalidDocument { location: "shots".into(), reason };
        let list: Self = serde_json::from_str(json).map_err(|error| invalid(error.to_string()))?;
        if list.fps > 60 {
            return Err(invalid("have more than 60 frames a second".into()));
        }
        if !list.pace.fits(list.rate().base) {
            return Err(invalid("have a rate whose frames are not counted in this way".into()));
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

    /// The shots with their places: in their film, and behind each other.
    fn cuts(&self) -> impl Iterator<Item = Cut<'_>> {
        let rate = self.rate();
        let mut at = 0;
        self.shots.iter().map(move |shot| {
            let frames = shot.frames.map_or(2 * u64::from(rate.base), u64::from).max(1);
            let start = shot.film.as_ref().map_or(0, |film| rate.frame_at(film.time));
            let cut = Cut { shot, start, frames, at };
            at += frames;
            cut
        })
    }
}

/// A shot in its place, in frames.
struct Cut<'a> {
    shot: &'a ListedShot,
    /// Where it begins in its film; 0 for a picture of its own.
    start: u64,
    /// How long it is.
    frames: u64,
    /// Where it begins among the others.
    at: u64,
}

impl Cut<'_> {
    /// The file that it is of.
    fn file(&self) -> &str {
        self.shot.film.as_ref().map_or(&self.shot.name, |film| &film.name)
    }

    /// What it is called: its scene and number.
    fn title(&self) -> String {
        let ListedShot { scene, number, .. } = self.shot;
        if scene.is_empty() { number.clone() } else { format!("{} / {number}", line(scene)) }
    }
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
            film: film.map(|(name, time)| Film { name: name.into(), time, length: Some(60.0) }),
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
        let cuts: Vec<_> = list.cuts().map(|cut| (cut.at, cut.frames, cut.start)).collect();
        assert_eq!(cuts, [(0, 36, 0), (36, 50, 313), (86, 1, 0)]);
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
    }

    proptest! {
        #[test]
        fn no_text_breaks_a_list(text in "\\PC{0,40}", time in -1e300_f64..1e300) {
            let film = Film { name: text.clone(), time, length: None };
            let shot = ListedShot { number: text.clone(), notes: text.clone(), film: Some(film), ..ListedShot::default() };
            let list = ShotList { title: text, shots: vec![shot], ..ShotList::default() };
            for (_, kind) in Kind::ALL {
                prop_assert!(!list.written(kind).is_empty());
            }
        }
    }
}
