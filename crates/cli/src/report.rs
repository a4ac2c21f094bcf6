//! Progress and warnings on standard error: sentences, or one line of JSON per step.

use crate::CliError;
use inkpanel_engine::raster::decode::Damage;
use serde_json::{Value, json};
use std::collections::HashSet;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{LazyLock, Mutex, PoisonError};

static AS_JSON: AtomicBool = AtomicBool::new(false);
/// Number of warnings.
static NOTES: AtomicUsize = AtomicUsize::new(0);
/// Names of the files whose damage was reported.
static DAMAGED: LazyLock<Mutex<HashSet<String>>> = LazyLock::new(Mutex::default);

/// From now on each line is JSON.
pub(crate) fn as_json() {
    AS_JSON.store(true, Ordering::Relaxed);
}

/// Whether each line is JSON.
pub(crate) fn is_json() -> bool {
    AS_JSON.load(Ordering::Relaxed)
}

/// Prints a warning, such as a skipped file or a photo without a panel. The run continues, unless `--strict`
/// is set. `file`: the affected file, if any.
pub(crate) fn note(file: Option<&str>, why: &str) {
    NOTES.fetch_add(1, Ordering::Relaxed);
    say(&json!({ "event": "note", "file": file, "message": why }), || match file {
        Some(file) => format!("{file}: {why}"),
        None => why.to_owned(),
    });
}

/// Reports the damage of a photo that is read nevertheless: once, however often it is decoded.
pub(crate) fn damage(file: &str, damage: Option<Damage>) {
    if let Some(damage) = damage
        && DAMAGED.lock().unwrap_or_else(PoisonError::into_inner).insert(file.to_owned())
    {
        note(Some(file), &damage.to_string());
    }
}

/// The damage of this file was reported.
pub(crate) fn damage_is_known(file: &str) {
    DAMAGED.lock().unwrap_or_else(PoisonError::into_inner).insert(file.to_owned());
}

/// How many notes there were.
pub(crate) fn notes() -> usize {
    NOTES.load(Ordering::Relaxed)
}

/// Reports a step of long work. The sentence, if any, is for people.
pub(crate) fn step(event: &Value, sentence: Option<String>) {
    if is_json() {
        print(&format!("{event}\n"));
    } else if let Some(sentence) = sentence {
        print(&format!("inkpanel: {sentence}\n"));
    }
}

/// Prints text to standard error. The run continues if standard error is closed.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stderr().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// Reports the error that ends the run.
pub(crate) fn failure(error: &CliError) {
    let message = error.to_string();
    say(&json!({ "event": "error", "code": error.code(), "message": message }), || message.clone());
}

fn say(event: &Value, sentence: impl FnOnce() -> String) {
    step(event, Some(sentence()));
}

/// Reports the end of the run.
#[allow(clippy::unnecessary_wraps, reason = "callers return it as their result")]
pub(crate) fn done(files: &[PathBuf]) -> Result<(), CliError> {
    let files: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    step(&json!({ "event": "done", "files": files }), None);
    Ok(())
}

/// With `--strict`, a warning is an error.
pub(crate) fn check_strict(strict: bool) -> Result<(), CliError> {
    let notes = notes();
    if !strict || notes == 0 {
        return Ok(());
    }
    let warnings = if notes == 1 { "1 warning".to_owned() } else { format!("{notes} warnings") };
    Err(CliError::new("warnings", format!("--strict: {warnings}, so nothing is written")))
}

/// Returns the first names of a list, and the number of the others.
pub(crate) fn some(names: &[&str]) -> String {
    match names.len() {
        0..=4 => names.join(", "),
        many => format!("{} and {} more", names[..3].join(", "), many - 3),
    }
}
