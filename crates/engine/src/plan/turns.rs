//! Turns: photos that recent pages did not show come first, so that each photo appears.

use crate::framing::PhotoMeta;

/// Number of recent pages that count.
pub const PAGES: usize = 24;
/// Panels of a usual page, which is the number of photos that are due at once.
const A_PAGE: f64 = 5.0;
/// Maximum wait of a photo in pages, and the bonus per page beyond it.
const OVERDUE: usize = 6;
const EACH: f64 = 4.0;
/// Bonus per page of waiting before a photo is overdue.
const WAITING: f64 = 0.15;
/// Cost of a photo on the last page, and on the page before.
const JUST_SHOWN: [f64; 2] = [0.25, 0.1];
/// Cost of a lead of the last pages, the last page first.
const JUST_LED: [f64; 3] = [0.5, 0.3, 0.15];

/// Turns of the photos of a plan.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Turns {
    /// For each photo: pages since it was shown, or all pages if it was not.
    since: Vec<usize>,
    /// For each photo: its cost as a lead.
    led: Vec<f64>,
    /// Pages until each photo can have been shown once.
    cycle: usize,
}

impl Turns {
    /// Looks back at `recent`: the ids of the photos of each page, the lead of the page first, the last page last.
    #[must_use]
    pub fn of(photos: &[PhotoMeta], recent: &[Vec<String>]) -> Self {
        let recent = &recent[recent.len().saturating_sub(PAGES)..];
        if recent.is_empty() {
            return Self::default();
        }
        let backwards = || recent.iter().rev();
        let since =
            |photo: &PhotoMeta| backwards().position(|page| page.contains(&photo.id)).unwrap_or(recent.len());
        let led = |photo: &PhotoMeta| {
            let at = backwards().position(|page| page.first() == Some(&photo.id));
            at.and_then(|at| JUST_LED.get(at)).copied().unwrap_or(0.0)
        };
        Self {
            since: photos.iter().map(since).collect(),
            led: photos.iter().map(led).collect(),
            cycle: (photos.len() as f64 / A_PAGE).ceil() as usize,
        }
    }

    /// Returns the priority of a photo: less than 0 if it was just shown, above 1 if it is overdue.
    #[must_use]
    pub fn need(&self, photo: usize) -> f64 {
        let Some(&since) = self.since.get(photo) else { return 0.0 };
        let lately = if self.cycle > 1 { JUST_SHOWN.get(since).copied().unwrap_or(0.0) } else { 0.0 };
        let waited = WAITING * (since + 1).saturating_sub(self.cycle.max(2)) as f64;
        waited + EACH * (since + 1).saturating_sub(OVERDUE) as f64 - lately
    }

    /// Whether no page was shown before.
    #[must_use]
    pub fn is_first_page(&self) -> bool {
        self.since.is_empty()
    }

    /// Returns the cost of a photo as a lead, because it led a recent page.
    #[must_use]
    pub fn led(&self, photo: usize) -> f64 {
        self.led.get(photo).copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_waits_longest_comes_first() {
        let photos: Vec<PhotoMeta> =
            (0..20).map(|i| PhotoMeta::unmeasured(&format!("p{i}"), 300, 200)).collect();
        let page = |from: usize| (from..from + 5).map(|i| format!("p{i}")).collect::<Vec<_>>();
        let recent: Vec<Vec<String>> = [0, 0, 0, 0, 5, 0, 0, 0, 10].map(page).to_vec();
        let turns = Turns::of(&photos, &recent);
        let needs = [0, 5, 10, 19].map(|photo| turns.need(photo));
        assert!(needs[2] < needs[0] && needs[0] <= needs[1] && needs[1] < needs[3], "{needs:?}");
        assert!(needs[3] > 2.0 && turns.led(10) > turns.led(0) && turns.led(1).abs() < 1e-12);
        assert!(!turns.is_first_page());
        let first = Turns::of(&photos, &[]);
        assert!(first.need(3).abs() < 1e-12 && first.is_first_page());
    }
}
