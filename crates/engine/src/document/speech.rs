//! Splits text for balloons: separates speakers, distinguishes sounds from speech, and splits long texts at
//! natural pauses.

use super::text_lines::{is_space, trimmed};
use crate::page::words::model::{NewText, Shape, TextItem, TextKind};

/// Maximum length of a balloon's text in characters, about six short lines. Longer texts are split.
pub const LONG: usize = 96;
/// Maximum characters of one part of a long text. A single longer word may exceed it.
const PART: usize = 72;
/// Letters of the name of a speaker.
const LONGEST_NAME: usize = 24;
/// Words of the name of a speaker.
const NAME_WORDS: usize = 3;

/// Manner of speech.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Manner {
    /// Normal speech.
    #[default]
    Said,
    /// Thought.
    Thought,
    /// Whispered.
    Whisper,
    /// Shouted.
    Shout,
    /// Narration.
    Told,
    /// A sound or a song.
    Sound,
}

/// Speech of one speaker.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Said {
    /// How.
    pub manner: Manner,
    /// Name of the speaker, if known.
    pub speaker: Option<String>,
    /// Whether the speaker changes, marked by a dash.
    pub turn: bool,
    /// Text.
    pub text: String,
}

/// Options for speech and sounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Taking {
    /// Kind of the text items: a caption or a balloon.
    pub kind: TextKind,
    /// Whether sounds become sound effects. If not, they are dropped.
    pub sounds: bool,
}

/// Parses the lines of a subtitle. `- ` or `NAME:` begins another speaker, and `[a door slams]` is a sound.
/// Text between note symbols is music. Note symbols without text are dropped.
#[must_use]
pub fn of_lines<'l>(lines: impl Iterator<Item = &'l str>) -> Vec<Said> {
    let mut all: Vec<Said> = Vec::new();
    for line in lines {
        let mut fresh = false;
        for piece in pieces(trimmed(line)) {
            let (sound, text) = match piece {
                Piece::Sound(text) => (true, text),
                Piece::Speech(text) => (false, text),
            };
            if sound {
                if text.chars().any(char::is_alphanumeric) {
                    all.push(Said { manner: Manner::Sound, text: text.to_owned(), ..Said::default() });
                }
                fresh = true;
                continue;
            }
            let (dashed, text) = undashed(text);
            let (speaker, text) = match named(text, true) {
                Some((name, rest)) => (Some(name.to_owned()), rest),
                None => (None, text),
            };
            fresh |= dashed || speaker.is_some();
            match all.last_mut().filter(|last| !fresh && last.manner == Manner::Said) {
                Some(last) => {
                    last.text.push(' ');
                    last.text.push_str(text);
                }
                // A name may be on a separate line, before the speech.
                None if !text.is_empty() || speaker.is_some() => {
                    all.push(Said { speaker, turn: dashed, text: text.to_owned(), ..Said::default() });
                }
                None => {}
            }
            fresh = false;
        }
    }
    for said in &mut all {
        said.text = trimmed(&said.text).to_owned();
    }
    all.retain(|said| !said.text.is_empty());
    all
}

/// A part of a line.
enum Piece<'l> {
    Speech(&'l str),
    Sound(&'l str),
}

/// Splits a line at its brackets. Text in round brackets is a sound if the line has nothing else.
fn pieces(line: &str) -> Vec<Piece<'_>> {
    let is_note = |letter: char| matches!(letter, '♪' | '♫' | '♬' | '♩');
    let bare = line.trim_start_matches(['-', '–', '—', ' ']);
    if bare.starts_with(is_note) || (bare.starts_with("# ") && bare.ends_with(" #")) {
        return vec![Piece::Sound(trimmed(bare.trim_matches(|letter| is_note(letter) || letter == '#')))];
    }
    if let Some(inside) = bare
        .strip_prefix('(')
        .and_then(|rest| rest.strip_suffix(')'))
        .filter(|inside| !inside.contains(['(', ')']))
    {
        return vec![Piece::Sound(trimmed(inside))];
    }
    let mut all = Vec::new();
    let mut rest = line;
    while let Some((before, inside, after)) = bracketed(rest) {
        if !undashed(before).1.is_empty() {
            all.push(Piece::Speech(trimmed(before)));
        }
        all.push(Piece::Sound(trimmed(inside)));
        rest = after;
    }
    if !trimmed(rest).is_empty() {
        all.push(Piece::Speech(trimmed(rest)));
    }
    all
}

/// The text before, inside and after the first square brackets.
fn bracketed(line: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = line.split_once('[')?;
    let (inside, after) = rest.split_once(']')?;
    Some((before, inside, after))
}

/// Returns whether a dash marks a change of the speaker, and the text without it.
fn undashed(text: &str) -> (bool, &str) {
    let text = trimmed(text);
    let rest = text.strip_prefix(">>").or_else(|| text.strip_prefix(['-', '–', '—', '‐', '‑']));
    match rest {
        // Negative numbers are not dialogue.
        Some(rest) if !rest.starts_with(|letter: char| letter.is_ascii_digit()) => {
            (true, trimmed(rest.trim_start_matches(['-', '>'])))
        }
        _ => (false, text),
    }
}

/// Returns the name before a colon, and the text after it. `loud`: names must be in capitals, as in
/// subtitles. There a colon in a sentence does not mark a name.
#[must_use]
pub fn named(text: &str, loud: bool) -> Option<(&str, &str)> {
    let (name, rest) = text.split_once([':', '：'])?;
    let name = trimmed(name);
    // A time of the day, or an address.
    if rest.starts_with(|letter: char| letter.is_ascii_digit() || letter == '/') {
        return None;
    }
    let words = name.split(is_space).filter(|word| !word.is_empty()).count();
    let fits = (1..=NAME_WORDS).contains(&words) && name.chars().count() <= LONGEST_NAME;
    let letters =
        name.chars().any(char::is_alphabetic) && !name.contains(['.', ',', '!', '?', '"', '“', '«']);
    let capitals = !name.chars().any(char::is_lowercase) && name.chars().any(char::is_uppercase);
    (fits && letters && (!loud || capitals)).then(|| (name, trimmed(rest)))
}

/// Splits a long text into parts of about one balloon. It prefers ends of sentences, then of clauses, then of
/// words.
#[must_use]
pub fn parted(text: &str) -> Vec<&str> {
    let mut parts = Vec::new();
    let mut rest = trimmed(text);
    loop {
        let count = rest.chars().count();
        if count <= LONG {
            break;
        }
        // Parts of about the same length read better than full ones and a rest.
        let wanted = count.div_ceil(count.div_ceil(PART));
        let end = cut(rest, wanted);
        parts.push(trimmed(&rest[..end]));
        rest = trimmed(&rest[end..]);
    }
    parts.push(rest);
    parts.retain(|part| !part.is_empty());
    parts
}

/// The best position to split a text after about `wanted` characters, as a byte index.
fn cut(text: &str, wanted: usize) -> usize {
    let least = wanted / 2;
    let most = wanted + wanted / 4;
    let (mut best, mut dearest) = (None, f64::MAX);
    let mut before = ' ';
    let mut letters = text.char_indices().enumerate().peekable();
    while let Some((count, (at, letter))) = letters.next() {
        if count >= most {
            break;
        }
        let end = at + letter.len_utf8();
        let next = letters.peek().map_or(' ', |(_, (_, next))| *next);
        let cost = match letter {
            // Scripts without spaces end their sentences so.
            '。' | '！' | '？' | '…' if !is_mark(next) => 0.0,
            '、' | '，' | '；' if !is_mark(next) => 0.4,
            _ if !is_space(next) => {
                before = letter;
                continue;
            }
            '.' | '!' | '?' | '"' | '”' | '’' | '»' | ')' if before != '.' || letter != '.' => 0.0,
            ',' | ';' | ':' | '–' | '—' => 0.4,
            _ => 1.0,
        };
        before = letter;
        if count + 1 < least {
            continue;
        }
        let off = (count + 1).abs_diff(wanted) as f64 / wanted as f64;
        if cost + off < dearest {
            (best, dearest) = (Some(end), cost + off);
        }
    }
    best.unwrap_or_else(|| text.char_indices().nth(wanted).map_or(text.len(), |(at, _)| at))
}

fn is_mark(letter: char) -> bool {
    matches!(letter, '。' | '！' | '？' | '…' | '、' | '，' | '；' | '」' | '』' | '）')
}

/// Text items of a speech. Empty for dropped sounds.
#[must_use]
pub fn words(said: &Said, taking: Taking) -> Vec<NewText> {
    let item = |kind, text: &str| TextItem { auto: Some(true), ..TextItem::new(kind, text) };
    let shaped = |shape, text: &str| TextItem { shape: Some(shape), ..item(TextKind::Balloon, text) };
    let new = |item| NewText { item, ..NewText::default() };
    if said.manner == Manner::Sound {
        let short = said.text.chars().count() <= 20;
        return match (taking.sounds, short) {
            (false, _) => Vec::new(),
            (true, true) => {
                vec![new(TextItem { angle: -8.0, ..item(TextKind::Effect, &said.text.to_uppercase()) })]
            }
            // Sentences and songs are not sound effects.
            (true, false) => {
                parted(&said.text).into_iter().map(|text| new(item(TextKind::Caption, text))).collect()
            }
        };
    }
    let word = |text| match said.manner {
        Manner::Thought => shaped(Shape::Thought, text),
        Manner::Whisper => shaped(Shape::Whisper, text),
        Manner::Shout => shaped(Shape::Shout, text),
        Manner::Told => item(TextKind::Caption, text),
        Manner::Said | Manner::Sound => item(taking.kind, text),
    };
    let mut words: Vec<NewText> = parted(&said.text).into_iter().map(|text| new(word(text))).collect();
    let balloons = words.iter_mut().filter(|word| word.item.kind == TextKind::Balloon);
    for (part, word) in balloons.enumerate() {
        word.item.by = said.speaker.as_ref().map(|name| name.to_lowercase());
        // All parts have the same speaker, so their balloons may be linked.
        word.joins = part > 0;
        word.item.apart = part == 0 && said.turn;
    }
    words
}

/// Distributes more groups than positions over positions in order, each with about the same number.
#[must_use]
pub fn laid(count: usize, places: usize) -> Vec<usize> {
    let of = |group: usize| if count > places { group * places / count } else { group };
    (0..count).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn told(lines: &[&str]) -> Vec<(Manner, String)> {
        of_lines(lines.iter().copied()).into_iter().map(|said| (said.manner, said.text)).collect()
    }

    fn speech(text: &str) -> (Manner, String) {
        (Manner::Said, text.to_owned())
    }

    fn sound(text: &str) -> (Manner, String) {
        (Manner::Sound, text.to_owned())
    }

    type Case = (&'static [&'static str], Vec<(Manner, String)>);

    #[test]
    fn speakers_and_sounds_are_told_apart() {
        let cases: [Case; 13] = [
            (&["Hello", "there."], vec![speech("Hello there.")]),
            (&["- Who is it?", "- Me."], vec![speech("Who is it?"), speech("Me.")]),
            (&["-Who is it,", "at night?", "–Me."], vec![speech("Who is it, at night?"), speech("Me.")]),
            (&["ANNA: Hello.", "DR. NO: No."], vec![speech("Hello. DR. NO: No.")]),
            (&["ANNA: Hello.", "DR NO: No."], vec![speech("Hello."), speech("No.")]),
            (&["It is this: nothing.", "At 10:30."], vec![speech("It is this: nothing. At 10:30.")]),
            (&["[door slams]", "Go!"], vec![sound("door slams"), speech("Go!")]),
            (
                &["(SIGHS)", "Wait [a bell] here"],
                vec![sound("SIGHS"), speech("Wait"), sound("a bell"), speech("here")],
            ),
            (&["- [coughs] Well."], vec![sound("coughs"), speech("Well.")]),
            (&["♪"], vec![]),
            (&["♪ La la la ♪", "So."], vec![sound("La la la"), speech("So.")]),
            (&["-5 degrees"], vec![speech("-5 degrees")]),
            (&[">> Anna speaks.", ">> Ben too."], vec![speech("Anna speaks."), speech("Ben too.")]),
        ];
        for (lines, said) in cases {
            assert_eq!(told(lines), said, "{lines:?}");
        }
        assert_eq!(of_lines(["ÉVA: Oui."].into_iter())[0].speaker.as_deref(), Some("ÉVA"));
    }

    #[test]
    fn long_texts_are_parted_where_a_reader_breathes() {
        assert_eq!(parted("Short."), ["Short."]);
        let long = "I looked for you everywhere, in the garden and in the house. Nobody had seen you. Then I heard the boat, and I knew at once.";
        assert_eq!(
            parted(long),
            [
                "I looked for you everywhere, in the garden and in the house.",
                "Nobody had seen you. Then I heard the boat, and I knew at once.",
            ]
        );
        let clauses = "we went along the river and over the bridge, past the mill and the two old oaks, until there was nothing";
        assert_eq!(parted(clauses)[0], "we went along the river and over the bridge,");
        assert!(parted(&"x".repeat(1000)).iter().all(|part| part.len() <= LONG));
        let japanese = "昨日は雨が降っていました。".repeat(12);
        assert!(parted(&japanese).iter().all(|part| part.ends_with('。')));
    }

    #[test]
    fn sounds_are_left_out_or_effects() {
        let said = Said { manner: Manner::Sound, text: "door slams".into(), ..Said::default() };
        assert!(words(&said, Taking { kind: TextKind::Balloon, sounds: false }).is_empty());
        let made = words(&said, Taking { kind: TextKind::Balloon, sounds: true });
        let effect =
            serde_json::json!({ "kind": "effect", "text": "DOOR SLAMS", "angle": -8.0, "auto": true });
        assert_eq!(serde_json::to_value(&made).unwrap(), serde_json::json!([effect]));
        let shout = Said { manner: Manner::Shout, text: "Go!".into(), ..Said::default() };
        let made = words(&shout, Taking { kind: TextKind::Caption, sounds: true });
        assert_eq!(made[0].item.shape, Some(Shape::Shout));
    }

    #[test]
    fn groups_are_laid_over_places_in_order() {
        assert_eq!(laid(3, 6), [0, 1, 2]);
        assert_eq!(laid(5, 2), [0, 0, 0, 1, 1]);
        assert!(laid(0, 2).is_empty());
    }

    proptest! {
        #[test]
        fn no_letter_is_lost_and_nothing_is_long(text in "[ a-zé。.,!?-]{0,400}") {
            let bare = |text: &str| text.chars().filter(|letter| !is_space(*letter)).collect::<String>();
            let parts = parted(&text);
            prop_assert_eq!(bare(&parts.concat()), bare(&text));
            prop_assert!(parts.iter().all(|part| part.chars().count() <= LONG && !part.is_empty()));
        }

        #[test]
        fn any_lines_give_speech(lines in prop::collection::vec("[\\-\\[\\]()♪:> A-Ca-c\u{e9}]{0,12}", 0..6)) {
            for said in of_lines(lines.iter().map(String::as_str)) {
                prop_assert!(!said.text.is_empty() && trimmed(&said.text) == said.text);
            }
        }
    }
}
