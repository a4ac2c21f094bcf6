//! New templates by recursive subdivision.
//!
//! The page is divided across its longer side near the middle, then each half again, until cells are small
//! enough. This is the oriented-box subdivision of Vanegas et al., "Procedural Generation of Parcels in Urban
//! Modeling" (2012). Many trees are generated. Trees that break a rule are dropped, and the most pleasing of
//! the rest is used.

use std::ops::RangeInclusive;

use oorandom::Rand64;

use super::aesthetics::score;
use super::parse::MOST_PANELS;
use super::polygon::{Bounds, area};
use super::template::{Body, Template};
use super::tree::{Axis, Node, PAGE, Quad, Split};

/// Maximum distance of a divider from the middle of its cell.
const OFF_MIDDLE: f64 = 0.18;
/// The chance that a page has slants, and then that a cut of its first two levels is slanted.
const SLANTED: f64 = 0.35;
const SLANTED_CUT: f64 = 0.7;
/// Probability that a cell is not divided further, if its size allows it.
const STAYS: f64 = 0.45;
/// Minimum area of a cell relative to an even share, and maximum area of a cell that is not divided.
const AREAS: RangeInclusive<f64> = 0.36..=1.8;
/// Number of trees grown for one template, and number of good ones to choose from.
const GROWN: usize = 400;
const CHOICE: usize = 16;

/// A template for a page of that aspect (width over height) with a number of panels in the range, which is
/// brought inside 1..=40. The same arguments give the same template. All templates are good for their page
/// (see [`Template::good_for`]) if the page has enough space for the panels.
#[must_use]
pub fn generate(seed: u64, aspect: f64, panels: RangeInclusive<usize>) -> Template {
    let aspect = if aspect.is_finite() { aspect.clamp(0.1, 10.0) } else { 1.0 };
    let least = (*panels.start()).clamp(1, MOST_PANELS);
    let most = (*panels.end()).clamp(least, MOST_PANELS);
    let mut random = Rand64::new(u128::from(seed) ^ 0x6765_6e65_7261_7465);
    // Decided once, or the calmer pages without slants would always win.
    let slants = random.rand_float() < SLANTED;
    let mut best: Option<(f64, Template)> = None;
    let mut good = 0;
    for _ in 0..GROWN {
        let wanted = random.rand_range(least as u64..most as u64 + 1) as usize;
        let node = Growth { random: &mut random, aspect, wanted, slants }.cell(&PAGE, 0);
        let count = node.count();
        if !(least..=most).contains(&count) || !clear(&node, &PAGE, aspect) {
            continue;
        }
        let template = template(node, aspect);
        if !template.good_for(aspect) {
            continue;
        }
        let score = score(&template, aspect);
        if best.as_ref().is_none_or(|(most, _)| score > *most) {
            best = Some((score, template));
        }
        good += 1;
        if good == CHOICE {
            break;
        }
    }
    best.map_or_else(|| template(even(least, aspect), aspect), |(_, template)| template)
}

struct Growth<'a> {
    random: &'a mut Rand64,
    aspect: f64,
    wanted: usize,
    slants: bool,
}

impl Growth<'_> {
    fn cell(&mut self, cell: &Quad, depth: usize) -> Node {
        let part = area(cell) * self.wanted as f64;
        let (width, height) = extent(cell, self.aspect);
        let small = part < AREAS.start() * 2.0;
        let may_stay = part < *AREAS.end() && width.max(height) < 2.6 * width.min(height);
        if self.wanted == 1 || small || (may_stay && self.random.rand_float() < STAYS) || depth > 8 {
            return Node::Panel;
        }
        // Nearly square cells are sometimes divided along the other axis, for variety.
        let square = width.max(height) < 1.4 * width.min(height);
        let turned = square && self.random.rand_float() < 0.35;
        let axis = if (height > width) == turned { Axis::Columns } else { Axis::Rows };
        let first = 0.5 + (self.random.rand_float() * 2.0 - 1.0) * OFF_MIDDLE;
        let slant = if self.slants && depth < 2 && self.random.rand_float() < SLANTED_CUT {
            let size = 0.06 + 0.12 * self.random.rand_float();
            if self.random.rand_float() < 0.5 { size } else { -size }
        } else {
            0.0
        };
        let mut split = Split {
            axis,
            shares: vec![round(first), round(1.0 - first)],
            slants: vec![round(slant)],
            children: vec![Node::Panel, Node::Panel],
        };
        let cells = split.cells(cell);
        split.children = cells.iter().map(|cell| self.cell(cell, depth + 1)).collect();
        Node::Split(split)
    }
}

/// Three digits are finer than a printed dot at the width of a hand, and keep files readable.
fn round(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// Mean width and height of a cell in page widths.
fn extent(cell: &Quad, aspect: f64) -> (f64, f64) {
    let [a, b, c, d] = cell.map(|p| super::Point::new(p.x, p.y / aspect));
    (f64::midpoint(a.distance(b), d.distance(c)), f64::midpoint(a.distance(d), b.distance(c)))
}

/// No panel drawn out to more than three times its breadth.
fn clear(node: &Node, page: &Quad, aspect: f64) -> bool {
    node.cells(page).iter().all(|cell| {
        let cell = cell.map(|p| super::Point::new(p.x, p.y / aspect));
        (1.0 / 3.0..=3.0).contains(&Bounds::of(&cell).aspect())
    })
}

/// Rows with almost equal numbers of panels, if random attempts find nothing.
fn even(count: usize, aspect: f64) -> Node {
    let rows = ((count as f64 / aspect).sqrt().round() as usize).clamp(1, count);
    let split = |axis, children: Vec<Node>| match children.len() {
        1 => children.into_iter().next().unwrap_or(Node::Panel),
        n => Node::Split(Split { axis, shares: vec![1.0; n], slants: vec![0.0; n - 1], children }),
    };
    let row = |i: usize| {
        let panels = (i + 1) * count / rows - i * count / rows;
        split(Axis::Columns, vec![Node::Panel; panels])
    };
    split(Axis::Rows, (0..rows).map(row).collect())
}

/// The tree as a template named after itself: equal trees have equal names.
fn template(node: Node, aspect: f64) -> Template {
    let hash = node.fingerprint();
    let (id, name) = (format!("generated-{hash}"), format!("Surprise {}", &hash[4..]));
    Template::assemble(&id, &name, "generated", round(aspect).max(0.1), Body::Tree(node))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::settings::PRESETS;

    #[test]
    fn thousands_of_seeds_give_valid_templates() {
        for seed in 0..3000u64 {
            let page = PRESETS[seed as usize % PRESETS.len()];
            let aspect = f64::from(page.width) / f64::from(page.height);
            let range = match seed % 4 {
                0 => 3..=6,
                1 => 5..=5,
                2 => 2..=9,
                _ => 7..=8,
            };
            let template = generate(seed, aspect, range.clone());
            assert!(range.contains(&template.panels().len()), "seed {seed}");
            assert!(template.good_for(aspect), "seed {seed}: {}", template.to_json());
            let again = Template::parse("again", &template.to_json()).unwrap();
            assert_eq!(again, template);
            assert_eq!(generate(seed, aspect, range), template);
        }
    }

    #[test]
    fn seeds_differ() {
        let mut ids: Vec<String> = (0..200).map(|seed| generate(seed, 0.707, 3..=8).id().into()).collect();
        ids.sort();
        ids.dedup();
        assert!(ids.len() > 195, "{} different ones of 200", ids.len());
    }

    #[test]
    fn any_request_has_an_answer() {
        let requests =
            [(0.7, 1..=1), (0.7, 0..=0), (1.0, 40..=40), (0.1, 30..=1000), (f64::NAN, 3..=4), (9.0, 25..=25)];
        for (aspect, range) in requests {
            let template = generate(7, aspect, range.clone());
            let least = (*range.start()).clamp(1, MOST_PANELS);
            assert!(template.panels().len() >= least && template.panels().len() <= MOST_PANELS);
            assert!(Template::parse("t", &template.to_json()).is_ok());
        }
    }
}
