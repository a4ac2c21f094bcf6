//! The version of a release, in every file that names it.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use semver::Version;
use serde_json::Value;
use toml_edit::{DocumentMut, Item};

/// Prefix of the crates in a release. Crates of a lock file without a source belong to this repository.
const CRATES: &str = "inkpanel";
/// The tool belongs to the workspace and inherits its version.
const TOOL: &str = "xtask";

/// A file with another content than it had.
#[derive(Debug, PartialEq)]
pub(crate) struct Edit {
    pub(crate) path: PathBuf,
    before: String,
    after: String,
}

impl Edit {
    /// Returns the edit of `path`, or `None` if nothing changes.
    pub(crate) fn new(path: PathBuf, before: String, after: String) -> Option<Self> {
        (before != after).then_some(Self { path, before, after })
    }
}

/// Edits that were made. They are undone unless the release succeeds.
#[must_use]
pub(crate) struct Made(Vec<Edit>);

impl Made {
    /// Makes all edits, or none.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub(crate) fn make(edits: Vec<Edit>) -> Result<Self> {
        let made = Self(edits);
        for Edit { path, after, .. } in &made.0 {
            fs::write(path, after).with_context(|| format!("cannot write {}", path.display()))?;
        }
        Ok(made)
    }

    pub(crate) fn keep(mut self) {
        self.0.clear();
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        for Edit { path, before, .. } in &self.0 {
            if let Err(error) = fs::write(path, before) {
                eprintln!("{} could not be put back ({error}): `git restore .` does", path.display());
            }
        }
    }
}

/// The version that the workspace in `root` has.
///
/// # Errors
/// When its manifest cannot be read.
pub(crate) fn current(root: &Path) -> Result<Version> {
    let (_, manifest) = toml(&root.join("Cargo.toml"))?;
    let version =
        manifest["workspace"]["package"]["version"].as_str().context("Cargo.toml names no version")?;
    Version::parse(version).with_context(|| format!("Cargo.toml: {version:?} is no version"))
}

/// How each file that names the version has to be changed to name this one.
///
/// # Errors
/// When a file cannot be read, or does not name a version where it should.
pub(crate) fn edits(root: &Path, version: &Version) -> Result<Vec<Edit>> {
    let version = version.to_string();
    let mut edits = Vec::new();
    for (file, keys) in MANIFESTS {
        let path = root.join(file);
        let (before, mut manifest) = toml(&path)?;
        for key in *keys {
            let mut item = manifest.as_item_mut();
            for part in *key {
                item = item.get_mut(part).with_context(|| format!("{file} has no {}", key.join(".")))?;
            }
            set(item, &version).with_context(|| format!("{file}: {} is no version", key.join(".")))?;
        }
        edits.extend(Edit::new(path, before, manifest.to_string()));
    }
    for file in ["Cargo.lock", "python/Cargo.lock"] {
        let path = root.join(file);
        let (before, mut lock) = toml(&path)?;
        let packages =
            lock["package"].as_array_of_tables_mut().with_context(|| format!("{file} has no packages"))?;
        for package in packages.iter_mut() {
            let name = package["name"].as_str().unwrap_or_default();
            let ours = name == TOOL || name.starts_with(CRATES);
            if ours && !package.contains_key("source") {
                set(&mut package["version"], &version)
                    .with_context(|| format!("{file}: a version is no text"))?;
            }
        }
        edits.extend(Edit::new(path, before, lock.to_string()));
    }
    for (file, pointers) in PACKAGES {
        let path = root.join(file);
        let before = read(&path)?;
        let mut after = before.clone();
        for (pointer, line) in *pointers {
            after = in_json(&after, pointer, line, &version).with_context(|| (*file).to_owned())?;
        }
        edits.extend(Edit::new(path, before, after));
    }
    Ok(edits)
}

/// Manifests of Rust, and where in them the version stands. The npm package and the wheel inherit their
/// versions from these.
const MANIFESTS: &[(&str, &[&[&str]])] = &[
    (
        "Cargo.toml",
        &[
            &["workspace", "package", "version"],
            &["workspace", "dependencies", "inkpanel", "version"],
            &["workspace", "dependencies", "inkpanel-detect", "version"],
            &["workspace", "dependencies", "inkpanel-engine", "version"],
            &["workspace", "dependencies", "inkpanel-image", "version"],
            &["workspace", "dependencies", "inkpanel-model", "version"],
            &["workspace", "dependencies", "inkpanel-style", "version"],
        ],
    ),
    ("python/Cargo.toml", &[&["package", "version"]]),
];

/// A file, a pointer to its version, and the start of the line with it. npm always formats these files in the
/// same way.
type Json = (&'static str, &'static [(&'static str, &'static str)]);
const PACKAGES: &[Json] = &[
    ("www/package.json", &[("/version", "  \"version\": \"")]),
    (
        "www/package-lock.json",
        &[("/version", "  \"version\": \""), ("/packages//version", "      \"version\": \"")],
    ),
];

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

fn toml(path: &Path) -> Result<(String, DocumentMut)> {
    let text = read(path)?;
    let parsed = text.parse().with_context(|| format!("{} is no TOML", path.display()))?;
    Ok((text, parsed))
}

/// Replaces a text without changing its surroundings.
fn set(item: &mut Item, version: &str) -> Result<()> {
    let value = item.as_value_mut().filter(|value| value.is_str()).context("there is no text")?;
    let around = value.decor().clone();
    *value = version.into();
    *value.decor_mut() = around;
    Ok(())
}

/// Replaces the version in the first line of `text` that begins with `line`. Everything else is unchanged.
fn in_json(text: &str, pointer: &str, line: &str, version: &str) -> Result<String> {
    let missing = || format!("the version at {pointer} is not where it should be");
    let start = format!("\n{line}");
    let at = text.find(&start).with_context(missing)? + start.len();
    let end = at + text[at..].find('"').with_context(missing)?;
    let changed = format!("{}{version}{}", &text[..at], &text[end..]);
    let parsed: Value = serde_json::from_str(&changed)?;
    ensure!(parsed.pointer(pointer).and_then(Value::as_str) == Some(version), missing());
    Ok(changed)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> PathBuf {
        xtask::project::Project::locate().unwrap().root
    }

    #[test]
    fn all_files_of_the_project_name_one_version() {
        let changed: Vec<_> =
            edits(&root(), &current(&root()).unwrap()).unwrap().into_iter().map(|edit| edit.path).collect();
        assert_eq!(changed, Vec::<PathBuf>::new());
    }

    #[test]
    fn another_version_changes_its_lines_alone() {
        let edits = edits(&root(), &Version::parse("12.3.4-beta.1").unwrap()).unwrap();
        let names: Vec<_> =
            edits.iter().map(|edit| edit.path.strip_prefix(root()).unwrap().to_str().unwrap()).collect();
        assert_eq!(
            names,
            [
                "Cargo.toml",
                "python/Cargo.toml",
                "Cargo.lock",
                "python/Cargo.lock",
                "www/package.json",
                "www/package-lock.json"
            ]
        );
        for Edit { path, before, after } in &edits {
            assert_eq!(before.lines().count(), after.lines().count(), "{}", path.display());
            let lines = before.lines().zip(after.lines()).filter(|(was, is)| was != is);
            let changed: Vec<_> = lines.map(|(_, is)| is).collect();
            assert!(
                !changed.is_empty() && changed.iter().all(|line| line.contains("12.3.4-beta.1")),
                "{changed:?}"
            );
        }
        // The crates of this repository: the library, the command line, engine, document, images, styles, detectors, ten modules, the task runner, three tools.
        let lock = edits.iter().find(|edit| edit.path == root().join("Cargo.lock")).unwrap();
        assert_eq!(lock.after.matches("\"12.3.4-beta.1\"").count(), 21);
    }

    #[test]
    fn edits_are_taken_back_unless_they_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "before").unwrap();
        let edit = || vec![Edit::new(path.clone(), "before".into(), "after".into()).unwrap()];
        let made = Made::make(edit()).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "after");
        drop(made);
        assert_eq!(fs::read_to_string(&path).unwrap(), "before");
        Made::make(edit()).unwrap().keep();
        assert_eq!(fs::read_to_string(&path).unwrap(), "after");
    }

    #[test]
    fn edits_that_cannot_all_be_made_are_none() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "before").unwrap();
        let edits = vec![
            Edit::new(path.clone(), "before".into(), "after".into()).unwrap(),
            Edit::new(folder.path().join("none/b"), "before".into(), "after".into()).unwrap(),
        ];
        assert!(Made::make(edits).is_err());
        assert_eq!(fs::read_to_string(&path).unwrap(), "before");
    }

    #[test]
    fn a_version_that_is_elsewhere_in_json_is_told() {
        let told = in_json("{\n  \"a\": {\n  \"version\": \"1\"\n}}", "/version", "  \"version\": \"", "2");
        assert_eq!(told.unwrap_err().to_string(), "the version at /version is not where it should be");
    }
}
