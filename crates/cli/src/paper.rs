//! The page settings of the command line: size, gutters and colours.

use crate::CliError;
use clap::{Arg, ArgAction, ArgMatches, Command, FromArgMatches, value_parser};
use inkpanel_engine::layout::{DPI, Field, PageSettings, PaperSize, SETTINGS, Setting};
use serde_json::Value;

/// Size, gutters and colours of a page. The defaults match a new page in the app.
#[derive(clap::Args, Default, PartialEq, Debug)]
#[command(next_help_heading = "Page (photos only)")]
pub(crate) struct Paper {
    /// Page size. [default: a4]
    ///
    /// A name such as a4, a5, letter, us-comic, manga-b5, square or webtoon; a size in pixels such as 1600x2400; or a paper size such
    /// as 210x297mm or 8.5x11in.
    #[arg(long, value_name = "NAME|WxH", value_parser = PaperSize::parse)]
    page_size: Option<PaperSize>,
    /// Resolution in pixels per inch, from 36 to 1200. [default: 300 on paper]
    #[arg(long, value_name = "N", value_parser = value_parser!(u32).range(i64::from(DPI[0])..=i64::from(DPI[1])))]
    dpi: Option<u32>,
    /// Width of the page in pixels. The paper size stays and the resolution changes.
    #[arg(long, value_name = "PX", value_parser = value_parser!(u32).range(64..=14_000))]
    width: Option<u32>,
    #[command(flatten)]
    given: Given,
}

/// The settings of [`SETTINGS`] that the user gave, by name.
#[derive(Default, PartialEq, Debug)]
struct Given(Vec<(&'static str, Value)>);

impl clap::Args for Given {
    fn augment_args(command: Command) -> Command {
        command.args(SETTINGS.map(|Setting { name, field, help }| {
            let option = Arg::new(name).long(name).help(help.trim_end_matches('.'));
            match field {
                Field::Length(..) => option.value_name("PART").value_parser(value_parser!(f64)),
                Field::Colour(_) => option.value_name("COLOUR"),
                Field::Flag(_) => option.action(ArgAction::SetTrue),
            }
        }))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Given {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let given = |Setting { name, field, .. }| {
            let value = match field {
                Field::Length(..) => Value::from(*matches.get_one::<f64>(name)?),
                Field::Colour(_) => Value::from(matches.get_one::<String>(name)?.as_str()),
                Field::Flag(_) => Value::from(matches.get_flag(name).then_some(true)?),
            };
            Some((name, value))
        };
        Ok(Self(SETTINGS.into_iter().filter_map(given).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Paper {
    /// Returns the settings of a page. In a file `with_paper`, the page has the exact size of the paper. Its
    /// width in pixels then follows from the nearest resolution.
    ///
    /// # Errors
    /// A sentence for invalid settings.
    pub(crate) fn settings(&self, with_paper: bool) -> Result<PageSettings, CliError> {
        let mut page = PageSettings::sized(self.page_size, self.dpi, self.width);
        let has_paper = !matches!(self.page_size, Some(PaperSize::Pixels(..)));
        if with_paper && has_paper && self.width.is_some() && self.dpi.is_none() {
            page = PageSettings::sized(self.page_size, Some(page.dpi), None);
        }
        for (name, value) in &self.given.0 {
            page.set(name, value)?;
        }
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
        let wide = Paper { given: Given(vec![("gutter", 0.5.into())]), ..Paper::default() };
        assert!(wide.settings(false).unwrap_err().to_string().contains("page.gutter"));
    }
}
