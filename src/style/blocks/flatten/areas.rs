//! Labels of pixels made into areas, and areas into pixels.

use super::STEP;
use super::palette::Costs;
use crate::raster::{Image, Plane};

/// Rounds in which pixels ask their neighbours.
const ROUNDS: usize = 3;

/// Cost of a neighbour that differs at full smoothness, in units of the costs.
const PULL: f32 = 420.0;

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
    for _ in 0..ROUNDS {
        for y in 0..height {
            for x in 0..width {
                let here = y * width + x;
                let around = neighbours(labels, (x, y), (width, height));
                let own = labels[here];
                if around.iter().all(|&label| label == own) {
                    continue;
                }
                let costs = costs.of([r.samples()[here], g.samples()[here], b.samples()[here]]);
                let energy = |label: u8| {
                    let equal = around.iter().filter(|&&other| other == label).count() as i32;
                    i32::from(costs[usize::from(label)]) - pull * equal
                };
                let mut best = (energy(own), own);
                for &label in &around {
                    let other = energy(label);
                    if other < best.0 {
                        best = (other, label);
                    }
                }
                labels[here] = best.1;
            }
        }
    }
}

/// The eight labels around a pixel; its own stands for those outside.
#[inline]
fn neighbours(labels: &[u8], (x, y): (usize, usize), (width, height): (usize, usize)) -> [u8; 8] {
    let at = |dx: isize, dy: isize| {
        let (x, y) = (x.wrapping_add_signed(dx), y.wrapping_add_signed(dy));
        if x < width && y < height { labels[y * width + x] } else { labels[(y.wrapping_add_signed(-dy)) * width + x.wrapping_add_signed(-dx)] }
    };
    [at(-1, -1), at(0, -1), at(1, -1), at(-1, 0), at(1, 0), at(-1, 1), at(0, 1), at(1, 1)]
}

/// For every pixel, the number of the area that it belongs to.
pub(super) struct Areas {
    pub(super) numbers: Vec<u32>,
    pub(super) count: usize,
}

/// Areas of equal labels, where those of fewer than `least` pixels have joined the neighbour with which they share most
/// of their border. Labels change alike.
pub(super) fn merge_small(labels: &mut [u8], (width, height): (usize, usize), least: usize) -> Areas {
    // Areas join the ones around them; several rounds, as small ones may lie side by side.
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
            // A larger neighbour is worth more than a small one that will be gone itself.
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
    let mut parents: Vec<u32> = Vec::new();
    let mut numbers = vec![0u32; labels.len()];
    for y in 0..height {
        for x in 0..width {
            let here = y * width + x;
            let left = (x > 0 && labels[here - 1] == labels[here]).then(|| numbers[here - 1]);
            let above = (y > 0 && labels[here - width] == labels[here]).then(|| numbers[here - width]);
            numbers[here] = match (left, above) {
                (Some(left), Some(above)) if left != above => {
                    let (a, b) = (root(&mut parents, left), root(&mut parents, above));
                    parents[a.max(b) as usize] = a.min(b);
                    a.min(b)
                }
                (Some(number), _) | (None, Some(number)) => number,
                (None, None) => {
                    parents.push(parents.len() as u32);
                    parents.len() as u32 - 1
                }
            };
        }
    }
    let mut names = vec![u32::MAX; parents.len()];
    let mut count = 0;
    for number in &mut numbers {
        let root = root(&mut parents, *number) as usize;
        if names[root] == u32::MAX {
            names[root] = count;
            count += 1;
        }
        *number = names[root];
    }
    Areas { numbers, count: count as usize }
}

fn root(parents: &mut [u32], mut number: u32) -> u32 {
    while parents[number as usize] != number {
        parents[number as usize] = parents[parents[number as usize] as usize];
        number = parents[number as usize];
    }
    number
}

/// The colour of each area: the palette's, and as much of its own mean as is wanted.
pub(super) fn colors(areas: &Areas, labels: &[u8], photo: &Image, palette: &[[u8; 3]], own: f32) -> Vec<[u8; 3]> {
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
    let gray: Vec<u8> = colors.iter().map(|&[r, g, b]| luma(r, g, b)).collect();
    let (full_width, full_height) = (planes[0].width(), planes[0].height());
    let reach = (2.0 * sigma).ceil() as isize;
    let border = borders(areas, (width, height), reach as usize);
    // Weights of places about each of the four pixels of a square.
    let weights: Vec<Vec<f32>> = (0..4)
        .map(|corner| {
            let centre = |odd: usize| odd as f32 * 0.5 - 0.25;
            let (cx, cy) = (centre(corner % 2), centre(corner / 2));
            (-reach..=reach)
                .flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)))
                .map(|(dx, dy)| {
                    let (x, y) = (dx as f32 - cx, dy as f32 - cy);
                    (f64::from(-(x * x + y * y) / (2.0 * sigma * sigma))).exp() as f32
                })
                .collect()
        })
        .collect();
    // The sum of weights changes by this for a pixel across a straight border: the inverse is the slope of a soft one.
    let slope = sigma * (2.0 * std::f32::consts::PI).sqrt() * STEP as f32;
    let mut votes: Vec<(u32, f32)> = Vec::with_capacity(8);
    for y in 0..full_height {
        for x in 0..full_width {
            let (i, j) = (x / STEP, y / STEP);
            let own = areas.numbers[j * width + i];
            let mut put = |color: [u8; 3], gray: u8| match planes {
                [r, g, b] => {
                    for (plane, tone) in [r, g, b].into_iter().zip(color) {
                        plane.samples_mut()[y * full_width + x] = tone;
                    }
                }
                [plane, ..] => plane.samples_mut()[y * full_width + x] = gray,
                [] => {}
            };
            if !border[j * width + i] {
                put(colors[own as usize], gray[own as usize]);
                continue;
            }
            votes.clear();
            let mut total = 0.0;
            let mut weight = weights[y % STEP * STEP + x % STEP].iter();
            for dy in -reach..=reach {
                let row = (j as isize + dy).clamp(0, height as isize - 1) as usize * width;
                for dx in -reach..=reach {
                    let number = areas.numbers[row + (i as isize + dx).clamp(0, width as isize - 1) as usize];
                    let weight = weight.next().copied().unwrap_or(0.0);
                    total += weight;
                    match votes.iter_mut().find(|(known, _)| *known == number) {
                        Some((_, sum)) => *sum += weight,
                        None => votes.push((number, weight)),
                    }
                }
            }
            let mut first = (own, 0.0);
            let mut second = (own, 0.0);
            for &(number, sum) in &votes {
                if sum > first.1 {
                    second = first;
                    first = (number, sum);
                } else if sum > second.1 {
                    second = (number, sum);
                }
            }
            let lead = (first.1 - second.1) / total.max(1e-6);
            let share = (0.5 + 0.5 * lead * slope).min(1.0);
            let (a, b) = (colors[first.0 as usize], colors[second.0 as usize]);
            let mixed =
                std::array::from_fn(|c| (share * f32::from(a[c]) + (1.0 - share) * f32::from(b[c]) + 0.5) as u8);
            let tone = share * f32::from(gray[first.0 as usize]) + (1.0 - share) * f32::from(gray[second.0 as usize]);
            put(mixed, (tone + 0.5) as u8);
        }
    }
}

/// Where another area is within `reach`, both ways.
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
