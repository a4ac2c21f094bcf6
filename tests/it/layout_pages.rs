//! Every template on every page size: tiling, convexity, even gutters, exact margins, overlays inside.

use inkpanel_engine::layout::polygon::{area, edges, intersection, normalised};
use inkpanel_engine::layout::{
    LEAST_THICKNESS, PRESETS, PageSettings, Point, ResolvedPanel, ResolvedShape, Shape, Template, catalogue,
    merge, resolve, score,
};

/// A tenth of a pixel of the default page, in page widths.
const TENTH_OF_A_PIXEL: f64 = 0.1 / 2480.0;

/// Calls `check` with every template, page aspect and settings of gutters and margins, sensible or not.
fn everywhere(check: impl Fn(&Template, f64, &PageSettings, &[ResolvedPanel])) {
    for template in catalogue() {
        for page in PRESETS {
            for (gutter, margin) in [(0.018, 0.027), (0.0, 0.0), (0.006, 0.06), (0.05, 0.02), (0.1, 0.2)] {
                let settings = PageSettings {
                    width: page.width,
                    height: page.height,
                    gutter,
                    margin,
                    ..PageSettings::default()
                };
                let aspect = settings.aspect();
                check(template, aspect, &settings, &resolve(template, aspect, &settings));
            }
        }
    }
}

fn polygon(panel: &ResolvedPanel) -> Option<&[Point]> {
    match &panel.shape {
        ResolvedShape::Polygon(corners) => Some(corners),
        ResolvedShape::Circle { .. } => None,
    }
}

/// Returns the smallest distance between facing edges of two polygons, or `None` if no edges face each other.
fn gap(one: &[Point], other: &[Point]) -> Option<f64> {
    let facing = edges(one).flat_map(|(a, b)| {
        let length = a.distance(b);
        let (ux, uy) = ((b.x - a.x) / length, (b.y - a.y) / length);
        edges(other).filter_map(move |(c, d)| {
            let along = |p: Point| (p.x - a.x) * ux + (p.y - a.y) * uy;
            let off = |p: Point| (p.x - a.x) * uy - (p.y - a.y) * ux;
            let shared = along(c).min(length) - along(d).max(0.0);
            let level = (off(c) - off(d)).abs() < 1e-6;
            (level && shared > 1e-3 && off(c) > -1e-9).then_some(off(c))
        })
    });
    facing.reduce(f64::min)
}

#[test]
fn base_cells_tile_the_page() {
    assert!(catalogue().len() >= 80, "only {} templates", catalogue().len());
    for template in catalogue() {
        let base = template.panels().iter().filter(|panel| !panel.overlay);
        let cells: Vec<&Vec<Point>> = base
            .map(|panel| match &panel.shape {
                Shape::Polygon(cell) => cell,
                Shape::Circle { .. } => panic!("{}: a circle cannot tile", template.id()),
            })
            .collect();
        let total: f64 = cells.iter().map(|cell| area(cell)).sum();
        assert!((total - 1.0).abs() < 1e-6, "{}: {total}", template.id());
        for (i, cell) in cells.iter().enumerate() {
            assert!(normalised(cell).is_some(), "{}: panel {i} is not convex", template.id());
            for other in &cells[..i] {
                assert!(area(&intersection(cell, other)) < 1e-6, "{}: panel {i} overlaps", template.id());
            }
        }
    }
}

#[test]
fn panels_stay_convex_and_inside_the_margins() {
    everywhere(|template, aspect, settings, panels| {
        assert_eq!(panels.len(), template.panels().len());
        // Margins are clamped to a quarter of the shorter side.
        let margin = settings.margin.min(0.25 * (1.0 / aspect).min(1.0));
        for (i, panel) in panels.iter().enumerate() {
            let name = format!("{} on {aspect:.3}, panel {i}", template.id());
            if let Some(corners) = polygon(panel) {
                assert!(normalised(corners).is_some(), "{name} is not convex");
                assert!(area(corners) > 1e-4, "{name} has vanished");
            }
            let b = panel.bounds;
            let margin = if template.panels()[i].bleeds { 0.0 } else { margin };
            let (right, bottom) = (1.0 - margin + 1e-9, 1.0 / aspect - margin + 1e-9);
            assert!(b.x >= margin - 1e-9 && b.y >= margin - 1e-9, "{name}: {b:?}");
            assert!(b.x + b.width <= right && b.y + b.height <= bottom, "{name}: {b:?}");
        }
    });
}

#[test]
fn gutters_are_even_to_a_tenth_of_a_pixel() {
    everywhere(|template, aspect, settings, panels| {
        let base: Vec<&[Point]> = panels.iter().filter(|panel| !panel.overlay).filter_map(polygon).collect();
        let gaps: Vec<f64> =
            merge::adjacent(template).into_iter().filter_map(|[i, j]| gap(base[i], base[j])).collect();
        assert!(base.len() == 1 || !gaps.is_empty(), "{}", template.id());
        let (least, most) = gaps.iter().fold((f64::INFINITY, 0.0f64), |(l, m), g| (l.min(*g), m.max(*g)));
        let name = format!("{} on {aspect:.3} with {}", template.id(), settings.gutter);
        assert!(gaps.is_empty() || most - least < TENTH_OF_A_PIXEL, "{name}: {least} to {most}");
        if settings.gutter < 0.02 && template.good_for(aspect) {
            let wanted = settings.gutter;
            assert!(gaps.iter().all(|g| (g - wanted).abs() < TENTH_OF_A_PIXEL), "{name}: {least} to {most}");
        }
    });
}

#[test]
fn the_panels_reach_the_margins_exactly() {
    let settings = PageSettings::default();
    let bleeds = |template: &Template| template.panels().iter().any(|panel| panel.bleeds);
    let good = catalogue().iter().filter(|template| template.good_for(settings.aspect()));
    for template in good.filter(|template| !bleeds(template)) {
        let panels = resolve(template, settings.aspect(), &settings);
        let all = panels.iter().filter(|panel| !panel.overlay).map(|panel| panel.bounds);
        let all = all.reduce(inkpanel_engine::layout::Bounds::union).unwrap();
        let bottom = 1.0 / settings.aspect() - all.y - all.height;
        for side in [all.x, all.y, 1.0 - all.x - all.width, bottom] {
            // A page that is cut into triangles has its sharp corners blunted by the gutters.
            assert!((side - settings.margin).abs() < 1e-9, "{}: {side}", template.id());
        }
    }
}

#[test]
fn panels_that_bleed_reach_the_edge_of_the_page_with_their_outer_edges_only() {
    let settings = PageSettings::default();
    let aspect = settings.aspect();
    let mut seen = 0;
    for template in catalogue() {
        for (panel, resolved) in template.panels().iter().zip(resolve(template, aspect, &settings)) {
            let Shape::Polygon(cell) = &panel.shape else { continue };
            let (cell, b) = (inkpanel_engine::layout::Bounds::of(cell), resolved.bounds);
            let sides = [
                (cell.x < 1e-9, b.x),
                (cell.y < 1e-9, b.y),
                (cell.x + cell.width > 1.0 - 1e-9, 1.0 - b.x - b.width),
                (cell.y + cell.height > 1.0 - 1e-9, 1.0 / aspect - b.y - b.height),
            ];
            for (_, distance) in sides.into_iter().filter(|_| panel.bleeds).filter(|(outer, _)| *outer) {
                assert!(distance.abs() < 1e-9, "{}: {distance}", template.id());
                seen += 1;
            }
            for (_, distance) in sides.into_iter().filter(|(outer, _)| !*outer) {
                assert!(distance > settings.margin + 0.5 * settings.gutter, "{}: {distance}", template.id());
            }
        }
    }
    assert!(seen > 20);
}

#[test]
fn columns_of_a_grid_stay_equal() {
    let settings = PageSettings { margin: 0.1, gutter: 0.03, ..PageSettings::default() };
    let grid = inkpanel_engine::layout::find("grid-9").unwrap();
    let widths: Vec<f64> =
        resolve(grid, settings.aspect(), &settings).iter().map(|p| p.bounds.width).collect();
    assert!(widths.iter().all(|width| (width - widths[0]).abs() < 1e-12), "{widths:?}");
}

#[test]
fn offered_templates_have_no_thin_panel_and_every_page_has_a_choice() {
    for page in PRESETS {
        let settings = PageSettings { width: page.width, height: page.height, ..PageSettings::default() };
        let offered = || catalogue().iter().filter(|template| template.good_for(settings.aspect()));
        assert!(offered().count() >= 40, "{}: {} templates", page.name, offered().count());
        for template in offered() {
            for panel in resolve(template, settings.aspect(), &settings) {
                let thinnest = panel.bounds.width.min(panel.bounds.height);
                let least = LEAST_THICKNESS - settings.margin - settings.gutter;
                assert!(thinnest > least, "{} on {}: {thinnest}", template.id(), page.name);
            }
        }
    }
    let on_a4 = catalogue().iter().filter(|template| template.good_for(210.0 / 297.0)).count();
    assert!(on_a4 >= 80, "{on_a4} templates on A4");
}

#[test]
fn no_template_is_there_twice() {
    let corners = |template: &Template| -> Vec<Point> {
        let panels = template.panels().iter();
        let outline = |shape: &Shape| match shape {
            Shape::Polygon(corners) => corners.clone(),
            Shape::Circle { center, radius } => vec![*center, Point::new(*radius, *radius)],
        };
        panels.flat_map(|panel| outline(&panel.shape)).collect()
    };
    for (i, template) in catalogue().iter().enumerate() {
        for other in &catalogue()[..i] {
            let (a, b) = (corners(template), corners(other));
            let bleeds = |template: &Template| -> Vec<bool> {
                template.panels().iter().map(|panel| panel.bleeds).collect()
            };
            if a.len() == b.len() && bleeds(template) == bleeds(other) {
                let most = a.iter().zip(&b).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
                assert!(most > 0.03, "{} is {} again", template.id(), other.id());
            }
        }
    }
}

#[test]
fn the_reading_order_goes_down_the_page() {
    for template in catalogue() {
        let tops: Vec<(f64, f64)> = template
            .panels()
            .iter()
            .filter(|panel| !panel.overlay)
            .filter_map(|panel| match &panel.shape {
                Shape::Polygon(cell) => Some(inkpanel_engine::layout::Bounds::of(cell)),
                Shape::Circle { .. } => None,
            })
            .map(|b| (b.y + b.height / 2.0, b.x + b.width / 2.0))
            .collect();
        for pair in tops.windows(2) {
            let ((y, x), (next_y, next_x)) = (pair[0], pair[1]);
            // The next panel is further down or further right; never up and to the left.
            assert!(next_y > y - 1e-9 || next_x > x - 1e-9, "{}: {pair:?}", template.id());
        }
    }
}

#[test]
fn the_heaviest_panel_is_no_small_one() {
    for template in catalogue() {
        let areas: Vec<f64> = template
            .panels()
            .iter()
            .map(|panel| match &panel.shape {
                Shape::Polygon(cell) => area(cell),
                Shape::Circle { radius, .. } => std::f64::consts::PI * radius * radius * template.aspect(),
            })
            .collect();
        let heaviest = template.panels().iter().map(|panel| panel.weight).fold(0.0, f32::max);
        let at = template.panels().iter().position(|panel| panel.weight >= heaviest).unwrap();
        let mut sorted = areas.clone();
        sorted.sort_by(f64::total_cmp);
        let median = sorted[sorted.len() / 2];
        assert!(template.panels()[at].overlay || areas[at] > median * 0.85, "{}", template.id());
    }
}

#[test]
fn files_survive_reading_and_writing() {
    for template in catalogue() {
        let again = Template::parse("again.json", &template.to_json()).unwrap();
        assert_eq!(&again, template);
        assert!(score(template, template.aspect()) > 0.0);
    }
}
