//! The front end's packages and tools, as `package-lock.json` pins them.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::tools;

/// The oldest Node that Vite 8 and Playwright run on.
const NODE: (u32, u32) = (20, 19);

/// Installs the packages of www unless they are there as the lock file wants them.
pub(crate) fn install(project: &Project) -> Result<()> {
    check_node()?;
    let www = project.www();
    let mut inputs = Inputs::default();
    inputs.path(&www.join("package.json"), &[])?.path(&www.join("package-lock.json"), &[])?;
    let stamp = Stamp::new(project, "npm", &inputs);
    if stamp.is_current(&www.join("node_modules")) {
        return Ok(());
    }
    println!("npm ci in www");
    clean_install(&www)?;
    stamp.keep()
}

/// Installs Ace, which looks at EPUB files, unless it is there as its lock file wants it. The browser that it runs in is the
/// one of the other tests: it downloads none.
pub(crate) fn install_ace(project: &Project) -> Result<()> {
    check_node()?;
    let folder = project.root.join("tests/ace");
    let mut inputs = Inputs::default();
    inputs.path(&folder.join("package-lock.json"), &[])?;
    let stamp = Stamp::new(project, "ace", &inputs);
    if stamp.is_current(&folder.join("node_modules")) {
        return Ok(());
    }
    println!("npm ci in tests/ace");
    tools::run(
        Command::new(program())
            .args(["ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"])
            .env("PUPPETEER_SKIP_DOWNLOAD", "1")
            .current_dir(folder),
    )?;
    stamp.keep()
}

/// `npm ci` in a folder.
pub(crate) fn clean_install(folder: &Path) -> Result<()> {
    // npm's progress and advice is noise here; its errors are not.
    tools::run(
        Command::new(program())
            .args(["ci", "--no-audit", "--no-fund", "--loglevel=error"])
            .current_dir(folder),
    )
}

/// What npm is called here.
pub(crate) fn program() -> &'static str {
    if cfg!(windows) { "npm.cmd" } else { "npm" }
}

/// A JavaScript tool of an installed package: `script` is a path below `node_modules`.
pub(crate) fn tool(project: &Project, script: &str) -> Command {
    let mut command = Command::new("node");
    command.arg(project.www().join("node_modules").join(script)).current_dir(project.www());
    command
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
