//! Skips a step with unchanged inputs: stores a hash of the inputs after the step.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::project::Project;

/// A hash over everything that a step depends on.
#[derive(Default)]
pub struct Inputs(DefaultHasher);

impl Inputs {
    /// Adds a value, for example an option of the step.
    pub fn value(&mut self, value: &str) -> &mut Self {
        value.hash(&mut self.0);
        self
    }

    /// Adds a file's bytes, or all files below a folder with their names. Entries called `skip` are left out.
    pub fn path(&mut self, path: &Path, skip: &[&str]) -> Result<&mut Self> {
        if path.is_dir() {
            let mut entries = fs::read_dir(path)?.collect::<Result<Vec<_>, _>>()?;
            entries.sort_by_key(fs::DirEntry::file_name);
            for entry in entries {
                let name = entry.file_name();
                if skip.iter().all(|skipped| *skipped != name) {
                    name.hash(&mut self.0);
                    self.path(&entry.path(), skip)?;
                }
            }
        } else {
            fs::read(path).with_context(|| format!("cannot read {}", path.display()))?.hash(&mut self.0);
        }
        Ok(self)
    }

    fn finish(&self) -> String {
        format!("{:016x}", self.0.finish())
    }
}

/// The record that a step was done for certain inputs.
pub struct Stamp {
    file: PathBuf,
    hash: String,
}

impl Stamp {
    /// The stamp of the step `name`. The stamp is stored in `node_modules`, next to the files that it
    /// describes. So a fresh checkout or install has no stamp, and two target folders of one checkout share
    /// it.
    pub fn new(project: &Project, name: &str, inputs: &Inputs) -> Self {
        let folder = project.www().join("node_modules/.cache/inkpanel");
        Self { file: folder.join(name), hash: inputs.finish() }
    }

    /// Whether the step was done for the same inputs and its output is still there.
    pub fn is_current(&self, output: &Path) -> bool {
        output.exists() && fs::read_to_string(&self.file).is_ok_and(|kept| kept == self.hash)
    }

    /// Records that the step is done.
    pub fn keep(&self) -> Result<()> {
        if let Some(folder) = self.file.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&self.file, &self.hash).with_context(|| format!("cannot write {}", self.file.display()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_renamed_or_changed_file_changes_the_hash_and_a_skipped_one_does_not() {
        let folder = std::env::temp_dir().join(format!("inkpanel-stamp-{}", std::process::id()));
        fs::create_dir_all(folder.join("skipped")).unwrap();
        let hash = || {
            let mut inputs = Inputs::default();
            inputs.path(&folder, &["skipped"]).unwrap();
            inputs.finish()
        };
        fs::write(folder.join("a"), "1").unwrap();
        let first = hash();
        fs::write(folder.join("skipped/b"), "2").unwrap();
        assert_eq!(hash(), first);
        fs::write(folder.join("a"), "2").unwrap();
        let second = hash();
        assert_ne!(second, first);
        fs::rename(folder.join("a"), folder.join("c")).unwrap();
        assert_ne!(hash(), second);
        fs::remove_dir_all(folder).unwrap();
    }
}
