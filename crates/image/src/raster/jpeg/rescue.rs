//! Reads all coefficients that a JPEG file holds, and writes them as a sound sequential file, in which missing blocks are grey. Damaged
//! files are decoded from it, and progressive ones, whose damage is not seen otherwise.
//!
//! Restart markers limit damage to their interval, as in libjpeg (`jpeg_resync_to_restart` in its `jdmarker.c`). Without markers
//! Huffman codes synchronise soon after damage, too, but the positions and the brightness of the blocks after it are unknown. The end
//! of the data tells their positions, and the row above tells their brightness.
//!
//! Sources: ITU-T T.81, annexes B, E.2, F and G.

mod scan;
mod write;

use super::header::{Component, Header, Layout, segment};
use super::huffman::Bits;
use super::{APP0, APP14, APP15, COMMENT, END_OF_IMAGE, START_OF_SCAN, first_mark, next_marker};
use super::{HUFFMAN_TABLES, QUANTIZATION_TABLES, RESTART_INTERVAL};
use crate::raster::limits::Damage;
use scan::{Block, Scan, State};
use std::ops::Range;

/// Maximum number of scans; more would only take time. `zune-jpeg` has the same limit.
const MAX_SCANS: usize = 100;
/// Minimum number of units after damage that count as synchronised.
const MIN_TAIL: usize = 8;
/// Maximum number of restart intervals that are skipped because of the number of a marker, which counts to eight.
const MAX_SKIPPED: usize = 4;
/// Maximum of a difference between two blocks that counts, as a multiple of the mean.
const MAX_STEP: f32 = 8.0;
/// Minimum decrease of such differences when blocks move to their right place.
const MIN_GAIN: f32 = 2.0;
/// Minimum number of units in a row for which such differences are compared.
const MIN_ROW: usize = 12;
/// Maximum number of units that are missing between others, as a share of those units. Truncated files lack more.
const MAX_GAP: f64 = 0.125;

/// How much of a block was read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Read {
    Nothing,
    /// The first coefficient has an unknown offset.
    Adrift,
    /// Coefficients of later scans are missing.
    Coarse,
    Whole,
}

/// The blocks of a component.
struct Blocks {
    values: Vec<Block>,
    read: Vec<Read>,
    /// Blocks of a row, including padding in the last unit.
    stride: usize,
    /// By coefficient: the lowest bit that a scan coded; 255 without a scan.
    lowest: [u8; 64],
}

impl Blocks {
    /// The nearest block above one that was read.
    fn above(&self, at: usize) -> Option<usize> {
        let mut rows = (1..=at / self.stride).map(|row| at - row * self.stride);
        rows.find(|&above| self.read[above] == Read::Whole)
    }
}

/// A picture that is read.
#[derive(Default)]
struct Picture {
    header: Header,
    components: Vec<Blocks>,
    /// Number of damaged or missing blocks at unknown positions.
    lost: usize,
    /// Whether any scan is damaged.
    is_torn: bool,
}

/// Reads a file. Returns it as a sound one with the damage that it had, or `None` if its headers are damaged or unusual.
pub(super) fn rescued(bytes: &[u8]) -> Option<(Vec<u8>, Damage)> {
    let mut picture = Picture::default();
    let (mut segments, mut frame) = (Vec::new(), Vec::new());
    let (mut at, mut scans, mut is_closed) = (2, 0, false);
    while let Some((marker, after)) = next_marker(bytes, at) {
        is_closed = marker == END_OF_IMAGE;
        let Some((body, end)) = segment(bytes, after).filter(|_| !is_closed && scans < MAX_SCANS) else {
            break;
        };
        at = end;
        match marker {
            START_OF_SCAN => {
                let Some(scan) = Scan::read(&mut picture.header, body) else { break };
                let data = Data::after(bytes, end);
                at = data.range.end;
                scans += 1;
                picture.read(&scan, &data);
                continue;
            }
            APP0 | APP14 | QUANTIZATION_TABLES => segments.extend(&bytes[after - 2..end]),
            0xC0..=0xC2 => frame = body.to_vec(),
            _ => {}
        }
        if picture.header.read(marker, body).is_none() {
            break;
        }
    }
    // The decoder draws sequential files with fewer blocks of brightness than of colour wrong.
    if picture.header.most_blocks() != Some(picture.header.components.first()?.blocks) {
        return None;
    }
    let damage = picture.damage(is_closed)?;
    Some((picture.written(&segments, &frame), damage))
}

/// The coded data of a scan.
struct Data<'a> {
    bytes: &'a [u8],
    range: Range<usize>,
    /// Positions and numbers of the restart markers.
    restarts: Vec<(usize, u8)>,
    /// Whether another marker follows.
    is_closed: bool,
}

/// Coded data without restarts.
struct Piece<'a> {
    data: &'a [u8],
    /// The restart intervals that it should hold: several if restart markers are missing.
    intervals: Range<usize>,
    /// Whether its end is where its last unit ends.
    is_closed: bool,
}

impl<'a> Data<'a> {
    /// Finds the end of the data from `start`: the first marker that may follow a scan. Damaged data contain other markers.
    fn after(bytes: &'a [u8], start: usize) -> Self {
        let mut data = Self { bytes, range: start..bytes.len(), restarts: Vec::new(), is_closed: false };
        let mut at = start;
        while let Some(found) = bytes.get(at..).and_then(first_mark) {
            at += found;
            match bytes.get(at + 1) {
                Some(0xFF) => at += 1,
                Some(&marker @ 0xD0..=0xD7) => {
                    data.restarts.push((at, marker & 7));
                    at += 2;
                }
                Some(&marker) if may_follow(bytes, marker, at + 2) => {
                    (data.range.end, data.is_closed) = (at, true);
                    break;
                }
                _ => at += 2,
            }
        }
        data
    }

    /// Splits the data at the restart markers that belong there, for a scan of `count` restart intervals.
    fn pieces(&self, count: usize) -> Vec<Piece<'a>> {
        let (mut pieces, mut interval, mut start) = (Vec::new(), 0, self.range.start);
        let piece = |data: Range<usize>, intervals, is_closed| Piece {
            data: &self.bytes[data],
            intervals,
            is_closed,
        };
        for (i, &(at, number)) in self.restarts.iter().enumerate() {
            let ahead = usize::from(number.wrapping_sub(interval as u8) & 7);
            // Markers that are missing from here on.
            let missing = (count - interval).saturating_sub(1 + self.restarts.len() - i);
            let are_all_here = self.is_closed && ahead > 0 && missing % 8 == ahead;
            let skipped = if are_all_here { missing } else { ahead };
            let next = interval + skipped + 1;
            if (are_all_here || ahead <= MAX_SKIPPED) && next < count {
                pieces.push(piece(start..at, interval..next, true));
                (interval, start) = (next, at + 2);
            }
        }
        pieces.push(piece(start..self.range.end, interval..count, self.is_closed));
        pieces
    }
}

/// Whether a marker may follow a scan: the end, or a segment that another marker follows.
fn may_follow(bytes: &[u8], marker: u8, after: usize) -> bool {
    match (marker, segment(bytes, after)) {
        (END_OF_IMAGE, _) => true,
        (START_OF_SCAN, Some((&[count, ref rest @ ..], _))) => rest.len() == 3 + 2 * usize::from(count),
        (
            HUFFMAN_TABLES | QUANTIZATION_TABLES | RESTART_INTERVAL | APP0..=APP15 | COMMENT,
            Some((_, end)),
        ) => bytes.get(end) == Some(&0xFF),
        _ => false,
    }
}

impl Picture {
    /// Reads all units of a scan that its data hold.
    fn read(&mut self, scan: &Scan, data: &Data<'_>) {
        if self.components.is_empty() {
            let blocks = |component: &Component| {
                let stride = self.header.units.0 * component.blocks.0;
                let count = stride * self.header.units.1 * component.blocks.1;
                Blocks {
                    values: vec![[0; 64]; count],
                    read: vec![Read::Nothing; count],
                    stride,
                    lowest: [u8::MAX; 64],
                }
            };
            self.components = self.header.components.iter().map(blocks).collect();
        }
        for part in &scan.layout.parts {
            self.components[part.index].lowest[scan.band.0..=scan.band.1].fill(scan.low);
        }
        let count = scan.layout.count();
        let interval = if self.header.interval == 0 { count } else { self.header.interval };
        let mut end = 0;
        for piece in data.pieces(count.div_ceil(interval)) {
            let units = piece.intervals.start * interval..(piece.intervals.end * interval).min(count);
            let [front, tail] = self.read_piece(scan, &piece, units, interval);
            self.miss(scan, end..front.start);
            self.miss(scan, front.end..tail.start);
            end = tail.end;
        }
        self.miss(scan, end..count);
    }

    /// Notes that a scan does not hold the detail of some units.
    fn miss(&mut self, scan: &Scan, units: Range<usize>) {
        if scan.is_base() {
            return;
        }
        for (component, at) in units.flat_map(|unit| scan.layout.blocks(unit)) {
            let read = &mut self.components[component].read[at];
            if *read == Read::Whole {
                *read = Read::Coarse;
            }
        }
    }

    /// Reads the units of a piece of the data: from its start up to damage, and then the units that lead to its end.
    /// Returns both ranges.
    fn read_piece(
        &mut self,
        scan: &Scan,
        piece: &Piece<'_>,
        units: Range<usize>,
        interval: usize,
    ) -> [Range<usize>; 2] {
        let mut state = State::new(Bits::new(piece.data));
        let first_interval = units.start..units.end.min(units.start + interval);
        let front = units.start..self.read_units(scan, &mut state, first_interval, Read::Whole);
        let nothing = units.end..units.end;
        let is_whole = front.end == units.end && (!piece.is_closed || state.bits.is_at_end());
        if is_whole && (!scan.is_base() || front.clone().all(|unit| self.is_possible(scan, unit))) {
            return [front, nothing];
        }
        self.is_torn = true;
        if !scan.is_base() {
            let is_whole = piece.is_closed && self.read_on(scan, &state, front.end..units.end);
            return if is_whole { [units, nothing] } else { [front, nothing] };
        }
        // The unit in which the damage was seen.
        self.lost += scan.layout.blocks(0).count();
        if !piece.is_closed {
            return [front, nothing];
        }
        if front.end == units.end || state.bits.left() < i32::MAX {
            return self.move_tail(scan, piece, front, units.end);
        }
        let room = front.end.max(units.end.saturating_sub(interval))..units.end;
        let tail = self.after_fault(scan, state, room.len());
        let tail = tail.map_or(nothing, |(start, count)| self.read_tail(scan, start, count, room));
        [front, tail]
    }

    /// Whether the first coefficients of a unit are plausible.
    fn is_possible(&self, scan: &Scan, unit: usize) -> bool {
        scan.layout.blocks(unit).all(|(index, at)| {
            i32::from(self.components[index].values[at][0]).abs() <= self.header.largest(index)
        })
    }

    /// Reads the other units of a refinement scan after a damaged unit, if they lead to the end of the data.
    fn read_on(&mut self, scan: &Scan, state: &State<'_>, units: Range<usize>) -> bool {
        // Whether they do is seen without a change.
        [false, true].into_iter().all(|writes| {
            let (mut state, mut unit) = (state.clone(), units.start);
            while unit < units.end {
                if self.read_unit(scan, &mut state, unit, writes).is_none() {
                    if !state.bits.skip_fault() {
                        return false;
                    }
                    state = State::new(state.bits);
                    if writes {
                        self.miss(scan, unit..unit + 1);
                    }
                }
                unit += 1;
            }
            state.bits.is_at_end()
        })
    }

    /// Finds where the codes are synchronised again after damage. Returns the state there, and the number of units that follow.
    fn after_fault<'d>(&self, scan: &Scan, mut state: State<'d>, room: usize) -> Option<(State<'d>, usize)> {
        while state.bits.skip_fault() {
            state = State::new(state.bits);
            let start = state.clone();
            if let Some(count) = self.units_to_end(scan, &mut state) {
                return (count >= MIN_TAIL.min(room)).then_some((start, count));
            }
        }
        None
    }

    /// Reads `count` units so that they end where the room for them does. Returns their range.
    fn read_tail(
        &mut self,
        scan: &Scan,
        mut start: State<'_>,
        count: usize,
        room: Range<usize>,
    ) -> Range<usize> {
        for _ in room.len()..count {
            self.skip_unit(scan, &mut start);
        }
        let tail = room.end - count.min(room.len())..room.end;
        self.read_units(scan, &mut State::new(start.bits), tail.clone(), Read::Adrift);
        self.anchor(scan, tail.clone());
        tail
    }

    /// Handles damage without an invalid code: there are too few or too many units. The damage is where blocks differ most from those
    /// above them. The units after it are moved to the `end`, if they differ less there.
    fn move_tail(
        &mut self,
        scan: &Scan,
        piece: &Piece<'_>,
        front: Range<usize>,
        end: usize,
    ) -> [Range<usize>; 2] {
        let row = scan.layout.units.0;
        let start = || State::new(Bits::new(piece.data));
        let count = self.units_to_end(scan, &mut start()).unwrap_or(front.len());
        self.lost += count.saturating_sub(front.len()) * scan.layout.blocks(0).count();
        let gap = (end - front.start).saturating_sub(count) as f64;
        if row < MIN_ROW || gap > MAX_GAP * count as f64 {
            return [front, end..end];
        }
        let steps: Vec<_> = front.clone().map(|unit| self.steps(scan, unit)).collect();
        let mean =
            |part: usize| steps.iter().map(|steps| steps[part]).sum::<f32>() / steps.len() as f32 + 1.0;
        let means = [0, 1, 2, 3].map(mean);
        let step =
            |steps: [f32; 4]| (0..4).map(|part| (steps[part] / means[part]).min(MAX_STEP)).sum::<f32>();
        let steps: Vec<_> = steps.into_iter().map(step).collect();
        let sums: Vec<f32> = steps.windows(row).map(|steps| steps.iter().sum()).collect();
        let Some(most) = sums.iter().copied().reduce(f32::max) else { return [front, end..end] };
        // Damaged units may precede the first sound one.
        let first = sums.iter().position(|&sum| sum >= most).unwrap_or(0);
        let mut near = sums.iter().enumerate().skip(first).take(row).filter(|(_, sum)| **sum > 0.9 * most);
        let at = near.next_back().map_or(first, |(at, _)| at);
        let median = |mut steps: Vec<f32>| {
            let middle = steps.len() / 2;
            *steps.select_nth_unstable_by(middle, f32::total_cmp).1
        };
        let before = median(steps[at..at + row].to_vec());
        let mut state = start();
        for _ in 0..at {
            self.skip_unit(scan, &mut state);
        }
        self.forget(scan, front.start + at..end);
        let tail = self.read_tail(scan, state, count - at, front.start + at..end);
        let after = median(tail.clone().take(row).map(|unit| step(self.steps(scan, unit))).collect());
        if before - after > MIN_GAIN {
            return [front.start..front.start + at, tail];
        }
        self.forget(scan, tail);
        self.read_units(scan, &mut start(), front.clone(), Read::Whole);
        [front, end..end]
    }

    /// By component of a scan: how much a unit differs from the one above it, in brightness or colour.
    fn steps(&self, scan: &Scan, unit: usize) -> [f32; 4] {
        let mut steps = [0.0; 4];
        for (part, step) in scan.layout.parts.iter().zip(&mut steps) {
            let component = &self.components[part.index];
            let at = scan.layout.first(part, unit);
            if let Some(above) = component.above(at) {
                *step = component.values[at][0].abs_diff(component.values[above][0]).into();
            }
        }
        steps
    }

    /// Removes units, so that they can be read again.
    fn forget(&mut self, scan: &Scan, units: Range<usize>) {
        for (component, at) in units.flat_map(|unit| scan.layout.blocks(unit)) {
            self.components[component].read[at] = Read::Nothing;
            self.components[component].values[at] = [0; 64];
        }
    }

    /// Reads units, and notes how much of their blocks that is. Returns the first unit that cannot be read.
    fn read_units(&mut self, scan: &Scan, state: &mut State<'_>, units: Range<usize>, read: Read) -> usize {
        for unit in units.clone() {
            if self.read_unit(scan, state, unit, true).is_none() {
                if scan.is_base() {
                    self.forget(scan, unit..unit + 1);
                }
                return unit;
            }
            if scan.is_base() {
                for (component, at) in scan.layout.blocks(unit) {
                    self.components[component].read[at] = read;
                }
            }
        }
        units.end
    }

    /// Reads a unit. Without `writes` only the position in the data changes.
    fn read_unit(&mut self, scan: &Scan, state: &mut State<'_>, unit: usize, writes: bool) -> Option<()> {
        for part in &scan.layout.parts {
            let component = &mut self.components[part.index];
            let tables = self.header.tables(part.index);
            let (first, (across, down)) = (scan.layout.first(part, unit), part.blocks);
            for row in 0..down {
                let first = first + row * component.stride;
                for at in first..first + across {
                    if scan.is_dependent() && component.read[at] == Read::Coarse {
                        return None;
                    }
                    let block = &mut component.values[at];
                    if writes {
                        scan.block(state, part.index, tables, block)?;
                    } else {
                        scan.block(state, part.index, tables, &mut block.clone())?;
                    }
                }
            }
        }
        state.bits.sufficed().then_some(())
    }

    /// Reads a unit of a base scan into nothing.
    fn skip_unit(&self, scan: &Scan, state: &mut State<'_>) -> Option<()> {
        for (index, _) in scan.layout.blocks(0) {
            scan.block(state, index, self.header.tables(index), &mut [0; 64])?;
        }
        state.bits.sufficed().then_some(())
    }

    /// Number of units up to the end of the data. Returns `None` if the data do not end with a unit.
    fn units_to_end(&self, scan: &Scan, state: &mut State<'_>) -> Option<usize> {
        let mut count = 0;
        loop {
            let left = state.bits.left();
            if self.skip_unit(scan, state).is_none() {
                return (left < 8).then_some(count);
            }
            count += 1;
        }
    }

    /// Gives units after damage the brightness and the colour of the blocks above them; or of a grey picture.
    fn anchor(&mut self, scan: &Scan, units: Range<usize>) {
        for part in &scan.layout.parts {
            let component = &mut self.components[part.index];
            let blocks = || {
                let all = units.clone().flat_map(|unit| scan.layout.blocks(unit));
                all.filter(|(index, _)| *index == part.index).map(|(_, at)| at)
            };
            let first = |at: usize| i32::from(component.values[at][0]);
            let difference = |at| Some(first(component.above(at)?) - first(at));
            let mut offsets: Vec<_> = blocks().filter_map(difference).take(component.stride).collect();
            if offsets.is_empty() {
                offsets = blocks().map(|at| -first(at)).collect();
            }
            let middle = offsets.len() / 2;
            let offset = *offsets.select_nth_unstable(middle).1;
            for at in blocks() {
                component.values[at][0] = component.values[at][0].wrapping_add(offset as i16);
                component.read[at] = Read::Whole;
            }
        }
    }

    /// How much of the picture is damaged. Returns `None` without a picture. `is_closed`: whether the file has its end.
    fn damage(&self, is_closed: bool) -> Option<Damage> {
        let (mut all, mut missing, mut coarse) = (0, 0, 0);
        for (index, Blocks { read, stride, lowest, .. }) in self.components.iter().enumerate() {
            let is_complete = is_closed && !self.is_torn || lowest.iter().all(|&low| low == 0);
            // Without the blocks that only fill the last units.
            let Layout { units: (across, down), .. } = self.header.layout(&[index])?;
            for read in read.chunks(*stride).take(down).flat_map(|row| &row[..across]) {
                all += 1;
                missing += usize::from(*read == Read::Nothing);
                coarse += usize::from(*read == Read::Coarse || *read == Read::Whole && !is_complete);
            }
        }
        let share = |count: usize| count.min(all) as f64 / all as f64;
        (all > 0).then(|| Damage { missing: share(missing.max(self.lost)), coarse: share(coarse) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_marker_after_a_truncated_file_does_not_change_its_damage() {
        let truncated = include_bytes!("../../../../../tests/oracles/data/odd/jpeg-cut.jpg");
        let closed = include_bytes!("../../../../../tests/oracles/data/odd/jpeg-patched.jpg");
        assert_eq!(rescued(truncated).unwrap().1, rescued(closed).unwrap().1);
    }

    #[test]
    fn a_file_with_fewer_blocks_of_brightness_than_of_colour_is_left_to_the_decoder() {
        let mut file =
            include_bytes!("../../../../../tests/oracles/data/files/jpeg-progressive.jpg").to_vec();
        assert!(rescued(&file).is_some());
        let frame = file.windows(2).position(|pair| pair == [0xFF, 0xC2]).unwrap();
        // The blocks of the three components.
        for (at, blocks) in [(11, 0x11), (14, 0x22), (17, 0x22)] {
            file[frame + at] = blocks;
        }
        assert!(rescued(&file).is_none());
    }
}
