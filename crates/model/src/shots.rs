//! Shot metadata of photos, and settings of the storyboard. The metadata of a shot is stored with its photo
//! in the tray, so it is saved, undone and moved with the photo. The order of the shots, the frame rate and
//! the custom columns belong to the project.

use super::limits::{
    LONGEST_FIELD, LONGEST_ID, LONGEST_LABEL, LONGEST_LOGO, LONGEST_NAME, MOST_COLUMNS, MOST_PHOTOS,
    MOST_SHOT_FRAMES,
};
use crate::json::{Fields, Read, Writer, Wrong, text_of};
use crate::timecode::Pace;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// Frame rates of shot durations, in frames per second.
pub const RATES: [u32; 3] = [24, 25, 30];
/// How fast a second of a board may pass, by name.
const PACES: [(&str, Pace); 3] = [("clock", Pace::Clock), ("ntsc", Pace::Ntsc), ("drop", Pace::Drop)];
/// Frames that fit on a sheet of a board.
pub const FRAMES: [u32; 8] = [1, 2, 3, 4, 6, 8, 9, 12];
/// Aspect ratios (width over height) of storyboard frames, by common name.
pub const ASPECTS: [(&str, f64); 6] = [
    ("2.39", 2.39),
    ("1.85", 1.85),
    ("16:9", 16.0 / 9.0),
    ("4:3", 4.0 / 3.0),
    ("1:1", 1.0),
    ("9:16", 9.0 / 16.0),
];
/// Default duration of a shot in seconds.
pub const USUAL_SECONDS: u32 = 2;

/// Metadata of a shot. Empty fields are unset.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Shot {
    /// The scene that it belongs to.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub scene: String,
    /// A custom number, such as 4A. Without one the shot is numbered automatically.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub number: String,
    /// Action.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub action: String,
    /// Dialogue.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub dialogue: String,
    /// Captions.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub caption: String,
    /// Sounds.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub sound: String,
    /// Notes.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub notes: String,
    /// How long it is, in frames of the board's rate.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub frames: Option<u32>,
    /// Values of custom columns by name.
    #[cfg_attr(
        feature = "typescript",
        ts(as = "Option<std::collections::BTreeMap<String, String>>", optional)
    )]
    pub more: Map<String, Value>,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// How the shots of a project are counted, ordered and laid out.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Board {
    /// Frames of a counted second, one of [`RATES`].
    pub fps: u32,
    /// Timecode pace (real time or NTSC 1000/1001). Default: real time.
    #[cfg_attr(feature = "typescript", ts(as = "Option<Pace>", optional))]
    pub pace: Pace,
    /// Names of custom columns, without duplicates.
    pub columns: Vec<String>,
    /// Frames on a sheet, one of [`FRAMES`].
    pub frames: u32,
    /// The name of the frames' aspect, one of [`ASPECTS`].
    pub aspect: String,
    /// Whether the fields are next to the frames instead of under them.
    pub beside: bool,
    /// Whether ruled lines for handwriting replace the fields.
    pub ruled: bool,
    /// Who made it, for the head of the sheets.
    pub author: String,
    /// Date in the header, as text.
    pub date: String,
    /// Logo in the header: a PNG file as a data URL. Empty for no logo.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub logo: String,
    /// Photos that the user ordered. The other photos keep their automatic position.
    pub order: Vec<String>,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

impl Default for Board {
    fn default() -> Self {
        Self {
            fps: RATES[0],
            pace: Pace::Clock,
            columns: Vec::new(),
            frames: 6,
            aspect: "16:9".into(),
            beside: false,
            ruled: false,
            author: String::new(),
            date: String::new(),
            logo: String::new(),
            order: Vec::new(),
            rest: Map::new(),
        }
    }
}

impl Shot {
    /// Whether all fields are unset.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    pub(crate) fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let mut shot = Self::default();
        for (name, most, field) in [
            ("scene", LONGEST_LABEL, &mut shot.scene),
            ("number", LONGEST_LABEL, &mut shot.number),
            ("action", LONGEST_FIELD, &mut shot.action),
            ("dialogue", LONGEST_FIELD, &mut shot.dialogue),
            ("caption", LONGEST_FIELD, &mut shot.caption),
            ("sound", LONGEST_FIELD, &mut shot.sound),
            ("notes", LONGEST_FIELD, &mut shot.notes),
        ] {
            *field = fields.nullable(name).text(name, most)?.unwrap_or_default();
        }
        let frames = fields.nullable("frames").whole("frames", 1, u64::from(MOST_SHOT_FRAMES))?;
        shot.frames = frames.map(|frames| frames as u32);
        shot.more = fields.nullable("more").part("more", &mut more)?.unwrap_or_default();
        shot.rest = fields.rest();
        Ok(shot)
    }

    pub(crate) fn write(&self, out: &mut Writer) {
        out.open(b'{');
        for (name, field) in [
            ("scene", &self.scene),
            ("number", &self.number),
            ("action", &self.action),
            ("dialogue", &self.dialogue),
            ("caption", &self.caption),
            ("sound", &self.sound),
            ("notes", &self.notes),
        ] {
            if !field.is_empty() {
                out.key(name).text(field);
            }
        }
        if let Some(frames) = self.frames {
            out.key("frames").whole(u64::from(frames));
        }
        if !self.more.is_empty() {
            out.key("more").open(b'{');
            out.rest(&self.more);
            out.close(b'}');
        }
        out.rest(&self.rest);
        out.close(b'}');
    }
}

/// Reads the values of custom columns. Empty texts are dropped.
fn more(value: Value) -> Read<Map<String, Value>> {
    let told = Fields::of(value)?.rest();
    if told.len() > MOST_COLUMNS {
        return Err(Wrong::beyond("has too many columns"));
    }
    let mut more = Map::new();
    for (name, value) in told {
        text_of(name.clone().into(), LONGEST_LABEL)?;
        let text = text_of(value, LONGEST_FIELD).map_err(|wrong| wrong.at(&name))?;
        if !text.is_empty() {
            more.insert(name, text.into());
        }
    }
    Ok(more)
}

impl Board {
    pub(crate) fn shared(value: Value) -> Read<Arc<Self>> {
        Self::read(value).map(Arc::new)
    }

    fn read(value: Value) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let mut board = Self::default();
        if let Some(fps) = one_of(&mut fields, "fps", &RATES)? {
            board.fps = fps;
        }
        if let Some(told) = fields.nullable("pace").text("pace", LONGEST_LABEL)? {
            let pace = PACES.iter().find(|(name, _)| *name == told).map(|(_, pace)| *pace);
            let pace = pace.filter(|pace| pace.fits(board.fps));
            board.pace = pace.ok_or_else(|| Wrong::new("is not valid for this frame rate").at("pace"))?;
        }
        if let Some(frames) = one_of(&mut fields, "frames", &FRAMES)? {
            board.frames = frames;
        }
        if let Some(aspect) = fields.text("aspect", LONGEST_LABEL)? {
            if !ASPECTS.iter().any(|(name, _)| *name == aspect) {
                return Err(Wrong::new("is not a valid aspect ratio").at("aspect"));
            }
            board.aspect = aspect;
        }
        board.columns = fields.each("columns", MOST_COLUMNS, &|name| text_of(name, LONGEST_LABEL))?;
        let mut seen = HashSet::new();
        if !board.columns.iter().all(|name| !name.is_empty() && seen.insert(name)) {
            return Err(Wrong::new("must be unique and not empty").at("columns"));
        }
        (board.beside, board.ruled) = (fields.flag("beside")?, fields.flag("ruled")?);
        board.author = fields.text("author", LONGEST_NAME)?.unwrap_or_default();
        board.date = fields.text("date", LONGEST_NAME)?.unwrap_or_default();
        board.logo = fields.nullable("logo").text("logo", LONGEST_LOGO)?.unwrap_or_default();
        if !board.logo.is_empty() && logo_file(&board.logo).is_none() {
            let shape = "must be a PNG data URL (data:image/png;base64,...)";
            return Err(Wrong::new(shape).at("logo"));
        }
        board.order = fields.each("order", MOST_PHOTOS, &|id| text_of(id, LONGEST_ID))?;
        board.rest = fields.rest();
        Ok(board)
    }

    pub(crate) fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("fps").whole(u64::from(self.fps));
        // The default is omitted, as in old projects.
        if let Some((name, _)) = PACES.iter().find(|(_, pace)| *pace == self.pace && *pace != Pace::Clock) {
            out.key("pace").text(name);
        }
        out.key("columns").texts(&self.columns);
        out.key("frames").whole(u64::from(self.frames));
        out.key("aspect").text(&self.aspect);
        out.key("beside").flag(self.beside);
        out.key("ruled").flag(self.ruled);
        out.key("author").text(&self.author);
        out.key("date").text(&self.date);
        if !self.logo.is_empty() {
            out.key("logo").text(&self.logo);
        }
        out.key("order").texts(&self.order);
        out.rest(&self.rest);
        out.close(b'}');
    }

    /// Adapts a shot to this board, which replaces another board. Durations keep their seconds, and values
    /// follow renamed columns. `None` if nothing changes.
    pub(crate) fn taken(&self, before: &Self, own: &Shot) -> Option<Shot> {
        let mut shot = own.clone();
        if let Some(frames) = shot.frames {
            let same = u64::from(frames) * u64::from(self.fps) * 2 / u64::from(before.fps.max(1));
            shot.frames = Some((same.div_ceil(2).max(1) as u32).min(MOST_SHOT_FRAMES));
        }
        if self.columns != before.columns {
            shot.more = shot
                .more
                .into_iter()
                .filter_map(|(name, text)| Some((self.column(before, name)?, text)))
                .collect();
        }
        (shot != *own).then_some(shot)
    }

    /// The new name of a renamed column. `None` if it was deleted.
    fn column(&self, before: &Self, name: String) -> Option<String> {
        if self.columns.contains(&name) {
            return Some(name);
        }
        // With an equal number of columns, the column at the same index was renamed.
        let place = before.columns.iter().position(|known| *known == name)?;
        let same = self.columns.len() == before.columns.len();
        self.columns.get(place).filter(|now| same && !before.columns.contains(now)).cloned()
    }
}

/// The PNG file in the data URL of a logo. `None` for any other text. The pixels are not checked.
#[must_use]
pub fn logo_file(url: &str) -> Option<Vec<u8>> {
    let file = STANDARD.decode(url.strip_prefix("data:image/png;base64,")?).ok()?;
    file.starts_with(b"\x89PNG\r\n\x1a\n").then_some(file)
}

fn one_of(fields: &mut Fields, name: &str, known: &[u32]) -> Read<Option<u32>> {
    let Some(told) = fields.whole(name, 0, u64::from(u32::MAX))? else { return Ok(None) };
    let told = told as u32;
    if known.contains(&told) { Ok(Some(told)) } else { Err(Wrong::new("is not a valid choice").at(name)) }
}

/// The shots that an edit describes: an object of shots by the ids of their photos.
pub(crate) fn described(value: Value) -> Read<Vec<(String, Shot)>> {
    let all = Fields::of(value)?.rest();
    if all.len() > MOST_PHOTOS {
        return Err(Wrong::beyond("must not be more than the photos"));
    }
    let shot = |(id, shot): (String, Value)| {
        let shot = Shot::read(shot).map_err(|wrong| wrong.at(&id))?;
        Ok((id, shot))
    };
    all.into_iter().map(shot).collect()
}

/// Photos in the order of a board: the photos that the user ordered, and each other photo after its automatic
/// predecessor. `photos`: all of them, in their own order.
#[must_use]
pub fn ordered<'p>(order: &[String], photos: &[&'p str]) -> Vec<&'p str> {
    let there: HashSet<&str> = photos.iter().copied().collect();
    let told: HashSet<&str> = order.iter().map(String::as_str).collect();
    let known = order.iter().filter(|id| there.contains(id.as_str()));
    let mut seen = HashSet::new();
    let mut all: Vec<&str> = known
        .filter_map(|id| photos.iter().copied().find(|photo| photo == id))
        .filter(|id| seen.insert(*id))
        .collect();
    let mut before = None;
    for &photo in photos {
        if !told.contains(photo) {
            let at = before.and_then(|before| all.iter().position(|id| *id == before)).map_or(0, |at| at + 1);
            all.insert(at, photo);
        }
        before = Some(photo);
    }
    all
}

/// Shot numbers in order: custom numbers, and automatic ones for the other shots.
#[must_use]
pub fn numbers<'n>(own: impl IntoIterator<Item = &'n str>) -> Vec<String> {
    let mut counted = 0_u32;
    let number = |own: &str| {
        if !own.trim().is_empty() {
            return own.trim().to_owned();
        }
        counted += 1;
        counted.to_string()
    };
    own.into_iter().map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_counted_past_those_of_ones_own() {
        assert_eq!(numbers(["", "", "2A", " ", "9"]), ["1", "2", "2A", "3", "9"]);
    }

    #[test]
    fn photos_that_nobody_put_anywhere_follow_the_one_before_them() {
        let order = ["c", "a", "gone", "c"].map(str::to_owned);
        assert_eq!(ordered(&order, &["a", "b", "c", "d"]), ["c", "d", "a", "b"]);
        assert_eq!(ordered(&order, &["x", "a", "c"]), ["x", "c", "a"]);
        assert_eq!(ordered(&[], &["b", "a"]), ["b", "a"]);
    }

    #[test]
    fn another_rate_keeps_seconds_and_a_column_its_name() {
        let before = Board { columns: vec!["Lens".into(), "Sound".into()], ..Board::default() };
        let mut shot = Shot { frames: Some(49), ..Shot::default() };
        shot.more =
            [("Lens".to_owned(), "35".into()), ("Sound".to_owned(), "wind".into())].into_iter().collect();
        let now = Board { fps: 30, columns: vec!["Optics".into(), "Sound".into()], ..Board::default() };
        let taken = now.taken(&before, &shot).unwrap();
        assert_eq!(
            (taken.frames, &taken.more["Optics"], &taken.more["Sound"]),
            (Some(61), &"35".into(), &"wind".into())
        );
        let fewer = Board { columns: vec!["Sound".into()], ..Board::default() };
        assert_eq!(fewer.taken(&before, &shot).unwrap().more.len(), 1);
        assert!(before.taken(&before, &shot).is_none());
    }

    #[test]
    fn what_is_no_board_is_refused() {
        let board = |json: &str| Board::read(serde_json::from_str(json).unwrap());
        for wrong in [
            r#"{"fps":23}"#,
            r#"{"fps":24,"pace":"drop"}"#,
            r#"{"fps":25,"pace":"ntsc"}"#,
            r#"{"pace":"slow"}"#,
            r#"{"frames":5}"#,
            r#"{"aspect":"3:2"}"#,
            r#"{"columns":["a","a"]}"#,
            r#"{"columns":[""]}"#,
            r#"{"logo":7}"#,
            r#"{"logo":"logo.png"}"#,
            r#"{"logo":"data:image/jpeg;base64,iVBORw0KGgo="}"#,
            r#"{"logo":"data:image/png;base64,iVBORw0KGgo*"}"#,
            r#"{"logo":"data:image/png;base64,R0lGODlhAQAB"}"#,
        ] {
            assert!(board(wrong).is_err(), "{wrong}");
        }
        assert_eq!(board("{}").unwrap(), Board::default());
        assert_eq!(board(r#"{"logo":""}"#).unwrap(), Board::default());
        let logo = |letters: usize| format!("data:image/png;base64,iVBORw0KGgoA{}", "A".repeat(letters));
        let longest = LONGEST_LOGO - logo(0).len();
        let told = |letters| board(&format!(r#"{{"logo":"{}"}}"#, logo(letters)));
        assert_eq!(told(longest / 4 * 4).unwrap().logo, logo(longest / 4 * 4));
        let wrong = told(longest / 4 * 4 + 4).unwrap_err();
        assert_eq!((wrong.place(), wrong.kind()), ("logo", crate::json::Kind::Beyond));
        let shot = |json: &str| Shot::read(serde_json::from_str(json).unwrap());
        for wrong in [r#"{"frames":0}"#, r#"{"scene":1}"#, r#"{"more":{"a":2}}"#, "[]"] {
            assert!(shot(wrong).is_err(), "{wrong}");
        }
        assert!(shot(r#"{"scene":"","frames":null,"more":{"a":""}}"#).unwrap().is_empty());
    }
}
