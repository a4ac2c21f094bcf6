//! Files of a release: archives and checksums. The bytes of an archive depend only on its content and on the
//! day of the release.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use flate2::{Compression, GzBuilder};

use inkpanel_models::digest;

use crate::compare;

/// Type of a file in an archive.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Plain,
    Program,
}

/// A gzipped tar archive under construction. Everything is in one folder, with one time and one owner.
pub(crate) struct Archive {
    folder: String,
    /// In seconds since 1970.
    time: u64,
    /// By path, so that they are written in order.
    files: std::collections::BTreeMap<String, (Kind, Vec<u8>)>,
}

impl Archive {
    pub(crate) fn new(folder: &str, time: u64) -> Self {
        Self { folder: folder.to_owned(), time, files: std::collections::BTreeMap::new() }
    }

    /// Adds a file under its path in the archive's folder.
    pub(crate) fn bytes(&mut self, path: &str, kind: Kind, bytes: Vec<u8>) -> &mut Self {
        self.files.insert(path.to_owned(), (kind, bytes));
        self
    }

    /// Adds a file of the disk.
    ///
    /// # Errors
    /// When it cannot be read.
    pub(crate) fn file(&mut self, path: &str, kind: Kind, from: &Path) -> Result<&mut Self> {
        let bytes = fs::read(from).with_context(|| format!("cannot read {}", from.display()))?;
        Ok(self.bytes(path, kind, bytes))
    }

    /// Adds all files below a folder of the disk.
    ///
    /// # Errors
    /// When one cannot be read.
    pub(crate) fn all(&mut self, from: &Path) -> Result<&mut Self> {
        for path in compare::files(from)? {
            self.file(&path, Kind::Plain, &from.join(&path))?;
        }
        Ok(self)
    }

    /// The archive's bytes.
    ///
    /// # Errors
    /// When a path cannot be written in an archive.
    pub(crate) fn packed(&self) -> Result<Vec<u8>> {
        // Without a name, a time or a system in its header.
        let gzip = GzBuilder::new().write(Vec::new(), Compression::best());
        let mut tar = tar::Builder::new(gzip);
        for (path, (kind, bytes)) in &self.files {
            let mut header = tar::Header::new_gnu();
            header.set_size(bytes.len() as u64);
            header.set_mode(if *kind == Kind::Program { 0o755 } else { 0o644 });
            header.set_mtime(self.time);
            header.set_uid(0);
            header.set_gid(0);
            tar.append_data(&mut header, format!("{}/{path}", self.folder), bytes.as_slice())
                .with_context(|| format!("cannot pack {path}"))?;
        }
        Ok(tar.into_inner()?.finish()?)
    }
}

/// Returns the checksums of all files of a folder, in the format of `sha256sum --check`.
///
/// # Errors
/// When a file cannot be read.
pub(crate) fn sums(folder: &Path) -> Result<String> {
    let line = |file: String| -> Result<String> {
        Ok(format!(
            "{}  {file}
",
            digest(&fs::read(folder.join(&file))?)
        ))
    };
    compare::files(folder)?.into_iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;

    const TIME: u64 = 1_795_478_400;

    #[test]
    fn an_archive_has_its_files_in_order_with_one_time_and_owner() {
        let long = format!("assets/{}.js", "x".repeat(150));
        let mut archive = Archive::new("thing-1.0.0", TIME);
        archive.bytes("z", Kind::Plain, b"last".to_vec()).bytes("bin", Kind::Program, b"run".to_vec());
        archive.bytes(&long, Kind::Plain, b"long".to_vec());
        let packed = archive.packed().unwrap();
        let mut read = tar::Archive::new(flate2::read::GzDecoder::new(packed.as_slice()));
        let mut seen = Vec::new();
        for entry in read.entries().unwrap() {
            let mut entry = entry.unwrap();
            let mut text = String::new();
            entry.read_to_string(&mut text).unwrap();
            let header = entry.header();
            assert_eq!((header.mtime().unwrap(), header.uid().unwrap(), header.gid().unwrap()), (TIME, 0, 0));
            let mode = header.mode().unwrap();
            seen.push((entry.path().unwrap().to_str().unwrap().to_owned(), mode, text));
        }
        let row = |path: &str, mode, text: &str| (format!("thing-1.0.0/{path}"), mode, text.to_owned());
        assert_eq!(seen, [row(&long, 0o644, "long"), row("bin", 0o755, "run"), row("z", 0o644, "last")]);
    }

    #[test]
    fn files_of_any_age_and_order_give_the_same_archive() {
        let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
        for (folder, names) in folders.iter().zip([["a", "b"], ["b", "a"]]) {
            for name in names {
                fs::write(folder.path().join(name), name).unwrap();
            }
        }
        let old = fs::File::options().write(true).open(folders[0].path().join("a")).unwrap();
        old.set_modified(std::time::UNIX_EPOCH).unwrap();
        let packed = |at: usize| Archive::new("x", TIME).all(folders[at].path()).unwrap().packed().unwrap();
        assert_eq!(packed(0), packed(1));
        assert_ne!(Archive::new("x", 1).all(folders[0].path()).unwrap().packed().unwrap(), packed(0));
    }

    #[test]
    fn sums_are_those_of_other_programs() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("b"), "abc").unwrap();
        fs::write(folder.path().join("a"), "").unwrap();
        assert_eq!(
            sums(folder.path()).unwrap(),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  a\n\
             ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  b\n"
        );
    }
}
