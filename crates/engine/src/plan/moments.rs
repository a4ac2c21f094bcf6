//! Capture times as days and seconds, for pauses, chapters and captions.

/// Second of a night at which the next day begins: a party belongs to the day on which it started.
const MORNING: i64 = 4 * 3600;
/// Seconds of a day.
const DAY: i64 = 86_400;

/// A capture time by the camera's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Moment {
    /// Seconds since the start of 1970, without a time zone.
    pub seconds: i64,
}

impl Moment {
    /// Reads `YYYY:MM:DD HH:MM:SS`. Seconds may be missing. `None` for dates that do not exist, such as `0000:00:00`.
    #[must_use]
    pub fn parse(taken: &str) -> Option<Self> {
        let mut numbers = taken.split([':', ' ', '-', 'T', '.']).map(|digits| digits.parse::<i64>().ok());
        let mut next = || numbers.next().flatten();
        let (year, month, day) = (next()?, next()?, next()?);
        let (hour, minute, second) = (next()?, next()?, next().unwrap_or(0));
        let real = (1..=9999).contains(&year)
            && (1..=12).contains(&month)
            && (1..=31).contains(&day)
            && (0..24).contains(&hour)
            && (0..60).contains(&minute);
        real.then(|| Self {
            seconds: days(year, month, day) * DAY + hour * 3600 + minute * 60 + second.clamp(0, 60),
        })
    }

    /// Number of the day since 1970. The hours before four in the morning belong to the day before.
    #[must_use]
    pub fn day(self) -> i64 {
        (self.seconds - MORNING).div_euclid(DAY)
    }

    /// Hour of the clock, 0 to 23.
    #[must_use]
    pub fn hour(self) -> i64 {
        self.seconds.rem_euclid(DAY) / 3600
    }
}

/// Days since 1970 of a date. Source: Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms", `days_from_civil`.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let of_era = year.rem_euclid(400);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

/// Returns year, month and day of a number of days since 1970. Source: as `days`, `civil_from_days`.
#[must_use]
pub fn date(day: i64) -> (i64, i64, i64) {
    let shifted = day + 719_468;
    let era = shifted.div_euclid(146_097);
    let of_era = shifted.rem_euclid(146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    (year + era * 400 + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_and_a_night_belongs_to_the_day_before() {
        let at = |taken: &str| Moment::parse(taken).unwrap();
        assert_eq!(at("1970:01:01 00:00:00").seconds, 0);
        // Python: datetime(2024, 2, 29, 23, 59, 58, tzinfo=utc).timestamp()
        assert_eq!(at("2024:02:29 23:59:58").seconds, 1_709_251_198);
        assert_eq!(at("2024:03:01 02:30:00").day(), at("2024:02:29 12:00:00").day());
        assert_eq!(at("2024:03:01 04:00:00").day(), at("2024:02:29 12:00:00").day() + 1);
        assert_eq!(at("2024:03:01 02:30").hour(), 2);
        for bad in
            ["", "2024", "0000:00:00 00:00:00", "2024:13:01 10:00:00", "2024:01:01 24:00:00", "a:b:c d:e:f"]
        {
            assert_eq!(Moment::parse(bad), None, "{bad}");
        }
    }

    #[test]
    fn dates_come_back() {
        for day in (-200_000..200_000).step_by(97) {
            let (year, month, of_month) = date(day);
            assert_eq!(days(year, month, of_month), day);
        }
        assert_eq!(date(19_782), (2024, 2, 29));
    }
}
