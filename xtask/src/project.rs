//! Where things are: the checkout's folders and cargo's target folder, from whatever folder the command was
//! started in.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::tools;

/// The folders of one checkout. All paths are absolute.
pub(crate) struct Project {
    /// The workspace's top folder.
    pub(crate) root: PathBuf,
    /// Cargo's target folder, wherever the environment or a configuration puts it.
    pub(crate) target: PathBuf,
}

impl Project {
    /// Finds the checkout that this program was built from.
    pub(crate) fn locate() -> Result<Self> {
        // As cargo says it now: checkouts that share a target folder share this program as well.
        let told = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
        let here = told.as_deref().unwrap_or(Path::new(env!("CARGO_MANIFEST_DIR")));
        let root = here.parent().context("xtask stands in the workspace's top folder")?.to_path_buf();
        let metadata = tools::output(
            Command::new(cargo())
                .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
                .current_dir(&root),
        )?;
        let metadata: serde_json::Value = serde_json::from_str(&metadata).context("cargo metadata")?;
        let target =
            metadata["target_directory"].as_str().context("cargo metadata names no target folder")?;
        Ok(Self { root, target: PathBuf::from(target) })
    }

    /// The front end's folder.
    pub(crate) fn www(&self) -> PathBuf {
        self.root.join("www")
    }

    /// Cargo at the top folder, with the target folder of this checkout whatever the environment says.
    pub(crate) fn cargo(&self) -> Command {
        let mut command = Command::new(cargo());
        command.current_dir(&self.root).env("CARGO_TARGET_DIR", &self.target);
        command
    }
}

/// The cargo that started this program, so that every step uses one toolchain.
fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}
