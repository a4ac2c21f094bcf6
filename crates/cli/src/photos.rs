//! The photos of a command: an album of the public API, and the files of its photos.

use crate::input::{name, told};
use crate::run::{Run, is_standard};
use crate::{CliError, detectors, report};
use inkpanel::{Album, Nets, PageOptions, Photo};
use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::page::import::Imported;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Consequence of missing models for pages.
pub(crate) const BY_CONTRAST: &str = "photos are cropped by contrast";

/// Maximum number of photos without a panel that are reported one by one.
const FEW: usize = 10;

/// Photos that were read.
pub(crate) struct Photos<'r> {
    pub(crate) run: &'r Run,
    files: Vec<PathBuf>,
    pub(crate) album: Album,
}

impl<'r> Photos<'r> {
    /// Reads files in parallel. Files that cannot be read are reported and left out.
    ///
    /// # Errors
    /// If standard input cannot be read.
    pub(crate) fn read(run: &'r Run, files: Vec<PathBuf>) -> Result<Self, CliError> {
        let photo = |path: &PathBuf| {
            if is_standard(path) {
                return Ok(Photo::from_bytes(told(path), run.read(path)?));
            }
            Ok(Photo::open(path))
        };
        let photos = files.iter().map(photo).collect::<Result<Vec<_>, CliError>>()?;
        let count = AtomicUsize::new(0);
        let album = Album::read_reporting(photos, &|photo| {
            let done = count.fetch_add(1, Ordering::Relaxed) + 1;
            let event = json!({ "event": "photo", "file": photo.name(), "done": done, "of": files.len() });
            run.report.step(&event, None);
        });
        for note in album.notes() {
            run.report.note(note.photo(), note.reason());
        }
        let photos = Self { run, files, album };
        for (path, _) in photos.iter().filter(|(_, photo)| photo.damage.is_some()) {
            run.report.mark_damage(&told(path));
        }
        Ok(photos)
    }

    /// Readable photos with their files, in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&Path, &Imported)> {
        self.album.imported().iter().map(|(place, photo)| (self.files[*place].as_path(), photo))
    }

    /// The file of a readable photo by its place in the album.
    pub(crate) fn file(&self, place: usize) -> &Path {
        &self.files[place]
    }

    /// The photo with an id, and its file.
    pub(crate) fn find(&self, id: &str) -> Option<(&Path, &Imported)> {
        self.iter().find(|(_, photo)| photo.meta.id == id)
    }

    /// The measurements of all photos.
    pub(crate) fn metas(&self) -> Vec<PhotoMeta> {
        self.iter().map(|(_, photo)| photo.meta.clone()).collect()
    }

    /// Adds the detected faces and subjects to the photos. Without the models, a warning is printed that ends with
    /// `consequence`.
    ///
    /// Returns whether the models were available.
    pub(crate) fn add_subjects(&mut self, models: Option<&Path>, consequence: &str) -> bool {
        let detectors = match detectors::load(models) {
            Ok(detectors) => detectors,
            Err(error) => {
                self.run.report.note(None, &format!("{error}; {consequence}"));
                return false;
            }
        };
        let known = self.album.notes().len();
        self.album.detect(&Nets::new(detectors));
        for note in &self.album.notes()[known..] {
            self.run.report.note(note.photo(), note.reason());
        }
        true
    }

    /// Marks the starred photos, and warns about names that match no photo.
    pub(crate) fn star(&mut self, names: &[PathBuf]) {
        for star in names {
            let places: Vec<usize> = self.album.imported().iter().map(|(place, _)| *place).collect();
            let starred = places.into_iter().filter(|place| is_named(&self.files[*place], star));
            let found = starred.filter(|place| self.album.star(*place).is_ok()).count();
            if found == 0 {
                self.run.report.note(Some(&star.display().to_string()), "--star: no photo has this name");
            }
        }
    }

    /// Returns the photos for the pages, in order. Similar and blurred photos are reported and left out.
    pub(crate) fn choose(&self, options: &PageOptions) -> Vec<PhotoMeta> {
        let selection = self.album.choose(options);
        let judged = self.iter().zip(&selection.verdicts).filter(|(_, verdict)| !verdict.kept);
        let left: Vec<(&str, String)> =
            judged.map(|((path, _), verdict)| (name(path), verdict.reason.to_string())).collect();
        if left.len() > FEW {
            let names: Vec<&str> = left.iter().map(|(name, _)| *name).collect();
            let (count, some) = (left.len(), report::some(&names));
            self.run.report.note(
                None,
                &format!("{count} photos are left out; `inkpanel select` lists the reasons: {some}"),
            );
        } else {
            for (name, why) in &left {
                self.run.report.note(Some(name), &format!("left out: {why}"));
            }
        }
        selection.used
    }
}

/// Returns whether a path matches a name, completely or by its last parts.
fn is_named(path: &Path, name: &Path) -> bool {
    path.ends_with(name.strip_prefix(".").unwrap_or(name))
}
