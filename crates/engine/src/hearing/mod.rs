//! Audio analysis: finds sounds of a video that may become sound effects, and passages of music.
//!
//! The sound is divided into frames (`spectrum`). A sudden rise of the spectrum and of the loudness is an
//! impact. A swell or a sweep in pitch is a whoosh. Tones that last for seconds, or a beat, are music. Voices
//! are ignored, because subtitles have the dialogue. All results are suggestions, so a missed sound is better
//! than an invented one.

mod spectrum;
mod words;

use crate::order::sort_by;
use serde::Serialize;
use spectrum::{Frame, Frames, STEP};
use std::ops::Range;

/// Supported sample rates, in samples per second.
const RATES: std::ops::RangeInclusive<f32> = 4000.0..=192_000.0;
/// Minimum loudness of a sound, in dB relative to full scale.
const FAINT: f32 = -42.0;
/// A start has the highest flux within this number of frames on either side.
const APART: usize = 3;
/// Number of frames before a start for the mean flux that it must exceed (Dixon 2006, section 2.6).
const BEFORE: usize = 3 * APART;
/// Minimum flux above that mean.
const ABOVE: f32 = 0.02;
/// Minimum rise in level after a start, in dB.
const RISE: f32 = 9.0;
/// Decrease in level at which a sound ends, in dB.
const FALL: f32 = 20.0;
/// Maximum length of a sound in frames.
const LONGEST: usize = 300;
/// Minimum number of frames of a sound with a gradual beginning.
const SWELL: usize = 15;
/// Minimum number of frames before the maximum of a sound with a gradual beginning.
const GRADUAL: usize = 9;
/// Minimum range of the centroid of a whoosh in octaves, and minimum straightness of its movement: the
/// squared correlation.
const OCTAVES: f32 = 1.0;
const STRAIGHT: f32 = 0.75;
/// Frames that a voice holds,
const HELD_FOR: usize = 9;
/// and the centroids in Hz of voices.
const VOICES: Range<f32> = 250.0..2500.0;
/// Flatness below which a frame is a tone.
const TONAL: f32 = 0.1;
/// Minimum correlation of a sustained tone with itself a tenth of a second before.
const HELD: f32 = 0.7;
/// Number of frames per test for music, and interval of the tests.
const PART: usize = 100;
const NEXT: usize = 25;
/// Share of tones that hold in music, and in music with a beat.
const MUSIC: f32 = 0.6;
const BEATEN: f32 = 0.35;
/// Minimum correlation of the flux with itself one beat before.
const BEAT: f32 = 0.4;
/// Frames per beat: 60 to 200 beats per minute.
const BEATS: Range<usize> = 30..100;
/// Seconds of music that are worth a sign.
const LASTING: f32 = 2.0;
/// Minimum level of an impact over music or speech, in dB.
const OVER: f32 = 10.0;
/// Interval of the tests for voices, in frames.
const ASKED: usize = 3;
/// and maximum decrease per frame in dB.
const HELD_BY: f32 = 1.5;
/// Seconds before and after a sound that are tested for speech. Speech is assumed if voices take a minimum
/// share of them.
const ABOUT: f64 = 1.5;
const VOICED: f64 = 0.07;
const ITSELF: f64 = 0.05;

/// Kind of a sound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SoundKind"))]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// It has a sudden beginning.
    Hit,
    /// It swells, or its pitch wanders.
    Sweep,
    /// Tones that hold, or a beat.
    Music,
}

/// Names of sound effects. Each language has its own spelling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SoundWord"))]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs, reason = "each says what it is")]
pub enum Word {
    Bang,
    Boom,
    Clang,
    Clap,
    Click,
    Clink,
    Crack,
    Crash,
    Ding,
    Knock,
    Note,
    Notes,
    Rumble,
    Slam,
    Snap,
    Swish,
    Tap,
    Thud,
    Thump,
    Tick,
    Tune,
    Vroom,
    Whoosh,
    Zip,
    Zoom,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Hit => "hit",
            Self::Sweep => "sweep",
            Self::Music => "music",
        }
    }
}

impl Word {
    fn name(self) -> &'static str {
        match self {
            Self::Bang => "bang",
            Self::Boom => "boom",
            Self::Clang => "clang",
            Self::Clap => "clap",
            Self::Click => "click",
            Self::Clink => "clink",
            Self::Crack => "crack",
            Self::Crash => "crash",
            Self::Ding => "ding",
            Self::Knock => "knock",
            Self::Note => "note",
            Self::Notes => "notes",
            Self::Rumble => "rumble",
            Self::Slam => "slam",
            Self::Snap => "snap",
            Self::Swish => "swish",
            Self::Tap => "tap",
            Self::Thud => "thud",
            Self::Thump => "thump",
            Self::Tick => "tick",
            Self::Tune => "tune",
            Self::Vroom => "vroom",
            Self::Whoosh => "whoosh",
            Self::Zip => "zip",
            Self::Zoom => "zoom",
        }
    }
}

/// A sound of a video.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SoundEvent"))]
pub struct Event {
    /// Seconds at which it begins
    pub start: f64,
    /// and ends.
    pub end: f64,
    /// Kind of the sound.
    pub kind: Kind,
    /// Level in whole dB below full scale, -42 to about 0: of the loudest frame, or the mean for music.
    pub loudness: i32,
    /// Suggested sound effects, the best first.
    pub words: [Word; 3],
}

/// Finds the sounds in `samples`, mono with full scale 1, at `rate` samples per second, in order of time. NaN
/// and infinite samples count as silence. Returns no sounds if the rate is outside 4 to 192 kHz or the input
/// is shorter than a frame.
#[must_use]
pub fn events(mut samples: Vec<f32>, rate: f32) -> Vec<Event> {
    if !RATES.contains(&rate) {
        return Vec::new();
    }
    for sample in &mut samples {
        *sample = if sample.is_finite() { sample.clamp(-4.0, 4.0) } else { 0.0 };
    }
    let frames = Frames::of(&samples, rate);
    let hearing =
        Hearing { samples: &samples, rate, frames: &frames.all, size: frames.size, step: frames.step };
    let (music, voices) = (hearing.music(), hearing.voices());
    let mut all: Vec<Event> = hearing
        .sounds()
        .into_iter()
        .filter(|sound| {
            let during = |piece: &&Event| piece.start - 0.2 <= sound.start && sound.start <= piece.end;
            music
                .iter()
                .find(during)
                .is_none_or(|piece| sound.loudness as f32 >= piece.loudness as f32 + OVER)
        })
        .filter(|sound| {
            speech_about(sound, &voices).is_none_or(|level| sound.loudness as f32 >= level + OVER)
        })
        .chain(music.iter().cloned())
        .collect();
    sort_by(&mut all, |a, b| a.start.total_cmp(&b.start));
    all
}

/// The sounds as JSON, equal to the output of serde. A general number formatter would increase the size of
/// the `films` module by half.
#[must_use]
pub fn to_json(events: &[Event]) -> String {
    let time = |seconds: f64| {
        let milliseconds = (seconds * 1000.0).round() as u64;
        format!("{}.{:03}", milliseconds / 1000, milliseconds % 1000)
    };
    let mut parts = Vec::with_capacity(events.len());
    for Event { start, end, kind, loudness, words } in events {
        let [first, second, third] = words.map(Word::name);
        parts.push(format!(
            r#"{{"start":{},"end":{},"kind":"{}","loudness":{loudness},"words":["{first}","{second}","{third}"]}}"#,
            time(*start),
            time(*end),
            kind.name(),
        ));
    }
    format!("[{}]", parts.join(","))
}

struct Hearing<'a> {
    samples: &'a [f32],
    rate: f32,
    frames: &'a [Frame],
    size: usize,
    step: usize,
}

impl Hearing<'_> {
    fn sounds(&self) -> Vec<Event> {
        let onsets = self.onsets();
        let mut spans: Vec<Range<usize>> = Vec::new();
        for (i, &onset) in onsets.iter().enumerate() {
            spans.push(self.span(onset, onsets.get(i + 1).copied()));
        }
        let swells = self.swells(&spans);
        let mut events: Vec<Event> = spans.into_iter().filter_map(|span| self.event(span, true)).collect();
        events.extend(swells.into_iter().filter_map(|span| self.event(span, false)));
        events
    }

    /// Returns the frames at which a sound begins suddenly.
    fn onsets(&self) -> Vec<usize> {
        let frames = self.frames;
        let mut found: Vec<usize> = Vec::new();
        for (i, frame) in frames.iter().enumerate().skip(1) {
            let about = &frames[i.saturating_sub(APART)..(i + APART + 1).min(frames.len())];
            let longer = &frames[i.saturating_sub(BEFORE)..(i + APART + 1).min(frames.len())];
            let mean = longer.iter().map(|frame| frame.flux).sum::<f32>() / longer.len() as f32;
            let highest = about.iter().all(|other| other.flux <= frame.flux);
            if !highest || frame.flux < mean + ABOVE || self.peak(i) < FAINT || self.rise(i) < RISE {
                continue;
            }
            // The first of equal neighbours wins.
            if found.last().is_none_or(|&last| i - last > 2 * APART) {
                found.push(i);
            }
        }
        found
    }

    /// The loudest level of the frames that follow.
    fn peak(&self, i: usize) -> f32 {
        let end = (i + APART + 2).min(self.frames.len());
        self.frames[i..end].iter().map(|frame| frame.level).fold(f32::NEG_INFINITY, f32::max)
    }

    /// How many dB louder these are than those before.
    fn rise(&self, i: usize) -> f32 {
        let before = &self.frames[i.saturating_sub(4 * APART)..i.saturating_sub(APART).max(1)];
        self.peak(i) - before.iter().map(|frame| frame.level).sum::<f32>() / before.len() as f32
    }

    /// The frames of a sound that begins at `onset`, at the latest up to `next`.
    fn span(&self, onset: usize, next: Option<usize>) -> Range<usize> {
        // The next sound begins in the frames before its onset.
        let next = next.map_or(usize::MAX, |next| next - APART);
        let most = (onset + LONGEST).min(next).min(self.frames.len());
        let mut peak = self.peak(onset);
        let mut end = onset + 1;
        while end < most {
            let level = self.frames[end].level;
            peak = peak.max(level);
            // The level rises while the sound comes into the frames.
            if end > onset + APART && level < (peak - FALL).max(FAINT - 3.0) {
                break;
            }
            end += 1;
        }
        onset..end
    }

    /// Frames that are louder than their surroundings and have no sudden start.
    fn swells(&self, spans: &[Range<usize>]) -> Vec<Range<usize>> {
        let usual = self.usual();
        let heard = |frame: &Frame| frame.level > FAINT.max((usual + 8.0).min(FAINT + 24.0));
        let mut found = Vec::new();
        let mut start = 0;
        while start < self.frames.len() {
            let length = self.frames[start..].iter().take_while(|frame| heard(frame)).count();
            let span = start..start + length;
            let free = spans.iter().all(|other| other.end <= span.start || span.end <= other.start);
            if (SWELL..=LONGEST).contains(&length) && start > 0 && free {
                found.push(span);
            }
            start += length.max(1);
        }
        found
    }

    /// The median of the levels, to the decibel.
    fn usual(&self) -> f32 {
        let mut counts = [0usize; 128];
        for frame in self.frames {
            counts[(-frame.level).clamp(0.0, 127.0) as usize] += 1;
        }
        let mut louder = 0;
        let half = |count: &usize| {
            louder += count;
            2 * louder > self.frames.len()
        };
        -(counts.iter().position(half).unwrap_or_default() as f32)
    }

    /// The sound of these frames, if it is not a voice.
    fn event(&self, span: Range<usize>, sudden: bool) -> Option<Event> {
        let frames = &self.frames[span.clone()];
        let peak = frames.iter().map(|frame| frame.level).fold(f32::NEG_INFINITY, f32::max);
        let loud: Vec<&Frame> = frames.iter().filter(|frame| frame.level >= peak - FALL).collect();
        let count = loud.len().max(1) as f32;
        let centroid = loud.iter().map(|frame| frame.centroid).sum::<f32>() / count;
        let tonal = loud.iter().map(|frame| frame.flatness).sum::<f32>() / count < TONAL;
        let attack = frames.iter().position(|frame| frame.level >= peak - 3.0).unwrap_or_default();
        let octaves = if loud.len() >= SWELL { wandering(&loud) } else { 0.0 };
        // Crashes fall in pitch while they fade; falling tones are sweeps.
        let moves = octaves >= OCTAVES || octaves <= -OCTAVES && tonal;
        let kind = if moves || attack >= GRADUAL { Kind::Sweep } else { Kind::Hit };
        let end = self.seconds(span.end);
        let start =
            if sudden && kind == Kind::Hit { self.beginning(span.start) } else { self.seconds(span.start) };
        let length = (end - start).max(0.01);
        // Impacts fade from their loudest frame on, voices last.
        let holds = frames.get(attack + HELD_FOR).is_some_and(|frame| frame.level >= peak - 6.0);
        let voice = !moves && holds && VOICES.contains(&centroid) && self.is_pitched(span.start + attack);
        if voice || kind == Kind::Hit && !sudden {
            return None;
        }
        let words = words::words(kind, peak, length as f32, centroid);
        Some(Event {
            start: rounded(start),
            end: rounded(start + length),
            kind,
            loudness: peak.round() as i32,
            words,
        })
    }

    /// Seconds of the middle of a frame.
    fn seconds(&self, frame: usize) -> f64 {
        ((frame * self.step + self.size / 2) as f64 / f64::from(self.rate)).min(self.length())
    }

    fn length(&self) -> f64 {
        self.samples.len() as f64 / f64::from(self.rate)
    }

    /// Seconds at which the sound of a frame begins: in blocks of two milliseconds.
    fn beginning(&self, frame: usize) -> f64 {
        let block = ((self.rate * 0.002) as usize).max(1);
        let middle = frame * self.step + self.size / 2;
        let around = (self.rate * 0.03) as usize;
        let first = middle.saturating_sub(around);
        let part = &self.samples[first..(middle + around).min(self.samples.len())];
        let powers: Vec<f32> = part.chunks(block).map(|block| block.iter().map(|x| x * x).sum()).collect();
        let most = powers.iter().copied().fold(0.0, f32::max);
        let at = powers.iter().position(|&power| power >= 0.1 * most).unwrap_or_default();
        (first + at * block) as f64 / f64::from(self.rate)
    }

    /// Whether the samples from a frame on are periodic like a voice, 80 to 400 times per second: by their
    /// normalised autocorrelation (L. Rabiner, *On the use of autocorrelation analysis for pitch detection*,
    /// 1977).
    fn is_pitched(&self, frame: usize) -> bool {
        let lags = (self.rate / 400.0) as usize..(self.rate / 80.0) as usize;
        let from = frame * self.step + self.size / 2;
        let length = (self.rate * 0.03) as usize;
        let Some(part) = self.samples.get(from..from + length + lags.end) else { return false };
        let now = &part[..length];
        let power = |x: &[f32]| x.iter().map(|x| x * x).sum::<f32>();
        let own = power(now);
        let alike = |lag: usize| {
            let then = &part[lag..lag + length];
            let product: f32 = now.iter().zip(then).map(|(a, b)| a * b).sum();
            product / (own * power(then)).sqrt().max(1e-9)
        };
        lags.map(alike).fold(0.0, f32::max) > 0.75
    }

    /// Times of voices in seconds, and their levels.
    fn voices(&self) -> Vec<(f64, f32)> {
        let asked = (0..self.frames.len()).step_by(ASKED);
        // Impacts may have a tone, but fade; voices last.
        let holds = |i: usize| {
            let [now, next] =
                [i, i + ASKED].map(|i| self.frames.get(i).map_or(f32::NEG_INFINITY, |frame| frame.level));
            now > FAINT && next > now - HELD_BY
        };
        let voiced =
            asked.filter(|&i| holds(i) && VOICES.contains(&self.frames[i].centroid) && self.is_pitched(i));
        voiced.map(|i| (self.seconds(i), self.frames[i].level)).collect()
    }

    /// Passages of music.
    fn music(&self) -> Vec<Event> {
        let frames = self.frames;
        let holds = |frame: &&Frame| frame.flatness < TONAL && frame.steadiness > HELD && frame.level > FAINT;
        let mut runs: Vec<Range<usize>> = Vec::new();
        for start in (0..(frames.len() + 1).saturating_sub(PART)).step_by(NEXT) {
            let part = start..start + PART;
            let share = frames[part.clone()].iter().filter(holds).count() as f32 / PART as f32;
            if share < MUSIC && (share < BEATEN || self.beat(&part) < BEAT) {
                continue;
            }
            match runs.last_mut() {
                Some(run) if part.start <= run.end => run.end = part.end,
                _ => runs.push(part),
            }
        }
        let lasting = runs.into_iter().filter(|run| run.len() as f32 * STEP >= LASTING);
        lasting
            .map(|run| {
                let level =
                    frames[run.clone()].iter().map(|frame| frame.level).sum::<f32>() / run.len() as f32;
                let (start, end) = (self.seconds(run.start), self.seconds(run.end));
                let words = words::words(Kind::Music, level, (end - start) as f32, 0.0);
                let loudness = level.round() as i32;
                Event { start: rounded(start), end: rounded(end), kind: Kind::Music, loudness, words }
            })
            .collect()
    }

    /// How strong a beat is about these frames, -1 to 1: the highest autocorrelation of the flux.
    fn beat(&self, part: &Range<usize>) -> f32 {
        let about = part.start.saturating_sub(PART)..(part.end + PART).min(self.frames.len());
        let flux: Vec<f32> = self.frames[about].iter().map(|frame| frame.flux).collect();
        let mean = flux.iter().sum::<f32>() / flux.len() as f32;
        let power: f32 = flux.iter().map(|x| (x - mean) * (x - mean)).sum();
        let alike = |lag: usize| {
            let pairs = flux.iter().zip(flux.get(lag..).unwrap_or_default());
            pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f32>() / power.max(1e-9)
        };
        BEATS.map(alike).fold(-1.0, f32::max)
    }
}

/// Mean level of voices around a sound in dB, if there is speech. Syllables begin as suddenly as impacts, and
/// many have no tone, but they occur between syllables with a tone.
fn speech_about(sound: &Event, voices: &[(f64, f32)]) -> Option<f32> {
    let within = |time: f64, by: f64| (sound.start - by..sound.end + by).contains(&time);
    let about: Vec<f32> = voices
        .iter()
        .filter(|(time, _)| within(*time, ABOUT) && !within(*time, ITSELF))
        .map(|(_, level)| *level)
        .collect();
    let seconds = about.len() as f64 * f64::from(STEP) * ASKED as f64;
    (seconds >= VOICED * 2.0 * ABOUT).then(|| about.iter().sum::<f32>() / about.len() as f32)
}

/// Change of the centroid in octaves, if it is monotonic; otherwise 0.
fn wandering(frames: &[&Frame]) -> f32 {
    let count = frames.len() as f32;
    let pitch = |frame: &Frame| frame.centroid.max(20.0).ln() / std::f32::consts::LN_2;
    let middle = (count - 1.0) / 2.0;
    let mean = frames.iter().map(|frame| pitch(frame)).sum::<f32>() / count;
    let [mut across, mut times, mut pitches] = [0f32; 3];
    for (i, frame) in frames.iter().enumerate() {
        let (x, y) = (i as f32 - middle, pitch(frame) - mean);
        across += x * y;
        times += x * x;
        pitches += y * y;
    }
    let straight = across * across / (times * pitches).max(1e-9);
    if straight < STRAIGHT { 0.0 } else { across / times * (count - 1.0) }
}

/// To the millisecond.
fn rounded(seconds: f64) -> f64 {
    (seconds * 1000.0).round() / 1000.0
}

#[cfg(test)]
pub(crate) mod tests;
