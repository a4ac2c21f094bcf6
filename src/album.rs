//! Photo sources of the command line: files, folders as albums, and standard input.

use crate::{Complaint, name, own_pages, telling};
use inkpanel::texts;
use serde_json::json;
use std::cmp::Ordering;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Name of standard input and standard output.
pub(crate) const STANDARD: &str = "-";
/// Endings of the pictures that a folder is searched for.
const PICTURES: [&str; 9] = ["jpg", "jpeg", "png", "webp", "gif", "bmp", "tif", "tiff", "jpe"];
/// Folders in folders that are looked into.
const DEEPEST: usize = 8;
/// Files that one run takes, more than an album has: a folder may be a whole disk.
const MOST_FILES: usize = 100_000;
/// Bytes that are taken from standard input.
const MOST_INPUT: u64 = 1 << 30;

/// Whether a path is standard input or output.
pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == STANDARD
}

/// Display name of a file.
pub(crate) fn told(path: &Path) -> String {
    if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// Reads a file, or standard input, which is read once and kept.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Complaint> {
    static INPUT: OnceLock<Result<Vec<u8>, Complaint>> = OnceLock::new();
    if !is_standard(path) {
        return std::fs::read(path).map_err(|error| error.to_string());
    }
    let input = || {
        let mut bytes = Vec::new();
        let mut input = std::io::stdin().lock().take(MOST_INPUT + 1);
        input.read_to_end(&mut bytes).map_err(|error| error.to_string())?;
        if bytes.len() as u64 > MOST_INPUT {
            return Err(format!("is larger than {} MB", MOST_INPUT >> 20));
        }
        Ok(bytes)
    };
    INPUT.get_or_init(input).clone()
}

/// Reads a file of JSON or TOML, or standard input: UTF-8 or UTF-16, with or without the byte order mark that editors on
/// Windows write.
pub(crate) fn text(path: &Path) -> Result<String, Complaint> {
    let bytes = read(path)?;
    let text = texts::unicode(&bytes).map_err(|reason| format!("is not JSON or TOML: {reason}"))?;
    Ok(text.into_owned())
}

/// Lists the files: for a folder, its images and the images in its subfolders, in natural order.
pub(crate) fn files(given: &[PathBuf]) -> Result<Vec<PathBuf>, Complaint> {
    if given.iter().filter(|path| is_standard(path)).count() > 1 {
        return Err("standard input (-) can be read only once".into());
    }
    let mut files = Vec::new();
    for path in given {
        if is_standard(path) || !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let before = files.len();
        walk(path, 0, &mut files)?;
        leave_own_pages(&mut files, before);
        if files.len() == before {
            return Err(format!("{}: the folder contains no pictures", path.display()));
        }
    }
    if files.len() > MOST_FILES {
        return Err(format!("there are more than {MOST_FILES} files"));
    }
    Ok(files)
}

/// Leaves out the pages that an earlier run wrote into a folder, unless the folder has nothing else. Files before `from`
/// are not of the folder.
fn leave_own_pages(files: &mut Vec<PathBuf>, from: usize) {
    let (pages, photos): (Vec<PathBuf>, Vec<PathBuf>) =
        files.drain(from..).partition(|path| own_pages::is_page(path));
    if photos.is_empty() {
        files.extend(pages);
        return;
    }
    files.extend(photos);
    for page in pages {
        let why = "left out: a page that Inkpanel wrote";
        let event = json!({ "event": "left-out", "file": page.display().to_string(), "message": why });
        telling::step(&event, Some(format!("{}: {why}", page.display())));
    }
}

fn walk(folder: &Path, depth: usize, files: &mut Vec<PathBuf>) -> Result<(), Complaint> {
    let complain = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut found: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(complain)? {
        found.push(entry.map_err(complain)?.path());
    }
    found.sort_by(|a, b| by_name(name(a), name(b)).then_with(|| a.cmp(b)));
    for path in found.into_iter().filter(|path| !name(path).starts_with('.')) {
        // Links could form a cycle.
        if path.is_dir() && !path.is_symlink() && depth < DEEPEST {
            walk(&path, depth + 1, files)?;
        } else if path.is_file() && is_picture(&path) && files.len() <= MOST_FILES {
            files.push(path);
        }
    }
    Ok(())
}

fn is_picture(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    ending.is_some_and(|ending| PICTURES.contains(&ending.as_str()))
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
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir_all(at("b/c")).unwrap();
        for file in ["2.jpg", "10.PNG", "b/c/x.webp", "b/notes.txt", ".hidden.jpg"] {
            std::fs::write(at(file), "").unwrap();
        }
        let found = files(&[folder.path().to_owned()]).unwrap();
        assert_eq!(found, ["2.jpg", "10.PNG", "b/c/x.webp"].map(at));
        std::fs::create_dir(at("empty")).unwrap();
        assert!(files(&[at("empty")]).unwrap_err().contains("the folder contains no pictures"));
        assert!(files(&["-".into(), "-".into()]).unwrap_err().contains("only once"));
    }
}
