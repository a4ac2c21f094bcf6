//! Letters of three by five dots, for the ids below the layouts.

use tiny_skia::{Pixmap, PremultipliedColorU8};

/// Side of a dot in pixels.
const DOT: u32 = 2;

/// Five rows of three dots a glyph, the top row in the highest bits.
const GLYPHS: [(char, u16); 37] = [
    ('a', 0b010_101_111_101_101),
    ('b', 0b110_101_110_101_110),
    ('c', 0b011_100_100_100_011),
    ('d', 0b110_101_101_101_110),
    ('e', 0b111_100_110_100_111),
    ('f', 0b111_100_110_100_100),
    ('g', 0b011_100_101_101_011),
    ('h', 0b101_101_111_101_101),
    ('i', 0b111_010_010_010_111),
    ('j', 0b001_001_001_101_010),
    ('k', 0b101_101_110_101_101),
    ('l', 0b100_100_100_100_111),
    ('m', 0b101_111_111_101_101),
    ('n', 0b110_101_101_101_101),
    ('o', 0b010_101_101_101_010),
    ('p', 0b110_101_110_100_100),
    ('q', 0b010_101_101_110_011),
    ('r', 0b110_101_110_101_101),
    ('s', 0b011_100_010_001_110),
    ('t', 0b111_010_010_010_010),
    ('u', 0b101_101_101_101_111),
    ('v', 0b101_101_101_101_010),
    ('w', 0b101_101_111_111_101),
    ('x', 0b101_101_010_101_101),
    ('y', 0b101_101_010_010_010),
    ('z', 0b111_001_010_100_111),
    ('0', 0b111_101_101_101_111),
    ('1', 0b010_110_010_010_111),
    ('2', 0b110_001_010_100_111),
    ('3', 0b110_001_010_001_110),
    ('4', 0b101_101_111_001_001),
    ('5', 0b111_100_110_001_110),
    ('6', 0b011_100_111_101_111),
    ('7', 0b111_001_010_010_010),
    ('8', 0b111_101_111_101_111),
    ('9', 0b111_101_111_001_110),
    ('-', 0b000_000_111_000_000),
];

/// Writes a text with its upper left corner at (x, y).
pub(crate) fn write(sheet: &mut Pixmap, text: &str, x: u32, y: u32) {
    for (i, letter) in text.chars().enumerate() {
        let glyph = GLYPHS.iter().find(|(known, _)| *known == letter).map_or(0, |(_, dots)| *dots);
        for dot in (0..15).filter(|dot| glyph >> (14 - dot) & 1 == 1) {
            let left = x + (i as u32 * 4 + dot % 3) * DOT;
            square(sheet, left, y + dot / 3 * DOT);
        }
    }
}

fn square(sheet: &mut Pixmap, x: u32, y: u32) {
    let (width, height) = (sheet.width(), sheet.height());
    let Some(ink) = PremultipliedColorU8::from_rgba(50, 50, 50, 255) else { return };
    for (px, py) in (0..DOT * DOT).map(|i| (x + i % DOT, y + i / DOT)) {
        if px < width && py < height {
            sheet.pixels_mut()[(py * width + px) as usize] = ink;
        }
    }
}
