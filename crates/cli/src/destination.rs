//! Output of the command line: files, which are written atomically, and standard output. Printing macros
//! panic when their pipe is closed, so the command line prints by the functions here and in `report`.

use crate::CliError;
use crate::format::Format;
use crate::run::is_standard;
use serde_json::Value;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A place for a result.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Output {
    /// Path; `-` is standard output.
    pub(crate) path: PathBuf,
    /// Name that determines the file type: the file name, or a default for standard output.
    pub(crate) named: PathBuf,
}

impl Output {
    /// A place of that name. `format` overrides the extension. The default of standard output is PNG.
    ///
    /// # Errors
    /// A sentence if the format is unknown.
    pub(crate) fn new(path: &Path, format: Option<&str>) -> Result<Self, CliError> {
        let named = match format {
            Some(format) => Path::new("page").with_extension(format),
            None if is_standard(path) => PathBuf::from("page.png"),
            None => path.to_owned(),
        };
        Format::of(&named)?;
        // The title of a PDF file is its name.
        let named = match format {
            Some(format) if !is_standard(path) => path.with_extension(format),
            _ => named,
        };
        Ok(Self { path: path.to_owned(), named })
    }

    /// Whether it already exists. Files are written atomically, so an existing file is complete.
    pub(crate) fn exists(&self) -> bool {
        !is_standard(&self.path)
            && fs::metadata(&self.path).is_ok_and(|file| file.is_file() && file.len() > 0)
    }

    pub(crate) fn write(&self, bytes: &[u8]) -> Result<(), CliError> {
        write(&self.path, bytes)
    }
}

/// Writes a temporary file in the same folder and renames it, so that the file is never incomplete. Can also
/// write to standard output.
///
/// # Errors
/// A sentence with the name. A failed write changes nothing.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    if is_standard(path) {
        return print(bytes);
    }
    let complain = |error| CliError::writing(path, &error);
    // Links stay links. Pipes and other special files cannot be replaced.
    let place = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&place).is_ok_and(|there| !there.is_file()) {
        return fs::write(&place, bytes).map_err(complain);
    }
    let fresh = fresh_beside(&place);
    let written =
        File::create(&fresh).and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()));
    let placed = written.and_then(|()| fs::rename(&fresh, &place));
    if placed.is_err() {
        let _ = fs::remove_file(&fresh);
    }
    placed.map_err(complain)
}

/// Writes to standard output. A closed pipe is not an error: the reader stopped on purpose.
///
/// # Errors
/// A sentence for any other failure.
pub(crate) fn print(bytes: &[u8]) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(CliError::writing(Path::new("standard output"), &error))
        }
        _ => Ok(()),
    }
}

/// Prints lines to standard output, as `print` does.
///
/// # Errors
/// The errors of `print`.
pub(crate) fn print_lines(lines: impl IntoIterator<Item = String>) -> Result<(), CliError> {
    let text: String = lines.into_iter().map(|line| line + "\n").collect();
    print(text.as_bytes())
}

/// A name in the same folder that no other run has.
fn fresh_beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let short: String = name.chars().take(40).collect();
    path.with_file_name(format!(".{short}.{}.part", std::process::id()))
}

/// Prints JSON.
pub(crate) fn print_json(value: &Value) -> Result<(), CliError> {
    list(value, true)
}

/// Prints a catalogue.
pub(crate) fn list(catalogue: &impl serde::Serialize, as_json: bool) -> Result<(), CliError> {
    // Converted to text first: a JSON value stores the numbers of layouts as f64, which prints other digits
    // than the app uses.
    let text = serde_json::to_string(catalogue).map_err(CliError::fault)?;
    if as_json {
        return print_lines([text]);
    }
    let catalogue: Value = serde_json::from_str(&text).map_err(CliError::fault)?;
    print_lines(catalogue.as_array().into_iter().flatten().map(|item| {
        let field = |key: &str| item[key].as_str().unwrap_or_default();
        let label = if field("name").is_empty() { field("label") } else { field("name") };
        format!("{:<24}{label}", field("id"))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_there_whole_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("page.png");
        for bytes in [&b"one"[..], b"another"] {
            write(&file, bytes).unwrap();
            assert_eq!(fs::read(&file).unwrap(), bytes);
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        let nowhere = folder.path().join("missing/page.png");
        assert!(write(&nowhere, b"x").unwrap_err().to_string().contains("page.png"));
    }

    #[test]
    fn a_folder_in_its_place_is_a_complaint_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("page.png");
        fs::create_dir(&place).unwrap();
        assert!(write(&place, b"x").is_err());
        assert!(place.is_dir());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn the_kind_is_told_by_the_name_or_by_word() {
        let kind = |path: &str, format: Option<&str>| {
            Output::new(Path::new(path), format).map(|output| Format::of(&output.named).unwrap())
        };
        assert_eq!(kind("a.PNG", None), Ok(Format::Png));
        assert_eq!(kind("-", None), Ok(Format::Png));
        assert_eq!(kind("-", Some("jpg")), Ok(Format::Jpeg));
        assert_eq!(kind("a.out", Some("webp")), Ok(Format::Webp));
        for name in ["a.tiff", "a", "a.svg"] {
            assert!(kind(name, None).unwrap_err().to_string().contains("must end in .png"), "{name}");
        }
    }
}
