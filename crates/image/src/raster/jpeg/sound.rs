//! Checks whether the coded data of a sequential JPEG file are sound, without decoding a pixel.

use super::header::{Header, Layout, Part, segment};
use super::huffman::{Bits, Steps};
use super::{END_OF_IMAGE, START_OF_SCAN, next_marker};

/// Whether all blocks are there, with valid codes and nothing after them but the end of the file.
pub(super) fn is_sound(bytes: &[u8]) -> bool {
    let (mut header, mut at) = (Header::default(), 2);
    let mut seen = [false; 4];
    while let Some((marker, after)) = next_marker(bytes, at) {
        if marker == END_OF_IMAGE {
            return !header.components.is_empty() && seen[..header.components.len()].iter().all(|&seen| seen);
        }
        let Some((body, end)) = segment(bytes, after) else { return false };
        at = end;
        if marker != START_OF_SCAN {
            if header.read(marker, body).is_none() {
                return false;
            }
            continue;
        }
        let scan = header.read_scan(body).and_then(|(indices, _)| header.layout(&indices));
        let Some(layout) = scan.filter(|_| !header.is_progressive) else { return false };
        layout.parts.iter().for_each(|part| seen[part.index] = true);
        let Some(length) = length_of_data(&header, &layout, &bytes[at..]) else { return false };
        at += length;
    }
    false
}

/// Goes through the data of a scan to their end. Returns `None` if they are damaged.
fn length_of_data(header: &Header, layout: &Layout, data: &[u8]) -> Option<usize> {
    let steps: [Option<Steps>; 4] = header.others.each_ref().map(|table| table.as_ref().map(Steps::new));
    let part = |part: &Part| {
        let (first, other) = header.tables(part.index);
        let steps = steps[header.components[part.index].tables.1].as_ref()?;
        Some((part.blocks.0 * part.blocks.1, header.largest(part.index), first?, other?, steps))
    };
    let parts: Vec<_> = layout.parts.iter().map(part).collect::<Option<_>>()?;
    let interval = if header.interval == 0 { usize::MAX } else { header.interval };
    let (mut bits, mut lasts) = (Bits::new(data), [0i32; 4]);
    for unit in 0..layout.count() {
        if unit > 0 && unit % interval == 0 {
            bits.restart(unit / interval - 1)?;
            lasts = [0; 4];
        }
        for (&(blocks, largest, first, others, steps), last) in parts.iter().zip(&mut lasts) {
            for _ in 0..blocks {
                *last += bits.next(first)?.1;
                (last.abs() <= largest).then_some(())?;
                bits.pass(others, steps)?;
            }
        }
        bits.sufficed().then_some(())?;
    }
    bits.filling_to()
}
