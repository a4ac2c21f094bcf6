//! Checks the licences and sources of all crates with cargo-deny and `deny.toml`.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::project::Project;
use crate::tools;

/// Version that is installed below `target`.
const CARGO_DENY: &str = "0.20.2";

/// Workspaces with a separate lock file, whose crates are also distributed.
const MANIFESTS: [&str; 2] = ["Cargo.toml", "python/Cargo.toml"];

/// Checks crates by `deny.toml`. Advisories are skipped, because their database is a separate download.
///
/// # Errors
/// When cargo-deny cannot be installed, or has something against a crate.
pub fn check(project: &Project) -> Result<()> {
    let program = install(project)?;
    for manifest in MANIFESTS {
        let mut deny = Command::new(&program);
        deny.args(["--manifest-path", manifest, "--config", "deny.toml", "check"]);
        tools::run(deny.args(["licenses", "bans", "sources"]).current_dir(&project.root))?;
    }
    Ok(())
}

fn install(project: &Project) -> Result<PathBuf> {
    let folder = project.target.join("tools");
    let program = folder.join(format!("bin/cargo-deny{}", std::env::consts::EXE_SUFFIX));
    if is_installed(&program) {
        return Ok(program);
    }
    println!("cargo install cargo-deny {CARGO_DENY}");
    let mut cargo = project.cargo();
    cargo.args(["install", "cargo-deny", "--version", CARGO_DENY, "--locked", "--quiet", "--root"]);
    // It runs for a second, so a fast compilation matters more.
    tools::run(cargo.arg(&folder).arg("--debug").env("CARGO_PROFILE_DEV_DEBUG", "0"))?;
    Ok(program)
}

fn is_installed(program: &Path) -> bool {
    let version = Command::new(program).arg("--version").output();
    version.is_ok_and(|told| String::from_utf8_lossy(&told.stdout).trim().ends_with(CARGO_DENY))
}
