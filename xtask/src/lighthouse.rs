//! Lighthouse on the start page of the built site.

use std::process::Command;

use anyhow::Result;

use crate::project::Project;
use crate::{chromium, npm, tools};

/// Runs Lighthouse and prints its scores.
///
/// # Errors
/// If a score is below the limits in `bench/lighthouse.js`, or if it cannot run.
pub fn check(project: &Project) -> Result<()> {
    npm::install_peers(project)?;
    let mut lighthouse = Command::new("node");
    lighthouse.arg("bench/lighthouse.js").current_dir(&project.root).env("CHROMIUM", chromium::find()?);
    tools::run(&mut lighthouse)
}
