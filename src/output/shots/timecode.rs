//! Frames as hours, minutes, seconds and frames, counted as cutting rooms count them: at 24, 25 or 30 frames a second, or at the
//! rates of North American television, which are slower by a thousandth. At these no frame of a number is dropped, so that a
//! time code falls behind the clock by 3.6 seconds an hour, or, at 29.97, the numbers of two frames are left out at the beginning of
//! each minute but every tenth.
//!
//! Source: SMPTE ST 12-1, "Time and Control Code", 5.2.

use serde::{Deserialize, Serialize};

/// The hour at which a programme begins, as everywhere: what comes before it has room there. In seconds of the time code.
pub const PROGRAMME: u64 = 3_600;
/// What no film reaches, in seconds.
const LONGEST: f64 = 1e9;
/// Frame numbers that are left out in a minute, and minutes from one that leaves none out to the next.
const DROPPED: u64 = 2;
const WHOLE: u64 = 10;

/// How fast a counted second passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(all(test, feature = "cli"), derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Pace {
    /// As the clock's.
    #[default]
    Clock,
    /// Slower by a thousandth: 23.976 frames in the place of 24, 29.97 in that of 30.
    Ntsc,
    /// The same at 30, with frame numbers left out, so that the time code keeps up with the clock.
    Drop,
}

impl Pace {
    /// Whether frames may be counted in this way at so many a second.
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
    /// Frames of a counted second; 24, 30 where the clock's are 23.976, 29.97.
    pub base: u32,
    /// How fast such a second passes.
    pub pace: Pace,
}

impl Rate {
    /// Frames of a second of the clock.
    #[must_use]
    pub fn exact(self) -> f64 {
        let slower = if self.pace == Pace::Clock { 1.0 } else { 1000.0 / 1001.0 };
        f64::from(self.base) * slower
    }

    /// Whether frame numbers are left out.
    #[must_use]
    pub fn drops(self) -> bool {
        self.pace == Pace::Drop
    }

    /// The frame that is nearest to a time in seconds.
    #[must_use]
    pub fn frame_at(self, seconds: f64) -> u64 {
        // Nothing is no time.
        let seconds = if seconds.is_finite() { seconds.clamp(0.0, LONGEST) } else { 0.0 };
        (seconds * self.exact()).round() as u64
    }

    /// The frame at which a programme begins: the one whose time code is one hour.
    #[must_use]
    pub fn programme(self) -> u64 {
        let minutes = PROGRAMME / 60;
        let left_out = if self.drops() { DROPPED * (minutes - minutes / WHOLE) } else { 0 };
        PROGRAMME * u64::from(self.base) - left_out
    }

    /// `hh:mm:ss:ff`, or `hh:mm:ss;ff` where frame numbers are left out. A day begins anew after 24 hours.
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
        let minute = u64::from(self.base) * 60 - DROPPED;
        let ten = u64::from(self.base) * 60 * WHOLE - DROPPED * (WHOLE - 1);
        let (tens, rest) = (frame / ten, frame % ten);
        // The first minute of ten is whole; each other is shorter, and its first numbers are left out.
        let minutes = rest.saturating_sub(DROPPED) / minute;
        frame + DROPPED * ((WHOLE - 1) * tens + minutes)
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
