//! The front end's packages and tools, as `package-lock.json` pins them.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::tools;

/// The oldest Node that Vite 8 and Playwright run on.
const NODE: (u32, u32) = (20, 19);

/// Installs the packages of www unless they match the lock file.
pub fn install(project: &Project) -> Result<()> {
    let www = project.www();
    install_in(project, "npm", &www, clean_install(&www))
}

/// Installs the libraries for comparisons. They have a separate lock file, so the site build does not
/// download them.
pub fn install_peers(project: &Project) -> Result<()> {
    let folder = project.root.join("bench");
    install_in(project, "peers", &folder, clean_install(&folder))
}

/// Installs Ace, the EPUB checker, unless the version of its lock file is installed. It uses the browser of
/// the other tests and downloads none.
pub fn install_ace(project: &Project) -> Result<()> {
    let folder = project.root.join("tests/ace");
    let mut install = clean_install(&folder);
    install.arg("--ignore-scripts").env("PUPPETEER_SKIP_DOWNLOAD", "1");
    install_in(project, "ace", &folder, install)
}

/// Runs `install` unless the packages of a folder match its files.
fn install_in(project: &Project, name: &'static str, folder: &Path, mut install: Command) -> Result<()> {
    check_node()?;
    let mut inputs = Inputs::default();
    inputs.path(&folder.join("package.json"), &[])?.path(&folder.join("package-lock.json"), &[])?;
    let stamp = Stamp::new(project, name, &inputs);
    if stamp.is_current(&folder.join("node_modules")) {
        return Ok(());
    }
    println!("npm ci in {}", folder.strip_prefix(&project.root).unwrap_or(folder).display());
    tools::run(&mut install)?;
    stamp.keep()
}

/// `npm ci` in a folder.
fn clean_install(folder: &Path) -> Command {
    let mut install = Command::new(program());
    // npm's progress and advice is noise here; its errors are not.
    install.args(["ci", "--no-audit", "--no-fund", "--loglevel=error"]).current_dir(folder);
    install
}

/// Name of the npm program on this system.
pub fn program() -> &'static str {
    if cfg!(windows) { "npm.cmd" } else { "npm" }
}

/// A JavaScript tool of an installed package: `script` is a path below `node_modules`.
pub fn tool(project: &Project, script: &str) -> Command {
    let mut command = Command::new("node");
    command.arg(project.www().join("node_modules").join(script)).current_dir(project.www());
    command
}

/// Compiles the messages of the app for the type checker. Vite compiles them automatically.
pub fn compile_strings(project: &Project) -> Result<()> {
    let www = project.www();
    tools::run(Command::new("node").arg("strings/compile.js").current_dir(www))
}

fn check_node() -> Result<()> {
    let printed = tools::output(Command::new("node").arg("--version"))?;
    let found = version(&printed).with_context(|| format!("`node --version` printed {printed:?}"))?;
    if found < NODE {
        bail!("Node {} is too old: install Node {}.{} or newer", printed.trim(), NODE.0, NODE.1);
    }
    Ok(())
}

/// Major and minor of `v20.19.1`.
fn version(printed: &str) -> Option<(u32, u32)> {
    let mut numbers = printed.trim().trim_start_matches('v').split('.').map(str::parse);
    Some((numbers.next()?.ok()?, numbers.next()?.ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn node_versions_compare_as_numbers() {
        assert!(version("v20.9.0\n") < Some(NODE));
        assert!(version("v22.1.0\n") > Some(NODE));
        assert_eq!(version("nonsense"), None);
    }
}
