//! The bounds of a document are told once, in `src/document/limits.rs`: what the page needs of them is written from there.

use inkpanel::document::limits;
use inkpanel::page::words::model::FARTHEST;

const FILE: &str = "www/engine/bounds.ts";

/// The module as it should be, formatted as Biome formats it.
fn expected() -> String {
    let most = [
        ("Photos of a project.", "photos", limits::MOST_PHOTOS),
        ("Pages of a storyboard.", "sheets", limits::MOST_SHEETS),
        ("Words of a page.", "words", limits::MOST_WORDS),
        ("Characters of a word.", "letters", limits::MOST_LETTERS),
        ("Styles of one's own, favourites, and layouts: of each so many.", "styles", limits::MOST_STYLES),
        ("Characters of a name.", "name", limits::LONGEST_NAME),
        ("A place of a word, in widths and heights of its panel to either side.", "away", FARTHEST as usize),
        ("Bytes of the text of a project.", "text", limits::PROJECT.bytes),
    ];
    let head = "/**\n * What a project holds at most. Written out of `src/document/limits.rs` by `cargo xtask bless`, not by hand: the core reads\n * no project beyond it, so none is made here.\n */\n\nexport const MOST = Object.freeze({\n";
    let lines = most.map(|(what, name, value)| format!("  /** {what} */\n  {name}: {},\n", grouped(value)));
    format!("{head}{}}});\n", lines.concat())
}

/// Digits in groups of three, as TypeScript takes them.
fn grouped(value: usize) -> String {
    let digits = value.to_string();
    let groups: Vec<_> =
        digits.as_bytes().rchunks(3).rev().map(|group| String::from_utf8_lossy(group)).collect();
    groups.join("_")
}

/// With `BLESS=1` the module is written anew, and the test fails for once.
#[test]
fn the_page_has_the_bounds_of_the_core() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    if std::env::var_os("BLESS").is_some() && found != expected() {
        std::fs::write(&path, expected()).unwrap();
        panic!("blessed {FILE}");
    }
    assert_eq!(found, expected(), "`cargo xtask bless` writes {FILE} anew");
}
