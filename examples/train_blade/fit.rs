//! Least squares, bucket by bucket.
//!
//! A filter is fitted to the change that the operator makes to a pixel. Its inputs are 24 sums: two opposite
//! neighbours minus twice the centre. So it is symmetric, and preserves the mean exactly. The filter of a
//! bucket with few pixels is pulled towards the mean filter.

use inkpanel_engine::raster::Plane;
use inkpanel_engine::simd::blade::{FRACTION, SIDE};
use inkpanel_engine::style::blade::bank::WEIGHTS;
use rayon::prelude::*;

use crate::photos::Photo;

/// Pull toward the filter of all buckets, in squared grey steps.
const RIDGE: f64 = 2e3;

/// Rows of a photo that one thread sums up.
const BAND: usize = 128;

/// Products of features, and of features with targets, for each bucket.
pub(crate) struct Sums {
    levels: usize,
    buckets: Vec<Bucket>,
}

#[derive(Clone)]
struct Bucket {
    products: Vec<f64>,
    targets: Vec<f64>,
}

impl Bucket {
    fn new(levels: usize) -> Self {
        Self { products: vec![0.0; WEIGHTS * WEIGHTS], targets: vec![0.0; WEIGHTS * levels] }
    }

    /// Adds a pixel. Only the products at and below the diagonal are summed.
    fn add(&mut self, features: &[f64; WEIGHTS], targets: &[f64]) {
        for (i, &feature) in features.iter().enumerate() {
            let row = &mut self.products[i * WEIGHTS..][..=i];
            for (sum, &other) in row.iter_mut().zip(features) {
                *sum += feature * other;
            }
        }
        for (sums, &target) in self.targets.chunks_exact_mut(WEIGHTS).zip(targets) {
            for (sum, &feature) in sums.iter_mut().zip(features) {
                *sum += feature * target;
            }
        }
    }

    fn merge(&mut self, other: &Self) {
        for (sum, &more) in self.products.iter_mut().zip(&other.products) {
            *sum += more;
        }
        for (sum, &more) in self.targets.iter_mut().zip(&other.targets) {
            *sum += more;
        }
    }

    /// The filter of a level that is best for this bucket's pixels and near to another.
    fn solve(&self, level: usize, near: &[f64; WEIGHTS]) -> [f64; WEIGHTS] {
        let mut matrix = self.products.clone();
        let mut vector: [f64; WEIGHTS] =
            std::array::from_fn(|i| self.targets[level * WEIGHTS + i] + RIDGE * near[i]);
        for i in 0..WEIGHTS {
            matrix[i * WEIGHTS + i] += RIDGE;
        }
        cholesky(&mut matrix, &mut vector);
        vector
    }
}

impl Sums {
    pub(crate) fn new(buckets: usize, levels: usize) -> Self {
        Self { levels, buckets: vec![Bucket::new(levels); buckets] }
    }

    /// Adds the pixels of a photo whose x + y divides by `every`.
    pub(crate) fn add(&mut self, photo: &Photo, places: &Plane, exact: &[Vec<f32>], every: usize) {
        let (width, height) = (photo.luma.width(), photo.luma.height());
        let bands: Vec<Vec<Bucket>> = (0..height.div_ceil(BAND))
            .into_par_iter()
            .map(|band| {
                let mut buckets = vec![Bucket::new(self.levels); self.buckets.len()];
                for y in band * BAND..((band + 1) * BAND).min(height) {
                    for x in (0..width).filter(|x| (x + y) % every == 0) {
                        let here = f64::from(photo.luma.at(x, y));
                        let targets: Vec<f64> =
                            exact.iter().map(|level| f64::from(level[y * width + x]) - here).collect();
                        let bucket = usize::from(places.at(x / 2, y / 2));
                        buckets[bucket].add(&features(photo, x as isize, y as isize), &targets);
                    }
                }
                buckets
            })
            .collect();
        for band in &bands {
            for (sum, more) in self.buckets.iter_mut().zip(band) {
                sum.merge(more);
            }
        }
    }

    /// The filters of every level and bucket, as fixed-point weights.
    pub(crate) fn solve(&self) -> Vec<Vec<[i16; WEIGHTS]>> {
        let mut all = Bucket::new(self.levels);
        for bucket in &self.buckets {
            all.merge(bucket);
        }
        (0..self.levels)
            .map(|level| {
                let common = all.solve(level, &[0.0; WEIGHTS]);
                self.buckets.iter().map(|bucket| bucket.solve(level, &common).map(fixed)).collect()
            })
            .collect()
    }
}

/// Sums of opposite neighbours minus twice the centre, in the order of the neighbours before it.
fn features(photo: &Photo, x: isize, y: isize) -> [f64; WEIGHTS] {
    let reach = (SIDE / 2) as isize;
    let center = photo.at(x, y);
    std::array::from_fn(|i| {
        let (dx, dy) = ((i % SIDE) as isize - reach, (i / SIDE) as isize - reach);
        f64::from(photo.at(x + dx, y + dy) + photo.at(x - dx, y - dy) - 2.0 * center)
    })
}

fn fixed(weight: f64) -> i16 {
    (weight * f64::from(1 << FRACTION)).round().clamp(f64::from(i16::MIN), f64::from(i16::MAX)) as i16
}

/// Solves a symmetric, positive system in place. Only the diagonal and the lower triangle of the matrix are
/// read.
fn cholesky(matrix: &mut [f64], vector: &mut [f64; WEIGHTS]) {
    let n = WEIGHTS;
    for j in 0..n {
        for k in 0..j {
            let factor = matrix[j * n + k];
            for i in j..n {
                matrix[i * n + j] -= matrix[i * n + k] * factor;
            }
        }
        let root = matrix[j * n + j].max(1e-12).sqrt();
        for i in j..n {
            matrix[i * n + j] /= root;
        }
    }
    for i in 0..n {
        let known: f64 = (0..i).map(|k| matrix[i * n + k] * vector[k]).sum();
        vector[i] = (vector[i] - known) / matrix[i * n + i];
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| matrix[k * n + i] * vector[k]).sum();
        vector[i] = (vector[i] - known) / matrix[i * n + i];
    }
}
