//! The reference of Edge Tangent Flow: Kang's field, and a Gaussian line integral along it.
//! `tests/oracles/etf.py` has another implementation.
//!
//! ```text
//! t(x)  = Sobel's gradient, turned by a quarter
//! t'(x) = normalise sum over |y - x| <= 5 of (1 + tanh(g(y) - g(x))) / 2 (t(x) . t(y)) t(y), three times
//! out(x) = sum over s of exp(-s^2 / 2 sigma^2) in(line(s)), |s| <= 3 sigma, the line by the midpoint rule
//! ```
//!
//! g is the gradient's magnitude over its maximum.
//!
//! Source: Kang, Lee and Chui, "Flow-based image abstraction", 2009.

use rayon::prelude::*;

use crate::photos::Photo;

/// Radius of the field's smoothing, in pixels.
const RADIUS: isize = 5;

/// Rounds of the field's smoothing.
const PASSES: usize = 3;

/// Step along a line, in pixels.
const STEP: f32 = 0.5;

/// Lengths below this are flat.
const FLAT: f32 = 1e-6;

/// The exact result for each sigma at the pixels whose x + y divides by `every`, 0 elsewhere.
pub(crate) fn smooth(photo: &Photo, sigmas: &[f32], every: usize) -> Vec<Vec<f32>> {
    let (width, height) = (photo.luma.width(), photo.luma.height());
    let flow = Flow { tangents: tangents(photo), width, height };
    let luma: Vec<f32> = photo.luma.samples().iter().map(|&sample| f32::from(sample)).collect();
    let mut out = vec![vec![0.0; width * height]; sigmas.len()];
    let rows: Vec<Vec<f32>> = (0..height)
        .into_par_iter()
        .map(|y| {
            let mut row = vec![0.0; width * sigmas.len()];
            for x in (0..width).filter(|x| (x + y) % every == 0) {
                flow.integrate(&luma, (x, y), sigmas, &mut row[x * sigmas.len()..][..sigmas.len()]);
            }
            row
        })
        .collect();
    for (y, row) in rows.iter().enumerate() {
        for (x, values) in row.chunks_exact(sigmas.len()).enumerate() {
            for (out, &value) in out.iter_mut().zip(values) {
                out[y * width + x] = value;
            }
        }
    }
    out
}

/// Unit tangents (x, y) of every pixel; (0, 0) where the photo is flat.
fn tangents(photo: &Photo) -> Vec<[f32; 2]> {
    let (width, height) = (photo.luma.width() as isize, photo.luma.height() as isize);
    let pixels = || (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let gradients: Vec<[f32; 2]> = pixels().map(|(x, y)| sobel(photo, x, y)).collect();
    let magnitudes: Vec<f32> = gradients.iter().map(|[x, y]| x.hypot(*y)).collect();
    let most = magnitudes.iter().copied().fold(FLAT, f32::max);
    // (1 + tanh(a - b)) / 2 is e^2a / (e^2a + e^2b): one exponential a pixel instead of one a pair.
    let heights: Vec<f32> = magnitudes.iter().map(|magnitude| (2.0 * magnitude / most).exp()).collect();
    let mut field: Vec<[f32; 2]> = gradients
        .iter()
        .zip(&magnitudes)
        .map(|([x, y], length)| [-y / length.max(FLAT), x / length.max(FLAT)])
        .collect();
    let disc: Vec<(isize, isize)> = (-RADIUS..=RADIUS)
        .flat_map(|dy| (-RADIUS..=RADIUS).map(move |dx| (dx, dy)))
        .filter(|(dx, dy)| dx * dx + dy * dy <= RADIUS * RADIUS)
        .collect();
    let index = |x: isize, y: isize| (y.clamp(0, height - 1) * width + x.clamp(0, width - 1)) as usize;
    for _ in 0..PASSES {
        let smoothed = (0..width * height).into_par_iter().map(|i| {
            let (x, y) = (i % width, i / width);
            let (here, level) = (field[i as usize], heights[i as usize]);
            let mut sum = [0.0f32; 2];
            for (dx, dy) in &disc {
                let j = index(x + dx, y + dy);
                let there = field[j];
                let weight = heights[j] / (heights[j] + level) * (here[0] * there[0] + here[1] * there[1]);
                sum = [sum[0] + weight * there[0], sum[1] + weight * there[1]];
            }
            let length = sum[0].hypot(sum[1]);
            if length < FLAT { [0.0; 2] } else { sum.map(|part| part / length) }
        });
        field = smoothed.collect();
    }
    field
}

fn sobel(photo: &Photo, x: isize, y: isize) -> [f32; 2] {
    let v = |dx: isize, dy: isize| photo.at(x + dx, y + dy);
    let across = v(1, -1) - v(-1, -1) + 2.0 * (v(1, 0) - v(-1, 0)) + v(1, 1) - v(-1, 1);
    let down = v(-1, 1) - v(-1, -1) + 2.0 * (v(0, 1) - v(0, -1)) + v(1, 1) - v(1, -1);
    [across, down]
}

struct Flow {
    tangents: Vec<[f32; 2]>,
    width: usize,
    height: usize,
}

/// A place or a direction.
type Point = [f32; 2];

impl Flow {
    /// Weighted means along the line through a pixel, one a sigma.
    fn integrate(&self, luma: &[f32], (x, y): (usize, usize), sigmas: &[f32], out: &mut [f32]) {
        let center = luma[y * self.width + x];
        let tangent = self.tangents[y * self.width + x];
        let longest = sigmas.iter().copied().fold(0.0, f32::max);
        let mut weights = vec![1.0; sigmas.len()];
        out.fill(center);
        for sense in [1.0, -1.0] {
            let mut place = [x as f32, y as f32];
            let mut ahead = tangent.map(|part| part * sense);
            for step in 1..=(3.0 * longest / STEP).ceil() as usize {
                let start = self.direction(place, ahead);
                let middle = [place[0] + STEP / 2.0 * start[0], place[1] + STEP / 2.0 * start[1]];
                ahead = self.direction(middle, start);
                place = self.inside([place[0] + STEP * ahead[0], place[1] + STEP * ahead[1]]);
                let value = self.mean(place, |i| luma[i]);
                let s = step as f32 * STEP;
                for ((out, weight), &sigma) in out.iter_mut().zip(&mut weights).zip(sigmas) {
                    if step <= (3.0 * sigma / STEP).ceil() as usize {
                        let share = (-s * s / (2.0 * sigma * sigma)).exp();
                        (*out, *weight) = (*out + share * value, *weight + share);
                    }
                }
            }
        }
        for (out, weight) in out.iter_mut().zip(weights) {
            *out /= weight;
        }
    }

    /// Returns the field's direction at a place, in the sense that continues the previous direction.
    fn direction(&self, place: Point, before: Point) -> Point {
        let place = self.inside(place);
        let [x, y] = [0, 1].map(|part: usize| self.mean(place, |i| self.tangents[i][part]));
        let length = x.hypot(y).max(FLAT);
        let sign = if x * before[0] + y * before[1] < 0.0 { -1.0 } else { 1.0 };
        [x / length * sign, y / length * sign]
    }

    fn inside(&self, [x, y]: Point) -> Point {
        [x.clamp(0.0, (self.width - 1) as f32), y.clamp(0.0, (self.height - 1) as f32)]
    }

    /// Between four pixels.
    fn mean(&self, [x, y]: Point, value: impl Fn(usize) -> f32) -> f32 {
        let (left, top) = (x as usize, y as usize);
        let (right, bottom) = ((left + 1).min(self.width - 1), (top + 1).min(self.height - 1));
        let (across, down) = (x.fract(), y.fract());
        let row = |y: usize| {
            let (a, b) = (value(y * self.width + left), value(y * self.width + right));
            a + across * (b - a)
        };
        let (above, below) = (row(top), row(bottom));
        above + down * (below - above)
    }
}
