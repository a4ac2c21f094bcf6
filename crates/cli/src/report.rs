//! Progress and warnings on standard error: sentences, or one line of JSON per step.

use crate::CliError;
use inkpanel_engine::raster::decode::Damage;
use serde_json::{Value, json};
use std::collections::HashSet;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Reports of one run.
pub(crate) struct Report {
    /// Whether each line is JSON.
    pub(crate) json: bool,
    /// Number of warnings.
    notes: AtomicUsize,
    /// Names of the files whose damage was reported.
    damaged: Mutex<HashSet<String>>,
}

impl Report {
    /// Prints sentences, or JSON.
    pub(crate) fn new(json: bool) -> Self {
        Self { json, notes: AtomicUsize::new(0), damaged: Mutex::default() }
    }

    /// Prints a warning, such as a skipped file or a photo without a panel. The run continues, unless `--strict`
    /// is set. `file`: the affected file, if any.
    pub(crate) fn note(&self, file: Option<&str>, why: &str) {
        self.notes.fetch_add(1, Ordering::Relaxed);
        let sentence = match file {
            Some(file) => format!("{file}: {why}"),
            None => why.to_owned(),
        };
        self.step(&json!({ "event": "note", "file": file, "message": why }), Some(sentence));
    }

    /// Reports the damage of a photo that is read nevertheless: once, however often it is decoded.
    pub(crate) fn damage(&self, file: &str, damage: Option<Damage>) {
        if let Some(damage) = damage
            && self.mark_damage(file)
        {
            self.note(Some(file), &damage.to_string());
        }
    }

    /// Counts the damage of a file as reported. Returns whether it was not reported before.
    pub(crate) fn mark_damage(&self, file: &str) -> bool {
        self.damaged.lock().unwrap_or_else(PoisonError::into_inner).insert(file.to_owned())
    }

    /// Reports a step of long work. The sentence, if any, is for people.
    pub(crate) fn step(&self, event: &Value, sentence: Option<String>) {
        if self.json {
            print(&format!("{event}\n"));
        } else if let Some(sentence) = sentence {
            print(&format!("inkpanel: {sentence}\n"));
        }
    }

    /// Reports the error that ends the run.
    pub(crate) fn failure(&self, error: &CliError) {
        let message = error.to_string();
        let event = json!({ "event": "error", "code": error.code(), "message": message });
        self.step(&event, Some(message));
    }

    /// Reports the end of the run.
    #[allow(clippy::unnecessary_wraps, reason = "callers return it as their result")]
    pub(crate) fn done(&self, files: &[PathBuf]) -> Result<(), CliError> {
        let files: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
        self.step(&json!({ "event": "done", "files": files }), None);
        Ok(())
    }

    /// With `--strict`, a warning is an error.
    pub(crate) fn check_strict(&self, strict: bool) -> Result<(), CliError> {
        let notes = self.notes.load(Ordering::Relaxed);
        if !strict || notes == 0 {
            return Ok(());
        }
        let warnings = if notes == 1 { "1 warning".to_owned() } else { format!("{notes} warnings") };
        Err(CliError::new("warnings", format!("--strict: {warnings}, so nothing is written")))
    }
}

/// Prints text to standard error. The run continues if standard error is closed.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stderr().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// Returns the first names of a list, and the number of the others.
pub(crate) fn some(names: &[&str]) -> String {
    match names.len() {
        0..=4 => names.join(", "),
        many => format!("{} and {} more", names[..3].join(", "), many - 3),
    }
}
