//! Timecode: frames as hours, minutes, seconds and frames. It counts 24, 25 or 30 frames per second, or the
//! NTSC rates, which are slower by a thousandth. Non-drop-frame timecode at NTSC rates is 3.6 seconds per
//! hour slower than the clock. Drop-frame timecode at 29.97 skips two frame numbers at each minute except
//! every tenth.
//!
//! Source: SMPTE ST 12-1, "Time and Control Code", 5.2.

use serde::{Deserialize, Serialize};

/// The programme starts at one hour, by convention, which leaves time for leaders. In seconds of the time
/// code.
pub const PROGRAMME: u64 = 3_600;
/// Upper limit of times, in seconds.
const LONGEST: f64 = 1e9;
/// Skipped frame numbers per minute, at 30 frames per second, and the interval in minutes without skipping.
const DROPPED: u64 = 2;
const WHOLE: u64 = 10;
/// Maximum frame rate of a timecode, in frames per counted second.
const MAX_FPS: u32 = 120;

/// How fast a counted second passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Pace {
    /// As the clock's.
    #[default]
    Clock,
    /// NTSC: slower by a thousandth, 23.976 instead of 24 frames, 29.97 instead of 30.
    Ntsc,
    /// Drop-frame timecode at 29.97: skipped frame numbers keep the timecode close to the clock.
    Drop,
}

impl Pace {
    /// Whether this pace supports the frame rate.
    #[must_use]
    pub fn fits(self, fps: u32) -> bool {
        match self {
            Self::Clock => true,
            Self::Ntsc => matches!(fps, 24 | 30),
            Self::Drop => fps == 30,
        }
    }
}

/// How frames are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rate {
    /// Frames per counted second, such as 24 for 23.976 or 30 for 29.97.
    pub base: u32,
    /// Timecode pace.
    pub pace: Pace,
}

impl Rate {
    /// Frames of a second of the clock.
    #[must_use]
    pub fn exact(self) -> f64 {
        let slower = if self.pace == Pace::Clock { 1.0 } else { 1000.0 / 1001.0 };
        f64::from(self.base) * slower
    }

    /// Whether the timecode is drop-frame.
    #[must_use]
    pub fn drops(self) -> bool {
        self.pace == Pace::Drop
    }

    /// The frame that is nearest to a time in seconds.
    #[must_use]
    pub fn frame_at(self, seconds: f64) -> u64 {
        self.frames_in(seconds).round() as u64
    }

    fn frames_in(self, seconds: f64) -> f64 {
        // NaN counts as 0.
        let seconds = if seconds.is_finite() { seconds.clamp(0.0, LONGEST) } else { 0.0 };
        seconds * self.exact()
    }

    /// Returns the number of whole frames in a time in seconds. The last frame counts even if a share of up
    /// to `missing` of it is missing.
    #[must_use]
    pub fn whole_frames(self, seconds: f64, missing: f64) -> u64 {
        (self.frames_in(seconds) + missing) as u64
    }

    /// The frame at which a programme begins: the one whose time code is one hour.
    #[must_use]
    pub fn programme(self) -> u64 {
        self.frame_of(PROGRAMME, 0)
    }

    /// The frame with a time code of these seconds and frames.
    fn frame_of(self, seconds: u64, frames: u64) -> u64 {
        let minutes = seconds / 60;
        let left_out = if self.drops() { self.dropped() * (minutes - minutes / WHOLE) } else { 0 };
        (seconds * u64::from(self.base) + frames).saturating_sub(left_out)
    }

    /// Frame numbers that are left out in a minute: two of thirty.
    fn dropped(self) -> u64 {
        DROPPED * u64::from(self.base / 30)
    }

    /// `hh:mm:ss:ff`, or `hh:mm:ss;ff` for drop-frame timecode. It wraps after 24 hours.
    #[must_use]
    pub fn timecode(self, frame: u64) -> String {
        let base = u64::from(self.base.max(1));
        let (number, mark) = if self.drops() { (self.numbered(frame), ';') } else { (frame, ':') };
        let (seconds, frames) = (number / base, number % base);
        let (hours, minutes) = (seconds / 3600 % 24, seconds / 60 % 60);
        format!("{hours:02}:{minutes:02}:{:02}{mark}{frames:02}", seconds % 60)
    }

    /// The number of a frame, with those before it that are left out.
    fn numbered(self, frame: u64) -> u64 {
        let dropped = self.dropped();
        let minute = u64::from(self.base) * 60 - dropped;
        let ten = u64::from(self.base) * 60 * WHOLE - dropped * (WHOLE - 1);
        let (tens, rest) = (frame / ten, frame % ten);
        // The first minute of ten is complete. The others skip their first frame numbers.
        let minutes = rest.saturating_sub(dropped) / minute;
        frame + dropped * ((WHOLE - 1) * tens + minutes)
    }
}

/// The timecode of the first frame of a video, as its camera recorded it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct StartTimecode {
    /// Frames since midnight.
    pub frame: u32,
    /// Frames per counted second: 30 at 29.97 frames per second.
    pub fps: u32,
    /// Whether it is drop-frame timecode.
    #[serde(default)]
    pub drop: bool,
}

impl StartTimecode {
    /// Reads `hh:mm:ss:ff`, or `hh:mm:ss;ff` for drop-frame timecode; `None` if it is not valid at this rate.
    #[must_use]
    pub fn parse(text: &str, fps: u32) -> Option<Self> {
        let numbers: Vec<u64> =
            text.split([':', ';', '.']).map(|part| part.parse().ok()).collect::<Option<_>>()?;
        let &[hours, minutes, seconds, frames] = numbers.as_slice() else { return None };
        let drop = text.contains([';', '.']);
        if hours > 23 || minutes > 59 || seconds > 59 || frames >= u64::from(fps) {
            return None;
        }
        let counting = Self { frame: 0, fps, drop }.counting();
        let frame = counting.frame_of((hours * 60 + minutes) * 60 + seconds, frames);
        Some(Self { frame: u32::try_from(frame).ok()?, fps, drop }).filter(|start| start.is_valid())
    }

    /// Whether the rate is supported and the time is within a day.
    #[must_use]
    pub fn is_valid(self) -> bool {
        (1..=MAX_FPS).contains(&self.fps)
            && (!self.drop || self.fps.is_multiple_of(30))
            && u64::from(self.frame) < self.counting().frame_of(24 * 3600, 0)
    }

    /// Returns the timecode at a time in seconds, at this number of frames per second of the clock.
    #[must_use]
    pub fn at(self, seconds: f64, frames_per_second: f64) -> String {
        let frames = (seconds * frames_per_second).round().max(0.0) as u64;
        self.counting().timecode(u64::from(self.frame) + frames)
    }

    /// How its frames are counted.
    fn counting(self) -> Rate {
        Rate { base: self.fps, pace: if self.drop { Pace::Drop } else { Pace::Clock } }
    }

    /// How frames of the video are counted in a list of this rate. Frames at 29.97 are counted as the camera did.
    #[must_use]
    pub fn counting_at(self, rate: Rate) -> Rate {
        match (rate.base, rate.pace) {
            (30, Pace::Ntsc | Pace::Drop) if self.drop => Rate { pace: Pace::Drop, ..rate },
            (30, Pace::Ntsc | Pace::Drop) => Rate { pace: Pace::Ntsc, ..rate },
            _ => rate,
        }
    }

    /// Returns its frame since midnight in a counting. In one with another number of frames per second, hours, minutes and
    /// seconds stay the same.
    #[must_use]
    pub fn frame_in(self, counting: Rate) -> u64 {
        let own = self.counting();
        let number = if self.drop { own.numbered(self.frame.into()) } else { self.frame.into() };
        let fps = u64::from(self.fps.max(1));
        counting.frame_of(number / fps, number % fps * u64::from(counting.base) / fps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn rate(base: u32, pace: Pace) -> Rate {
        Rate { base, pace }
    }

    #[test]
    fn a_time_code_counts_every_frame() {
        let of = |base| rate(base, Pace::Clock);
        assert_eq!(of(24).timecode(24 * 3661 + 23), "01:01:01:23");
        assert_eq!(of(30).timecode(30 * 86_400), "00:00:00:00");
        let at = |seconds| of(25).frame_at(seconds);
        assert_eq!([at(1.02), at(-3.0), at(f64::NAN)], [26, 0, 0]);
        assert_eq!(of(24).frame_at(41.708_333), 1001);
        // Slower, and counted as if it were not.
        let film = rate(24, Pace::Ntsc);
        assert_eq!((film.timecode(86_400), film.frame_at(3_603.6)), ("01:00:00:00".into(), 86_400));
    }

    #[test]
    fn numbers_of_frames_are_left_out_each_minute_but_every_tenth() {
        let drop = rate(30, Pace::Drop);
        for (frame, code) in [
            (0, "00:00:00;00"),
            (1_799, "00:00:59;29"),
            (1_800, "00:01:00;02"),
            (3_597, "00:01:59;29"),
            (3_598, "00:02:00;02"),
            (17_981, "00:09:59;29"),
            (17_982, "00:10:00;00"),
            (19_782, "00:11:00;02"),
            (107_892, "01:00:00;00"),
            (2_589_408, "00:00:00;00"),
        ] {
            assert_eq!(drop.timecode(frame), code, "{frame}");
        }
        assert_eq!(drop.programme(), 107_892);
        // An hour of the clock is an hour of the time code, to the frame.
        assert_eq!(drop.timecode(drop.frame_at(3_600.0)), "01:00:00;00");
        assert_eq!(rate(30, Pace::Ntsc).programme(), 108_000);
    }

    #[test]
    fn a_start_timecode_is_read_and_counted_at_the_rate_of_the_list() {
        let start = |text, fps| StartTimecode::parse(text, fps);
        let camera = start("10:00:00;00", 30).unwrap();
        assert_eq!(camera, StartTimecode { frame: 1_078_920, fps: 30, drop: true });
        assert_eq!(start("10:00:00:00", 25), Some(StartTimecode { frame: 900_000, fps: 25, drop: false }));
        assert_eq!(start("01:00:00;00", 60).unwrap().frame, 215_784);
        for (text, fps) in [
            ("24:00:00:00", 25),
            ("10:60:00:00", 25),
            ("10:00:60:00", 25),
            ("10:00:00:25", 25),
            ("10:00:00;00", 25),
            ("10:00:00", 25),
            ("-1:00:00:00", 25),
            ("", 25),
            ("00:00:00:00", 0),
            ("00:00:00:00", 121),
        ] {
            assert_eq!(start(text, fps), None, "{text} at {fps}");
        }
        assert!(StartTimecode { frame: 2_589_407, fps: 30, drop: true }.is_valid());
        assert!(!StartTimecode { frame: 2_589_408, fps: 30, drop: true }.is_valid());
        assert_eq!(camera.at(60.06, 30_000.0 / 1_001.0), "10:01:00;02");
        let code = |start: Option<StartTimecode>, rate: Rate| {
            let start = start.unwrap();
            let counting = start.counting_at(rate);
            counting.timecode(start.frame_in(counting))
        };
        for (pace, base, text, fps, expected) in [
            (Pace::Drop, 30, "10:01:00;02", 30, "10:01:00;02"),
            // The list is counted in another way than the video.
            (Pace::Ntsc, 30, "10:01:00;02", 30, "10:01:00;02"),
            (Pace::Drop, 30, "10:01:00:00", 30, "10:01:00:00"),
            // Another number of frames per second.
            (Pace::Clock, 25, "10:01:00;02", 30, "10:01:00:01"),
            (Pace::Clock, 24, "23:59:59:24", 25, "23:59:59:23"),
            (Pace::Clock, 25, "01:02:03:48", 50, "01:02:03:24"),
            (Pace::Ntsc, 24, "01:02:03:04", 24, "01:02:03:04"),
        ] {
            assert_eq!(code(start(text, fps), rate(base, pace)), expected, "{text} at {fps} in {base}");
        }
    }

    #[test]
    fn every_time_code_of_an_hour_is_told_once() {
        let drop = rate(30, Pace::Drop);
        let read = |code: &str| {
            let parts: Vec<u64> = code.split([':', ';']).map(|part| part.parse().unwrap()).collect();
            let minutes = 60 * parts[0] + parts[1];
            (minutes * 60 + parts[2]) * 30 + parts[3] - 2 * (minutes - minutes / 10)
        };
        assert!((0..110_000).all(|frame| read(&drop.timecode(frame)) == frame));
    }
}
