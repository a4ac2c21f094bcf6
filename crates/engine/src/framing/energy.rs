//! Energy map: gradient energy of a photo on a coarse grid, as a guess of interesting areas before detection.

use serde::{Deserialize, Serialize};

use super::Crop;
use super::pixel::{luma, rgb};
use crate::raster::Image;

/// Cells along the longer side of a photo.
const LONGEST: usize = 48;
/// Maximum pixels along the longer side that are analysed. More pixels give the same map.
const SAMPLES: usize = 480;

/// The part of detail in the energy of a cell; the rest is contrast of colour.
const GRADIENT: f64 = 0.6;
/// Steps of each of R, G and B when the colours of a photo are counted.
const LEVELS: usize = 6;

/// Energy of the cells of a grid laid over a photo, row by row from the top left; the strongest cell has 255.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Hexadecimal", into = "Hexadecimal")]
pub struct EnergyMap {
    columns: usize,
    rows: usize,
    values: Vec<u8>,
}

impl EnergyMap {
    /// Measures a photo (any size; a small one will do). A cell's energy combines two parts. `GRADIENT` is
    /// the weight of its mean luma gradient, the sum of the absolute central differences in x and y. The rest
    /// is the distance of its colour from the colours of the whole photo (see `contrast`). Detail only would
    /// prefer grass to a smooth face in front of it.
    #[must_use]
    pub fn of(image: &Image) -> Self {
        let (width, height) = (image.width(), image.height());
        let longest = width.max(height);
        let cells = |side: usize| (side * LONGEST).div_ceil(longest).clamp(1, side.min(LONGEST));
        let (columns, rows) = (cells(width), cells(height));
        let step = longest.div_ceil(SAMPLES);
        let mut sums = vec![Cell::default(); columns * rows];
        for y in (0..height).step_by(step) {
            let (above, below) = (y.saturating_sub(step), (y + step).min(height - 1));
            for x in (0..width).step_by(step) {
                let (left, right) = (x.saturating_sub(step), (x + step).min(width - 1));
                let across = luma(rgb(image, right, y)).abs_diff(luma(rgb(image, left, y)));
                let down = luma(rgb(image, x, below)).abs_diff(luma(rgb(image, x, above)));
                sums[(y * rows / height) * columns + x * columns / width]
                    .add(across + down, rgb(image, x, y));
            }
        }
        let gradients = stretched(&sums.iter().map(|cell| cell.mean(cell.gradient)).collect::<Vec<_>>());
        let colours: Vec<[f64; 3]> = sums.iter().map(|cell| cell.rgb.map(|sum| cell.mean(sum))).collect();
        let contrasts = stretched(&contrast(&colours));
        let energy = |(g, c): (&f64, &f64)| GRADIENT * g + (1.0 - GRADIENT) * c;
        let energies: Vec<f64> = gradients.iter().zip(&contrasts).map(energy).collect();
        let values = stretched(&energies).iter().map(|e| (e * 255.0).round() as u8).collect();
        Self { columns, rows, values }
    }

    /// A map without anything to see, for photos that were never measured.
    #[must_use]
    pub fn flat() -> Self {
        Self { columns: 1, rows: 1, values: vec![0] }
    }

    /// Cells across.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Cells down.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The cells, row by row.
    #[must_use]
    pub fn values(&self) -> &[u8] {
        &self.values
    }

    /// The cells of a part of the photo.
    pub(super) fn part(&self, part: &Crop) -> Self {
        let cells = |from: f64, length: f64, count: usize| {
            let first = ((from * count as f64).round() as usize).min(count - 1);
            (first, (((from + length) * count as f64).round() as usize).clamp(first + 1, count))
        };
        let (left, right) = cells(part.x, part.width, self.columns);
        let (top, bottom) = cells(part.y, part.height, self.rows);
        let row = |y: usize| self.values[y * self.columns + left..y * self.columns + right].iter().copied();
        Self { columns: right - left, rows: bottom - top, values: (top..bottom).flat_map(row).collect() }
    }
}

/// Sums over the samples of a cell.
#[derive(Clone, Copy, Default)]
struct Cell {
    gradient: u64,
    rgb: [u64; 3],
    samples: u64,
}

impl Cell {
    fn add(&mut self, gradient: u32, rgb: [u8; 3]) {
        self.gradient += u64::from(gradient);
        self.samples += 1;
        for (sum, value) in self.rgb.iter_mut().zip(rgb) {
            *sum += u64::from(value);
        }
    }

    fn mean(&self, sum: u64) -> f64 {
        sum as f64 / self.samples.max(1) as f64
    }
}

/// Mean distance of each colour to all others: high for outstanding colours, low for sky, grass and walls.
/// Histogram-based contrast after Cheng et al., "Global Contrast Based Salient Region Detection" (2011), with
/// the colours of the cells counted in a few steps of R, G and B.
fn contrast(colours: &[[f64; 3]]) -> Vec<f64> {
    let step = |value: f64| ((value * LEVELS as f64 / 256.0) as usize).min(LEVELS - 1);
    let bin = |rgb: &[f64; 3]| rgb.iter().fold(0, |index, value| index * LEVELS + step(*value));
    let mut bins = vec![([0.0; 3], 0.0); LEVELS * LEVELS * LEVELS];
    for rgb in colours {
        let (sum, count) = &mut bins[bin(rgb)];
        *count += 1.0;
        for (sum, value) in sum.iter_mut().zip(rgb) {
            *sum += value;
        }
    }
    bins.retain(|(_, count)| *count > 0.0);
    let means: Vec<([f64; 3], f64)> = bins.iter().map(|(sum, n)| (sum.map(|s| s / n), *n)).collect();
    let distance =
        |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    colours.iter().map(|rgb| means.iter().map(|(mean, n)| n * distance(rgb, mean)).sum()).collect()
}

/// Scales the values to 0..=1; all 0 if they are equal.
fn stretched(values: &[f64]) -> Vec<f64> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let range = if high - low > 1e-9 { high - low } else { f64::INFINITY };
    values.iter().map(|value| (value - low) / range).collect()
}

/// An energy map as JSON has it: two hexadecimal digits a cell.
#[derive(Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "EnergyMap"))]
pub(crate) struct Hexadecimal {
    columns: usize,
    rows: usize,
    values: String,
}

impl From<EnergyMap> for Hexadecimal {
    fn from(map: EnergyMap) -> Self {
        let digit = |value: u8| char::from_digit(u32::from(value), 16).unwrap_or('0');
        let values = map.values.iter().flat_map(|value| [digit(value >> 4), digit(value & 15)]).collect();
        Self { columns: map.columns, rows: map.rows, values }
    }
}

impl TryFrom<Hexadecimal> for EnergyMap {
    type Error = String;

    fn try_from(text: Hexadecimal) -> Result<Self, String> {
        let (columns, rows) = (text.columns, text.rows);
        let sides = 1..=4 * LONGEST;
        if !sides.contains(&columns) || !sides.contains(&rows) || text.values.len() != columns * rows * 2 {
            return Err(format!("an energy map of {columns} x {rows} cells has two digits per cell"));
        }
        let digit = |byte: u8| char::from(byte).to_digit(16).map(|digit| digit as u8);
        let cell = |pair: &[u8]| Some(digit(pair[0])? << 4 | digit(pair[1])?);
        let values = text.values.as_bytes().chunks_exact(2).map(cell).collect::<Option<Vec<u8>>>();
        let values = values.ok_or("an energy map is written in hexadecimal digits")?;
        Ok(Self { columns, rows, values })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    /// A gray image that is busy only inside x0..x1, y0..y1.
    fn busy(width: usize, height: usize, x: std::ops::Range<usize>, y: std::ops::Range<usize>) -> Image {
        Image::from_luma(Plane::from_fn(width, height, |px, py| {
            if x.contains(&px) && y.contains(&py) && (px / 2 + py / 2) % 2 == 0 { 220 } else { 90 }
        }))
    }

    #[test]
    fn energy_lies_where_the_detail_is() {
        let map = EnergyMap::of(&busy(200, 100, 120..160, 20..60));
        assert_eq!((map.columns(), map.rows()), (48, 24));
        assert_eq!(map.values().iter().max(), Some(&255));
        let sums = map.sums();
        let crop = |x, y, width, height| Crop { x, y, width, height };
        assert!(sums.share(&crop(0.55, 0.15, 0.3, 0.5)) > 0.7);
        assert!(sums.share(&crop(0.0, 0.0, 0.5, 1.0)) < 0.2);
        assert!((sums.share(&crop(0.0, 0.0, 1.0, 1.0)) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn any_size_has_a_map() {
        for (width, height) in [(1, 1), (1, 10_000), (3, 2), (5000, 7)] {
            let map = EnergyMap::of(&Image::from_luma(Plane::filled(width, height, 7)));
            assert_eq!(map.values().len(), map.columns() * map.rows());
            let all = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
            assert!((map.sums().share(&all) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn maps_survive_json() {
        let map = EnergyMap::of(&busy(90, 120, 10..50, 30..70));
        let json = serde_json::to_string(&map).unwrap();
        assert_eq!(serde_json::from_str::<EnergyMap>(&json).unwrap(), map);
        for bad in [
            r#"{"columns":2,"rows":1,"values":"00f"}"#,
            r#"{"columns":0,"rows":0,"values":""}"#,
            r#"{"columns":1,"rows":1,"values":"zz"}"#,
            r#"{"columns":18446744073709551615,"rows":2,"values":""}"#,
        ] {
            assert!(serde_json::from_str::<EnergyMap>(bad).is_err(), "{bad}");
        }
    }
}
