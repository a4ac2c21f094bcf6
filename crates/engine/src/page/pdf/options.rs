//! Options of a PDF file.

use super::impose::Imposition;
use serde::Deserialize;

/// Options of a PDF file. Default: one sheet per page, in colour, without marks.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "PdfOptions", rename_all = "camelCase", optional_fields))]
pub struct Options {
    /// Title of the file.
    #[cfg_attr(test, ts(as = "Option<String>"))]
    pub title: String,
    /// Language of the text, as a tag such as `pt-BR`. Empty: not specified.
    #[cfg_attr(test, ts(as = "Option<String>"))]
    pub language: String,
    /// Crop marks and fold marks.
    #[cfg_attr(test, ts(as = "Option<bool>"))]
    pub marks: bool,
    /// How pages share sheets.
    #[cfg_attr(test, ts(optional = nullable))]
    pub imposition: Option<Imposition>,
    /// Width and height in millimetres of the sheets, in either orientation. The content is scaled to fit.
    /// `None`: sheets fit the content.
    #[cfg_attr(test, ts(optional = nullable, as = "Option<[f64; 2]>"))]
    pub paper: Option<[f64; 2]>,
    /// Index in `inks` of the ink of this plate. `None`: all colours.
    #[cfg_attr(test, ts(optional = nullable))]
    pub plate: Option<usize>,
    /// The colours on white paper of the inks of plates, the strongest last.
    #[cfg_attr(test, ts(as = "Option<Vec<[u8; 3]>>"))]
    pub inks: Vec<[u8; 3]>,
}
