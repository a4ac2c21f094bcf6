//! Memory limits for small files: the size of decompressed and collected data besides pixels is limited. This
//! file has only one test, because it counts every allocation of the process.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

#[allow(dead_code, reason = "the example makes more of it")]
#[path = "../examples/hostile/made.rs"]
mod made;

use std::fs;
use std::path::Path;

use inkpanel_engine::raster::decode::{Limits, decode};
use made::{Tiff, gif, inflating, jpeg_with, png, profile_parts};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Allowance for other data of a decoder: tables, a profile, some copies of a small picture.
const ROOM: usize = 24 << 20;

#[test]
fn what_is_said_besides_the_pixels_takes_little_memory() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/data/files");
    let jpeg = fs::read(data.join("jpeg-420.jpg")).unwrap();
    let webp = fs::read(data.join("webp-icc-p3.webp")).unwrap();
    let mib = 1 << 20;
    let half = |_| vec![b'a'; 65_000];
    // The file, and the maximum number of copied bytes: the pixels of a JPEG file, but no metadata.
    let files = [
        ("iCCP of 900 MB", png(&[(*b"iCCP", inflating(900 * mib))])),
        ("two iCCP of 900 MB", png(&[(*b"iCCP", inflating(900 * mib)), (*b"iCCP", inflating(900 * mib))])),
        ("zTXt of 900 MB", png(&[(*b"zTXt", inflating(900 * mib))])),
        ("tEXt of 40 MB", png(&[(*b"tEXt", vec![b'a'; 40 << 20])])),
        ("eXIf of 40 MB", png(&[(*b"eXIf", vec![b'I'; 40 << 20])])),
        ("APP2 of 16 MB", jpeg_with(&jpeg, 0xE2, profile_parts(255))),
        ("comments of 40 MB", jpeg_with(&jpeg, 0xFE, (0..640).map(half))),
        ("XMP of 40 MB", jpeg_with(&jpeg, 0xE1, (0..640).map(half))),
        ("ICCP of 40 MB", webp_with_profile(&webp, 40 << 20)),
        ("ICC of 40 MB", tiff_with_profile(40 << 20)),
        ("8 million strips", tiff_of_strips(8 << 20)),
        ("a frame of a gigabyte", gif((1, 1), (0, 0), (16_383, 16_383))),
    ];
    let limits = Limits { max_bytes: 256 << 20, ..Limits::default() };
    let mut offences = Vec::new();
    for (name, file) in files {
        let before = MEMORY.current_usage();
        MEMORY.reset_peak_usage();
        let outcome = decode(&file, &limits).map_or_else(|error| error.to_string(), |_| "decoded".into());
        let taken = MEMORY.peak_usage() - before;
        println!("{name}: {} kB, {outcome}", taken >> 10);
        if taken > ROOM {
            offences.push(format!("{name}: {} MB, {outcome}", taken >> 20));
        }
    }
    assert!(offences.is_empty(), "{offences:#?}");
}

/// Returns a WebP file with a profile of this length.
fn webp_with_profile(webp: &[u8], length: u32) -> Vec<u8> {
    let at = webp.windows(4).position(|name| name == b"ICCP").unwrap();
    let old = u32::from_le_bytes(*webp[at + 4..].first_chunk().unwrap()).next_multiple_of(2) as usize;
    let profile = vec![7; length as usize];
    let mut file = [&webp[..at + 4], &length.to_le_bytes(), &profile, &webp[at + 8 + old..]].concat();
    let size = file.len() as u32 - 8;
    file[4..8].copy_from_slice(&size.to_le_bytes());
    file
}

/// A TIFF file with a profile of that many bytes, which begins where the file does.
fn tiff_with_profile(length: u32) -> Vec<u8> {
    let mut file = Tiff { fields: vec![[34_675, 7, length, 0]], ..Tiff::rgb(45, 27) }.file();
    file.resize(length as usize, 0);
    file
}

/// A TIFF file that declares this many strips.
fn tiff_of_strips(count: u32) -> Vec<u8> {
    let fields = vec![[273, 4, count, 8], [279, 4, count, 8]];
    let mut file = Tiff { fields, ..Tiff::rgb(45, 27) }.file();
    file.resize(8 + 4 * count as usize, 0);
    file
}
