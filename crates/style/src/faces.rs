//! Protection of faces: lines, cells and areas of a panel shrink with the smallest main face. Inside faces, each layer is drawn
//! again at half the scale, light is brought to features, and colours stay near the photo.
//!
//! All lengths depend on the height of a face, which grows with the render like any length of a style:
//! thumbnail, preview and print agree. The shares were chosen by visual comparison.

use super::chain;
use super::context::Context;
pub use super::face_box::FaceBox;
use super::face_box::{MASK, each_pixel, luma, rgb_at};
use super::file::{Step, Style, recolours};
use super::params::FaceLimit;
use super::shadows::step;
use super::skin::Skin;
use crate::error::Result;
use crate::raster::guided::softened;
use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;

/// Faces of less than this share of the largest are of a crowd: lengths of the style do not shrink for them.
const CROWD: f64 = 0.42;

/// Minimum factor of a length, even for very small faces. Cells have no minimum.
const LEAST: f32 = 0.5;

/// Maximum spread of luma in a face, from the 5th to the 95th percentile, that is increased, and the maximum
/// factor.
const CONTRAST: (f32, f32) = (110.0, 1.5);
/// Light for the colour layer. More light would make dark skin lighter than the neck and the hands.
const LIGHT: Light = Light { darkest: 92.0, lightest: 176.0, most: 30.0, part: 0.4 };
/// Light for the line layer, whose blacks would fill dark skin.
const LINE_LIGHT: Light = Light { darkest: 124.0, lightest: 190.0, most: 64.0, part: f32::INFINITY };
/// Grey levels above the light tones of a face from which its surroundings get no light.
const BACKDROP: f32 = 40.0;
/// Darkest tones that have no detail, up to this one, and the part of such pixels that makes a face a silhouette.
const SILHOUETTE: (u8, f32) = (8, 0.2);
/// Maximum colour strength of a face relative to the photo, and a difference that is always allowed, in grey
/// levels.
const CHROMA: (f32, f32) = (1.35, 9.0);
/// Colour strength of natural skin in strong light, in grey levels. Styles do not make skin stronger than this, and stronger
/// skin not stronger than the photo.
const VIVID: f32 = 40.0;
/// Largest factor of the strength of a colour that gets light. More light is added as gray.
const STRONGER: f32 = 1.4;
/// Largest factor of the strength of colours in a face that is lighter than in the photo.
const LIGHTER: f32 = 1.8;
/// Least strength of colours in a face, as a part of their strength in the photo.
const PALEST: f32 = 0.7;
/// Largest distance of colours in a face from the photo, at equal strength, in grey steps: skin has no green areas. Pale
/// skin bears less: the first number, and the part of the strength of its colour.
const TINT: f32 = 7.0;
const PALE_TINT: (f32, f32) = (3.0, 0.4);
/// Share of the mask of a face up to which only skin keeps the colours of the photo: 1.05 half sides from the centre.
const AROUND: f32 = 0.84;
/// Part of the way to black and to white that tones of a face may take.
const TONES: (f32, f32) = (0.62, 0.55);

/// Factor of lengths in a face that is drawn again, relative to its surroundings.
const FINER: f32 = 0.5;
/// Scale of the thinnest line in a face, in pixels of the render.
const THINNEST: f32 = 0.55;
/// Height of a face that needs no finer lines, in pixels of a style.
const LARGE: f32 = 420.0;
/// Faces that are drawn again at most: the largest ones.
const MOST_FACES: usize = 12;
/// Room around a face that is drawn again, in parts of its size: its mask, and what filters look at.
const ROOM: f64 = 0.5;

/// Columns and rows of the grid on which a drawn face is compared with the photo. An eye has two columns.
const GRID: (usize, usize) = (12, 15);
/// Correlation of a drawn face with the photo at which it is hard to recognise, and at which it needs nothing.
const LIKE: (f32, f32) = (0.45, 0.86);
/// Correlation of a face in a negative.
const NEGATIVE: f32 = -0.3;
/// The contrast of a drawn face, relative to the photo, below which features are missing, and which needs nothing.
const FEATURES: (f32, f32) = (0.4, 0.85);
/// Rows of the grid from a feature to the skin above and below it.
const BESIDE: usize = 2;
/// Part of the features of the photo below which a face is hard to recognise, and which needs nothing.
const DETAIL: (f32, f32) = (0.3, 0.75);
/// Depth of the features of a photo below which there are none: the root of the sum of squares, in grey levels.
const PLAIN: f32 = 12.0;
/// Contrast of a face, as a standard deviation in grey levels, and the range of its factor relative to the photo.
const DEPTH: (f32, f32, f32) = (30.0, 0.8, 1.7);
/// Farthest distance of the mean tone of a face from the photo, in grey levels.
const FARTHEST: f32 = 52.0;
/// Part of the missing tones that a face gets at most.
const MENDED: f32 = 0.8;
/// Heights of faces that get tones of the photo in any case: all of [`MENDED`], and none. In pixels of a style.
const SMALL: (f32, f32) = (60.0, 150.0);
/// Radius of the smallest feature, and of its surroundings, in heights of a face.
const FEATURE: f32 = 0.022;
const SURROUNDINGS: f32 = 0.1;
/// Heights of faces whose features are drawn again: all, and none. In pixels of a style.
const DRAWN: (f32, f32) = (180.0, 330.0);
/// Depth of a feature of a drawn face, relative to the photo: eyes and a mouth, and teeth and the whites of eyes.
const DEEPER: (f32, f32) = (1.5, 1.0);
/// A pixel becomes a feature between these differences from its surroundings. The largest change of a pixel. In grey levels.
const DETAILS: (f32, f32) = (3.0, 12.0);
const MOST_DETAIL: f32 = 80.0;
/// How much darker than its surroundings a pixel is that gets no ink, and all ink, in grey levels.
const EDGE: (f32, f32) = (3.0, 13.0);
/// Luma of hair and pupils, which get all ink, and least luma of skin, whose features get ink.
const BLACK: (f32, f32) = (36.0, 64.0);
/// Minimum height of a face that can be compared, in pixels.
const COMPARED: f64 = 12.0;
/// Part of the picture that counts as its darkest and as its lightest colour.
const ENDS: f32 = 0.04;

/// How much light a face gets.
struct Light {
    /// Range of middle tones in which a face is not changed, in grey levels.
    darkest: f32,
    lightest: f32,
    /// Maximum shift, in grey levels.
    most: f32,
    /// Maximum shift as a part of the middle tone.
    part: f32,
}

/// The faces of an image that must stay recognisable.
pub(super) struct Care<'a> {
    faces: Vec<&'a FaceBox>,
    /// Height of the smallest main face, in pixels.
    height: f32,
}

impl<'a> Care<'a> {
    /// Returns `None` if no face is in view. A silhouette has no features to protect. `luma`: the photo in gray.
    pub(super) fn of(faces: &'a [FaceBox], luma: &Plane) -> Option<Self> {
        let (width, height) = (luma.width(), luma.height());
        let inside = |at: f64, side: usize| at > 0.0 && at < side as f64;
        let seen = |face: &&FaceBox| {
            face.height >= 1.0
                && inside(face.x + face.width / 2.0, width)
                && inside(face.y + face.height / 2.0, height)
        };
        let faces: Vec<&FaceBox> =
            faces.iter().filter(seen).filter(|face| !is_silhouette(luma, face)).collect();
        let heights = || faces.iter().map(|face| face.height);
        let largest = heights().fold(0.0, f64::max);
        let least = heights().filter(|height| *height >= CROWD * largest).reduce(f64::min)?;
        Some(Self { faces, height: least as f32 })
    }

    /// The style with lengths that these faces bear. `scale`: pixels of the render for one of a style.
    pub(super) fn scaled(&self, style: &Style, scale: f32) -> Style {
        let mut style = style.clone();
        let height = self.height / scale.max(f32::MIN_POSITIVE);
        for step in style.background.iter_mut().chain(style.foreground.iter_mut().flatten()) {
            shorten(step, height);
        }
        style
    }

    /// The photo with light in its faces that features show in.
    pub(super) fn lit(&self, photo: &Image) -> Image {
        self.lighted(photo, LIGHT)
    }

    /// The photo with light in its faces for the line layer.
    pub(super) fn lit_for_lines(&self, photo: &Image) -> Image {
        self.lighted(photo, LINE_LIGHT)
    }

    fn lighted(&self, photo: &Image, Light { darkest, lightest, most, part }: Light) -> Image {
        let luma = luma_plane(photo);
        let mut lit = photo.clone();
        for face in &self.faces {
            let Some((low, middle, high)) = light(&luma, face) else { continue };
            let gain = (CONTRAST.0 / (high - low).max(1.0)).clamp(1.0, CONTRAST.1);
            let move_by = (middle.clamp(darkest, lightest) - middle).clamp(-most, most.min(part * middle));
            if gain <= 1.0 && move_by.abs() < 1.0 {
                continue;
            }
            each_pixel(face, photo.width(), photo.height(), |x, y, share| {
                let v = f32::from(luma.at(x, y));
                let own = share * ((high + BACKDROP - v) / BACKDROP).clamp(0.0, 1.0);
                shift_luma(&mut lit, (x, y), v, own * ((v - middle) * (gain - 1.0) + move_by));
            });
        }
        lit
    }

    /// Runs a layer on a photo. Its blocks before the first screen run a second time on each face, at half the scale. If `holds`
    /// and the layer keeps colours, the colours in faces stay near the photo.
    ///
    /// # Errors
    /// `cancelled` if the caller cancels.
    pub(super) fn run(
        &self,
        steps: &[Step],
        photo: &Image,
        holds: bool,
        context: &mut Context<'_>,
    ) -> Result<Image> {
        if steps.iter().any(|step| !step.bypass && step.block.id == "size") {
            return chain::run(steps, photo, context);
        }
        let (areas, screens) = steps.split_at(first_screen(steps));
        let finer: Vec<Step> = areas.iter().map(|step| finer(step, context.scale())).collect();
        let adapted: Vec<Step> = areas.iter().map(adapted).collect();
        let large = LARGE * context.scale();
        let is_small = |face: &FaceBox| (face.height as f32) < large;
        let all = areas.iter().any(|step| !step.bypass && step.block.adapts_to_large_faces);
        let again = |face: &&&FaceBox| all || is_small(face);
        let faces: Vec<&FaceBox> = self.faces.iter().filter(again).take(MOST_FACES).copied().collect();
        // Painters paint a large face like its surroundings, so its painting is a part of the whole painting.
        context.record_tones(faces.iter().any(|face| !is_small(face)));
        let drawn = chain::run(areas, photo, context);
        let tones = context.recorded_tones();
        let mut drawn = drawn?;
        let subject = context.subject().cloned();
        for face in faces {
            let Some(room) = Room::around(face, photo) else { continue };
            context.show_subject(subject.as_ref().map(|plane| room.cut_plane(plane)));
            let cut = |painting: &Image| (!is_small(face)).then(|| room.cut(painting));
            context.replay_tones(tones.iter().map(|measured| measured.of_part(cut)).collect());
            let steps = if is_small(face) { &finer } else { &adapted };
            let again = chain::run(steps, &room.cut(photo), context);
            context.recorded_tones();
            context.show_subject(subject.clone());
            room.lay(&mut drawn, &again?, face);
        }
        if holds && !recolours(areas) {
            // A backdrop is not a part of a face.
            let parted = areas.iter().any(|step| !step.bypass && step.part.is_some());
            self.hold(photo, &mut drawn, subject.as_ref().filter(|_| parted));
        }
        chain::run_owned(screens, drawn, context)
    }

    /// Compares the drawn faces with the photo. If features are missing, tones of the photo come back, as far as
    /// necessary, in the colours of the picture.
    /// The features of a small face have the size of lines and areas, so it gets tones in any case. `scale`: pixels of the
    /// render for one of a style.
    pub(super) fn mend(&self, photo: &Image, drawn: &mut Image, recolours: bool, scale: f32) {
        let faces = || self.faces.iter().filter(|face| face.height >= COMPARED);
        if faces().next().is_none() {
            return;
        }
        let (before, after) = (luma_plane(photo), luma_plane(drawn));
        let mut ends = None;
        for face in faces() {
            let Some(fit) = Fit::of(&before, &after, face) else { continue };
            let height = face.height as f32 / scale.max(f32::MIN_POSITIVE);
            let part = fit.missing().max(fit.of_small(height));
            if part < 0.05 {
                continue;
            }
            let Some(room) = Room::around(face, photo) else { continue };
            let (before, after) = (room.cut_plane(&before), room.cut_plane(&after));
            // Only the tones of features and larger areas: hatching, dots and lines stay.
            let radius = (FEATURE * face.height as f32).round() as usize;
            let (wanted, now) = (softened(&before, radius), softened(&after, radius));
            let ends = *ends.get_or_insert_with(|| Ends::of(drawn, recolours));
            room.each_pixel(face, (photo.width(), photo.height()), |(x, y), (i, j), share| {
                let by = fit.wanted(f32::from(wanted.at(i, j))) - f32::from(now.at(i, j));
                ends.shift(drawn, (x, y), share * part * by);
            });
        }
    }

    /// Draws the features of small faces as deep as in the photo or deeper. A style draws areas and lines as large as the eyes of
    /// such a face, and only eyes and a mouth make it a face. `scale`: pixels of the render for one of a style.
    pub(super) fn deepen(&self, photo: &Image, drawn: &mut Image, recolours: bool, scale: f32) {
        let height = |face: &FaceBox| face.height as f32 / scale.max(f32::MIN_POSITIVE);
        let small = |face: &&&FaceBox| face.height >= COMPARED && height(face) < DRAWN.1;
        let faces: Vec<&FaceBox> = self.faces.iter().filter(small).copied().collect();
        if faces.is_empty() {
            return;
        }
        let (before, after) = (luma_plane(photo), luma_plane(drawn));
        let ends = Ends::of(drawn, recolours);
        for face in faces {
            let Some(room) = Room::around(face, photo) else { continue };
            // A negative is meant.
            if Fit::of(&before, &after, face).is_none_or(|fit| fit.likeness < NEGATIVE) {
                continue;
            }
            let part = 1.0 - step(DRAWN, height(face));
            let (before, after) = (room.cut_plane(&before), room.cut_plane(&after));
            let pixels = |part: f32| (part * face.height as f32).round() as usize;
            let around = |plane: &Plane| softened(plane, pixels(SURROUNDINGS).max(2));
            let (skin, drawn_skin) = (around(&before), around(&after));
            room.each_pixel(face, (photo.width(), photo.height()), |(x, y), (i, j), share| {
                let detail =
                    |plane: &Plane, around: &Plane| f32::from(plane.at(i, j)) - f32::from(around.at(i, j));
                let (own, now) = (detail(&before, &skin), detail(&after, &drawn_skin));
                let wanted = step(DETAILS, own.abs()) * own * if own < 0.0 { DEEPER.0 } else { DEEPER.1 };
                // Never flatter than the style draws it.
                let by = if own < 0.0 { (wanted - now).min(0.0) } else { (wanted - now).max(0.0) };
                ends.shift(drawn, (x, y), share * part * by.clamp(-MOST_DETAIL, MOST_DETAIL));
            });
        }
    }

    /// Removes ink from faces where the photo has no feature: lines along shadows and wrinkles look like scratches. `photo`: the
    /// photo of the line layer. `lines`: white without ink.
    pub(super) fn clean(&self, photo: &Image, lines: &mut Image) {
        let luma = luma_plane(photo);
        for face in self.faces.iter().filter(|face| face.height >= COMPARED) {
            let Some(room) = Room::around(face, photo) else { continue };
            let luma = room.cut_plane(&luma);
            let mean = |part: f32, least: usize| {
                softened(&luma, ((part * face.height as f32).round() as usize).max(least))
            };
            let (fine, around) = (mean(FEATURE / 2.0, 0), mean(SURROUNDINGS, 2));
            room.each_pixel(face, (photo.width(), photo.height()), |(x, y), (i, j), share| {
                let (tone, around) = (f32::from(fine.at(i, j)), f32::from(around.at(i, j)));
                let ink = step(EDGE, around - tone).max(1.0 - step(BLACK, tone));
                for plane in lines.planes_mut() {
                    let sample = &mut plane.row_mut(y)[x];
                    let now = f32::from(*sample);
                    let lightest = now.max(255.0 * (1.0 - ink));
                    // The outline of the head stays.
                    let inner = (2.0 * share - 1.0).max(0.0);
                    *sample = (now + inner * (lightest - now)).round() as u8;
                }
            });
        }
    }

    /// Moves the colours of faces and of other skin toward the photo, within the subject if there is one.
    fn hold(&self, photo: &Image, drawn: &mut Image, subject: Option<&Plane>) {
        if photo.is_luma() || drawn.is_luma() {
            return;
        }
        let mut hold = |x: usize, y: usize, share: f32| {
            let (before, after) = (rgb_at(photo, x, y), rgb_at(drawn, x, y));
            let share = share * subject.map_or(1.0, |subject| f32::from(subject.at(x, y)) / 255.0);
            let held = held(before, after);
            for ((plane, after), held) in drawn.planes_mut().iter_mut().zip(after).zip(held) {
                let value = after + share * (held - after);
                plane.row_mut(y)[x] = value.round().clamp(0.0, 255.0) as u8;
            }
        };
        let skin = Skin::of(photo, &self.faces);
        for face in &self.faces {
            each_pixel(face, photo.width(), photo.height(), |x, y, share| {
                // Around the face, only skin: a light backdrop would get a gray halo.
                let inner = ((share - AROUND) / (1.0 - AROUND)).max(0.0);
                hold(x, y, inner.max(share * skin.share(x, y, rgb_at(photo, x, y))));
            });
        }
        let (columns, rows) = skin.bounds();
        for y in rows {
            for x in columns.clone() {
                let share = skin.share(x, y, rgb_at(photo, x, y));
                if share > 0.0 {
                    hold(x, y, share);
                }
            }
        }
    }
}

/// How the tones of a drawn face follow the tones of the photo.
struct Fit {
    /// Correlation of both, -1 to 1.
    likeness: f32,
    /// Mean and standard deviation of luma in the photo, and in the drawing.
    photo: (f32, f32),
    drawn: (f32, f32),
    /// Part of the contrast of features in the photo that the drawing has at the same places.
    features: f32,
}

impl Fit {
    /// Compares means of the cells of a grid. `None` if the photo shows nothing there.
    fn of(photo: &Plane, drawn: &Plane, face: &FaceBox) -> Option<Self> {
        let mut cells = [[0.0_f32; 3]; GRID.0 * GRID.1];
        let place = |at: f64, from: f64, side: f64, count: usize| {
            let at = (at + 0.5 - from) / side * count as f64;
            (at >= 0.0 && at < count as f64).then_some(at as usize)
        };
        let (width, height) = (photo.width(), photo.height());
        each_pixel(face, width, height, |x, y, share| {
            let column = place(x as f64, face.x, face.width, GRID.0);
            let row = place(y as f64, face.y, face.height, GRID.1);
            if let (Some(column), Some(row)) = (column, row)
                && share >= 1.0
            {
                let cell = &mut cells[row * GRID.0 + column];
                cell[0] += 1.0;
                cell[1] += f32::from(photo.at(x, y));
                cell[2] += f32::from(drawn.at(x, y));
            }
        });
        let means: Vec<(f32, f32)> = cells
            .iter()
            .filter(|[count, ..]| *count > 0.0)
            .map(|[count, photo, drawn]| (photo / count, drawn / count))
            .collect();
        let count = means.len() as f32;
        if means.len() < GRID.0 * GRID.1 / 3 {
            return None;
        }
        let sum = |f: &dyn Fn(&(f32, f32)) -> f32| means.iter().map(f).sum::<f32>() / count;
        let (p, d) = (sum(&|cell| cell.0), sum(&|cell| cell.1));
        let both = sum(&|cell| (cell.0 - p) * (cell.1 - d));
        let (own, now) = (sum(&|cell| (cell.0 - p) * (cell.0 - p)), sum(&|cell| (cell.1 - d) * (cell.1 - d)));
        let (own, now) = (own.sqrt(), now.sqrt());
        (own > 2.0).then_some(Self {
            likeness: both / (own * now).max(1.0),
            photo: (p, own),
            drawn: (d, now),
            features: features(&cells),
        })
    }

    /// The part of the tones of the photo that the face needs.
    fn missing(&self) -> f32 {
        // A negative is meant.
        if self.likeness < NEGATIVE {
            return 0.0;
        }
        let short =
            |(least, enough): (f32, f32), value: f32| ((enough - value) / (enough - least)).clamp(0.0, 1.0);
        let far = (self.middle() - self.drawn.0).abs() / FARTHEST;
        let unlike = short(LIKE, self.likeness).max(short(FEATURES, self.drawn.1 / self.photo.1.min(40.0)));
        MENDED * unlike.max(short(DETAIL, self.features)).max(far.min(1.0))
    }

    /// The part of the tones of the photo that a face gets because it is small.
    fn of_small(&self, height: f32) -> f32 {
        if self.likeness < NEGATIVE {
            return 0.0;
        }
        MENDED * ((SMALL.1 - height) / (SMALL.1 - SMALL.0)).clamp(0.0, 1.0)
    }

    /// The mean tone of the drawn face, not too far from the photo.
    fn middle(&self) -> f32 {
        self.drawn.0.clamp(self.photo.0 - FARTHEST, self.photo.0 + FARTHEST)
    }

    /// The tone for one of the photo.
    fn wanted(&self, tone: f32) -> f32 {
        let factor = (self.drawn.1.max(DEPTH.0) / self.photo.1).clamp(DEPTH.1, DEPTH.2);
        self.middle() + factor * (tone - self.photo.0)
    }
}

/// The part of the features of the photo that a drawing has. Eyes, nostrils and a mouth are darker than the skin above and below
/// them; light and shadow are not. `cells`: pixels of each cell, and the sums of both pictures.
fn features(cells: &[[f32; 3]]) -> f32 {
    let mean = |row: usize, column: usize, of: usize| {
        let cell = cells[row * GRID.0 + column];
        (cell[0] > 0.0).then(|| cell[of] / cell[0])
    };
    let depth = |row: usize, column: usize, of: usize| {
        let edges = mean(row - BESIDE, column, of)?.min(mean(row + BESIDE, column, of)?);
        Some((edges - mean(row, column, of)?).max(0.0))
    };
    let (mut both, mut own) = (0.0_f32, 0.0_f32);
    for row in BESIDE..GRID.1 - BESIDE {
        for column in 0..GRID.0 {
            if let (Some(photo), Some(drawn)) = (depth(row, column, 1), depth(row, column, 2)) {
                both += photo * drawn;
                own += photo * photo;
            }
        }
    }
    if own < PLAIN * PLAIN { 1.0 } else { both / own }
}

/// The colours that tones of a face move to: black and white of the photo's colours, or the darkest and the lightest
/// colour of a picture that has other colours.
#[derive(Clone, Copy)]
struct Ends {
    ends: Option<[[f32; 3]; 2]>,
}

impl Ends {
    fn of(drawn: &Image, recolours: bool) -> Self {
        if drawn.is_luma() || !recolours {
            return Self { ends: None };
        }
        let luma = luma_plane(drawn);
        let mut counts = [(0.0_f32, [0.0_f32; 3]); 256];
        for (i, &y) in luma.samples().iter().enumerate() {
            let (count, sums) = &mut counts[usize::from(y)];
            *count += 1.0;
            for (sum, plane) in sums.iter_mut().zip(drawn.planes()) {
                *sum += f32::from(plane.samples()[i]);
            }
        }
        let least = ENDS * luma.samples().len() as f32;
        let mean = |tones: &mut dyn Iterator<Item = &(f32, [f32; 3])>| {
            let (mut all, mut sums) = (0.0_f32, [0.0_f32; 3]);
            for (count, colour) in tones {
                all += count;
                for (sum, part) in sums.iter_mut().zip(colour) {
                    *sum += part;
                }
                if all >= least {
                    break;
                }
            }
            sums.map(|sum| sum / all.max(1.0))
        };
        Self { ends: Some([mean(&mut counts.iter()), mean(&mut counts.iter().rev())]) }
    }

    /// Moves the luma of a pixel.
    fn shift(&self, drawn: &mut Image, (x, y): (usize, usize), by: f32) {
        if drawn.is_luma() {
            let now = f32::from(drawn.planes()[0].at(x, y));
            return shift_luma(drawn, (x, y), now, by);
        }
        let now = rgb_at(drawn, x, y);
        let Some(ends) = self.ends else { return shift_luma(drawn, (x, y), luma(now), by) };
        let target = ends[usize::from(by > 0.0)];
        let distance = luma(target) - luma(now);
        // Never past the end.
        let part = if distance * by > 0.0 { (by / distance).min(1.0) } else { 0.0 };
        for (plane, (now, target)) in drawn.planes_mut().iter_mut().zip(now.into_iter().zip(target)) {
            plane.row_mut(y)[x] = (now + part * (target - now)).round().clamp(0.0, 255.0) as u8;
        }
    }
}

/// Changes the luma of a pixel, and the strength of its colour by the same factor up to [`STRONGER`]: skin in light is neither
/// white nor gray. `now`: its luma.
fn shift_luma(image: &mut Image, (x, y): (usize, usize), now: f32, by: f32) {
    let now = now.max(1.0);
    let factor = ((now + by) / now).clamp(0.0, STRONGER);
    let rest = now + by - factor * now;
    for plane in image.planes_mut() {
        let sample = &mut plane.row_mut(y)[x];
        *sample = (f32::from(*sample) * factor + rest).round().clamp(0.0, 255.0) as u8;
    }
}

/// Moves a colour toward the photo as far as a face needs.
fn held(before: [f32; 3], after: [f32; 3]) -> [f32; 3] {
    let (y_before, y_after) = (luma(before), luma(after));
    let y = y_after.clamp(TONES.0 * y_before, 255.0 - TONES.1 * (255.0 - y_before));
    let chroma = |rgb: [f32; 3], y: f32| [(rgb[2] - y) / 1.772, (rgb[0] - y) / 1.402];
    let (own, now) = (chroma(before, y_before), chroma(after, y_after));
    // Products and square roots are rounded identically on all platforms.
    let length = |[u, v]: [f32; 2]| (u * u + v * v).sqrt();
    // Colours of skin are stronger in more light.
    let lighter = (y / y_before.max(1.0)).clamp(1.0, LIGHTER);
    let own = own.map(|part| lighter * part);
    let (strength, strength_now) = (length(own), length(now));
    // As strong as the style makes it, up to a limit, and near the direction of the photo.
    let most = (CHROMA.0 * strength + CHROMA.1).min(VIVID.max(strength));
    let capped = strength_now.min(most).max(PALEST * strength);
    let now = now.map(|part| part * capped / strength_now.max(1.0));
    let target = own.map(|part| part * capped / strength.max(4.0));
    let (du, dv) = (now[0] - target[0], now[1] - target[1]);
    let off = length([du, dv]);
    let tint = TINT.min(PALE_TINT.0 + PALE_TINT.1 * strength);
    let part = if off > tint { tint / off } else { 1.0 };
    let [u, v] = [target[0] + du * part, target[1] + dv * part];
    [y + 1.402 * v, y - 0.344 * u - 0.714 * v, y + 1.772 * u]
}

/// The part of an image around a face.
struct Room {
    x: usize,
    y: usize,
    width: usize,
    height: usize,
}

impl Room {
    /// `None` if the face is outside the image.
    fn around(face: &FaceBox, image: &Image) -> Option<Self> {
        let span = |start: f64, length: f64, side: usize| {
            let room = length * ((MASK.1 - 1.0) / 2.0 + ROOM);
            let at = |place: f64| place.clamp(0.0, side as f64) as usize;
            let (first, last) = (at((start - room).floor()), at((start + length + room).ceil()));
            (last > first).then_some((first, last - first))
        };
        let (x, width) = span(face.x, face.width, image.width())?;
        let (y, height) = span(face.y, face.height, image.height())?;
        Some(Self { x, y, width, height })
    }

    /// Calls `f` with each pixel of a face's ellipse in the image, its place in this part, and its share of the ellipse.
    fn each_pixel(
        &self,
        face: &FaceBox,
        (width, height): (usize, usize),
        mut f: impl FnMut((usize, usize), (usize, usize), f32),
    ) {
        each_pixel(face, width, height, |x, y, share| {
            let (Some(i), Some(j)) = (x.checked_sub(self.x), y.checked_sub(self.y)) else { return };
            if i < self.width && j < self.height {
                f((x, y), (i, j), share);
            }
        });
    }

    fn cut_plane(&self, plane: &Plane) -> Plane {
        Plane::from_fn(self.width, self.height, |x, y| plane.at(self.x + x, self.y + y))
    }

    fn cut(&self, image: &Image) -> Image {
        let planes: Vec<Plane> = image.planes().iter().map(|plane| self.cut_plane(plane)).collect();
        match <[Plane; 3]>::try_from(planes) {
            // Three planes of one size are always an image.
            Ok(planes) => Image::from_rgb(planes).unwrap_or_else(|_| image.clone()),
            Err(mut planes) => Image::from_luma(planes.swap_remove(0)),
        }
    }

    /// Draws the new drawing of a face into the whole picture.
    fn lay(&self, whole: &mut Image, again: &Image, face: &FaceBox) {
        if whole.is_luma() != again.is_luma() {
            return;
        }
        let size = (whole.width(), whole.height());
        self.each_pixel(face, size, |(x, y), (i, j), share| {
            for (plane, again) in whole.planes_mut().iter_mut().zip(again.planes()) {
                let sample = &mut plane.row_mut(y)[x];
                let (before, after) = (f32::from(*sample), f32::from(again.at(i, j)));
                *sample = (before + share * (after - before)).round() as u8;
            }
        });
    }
}

/// Returns the index of the first block whose pattern must continue across faces. 0 if a later block restores
/// colours.
fn first_screen(steps: &[Step]) -> usize {
    let is_screen = |step: &Step| !step.bypass && step.block.is_screen;
    let first = steps.iter().position(is_screen).unwrap_or(steps.len());
    let wants_colour = steps[first..].iter().any(|step| !step.bypass && step.block.restores_color);
    if wants_colour { 0 } else { first }
}

/// A block for a face that is drawn again.
fn finer(step: &Step, scale: f32) -> Step {
    let mut step = step.clone();
    for (param, value) in step.block.params.iter().zip(&mut step.values) {
        let least = param.kind.range().0;
        let thinnest = match param.face {
            Some(FaceLimit::Line(_)) => THINNEST / scale.max(f32::MIN_POSITIVE),
            Some(FaceLimit::Length(_)) => least,
            Some(FaceLimit::Cell { .. }) | None => continue,
        };
        if *value > least {
            *value = (FINER * *value).max(thinnest).min(*value).max(least);
        }
    }
    (step.block.adapt_to_face)(&mut step.values);
    step
}

/// A block for a large face, which needs no finer lengths. Only blocks for large faces change.
fn adapted(step: &Step) -> Step {
    let mut step = step.clone();
    if step.block.adapts_to_large_faces {
        (step.block.adapt_to_face)(&mut step.values);
    }
    step
}

fn shorten(step: &mut Step, height: f32) {
    for (param, value) in step.block.params.iter().zip(&mut step.values) {
        let least = param.kind.range().0;
        let (share, floor) = match param.face {
            Some(FaceLimit::Cell { share, least: cell }) => (share, least.max(cell)),
            Some(FaceLimit::Line(share) | FaceLimit::Length(share)) => (share, LEAST * *value),
            None => continue,
        };
        // A screen without a pitch has no cells.
        if *value > least {
            *value = value.min((height * share).max(floor));
        }
    }
}

/// Distance from gray of the same luma.
#[cfg(test)]
fn chroma(rgb: [f32; 3]) -> f32 {
    let y = luma(rgb);
    ((rgb[2] - y) / 1.772).hypot((rgb[0] - y) / 1.402)
}

/// The number of pixels in the middle of a face, by luma.
fn histogram(luma: &Plane, face: &FaceBox) -> [u32; 256] {
    let mut counts = [0_u32; 256];
    each_pixel(face, luma.width(), luma.height(), |x, y, share| {
        if share >= 1.0 {
            counts[usize::from(luma.at(x, y))] += 1;
        }
    });
    counts
}

/// Whether a large part of a face is black without detail.
fn is_silhouette(luma: &Plane, face: &FaceBox) -> bool {
    let counts = histogram(luma, face);
    let black: u32 = counts[..=usize::from(SILHOUETTE.0)].iter().sum();
    black as f32 > SILHOUETTE.1 * counts.iter().sum::<u32>() as f32
}

/// Returns the fifth percentile, the median and the 95th percentile of luma in the middle of a face, or `None` without pixels.
fn light(luma: &Plane, face: &FaceBox) -> Option<(f32, f32, f32)> {
    let counts = histogram(luma, face);
    let all: u32 = counts.iter().sum();
    let percentile = |percent: u32| {
        let mut left = (all * percent).div_ceil(100).max(1);
        let at = counts.iter().position(|&count| {
            left = left.saturating_sub(count);
            left == 0
        });
        at.unwrap_or_default() as f32
    };
    (all > 0).then(|| (percentile(5), percentile(50), percentile(95)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Context, stylize};

    fn face(x: f64, y: f64, side: f64) -> FaceBox {
        FaceBox { x, y, width: 0.8 * side, height: side }
    }

    fn photo() -> Image {
        Image::from_rgb(
            [70, 50, 45].map(|base| Plane::from_fn(160, 120, |x, y| (base + ((x * 3) ^ (y * 5)) % 40) as u8)),
        )
        .unwrap()
    }

    fn style(json: &str) -> Style {
        Style::parse("test", json).unwrap()
    }

    #[test]
    fn cells_fit_fourteen_times_into_a_face_and_lines_shrink_with_it() {
        let faces = [face(10.0, 10.0, 140.0), face(400.0, 20.0, 100.0), face(600.0, 9.0, 20.0)];
        let care = Care::of(&faces, &Plane::from_fn(960, 540, |_, _| 90)).unwrap();
        let dots = style(
            r#"{"background":[{"block":"halftone","pitch":30},{"block":"plates"}],
            "foreground":[{"block":"to_gray"},{"block":"xdog","sigma":8},{"block":"pattern","scale":4}]}"#,
        );
        // The face of the crowd does not count; the scale of 960 x 540 is a half.
        let scaled = care.scaled(&dots, 0.5);
        assert!((scaled.background[0].values[0] - 200.0 / 14.0).abs() < 1e-3);
        assert_eq!(scaled.background[1].values, dots.background[1].values, "no pitch, no cells");
        let lines = scaled.foreground.unwrap();
        assert!((lines[1].values[0] - 4.0).abs() < 1e-3, "half of 8 stays");
        assert!(lines[2].values[2] * 5.0 <= 200.0 / 14.0 + 1e-3, "a cell of the pattern has 5 pixels");
    }

    #[test]
    fn without_faces_or_where_a_style_wants_none_nothing_changes() {
        let json = r#"{"background":[{"block":"saturation","amount":4}],"foreground":[{"block":"to_gray"},{"block":"xdog"}]}"#;
        let photo = photo();
        let draw = |style: &Style, faces: Vec<FaceBox>| {
            let mut context = Context::for_image(&photo);
            context.show_faces(faces);
            stylize(&photo, style, &mut context).unwrap().to_rgba()
        };
        let plain = draw(&style(json), Vec::new());
        let faces = vec![face(40.0, 30.0, 60.0)];
        assert!(plain == draw(&style(json), vec![face(-90.0, 0.0, 60.0)]));
        let careless = json.replacen('{', r#"{"faces":false,"#, 1);
        assert!(plain == draw(&style(&careless), faces.clone()));
        assert_eq!(style(&careless).to_value()["faces"], false);
        assert!(plain != draw(&style(json), faces));
    }

    #[test]
    fn silhouettes_stay_black_and_dark_faces_get_light() {
        let posterized = style(r#"{"background":[{"block":"luma_posterize","levels":16}]}"#);
        let darkest_of = |body: u8| {
            // A body on a bright sky.
            let plane =
                Plane::from_fn(160, 120, |x, y| if (x + y) % 3 == 0 { 150 } else { body + (x % 3) as u8 });
            let photo = Image::from_luma(plane);
            let mut context = Context::for_image(&photo);
            let draw = |context: &mut Context<'_>| stylize(&photo, &posterized, context).unwrap();
            let plain = draw(&mut context);
            context.show_faces(vec![face(40.0, 30.0, 60.0)]);
            (plain == draw(&mut context), photo)
        };
        assert!(darkest_of(3).0);
        assert!(!darkest_of(30).0);
    }

    #[test]
    fn colours_of_a_face_stay_near_the_photo_and_others_do_not() {
        let strong = style(r#"{"background":[{"block":"saturation","amount":4}]}"#);
        let mut photo = photo();
        // A blue wall beside the person.
        let wall = photo.planes()[0].clone();
        for y in 0..120 {
            photo.planes_mut()[2].row_mut(y)[140..].copy_from_slice(&wall.row(y)[140..]);
            photo.planes_mut()[0].row_mut(y)[140..].fill(45);
        }
        let mut context = Context::for_image(&photo);
        context.show_faces(vec![face(40.0, 30.0, 60.0)]);
        let drawn = stylize(&photo, &strong, &mut context).unwrap();
        let at = |image: &Image, x, y| chroma([0, 1, 2].map(|i| f32::from(image.planes()[i].at(x, y))));
        assert!(at(&drawn, 64, 60) <= CHROMA.0 * at(&photo, 64, 60) + CHROMA.1 + 4.0);
        let vivid = held([230.0, 150.0, 100.0], [255.0, 90.0, 20.0]);
        assert!(chroma(vivid) <= chroma([230.0, 150.0, 100.0]).max(VIVID) + TINT, "{}", chroma(vivid));
        assert!(at(&drawn, 150, 110) > 2.5 * at(&photo, 150, 110));
    }

    /// Skin of a tone with two eyes and a mouth, in the middle of a green wall.
    fn portrait(skin: [u8; 3]) -> (Image, FaceBox) {
        let face = FaceBox { x: 120.0, y: 60.0, width: 96.0, height: 120.0 };
        let feature = |x: usize, y: usize| {
            let eye = |cx: usize| x.abs_diff(cx) < 6 && y.abs_diff(108) < 3;
            eye(148) || eye(188) || (x.abs_diff(168) < 14 && y.abs_diff(148) < 2)
        };
        let inside = |x: usize, y: usize| ((x as f64 - 168.0) / 48.0).hypot((y as f64 - 120.0) / 60.0) < 1.0;
        let colour = |x: usize, y: usize| match (feature(x, y), inside(x, y)) {
            (true, _) => skin.map(|tone| tone / 3),
            (_, true) => skin.map(|tone| tone + ((x * 5 + y * 3) % 9) as u8),
            _ => [90, 140, 80],
        };
        let plane = |c: usize| Plane::from_fn(336, 240, |x, y| colour(x, y)[c]);
        (Image::from_rgb([0, 1, 2].map(plane)).unwrap(), face)
    }

    fn drawn(json: &str, (photo, face): &(Image, FaceBox), cares: bool) -> Image {
        let mut context = Context::default();
        context.set_scale(0.5);
        context.show_faces(if cares { vec![*face] } else { Vec::new() });
        stylize(photo, &style(json), &mut context).unwrap()
    }

    #[test]
    fn eyes_stay_where_areas_are_as_large_as_they_are() {
        let json = r#"{"background":[{"block":"kuwahara","radius":14,"passes":3}]}"#;
        let photo = portrait([190, 140, 110]);
        // How much darker the eyes are than the cheeks.
        let depth = |image: &Image| {
            let luma = luma_plane(image);
            i32::from(luma.at(168, 128)) - i32::from(luma.at(148, 108))
        };
        let (plain, cared) = (depth(&drawn(json, &photo, false)), depth(&drawn(json, &photo, true)));
        assert!(cared > 20 && cared > plain + 15, "{plain} {cared}");
    }

    #[test]
    fn a_light_backdrop_gets_no_gray_halo() {
        let (mut photo, face) = portrait([235, 190, 165]);
        for y in 0..240 {
            for x in 0..336 {
                if photo.planes().iter().map(|plane| plane.at(x, y)).eq([90, 140, 80]) {
                    photo.planes_mut().iter_mut().for_each(|plane| plane.row_mut(y)[x] = 190);
                }
            }
        }
        let photo = (photo, face);
        let bright = r#"{"background":[{"block":"brightness","gain":1.6,"channels":"each"}]}"#;
        let [plain, cared] = [false, true].map(|cares| luma_plane(&drawn(bright, &photo, cares)));
        for (x, y) in [(112, 120), (168, 50), (60, 200)] {
            assert!(cared.at(x, y) > 250, "{x} {y}: {} {}", plain.at(x, y), cared.at(x, y));
        }
        assert!(cared.at(150, 130) + 10 < plain.at(150, 130), "the skin is held");
    }

    #[test]
    fn black_fills_no_dark_skin() {
        let json = r#"{"background":[{"block":"brightness","gain":0,"channels":"each"},{"block":"hue","red":255,"green":255,"blue":255}],
            "foreground":[{"block":"to_gray"},{"block":"xdog","sigma":2.6},{"block":"soft_threshold","phi":0.05,"epsilon":100}]}"#;
        let photo = portrait([78, 52, 40]);
        let cheek = |cares: bool| luma_plane(&drawn(json, &photo, cares)).at(168, 128);
        let eye = luma_plane(&drawn(json, &photo, true)).at(148, 108);
        assert!(cheek(false) < 40 && cheek(true) > 120 && eye < 60, "{} {} {eye}", cheek(false), cheek(true));
    }

    #[test]
    fn features_come_back_where_a_style_erases_them() {
        // So bright that everything is white.
        let white = r#"{"background":[{"block":"brightness","gain":4,"channels":"each"},{"block":"brightness","gain":4,"channels":"each"}]}"#;
        let photo = portrait([190, 140, 110]);
        let depth = |image: &Image| {
            let luma = luma_plane(image);
            i32::from(luma.at(168, 128)) - i32::from(luma.at(148, 108))
        };
        let (plain, cared) = (depth(&drawn(white, &photo, false)), depth(&drawn(white, &photo, true)));
        assert!(plain == 0 && cared > 15, "{plain} {cared}");
        // The background does not change.
        let corner = |cares| luma_plane(&drawn(white, &photo, cares)).at(5, 5);
        assert_eq!(corner(true), corner(false));
    }

    #[test]
    fn a_small_face_has_more_tones_of_the_photo_than_a_large_one() {
        let fit = Fit { likeness: 1.0, photo: (120.0, 30.0), drawn: (120.0, 30.0), features: 1.0 };
        assert!(fit.missing() == 0.0 && fit.of_small(400.0) == 0.0);
        assert!((fit.of_small(30.0) - MENDED).abs() < 1e-6 && fit.of_small(100.0) > 0.3);
        assert!(Fit { likeness: -0.9, ..fit }.of_small(30.0) == 0.0, "a negative is meant");
    }

    #[test]
    fn small_faces_get_deeper_features_and_large_ones_keep_those_of_the_style() {
        let (photo, face) = portrait([190, 140, 110]);
        let faces = [face];
        let care = Care::of(&faces, &luma_plane(&photo)).unwrap();
        // How much darker the left eye is than the cheeks, for a face of `height` in pixels of a style.
        let depth = |drawn: &Image, height: f64| {
            let mut drawn = drawn.clone();
            care.deepen(&photo, &mut drawn, false, (face.height / height) as f32);
            let luma = luma_plane(&drawn);
            i32::from(luma.at(168, 128)) - i32::from(luma.at(148, 108))
        };
        let flat = Image::from_rgb([190, 140, 110].map(|tone| Plane::filled(336, 240, tone))).unwrap();
        // The photo without its features, and the photo itself.
        assert!(depth(&flat, 120.0) > 40 && depth(&flat, 400.0) == 0, "{}", depth(&flat, 120.0));
        assert!(depth(&photo, 120.0) >= depth(&photo, 400.0));
        let negative = Image::from_rgb(
            [0, 1, 2].map(|c: usize| Plane::from_fn(336, 240, |x, y| 255 - photo.planes()[c].at(x, y))),
        );
        let negative = negative.unwrap();
        assert_eq!(depth(&negative, 120.0), depth(&negative, 400.0));
    }

    #[test]
    fn shadows_in_a_face_get_no_lines_and_features_do() {
        let (photo, face) = portrait([190, 140, 110]);
        // A soft shadow on a cheek, and lines along it, through an eye and beside the face.
        let mut shaded = photo;
        for plane in shaded.planes_mut() {
            for x in 170..190 {
                let sample = &mut plane.row_mut(130)[x];
                *sample -= 4;
            }
        }
        let faces = [face];
        let care = Care::of(&faces, &luma_plane(&shaded)).unwrap();
        let ink = |x: usize, y: usize| y == 130 && (170..190).contains(&x) || y == 108 || x == 20;
        let mut lines = Image::from_luma(Plane::from_fn(336, 240, |x, y| if ink(x, y) { 0 } else { 255 }));
        care.clean(&shaded, &mut lines);
        let at = |x: usize, y: usize| lines.planes()[0].at(x, y);
        assert!(at(180, 130) > 200 && at(148, 108) < 40, "{} {}", at(180, 130), at(148, 108));
        assert_eq!(at(20, 50), 0, "outside of the face");
    }

    #[test]
    fn light_in_a_face_keeps_the_strength_of_its_colour() {
        let colours = [0, 1, 2].map(|i: usize| Plane::filled(4, 4, [100, 70, 55][i]));
        let mut image = Image::from_rgb(colours).unwrap();
        let before = rgb_at(&image, 1, 1);
        shift_luma(&mut image, (1, 1), luma(before), 25.0);
        let after = rgb_at(&image, 1, 1);
        assert!((luma(after) - luma(before) - 25.0).abs() < 1.0);
        let relative = |rgb: [f32; 3]| chroma(rgb) / luma(rgb);
        assert!((relative(after) / relative(before) - 1.0).abs() < 0.05);
        assert_eq!(image.planes()[0].at(2, 1), 100, "one pixel changes");
    }

    #[test]
    fn light_and_shadow_do_not_replace_features() {
        let face = face(20.0, 20.0, 100.0);
        // Half of the face is in shadow. Eyes are in the photo only.
        let picture = |eyes: bool| {
            Plane::from_fn(140, 140, |x, y| {
                let eye = (58..66).contains(&y) && (x.abs_diff(42) < 5 || x.abs_diff(76) < 5);
                let tone = if x < 60 { 190 } else { 90 };
                if eyes && eye { tone - 60 } else { tone }
            })
        };
        let fit = |drawn: &Plane| Fit::of(&picture(true), drawn, &face).unwrap();
        let (erased, kept) = (fit(&picture(false)), fit(&picture(true)));
        assert!(erased.likeness > 0.86, "{}", erased.likeness);
        assert!(erased.missing() > 0.1 && kept.missing() == 0.0, "{} {}", erased.features, kept.features);
    }

    #[test]
    fn arms_have_the_colours_of_skin_and_clothes_do_not() {
        let json = r#"{"background":[{"block":"saturation","amount":4}]}"#;
        let mut photo = portrait([190, 140, 110]);
        // An arm and a sleeve beside the face.
        for (columns, colour) in [(4..14, [200, 148, 116]), (20..30, [80, 110, 190])] {
            for (plane, value) in photo.0.planes_mut().iter_mut().zip(colour) {
                for y in 200..230 {
                    plane.row_mut(y)[columns.clone()].fill(value);
                }
            }
        }
        let strength = |x: usize, cares: bool| chroma(rgb_at(&drawn(json, &photo, cares), x, 215));
        assert!(strength(9, true) < 0.6 * strength(9, false), "{} {}", strength(9, true), strength(9, false));
        assert!((strength(25, true) - strength(25, false)).abs() < 1.0);
    }

    #[test]
    fn skin_has_no_green_areas() {
        let json = r#"{"background":[{"block":"posterize","levels":3}]}"#;
        let photo = portrait([168, 175, 130]);
        // How much more red than green there is.
        let warmth = |cares: bool| {
            let image = drawn(json, &photo, cares);
            let [r, g] = [0, 1].map(|c: usize| i32::from(image.planes()[c].at(168, 128)));
            r - g
        };
        assert!(warmth(false) < -100 && warmth(true) > -50, "{} {}", warmth(false), warmth(true));
    }

    #[test]
    fn tones_of_a_face_are_those_of_the_whole_picture() {
        // If a face were equalised separately, it would become light.
        let json = r#"{"background":[{"block":"equalize","low":1,"high":99}]}"#;
        let photo = portrait([120, 100, 90]);
        let (plain, cared) = (drawn(json, &photo, false), drawn(json, &photo, true));
        let at = |image: &Image| i32::from(luma_plane(image).at(168, 128));
        assert!(at(&plain) < 60 && at(&cared) < 90, "{} {}", at(&plain), at(&cared));
    }

    #[test]
    fn a_dull_dark_face_gets_light() {
        let care = [face(40.0, 30.0, 60.0)];
        let photo = photo();
        let lit = Care::of(&care, &luma_plane(&photo)).unwrap().lit(&photo);
        let (before, after) = (luma_plane(&photo), luma_plane(&lit));
        let (_, was, _) = light(&before, &care[0]).unwrap();
        let (_, is, _) = light(&after, &care[0]).unwrap();
        assert!(is > was + 10.0, "{was} {is}");
        assert_eq!(before.row(118), after.row(118));
    }
}
