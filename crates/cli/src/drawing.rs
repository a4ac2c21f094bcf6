//! Writes pages of the command line as files: rendered from full-size photos, with their text.

use crate::destination::{Output, write};
use crate::format::Format;
use crate::masks::Masks;
use crate::photos::Photos;
use crate::run::{Run, is_standard};
use crate::{CliError, detectors, language, own_pages};
use inkpanel_engine::framing::Subject;
use inkpanel_engine::layout::{self, PagePreset, PaperSize};
use inkpanel_engine::native::{self, QUALITY, alts};
use inkpanel_engine::page::pdf::{self, Imposition, Options};
use inkpanel_engine::page::plates::{self, Separation};
use inkpanel_engine::page::words::TextItem;
use inkpanel_engine::page::words::given::{self, GivenFonts};
use inkpanel_engine::page::words::place::{self, Known};
use inkpanel_engine::page::{Document, jpeg, png, webp};
use inkpanel_engine::raster::Image;
use rayon::prelude::*;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Adds the text items of a file to a page. Items without a position are placed clear of faces, and of
/// subjects with masks.
pub(crate) fn add_words(
    document: &mut Document,
    file: &Path,
    photos: &Photos<'_>,
    fonts: &GivenFonts,
) -> Result<(), CliError> {
    let complain = |error: CliError| error.at(file.display());
    let json = photos.run.text(file).map_err(complain)?;
    let words = TextItem::read_all(&json).map_err(|error| complain(error.into()))?;
    let known = |id: &str| photos.find(id).map(|(_, photo)| Known::from(&photo.meta)).unwrap_or_default();
    let letters = fonts.letters(&words).map_err(|error| complain(error.into()))?;
    place::add(document, words, known, &letters).map_err(|error| complain(error.into()))
}

/// Warns about characters without a glyph, and about models of painters that are named but not used.
pub(crate) fn tell_missing(run: &Run, pages: &[Document], fonts: &GivenFonts) -> Result<(), CliError> {
    let styles = pages.iter().map(Document::style).collect::<Result<Vec<_>, _>>()?;
    detectors::warn_about_models(run, styles.iter().map(AsRef::as_ref));
    let words = || pages.iter().flat_map(|page| &page.words);
    let letters = fonts.letters(words())?;
    let missing = given::missing(&letters, words());
    if !missing.is_empty() {
        run.report.note(
            None,
            &format!(
                "no font has these characters, so they become question marks: {} (add a font with --font)",
                missing.join(" ")
            ),
        );
    }
    Ok(())
}

/// Returns the subjects of a photo by id.
pub(crate) type Subjects<'a> = dyn Fn(&str) -> &'a [Subject] + 'a;

/// Decodes a photo at full size by its id. Returns nothing for a missing photo.
pub(crate) type FullPhotos<'p> = dyn Fn(&str) -> Result<Option<Image>, CliError> + Sync + 'p;

/// Resources to draw pages.
#[derive(Clone, Copy)]
pub(crate) struct Means<'p> {
    pub(crate) run: &'p Run,
    pub(crate) photos: &'p FullPhotos<'p>,
    pub(crate) fonts: &'p GivenFonts,
    pub(crate) masks: &'p Masks<'p>,
    /// JPEG quality, from 1 to 100.
    pub(crate) quality: u8,
    /// Whether coarse photos are enlarged well.
    pub(crate) enlarges: bool,
}

/// Returns a page in its final form, with its photos. Upscaled photos are reported.
fn prepared(document: &Document, means: &Means<'_>) -> Result<(Document, native::Photos), CliError> {
    let photos = decoded(document, means)?;
    let mut page = document.clone();
    if means.enlarges {
        page.page.enlarge = true;
        let size =
            |id: &str| photos.get(id).map(|photo| (photo.image.width() as u32, photo.image.height() as u32));
        for (panel, dpi) in native::coarse(&page, &size)? {
            let event = json!({ "event": "enlarged", "panel": panel + 1, "dpi": dpi });
            means.run.report.step(&event, Some(format!("panel {}: enlarged from {dpi} dpi", panel + 1)));
        }
    }
    Ok((page, photos))
}

/// Renders a document from its photos, decoded at their full size, as the kind of picture that `output` names.
pub(crate) fn draw(document: &Document, means: &Means<'_>, output: &Path) -> Result<Vec<u8>, CliError> {
    let format = Format::of(output)?;
    Ok(own_pages::marked(drawn(document, means, format)?, format))
}

fn drawn(document: &Document, means: &Means<'_>, format: Format) -> Result<Vec<u8>, CliError> {
    let (document, photos) = &prepared(document, means)?;
    let sheet = native::sheet(document, photos, means.fonts)?;
    encoded(format, (sheet.width(), sheet.height()), sheet.rgb(), (document.page.dpi, means.quality))
}

/// Pixels as a file of a kind that holds a single picture.
pub(crate) fn encoded(
    format: Format,
    (width, height): (usize, usize),
    rgb: &[u8],
    (dpi, quality): (u32, u8),
) -> Result<Vec<u8>, CliError> {
    let file = match format {
        Format::Png => png::encode_rgb(width, height, rgb, dpi),
        Format::Jpeg => jpeg::encode_rgb(width, height, rgb, dpi, quality),
        Format::Webp => webp::encode_rgb(width, height, rgb),
        Format::Pdf => return Err("stylize writes .png, .jpg or .webp".into()),
        Format::Project | Format::Comic(_) | Format::Shots(_) => {
            return Err("this format is only available in `render`".into());
        }
    };
    Ok(file?)
}

/// Renders a document as JPEG.
pub(crate) fn jpeg_of(document: &Document, means: &Means<'_>) -> Result<Vec<u8>, CliError> {
    drawn(document, means, Format::Jpeg)
}

/// Options of output files, mostly for print.
#[derive(clap::Args, Default, PartialEq, Clone)]
#[command(next_help_heading = "Print")]
pub(crate) struct Printing {
    /// Bleed in millimetres (PDF only).
    #[arg(long, value_name = "MM", value_parser = millimetres)]
    bleed: Option<f64>,
    /// Add crop and fold marks (PDF only).
    #[arg(long)]
    marks: bool,
    /// Arrange pages on sheets: booklet, zine, 2up or spreads (PDF only).
    #[arg(long, value_name = "HOW", value_parser = imposition)]
    impose: Option<Imposition>,
    /// Sheet size: a name, or millimetres such as 210x297 (PDF only). [default: the size of the pages; a4 for a zine]
    #[arg(long, value_name = "NAME|WxH", value_parser = sheet)]
    sheet: Option<[f64; 2]>,
    /// Also write one gray PDF per ink of the style, such as OUT-red.pdf (PDF only).
    #[arg(long)]
    plates: bool,
    /// Language of the text, for screen readers and hyphenation: a tag such as en or pt-BR (PDF and comics). [default: en]
    #[arg(long, value_name = "TAG", value_parser = language::tag)]
    language: Option<String>,
    /// Fallback font file (TrueType or OpenType) for missing characters, such as Arabic. Can be repeated.
    #[arg(long, value_name = "FILE")]
    font: Vec<PathBuf>,
    /// Upscale photos that have fewer than 200 DPI at this size. They are listed on standard error.
    #[arg(long)]
    enlarge: bool,
    /// JPEG quality, also of pictures in PDF files and comics. [default: 90]
    #[arg(long, value_name = "1-100", value_parser = clap::value_parser!(u8).range(1..=100))]
    quality: Option<u8>,
}

/// Width and height of A4 in millimetres.
const A4: [f64; 2] = [210.0, 297.0];
/// Widest bleed in millimetres; a tenth of the page's width is the most in any case.
const MOST_BLEED: f64 = 25.0;

fn millimetres(text: &str) -> Result<f64, String> {
    let told = text.trim_end_matches("mm").trim().parse::<f64>().ok();
    told.filter(|told| (0.0..=MOST_BLEED).contains(told))
        .ok_or_else(|| format!("must be a number of millimetres from 0 to {MOST_BLEED}"))
}

fn imposition(name: &str) -> Result<Imposition, String> {
    let found = Imposition::ALL.iter().find(|(known, _)| *known == name);
    found.map(|(_, how)| *how).ok_or_else(|| {
        let names: Vec<&str> = Imposition::ALL.iter().map(|(known, _)| *known).collect();
        format!("must be one of {}", names.join(", "))
    })
}

fn sheet(text: &str) -> Result<[f64; 2], String> {
    if let Some(PagePreset { width, height, dpi, .. }) = layout::preset(text) {
        return Ok([width, height].map(|side| f64::from(side) / f64::from(dpi) * 25.4));
    }
    let sides: Option<Vec<f64>> = text.split('x').map(|side| side.parse().ok()).collect();
    match sides.as_deref() {
        Some(&[width, height]) if [width, height].iter().all(|side| (20.0..=5000.0).contains(side)) => {
            Ok([width, height])
        }
        _ => Err(format!(
            "expected WIDTHxHEIGHT in millimetres, such as 210x297, or one of {}",
            PaperSize::names()
        )),
    }
}

/// Fonts out of their files.
///
/// # Errors
/// A sentence with the name of a file that is not a font or is too large.
pub(crate) fn fonts(run: &Run, files: &[PathBuf]) -> Result<GivenFonts, CliError> {
    let mut fonts = GivenFonts::default();
    for path in files {
        let complain = |error: CliError| error.at(path.display());
        let file = run.read(path).map_err(complain)?;
        fonts.add(file).map_err(|reason| complain(reason.into()))?;
    }
    Ok(fonts)
}

impl Printing {
    /// Rejects PDF options for other file types.
    pub(crate) fn check(&self, format: Format) -> Result<(), CliError> {
        let told = [
            ("--bleed", self.bleed.is_some()),
            ("--marks", self.marks),
            ("--impose", self.impose.is_some()),
            ("--sheet", self.sheet.is_some()),
            ("--plates", self.plates),
        ];
        match told.iter().find(|(_, told)| *told) {
            Some((flag, _)) if format != Format::Pdf => {
                Err(format!("{flag} needs an output file .pdf").into())
            }
            _ if self.quality.is_some() && matches!(format, Format::Png | Format::Webp | Format::Project) => {
                Err("--quality needs an output file .jpg, .pdf, .html, .epub or .cbz".into())
            }
            _ => Ok(()),
        }
    }

    /// The fonts that are given.
    ///
    /// # Errors
    /// A sentence with the name of a file that is not a font or is too large.
    pub(crate) fn fonts(&self, run: &Run) -> Result<GivenFonts, CliError> {
        fonts(run, &self.font)
    }

    /// Resources to draw pages.
    pub(crate) fn means<'m>(
        &self,
        photos: &'m FullPhotos<'m>,
        fonts: &'m GivenFonts,
        masks: &'m Masks<'m>,
    ) -> Means<'m> {
        Means { run: masks.run, photos, fonts, masks, quality: self.quality(), enlarges: self.enlarge }
    }

    /// Returns the requested quality.
    fn quality(&self) -> u8 {
        self.quality.unwrap_or(QUALITY)
    }

    /// Returns the requested language.
    pub(crate) fn language(&self) -> &str {
        self.language.as_deref().unwrap_or("en")
    }

    /// Whether pages are put together in another way than one after the other.
    pub(crate) fn binds(&self) -> bool {
        self.impose.is_some()
    }

    fn options(&self, output: &Path, plate: Option<usize>) -> Options {
        Options {
            title: output.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default(),
            language: self.language().to_owned(),
            marks: self.marks,
            imposition: self.impose,
            // Eight pages at full size would be a poster, so a zine uses A4 by default.
            paper: self.sheet.or((self.impose == Some(Imposition::Zine)).then_some(A4)),
            plate,
            inks: Vec::new(),
        }
    }

    /// Returns the page with the requested bleed.
    fn bled(&self, document: &Document) -> Document {
        let mut page = document.clone();
        let width = f64::from(page.page.width) / f64::from(page.page.dpi.max(1)) * 25.4;
        page.page.bleed = (self.bleed.unwrap_or(0.0) / width).min(0.1);
        page
    }
}

/// How pages are printed, and what their photos show.
pub(crate) type Printed<'a> = (&'a Printing, &'a Subjects<'a>);

/// Writes pages as one PDF file, or also as one file per ink.
///
/// Returns the files.
pub(crate) fn write_book(
    documents: &[Document],
    means: &Means<'_>,
    output: &Output,
    (printing, subjects): Printed<'_>,
) -> Result<Vec<PathBuf>, CliError> {
    if printing.plates && is_standard(&output.path) {
        return Err("--plates writes one file per ink, so it needs --output with a file name".into());
    }
    let name = if printing.plates { &output.path } else { &output.named };
    let mut written = Vec::new();
    for (path, file) in draw_book(documents, means, name, (printing, subjects))? {
        let path = if printing.plates { path } else { output.path.clone() };
        write(&path, &file)?;
        written.push(path);
    }
    Ok(written)
}

/// Pages as PDF files whose title is the file's name: one, or one for each ink. Calls the function with each
/// page and its output path.
fn draw_book(
    documents: &[Document],
    means: &Means<'_>,
    output: &Path,
    (printing, subjects): Printed<'_>,
) -> Result<Vec<(PathBuf, Vec<u8>)>, CliError> {
    let letters = means.fonts.letters(documents.iter().flat_map(|page| &page.words))?;
    let documents: Vec<Document> = documents.iter().map(|document| printing.bled(document)).collect();
    if !printing.plates {
        let leaf = |document| leaf(document, means, (None, alts(document, subjects)));
        let leaves = documents.iter().map(leaf).collect::<Result<Vec<_>, _>>()?;
        let file = pdf::write(&leaves, &printing.options(output, None), &letters)?;
        return Ok(vec![(output.to_owned(), file)]);
    }
    let style = documents.first().ok_or("the document has no pages")?.style()?;
    let inks = plates::inks(&style).ok_or_else(|| {
        format!(
            "the style {} has no plates; choose a style with the block \"Inks (Printing Plates)\"",
            style.name
        )
    })?;
    let colours = plates::colours(&inks);
    let separation = Separation::new(&colours);
    if documents
        .iter()
        .any(|page| page.style().is_ok_and(|style| plates::inks(&style).as_ref() != Some(&inks)))
    {
        return Err("the pages have different inks; plates need one style for all pages".into());
    }
    let exact = documents.iter().map(plates::exact).collect::<Result<Vec<_>, _>>()?;
    let mut files = Vec::new();
    for (plate, ink) in inks.iter().enumerate() {
        let leaf = |document| leaf(document, means, (Some((&separation, plate)), alts(document, subjects)));
        let leaves = exact.iter().map(leaf).collect::<Result<Vec<_>, _>>()?;
        let stem = output.file_stem().map(|stem| stem.to_string_lossy()).unwrap_or_default();
        let path = output.with_file_name(format!("{stem}-{}.pdf", ink.name));
        let options = Options { inks: colours.clone(), ..printing.options(&path, Some(plate)) };
        let file = pdf::write(&leaves, &options, &letters)?;
        files.push((path, file));
    }
    Ok(files)
}

fn leaf(
    document: &Document,
    means: &Means<'_>,
    (plate, alts): (Option<(&Separation, usize)>, Vec<String>),
) -> Result<pdf::Leaf, CliError> {
    let (document, photos) = &prepared(document, means)?;
    Ok(native::leaf(document, photos, alts, (plate, means.quality))?)
}

/// Decodes the available photos of a page, in parallel.
pub(crate) fn decoded(document: &Document, means: &Means<'_>) -> Result<native::Photos, CliError> {
    let wanted = native::photos_of(document)?;
    let style = document.style()?;
    let read = |id: String| {
        let image = (means.photos)(&id).transpose()?;
        Some(image.map(|image| {
            let asked = native::is_styled(document, &id);
            let subject = asked.then(|| means.masks.asked_by_page(document, &style, &id, &image)).flatten();
            (id, native::Photo { image, subject })
        }))
    };
    wanted.into_par_iter().filter_map(read).collect()
}
