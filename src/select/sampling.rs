//! When to look at a video.

/// `count` moments, in seconds, in the middles of equal parts of a video of `duration` seconds. None where the
/// duration is not a positive number, as that of a stream is not.
#[must_use]
pub fn uniform(duration: f64, count: usize) -> Vec<f64> {
    if !duration.is_finite() || duration <= 0.0 {
        return Vec::new();
    }
    (0..count).map(|i| (i as f64 + 0.5) / count as f64 * duration).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_in_the_middles() {
        assert_eq!(uniform(16.0, 4), [2.0, 6.0, 10.0, 14.0]);
        assert_eq!(uniform(3.0, 1), [1.5]);
        assert!(uniform(16.0, 0).is_empty());
    }

    #[test]
    fn a_stream_has_none() {
        for duration in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(uniform(duration, 4).is_empty());
        }
    }
}
