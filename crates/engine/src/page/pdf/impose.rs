//! Imposition: the order of pages on sheets that are folded or cut.
//!
//! The orders are standard in printing. `tests/oracles/impose.py` compares them with another program.

use serde::Deserialize;

/// How pages share sheets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Imposition {
    /// Saddle-stitched booklet: two pages per side, printed on both sides, folded once.
    #[serde(rename = "booklet")]
    Booklet,
    /// Eight on one side of one sheet, which is cut once in its middle and folded.
    #[serde(rename = "zine")]
    Zine,
    /// Two pages next to each other, to be cut apart.
    #[serde(rename = "2up")]
    TwoUp,
    /// One page on the first sheet, then two pages per sheet, like an open book.
    #[serde(rename = "spreads")]
    Spreads,
}

impl Imposition {
    /// All kinds by name.
    pub const ALL: [(&'static str, Self); 4] =
        [("booklet", Self::Booklet), ("zine", Self::Zine), ("2up", Self::TwoUp), ("spreads", Self::Spreads)];
}

/// A page on a sheet: its index from 0, and whether it is upside down.
pub type Seat = (usize, bool);

/// One side of a sheet: rows of page positions, from the top left. A position beyond the last page is empty.
pub type Side = Vec<Vec<Seat>>;

/// The sides of all sheets for a number of pages, in printing order.
#[must_use]
pub fn sides(how: Option<Imposition>, pages: usize) -> Vec<Side> {
    let row = |numbers: &[usize]| vec![numbers.iter().map(|&number| (number, false)).collect()];
    match how {
        None => (0..pages).map(|page| row(&[page])).collect(),
        Some(Imposition::TwoUp) => (0..pages).step_by(2).map(|page| row(&[page, page + 1])).collect(),
        Some(Imposition::Spreads) => {
            let pairs = (1..pages)
                .step_by(2)
                .map(|page| if page + 1 < pages { row(&[page, page + 1]) } else { row(&[page]) });
            (0..pages.min(1)).map(|page| row(&[page])).chain(pairs).collect()
        }
        Some(Imposition::Booklet) => {
            let seats = pages.next_multiple_of(4);
            let side = |side: usize| {
                let other = seats - 1 - side;
                if side.is_multiple_of(2) { row(&[other, side]) } else { row(&[side, other]) }
            };
            (0..seats / 2).map(side).collect()
        }
        Some(Imposition::Zine) => (0..pages)
            .step_by(8)
            .map(|first| {
                let seats = |numbers: [usize; 4], turned| numbers.map(|n| (first + n, turned)).to_vec();
                vec![seats([4, 3, 2, 1], true), seats([5, 6, 7, 0], false)]
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_has_one_seat() {
        let all = [Imposition::Booklet, Imposition::Zine, Imposition::TwoUp, Imposition::Spreads];
        for how in [None].into_iter().chain(all.map(Some)) {
            for pages in 0..20 {
                let mut seen: Vec<usize> = sides(how, pages)
                    .iter()
                    .flatten()
                    .flatten()
                    .map(|(number, _)| *number)
                    .filter(|number| *number < pages)
                    .collect();
                seen.sort_unstable();
                assert_eq!(seen, (0..pages).collect::<Vec<_>>(), "{how:?} {pages}");
            }
        }
    }
}
