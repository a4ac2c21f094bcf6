//! Photo sources of the command line: files, folders as albums, and standard input.

use crate::report::Report;
use crate::run::{Run, is_standard};
use crate::{CliError, own_pages};
use inkpanel::survived;
use inkpanel_engine::kinds::clearer;
use inkpanel_engine::kinds::{self, Role};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use serde_json::json;
use std::cmp::Ordering;
use std::collections::HashSet;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// Folders in folders that are looked into.
const DEEPEST: usize = 8;
/// Files that one run takes, more than an album has: a folder may be a whole disk.
const MOST_FILES: usize = 100_000;

/// Display name of a file.
pub(crate) fn told(path: &Path) -> String {
    if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// Lists the files: for a folder, its photos and the photos in its subfolders, in natural order. Other files of a folder are
/// counted; videos and kinds that cannot be read are named.
pub(crate) fn files(run: &Run, given: &[PathBuf]) -> Result<Vec<PathBuf>, CliError> {
    if given.iter().filter(|path| is_standard(path)).count() > 1 {
        return Err("standard input (-) can be read only once".into());
    }
    let mut files = Vec::new();
    for path in given {
        if is_standard(path) || !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let mut found = Found::default();
        walk(path, 0, &mut found).map_err(|error| error.at(path.display()))?;
        found.tell(path, &run.report);
        leave_own_pages(&mut found.photos, &run.report);
        if found.photos.is_empty() {
            return Err(CliError::new("no-photos", "the folder contains no pictures").at(path.display()));
        }
        files.append(&mut found.photos);
    }
    if files.len() > MOST_FILES {
        return Err(CliError::new("too-large", format!("more than {MOST_FILES} files")));
    }
    Ok(files)
}

/// Leaves out the pages that an earlier run wrote into a folder, unless the folder has nothing else.
fn leave_own_pages(files: &mut Vec<PathBuf>, report: &Report) {
    let (pages, photos): (Vec<PathBuf>, Vec<PathBuf>) =
        files.drain(..).partition(|path| own_pages::is_page(path));
    if photos.is_empty() {
        files.extend(pages);
        return;
    }
    files.extend(photos);
    for page in pages {
        let why = "left out: a page that Inkpanel wrote";
        let event = json!({ "event": "left-out", "file": page.display().to_string(), "message": why });
        report.step(&event, Some(format!("{}: {why}", page.display())));
    }
}

/// The files of a folder.
#[derive(Default)]
struct Found {
    photos: Vec<PathBuf>,
    /// Files of systems and programs.
    sidecars: usize,
    /// Videos of Live Photos: the photo of the same name is taken.
    live: usize,
    /// Files of other kinds.
    others: usize,
    /// Unreadable entries, and files that users may mistake for photos, each with the reason.
    named: Vec<(PathBuf, String)>,
}

impl Found {
    fn tell(&self, folder: &Path, report: &Report) {
        for (path, why) in &self.named {
            report.note(Some(&path.display().to_string()), &format!("{why}; left out"));
        }
        if self.sidecars + self.live + self.others == 0 {
            return;
        }
        let folder = folder.display().to_string();
        let event = json!({ "event": "skipped", "folder": folder, "sidecars": self.sidecars, "live": self.live, "others": self.others });
        let videos = |count: usize| format!("{count} {}", if count == 1 { "video" } else { "videos" });
        let counted = |count: usize| format!("{count} {}", if count == 1 { "file" } else { "files" });
        let of_systems = (self.sidecars > 0)
            .then(|| format!("{} that systems and programs store next to photos", counted(self.sidecars)));
        let others = (self.others > 0).then(|| format!("{} of other kinds", counted(self.others)));
        let live =
            (self.live > 0).then(|| format!("{} of Live Photos with the name of a photo", videos(self.live)));
        let skipped: Vec<_> = of_systems.into_iter().chain(live).chain(others).collect();
        report.step(&event, Some(format!("{folder}: skipped {}", skipped.join(", "))));
    }
}

fn walk(folder: &Path, depth: usize, found: &mut Found) -> Result<(), CliError> {
    let complain = |error| CliError::reading(&error);
    let mut paths: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(complain)? {
        paths.push(entry.map_err(complain)?.path());
    }
    paths.sort_by(|a, b| by_name(name(a), name(b)).then_with(|| a.cmp(b)));
    let photos: HashSet<OsString> =
        paths.iter().filter(|path| role(path) == Some(Role::Photo)).filter_map(|path| stem(path)).collect();
    for path in paths {
        // Links could form a cycle.
        if path.is_dir() && (path.is_symlink() || depth >= DEEPEST) {
            let why = if depth >= DEEPEST { "the folder is too deep" } else { "the folder is a link" };
            found.named.push((path, why.to_owned()));
        } else if path.is_dir() {
            if kinds::is_system(name(&path)) {
                continue;
            }
            if let Err(why) = walk(&path, depth + 1, found) {
                found.named.push((path, why.to_string()));
            }
        } else if found.photos.len() <= MOST_FILES {
            let is_live =
                role(&path) == Some(Role::Video) && stem(&path).is_some_and(|stem| photos.contains(&stem));
            if is_live && path.is_file() { found.live += 1 } else { sort_in(path, found) }
        }
    }
    Ok(())
}

fn role(path: &Path) -> Option<Role> {
    kinds::by_name(&path.file_name()?.to_string_lossy()).map(|kind| kind.role)
}

/// The name of a file without its ending, in lower case: the video of a Live Photo has the name of the photo.
fn stem(path: &Path) -> Option<OsString> {
    path.file_stem().map(OsStr::to_ascii_lowercase)
}

fn sort_in(path: PathBuf, found: &mut Found) {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let kind = kinds::by_name(&name);
    if kinds::is_sidecar(&name) {
        found.sidecars += 1;
    } else if !path.is_file() {
        found.named.push((path, "it cannot be read; it may be a broken link".to_owned()));
    } else if kind.is_some_and(|kind| kind.role == Role::Photo) {
        found.photos.push(path);
    } else if let Some(explained) = kinds::explained(&name, &[])
        && matches!(explained.kind().role, Role::Video | Role::Archive | Role::Unsupported(_))
    {
        found.named.push((path, explained.to_string()));
    } else {
        found.others += 1;
    }
}

/// Natural order of file names: `photo2` before `photo10`, ignoring case.
fn by_name(a: &str, b: &str) -> Ordering {
    let (mut a, mut b) = (a.chars().peekable(), b.chars().peekable());
    loop {
        let (Some(&x), Some(&y)) = (a.peek(), b.peek()) else {
            return a.peek().is_some().cmp(&b.peek().is_some());
        };
        let order = if x.is_ascii_digit() && y.is_ascii_digit() {
            let (x, y) = (number(&mut a), number(&mut b));
            x.len().cmp(&y.len()).then_with(|| x.cmp(&y))
        } else {
            a.next();
            b.next();
            x.to_lowercase().cmp(y.to_lowercase())
        };
        if order != Ordering::Equal {
            return order;
        }
    }
}

/// The digits that come next, without zeros before them.
fn number(text: &mut std::iter::Peekable<std::str::Chars<'_>>) -> String {
    let mut digits = String::new();
    while let Some(digit) = text.next_if(char::is_ascii_digit) {
        if !(digits.is_empty() && digit == '0') {
            digits.push(digit);
        }
    }
    digits
}

pub(crate) fn decode_file(run: &Run, path: &Path) -> Result<Image, CliError> {
    decode_file_fit(run, path, usize::MAX)
}

pub(crate) fn decode_file_fit(run: &Run, path: &Path, longest: usize) -> Result<Image, CliError> {
    let complain = |error: CliError| error.at(told(path));
    let bytes = run.read(path).map_err(complain)?;
    let decode = || {
        let decoded = decode_fit(&bytes, &Limits::default(), longest);
        Ok(decoded.map_err(|error| clearer(error, name(path), &bytes))?)
    };
    let decoded = survived(decode).map_err(complain)?;
    run.report.damage(&told(path), decoded.damage);
    Ok(decoded.image)
}

pub(crate) fn name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).unwrap_or("?")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_in_the_order_in_which_people_count() {
        let mut names = ["photo10.jpg", "Photo2.jpg", "photo1.jpg", "a.jpg", "photo02b.jpg", "photo"];
        names.sort_by(|a, b| by_name(a, b));
        assert_eq!(names, ["a.jpg", "photo", "photo1.jpg", "Photo2.jpg", "photo02b.jpg", "photo10.jpg"]);
    }

    #[test]
    fn a_folder_is_its_pictures_and_those_of_its_folders() {
        let run = Run::new(Report::new(false));
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir_all(at("b/c")).unwrap();
        for file in ["2.jpg", "10.PNG", "b/c/x.webp", "b/notes.txt", ".hidden.jpg"] {
            std::fs::write(at(file), "").unwrap();
        }
        let found = files(&run, &[folder.path().to_owned()]).unwrap();
        assert_eq!(found, ["2.jpg", "10.PNG", "b/c/x.webp"].map(at));
        // A name that is not UTF-8 keeps its extension.
        #[cfg(unix)]
        {
            use std::os::unix::ffi::OsStrExt;
            let odd = at("odd");
            std::fs::create_dir(&odd).unwrap();
            let file = odd.join(std::ffi::OsStr::from_bytes(b"\x82\xa0.JFIF"));
            std::fs::write(&file, "").unwrap();
            assert_eq!(files(&run, &[odd]).unwrap(), [file]);
        }
        std::fs::create_dir(at("empty")).unwrap();
        assert!(
            files(&run, &[at("empty")]).unwrap_err().to_string().contains("the folder contains no pictures")
        );
        assert!(files(&run, &["-".into(), "-".into()]).unwrap_err().to_string().contains("only once"));
    }
}
