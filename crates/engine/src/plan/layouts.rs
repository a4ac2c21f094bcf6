//! The layouts that a page is chosen from: some of all that are good for it, drawn without repeats, families that make
//! good pages rather than others.

use inkpanel_model::choice::Taste;
use oorandom::Rand64;

use super::assign::gumbel;
use super::best_first;
use crate::layout::{self, Template};

/// Number of layouts in one plan.
pub const DRAWN: usize = 16;
/// Maximum number of panels of a page, unless the request has more.
pub const USUAL_MOST: usize = 9;
/// Preferred number of panels, and the factor for each panel more or fewer.
const LIKED_COUNTS: std::ops::RangeInclusive<usize> = 5..=6;
const OTHER_COUNTS: f64 = 0.4;
/// Minimum share of the page for a panel of an automatic layout.
const LEAST_SHARE: f64 = 0.07;
/// Factors by the ratio of the largest panel to the next one: at least 1.55, at least 1.3, and below.
const LEAD: [(f64, f64); 3] = [(1.55, 1.0), (1.3, 0.7), (0.0, 0.35)];
/// Factor of layouts that consist of rectangles only.
const PLAIN: f64 = 0.6;
/// Requirements for a layout of an unlocked page.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// Width over height of the page.
    pub aspect: f64,
    /// Exact number of panels. If no layout has it, the nearest number counts.
    pub panels: Option<usize>,
    /// Number of photos to show.
    pub photos: usize,
    /// Layouts that were shown just now.
    pub shown: &'a [&'a str],
    /// Families to choose from; an empty list allows all.
    pub families: &'a [String],
    /// The user's preferences.
    pub taste: &'a Taste,
}

/// A layout and its prior weight, 0 to 1.
#[derive(Debug, Clone, Copy)]
pub struct Drawn {
    /// The layout.
    pub template: &'static Template,
    /// Weight of its family.
    pub prior: f64,
}

/// Draws layouts by their weights, by the largest `ln(weight) + gumbel` (Gumbel top-k: like drawing without
/// putting back). Templates share the weight of their family. Otherwise, large families would be chosen most
/// of the time.
#[must_use]
pub fn draw(wanted: &Wanted, random: &mut Rand64) -> Vec<Drawn> {
    let within = |template: &&'static Template| is_within(wanted.families, template.family());
    let mut good = layout::good_for(wanted.aspect);
    good.retain(within);
    // Every page has at least one template. If none fits well, the whole list is the fallback.
    if good.is_empty() {
        good = layout::catalogue().iter().filter(within).collect();
    }
    let roomy: Vec<&'static Template> =
        good.iter().copied().filter(|template| is_roomy(template, wanted.aspect)).collect();
    let count = |template: &&'static Template| Some(template.panels().len()) == wanted.panels;
    if !roomy.is_empty() && (wanted.panels.is_none() || roomy.iter().any(count)) {
        good = roomy;
    }
    let mut fitting: Vec<&'static Template> = match wanted.panels {
        Some(panels) => nearest(&good, panels),
        None => usual(&good, wanted.photos),
    };
    if fitting.iter().any(|template| !wanted.shown.contains(&template.id())) {
        fitting.retain(|template| !wanted.shown.contains(&template.id()));
    }
    let drawn: Vec<(f64, Drawn)> = fitting
        .iter()
        .map(|&template| {
            let family = template.family();
            let liking = Taste::factor(&wanted.taste.families, family);
            let prior = weight(family) * liking * shape(template, wanted);
            // The factor is less than proportional, so that a family with one template is chosen less often
            // than a family with twenty.
            let share = (fitting.iter().filter(|other| other.family() == family).count() as f64).powf(0.6);
            ((prior / share).ln() + gumbel(random), Drawn { template, prior: prior.min(1.5) })
        })
        .collect();
    let ratings: Vec<f64> = drawn.iter().map(|(rating, _)| *rating).collect();
    best_first(&ratings).into_iter().take(DRAWN).map(|at| drawn[at].1).collect()
}

/// Rates the panels of a template: their number, their lead and their shapes.
fn shape(template: &Template, wanted: &Wanted) -> f64 {
    let panels = template.panels().len();
    let (least, most) = (*LIKED_COUNTS.start().min(&wanted.photos), *LIKED_COUNTS.end().min(&wanted.photos));
    let off = least.saturating_sub(panels) + panels.saturating_sub(most);
    let lead = lead(&template.shares(wanted.aspect));
    let lead = LEAD.iter().find(|(least, _)| lead >= *least).map_or(0.0, |(_, weight)| *weight);
    OTHER_COUNTS.powi(off as i32) * lead * if template.is_lively() { 1.0 } else { PLAIN }
}

/// Ratio of the largest panel to the next one.
fn lead(shares: &[f64]) -> f64 {
    let (mut first, mut second) = (0.0, 0.0);
    for &share in shares {
        (first, second) = if share > first { (share, first) } else { (first, share.max(second)) };
    }
    first / f64::max(second, 1e-9)
}

/// Whether no panel of a template is too small.
fn is_roomy(template: &Template, aspect: f64) -> bool {
    template.shares(aspect).iter().all(|share| *share >= LEAST_SHARE - 1e-6)
}

/// Returns whether a family is allowed. An empty list allows all.
#[must_use]
pub fn is_within(families: &[String], family: &str) -> bool {
    families.is_empty() || families.iter().any(|other| other == family)
}

/// Returns the weight of a family, 0 to 1. The values come from manual ratings of pages.
#[must_use]
pub fn weight(family: &str) -> f64 {
    match family {
        "slanted" | "manga" => 1.0,
        // Splashes score well because of their large leads.
        "cinema" | "circle" | "splash" => 0.5,
        "mosaic" => 0.7,
        "columns" | "inset" => 0.45,
        "overlap" | "landscape" => 0.9,
        "grid" => 0.2,
        // Rows, heroes, and layouts for one page shape.
        _ => 0.6,
    }
}

fn nearest(good: &[&'static Template], panels: usize) -> Vec<&'static Template> {
    let distance = |template: &&Template| template.panels().len().abs_diff(panels);
    let least = good.iter().map(distance).min().unwrap_or(0);
    good.iter().copied().filter(|template| distance(template) == least).collect()
}

/// Returns layouts that the photos fill without repeats. Layouts with one panel and layouts with very small
/// panels are left out.
fn usual(good: &[&'static Template], photos: usize) -> Vec<&'static Template> {
    let most = photos.min(USUAL_MOST);
    let least = photos.min(3).min(most);
    let fits = |template: &&&'static Template| (least..=most).contains(&template.panels().len());
    let fitting: Vec<&'static Template> = good.iter().filter(fits).copied().collect();
    if fitting.is_empty() { nearest(good, most) } else { fitting }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wanted(taste: &Taste) -> Wanted<'_> {
        Wanted { aspect: 0.707, panels: None, photos: 12, shown: &[], families: &[], taste }
    }

    fn times(taste: &Taste, family: &str) -> usize {
        let first = |seed: u32| {
            draw(&wanted(taste), &mut Rand64::new(u128::from(seed)))[0].template.family() == family
        };
        (0..600).filter(|&seed| first(seed)).count()
    }

    #[test]
    fn sixteen_different_layouts_are_drawn_and_none_that_was_shown() {
        let taste = Taste::default();
        let first = draw(&wanted(&taste), &mut Rand64::new(1));
        let mut ids: Vec<&str> = first.iter().map(|drawn| drawn.template.id()).collect();
        let shown = ids.clone();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), DRAWN);
        let next = draw(&Wanted { shown: &shown, ..wanted(&taste) }, &mut Rand64::new(1));
        assert!(next.iter().all(|drawn| !shown.contains(&drawn.template.id())));
    }

    #[test]
    fn what_is_liked_comes_more_often_and_nothing_is_lost() {
        let mut liking = Taste::default();
        let before = times(&liking, "columns");
        liking.families = vec![("columns".into(), 1.2)];
        let after = times(&liking, "columns");
        assert!(before > 5 && after > 2 * before, "{before} {after}");
        liking.families[0].1 = f64::NAN;
        assert_eq!(times(&liking, "columns"), before);
        let comes = |seed: u32| {
            let drawn = draw(&wanted(&Taste::default()), &mut Rand64::new(u128::from(seed)));
            drawn.iter().any(|drawn| drawn.template.family() == "grid")
        };
        assert!((0..600).any(comes));
    }

    #[test]
    fn families_that_are_asked_for_are_kept_to() {
        let (taste, families) = (Taste::default(), ["manga".to_owned(), "strip".to_owned()]);
        for aspect in [0.707, 1.0, 1.414] {
            let wanted = Wanted { aspect, families: &families, ..wanted(&taste) };
            let drawn = draw(&wanted, &mut Rand64::new(5));
            assert!(!drawn.is_empty());
            assert!(drawn.iter().all(|drawn| ["manga", "strip"].contains(&drawn.template.family())));
        }
    }

    #[test]
    fn few_photos_get_few_panels() {
        let taste = Taste::default();
        for photos in 1..12 {
            let drawn = draw(&Wanted { photos, ..wanted(&taste) }, &mut Rand64::new(7));
            assert!(!drawn.is_empty());
            assert!(drawn.iter().all(|drawn| drawn.template.panels().len() <= photos.max(1)), "{photos}");
        }
        let nine = draw(&Wanted { panels: Some(9), ..wanted(&taste) }, &mut Rand64::new(7));
        assert!(nine.iter().all(|drawn| drawn.template.panels().len() == 9));
    }
}
