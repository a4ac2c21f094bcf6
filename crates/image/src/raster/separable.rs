//! The two passes of a separable resampling, as one operation done twice: weighted sums of rows.
//!
//! ```text
//! for each sixteen output rows:
//!     rows    = sums of weighted source rows        (down, contiguous)
//!     columns = rows, transposed
//!     out     = sums of weighted columns            (across), transposed back
//! ```

use super::Plane;
use super::axis::Axis;
use crate::simd::double::{MARGIN, double_columns, double_rows};
use crate::simd::mix::{LANES, halve_row, load, mix, mix_rows, transpose};
use wide::u8x16;

/// One resampling of a source of `width` x `height` pixels.
pub(super) struct Separable {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) across: Axis,
    pub(super) down: Axis,
}

/// Sixteen output rows under way.
struct Block {
    /// First source pixel and number of bytes of a row that are used.
    left: usize,
    used: usize,
    stride: usize,
    rows: Vec<u8>,
    columns: Vec<u8x16>,
    offsets: Vec<usize>,
}

impl Separable {
    /// Resamples `C` interleaved channels into `C` planes.
    pub(super) fn planes<const C: usize>(&self, source: &[u8]) -> [Plane; C] {
        let (width, height) = (self.across.count(), self.down.count());
        let mut planes = std::array::from_fn(|_| Plane::filled(width, height, 0));
        if let (1, Some(left), Some(top), [plane]) =
            (C, self.across.halved_from(), self.down.halved_from(), &mut planes[..])
        {
            self.halve(source, (left, top), plane);
            return planes;
        }
        if let (1, true, true, [plane]) =
            (C, self.across.is_doubled(), self.down.is_doubled(), &mut planes[..])
        {
            self.double(source, plane);
            return planes;
        }
        self.mix::<C>(source, &mut planes);
        planes
    }

    /// By the weights of each axis, whatever they are.
    fn mix<const C: usize>(&self, source: &[u8], planes: &mut [Plane; C]) {
        let (width, height) = (self.across.count(), self.down.count());
        let mut block = self.block::<C>();
        for top in (0..height).step_by(LANES) {
            let count = LANES.min(height - top);
            self.mix_down::<C>(source, top, count, &mut block);
            for (channel, plane) in planes.iter_mut().enumerate() {
                let out = &mut plane.samples_mut()[top * width..(top + count) * width];
                self.mix_across::<C>(&block, channel, out);
            }
        }
    }

    /// Two rows of two samples for each: the same sums, but by weights that are known.
    fn double(&self, source: &[u8], plane: &mut Plane) {
        let (width, last) = (self.width, self.height - 1);
        let row = |y: usize| &source[y.min(last) * width..][..width];
        let mut padded = [(); 2].map(|()| vec![0; width + 2 * MARGIN + LANES]);
        for y in 0..self.height {
            let rows = [y.saturating_sub(2), y.saturating_sub(1), y, y + 1, y + 2].map(row);
            let inner = MARGIN..MARGIN + width;
            double_rows(rows, padded.each_mut().map(|row| &mut row[inner.clone()]));
            for (k, padded) in padded.iter_mut().enumerate() {
                let (first, end) = (padded[inner.start], padded[inner.end - 1]);
                padded[..inner.start].fill(first);
                padded[inner.end..inner.end + MARGIN].fill(end);
                double_columns(padded, plane.row_mut(2 * y + k));
            }
        }
    }

    /// Means of 2 x 2 samples, rounded once.
    fn halve(&self, source: &[u8], (left, top): (usize, usize), plane: &mut Plane) {
        for y in 0..plane.height() {
            let row = |k: usize| &source[(top + 2 * y + k) * self.width + left..][..2 * plane.width()];
            let (above, below) = (row(0), row(1));
            halve_row(above, below, plane.row_mut(y));
        }
    }

    fn block<const C: usize>(&self) -> Block {
        let (left, right) = self.across.extent();
        let used = (right - left) * C;
        // One more pixel than is used, of any value: the last pair of an odd number of taps has weight 0 for it.
        let stride = (used + C).next_multiple_of(LANES);
        let columns = vec![u8x16::ZERO; stride];
        Block { left, used, stride, rows: vec![0; stride * LANES], columns, offsets: Vec::new() }
    }

    /// The first pass: `count` output rows from `top`, left as columns of sixteen.
    fn mix_down<const C: usize>(&self, source: &[u8], top: usize, count: usize, block: &mut Block) {
        let Block { left, used, stride, rows, columns, offsets } = block;
        for (y, row) in (top..top + count).zip(rows.chunks_exact_mut(*stride)) {
            let (start, pairs) = self.down.taps(y);
            let offset = |y: usize| (y.min(self.height - 1) * self.width + *left) * C;
            offsets.clear();
            offsets.extend((start..start + 2 * pairs.len()).map(offset));
            mix_rows(source, offsets, pairs, self.down.precision(), &mut row[..*used]);
        }
        for (x, columns) in (0..).step_by(LANES).zip(columns.as_chunks_mut::<LANES>().0) {
            *columns = transpose(std::array::from_fn(|y| load(rows, y * *stride + x)));
        }
    }

    /// The second pass: one channel of a block, written to at most sixteen rows of `out`.
    fn mix_across<const C: usize>(&self, block: &Block, channel: usize, out: &mut [u8]) {
        let width = self.across.count();
        let column = |x: usize| {
            let (start, pairs) = self.across.taps(x);
            let taps = block.columns[(start - block.left) * C..].chunks_exact(2 * C);
            let sources =
                pairs.iter().zip(taps).map(|(&pair, taps)| (pair, [taps[channel], taps[C + channel]]));
            mix(sources, self.across.precision())
        };
        let tile = |x: usize| transpose(std::array::from_fn(|i| column(x + i))).map(u8x16::to_array);
        let whole = width - width % LANES;
        for x in (0..whole).step_by(LANES) {
            for (out, row) in out.chunks_exact_mut(width).zip(tile(x)) {
                out[x..x + LANES].copy_from_slice(&row);
            }
        }
        // The narrow rest apart: a copy of unknown length is a call, and a slow one in wasm.
        if whole < width {
            for (out, row) in out.chunks_exact_mut(width).zip(tile(whole)) {
                out[whole..].copy_from_slice(&row[..width - whole]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn twice_as_large_is_what_the_weights_give(
            (width, height) in (1usize..80, 1usize..12),
            bytes in proptest::collection::vec(prop_oneof![Just(0u8), Just(255), any::<u8>()], 80 * 12..=80 * 12),
        ) {
            let axis = |samples: usize| Axis::new(samples, 0.0, samples as f64, 2 * samples);
            let plan = Separable { width, height, across: axis(width), down: axis(height) };
            prop_assert!(plan.across.is_doubled() && plan.down.is_doubled());
            let source = &bytes[..width * height];
            let mut expected = [Plane::filled(2 * width, 2 * height, 0)];
            plan.mix(source, &mut expected);
            prop_assert_eq!(plan.planes::<1>(source), expected);
        }
    }

    #[test]
    fn a_part_that_becomes_twice_as_large_takes_what_lies_beside_it() {
        assert!(!Axis::new(20, 1.0, 10.0, 20).is_doubled());
        assert!(!Axis::new(20, 0.0, 10.0, 20).is_doubled());
        assert!(Axis::new(20, 0.0, 20.0, 40).is_doubled());
    }
}
