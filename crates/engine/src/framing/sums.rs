//! Questions about the energy of any part of a photo, each answered in constant time.

use super::Crop;
use super::energy::EnergyMap;

/// Width of the band along the edges of a crop, as part of its side.
const BAND: f64 = 0.05;
/// Vertical centre of the prior in a photo: heads and gables are above the middle.
const LEVEL: f64 = 0.44;
/// A summed-area table of energy, weighted toward the centre of the photo.
pub(super) struct Sums {
    columns: usize,
    rows: usize,
    /// `(columns + 1) * (rows + 1)` sums of everything above and to the left.
    table: Vec<f64>,
}

impl EnergyMap {
    /// The summed-area table with the centre prior, for many questions about one photo.
    pub(super) fn sums(&self) -> Sums {
        Sums::of(self)
    }
}

impl Sums {
    fn of(map: &EnergyMap) -> Self {
        let (columns, rows) = (map.columns(), map.rows());
        let mut table = vec![0.0; (columns + 1) * (rows + 1)];
        for row in 0..rows {
            let mut line = 0.0;
            for column in 0..columns {
                let off =
                    |i: usize, n: usize, centre: f64| (2.0 * ((i as f64 + 0.5) / n as f64 - centre)).powi(2);
                let prior = 1.0 - 0.3 * (off(column, columns, 0.5) + off(row, rows, LEVEL));
                // A little everywhere, so that a flat photo is cropped about its centre.
                line += prior * (4.0 + f64::from(map.values()[row * columns + column]));
                let at = (row + 1) * (columns + 1) + column + 1;
                table[at] = table[at - columns - 1] + line;
            }
        }
        Self { columns, rows, table }
    }

    /// The share of the photo's energy that lies inside the crop, 0..1.
    pub(super) fn share(&self, crop: &Crop) -> f64 {
        let (right, bottom) = (crop.x + crop.width, crop.y + crop.height);
        let inside = self.up_to(right, bottom) - self.up_to(crop.x, bottom) - self.up_to(right, crop.y)
            + self.up_to(crop.x, crop.y);
        (inside / self.table[self.table.len() - 1]).clamp(0.0, 1.0)
    }

    /// Activity along the edges of the crop: the mean energy of a narrow band inside the edges over the mean
    /// energy of the photo. Content there is cut. A head at the top is worse than feet at the bottom. Edges
    /// on the rim of the photo count like others, or crops would flee to it.
    pub(super) fn cut(&self, crop: &Crop) -> f64 {
        let (bx, by) = (crop.width * BAND, crop.height * BAND);
        let (right, bottom) = (crop.x + crop.width, crop.y + crop.height);
        let bands = [
            (1.0, Crop { width: bx, ..*crop }),
            (1.0, Crop { x: right - bx, width: bx, ..*crop }),
            (2.0, Crop { height: by, ..*crop }),
            (0.5, Crop { y: bottom - by, height: by, ..*crop }),
        ];
        let cost = |band: &Crop| self.share(band) / (band.width * band.height).max(f64::MIN_POSITIVE);
        bands.iter().map(|(weight, band)| weight * cost(band)).sum()
    }

    /// The sum above and to the left of a point, interpolated inside its cell.
    fn up_to(&self, x: f64, y: f64) -> f64 {
        let split = |at: f64, n: usize| {
            let at = (at * n as f64).clamp(0.0, n as f64);
            let cell = (at as usize).min(n - 1);
            (cell, at - cell as f64)
        };
        let ((column, fx), (row, fy)) = (split(x, self.columns), split(y, self.rows));
        let at = |row: usize, column: usize| self.table[row * (self.columns + 1) + column];
        let upper = at(row, column) * (1.0 - fx) + at(row, column + 1) * fx;
        let lower = at(row + 1, column) * (1.0 - fx) + at(row + 1, column + 1) * fx;
        upper * (1.0 - fy) + lower * fy
    }
}
