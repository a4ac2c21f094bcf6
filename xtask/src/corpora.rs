//! Malformed files for testing decoders, downloaded by package managers, and the results.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};

use crate::project::Project;
use crate::tally::{self, Tally};
use crate::tools;

/// Debian's archive has one version of a package at a time; apt checks its signature.
const DEBIAN: &str = "gdk-pixbuf-tests";
const DEBIAN_FOLDER: &str = "usr/libexec/installed-tests/gdk-pixbuf/test-images";
/// The crate with the sources of libpng, and the SHA-256 of its archive.
const CRATE: (&str, &str, &str) =
    ("libpng-src", "0.2.3", "6189252c6416ae6e97e267f143cfa9ab639bbddfafddf9c6108c07669ebc090b");
const CRATE_FOLDER: &str = "libpng/contrib";

/// Replays all and writes `docs/reports/malformed-files.md`.
///
/// # Errors
/// When a corpus cannot be obtained, or a file is a fault.
pub fn write(project: &Project) -> Result<()> {
    let (folders, missing) = obtain(project);
    if let Some(reason) = missing.first() {
        bail!("the table needs all files: {reason}");
    }
    tools::run(replay(project, "docs/reports/malformed-files.md")?.args(folders))
}

/// Runs the available corpora, and reports missing ones.
///
/// # Errors
/// When the program that reads the files cannot be run.
pub fn check(project: &Project) -> Result<(Tally, bool)> {
    let (folders, missing) = obtain(project);
    for reason in &missing {
        println!("SKIPPED, NOT TESTED: {reason}");
    }
    tally::count(replay(project, "-")?.args(folders))
}

/// The program that reads the files, built as the suite `rust` builds it.
fn replay(project: &Project, table: &str) -> Result<Command> {
    let mut cargo = project.cargo();
    tools::run(cargo.arg("build").args(crate::test::ENGINE).args(["--example", "hostile", "--quiet"]))?;
    let example = format!("debug/examples/hostile{}", std::env::consts::EXE_SUFFIX);
    let mut replay = Command::new(project.target.join(example));
    replay.arg(table).current_dir(&project.root);
    Ok(replay)
}

/// The corpora as `NAME=FOLDER`, and why others are not there.
fn obtain(project: &Project) -> (Vec<String>, Vec<String>) {
    let target = project.target.join("corpora");
    let (mut folders, mut missing) = (Vec::new(), Vec::new());
    match debian(&target) {
        Ok(folder) => {
            for part in ["fail", "randomly-modified", "gif-test-suite", "reftests"] {
                folders.push(format!("{DEBIAN} {part}={}", folder.join(part).display()));
            }
        }
        Err(error) => missing.push(format!("{DEBIAN}: {error:#}")),
    }
    match libpng(project, &target) {
        Ok(folder) => {
            for part in ["pngsuite", "testpngs"] {
                folders.push(format!("libpng {part}={}", folder.join(part).display()));
            }
        }
        Err(error) => missing.push(format!("{}: {error:#}", CRATE.0)),
    }
    (folders, missing)
}

/// Downloads and unpacks the package without installing it, so root is not necessary.
fn debian(target: &Path) -> Result<PathBuf> {
    let folder = target.join(DEBIAN);
    let images = folder.join(DEBIAN_FOLDER);
    if images.is_dir() {
        return Ok(images);
    }
    ensure!(Path::new("/usr/bin/apt-get").exists(), "it needs Debian or a child of it (apt-get, dpkg-deb)");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder)?;
    let mut download = Command::new("apt-get");
    download.args(["download", "-qq", DEBIAN]).current_dir(&folder);
    if tools::run(&mut download).is_err() {
        // The lists may be older than the archive, which only root can mend.
        tools::run(Command::new("apt-get").args(["update", "-qq"]))?;
        tools::run(&mut download)?;
    }
    let mut files = fs::read_dir(&folder)?.flatten().map(|entry| entry.path());
    let package = files.find(|path| path.extension().is_some_and(|kind| kind == "deb"));
    let package = package.context("apt-get left no package")?;
    tools::run(Command::new("dpkg-deb").arg("-x").args([&package, &folder]))?;
    ensure!(images.is_dir(), "the package holds no {DEBIAN_FOLDER}");
    Ok(images)
}

/// Cargo vendors the crate without building it.
fn libpng(project: &Project, target: &Path) -> Result<PathBuf> {
    let (name, version, sha256) = CRATE;
    let folder = target.join(name);
    let vendored = folder.join(format!("vendor/{name}-{version}"));
    if !vendored.join(CRATE_FOLDER).is_dir() {
        fs::create_dir_all(folder.join("src"))?;
        let manifest = format!(
            "[workspace]\n[package]\nname = \"corpora\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\n{name} = \"={version}\"\n"
        );
        fs::write(folder.join("Cargo.toml"), manifest)?;
        fs::write(folder.join("src/lib.rs"), "")?;
        let mut vendor = project.cargo();
        vendor.args(["vendor", "--quiet", "--versioned-dirs", "vendor"]).current_dir(&folder);
        tools::output(&mut vendor)?;
    }
    let sums = fs::read_to_string(vendored.join(".cargo-checksum.json")).context("cargo left no crate")?;
    let sums: serde_json::Value = serde_json::from_str(&sums)?;
    ensure!(sums["package"] == sha256, "{name} {version} is {} instead of {sha256}", sums["package"]);
    Ok(vendored.join(CRATE_FOLDER))
}
