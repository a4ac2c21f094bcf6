//! The coded data of a scan: its bits, and the Huffman codes in them. Source: ITU-T T.81, annexes C and F.2.2.

/// The symbol of sixteen zeros. The block continues after it.
pub(super) const ZEROS: u8 = 0xF0;

/// How many bits one look into a table tells about.
const LOOK: u32 = 10;

/// A Huffman table.
pub(super) struct Table {
    /// By the next bits; 0 where the code is longer. Other values, from the lowest bit: eight bits for the
    /// number of consumed bits, eight for the symbol, sixteen for the number that follows it. The number is 0
    /// if it is not completely in the bits.
    short: [i32; 1 << LOOK],
    /// By length: upper limit of the codes of this length, aligned to the top of 16 bits.
    ends: [u32; 17],
    /// By length: offset from a code to its symbol index.
    firsts: [i32; 17],
    symbols: Vec<u8>,
}

impl Table {
    /// A table of `counts[n - 1]` codes of `n` bits, and their symbols. Returns `None` if there are more
    /// codes than their bits allow.
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

/// Number of bits that index [`Steps`].
const STEP: u32 = 12;

/// A table to skip coefficients without their values, indexed by the next bits. An entry covers all complete symbols in these bits.
/// From the lowest bit on it has the number of bits (5), the number of coefficients (7), and the end of the block (1). An entry
/// without a complete symbol is 0.
pub(super) struct Steps([u16; 1 << STEP]);

impl Steps {
    /// Creates the table from the Huffman table of the AC coefficients.
    pub(super) fn new(table: &Table) -> Self {
        let steps = |bits: usize| {
            let (mut taken, mut passed) = (0, 0);
            loop {
                let found = table.short[(bits << taken & ((1 << STEP) - 1)) >> (STEP - LOOK)];
                let (length, symbol) = ((found & 0xFF) as u32, (found >> 8 & 0xFF) as u16);
                let length = if found >> 16 == 0 { length + u32::from(symbol & 15) } else { length };
                if found == 0 || taken + length > STEP || passed > 63 {
                    return passed << 5 | taken as u16;
                }
                taken += length;
                match symbol {
                    0xF0 => passed += 16,
                    _ if symbol.trailing_zeros() >= 4 => return 1 << 12 | passed << 5 | taken as u16,
                    _ => passed += (symbol >> 4) + 1,
                }
            }
        };
        Self(std::array::from_fn(steps))
    }
}

/// The entry of a table for a code, and the `rest` bits `behind` it.
fn known(symbol: u8, length: u32, behind: u32, rest: u32) -> i32 {
    let size = u32::from(symbol & 15);
    let (number, taken) = if (1..=rest).contains(&size) {
        (signed(behind >> (rest - size), size), length + size)
    } else {
        (0, length)
    };
    number << 16 | i32::from(symbol) << 8 | taken as i32
}

/// The number in `size` bits, 1 to 15. Negative numbers begin with a 0.
#[inline]
fn signed(bits: u32, size: u32) -> i32 {
    let below = if bits >> (size - 1) == 0 { (1 << size) - 1 } else { 0 };
    bits as i32 - below
}

/// The bits of a scan, up to its next marker.
#[derive(Clone)]
pub(super) struct Bits<'a> {
    data: &'a [u8],
    at: usize,
    /// The next bits, from the highest down; zeros behind them.
    ahead: u64,
    /// How many of them there are; below 0 once more were taken than there are.
    count: i32,
}

impl<'a> Bits<'a> {
    /// Reads the data after the header of a scan.
    pub(super) fn new(data: &'a [u8]) -> Self {
        Self { data, at: 0, ahead: 0, count: 0 }
    }

    /// Fetches as many bits as a symbol and its number may have together: 31.
    #[inline]
    fn fetch(&mut self) {
        if self.count < 31 {
            self.fill();
        }
    }

    /// Fetches 49 bits or more, if there are as many before the next marker.
    #[inline]
    fn fill(&mut self) {
        if let Some(&eight) = self.data.get(self.at..).and_then(<[u8]>::first_chunk) {
            let word = u64::from_be_bytes(eight);
            // Whether one of the bytes is 0xFF, which may start a marker.
            let may_end = (!word).wrapping_sub(0x0101_0101_0101_0101) & word & 0x8080_8080_8080_8080 != 0;
            if !may_end && (0..56).contains(&self.count) {
                self.ahead |= word >> self.count;
                self.at += (63 - self.count as usize) / 8;
                self.count |= 0x38;
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

    /// Returns the next symbol and its additional bits as a number. The lower half of the symbol is the
    /// number of bits. Returns `None` for an unknown code.
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

    /// Skips the AC coefficients of a block. Returns `None` for an unknown code or too many coefficients.
    #[inline]
    pub(super) fn pass(&mut self, table: &Table, steps: &Steps) -> Option<()> {
        let mut k = 1;
        'block: while k < 64 {
            self.fill();
            // As many looks as there are bits for.
            for _ in 0..4 {
                let step = steps.0[(self.ahead >> (64 - STEP)) as usize];
                let passed = usize::from(step >> 5 & 127);
                if step == 0 || k + passed > 63 {
                    // A long symbol, or the last one: the next block follows without an end.
                    let (symbol, number) = self.next(table)?;
                    k += usize::from(symbol >> 4) + 1;
                    if number == 0 && symbol != ZEROS {
                        return Some(());
                    }
                    if number != 0 && k > 64 {
                        return None;
                    }
                    continue 'block;
                }
                self.skip((step & 31).into());
                k += passed;
                if step >> 12 != 0 {
                    return Some(());
                }
            }
        }
        Some(())
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

    /// Whether nothing is left before the end of the data.
    pub(super) fn is_at_end(&self) -> bool {
        self.filling_to() == Some(self.data.len())
    }

    /// The position of the next marker, or of the end, if only filling lies before it: bits of the last byte, and bytes that are alike.
    pub(super) fn filling_to(&self) -> Option<usize> {
        let count = usize::try_from(self.count).ok()?;
        let rest = self.data.get(self.at..)?;
        let marker = rest.windows(2).position(|pair| pair[0] == 0xFF && !matches!(pair[1], 0 | 0xFF));
        let end = marker.unwrap_or(rest.len());
        let ahead = (self.ahead << (count % 8)).to_be_bytes();
        let mut bytes = ahead[..count / 8].iter().chain(&rest[..end]);
        bytes.next().is_none_or(|first| bytes.all(|byte| byte == first)).then_some(self.at + end)
    }

    /// The next bits as a number, at most 16.
    #[inline]
    pub(super) fn take(&mut self, count: u8) -> u32 {
        self.fetch();
        let bits = (self.ahead >> 48) as u32 >> (16 - u32::from(count));
        self.skip(count.into());
        bits
    }

    /// Number of bits up to the end of the data, if there are few; otherwise any larger number.
    pub(super) fn left(&mut self) -> i32 {
        self.fetch();
        if self.at < self.data.len() { i32::MAX } else { self.count }
    }

    /// Continues after bits that cannot be read. Returns false at the end of the data.
    pub(super) fn skip_fault(&mut self) -> bool {
        if self.count > 0 {
            self.skip(1);
        } else {
            // After a marker that does not belong here.
            *self = Self { at: self.at + 2, ..Self::new(self.data) };
        }
        self.at < self.data.len()
    }

    /// Skips the restart marker with this number. Returns `None` if the next bytes are anything else.
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
