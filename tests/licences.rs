//! Every library is under a licence that lets anybody use, change and sell what contains it; no other comes in unseen.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Licences that ask for a notice at most.
const PERMISSIVE: &[&str] = &[
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BlueOak-1.0.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "MIT",
    "OFL-1.1",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// Of npm packages also what asks for changes of its own files alone; we change none.
const UNCHANGED: &[&str] = &["MPL-2.0"];

/// Whether an SPDX expression (or cargo's old form with a slash) leaves a choice among the licences.
fn allowed(expression: &str, licences: &[&str]) -> bool {
    let plain = expression.replace(['(', ')'], "").replace('/', " OR ");
    let one = |term: &str| licences.contains(&term.trim());
    // Where a choice stands inside a pair, every part of the pair has to have one.
    plain.split(" AND ").all(|part| part.split(" OR ").any(one))
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn expressions_are_read() {
    assert!(allowed("MIT OR LGPL-2.1-or-later", PERMISSIVE));
    assert!(allowed("(MIT OR Apache-2.0) AND Unicode-3.0", PERMISSIVE));
    assert!(allowed("MIT/Apache-2.0", PERMISSIVE));
    assert!(!allowed("AGPL-3.0-only", PERMISSIVE));
    assert!(!allowed("MIT AND GPL-3.0-only", PERMISSIVE));
    assert!(!allowed("", PERMISSIVE));
}

#[test]
fn crates_are_permissive() {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["metadata", "--format-version", "1", "--locked"]).current_dir(root());
    let answer: Value = serde_json::from_slice(&cargo.output().unwrap().stdout).unwrap();
    let packages = answer["packages"].as_array().unwrap();
    assert!(packages.len() > 50, "only {} packages", packages.len());
    for package in packages {
        let licence = package["license"].as_str().unwrap_or("");
        assert!(allowed(licence, PERMISSIVE), "{}: {licence:?}", package["name"]);
    }
}

#[test]
fn npm_packages_are_permissive() {
    let licences = [PERMISSIVE, UNCHANGED].concat();
    let mut seen = 0;
    for folder in ["www", "bench"] {
        let lock = fs::read_to_string(root().join(folder).join("package-lock.json")).unwrap();
        let lock: Value = serde_json::from_str(&lock).unwrap();
        for (path, package) in lock["packages"].as_object().unwrap() {
            // The first entry is the project itself.
            if path.is_empty() {
                continue;
            }
            seen += 1;
            let licence = package["license"].as_str().unwrap_or("");
            assert!(allowed(licence, &licences), "{folder}/{path}: {licence:?}");
        }
    }
    assert!(seen > 50, "only {seen} packages");
}
