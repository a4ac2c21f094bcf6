//! Enlarges one panel of a layout: the dividers next to it move in small steps, while the other panels retain
//! a reasonable size. An inset grows around its centre.

use super::edit::{cuts, move_cut, place_overlay};
use super::{Bounds, PageSettings, Template, resolve};
use crate::error::Result;

/// The panel grows to this multiple of its area.
const GOAL: f64 = 1.7;
/// Minimum area of another panel, relative to its area before.
const FAIR: f64 = 0.5;
/// Distance that a divider moves at a time, in parts of its cell.
const STEP: f64 = 0.02;
const MAX_STEPS: usize = 32;
/// Maximum area of an inset, relative to the page, because it covers other panels.
const MOST_INSET: f64 = 0.3;
/// Minimum growth by one step, relative to the area at the start.
const WORTH: f64 = 0.02;

/// Returns the layout with a larger group of panels, or `None` if that is impossible. `group`: the panels
/// that share an image, or one panel. `locked`: whether each panel keeps its size.
///
/// # Errors
/// `invalid-layout`.
pub fn enlarged(
    template: &Template,
    page: &PageSettings,
    group: &[usize],
    locked: &[bool],
) -> Result<Option<Template>> {
    let aspect = page.aspect();
    let placed = resolve(template, aspect, page);
    if let [panel] = *group
        && let Some(inset) = placed.get(panel).filter(|placed| placed.overlay)
    {
        let bounds = larger_inset(inset.bounds, 1.0 / aspect, page.margin);
        return bounds.map(|bounds| place_overlay(template, panel, bounds, aspect, page)).transpose();
    }
    let areas = |template: &Template| -> Vec<f64> {
        resolve(template, aspect, page)
            .iter()
            .map(|placed| placed.bounds.width * placed.bounds.height)
            .collect()
    };
    let size = |areas: &[f64]| -> f64 { group.iter().filter_map(|panel| areas.get(*panel)).sum() };
    let start = areas(template);
    let is_fair = |areas: &[f64]| {
        areas.iter().zip(&start).enumerate().all(|(i, (area, before))| {
            if group.contains(&i) {
                return true;
            }
            if locked.get(i) == Some(&true) { (area - before).abs() < 1e-6 } else { *area >= FAIR * before }
        })
    };
    let mut layout: Option<Template> = None;
    let mut reached = size(&start);
    for _ in 0..MAX_STEPS {
        if reached >= GOAL * size(&start) {
            break;
        }
        let mut best: Option<(f64, Template)> = None;
        for moved in moves(layout.as_ref().unwrap_or(template), page)? {
            let areas = areas(&moved);
            let grown = size(&areas);
            let least = best.as_ref().map_or(reached + WORTH * size(&start), |(most, _)| *most);
            if grown > least && is_fair(&areas) {
                best = Some((grown, moved));
            }
        }
        let Some((grown, moved)) = best else { break };
        (reached, layout) = (grown, Some(moved));
    }
    Ok(layout)
}

/// Returns `None` if the inset has its maximum size. `height`: of the page, in page widths.
fn larger_inset(from: Bounds, height: f64, margin: f64) -> Option<Bounds> {
    let area = from.width * from.height;
    let factor = GOAL
        .min(MOST_INSET * height / area)
        .sqrt()
        .min((1.0 - 2.0 * margin) / from.width)
        .min((height - 2.0 * margin) / from.height);
    if factor * factor < 1.0 + WORTH {
        return None;
    }
    let (wide, high) = (from.width * factor, from.height * factor);
    let within =
        |middle: f64, side: f64, all: f64| (middle - side / 2.0).max(margin).min(all - margin - side);
    Some(Bounds {
        x: within(from.x + from.width / 2.0, wide, 1.0),
        y: within(from.y + from.height / 2.0, high, height),
        width: wide,
        height: high,
    })
}

/// The layouts with one divider moved by a step to either side.
fn moves(template: &Template, page: &PageSettings) -> Result<Vec<Template>> {
    let mut moved = Vec::new();
    for (i, cut) in cuts(template, page.aspect(), page).iter().enumerate() {
        for by in [-STEP, STEP] {
            moved.push(move_cut(template, i, cut.fraction + by, cut.slant)?);
        }
    }
    Ok(moved)
}

#[cfg(test)]
mod tests {
    use super::super::{catalogue, find};
    use super::*;

    fn areas(template: &Template) -> Vec<f64> {
        let page = PageSettings::default();
        let placed = resolve(template, page.aspect(), &page);
        placed.iter().map(|placed| placed.bounds.width * placed.bounds.height).collect()
    }

    fn larger(template: &Template, panel: usize, locked: &[bool]) -> Option<Template> {
        enlarged(template, &PageSettings::default(), &[panel], locked).unwrap()
    }

    #[test]
    fn a_panel_becomes_larger_and_the_other_panels_keep_a_fair_size() {
        let grid = find("grid-4").unwrap();
        for panel in 0..4 {
            let (small, large) = (areas(grid), areas(&larger(grid, panel, &[]).unwrap()));
            assert!(large[panel] > 1.2 * small[panel]);
            for i in (0..4).filter(|i| *i != panel) {
                assert!(large[i] > 0.49 * small[i]);
            }
        }
    }

    #[test]
    fn an_inset_grows_inside_the_margins_up_to_a_part_of_the_page() {
        let good = |template: &&Template| {
            template.base_count() < template.panels().len()
                && template.good_for(PageSettings::default().aspect())
        };
        let mut layout = catalogue().iter().find(good).unwrap().clone();
        let inset = layout.panels().len() - 1;
        let before = areas(&layout);
        while let Some(next) = larger(&layout, inset, &[]) {
            layout = next;
        }
        let after = areas(&layout);
        assert!(after[inset] > 1.2 * before[inset]);
        assert!(after[inset] < 0.31 / PageSettings::default().aspect());
        assert_eq!(after[..inset], before[..inset]);
    }

    #[test]
    fn a_locked_panel_keeps_its_size_and_a_layout_without_dividers_stays() {
        assert_eq!(larger(find("grid-4").unwrap(), 0, &[false, true, true, true]), None);
        assert_eq!(larger(find("mosaic-y").unwrap(), 0, &[]), None);
    }
}
