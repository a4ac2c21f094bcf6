//! Plans of the command line: makes pages, writes them as JSON, reads and scores them.

use crate::destination::{Output, print_lines};
use crate::format::Format;
use crate::input::name;
use crate::photos::{BY_CONTRAST, Photos};
use crate::run::{Run, is_standard};
use crate::{CliError, drawing, report};
use inkpanel_engine::framing::{Crop, PhotoMeta};
use inkpanel_engine::layout::{self, Bounds, PageSettings, Point, ResolvedPanel, ResolvedShape, polygon};
use inkpanel_engine::page::shuffle::Planned;
use inkpanel_engine::page::{Document, breaking};
use inkpanel_engine::plan::composer::{gallery, judge};
use inkpanel_engine::plan::slots::slot;
use inkpanel_engine::plan::{Assignment, Candidate, Score, Shelf, layouts};
use serde_json::{Map, Value, json};
use std::collections::HashSet;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Number of corners of a circle in JSON.
const CORNERS: usize = 64;
/// Most panels and pages that a plan may have.
const MOST_PANELS: usize = 200;
const MOST_PAGES: usize = 1000;

/// Returns the plan as JSON, in the format of `docs/reference/formats.md`.
///
/// `planned`: the pages before edits. A page that was edited has no score.
pub(crate) fn told(pages: &[Document], planned: &[Planned], photos: &Photos<'_>) -> Result<Value, CliError> {
    let score = |page: &Document| {
        planned.iter().find(|planned| planned.document == *page).map(|planned| &planned.score)
    };
    let pages =
        pages.iter().map(|page| told_page(page, score(page), photos)).collect::<Result<Vec<_>, _>>()?;
    Ok(json!({ "pages": pages }))
}

pub(crate) fn told_page(
    document: &Document,
    score: Option<&Score>,
    photos: &Photos<'_>,
) -> Result<Value, CliError> {
    let template = document.template()?;
    let aspect = document.page.aspect();
    let resolved = layout::resolve(&template, aspect, &document.page);
    let file = |id: &String| photos.find(id).map(|(path, _)| path.display().to_string());
    let breaks = breaking::breaks(document)?;
    let panels: Vec<Value> = resolved
        .iter()
        .zip(&document.panels)
        .enumerate()
        .map(|(i, (panel, content))| {
            json!({
                "photo": content.photo.as_ref().and_then(file),
                "crop": content.crop,
                "shape": outline(&panel.shape, aspect),
                "group": document.merges.iter().position(|group| group.contains(&i)),
                "breaks_frame": breaks[i],
                "halo": rounded(panel.halo),
            })
        })
        .collect();
    let mut told = json!({
        "layout": document.layout.id(),
        "style": document.style.id(),
        "score": score.map(|score| rounded(score.total())),
        "terms": score.map(terms),
        "page": { "width": document.page.width, "height": document.page.height },
        "panels": panels,
    });
    if let Some(why) = repeats(document) {
        told["why"] = json!(why);
    }
    Ok(told)
}

/// Returns the reason if photos repeat.
fn repeats(document: &Document) -> Option<String> {
    let leads = |i: usize| document.merge_of(i).is_none_or(|group| group.first() == Some(&i));
    let shown: Vec<&String> = document
        .panels
        .iter()
        .enumerate()
        .filter(|(i, _)| leads(*i))
        .filter_map(|(_, panel)| panel.photo.as_ref())
        .collect();
    let mut different = shown.clone();
    different.sort_unstable();
    different.dedup();
    let (photos, panels) = (different.len(), shown.len());
    (photos < panels).then(|| format!("photos repeat: {photos} photos for {panels} panels"))
}

fn terms(score: &Score) -> Value {
    score
        .terms()
        .iter()
        .map(|(term, value)| ((*term).to_owned(), json!(rounded(*value))))
        .collect::<Map<_, _>>()
        .into()
}

fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// An outline in fractions of the page.
fn outline(shape: &ResolvedShape, aspect: f64) -> Value {
    let corners: Vec<Point> = match shape {
        ResolvedShape::Polygon(corners) => corners.clone(),
        ResolvedShape::Circle { center, radius } => (0..CORNERS)
            .map(|i| i as f64 / CORNERS as f64 * std::f64::consts::TAU)
            .map(|angle| Point::new(center.x + radius * angle.cos(), center.y + radius * angle.sin()))
            .collect(),
    };
    corners.iter().map(|p| json!([rounded(p.x), rounded(p.y * aspect)])).collect()
}

/// Judges the pages of a plan that was made here or elsewhere. Photos are searched by name in the working
/// folder and in the folder of the plan.
pub(crate) fn score(run: &Run, asked: &ScoreArgs) -> Result<(), CliError> {
    let file = asked.plan.as_path();
    let complain = |error: CliError| error.at(file.display());
    let invalid = |reason: String| complain(CliError::new("invalid-document", reason));
    let text = run.text(file).map_err(complain)?;
    let plan: Value = serde_json::from_str(&text).map_err(|error| complain(CliError::not_json(error)))?;
    let pages = plan["pages"].as_array().ok_or_else(|| invalid("has no list of \"pages\"".into()))?;
    if pages.len() > MOST_PAGES {
        return Err(invalid(format!("has more than {MOST_PAGES} pages")));
    }
    let mut files: Vec<PathBuf> = Vec::new();
    for panel in pages.iter().filter_map(|page| page["panels"].as_array()).flatten() {
        let path = panel["photo"].as_str().map(|photo| located(Path::new(photo), file));
        files.extend(path.filter(|path| !files.contains(path)));
    }
    let mut photos = Photos::read(run, files)?;
    if !asked.no_detect {
        photos.add_subjects(asked.models.as_deref(), BY_CONTRAST);
    }
    let metas = photos.metas();
    let (mut told, mut lines) = (Vec::new(), Vec::new());
    for (number, page) in pages.iter().enumerate() {
        let at = |reason: String| invalid(format!("page {}: {reason}", number + 1));
        let known = |photo: &str| photos.iter().position(|(path, _)| path == located(Path::new(photo), file));
        let score = judged(page, &metas, &known).map_err(at)?;
        if asked.json {
            told.push(json!({
                "layout": page["layout"], "score": rounded(score.total()), "terms": terms(&score),
            }));
        } else {
            let terms: Vec<String> =
                score.terms().iter().map(|(term, value)| format!("{term} {value:.2}")).collect();
            lines.push(format!("page {}  {:.2}  {}", number + 1, score.total(), terms.join(", ")));
        }
    }
    if asked.json {
        return crate::destination::print_json(&json!({ "pages": told }));
    }
    print_lines(lines)
}

fn located(photo: &Path, plan: &Path) -> PathBuf {
    let beside = plan.parent().unwrap_or(Path::new("")).join(photo);
    if photo.is_file() || !beside.is_file() { photo.to_owned() } else { beside }
}

fn judged(page: &Value, metas: &[PhotoMeta], known: &dyn Fn(&str) -> Option<usize>) -> Result<Score, String> {
    let side = |name: &str| page["page"][name].as_f64().filter(|side| (1.0..=1e5).contains(side));
    let (Some(width), Some(height)) = (side("width"), side("height")) else {
        return Err("\"page\" must have a width and a height in pixels".into());
    };
    let told = page["panels"].as_array().ok_or("has no list of \"panels\"")?;
    let looked_at =
        PageSettings { width: width as u32, height: height as u32, ..PageSettings::default() }.looked_at();
    if told.is_empty() || told.len() > MOST_PANELS {
        return Err(format!("must have from 1 to {MOST_PANELS} panels"));
    }
    let panels = told
        .iter()
        .enumerate()
        .map(|(i, panel)| {
            resolved(panel, height / width)
                .ok_or(format!("panel {}: \"shape\" must be a convex polygon", i + 1))
        })
        .collect::<Result<Vec<_>, _>>()?;
    let group_of = |i: usize| -> Vec<usize> {
        let Some(group) = told[i]["group"].as_u64() else { return vec![i] };
        (0..told.len()).filter(|&other| told[other]["group"].as_u64() == Some(group)).collect()
    };
    let (mut slots, mut assigned) = (Vec::new(), Vec::new());
    for (i, panel) in told.iter().enumerate() {
        let group = group_of(i);
        let Some(photo) = panel["photo"].as_str().filter(|_| group[0] == i) else { continue };
        let at = known(photo).ok_or_else(|| format!("panel {}: {photo} cannot be read", i + 1))?;
        let crop: Crop = serde_json::from_value(panel["crop"].clone())
            .ok()
            .filter(|crop: &Crop| [crop.x, crop.y].iter().all(|at| (-1e-6..=1.0).contains(at)))
            .filter(|crop| [crop.width, crop.height].iter().all(|side| (1e-6..=1.0 + 1e-6).contains(side)))
            .ok_or_else(|| format!("panel {}: \"crop\" must lie inside of the photo", i + 1))?;
        slots.extend(slot(&panels, &group, looked_at, true));
        assigned.push(Assignment { photo: at, crop });
    }
    if slots.is_empty() {
        return Err("shows no photo".into());
    }
    // Only the photos of the page are available.
    let mut own: Vec<usize> = assigned.iter().map(|panel| panel.photo).collect();
    own.sort_unstable();
    own.dedup();
    let album: Vec<PhotoMeta> = own.iter().map(|&i| metas[i].clone()).collect();
    for panel in &mut assigned {
        panel.photo = own.iter().position(|&i| i == panel.photo).unwrap_or(0);
    }
    let shelf = Shelf::new(album.len());
    let photos = gallery(&album, &shelf);
    let template = page["layout"].as_str().and_then(|id| layout::find(id).ok());
    let prior = template.map_or(0.5, |template| layouts::weight(template.family()));
    Ok(judge(&Candidate { slots, prior, layout: 0, family: "" }, &assigned, &photos))
}

/// A panel of a plan, in page widths.
fn resolved(panel: &Value, height: f64) -> Option<ResolvedPanel> {
    let corner = |corner: &Value| {
        let (x, y) = (corner.get(0)?.as_f64()?, corner.get(1)?.as_f64()?);
        ((-1.0..=2.0).contains(&x) && (-1.0..=2.0).contains(&y)).then(|| Point::new(x, y * height))
    };
    let corners = panel["shape"].as_array()?;
    if corners.len() > 1000 {
        return None;
    }
    let corners = polygon::normalised(&corners.iter().map(corner).collect::<Option<Vec<_>>>()?)?;
    let bounds = Bounds::of(&corners);
    let halo = panel["halo"].as_f64().filter(|halo| (0.0..=0.2).contains(halo)).unwrap_or(0.0);
    let weight = polygon::area(&corners) as f32;
    Some(ResolvedPanel { shape: ResolvedShape::Polygon(corners), bounds, weight, overlay: false, halo })
}

/// Makes of the file of a page, by its number from 0, what is written.
pub(crate) type Finish<'f> = &'f dyn Fn(usize, Vec<u8>) -> Result<Vec<u8>, CliError>;

/// How pages become files.
pub(crate) struct Files<'a> {
    /// Whether existing files are skipped.
    pub(crate) skips: bool,
    pub(crate) finish: Finish<'a>,
    pub(crate) printed: drawing::Printed<'a>,
}

/// Draws pages into one file, or into one file per page if its name has a number placeholder, as in
/// `page-%02d.png`.
///
/// Returns the files.
pub(crate) fn draw_all(
    documents: &[Document],
    means: &drawing::Means<'_>,
    output: &Output,
    how: &Files<'_>,
) -> Result<Vec<PathBuf>, CliError> {
    let kind = Format::of(&output.named)?;
    if kind == Format::Project {
        return Err("a project needs photos; --document pages cannot become a project".into());
    }
    if kind == Format::Pdf {
        return drawing::write_book(documents, means, output, how.printed);
    }
    if is_standard(&output.path) {
        return Err("standard output takes several pages only as one PDF file; add --format pdf".into());
    }
    let mut files = Vec::new();
    for (i, document) in documents.iter().enumerate() {
        let own = Output { path: numbered(&output.path, i + 1), named: numbered(&output.named, i + 1) };
        let there = how.skips && own.exists();
        if !there {
            own.write(&(how.finish)(i, drawing::draw(document, means, &own.named)?)?)?;
        }
        let file = name(&own.path);
        let event = json!({
            "event": if there { "skipped" } else { "page" },
            "page": i + 1, "of": documents.len(), "file": own.path.display().to_string(),
        });
        let more = if there { ", skipped" } else { "" };
        means.run.report.step(&event, Some(format!("{} of {}: {file}{more}", i + 1, documents.len())));
        files.push(own.path);
    }
    Ok(files)
}

/// Finds the first number's place in the name of a file, `%d` or `%02d`. Returns its bytes, and the minimum number of digits.
fn number_place(text: &str) -> Option<(Range<usize>, usize)> {
    text.match_indices('%').find_map(|(from, _)| {
        let digits: String = text[from + 1..].chars().take_while(char::is_ascii_digit).take(2).collect();
        let to = from + 1 + digits.len();
        text[to..].starts_with('d').then(|| (from..to + 1, digits.parse().unwrap_or(0).min(9)))
    })
}

/// Whether a name has a number placeholder.
pub(crate) fn has_number(output: &Path) -> bool {
    number_place(name(output)).is_some()
}

/// Whether the files of all pages exist.
pub(crate) fn all_exist(output: &Output, pages: usize) -> bool {
    let own = |number| Output { path: numbered(&output.path, number), named: output.named.clone() };
    (1..=pages).all(|number| own(number).exists())
}

/// File name of a page: the number replaces `%d` or `%02d`, or precedes the extension.
fn numbered(output: &Path, number: usize) -> PathBuf {
    let file = name(output);
    let place = |text: &str| {
        let (at, width) = number_place(text)?;
        Some(format!("{}{number:0width$}{}", &text[..at.start], &text[at.end..]))
    };
    let ending = output.extension().map(|e| e.to_string_lossy().into_owned()).unwrap_or_default();
    let stem = output.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    output.with_file_name(place(file).unwrap_or_else(|| format!("{stem}-{number:02}.{ending}")))
}

/// Reports differences from the request: another number of panels, photos that are used twice, photos on no
/// page.
pub(crate) fn tell_differences(
    pages: &[Planned],
    wanted: Option<usize>,
    used: &[String],
    photos: &Photos<'_>,
) {
    let report = &photos.run.report;
    for (i, page) in pages.iter().enumerate() {
        let of = if pages.len() > 1 { format!("page {}: ", i + 1) } else { String::new() };
        let panels = page.document.panels.len();
        if let Some(wanted) = wanted.filter(|wanted| *wanted != panels) {
            report.note(None, &format!("{of}{panels} panels instead of {wanted}"));
        }
        if let Some(why) = repeats(&page.document) {
            report.note(None, &format!("{of}{why}"));
        }
    }
    let shown: HashSet<&str> = pages
        .iter()
        .flat_map(|page| page.document.panels.iter().filter_map(|panel| panel.photo.as_deref()))
        .collect();
    let unseen: Vec<&str> = photos
        .iter()
        .filter(|(_, photo)| used.contains(&photo.meta.id))
        .filter(|(_, photo)| !shown.contains(photo.meta.id.as_str()))
        .map(|(path, _)| name(path))
        .collect();
    if !unseen.is_empty() {
        let (count, of, some) = (unseen.len(), used.len(), report::some(&unseen));
        report.note(None, &format!("{count} of {of} photos have no panel: {some}"));
    }
}

/// Arguments of `inkpanel score`.
#[derive(clap::Args)]
pub(crate) struct ScoreArgs {
    /// Plan file, as printed by `render --json`.
    pub(crate) plan: PathBuf,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
    /// Skip face and object detection.
    #[arg(long)]
    pub(crate) no_detect: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_numbered_where_the_name_says() {
        let named = |name: &str| numbered(Path::new(name), 7).display().to_string();
        assert_eq!(named("out/page-%02d.png"), "out/page-07.png");
        assert_eq!(named("%dx.png"), "7x.png");
        assert_eq!(named("out/book.png"), "out/book-07.png");
        assert_eq!(named("100%.png"), "100%-07.png");
    }

    #[test]
    fn a_shape_that_is_no_polygon_is_refused() {
        for shape in
            [json!(null), json!([[0, 0], [1, 1]]), json!([[0, 0], [1, 1], [0, 1], [1, 0]]), json!([[0, "a"]])]
        {
            assert!(resolved(&json!({ "shape": shape }), 1.4).is_none());
        }
        let square = json!({ "shape": [[0.1, 0.1], [0.5, 0.1], [0.5, 0.5], [0.1, 0.5]] });
        let panel = resolved(&square, 1.4).unwrap();
        assert!((panel.bounds.aspect() - 1.0 / 1.4).abs() < 1e-9);
    }
}
