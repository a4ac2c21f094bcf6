//! The glyph file of the app: the table of `crates/engine/pack.rs`, which the `words` and `exports` modules share. It
//! is compressed here, because servers do not compress unknown file types. Its checksum detects damage.

#[path = "../../crates/engine/pack.rs"]
mod pack;

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use anyhow::{Context, Result, anyhow};
use flate2::{Compression, write::ZlibEncoder};

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};

/// The folder of `letters.bin`.
pub fn folder(project: &Project) -> PathBuf {
    project.www().join("letters")
}

/// Writes the glyphs unless they exist.
pub fn make(project: &Project) -> Result<()> {
    let (fonts, file) = (project.root.join("fonts"), folder(project).join("letters.bin"));
    let mut inputs = Inputs::default();
    inputs
        .path(&fonts, &[])?
        .value(include_str!("letters.rs"))
        .value(include_str!("../../crates/engine/pack.rs"));
    let stamp = Stamp::new(project, "letters", &inputs);
    if stamp.is_current(&file) {
        return Ok(());
    }
    let table = pack::pack(&fonts).map_err(|error| anyhow!("fonts: {error}"))?;
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&table)?;
    fs::create_dir_all(folder(project))?;
    fs::write(&file, encoder.finish()?).with_context(|| format!("cannot write {}", file.display()))?;
    stamp.keep()
}
