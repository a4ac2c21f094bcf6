//! Lettering in photos: signs, titles, names on boats. A crop that cuts through text is a mistake, so lines
//! of text count as subjects.
//!
//! Letters are strokes of even width, darker or lighter than their surroundings, of similar height, side by
//! side. These observations are from Epshtein, Ofek, Wexler 2010, "Detecting text in natural scenes with
//! stroke width transform". Here they apply to connected components of a locally thresholded image. The
//! detector prefers misses to false positives, such as fences.

use super::pixel::{luma, rgb};
use super::{LETTERING, Subject};
use crate::order::{sort_by, sort_by_key};
use crate::raster::Image;
use crate::raster::sets::Sets;

/// Maximum number of lines per photo, the largest first.
const MOST: usize = 4;
/// Score of lettering, comparable with detection scores.
const SCORE: f64 = 0.6;
/// Letters of a line at least.
const LEAST_LETTERS: usize = 4;
/// Minimum height of characters in pixels, and range as a fraction of the image height.
const LEAST_HEIGHT: usize = 7;
const MOST_HEIGHT: f64 = 0.3;
/// Stroke width relative to the height of characters.
const STROKES: std::ops::RangeInclusive<f64> = 0.06..=0.42;
/// Half the side of the window whose mean is compared with a stroke, as a fraction of the image's longer
/// side, and the minimum difference in grey levels.
const WINDOW: f64 = 0.06;
const CONTRAST: f64 = 28.0;
/// Minimum contrast between a line of text and its background in grey levels, and the maximum deviation of
/// either, relative to the contrast.
const LEAST_CONTRAST: f64 = 50.0;
const EVEN: f64 = 0.33;

/// A part of the image in one piece.
#[derive(Debug, Clone, Copy)]
struct Piece {
    left: usize,
    top: usize,
    right: usize,
    bottom: usize,
    area: usize,
    /// Sides of its pixels that are not inside of it.
    rim: usize,
    /// Sum of lumas.
    sum: u64,
}

impl Piece {
    fn width(&self) -> f64 {
        (self.right - self.left + 1) as f64
    }

    fn height(&self) -> f64 {
        (self.bottom - self.top + 1) as f64
    }

    fn fill(&self) -> f64 {
        self.area as f64 / (self.width() * self.height())
    }

    /// A stroke of length `l` and width `w` has the area `l w` and about `2 l` sides.
    fn stroke(&self) -> f64 {
        2.0 * self.area as f64 / self.rim.max(1) as f64
    }

    fn shade(&self) -> f64 {
        self.sum as f64 / self.area.max(1) as f64
    }

    fn is_letter(&self, width: usize, height: usize) -> bool {
        let tall = self.height();
        let inside = self.left > 0 && self.top > 0 && self.right + 1 < width && self.bottom + 1 < height;
        inside
            && tall >= LEAST_HEIGHT as f64
            && tall <= MOST_HEIGHT * height as f64
            && (0.08..=1.8).contains(&(self.width() / tall))
            && (0.16..=0.92).contains(&self.fill())
            && STROKES.contains(&(self.stroke() / tall))
    }

    /// Returns whether another piece may be the next character of its line.
    fn precedes(&self, next: &Self) -> bool {
        let tall = self.height().max(next.height());
        let low = self.height().min(next.height());
        let gap = next.left as f64 - self.right as f64;
        let shared = self.bottom.min(next.bottom) as f64 - self.top.max(next.top) as f64 + 1.0;
        tall <= 1.9 * low
            && (-0.1 * tall..=1.1 * tall).contains(&gap)
            && shared >= 0.7 * low
            && self.stroke().max(next.stroke()) <= 2.0 * self.stroke().min(next.stroke())
            && (self.shade() - next.shade()).abs() <= 42.0
    }
}

/// Finds lines of text, in fractions of the image; at most four.
///
/// `image`: the small copy of a photo, some hundred pixels along the longer side. Text lower than 7 of its
/// pixels is not found.
#[must_use]
pub fn lettering(image: &Image) -> Vec<Subject> {
    let (width, height) = (image.width(), image.height());
    if width < 3 * LEAST_HEIGHT || height < 2 * LEAST_HEIGHT {
        return Vec::new();
    }
    let lumas: Vec<u8> =
        (0..height).flat_map(|y| (0..width).map(move |x| luma(rgb(image, x, y)) as u8)).collect();
    let (dark, light) = strokes(&lumas, width, height);
    let mut lines: Vec<Piece> = Vec::new();
    for mask in [dark, light] {
        let letters: Vec<Piece> =
            pieces(&mask, &lumas, width).into_iter().filter(|piece| piece.is_letter(width, height)).collect();
        let sheet = Sheet { mask: &mask, lumas: &lumas, width };
        lines.extend(lines_of(letters).into_iter().filter(|line| sheet.is_printed(line)));
    }
    let mut blocks = joined(lines);
    sort_by(&mut blocks, |a, b| (b.width() * b.height()).total_cmp(&(a.width() * a.height())));
    let subject = |line: &Piece| Subject {
        x: line.left as f64 / width as f64,
        y: line.top as f64 / height as f64,
        width: line.width() / width as f64,
        height: line.height() / height as f64,
        label: LETTERING.to_owned(),
        score: SCORE,
        points: None,
        expression: None,
        light: None,
    };
    blocks.iter().take(MOST).map(subject).collect()
}

/// The image with the pixels of one kind of strokes.
struct Sheet<'a> {
    mask: &'a [bool],
    lumas: &'a [u8],
    width: usize,
}

impl Sheet<'_> {
    /// Whether a line is of one ink on one ground, as signs are, and grass, fur and leaves are not.
    fn is_printed(&self, line: &Piece) -> bool {
        let (mut ink, mut ground) = (Tone::default(), Tone::default());
        for y in line.top..=line.bottom {
            for at in y * self.width + line.left..=y * self.width + line.right {
                (if self.mask[at] { &mut ink } else { &mut ground }).add(self.lumas[at]);
            }
        }
        let contrast = (ink.mean() - ground.mean()).abs();
        contrast >= LEAST_CONTRAST
            && ink.deviation() <= EVEN * contrast
            && ground.deviation() <= EVEN * contrast
    }
}

#[derive(Default)]
struct Tone {
    count: f64,
    sum: f64,
    squares: f64,
}

impl Tone {
    fn add(&mut self, luma: u8) {
        let luma = f64::from(luma);
        (self.count, self.sum, self.squares) =
            (self.count + 1.0, self.sum + luma, self.squares + luma * luma);
    }

    fn mean(&self) -> f64 {
        self.sum / self.count.max(1.0)
    }

    fn deviation(&self) -> f64 {
        (self.squares / self.count.max(1.0) - self.mean().powi(2)).max(0.0).sqrt()
    }
}

/// The pixels that are darker, and the pixels that are lighter, than the mean of their neighbourhood.
fn strokes(lumas: &[u8], width: usize, height: usize) -> (Vec<bool>, Vec<bool>) {
    let mut sums = vec![0u32; (width + 1) * (height + 1)];
    for y in 0..height {
        let mut row = 0;
        for x in 0..width {
            row += u32::from(lumas[y * width + x]);
            sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + row;
        }
    }
    let reach = ((WINDOW * width.max(height) as f64) as usize).max(6);
    let (mut dark, mut light) = (vec![false; lumas.len()], vec![false; lumas.len()]);
    for y in 0..height {
        let (top, bottom) = (y.saturating_sub(reach), (y + reach + 1).min(height));
        for x in 0..width {
            let (left, right) = (x.saturating_sub(reach), (x + reach + 1).min(width));
            let at = |x: usize, y: usize| sums[y * (width + 1) + x];
            let sum = at(right, bottom) + at(left, top) - at(left, bottom) - at(right, top);
            let mean = f64::from(sum) / ((right - left) * (bottom - top)) as f64;
            let here = f64::from(lumas[y * width + x]);
            dark[y * width + x] = here < mean - CONTRAST;
            light[y * width + x] = here > mean + CONTRAST;
        }
    }
    (dark, light)
}

/// The connected parts of a mask, by corners too, by one walk over it with joined labels.
fn pieces(mask: &[bool], lumas: &[u8], width: usize) -> Vec<Piece> {
    let mut labels = vec![u32::MAX; mask.len()];
    let mut sets = Sets::default();
    for i in 0..mask.len() {
        if !mask[i] {
            continue;
        }
        let (first, last) = (i % width == 0, i % width == width - 1);
        let above = i.wrapping_sub(width);
        let before = [
            (!first, i.wrapping_sub(1)),
            (i >= width && !first, above.wrapping_sub(1)),
            (i >= width, above),
            (i >= width && !last, above.wrapping_add(1)),
        ];
        let mut label = u32::MAX;
        for (_, at) in before.into_iter().filter(|&(inside, at)| inside && mask[at]) {
            label = if label == u32::MAX { sets.root(labels[at]) } else { sets.join(label, labels[at]) };
        }
        if label == u32::MAX {
            label = sets.add();
        }
        labels[i] = label;
    }
    let none = Piece { left: usize::MAX, top: usize::MAX, right: 0, bottom: 0, area: 0, rim: 0, sum: 0 };
    let mut pieces = vec![none; sets.len()];
    for i in (0..mask.len()).filter(|&i| mask[i]) {
        let piece = &mut pieces[sets.root(labels[i]) as usize];
        let (x, y) = (i % width, i / width);
        (piece.left, piece.right) = (piece.left.min(x), piece.right.max(x));
        (piece.top, piece.bottom) = (piece.top.min(y), piece.bottom.max(y));
        piece.area += 1;
        piece.sum += u64::from(lumas[i]);
        let open = |inside: bool, at: usize| usize::from(!inside || !mask[at]);
        piece.rim += open(x > 0, i.wrapping_sub(1))
            + open(x + 1 < width, i + 1)
            + open(y > 0, i.wrapping_sub(width))
            + open(i + width < mask.len(), i + width);
    }
    pieces.retain(|piece| piece.area > 0);
    pieces
}

/// Returns rows of adjacent characters on a line.
fn lines_of(mut letters: Vec<Piece>) -> Vec<Piece> {
    sort_by_key(&mut letters, |letter| letter.left);
    let mut used = vec![false; letters.len()];
    let mut lines = Vec::new();
    for first in 0..letters.len() {
        if used[first] {
            continue;
        }
        let mut line = vec![first];
        let mut last = first;
        while let Some(next) = (last + 1..letters.len())
            .filter(|&next| !used[next] && letters[last].precedes(&letters[next]))
            .min_by_key(|&next| letters[next].right)
        {
            line.push(next);
            last = next;
        }
        let row: Vec<Piece> = line.iter().map(|&i| letters[i]).collect();
        if is_line(&row) {
            for &i in &line {
                used[i] = true;
            }
            lines.extend(row.into_iter().reduce(together));
        }
    }
    lines
}

/// Whether pieces in a row are text: enough pieces, on a common base line or top line, and of different
/// shapes. Fences and windows have equal shapes.
fn is_line(row: &[Piece]) -> bool {
    if row.len() < LEAST_LETTERS {
        return false;
    }
    let count = row.len() as f64;
    let tall = row.iter().map(Piece::height).sum::<f64>() / count;
    // Lines may be slanted: measure the distances from a straight line through the lower or upper edges of
    // the characters.
    let strays = |at: &dyn Fn(&Piece) -> f64| {
        let middle = |piece: &Piece| piece.left as f64 + piece.width() / 2.0;
        let (mx, my) = (row.iter().map(middle).sum::<f64>() / count, row.iter().map(at).sum::<f64>() / count);
        let spread: f64 = row.iter().map(|p| (middle(p) - mx).powi(2)).sum();
        let slope = row.iter().map(|p| (middle(p) - mx) * (at(p) - my)).sum::<f64>() / spread.max(1.0);
        let left = |p: &Piece| (at(p) - my - slope * (middle(p) - mx)).abs();
        let close = row.iter().filter(|p| left(p) <= 0.12 * tall + 0.75).count() as f64;
        (1.0 - close / count, slope.abs())
    };
    let (feet, fall) = strays(&|piece| piece.bottom as f64);
    let (heads, _) = strays(&|piece| piece.top as f64);
    let varied = |value: &dyn Fn(&Piece) -> f64| {
        let mean = row.iter().map(value).sum::<f64>() / count;
        let variance = row.iter().map(|piece| (value(piece) - mean).powi(2)).sum::<f64>() / count;
        variance.sqrt() / mean.max(1e-9)
    };
    let fill = row.iter().map(Piece::fill).sum::<f64>() / count;
    fill <= 0.74
        && feet.min(heads) <= 0.25
        && feet.max(heads) <= 0.6
        && fall < 0.35
        && (varied(&Piece::width) > 0.12 || varied(&Piece::fill) > 0.07)
        && varied(&Piece::stroke) < 0.4
        && varied(&Piece::width) < 0.9
}

fn together(a: Piece, b: Piece) -> Piece {
    Piece {
        left: a.left.min(b.left),
        top: a.top.min(b.top),
        right: a.right.max(b.right),
        bottom: a.bottom.max(b.bottom),
        area: a.area + b.area,
        rim: a.rim + b.rim,
        sum: a.sum + b.sum,
    }
}

/// Joins lines that overlap or are close to each other.
fn joined(mut lines: Vec<Piece>) -> Vec<Piece> {
    let near = |a: &Piece, b: &Piece| {
        let apart = |low: usize, high: usize, other: usize, its: usize| {
            other as f64 - high as f64 > 0.0 || low as f64 - its as f64 > 0.0
        };
        let reach = (0.8 * a.height().min(b.height())) as usize;
        !apart(a.left, a.right, b.left, b.right)
            && !apart(a.top.saturating_sub(reach), a.bottom + reach, b.top, b.bottom)
    };
    let mut i = 0;
    while i < lines.len() {
        match (i + 1..lines.len()).find(|&other| near(&lines[i], &lines[other])) {
            Some(other) => {
                lines[i] = together(lines[i], lines[other]);
                lines.swap_remove(other);
                i = 0;
            }
            None => i += 1,
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The 5 x 7 dot matrix of some characters.
    const LETTERS: [(char, [u8; 7]); 7] = [
        ('O', [0x0e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e]),
        ('P', [0x1e, 0x11, 0x11, 0x1e, 0x10, 0x10, 0x10]),
        ('E', [0x1f, 0x10, 0x10, 0x1e, 0x10, 0x10, 0x1f]),
        ('N', [0x11, 0x19, 0x15, 0x15, 0x13, 0x11, 0x11]),
        ('T', [0x1f, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04]),
        ('L', [0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1f]),
        ('S', [0x0f, 0x10, 0x10, 0x0e, 0x01, 0x01, 0x1e]),
    ];

    struct Wall {
        pixels: Vec<u8>,
    }

    const SIZE: (usize, usize) = (400, 300);

    impl Wall {
        fn new(shade: impl Fn(usize, usize) -> u8) -> Self {
            let at = |i: usize| shade(i % SIZE.0, i / SIZE.0);
            Self { pixels: (0..SIZE.0 * SIZE.1).map(at).collect() }
        }

        fn write(mut self, text: &str, left: usize, top: usize, dot: usize, shade: u8) -> Self {
            for (place, letter) in text.chars().enumerate() {
                let rows = LETTERS.iter().find(|(name, _)| *name == letter).unwrap().1;
                for (y, row) in rows.iter().enumerate() {
                    for x in (0..5).filter(|x| row & (16 >> x) != 0) {
                        self.fill(left + (6 * place + x) * dot, top + y * dot, dot, dot, shade);
                    }
                }
            }
            self
        }

        fn fill(&mut self, left: usize, top: usize, width: usize, height: usize, shade: u8) {
            for y in top..top + height {
                self.pixels[y * SIZE.0 + left..][..width].fill(shade);
            }
        }

        fn found(&self) -> Vec<Subject> {
            let rgba: Vec<u8> = self.pixels.iter().flat_map(|grey| [*grey, *grey, *grey, 255]).collect();
            lettering(&Image::from_rgba(SIZE.0, SIZE.1, &rgba, [255; 3]).unwrap())
        }
    }

    fn grain(x: usize, y: usize) -> u8 {
        ((x * 7919 + y * 104_729 + x * y * 31) % 23) as u8
    }

    #[test]
    fn a_sign_is_found_where_it_is_dark_on_light_and_light_on_dark() {
        for (ground, ink) in [(200, 30), (40, 220)] {
            let found = Wall::new(|x, y| ground + grain(x, y)).write("OPEN", 100, 80, 4, ink).found();
            let [sign] = &found[..] else { panic!("one sign: {found:?}") };
            assert_eq!(sign.label, LETTERING);
            let near = |value: f64, wanted: f64| (value - wanted).abs() < 0.02;
            assert!(near(sign.x, 0.25) && near(sign.y, 80.0 / 300.0), "{sign:?}");
            assert!(near(sign.width, 92.0 / 400.0) && near(sign.height, 28.0 / 300.0), "{sign:?}");
        }
    }

    #[test]
    fn two_lines_are_one_sign() {
        let wall =
            Wall::new(|x, y| 180 + grain(x, y)).write("OPEN", 60, 80, 4, 20).write("POLE", 60, 125, 4, 20);
        assert_eq!(wall.found().len(), 1);
    }

    #[test]
    fn fences_windows_grain_and_edges_are_no_words() {
        let mut fence = Wall::new(|x, y| 190 + grain(x, y));
        for i in 0..14 {
            fence.fill(30 + 24 * i, 60, 9, 60, 40);
        }
        let mut windows = Wall::new(|x, y| 190 + grain(x, y));
        (0..4).for_each(|row| (0..9).for_each(|i| windows.fill(30 + 40 * i, 30 + 60 * row, 22, 34, 50)));
        let noise = Wall::new(|x, y| ((x * 7919) ^ (y * 104_729) ^ (x * y * 31)) as u8);
        let slope = Wall::new(|x, _| (x * 255 / 400) as u8);
        for (name, wall) in [("fence", fence), ("windows", windows), ("noise", noise), ("slope", slope)] {
            assert!(wall.found().is_empty(), "{name}: {:?}", wall.found());
        }
    }

    #[test]
    fn three_letters_and_small_images_have_none() {
        assert!(Wall::new(|_, _| 200).write("TEN", 60, 60, 4, 20).found().is_empty());
        for size in [(1, 1), (1, 400), (400, 1), (20, 13)] {
            let image = Image::from_rgba(size.0, size.1, &vec![9; size.0 * size.1 * 4], [255; 3]).unwrap();
            assert!(lettering(&image).is_empty());
        }
    }
}
