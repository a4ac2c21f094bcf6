//! Runs other programs. An error is one sentence with the name of the program and, if it is missing, the
//! package to install.

use std::env;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::{Result, anyhow, bail};
use sha2::{Digest, Sha256};

use crate::lane;

/// The first program of these names in PATH, folder by folder.
pub fn in_path(names: &[&str]) -> Option<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    let suffix = env::consts::EXE_SUFFIX;
    env::split_paths(&path)
        .flat_map(|folder| names.iter().map(move |name| folder.join(format!("{name}{suffix}"))))
        .find(|program| program.is_file())
}

/// Runs a program with its output on this terminal.
///
/// # Errors
/// When it is missing or ends with a failure.
pub fn run(command: &mut Command) -> Result<()> {
    let status = if lane::name().is_some() {
        let (mut child, printed) = lane::start(command)?;
        lane::lines(printed, lane::say)?;
        child.wait()?
    } else {
        command.status().map_err(|error| cannot_start(command, &error))?
    };
    if !status.success() {
        bail!("`{}` failed ({status})", line(command));
    }
    Ok(())
}

/// Runs a program and returns what it printed on standard output; its standard error goes to this terminal.
///
/// # Errors
/// When it is missing, ends with a failure or prints no UTF-8.
pub fn output(command: &mut Command) -> Result<String> {
    let output = command.stderr(Stdio::inherit()).output().map_err(|error| cannot_start(command, &error))?;
    if !output.status.success() {
        bail!("`{}` failed ({})", line(command), output.status);
    }
    Ok(String::from_utf8(output.stdout)?)
}

/// Returns the SHA-256 as hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// The command as one would type it, without the folders of the program's path.
pub fn line(command: &Command) -> String {
    let program = std::path::Path::new(command.get_program()).file_name().unwrap_or(command.get_program());
    let mut words = vec![program.to_string_lossy().into_owned()];
    words.extend(command.get_args().map(|argument| argument.to_string_lossy().into_owned()));
    words.join(" ")
}

/// Explains why a program did not start. If it is missing, the text names the package.
pub fn cannot_start(command: &Command, error: &std::io::Error) -> anyhow::Error {
    let program = command.get_program().to_string_lossy();
    if error.kind() != ErrorKind::NotFound {
        return anyhow!("`{program}` could not be started: {error}");
    }
    match &*program {
        "node" | "npm" | "npm.cmd" => anyhow!("Node is missing: install Node 20.19 or newer, with npm"),
        "python" | "python3" => anyhow!("Python is missing: install Python 3 with pip and venv"),
        "rustup" => anyhow!("rustup is missing: install it from https://rustup.rs"),
        _ => anyhow!("`{program}` is missing: install it and try again"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_program_is_named_with_what_to_install() {
        let error = run(&mut Command::new("no-such-program")).unwrap_err().to_string();
        assert_eq!(error, "`no-such-program` is missing: install it and try again");
    }

    #[test]
    fn python_that_is_missing_is_told_as_what_to_install() {
        let error = cannot_start(&Command::new("python3"), &ErrorKind::NotFound.into()).to_string();
        assert!(error.starts_with("Python is missing: install Python 3"), "{error}");
    }

    #[test]
    fn a_failure_names_the_command_line() {
        let error =
            run(Command::new("cargo").arg("no-such-task").stderr(Stdio::null())).unwrap_err().to_string();
        assert!(error.starts_with("`cargo no-such-task` failed"), "{error}");
    }
}
