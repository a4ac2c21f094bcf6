//! Readers of subtitle formats. Real files violate their formats in many ways, so the readers follow one
//! rule. A line with times begins a subtitle, and every line of text belongs to a subtitle or to a reported
//! error.

use super::markup::{self, Dialect};
use super::{Flaw, Result};
use crate::document::text_lines::{is_space, lines, trimmed};

/// A subtitle with the plain lines of its text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RawCue {
    /// Seconds.
    pub(super) start: f64,
    /// Seconds, no less than the start.
    pub(super) end: f64,
    /// Lines without markup. Empty lines are left out.
    pub(super) lines: Vec<String>,
    /// Name of the speaker, if the format has a field for it.
    pub(super) speaker: Option<String>,
    /// Whether single words of the text have times.
    pub(super) stamped: bool,
}

type Read = (Vec<RawCue>, Vec<Flaw>);

/// Tolerance in seconds between the end of a subtitle and the start of the next if the next repeats its lines.
const JOINT: f64 = 0.1;
/// Frames per second of a time such as `00:00:01:12`, whose last part counts frames.
const FRAMES: f64 = 25.0;

/// Reads the subtitles of a text, in the order of the file.
pub(super) fn read(text: &str, vtt: bool) -> Result<Read> {
    let lines = lines(text);
    let has_header = lines[0]
        .strip_prefix("WEBVTT")
        .is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', '\t', '-', ':']));
    if vtt && !has_header {
        return Err(Flaw::Header);
    }
    let (mut cues, flaws) = if has_header {
        blocks(&lines, Kind::Vtt)
    } else if lines.iter().any(|line| dialogue(line).is_some()) {
        substation(&lines)
    } else if !lines.iter().any(|line| arrow(line).is_some())
        && lines.iter().any(|line| comma(line).is_some())
    {
        blocks(&lines, Kind::YouTube)
    } else {
        blocks(&lines, Kind::Srt)
    };
    unroll(&mut cues);
    Ok((cues, flaws))
}

/// Formats of blocks: a line with times, and lines of text after it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Srt,
    Vtt,
    YouTube,
}

/// The subtitle that the lines belong to.
enum Open {
    /// No subtitle has started, or an empty line ended it.
    Nothing,
    Cue {
        start: f64,
        end: f64,
        text: Vec<usize>,
    },
    /// A block with a reported error, whose lines are skipped.
    Flawed,
}

fn blocks(lines: &[&str], kind: Kind) -> Read {
    let (mut cues, mut flaws) = (Vec::new(), Vec::new());
    let mut open = Open::Nothing;
    // The number of the last subtitle, and whether it had one.
    let (mut count, mut numbered) = (None, true);
    let mut at = 0;
    if kind == Kind::Vtt {
        // Lines after the header belong to it, up to an empty line or a time.
        at = 1 + lines[1..]
            .iter()
            .take_while(|line| !is_end(line, kind) && head(line, kind).is_none())
            .count();
    }
    let first = at;
    let close = |open: &mut Open, cues: &mut Vec<RawCue>| {
        if let Open::Cue { start, end, text } = std::mem::replace(open, Open::Nothing) {
            cues.push(cue(lines, (start, end), &text, kind));
        }
    };
    while at < lines.len() {
        let line = lines[at];
        let begins = at == first || is_end(lines[at - 1], kind);
        if is_end(line, kind) {
            if kind == Kind::Vtt || matches!(open, Open::Flawed) {
                close(&mut open, &mut cues);
            }
            at += 1;
            continue;
        }
        if kind == Kind::Vtt && begins && is_remark(line) {
            at += lines[at..].iter().take_while(|line| !is_end(line, kind)).count();
            continue;
        }
        let below = at + 1;
        // A number or a name may precede the times.
        let own = number(line);
        let named = lines.get(below).is_some_and(|next| is_head(next, own.is_some() || begins, kind))
            && match own {
                Some(own) => {
                    begins || (numbered && (kind == Kind::Srt || Some(own) == count.map(|last| last + 1)))
                }
                None => begins && (kind == Kind::Vtt || matches!(open, Open::Nothing)),
            };
        if named {
            close(&mut open, &mut cues);
            (count, numbered) = (own, true);
            open = begun(lines[below], below, kind, &mut flaws);
            at += 2;
            continue;
        }
        if is_head(line, begins, kind) {
            close(&mut open, &mut cues);
            numbered = false;
            open = begun(line, at, kind, &mut flaws);
            at += 1;
            continue;
        }
        // The next number without times: the times are missing or damaged.
        let follows = begins && own.is_some() && own == count.map(|last| last + 1);
        match &mut open {
            Open::Cue { text, .. } if !(follows || begins && is_clock(line)) => text.push(at),
            Open::Cue { .. } if is_clock(line) => {
                close(&mut open, &mut cues);
                flaws.push(Flaw::Time(at + 1, shortened(line)));
                open = Open::Flawed;
            }
            Open::Flawed => {}
            Open::Cue { .. } | Open::Nothing => {
                close(&mut open, &mut cues);
                flaws.push(Flaw::Stray(at + 1, shortened(line)));
                (count, open) = (own.or(count), Open::Flawed);
            }
        }
        at += 1;
    }
    close(&mut open, &mut cues);
    (cues, flaws)
}

/// Opens the subtitle of a line with times.
fn begun(line: &str, at: usize, kind: Kind, flaws: &mut Vec<Flaw>) -> Open {
    match head(line, kind) {
        Some((start, end)) if end >= start => Open::Cue { start, end, text: Vec::new() },
        Some(_) => {
            flaws.push(Flaw::Order(at + 1));
            Open::Flawed
        }
        None => {
            flaws.push(Flaw::Time(at + 1, shortened(line)));
            Open::Flawed
        }
    }
}

fn cue(lines: &[&str], (start, end): (f64, f64), text: &[usize], kind: Kind) -> RawCue {
    let text: Vec<&str> = text.iter().map(|&at| lines[at]).collect();
    let dialect = if kind == Kind::YouTube { Dialect::YouTube } else { Dialect::Tags };
    let (lines, stamped) = markup::plain(&text.join("\n"), dialect);
    RawCue { start, end, lines, speaker: None, stamped }
}

/// Whether a line ends a block. Lines of spaces do not in `WebVTT`.
fn is_end(line: &str, kind: Kind) -> bool {
    if kind == Kind::Vtt { line.is_empty() } else { trimmed(line).is_empty() }
}

/// Whether a line has times. A line with an arrow and without valid times is text, unless it has the `place` of times.
fn is_head(line: &str, place: bool, kind: Kind) -> bool {
    head(line, kind).is_some() || (place && kind != Kind::YouTube && line.contains("-->"))
}

/// The times of a line, in seconds.
fn head(line: &str, kind: Kind) -> Option<(f64, f64)> {
    let (before, after) = if kind == Kind::YouTube { comma(line)? } else { arrow(line)? };
    // Places and settings follow the times.
    Some((clock(before).filter(|(_, rest)| trimmed(rest).is_empty())?.0, clock(after)?.0))
}

/// The texts before and after an arrow between two times, in any of its forms.
fn arrow(line: &str) -> Option<(&str, &str)> {
    let (at, head) = line.char_indices().find(|(_, letter)| matches!(letter, '>' | '→' | '⇒'))?;
    let before = line[..at].trim_end();
    let bare = before.trim_end_matches(['-', '–', '—', '=', '‐', '−']);
    let is_arrow = head != '>' || bare.len() < before.len();
    let after = &line[at + head.len_utf8()..];
    (is_arrow && clock(bare).is_some() && clock(after).is_some()).then_some((bare, after))
}

/// The two times of a line that consists of them.
fn comma(line: &str) -> Option<(&str, &str)> {
    let (before, after) = line.split_once(',')?;
    let is_time =
        |text: &str| text.contains('.') && clock(text).is_some_and(|(_, rest)| trimmed(rest).is_empty());
    (is_time(before) && is_time(after)).then_some((before, after))
}

/// Whether a line consists of the signs of times and begins with a time.
fn is_clock(line: &str) -> bool {
    let line = trimmed(line);
    clock(line).is_some() && line.matches(':').count() >= 2 && !line.contains(char::is_alphabetic)
}

/// Reads a time at the start of a text: `hours:minutes:seconds,thousandths`. Hours and thousandths are optional, spaces
/// are allowed, and a colon may precede the thousandths. Returns seconds and the rest of the text.
fn clock(text: &str) -> Option<(f64, &str)> {
    let text = text.trim_start_matches(is_space);
    let mut parts: Vec<(char, &str)> = Vec::new();
    let (mut mark, mut rest, mut after) = (' ', text, text);
    loop {
        let digits = rest.len() - rest.trim_start_matches(|letter: char| letter.is_ascii_digit()).len();
        if digits == 0 || digits > 9 || parts.len() == 5 {
            break;
        }
        parts.push((mark, &rest[..digits]));
        after = &rest[digits..];
        let next = after.trim_start_matches(is_space);
        mark = match next.chars().next() {
            Some(':' | '：') => ':',
            Some('.' | ',' | '，' | ';') => '.',
            _ => break,
        };
        rest = next[next.chars().next()?.len_utf8()..].trim_start_matches(is_space);
    }
    let whole = |digits: &str| digits.parse::<f64>().ok();
    let &(last, tail) = parts.last()?;
    let part = if last == '.' {
        Some(whole(tail)? / 10_f64.powi(tail.len() as i32))
    } else if parts.len() == 4 {
        // The third colon precedes thousandths or frames.
        Some(if tail.len() == 3 { whole(tail)? / 1000.0 } else { (whole(tail)? / FRAMES).min(0.999) })
    } else {
        None
    };
    if part.is_some() {
        parts.pop();
    }
    if !(1..=3).contains(&parts.len())
        || (parts.len() == 1 && part.is_none())
        || parts[1..].iter().any(|(mark, digits)| *mark != ':' || digits.len() > 2)
    {
        return None;
    }
    let mut total = part.unwrap_or(0.0);
    let count = parts.len();
    for (i, ((_, digits), unit)) in parts.iter().rev().zip([1.0, 60.0, 3600.0]).enumerate() {
        let value = whole(digits)?;
        let most = if i == 2 { 9_999.0 } else { 59.0 };
        if value > most || (i == 1 && count == 2 && digits.len() > 2) {
            return None;
        }
        total += value * unit;
    }
    Some(((total * 1000.0).round() / 1000.0, after))
}

/// The number of a subtitle in its own line.
fn number(line: &str) -> Option<u64> {
    let line = trimmed(line).trim_start_matches('#').trim_end_matches(['.', ':', ')']);
    (!line.is_empty() && line.bytes().all(|digit| digit.is_ascii_digit()))
        .then(|| line.parse().ok())
        .flatten()
}

fn is_remark(line: &str) -> bool {
    let rest = ["NOTE", "STYLE", "REGION"].into_iter().find_map(|word| line.strip_prefix(word));
    rest.is_some_and(|rest| !rest.starts_with(|letter: char| letter.is_ascii_alphanumeric() || letter == '_'))
}

/// The fields of a line of dialogue in Advanced `SubStation`.
fn dialogue(line: &str) -> Option<&str> {
    let rest = trimmed(line).strip_prefix("Dialogue:")?;
    (rest.matches(',').count() >= 4).then_some(rest)
}

/// Fields of dialogue in `[V4+ Styles]` files without a format line.
const FIELDS: [&str; 10] =
    ["layer", "start", "end", "style", "name", "marginl", "marginr", "marginv", "effect", "text"];

/// Reads Advanced `SubStation` (`.ass`) and `SubStation` (`.ssa`).
fn substation(lines: &[&str]) -> Read {
    let (mut cues, mut flaws): Read = Default::default();
    let mut fields: Vec<String> = FIELDS.map(str::to_owned).to_vec();
    let mut section = String::from("[events]");
    for (at, line) in lines.iter().enumerate() {
        let line = trimmed(line);
        if line.starts_with('[') && line.ends_with(']') {
            section = line.to_lowercase();
        } else if let Some(names) = line.strip_prefix("Format:").filter(|_| section == "[events]") {
            fields = names.split(',').map(|name| trimmed(name).to_lowercase()).collect();
        }
        let Some(rest) = dialogue(line) else { continue };
        // The text is the last field, and has commas.
        let values: Vec<&str> = rest.splitn(fields.len().max(2), ',').collect();
        let value = |name: &str| Some(*values.get(fields.iter().position(|field| field == name)?)?);
        let time = |name| value(name).and_then(clock).map(|(seconds, _)| seconds);
        let (Some(start), Some(end), Some(text)) = (time("start"), time("end"), value("text")) else {
            flaws.push(Flaw::Time(at + 1, shortened(line)));
            continue;
        };
        if end < start {
            flaws.push(Flaw::Order(at + 1));
            continue;
        }
        let (lines, _) = markup::plain(text, Dialect::SubStation);
        let speaker = value("name").or_else(|| value("actor")).map(trimmed).filter(|name| !name.is_empty());
        let fresh = RawCue { start, end, lines, speaker: speaker.map(str::to_owned), stamped: false };
        // Outline, shadow and glyphs of one text are often separate lines.
        if !cues.contains(&fresh) {
            cues.push(fresh);
        }
    }
    (cues, flaws)
}

/// Removes the lines that a subtitle repeats from the subtitle before it, if the lines of the file roll up.
fn unroll(cues: &mut Vec<RawCue>) {
    let repeated = |before: &RawCue, next: &RawCue| {
        let most = before.lines.len().min(next.lines.len());
        let joined = next.start <= before.end + JOINT;
        (1..=most).rev().find(|&count| joined && before.lines.ends_with(&next.lines[..count])).unwrap_or(0)
    };
    let counts: Vec<usize> = cues.windows(2).map(|pair| repeated(&pair[0], &pair[1])).collect();
    let rolling = counts.iter().filter(|count| **count > 0).count();
    let stamped = cues.iter().any(|cue| cue.stamped);
    // Two people may say the same word one after the other.
    if !stamped && (rolling < 3 || 2 * rolling < counts.len()) {
        return;
    }
    for (cue, count) in cues.iter_mut().skip(1).zip(counts) {
        cue.lines.drain(..count);
    }
    cues.retain(|cue| !cue.lines.is_empty());
}

/// The start of a line, for a message.
fn shortened(line: &str) -> String {
    let line = trimmed(line);
    match line.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line.to_owned(),
    }
}
