//! Manual changes to a template: move or slant a divider, split or remove a panel, move or size an overlay.
//! Panels are joined by [`super::join`].
//!
//! Each change gives a new template of the family `custom`, which passes the same checks as a file. Polygon
//! templates have no dividers, so only their overlays can be changed.

use serde::Serialize;

use super::polygon::{Bounds, Point};
use super::resolve::{Page, resolve};
use super::settings::PageSettings;
use super::template::{Body, Panel, Shape, Template};
use super::tree::{Axis, Node, PAGE, Quad, Split};
use crate::error::{Error, Result};

/// The least distance, as a fraction of the cell, that a moved cut keeps from its neighbours.
const LEAST_STEP: f64 = 0.06;

/// The least side of a sized overlay, as a fraction of the page.
const LEAST_OVERLAY: f64 = 0.08;

/// The radius of a sized circle in page widths: at least, and at most.
const RADIUS: (f64, f64) = (0.04, 0.5);

/// A cut of a template on a page.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Cut {
    /// Which way the cells that it parts are laid out: it runs across for rows, down for columns.
    pub axis: Axis,
    /// Its left or upper end, in page widths.
    pub from: Point,
    /// Its right or lower end, in page widths.
    pub to: Point,
    /// Position in its cell, 0 to 1.
    pub fraction: f64,
    /// Its slant, as in the file.
    pub slant: f64,
    /// The extent of its cell along the way that it can move, in page widths: moved by `d` page widths, its
    /// fraction changes by `d / length`.
    pub length: f64,
}

/// All dividers of a template on a page of this aspect ratio, outer ones before inner ones. Empty for polygon
/// templates and for a single panel.
#[must_use]
pub fn cuts(template: &Template, page_aspect: f64, settings: &PageSettings) -> Vec<Cut> {
    let page = Page::new(page_aspect, settings);
    let gutter = page.largest_gutter(template);
    let mut found = Vec::new();
    if let Body::Tree(node) = template.body() {
        collect(node, &PAGE, &|p| page.place(p, gutter), &mut found);
    }
    found
}

/// Moves one divider (an index into [`cuts`]) to `fraction` of its cell and slants it by `slant`. Both are
/// limited by the neighbouring dividers.
///
/// # Errors
/// `invalid-layout` if there is no such divider or a number is not finite.
pub fn move_cut(template: &Template, cut: usize, fraction: f64, slant: f64) -> Result<Template> {
    if !fraction.is_finite() || !slant.is_finite() {
        return Err(refused(template, format!("cut {cut}"), "needs a finite place and slant"));
    }
    let mut node = tree(template)?.clone();
    let Some((split, index)) = nth_cut(&mut node, &mut { cut }) else {
        return Err(refused(template, format!("cut {cut}"), "does not exist"));
    };
    let places = split.cuts();
    let before = if index == 0 { (0.0, 0.0) } else { places[index - 1] };
    let after = places.get(index + 1).copied().unwrap_or((1.0, 1.0));
    let bound = |at: f64, low: f64, high: f64| {
        let (low, high) = (low + LEAST_STEP, high - LEAST_STEP);
        if low < high { at.clamp(low, high) } else { f64::midpoint(low, high) }
    };
    let left = bound(fraction - slant / 2.0, before.0, after.0);
    let right = bound(fraction + slant / 2.0, before.1, after.1);
    let mut middles: Vec<f64> = places.iter().map(|(left, right)| f64::midpoint(*left, *right)).collect();
    middles[index] = f64::midpoint(left, right);
    split.slants[index] = right - left;
    let ends = middles.iter().copied().chain([1.0]);
    split.shares = ends.scan(0.0, |from, to| Some(to - std::mem::replace(from, to))).collect();
    rebuilt(template, node, template.order.clone(), base_panels(template))
}

/// Splits a base panel in two equal halves, stacked (`Axis::Rows`) or side by side. The halves follow each
/// other in the reading order.
///
/// # Errors
/// `invalid-layout` if there is no such panel, or the panels would be too small.
pub fn split_panel(template: &Template, panel: usize, axis: Axis) -> Result<Template> {
    let mut node = tree(template)?.clone();
    let at = in_tree(template, panel)?;
    if let Some(leaf) = nth_panel(&mut node, &mut { at }) {
        let children = vec![Node::Panel, Node::Panel];
        *leaf = Node::Split(Split { axis, shares: vec![1.0; 2], slants: vec![0.0], children });
    }
    let mut order: Vec<usize> = template.order.iter().map(|&i| i + usize::from(i > at)).collect();
    order.insert(panel + 1, at + 1);
    let mut panels = base_panels(template);
    panels[panel].weight /= 2.0;
    panels.insert(panel + 1, panels[panel].clone());
    rebuilt(template, node, order, panels)
}

/// Removes a panel. The neighbours of a base panel fill its area. Removing an overlay shows the panels below.
///
/// # Errors
/// `invalid-layout` if there is no such panel, or it is the only base panel.
pub fn remove_panel(template: &Template, panel: usize) -> Result<Template> {
    if panel >= template.base_count() && panel < template.panels.len() {
        let mut changed = template.clone();
        changed.panels.remove(panel);
        return checked(changed);
    }
    let mut node = tree(template)?.clone();
    let at = in_tree(template, panel)?;
    if !remove(&mut node, at) {
        return Err(refused(template, format!("panel {panel}"), "is the only one"));
    }
    let rest = template.order.iter().filter(|&&i| i != at);
    let order = rest.map(|&i| i - usize::from(i > at)).collect();
    let mut panels = base_panels(template);
    panels.remove(panel);
    rebuilt(template, node, order, panels)
}

/// Moves and sizes an overlay so that its bounds on the page are `to`, in page widths. The overlay keeps its shape,
/// stays inside the margins, and keeps a minimum size. A circle has the size of the shorter side.
///
/// # Errors
/// `invalid-layout` if the panel is not an overlay, or a number is not finite or a size is not above 0.
pub fn place_overlay(
    template: &Template,
    panel: usize,
    to: Bounds,
    page_aspect: f64,
    settings: &PageSettings,
) -> Result<Template> {
    let place = || format!("panel {panel}");
    if panel < template.base_count() || panel >= template.panels.len() {
        return Err(refused(template, place(), "is not an overlay"));
    }
    let is_size = |side: f64| side.is_finite() && side > 0.0;
    if !(to.x.is_finite() && to.y.is_finite() && is_size(to.width) && is_size(to.height)) {
        return Err(refused(template, place(), "needs finite bounds with a size above 0"));
    }
    let page = Page::new(page_aspect, settings);
    let gutter = page.largest_gutter(template);
    // The unit square is not mirrored. The cell of a panel is half a gutter larger than the panel on each side.
    let cell_of = |bounds: Bounds| Bounds {
        x: if settings.rtl { 1.0 - bounds.x - bounds.width } else { bounds.x } - gutter / 2.0,
        y: bounds.y - gutter / 2.0,
        width: bounds.width + gutter,
        height: bounds.height + gutter,
    };
    let from = cell_of(resolve(template, page_aspect, settings)[panel].bounds);
    let to = cell_of(to);
    let mut changed = template.clone();
    match &mut changed.panels[panel].shape {
        Shape::Polygon(corners) => {
            let moved = corners
                .iter()
                .map(|&corner| page.unplace(carried(page.place(corner, gutter), from, to), gutter));
            let moved: Vec<Point> = moved.collect();
            let wanted = Bounds::of(&moved);
            let limited = inside(wanted);
            *corners = moved.iter().map(|&corner| rounded(carried(corner, wanted, limited))).collect();
        }
        Shape::Circle { center, radius } => {
            let aspect = template.aspect();
            let most = RADIUS.1.min(0.5 / aspect);
            let scale = to.width.min(to.height) / from.width;
            *radius = fourth((*radius * scale).clamp(RADIUS.0.min(most), most));
            let middle = Point::new(to.x + to.width / 2.0, to.y + to.height / 2.0);
            let at = page.unplace(middle, gutter);
            let limited = |at: f64, reach: f64| at.clamp(reach.min(0.5), (1.0 - reach).max(0.5));
            *center = rounded(Point::new(limited(at.x, *radius), limited(at.y, *radius * aspect)));
            // A rounded centre may be too close to the edge by a part of the last digit.
            let room = center.x.min(1.0 - center.x).min(center.y.min(1.0 - center.y) / aspect);
            *radius = radius.min(room);
        }
    }
    checked(changed)
}

/// A point that keeps its relative position while a rectangle moves and changes its size.
fn carried(p: Point, from: Bounds, to: Bounds) -> Point {
    let along = |at: f64, from: f64, length: f64, to: f64, new: f64| to + (at - from) / length * new;
    Point::new(
        along(p.x, from.x, from.width, to.x, to.width),
        along(p.y, from.y, from.height, to.y, to.height),
    )
}

/// Bounds inside the unit square with a minimum size.
fn inside(bounds: Bounds) -> Bounds {
    let width = bounds.width.clamp(LEAST_OVERLAY, 1.0);
    let height = bounds.height.clamp(LEAST_OVERLAY, 1.0);
    Bounds { x: bounds.x.clamp(0.0, 1.0 - width), y: bounds.y.clamp(0.0, 1.0 - height), width, height }
}

fn rounded(p: Point) -> Point {
    Point::new(fourth(p.x).clamp(0.0, 1.0), fourth(p.y).clamp(0.0, 1.0))
}

/// Four digits are finer than a printed dot, and keep files readable.
fn fourth(value: f64) -> f64 {
    (value * 10_000.0).round() / 10_000.0
}

/// The base panels, in reading order.
pub(super) fn base_panels(template: &Template) -> Vec<Panel> {
    template.panels[..template.base_count()].to_vec()
}

/// The place in the tree of a panel of the reading order.
pub(super) fn in_tree(template: &Template, panel: usize) -> Result<usize> {
    let at = template.order.get(panel).copied();
    at.ok_or_else(|| refused(template, format!("panel {panel}"), "is not a base panel"))
}

pub(super) fn tree(template: &Template) -> Result<&Node> {
    match template.body() {
        Body::Tree(node) => Ok(node),
        Body::Polygons(_) => {
            Err(refused(template, "polygons".into(), "have no dividers that can be changed"))
        }
    }
}

pub(super) fn refused(template: &Template, location: String, reason: &str) -> Error {
    Error::InvalidLayout { file: template.id().into(), location, reason: reason.into() }
}

/// A template of the changed tree with its base panels in that order. The panels keep their weight and bleed, but have the
/// cells of the tree. Overlays stay.
pub(super) fn rebuilt(
    template: &Template,
    mut node: Node,
    order: Vec<usize>,
    panels: Vec<Panel>,
) -> Result<Template> {
    tidy(&mut node);
    let (name, aspect) = (template.name(), template.aspect());
    let mut changed = Template::assemble("custom", name, "custom", aspect, Body::Tree(node));
    let cells = std::mem::take(&mut changed.panels);
    let base = order.iter().zip(panels).map(|(&i, panel)| Panel { shape: cells[i].shape.clone(), ..panel });
    changed.panels = base.chain(template.panels.iter().filter(|panel| panel.overlay).cloned()).collect();
    changed.order = order;
    checked(changed)
}

/// The changed template, checked like a file and named after what is in it.
fn checked(mut changed: Template) -> Result<Template> {
    changed.family = "custom".into();
    changed.id = "custom".into();
    let id = format!("custom-{}", fingerprint(&changed.to_json()));
    changed.id.clone_from(&id);
    Template::parse(&id, &changed.to_json())
}

/// Eight hexadecimal digits that are equal for equal texts (FNV-1a).
fn fingerprint(text: &str) -> String {
    let hash = text
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{:08x}", (hash ^ (hash >> 32)) as u32)
}

fn tidy(node: &mut Node) {
    if let Node::Split(split) = node {
        split.shares.iter_mut().for_each(|share| *share = fourth(*share));
        split.slants.iter_mut().for_each(|slant| *slant = fourth(*slant));
        split.children.iter_mut().for_each(tidy);
    }
}

fn collect(node: &Node, cell: &Quad, place: &impl Fn(Point) -> Point, found: &mut Vec<Cut>) {
    let Node::Split(split) = node else { return };
    let cells = split.cells(cell);
    let [a, b, c, d] = cell.map(place);
    let length = match split.axis {
        Axis::Rows => f64::midpoint(d.y - a.y, c.y - b.y),
        Axis::Columns => f64::midpoint(b.x - a.x, c.x - d.x),
    };
    for (i, (before, (left, right))) in cells.iter().zip(split.cuts()).enumerate() {
        let [_, upper_right, lower_right, lower_left] = *before;
        let (from, to) =
            if split.axis == Axis::Rows { (lower_left, lower_right) } else { (upper_right, lower_right) };
        found.push(Cut {
            axis: split.axis,
            from: place(from),
            to: place(to),
            fraction: f64::midpoint(left, right),
            slant: split.slants[i],
            length,
        });
    }
    for (child, cell) in split.children.iter().zip(&cells) {
        collect(child, cell, place, found);
    }
}

/// The split that has the n-th cut in the order of [`cuts`], and which of its cuts it is.
fn nth_cut<'a>(node: &'a mut Node, left: &mut usize) -> Option<(&'a mut Split, usize)> {
    let Node::Split(split) = node else { return None };
    if *left < split.slants.len() {
        return Some((split, *left));
    }
    *left -= split.slants.len();
    split.children.iter_mut().find_map(|child| nth_cut(child, left))
}

fn nth_panel<'a>(node: &'a mut Node, left: &mut usize) -> Option<&'a mut Node> {
    if let Node::Split(split) = node {
        return split.children.iter_mut().find_map(|child| nth_panel(child, left));
    }
    if *left == 0 {
        return Some(node);
    }
    *left -= 1;
    None
}

/// Takes the n-th panel out of the tree; false when the tree is that panel.
fn remove(node: &mut Node, at: usize) -> bool {
    let Node::Split(split) = node else { return false };
    let mut first = 0;
    let holds = |child: &Node| {
        first += child.count();
        at < first
    };
    let Some(index) = split.children.iter().position(holds) else { return false };
    let inside = at + split.children[index].count() - first;
    if remove(&mut split.children[index], inside) {
        return true;
    }
    split.children.remove(index);
    split.shares.remove(index);
    // Remove the divider before the panel, or the first one for the first panel.
    split.slants.remove(index.saturating_sub(1));
    if let [only] = &mut split.children[..] {
        *node = std::mem::replace(only, Node::Panel);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::{Shape, catalogue, find};

    fn on_a4(template: &Template) -> Vec<Cut> {
        let settings = PageSettings::default();
        cuts(template, settings.aspect(), &settings)
    }

    #[test]
    fn a_cut_moves_where_it_is_dragged() {
        let before = find("manga-action-5").unwrap();
        for (i, cut) in on_a4(before).iter().enumerate() {
            let after = move_cut(before, i, cut.fraction + 0.05, cut.slant - 0.04).unwrap();
            let moved = &on_a4(&after)[i];
            assert!((moved.fraction - cut.fraction - 0.05).abs() < 2e-4, "{moved:?}");
            assert!((moved.slant - cut.slant + 0.04).abs() < 2e-4, "{moved:?}");
            assert!((moved.length - cut.length).abs() < 0.2);
            let weights = |t: &Template| t.panels().iter().map(|p| p.weight).collect::<Vec<_>>();
            assert_eq!((after.family(), weights(&after)), ("custom", weights(before)));
        }
    }

    #[test]
    fn panels_keep_their_bleed_while_others_are_split_or_removed() {
        let bleeding = |t: &Template| t.panels().iter().map(|p| p.bleeds).collect::<Vec<_>>();
        let before = find("bleed-bottom-5").unwrap();
        assert_eq!(bleeding(before), [false, false, false, false, true]);
        let split = split_panel(before, 1, Axis::Columns).unwrap();
        assert_eq!(bleeding(&split), [false, false, false, false, false, true]);
        assert_eq!(bleeding(&remove_panel(&split, 2).unwrap()), bleeding(before));
        assert_eq!(bleeding(&remove_panel(before, 0).unwrap()), [false, false, false, true]);
        let halves = split_panel(before, 4, Axis::Columns).unwrap();
        assert_eq!(bleeding(&halves), [false, false, false, false, true, true]);
        // The panel at the edge of the page does not move.
        let settings = PageSettings::default();
        let (was, is) = (bounds(before, 4, &settings), bounds(&split, 5, &settings));
        assert!((was.x - is.x).abs() < 1e-3 && (was.width - is.width).abs() < 1e-3, "{was:?} {is:?}");
    }

    #[test]
    fn cuts_stop_at_their_neighbours() {
        let before = find("cinema-5").unwrap();
        for (fraction, slant) in [(-3.0, 0.0), (9.0, 0.0), (0.4, 5.0), (0.4, -5.0)] {
            let after = move_cut(before, 1, fraction, slant).unwrap();
            assert_eq!(after.panels().len(), 5);
            assert_eq!(on_a4(&after).len(), 4);
        }
        assert_eq!(move_cut(before, 4, 0.5, 0.0).unwrap_err().code(), "invalid-layout");
        assert!(move_cut(before, 0, f64::NAN, 0.0).is_err());
        assert!(move_cut(find("mosaic-y").unwrap(), 0, 0.5, 0.0).is_err());
    }

    #[test]
    fn every_panel_of_every_tree_can_be_split_and_removed() {
        for template in catalogue().iter().filter(|t| matches!(t.body(), Body::Tree(_))) {
            let (base, all) = (template.base_count(), template.panels().len());
            for panel in 0..base {
                for axis in [Axis::Rows, Axis::Columns] {
                    let more = split_panel(template, panel, axis).unwrap();
                    assert_eq!(more.panels().len(), all + 1, "{}", template.id());
                }
                let fewer = remove_panel(template, panel);
                assert_eq!(fewer.is_ok(), base > 1, "{}", template.id());
                assert!(fewer.is_err() || fewer.unwrap().panels().len() == all - 1);
            }
            assert!(split_panel(template, base, Axis::Rows).is_err());
            assert!(remove_panel(template, all).is_err());
        }
    }

    #[test]
    fn the_panels_that_stay_keep_place_and_weight() {
        for template in catalogue().iter().filter(|t| matches!(t.body(), Body::Tree(_))) {
            for panel in 0..template.base_count() {
                let after = split_panel(template, panel, Axis::Columns).unwrap();
                let shapes = |t: &Template| t.panels().iter().map(|p| p.shape.clone()).collect::<Vec<_>>();
                let (mut left, mut stayed) = (shapes(template), shapes(&after));
                left.remove(panel);
                stayed.drain(panel..panel + 2);
                assert_eq!(left.len(), stayed.len());
                assert!(left.iter().zip(&stayed).all(|(a, b)| near(a, b)), "{} {panel}", template.id());
                let again = remove_panel(&after, panel + 1).unwrap();
                assert!(shapes(template).iter().zip(&shapes(&again)).all(|(a, b)| near(a, b)));
            }
        }
    }

    /// Shares are rounded when a tree is changed.
    fn near(a: &Shape, b: &Shape) -> bool {
        match (a, b) {
            (Shape::Polygon(a), Shape::Polygon(b)) => a.iter().zip(b).all(|(p, q)| p.distance(*q) < 1e-3),
            (a, b) => a == b,
        }
    }

    #[test]
    fn an_overlay_is_taken_away_and_the_page_below_it_stays() {
        let mut seen = 0;
        for template in catalogue().iter().filter(|t| t.panels().len() > t.base_count()) {
            let last = template.panels().len() - 1;
            let after = remove_panel(template, last).unwrap();
            assert_eq!(after.panels(), &template.panels()[..last]);
            assert_eq!((after.body(), after.family()), (template.body(), "custom"));
            assert_ne!(after.id(), template.id());
            seen += 1;
        }
        assert!(seen > 5);
    }

    /// The bounds of a panel on an A4 page, in page widths.
    fn bounds(template: &Template, panel: usize, settings: &PageSettings) -> Bounds {
        resolve(template, settings.aspect(), settings)[panel].bounds
    }

    #[test]
    fn an_overlay_moves_to_the_bounds_that_were_asked_for() {
        for settings in [PageSettings::default(), PageSettings { rtl: true, ..PageSettings::default() }] {
            let before = find("inset-corner").unwrap();
            let was = bounds(before, 1, &settings);
            let to = Bounds { x: 0.2, y: 0.3, width: was.width * 1.2, height: was.height * 0.8 };
            let after = place_overlay(before, 1, to, settings.aspect(), &settings).unwrap();
            let is = bounds(&after, 1, &settings);
            for (a, b) in [(is.x, to.x), (is.y, to.y), (is.width, to.width), (is.height, to.height)] {
                assert!((a - b).abs() < 1e-3, "{is:?} {to:?}");
            }
            assert_eq!((after.body(), after.family()), (before.body(), "custom"));
            assert_eq!(after.panels()[0], before.panels()[0]);
        }
    }

    #[test]
    fn an_overlay_stays_on_the_page_and_keeps_a_size() {
        let settings = PageSettings::default();
        let aspect = settings.aspect();
        let mut circles = 0;
        for template in catalogue().iter().filter(|t| t.panels().len() > t.base_count()) {
            let panel = template.panels().len() - 1;
            circles += usize::from(matches!(template.panels()[panel].shape, Shape::Circle { .. }));
            for (x, y, side) in [(-3.0, -3.0, 0.3), (3.0, 3.0, 0.3), (0.4, 0.4, 1e-6), (0.0, 0.0, 9.0)] {
                let to = Bounds { x, y, width: side, height: side };
                let after = place_overlay(template, panel, to, aspect, &settings).unwrap();
                let is = bounds(&after, panel, &settings);
                assert!(is.x > 0.0 && is.y > 0.0 && is.x + is.width < 1.0, "{} {is:?}", template.id());
                assert!(is.y + is.height < 1.0 / aspect && is.width > 0.03, "{} {is:?}", template.id());
            }
            assert!(place_overlay(template, 0, bounds(template, 0, &settings), aspect, &settings).is_err());
            let wrong = Bounds { x: f64::NAN, y: 0.0, width: 0.1, height: 0.1 };
            assert!(place_overlay(template, panel, wrong, aspect, &settings).is_err());
        }
        assert!(circles > 0);
    }

    #[test]
    fn removing_what_was_split_off_gives_the_page_back() {
        let before = find("rows-1-2-1").unwrap();
        let after = remove_panel(&split_panel(before, 1, Axis::Columns).unwrap(), 2).unwrap();
        assert_eq!(after.body(), before.body());
    }
}
