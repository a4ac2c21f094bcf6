//! Data of a video frame for shot detection: a copy of 64 x 36 pixels, and the sharpness of the frame.
//!
//! A two-hour video has some ten thousand such samples of 3.5 kB each.

use crate::error::{Error, Result};

/// Cells of the luma copy.
const CELLS: [usize; 2] = [64, 36];
/// Cells of each chroma copy.
const CHROMA: [usize; 2] = [32, 18];
/// Cells of each channel of a [`Coarse`] copy.
const COARSE: [usize; 2] = [16, 9];
/// Maximum width for measuring sharpness, in pixels. Finer detail is invisible in panels.
const ACROSS: usize = 640;
/// Maximum standard deviation of luma in an empty frame: black, white, one colour.
const FLAT: f32 = 6.0;
/// Tolerance around the most frequent grey level for the background of a title.
const GROUND: usize = 8;
/// Share of a frame that the ground of a title takes.
const TITLE: f32 = 0.72;
/// Largest mean distance of the chroma of a title from its own mean.
const COLOURLESS: f32 = 6.0;

/// One channel of a decoded frame.
#[derive(Debug, Clone, Copy)]
pub struct Samples<'a> {
    /// The channel's first sample and all that follows.
    pub bytes: &'a [u8],
    /// Bytes from one row to the next.
    pub stride: usize,
    /// Bytes from one sample to the next: 1 for a separate plane, 2 in NV12, 4 in RGBA.
    pub step: usize,
    /// Samples across.
    pub width: usize,
    /// Samples down.
    pub height: usize,
}

impl<'a> Samples<'a> {
    /// A channel whose last sample is within `bytes`.
    ///
    /// # Errors
    /// `buffer-size`.
    pub fn new(
        bytes: &'a [u8],
        [stride, step]: [usize; 2],
        [width, height]: [usize; 2],
    ) -> Result<Samples<'a>> {
        let row = width.checked_sub(1).and_then(|last| last.checked_mul(step)).map(|last| last + 1);
        let rows = height.checked_sub(1).and_then(|last| last.checked_mul(stride));
        let needed = row.zip(rows).and_then(|(row, rows)| rows.checked_add(row));
        match needed {
            Some(needed) if needed <= bytes.len() && step > 0 => {
                Ok(Self { bytes, stride, step, width, height })
            }
            _ => Err(Error::BufferSize {
                width,
                height,
                expected: needed.unwrap_or(usize::MAX),
                actual: bytes.len(),
            }),
        }
    }

    #[inline]
    fn at(&self, x: usize, y: usize) -> u8 {
        self.bytes[y * self.stride + x * self.step]
    }

    /// Means over cells of about the same size.
    fn reduced([columns, rows]: [usize; 2], channel: &Samples) -> Vec<u8> {
        let edge = |i: usize, cells: usize, length: usize| {
            let from = i * length / cells;
            (from, ((i + 1) * length / cells).max(from + 1))
        };
        let mut cells = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            let (top, bottom) = edge(row, rows, channel.height);
            for column in 0..columns {
                let (left, right) = edge(column, columns, channel.width);
                let mut sum = 0u32;
                for y in top..bottom {
                    let line = &channel.bytes[y * channel.stride + left * channel.step..];
                    sum += line
                        .iter()
                        .step_by(channel.step)
                        .take(right - left)
                        .map(|&v| u32::from(v))
                        .sum::<u32>();
                }
                cells.push((sum / ((right - left) * (bottom - top)) as u32) as u8);
            }
        }
        cells
    }

    /// Root of the mean square of the Laplacian, in grey steps, at most [`ACROSS`] pixels across.
    fn sharpness(&self) -> f32 {
        let factor = self.width.max(self.height).div_ceil(ACROSS).max(1);
        let (width, height) = (self.width / factor, self.height / factor);
        if width < 3 || height < 3 {
            return 0.0;
        }
        let small: Vec<i16> = if factor == 1 {
            (0..height).flat_map(|y| (0..width).map(move |x| i16::from(self.at(x, y)))).collect()
        } else {
            Self::reduced([width, height], self).into_iter().map(i16::from).collect()
        };
        let mut sum = 0u64;
        for rows in small.windows(3 * width).step_by(width) {
            let (above, line) = rows.split_at(width);
            let (line, below) = line.split_at(width);
            let squares = (1..width - 1).map(|x| {
                let laplacian =
                    i32::from(above[x] + below[x] + line[x - 1] + line[x + 1]) - 4 * i32::from(line[x]);
                (laplacian * laplacian) as u64
            });
            sum += squares.sum::<u64>();
        }
        (sum as f32 / ((width - 2) * (height - 2)) as f32).sqrt()
    }
}

/// Stored data of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    luma: Vec<u8>,
    chroma: [Vec<u8>; 2],
    /// How sharp it is, in grey steps: comparable between frames that show the same.
    pub sharpness: f32,
    /// Standard deviation of luma: a frame that fades has less than its shot.
    pub deviation: f32,
    /// Mean of luma.
    pub mean: f32,
    /// Whether the frame is blank: black, white or one colour.
    pub flat: bool,
    /// Whether the frame is a title: mainly text on an even background.
    pub title: bool,
}

impl Look {
    /// Looks at luma and the two channels of chroma.
    #[must_use]
    pub fn of(luma: &Samples, chroma: [&Samples; 2]) -> Self {
        let sharpness = luma.sharpness();
        Self::new(Samples::reduced(CELLS, luma), chroma.map(|c| Samples::reduced(CHROMA, c)), sharpness)
    }

    /// Samples interleaved RGBA or BGRA pixels. The order of channels does not change distances.
    ///
    /// # Errors
    /// `buffer-size` if the number of bytes is not `4 * width * height`.
    pub fn of_rgba(rgba: &[u8], width: usize, height: usize) -> Result<Self> {
        let channel =
            |i: usize| Samples::new(rgba.get(i..).unwrap_or_default(), [4 * width, 4], [width, height]);
        let [red, green, blue] = [channel(0)?, channel(1)?, channel(2)?];
        let luma: Vec<u8> = rgba
            .chunks_exact(4)
            .map(|p| ((77 * u32::from(p[0]) + 150 * u32::from(p[1]) + 29 * u32::from(p[2])) >> 8) as u8)
            .collect();
        let sharpness = Samples::new(&luma, [width, 1], [width, height])?.sharpness();
        let [small_red, small_green, small_blue] =
            [&red, &green, &blue].map(|channel| Samples::reduced(CHROMA, channel));
        let colour = |channel: &[u8]| -> Vec<u8> {
            channel
                .iter()
                .zip(&small_green)
                .map(|(&c, &green)| (128 + (i32::from(c) - i32::from(green)) / 2).clamp(0, 255) as u8)
                .collect()
        };
        let chroma = [colour(&small_blue), colour(&small_red)];
        let luma = Samples::reduced(CELLS, &Samples::new(&luma, [width, 1], [width, height])?);
        Ok(Self::new(luma, chroma, sharpness))
    }

    fn new(luma: Vec<u8>, chroma: [Vec<u8>; 2], sharpness: f32) -> Self {
        let count = luma.len() as f32;
        let mean = luma.iter().map(|&v| f32::from(v)).sum::<f32>() / count;
        let deviation = (luma.iter().map(|&v| (f32::from(v) - mean).powi(2)).sum::<f32>() / count).sqrt();
        let colourless = chroma.iter().all(|channel| spread(channel) < COLOURLESS);
        let flat = deviation < FLAT && colourless;
        let title = !flat && colourless && ground(&luma) >= TITLE;
        Self { luma, chroma, sharpness, deviation, mean, flat, title }
    }

    /// How different two frames are: the mean difference of their cells, luma and both chromas together, in grey steps.
    #[must_use]
    pub fn distance(&self, other: &Self) -> f32 {
        let luma = mean_difference(&self.luma, &other.luma);
        let chroma: f32 = self.chroma.iter().zip(&other.chroma).map(|(a, b)| mean_difference(a, b)).sum();
        0.6 * luma + 0.8 * chroma
    }

    /// Returns the correlation of the luma of two frames, -1 to 1: 1 if one is a brighter copy of the other, 0 if they have
    /// nothing in common or one of them is even.
    #[must_use]
    pub(super) fn correlation(&self, other: &Self) -> f64 {
        let product: f64 = self
            .luma
            .iter()
            .zip(&other.luma)
            .map(|(&a, &b)| f64::from((f32::from(a) - self.mean) * (f32::from(b) - other.mean)))
            .sum();
        let scale = f64::from(self.deviation * other.deviation) * self.luma.len() as f64;
        if scale > 0.0 { product / scale } else { 0.0 }
    }

    /// Returns a copy in which small movements do not show.
    #[must_use]
    pub(super) fn coarse(&self) -> Coarse {
        let [blue, red] = &self.chroma;
        let channels = [(&self.luma, CELLS), (blue, CHROMA), (red, CHROMA)];
        let reduced = channels.map(|(cells, [width, height])| {
            Samples::reduced(COARSE, &Samples { bytes: cells, stride: width, step: 1, width, height })
        });
        Coarse(reduced.concat())
    }

    /// How different the tones of two frames are, wherever they stand: half the sum of the differences of their histograms
    /// of 32 bins, 0 to 1.
    #[must_use]
    pub fn tones(&self, other: &Self) -> f32 {
        let (a, b) = (bins(&self.luma), bins(&other.luma));
        let sum: u32 = a.iter().zip(&b).map(|(a, b)| a.abs_diff(*b)).sum();
        sum as f32 / (2 * self.luma.len()) as f32
    }
}

/// Luma and both chromas of a frame in a few large cells.
#[derive(Debug, Clone)]
pub(super) struct Coarse(Vec<u8>);

impl Coarse {
    /// Number of values.
    pub(super) const CELLS: usize = 3 * COARSE[0] * COARSE[1];

    /// Returns the sum of the squared differences of all cells.
    pub(super) fn squared_distance(&self, other: &Self) -> f64 {
        let square = |(&a, &b): (&u8, &u8)| (i32::from(a) - i32::from(b)).pow(2);
        f64::from(self.0.iter().zip(&other.0).map(square).sum::<i32>())
    }

    /// Returns the position of this frame between two others, as a fraction of their squared distance: 0 at
    /// the first.
    pub(super) fn share(&self, first: &Self, last: &Self) -> f64 {
        let product =
            |((&x, &a), &b): ((&u8, &u8), &u8)| (i32::from(x) - i32::from(a)) * (i32::from(b) - i32::from(a));
        f64::from(self.0.iter().zip(&first.0).zip(&last.0).map(product).sum::<i32>())
    }
}

fn bins(cells: &[u8]) -> [u32; 32] {
    let mut bins = [0; 32];
    for &value in cells {
        bins[usize::from(value / 8)] += 1;
    }
    bins
}

fn mean_difference(a: &[u8], b: &[u8]) -> f32 {
    let sum: u32 = a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
    sum as f32 / a.len().max(1) as f32
}

/// Mean distance of a channel from its mean.
fn spread(channel: &[u8]) -> f32 {
    let mean = channel.iter().map(|&v| u32::from(v)).sum::<u32>() / channel.len().max(1) as u32;
    mean_difference(channel, &vec![mean as u8; channel.len()])
}

/// The share of the cells about the most frequent tone.
fn ground(luma: &[u8]) -> f32 {
    let mut counts = [0u32; 256];
    for &value in luma {
        counts[usize::from(value)] += 1;
    }
    let most = (0..256).map(|tone: usize| {
        counts[tone.saturating_sub(GROUND)..(tone + GROUND + 1).min(256)].iter().sum::<u32>()
    });
    most.max().unwrap_or(0) as f32 / luma.len().max(1) as f32
}
