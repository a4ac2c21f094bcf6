//! Every npm package has a licence that allows everyone to use, change and sell it. `deny.toml` lists the
//! allowed licences, and `cargo xtask test licences` checks the crates with the same list.

use std::fs;

use serde_json::Value;

/// Also allowed for npm packages: a licence that only affects changes of the package's files. None is changed
/// here.
const UNCHANGED: [&str; 1] = ["MPL-2.0"];
/// Also allowed for packages that only tests use: data that requires attribution. Releases do not contain it.
const NAMED: &str = "CC-BY-4.0";
/// The licence of Python, which a parser of command lines has that was Python's: as free as the others.
const PYTHON: &str = "Python-2.0";

/// Whether an SPDX expression (or cargo's old form with a slash) leaves a choice among the licences.
fn allowed(expression: &str, licences: &[String]) -> bool {
    let plain = expression.replace(['(', ')'], "").replace('/', " OR ");
    let one = |term: &str| licences.iter().any(|licence| licence == term.trim());
    // If a choice is inside of a pair, every part of the pair needs an allowed licence.
    plain.split(" AND ").all(|part| part.split(" OR ").any(one))
}

/// The licences that `deny.toml` allows.
fn permissive() -> Vec<String> {
    let file = fs::read_to_string(crate::root("deny.toml")).unwrap();
    let (_, list) = file.split_once("\nallow = [\n").unwrap();
    let (list, _) = list.split_once("\n]").unwrap();
    list.lines().map(|line| line.trim().trim_matches([',', '"']).to_owned()).collect()
}

#[test]
fn expressions_are_read() {
    let permissive = permissive();
    assert!(allowed("MIT OR LGPL-2.1-or-later", &permissive));
    assert!(allowed("(MIT OR Apache-2.0) AND Unicode-3.0", &permissive));
    assert!(allowed("MIT/Apache-2.0", &permissive));
    assert!(!allowed("AGPL-3.0-only", &permissive));
    assert!(!allowed("MIT AND GPL-3.0-only", &permissive));
    assert!(!allowed("", &permissive));
}

#[test]
fn npm_packages_are_permissive() {
    let mut licences = permissive();
    licences.extend(UNCHANGED.map(str::to_owned));
    licences.push(PYTHON.to_owned());
    let mut seen = 0;
    for folder in ["www", "bench", "tests/ace"] {
        let lock = fs::read_to_string(crate::root(folder).join("package-lock.json")).unwrap();
        let lock: Value = serde_json::from_str(&lock).unwrap();
        for (path, package) in lock["packages"].as_object().unwrap() {
            // The first entry is the project itself.
            if path.is_empty() {
                continue;
            }
            seen += 1;
            let licence = package["license"].as_str().unwrap_or("");
            let of_tests = package["dev"] == true && licence == NAMED;
            assert!(of_tests || allowed(licence, &licences), "{folder}/{path}: {licence:?}");
        }
    }
    assert!(seen > 50, "only {seen} packages");
}
