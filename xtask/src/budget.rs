//! The size of what a visitor downloads before the first page.

use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result, bail};
use flate2::{Compression, write::GzEncoder};

use crate::project::Project;

/// The most that the core (module and its script) may take, gzipped, in bytes.
const CORE: usize = 700_000;

/// Fails when the core has outgrown its budget.
pub(crate) fn check(project: &Project) -> Result<()> {
    let folder = project.www().join("pkg");
    let size = gzipped(&folder.join("inkpanel_bg.wasm"))? + gzipped(&folder.join("inkpanel.js"))?;
    println!("core module and its script: {size} bytes gzipped, {CORE} allowed");
    if size > CORE {
        bail!("the core is {} bytes above its budget", size - CORE);
    }
    Ok(())
}

fn gzipped(file: &Path) -> Result<usize> {
    let bytes = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&bytes)?;
    Ok(encoder.finish()?.len())
}
