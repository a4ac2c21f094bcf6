//! Linear Histogram Equalization: (v - lo) 255 / (hi - lo), where lo and hi are percentiles of luma (inverted
//! CDF); unchanged where they meet. A colour image has all channels stretched alike, which stretches its
//! luma by the same rule and keeps its hues.

use super::{Block, Channels, Kernel};
use crate::simd::table::Table;
use crate::style::params::{Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "equalize",
    label: "Linear Histogram Equalization",
    help: "Stretches the tones, so that hazy photos get real blacks and whites.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number(
            "low",
            "Black from",
            "Share of pixels that turn black.",
            (5.0, 0.0, 100.0, 0.5),
            Unit::Percent,
        ),
        number("high", "White from", "Percentile that turns white.", (95.0, 0.0, 100.0, 0.5), Unit::Percent),
    ],
    kernel: Kernel::Histogram(|args, histogram| {
        let low = percentile(histogram, args.number(0)) as f32;
        let high = percentile(histogram, args.number(1)) as f32;
        if high <= low {
            return Table::from_fn(|v| v);
        }
        Table::from_fn(|v| (v - low) * 255.0 / (high - low))
    }),
};

/// The smallest value that at least `percent` of the pixels do not exceed (inverted CDF).
pub(super) fn percentile(histogram: &[u32; 256], percent: f32) -> usize {
    let total: u64 = histogram.iter().map(|&n| u64::from(n)).sum();
    let rank = (f64::from(percent) / 100.0 * total as f64).ceil().max(1.0) as u64;
    let mut below = 0;
    for (value, &count) in histogram.iter().enumerate() {
        below += u64::from(count);
        if below >= rank {
            return value;
        }
    }
    255
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_those_of_the_inverted_cdf() {
        let mut histogram = [0; 256];
        histogram[10] = 5;
        histogram[20] = 90;
        histogram[200] = 5;
        assert_eq!(percentile(&histogram, 5.0), 10);
        assert_eq!(percentile(&histogram, 5.1), 20);
        assert_eq!(percentile(&histogram, 95.0), 20);
        assert_eq!(percentile(&histogram, 100.0), 200);
        assert_eq!(percentile(&histogram, 0.0), 10);
    }
}
