//! Subtitles, and the frames that they go to. The readers of the file formats are in `formats`.

mod formats;
mod markup;

use super::script::{self, Placed};
use super::speech::{self, Said, Taking};
use crate::json::{Writer, unmarked};
use crate::order::sort_by;
use crate::page::words::model::NewText;
use formats::RawCue;

/// Most bytes of a file.
pub const MOST_BYTES: usize = 5_000_000;
/// Most bytes of its text in UTF-8. Characters of other encodings have at least a third of their bytes in UTF-8.
const MOST_LENGTH: usize = 3 * MOST_BYTES;
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
    /// Reads the text of a file. Its kind is determined by its content: `SubRip`, `WebVTT`, Advanced `SubStation`, or
    /// the subtitles of `YouTube`. `vtt` requires the header of `WebVTT`.
    ///
    /// # Errors
    /// Returns the error in the text.
    pub fn parse(text: &str, vtt: bool) -> Result<Self> {
        if text.len() > MOST_LENGTH {
            return Err(Flaw::Large);
        }
        if text.contains('\0') {
            return Err(Flaw::Binary);
        }
        let (raw, flaws) = formats::read(unmarked(text), vtt)?;
        let mut all = Self { skipped: flaws.len(), ..Self::default() };
        all.flaws = flaws.into_iter().take(MOST_SKIPPED).collect();
        for RawCue { start, end, lines, speaker, .. } in raw {
            let text = lines.join("\n");
            let (text, cut) = match text.char_indices().nth(MOST_LETTERS) {
                Some((end, _)) => (&text[..end], true),
                None => (&text[..], false),
            };
            let mut said = speech::of_lines(text.split('\n'));
            if let Some(first) = said.first_mut().filter(|first| first.manner != speech::Manner::Sound) {
                first.speaker = first.speaker.take().or(speaker);
            }
            if said.is_empty() {
                continue;
            }
            if all.cues.len() == MOST_CUES {
                all.left += 1;
            } else {
                all.cut += usize::from(cut);
                all.cues.push(Cue { start, end, said });
            }
        }
        if all.cues.is_empty() {
            return Err(all.flaws.into_iter().next().unwrap_or(Flaw::Empty));
        }
        sort_by(&mut all.cues, |a, b| a.start.total_cmp(&b.start));
        Ok(all)
    }
}

/// The middle of each subtitle in seconds, for the choice of frames. Empty for an invalid file.
#[must_use]
pub fn middles(text: &str, vtt: bool) -> Vec<f64> {
    let cues = Subtitles::parse(text, vtt).map(|read| read.cues).unwrap_or_default();
    cues.iter().map(|cue| f64::midpoint(cue.start, cue.end)).collect()
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
pub fn matched(cues: &[Cue], frames: &[Frame], taking: Taking) -> (Vec<NewText>, usize) {
    let words: Vec<Vec<NewText>> = cues
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
            word.frame = Some(frame);
            word.item.cue = Some(format!("{:.3}/{part}", cue.start));
            made.push(word);
        }
    }
    (made, homeless)
}

/// Matches a subtitle file with frames, in JSON: `{words, unplaced, cues, homeless, left, cut, skipped,
/// flaws}`. The fields are the text items, and the number of subtitles that were read, found no
/// frame, were left out, cut or skipped. An invalid file gives `{flaw: {kind, line, text}}`. Without frames,
/// the text items are placed on panels in order, see `script::placed`.
#[must_use]
pub fn told(text: &str, vtt: bool, frames: &[Frame], panels: usize, taking: Taking) -> String {
    let mut out = Writer::default();
    out.open(b'{');
    match Subtitles::parse(text, vtt) {
        Ok(Subtitles { cues, left, cut, flaws, skipped }) => {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::text_lines::trimmed;
    use crate::page::words::TextKind;
    use proptest::prelude::*;
    use serde_json::{Value, json};

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
            (
                "1\n00:00:01,0a0 --> 00:00:02\nHi".into(),
                false,
                Flaw::Time(2, "00:00:01,0a0 --> 00:00:02".into()),
            ),
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
        let text = format!(
            "no time here\nnone\n\n1\n{time}\nHi\n\n2\nno time\n\n3\nsoon --> later\nx\n\n4\n{time}\nBye\n\n5\n"
        );
        let read = Subtitles::parse(&text, false).unwrap();
        assert_eq!(read.cues.iter().map(said).collect::<Vec<_>>(), ["Hi", "Bye"]);
        let flaws = [
            Flaw::Stray(1, "no time here".into()),
            Flaw::Stray(8, "2".into()),
            Flaw::Time(12, "soon --> later".into()),
        ];
        assert_eq!((read.skipped, &read.flaws[..]), (4, &flaws[..]));
        let many = format!("{}{time}\nHi", "x\ny\n\n".repeat(9));
        let read = Subtitles::parse(&many, false).unwrap();
        assert_eq!((read.skipped, read.flaws.len()), (9, MOST_SKIPPED));
    }

    #[test]
    fn a_line_with_times_begins_a_subtitle_and_no_text_is_lost() {
        let read = |text: &str| cues(text, false).into_iter().map(|cue| cue.2).collect::<Vec<_>>();
        let [one, two] = ["00:00:01,000 --> 00:00:02,000", "00:00:03,000 --> 00:00:04,000"];
        let cases = [
            // No empty lines, with and without numbers.
            (format!("1\n{one}\nHi\n2\n{two}\nBye"), vec!["Hi", "Bye"]),
            (format!("{one}\nHi\n{two}\n7"), vec!["Hi", "7"]),
            (format!("{one}\nHow many?\n42\n{two}\nBye"), vec!["How many? 42", "Bye"]),
            // Empty lines before, in and after the text.
            (format!("1\n{one}\n\nHi\n\nthere\n\n2\n{two}\n \nBye"), vec!["Hi there", "Bye"]),
            // The text is a number; the text is missing.
            (format!("1\n{one}\n5\n\n2\n{two}\nBye"), vec!["5", "Bye"]),
            (format!("1\n{one}\n\n2\n{two}\nBye"), vec!["Bye"]),
            (
                format!("1\r\r\n{one}\r\r\nHi\r\r\nthere\r\r\n\r\r\n2\r\r\n{two}\r\r\nBye"),
                vec!["Hi there", "Bye"],
            ),
            // An arrow in the text.
            (format!("1\n{one}\nGo\nA --> B\n\n2\n{two}\n1 -> 2"), vec!["Go A --> B", "1 -> 2"]),
        ];
        for (text, said) in cases {
            assert_eq!(read(&text), said, "{text:?}");
        }
        let vtt =
            format!("WEBVTT\n{}\nHi\n \nthere\nBen\n{}\nBye", one.replace(',', "."), two.replace(',', "."));
        assert_eq!(
            cues(&vtt, true).into_iter().map(|cue| cue.2).collect::<Vec<_>>(),
            ["Hi there Ben", "Bye"]
        );
    }

    #[test]
    fn times_are_read_in_unusual_forms() {
        let cases = [
            ("00:00:01:000 --> 00:00:02:500", 1.0, 2.5),
            ("00:00:01 --> 00:00:02", 1.0, 2.0),
            ("0:01,5 --> 0:02.25", 1.5, 2.25),
            (" 00 : 00 : 01 , 000 -->00: 00:02, 500  X1:10 X2:20", 1.0, 2.5),
            ("100:00:01,000 --> 9999:00:02,000", 360_001.0, 35_996_402.0),
            ("00:00:01.123456 -> 00:00:02.0000", 1.123, 2.0),
            ("00：00：01，000 → 00：00：02，000", 1.0, 2.0),
            ("00:00:01:10 --> 00:00:02:05", 1.4, 2.2),
            ("00:00:01.000 – > 00:00:02.000 align:start", 1.0, 2.0),
            ("1.5 --> 2.5", 1.5, 2.5),
        ];
        for (line, start, end) in cases {
            assert_eq!(cues(&format!("1\n{line}\nHi"), false), [(start, end, "Hi".into())], "{line}");
        }
        for line in [
            "00:00:01,000 --> soon",
            "-00:00:01,000 --> 00:00:02,000",
            "00:61:01,000 --> 01:62:02,000",
            "1:2:3:4:5 --> 2:2:3:4:5",
        ] {
            let flaw = Flaw::Time(2, line.into());
            assert_eq!(Subtitles::parse(&format!("1\n{line}\nHi"), false), Err(flaw), "{line}");
        }
    }

    #[test]
    fn the_kind_of_a_file_is_in_its_content() {
        let ass = "[Script Info]\nTitle: x\n\n[Events]\nFormat: Layer, Start, End, Style, Name, MarginL, MarginR, MarginV, Effect, Text\nComment: 0,0:00:00.00,0:00:01.00,,,0,0,0,,no\nDialogue: 1,0:00:01.50,0:00:02.00,Default,Anna,0,0,0,,{\\i1}Hello, you{\\i0}\\Nthere\\hnow\nDialogue: 0,0:00:01.50,0:00:02.00,Default,Anna,0,0,0,,Hello, you\\Nthere now\nDialogue: 0,0:00:03.00,0:00:04.00,Sign,,0,0,0,,{\\p1}m 0 0 l 1 1{\\p0}\nDialogue: 0,soon,0:00:04.00,Sign,,0,0,0,,Bye";
        let read = Subtitles::parse(ass, false).unwrap();
        let speaker = read.cues[0].said[0].speaker.as_deref();
        assert_eq!(
            (read.cues.len(), said(&read.cues[0]).as_str(), speaker),
            (1, "Hello, you there now", Some("Anna"))
        );
        assert_eq!((read.cues[0].start, read.cues[0].end, read.skipped), (1.5, 2.0, 1));
        let ssa = "[Events]\nFormat: Marked, Start, End, Style, Name, MarginL, MarginR, MarginV, Effect, Text\nDialogue: Marked=0,0:00:01.50,0:00:02.00,Default,,0,0,0,,Hi";
        assert_eq!(cues(ssa, false), [(1.5, 2.0, "Hi".into())]);
        let sbv = "0:00:01.000,0:00:02.500\nHello[br]there\nyou\n\n0:01:00.000,0:01:02.000\nBye, 1,2";
        assert_eq!(cues(sbv, false), [(1.0, 2.5, "Hello there you".into()), (60.0, 62.0, "Bye, 1,2".into())]);
        assert_eq!(cues("WEBVTT - title\n\n00:01.000 --> 00:02.000\nHi", false), [(1.0, 2.0, "Hi".into())]);
    }

    #[test]
    fn lines_that_roll_up_are_read_once() {
        let texts = |text: &str, vtt| cues(text, vtt).into_iter().map(|cue| cue.2).collect::<Vec<_>>();
        let vtt = "WEBVTT\nKind: captions\n\n00:00:00.000 --> 00:00:02.000 align:start position:0%\n \nhello<00:00:00.400><c> there</c>\n\n00:00:02.000 --> 00:00:02.010\nhello there\n \n\n00:00:02.010 --> 00:00:04.000\nhello there\ngeneral<00:00:02.400><c> kenobi</c>\n\n00:00:04.000 --> 00:00:04.010\ngeneral kenobi\n \n\n00:00:04.010 --> 00:00:06.000\ngeneral kenobi\nyou are<00:00:05.000><c> bold</c>\n";
        assert_eq!(texts(vtt, true), ["hello there", "general kenobi", "you are bold"]);
        let roll: Vec<String> = ["a\nb", "b\nc", "c\nd", "d\ne"]
            .iter()
            .enumerate()
            .map(|(i, text)| format!("00:00:0{i},000 --> 00:00:0{},000\n{text}\n\n", i + 1))
            .collect();
        assert_eq!(texts(&roll.concat(), false), ["a b", "c", "d", "e"]);
        // An answer may be the same word.
        let no = "00:00:01,000 --> 00:00:02,000\nNo.\n\n00:00:02,000 --> 00:00:03,000\nNo.";
        assert_eq!(texts(no, false), ["No.", "No."]);
    }

    /// Editors on Windows put marks of direction around the punctuation of Arabic and Hebrew.
    #[test]
    fn marks_of_direction_are_kept() {
        let srt = "1\n00:00:01,000 --> 00:00:02,000\n\u{200f}שלום!\u{200f}\n\u{200e}\n";
        assert_eq!(cues(srt, false)[0].2, "\u{200f}שלום!\u{200f}");
    }

    #[test]
    fn times_of_subtitles_are_their_middles() {
        assert_eq!(middles(SRT, false), [1.75, 1830.875]);
        assert!(middles("", false).is_empty());
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
    fn marks_are_taken_out_and_other_text_in_brackets_stays() {
        let cases = [
            ("<c.a.b>Hi</c> <there", "Hi <there"),
            ("a > b <<i>> c", "a > b <> c"),
            ("I <3 you and 5 > 4", "I <3 you and 5 > 4"),
            ("a<b and c>d, <whispers> no", "a<b and c>d, <whispers> no"),
            ("<font color=\"red\">Hi</FONT> <b>you</b><00:00:01.500>!", "Hi you!"),
            ("{\\an8}Up {\\pos(1,2)}here {here}", "Up here {here}"),
            ("{\\Up", "{\\Up"),
            ("Hello<br>there<BR/>friend<br />!", "Hello there friend !"),
            ("Up\\Nand down\\hnow", "Up and down now"),
            ("a&amp;b &lt;i&gt; &nbsp;c&lrm; &x; &amp", "a&b <i> c\u{200e} &x; &amp"),
            (
                "Don&#39;t say &quot;never&quot; &amp; go &eacute;t&eacute; 5&deg; &#x2014; &hellip; &#146;",
                "Don't say \"never\" & go été 5° — … ’",
            ),
            ("&amp;lt;", "&lt;"),
            ("<ruby>漢字<rt>かんじ</rt></ruby>を読む", "漢字《かんじ》を読む"),
            ("大<ruby>漢<rp>(</rp><rt>かん</rt><rp>)</rp>字<rt>じ</rt></ruby>", "大｜漢《かん》字《じ》"),
            ("<ruby>base<rt>top</rt></ruby> <ruby>x<rt></rt></ruby>", "｜base《top》 x"),
            (" \t x\u{a0}\u{2028} y ", "x y"),
        ];
        for (line, said) in cases {
            assert_eq!(cues(&format!("00:00:01,000 --> 00:00:02,000\n{line}"), false)[0].2, said, "{line:?}");
        }
    }

    const TAKING: Taking = Taking { kind: TextKind::Balloon, sounds: false };

    #[test]
    fn what_a_file_says_is_told_as_json() {
        let read = |text: &str, frames: &[Frame]| -> Value {
            serde_json::from_str(&told(text, false, frames, 2, TAKING)).unwrap()
        };
        let frames = [Frame { time: 90.0, shown: true }, Frame { time: 1.5, shown: true }];
        let word = json!({ "kind": "balloon", "text": "Hello there", "auto": true });
        let on = |word: &Value, name: &str, at: Value| {
            let mut word = word.clone();
            word[name] = at;
            word
        };
        let placed = on(&on(&word, "frame", json!(1)), "cue", json!("1.000/0"));
        let answer = read(SRT, &frames);
        assert_eq!(answer["words"][0], placed);
        assert_eq!((&answer["cues"], &answer["homeless"]), (&json!(2), &json!(0)));
        // Without frames they are laid over the panels.
        let words = read(SRT, &[])["words"].clone();
        let bye = json!({ "kind": "balloon", "text": "Bye", "auto": true });
        assert_eq!(words, json!([on(&word, "place", json!(0)), on(&bye, "place", json!(1))]));
        assert_eq!(read("1\n", &[]), json!({ "flaw": { "kind": "stray", "line": 1, "text": "1" } }));
        assert_eq!(read("1\0", &[]), json!({ "flaw": { "kind": "binary" } }));
    }

    #[test]
    fn text_that_is_too_long_or_binary_is_refused() {
        assert_eq!(Subtitles::parse(&" ".repeat(MOST_LENGTH + 1), false), Err(Flaw::Large));
        assert_eq!(Subtitles::parse("1\0", false), Err(Flaw::Binary));
    }

    /// Text items by content, with the indices of their frames.
    fn homes(cues: &[Cue], frames: &[(f64, bool)]) -> (Vec<(String, u64)>, usize) {
        let frames: Vec<Frame> = frames.iter().map(|&(time, shown)| Frame { time, shown }).collect();
        let (words, homeless) = matched(cues, &frames, TAKING);
        let home = |word: &NewText| (word.item.text.clone(), word.frame.unwrap() as u64);
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
            let _: Result<_> = Subtitles::parse(&wall(part), false);
        }
        assert!(begin.elapsed().as_secs() < 20);
    }

    /// A generated subtitle: its times, how they are written, the decoration of its lines, and the empty lines around them.
    #[derive(Debug, Clone)]
    struct Written {
        times: usize,
        lines: Vec<usize>,
        gaps: [bool; 2],
        apart: usize,
    }

    fn written() -> impl Strategy<Value = Written> {
        let lines = prop::collection::vec(0_usize..10, 1..4);
        (0_usize..9, lines, any::<[bool; 2]>(), 0_usize..3).prop_map(|(times, lines, gaps, apart)| Written {
            times,
            lines,
            gaps,
            apart,
        })
    }

    /// The file of the subtitles, and the words of the subtitles with valid times.
    fn file(all: &[Written], vtt: bool, numbered: bool, end: &str) -> (String, Vec<String>, usize) {
        let mut lines: Vec<String> = if vtt { vec!["WEBVTT".into(), String::new()] } else { Vec::new() };
        let (mut words, mut bad) = (Vec::new(), 0);
        for (i, Written { times, lines: decorations, gaps, apart }) in all.iter().enumerate() {
            let (from, to) = (2 * i, 2 * i + 1);
            let time = match times {
                0 => format!("{from}.5 --> {to}.75"),
                1 => format!(
                    "00:{:02}:{:02}:000 --> 00:{:02}:{:02}:500",
                    from / 60,
                    from % 60,
                    to / 60,
                    to % 60
                ),
                2 => format!("{:02}:{:02} --> {:02}:{:02}", from / 60, from % 60, to / 60, to % 60),
                3 => format!("{}:00:01,000 --> {}:00:02,000 X1:5", 100 + from, 100 + from),
                4 => "soon --> later".to_owned(),
                5 => "00:00:09,000 --> 00:00:01,000".to_owned(),
                _ => {
                    format!("00:{:02}:{:02}.5 --> 00:{:02}:{:02}.25", from / 60, from % 60, to / 60, to % 60)
                }
            };
            let is_bad = matches!(times, 4 | 5);
            bad += usize::from(is_bad);
            // Without an empty line before it, a line without times is text.
            if is_bad && lines.last().is_some_and(|line| !line.is_empty()) {
                lines.push(String::new());
            }
            if numbered {
                lines.push((i + 1).to_string());
            }
            lines.push(time);
            for (j, decoration) in decorations.iter().enumerate() {
                let word = format!("w{i}x{j}");
                if gaps[usize::from(j > 0)] && !vtt && !is_bad {
                    lines.push(String::new());
                }
                lines.push(match decoration {
                    0 => format!("<i>{word}</i>"),
                    1 => format!("{{\\an8}}{word} &amp; <3"),
                    2 => format!("a<br/>{word}"),
                    3 => format!("<v Anna>{word}</v>"),
                    4 => format!("- {word}"),
                    5 => format!("{word}\\N{j}"),
                    6 => format!("<ruby>{word}<rt>x</rt></ruby>"),
                    7 => format!("<00:00:00.500><c>{word}</c>"),
                    8 => format!("  {word}\t"),
                    _ => format!("&lt;{word}&gt; -> 5 > 4"),
                });
                if !is_bad {
                    words.push(word);
                }
            }
            let most = if is_bad || vtt { (*apart).max(1) } else { *apart };
            lines.extend(std::iter::repeat_n(String::new(), most));
        }
        (lines.join(end), words, bad)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        #[test]
        fn every_line_of_text_is_read_or_reported(
            all in prop::collection::vec(written(), 1..9),
            vtt: bool,
            numbered: bool,
            end in prop::sample::select(vec!["\n", "\r\n", "\r", "\r\r\n"]),
        ) {
            let (text, words, bad) = file(&all, vtt, numbered, end);
            match Subtitles::parse(&text, vtt) {
                Ok(read) => {
                    let said = read.cues.iter().map(self::said).collect::<Vec<_>>().join(" ");
                    for word in &words {
                        prop_assert_eq!(said.matches(word.as_str()).count(), 1, "{} in {:?}", word, said);
                    }
                    prop_assert!(read.skipped >= bad, "{} of {bad}", read.skipped);
                }
                Err(_) => prop_assert!(words.is_empty() && bad > 0),
            }
        }
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
                    prop_assert!(homeless <= read.cues.len() && words.iter().all(|word| word.frame < Some(2)));
                }
            }
        }
    }
}
