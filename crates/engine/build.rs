//! Makes tables in `OUT_DIR`. `crates/model/build.rs` embeds `layouts/`, and `crates/style/build.rs` embeds `styles/`. Text
//! colours are computed from the styles. The fonts of `fonts/` become the table of glyphs, except for WebAssembly modules, which receive it
//! at run time.

mod pack;
#[path = "src/page/words/palette.rs"]
#[allow(dead_code, unreachable_pub)]
mod palette;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Paths are relative to the package, where cargo runs this program, so that a checkout can be moved without a new build.
fn main() -> io::Result<()> {
    palettes()?;
    reader()?;
    letters()
}

/// Writes `OUT_DIR/palettes.rs`: text colours on pages of each style, sorted by style id.
fn palettes() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src/page/words/palette.rs");
    let folder = top("styles");
    let mut rows = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let style: serde_json::Value = serde_json::from_str(&fs::read_to_string(&path)?)?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let id = style["id"].as_str().map_or(stem, str::to_owned);
        let palette::Palette { ink, paper, note, accent, edge } = palette::of(&style);
        rows.push(format!("    ({id:?}, [{ink:?}, {paper:?}, {note:?}, {accent:?}, {edge:?}]),\n"));
    }
    rows.sort();
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let table = "static PALETTES: &[(&str, [[u8; 3]; 5])] = &[\n";
    fs::write(Path::new(&out).join("palettes.rs"), format!("{table}{}];\n", rows.concat()))
}

/// Writes `OUT_DIR/reader.rs`: the hashes that allow the inline script and style of an HTML comic in its
/// Content-Security-Policy.
fn reader() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src/output/reader");
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let folder = Path::new("src/output/reader");
    let mut constants = String::new();
    for (name, file) in [("STYLE_HASH", "reader.css"), ("SCRIPT_HASH", "reader.js")] {
        let hash = BASE64_STANDARD.encode(Sha256::digest(fs::read(folder.join(file))?));
        let _ = writeln!(constants, "const {name}: &str = \"{hash}\";");
    }
    fs::write(Path::new(&out).join("reader.rs"), constants)
}

/// Writes `OUT_DIR/letters.bin`.
fn letters() -> io::Result<()> {
    println!("cargo:rerun-if-changed=pack.rs");
    let folder = top("fonts");
    // `cargo xtask` writes the table for the app.
    if env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|target| target == "wasm32") {
        return Ok(());
    }
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let table = pack::pack(&folder).map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("letters.bin"), table)
}

/// Returns a folder at the top of the repository, or inside the published crate, which has copies instead of the links. A change in
/// it starts this program again.
fn top(name: &str) -> PathBuf {
    let folder = Path::new("../..").join(name);
    let folder = if folder.is_dir() { folder } else { PathBuf::from(name) };
    println!("cargo:rerun-if-changed={}", folder.display());
    folder
}
