//! Decodes JPEG files at a half, a quarter or an eighth of their sides. Each sample is the mean of the pixels
//! that it covers. This skips most of the inverse transform, colour conversion and memory. It supports
//! sequential files, as cameras write them. For unusual or damaged files it returns no result, and the full
//! decoder reads the file.
//!
//! Sources: ITU-T T.81, annexes A, B and F. The crate `jpeg-decoder` has this feature as well, but it is no
//! longer developed and ten times as large.

use super::header::{Header, segment};
use super::huffman::{Bits, Steps, Table, ZEROS};
use super::{APP14, END_OF_IMAGE, START_OF_SCAN};
use crate::simd::dct::{Block, inverse};

/// A photo at reduced size.
pub(super) struct Reduced {
    /// Width and height of the whole photo.
    pub(super) size: (usize, usize),
    /// Samples for eight of the photo, along each side: 1, 2 or 4.
    pub(super) of_eight: usize,
    /// Brightness, and in colour files two differences of colour, of `width * height` samples: whole blocks, so that some lie beyond
    /// the right and lower edges.
    pub(super) planes: Vec<Vec<u8>>,
    pub(super) width: usize,
    pub(super) height: usize,
}

/// Positions of coefficients in a block, in file order.
const ZIGZAG: [u8; 64] = [
    0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7,
    14, 21, 28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39,
    46, 53, 60, 61, 54, 47, 55, 62, 63,
];

/// By the last coefficient of the file that is not 0: how many columns and rows there are.
const USED: [(u8, u8); 64] = {
    let mut used = [(1, 1); 64];
    let mut k = 1;
    while k < 64 {
        let (columns, rows) = used[k - 1];
        let (x, y) = (ZIGZAG[k] % 8 + 1, ZIGZAG[k] / 8 + 1);
        used[k] = (if x > columns { x } else { columns }, if y > rows { y } else { rows });
        k += 1;
    }
    used
};

/// The largest size of a difference between two blocks, in bits, where samples have eight.
const LONGEST_DIFFERENCE: u8 = 11;

/// Decodes a file whose longer side is twice `longest` or more, to no less than `longest`.
pub(super) fn reduced(bytes: &[u8], longest: usize) -> Option<Reduced> {
    let (header, data) = read_headers(bytes)?;
    let long = header.size.0.max(header.size.1);
    let of_eight = [1, 2, 4].into_iter().find(|part| long * part >= longest.saturating_mul(8))?;
    let (units, unit) = (header.units, header.most_blocks()?);
    // With fewer blocks a component is coarser: of its blocks more samples are made, so that all planes are alike.
    let samples = |index: usize| {
        let component = header.components[index];
        let made = |blocks: usize, most: usize| {
            (matches!(most, 1 | 2) && most.is_multiple_of(blocks)).then(|| of_eight * most / blocks)
        };
        let largest = header.largest(index);
        Some((made(component.blocks.0, unit.0)?, made(component.blocks.1, unit.1)?, largest))
    };
    let samples: Vec<_> = (0..header.components.len()).map(samples).collect::<Option<_>>()?;
    // A block that becomes one sample needs only its first coefficient.
    let steps: Vec<_> = (header.components.iter().zip(&samples))
        .map(|(component, &(wide, high, _))| {
            let others = header.others.get(component.tables.1)?.as_ref()?;
            Some((wide * high == 1).then(|| Steps::new(others)))
        })
        .collect::<Option<_>>()?;
    let (width, height) = (units.0 * unit.0 * of_eight, units.1 * unit.1 * of_eight);
    let mut planes = vec![vec![0; width * height]; header.components.len()];
    let mut lasts = [0i32; 4];
    let interval = if header.interval == 0 { usize::MAX } else { header.interval };
    let (mut bits, mut block) = (Bits::new(data), Block::default());
    for index in 0..units.0 * units.1 {
        if index > 0 && index % interval == 0 {
            bits.restart(index / interval - 1)?;
            lasts = [0; 4];
        }
        let place = (index % units.0, index / units.0);
        for ((((component, plane), last), &(wide, high, largest)), steps) in
            header.components.iter().zip(&mut planes).zip(&mut lasts).zip(&samples).zip(&steps)
        {
            let quantization = header.quantizations.get(component.quantization)?.as_ref()?;
            let first = header.firsts.get(component.tables.0)?.as_ref()?;
            let others = header.others.get(component.tables.1)?.as_ref()?;
            let (across, down) = component.blocks;
            for (x, y) in
                (0..across * down).map(|i| (place.0 * across + i % across, place.1 * down + i / across))
            {
                let (size, difference) = bits.next(first)?;
                *last = last.checked_add(difference)?;
                if size > LONGEST_DIFFERENCE || last.abs() > largest {
                    return None;
                }
                block[0][0] = *last as f32 * quantization[0];
                let end = match steps {
                    Some(steps) => bits.pass(others, steps).filter(|()| bits.sufficed()).map(|()| 0)?,
                    None => coefficients(&mut bits, others, quantization, &mut block)?,
                };
                let out = &mut plane[y * high * width + x * wide..];
                if end == 0 {
                    let value = (block[0][0] / 8.0 + 128.5) as u8;
                    out.chunks_mut(width).take(high).for_each(|row| row[..wide].fill(value));
                } else {
                    let (columns, rows) = USED[end];
                    inverse(&block, (columns.into(), rows.into()), (wide, high), out, width);
                    block = Block::default();
                }
            }
        }
    }
    // More data than units are the mark of damage.
    bits.filling_to()?;
    Some(Reduced { size: header.size, of_eight, planes, width, height })
}

/// Reads the coefficients of a block after its first, in file order.
///
/// Returns the index of the last coefficient that is not 0, or 0.
#[inline]
fn coefficients(
    bits: &mut Bits<'_>,
    table: &Table,
    quantization: &[f32; 64],
    block: &mut Block,
) -> Option<usize> {
    let (mut at, mut last) = (1, 0);
    while at < 64 {
        let (symbol, number) = bits.next(table)?;
        if number == 0 {
            if symbol != ZEROS {
                break;
            }
            at += 16;
            continue;
        }
        at += usize::from(symbol >> 4);
        let place = usize::from(*ZIGZAG.get(at)?);
        block[place / 8][place % 8] = number as f32 * quantization[at];
        (at, last) = (at + 1, at);
    }
    bits.sufficed().then_some(last)
}

/// Reads to the one scan of a sequential file; also gives what follows.
fn read_headers(bytes: &[u8]) -> Option<(Header, &[u8])> {
    let (mut header, mut at) = (Header::default(), 2);
    loop {
        let &[0xFF, marker] = bytes.get(at..)?.first_chunk()? else { return None };
        let (body, end) = segment(bytes, at + 2)?;
        at = end;
        match marker {
            START_OF_SCAN => {
                let (indices, _) = header.read_scan(body)?;
                let is_whole = indices.iter().copied().eq(0..header.components.len());
                return is_whole.then(|| (header, &bytes[at..]));
            }
            // Adobe's marker defines whether components are colour differences.
            APP14 if body.starts_with(b"Adobe") && body.get(11) != Some(&1) => return None,
            // Files of other kinds, and of several pictures.
            0xD0..=END_OF_IMAGE | 0xDC | 0xDE | 0xDF => return None,
            _ => header.read(marker, body)?,
        }
        if header.is_progressive || header.is_rgb() || matches!(header.components.len(), 2 | 4) {
            return None;
        }
    }
}
