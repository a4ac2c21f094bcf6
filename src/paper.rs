//! The paper of pages that the command line plans: its size, and what else of a page is no choice of layout or style.

use crate::Complaint;
use inkpanel::layout::{self, DPI, PRESETS, PagePreset, PageSettings};

/// Millimetres of an inch.
const INCH: f64 = 25.4;

/// Size, gutters and colours of a page; what is not said is as in the page that the browser begins with.
#[derive(clap::Args, Default, PartialEq, Debug)]
#[allow(clippy::struct_field_names, reason = "they are the names of options")]
pub(crate) struct Paper {
    /// Size of the page: a name (such as a4, a5, letter, us-comic, manga-b5, square, webtoon), pixels (1600x2400), or a
    /// size on paper (210x297mm, 8.5x11in); a4 unless told.
    #[arg(long, value_name = "NAME|WxH", value_parser = Size::parse)]
    page_size: Option<Size>,
    /// Pixels an inch, from 36 to 1200. A size by name or on paper then has as many pixels as that makes.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(i64::from(DPI[0])..=i64::from(DPI[1])))]
    dpi: Option<u32>,
    /// Width of the page in pixels; the paper stays as large, so it has more or fewer pixels an inch.
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(64..=14_000))]
    width: Option<u32>,
    /// Distance between panels, as a part of the page's width.
    #[arg(long, value_name = "PART")]
    gutter: Option<f64>,
    /// Distance between panels and the edge of the page, as a part of its width.
    #[arg(long, value_name = "PART")]
    margin: Option<f64>,
    /// Width of the line round panels, as a part of the page's width.
    #[arg(long, value_name = "PART")]
    border: Option<f64>,
    /// Radius of the panels' corners, as a part of the page's width.
    #[arg(long, value_name = "PART")]
    corner_radius: Option<f64>,
    /// Colour of the paper, as #rrggbb.
    #[arg(long, value_name = "COLOUR")]
    paper: Option<String>,
    /// Colour of the line round panels, as #rrggbb.
    #[arg(long, value_name = "COLOUR")]
    border_color: Option<String>,
}

/// A size of paper as it is said.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Size {
    Known(PagePreset),
    Pixels(u32, u32),
    /// Width and height.
    Inches(f64, f64),
}

/// The names of all sizes.
pub(crate) fn names() -> String {
    PRESETS.map(|preset| preset.id).join(", ")
}

impl Size {
    fn parse(text: &str) -> Result<Self, Complaint> {
        let plain = text.trim().to_lowercase();
        if let Some(known) = layout::preset(&plain) {
            return Ok(Self::Known(known));
        }
        Self::measured(&plain).ok_or_else(|| {
            format!(
                "there is no such size; say one of {}, or a width and a height such as 1600x2400, 210x297mm or 8.5x11in",
                names()
            )
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

impl Paper {
    /// The settings of a page.
    ///
    /// # Errors
    /// A sentence for what no page can be.
    pub(crate) fn settings(&self) -> Result<PageSettings, Complaint> {
        let usual = PageSettings::default();
        let (width, height, dpi) = match self.page_size {
            None => at_dpi(f64::from(usual.width), f64::from(usual.height), usual.dpi, self.dpi),
            Some(Size::Known(known)) => {
                at_dpi(f64::from(known.width), f64::from(known.height), known.dpi, self.dpi)
            }
            // So many pixels were asked for: only their size on paper is another.
            Some(Size::Pixels(width, height)) => {
                (f64::from(width), f64::from(height), self.dpi.unwrap_or(usual.dpi))
            }
            Some(Size::Inches(width, height)) => {
                let dpi = self.dpi.unwrap_or(usual.dpi);
                (width * f64::from(dpi), height * f64::from(dpi), dpi)
            }
        };
        let (width, height, dpi) = match self.width {
            None => (width, height, dpi),
            Some(wanted) => {
                let by = f64::from(wanted) / width;
                let dots = (f64::from(dpi) * by).round().clamp(f64::from(DPI[0]), f64::from(DPI[1]));
                (f64::from(wanted), height * by, self.dpi.unwrap_or(dots as u32))
            }
        };
        let page = PageSettings {
            width: width.round() as u32,
            height: height.round() as u32,
            dpi,
            gutter: self.gutter.unwrap_or(usual.gutter),
            margin: self.margin.unwrap_or(usual.margin),
            border: self.border.unwrap_or(usual.border),
            corner_radius: self.corner_radius.unwrap_or(usual.corner_radius),
            paper: self.paper.clone().unwrap_or(usual.paper),
            border_color: self.border_color.clone().unwrap_or(usual.border_color),
            ..usual
        };
        page.validate().map_err(|error| error.to_string())?;
        Ok(page)
    }
}

/// A size with as many pixels as another number of dots an inch makes of it.
fn at_dpi(width: f64, height: f64, dpi: u32, wanted: Option<u32>) -> (f64, f64, u32) {
    let by = wanted.map_or(1.0, |wanted| f64::from(wanted) / f64::from(dpi));
    (width * by, height * by, wanted.unwrap_or(dpi))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(size: &str, dpi: Option<u32>, width: Option<u32>) -> (u32, u32, u32) {
        let page_size = (!size.is_empty()).then(|| Size::parse(size).unwrap());
        let page = Paper { page_size, dpi, width, ..Paper::default() }.settings().unwrap();
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
            let why = Size::parse(text).unwrap_err();
            assert!(why.contains("a4-landscape") && why.contains("210x297mm"), "{text}: {why}");
        }
        let huge = Paper { page_size: Some(Size::parse("13000x13000").unwrap()), ..Paper::default() };
        assert!(huge.settings().unwrap_err().contains("million pixels"));
        let wide = Paper { gutter: Some(0.5), ..Paper::default() };
        assert!(wide.settings().unwrap_err().contains("page.gutter"));
    }
}
