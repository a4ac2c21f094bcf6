//! Frames as hours, minutes, seconds and frames, none dropped.

/// The hour at which a programme begins, as everywhere: what comes before it has room there.
pub const PROGRAMME: u64 = 3_600;
/// What no film reaches, in seconds.
const LONGEST: f64 = 1e9;

/// The frame that is nearest to a time.
#[must_use]
pub fn frame_at(seconds: f64, rate: u32) -> u64 {
    // Nothing is no time.
    let seconds = if seconds.is_finite() { seconds.clamp(0.0, LONGEST) } else { 0.0 };
    (seconds * f64::from(rate)).round() as u64
}

/// `hh:mm:ss:ff`. A day begins anew after 24 hours.
#[must_use]
pub fn timecode(frame: u64, rate: u32) -> String {
    let rate = u64::from(rate.max(1));
    let (seconds, frames) = (frame / rate, frame % rate);
    let (hours, minutes) = (seconds / 3600 % 24, seconds / 60 % 60);
    format!("{hours:02}:{minutes:02}:{:02}:{frames:02}", seconds % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_code_counts_every_frame() {
        assert_eq!(timecode(24 * 3661 + 23, 24), "01:01:01:23");
        assert_eq!(timecode(30 * 86_400, 30), "00:00:00:00");
        assert_eq!([frame_at(1.02, 25), frame_at(-3.0, 25), frame_at(f64::NAN, 25)], [26, 0, 0]);
        assert_eq!(frame_at(41.708_333, 24), 1001);
    }
}
