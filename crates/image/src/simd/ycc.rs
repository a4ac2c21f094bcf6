//! Brightness and two differences of colour, as JPEG has them, turned to red, green and blue. Source: ITU-T T.871, 7.

use super::lanes::{widen_high, widen_low};
use super::mix::{LANES, load_part};
use wide::{i16x8, u8x16};

/// Sixteen samples as two halves of sixteen bits.
type Wide = [i16x8; 2];

/// Turns rows of one length in place: from Y, Cb and Cr to R, G and B, each rounded to the nearest.
pub fn rgb_of_ycc([y, u, v]: [&mut [u8]; 3]) {
    let [(y, y_end), (u, u_end), (v, v_end)] = [y, u, v].map(<[u8]>::as_chunks_mut::<LANES>);
    for ((y, u), v) in y.iter_mut().zip(u).zip(v) {
        [*y, *u, *v] = turned([*y, *u, *v].map(u8x16::new)).map(u8x16::to_array);
    }
    // The narrow rest apart: a copy of unknown length is a call, and a slow one in wasm.
    let ends = turned([&*y_end, u_end, v_end].map(load_part));
    for (out, lanes) in [y_end, u_end, v_end].into_iter().zip(ends) {
        out.copy_from_slice(&lanes.as_array()[..out.len()]);
    }
}

#[inline]
fn turned([y, u, v]: [u8x16; 3]) -> [u8x16; 3] {
    let widen = |samples: u8x16| -> Wide { [widen_low(samples), widen_high(samples)] };
    let y = widen(y);
    // Differences, which are -128 to 127, in 128ths.
    let [u, v] = [u, v].map(|samples| widen(samples).map(|half| (half - i16x8::splat(128)) << 7));
    let parts = |half: usize, of_u: f32, of_v: f32| {
        let times = |lanes: i16x8, factor: f32| {
            lanes.mul_scale_round(i16x8::splat((factor * 32768.0).round() as i16))
        };
        times(u[half], of_u) + times(v[half], of_v)
    };
    // A factor above 1 is 1 and the rest of it, which fits the product.
    let red = [0, 1].map(|half| (parts(half, 0.0, 0.402), v[half]));
    let green = [0, 1].map(|half| (parts(half, -0.344_136, -0.714_136), i16x8::ZERO));
    let blue = [0, 1].map(|half| (parts(half, 0.772, 0.0), u[half]));
    [red, green, blue].map(|channel| {
        let sum = |half: usize| {
            let (part, whole) = channel[half];
            y[half] + (whole >> 7) + ((part + i16x8::splat(64)) >> 7)
        };
        u8x16::narrow_i16x8(sum(0), sum(1))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_colour_is_that_of_the_definition() {
        let all: Vec<u8> = (0..=255).collect();
        for u in 0..=255u8 {
            for v in (0..=255u8).step_by(3) {
                let [mut red, mut green, mut blue] = [all.clone(), vec![u; 256], vec![v; 256]];
                rgb_of_ycc([&mut red, &mut green, &mut blue]);
                let (du, dv) = (f64::from(u) - 128.0, f64::from(v) - 128.0);
                for y in 0..256 {
                    let exact = [1.402 * dv, -0.344_136 * du - 0.714_136 * dv, 1.772 * du];
                    for (seen, exact) in [red[y], green[y], blue[y]].into_iter().zip(exact) {
                        let exact = (y as f64 + exact).clamp(0.0, 255.0);
                        assert!((f64::from(seen) - exact).abs() < 0.52, "{seen} for {exact} of {y} {u} {v}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_end_of_a_row_is_turned_as_well() {
        for length in 0..40 {
            let rows = || [vec![100; length], vec![90; length], vec![200; length]];
            let [mut y, mut u, mut v] = rows();
            rgb_of_ycc([&mut y, &mut u, &mut v]);
            assert_eq!([y, u, v], [vec![201; length], vec![62; length], vec![33; length]]);
        }
    }
}
