//! JPEG files decoded at a half, a quarter or an eighth of their sides, each sample the mean of those that it stands for: most of the
//! inverse transform, of the colours and of the memory of a photo is for pixels that nobody is going to see. The sequential files of
//! cameras are read so; where anything is unusual, or wrong, there is no result, and the decoder of whole files has its say.
//!
//! Sources: ITU-T T.81, annexes A, B and F. `jpeg-decoder` can do it, too: it is no longer developed, and of ten times the size.

use super::huffman::{Bits, Table};
use super::{APP14, END_OF_IMAGE, START_OF_SCAN};
use crate::simd::dct::{Block, inverse};

/// What a photo looks like in small.
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

/// Where coefficients stand in a block, in the order of the file.
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

const HUFFMAN_TABLES: u8 = 0xC4;
const QUANTIZATION_TABLES: u8 = 0xDB;
const RESTART_INTERVAL: u8 = 0xDD;
/// The largest size of a difference between two blocks, in bits, where samples have eight.
const LONGEST_DIFFERENCE: u8 = 11;
/// Sixteen zeros, behind which the block goes on.
const ZEROS: u8 = 0xF0;

/// A component of the picture.
struct Component {
    id: u8,
    /// Blocks side by side, and one above the other, of each unit of the scan.
    blocks: (usize, usize),
    /// Samples of a block that are made.
    samples: (usize, usize),
    quantization: usize,
    /// Tables of the first coefficient and of the others.
    tables: (usize, usize),
    /// The first coefficient of the block before.
    last: i32,
}

/// What stands before the data of a scan.
#[derive(Default)]
struct Header {
    size: (usize, usize),
    components: Vec<Component>,
    quantizations: [Option<[f32; 64]>; 4],
    firsts: [Option<Table>; 4],
    others: [Option<Table>; 4],
    /// Units between two restarts, or 0.
    interval: usize,
}

/// Decodes a file whose longer side is twice `longest` or more, to no less than `longest`.
pub(super) fn reduced(bytes: &[u8], longest: usize) -> Option<Reduced> {
    let (mut header, data) = Header::read(bytes)?;
    let long = header.size.0.max(header.size.1);
    let of_eight = [1, 2, 4].into_iter().find(|part| long * part >= longest.saturating_mul(8))?;
    let Header { size, components, interval, .. } = &mut header;
    let largest = |side: fn(&Component) -> usize| components.iter().map(side).max();
    let unit = (largest(|one| one.blocks.0)?, largest(|one| one.blocks.1)?);
    // With fewer blocks a component is coarser: of its blocks more samples are made, so that all planes are alike.
    for component in &mut *components {
        let made = |blocks: usize, most: usize| {
            (blocks > 0 && matches!(most, 1 | 2) && most.is_multiple_of(blocks))
                .then(|| of_eight * most / blocks)
        };
        component.samples = (made(component.blocks.0, unit.0)?, made(component.blocks.1, unit.1)?);
    }
    let units = (size.0.div_ceil(8 * unit.0), size.1.div_ceil(8 * unit.1));
    let (width, height) = (units.0 * unit.0 * of_eight, units.1 * unit.1 * of_eight);
    let mut planes = vec![vec![0; width * height]; components.len()];
    let interval = if *interval == 0 { usize::MAX } else { *interval };
    let (mut bits, mut block) = (Bits::new(data), Block::default());
    for index in 0..units.0 * units.1 {
        if index > 0 && index % interval == 0 {
            bits.restart(index / interval - 1)?;
            header.components.iter_mut().for_each(|component| component.last = 0);
        }
        let place = (index % units.0, index / units.0);
        for (component, plane) in header.components.iter_mut().zip(&mut planes) {
            let quantization = header.quantizations.get(component.quantization)?.as_ref()?;
            let first = header.firsts.get(component.tables.0)?.as_ref()?;
            let others = header.others.get(component.tables.1)?.as_ref()?;
            let (across, down) = component.blocks;
            for (x, y) in
                (0..across * down).map(|i| (place.0 * across + i % across, place.1 * down + i / across))
            {
                let (size, difference) = bits.next(first)?;
                if size > LONGEST_DIFFERENCE {
                    return None;
                }
                component.last = component.last.checked_add(difference)?;
                block[0][0] = component.last as f32 * quantization[0];
                let last = coefficients(&mut bits, others, quantization, &mut block)?;
                let (wide, high) = component.samples;
                let out = &mut plane[y * high * width + x * wide..];
                if last == 0 {
                    let value = (block[0][0] / 8.0 + 128.5) as u8;
                    out.chunks_mut(width).take(high).for_each(|row| row[..wide].fill(value));
                } else {
                    let (columns, rows) = USED[last];
                    inverse(&block, (columns.into(), rows.into()), component.samples, out, width);
                    block = Block::default();
                }
            }
        }
    }
    Some(Reduced { size: header.size, of_eight, planes, width, height })
}

/// Reads the coefficients of a block behind its first, by the order of the file.
///
/// Gives the last that is not 0; 0 where there is none.
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

impl Header {
    /// Reads to the one scan of a sequential file; also gives what follows.
    fn read(bytes: &[u8]) -> Option<(Self, &[u8])> {
        let (mut header, mut rest) = (Self::default(), bytes.get(2..)?);
        loop {
            let &[0xFF, marker, high, low] = rest.first_chunk()? else { return None };
            let length = usize::from(u16::from_be_bytes([high, low]));
            let (body, after) = rest.get(4..)?.split_at_checked(length.checked_sub(2)?)?;
            rest = after;
            match marker {
                QUANTIZATION_TABLES => header.read_quantizations(body)?,
                HUFFMAN_TABLES => header.read_tables(body)?,
                RESTART_INTERVAL => header.interval = u16::from_be_bytes(*body.first_chunk()?).into(),
                0xC0 | 0xC1 => header.read_frame(body)?,
                START_OF_SCAN => return header.read_scan(body).map(|()| (header, rest)),
                // Adobe's says so where the components are no differences of colour.
                APP14 if body.starts_with(b"Adobe") && body.get(11) != Some(&1) => return None,
                // Files of other kinds, and of several pictures.
                0xC2..=0xCF | 0xD0..=END_OF_IMAGE | 0xDC | 0xDE | 0xDF => return None,
                _ => {}
            }
        }
    }

    fn read_quantizations(&mut self, mut body: &[u8]) -> Option<()> {
        while let Some((&kind, rest)) = body.split_first() {
            let wide = usize::from(kind >> 4) + 1;
            let (values, rest) = rest.split_at_checked(64 * wide)?;
            let value =
                |k: usize| values[k * wide..][..wide].iter().fold(0, |sum, &byte| sum << 8 | u32::from(byte));
            let table = std::array::from_fn(|k| value(k) as f32);
            *self.quantizations.get_mut(usize::from(kind & 15))? = Some(table);
            body = rest;
        }
        Some(())
    }

    fn read_tables(&mut self, mut body: &[u8]) -> Option<()> {
        while let Some((&kind, rest)) = body.split_first() {
            let (counts, rest) = rest.split_first_chunk()?;
            let (symbols, rest) =
                rest.split_at_checked(counts.iter().map(|&count| usize::from(count)).sum())?;
            let tables = if kind >> 4 == 0 { &mut self.firsts } else { &mut self.others };
            *tables.get_mut(usize::from(kind & 15))? = Some(Table::new(counts, symbols)?);
            body = rest;
        }
        Some(())
    }

    fn read_frame(&mut self, body: &[u8]) -> Option<()> {
        let (&[8, high, low, right, left, count], rest) = body.split_first_chunk()? else { return None };
        let side = |bytes| usize::from(u16::from_be_bytes(bytes));
        self.size = (side([right, left]), side([high, low]));
        let (components, []) = rest.as_chunks::<3>() else { return None };
        let is_rgb = components.iter().map(|[id, ..]| id).eq(b"RGB");
        let once = self.components.is_empty() && components.len() == usize::from(count);
        if !once || !matches!(count, 1 | 3) || is_rgb || self.size.0 == 0 || self.size.1 == 0 {
            return None;
        }
        self.components.extend(components.iter().map(|&[id, blocks, quantization]| Component {
            id,
            // The blocks of a component that is alone stand one after the other, whatever it says.
            blocks: if count == 1 { (1, 1) } else { (usize::from(blocks >> 4), usize::from(blocks & 15)) },
            samples: (0, 0),
            quantization: quantization.into(),
            tables: (0, 0),
            last: 0,
        }));
        Some(())
    }

    /// The scan has to be that of all components.
    fn read_scan(&mut self, body: &[u8]) -> Option<()> {
        let (&count, rest) = body.split_first()?;
        let components = rest.as_chunks::<2>().0.get(..usize::from(count))?;
        if self.components.len() != components.len() || components.is_empty() {
            return None;
        }
        for (component, &[id, tables]) in self.components.iter_mut().zip(components) {
            component.tables = (usize::from(tables >> 4), usize::from(tables & 15));
            (component.id == id).then_some(())?;
        }
        Some(())
    }
}
