//! The entries that `fuzz/` fuzzes, under plain `cargo test`: files that once were a fault (`tests/regressions/NAME/`),
//! and as many damaged copies of good ones as fit into a few seconds.

#[allow(unreachable_pub, reason = "the fuzz targets take it as a crate of its own")]
#[path = "../../fuzz/entries.rs"]
mod entries;

use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

use entries::{ENTRIES, Entry};
use oorandom::Rand64;

/// Replacements for a number in a JSON file.
const ODD: &[&str] = &[
    "0",
    "-1",
    "1",
    "1e-320",
    "1e308",
    "-0.0",
    "4294967296",
    "18446744073709551615",
    "0.5",
    "null",
    "\"\"",
    "[]",
    "{}",
    "true",
];

fn files(folder: &str) -> Vec<Vec<u8>> {
    let Ok(entries) = fs::read_dir(crate::root(folder)) else { return Vec::new() };
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let hidden = |path: &Path| path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."));
    let about = |path: &Path| path.extension().is_some_and(|kind| kind == "md" || kind == "bin");
    paths.retain(|path| path.is_file() && !hidden(path) && !about(path));
    paths.into_iter().map(|path| fs::read(path).unwrap()).collect()
}

/// Good files to begin with, of the kind that an entry takes.
fn seeds(name: &str) -> Vec<Vec<u8>> {
    let some = |folder: &str| files(folder).into_iter().step_by(6).collect();
    match name {
        "photo" => ["files", "animations", "odd"]
            .into_iter()
            .flat_map(|folder| files(&format!("tests/oracles/data/{folder}")))
            .filter(|file| file.len() < 20_000)
            .collect(),
        "style" => some("styles"),
        "layout" => some("layouts"),
        // The model is not in git. `cargo xtask models` makes it.
        "painters" => vec![fs::read(crate::root("www/models/painters.onnx")).unwrap()],
        _ => files(&format!("fuzz/seeds/{name}")),
    }
}

/// Runs an entry point. Input that makes it panic is stored in `target/`, and the test prints its name.
fn survive(name: &str, entry: Entry, bytes: &[u8]) {
    if catch_unwind(|| entry(bytes)).is_err() {
        let kept = crate::root("target").join(format!("fault-{name}"));
        fs::write(&kept, bytes).unwrap();
        panic!(
            "the entry {name} panicked; its input is {}: move it to tests/regressions/{name}/",
            kept.display()
        );
    }
}

#[test]
fn what_once_was_a_fault_is_none_any_more() {
    for (name, entry) in ENTRIES {
        for bytes in files(&format!("tests/regressions/{name}")) {
            survive(name, *entry, &bytes);
        }
    }
}

#[test]
fn damaged_copies_of_good_files_are_read_or_refused() {
    for (name, entry) in ENTRIES {
        let seeds = seeds(name);
        assert!(!seeds.is_empty(), "{name}");
        let copies = crate::trials(15, 60) as usize * 40 / seeds.len().clamp(1, 40);
        for (i, seed) in seeds.iter().enumerate() {
            survive(name, *entry, seed);
            let mut random = Rand64::new(i as u128);
            for _ in 0..copies {
                let json = matches!(seed.first(), Some(b'{' | b'['));
                let copy = if json { oddly_numbered(seed, &mut random) } else { damaged(seed, &mut random) };
                survive(name, *entry, &copy);
            }
        }
    }
}

/// A few bytes changed, a piece doubled or left out, or the end cut off.
fn damaged(seed: &[u8], random: &mut Rand64) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.rand_range(0..4) {
        let at = random.rand_range(0..bytes.len() as u64) as usize;
        let end = (at + random.rand_range(1..40) as usize).min(bytes.len());
        match random.rand_range(0..8) {
            0 => bytes.truncate(at.max(1)),
            1 => drop(bytes.drain(at..end)),
            2 => drop(bytes.splice(at..at, bytes[at..end].to_vec())),
            3 => bytes[at] = [0, 1, 0x7F, 0x80, 0xFF][random.rand_range(0..5) as usize],
            _ => bytes[at] ^= 1 << random.rand_range(0..8),
        }
        if bytes.is_empty() {
            return bytes;
        }
    }
    bytes
}

/// Some of the numbers replaced by odd values; now and then damaged as any file.
fn oddly_numbered(seed: &[u8], random: &mut Rand64) -> Vec<u8> {
    if random.rand_range(0..5) == 0 {
        return damaged(seed, random);
    }
    let text = String::from_utf8_lossy(seed);
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '-' | '.');
    let (mut out, mut rest) = (String::new(), text.as_ref());
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let length = rest[start..].find(|c| !is_part(c)).unwrap_or(rest.len() - start);
        out.push_str(&rest[..start]);
        let number = &rest[start..start + length];
        out.push_str(if random.rand_range(0..12) == 0 {
            ODD[random.rand_range(0..ODD.len() as u64) as usize]
        } else {
            number
        });
        rest = &rest[start + length..];
    }
    (out + rest).into_bytes()
}
