//! Runs each fuzz target of `fuzz/` for a minute.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};

use crate::project::Project;
use crate::tally::Tally;
use crate::tools;

/// Version of cargo-fuzz, which is installed below `target`.
const CARGO_FUZZ: &str = "0.13.2";

/// Seconds per target.
const SECONDS: u32 = 60;

/// Folders with valid files, for the targets without seeds in `fuzz/seeds`.
const SEEDS: [(&str, &[&str]); 3] = [
    ("photo", &["tests/oracles/data/files", "tests/oracles/data/animations", "tests/oracles/data/reduced"]),
    ("style", &["styles"]),
    ("layout", &["layouts"]),
];

/// Runs all targets, one after the other.
///
/// # Errors
/// If cargo-fuzz cannot be installed.
pub fn run(project: &Project) -> Result<crate::test::Outcome> {
    let program = install(project)?;
    let mut tally = Tally::default();
    for target in targets(project)? {
        let corpus = project.root.join("fuzz/corpus").join(&target);
        fs::create_dir_all(&corpus)?;
        let mut fuzz = std::process::Command::new(&program);
        // The toolchain of this project then accepts the options of nightly that cargo-fuzz uses.
        fuzz.current_dir(&project.root)
            .env("RUSTC_BOOTSTRAP", "1")
            .args(["fuzz", "run", &target])
            .arg(corpus);
        match SEEDS.iter().find(|(name, _)| *name == target) {
            Some((_, folders)) => fuzz.args(*folders),
            None => fuzz.arg(format!("fuzz/seeds/{target}")),
        };
        match tools::run(fuzz.args(["--", &format!("-max_total_time={SECONDS}")])) {
            Ok(()) => tally.passed += 1,
            Err(error) => {
                tally.failed += 1;
                tally.failures.push(format!("{target}: {error:#}"));
            }
        }
    }
    Ok((tally, true))
}

/// Returns the names of the targets.
fn targets(project: &Project) -> Result<Vec<String>> {
    let folder = project.root.join("fuzz/fuzz_targets");
    let entries = fs::read_dir(&folder).with_context(|| format!("cannot list {}", folder.display()))?;
    let names =
        entries.map(|entry| Ok(entry?.path().file_stem().map(|name| name.to_string_lossy().into_owned())));
    let mut names: Vec<String> = names.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect();
    names.sort();
    Ok(names)
}

fn install(project: &Project) -> Result<PathBuf> {
    let root = project.target.join("tools").join(format!("cargo-fuzz-{CARGO_FUZZ}"));
    let program = root.join("bin").join(format!("cargo-fuzz{}", std::env::consts::EXE_SUFFIX));
    if !program.is_file() {
        let mut install = project.cargo();
        install.args([
            "install",
            "cargo-fuzz",
            "--locked",
            "--quiet",
            "--debug",
            "--version",
            CARGO_FUZZ,
            "--root",
        ]);
        tools::run(install.arg(&root))?;
    }
    Ok(program)
}
