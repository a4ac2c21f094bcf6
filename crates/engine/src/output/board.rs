//! Storyboard sheets: the shots of an album as frames of one aspect ratio, with shot fields next to or under
//! each frame and a header on every sheet. A sheet is a normal page ([`Document`]), so drawing, export and
//! print need no special code. Its frames are panels. Its fields are plain captions, which stay text in a PDF
//! file.

use super::shots::{ListedShot, ShotList};
use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::layout::PageSettings;
use crate::page::document::PanelContent;
use crate::page::words::{TextItem, TextKind};
use crate::page::{Document, LayoutRef, StyleRef};
use serde::Deserialize;
use serde_json::{Value, json};

/// Most frames of a sheet.
const MOST_FRAMES: usize = 12;
/// Widths and heights of upright paper in millimetres.
const A4: (f64, f64) = (210.0, 297.0);
const LETTER: (f64, f64) = (215.9, 279.4);
/// Resolution in DPI.
const DPI: u32 = 300;
/// Around a sheet, between frames, and between a frame and its text, in millimetres.
const MARGIN: f64 = 11.0;
const GAP: f64 = 6.0;
const NEAR: f64 = 1.8;
/// Height of the header and of its text, in millimetres.
const HEAD: f64 = 11.0;
const TITLE: f64 = 4.9;
/// Width of the sheet number.
const NUMBER: f64 = 25.0;
/// Maximum width and height of a logo, in millimetres, and the maximum ratio of its sides.
const LOGO: (f64, f64) = (30.0, 9.0);
const FLATTEST: f64 = 30.0;
/// Offset of the header text next to a logo, which aligns their centres.
const LOWER: f64 = 2.8;
/// Minimum share of the cell height for the text below a frame, and maximum share of the cell width for a
/// frame with text next to it.
const UNDER: f64 = 0.27;
const BESIDE: f64 = 0.56;
/// Text height in millimetres by the maximum number of frames per sheet.
const LETTERS: [(usize, f64); 4] = [(2, 4.0), (4, 3.6), (6, 3.2), (MOST_FRAMES, 2.75)];
/// Half the width of the line around a frame, in millimetres.
const LINE: f64 = 0.35;
const INK: &str = "#111111";
const RULES: &str = "#a4a4a8";

/// Request of storyboard sheets. In JSON, the fields of a [`ShotList`] are in the same object.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BoardRequest", optional_fields))]
pub struct Request {
    /// The shots and the title.
    pub list: ShotList,
    /// The image of each shot.
    pub pictures: Vec<PictureOf>,
    /// Frames per sheet, 1 to 12. Default: 6.
    pub frames: usize,
    /// Width over height of the frames, 0.2 to 5. Default: 16:9.
    pub aspect: f64,
    /// Whether the fields are next to the frames instead of under them.
    pub beside: bool,
    /// Whether ruled lines replace the fields.
    pub ruled: bool,
    /// Who made it.
    pub author: String,
    /// When.
    pub date: String,
    /// Logo in the header of every sheet.
    pub logo: Option<Logo>,
    /// Whether the paper is US Letter instead of A4.
    pub letter: bool,
    /// The style of the frames: an id, or a style in full.
    #[cfg_attr(test, ts(as = "Option<crate::page::document::StyleChoice>"))]
    pub style: StyleRef,
    /// Labels of the fields, in the language of the reader.
    pub labels: Labels,
}

/// The image of a shot.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BoardPicture"))]
pub struct PictureOf {
    /// Id of the photo.
    pub photo: String,
    /// The crop of the frame.
    #[cfg_attr(test, ts(as = "Crop"))]
    pub crop: Option<Crop>,
    /// Faces of the photo, which the style protects.
    pub faces: Vec<Crop>,
}

/// The logo in the headers.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BoardLogo"))]
pub struct Logo {
    /// Photo id for the renderer.
    pub photo: String,
    /// Its width over its height; it is shown with 1/30 to 30.
    pub aspect: f64,
}

impl Logo {
    /// Its place on a sheet in millimetres.
    fn area(&self) -> Area {
        let aspect = self.aspect.clamp(1.0 / FLATTEST, FLATTEST);
        let width = LOGO.0.min(LOGO.1 * aspect);
        let height = width / aspect;
        Area { x: MARGIN, y: MARGIN + (LOGO.1 - height) / 2.0, width, height }
    }
}

/// Labels of the fields. `{page}` and `{count}` are placeholders for numbers.
#[derive(Debug, Clone, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BoardLabels", optional_fields))]
pub struct Labels {
    /// Before the scene.
    pub scene: String,
    /// Label of the dialogue.
    pub dialogue: String,
    /// Label of captions.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub caption: String,
    /// Label of sounds.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub sound: String,
    /// Before the notes.
    pub notes: String,
    /// Number of the sheet, and total number of sheets.
    pub page: String,
}

impl Default for Labels {
    fn default() -> Self {
        let [scene, dialogue, caption, sound, notes, page] =
            ["Scene", "Dialogue", "Caption", "Sound", "Notes", "Page {page} of {count}"].map(str::to_owned);
        Self { scene, dialogue, caption, sound, notes, page }
    }
}

impl Request {
    /// Reads a request.
    ///
    /// # Errors
    /// Returns `invalid-document` if the JSON is not a valid request.
    pub fn parse(json: &str) -> Result<Self> {
        serde_json::from_str(json).map_err(|error| invalid("board", &error.to_string()))
    }

    /// Returns the sheets as pages. Empty without shots.
    ///
    /// # Errors
    /// `invalid-document` for invalid images, a number of images other than the number of shots, or a logo
    /// without an aspect ratio; style errors.
    pub fn sheets(&self) -> Result<Vec<Document>> {
        if self.pictures.len() != self.list.shots.len() {
            return Err(invalid("pictures", "must have one entry per shot"));
        }
        if self.logo.as_ref().is_some_and(|logo| !(logo.aspect.is_finite() && logo.aspect > 0.0)) {
            return Err(invalid("logo.aspect", "must be a number above 0"));
        }
        let per_sheet = if self.frames == 0 { 6 } else { self.frames.min(MOST_FRAMES) };
        let grid = Grid::best(self, per_sheet);
        let count = self.list.shots.len().div_ceil(per_sheet);
        let shots = self.list.shots.chunks(per_sheet).zip(self.pictures.chunks(per_sheet));
        shots.enumerate().map(|(i, shots)| self.sheet(&grid, shots, (i + 1, count))).collect()
    }

    fn aspect(&self) -> f64 {
        if self.aspect.is_finite() && self.aspect > 0.0 { self.aspect.clamp(0.2, 5.0) } else { 16.0 / 9.0 }
    }

    fn sheet(
        &self,
        grid: &Grid,
        (shots, pictures): (&[ListedShot], &[PictureOf]),
        number: (usize, usize),
    ) -> Result<Document> {
        let mut words = self.head(grid, number);
        let mut polygons = Vec::new();
        let mut panels = Vec::new();
        for (i, (shot, picture)) in shots.iter().zip(pictures).enumerate() {
            let Cell { frame, text } = grid.cell(i);
            polygons.push(grid.polygon(&frame));
            panels.push(PanelContent {
                photo: Some(picture.photo.clone()),
                crop: picture.crop,
                faces: picture.faces.clone(),
                ..PanelContent::default()
            });
            words.extend(self.told(grid, shot, (i, &frame, &text)));
        }
        // After the frames, so that their indices do not change.
        if let Some(logo) = &self.logo {
            polygons.push(grid.polygon(&logo.area()));
            panels.push(PanelContent {
                photo: Some(logo.photo.clone()),
                plain: true,
                ..PanelContent::default()
            });
        }
        let pixels = |millimetres: f64| (millimetres / 25.4 * f64::from(DPI)).round();
        let layout = LayoutRef::from_file(json!({
            "id": "board", "name": "Board", "family": "board", "aspect": grid.width / grid.height, "polygons": polygons,
        }));
        let page = PageSettings {
            width: pixels(grid.width) as u32,
            height: pixels(grid.height) as u32,
            dpi: DPI,
            gutter: 0.0,
            margin: 0.0,
            border: LINE / grid.width,
            paper: "#ffffff".into(),
            border_color: INK.into(),
            ..PageSettings::default()
        };
        let order = pictures.iter().map(|picture| picture.photo.clone()).collect();
        Document { order, panels, words, ..Document::new(layout, self.style.clone(), page) }.validated()
    }

    /// Returns the header: title, author, date and sheet number, after the logo, if there is a logo.
    fn head(&self, grid: &Grid, (page, count): (usize, usize)) -> Vec<TextItem> {
        let wide = grid.width - 2.0 * MARGIN;
        let (left, lower) = match &self.logo {
            Some(logo) => ((logo.area().width + 2.0 * NEAR) / wide, LOWER),
            None => (0.0, 0.0),
        };
        let about = [&self.author, &self.date].into_iter().filter(|text| !text.is_empty());
        let about = about.cloned().collect::<Vec<_>>().join(" · ");
        let number =
            self.labels.page.replace("{page}", &page.to_string()).replace("{count}", &count.to_string());
        let word = |text: &str, from: f64, to: f64, size: f64, font: &str| {
            let area = Area {
                x: MARGIN + from * wide,
                y: MARGIN + TITLE - size + lower,
                width: (to - from) * wide,
                height: 1.6 * size,
            };
            (!text.is_empty()).then(|| {
                let word = grid.word(text, (&area, size), font);
                TextItem { x: Some(area.x / grid.width), y: Some(area.y / grid.height), ..word }
            })
        };
        let right = 1.0 - NUMBER / wide;
        let parts = [
            word(&self.list.title, left, 0.52, TITLE, BOLD),
            word(&about, 0.54, right - 0.02, 3.4, PLAIN),
            word(&number, right, 1.0, 3.4, PLAIN),
        ];
        parts.into_iter().flatten().collect()
    }

    /// The fields of a frame: number, scene and duration on one line, and the others below.
    fn told(
        &self,
        grid: &Grid,
        shot: &ListedShot,
        (panel, frame, text): (usize, &Area, &Area),
    ) -> Vec<TextItem> {
        let size = grid.letters;
        let rate = self.list.rate();
        let scene = (!shot.scene.is_empty()).then(|| format!("{} {}", self.labels.scene, shot.scene));
        let length = shot.frames.map(|frames| rate.timecode(u64::from(frames))[3..].to_owned());
        let head =
            [Some(shot.number.clone()), scene, length].into_iter().flatten().collect::<Vec<_>>().join("   ");
        let labelled = |label: &str, text: &str| format!("{label}: {text}");
        let known = [
            (&self.labels.dialogue, &shot.dialogue),
            (&self.labels.caption, &shot.caption),
            (&self.labels.sound, &shot.sound),
            (&self.labels.notes, &shot.notes),
        ];
        let known =
            known.into_iter().filter(|(_, text)| !text.is_empty()).map(|(label, text)| labelled(label, text));
        let own = self.list.columns.iter().filter_map(|name| Some(labelled(name, shot.more.get(name)?)));
        let action = std::iter::once(shot.action.clone());
        let fields: Vec<String> = action.chain(known).chain(own).filter(|text| !text.is_empty()).collect();
        let heading = Area { height: 1.3 * size, ..*text };
        let rest = Area { y: text.y + 1.5 * size, height: text.height - 1.5 * size, ..*text };
        // Text items are read with their frame.
        let word = |text: &str, area: &Area, font: &str| TextItem {
            panel: Some(panel),
            x: Some((area.x - frame.x) / frame.width),
            y: Some((area.y - frame.y) / frame.height),
            ..grid.word(text, (area, size), font)
        };
        let mut words = vec![word(&head, &heading, BOLD)];
        if self.ruled {
            words.push(TextItem { ruled: true, color: Some(RULES.into()), ..word("", &rest, PLAIN) });
        } else if !fields.is_empty() {
            words.push(word(&fields.join("\n"), &rest, PLAIN));
        }
        words
    }
}

const BOLD: &str = "comic-neue-bold";
const PLAIN: &str = "comic-neue";

/// A rectangle in millimetres of the paper.
#[derive(Debug, Clone, Copy)]
struct Area {
    x: f64,
    y: f64,
    width: f64,
    height: f64,
}

/// A frame and the place of its text.
struct Cell {
    frame: Area,
    text: Area,
}

/// The places of frames on paper, in millimetres.
#[derive(Debug, Clone, Copy)]
struct Grid {
    width: f64,
    height: f64,
    columns: usize,
    cell: (f64, f64),
    frame: (f64, f64),
    beside: bool,
    /// Height of the text.
    letters: f64,
}

impl Grid {
    /// The paper, and the columns and rows on it, that make the frames largest.
    fn best(request: &Request, frames: usize) -> Self {
        let paper = if request.letter { LETTER } else { A4 };
        let all = [(paper.1, paper.0), paper].into_iter().flat_map(|(width, height)| {
            let columns = (1..=frames).filter(move |columns| frames.is_multiple_of(*columns));
            columns.map(move |columns| Self::new(request, frames, (width, height), columns))
        });
        let area = |grid: &Self| grid.frame.0 * grid.frame.1;
        // If two grids are equally good, the first one wins: landscape, like screens.
        let better = |best: Self, grid: Self| if area(&grid) > 1.02 * area(&best) { grid } else { best };
        let first = Self::new(request, frames, (paper.1, paper.0), frames);
        all.fold(first, better)
    }

    fn new(request: &Request, frames: usize, (width, height): (f64, f64), columns: usize) -> Self {
        let rows = frames.div_ceil(columns);
        let part = |length: f64, count: usize| (length - GAP * (count as f64 - 1.0)) / count as f64;
        let cell = (part(width - 2.0 * MARGIN, columns), part(height - 2.0 * MARGIN - HEAD, rows));
        let letters =
            LETTERS.iter().find(|(most, _)| frames <= *most).map_or(LETTERS[3].1, |(_, size)| *size);
        let room = if request.beside {
            (cell.0 * BESIDE, cell.1)
        } else {
            (cell.0, cell.1 - NEAR - (cell.1 * UNDER).max(5.0 * letters))
        };
        let across = room.0.min(room.1 * request.aspect()).max(1.0);
        let frame = (across, across / request.aspect());
        Self { width, height, columns, cell, frame, beside: request.beside, letters }
    }

    fn cell(&self, index: usize) -> Cell {
        let (column, row) = ((index % self.columns) as f64, (index / self.columns) as f64);
        let (x, y) = (MARGIN + column * (self.cell.0 + GAP), MARGIN + HEAD + row * (self.cell.1 + GAP));
        let frame = Area { x, y, width: self.frame.0, height: self.frame.1 };
        let text = if self.beside {
            let off = self.frame.0 + 2.0 * NEAR;
            Area { x: x + off, y, width: self.cell.0 - off, height: self.cell.1 }
        } else {
            let off = self.frame.1 + NEAR;
            Area { x, y: y + off, width: self.cell.0, height: self.cell.1 - off }
        };
        Cell { frame, text }
    }

    /// An area as a panel of a layout.
    fn polygon(&self, area: &Area) -> Value {
        let corner = |x: f64, y: f64| json!([x / self.width, y / self.height]);
        let (right, bottom) = (area.x + area.width, area.y + area.height);
        json!([corner(area.x, area.y), corner(right, area.y), corner(right, bottom), corner(area.x, bottom)])
    }

    /// A plain caption without a place.
    fn word(&self, text: &str, (area, size): (&Area, f64), font: &str) -> TextItem {
        TextItem {
            plain: true,
            auto: Some(false),
            font: Some(font.into()),
            color: Some(INK.into()),
            fill: Some("#ffffff".into()),
            size: Some(size / self.width),
            room: Some(((area.width / self.width).max(0.02), (area.height / self.width).max(0.02))),
            ..TextItem::new(TextKind::Caption, text)
        }
    }
}

fn invalid(location: &str, reason: &str) -> Error {
    Error::InvalidDocument { location: location.into(), reason: reason.into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::scene::Scene;
    use crate::page::words::Letters;
    use crate::page::words::layout::measured;

    fn request(frames: usize, aspect: f64, shots: usize) -> Request {
        let shot = |i: usize| ListedShot {
            number: format!("{}", i + 1),
            scene: "2".into(),
            action: "She opens the door, looks along the corridor, and steps out. ".repeat(1 + i % 4),
            dialogue: "Is anybody there?".into(),
            frames: Some(48),
            ..ListedShot::default()
        };
        let crop = Some(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 });
        let picture = |i: usize| PictureOf { photo: format!("p{i}"), crop, faces: Vec::new() };
        Request {
            list: ShotList {
                title: "Night".into(),
                shots: (0..shots).map(shot).collect(),
                ..ShotList::default()
            },
            pictures: (0..shots).map(picture).collect(),
            frames,
            aspect,
            style: "storyboard".into(),
            author: "Ann".into(),
            ..Request::default()
        }
    }

    #[test]
    fn dialogue_captions_and_sounds_have_labels() {
        let mut request = request(1, 1.0, 1);
        let shot = &mut request.list.shots[0];
        (shot.action, shot.caption, shot.sound) = ("She turns.".into(), "Later".into(), "BANG".into());
        let sheet = request.sheets().unwrap().remove(0);
        let text = sheet.words.iter().find(|word| word.text.contains("Later")).unwrap();
        assert_eq!(text.text, "She turns.\nDialogue: Is anybody there?\nCaption: Later\nSound: BANG");
    }

    #[test]
    fn frames_have_their_aspect_and_texts_stay_on_the_sheet_and_off_the_frames() {
        let letters = Letters::bundled().unwrap();
        for frames in [1, 2, 3, 4, 6, 8, 9, 12] {
            for aspect in [2.39, 1.85, 16.0 / 9.0, 4.0 / 3.0, 1.0, 9.0 / 16.0] {
                for beside in [false, true] {
                    let request = Request { beside, ..request(frames, aspect, frames + 1) };
                    let sheets = request.sheets().unwrap();
                    assert_eq!((sheets.len(), sheets[1].panels.len()), (2, 1));
                    let scene = Scene::new(&sheets[0], 3000).unwrap();
                    let (width, height) = (1.0, scene.height as f64 / scene.width as f64);
                    let bounds: Vec<_> = scene.panels.iter().map(|panel| panel.image_bounds).collect();
                    for panel in &bounds {
                        assert!(
                            (panel.width / panel.height / aspect - 1.0).abs() < 0.01,
                            "{frames} {aspect}"
                        );
                    }
                    for word in measured(&sheets[0], &letters).unwrap() {
                        assert!(
                            word.x > 0.0
                                && word.y > 0.0
                                && word.x + word.width < width
                                && word.y + word.height < height,
                            "{frames} {aspect} {beside}: {word:?}"
                        );
                        let over = |panel: &crate::layout::Bounds| {
                            let shared = |a: f64, al: f64, b: f64, bl: f64| (a + al).min(b + bl) - a.max(b);
                            shared(word.x * 3000.0, word.width * 3000.0, panel.x, panel.width) > 1.0
                                && shared(word.y * 3000.0, word.height * 3000.0, panel.y, panel.height) > 1.0
                        };
                        assert!(!bounds.iter().any(over), "{frames} {aspect} {beside}: {word:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_logo_stands_whole_in_the_head_off_title_and_frames() {
        let letters = Letters::bundled().unwrap();
        for frames in [1, 2, 3, 4, 6, 8, 9, 12] {
            for (letter, aspect) in [(false, 2.39), (true, 16.0 / 9.0), (false, 9.0 / 16.0)] {
                for shape in [0.001, 0.3, 1.0, 600.0 / 264.0, 8.0, 1000.0] {
                    let logo = Logo { photo: "logo".into(), aspect: shape };
                    let plain = Request { letter, ..request(frames, aspect, frames) };
                    let request = Request { logo: Some(logo), ..plain.clone() };
                    let [sheet] = &request.sheets().unwrap()[..] else { panic!("one sheet") };
                    let scene = Scene::new(sheet, 3000).unwrap();
                    let without = Scene::new(&plain.sheets().unwrap()[0], 3000).unwrap();
                    // Frames are where they were, and lines in them as thick.
                    assert_eq!((scene.panels.len(), scene.scale), (frames + 1, without.scale));
                    for (frame, before) in scene.panels.iter().zip(&without.panels) {
                        assert_eq!((&frame.shape, frame.plain), (&before.shape, false));
                    }
                    let panel = &scene.panels[frames];
                    assert!(panel.plain && panel.photo.as_deref() == Some("logo"));
                    let bounds = panel.image_bounds;
                    let shown = shape.clamp(1.0 / FLATTEST, FLATTEST);
                    assert!((bounds.width / bounds.height / shown - 1.0).abs() < 0.01, "{shape}");
                    let millimetre = 3000.0 / Grid::best(&request, frames).width;
                    let of = |millimetres: f64| millimetres * millimetre;
                    // The page has a whole number of pixels.
                    assert!((bounds.x - of(MARGIN)).abs() < 1.0 && bounds.y > of(MARGIN) - 1.0);
                    assert!(bounds.width < of(LOGO.0) + 1.0 && bounds.height < of(LOGO.1) + 1.0);
                    for frame in &scene.panels[..frames] {
                        assert!(frame.image_bounds.y - of(LINE) > bounds.y + bounds.height);
                    }
                    let frames_top = scene.panels[0].image_bounds.y - of(LINE);
                    for word in measured(sheet, &letters).unwrap() {
                        if word.y * 3000.0 < frames_top {
                            assert!((word.y + word.height) * 3000.0 < frames_top, "{frames}: {word:?}");
                        }
                        let right = bounds.x + bounds.width;
                        assert!(
                            word.x * 3000.0 > right || word.y * 3000.0 > bounds.y + bounds.height,
                            "{frames} {shape}: {word:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_worksheet_has_lines_in_the_place_of_what_is_told() {
        let sheets = Request { ruled: true, ..request(4, 1.85, 4) }.sheets().unwrap();
        assert_eq!(sheets[0].words.iter().filter(|word| word.ruled).count(), 4);
        assert!(!sheets[0].to_json().contains("corridor"));
        assert!(sheets[0].to_json().contains("Page 1 of 1"));
    }

    #[test]
    fn what_is_no_board_is_refused() {
        assert!(Request::parse("{\"frames\":-1}").is_err());
        assert!(Request { pictures: Vec::new(), ..request(1, 1.0, 1) }.sheets().is_err());
        for aspect in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let logo = Some(Logo { photo: "logo".into(), aspect });
            assert!(Request { logo, ..request(1, 1.0, 1) }.sheets().is_err());
        }
        assert!(request(6, f64::NAN, 0).sheets().unwrap().is_empty());
    }
}
