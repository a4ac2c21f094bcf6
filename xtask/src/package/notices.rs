//! Collects the licences of the crates in the wasm modules. Most licences require that copies include their
//! text.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::project::Project;
use crate::tools;

/// How files with licences and notices begin.
const BEGINNINGS: [&str; 4] = ["LICENSE", "LICENCE", "COPYING", "NOTICE"];

/// Returns the licence texts of all third-party crates in these workspace packages. Each text is printed once, below the
/// crates that it covers. A crate without a licence file is listed with its authors.
///
/// # Errors
/// If `cargo metadata` fails.
pub fn text(project: &Project, target: &str, packages: &[&str]) -> Result<String> {
    let mut cargo = project.cargo();
    cargo.args(["metadata", "--format-version", "1", "--locked", "--filter-platform", target]);
    let metadata: Value = serde_json::from_str(&tools::output(&mut cargo)?)?;
    let needed = compiled(project, "Cargo.toml", target, packages, Macros::Included)?;
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let field = |name: &str| package[name].as_str().unwrap_or_default();
        if package["source"].is_null() || !needed.contains(&named(field("name"), field("version"))) {
            continue;
        }
        let title = format!("{} {} ({})", field("name"), field("version"), field("license"));
        let folder = Path::new(field("manifest_path")).parent().context("a manifest lies in a folder")?;
        let mut found = files(folder)?;
        if found.is_empty() {
            let authors: Vec<_> =
                package["authors"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
            found.push(format!("Licence as named above. Authors: {}", authors.join(", ")));
        }
        for text in found {
            texts.entry(text).or_default().push(title.clone());
        }
    }
    let mut written = "Libraries that are compiled into this, and their licences.\n".to_owned();
    for (text, titles) in &texts {
        // Writing to a string cannot fail.
        let _ = write!(written, "\n{}\n{}\n\n{text}\n", "=".repeat(80), titles.join("\n"));
    }
    Ok(written)
}

/// Whether procedural macros count. They run in the compiler, and none of their code is in the output.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Macros {
    Included,
    LeftOut,
}

/// Returns the crates that cargo compiles into packages of a workspace for a target, as [`named`]. Only features of these packages
/// count, not the features that other packages of the workspace turn on.
///
/// # Errors
/// If `cargo tree` fails.
pub fn compiled(
    project: &Project,
    manifest: &str,
    target: &str,
    packages: &[&str],
    macros: Macros,
) -> Result<BTreeSet<String>> {
    let mut cargo = project.cargo();
    let edges = if macros == Macros::Included { "normal" } else { "normal,no-proc-macro" };
    cargo.args(["tree", "--locked", "--prefix", "none", "--format", "{p}", "--edges", edges]);
    cargo.args(["--manifest-path", manifest, "--target", target]);
    for package in packages {
        cargo.args(["--package", package]);
    }
    Ok(listed(&tools::output(&mut cargo)?))
}

/// The crates in the lines of `cargo tree`, such as `zip v4.6.1 (*)`.
fn listed(tree: &str) -> BTreeSet<String> {
    let name = |line: &str| {
        let (name, rest) = line.split_once(" v")?;
        Some(named(name, rest.split(' ').next()?))
    };
    tree.lines().filter_map(name).collect()
}

/// A crate and its version as one text.
#[must_use]
pub fn named(name: &str, version: &str) -> String {
    format!("{name} {version}")
}

/// The texts in a crate's folder, without the spaces that differ from one to the other.
fn files(folder: &Path) -> Result<Vec<String>> {
    let mut paths = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    paths.retain(|path| {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default().to_uppercase();
        path.is_file() && BEGINNINGS.iter().any(|beginning| name.starts_with(beginning))
    });
    paths.sort();
    let read = |path: &Path| -> Result<String> {
        let text = String::from_utf8_lossy(&fs::read(path)?).replace('\r', "");
        let lines: Vec<_> = text.trim().lines().map(str::trim_end).collect();
        Ok(lines.join("\n"))
    };
    paths.iter().map(|path| read(path)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crates_are_read_from_the_lines_of_a_tree() {
        let tree = "inkpanel-core v0.1.0 (/checkout/wasm/core)\nserde v1.0.228\nserde_derive v1.0.228 (proc-macro)\n\nserde v1.0.228 (*)\n";
        let found: Vec<_> = listed(tree).into_iter().collect();
        assert_eq!(found, ["inkpanel-core 0.1.0", "serde 1.0.228", "serde_derive 1.0.228"]);
    }
}
