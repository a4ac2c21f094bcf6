//! One scan of a JPEG file, sequential or progressive: which coefficients it codes, and how they are read.
//! Source: ITU-T T.81, annexes F.2 and G.

use super::super::header::{Header, Layout};
use super::super::huffman::{Bits, Table, ZEROS};

/// The quantised coefficients of a block, in the order of the file.
pub(super) type Block = [i16; 64];

/// Largest size of the difference between two blocks, in bits, for samples of eight bits.
const MAX_DIFFERENCE: u8 = 11;

/// The parameters of a scan.
pub(super) struct Scan {
    pub(super) layout: Layout,
    /// The first and the last coefficient.
    pub(super) band: (usize, usize),
    /// Lowest bit that an earlier scan coded; 0 if this is the first scan of the band.
    high: u8,
    /// Lowest bit that this scan codes.
    pub(super) low: u8,
    is_progressive: bool,
}

/// A position in the coded data, and everything that reading on depends on.
#[derive(Clone)]
pub(super) struct State<'a> {
    pub(super) bits: Bits<'a>,
    /// By component: the first coefficient of the block before.
    pub(super) last: [i32; 4],
    /// Number of the next blocks that have no new coefficients.
    run: u32,
}

impl<'a> State<'a> {
    /// The state at the start of a restart interval.
    pub(super) fn new(bits: Bits<'a>) -> Self {
        Self { bits, last: [0; 4], run: 0 }
    }
}

impl Scan {
    /// Reads the header of a scan. Returns `None` if no scan has such parameters.
    pub(super) fn read(header: &mut Header, body: &[u8]) -> Option<Self> {
        let (indices, &[start, end, bits]) = header.read_scan(body)?;
        let is_progressive = header.is_progressive;
        let (band, high, low) =
            if is_progressive { ((start.into(), end.into()), bits >> 4, bits & 15) } else { ((0, 63), 0, 0) };
        let scan = Self { layout: header.layout(&indices)?, band, high, low, is_progressive };
        let is_band = match band {
            (0, 0) => true,
            (0, _) => !is_progressive,
            (start, end) => start <= end && end < 64 && indices.len() == 1,
        };
        let has_tables = |&index: &usize| {
            let (first, others) = header.tables(index);
            (first.is_some() || !scan.is_base()) && (others.is_some() || band.1 == 0)
        };
        (is_band && low < 14 && indices.iter().all(has_tables)).then_some(scan)
    }

    /// Whether it codes the first coefficient of each block for the first time.
    pub(super) fn is_base(&self) -> bool {
        self.band.0 == 0 && self.high == 0
    }

    /// Whether reading depends on coefficients of earlier scans.
    pub(super) fn is_dependent(&self) -> bool {
        self.band.0 > 0 && self.high > 0
    }

    /// Reads the coefficients of a block of a component. Returns `None` for data that no encoder writes.
    #[inline]
    pub(super) fn block(
        &self,
        state: &mut State<'_>,
        component: usize,
        (first, others): (Option<&Table>, Option<&Table>),
        block: &mut Block,
    ) -> Option<()> {
        let State { bits, last, run } = state;
        match (self.band.0, self.high) {
            (0, 0) => {
                let (size, difference) = bits.next(first?)?;
                let last = &mut last[component];
                *last = last.wrapping_add(difference);
                block[0] = (*last << self.low) as i16;
                (size <= MAX_DIFFERENCE).then_some(())?;
                if self.is_progressive { Some(()) } else { sequential(bits, others?, block) }
            }
            (0, _) => {
                block[0] |= (bits.take(1) as i16) << self.low;
                Some(())
            }
            (_, 0) => self.add(bits, run, others?, block),
            _ => self.refine(bits, run, others?, block),
        }
    }

    /// Reads the coefficients of a band for the first time.
    fn add(&self, bits: &mut Bits<'_>, run: &mut u32, table: &Table, block: &mut Block) -> Option<()> {
        if *run > 0 {
            *run -= 1;
            return Some(());
        }
        let mut k = self.band.0;
        while k <= self.band.1 {
            let (symbol, number) = bits.next(table)?;
            if number != 0 {
                k += usize::from(symbol >> 4);
                *block[..=self.band.1].get_mut(k)? = (number << self.low) as i16;
                k += 1;
            } else if symbol == ZEROS {
                k += 16;
            } else {
                *run = run_of(symbol, bits) - 1;
                break;
            }
        }
        Some(())
    }

    /// Reads one more bit of each coefficient of a band, and coefficients that have only this bit.
    fn refine(&self, bits: &mut Bits<'_>, run: &mut u32, table: &Table, block: &mut Block) -> Option<()> {
        let one = 1 << self.low;
        let correct = |bits: &mut Bits<'_>, coefficient: &mut i16| {
            if bits.take(1) == 1 && *coefficient & one == 0 {
                *coefficient = coefficient.wrapping_add(if *coefficient > 0 { one } else { -one });
            }
        };
        let band = &mut block[..=self.band.1];
        let mut k = self.band.0;
        while *run == 0 && k < band.len() {
            let (symbol, number) = bits.next(table)?;
            if number == 0 && symbol != ZEROS {
                *run = run_of(symbol, bits);
                break;
            }
            (number.abs() <= 1).then_some(())?;
            let mut zeros = symbol >> 4;
            while let Some(coefficient) = band.get_mut(k) {
                if *coefficient != 0 {
                    correct(bits, coefficient);
                } else if zeros == 0 {
                    break;
                } else {
                    zeros -= 1;
                }
                k += 1;
            }
            if number != 0 {
                *band.get_mut(k)? = number as i16 * one;
            }
            k += 1;
        }
        if *run > 0 {
            *run -= 1;
            for coefficient in band.iter_mut().skip(k).filter(|coefficient| **coefficient != 0) {
                correct(bits, coefficient);
            }
        }
        Some(())
    }
}

/// Number of blocks that end with this symbol.
fn run_of(symbol: u8, bits: &mut Bits<'_>) -> u32 {
    (1 << (symbol >> 4)) + bits.take(symbol >> 4)
}

/// Reads the coefficients of a sequential block after its first.
#[inline]
fn sequential(bits: &mut Bits<'_>, table: &Table, block: &mut Block) -> Option<()> {
    let mut k = 1;
    while k < 64 {
        let (symbol, number) = bits.next(table)?;
        if number != 0 {
            k += usize::from(symbol >> 4);
            *block.get_mut(k)? = number as i16;
            k += 1;
        } else if symbol == ZEROS {
            k += 16;
        } else {
            break;
        }
    }
    Some(())
}
