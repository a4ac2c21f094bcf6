//! State of one run of the command line. `main` makes it, and passes it to all functions that report progress or read
//! files.

use crate::CliError;
use crate::report::Report;
use inkpanel_engine::texts;
use std::io::Read;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// Name of standard input and standard output.
pub(crate) const STANDARD: &str = "-";
/// Bytes that are taken from standard input.
const MOST_INPUT: u64 = 1 << 30;

/// Whether a path is standard input or output.
pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == STANDARD
}

/// A run of the command line.
pub(crate) struct Run {
    /// Shared with the function that reads the model of the block Painter.
    pub(crate) report: Arc<Report>,
    /// Id of the model of `--painters`, as references in styles have it.
    pub(crate) painters: Option<String>,
    /// Standard input, after it was read.
    input: OnceLock<Result<Vec<u8>, CliError>>,
}

impl Run {
    pub(crate) fn new(report: Report) -> Self {
        Self { report: Arc::new(report), painters: None, input: OnceLock::new() }
    }

    /// Reads a file, or standard input, which is read once and kept.
    pub(crate) fn read(&self, path: &Path) -> Result<Vec<u8>, CliError> {
        if !is_standard(path) {
            return std::fs::read(path).map_err(|error| CliError::reading(&error));
        }
        let input = || {
            let mut bytes = Vec::new();
            let mut input = std::io::stdin().lock().take(MOST_INPUT + 1);
            input.read_to_end(&mut bytes).map_err(|error| CliError::reading(&error))?;
            if bytes.len() as u64 > MOST_INPUT {
                return Err(CliError::new("too-large", format!("is larger than {} MB", MOST_INPUT >> 20)));
            }
            Ok(bytes)
        };
        self.input.get_or_init(input).clone()
    }

    /// Reads a file of JSON, or standard input.
    pub(crate) fn text(&self, path: &Path) -> Result<String, CliError> {
        unicode(&self.read(path)?)
    }
}

/// Returns the text of a JSON or TOML file: UTF-8 or UTF-16, with or without the byte order mark that editors on Windows
/// write.
pub(crate) fn unicode(file: &[u8]) -> Result<String, CliError> {
    let text = texts::unicode(file).map_err(|reason| format!("is not JSON or TOML: {reason}"))?;
    Ok(text.into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_engine::raster::decode::Damage;

    #[test]
    fn warnings_of_one_run_do_not_count_in_the_next() {
        let runs = [(); 2].map(|()| Run::new(Report::new(false)));
        let damage = Some(Damage { missing: 0.1, coarse: 0.0 });
        runs[0].report.note(None, "a warning");
        runs[0].report.damage("photo.jpg", damage);
        runs[0].report.damage("photo.jpg", damage);
        let error = runs[0].report.check_strict(true).unwrap_err();
        assert_eq!(error.to_string(), "--strict: 2 warnings, so nothing is written");
        assert_eq!(runs[1].report.check_strict(true), Ok(()));
        // The other run reports the damage of the photo again.
        runs[1].report.damage("photo.jpg", damage);
        let error = runs[1].report.check_strict(true).unwrap_err();
        assert_eq!(error.to_string(), "--strict: 1 warning, so nothing is written");
    }
}
