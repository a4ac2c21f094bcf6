//! Labels of output lines for parallel work: each line begins with the name of its lane.

use std::cell::Cell;
use std::io::{BufRead, BufReader, PipeReader, pipe};
use std::process::{Child, Command};

use anyhow::Result;

use crate::tools;

thread_local! {
    static NAME: Cell<Option<&'static str>> = const { Cell::new(None) };
}

/// Runs `run` with a lane name, which precedes each printed line.
pub fn named<T>(name: &'static str, run: impl FnOnce() -> T) -> T {
    NAME.set(Some(name));
    let result = run();
    NAME.set(None);
    result
}

/// The name that this thread runs under.
pub fn name() -> Option<&'static str> {
    NAME.get()
}

/// Prints a line under the name that this thread runs under.
pub fn say(line: &str) {
    match name() {
        Some(name) => println!("{name:<9}| {line}"),
        None => println!("{line}"),
    }
}

/// Starts a program whose two outputs are one.
///
/// # Errors
/// When it cannot be started.
pub fn start(command: &mut Command) -> Result<(Child, BufReader<PipeReader>)> {
    let (reader, writer) = pipe()?;
    command.stdout(writer.try_clone()?).stderr(writer);
    let child = command.spawn().map_err(|error| tools::cannot_start(command, &error))?;
    // The command has the writing end of the pipe, so reading would not end before the command is dropped.
    command.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null());
    Ok((child, BufReader::new(reader)))
}

/// Passes each line to `take` until the input ends.
///
/// # Errors
/// When the pipe breaks.
pub fn lines(from: BufReader<PipeReader>, mut take: impl FnMut(&str)) -> Result<()> {
    for line in from.split(b'\n') {
        take(&String::from_utf8_lossy(&line?));
    }
    Ok(())
}
