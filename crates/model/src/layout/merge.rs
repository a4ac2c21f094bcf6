//! Merges: one photo across adjacent panels. Each panel shows a window of it, so that the gutter seems to be
//! on top of the photo.

use super::polygon::{Bounds, Point, area, edges, hull};
use super::resolve::ResolvedPanel;
use super::template::{Shape, Template};
use serde::Serialize;

/// The least part of its hull that a union must fill to be merged unasked.
const LEAST_CONVEX: f64 = 0.9;
/// The most of the page that three panels merged unasked may cover: a page of one picture is a splash.
const MOST_COVERED: f64 = 0.67;
/// The least common edge of two panels that touch, in unit coordinates; corners do not count.
const LEAST_EDGE: f64 = 0.02;

/// Why panels cannot share one photo, or become one panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Obstacle {
    /// Fewer than two panels.
    Few,
    /// An overlay is one of them.
    Overlay,
    /// They share a photo already.
    Already,
    /// They do not touch along edges.
    Apart,
    /// No cuts can make one panel of them.
    Uneven,
}

/// Which base panels touch along an edge: pairs of indices into [`Template::panels`], the smaller first.
#[must_use]
pub fn adjacent(template: &Template) -> Vec<[usize; 2]> {
    let cells = base_cells(template);
    let pairs = (0..cells.len()).flat_map(|i| (i + 1..cells.len()).map(move |j| [i, j]));
    pairs.filter(|&[i, j]| common_edge(cells[i], cells[j]) > LEAST_EDGE).collect()
}

/// Groups of two or three panels that look well when merged: they touch, and their union fills at least 90 %
/// of its hull. Indices ascend; pairs come first.
#[must_use]
pub fn mergeable(template: &Template) -> Vec<Vec<usize>> {
    let pairs = adjacent(template);
    let cells = base_cells(template);
    let fills = |group: &Vec<usize>| {
        let corners: Vec<Point> = group.iter().flat_map(|&i| cells[i].iter().copied()).collect();
        let union: f64 = group.iter().map(|&i| area(cells[i])).sum();
        union >= LEAST_CONVEX * area(&hull(&corners))
    };
    let mut groups: Vec<Vec<usize>> = pairs.iter().map(|pair| pair.to_vec()).filter(fills).collect();
    for [i, j] in groups.clone().into_iter().filter_map(|pair| <[usize; 2]>::try_from(pair).ok()) {
        let touches =
            |k: usize| pairs.contains(&[i.min(k), i.max(k)]) || pairs.contains(&[j.min(k), j.max(k)]);
        for k in (0..cells.len()).filter(|&k| k != i && k != j && touches(k)) {
            let mut group = vec![i, j, k];
            group.sort_unstable();
            let covered: f64 = group.iter().map(|&i| area(cells[i])).sum();
            if covered < MOST_COVERED && fills(&group) && !groups.contains(&group) {
                groups.push(group);
            }
        }
    }
    groups
}

/// Why the user cannot merge these panels. Two or more different base panels that are connected by their edges
/// can be merged. Their union may have any shape.
#[must_use]
pub fn why_not_merge(template: &Template, group: &[usize]) -> Option<Obstacle> {
    let distinct = group.iter().enumerate().all(|(at, i)| !group[..at].contains(i));
    if group.len() < 2 || !distinct {
        return Some(Obstacle::Few);
    }
    if group.iter().any(|&i| i >= template.base_count()) {
        return Some(Obstacle::Overlay);
    }
    let pairs = adjacent(template);
    let mut reached = vec![group[0]];
    let mut next = 0;
    while next < reached.len() {
        let from = reached[next];
        for &to in group {
            if pairs.contains(&[from.min(to), from.max(to)]) && !reached.contains(&to) {
                reached.push(to);
            }
        }
        next += 1;
    }
    (reached.len() < group.len()).then_some(Obstacle::Apart)
}

/// The rectangle around the merged panels on the page, including the gutters between them. The shared photo
/// is framed for it. `None` for an empty group or an index outside.
#[must_use]
pub fn merged_bounds(panels: &[ResolvedPanel], group: &[usize]) -> Option<Bounds> {
    let bounds = group.iter().map(|&i| panels.get(i).map(|panel| panel.bounds));
    bounds.collect::<Option<Vec<_>>>()?.into_iter().reduce(Bounds::union)
}

fn base_cells(template: &Template) -> Vec<&[Point]> {
    let base = template.panels().iter().filter(|panel| !panel.overlay);
    base.filter_map(|panel| match &panel.shape {
        Shape::Polygon(cell) => Some(cell.as_slice()),
        Shape::Circle { .. } => None,
    })
    .collect()
}

/// The longest edge that two cells have in common.
fn common_edge(a: &[Point], b: &[Point]) -> f64 {
    let mut longest = 0.0f64;
    for (p, q) in edges(a) {
        let length = p.distance(q);
        let (ux, uy) = ((q.x - p.x) / length, (q.y - p.y) / length);
        // Along and across the edge p -> q.
        let local = |r: Point| {
            let (x, y) = (r.x - p.x, r.y - p.y);
            (x * ux + y * uy, (x * uy - y * ux).abs())
        };
        for (r, s) in edges(b) {
            let ((from, off_r), (to, off_s)) = (local(r), local(s));
            if off_r.max(off_s) < 1e-6 {
                longest = longest.max(from.max(to).min(length) - from.min(to).max(0.0));
            }
        }
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::{PageSettings, find, resolve};

    fn template(tree: &str) -> Template {
        let head = r#"{"id": "t", "name": "T", "family": "custom", "aspect": 0.7"#;
        Template::parse("t.json", &format!("{head}, \"tree\": {tree}}}")).unwrap()
    }

    #[test]
    fn a_grid_merges_along_edges_and_not_across_corners() {
        let grid = find("grid-4").unwrap();
        assert_eq!(adjacent(grid), [[0, 1], [0, 2], [1, 3], [2, 3]]);
        assert_eq!(mergeable(grid), [[0, 1], [0, 2], [1, 3], [2, 3]].map(|pair| pair.to_vec()));
        assert_eq!(why_not_merge(grid, &[0, 1, 3]), None);
        let bad: [(&[usize], Obstacle); 5] = [
            (&[0, 3], Obstacle::Apart),
            (&[0], Obstacle::Few),
            (&[], Obstacle::Few),
            (&[0, 0], Obstacle::Few),
            (&[0, 4], Obstacle::Overlay),
        ];
        for (group, why) in bad {
            assert_eq!(why_not_merge(grid, group), Some(why), "{group:?}");
        }
    }

    #[test]
    fn a_row_of_three_is_a_triptych() {
        let row = r#"{"columns": ["panel", "panel", "panel"], "slants": [0.1, 0.1]}"#;
        assert_eq!(mergeable(&template(row)), [vec![0, 1], vec![1, 2]]);
        let below = template(&format!(r#"{{"rows": ["panel", {row}]}}"#));
        assert_eq!(mergeable(&below), [vec![1, 2], vec![2, 3], vec![1, 2, 3]]);
    }

    #[test]
    fn an_l_is_merged_on_demand_only() {
        let tree = r#"{"rows": ["panel", {"columns": ["panel", "panel"]}]}"#;
        let layout = template(tree);
        assert_eq!(mergeable(&layout), [vec![1, 2]]);
        assert_eq!(why_not_merge(&layout, &[0, 1]), None);
    }

    #[test]
    fn merged_bounds_hold_the_gutter() {
        let settings = PageSettings::default();
        let panels = resolve(find("grid-4").unwrap(), settings.aspect(), &settings);
        let both = merged_bounds(&panels, &[0, 1]).unwrap();
        let alone = panels[0].bounds.width + panels[1].bounds.width;
        assert!((both.width - alone - settings.gutter).abs() < 1e-12);
        assert_eq!(merged_bounds(&panels, &[0, 9]), None);
        assert_eq!(merged_bounds(&panels, &[]), None);
    }
}
