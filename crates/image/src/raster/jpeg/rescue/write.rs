//! Writes the blocks of an image as a sequential JPEG file. Source: ITU-T T.81, annexes B and F.1.

use super::super::{END_OF_IMAGE, HUFFMAN_TABLES, START_OF_SCAN};
use super::{Block, Picture, Read};

/// Maximum of a coefficient in either direction, for samples of eight bits.
const MAX_COEFFICIENT: i32 = 1023;
/// Sizes of the first coefficients, from 0 on. Each has a code of four bits.
const FIRSTS: u8 = 12;
/// Sizes of other coefficients, from 1 on. With the number of zeros before it, each has a code of eight bits.
const OTHERS: u8 = 10;
/// Codes of the end of a block and of sixteen zeros: the two after the others.
const END: u32 = 16 * OTHERS as u32;
const ZEROS: u32 = END + 1;

impl Picture {
    /// The picture as a file, with `segments` before its frame.
    pub(super) fn written(&self, segments: &[u8], frame: &[u8]) -> Vec<u8> {
        let mut file = vec![0xFF, 0xD8];
        file.extend(segments);
        push_segment(&mut file, 0xC1, frame);
        push_segment(&mut file, HUFFMAN_TABLES, &tables());
        let mut scan = vec![self.components.len() as u8];
        scan.extend(self.header.components.iter().flat_map(|component| [component.id, 0]));
        scan.extend([0, 63, 0]);
        push_segment(&mut file, START_OF_SCAN, &scan);
        let mut bits = Bits { file, ahead: 0, count: 0 };
        let mut last = [0; 4];
        let indices: Vec<_> = (0..self.components.len()).collect();
        if let Some(layout) = self.header.layout(&indices) {
            for (index, at) in (0..layout.count()).flat_map(|unit| layout.blocks(unit)) {
                let component = &self.components[index];
                let is_read = component.read[at] != Read::Nothing;
                let block = if is_read { &component.values[at] } else { &[0; 64] };
                bits.push_block(block, &mut last[index]);
            }
        }
        bits.finished()
    }
}

fn push_segment(file: &mut Vec<u8>, marker: u8, body: &[u8]) {
    file.extend([0xFF, marker]);
    file.extend((body.len() as u16 + 2).to_be_bytes());
    file.extend(body);
}

/// The Huffman tables. All codes of a table have the same length.
fn tables() -> Vec<u8> {
    let counts = |length: usize, count: u8| {
        let mut counts = [0; 16];
        counts[length - 1] = count;
        counts
    };
    let mut tables = vec![0x00];
    tables.extend(counts(4, FIRSTS));
    tables.extend(0..FIRSTS);
    tables.push(0x10);
    tables.extend(counts(8, 16 * OTHERS + 2));
    tables.extend((0..16).flat_map(|zeros| (1..=OTHERS).map(move |size| zeros << 4 | size)));
    tables.extend([0x00, 0xF0]);
    tables
}

/// Coded data behind the headers of a file.
struct Bits {
    file: Vec<u8>,
    ahead: u64,
    count: u32,
}

impl Bits {
    fn push_block(&mut self, block: &Block, last: &mut i32) {
        let first = i32::from(block[0]).clamp(-MAX_COEFFICIENT - 1, MAX_COEFFICIENT);
        let (size, bits) = number(first - *last);
        *last = first;
        self.push(size << size | bits, 4 + size);
        // Bits of the coefficients after the first that are not 0.
        let mut left =
            block.iter().enumerate().fold(0, |bits, (k, &one)| bits | u64::from(one != 0) << k) & !1;
        let mut before = 0;
        while left != 0 {
            let k = left.trailing_zeros();
            let zeros = k - before - 1;
            for _ in 0..zeros / 16 {
                self.push(ZEROS, 8);
            }
            let (size, bits) = number(i32::from(block[k as usize]).clamp(-MAX_COEFFICIENT, MAX_COEFFICIENT));
            let code = zeros % 16 * u32::from(OTHERS) + size - 1;
            self.push(code << size | bits, 8 + size);
            (before, left) = (k, left & (left - 1));
        }
        if before < 63 {
            self.push(END, 8);
        }
    }

    fn push(&mut self, bits: u32, count: u32) {
        self.ahead = self.ahead << count | u64::from(bits);
        self.count += count;
        while self.count >= 8 {
            self.count -= 8;
            let byte = (self.ahead >> self.count) as u8;
            self.file.push(byte);
            if byte == 0xFF {
                self.file.push(0);
            }
        }
    }

    /// The file with its end.
    fn finished(mut self) -> Vec<u8> {
        self.push(0x7F, 7);
        self.file.extend([0xFF, END_OF_IMAGE]);
        self.file
    }
}

/// Number of bits of a coefficient, and these bits.
fn number(value: i32) -> (u32, u32) {
    let size = 32 - value.unsigned_abs().leading_zeros();
    let bits = if value < 0 { value - 1 } else { value };
    (size, bits as u32 & ((1 << size) - 1))
}
