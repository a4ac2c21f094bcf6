//! Joins panels of a template into one panel that covers their area.
//!
//! For adjacent panels in one cell, the dividers between them are removed. Panels of different cells need
//! another order of dividers. The smallest cell that contains them is split into rectangles and divided again
//! (a guillotine partition). This works only without slanted dividers.

use super::edit::{base_panels, in_tree, rebuilt, refused, tree};
use super::template::{Panel, Template};
use super::tree::{Axis, Node, PAGE, Split};
use crate::error::Result;
use crate::order::sort_by;

/// Maximum distance of positions that count as equal, as a fraction of a cell. Shares have four digits.
const NEAR: f64 = 1e-3;

/// The template with some base panels as one, at the place of the first of them in the reading order.
///
/// # Errors
/// `invalid-layout` for fewer than two panels, an overlay, and panels that no cuts can make one of.
pub fn join_panels(template: &Template, panels: &[usize]) -> Result<Template> {
    let mut group = panels.to_vec();
    group.sort_unstable();
    group.dedup();
    let named = || format!("panels {group:?}");
    let [first, _, ..] = group[..] else { return Err(refused(template, named(), "are not two")) };
    let leaves = group.iter().map(|&panel| in_tree(template, panel)).collect::<Result<Vec<_>>>()?;
    let Some((node, ids)) = joined(tree(template)?, 0, &leaves) else {
        return Err(refused(template, named(), "do not make one panel together"));
    };
    let old = base_panels(template);
    let joined = Panel {
        weight: group.iter().map(|&panel| old[panel].weight).sum(),
        bleeds: group.iter().any(|&panel| old[panel].bleeds),
        ..old[first].clone()
    };
    let (mut order, mut panels) = (Vec::new(), Vec::new());
    for (panel, &leaf) in template.order.iter().enumerate() {
        let stays = panel == first || !group.contains(&panel);
        let leaf = if panel == first { leaves.iter().copied().min().unwrap_or(leaf) } else { leaf };
        if let (true, Some(at)) = (stays, ids.iter().position(|&id| id == leaf)) {
            order.push(at);
            panels.push(if panel == first { joined.clone() } else { old[panel].clone() });
        }
    }
    rebuilt(template, node, order, panels)
}

/// The cell with the leaves of that group joined, and the old number of each leaf. The joined leaf has the
/// smallest number of the group. `before` is the number of leaves before the cell.
fn joined(node: &Node, before: usize, group: &[usize]) -> Option<(Node, Vec<usize>)> {
    let Node::Split(split) = node else { return None };
    let starts: Vec<usize> = split
        .children
        .iter()
        .scan(before, |next, child| Some(std::mem::replace(next, *next + child.count())))
        .collect();
    let held = |i: usize| {
        let leaves = starts[i]..starts[i] + split.children[i].count();
        group.iter().filter(|leaf| leaves.contains(leaf)).count()
    };
    let touched: Vec<usize> = (0..starts.len()).filter(|&i| held(i) > 0).collect();
    let (first, last) = (*touched.first()?, *touched.last()?);
    let all = |from: usize, count: usize| from..from + count;
    if first == last {
        let (child, ids) = joined(&split.children[first], starts[first], group)?;
        let mut changed = split.clone();
        changed.children[first] = child;
        let after = starts[first] + split.children[first].count();
        let ids = (before..starts[first]).chain(ids).chain(after..before + node.count());
        return Some((Node::Split(changed), ids.collect()));
    }
    let whole = (first..=last).all(|i| held(i) == split.children[i].count());
    if !whole {
        return cut_anew(node, before, group);
    }
    let least = starts[first];
    let end = starts[last] + split.children[last].count();
    let ids = (before..least).chain([least]).chain(all(end, before + node.count() - end)).collect();
    if last - first + 1 == split.children.len() {
        return Some((Node::Panel, ids));
    }
    let mut changed = split.clone();
    changed.children.splice(first..=last, [Node::Panel]);
    let share = split.shares[first..=last].iter().sum();
    changed.shares.splice(first..=last, [share]);
    changed.slants.drain(first..last);
    Some((Node::Split(changed), ids))
}

/// A straight rectangle of a cell, and the number of the leaf that it was.
#[derive(Clone, Copy)]
struct Rect {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
    id: usize,
}

impl Rect {
    fn area(&self) -> f64 {
        (self.right - self.left) * (self.bottom - self.top)
    }

    fn union(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
            id: self.id.min(other.id),
        }
    }

    /// Start and end along an axis.
    fn extent(&self, axis: Axis) -> (f64, f64) {
        match axis {
            Axis::Rows => (self.top, self.bottom),
            Axis::Columns => (self.left, self.right),
        }
    }
}

fn cut_anew(node: &Node, before: usize, group: &[usize]) -> Option<(Node, Vec<usize>)> {
    if is_slanted(node) {
        return None;
    }
    // Coordinates relative to the cell, in which the edges of the cell are straight.
    let rects = node.cells(&PAGE).into_iter().enumerate().map(|(i, [from, _, to, _])| Rect {
        left: from.x,
        top: from.y,
        right: to.x,
        bottom: to.y,
        id: before + i,
    });
    let (chosen, mut rest): (Vec<_>, Vec<_>) = rects.partition(|rect| group.contains(&rect.id));
    let filled: f64 = chosen.iter().map(Rect::area).sum();
    let union = chosen.into_iter().reduce(Rect::union)?;
    if union.area() - filled > NEAR * NEAR {
        return None;
    }
    rest.push(union);
    let mut ids = Vec::new();
    Some((partition(&rest, &mut ids)?, ids))
}

fn is_slanted(node: &Node) -> bool {
    let Node::Split(split) = node else { return false };
    split.slants.iter().any(|slant| slant.abs() > f64::EPSILON) || split.children.iter().any(is_slanted)
}

/// Divides a rectangle that consists of other rectangles, with dividers across a complete side. `None` if
/// every divider would split one of them. The numbers of the leaves come in the order of the tree.
fn partition(rects: &[Rect], ids: &mut Vec<usize>) -> Option<Node> {
    if let [only] = rects {
        ids.push(only.id);
        return Some(Node::Panel);
    }
    let axes = [Axis::Rows, Axis::Columns];
    let (axis, bands) =
        axes.into_iter().map(|axis| (axis, bands(rects, axis))).find(|(_, bands)| bands.len() > 1)?;
    let mut split =
        Split { axis, shares: Vec::new(), slants: vec![0.0; bands.len() - 1], children: Vec::new() };
    for band in bands {
        let (from, to) = band.iter().copied().reduce(Rect::union)?.extent(axis);
        split.shares.push(to - from);
        split.children.push(partition(&band, ids)?);
    }
    Some(Node::Split(split))
}

/// Groups the rectangles by the dividers across the complete side.
fn bands(rects: &[Rect], axis: Axis) -> Vec<Vec<Rect>> {
    let mut sorted = rects.to_vec();
    sort_by(&mut sorted, |a, b| a.extent(axis).0.total_cmp(&b.extent(axis).0));
    let mut bands: Vec<Vec<Rect>> = Vec::new();
    let mut reached = f64::NEG_INFINITY;
    for rect in sorted {
        let (from, to) = rect.extent(axis);
        match bands.last_mut() {
            Some(band) if from < reached - NEAR => band.push(rect),
            _ => bands.push(vec![rect]),
        }
        reached = reached.max(to);
    }
    bands
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::merge::adjacent;
    use crate::layout::polygon::{Bounds, area};
    use crate::layout::{Body, Point, Shape, catalogue, find};

    fn corners(template: &Template, panel: usize) -> Vec<Point> {
        match &template.panels()[panel].shape {
            Shape::Polygon(points) => points.clone(),
            Shape::Circle { .. } => Vec::new(),
        }
    }

    #[test]
    fn two_that_touch_become_one_and_the_others_stay() {
        let (mut tried, mut done) = (0, 0);
        for template in catalogue().iter().filter(|t| matches!(t.body(), Body::Tree(_))) {
            for [a, b] in adjacent(template) {
                tried += 1;
                let Ok(after) = join_panels(template, &[b, a]) else { continue };
                done += 1;
                let name = format!("{} {a} {b}", template.id());
                assert_eq!(after.panels().len(), template.panels().len() - 1, "{name}");
                assert_eq!((after.family(), after.base_count()), ("custom", template.base_count() - 1));
                let whole: f64 = [a, b].into_iter().map(|panel| area(&corners(template, panel))).sum();
                assert!((area(&corners(&after, a)) - whole).abs() < 2e-3, "{name}");
                let weight = template.panels()[a].weight + template.panels()[b].weight;
                assert!((after.panels()[a].weight - weight).abs() < 1e-6, "{name}");
                for panel in (0..template.panels().len()).filter(|&panel| panel != a && panel != b) {
                    let now = panel - usize::from(panel > b);
                    let (one, other) = (corners(template, panel), corners(&after, now));
                    let bounds = |points: &[Point]| (!points.is_empty()).then(|| Bounds::of(points));
                    let (Some(one), Some(other)) = (bounds(&one), bounds(&other)) else { continue };
                    let moved = [
                        one.x - other.x,
                        one.y - other.y,
                        one.width - other.width,
                        one.height - other.height,
                    ];
                    assert!(moved.iter().all(|by| by.abs() < 2e-3), "{name}: {panel} moved by {moved:?}");
                }
            }
        }
        // The others cover a corner of a third panel, or have slanted dividers.
        assert!(tried > 300 && done * 2 > tried, "{done} of {tried}");
    }

    #[test]
    fn panels_keep_their_bleed_while_others_are_joined() {
        let before = find("bleed-bottom-5").unwrap();
        let bleeding = |t: &Template| t.panels().iter().map(|p| p.bleeds).collect::<Vec<_>>();
        let mut joined = 0;
        for [a, b] in adjacent(before) {
            let Ok(after) = join_panels(before, &[a, b]) else { continue };
            assert_eq!(bleeding(&after), [false, false, false, true], "{a} {b}");
            joined += 1;
        }
        assert_eq!(joined, 2);
        let split = super::super::edit::split_panel(before, 4, Axis::Columns).unwrap();
        assert_eq!(bleeding(&join_panels(&split, &[4, 5]).unwrap()), bleeding(before));
    }

    #[test]
    fn panels_of_two_rows_become_one_where_their_cuts_meet() {
        let grid = find("grid-4").unwrap();
        let after = join_panels(grid, &[0, 2]).unwrap();
        assert_eq!(after.panels().len(), 3);
        let tall = Bounds::of(&corners(&after, 0));
        assert!((tall.height - 1.0).abs() < 1e-9 && (tall.width - 0.5).abs() < 1e-3, "{tall:?}");
        assert_eq!(join_panels(grid, &[0, 1, 2, 3]).unwrap().panels().len(), 1);
        assert_eq!(join_panels(grid, &[0, 1, 2]).unwrap_err().code(), "invalid-layout", "an L is no panel");
        assert_eq!(join_panels(grid, &[0, 3]).unwrap_err().code(), "invalid-layout", "they meet at a corner");
        assert!(join_panels(grid, &[0]).is_err() && join_panels(grid, &[0, 0]).is_err());
        assert!(join_panels(grid, &[0, 9]).is_err());
        assert!(join_panels(find("mosaic-y").unwrap(), &[0, 1]).is_err());
    }

    #[test]
    fn what_was_split_is_joined_again() {
        let before = find("rows-1-2-1").unwrap();
        let split = super::super::edit::split_panel(before, 1, Axis::Rows).unwrap();
        assert_eq!(join_panels(&split, &[1, 2]).unwrap().body(), before.body());
    }
}
