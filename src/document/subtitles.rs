//! Subtitles as `SubRip` (.srt) and `WebVTT` (.vtt) files have them, and the panels that they go to. Each letter is looked at a
//! bounded number of times, whatever the text is.

use crate::json::Writer;
use serde_json::{Value, json};

/// Most bytes of a file.
pub const MOST_BYTES: usize = 5_000_000;
/// Most subtitles of a film: one of ten hours with one every other second has fewer.
pub const MOST_CUES: usize = 20_000;
/// Most characters of a subtitle; two lines on the screen have some eighty.
pub const MOST_LETTERS: usize = 1_000;
/// Seconds that a frame may be before or after what is said.
pub const SLACK: f64 = 0.75;

/// What is said when.
#[derive(Debug, Clone, PartialEq)]
pub struct Cue {
    /// Seconds.
    pub start: f64,
    /// Seconds, no less than the start.
    pub end: f64,
    /// The text without marks.
    pub text: String,
}

/// What a file says.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Subtitles {
    /// In the order of their starts.
    pub cues: Vec<Cue>,
    /// Subtitles that were too many.
    pub left: usize,
    /// Subtitles whose text was too long.
    pub cut: usize,
}

/// What is wrong with a file of subtitles.
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
    /// This is no time.
    Time(usize, String),
    /// It ends before it starts.
    Order(usize),
}

impl Flaw {
    /// Writes it: `{kind, line, text}`, the line and the text where they are told.
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
        out.open(b'{');
        out.key("kind").text(kind);
        if let Some(line) = line {
            out.key("line").whole(*line as u64);
        }
        if let Some(text) = text {
            out.key("text").text(text);
        }
        out.close(b'}');
    }
}

/// What reading gives.
pub type Result<T> = std::result::Result<T, Flaw>;

/// A panel that shows a frame of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Which.
    pub panel: usize,
    /// Its time in seconds.
    pub time: f64,
}

impl Subtitles {
    /// Reads a file in UTF-8 or, with its mark, in UTF-16.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(bytes: &[u8], vtt: bool) -> Result<Self> {
        if bytes.len() > MOST_BYTES {
            return Err(Flaw::Large);
        }
        let wide = |order: fn([u8; 2]) -> u16| {
            let (units, rest) = bytes[2..].as_chunks::<2>();
            let letters = char::decode_utf16(units.iter().map(|unit| order(*unit)));
            letters.collect::<std::result::Result<String, _>>().ok().filter(|_| rest.is_empty())
        };
        let text = match bytes {
            [0xFF, 0xFE, ..] => wide(u16::from_le_bytes),
            [0xFE, 0xFF, ..] => wide(u16::from_be_bytes),
            _ => std::str::from_utf8(bytes).ok().map(str::to_owned),
        };
        let text = text.filter(|text| !text.contains('\0')).ok_or(Flaw::Binary)?;
        Self::parse(&text, vtt)
    }

    /// Reads the text of a file.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str, vtt: bool) -> Result<Self> {
        let lines = lines(text.strip_prefix('\u{feff}').unwrap_or(text));
        let mut at = 0;
        if vtt {
            let rest = lines[0].strip_prefix("WEBVTT");
            if !rest.is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', '\t'])) {
                return Err(Flaw::Header);
            }
            // What follows the header up to an empty line belongs to it.
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
            let mut cue = cue(&lines, from, at)?;
            if cue.text.is_empty() {
                continue;
            }
            if all.cues.len() == MOST_CUES {
                all.left += 1;
                continue;
            }
            if let Some((end, _)) = cue.text.char_indices().nth(MOST_LETTERS) {
                let kept = trimmed(&cue.text[..end]).to_owned();
                cue.text = kept;
                all.cut += 1;
            }
            all.cues.push(cue);
        }
        if all.cues.is_empty() {
            return Err(Flaw::Empty);
        }
        all.cues.sort_by(|a, b| a.start.total_cmp(&b.start));
        Ok(all)
    }
}

/// The subtitle that is shown at a time, or the nearest that begins or ends within `slack` seconds of it.
#[must_use]
pub fn cue_at(cues: &[Cue], time: f64, slack: f64) -> Option<usize> {
    let away = |cue: &Cue| (cue.start - time).max(time - cue.end).max(0.0);
    let nearest = (0..cues.len()).min_by(|&a, &b| away(&cues[a]).total_cmp(&away(&cues[b])))?;
    (away(&cues[nearest]) <= slack).then_some(nearest)
}

/// Words for the frames at whose times something is said, as captions or balloons that find their places. A subtitle goes
/// to one frame only, the nearest to its middle.
#[must_use]
pub fn matched(cues: &[Cue], frames: &[Frame], kind: &str) -> Vec<Value> {
    let mut places: Vec<(usize, Frame)> = Vec::new();
    for frame in frames {
        let Some(cue) = cue_at(cues, frame.time, SLACK) else { continue };
        let off = |frame: &Frame| (frame.time - f64::midpoint(cues[cue].start, cues[cue].end)).abs();
        match places.iter_mut().find(|(other, _)| *other == cue) {
            Some((_, before)) if off(frame) < off(before) => *before = *frame,
            Some(_) => {}
            None => places.push((cue, *frame)),
        }
    }
    let word = |(cue, frame): (usize, Frame)| json!({ "kind": kind, "text": cues[cue].text, "panel": frame.panel, "auto": true });
    places.into_iter().map(word).collect()
}

/// What a file of subtitles says at the times of some frames, in JSON: `{words, cues, left, cut}`, the words and how many
/// subtitles were read, left out, and cut; or what is wrong with it, `{flaw: {kind, line, text}}`.
#[must_use]
pub fn told(bytes: &[u8], vtt: bool, frames: &[Frame], kind: &str) -> String {
    let mut out = Writer::default();
    out.open(b'{');
    match Subtitles::read(bytes, vtt) {
        Ok(Subtitles { cues, left, cut }) => {
            out.key("words").list(&matched(&cues, frames, kind), &|out, word| out.value(word));
            for (name, count) in [("cues", cues.len()), ("left", left), ("cut", cut)] {
                out.key(name).whole(count as u64);
            }
        }
        Err(flaw) => flaw.write(out.key("flaw")),
    }
    out.close(b'}');
    out.finish()
}

/// Lines of whatever system.
fn lines(text: &str) -> Vec<&str> {
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
fn is_space(letter: char) -> bool {
    letter == '\u{feff}' || (letter.is_whitespace() && letter != '\u{85}')
}

fn trimmed(text: &str) -> &str {
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

fn cue(lines: &[&str], from: usize, end: usize) -> Result<Cue> {
    // A number or a name may stand before the times.
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
    Ok(Cue { start, end: end_time, text: plain(&lines[at + 1..end]) })
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

/// Text without tags, places and entities.
fn plain(lines: &[&str]) -> String {
    let lines = lines.iter().map(|line| without(&without(line, "<", ">"), "{\\", "}"));
    let lines: Vec<String> =
        lines.map(|line| trimmed(&line).to_owned()).filter(|line| !line.is_empty()).collect();
    let text = entities(&lines.join(" "));
    text.split(is_space).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Without what stands between these; what is not closed stays.
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

/// With the letters that entities of `WebVTT` stand for.
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
        read.cues.into_iter().map(|Cue { start, end, text }| (start, end, text)).collect()
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
        let time = "00:00:01,000 --> 00:00:02,000";
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
            (format!("1\n{time}\nHi\n\nno time here\nnone"), false, Flaw::Stray(5, "no time here".into())),
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

    #[test]
    fn what_a_file_says_is_told_as_json() {
        let read = |bytes: &[u8]| -> Value {
            let frames = [Frame { panel: 2, time: 1.5 }];
            serde_json::from_str(&told(bytes, false, &frames, "balloon")).unwrap()
        };
        let word = json!({ "kind": "balloon", "text": "Hello there", "panel": 2, "auto": true });
        assert_eq!(read(SRT.as_bytes()), json!({ "words": [word], "cues": 2, "left": 0, "cut": 0 }));
        assert_eq!(read(b"1\n"), json!({ "flaw": { "kind": "stray", "line": 1, "text": "1" } }));
        assert_eq!(read(b"1\0"), json!({ "flaw": { "kind": "binary" } }));
    }

    #[test]
    fn files_are_read_in_utf_8_and_utf_16_and_refused_in_anything_else() {
        let units: Vec<u16> = SRT.encode_utf16().collect();
        let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        for bytes in [SRT.as_bytes(), &little, &big] {
            assert_eq!(Subtitles::read(bytes, false).unwrap().cues.len(), 2);
        }
        for bytes in [&[0x31, 0xe9, 0x0a][..], b"1\0", &[0xFF, 0xFE, 0x00], &[0xFE, 0xFF, 0xD8, 0x00]] {
            assert_eq!(Subtitles::read(bytes, false), Err(Flaw::Binary));
        }
        assert_eq!(Subtitles::read(&vec![b' '; MOST_BYTES + 1], false), Err(Flaw::Large));
    }

    #[test]
    fn a_frame_has_what_is_said_at_its_time_or_close_to_it() {
        let cues = Subtitles::parse(SRT, false).unwrap().cues;
        let at = |time| cue_at(&cues, time, 0.5).map(|cue| cues[cue].text.as_str());
        assert_eq!((at(2.0), at(2.9), at(5.0)), (Some("Hello there"), Some("Hello there"), None));
        assert_eq!(cue_at(&[], 5.0, 0.5), None);
    }

    #[test]
    fn a_subtitle_goes_to_one_frame_only_the_one_nearest_to_its_middle() {
        let frames = [(0, 1.1), (1, 1.7), (2, 30.0), (3, 61.0)].map(|(panel, time)| Frame { panel, time });
        let words = matched(&Subtitles::parse(SRT, false).unwrap().cues, &frames, "caption");
        let word = |text: &str, panel: usize| json!({ "kind": "caption", "text": text, "panel": panel, "auto": true });
        assert_eq!(words, [word("Hello there", 1), word("Bye", 3)]);
    }

    #[test]
    fn what_is_too_much_is_counted() {
        const CUE: &str = "00:00:01,000 --> 00:00:02,000\n";
        let many: Vec<String> = (0..MOST_CUES + 7).map(|i| format!("{CUE}{i}")).collect();
        let read = Subtitles::parse(&many.join("\n\n"), false).unwrap();
        assert_eq!((read.cues.len(), read.left, read.cues[0].text.as_str()), (MOST_CUES, 7, "0"));
        let long = format!("{CUE}{}\n\n{CUE}short", "\u{1f600}".repeat(MOST_LETTERS + 1));
        let read = Subtitles::parse(&long, false).unwrap();
        assert_eq!(
            (read.cut, read.cues[0].text.chars().count(), read.cues[1].text.as_str()),
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
                    prop_assert!(read.cues.iter().map(|cue| cue.text.len()).sum::<usize>() <= text.len());
                    prop_assert!(read.cues.is_sorted_by(|a, b| a.start <= b.start));
                    for Cue { start, end, text } in &read.cues {
                        prop_assert!(end >= start && *start >= 0.0 && !text.is_empty() && trimmed(text) == text);
                    }
                }
            }
        }
    }
}
