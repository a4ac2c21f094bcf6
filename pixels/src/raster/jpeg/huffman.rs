//! The coded data of a scan: its bits, and the Huffman codes in them. Source: ITU-T T.81, annexes C and F.2.2.

/// How many bits one look into a table tells about.
const LOOK: u32 = 10;

/// A Huffman table.
pub(super) struct Table {
    /// By the next bits; 0 where the code is longer. Else from the lowest bit on: eight bits for how many are taken, eight for the
    /// symbol, sixteen for the number that follows it, where all of it is among the bits, or 0.
    short: [i32; 1 << LOOK],
    /// By length: codes of so many bits are below, aligned to the top of 16 bits.
    ends: [u32; 17],
    /// By length: what is added to a code for its place among the symbols.
    firsts: [i32; 17],
    symbols: Vec<u8>,
}

impl Table {
    /// Of `counts[n - 1]` codes of `n` bits, and their symbols; none where there are more codes than bits can tell apart.
    pub(super) fn new(counts: &[u8; 16], symbols: &[u8]) -> Option<Self> {
        let (short, symbols) = ([0; 1 << LOOK], symbols.to_vec());
        let mut table = Self { short, ends: [0; 17], firsts: [0; 17], symbols };
        let (mut code, mut place) = (0u32, 0usize);
        for (length, &count) in (1u32..).zip(counts) {
            table.firsts[length as usize] = place as i32 - code as i32;
            for _ in 0..count {
                let &symbol = table.symbols.get(place)?;
                if length <= LOOK {
                    let rest = LOOK - length;
                    let first = (code << rest) as usize;
                    for (behind, entry) in (0..).zip(table.short.get_mut(first..first + (1 << rest))?) {
                        *entry = known(symbol, length, behind, rest);
                    }
                }
                (code, place) = (code + 1, place + 1);
            }
            if code > 1 << length {
                return None;
            }
            table.ends[length as usize] = code << (16 - length);
            code <<= 1;
        }
        Some(table)
    }
}

/// What a table tells of a code, and of the `rest` bits `behind` it.
fn known(symbol: u8, length: u32, behind: u32, rest: u32) -> i32 {
    let size = u32::from(symbol & 15);
    let (number, taken) = if (1..=rest).contains(&size) {
        (signed(behind >> (rest - size), size), length + size)
    } else {
        (0, length)
    };
    number << 16 | i32::from(symbol) << 8 | taken as i32
}

/// The number that `size` bits stand for, 1 to 15: one below 0 begins with a 0.
#[inline]
fn signed(bits: u32, size: u32) -> i32 {
    let below = if bits >> (size - 1) == 0 { (1 << size) - 1 } else { 0 };
    bits as i32 - below
}

/// The bits of a scan, up to its next marker.
pub(super) struct Bits<'a> {
    data: &'a [u8],
    at: usize,
    /// The next bits, from the highest down; zeros behind them.
    ahead: u64,
    /// How many of them there are; below 0 once more were taken than there are.
    count: i32,
}

impl<'a> Bits<'a> {
    /// Of the data behind the header of a scan.
    pub(super) fn new(data: &'a [u8]) -> Self {
        Self { data, at: 0, ahead: 0, count: 0 }
    }

    /// Fetches as many bits as a symbol and its number may have together: 31.
    #[inline]
    fn fetch(&mut self) {
        if self.count >= 31 {
            return;
        }
        if let Some(&four) = self.data.get(self.at..).and_then(<[u8]>::first_chunk) {
            let word = u32::from_be_bytes(four);
            // Whether one of the bytes is 0xFF, behind which there may be a marker.
            let may_end = (!word).wrapping_sub(0x0101_0101) & word & 0x8080_8080 != 0;
            if !may_end && self.count >= 0 {
                self.ahead |= u64::from(word) << (32 - self.count);
                self.count += 32;
                self.at += 4;
                return;
            }
        }
        self.fetch_bytes();
    }

    #[cold]
    fn fetch_bytes(&mut self) {
        while (0..=48).contains(&self.count) {
            let (byte, length) = match self.data.get(self.at..) {
                Some([0xFF, 0, ..]) => (0xFF, 2),
                Some([0xFF, ..] | []) | None => return,
                Some([byte, ..]) => (*byte, 1),
            };
            self.ahead |= u64::from(byte) << (56 - self.count);
            self.count += 8;
            self.at += length;
        }
    }

    #[inline]
    fn skip(&mut self, bits: u32) {
        self.ahead <<= bits;
        self.count -= bits as i32;
    }

    /// The next symbol, and the number of as many bits as its lower half says, or 0; none for a code that the table does not have.
    #[inline]
    pub(super) fn next(&mut self, table: &Table) -> Option<(u8, i32)> {
        self.fetch();
        let found = table.short[(self.ahead >> (64 - LOOK)) as usize];
        let symbol = if found == 0 {
            self.long(table)?
        } else {
            self.skip((found & 0xFF) as u32);
            (found >> 8) as u8
        };
        let (number, size) = (found >> 16, u32::from(symbol & 15));
        if number != 0 || size == 0 {
            return Some((symbol, number));
        }
        let bits = (self.ahead >> (64 - size)) as u32;
        self.skip(size);
        Some((symbol, signed(bits, size)))
    }

    #[cold]
    fn long(&mut self, table: &Table) -> Option<u8> {
        let code = (self.ahead >> 48) as u32;
        let length = (LOOK + 1..=16).find(|&length| code < table.ends[length as usize])?;
        let place = table.firsts[length as usize] + (code >> (16 - length)) as i32;
        self.skip(length);
        table.symbols.get(place as usize).copied()
    }

    /// Whether there were as many bits as were taken.
    #[inline]
    pub(super) fn sufficed(&self) -> bool {
        self.count >= 0
    }

    /// Goes on behind the restart marker of a number; none where another one stands there, or data before it.
    pub(super) fn restart(&mut self, number: usize) -> Option<()> {
        self.fetch();
        let marker = [0xFF, 0xD0 | (number % 8) as u8];
        if self.count >= 8 || !self.data.get(self.at..)?.starts_with(&marker) {
            return None;
        }
        *self = Self { at: self.at + 2, ..Self::new(self.data) };
        Some(())
    }
}
