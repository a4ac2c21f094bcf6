//! The page settings of the command line: size, gutters and colours.

use crate::CliError;
use inkpanel_engine::layout::{DPI, PageSettings, PaperSize};

/// Size, gutters and colours of a page. The defaults match a new page in the app.
#[derive(clap::Args, Default, PartialEq, Debug)]
#[command(next_help_heading = "Page (photos only)")]
#[allow(clippy::struct_field_names, reason = "they are the names of options")]
pub(crate) struct Paper {
    /// Page size. [default: a4]
    ///
    /// A name such as a4, a5, letter, us-comic, manga-b5, square or webtoon; a size in pixels such as 1600x2400; or a paper size such
    /// as 210x297mm or 8.5x11in.
    #[arg(long, value_name = "NAME|WxH", value_parser = PaperSize::parse)]
    page_size: Option<PaperSize>,
    /// Resolution in pixels per inch, from 36 to 1200. [default: 300 on paper]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(i64::from(DPI[0])..=i64::from(DPI[1])))]
    dpi: Option<u32>,
    /// Width of the page in pixels. The paper size stays and the resolution changes.
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(64..=14_000))]
    width: Option<u32>,
    /// Distance between panels, as a fraction of the page width.
    #[arg(long, value_name = "PART")]
    gutter: Option<f64>,
    /// Distance between panels and the page edge, as a fraction of the page width.
    #[arg(long, value_name = "PART")]
    margin: Option<f64>,
    /// Width of the panel border, as a fraction of the page width.
    #[arg(long, value_name = "PART")]
    border: Option<f64>,
    /// Radius of the panel corners, as a fraction of the page width.
    #[arg(long, value_name = "PART")]
    corner_radius: Option<f64>,
    /// Read pages from right to left: layouts are mirrored.
    #[arg(long)]
    rtl: bool,
    /// Show photos whole: the layout follows their aspect ratios.
    #[arg(long)]
    whole_photos: bool,
    /// Paper colour, as #rrggbb.
    #[arg(long, value_name = "COLOUR")]
    paper: Option<String>,
    /// Colour of the panel border, as #rrggbb.
    #[arg(long, value_name = "COLOUR")]
    border_color: Option<String>,
}

impl Paper {
    /// Returns the settings of a page. In a file `with_paper`, the page has the exact size of the paper. Its
    /// width in pixels then follows from the nearest resolution.
    ///
    /// # Errors
    /// A sentence for invalid settings.
    pub(crate) fn settings(&self, with_paper: bool) -> Result<PageSettings, CliError> {
        let mut usual = PageSettings::sized(self.page_size, self.dpi, self.width);
        let has_paper = !matches!(self.page_size, Some(PaperSize::Pixels(..)));
        if with_paper && has_paper && self.width.is_some() && self.dpi.is_none() {
            usual = PageSettings::sized(self.page_size, Some(usual.dpi), None);
        }
        let page = PageSettings {
            gutter: self.gutter.unwrap_or(usual.gutter),
            margin: self.margin.unwrap_or(usual.margin),
            border: self.border.unwrap_or(usual.border),
            corner_radius: self.corner_radius.unwrap_or(usual.corner_radius),
            paper: self.paper.clone().unwrap_or(usual.paper),
            border_color: self.border_color.clone().unwrap_or(usual.border_color),
            rtl: self.rtl,
            whole_photos: self.whole_photos,
            ..usual
        };
        page.validate()?;
        Ok(page)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pdf_has_the_size_of_the_paper_at_any_width() {
        let points = |size: &str, width: u32| {
            let page_size = Some(PaperSize::parse(size).unwrap());
            let page = Paper { page_size, width: Some(width), ..Paper::default() }.settings(true).unwrap();
            [page.width, page.height].map(|side| f64::from(side) * 72.0 / f64::from(page.dpi))
        };
        for width in [64, 300, 400, 420, 600, 777, 2480] {
            for (size, across, down) in [("a4", 595.3, 841.9), ("letter", 612.0, 792.0), ("a5", 419.5, 595.3)]
            {
                let [x, y] = points(size, width);
                assert!((x - across).abs() <= 1.0 && (y - down).abs() <= 1.0, "{size} {width}: {x} x {y}");
            }
        }
    }

    #[test]
    fn what_no_page_can_be_is_refused() {
        let huge = Paper { page_size: Some(PaperSize::parse("13000x13000").unwrap()), ..Paper::default() };
        assert!(huge.settings(false).unwrap_err().to_string().contains("million pixels"));
        let wide = Paper { gutter: Some(0.5), ..Paper::default() };
        assert!(wide.settings(false).unwrap_err().to_string().contains("page.gutter"));
    }
}
