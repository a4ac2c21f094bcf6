//! wasm bindings of the texts module. Structured data crosses as JSON text.

use inkpanel_engine::document::script;
use inkpanel_engine::document::speech::Taking;
use inkpanel_engine::document::subtitles::{self, Frame};
use inkpanel_engine::page::words::TextKind;
use inkpanel_engine::texts::{self, Text};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// A decoded text file.
#[wasm_bindgen(getter_with_clone)]
pub struct Decoded {
    /// The characters, without a byte order mark.
    pub text: String,
    /// The name of the encoding.
    pub encoding: String,
    /// Whether the encoding was guessed from the bytes.
    pub guessed: bool,
    /// Number of places that are invalid in the encoding.
    pub lost: usize,
}

impl Decoded {
    fn of(Text { text, encoding, guessed, lost }: Text) -> Self {
        Self { text, encoding: encoding.to_owned(), guessed, lost }
    }
}

/// Decodes a file; see `texts::decode`. `encoding` is the name of the encoding if the user chose one, or empty.
/// Undefined for bytes that are not text.
#[wasm_bindgen]
#[must_use]
pub fn decode(bytes: &[u8], language: &str, encoding: &str) -> Option<Decoded> {
    let read =
        if encoding.is_empty() { texts::decode(bytes, language) } else { texts::decode_as(bytes, encoding) };
    read.map(Decoded::of)
}

/// The encodings that a user can choose, each as its name and the languages that it is for, separated by spaces.
#[wasm_bindgen]
#[must_use]
pub fn encodings() -> Vec<String> {
    texts::ENCODINGS.iter().map(|(name, languages)| format!("{name} {languages}").trim().to_owned()).collect()
}

/// Decodes the names in an archive together; see `texts::names`. `bytes` are all names one after the other, and `ends`
/// the end of each.
#[wasm_bindgen]
#[must_use]
pub fn names(bytes: &[u8], ends: &[u32], language: &str) -> Vec<String> {
    let starts = std::iter::once(0).chain(ends.iter().copied());
    let name = |(start, end): (u32, &u32)| bytes.get(start as usize..*end as usize).unwrap_or_default();
    texts::names(&starts.zip(ends).map(name).collect::<Vec<_>>(), language)
}

/// The kind of the text items by its name.
fn kind_of(name: &str) -> TextKind {
    if name == "caption" { TextKind::Caption } else { TextKind::Balloon }
}

/// Matches subtitles with frames, or places them on `panels` in order; see `document::subtitles::told`.
/// `frames` has two numbers per frame: its time in seconds, and 1 if a page shows it. `sounds` become
/// effects, or are left out.
#[wasm_bindgen]
#[must_use]
pub fn subtitles(text: &str, vtt: bool, frames: &[f64], panels: usize, kind: &str, sounds: bool) -> String {
    let (frames, _) = frames.as_chunks::<2>();
    let frames: Vec<Frame> = frames.iter().map(|&[time, shown]| Frame { time, shown: shown > 0.0 }).collect();
    subtitles::told(text, vtt, &frames, panels, Taking { kind: kind_of(kind), sounds })
}

/// The middle of each subtitle in seconds; see `document::subtitles::middles`.
#[wasm_bindgen]
#[must_use]
pub fn middles(text: &str, vtt: bool) -> Vec<f64> {
    subtitles::middles(text, vtt)
}

/// Places a script on `panels` in order; see `document::script::told`.
#[wasm_bindgen]
#[must_use]
pub fn script(text: &str, panels: usize, kind: &str, sounds: bool) -> String {
    script::told(text, panels, Taking { kind: kind_of(kind), sounds })
}
