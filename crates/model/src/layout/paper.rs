//! Page sizes: by name, in pixels, or in paper units.

use super::settings::{DPI, PRESETS, PagePreset, PageSettings, preset};
use crate::error::{Error, Result};

/// Millimetres of an inch.
const INCH: f64 = 25.4;

/// A paper size as the user enters it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PaperSize {
    /// A named size.
    Known(PagePreset),
    /// Width and height in pixels.
    Pixels(u32, u32),
    /// Width and height in inches.
    Inches(f64, f64),
}

impl PaperSize {
    /// The names of all sizes, with commas between them.
    #[must_use]
    pub fn names() -> String {
        PRESETS.map(|preset| preset.id).join(", ")
    }

    /// Reads a size: a name (`a4`), pixels (`1600x2400`), or a size on paper (`210x297mm`, `8.5x11in`).
    ///
    /// # Errors
    /// `invalid-document`, with a list of all valid forms.
    pub fn parse(text: &str) -> Result<Self> {
        let plain = text.trim().to_lowercase();
        if let Some(known) = preset(&plain) {
            return Ok(Self::Known(known));
        }
        Self::measured(&plain).ok_or_else(|| Error::InvalidDocument {
            location: "page size".into(),
            reason: format!(
                "unknown size; use one of {}, or a width and a height such as 1600x2400, 210x297mm or 8.5x11in",
                Self::names()
            ),
        })
    }

    fn measured(text: &str) -> Option<Self> {
        let (numbers, unit) = match text.find(|c: char| c.is_ascii_alphabetic() && c != 'x') {
            Some(at) => (&text[..at], &text[at..]),
            None => (text, "px"),
        };
        let (width, height) = numbers.trim().split_once(['x', '×'])?;
        let side =
            |text: &str| text.trim().parse::<f64>().ok().filter(|side| side.is_finite() && *side > 0.0);
        let (width, height) = (side(width)?, side(height)?);
        match unit {
            "px" if width.fract() == 0.0 && height.fract() == 0.0 && width.max(height) < 1e6 => {
                Some(Self::Pixels(width as u32, height as u32))
            }
            "mm" => Some(Self::Inches(width / INCH, height / INCH)),
            "cm" => Some(Self::Inches(width * 10.0 / INCH, height * 10.0 / INCH)),
            "in" => Some(Self::Inches(width, height)),
            _ => None,
        }
    }
}

impl PageSettings {
    /// The default page in another size. `dpi` sets the pixels of a named or paper size. `width` keeps the
    /// paper size and changes its resolution. Their ranges are left to [`validate`](Self::validate).
    #[must_use]
    pub fn sized(size: Option<PaperSize>, dpi: Option<u32>, width: Option<u32>) -> Self {
        let usual = Self::default();
        let (across, down, dots) = match size {
            None => at_dpi(f64::from(usual.width), f64::from(usual.height), usual.dpi, dpi),
            Some(PaperSize::Known(known)) => {
                at_dpi(f64::from(known.width), f64::from(known.height), known.dpi, dpi)
            }
            // A size in pixels keeps its pixels; only the paper size changes.
            Some(PaperSize::Pixels(across, down)) => {
                (f64::from(across), f64::from(down), dpi.unwrap_or(usual.dpi))
            }
            Some(PaperSize::Inches(across, down)) => {
                let dpi = dpi.unwrap_or(usual.dpi);
                (across * f64::from(dpi), down * f64::from(dpi), dpi)
            }
        };
        let (across, down, dots) = match width {
            None => (across, down, dots),
            Some(wanted) => {
                let by = f64::from(wanted) / across;
                let near = (f64::from(dots) * by).round().clamp(f64::from(DPI[0]), f64::from(DPI[1]));
                (f64::from(wanted), down * by, dpi.unwrap_or(near as u32))
            }
        };
        Self { width: across.round() as u32, height: down.round() as u32, dpi: dots, ..usual }
    }
}

/// A size converted to another resolution.
fn at_dpi(width: f64, height: f64, dpi: u32, wanted: Option<u32>) -> (f64, f64, u32) {
    let by = wanted.map_or(1.0, |wanted| f64::from(wanted) / f64::from(dpi));
    (width * by, height * by, wanted.unwrap_or(dpi))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(size: &str, dpi: Option<u32>, width: Option<u32>) -> (u32, u32, u32) {
        let size = (!size.is_empty()).then(|| PaperSize::parse(size).unwrap());
        let page = PageSettings::sized(size, dpi, width);
        page.validate().unwrap();
        (page.width, page.height, page.dpi)
    }

    #[test]
    fn sizes_are_names_pixels_or_lengths() {
        assert_eq!(page("", None, None), (2480, 3508, 300));
        assert_eq!(page("Letter", None, None), (2550, 3300, 300));
        assert_eq!(page("a4", Some(150), None), (1240, 1754, 150));
        assert_eq!(page("1600x2400", Some(200), None), (1600, 2400, 200));
        assert_eq!(page("210x297mm", None, None), (2480, 3508, 300));
        assert_eq!(page("21 x 29.7 cm", Some(150), None), (1240, 1754, 150));
        assert_eq!(page("8.5x11in", Some(100), None), (850, 1100, 100));
    }

    #[test]
    fn a_width_leaves_the_paper_as_large_as_it_was() {
        // A4 at half the dots, not A6.
        assert_eq!(page("", None, Some(1240)), (1240, 1754, 150));
        assert_eq!(page("letter", None, Some(1275)), (1275, 1650, 150));
        assert_eq!(page("", Some(300), Some(1240)), (1240, 1754, 300));
        assert_eq!(page("", None, Some(64)), (64, 91, 36));
    }

    #[test]
    fn what_is_no_size_is_refused_with_those_that_are() {
        for text in ["a7b", "10", "10x", "0x10", "-5x5", "1.5x2", "10x10pt", "NaNx1", "1e9x1"] {
            let why = PaperSize::parse(text).unwrap_err().to_string();
            assert!(why.contains("a4-landscape") && why.contains("210x297mm"), "{text}: {why}");
        }
    }
}
