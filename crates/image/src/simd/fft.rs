//! The parts of a radix-2 Fourier transform that do not depend on the elements.
//!
//! Source: Cooley and Tukey, "An algorithm for the machine calculation of complex Fourier series", 1965.

/// The first half of a turn in `size` parts: cosine and negative sine of each. `size` is a power of two, at least 4.
///
/// They come from repeated halving of a quarter turn, so that all platforms have the same numbers.
#[must_use]
pub fn turns(size: usize) -> Vec<[f32; 2]> {
    let (mut cosine, mut sine) = (0f64, 1f64);
    for _ in 2..size.trailing_zeros() {
        cosine = f64::midpoint(1.0, cosine).sqrt();
        sine /= 2.0 * cosine;
    }
    let mut at = (1f64, 0f64);
    let next = |_| {
        let (x, y) = at;
        at = (x * cosine - y * sine, x * sine + y * cosine);
        [x as f32, -y as f32]
    };
    (0..size / 2).map(next).collect()
}

/// Returns the position of element `i` of `size` at the start of the transform: its bits in reverse order.
#[must_use]
pub fn reversed(i: usize, size: usize) -> usize {
    i.reverse_bits() >> (usize::BITS - size.trailing_zeros())
}

/// Calls `butterfly` for each pair of elements of each step, with the index of its turn in [`turns`]. It replaces the two elements by
/// their sum and difference, after the second one is turned.
pub fn steps(size: usize, mut butterfly: impl FnMut(usize, usize, usize)) {
    let mut half = 1;
    while half < size {
        for start in (0..size).step_by(2 * half) {
            for i in 0..half {
                butterfly(start + i, start + i + half, i * (size / (2 * half)));
            }
        }
        half *= 2;
    }
}
