//! What is asked of a PDF file beside its pages.

use super::impose::Imposition;
use serde::Deserialize;

/// How a file is made of pages; nothing told gives one sheet a page, in colour, without marks.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(
    all(test, feature = "cli"),
    derive(ts_rs::TS),
    ts(rename = "PdfOptions", rename_all = "camelCase", optional_fields)
)]
pub struct Options {
    /// What the file is called where it is shown.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<String>"))]
    pub title: String,
    /// Language of what stands in it, as a tag such as `pt-BR`; empty says nothing.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<String>"))]
    pub language: String,
    /// Lines beyond the corners that say where to cut and fold.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<bool>"))]
    pub marks: bool,
    /// How pages share sheets.
    #[cfg_attr(all(test, feature = "cli"), ts(optional = nullable))]
    pub imposition: Option<Imposition>,
    /// Width and height in millimetres of the sheets that all is fitted to, upright or not; none makes sheets as large as
    /// what is on them.
    #[cfg_attr(all(test, feature = "cli"), ts(optional = nullable, as = "Option<[f64; 2]>"))]
    pub paper: Option<[f64; 2]>,
    /// The ink whose plate this is, by its place in `inks`; none is for all colours.
    #[cfg_attr(all(test, feature = "cli"), ts(optional = nullable))]
    pub plate: Option<usize>,
    /// The colours on white paper of the inks of plates, the strongest last.
    #[cfg_attr(all(test, feature = "cli"), ts(as = "Option<Vec<[u8; 3]>>"))]
    pub inks: Vec<[u8; 3]>,
}
