//! Rated pairs of pages, stored as one JSON object per line.

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::Path;

use anyhow::{Context, Result};
use oorandom::Rand64;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::pages::Page;

/// A stored comparison.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Pair {
    /// The folder of the photos.
    pub(crate) album: String,
    /// Seeds of the preferred page and of the other one.
    pub(crate) seeds: [u64; 2],
    /// Score terms of the preferred page.
    pub(crate) better: Map<String, Value>,
    /// Score terms of the other page.
    pub(crate) worse: Map<String, Value>,
}

/// Reads stored pairs. A missing file counts as empty.
///
/// # Errors
/// If the file cannot be read; the message names the line that is not a pair.
pub(crate) fn read(file: &Path) -> Result<Vec<Pair>> {
    let text = match fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(error).with_context(|| format!("cannot read {}", file.display())),
    };
    let lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    lines
        .map(|(i, line)| {
            serde_json::from_str(line)
                .with_context(|| format!("{}: line {} is not a pair", file.display(), i + 1))
        })
        .collect()
}

/// Appends a pair to the file.
///
/// # Errors
/// If the file cannot be written.
pub(crate) fn store(file: &Path, pair: &Pair) -> Result<()> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    }
    let mut line = serde_json::to_string(pair)?;
    line.push('\n');
    let opened = OpenOptions::new().create(true).append(true).open(file);
    let written = opened.and_then(|mut file| file.write_all(line.as_bytes()));
    written.with_context(|| format!("cannot write {}", file.display()))
}

/// The pairs of pages to compare, of one album each, in random order. The sides are random too.
pub(crate) fn duels(pages: &[Page], seed: u64) -> Vec<[usize; 2]> {
    let mut random = Rand64::new(u128::from(seed));
    let mut duels = Vec::new();
    for a in 0..pages.len() {
        for b in a + 1..pages.len() {
            if pages[a].album == pages[b].album {
                duels.push(if random.rand_float() < 0.5 { [a, b] } else { [b, a] });
            }
        }
    }
    for i in (1..duels.len()).rev() {
        duels.swap(i, random.rand_range(0..i as u64 + 1) as usize);
    }
    duels
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    fn page(album: &str, seed: u64) -> Page {
        Page { album: album.into(), seed, file: PathBuf::new(), terms: Map::new() }
    }

    #[test]
    fn stored_pairs_are_read_back_and_a_bad_line_is_named() -> Result<()> {
        let folder = tempfile::tempdir()?;
        let file = folder.path().join("new").join("pairs.jsonl");
        assert_eq!(read(&file)?, []);
        let terms = |value: f64| Map::from_iter([("hero".to_owned(), Value::from(value))]);
        let pair = Pair { album: "a".into(), seeds: [3, 4], better: terms(0.5), worse: terms(-1.0) };
        store(&file, &pair)?;
        store(&file, &pair)?;
        assert_eq!(read(&file)?, [pair.clone(), pair]);
        fs::write(&file, "{}\n")?;
        assert!(read(&file).is_err_and(|error| format!("{error:#}").contains("line 1")));
        Ok(())
    }

    #[test]
    fn pages_are_compared_within_their_album_only() {
        let pages = [page("a", 1), page("a", 2), page("b", 1), page("a", 3), page("b", 2)];
        let mut duels = duels(&pages, 1);
        assert!(duels.iter().all(|[a, b]| pages[*a].album == pages[*b].album));
        for pair in &mut duels {
            pair.sort_unstable();
        }
        duels.sort_unstable();
        assert_eq!(duels, [[0, 1], [0, 3], [1, 3], [2, 4]]);
    }
}
