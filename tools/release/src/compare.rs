//! Whether two folders have the same files with the same bytes.

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

/// How two folders differ in one file, whose path is written with forward slashes.
#[derive(Debug, PartialEq)]
pub(crate) enum Difference {
    FirstAlone(String),
    SecondAlone(String),
    /// Both have it, and from this byte on it differs.
    Bytes(String, usize),
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FirstAlone(file) => write!(f, "{file}: the first build alone has it"),
            Self::SecondAlone(file) => write!(f, "{file}: the second build alone has it"),
            Self::Bytes(file, at) => write!(f, "{file}: differs from byte {at} on"),
        }
    }
}

/// Every file in which the folders differ, by path.
///
/// # Errors
/// When a folder or file cannot be read.
pub(crate) fn folders(first: &Path, second: &Path) -> Result<Vec<Difference>> {
    let files = [self::files(first)?, self::files(second)?];
    let mut differences = Vec::new();
    for file in files[0].union(&files[1]) {
        if !files[1].contains(file) {
            differences.push(Difference::FirstAlone(file.clone()));
        } else if !files[0].contains(file) {
            differences.push(Difference::SecondAlone(file.clone()));
        } else if let Some(at) = parting(&fs::read(first.join(file))?, &fs::read(second.join(file))?) {
            differences.push(Difference::Bytes(file.clone(), at));
        }
    }
    Ok(differences)
}

/// The first byte that is not the same.
fn parting(first: &[u8], second: &[u8]) -> Option<usize> {
    let together = first.iter().zip(second).take_while(|(one, other)| one == other).count();
    (together < first.len().max(second.len())).then_some(together)
}

/// All files below a folder, by their paths in it, with forward slashes.
///
/// # Errors
/// If a folder cannot be listed, or a name is not Unicode.
pub(crate) fn files(folder: &Path) -> Result<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    let mut open = vec![String::new()];
    while let Some(below) = open.pop() {
        let here = folder.join(&below);
        for entry in fs::read_dir(&here).with_context(|| format!("cannot list {}", here.display()))? {
            let entry = entry?;
            let name = entry.file_name();
            let name = name.to_str().with_context(|| format!("{} is no Unicode", entry.path().display()))?;
            let path = if below.is_empty() { name.to_owned() } else { format!("{below}/{name}") };
            if entry.path().is_dir() {
                open.push(path);
            } else {
                found.insert(path);
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in files {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        folder
    }

    #[test]
    fn the_same_bytes_are_no_difference() {
        let files = [("index.html", "a"), ("assets/deep/x.js", "let x;"), ("empty", "")];
        assert_eq!(folders(folder(&files).path(), folder(&files).path()).unwrap(), []);
    }

    #[test]
    fn each_file_that_differs_is_named_once() {
        let first = folder(&[("same", "s"), ("a/gone", "1"), ("a/changed", "one two"), ("longer", "ab")]);
        let second = folder(&[("same", "s"), ("b/new", "1"), ("a/changed", "one too"), ("longer", "abc")]);
        let told: Vec<_> =
            folders(first.path(), second.path()).unwrap().iter().map(ToString::to_string).collect();
        assert_eq!(
            told,
            [
                "a/changed: differs from byte 5 on",
                "a/gone: the first build alone has it",
                "b/new: the second build alone has it",
                "longer: differs from byte 2 on",
            ]
        );
    }

    #[test]
    fn a_folder_that_is_not_there_is_told() {
        let here = folder(&[]);
        assert!(
            folders(here.path(), &here.path().join("none"))
                .unwrap_err()
                .to_string()
                .starts_with("cannot list")
        );
    }
}
