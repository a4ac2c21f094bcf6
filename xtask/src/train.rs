//! Fits a filter bank from photos again, with the settings of the bank in `crates/style/src/banks/`.

use anyhow::Result;

use crate::project::Project;
use crate::tools;

/// Training photos of the shipped banks, also used for measuring them.
const PHOTOS: &str = "www/public/samples";
const HELD_OUT: &str = "tests/photos";

/// Fits the filter bank of an operator to the sample album and to photos in other folders, and writes it.
/// Prints its error on the test photos, which are not used for training.
pub fn run(project: &Project, operator: &str, folders: &[String]) -> Result<()> {
    let bank = format!("crates/style/src/banks/{operator}.blade");
    let mut cargo = project.cargo();
    cargo.args(["run", "--release", "--example", "train_blade", "--", operator, &bank, HELD_OUT, PHOTOS]);
    tools::run(cargo.args(folders))
}
