//! The difference between two looks, in parts. One unit of each part is barely visible.

use super::colours::{SEVERAL, hues, palette_distance};
use super::features::{Features, TONES};
use super::lines::Lines;
use crate::context::scale_of;

/// Minimum pitch, in pixels of a trial, that is visible in it.
const FINEST: f32 = 2.4;

/// Distance of a screen that has no close-up measurement yet: about as much as a very different screen.
const UNSEEN: f32 = 3.0;

/// Limits at which two looks differ: Delta E 2000 of the palettes, and relative difference of the line
/// density. Both are slightly stricter than human judgement.
const PALETTE: f32 = 3.6;
const LINES: f32 = 0.17;
/// Extra distance beyond these limits.
const MISS: f32 = 1.0;

/// Distance of a look in one hue to a picture in several hues.
const ONE_HUE: f32 = 6.0;

/// The parts of a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Apart {
    /// The difference of the palettes.
    pub(super) palette: f32,
    /// The difference of the remaining features.
    pub(super) shape: f32,
    /// The difference of the screens.
    pub(super) screen: f32,
}

impl Apart {
    pub(super) fn total(self) -> f32 {
        self.palette + self.shape + self.screen
    }
}

/// Returns the distance of the wanted look to another look.
pub(super) fn apart(wanted: &Features, found: &Features) -> Apart {
    let texture: f32 = wanted
        .texture
        .iter()
        .zip(&found.texture)
        .map(|(a, b)| ((a + 0.6) / (b + 0.6)).ln().abs() / 0.35)
        .sum();
    let free = |features: &Features| (features.free + 0.004).ln();
    let palette = palette_distance(&wanted.palette, &found.palette);
    let dense = lines_apart(wanted.dark.density, found.dark.density);
    let missing = (hues(&wanted.palette) - hues(&found.palette)).clamp(0.0, SEVERAL) / SEVERAL;
    Apart {
        palette: palette / 4.0 + if palette > PALETTE { MISS } else { 0.0 } + ONE_HUE * missing,
        shape: if dense > LINES { MISS } else { 0.0 }
            + 0.6 * tones(&wanted.tones, &found.tones) / 0.06
            + lines(wanted.dark, found.dark)
            + 0.7 * lines(wanted.light, found.light)
            + 0.4 * texture
            + 0.8 * (wanted.flat - found.flat).abs() / 0.12
            + 0.5 * (free(wanted) - free(found)).abs() / 0.7,
        screen: if (0.1..FINEST / scale_of(wanted.area as f64)).contains(&wanted.screen.pitch) {
            UNSEEN
        } else {
            screens(wanted, found)
        },
    }
}

/// The difference of the screens of two pictures.
pub(super) fn screens(wanted: &Features, found: &Features) -> f32 {
    let (a, b) = (&wanted.screen, &found.screen);
    let directed = 1.5 * (a.directed - b.directed).abs();
    match (a.pitch > 0.0, b.pitch > 0.0) {
        (true, true) => ((a.pitch / b.pitch).ln().abs() / 0.1).min(3.0) + directed,
        (true, false) => 3.5,
        (false, true) => 1.0 + b.strength,
        (false, false) => 0.0,
    }
}

/// Earth mover's distance of two histograms, in steps of the whole range.
fn tones(a: &[f32; TONES], b: &[f32; TONES]) -> f32 {
    let mut carried = 0.0f32;
    let mut work = 0.0;
    for (a, b) in a.iter().zip(b) {
        carried += a - b;
        work += carried.abs();
    }
    work / TONES as f32
}

/// Returns the relative difference of the line density; 0 if both are nearly 0.
fn lines_apart(wanted: f32, found: f32) -> f32 {
    ((wanted - found).abs() - 0.004).max(0.0) / wanted.max(1e-3)
}

fn lines(a: Lines, b: Lines) -> f32 {
    // Below a hundredth of the picture they hardly count.
    let density = ((a.density + 0.012) / (b.density + 0.012)).ln().abs() / 0.15;
    let both = (a.density.min(b.density) / 0.03).min(1.0);
    let width = if a.width > 0.0 && b.width > 0.0 { (a.width / b.width).ln().abs() / 0.3 } else { 0.0 };
    density.min(6.0) + 0.5 * both * width
}
