//! The page settings of the command line: size, gutters and colours.

use crate::Complaint;
use inkpanel::layout::{DPI, PageSettings, PaperSize};

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
    /// Paper colour, as #rrggbb.
    #[arg(long, value_name = "COLOUR")]
    paper: Option<String>,
    /// Colour of the panel border, as #rrggbb.
    #[arg(long, value_name = "COLOUR")]
    border_color: Option<String>,
}

impl Paper {
    /// The settings of a page.
    ///
    /// # Errors
    /// A sentence for invalid settings.
    pub(crate) fn settings(&self) -> Result<PageSettings, Complaint> {
        let usual = PageSettings::sized(self.page_size, self.dpi, self.width);
        let page = PageSettings {
            gutter: self.gutter.unwrap_or(usual.gutter),
            margin: self.margin.unwrap_or(usual.margin),
            border: self.border.unwrap_or(usual.border),
            corner_radius: self.corner_radius.unwrap_or(usual.corner_radius),
            paper: self.paper.clone().unwrap_or(usual.paper),
            border_color: self.border_color.clone().unwrap_or(usual.border_color),
            rtl: self.rtl,
            ..usual
        };
        page.validate().map_err(|error| error.to_string())?;
        Ok(page)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_page_can_be_is_refused() {
        let huge = Paper { page_size: Some(PaperSize::parse("13000x13000").unwrap()), ..Paper::default() };
        assert!(huge.settings().unwrap_err().contains("million pixels"));
        let wide = Paper { gutter: Some(0.5), ..Paper::default() };
        assert!(wide.settings().unwrap_err().contains("page.gutter"));
    }
}
