//! Packages of the npm registry, obtained with npm itself.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use flate2::read::GzDecoder;

use super::digest;
use crate::{npm, tools};

/// A package at one version.
pub(crate) struct Package {
    /// `name@version`.
    pub(crate) name: &'static str,
    /// SHA-256 of its archive.
    pub(crate) sha256: &'static str,
}

impl Package {
    /// Fetches the package below `folder` unless it is there, and unpacks it. Gives the folder of its files.
    pub(crate) fn obtain(&self, folder: &Path) -> Result<PathBuf> {
        let archive = folder.join(self.file_name());
        if !fs::read(&archive).is_ok_and(|bytes| digest(&bytes) == self.sha256) {
            fs::create_dir_all(folder)?;
            let mut pack = Command::new(npm::program());
            pack.args(["pack", "--silent", "--fetch-retries=1", "--pack-destination", "."]).arg(self.name);
            tools::output(pack.current_dir(folder))
                .with_context(|| format!("the npm registry did not give {}", self.name))?;
        }
        let bytes = fs::read(&archive).with_context(|| format!("npm left no {}", self.file_name()))?;
        let found = digest(&bytes);
        ensure!(found == self.sha256, "{} is {found} instead of {}", self.name, self.sha256);
        let unpacked = folder.join(self.file_name().replace(".tgz", ""));
        tar::Archive::new(GzDecoder::new(bytes.as_slice())).unpack(&unpacked).context("cannot unpack")?;
        Ok(unpacked.join("package"))
    }

    /// How npm calls the archive.
    fn file_name(&self) -> String {
        let name = self.name.trim_start_matches('@').replace(['/', '@'], "-");
        format!("{name}.tgz")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn archives_are_called_as_npm_calls_them() {
        let package = Package { name: "@scope/net@1.2.3", sha256: "" };
        assert_eq!(package.file_name(), "scope-net-1.2.3.tgz");
    }

    #[test]
    fn an_archive_that_is_not_the_pinned_one_is_refused() {
        let folder = std::env::temp_dir().join(format!("inkpanel-package-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let package = Package { name: "./no-such-folder@0", sha256: "0" };
        fs::write(folder.join(package.file_name()), "other bytes").unwrap();
        let error = format!("{:#}", package.obtain(&folder).unwrap_err());
        fs::remove_dir_all(&folder).unwrap();
        assert!(error.contains("npm registry") || error.contains("instead of"), "{error}");
    }
}
