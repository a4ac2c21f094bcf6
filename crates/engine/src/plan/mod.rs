//! Plan: which layout, which photo in which panel, and how good the page is.
//!
//! | module | for |
//! |---|---|
//! | [`mod@slots`] | the panels of a page as slots for photos |
//! | [`prepared`] | analysis of one photo, cached for all plans |
//! | [`utility`] | fit of a photo in a panel |
//! | [`mod@assign`] | photos to panels, by exact assignment |
//! | [`layouts`] | the layouts that a page is chosen from |
//! | [`composer`] | creates plans, scores their visible content, and selects one by rank |
//! | [`turns`] | photos that wait for a panel |
//! | [`tones`] | styles that preserve the content of the photos |
//! | [`spread`] | an album cut into pages |
//! | [`moments`] | capture times as days and seconds |
//! | [`book`] | the pages of a book: which photos each shows |
//!
//! Nothing here depends on a document: locked slots carry the retained parts of the old page. All functions
//! are pure, and random choices depend on a seed.

pub mod assign;
pub mod book;
pub mod composer;
pub mod layouts;
pub mod moments;
pub mod prepared;
pub mod slots;
pub mod spread;
pub mod tones;
pub mod turns;
pub mod utility;

/// Indices of values, the largest first, equal ones in their order. Written out since each sort of the standard library's
/// adds kilobytes to the module of the page, and lists are short here.
fn best_first(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = Vec::with_capacity(values.len());
    for (i, value) in values.iter().enumerate() {
        let at = order.iter().rposition(|&other| values[other] >= *value).map_or(0, |last| last + 1);
        order.insert(at, i);
    }
    order
}

pub use assign::{Order, assign};
pub use composer::{Candidate, Plan, Score, compose, judge};
pub use prepared::{Prepared, Shelf};
pub use slots::{Assignment, Slot, slots};
pub use turns::Turns;
