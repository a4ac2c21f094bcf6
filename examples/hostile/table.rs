//! The table of outcomes: a row a corpus, a column an outcome that occurs.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::Outcome;

/// Text above the table.
pub(crate) const ABOUT: &str = "\
# Malformed files

This report shows how the decoders handle malformed and malicious files.
`cargo xtask corpora` writes it, and `cargo xtask test corpora` repeats the run.

- The files come from the Debian package `gdk-pixbuf-tests` and the crate `libpng-src` 0.2.3. Package managers download them; the repository does not contain them.
- `examples/hostile/made.rs` generates the files *made here*: records that inflate to 900 MB, tiles and planes of many sizes, wrong fields, and frames outside the screen.
- Inkpanel reads each file as the app does. The suite fails if a file causes a panic, takes more than five seconds, or needs more than 1 GiB.
- Times are from a test build. *Memory* is the largest peak of one file.
";

/// The table of all corpora, and their sum.
pub(crate) fn written(corpora: &[(String, Vec<Outcome>)]) -> String {
    let found: BTreeSet<&str> =
        corpora.iter().flat_map(|(_, all)| all.iter().map(|one| one.word.as_str())).collect();
    // `decoded` comes first, then the codes by name.
    let (mut words, codes): (Vec<&str>, Vec<&str>) = found.into_iter().partition(|word| *word == "decoded");
    words.extend(codes);
    let mut text = format!("| Corpus | Files | {} | Slowest | Memory |\n", words.join(" | "));
    let _ = writeln!(text, "|---|{}", "--:|".repeat(words.len() + 3));
    let mut row = |name: &str, outcomes: &[&Outcome]| {
        let counts =
            words.iter().map(|word| outcomes.iter().filter(|one| one.word == *word).count().to_string());
        let slowest = outcomes.iter().map(|one| one.time.as_millis()).max().unwrap_or(0);
        let memory = outcomes.iter().filter_map(|one| one.memory).max();
        let memory = memory.map_or("not known".to_owned(), |bytes| format!("{} MB", bytes >> 20));
        let counts = counts.collect::<Vec<_>>().join(" | ");
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {} | {counts} | {slowest} ms | {memory} |", outcomes.len());
    };
    for (name, outcomes) in corpora {
        row(name, &outcomes.iter().collect::<Vec<_>>());
    }
    row("all", &corpora.iter().flat_map(|(_, all)| all).collect::<Vec<_>>());
    text
}
