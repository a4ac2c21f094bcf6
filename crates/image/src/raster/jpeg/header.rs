//! The segments of a JPEG file that decoding needs: frame, tables and scans. Source: ITU-T T.81, annex B.

use super::huffman::Table;
use super::{HUFFMAN_TABLES, QUANTIZATION_TABLES, RESTART_INTERVAL};

/// Largest first coefficient of samples of eight bits after dequantisation, with room for encoders that go beyond black and white.
const MAX_FIRST: f32 = 1280.0;

/// A component of the picture.
#[derive(Clone, Copy)]
pub(super) struct Component {
    pub(super) id: u8,
    /// Blocks side by side, and one above the other, in each unit of an interleaved scan.
    pub(super) blocks: (usize, usize),
    /// Number of its quantisation table.
    pub(super) quantization: usize,
    /// Numbers of its Huffman tables: of the first coefficient and of the others.
    pub(super) tables: (usize, usize),
}

/// The headers before the data of a scan.
#[derive(Default)]
pub(super) struct Header {
    /// Width and height in pixels.
    pub(super) size: (usize, usize),
    pub(super) is_progressive: bool,
    pub(super) components: Vec<Component>,
    /// Units of an interleaved scan, across and down.
    pub(super) units: (usize, usize),
    pub(super) quantizations: [Option<[f32; 64]>; 4],
    pub(super) firsts: [Option<Table>; 4],
    pub(super) others: [Option<Table>; 4],
    /// Units between two restarts, or 0.
    pub(super) interval: usize,
}

/// The body of a segment whose length is stored at `at`, and the position after the segment.
pub(super) fn segment(bytes: &[u8], at: usize) -> Option<(&[u8], usize)> {
    let end = at + usize::from(u16::from_be_bytes(*bytes.get(at..)?.first_chunk()?));
    Some((bytes.get(at + 2..end)?, end))
}

impl Header {
    /// Reads a segment. Returns `None` if it is damaged or describes a file that is not decoded here.
    pub(super) fn read(&mut self, marker: u8, body: &[u8]) -> Option<()> {
        match marker {
            QUANTIZATION_TABLES => self.read_quantizations(body),
            HUFFMAN_TABLES => self.read_tables(body),
            RESTART_INTERVAL => {
                self.interval = u16::from_be_bytes(*body.first_chunk()?).into();
                Some(())
            }
            0xC0..=0xC2 => {
                self.is_progressive = marker == 0xC2;
                self.read_frame(body)
            }
            // Frames of other kinds.
            0xC3..=0xCF => None,
            _ => Some(()),
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
        let once = self.components.is_empty() && components.len() == usize::from(count);
        if !once || !matches!(count, 1..=4) || self.size.0 == 0 || self.size.1 == 0 {
            return None;
        }
        self.components.extend(components.iter().map(|&[id, blocks, quantization]| Component {
            id,
            // The blocks of a component that is alone stand one after the other, whatever it says.
            blocks: if count == 1 { (1, 1) } else { (usize::from(blocks >> 4), usize::from(blocks & 15)) },
            quantization: quantization.into(),
            tables: (0, 0),
        }));
        let (across, down) = self.most_blocks()?;
        self.units = (self.size.0.div_ceil(8 * across), self.size.1.div_ceil(8 * down));
        Some(())
    }

    /// The most blocks of a component in a unit, across and down. Returns `None` for numbers that no component has.
    pub(super) fn most_blocks(&self) -> Option<(usize, usize)> {
        let most = |side: fn(&Component) -> usize| {
            let sides = || self.components.iter().map(side);
            sides().all(|side| (1..=4).contains(&side)).then(|| sides().max()).flatten()
        };
        Some((most(|one| one.blocks.0)?, most(|one| one.blocks.1)?))
    }

    /// The Huffman tables of a component in the scan: of the first coefficient and of the others.
    pub(super) fn tables(&self, component: usize) -> (Option<&Table>, Option<&Table>) {
        let (first, other) = self.components[component].tables;
        (self.firsts.get(first).and_then(Option::as_ref), self.others.get(other).and_then(Option::as_ref))
    }

    /// The largest first coefficient of a component.
    pub(super) fn largest(&self, component: usize) -> i32 {
        let number = self.components[component].quantization;
        let table = self.quantizations.get(number).and_then(Option::as_ref);
        let divisor = table.map_or(1.0, |table| table[0].max(1.0));
        (MAX_FIRST / divisor) as i32 + 1
    }

    /// Whether the components are red, green and blue.
    pub(super) fn is_rgb(&self) -> bool {
        self.components.iter().map(|component| &component.id).eq(b"RGB")
    }

    /// Reads the header of a scan. Returns the indices of its components, and its parameters.
    pub(super) fn read_scan<'b>(&mut self, body: &'b [u8]) -> Option<(Vec<usize>, &'b [u8; 3])> {
        let (&count, rest) = body.split_first()?;
        let (parts, parameters) = rest.split_at_checked(2 * usize::from(count))?;
        let mut indices = Vec::new();
        for &[id, tables] in parts.as_chunks::<2>().0 {
            let index = self.components.iter().position(|component| component.id == id)?;
            let (first, others) = (usize::from(tables >> 4), usize::from(tables & 15));
            if first >= self.firsts.len() || others >= self.others.len() {
                return None;
            }
            self.components[index].tables = (first, others);
            indices.push(index);
        }
        (!indices.is_empty()).then_some((indices, parameters.first_chunk()?))
    }

    /// The blocks of each unit of a scan.
    pub(super) fn layout(&self, indices: &[usize]) -> Option<Layout> {
        let (across, down) = self.most_blocks()?;
        let is_alone = indices.len() == 1;
        let part = |&index: &usize| {
            let component = self.components[index];
            let stride = self.units.0 * component.blocks.0;
            Part { index, blocks: if is_alone { (1, 1) } else { component.blocks }, stride }
        };
        let units = match indices {
            [alone] => {
                let blocks = self.components[*alone].blocks;
                ((self.size.0 * blocks.0).div_ceil(8 * across), (self.size.1 * blocks.1).div_ceil(8 * down))
            }
            _ => self.units,
        };
        Some(Layout { units, parts: indices.iter().map(part).collect() })
    }
}

/// Positions of the blocks of a scan.
pub(super) struct Layout {
    /// Units of the scan, across and down.
    pub(super) units: (usize, usize),
    pub(super) parts: Vec<Part>,
}

/// The blocks of a component in a unit of a scan.
pub(super) struct Part {
    /// Index of the component.
    pub(super) index: usize,
    /// Blocks across and down.
    pub(super) blocks: (usize, usize),
    /// Blocks of a row of the component, including padding in the last unit.
    stride: usize,
}

impl Layout {
    /// Number of units.
    pub(super) fn count(&self) -> usize {
        self.units.0 * self.units.1
    }

    /// The blocks of a unit in the order of the file: index of the component, and position in it.
    #[inline]
    pub(super) fn blocks(&self, unit: usize) -> impl Iterator<Item = (usize, usize)> {
        self.parts.iter().flat_map(move |part| {
            let (across, down) = part.blocks;
            let first = self.first(part, unit);
            (0..across * down).map(move |i| (part.index, first + i / across * part.stride + i % across))
        })
    }

    /// The position of the first block of a component in a unit.
    #[inline]
    pub(super) fn first(&self, part: &Part, unit: usize) -> usize {
        let (column, row) = (unit % self.units.0, unit / self.units.0);
        row * part.blocks.1 * part.stride + column * part.blocks.0
    }
}
