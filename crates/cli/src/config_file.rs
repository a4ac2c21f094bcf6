//! Settings of `render` and `book` in a file. Each setting has the name of an option. The command line takes precedence.

use crate::{CliError, run};
use clap::{Arg, Command, CommandFactory};
use serde_json::{Map, Value};
use std::any::TypeId;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Bytes of a file of settings.
const MOST: u64 = 1 << 20;
/// Settings that may name a file or something else.
const PERHAPS_FILES: [&str; 2] = ["layout", "style"];

/// Inserts the settings of the file in `--config` before the arguments, and adds its photos.
///
/// # Errors
/// A sentence with the name of the file and of the setting.
pub(crate) fn expanded<C: CommandFactory>(
    arguments: Vec<OsString>,
) -> Result<(Vec<OsString>, Vec<PathBuf>), CliError> {
    let Some(file) = named(&arguments) else { return Ok((arguments, Vec::new())) };
    let complain = |error: CliError| error.at(file.display());
    let settings = read(&file).map_err(complain)?;
    let command = C::command();
    let name = arguments[1].to_str().unwrap_or_default();
    let render = command.find_subcommand(name).ok_or("the command is missing")?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let (head, tail) = arguments.split_at(2);
    let (options, files) = options(settings, render, folder, tail).map_err(complain)?;
    Ok(([head, &options[..], tail].concat(), files))
}

/// The file that `--config` names.
fn named(arguments: &[OsString]) -> Option<PathBuf> {
    if !["render", "book"].contains(&arguments.get(1)?.to_str()?) {
        return None;
    }
    let mut rest = arguments[2..].iter().take_while(|argument| *argument != "--");
    while let Some(argument) = rest.next() {
        if argument == "--config" {
            return rest.next().map(PathBuf::from);
        }
        if let Some(file) = argument.to_str().and_then(|text| text.strip_prefix("--config=")) {
            return Some(PathBuf::from(file));
        }
    }
    None
}

/// Reads JSON from a file with this extension, otherwise TOML.
fn read(file: &Path) -> Result<Map<String, Value>, CliError> {
    let about = std::fs::metadata(file).map_err(|error| CliError::reading(&error))?;
    if about.len() > MOST {
        return Err(CliError::new("too-large", format!("is larger than {MOST} bytes")));
    }
    let bytes = std::fs::read(file).map_err(|error| CliError::reading(&error))?;
    let text = run::unicode(&bytes)?;
    let is_json = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    let value: Value = if is_json {
        serde_json::from_str(&text).map_err(|error| format!("not valid JSON: {error}"))?
    } else {
        toml::from_str(&text).map_err(|error| format!("not valid TOML: {}", error.to_string().trim()))?
    };
    match value {
        Value::Object(settings) => Ok(settings),
        _ => Err("must be a table of settings".into()),
    }
}

/// Converts settings to options, except options that were already `said`, and lists the files in the
/// settings.
fn options(
    settings: Map<String, Value>,
    command: &Command,
    folder: &Path,
    said: &[OsString],
) -> Result<(Vec<OsString>, Vec<PathBuf>), CliError> {
    let (mut options, mut files) = (Vec::new(), Vec::new());
    for (key, value) in settings {
        let name = key.replace('_', "-");
        if name == "files" {
            files.extend(texts(&value, &key)?.into_iter().map(|file| located(&file, folder)));
            continue;
        }
        let known = command.get_arguments().find(|argument| names(argument).contains(&name.as_str()));
        let known = known.filter(|_| name != "config").ok_or_else(|| format!("unknown setting \"{key}\""))?;
        if is_said(said, known) {
            continue;
        }
        let option = format!("--{name}");
        if !known.get_action().takes_values() {
            match value {
                Value::Bool(true) => options.push(option.into()),
                Value::Bool(false) => {}
                _ => return Err(format!("{key}: must be true or false").into()),
            }
            continue;
        }
        // Relative paths start at the folder of the settings file.
        let names_files = known.get_value_parser().type_id() == TypeId::of::<PathBuf>();
        for text in texts(&value, &key)? {
            let is_file =
                names_files || (PERHAPS_FILES.contains(&name.as_str()) && folder.join(&text).is_file());
            let value = if is_file { located(&text, folder).into_os_string() } else { text.into() };
            // Otherwise, clap would parse a number below 0 as an option.
            let mut whole = OsString::from(format!("{option}="));
            whole.push(value);
            options.push(whole);
        }
    }
    Ok((options, files))
}

/// The name of an option, and its earlier names.
fn names(option: &Arg) -> Vec<&str> {
    option.get_long().into_iter().chain(option.get_all_aliases().unwrap_or_default()).collect()
}

/// Whether an option is among the arguments, by one of its names or in short.
fn is_said(arguments: &[OsString], option: &Arg) -> bool {
    arguments.iter().filter_map(|argument| argument.to_str()).take_while(|text| *text != "--").any(|text| {
        let whole = text.split_once('=').map_or(text, |(option, _)| option);
        whole.strip_prefix("--").is_some_and(|name| names(option).contains(&name))
            || option.get_short().is_some_and(|short| {
                text.strip_prefix('-').is_some_and(|rest| !rest.starts_with('-') && rest.starts_with(short))
            })
    })
}

fn located(file: &str, folder: &Path) -> PathBuf {
    if file == run::STANDARD { PathBuf::from(file) } else { folder.join(file) }
}

/// A text or a number, or several.
fn texts(value: &Value, key: &str) -> Result<Vec<String>, CliError> {
    let one = |value: &Value| match value {
        Value::String(text) => Ok(text.clone()),
        Value::Number(number) => Ok(number.to_string()),
        _ => Err(format!("{key}: must be a text or a number").into()),
    };
    match value {
        Value::Array(values) => values.iter().map(one).collect(),
        value => Ok(vec![one(value)?]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn made(settings: Value, said: &[&str]) -> Result<Vec<String>, CliError> {
        let command = crate::Cli::command();
        let render = command.find_subcommand("render").unwrap();
        let Value::Object(settings) = settings else { panic!("a table") };
        let said: Vec<OsString> = said.iter().map(OsString::from).collect();
        let (options, files) = options(settings, render, Path::new("album"), &said)?;
        let files = files.into_iter().map(PathBuf::into_os_string);
        Ok(options.into_iter().chain(files).map(|text| text.to_string_lossy().into_owned()).collect())
    }

    #[test]
    fn settings_are_options_and_files_are_beside_them() {
        let settings = json!({ "seed": 7, "merge": true, "no_detect": false, "star": ["a.jpg", "b.jpg"], "files": "c.jpg" });
        let expected = ["--merge", "--seed=7", "--star=album/a.jpg", "--star=album/b.jpg", "album/c.jpg"];
        assert_eq!(made(settings, &[]).unwrap(), expected);
    }

    #[test]
    fn every_option_that_takes_a_file_is_beside_the_settings() {
        let command = crate::Cli::command();
        let render = command.find_subcommand("render").unwrap();
        let takes_file = |name: &str| {
            let option = render.get_arguments().find(|argument| argument.get_long() == Some(name)).unwrap();
            let names = option.get_value_names().unwrap_or_default();
            names.iter().any(|name| ["FILE", "DIR", "OUTPUT"].contains(&name.as_str()))
        };
        let mut files = Vec::new();
        let options = render.get_arguments().filter(|option| option.get_action().takes_values());
        for name in options.filter_map(clap::Arg::get_long).filter(|name| *name != "config") {
            let made = made(json!({ name: "x" }), &[]).unwrap();
            assert_eq!(made == [format!("--{name}=album/x")], takes_file(name), "{name}");
            files.extend(takes_file(name).then_some(name));
        }
        for name in ["font", "output", "words", "edits", "star", "models", "document", "save-document"] {
            assert!(files.contains(&name), "{name}");
        }
    }

    #[test]
    fn what_the_command_line_says_goes_before() {
        let settings = json!({ "seed": 7, "style": "noir", "output": "x.png" });
        assert_eq!(made(settings.clone(), &["--seed=3", "-opage.png"]).unwrap(), ["--style=noir"]);
        assert_eq!(
            made(settings, &["--style", "comic", "--", "--seed"]).unwrap(),
            ["--output=album/x.png", "--seed=7"]
        );
        // Also by an earlier name of the option.
        let settings = json!({ "duplicate_threshold": 8 });
        assert_eq!(made(settings.clone(), &["--alike", "4"]).unwrap(), [""; 0]);
        assert_eq!(made(settings, &[]).unwrap(), ["--duplicate-threshold=8"]);
        assert_eq!(made(json!({ "alike": 8 }), &[]).unwrap(), ["--alike=8"]);
    }

    #[test]
    fn what_is_no_setting_is_named() {
        assert_eq!(made(json!({ "sede": 7 }), &[]).unwrap_err().to_string(), "unknown setting \"sede\"");
        assert_eq!(
            made(json!({ "config": "x" }), &[]).unwrap_err().to_string(),
            "unknown setting \"config\""
        );
        assert_eq!(made(json!({ "merge": 1 }), &[]).unwrap_err().to_string(), "merge: must be true or false");
        assert_eq!(
            made(json!({ "seed": {} }), &[]).unwrap_err().to_string(),
            "seed: must be a text or a number"
        );
    }
}
