//! `cargo xtask rate`: shows two automatic pages of one album, stores which one the user prefers, and fits
//! the terms of the composer's score to the stored pairs.

mod fit;
mod pages;
mod pairs;
mod server;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Result, bail};
use clap::Parser;

#[derive(Parser)]
#[command(
    name = "cargo xtask rate",
    bin_name = "cargo xtask rate",
    about = "Compare two automatic pages at a time and store the better one; or fit the score to the stored pairs.",
    after_help = "Examples:\n  cargo xtask rate ~/Pictures/Lisbon ~/Pictures/Birthday\n  cargo xtask rate --fit"
)]
struct Arguments {
    /// Folders with one album each
    albums: Vec<PathBuf>,
    /// Pages to draw of each album
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u32).range(2..=24))]
    pages: u32,
    /// Seed of the pages and of their order
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// File with the pairs, one JSON object a line
    #[arg(long, default_value = "target/ratings/pairs.jsonl")]
    pairs: PathBuf,
    /// Print the weights that fit the stored pairs and their cross-validation
    #[arg(long)]
    fit: bool,
    /// Port of the local web page
    #[arg(long, default_value_t = 4180)]
    port: u16,
    /// The `inkpanel` program that draws the pages
    #[arg(long, hide = true)]
    inkpanel: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<()> {
    if arguments.fit {
        print!("{}", fit::report(&pairs::read(&arguments.pairs)?)?);
        return Ok(());
    }
    let Some(inkpanel) = &arguments.inkpanel else { bail!("start this program with `cargo xtask rate`") };
    if arguments.albums.is_empty() {
        bail!("name at least one folder with photos");
    }
    let folder = arguments.pairs.with_file_name("pages");
    let pages = pages::draw(inkpanel, &arguments.albums, arguments.pages, arguments.seed, &folder)?;
    let duels = pairs::duels(&pages, arguments.seed);
    server::serve(&pages, &duels, &arguments.pairs, arguments.port)
}
