//! The commands, one file each.

pub(crate) mod animate;
pub(crate) mod book;
pub(crate) mod detect;
pub(crate) mod generate;
pub(crate) mod imitate;
pub(crate) mod render;
pub(crate) mod segment;
pub(crate) mod select;
pub(crate) mod shots;
pub(crate) mod stylize;

use crate::CliError;
use crate::run::Run;
use inkpanel::PageOptions;
use inkpanel_engine::layout::Template;
use inkpanel_engine::style::{Style, catalogue};
use std::path::Path;

pub(crate) fn read_style(run: &Run, id_or_file: &str) -> Result<Style, CliError> {
    if !Path::new(id_or_file).is_file() {
        return Ok(catalogue::find(id_or_file)?.clone());
    }
    let json = run.text(Path::new(id_or_file)).map_err(|error| error.at(id_or_file))?;
    Ok(Style::parse(id_or_file, &json)?)
}

/// Sets a layout by its id or file.
fn with_layout(run: &Run, options: PageOptions, id_or_file: &str) -> Result<PageOptions, CliError> {
    if !Path::new(id_or_file).is_file() {
        return Ok(options.layout(id_or_file)?);
    }
    let json = run.text(Path::new(id_or_file)).map_err(|error| error.at(id_or_file))?;
    // Checked first, so that errors have the name of the file.
    Template::parse(id_or_file, &json)?;
    Ok(options.layout_from_json(&json)?)
}
