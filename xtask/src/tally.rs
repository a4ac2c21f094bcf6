//! Counts what passed and failed from the summary lines of cargo test, Vitest and Playwright, and notes which failed.

use std::io::{IsTerminal, stdout};
use std::ops::AddAssign;
use std::process::Command;

use anyhow::Result;

use crate::lane;

/// Tests of one suite, or of all.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    pub passed: usize,
    pub failed: usize,
    /// What the runner said of each that failed: a test that passed when tried again is among them.
    pub failures: Vec<String>,
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.failures.extend(other.failures);
    }
}

/// Runs a program with its output on this terminal and adds up the summaries it prints. The second value tells
/// whether the program itself ended well.
pub fn count(command: &mut Command) -> Result<(Tally, bool)> {
    if stdout().is_terminal() {
        command.env("CARGO_TERM_COLOR", "always").env("FORCE_COLOR", "1");
    }
    let (mut child, printed) = lane::start(command)?;
    let mut tally = Tally::default();
    lane::lines(printed, |line| {
        lane::say(line);
        let line = without_colour(line);
        tally += summary(&line);
        tally.failures.extend(failure(&line));
    })?;
    Ok((tally, child.wait()?.success()))
}

/// The counts of one line: `test result: ok. 5 passed; 0 failed; …` of cargo, `Tests  1 failed | 4 passed (5)`
/// of Vitest, or `5 passed (2.1s)`, `1 failed` and `1 flaky` (passed when tried again) of Playwright. Any other line counts
/// nothing.
fn summary(line: &str) -> Tally {
    let words: Vec<&str> = line.split_whitespace().collect();
    let number = |word: &str| word.parse::<usize>().ok();
    let of_runner = line.starts_with("test result:")
        || words.first() == Some(&"Tests")
        || matches!(words.as_slice(), [n, "failed" | "flaky"] | [n, "passed", _] if number(n).is_some());
    let mut tally = Tally::default();
    if of_runner {
        for pair in words.windows(2) {
            match (number(pair[0]), pair[1].trim_end_matches(';')) {
                (Some(passed), "passed" | "flaky") => tally.passed += passed,
                (Some(failed), "failed") => tally.failed += failed,
                _ => {}
            }
        }
    }
    tally
}

/// The test that failed, where a line tells of one: `test NAME ... FAILED` of cargo, ` FAIL  FILE > NAME` of Vitest,
/// `✘  7 FILE:LINE:COLUMN › NAME` of Playwright.
fn failure(line: &str) -> Option<String> {
    let line = line.trim();
    let of_cargo = line.strip_prefix("test ").and_then(|rest| rest.strip_suffix(" ... FAILED"));
    let of_others = line.strip_prefix("FAIL ").or_else(|| line.strip_prefix('✘'));
    of_cargo.or(of_others).map(|name| name.trim().to_owned())
}

/// The line without its terminal colours.
fn without_colour(line: &str) -> String {
    let mut plain = String::with_capacity(line.len());
    let mut rest = line;
    while let Some((before, sequence)) = rest.split_once("\u{1b}[") {
        plain.push_str(before);
        rest = sequence.split_once(|c: char| c.is_ascii_alphabetic()).map_or("", |(_, after)| after);
    }
    plain + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(line: &str) -> (usize, usize) {
        let Tally { passed, failed, .. } = summary(&without_colour(line));
        (passed, failed)
    }

    #[test]
    fn each_runner_is_understood() {
        assert_eq!(
            counts("test result: FAILED. 5 passed; 2 failed; 1 ignored; 0 measured; 0 filtered out"),
            (5, 2)
        );
        assert_eq!(
            counts("\u{1b}[2m      Tests \u{1b}[22m \u{1b}[1m\u{1b}[32m12 passed\u{1b}[39m\u{1b}[22m (12)"),
            (12, 0)
        );
        assert_eq!(counts("      Tests  1 failed | 11 passed (12)"), (11, 1));
        assert_eq!(counts("  7 passed (3.4s)"), (7, 0));
        assert_eq!(counts("  2 failed"), (0, 2));
        assert_eq!(counts("  1 flaky"), (1, 0));
    }

    #[test]
    fn other_lines_count_nothing() {
        assert_eq!(counts(" Test Files  3 passed (3)"), (0, 0));
        assert_eq!(counts("test gives::3 passed ... ok"), (0, 0));
        assert_eq!(counts("expected 3 passed photos, 1 failed"), (0, 0));
    }

    #[test]
    fn what_failed_is_noted() {
        assert_eq!(failure("test page::words ... FAILED").as_deref(), Some("page::words"));
        assert_eq!(
            failure(" FAIL  engine/pool.test.ts > a job waits").as_deref(),
            Some("engine/pool.test.ts > a job waits")
        );
        let line = "  ✘  34 [webkit] › ../tests/a.spec.js:104:1 › films (retry #1) (1.1m)";
        assert_eq!(
            failure(line).as_deref(),
            Some("34 [webkit] › ../tests/a.spec.js:104:1 › films (retry #1) (1.1m)")
        );
        assert_eq!(failure("test result: FAILED. 5 passed; 2 failed"), None);
        assert_eq!(failure("test page::words ... ok"), None);
    }

    #[test]
    fn a_programs_failure_is_told_apart_from_its_counts() {
        let mut script = Command::new("node");
        script.args(["-e", "console.log('  3 passed (1s)'); process.exit(1)"]);
        assert_eq!(count(&mut script).unwrap(), (Tally { passed: 3, ..Tally::default() }, false));
    }
}
