//! Turns an album of photos into pages in one style, in one PDF file. This is the most common use of the
//! engine.
//!
//!     cargo run --release --features detect --example album -- www/models album.pdf www/public/samples/*.jpg

use inkpanel::{Album, Nets, PageOptions, Photo, Style, pdf};
use std::error::Error;

/// The most pages of the album.
const PAGES: usize = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(models), Some(output)) = (arguments.next(), arguments.next()) else {
        return Err("usage: album MODELS OUT.pdf PHOTO...".into());
    };
    let mut album = Album::read_skipping_broken(arguments.map(Photo::open).collect());
    album.detect(&Nets::open(models)?);

    let options =
        PageOptions::new().size("a5", Some(150), None)?.style(&Style::designed("ligne-claire")?).seed(7);
    let pages = album.pages(&options, PAGES)?;
    for note in pages[0].notes() {
        eprintln!("{note}");
    }
    std::fs::write(&output, pdf(&pages.iter().collect::<Vec<_>>(), "Album", "en")?)?;
    println!("{output}: {} pages", pages.len());
    Ok(())
}
