//! Subtitles as `SubRip` (.srt) and `WebVTT` (.vtt) files have them, and the frames that they go to. Each letter is looked at a
//! bounded number of times, whatever the text is.

use super::script::{self, Placed};
use super::speech::{self, Said, Taking};
use crate::json::Writer;
use crate::order::sort_by;
use serde_json::{Value, json};

/// Most bytes of a file.
pub const MOST_BYTES: usize = 5_000_000;
/// Maximum number of subtitles. Ten hours with one every two seconds have fewer.
pub const MOST_CUES: usize = 20_000;
/// Most characters of a subtitle; two lines on the screen have some eighty.
pub const MOST_LETTERS: usize = 1_000;
/// Maximum distance in seconds between a frame and a subtitle. Only a few frames of a video are used, and
/// each represents its surroundings.
pub const REACH: f64 = 20.0;
/// Maximum number of text items per frame, so that they do not cover its panel.
pub const MOST_OF_FRAME: usize = 3;
/// Frames on either side of a subtitle that are looked at for it.
const NEAREST: usize = 8;
/// Maximum number of reported errors of single subtitles.
const MOST_SKIPPED: usize = 3;

/// A timed subtitle.
#[derive(Debug, Clone, PartialEq)]
pub struct Cue {
    /// Seconds.
    pub start: f64,
    /// Seconds, no less than the start.
    pub end: f64,
    /// Its speech without markup, in order of speakers.
    pub said: Vec<Said>,
}

/// Content of a subtitle file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Subtitles {
    /// In the order of their starts.
    pub cues: Vec<Cue>,
    /// Subtitles that were too many.
    pub left: usize,
    /// Subtitles whose text was too long.
    pub cut: usize,
    /// The first errors of skipped subtitles.
    pub flaws: Vec<Flaw>,
    /// and how many these were.
    pub skipped: usize,
    /// It was in no UTF, and so was taken for Windows-1252.
    pub guessed: bool,
}

/// An error in a subtitle file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Flaw {
    /// It has more than [`MOST_BYTES`].
    Large,
    /// It is not text.
    Binary,
    /// It does not begin as `WebVTT` does.
    Header,
    /// There are no subtitles in it.
    Empty,
    /// A time was expected in that line, counted from 1, not this.
    Stray(usize, String),
    /// An invalid time.
    Time(usize, String),
    /// It ends before it starts.
    Order(usize),
}

impl Flaw {
    /// Writes its fields: `kind, line, text`, the line and the text if they are known.
    fn write(&self, out: &mut Writer) {
        let (kind, line, text) = match self {
            Self::Large => ("large", None, None),
            Self::Binary => ("binary", None, None),
            Self::Header => ("header", None, None),
            Self::Empty => ("empty", None, None),
            Self::Stray(line, text) => ("stray", Some(line), Some(text)),
            Self::Time(line, text) => ("time", Some(line), Some(text)),
            Self::Order(line) => ("order", Some(line), None),
        };
        out.key("kind").text(kind);
        if let Some(line) = line {
            out.key("line").whole(*line as u64);
        }
        if let Some(text) = text {
            out.key("text").text(text);
        }
    }
}

/// Result of the parser.
pub type Result<T> = std::result::Result<T, Flaw>;

/// A video frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Its time in seconds.
    pub time: f64,
    /// A page shows it.
    pub shown: bool,
}

impl Subtitles {
    /// Reads a file in UTF-8, with its mark in UTF-16, or in Windows-1252.
    ///
    /// # Errors
    /// Returns the error in the file.
    pub fn read(bytes: &[u8], vtt: bool) -> Result<Self> {
        if bytes.len() > MOST_BYTES {
            return Err(Flaw::Large);
        }
        let (text, guessed) = decoded(bytes).ok_or(Flaw::Binary)?;
        Self::parse(&text, vtt).map(|read| Self { guessed, ..read })
    }

    /// Reads the text of a file.
    ///
    /// # Errors
    /// Returns the error in the text.
    pub fn parse(text: &str, vtt: bool) -> Result<Self> {
        let lines = lines(text.strip_prefix('\u{feff}').unwrap_or(text));
        let mut at = 0;
        if vtt {
            let rest = lines[0].strip_prefix("WEBVTT");
            if !rest.is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', '\t'])) {
                return Err(Flaw::Header);
            }
            // Lines after the header, up to an empty line, belong to it.
            at = end_of_block(&lines, 1);
        }
        let mut all = Self::default();
        while at < lines.len() {
            if trimmed(lines[at]).is_empty() {
                at += 1;
                continue;
            }
            let from = at;
            at = end_of_block(&lines, from);
            if vtt && is_remark(lines[from]) {
                continue;
            }
            let read = cue(&lines, from, at).map(|(start, end, text)| {
                let (text, cut) = match text.char_indices().nth(MOST_LETTERS) {
                    Some((end, _)) => (&text[..end], true),
                    None => (&text[..], false),
                };
                (Cue { start, end, said: speech::of_lines(text.split('\n')) }, cut)
            });
            match read {
                Err(flaw) => {
                    all.skipped += 1;
                    if all.flaws.len() < MOST_SKIPPED {
                        all.flaws.push(flaw);
                    }
                }
                Ok((cue, _)) if cue.said.is_empty() => {}
                Ok(_) if all.cues.len() == MOST_CUES => all.left += 1,
                Ok((cue, cut)) => {
                    all.cut += usize::from(cut);
                    all.cues.push(cue);
                }
            }
        }
        if all.cues.is_empty() {
            return Err(all.flaws.into_iter().next().unwrap_or(Flaw::Empty));
        }
        sort_by(&mut all.cues, |a, b| a.start.total_cmp(&b.start));
        Ok(all)
    }
}

/// Returns the text of a file, and whether its encoding was guessed.
#[must_use]
pub fn decoded(bytes: &[u8]) -> Option<(String, bool)> {
    let wide = |order: fn([u8; 2]) -> u16| {
        let (units, rest) = bytes[2..].as_chunks::<2>();
        let letters = char::decode_utf16(units.iter().map(|unit| order(*unit)));
        letters.collect::<std::result::Result<String, _>>().ok().filter(|_| rest.is_empty())
    };
    let (text, guessed) = match bytes {
        [0xFF, 0xFE, ..] => (wide(u16::from_le_bytes)?, false),
        [0xFE, 0xFF, ..] => (wide(u16::from_be_bytes)?, false),
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => (text.to_owned(), false),
            Err(_) => (bytes.iter().map(|byte| western(*byte)).collect(), true),
        },
    };
    // Text has no control characters except line ends. Binary files have many.
    let control = |letter: char| {
        letter.is_ascii_control() && !matches!(letter, '\n' | '\r' | '\t' | '\x0b' | '\x0c' | '\x1a')
    };
    let few = if guessed { !text.contains(control) } else { !text.contains('\0') };
    few.then_some((text, guessed))
}

/// A character of Windows-1252, the encoding of old Western European files. A table of 32 entries needs no
/// library.
fn western(byte: u8) -> char {
    const HIGH: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
        '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..=0x9f => HIGH[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

/// Distance of a time from a subtitle, in seconds.
fn away(cue: &Cue, time: f64) -> f64 {
    (cue.start - time).max(time - cue.end).max(0.0)
}

/// Text items for frames with subtitles close to them, as captions or balloons with automatic placement, and
/// the number of subtitles without a frame. Each subtitle goes to one frame: the nearest frame on a page with
/// free space, or the nearest other frame. `frame` of a text item is the index of its frame. `cue` identifies
/// the subtitle and its part.
#[must_use]
pub fn matched(cues: &[Cue], frames: &[Frame], taking: Taking) -> (Vec<Value>, usize) {
    let words: Vec<Vec<Value>> = cues
        .iter()
        .map(|cue| cue.said.iter().flat_map(|said| speech::words(said, taking)).collect())
        .collect();
    // By time, frames on pages separately.
    let sorted = |shown: bool| {
        let mut some: Vec<usize> = (0..frames.len()).filter(|&i| frames[i].shown == shown).collect();
        sort_by(&mut some, |&a, &b| frames[a].time.total_cmp(&frames[b].time));
        some
    };
    let mut pairs: Vec<(bool, f64, usize, usize)> = Vec::new();
    for shown in [true, false] {
        let some = sorted(shown);
        for (i, cue) in cues.iter().enumerate().filter(|(i, _)| !words[*i].is_empty()) {
            let middle = f64::midpoint(cue.start, cue.end);
            let at = some.partition_point(|&frame| frames[frame].time < middle);
            for &frame in &some[at.saturating_sub(NEAREST)..(at + NEAREST).min(some.len())] {
                let off = away(cue, frames[frame].time);
                if off <= REACH {
                    // If several frames are in one subtitle, the closest to its middle wins.
                    pairs.push((!shown, off + (frames[frame].time - middle).abs() * 1e-3, i, frame));
                }
            }
        }
    }
    sort_by(&mut pairs, |a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut room = vec![MOST_OF_FRAME; frames.len()];
    let mut places = vec![None; cues.len()];
    for (_, _, cue, frame) in pairs {
        let wanted = words[cue].len();
        // Text that is too long for any frame gets a frame without other text.
        if places[cue].is_none() && (room[frame] >= wanted || room[frame] == MOST_OF_FRAME) {
            places[cue] = Some(frame);
            room[frame] = room[frame].saturating_sub(wanted);
        }
    }
    let homeless = (0..cues.len()).filter(|&i| places[i].is_none() && !words[i].is_empty()).count();
    let mut made = Vec::new();
    for ((cue, words), place) in cues.iter().zip(words).zip(places) {
        let Some(frame) = place else { continue };
        for (part, mut word) in words.into_iter().enumerate() {
            word["frame"] = json!(frame);
            word["cue"] = json!(format!("{:.3}/{part}", cue.start));
            made.push(word);
        }
    }
    (made, homeless)
}

/// Matches a subtitle file with frames, in JSON: `{words, unplaced, cues, homeless, left, cut, skipped,
/// flaws, guessed}`. The fields are the text items, and the number of subtitles that were read, found no
/// frame, were left out, cut or skipped. An invalid file gives `{flaw: {kind, line, text}}`. Without frames,
/// the text items are placed on panels in order, see [`script::placed`].
#[must_use]
pub fn told(bytes: &[u8], vtt: bool, frames: &[Frame], panels: usize, taking: Taking) -> String {
    let mut out = Writer::default();
    out.open(b'{');
    match Subtitles::read(bytes, vtt) {
        Ok(Subtitles { cues, left, cut, flaws, skipped, guessed }) => {
            let (placed, homeless) = if frames.is_empty() {
                let groups: Vec<Vec<Said>> = cues.iter().map(|cue| cue.said.clone()).collect();
                (script::placed(&groups, (panels, MOST_OF_FRAME), taking), 0)
            } else {
                let (words, homeless) = matched(&cues, frames, taking);
                (Placed { words, unplaced: 0 }, homeless)
            };
            placed.write(&mut out);
            let counts = [
                ("cues", cues.len()),
                ("homeless", homeless),
                ("left", left),
                ("cut", cut),
                ("skipped", skipped),
            ];
            for (name, count) in counts {
                out.key(name).whole(count as u64);
            }
            out.key("flaws").list(&flaws, &|out, flaw| {
                out.open(b'{');
                flaw.write(out);
                out.close(b'}');
            });
            out.key("guessed").flag(guessed);
        }
        Err(flaw) => {
            out.key("flaw").open(b'{');
            flaw.write(&mut out);
            out.close(b'}');
        }
    }
    out.close(b'}');
    out.finish()
}

/// Lines of whatever system.
pub(super) fn lines(text: &str) -> Vec<&str> {
    let mut lines = Vec::new();
    let mut rest = text;
    while let Some(end) = rest.find(['\r', '\n']) {
        lines.push(&rest[..end]);
        rest = rest[end..].strip_prefix("\r\n").unwrap_or(&rest[end + 1..]);
    }
    lines.push(rest);
    lines
}

/// As JavaScript has white space.
pub(super) fn is_space(letter: char) -> bool {
    letter == '\u{feff}' || (letter.is_whitespace() && letter != '\u{85}')
}

pub(super) fn trimmed(text: &str) -> &str {
    text.trim_matches(is_space)
}

fn end_of_block(lines: &[&str], from: usize) -> usize {
    let empty = lines.iter().skip(from).position(|line| trimmed(line).is_empty());
    empty.map_or(lines.len(), |empty| from + empty)
}

fn is_remark(line: &str) -> bool {
    let rest = ["NOTE", "STYLE", "REGION"].into_iter().find_map(|word| line.strip_prefix(word));
    rest.is_some_and(|rest| !rest.starts_with(is_word))
}

fn is_word(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// Times and lines of a block.
fn cue(lines: &[&str], from: usize, end: usize) -> Result<(f64, f64, String)> {
    // A number or a name may precede the times.
    let at = if lines[from].contains("-->") { from } else { from + 1 };
    let line = lines.get(at).filter(|line| at < end && line.contains("-->"));
    let line = line.ok_or_else(|| Flaw::Stray(from + 1, shortened(lines[from])))?;
    let mut parts = line.split("-->").map(|part| trimmed(part).split(is_space).next().and_then(seconds));
    let (Some(Some(start)), Some(Some(end_time))) = (parts.next(), parts.next()) else {
        return Err(Flaw::Time(at + 1, shortened(line)));
    };
    if end_time < start {
        return Err(Flaw::Order(at + 1));
    }
    Ok((start, end_time, plain(&lines[at + 1..end])))
}

/// `hours:minutes:seconds,thousandths`, the hours left out or not.
fn seconds(time: &str) -> Option<f64> {
    let number = |digits: &str, most: usize| {
        let good = (1..=most).contains(&digits.len()) && digits.bytes().all(|digit| digit.is_ascii_digit());
        good.then(|| digits.parse::<u32>().ok()).flatten()
    };
    let (front, thousandths) = time.split_once(['.', ','])?;
    let mut parts = front.rsplit(':');
    let (seconds, minutes) = (number(parts.next()?, 2)?, number(parts.next()?, 2)?);
    let hours = parts.next().map_or(Some(0), |hours| number(hours, 4))?;
    if parts.next().is_some() || seconds > 59 || minutes > 59 {
        return None;
    }
    let part = number(thousandths, 3)? * 10u32.pow(3 - thousandths.len() as u32);
    Some(
        f64::from(hours) * 3600.0 + f64::from(minutes) * 60.0 + f64::from(seconds) + f64::from(part) / 1000.0,
    )
}

/// Lines without tags, places and entities. Who speaks in `WebVTT` begins as with a dash.
fn plain(lines: &[&str]) -> String {
    let bare = |line: &str| {
        let line = entities(&without(&without(line, "<", ">"), "{\\", "}"));
        line.split(is_space).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
    };
    let lines = lines.iter().map(|line| voices(line));
    let bare: Vec<String> = lines.flat_map(|line| line.split('\n').map(bare).collect::<Vec<_>>()).collect();
    bare.into_iter().filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")
}

/// A line with a new one and a dash where `<v Name>` stands.
fn voices(line: &str) -> String {
    if !line.contains("<v") {
        return line.to_owned();
    }
    line.replace("<v ", "\n- <v ").replace("<v.", "\n- <v.")
}

/// Removes text between these marks. Text without a closing mark stays.
fn without(line: &str, open: &str, close: &str) -> String {
    let mut kept = String::new();
    let mut rest = line;
    while let Some(start) = rest.find(open) {
        let inside = &rest[start + open.len()..];
        let Some(end) = inside.find(close) else { break };
        kept.push_str(&rest[..start]);
        rest = &inside[end + close.len()..];
    }
    kept + rest
}

/// Decodes `WebVTT` entities.
fn entities(text: &str) -> String {
    let mut told = String::new();
    let mut rest = text;
    while let Some(start) = rest.find('&') {
        let (before, from) = rest.split_at(start);
        told.push_str(before);
        let name = from[1..].split(|letter| !is_word(letter)).next().unwrap_or_default();
        let length = if from[1 + name.len()..].starts_with(';') { name.len() + 2 } else { 1 };
        told.push_str(match &from[..length] {
            "&amp;" => "&",
            "&lt;" => "<",
            "&gt;" => ">",
            "&nbsp;" => " ",
            "&lrm;" | "&rlm;" => "",
            other => other,
        });
        rest = &from[length..];
    }
    told + rest
}

fn shortened(line: &str) -> String {
    let line = trimmed(line);
    match line.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SRT: &str = "\u{feff}1\r\n00:00:01,000 --> 00:00:02,500\r\n<i>Hello</i>\r\nthere\r\n\r\n2\r\n00:01:00,5 --> 01:00:01,250\r\n{\\an8}Bye\r\n";

    fn cues(text: &str, vtt: bool) -> Vec<(f64, f64, String)> {
        let read = Subtitles::parse(text, vtt).unwrap();
        read.cues.iter().map(|cue| (cue.start, cue.end, said(cue))).collect()
    }

    fn said(cue: &Cue) -> String {
        cue.said.iter().map(|said| said.text.as_str()).collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn subrip_is_read_without_its_marks() {
        assert_eq!(cues(SRT, false), [(1.0, 2.5, "Hello there".into()), (60.5, 3601.25, "Bye".into())]);
    }

    #[test]
    fn webvtt_is_read_its_notes_names_and_settings_passed_over() {
        let vtt = "WEBVTT Kind: captions\nLanguage: en\n\nNOTE a --> remark\n\nSTYLE\n::cue { color: red }\n\nintro\n00:04.000 --> 00:05.000 align:start\n<v Anna>Tom &amp; Jerry</v>\n\n01:00:00.000 --> 01:00:01.000\n\n\n00:01.000 --> 00:02.000\nFirst";
        assert_eq!(cues(vtt, true), [(1.0, 2.0, "First".into()), (4.0, 5.0, "Tom & Jerry".into())]);
    }

    #[test]
    fn what_is_malformed_names_its_line() {
        let cases = [
            (String::new(), false, Flaw::Empty),
            ("1\n00:00:01,000 > 00:00:02,000\nHi".into(), false, Flaw::Stray(1, "1".into())),
            ("1\n00:00:01 --> 00:00:02\nHi".into(), false, Flaw::Time(2, "00:00:01 --> 00:00:02".into())),
            (
                "1\n00:99:01,000 --> 00:00:02,000\nHi".into(),
                false,
                Flaw::Time(2, "00:99:01,000 --> 00:00:02,000".into()),
            ),
            (
                "1\n00:00:01,000 --> 99999:00:02,000\nHi".into(),
                false,
                Flaw::Time(2, "00:00:01,000 --> 99999:00:02,000".into()),
            ),
            ("1\n00:00:03,000 --> 00:00:02,000\nHi".into(), false, Flaw::Order(2)),
            (format!("{}\nx", "-->".repeat(20)), false, Flaw::Time(1, format!("{}-…", "-->".repeat(13)))),
            ("1\n".into(), false, Flaw::Stray(1, "1".into())),
            ("00:01.000 --> 00:02.000\nHi".into(), true, Flaw::Header),
            ("WEBVTT".into(), true, Flaw::Empty),
        ];
        for (text, vtt, flaw) in cases {
            assert_eq!(Subtitles::parse(&text, vtt), Err(flaw), "{text:?}");
        }
    }

    #[test]
    fn a_subtitle_that_is_malformed_costs_itself_alone() {
        let time = "00:00:01,000 --> 00:00:02,000";
        let text = format!("1\n{time}\nHi\n\nno time here\nnone\n\n3\nsoon --> later\nx\n\n4\n{time}\nBye");
        let read = Subtitles::parse(&text, false).unwrap();
        assert_eq!(read.cues.iter().map(said).collect::<Vec<_>>(), ["Hi", "Bye"]);
        let flaws = [Flaw::Stray(5, "no time here".into()), Flaw::Time(9, "soon --> later".into())];
        assert_eq!((read.skipped, &read.flaws[..]), (2, &flaws[..]));
        let many = format!("{}{time}\nHi", "x\ny\n\n".repeat(9));
        let read = Subtitles::parse(&many, false).unwrap();
        assert_eq!((read.skipped, read.flaws.len()), (9, MOST_SKIPPED));
    }

    #[test]
    fn speakers_of_one_subtitle_are_told_apart() {
        let time = "00:00:01.000 --> 00:00:02.000";
        let read = |text: &str| cues(&format!("WEBVTT\n\n{time}\n{text}"), true)[0].2.clone();
        assert_eq!(read("<v Anna>Who?\n<v.loud Ben>Me.</v>"), "Who? | Me.");
        assert_eq!(read("- Who?\n- Me."), "Who? | Me.");
        assert_eq!(read("ANNA: Who?\n[a bell]"), "Who? | a bell");
    }

    #[test]
    fn marks_are_taken_out_and_what_is_not_closed_stays() {
        let cases = [
            ("<c.a.b>Hi</c> <there", "Hi <there"),
            ("a > b <<i>> c", "a > b > c"),
            ("{\\an8}Up {\\pos(1,2)}here {here}", "Up here {here}"),
            ("{\\Up", "{\\Up"),
            ("a&amp;b &lt;i&gt; &nbsp;c&lrm; &x; &amp", "a&b <i> c &x; &amp"),
            ("&amp;lt;", "&lt;"),
            (" \t x\u{a0}\u{2028} y ", "x y"),
        ];
        for (line, said) in cases {
            assert_eq!(cues(&format!("00:00:01,000 --> 00:00:02,000\n{line}"), false)[0].2, said, "{line:?}");
        }
    }

    const TAKING: Taking = Taking { kind: "balloon", sounds: false };

    #[test]
    fn what_a_file_says_is_told_as_json() {
        let read = |bytes: &[u8], frames: &[Frame]| -> Value {
            serde_json::from_str(&told(bytes, false, frames, 2, TAKING)).unwrap()
        };
        let frames = [Frame { time: 90.0, shown: true }, Frame { time: 1.5, shown: true }];
        let word = json!({ "kind": "balloon", "text": "Hello there", "auto": true });
        let on = |word: &Value, name: &str, at: Value| {
            let mut word = word.clone();
            word[name] = at;
            word
        };
        let placed = on(&on(&word, "frame", json!(1)), "cue", json!("1.000/0"));
        let answer = read(SRT.as_bytes(), &frames);
        assert_eq!(answer["words"][0], placed);
        assert_eq!(
            (&answer["cues"], &answer["homeless"], &answer["guessed"]),
            (&json!(2), &json!(0), &json!(false))
        );
        // Without frames they are laid over the panels.
        let words = read(SRT.as_bytes(), &[])["words"].clone();
        let bye = json!({ "kind": "balloon", "text": "Bye", "auto": true });
        assert_eq!(words, json!([on(&word, "place", json!(0)), on(&bye, "place", json!(1))]));
        assert_eq!(read(b"1\n", &[]), json!({ "flaw": { "kind": "stray", "line": 1, "text": "1" } }));
        assert_eq!(read(b"1\0", &[]), json!({ "flaw": { "kind": "binary" } }));
    }

    #[test]
    fn files_are_read_in_utf_8_utf_16_and_windows_1252_and_refused_in_anything_else() {
        let units: Vec<u16> = SRT.encode_utf16().collect();
        let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        for bytes in [SRT.as_bytes(), &little, &big] {
            let read = Subtitles::read(bytes, false).unwrap();
            assert_eq!((read.cues.len(), read.guessed), (2, false));
        }
        let read =
            Subtitles::read(b"00:00:01,000 --> 00:00:02,000\n\x93Caf\xe9\x94 \x96 5\xa0\x80", false).unwrap();
        assert_eq!((said(&read.cues[0]).as_str(), read.guessed), ("“Café” – 5 €", true));
        for bytes in [&[0x31, 0xe9, 0x0a, 0x01][..], b"1\0", &[0xFF, 0xFE, 0x00], &[0xFE, 0xFF, 0xD8, 0x00]] {
            assert_eq!(Subtitles::read(bytes, false), Err(Flaw::Binary));
        }
        assert_eq!(Subtitles::read(&vec![b' '; MOST_BYTES + 1], false), Err(Flaw::Large));
    }

    /// Text items by content, with the indices of their frames.
    fn homes(cues: &[Cue], frames: &[(f64, bool)]) -> (Vec<(String, u64)>, usize) {
        let frames: Vec<Frame> = frames.iter().map(|&(time, shown)| Frame { time, shown }).collect();
        let (words, homeless) = matched(cues, &frames, TAKING);
        let home =
            |word: &Value| (word["text"].as_str().unwrap().to_owned(), word["frame"].as_u64().unwrap());
        (words.iter().map(home).collect(), homeless)
    }

    fn film(count: usize, every: usize) -> Vec<Cue> {
        let cue = |i| {
            let from = i * every;
            format!("00:00:{from:02},000 --> 00:00:{from:02},900\nLine {i}")
        };
        Subtitles::parse(&(0..count).map(cue).collect::<Vec<_>>().join("\n\n"), false).unwrap().cues
    }

    #[test]
    fn a_subtitle_goes_to_one_frame_only_the_nearest_to_it() {
        let cues = Subtitles::parse(SRT, false).unwrap().cues;
        let (words, homeless) = homes(&cues, &[(1.1, true), (1.7, true), (30.0, true), (61.0, true)]);
        assert_eq!((words, homeless), (vec![("Hello there".into(), 1), ("Bye".into(), 3)], 0));
        // A subtitle minutes away does not belong to a frame.
        assert_eq!(homes(&cues[..1], &[(90.0, true)]), (vec![], 1));
    }

    #[test]
    fn all_subtitles_of_a_short_film_find_a_frame() {
        let (words, homeless) = homes(&film(11, 4), &[(2.0, true), (14.0, true), (26.0, true), (38.0, true)]);
        assert_eq!((words.len(), homeless), (11, 0));
        assert!((0..4).all(|frame| words.iter().filter(|word| word.1 == frame).count() <= MOST_OF_FRAME));
        assert_eq!(homes(&film(11, 4), &[(20.0, true)]).1, 11 - MOST_OF_FRAME);
    }

    #[test]
    fn frames_that_are_seen_come_first() {
        let cues = film(1, 1);
        assert_eq!(homes(&cues, &[(0.5, false), (6.0, true)]).0[0].1, 1);
        assert_eq!(homes(&cues, &[(0.5, false), (60.0, true)]).0[0].1, 0);
    }

    #[test]
    fn what_is_too_much_is_counted() {
        const CUE: &str = "00:00:01,000 --> 00:00:02,000\n";
        let many: Vec<String> = (0..MOST_CUES + 7).map(|i| format!("{CUE}{i}")).collect();
        let read = Subtitles::parse(&many.join("\n\n"), false).unwrap();
        assert_eq!((read.cues.len(), read.left, said(&read.cues[0]).as_str()), (MOST_CUES, 7, "0"));
        let long = format!("{CUE}{}\n\n{CUE}short", "\u{1f600}".repeat(MOST_LETTERS + 1));
        let read = Subtitles::parse(&long, false).unwrap();
        assert_eq!(
            (read.cut, said(&read.cues[0]).chars().count(), said(&read.cues[1]).as_str()),
            (1, MOST_LETTERS, "short")
        );
    }

    #[test]
    fn walls_of_marks_take_no_time() {
        const CUE: &str = "00:00:01,000 --> 00:00:02,000\n";
        let wall = |part: &str| format!("{CUE}{}", part.repeat(4_000_000 / part.len()));
        let begin = std::time::Instant::now();
        for part in ["<", "{\\", "<>", "\n\n", " \t", "&a", "x\n\n0:0.0-->0:1.0\n", "-->"] {
            let _: Result<_> = Subtitles::read(wall(part).as_bytes(), false);
        }
        assert!(begin.elapsed().as_secs() < 20);
    }

    proptest! {
        #[test]
        fn any_text_gives_bounded_subtitles_in_order_or_a_sentence(
            parts in prop::collection::vec(prop_oneof![
                5 => prop::sample::select(vec![
                    "<", ">", "</i>", "{", "}", "{\\an8}", "&", ";", "&lt;", "&x;", "\\", "\n", "\r\n", "\r", "\n\n", " ", "\u{2028}", "\u{feff}",
                    "1", "-->", " --> ", "00:00:01,000", "99:59:59,999", "00:01", "NOTE", "\u{1f600}", "é", "\0",
                    "\n\n00:00:01,000 --> 00:00:02,000\n", "\n\n7\n00:01.000 --> 00:02.000 align:start\n",
                ]).prop_map(str::to_owned),
                1 => ".{0,8}",
            ], 0..60),
            vtt: bool,
        ) {
            let text = format!("{}{}", if vtt { "WEBVTT\n\n" } else { "" }, parts.concat());
            match Subtitles::parse(&text, vtt) {
                Err(Flaw::Stray(_, said) | Flaw::Time(_, said)) => prop_assert!(said.chars().count() <= 41),
                Err(_) => {}
                Ok(read) => {
                    prop_assert!(!read.cues.is_empty());
                    prop_assert!(read.cues.is_sorted_by(|a, b| a.start <= b.start));
                    for Cue { start, end, said } in &read.cues {
                        prop_assert!(end >= start && *start >= 0.0 && !said.is_empty());
                        prop_assert!(said.iter().all(|said| !said.text.is_empty() && trimmed(&said.text) == said.text));
                    }
                    let frames = [Frame { time: 1.0, shown: true }, Frame { time: 2.0, shown: false }];
                    let (words, homeless) = matched(&read.cues, &frames, TAKING);
                    prop_assert!(homeless <= read.cues.len() && words.iter().all(|word| word["frame"].as_u64() < Some(2)));
                }
            }
        }
    }
}
