//! `cargo xtask test prose`: counts unclear English per file. `tests/prose/` has the rules and the allowed counts.

use std::process::Command;

use anyhow::Result;

use crate::project::Project;
use crate::tools;

/// Runs the check.
///
/// # Errors
/// If a count rose, or a commit subject breaks a rule.
pub fn check(project: &Project) -> Result<()> {
    tools::run(Command::new("node").arg("tests/prose/check.mjs").current_dir(&project.root))
}
