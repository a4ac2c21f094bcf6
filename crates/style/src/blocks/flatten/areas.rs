//! Labels of pixels made into areas, and areas into pixels.

use super::STEP;
use super::palette::Costs;
use crate::raster::sets::Sets;
use crate::raster::{Image, Plane};

/// Rounds in which pixels adopt the area of their neighbours.
const ROUNDS: usize = 3;

/// Cost of a neighbour that differs at full smoothness, in units of the costs.
const PULL: f32 = 420.0;

/// Marks the margin around the picture, which has no labels.
const OUTSIDE: u8 = u8::MAX;

/// Iterated conditional modes: every pixel takes the label whose distance, less what equal neighbours are worth, is least.
pub(super) fn settle(
    labels: &mut [u8],
    (width, height): (usize, usize),
    photo: &Image,
    costs: &Costs,
    smoothness: f32,
) {
    let pull = (PULL * smoothness) as i32;
    let [r, g, b] = photo.planes() else { return };
    if pull == 0 {
        return;
    }
    let stride = width + 2;
    let mut framed = vec![OUTSIDE; stride * (height + 2)];
    for (row, own) in framed.chunks_exact_mut(stride).skip(1).zip(labels.chunks_exact(width)) {
        row[1..=width].copy_from_slice(own);
    }
    for _ in 0..ROUNDS {
        for y in 0..height {
            for x in 0..width {
                let here = (y + 1) * stride + x + 1;
                let three = |at: usize| [framed[at - 1], framed[at], framed[at + 1]];
                let ([a, b0, c], [d, own, e], [f, g0, h]) =
                    (three(here - stride), three(here), three(here + stride));
                let around = [a, b0, c, d, e, f, g0, h];
                if around == [own; 8] {
                    continue;
                }
                let at = y * width + x;
                let costs = costs.of([r.samples()[at], g.samples()[at], b.samples()[at]]);
                let energy = |label: u8| {
                    let equal: i32 = around.iter().map(|&other| i32::from(other == label)).sum();
                    i32::from(costs[usize::from(label)]) - pull * equal
                };
                let mut best = (energy(own), own);
                for &label in around.iter().filter(|&&label| label != OUTSIDE) {
                    let other = energy(label);
                    if other < best.0 {
                        best = (other, label);
                    }
                }
                framed[here] = best.1;
            }
        }
    }
    for (row, own) in framed.chunks_exact(stride).skip(1).zip(labels.chunks_exact_mut(width)) {
        own.copy_from_slice(&row[1..=width]);
    }
}

/// For every pixel, the number of the area that it belongs to.
pub(super) struct Areas {
    pub(super) numbers: Vec<u32>,
    pub(super) count: usize,
}

/// Areas of equal labels. Areas of fewer than `least` pixels have joined the neighbour with the longest
/// common border. Updates the labels accordingly.
pub(super) fn merge_small(labels: &mut [u8], (width, height): (usize, usize), least: usize) -> Areas {
    // Small areas join their neighbours. Several rounds, because small areas can be adjacent.
    for _ in 0..4 {
        let areas = connect(labels, (width, height));
        let mut sizes = vec![0usize; areas.count];
        for &number in &areas.numbers {
            sizes[number as usize] += 1;
        }
        if least < 2 || sizes.iter().all(|&size| size >= least) {
            return areas;
        }
        let mut borders: Vec<(u32, u32)> = Vec::new();
        let mut meet = |a: usize, b: usize| {
            let (a, b) = (areas.numbers[a], areas.numbers[b]);
            if a != b {
                if sizes[a as usize] < least {
                    borders.push((a, b));
                }
                if sizes[b as usize] < least {
                    borders.push((b, a));
                }
            }
        };
        for y in 0..height {
            for x in 0..width {
                let here = y * width + x;
                if x + 1 < width {
                    meet(here, here + 1);
                }
                if y + 1 < height {
                    meet(here, here + width);
                }
            }
        }
        borders.sort_unstable();
        let mut into: Vec<u32> = (0..areas.count as u32).collect();
        let mut longest = vec![0usize; areas.count];
        for run in borders.chunk_by(|a, b| a == b) {
            let (small, other) = run[0];
            // Large neighbours are preferred to small ones, which will disappear.
            let length = run.len() * if sizes[other as usize] >= least { 4 } else { 1 };
            if length > longest[small as usize] {
                longest[small as usize] = length;
                into[small as usize] = other;
            }
        }
        let mut label_of = vec![0u8; areas.count];
        for (&number, &label) in areas.numbers.iter().zip(labels.iter()) {
            label_of[number as usize] = label;
        }
        for (label, &number) in labels.iter_mut().zip(&areas.numbers) {
            *label = label_of[into[number as usize] as usize];
        }
    }
    connect(labels, (width, height))
}

/// Areas of equal labels, by their four neighbours.
fn connect(labels: &[u8], (width, height): (usize, usize)) -> Areas {
    let mut sets = Sets::default();
    let mut numbers = vec![0u32; labels.len()];
    for y in 0..height {
        for x in 0..width {
            let here = y * width + x;
            let left = (x > 0 && labels[here - 1] == labels[here]).then(|| numbers[here - 1]);
            let above = (y > 0 && labels[here - width] == labels[here]).then(|| numbers[here - width]);
            numbers[here] = match (left, above) {
                (Some(left), Some(above)) if left != above => sets.join(left, above),
                (Some(number), _) | (None, Some(number)) => number,
                (None, None) => sets.add(),
            };
        }
    }
    let mut names = vec![u32::MAX; sets.len()];
    let mut count = 0;
    for number in &mut numbers {
        let root = sets.root(*number) as usize;
        if names[root] == u32::MAX {
            names[root] = count;
            count += 1;
        }
        *number = names[root];
    }
    Areas { numbers, count: count as usize }
}

/// The colour of each area: the palette's colour, mixed with the requested share of the area's mean.
pub(super) fn colors(
    areas: &Areas,
    labels: &[u8],
    photo: &Image,
    palette: &[[u8; 3]],
    own: f32,
) -> Vec<[u8; 3]> {
    let mut sums = vec![([0u64; 3], 0u64); areas.count];
    let mut label_of = vec![0u8; areas.count];
    let [r, g, b] = photo.planes() else { return Vec::new() };
    for (i, &number) in areas.numbers.iter().enumerate() {
        label_of[number as usize] = labels[i];
        let (sum, count) = &mut sums[number as usize];
        for (sum, plane) in sum.iter_mut().zip([r, g, b]) {
            *sum += u64::from(plane.samples()[i]);
        }
        *count += 1;
    }
    sums.iter()
        .zip(&label_of)
        .map(|((sum, count), &label)| {
            let named = palette[usize::from(label)];
            std::array::from_fn(|c| {
                let mean = sum[c] as f32 / (*count).max(1) as f32;
                (f32::from(named[c]) + own * (mean - f32::from(named[c])) + 0.5) as u8
            })
        })
        .collect()
}

/// Paints the areas at twice the resolution: inside of one its colour, at a border the areas around by a Gaussian of
/// `sigma` pixels of half the resolution, one pixel soft. A single plane takes luma.
pub(super) fn paint(
    areas: &Areas,
    (width, height): (usize, usize),
    colors: &[[u8; 3]],
    sigma: f32,
    planes: &mut [Plane],
) {
    let (full_width, full_height) = (planes[0].width(), planes[0].height());
    let reach = (2.0 * sigma).ceil() as isize;
    let border = borders(areas, (width, height), reach as usize);
    // The weights of each place around a square for the four pixels of the square.
    let weights: Vec<[f32; CORNERS]> = (-reach..=reach)
        .flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)))
        .map(|(dx, dy)| {
            std::array::from_fn(|corner| {
                let centre = |odd: usize| odd as f32 * 0.5 - 0.25;
                let (x, y) = (dx as f32 - centre(corner % STEP), dy as f32 - centre(corner / STEP));
                (f64::from(-(x * x + y * y) / (2.0 * sigma * sigma))).exp() as f32
            })
        })
        .collect();
    // The sum of weights changes by this for a pixel across a straight border: the inverse is the slope of a soft one.
    let slope = sigma * (2.0 * std::f32::consts::PI).sqrt() * STEP as f32;
    let votes = Votes { areas, size: (width, height), colors, weights: &weights, reach, slope };
    // Two rows of the picture, as R, G and B.
    let mut rows = [(); STEP].map(|()| [(); 3].map(|()| vec![0u8; full_width.next_multiple_of(STEP)]));
    for j in 0..height {
        for i in 0..width {
            let square = if border[j * width + i] {
                votes.mixed((i, j))
            } else {
                [colors[areas.numbers[j * width + i] as usize]; CORNERS]
            };
            for (corner, color) in square.into_iter().enumerate() {
                for (row, tone) in rows[corner / STEP].iter_mut().zip(color) {
                    row[STEP * i + corner % STEP] = tone;
                }
            }
        }
        for (y, rows) in (STEP * j..full_height).zip(&rows) {
            match planes {
                [r, g, b] => {
                    for (plane, row) in [r, g, b].into_iter().zip(rows) {
                        plane.row_mut(y).copy_from_slice(&row[..full_width]);
                    }
                }
                [plane, ..] => {
                    for (x, out) in plane.row_mut(y).iter_mut().enumerate() {
                        *out = luma(rows[0][x], rows[1][x], rows[2][x]);
                    }
                }
                [] => {}
            }
        }
    }
}

/// Pixels of the picture per pixel of the label map: one row of two above another.
const CORNERS: usize = STEP * STEP;

/// The inputs for the colour of a pixel near a border.
struct Votes<'a> {
    areas: &'a Areas,
    size: (usize, usize),
    colors: &'a [[u8; 3]],
    /// The weights of each place around a square, row by row, for each of the square's pixels.
    weights: &'a [[f32; CORNERS]],
    reach: isize,
    slope: f32,
}

impl Votes<'_> {
    /// The colours of the four pixels of the square (i, j): of each the two areas with most weight about it, one pixel soft.
    fn mixed(&self, (i, j): (usize, usize)) -> [[u8; 3]; CORNERS] {
        let (width, height) = self.size;
        // The areas around a square are determined once for all of its pixels.
        let mut sums = [(0u32, [0.0f32; CORNERS]); 12];
        let mut count = 0;
        let mut totals = [0.0f32; CORNERS];
        let mut weights = self.weights.iter();
        for dy in -self.reach..=self.reach {
            let row = (j as isize + dy).clamp(0, height as isize - 1) as usize * width;
            for dx in -self.reach..=self.reach {
                let number =
                    self.areas.numbers[row + (i as isize + dx).clamp(0, width as isize - 1) as usize];
                let weight = weights.next().copied().unwrap_or([0.0; CORNERS]);
                add(&mut totals, weight);
                if let Some((_, sum)) = sums[..count].iter_mut().find(|(known, _)| *known == number) {
                    add(sum, weight);
                } else if count < sums.len() {
                    sums[count] = (number, weight);
                    count += 1;
                }
            }
        }
        std::array::from_fn(|corner| self.blended(&sums[..count.max(1)], corner, totals[corner]))
    }

    /// The colour of one pixel of a square, by the weights of the areas about it.
    fn blended(&self, sums: &[(u32, [f32; CORNERS])], corner: usize, total: f32) -> [u8; 3] {
        let mut first = (sums[0].0, sums[0].1[corner]);
        let mut second = (first.0, 0.0);
        for &(number, sum) in &sums[1..] {
            if sum[corner] > first.1 {
                second = first;
                first = (number, sum[corner]);
            } else if sum[corner] > second.1 {
                second = (number, sum[corner]);
            }
        }
        let lead = (first.1 - second.1) / total.max(1e-6);
        let share = (0.5 + 0.5 * lead * self.slope).min(1.0);
        let (a, b) = (self.colors[first.0 as usize], self.colors[second.0 as usize]);
        std::array::from_fn(|c| (share * f32::from(a[c]) + (1.0 - share) * f32::from(b[c]) + 0.5) as u8)
    }
}

fn add(sums: &mut [f32; CORNERS], weights: [f32; CORNERS]) {
    for (sum, weight) in sums.iter_mut().zip(weights) {
        *sum += weight;
    }
}

/// Mask of pixels with another area within `reach`, both ways.
fn borders(areas: &Areas, (width, height): (usize, usize), reach: usize) -> Vec<bool> {
    let mut near = vec![false; areas.numbers.len()];
    for y in 0..height {
        for x in 0..width {
            let here = y * width + x;
            let right = x + 1 < width && areas.numbers[here] != areas.numbers[here + 1];
            let below = y + 1 < height && areas.numbers[here] != areas.numbers[here + width];
            if right || below {
                near[here] = true;
                if right {
                    near[here + 1] = true;
                }
                if below {
                    near[here + width] = true;
                }
            }
        }
    }
    for row in near.chunks_exact_mut(width) {
        spread(row, reach);
    }
    let mut column = vec![false; height];
    for x in 0..width {
        for (y, own) in column.iter_mut().enumerate() {
            *own = near[y * width + x];
        }
        spread(&mut column, reach);
        for (y, &own) in column.iter().enumerate() {
            near[y * width + x] = own;
        }
    }
    near
}

/// Widens every run of `true` by `reach` both ways.
fn spread(line: &mut [bool], reach: usize) {
    let mut since = usize::MAX;
    let before = line.to_vec();
    for (out, &own) in line.iter_mut().zip(&before) {
        since = if own { 0 } else { since.saturating_add(1) };
        *out = since <= reach;
    }
    since = usize::MAX;
    for (out, &own) in line.iter_mut().zip(&before).rev() {
        since = if own { 0 } else { since.saturating_add(1) };
        *out |= since <= reach;
    }
}

fn luma(r: u8, g: u8, b: u8) -> u8 {
    ((u32::from(r) * 299 + u32::from(g) * 587 + u32::from(b) * 114 + 500) / 1000) as u8
}
