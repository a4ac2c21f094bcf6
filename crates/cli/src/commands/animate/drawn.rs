//! Content and pixels of frames: the image of a shot with its caption, or a page with its visible text and
//! dimmed panels.

use crate::CliError;
use inkpanel_engine::framing::Crop;
use inkpanel_engine::layout::Point;
use inkpanel_engine::output::reading::Told;
use inkpanel_engine::page::Patch;
use inkpanel_engine::page::compose::Sheet;
use inkpanel_engine::page::coverage::{Contour, coverage};
use inkpanel_engine::page::rect::PixelRect;
use inkpanel_engine::raster::resize::{Region, resample, resample_image};
use inkpanel_engine::raster::{Image, Plane};

/// Colour around a page, and of the dimming.
const GROUND: [u8; 3] = [0x15, 0x15, 0x1a];
/// Darkness of the dimmed parts.
const VEIL: f64 = 0.8;

/// A clip as frames are made of it.
pub(super) enum Drawn {
    /// The image of a shot, and its caption at its position in the frame.
    Shot(Image, Option<Patch>),
    /// A page that is read.
    Page(Page),
}

impl Drawn {
    /// The pixels of a frame, as RGB.
    pub(super) fn seen(&self, view: &Crop, told: &Told, size: [usize; 2]) -> Result<Vec<u8>, CliError> {
        match self {
            Self::Shot(picture, None) => Ok(filled(picture, view, size)),
            Self::Shot(picture, Some(caption)) => {
                let mut sheet = Sheet::of(size[0], size[1], filled(picture, view, size));
                sheet.lay(caption.area, &caption.rgba)?;
                Ok(sheet.into_rgb())
            }
            Self::Page(page) => Ok(page.seen(view, told, size)),
        }
    }
}

/// The part of a picture that fills a frame. If that is the whole image, it is copied exactly.
fn filled(picture: &Image, view: &Crop, [width, height]: [usize; 2]) -> Vec<u8> {
    let (wide, high) = (picture.width() as f64, picture.height() as f64);
    let region =
        Region { x: view.x * wide, y: view.y * high, width: view.width * wide, height: view.height * high };
    let whole = Region::whole(width, height);
    if (picture.width(), picture.height()) == (width, height) && region == whole {
        return picture.to_rgb();
    }
    resample_image(picture, region, width, height).to_rgb()
}

/// A page in the layers that a frame is made of.
pub(super) struct Page {
    sheet: Plate,
    /// In paint order.
    words: Vec<Word>,
    /// The outline of each panel, in fractions of the page.
    panels: Vec<Vec<(f64, f64)>>,
}

/// A text item of an animated page.
struct Word {
    plate: Plate,
    /// Number of text items that appear before it.
    turn: usize,
    /// The panel that it is read with.
    panel: usize,
}

impl Page {
    /// `across`: maximum number of page pixels per frame pixel.
    pub(super) fn new(sheet: &Sheet, panels: Vec<Vec<(f64, f64)>>, across: f64) -> Self {
        let (width, height) = (sheet.width(), sheet.height());
        let page = PixelRect { x: 0, y: 0, width, height };
        // Interpolation needs two pixels of margin.
        let room = across.ceil() as usize + 2;
        let sheet = Plate::new::<3>(sheet.rgb(), page, (room, GROUND), [width, height]);
        Self { sheet, words: Vec::new(), panels }
    }

    /// Adds a text item on top of the previous ones. `turn` items appear before it, and it belongs to a
    /// panel.
    pub(super) fn add(&mut self, patch: &Patch, (turn, panel): (usize, usize)) {
        let mut rgba = patch.rgba.clone();
        for pixel in rgba.as_chunks_mut::<4>().0 {
            let alpha = u32::from(pixel[3]);
            for colour in &mut pixel[..3] {
                *colour = ((u32::from(*colour) * alpha + 127) / 255) as u8;
            }
        }
        let plate = Plate::new::<4>(&rgba, patch.area, (self.sheet.room, [0; 4]), self.sheet.page);
        self.words.push(Word { plate, turn, panel });
    }

    fn seen(&self, view: &Crop, told: &Told, size: [usize; 2]) -> Vec<u8> {
        let mut frame = Frame { rgb: GROUND.repeat(size[0] * size[1]), size, view: *view };
        frame.lay(&self.sheet, 1.0);
        self.say(&mut frame, told, false);
        if told.veil > 0.0 {
            let outline = told.panel.and_then(|panel| self.panels.get(panel));
            frame.veil(outline.map_or(&[], Vec::as_slice), told.veil * VEIL);
        }
        // Text of the current panel is above the dimming, even outside of the panel.
        self.say(&mut frame, told, true);
        frame.rgb
    }

    /// Draws the visible text: of the current panel, or all other text.
    fn say(&self, frame: &mut Frame, told: &Told, read: bool) {
        for Word { plate, turn, panel } in &self.words {
            let there = (told.words - *turn as f64).clamp(0.0, 1.0);
            if there > 0.0 && (told.panel == Some(*panel)) == read {
                frame.lay(plate, there);
            }
        }
    }
}

/// An image with its position on a page, and a transparent margin for smooth edges.
struct Plate {
    /// Red, green and blue, and optionally alpha. The colours are premultiplied.
    planes: Vec<Plane>,
    /// Bounds with the margin, in pixels of the page.
    place: Region,
    room: usize,
    /// Sides of the page in pixels.
    page: [usize; 2],
}

impl Plate {
    fn new<const C: usize>(
        pixels: &[u8],
        area: PixelRect,
        (room, nothing): (usize, [u8; C]),
        page: [usize; 2],
    ) -> Self {
        let (width, height) = (area.width + 2 * room, area.height + 2 * room);
        let plane = |channel: usize| {
            let mut plane = Plane::filled(width, height, nothing[channel]);
            for (y, row) in pixels.chunks_exact(area.width * C).enumerate() {
                let places = &mut plane.row_mut(y + room)[room..room + area.width];
                for (place, pixel) in places.iter_mut().zip(row.as_chunks::<C>().0) {
                    *place = pixel[channel];
                }
            }
            plane
        };
        let place = Region {
            x: area.x as f64 - room as f64,
            y: area.y as f64 - room as f64,
            width: width as f64,
            height: height as f64,
        };
        Self { planes: (0..C).map(plane).collect(), place, room, page }
    }
}

/// A frame that is being drawn.
struct Frame {
    rgb: Vec<u8>,
    size: [usize; 2],
    /// The visible part of the page, in fractions of the page.
    view: Crop,
}

impl Frame {
    /// Draws a plate with an opacity of 0 to 1.
    fn lay(&mut self, plate: &Plate, share: f64) {
        let Crop { x, y, width, height } = self.view;
        let along = |axis: usize, (from, length): (f64, f64), (start, long): (f64, f64)| {
            stretch(self.size[axis], plate.page[axis] as f64, (from, length), (start, long))
        };
        let Some((left, wide, source_x)) = along(0, (x, width), (plate.place.x, plate.place.width)) else {
            return;
        };
        let Some((top, high, source_y)) = along(1, (y, height), (plate.place.y, plate.place.height)) else {
            return;
        };
        let region = Region { x: source_x.0, y: source_y.0, width: source_x.1, height: source_y.1 };
        let planes: Vec<Plane> =
            plate.planes.iter().map(|plane| resample(plane, region, wide, high)).collect();
        let share = (share * 256.0).round() as u32;
        for row in 0..high {
            let start = ((top + row) * self.size[0] + left) * 3;
            let pixels = self.rgb[start..start + wide * 3].as_chunks_mut::<3>().0;
            let rows: Vec<&[u8]> = planes.iter().map(|plane| plane.row(row)).collect();
            for (i, pixel) in pixels.iter_mut().enumerate() {
                let there = rows.get(3).map_or(255, |alpha| u32::from(alpha[i])) * share;
                for (below, over) in pixel.iter_mut().zip(&rows) {
                    let sum = u32::from(over[i]) * share * 255 + u32::from(*below) * (255 * 256 - there);
                    *below = ((sum + 255 * 128) / (255 * 256)).min(255) as u8;
                }
            }
        }
    }

    /// Dims everything outside an outline, in fractions of the page; `depth` is 0 to 1.
    fn veil(&mut self, outline: &[(f64, f64)], depth: f64) {
        let [width, height] = self.size;
        let Crop { x, y, width: wide, height: high } = self.view;
        let placed = |&(across, down): &(f64, f64)| {
            Point::new((across - x) / wide * width as f64, (down - y) / high * height as f64)
        };
        let contour = Contour { points: outline.iter().map(placed).collect(), adds: true };
        let bright = coverage(&[contour], PixelRect { x: 0, y: 0, width, height });
        let depth = (depth * 256.0).round() as u32;
        for (pixel, bright) in self.rgb.as_chunks_mut::<3>().0.iter_mut().zip(bright) {
            let veil = (255 - u32::from(bright)) * depth;
            for (below, ground) in pixel.iter_mut().zip(GROUND) {
                let sum = u32::from(ground) * veil + u32::from(*below) * (255 * 256 - veil);
                *below = ((sum + 255 * 128) / (255 * 256)) as u8;
            }
        }
    }
}

/// Pixels of a frame that a plate covers on one axis, as start and length, and the shown part of the plate.
/// `None` if they do not overlap. `view` is what the frame shows in fractions of the page, `place` where the
/// plate is in pixels of it, each as its start and length.
fn stretch(
    pixels: usize,
    page: f64,
    view: (f64, f64),
    place: (f64, f64),
) -> Option<(usize, usize, (f64, f64))> {
    let pixel = view.1 * page / pixels as f64;
    let at = |place: f64| (place - view.0 * page) / pixel;
    let first = at(place.0).ceil().max(0.0);
    let end = at(place.0 + place.1).floor().min(pixels as f64);
    (end > first).then(|| {
        let start = view.0 * page + first * pixel - place.0;
        (first as usize, (end - first) as usize, (start, (end - first) * pixel))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [64, 36];
    const WHOLE: Crop = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };

    /// A page with two panels, left and right, of one colour each.
    fn page() -> Page {
        let pixel = |i: usize| if i % 128 < 64 { [200, 40, 30] } else { [20, 60, 220] };
        let rgb: Vec<u8> = (0..128 * 72).flat_map(pixel).collect();
        let half = |x: f64| vec![(x, 0.0), (x + 0.5, 0.0), (x + 0.5, 1.0), (x, 1.0)];
        let mut page = Page::new(&Sheet::of(128, 72, rgb), vec![half(0.0), half(0.5)], 2.0);
        // A white box that stands out of the left panel.
        let area = PixelRect { x: 40, y: 30, width: 48, height: 12 };
        page.add(&Patch { area, rgba: vec![255; 48 * 12 * 4] }, (0, 0));
        page
    }

    fn at(frame: &[u8], x: usize, y: usize) -> [u8; 3] {
        let start = (y * SIZE[0] + x) * 3;
        [frame[start], frame[start + 1], frame[start + 2]]
    }

    fn veiled(colour: [u8; 3]) -> [u8; 3] {
        let mixed = |i: usize| f64::from(colour[i]) * (1.0 - VEIL) + f64::from(GROUND[i]) * VEIL;
        [0, 1, 2].map(|i| mixed(i).round() as u8)
    }

    fn near(a: [u8; 3], b: [u8; 3]) -> bool {
        a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1)
    }

    #[test]
    fn all_but_the_panel_that_is_read_is_veiled_and_its_words_are_not() {
        let read = Told { words: 1.0, panel: Some(0), veil: 1.0 };
        let frame = page().seen(&WHOLE, &read, SIZE);
        assert_eq!(at(&frame, 5, 5), [200, 40, 30]);
        assert!(near(at(&frame, 60, 5), veiled([20, 60, 220])), "{:?}", at(&frame, 60, 5));
        // The text item in the panel, and its part beyond the border.
        assert_eq!((at(&frame, 25, 18), at(&frame, 40, 18)), ([255; 3], [255; 3]));
        let other = page().seen(&WHOLE, &Told { panel: Some(1), ..read }, SIZE);
        assert_eq!(at(&other, 60, 5), [20, 60, 220]);
        assert!(near(at(&other, 25, 18), veiled([255; 3])));
        // It is in the active panel.
        assert_eq!(at(&other, 40, 18), [255; 3]);
    }

    #[test]
    fn a_word_appears_by_and_by() {
        let seen = |words: f64| {
            let frame = page().seen(&WHOLE, &Told { words, panel: None, veil: 0.0 }, SIZE);
            at(&frame, 25, 18)
        };
        assert_eq!((seen(0.0), seen(1.0)), ([200, 40, 30], [255; 3]));
        assert!(near(seen(0.5), [228, 148, 143]), "{:?}", seen(0.5));
    }

    #[test]
    fn what_is_beside_the_page_is_ground_and_edges_between_pixels_are_smooth() {
        let view = Crop { x: -0.5 - 0.5 / 64.0, width: 2.0, y: -0.5, height: 2.0 };
        let frame = page().seen(&view, &Told::default(), SIZE);
        assert_eq!((at(&frame, 2, 18), at(&frame, 60, 18), at(&frame, 32, 2)), (GROUND, GROUND, GROUND));
        assert_eq!(at(&frame, 20, 18), [200, 40, 30]);
        // The page begins a quarter into a pixel.
        let [edge, ..] = at(&frame, 16, 18);
        let wanted = f64::from(GROUND[0]) * 0.25 + 200.0 * 0.75;
        assert!((f64::from(edge) - wanted).abs() <= 2.0, "{edge}, not {wanted}");
    }

    #[test]
    fn a_frame_that_shows_a_part_shows_that_part() {
        let view = Crop { x: 0.6, y: 0.6, width: 0.25, height: 0.25 };
        let frame = page().seen(&view, &Told::default(), SIZE);
        assert!(frame.as_chunks::<3>().0.iter().all(|pixel| near(*pixel, [20, 60, 220])));
    }
}
