//! Packages of the npm registry and of the Python package index, downloaded by npm and pip.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use flate2::read::GzDecoder;

use super::digest;
use crate::program;

/// A package registry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Registry {
    /// A gzipped tar archive by npm.
    Npm,
    /// A Python wheel (a zip archive), downloaded by pip. Optional, because Python may be missing.
    PyPi,
}

/// A package at one version.
#[derive(Debug)]
pub struct Package<'a> {
    /// The registry that publishes it.
    pub registry: Registry,
    /// `name@version` for npm, `name==version` for pip.
    pub name: &'a str,
    /// SHA-256 of its archive.
    pub sha256: &'a str,
}

impl Package<'_> {
    /// Downloads the package into `folder` unless it is there, and unpacks it. Returns the folder of its files.
    ///
    /// # Errors
    /// If the registry cannot be reached or the SHA-256 differs.
    pub fn obtain(&self, folder: &Path) -> Result<PathBuf> {
        let archive = folder.join(self.file_name());
        if !fs::read(&archive).is_ok_and(|bytes| digest(&bytes) == self.sha256) {
            fs::create_dir_all(folder)?;
            program::run(self.fetch().current_dir(folder))
                .with_context(|| format!("{} did not give {}", self.registry.title(), self.name))?;
        }
        let bytes = fs::read(&archive).with_context(|| format!("no {} was left", self.file_name()))?;
        let found = digest(&bytes);
        ensure!(found == self.sha256, "{} is {found} instead of {}", self.name, self.sha256);
        match self.registry {
            Registry::Npm => {
                let unpacked = folder.join(self.file_name().replace(".tgz", ""));
                let mut files = tar::Archive::new(GzDecoder::new(bytes.as_slice()));
                files.unpack(&unpacked).context("cannot unpack")?;
                Ok(unpacked.join("package"))
            }
            Registry::PyPi => {
                let unpacked = folder.join(self.file_name().replace(".whl", ""));
                // Python unpacks zip archives. It is installed, because pip downloaded this one.
                let mut unpack = Command::new(program::PYTHON);
                unpack.args(["-m", "zipfile", "-e", &self.file_name()]).arg(&unpacked);
                program::run(unpack.current_dir(folder)).context("cannot unpack")?;
                Ok(unpacked)
            }
        }
    }

    /// The command that leaves the archive in the working folder.
    fn fetch(&self) -> Command {
        match self.registry {
            Registry::Npm => {
                let mut pack = Command::new(program::NPM);
                pack.args(["pack", "--silent", "--fetch-retries=1", "--pack-destination", "."])
                    .arg(self.name);
                pack
            }
            Registry::PyPi => {
                let mut download = Command::new(program::PYTHON);
                download.args(["-m", "pip", "download", "--quiet", "--disable-pip-version-check"]);
                download
                    .args(["--retries=1", "--no-deps", "--only-binary=:all:", "--dest", "."])
                    .arg(self.name);
                download
            }
        }
    }

    /// Returns the file name of the archive.
    fn file_name(&self) -> String {
        match self.registry {
            Registry::Npm => format!("{}.tgz", self.name.trim_start_matches('@').replace(['/', '@'], "-")),
            Registry::PyPi => {
                format!("{}-py3-none-any.whl", self.name.replace('-', "_").replace("==", "-"))
            }
        }
    }
}

impl Registry {
    fn title(self) -> &'static str {
        match self {
            Self::Npm => "the npm registry",
            Self::PyPi => "pip",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn archives_are_called_as_the_registries_call_them() {
        let package = Package { registry: Registry::Npm, name: "@scope/net@1.2.3", sha256: "" };
        assert_eq!(package.file_name(), "scope-net-1.2.3.tgz");
        let package = Package { registry: Registry::PyPi, name: "good-net==1.2.3", sha256: "" };
        assert_eq!(package.file_name(), "good_net-1.2.3-py3-none-any.whl");
    }

    #[test]
    fn an_archive_that_is_not_the_pinned_one_is_refused() {
        let folder = std::env::temp_dir().join(format!("inkpanel-package-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let package = Package { registry: Registry::Npm, name: "./no-such-folder@0", sha256: "0" };
        fs::write(folder.join(package.file_name()), "other bytes").unwrap();
        let error = format!("{:#}", package.obtain(&folder).unwrap_err());
        fs::remove_dir_all(&folder).unwrap();
        assert!(error.contains("npm registry") || error.contains("instead of"), "{error}");
    }
}
