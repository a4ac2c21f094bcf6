//! Reads every file of some folders and reports the results. `cargo xtask corpora` runs it.
//!
//!     cargo run --example hostile -- TABLE.md|- [NAME=FOLDER...]
//!
//! So does it with the files of `made.rs`. Each file either decodes or gives an error with a code. Exit code
//! 1 if a file makes the program panic, takes longer than five seconds, or needs more memory than the limit
//! of the app.

mod made;
mod memory;
mod table;

use std::fs;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use inkpanel_engine::page::import::import;
use inkpanel_engine::raster::decode::Limits;

/// Maximum time for a file.
const PATIENCE: Duration = Duration::from_secs(5);

/// Result of reading a file.
pub(crate) struct Outcome {
    /// `decoded`, an error's code, or a fault in capitals.
    pub(crate) word: String,
    pub(crate) time: Duration,
    /// Additional bytes of memory; `None` if the system does not report them.
    pub(crate) memory: Option<u64>,
    pub(crate) is_fault: bool,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((target, folders)) = arguments.split_first() else {
        eprintln!("usage: hostile TABLE.md|- [NAME=FOLDER...]");
        return ExitCode::FAILURE;
    };
    // The table reports panics, so their backtraces are not printed.
    panic::set_hook(Box::new(|_| {}));
    let (mut rows, mut faults) = (Vec::new(), 0);
    for folder in folders {
        let (name, folder) = folder.split_once('=').unwrap_or((folder, folder));
        let mut files = Vec::new();
        collect(Path::new(folder), &mut files);
        files.sort();
        let read = files.iter().map(|file| (file.display().to_string(), fs::read(file).unwrap_or_default()));
        rows.push((name.to_owned(), outcomes(read, &mut faults)));
    }
    let photo = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/data/files/jpeg-420.jpg");
    let made = made::all(&fs::read(photo).unwrap_or_default());
    rows.push(("made here".to_owned(), outcomes(made.into_iter(), &mut faults)));
    let passed = rows.iter().map(|(_, outcomes)| outcomes.len()).sum::<usize>() - faults;
    let text = table::written(&rows);
    println!("{text}\ntest result: {passed} passed; {faults} failed;");
    let kept = target == "-" || fs::write(target, format!("{}\n{text}", table::ABOUT)).is_ok();
    if kept && faults == 0 && passed > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Returns the result of each file. Failures of the program are printed and counted.
fn outcomes(files: impl Iterator<Item = (String, Vec<u8>)>, faults: &mut usize) -> Vec<Outcome> {
    let outcome = |(name, bytes)| {
        let outcome = examined(bytes);
        if outcome.is_fault {
            *faults += 1;
            println!("{name}: {}", outcome.word);
        }
        outcome
    };
    files.map(outcome).collect()
}

/// All files below a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() { collect(&path, files) } else { files.push(path) }
    }
}

/// Reads a file in a separate thread, which is abandoned if it does not end.
fn examined(bytes: Vec<u8>) -> Outcome {
    let before = memory::begin();
    let (send, receive) = mpsc::channel();
    let start = Instant::now();
    thread::spawn(move || {
        let word = panic::catch_unwind(AssertUnwindSafe(|| read(&bytes))).unwrap_or_else(|_| "PANIC".into());
        // After a timeout, the receiver is gone.
        let _ = send.send(word);
    });
    let word = receive.recv_timeout(PATIENCE).unwrap_or_else(|_| "TOO SLOW".into());
    let (time, memory) = (start.elapsed(), before.and_then(memory::most_since));
    let word = match memory {
        Some(bytes) if bytes > Limits::default().max_bytes => "TOO MUCH MEMORY".into(),
        _ => word,
    };
    let is_fault = word.chars().all(|c| c.is_ascii_uppercase() || c == ' ');
    Outcome { word, time, memory, is_fault }
}

/// As the page reads a file.
fn read(bytes: &[u8]) -> String {
    match import("photo", bytes, &Limits::default()) {
        Ok(_) => "decoded".into(),
        Err(error) => error.code().into(),
    }
}
