//! Blurs of volumes of floats, whatever the axis.

use wide::f32x4;

/// Floats a step.
const LANES: usize = 4;

/// `target[i]` = [1 4 6 4 1] / 16 of `source` at distances of `shift`; zeros lie beyond the ends. Both have one length.
pub fn binomial(source: &[f32], shift: usize, target: &mut [f32]) {
    let n = source.len();
    let edge = (2 * shift).min(n);
    let at = |i: usize, k: usize| (i + k).checked_sub(2 * shift).and_then(|i| source.get(i)).unwrap_or(&0.0);
    let one = |i: usize| {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| *at(i, k * shift));
        sum(a + e, b + d, c)
    };
    let inner_end = n.saturating_sub(2 * shift).max(edge);
    let whole = edge + (inner_end - edge) / LANES * LANES;
    for i in (0..edge).chain(whole..n) {
        target[i] = one(i);
    }
    let tap = |k: usize| source[k * shift..][..whole - edge].as_chunks::<LANES>().0;
    if whole == edge {
        return;
    }
    let (out, _) = target[edge..whole].as_chunks_mut::<LANES>();
    let taps = tap(0).iter().zip(tap(1)).zip(tap(2)).zip(tap(3)).zip(tap(4));
    for (out, ((((a, b), c), d), e)) in out.iter_mut().zip(taps) {
        let [a, b, c, d, e] = [a, b, c, d, e].map(|tap| f32x4::new(*tap));
        let sum = (a + e) * f32x4::splat(0.0625) + (b + d) * f32x4::splat(0.25) + c * f32x4::splat(0.375);
        *out = sum.to_array();
    }
}

fn sum(far: f32, near: f32, centre: f32) -> f32 {
    far * 0.0625 + near * 0.25 + centre * 0.375
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_equal_scalars_at_every_length_and_shift() {
        let mut random = oorandom::Rand32::new(6);
        for n in 1..=67usize {
            let source: Vec<f32> = (0..n).map(|_| random.rand_float()).collect();
            for shift in [1, 2, 3, 8, 31, 70] {
                let mut target = vec![9.0; n];
                binomial(&source, shift, &mut target);
                for (i, &target) in target.iter().enumerate() {
                    let v = |k: isize| {
                        let i = i as isize + k * shift as isize;
                        if (0..n as isize).contains(&i) { source[i as usize] } else { 0.0 }
                    };
                    let exact = (v(-2) + 4.0 * v(-1) + 6.0 * v(0) + 4.0 * v(1) + v(2)) / 16.0;
                    assert!((target - exact).abs() < 1e-6, "{n} {shift} {i}");
                }
            }
        }
    }
}
