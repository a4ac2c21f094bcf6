//! Tables of measurements in documents, each between two named markers.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

/// The document with the tables of the benchmarks.
pub(crate) const BENCHMARKS: &str = "docs/reports/benchmarks.md";

/// Replaces the table of this name in a document.
///
/// # Errors
/// When the document cannot be read or written, or lacks the markers.
pub fn put(document: &Path, name: &str, table: &str) -> Result<()> {
    let text = fs::read_to_string(document).with_context(|| format!("cannot read {}", document.display()))?;
    let text = between(&text, name, table.trim()).with_context(|| document.display().to_string())?;
    fs::write(document, text).with_context(|| format!("cannot write {}", document.display()))
}

fn between(text: &str, name: &str, table: &str) -> Result<String> {
    let [start, end] = ["start", "end"].map(|side| format!("<!-- {name}:{side} -->"));
    let Some((before, rest)) = text.split_once(&start) else { bail!("the marker {start} is missing") };
    let Some((_, after)) = rest.split_once(&end) else { bail!("the marker {end} is missing") };
    Ok(format!("{before}{start}\n{table}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_replaces_the_last_one() {
        let text = "a\n<!-- native:start -->\nold\n<!-- native:end -->\nb\n";
        let new = between(text, "native", "new").unwrap();
        assert_eq!(new, "a\n<!-- native:start -->\nnew\n<!-- native:end -->\nb\n");
        assert_eq!(between(&new, "native", "new").unwrap(), new);
        assert!(between(text, "batch", "new").is_err());
    }
}
