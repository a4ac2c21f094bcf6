//! Takes what the program draws now as what it should draw.

use std::process::Command;

use anyhow::Result;

use crate::project::Project;
use crate::tools;

/// What tests write when they bless.
const BLESSED: &[&str] =
    &["tests/goldens", "styles/README.md", "www/engine/bounds.ts", "www/document/empty.ts"];

/// Regenerates the stored images and values. A blessing test run fails on purpose, so that it never passes for a
/// test; here only compiling must succeed. What changed is listed, to be looked at before it is committed.
pub(crate) fn run(project: &Project) -> Result<()> {
    tools::run(project.cargo().args(["test", "--workspace", "--no-run"]))?;
    let blessing = ["test", "--workspace", "--no-fail-fast"];
    if let Err(error) = tools::run(project.cargo().args(blessing).env("BLESS", "1")) {
        println!("{error}: a test that blesses fails");
    }
    let mut git = Command::new("git");
    git.args(["status", "--short", "--"]).args(BLESSED).current_dir(&project.root);
    let changed = tools::output(&mut git)?;
    if changed.is_empty() {
        println!("\nNothing changed in {}.", BLESSED.join(", "));
    } else {
        println!("\nChanged; look at each before committing it:\n{changed}");
    }
    Ok(())
}
