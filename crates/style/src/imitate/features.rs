//! The look of a picture, in numbers that depend as little as possible on its content.

use super::colours::{self, Colour, palette};
use super::lines::{Lines, lines};
use super::spectrum::{Screen, screen};
use crate::blocks::flatten::{cell_of, cells};
use crate::context::scale_of;
use crate::order::sort_by;
use crate::raster::resize::{Region, resample_image};
use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;
use crate::simd::table::histogram;
use serde::{Deserialize, Serialize};

/// Pixels at which pictures are measured and styles are tried.
pub(super) const AREA: usize = 160_000;

/// Pixels of the picture for measuring screens. Smaller pictures lose fine screens.
pub(super) const FINE: usize = 1_200_000;

/// Steps of the tones.
pub(super) const TONES: usize = 16;

/// Differences of neighbours up to this many grey steps are ignored.
const EQUAL: u8 = 2;

/// The look of a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Features {
    /// Pixels at which it was measured.
    pub area: usize,
    /// Share of the pixels in each of 16 steps of luma, dark to light.
    pub tones: [f32; TONES],
    /// Its colours, the most common first.
    pub palette: Vec<Colour>,
    /// Thin dark lines.
    pub dark: Lines,
    /// Thin light lines.
    pub light: Lines,
    /// Dots or lines that repeat.
    pub screen: Screen,
    /// Mean difference of pixels from the mean of four, in grey steps, at four sizes from fine to coarse.
    pub texture: [f32; 4],
    /// Share of the pixels that equal their neighbours.
    pub flat: f32,
    /// Mean chroma in Oklab.
    pub chroma: f32,
    /// Standard deviation of the colours of one lightness, in Oklab. It is nearly 0 in prints with one or two
    /// inks.
    pub free: f32,
    /// Number of colours that make up most of the picture, 0 to 1 and more; 0 if not requested, as for
    /// trials.
    pub variety: f32,
    /// Share of the pixels that have one of the ten most common grays, except black and white; 0 if not
    /// requested.
    pub steps: f32,
    /// Share of flat pixels among flat pixels and gentle slopes. It is near 1 if each area has one colour and
    /// a hard edge; 0 if not requested.
    pub terraced: f32,
    /// Share of the pixels next to a hard edge; 0 if not requested.
    pub edges: f32,
}

impl Features {
    /// Measures a picture of any size. A larger picture than needed is reduced first.
    #[must_use]
    pub fn of(picture: &Image) -> Self {
        Self::within(picture, AREA)
    }

    /// Measures at the given maximum number of pixels; trials of styles then use that size.
    #[must_use]
    pub fn within(picture: &Image, area: usize) -> Self {
        let small = reduced(picture, area.min(AREA));
        let fine = reduced(picture, FINE);
        let luma = luma_plane(&fine);
        let (terraced, edges) = terraces(&luma);
        Self {
            terraced,
            edges,
            screen: screen(&luma, scale_of(luma.samples().len() as f64)),
            variety: colours::variety(&small),
            steps: steps(&small),
            ..Self::at_size(&small)
        }
    }

    /// Measures a picture at its measuring size.
    pub(super) fn at_size(picture: &Image) -> Self {
        let luma = luma_plane(picture);
        let area = luma.samples().len();
        let scale = scale_of(area as f64);
        let [dark, light] = lines(&luma, scale);
        let (chroma, free) = freedom(picture);
        Self {
            area,
            tones: tones(&luma),
            palette: palette(picture),
            dark,
            light,
            screen: screen(&luma, scale),
            texture: texture(&luma),
            flat: flat(&luma),
            chroma,
            free,
            variety: 0.0,
            steps: 0.0,
            terraced: 0.0,
            edges: 0.0,
        }
    }

    /// Mean luma, 0 to 1.
    pub(super) fn tone(&self) -> f32 {
        self.tones.iter().enumerate().map(|(i, share)| share * (i as f32 + 0.5) / TONES as f32).sum()
    }
}

/// A picture with at most the given number of pixels.
pub(super) fn reduced(picture: &Image, area: usize) -> Image {
    let (width, height) = (picture.width(), picture.height());
    let factor = (area as f64 / (width as f64 * height as f64)).sqrt().min(1.0);
    let side = |length: usize| ((length as f64 * factor).round() as usize).max(1);
    let image = resample_image(picture, Region::whole(width, height), side(width), side(height));
    match image.planes() {
        // Three planes of one size are always an image.
        [y] => Image::from_rgb([y.clone(), y.clone(), y.clone()]).unwrap_or(image),
        _ => image,
    }
}

fn tones(luma: &Plane) -> [f32; TONES] {
    let counts = histogram(luma.samples());
    let step = 256 / TONES;
    std::array::from_fn(|i| {
        counts[i * step..(i + 1) * step].iter().sum::<u32>() as f32 / luma.samples().len() as f32
    })
}

/// Returns nearly 1 for pictures with few tones; see [`Features::steps`].
fn steps(picture: &Image) -> f32 {
    /// Grays that count as black, and as white.
    const ENDS: usize = 6;
    let luma = luma_plane(picture);
    let mut counts = histogram(luma.samples());
    let between = &mut counts[ENDS..256 - ENDS];
    let total: u32 = between.iter().sum();
    sort_by(between, |a, b| b.cmp(a));
    between[..10].iter().sum::<u32>() as f32 / total.max(1) as f32
}

/// See [`Features::terraced`] and [`Features::edges`].
fn terraces(luma: &Plane) -> (f32, f32) {
    /// Maximum difference of neighbours on a slope, and minimum difference at an edge, in grey levels.
    const SLOPE: u8 = 10;
    const EDGE: u8 = 40;
    let (mut equal, mut slopes, mut edges) = (0u32, 0u32, 0u32);
    for y in 1..luma.height() {
        let (above, row) = (luma.row(y - 1), luma.row(y));
        for x in 1..luma.width() {
            let change = row[x].abs_diff(row[x - 1]).max(row[x].abs_diff(above[x]));
            equal += u32::from(change <= EQUAL);
            slopes += u32::from(change <= SLOPE);
            edges += u32::from(change > EDGE);
        }
    }
    let all = (luma.width() - 1) * (luma.height() - 1);
    (equal as f32 / slopes.max(1) as f32, edges as f32 / all.max(1) as f32)
}

fn texture(luma: &Plane) -> [f32; 4] {
    let (mut width, mut height) = (luma.width(), luma.height());
    let mut here: Vec<f32> = luma.samples().iter().map(|&tone| f32::from(tone)).collect();
    std::array::from_fn(|_| {
        let (half_width, half_height) = (width / 2, height / 2);
        if half_width == 0 || half_height == 0 {
            return 0.0;
        }
        let mut half = Vec::with_capacity(half_width * half_height);
        let mut sum = 0.0;
        for y in 0..half_height {
            let (above, below) = (&here[2 * y * width..], &here[(2 * y + 1) * width..]);
            let mut row = 0.0;
            for x in (0..2 * half_width).step_by(2) {
                let four = [above[x], above[x + 1], below[x], below[x + 1]];
                let mean = 0.25 * (four[0] + four[1] + four[2] + four[3]);
                row += four.iter().map(|tone| (tone - mean).abs()).sum::<f32>();
                half.push(mean);
            }
            sum += f64::from(row);
        }
        let pixels = 4 * half_width * half_height;
        (here, width, height) = (std::mem::take(&mut half), half_width, half_height);
        (sum / pixels as f64) as f32
    })
}

fn flat(luma: &Plane) -> f32 {
    let (width, height) = (luma.width(), luma.height());
    let rows = (0..height).map(|y| {
        let (row, next) = (luma.row(y), luma.row((y + 1).min(height - 1)));
        let same = |x: usize| row[x].abs_diff(row[x + 1]) <= EQUAL && row[x].abs_diff(next[x]) <= EQUAL;
        (0..width - 1).filter(|&x| same(x)).count()
    });
    rows.sum::<usize>() as f32 / (width * height) as f32
}

/// Mean chroma, and how far colours of one lightness are apart.
fn freedom(picture: &Image) -> (f32, f32) {
    /// One pixel in this many is sampled.
    const SPARSE: usize = 7;
    const STEPS: usize = 20;
    let [r, g, b] = picture.planes() else { return (0.0, 0.0) };
    // Count, sums of a and b, and sum of their squares.
    let mut steps = [[0.0f64; 4]; STEPS + 1];
    let mut chroma = 0.0;
    let pixels = r.samples().iter().zip(g.samples()).zip(b.samples()).step_by(SPARSE);
    for ((&r, &g), &b) in pixels {
        let [lightness, a, b] = cells()[cell_of([r, g, b])].map(f64::from);
        let step = &mut steps[((lightness * STEPS as f64) as usize).min(STEPS)];
        chroma += a.hypot(b);
        for (sum, value) in step.iter_mut().zip([1.0, a, b, a * a + b * b]) {
            *sum += value;
        }
    }
    let count: f64 = steps.iter().map(|step| step[0]).sum();
    let inside = |[n, a, b, squares]: &[f64; 4]| if *n > 0.0 { squares - (a * a + b * b) / n } else { 0.0 };
    let spread = (steps.iter().map(inside).sum::<f64>() / count.max(1.0)).max(0.0).sqrt();
    ((chroma / count.max(1.0)) as f32, spread as f32)
}
