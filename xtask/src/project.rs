//! Paths of the checkout and of cargo's target folder, independent of the working folder.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::tools;

/// The folders of one checkout. All paths are absolute.
pub struct Project {
    /// The workspace's top folder.
    pub root: PathBuf,
    /// Cargo's target folder, wherever the environment or a configuration puts it.
    pub target: PathBuf,
    /// Whether cargo stores the state for incremental compilation.
    incremental: bool,
}

impl Project {
    /// Finds the checkout that this program was built from.
    pub fn locate() -> Result<Self> {
        // Read at run time, because checkouts with a shared target folder share this program.
        let told = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
        let here = told.as_deref().unwrap_or(Path::new(env!("CARGO_MANIFEST_DIR")));
        // The release tool is deeper in the workspace than the task runner.
        let root = here.ancestors().find(|folder| folder.join("Cargo.lock").is_file());
        let root = root.context("no folder above this program has a Cargo.lock")?.to_path_buf();
        let metadata = tools::output(
            Command::new(cargo())
                .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
                .current_dir(&root),
        )?;
        let metadata: serde_json::Value = serde_json::from_str(&metadata).context("cargo metadata")?;
        let target =
            metadata["target_directory"].as_str().context("cargo metadata names no target folder")?;
        Ok(Self::at(root, PathBuf::from(target)))
    }

    /// A checkout at an absolute path, and its target folder.
    pub fn at(root: PathBuf, target: PathBuf) -> Self {
        let incremental = has_incremental(&target);
        Self { root, target, incremental }
    }

    /// The front end's folder.
    pub fn www(&self) -> PathBuf {
        self.root.join("www")
    }

    /// Cargo in the top folder, always with the target folder of this checkout.
    pub fn cargo(&self) -> Command {
        let mut command = Command::new(cargo());
        command.current_dir(&self.root).env("CARGO_TARGET_DIR", &self.target);
        if !self.incremental && std::env::var_os("CARGO_INCREMENTAL").is_none() {
            command.env("CARGO_INCREMENTAL", "0");
        }
        command
    }
}

/// Whether the engine was compiled incrementally here before. In continuous integration, storing the state
/// would take a third of the compile time.
fn has_incremental(target: &Path) -> bool {
    let kept = std::fs::read_dir(target.join("debug/incremental"));
    kept.is_ok_and(|entries| {
        entries.flatten().any(|entry| entry.file_name().to_string_lossy().starts_with("inkpanel"))
    })
}

/// The cargo that started this program, so that every step uses one toolchain.
pub fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_engine_that_was_compiled_by_hand_is_compiled_incrementally() {
        let target = tempfile::tempdir().unwrap();
        assert!(!has_incremental(target.path()));
        // Cargo compiles this program before the program can set options.
        let kept = target.path().join("debug/incremental");
        std::fs::create_dir_all(kept.join("xtask-1x2y3z")).unwrap();
        assert!(!has_incremental(target.path()));
        std::fs::create_dir_all(kept.join("inkpanel_image-1x2y3z")).unwrap();
        assert!(has_incremental(target.path()));
    }
}
