//! The table of outcomes: a row a corpus, a column an outcome that occurs.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::Outcome;

/// What stands above the table.
pub(crate) const ABOUT: &str = "\
# Hostile files

Written by `cargo xtask corpora`; `cargo xtask test corpora` replays the same. The files come from Debian's package
`gdk-pixbuf-tests` and from the sources of libpng in the crate `libpng-src` 0.2.3, by the package managers, and are not
kept here; those *made here* come from `examples/hostile/made.rs`: records that inflate to 900 MB, tiles and planes of all
sizes, fields that lie, screens that are no frames. Each file is read as the page reads it; one that panics, takes more than five seconds or more memory than
the limit (1 GiB) fails the suite. Times are those of a build for tests. *Memory* is the most that one file took.
";

/// The table of all corpora, and their sum.
pub(crate) fn written(corpora: &[(String, Vec<Outcome>)]) -> String {
    let found: BTreeSet<&str> =
        corpora.iter().flat_map(|(_, all)| all.iter().map(|one| one.word.as_str())).collect();
    // What decodes first, then the codes by name.
    let (mut words, codes): (Vec<&str>, Vec<&str>) = found.into_iter().partition(|word| *word == "decoded");
    words.extend(codes);
    let mut text = format!("| Corpus | Files | {} | Slowest | Memory |\n", words.join(" | "));
    let _ = writeln!(text, "|---|{}", "--:|".repeat(words.len() + 3));
    let mut row = |name: &str, outcomes: &[&Outcome]| {
        let counts =
            words.iter().map(|word| outcomes.iter().filter(|one| one.word == *word).count().to_string());
        let slowest = outcomes.iter().map(|one| one.time.as_millis()).max().unwrap_or(0);
        let memory = outcomes.iter().filter_map(|one| one.memory).max();
        let memory = memory.map_or("not told".to_owned(), |bytes| format!("{} MB", bytes >> 20));
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
