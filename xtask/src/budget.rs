//! Size limits of downloads: the core before the first page, the detectors after it, and the other modules on
//! demand.

use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use flate2::{Compression, write::GzEncoder};

use crate::letters;
use crate::project::Project;

/// The most that a module and its script may take, gzipped, in bytes. The exports module is not part of the
/// first load. It makes PDF, JPEG, WebP, comics, storyboards, edit lists and plans of animatics.
const BUDGETS: [(&str, &str, usize); 10] = [
    ("core", "pkg", 800_000),
    ("decoders", "pkg-decoders", 330_000),
    ("words", "pkg-words", 300_000),
    ("texts", "pkg-texts", 300_000),
    ("exports", "pkg-exports", 345_000),
    ("films", "pkg-films", 40_000),
    ("heic", "pkg-heic", 240_000),
    ("imitation", "pkg-imitation", 460_000),
    ("brush", "pkg-brush", 45_000),
    ("detectors", "pkg-detector", 2_500_000),
];

/// Maximum size of the packed glyphs, which the modules `words` and `exports` both download.
const LETTERS: usize = 130_000;

/// Prints all sizes.
///
/// # Errors
/// If modules or the glyphs exceed their budgets. The error names all of them.
pub fn check(project: &Project) -> Result<()> {
    let mut over = Vec::new();
    for (name, folder, budget) in BUDGETS {
        let folder = project.www().join(folder);
        let size = gzipped(&folder.join("inkpanel_bg.wasm"))? + gzipped(&folder.join("inkpanel.js"))?;
        println!("{name}, module and its script: {size} bytes gzipped, {budget} allowed");
        over.extend(excess(name, size, budget));
    }
    let letters = letters::folder(project).join("letters.bin");
    let size = fs::metadata(&letters).with_context(|| format!("cannot read {}", letters.display()))?.len();
    println!("letters: {size} bytes, {LETTERS} allowed");
    over.extend(excess("letters", usize::try_from(size)?, LETTERS));
    ensure!(over.is_empty(), "above the budget: {}", over.join(", "));
    Ok(())
}

fn excess(name: &str, size: usize, budget: usize) -> Option<String> {
    (size > budget).then(|| format!("{name} by {} bytes", size - budget))
}

fn gzipped(file: &Path) -> Result<usize> {
    let bytes = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&bytes)?;
    Ok(encoder.finish()?.len())
}
