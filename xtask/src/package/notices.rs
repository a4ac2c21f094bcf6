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
pub fn text(project: &Project, target: &str, features: &str, packages: &[&str]) -> Result<String> {
    let mut cargo = project.cargo();
    cargo.args(["metadata", "--format-version", "1", "--locked", "--no-default-features"]);
    cargo.args(["--features", features, "--filter-platform", target]);
    let metadata: Value = serde_json::from_str(&tools::output(&mut cargo)?)?;
    let needed = reached(&metadata, &workspace_ids(&metadata, packages), &BTreeSet::new());
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for package in metadata["packages"].as_array().into_iter().flatten() {
        let field = |name: &str| package[name].as_str().unwrap_or_default();
        if package["source"].is_null() || !needed.contains(field("id")) {
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

/// Returns the ids of workspace packages with these names.
pub fn workspace_ids<'a>(metadata: &'a Value, names: &[&str]) -> Vec<&'a str> {
    let packages = metadata["packages"].as_array().into_iter().flatten();
    packages
        .filter(|package| package["source"].is_null())
        .filter(|package| names.iter().any(|name| package["name"] == *name))
        .filter_map(|package| package["id"].as_str())
        .collect()
}

/// Returns the ids of all packages that are compiled into `roots`, including the roots. Packages in `left_out` and their own
/// dependencies are excluded.
pub fn reached<'a>(metadata: &'a Value, roots: &[&'a str], left_out: &BTreeSet<&str>) -> BTreeSet<&'a str> {
    let nodes = metadata["resolve"]["nodes"].as_array().map_or(&[][..], Vec::as_slice);
    let mut reached = BTreeSet::new();
    let mut open = roots.to_vec();
    while let Some(id) = open.pop() {
        if left_out.contains(id) || !reached.insert(id) {
            continue;
        }
        let node = nodes.iter().find(|node| node["id"] == id);
        for other in node.and_then(|node| node["deps"].as_array()).into_iter().flatten() {
            let mut kinds = other["dep_kinds"].as_array().into_iter().flatten();
            // Dependencies of build scripts and tests have a kind.
            if kinds.any(|kind| kind["kind"].is_null()) {
                open.extend(other["pkg"].as_str());
            }
        }
    }
    reached
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
