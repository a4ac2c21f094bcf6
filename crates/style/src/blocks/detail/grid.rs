//! The bilateral grid: a coarse volume of (x, y, tone) that holds sums of tones and how many pixels made them.
//!
//! Only a few rows of cells are in memory: pixels are gathered a little ahead of the row whose base is read.

use crate::context::Context;
use crate::error::Result;
use crate::raster::Plane;
use crate::simd::volume::{
    Across, Corners, Level, binomial, collect, divide, exaggerate, gather, shares, surround,
};

/// Cells for one sigma. Gathering into a cell, the blur of one cell and reading back between cells add up to
/// a Gaussian of 1.12 cells. Cells are therefore smaller than sigma by this factor.
const CELL: f32 = 0.89;

/// No grid has more cells: tiny sigmas are coarsened until they fit.
const MAX_CELLS: usize = 6_000_000;

/// Empty cells after the tones of a column. They absorb the values that a blur along the tone moves across an
/// end, so that the blur is one sum over the whole row.
const GAP: usize = 2;

/// Rows of cells that the blur along y sees.
const REACH: usize = 5;

/// The memory of a grid, kept between runs. Cells are in the order (x, tone), with a margin of one cell at the far ends
/// for interpolation, and gaps.
#[derive(Default, Debug)]
pub(crate) struct Buffers {
    /// The first cell of the column before each pixel, the shares of that column and of the next, and the first cell of
    /// the column nearest to the pixel.
    columns: Vec<u32>,
    shares: Vec<[i16; 2]>,
    nearest: Vec<u32>,
    /// Pixels gathered for a row of cells.
    slots: Vec<[f32; 4]>,
    /// Weight and weighted tone of the cells of a row, before and after the blur along the tone.
    cells: [Vec<f32>; 2],
    /// Rows blurred along the tone and along x, the last ones.
    ring: [Vec<f32>; REACH],
    /// The tone in the middle of each cell.
    own: Vec<f32>,
    /// Tones of two rows, the even one first.
    tones: [Vec<i16>; 2],
    corners: Vec<Corners>,
}

pub(super) struct Grid {
    /// Cells for a pixel.
    per_pixel: f32,
    /// Cells of a column.
    column: usize,
    levels: Box<[Level; 256]>,
    buffers: Buffers,
    /// Rows of cells in the ring so far, and rows of pixels in them.
    gathered: (usize, usize),
}

impl Grid {
    /// An empty grid for planes of a size. `sigma_s` in pixels of the plane, `sigma_r` in grey steps.
    pub(super) fn new(
        (width, height): (usize, usize),
        sigma_s: f32,
        sigma_r: f32,
        mut buffers: Buffers,
    ) -> Self {
        let mut per_pixel = 1.0 / (CELL * sigma_s.max(0.5));
        let mut per_grey = 1.0 / (CELL * sigma_r);
        let cells = |length: usize, rate: f32| (length as f32 * rate) as usize + 3;
        while cells(width, per_pixel) * cells(height, per_pixel) * (cells(255, per_grey) + GAP) > MAX_CELLS {
            (per_pixel, per_grey) = (per_pixel * 0.9, per_grey * 0.95);
        }
        let column = cells(255, per_grey) + GAP;
        // Whole groups of lanes.
        let count = (cells(width, per_pixel) * column).next_multiple_of(8);
        let first = |position: f32| position as u32 * column as u32;
        let places = (0..width).map(|x| x as f32 * per_pixel);
        refill(&mut buffers.columns, places.clone().map(first));
        refill(&mut buffers.shares, places.clone().map(|place| shares(place.fract())));
        refill(&mut buffers.nearest, places.map(|place| first(place + 0.5)));
        refill(&mut buffers.slots, (0..count).map(|_| [0.0; 4]));
        for floats in buffers.cells.iter_mut().chain(&mut buffers.ring) {
            refill(floats, (0..2 * count).map(|_| 0.0));
        }
        refill(&mut buffers.own, (0..count).map(|i| ((i % column) as f32 / per_grey).min(255.0)));
        for tones in &mut buffers.tones {
            // One more column and one more cell, for reads beyond the last corners.
            tones.resize(count + column + 1, 0);
        }
        buffers.corners.resize(count, [0; 8]);
        let level = |grey: usize| {
            let (place, grey) = (grey as f32 * per_grey, grey as f32);
            let upper = place.fract();
            let parts = [1.0 - upper, (1.0 - upper) * grey, upper, upper * grey];
            Level { cell: place as u32, shares: shares(upper), parts }
        };
        Self { per_pixel, column, levels: Box::new(std::array::from_fn(level)), buffers, gathered: (0, 0) }
    }

    /// Gives the memory back for reuse.
    pub(super) fn into_buffers(self) -> Buffers {
        self.buffers
    }

    /// Moves every sample of a plane of that size away from its base by `amount` times its distance.
    ///
    /// # Errors
    /// `cancelled` when the context is cancelled.
    pub(super) fn run(&mut self, plane: &mut Plane, amount: f32, context: &Context<'_>) -> Result<()> {
        let mut ready = 0;
        for y in 0..plane.height() {
            let position = y as f32 * self.per_pixel;
            let upper = position as usize;
            if ready < upper + 2 {
                context.check_cancelled()?;
                while ready < upper + 2 {
                    self.settle(ready, plane);
                    ready += 1;
                }
                let [even, odd] = self.buffers.tones.each_ref().map(Vec::as_slice);
                let rows = if upper.is_multiple_of(2) { [even, odd] } else { [odd, even] };
                surround(rows, self.column, &mut self.buffers.corners);
            }
            let Buffers { columns, shares: along, corners, .. } = &self.buffers;
            let across = Across { columns, shares: along };
            let down = shares(position.fract());
            exaggerate(plane.row_mut(y), across, down, (&self.levels, corners), amount);
        }
        Ok(())
    }

    /// Makes the tones of row `row` of cells. Rows must arrive in order.
    fn settle(&mut self, row: usize, plane: &Plane) {
        while self.gathered.0 <= row + REACH / 2 {
            self.gather_row(plane);
        }
        let Buffers { ring, own, tones, .. } = &mut self.buffers;
        let rows = std::array::from_fn(|k| ring[(row + k + REACH - REACH / 2) % REACH].as_slice());
        divide(rows, own, &mut tones[row % 2]);
    }

    /// Gathers the pixels of the next row of cells, blurs them along the tone and along x, and puts them in the ring.
    /// Every second pixel of every second row is enough: a cell holds many.
    fn gather_row(&mut self, plane: &Plane) {
        let stride = if self.per_pixel < 0.25 { 2 } else { 1 };
        let (row, mut y) = self.gathered;
        let Buffers { nearest, slots, cells: [cells, blurred], ring, .. } = &mut self.buffers;
        while y < plane.height() && (y as f32 * self.per_pixel + 0.5) as usize == row {
            gather(plane.row(y), nearest, stride, &self.levels, slots);
            y += stride;
        }
        self.gathered = (row + 1, y);
        collect(slots, cells);
        binomial(cells, 2, blurred);
        binomial(blurred, 2 * self.column, &mut ring[row % REACH]);
    }
}

/// New content in old memory.
fn refill<T>(memory: &mut Vec<T>, content: impl Iterator<Item = T>) {
    memory.clear();
    memory.extend(content);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn base(plane: &Plane, sigma_s: f32, sigma_r: f32) -> Plane {
        let mut context = Context::default();
        let mut run = || {
            let mut base = plane.clone();
            let buffers = context.take().unwrap_or_default();
            let mut grid = Grid::new((plane.width(), plane.height()), sigma_s, sigma_r, buffers);
            grid.run(&mut base, -1.0, &context).unwrap();
            context.give(grid.into_buffers());
            base
        };
        // The second run finds what the first left in memory.
        let first = run();
        assert_eq!(run(), first);
        first
    }

    #[test]
    fn flat_stays_flat_and_a_tall_edge_stays_sharp() {
        for (width, height) in [(1, 1), (3, 67), (67, 3), (80, 60)] {
            let flat = Plane::filled(width, height, 77);
            assert_eq!(base(&flat, 8.0, 25.0), flat);
        }
        let edge = Plane::from_fn(80, 40, |x, _| if x < 40 { 30 } else { 220 });
        let out = base(&edge, 8.0, 25.0);
        assert!(out.at(39, 20).abs_diff(30) <= 1 && out.at(40, 20).abs_diff(220) <= 1);
    }

    #[test]
    fn noise_within_the_edge_height_is_smoothed() {
        let mut random = oorandom::Rand32::new(3);
        let plane = Plane::from_fn(128, 128, |_, _| 120 + (random.rand_u32() % 21) as u8);
        let out = base(&plane, 8.0, 40.0);
        assert!(out.samples().iter().all(|v| v.abs_diff(130) <= 5));
    }

    #[test]
    fn tiny_sigmas_do_not_ask_for_endless_work() {
        let grid = Grid::new((4000, 3000), 1.0, 1.0, Buffers::default());
        assert!(grid.buffers.own.len() * (3000.0 * grid.per_pixel) as usize <= MAX_CELLS);
    }
}
