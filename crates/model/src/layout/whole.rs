//! Layouts that show photos whole: a split tree whose panels have the aspect ratios of the photos.
//!
//! The aspect ratio of a tree follows from the aspect ratios of its photos (Atkins, "Blocked Recursive Image
//! Composition", ACM Multimedia 2008). With gutters, the height of each cell is a linear function of its width. Simulated
//! annealing over the trees looks for one that fills the page and gives each photo its share of the area.
//!
//! A tree is one divider per pair of neighbouring photos, with an axis and a rank. The divider of the highest rank divides the
//! page, and so on (a Cartesian tree). So the photos stay in reading order.

use oorandom::Rand64;

use super::parse::{DEEPEST, LEAST_STEP, MOST_PANELS};
use super::polygon::Point;
use super::resolve::Page;
use super::settings::PageSettings;
use super::template::{Body, Template, WHOLE};
use super::tree::{Axis, Node, Split};

/// Trees that are tried, and the number of starts among them: for any number of photos, and more by the photo for few photos,
/// whose trees take less time.
const TRIED: [usize; 2] = [3600, 40_000];
const STARTS: [usize; 2] = [2, 24];
/// Temperature of the annealing at the beginning, and at the end of each start.
const HEAT: [f64; 2] = [0.3, 0.003];
/// Share of the page that counts as full, and the cost of a smaller share.
const FILLED: f64 = 0.98;
const EMPTY: f64 = 40.0;
/// Weight of the area of a starred photo, compared with all others together.
const SPECIAL: f64 = 1.0;
/// Part of the page that a tree may lack to be stretched to the whole page. Photos lose as much at their edges.
const STRETCHED: f64 = 0.01;
/// Maximum slant of a divider, as a share of the narrowest cell next to it. A slant hides corners of photos.
const SLANT: f64 = 0.05;
/// Probability of a swap of two photos, if their order is free.
const SWAPPED: f64 = 0.3;

/// A photo for a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whole {
    /// Width over height.
    pub aspect: f64,
    /// Wanted area, relative to the other photos.
    pub share: f64,
}

/// Returns a template with one panel per photo, and the index of the photo of each panel. The photos stay in reading order
/// unless it is `free`.
///
/// The panels have the aspect ratios of the photos, or at most one percent more or less, if no divider is slanted. `slants` are
/// given to the largest dividers. `None` without photos, with too many, or if the page has no room for the gutters.
#[must_use]
pub fn whole(
    photos: &[Whole],
    free: bool,
    page_aspect: f64,
    settings: &PageSettings,
    (slants, seed): (&[f64], u32),
) -> Option<(Template, Vec<usize>)> {
    if photos.is_empty() || photos.len() > MOST_PANELS {
        return None;
    }
    let page = Page::new(page_aspect, settings);
    let (width, height, gutter) = page.room();
    let sound = photos.iter().map(|photo| Whole {
        aspect: if photo.aspect.is_finite() { photo.aspect.clamp(0.05, 20.0) } else { 1.0 },
        share: if photo.share.is_finite() { photo.share.clamp(0.1, 10.0) } else { 1.0 },
    });
    let order = (0..photos.len()).collect();
    let mut search = Search { photos: sound.collect(), order, width, height, gutter, cells: Vec::new() };
    let tree = search.best(free, &mut Rand64::new(u128::from(seed) ^ 0x0077_686f_6c65))?;
    search.cost(&tree)?;
    let (used_width, used_height) = search.used();
    let mut slants = slants.iter().copied().filter(|slant| slant.is_finite() && *slant != 0.0);
    let node = search.node(&mut slants);
    let hash = node.fingerprint();
    let part = |used: f64, room: f64| (used + gutter) / (room + gutter);
    let (across, down) = (part(used_width, width), part(used_height, height));
    let body = if across.min(down) >= 1.0 - STRETCHED {
        Body::Tree(node)
    } else {
        let (left, top) = ((1.0 - across) / 2.0, (1.0 - down) / 2.0);
        let quad = [(left, top), (left + across, top), (left + across, top + down), (left, top + down)]
            .map(|(x, y)| Point::new(x.clamp(0.0, 1.0), y.clamp(0.0, 1.0)));
        Body::Polygons(node.cells(&quad).iter().map(|cell| cell.to_vec()).collect())
    };
    let (id, name) = (format!("{WHOLE}{hash}"), format!("Whole photos {}", &hash[4..]));
    let template = Template::assemble(&id, &name, "generated", page_aspect.clamp(0.1, 10.0), body);
    Some((template, search.order))
}

/// A divider between two neighbouring photos.
#[derive(Debug, Clone, Copy)]
struct Divider {
    columns: bool,
    rank: f64,
}

/// A node of the tree. Its height is `slope * width + base`.
#[derive(Debug, Clone, Copy)]
struct Cell {
    slope: f64,
    base: f64,
    /// Axis and children; `None` for the photo of this index.
    inner: Result<(bool, usize, usize), usize>,
    width: f64,
    height: f64,
}

struct Search {
    photos: Vec<Whole>,
    /// The photo of each panel.
    order: Vec<usize>,
    /// The room for panels, and the gutter, in page widths.
    width: f64,
    height: f64,
    gutter: f64,
    /// The nodes of the last tree, the root last.
    cells: Vec<Cell>,
}

impl Search {
    /// The tree of the lowest cost. Sets the order of the photos, which changes if it is `free`. `None` if the page has no
    /// room for any.
    fn best(&mut self, free: bool, random: &mut Rand64) -> Option<Vec<Divider>> {
        let count = self.photos.len() - 1;
        let mut best: Option<(f64, Vec<Divider>, Vec<usize>)> = None;
        let [tried, starts] = [TRIED, STARTS].map(|[least, more]| least + more / self.photos.len());
        for _ in 0..starts {
            let mut tree = vec![Divider { columns: false, rank: 0.0 }; count];
            self.divide(&mut tree, 0, (self.width, self.height), 0.0, random);
            let mut cost = self.cost(&tree).unwrap_or(f64::INFINITY);
            let steps = if count == 0 { 1 } else { tried / starts };
            for step in 0..steps {
                if best.as_ref().is_none_or(|(least, ..)| cost < *least) && cost.is_finite() {
                    best = Some((cost, tree.clone(), self.order.clone()));
                }
                if count == 0 {
                    break;
                }
                let heat = HEAT[0] * (HEAT[1] / HEAT[0]).powf(step as f64 / steps as f64);
                let mut place = |end: usize| random.rand_range(0..end as u64) as usize;
                let (one, other) = (place(count), place(count));
                let (first, second) = (place(count + 1), place(count + 1));
                let before = (tree[one], tree[other]);
                let swaps = free && random.rand_float() < SWAPPED;
                if swaps {
                    self.order.swap(first, second);
                } else if one == other || random.rand_float() < 0.4 {
                    tree[one].columns = !tree[one].columns;
                } else {
                    (tree[one], tree[other]) = (before.1, before.0);
                    if random.rand_float() < 0.5 {
                        tree[one].columns = !tree[one].columns;
                    }
                }
                let next = self.cost(&tree).unwrap_or(f64::INFINITY);
                if next <= cost || random.rand_float() < ((cost - next) / heat).exp() {
                    cost = next;
                } else if swaps {
                    self.order.swap(first, second);
                } else {
                    (tree[one], tree[other]) = before;
                }
            }
        }
        let (_, tree, order) = best?;
        self.order = order;
        Some(tree)
    }

    /// Divides a cell near the middle of its area, across its longer side.
    fn divide(
        &self,
        tree: &mut [Divider],
        first: usize,
        (width, height): (f64, f64),
        depth: f64,
        random: &mut Rand64,
    ) {
        let count = tree.len() + 1;
        if count < 2 {
            return;
        }
        let share = |from: usize, to: usize| -> f64 {
            self.order[first + from..first + to].iter().map(|&photo| self.photos[photo].share).sum()
        };
        let wanted = share(0, count) * (0.3 + 0.4 * random.rand_float());
        let at = (1..count).find(|&at| share(0, at) >= wanted).unwrap_or(count - 1);
        let columns = if random.rand_float() < 0.2 { width < height } else { width >= height };
        tree[at - 1] = Divider { columns, rank: -depth - 0.5 * random.rand_float() };
        let part = share(0, at) / share(0, count);
        let side = |part: f64| if columns { (width * part, height) } else { (width, height * part) };
        let (left, right) = tree.split_at_mut(at - 1);
        self.divide(left, first, side(part), depth + 1.0, random);
        self.divide(&mut right[1..], first + at, side(1.0 - part), depth + 1.0, random);
    }

    /// Cost of a tree, whose cells are stored. `None` if a cell has no room, or is too small for a layout file.
    fn cost(&mut self, tree: &[Divider]) -> Option<f64> {
        self.cells.clear();
        let root = self.grown(tree, 0, (None, 0))?;
        let Cell { slope, base, .. } = self.cells[root];
        let tall = slope * self.width + base;
        let size = if tall <= self.height {
            (self.width, tall)
        } else {
            ((self.height - base) / slope, self.height)
        };
        self.spread(root, size)?;
        let filled = size.0 * size.1 / (self.width * self.height);
        let leaves = || {
            self.cells
                .iter()
                .filter_map(|cell| cell.inner.err().map(|photo| (photo, cell.width * cell.height)))
        };
        let shares: f64 = self.photos.iter().map(|photo| photo.share).sum();
        let mean = leaves().map(|(_, area)| area).sum::<f64>() / shares;
        let (mut all, mut special) = (0.0, 0.0);
        for (photo, area) in leaves() {
            let share = self.photos[photo].share;
            let off = (area / (share * mean)).ln().powi(2);
            if (share - 1.0).abs() > 0.01 { special += off } else { all += off }
        }
        let uneven = all / self.photos.len() as f64 + SPECIAL * special;
        Some(uneven + EMPTY * (FILLED - filled).max(0.0))
    }

    /// Adds the cells of a part of the tree, from the photo `first`. Returns the index of their root.
    fn grown(
        &mut self,
        tree: &[Divider],
        first: usize,
        (axis, depth): (Option<bool>, usize),
    ) -> Option<usize> {
        let top = (0..tree.len()).max_by(|&a, &b| tree[a].rank.total_cmp(&tree[b].rank));
        let Some(top) = top else {
            let photo = self.order[first];
            let slope = 1.0 / self.photos[photo].aspect;
            self.cells.push(Cell { slope, base: 0.0, inner: Err(photo), width: 0.0, height: 0.0 });
            return Some(self.cells.len() - 1);
        };
        let columns = tree[top].columns;
        // Neighbours along one axis are one level of a layout file.
        let depth = if axis == Some(columns) { depth } else { depth + 1 };
        if depth > DEEPEST {
            return None;
        }
        let one = self.grown(&tree[..top], first, (Some(columns), depth))?;
        let other = self.grown(&tree[top + 1..], first + top + 1, (Some(columns), depth))?;
        let (a, b) = (self.cells[one], self.cells[other]);
        let (slope, base) = if columns {
            let slope = 1.0 / (1.0 / a.slope + 1.0 / b.slope);
            (slope, slope * (a.base / a.slope + b.base / b.slope - self.gutter))
        } else {
            (a.slope + b.slope, a.base + b.base + self.gutter)
        };
        self.cells.push(Cell { slope, base, inner: Ok((columns, one, other)), width: 0.0, height: 0.0 });
        Some(self.cells.len() - 1)
    }

    /// Sets the sizes of a cell and of all cells in it. `None` if one is not large enough.
    fn spread(&mut self, at: usize, (width, height): (f64, f64)) -> Option<()> {
        (self.cells[at].width, self.cells[at].height) = (width, height);
        let Ok((columns, one, other)) = self.cells[at].inner else {
            return (width > 0.0 && height > 0.0).then_some(());
        };
        for child in [one, other] {
            let Cell { slope, base, .. } = self.cells[child];
            let size =
                if columns { ((height - base) / slope, height) } else { (width, slope * width + base) };
            let (part, whole) = if columns { (size.0, width) } else { (size.1, height) };
            if part + self.gutter < 1.5 * LEAST_STEP * (whole + self.gutter) {
                return None;
            }
            self.spread(child, size)?;
        }
        Some(())
    }

    /// The size of the tree that was rated last.
    fn used(&self) -> (f64, f64) {
        self.cells.last().map_or((0.0, 0.0), |root| (root.width, root.height))
    }

    /// The tree that was rated last as a node of a layout file.
    fn node(&self, slants: &mut impl Iterator<Item = f64>) -> Node {
        self.node_of(self.cells.len() - 1, slants)
    }

    fn node_of(&self, at: usize, slants: &mut impl Iterator<Item = f64>) -> Node {
        let Ok((columns, ..)) = self.cells[at].inner else { return Node::Panel };
        let mut children = Vec::new();
        self.along(at, columns, &mut children);
        let length = |&child: &usize| {
            let Cell { width, height, .. } = self.cells[child];
            self.gutter + if columns { width } else { height }
        };
        let lengths: Vec<f64> = children.iter().map(length).collect();
        let whole: f64 = lengths.iter().sum();
        let shares: Vec<f64> = lengths.iter().map(|length| length / whole).collect();
        let narrowest = shares.iter().copied().fold(1.0, f64::min);
        let most = SLANT * narrowest;
        let slants_here =
            (1..children.len()).map(|_| slants.next().map_or(0.0, |slant| slant.clamp(-most, most)));
        Node::Split(Split {
            axis: if columns { Axis::Columns } else { Axis::Rows },
            slants: slants_here.collect(),
            children: children.into_iter().map(|child| self.node_of(child, slants)).collect(),
            shares,
        })
    }

    /// Collects the cells along one axis.
    fn along(&self, at: usize, columns: bool, out: &mut Vec<usize>) {
        match self.cells[at].inner {
            Ok((axis, one, other)) if axis == columns => {
                self.along(one, columns, out);
                self.along(other, columns, out);
            }
            _ => out.push(at),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::polygon::area;
    use crate::layout::{ResolvedShape, resolve};

    const ASPECTS: [f64; 7] = [1.5, 0.667, 1.333, 1.0, 1.778, 0.75, 0.5625];

    fn photos(count: usize, seed: usize, starred: Option<usize>) -> Vec<Whole> {
        let aspect = |i: usize| ASPECTS[(i * 5 + seed * 3 + i * i * (seed + 1)) % ASPECTS.len()];
        let share = |i: usize| if starred == Some(i) { 2.0 } else { 1.0 };
        (0..count).map(|i| Whole { aspect: aspect(i), share: share(i) }).collect()
    }

    fn a4() -> PageSettings {
        PageSettings::default()
    }

    /// The part of the page inside the margins, without gutters, that the panels use, and their aspect ratios.
    fn used(template: &Template, settings: &PageSettings) -> (f64, Vec<f64>) {
        let panels = resolve(template, settings.aspect(), settings);
        let bounds = panels.iter().map(|panel| panel.bounds).reduce(crate::layout::Bounds::union).unwrap();
        let room = (1.0 - 2.0 * settings.margin) * (1.0 / settings.aspect() - 2.0 * settings.margin);
        (bounds.width * bounds.height / room, panels.iter().map(|panel| panel.bounds.aspect()).collect())
    }

    #[test]
    fn photos_are_whole_and_fill_the_page() {
        let settings = a4();
        for (free, least) in [(true, 6), (false, 10)] {
            for count in least..=40 {
                for seed in 0..3 {
                    let photos = photos(count, seed, None);
                    let made = whole(&photos, free, settings.aspect(), &settings, (&[], seed as u32));
                    let (template, order) = made.unwrap();
                    let again = Template::parse("whole", &template.to_json()).unwrap();
                    let (filled, aspects) = used(&again, &settings);
                    let told = format!("{count} photos, free {free}, seed {seed}");
                    assert!(filled >= 0.97, "{told}: {filled:.3}");
                    for (&photo, aspect) in order.iter().zip(aspects) {
                        let off = aspect / photos[photo].aspect;
                        assert!((0.985..1.015).contains(&off), "{told}: {off}");
                    }
                    let mut sorted = order.clone();
                    sorted.sort_unstable();
                    assert!(sorted.iter().copied().eq(0..count), "{told}: {order:?}");
                    assert!(free || order == sorted, "{told}: {order:?}");
                }
            }
        }
    }

    #[test]
    fn a_starred_photo_gets_about_twice_the_area() {
        let settings = a4();
        let mut ratios = Vec::new();
        for count in [10, 12, 24, 40] {
            for seed in 0..4 {
                let starred = (seed * 3) % count;
                let photos = photos(count, seed, Some(starred));
                let made = whole(&photos, true, settings.aspect(), &settings, (&[], seed as u32));
                let (template, order) = made.unwrap();
                let panels = resolve(&template, settings.aspect(), &settings);
                let area = |panel: usize| panels[panel].bounds.width * panels[panel].bounds.height;
                let own = area(order.iter().position(|&photo| photo == starred).unwrap());
                let others = ((0..count).map(area).sum::<f64>() - own) / (count - 1) as f64;
                assert!(
                    (1.1..3.2).contains(&(own / others)),
                    "{count} photos, seed {seed}: {}",
                    own / others
                );
                ratios.push(own / others);
            }
        }
        let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
        assert!((1.7..2.3).contains(&mean), "{mean}");
    }

    #[test]
    fn slants_stay_and_few_photos_leave_paper() {
        let settings = a4();
        let made = whole(&photos(7, 1, None), true, settings.aspect(), &settings, (&[0.1, -0.2], 5));
        let (template, _) = made.unwrap();
        assert!(template.is_lively(), "{}", template.to_json());
        assert!(Template::parse("whole", &template.to_json()).is_ok());
        // A wide photo cannot fill an upright page.
        let wide = [Whole { aspect: 1.5, share: 1.0 }];
        let (one, _) = whole(&wide, true, settings.aspect(), &settings, (&[], 1)).unwrap();
        let again = Template::parse("whole", &one.to_json()).unwrap();
        let panels = resolve(&again, settings.aspect(), &settings);
        assert!((panels[0].bounds.aspect() - 1.5).abs() < 1e-6);
        let ResolvedShape::Polygon(corners) = &panels[0].shape else { panic!() };
        assert!((corners[0].x - settings.margin).abs() < 1e-9 && area(corners) > 0.0);
    }

    #[test]
    fn odd_wishes_have_an_answer() {
        assert!(whole(&[], true, 0.7, &a4(), (&[], 1)).is_none());
        assert!(whole(&photos(41, 0, None), true, 0.7, &a4(), (&[], 1)).is_none());
        let odd = [0.0, f64::NAN, 1e9, -3.0, f64::INFINITY].map(|aspect| Whole { aspect, share: f64::NAN });
        let wide = PageSettings { gutter: 0.1, margin: 0.2, ..a4() };
        for settings in [a4(), wide] {
            if let Some((template, _)) = whole(&odd, false, settings.aspect(), &settings, (&[f64::NAN], 3)) {
                assert!(Template::parse("whole", &template.to_json()).is_ok(), "{}", template.to_json());
            }
        }
        let again = || whole(&photos(9, 2, None), true, 0.7, &a4(), (&[], 8));
        assert_eq!(again(), again());
    }
}
