//! Rates the aesthetics of a template on a page by numbers.
//!
//! Five terms, each 0 to 1: panels of different sizes with one leading panel; weight balanced around the
//! centre; edges that align or clearly do not; no slivers; few slants.

use super::polygon::{Bounds, Point, area, edges, thickness};
use super::template::{Shape, Template};

/// The preferred spread of panel areas (standard deviation over mean): lively, but not random.
const SPREAD: f64 = 0.42;
/// Edges nearer than this, in page widths, that do not line up look like a mistake.
const NEAR_MISS: f64 = 0.06;

/// The score of a template on a page of that aspect (width over height): 0 (poor) to 1. Overlays are ignored.
#[must_use]
pub fn score(template: &Template, page_aspect: f64) -> f64 {
    let on_page = |p: &Point| Point::new(p.x, p.y / page_aspect);
    let base = template.panels().iter().filter(|panel| !panel.overlay);
    let cells: Vec<Vec<Point>> = base
        .filter_map(|panel| match &panel.shape {
            Shape::Polygon(cell) => Some(cell.iter().map(on_page).collect()),
            Shape::Circle { .. } => None,
        })
        .collect();
    if cells.len() < 2 {
        return 0.5;
    }
    0.3 * variety(&cells)
        + 0.15 * balance(&cells, page_aspect)
        + 0.25 * alignment(&cells)
        + 0.2 * fullness(&cells)
        + 0.1 * calm(&cells)
}

fn variety(cells: &[Vec<Point>]) -> f64 {
    let areas: Vec<f64> = cells.iter().map(|cell| area(cell)).collect();
    let mean = areas.iter().sum::<f64>() / areas.len() as f64;
    let variance = areas.iter().map(|a| (a - mean).powi(2)).sum::<f64>() / areas.len() as f64;
    let spread = variance.sqrt() / mean;
    (1.0 - (spread - SPREAD).abs() / SPREAD).max(0.0)
}

/// Panels have equal weight, so a side with many small panels is the heavier one.
fn balance(cells: &[Vec<Point>], page_aspect: f64) -> f64 {
    let centre = |cell: &Vec<Point>| {
        let bounds = Bounds::of(cell);
        (bounds.x + bounds.width / 2.0, bounds.y + bounds.height / 2.0)
    };
    let n = cells.len() as f64;
    let (x, y) = cells.iter().map(centre).fold((0.0, 0.0), |sum, at| (sum.0 + at.0, sum.1 + at.1));
    let (off_x, off_y) = (x / n - 0.5, (y / n) * page_aspect - 0.5);
    (1.0 - off_x.hypot(off_y) * 4.0).max(0.0)
}

/// The part of pairs of parallel edges that either line up or stand clearly apart.
fn alignment(cells: &[Vec<Point>]) -> f64 {
    let (mut misses, mut pairs) = (0.0, 0.0);
    for across in [true, false] {
        let mut places: Vec<f64> = Vec::new();
        for (a, b) in cells.iter().flat_map(|cell| edges(cell)) {
            let (along, off) = if across { (b.x - a.x, b.y - a.y) } else { (b.y - a.y, b.x - a.x) };
            let place = if across { f64::midpoint(a.y, b.y) } else { f64::midpoint(a.x, b.x) };
            if along.abs() > off.abs() && places.iter().all(|known| (known - place).abs() > 1e-6) {
                places.push(place);
            }
        }
        for (i, place) in places.iter().enumerate() {
            for other in &places[..i] {
                pairs += 1.0;
                misses += (1.0 - (place - other).abs() / NEAR_MISS).max(0.0);
            }
        }
    }
    if pairs > 0.0 { (1.0 - 4.0 * misses / pairs).max(0.0) } else { 1.0 }
}

/// How far the thinnest panel is from a sliver, against an even page of as many panels.
fn fullness(cells: &[Vec<Point>]) -> f64 {
    let total: f64 = cells.iter().map(|cell| area(cell)).sum();
    let even = (total / cells.len() as f64).sqrt();
    let thinnest = cells.iter().map(|cell| thickness(cell)).fold(f64::INFINITY, f64::min);
    (thinnest / even / 0.75).min(1.0)
}

/// The part of edges that are upright or level.
fn calm(cells: &[Vec<Point>]) -> f64 {
    let (mut straight, mut all) = (0.0, 0.0);
    for (a, b) in cells.iter().flat_map(|cell| edges(cell)) {
        all += 1.0;
        straight += f64::from(u8::from((b.x - a.x).abs().min((b.y - a.y).abs()) < 1e-6));
    }
    straight / all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::{PRESETS, catalogue};

    fn template(tree: &str) -> Template {
        let head = r#"{"id": "t", "name": "T", "family": "custom", "aspect": 0.707"#;
        Template::parse("t.json", &format!("{head}, \"tree\": {tree}}}")).unwrap()
    }

    #[test]
    fn what_looks_like_a_mistake_scores_less() {
        let row = |first: f64| format!(r#"{{"columns": ["panel", "panel"], "shares": [{first}, 1]}}"#);
        let page = |a: f64, b: f64| format!(r#"{{"rows": [{}, {}]}}"#, row(a), row(b));
        let of = |tree: &str| score(&template(tree), 0.707);
        // Cuts that nearly line up are worse than cuts that do, and than cuts that clearly do not.
        assert!(of(&page(1.6, 1.5)) < of(&page(1.6, 1.6)));
        assert!(of(&page(1.6, 1.5)) < of(&page(1.6, 0.6)));
        // A sliver is worse than a full panel.
        assert!(of(&row(6.0)) < of(&row(1.8)));
    }

    #[test]
    fn scores_of_all_templates_are_from_0_to_1() {
        for template in catalogue() {
            for page in PRESETS {
                let score = score(template, f64::from(page.width) / f64::from(page.height));
                assert!((0.0..=1.0).contains(&score), "{}: {score}", template.id());
            }
        }
    }
}
