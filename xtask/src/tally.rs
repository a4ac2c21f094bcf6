//! Counts passed and failed tests from the summary lines of cargo test, Vitest and Playwright, and lists the
//! failures.

use std::io::{IsTerminal, stdout};
use std::ops::AddAssign;
use std::process::Command;

use anyhow::Result;
use serde_json::Value;

use crate::lane;

/// Tests of one suite, or of all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    pub passed: usize,
    pub failed: usize,
    /// Names of the tests that failed.
    pub failures: Vec<String>,
    /// Names of the tests that failed and passed when tried again.
    pub flaky: Vec<String>,
    /// Names of tests, and the duration of each in seconds.
    pub times: Vec<(String, f64)>,
}

impl Tally {
    /// One failure without a test.
    pub fn failure() -> Self {
        Self { failed: 1, ..Self::default() }
    }

    /// Adds the counts in a line of a test runner.
    fn read(&mut self, line: &str) {
        *self += summary(line);
        self.failures.extend(failure(line));
        let Some((name, seconds)) = timed(line) else { return };
        // The tries of one test have the same name.
        if let Some(at) = self.failures.iter().position(|failed| is_try_of(failed, &name)) {
            let failed = self.failures.remove(at);
            self.flaky.push(failed);
        }
        self.times.push((name, seconds));
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.failures.extend(other.failures);
        self.flaky.extend(other.flaky);
        self.times.extend(other.times);
    }
}

/// Runs a program with its output on this terminal and adds up the summaries it prints. The second value is
/// `true` if the program succeeded.
pub fn count(command: &mut Command) -> Result<(Tally, bool)> {
    if stdout().is_terminal() {
        command.env("CARGO_TERM_COLOR", "always").env("FORCE_COLOR", "1");
    }
    let (mut child, printed) = lane::start(command)?;
    let mut tally = Tally::default();
    lane::lines(printed, |line| {
        lane::say(line);
        tally.read(&without_colour(line));
    })?;
    Ok((tally, child.wait()?.success()))
}

/// The counts of one line: `test result: ok. 5 passed; 0 failed; …` of cargo, `Tests 1 failed | 4 passed (5)`
/// of Vitest, or `5 passed (2.1s)`, `1 failed` and `1 flaky` (passed when tried again) of Playwright. Any
/// other line is ignored.
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

/// The failed test in a line: `test NAME ... FAILED` of cargo, ` FAIL  FILE > NAME` of Vitest,
/// `✘  7 FILE:LINE:COLUMN › NAME` of Playwright.
fn failure(line: &str) -> Option<String> {
    let line = line.trim();
    let of_cargo = line.strip_prefix("test ").and_then(|rest| Some(rest.split_once(" ... FAILED")?.0));
    let of_others = line.strip_prefix("FAIL ").or_else(|| line.strip_prefix('✘'));
    of_cargo.or(of_others).map(|name| name.trim().to_owned())
}

/// The test that passed and its time in seconds, if a line reports one: `test NAME ... ok <1.234s>` of libtest, or
/// `✓  7 FILE:LINE:COLUMN › NAME (1.2s)` of Playwright.
fn timed(line: &str) -> Option<(String, f64)> {
    let line = line.trim();
    if let Some(rest) = line.strip_prefix("test ") {
        let (name, time) = rest.split_once(" ... ok <")?;
        return Some((name.to_owned(), time.strip_suffix("s>")?.parse().ok()?));
    }
    let (name, time) = line.strip_prefix('✓')?.trim().rsplit_once(" (")?;
    let (_, name) = name.split_once(' ')?;
    Some((name.trim().to_owned(), seconds(time.strip_suffix(')')?)?))
}

/// Parses the seconds of a time such as `350ms`, `1.2s` or `1.5m`.
fn seconds(time: &str) -> Option<f64> {
    let unit = time.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
    let number: f64 = time.strip_suffix(unit)?.parse().ok()?;
    match unit {
        "ms" => Some(number / 1000.0),
        "s" => Some(number),
        "m" => Some(number * 60.0),
        _ => None,
    }
}

/// Whether a failed test is an earlier try of the test that passed: `34 FILE › NAME (1.1m)` and `FILE › NAME (retry #1)`.
fn is_try_of(failed: &str, passed: &str) -> bool {
    let Some((passed, _)) = passed.split_once(" (retry #") else { return false };
    let failed = failed.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    failed.starts_with(passed)
}

/// The times in a JSON report of Vitest, in seconds.
pub fn vitest_times(report: &str) -> Result<Vec<(String, f64)>> {
    let report: Value = serde_json::from_str(report)?;
    let files = report["testResults"].as_array().into_iter().flatten();
    let tests = files.flat_map(|file| file["assertionResults"].as_array().into_iter().flatten());
    let time =
        |test: &Value| Some((test["fullName"].as_str()?.to_owned(), test["duration"].as_f64()? / 1000.0));
    Ok(tests.filter_map(time).collect())
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
    fn times_are_read() {
        assert_eq!(timed("test page::words ... ok <0.250s>"), Some(("page::words".to_owned(), 0.25)));
        assert_eq!(timed("test page::words ... ok"), None);
        let name = "[short] › ../tests/a.spec.js:1:1 › opens";
        for (time, expected) in [("350ms", 0.35), ("1.5s", 1.5), ("2.0m", 120.0)] {
            assert_eq!(timed(&format!("  ✓   7 {name} ({time})")), Some((name.to_owned(), expected)));
        }
        let report = r#"{"testResults": [{"assertionResults": [{"fullName": "a b", "duration": 1500}, {"fullName": "c"}]}]}"#;
        assert_eq!(vitest_times(report).unwrap(), [("a b".to_owned(), 1.5)]);
    }

    #[test]
    fn a_test_that_passes_at_the_second_try_is_flaky() {
        let mut tally = Tally::default();
        tally.read("  ✘  34 [webkit] › ../tests/a.spec.js:104:1 › films (1.1m)");
        tally.read("  ✘  35 [webkit] › ../tests/a.spec.js:120:1 › pages (2.0s)");
        tally.read("  ✓  36 [webkit] › ../tests/a.spec.js:104:1 › films (retry #1) (1.0m)");
        assert_eq!(tally.flaky, ["34 [webkit] › ../tests/a.spec.js:104:1 › films (1.1m)"]);
        assert_eq!(tally.failures, ["35 [webkit] › ../tests/a.spec.js:120:1 › pages (2.0s)"]);
    }

    #[test]
    fn a_programs_failure_is_told_apart_from_its_counts() {
        let mut script = Command::new("node");
        script.args(["-e", "console.log('  3 passed (1s)'); process.exit(1)"]);
        assert_eq!(count(&mut script).unwrap(), (Tally { passed: 3, ..Tally::default() }, false));
    }
}
