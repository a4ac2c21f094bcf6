//! What the command line says while it works, on standard error: sentences for people, or a line of JSON for each step.

use serde_json::{Value, json};
use std::io::Write;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

static AS_JSON: AtomicBool = AtomicBool::new(false);
/// How often something was not as it was asked for.
static NOTES: AtomicUsize = AtomicUsize::new(0);

/// From now on each line is JSON.
pub(crate) fn as_json() {
    AS_JSON.store(true, Ordering::Relaxed);
}

/// Something is not as it was asked for: a file is left out, a photo has no panel. The work goes on, unless `--strict` says
/// otherwise. `file` is the one that it is about, if any.
pub(crate) fn note(file: Option<&str>, why: &str) {
    NOTES.fetch_add(1, Ordering::Relaxed);
    say(&json!({ "event": "note", "file": file, "message": why }), || match file {
        Some(file) => format!("{file}: {why}"),
        None => why.to_owned(),
    });
}

/// How many notes there were.
pub(crate) fn notes() -> usize {
    NOTES.load(Ordering::Relaxed)
}

/// A step of long work is done; people are told of it where it has a sentence.
pub(crate) fn step(event: &Value, sentence: Option<String>) {
    if AS_JSON.load(Ordering::Relaxed) {
        print(&format!("{event}\n"));
    } else if let Some(sentence) = sentence {
        print(&format!("inkpanel: {sentence}\n"));
    }
}

/// Prints text to standard error. The work goes on if standard error is closed.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stderr().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// The end of work that failed.
pub(crate) fn failure(complaint: &str) {
    say(&json!({ "event": "error", "message": complaint }), || complaint.to_owned());
}

fn say(event: &Value, sentence: impl FnOnce() -> String) {
    step(event, Some(sentence()));
}
