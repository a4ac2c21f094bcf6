//! `cargo xtask translations`: the strings of `www/strings` as files that translators' tools read, and back.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};
use clap::Subcommand;

use crate::project::Project;
use crate::{npm, site, tools};

#[derive(Subcommand)]
pub enum Task {
    /// Write a PO file for each language into a folder, and list texts that need code
    Export {
        /// Where to; it is made if it is not there
        folder: PathBuf,
        /// Only these languages, by tag; a new language gets an empty file
        languages: Vec<String>,
    },
    /// Read a PO file into the folder of its language, and list what was not understood
    Import {
        /// The file, which names its language
        file: PathBuf,
    },
}

/// Exports or imports.
///
/// # Errors
/// When a file cannot be read or written, or a text was rejected.
pub fn run(project: &Project, task: &Task) -> Result<()> {
    npm::install(project)?;
    // The core defines the names of filters and styles.
    if !project.www().join("pkg/inkpanel_bg.wasm").is_file() {
        site::build_module(project, "core")?;
    }
    let mut node = Command::new("node");
    node.arg(project.www().join("strings/exchange/main.js"));
    match task {
        Task::Export { folder, languages } => {
            tools::run(node.arg("export").arg(std::path::absolute(folder)?).args(languages))
        }
        Task::Import { file } => {
            let read = tools::run(node.arg("import").arg(std::path::absolute(file)?));
            format(project)?;
            read.context("not everything was taken")
        }
    }
}

/// As the other files are written.
fn format(project: &Project) -> Result<()> {
    let mut biome = npm::tool(project, "@biomejs/biome/bin/biome");
    tools::run(
        biome.args(["format", "--write", "--log-level=warn", "www/strings"]).current_dir(&project.root),
    )
}
