//! Sizes of downloads: each wasm module with its script, and the packed glyphs. `wasm/sizes.json` stores the expected
//! sizes. A download may grow by `GROWTH` beyond its newest entry. More growth needs a new entry with a reason.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use flate2::{Compression, write::GzEncoder};
use serde_json::Value;

use crate::letters;
use crate::project::Project;

/// The modules by name, and the folders in `www` that contain them.
const MODULES: [(&str, &str); 10] = [
    ("core", "pkg"),
    ("decoders", "pkg-decoders"),
    ("words", "pkg-words"),
    ("texts", "pkg-texts"),
    ("exports", "pkg-exports"),
    ("films", "pkg-films"),
    ("heic", "pkg-heic"),
    ("imitation", "pkg-imitation"),
    ("brush", "pkg-brush"),
    ("detectors", "pkg-detector"),
];

/// The packed glyphs, which the modules `words` and `exports` both download. They are not compressed further.
const LETTERS: &str = "letters";

/// Growth that needs no entry, in percent.
const GROWTH: usize = 5;

/// The stored sizes, relative to the root.
const STORED: &str = "wasm/sizes.json";

/// Prints all sizes next to the stored ones.
///
/// # Errors
/// If a download is missing in `wasm/sizes.json` or grew by more than `GROWTH` percent. The error names all of them.
pub fn check(project: &Project) -> Result<()> {
    let mut sizes = BTreeMap::new();
    for (name, folder) in MODULES {
        let folder = project.www().join(folder);
        let size = gzipped(&folder.join("inkpanel_bg.wasm"))? + gzipped(&folder.join("inkpanel.js"))?;
        sizes.insert(name, size);
    }
    let letters = letters::folder(project).join("letters.bin");
    let size = fs::metadata(&letters).with_context(|| format!("cannot read {}", letters.display()))?.len();
    sizes.insert(LETTERS, usize::try_from(size)?);

    let text =
        fs::read_to_string(project.root.join(STORED)).with_context(|| format!("cannot read {STORED}"))?;
    let stored = newest(&text)?;
    let mut faults = Vec::new();
    for (name, size) in &sizes {
        let expected = stored.get(*name).copied();
        let known = expected.map_or_else(|| "no entry".to_owned(), |bytes| format!("{bytes} stored"));
        println!("{name:<10}{size:>9} bytes gzipped, {known}");
        faults.extend(fault(name, *size, expected));
    }
    ensure!(faults.is_empty(), "{}. Add entries with reasons to {STORED}", faults.join(", "));
    Ok(())
}

/// Returns the newest size of each download.
fn newest(text: &str) -> Result<BTreeMap<String, usize>> {
    let stored: BTreeMap<String, Vec<Value>> =
        serde_json::from_str(text).with_context(|| format!("{STORED} is not an object of arrays"))?;
    let size = |(name, entries): (String, Vec<Value>)| {
        let entry = entries.last().with_context(|| format!("{STORED}: {name} has no entry"))?;
        let bytes = entry["bytes"].as_u64().with_context(|| format!("{STORED}: {name} has no bytes"))?;
        let reason = entry["reason"].as_str().unwrap_or_default();
        ensure!(!reason.trim().is_empty(), "{STORED}: the newest entry of {name} has no reason");
        Ok((name, usize::try_from(bytes)?))
    };
    stored.into_iter().map(size).collect()
}

fn fault(name: &str, size: usize, expected: Option<usize>) -> Option<String> {
    let Some(expected) = expected else {
        return Some(format!("{name} has no stored size"));
    };
    let limit = expected + expected * GROWTH / 100;
    (size > limit).then(|| format!("{name} grew from {expected} to {size} bytes"))
}

fn gzipped(file: &Path) -> Result<usize> {
    let bytes = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&bytes)?;
    Ok(encoder.finish()?.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_above_five_percent_needs_an_entry() {
        assert_eq!(fault("core", 1050, Some(1000)), None);
        assert_eq!(fault("core", 1051, Some(1000)).unwrap(), "core grew from 1000 to 1051 bytes");
        assert_eq!(fault("core", 10, None).unwrap(), "core has no stored size");
    }

    #[test]
    fn the_newest_entry_counts_and_has_a_reason() {
        let text = r#"{"core": [{"bytes": 1, "reason": "first"}, {"bytes": 2, "reason": "books"}]}"#;
        assert_eq!(newest(text).unwrap()["core"], 2);
        let error = newest(r#"{"core": [{"bytes": 2}]}"#).unwrap_err().to_string();
        assert!(error.contains("no reason"), "{error}");
        assert!(newest(r#"{"core": []}"#).is_err());
    }

    #[test]
    fn the_stored_sizes_name_every_download() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let stored = newest(&fs::read_to_string(root.join(STORED)).unwrap()).unwrap();
        let mut names: Vec<_> = MODULES.iter().map(|(name, _)| *name).collect();
        names.push(LETTERS);
        names.sort_unstable();
        assert_eq!(stored.keys().map(String::as_str).collect::<Vec<_>>(), names);
    }
}
