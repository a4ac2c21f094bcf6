//! The bilateral grid: a coarse volume of (x, y, tone) that holds sums of tones and how many pixels made them.

use crate::raster::Plane;
use crate::simd::volume::binomial;
use crate::style::context::Context;

/// Cells for one sigma: gathering into a cell, the blur of one cell and reading back between cells add up to
/// a Gaussian of 1.12 cells, so cells are that much smaller than sigma.
const CELL: f32 = 0.89;

/// No grid has more cells: tiny sigmas are coarsened until they fit.
const MAX_CELLS: usize = 6_000_000;

/// Empty cells behind the tones of a column and behind the columns of a row, so that a blur along one axis is one
/// sum over the whole volume: what it carries across an end is lost in them.
const GAP: usize = 2;

/// Cells in the order (y, x, tone), with a margin of one cell at the far ends for interpolation and gaps.
pub(super) struct Grid {
    columns: usize,
    tones: usize,
    /// Cells for a pixel and for a grey step.
    per_pixel: f32,
    per_grey: f32,
    /// Weight and weighted tone of each cell, in turn.
    cells: Vec<f32>,
    /// Tone of each cell after the blur.
    values: Vec<f32>,
    /// One row of cells between two, for a row of pixels.
    between: Vec<f32>,
    /// First cell of each pixel column, and its share of the next.
    places: Vec<(u32, f32)>,
    /// Cell of each grey step, and its share of the next.
    levels: [(u32, f32); 256],
}

impl Grid {
    /// An empty grid for a plane. `sigma_s` in pixels of the plane, `sigma_r` in grey steps.
    pub(super) fn new(size: (usize, usize), sigma_s: f32, sigma_r: f32, context: &mut Context<'_>) -> Self {
        let (width, height) = size;
        let mut per_pixel = 1.0 / (CELL * sigma_s.max(0.5));
        let mut per_grey = 1.0 / (CELL * sigma_r);
        let cells = |length: usize, rate: f32| (length as f32 * rate) as usize + 3 + GAP;
        while cells(width, per_pixel) * cells(height, per_pixel) * cells(255, per_grey) > MAX_CELLS {
            (per_pixel, per_grey) = (per_pixel * 0.9, per_grey * 0.95);
        }
        let (columns, rows) = (cells(width, per_pixel), cells(height, per_pixel));
        let tones = cells(255, per_grey);
        let place = |position: f32| (position as u32, position.fract());
        let along = |x: usize| {
            let (column, share) = place(x as f32 * per_pixel);
            (column * tones as u32, share)
        };
        let mut grid = Self {
            columns,
            tones,
            per_pixel,
            per_grey,
            cells: context.take_floats(columns * rows * tones * 2),
            values: context.take_floats(columns * rows * tones),
            between: context.take_floats(columns * tones),
            places: (0..width).map(along).collect(),
            levels: std::array::from_fn(|v| place(v as f32 * per_grey)),
        };
        grid.cells.fill(0.0);
        grid
    }

    /// Gives the memory back for reuse.
    pub(super) fn release(self, context: &mut Context<'_>) {
        for floats in [self.cells, self.values, self.between] {
            context.give_floats(floats);
        }
    }

    /// Gathers a plane. Every second pixel of every second row is enough: a cell holds many.
    pub(super) fn splat(&mut self, plane: &Plane) {
        let stride = if self.per_pixel < 0.25 { 2 } else { 1 };
        let length = self.columns * self.tones * 2;
        for y in (0..plane.height()).step_by(stride) {
            let row = ((y as f32 * self.per_pixel) + 0.5) as usize;
            let cells = &mut self.cells[row * length..][..length];
            for (x, &sample) in plane.row(y).iter().enumerate().step_by(stride) {
                let column = (x as f32 * self.per_pixel + 0.5) as usize;
                let (z, upper) = self.levels[usize::from(sample)];
                let i = (column * self.tones + z as usize) * 2;
                let (value, lower) = (f32::from(sample), 1.0 - upper);
                if let Some([a, b, c, d]) = cells.get_mut(i..i + 4) {
                    (*a, *b) = (*a + lower, *b + lower * value);
                    (*c, *d) = (*c + upper, *d + upper * value);
                }
            }
        }
    }

    /// Blurs along all three axes and divides.
    pub(super) fn blur(&mut self, context: &mut Context<'_>) {
        let mut scratch = context.take_floats(self.cells.len());
        let column = self.tones * 2;
        binomial(&self.cells, 2, &mut scratch);
        binomial(&scratch, column, &mut self.cells);
        binomial(&self.cells, column * self.columns, &mut scratch);
        let grey = 1.0 / self.per_grey;
        let columns = self.values.chunks_exact_mut(self.tones).zip(scratch.chunks_exact(column));
        for (values, cells) in columns {
            for (z, (value, cell)) in values.iter_mut().zip(cells.as_chunks::<2>().0).enumerate() {
                // A cell far from every pixel says its own tone: nothing reads it but at a weight near zero.
                *value = if cell[0] > 1e-6 { cell[1] / cell[0] } else { z as f32 * grey };
            }
        }
        context.give_floats(scratch);
    }

    /// The base of one row of pixels.
    pub(super) fn slice_row(&mut self, y: usize, row: &[u8], base: &mut [f32]) {
        let position = y as f32 * self.per_pixel;
        let (first, share) = (position as usize, position.fract());
        let length = self.columns * self.tones;
        let upper = &self.values[first * length..][..length];
        let lower = &self.values[(first + 1) * length..][..length];
        for ((between, &a), &b) in self.between.iter_mut().zip(upper).zip(lower) {
            *between = a + share * (b - a);
        }
        let next = &self.between[self.tones..];
        for ((base, &sample), &(column, along)) in base.iter_mut().zip(row).zip(&self.places) {
            let (z, up) = self.levels[usize::from(sample)];
            let i = (column + z) as usize;
            let (Some(&[a, b]), Some(&[c, d])) = (pair(&self.between, i), pair(next, i)) else { continue };
            let (near, far) = (a + up * (b - a), c + up * (d - c));
            *base = near + along * (far - near);
        }
    }
}

#[inline]
fn pair(values: &[f32], i: usize) -> Option<&[f32; 2]> {
    values.get(i..i + 2)?.first_chunk()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn base(plane: &Plane, sigma_s: f32, sigma_r: f32) -> Vec<f32> {
        let mut context = Context::default();
        let mut grid = Grid::new((plane.width(), plane.height()), sigma_s, sigma_r, &mut context);
        grid.splat(plane);
        grid.blur(&mut context);
        let mut out = Vec::new();
        let mut row = vec![0.0; plane.width()];
        for y in 0..plane.height() {
            grid.slice_row(y, plane.row(y), &mut row);
            out.extend_from_slice(&row);
        }
        out
    }

    #[test]
    fn flat_stays_flat_and_a_tall_edge_stays_sharp() {
        for (width, height) in [(1, 1), (3, 67), (67, 3), (80, 60)] {
            let flat = base(&Plane::filled(width, height, 77), 8.0, 25.0);
            assert!(flat.iter().all(|v| (v - 77.0).abs() < 0.01));
        }
        let edge = Plane::from_fn(80, 40, |x, _| if x < 40 { 30 } else { 220 });
        let out = base(&edge, 8.0, 25.0);
        assert!((out[20 * 80 + 39] - 30.0).abs() < 1.0 && (out[20 * 80 + 40] - 220.0).abs() < 1.0);
    }

    #[test]
    fn noise_within_the_edge_height_is_smoothed() {
        let mut random = oorandom::Rand32::new(3);
        let plane = Plane::from_fn(128, 128, |_, _| 120 + (random.rand_u32() % 21) as u8);
        let out = base(&plane, 8.0, 40.0);
        assert!(out.iter().all(|v| (v - 130.0).abs() < 5.0));
    }

    #[test]
    fn tiny_sigmas_do_not_ask_for_endless_memory() {
        let grid = Grid::new((4000, 3000), 1.0, 1.0, &mut Context::default());
        assert!(grid.values.len() <= MAX_CELLS);
    }
}
