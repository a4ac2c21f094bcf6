//! Care for faces: where a panel shows some, lines, cells and areas are no larger than faces of that size bear, and inside
//! them light is brought to where features show and colours stay near those of the photo.
//!
//! All lengths are told by the height of a face, which grows with the render like any length of a style: thumbnail, preview
//! and print agree. The shares are this project's own, found by eye.

use super::blocks::Channels;
use super::file::{Step, Style};
use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;

/// A face in pixels of the image that shows it, parts of it perhaps beyond the border.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceBox {
    /// Left edge.
    pub x: f64,
    /// Top edge.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

/// Cells of a screen or pattern that a face is high, at least.
const CELLS: f32 = 14.0;
/// Faces of less than this share of the largest are of a crowd: they need not be read.
const CROWD: f64 = 0.55;
/// Pixels of a cell of a pattern at scale 1.
const PATTERN_CELL: f32 = 5.0;

/// Block, parameter, and the most of it for a face that is one pixel high; in pixels of a style.
const MOST: &[(&str, &str, f32)] = &[
    ("halftone", "pitch", 1.0 / CELLS),
    ("plates", "pitch", 1.0 / CELLS),
    ("engrave", "pitch", 1.0 / CELLS),
    ("pattern", "scale", 1.0 / CELLS / PATTERN_CELL),
    ("xdog", "sigma", 1.0 / 50.0),
    ("flow_lines", "sigma", 1.0 / 60.0),
    ("flow_lines", "shortest", 1.0 / 8.0),
    ("strokes", "width", 1.0 / 36.0),
    ("strokes", "length", 1.0 / 6.0),
    ("kuwahara", "radius", 1.0 / 14.0),
    ("flatten", "detail", 1.0 / 9.0),
    ("tvf", "time", 1.0 / 4.0),
    ("etf", "sigma", 1.0 / 28.0),
];
/// However small faces are, so much of a length stays, but of cells.
const LEAST: f32 = 0.5;

/// Spread of light in a face, from its fifth to its 95th percentile, up to which it is raised, and how much at most.
const CONTRAST: (f32, f32) = (110.0, 1.5);
/// Middle tones between which a face is left, and how far it is moved at most, in grey steps.
const LIGHT: (f32, f32, f32) = (92.0, 176.0, 30.0);
/// How much stronger than in the photo colours of a face may be, and what is always allowed, in grey steps.
const CHROMA: (f32, f32) = (1.35, 8.0);
/// Where the mask of a face begins to fall and where it ends, in half sides of its box.
const MASK: (f64, f64) = (0.9, 1.5);

/// Blocks that give a picture colours of its own: those in faces are then the style's, and stay.
const RECOLOUR: [&str; 6] = ["hue", "colorize", "plates", "flatten", "halftone", "paper"];

/// The faces of an image that are to be read.
pub(super) struct Care<'a> {
    faces: Vec<&'a FaceBox>,
    /// Height of the smallest, in pixels.
    height: f32,
}

impl<'a> Care<'a> {
    /// None where no face is in view.
    pub(super) fn of(faces: &'a [FaceBox], width: usize, height: usize) -> Option<Self> {
        let inside = |at: f64, side: usize| at > 0.0 && at < side as f64;
        let seen = |face: &&FaceBox| {
            face.height >= 1.0
                && inside(face.x + face.width / 2.0, width)
                && inside(face.y + face.height / 2.0, height)
        };
        let seen: Vec<&FaceBox> = faces.iter().filter(seen).collect();
        let largest = seen.iter().map(|face| face.height).fold(0.0, f64::max);
        let faces: Vec<&FaceBox> = seen.into_iter().filter(|face| face.height >= CROWD * largest).collect();
        let least = faces.iter().map(|face| face.height).reduce(f64::min)?;
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
        let luma = luma_plane(photo);
        let mut lit = photo.clone();
        for face in &self.faces {
            let Some((low, middle, high)) = light(&luma, face) else { continue };
            let gain = (CONTRAST.0 / (high - low).max(1.0)).clamp(1.0, CONTRAST.1);
            let move_by = (middle.clamp(LIGHT.0, LIGHT.1) - middle).clamp(-LIGHT.2, LIGHT.2);
            if gain <= 1.0 && move_by.abs() < 1.0 {
                continue;
            }
            each_pixel(face, photo.width(), photo.height(), |x, y, share| {
                let v = f32::from(luma.at(x, y));
                let by = share * ((v - middle) * (gain - 1.0) + move_by);
                for plane in lit.planes_mut() {
                    let sample = &mut plane.row_mut(y)[x];
                    *sample = (f32::from(*sample) + by).round().clamp(0.0, 255.0) as u8;
                }
            });
        }
        lit
    }

    /// What a style's colours made of a photo, those in faces held near the photo's.
    pub(super) fn held(&self, photo: &Image, mut drawn: Image, steps: &[Step]) -> Image {
        let own = |step: &Step| RECOLOUR.contains(&step.block.id) || step.block.output == Channels::Luma;
        let same_size = (drawn.width(), drawn.height()) == (photo.width(), photo.height());
        if photo.is_luma() || drawn.is_luma() || !same_size || steps.iter().any(|s| !s.bypass && own(s)) {
            return drawn;
        }
        for face in &self.faces {
            each_pixel(face, photo.width(), photo.height(), |x, y, share| {
                let of = |image: &Image| [0, 1, 2].map(|i| f32::from(image.planes()[i].at(x, y)));
                let (before, after) = (of(photo), of(&drawn));
                let most = CHROMA.0 * chroma(before) + CHROMA.1;
                let now = chroma(after);
                if now <= most {
                    return;
                }
                let kept = 1.0 - share * (1.0 - most / now);
                let y_luma = luma(after);
                for (plane, value) in drawn.planes_mut().iter_mut().zip(after) {
                    plane.row_mut(y)[x] = (y_luma + kept * (value - y_luma)).round().clamp(0.0, 255.0) as u8;
                }
            });
        }
        drawn
    }
}

fn shorten(step: &mut Step, height: f32) {
    for &(_, id, share) in MOST.iter().filter(|(block, ..)| *block == step.block.id) {
        let Some(i) = step.block.params.iter().position(|param| param.id == id) else { continue };
        let (value, least) = (step.values[i], step.block.params[i].kind.range().0);
        // A screen without a pitch has no cells.
        if value <= least {
            continue;
        }
        let is_cell = share <= 1.0 / CELLS && ["pitch", "scale"].contains(&id);
        let floor = if is_cell { least.max(if id == "pitch" { 3.0 } else { 0.0 }) } else { LEAST * value };
        step.values[i] = value.min((height * share).max(floor));
    }
}

fn luma([r, g, b]: [f32; 3]) -> f32 {
    0.299 * r + 0.587 * g + 0.114 * b
}

/// Distance from gray of the same luma.
fn chroma(rgb: [f32; 3]) -> f32 {
    let y = luma(rgb);
    ((rgb[2] - y) / 1.772).hypot((rgb[0] - y) / 1.402)
}

/// Fifth percentile, median and 95th of the light in the middle of a face; none where it has no pixel.
fn light(luma: &Plane, face: &FaceBox) -> Option<(f32, f32, f32)> {
    let mut counts = [0_u32; 256];
    let mut all = 0;
    each_pixel(face, luma.width(), luma.height(), |x, y, share| {
        if share >= 1.0 {
            counts[usize::from(luma.at(x, y))] += 1;
            all += 1;
        }
    });
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

/// Calls `f` with each pixel of a face's ellipse and its share of it, 0 to 1.
fn each_pixel(face: &FaceBox, width: usize, height: usize, mut f: impl FnMut(usize, usize, f32)) {
    let (rx, ry) = (face.width / 2.0, face.height / 2.0);
    let (cx, cy) = (face.x + rx, face.y + ry);
    let span = |centre: f64, radius: f64, side: usize| {
        let clamp = |at: f64| at.clamp(0.0, side as f64) as usize;
        clamp((centre - MASK.1 * radius).floor())..clamp((centre + MASK.1 * radius).ceil())
    };
    for y in span(cy, ry, height) {
        for x in span(cx, rx, width) {
            let (dx, dy) = ((x as f64 + 0.5 - cx) / rx, (y as f64 + 0.5 - cy) / ry);
            let t = ((MASK.1 - dx.hypot(dy)) / (MASK.1 - MASK.0)).clamp(0.0, 1.0);
            if t > 0.0 {
                f(x, y, (t * t * (3.0 - 2.0 * t)) as f32);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::{Context, stylize};

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
        let care = Care::of(&faces, 960, 540).unwrap();
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
        assert!(lines[2].values[2] * PATTERN_CELL <= 200.0 / 14.0 + 1e-3);
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
    fn colours_of_a_face_stay_near_the_photo_and_others_do_not() {
        let strong = style(r#"{"background":[{"block":"saturation","amount":4}]}"#);
        let photo = photo();
        let mut context = Context::for_image(&photo);
        context.show_faces(vec![face(40.0, 30.0, 60.0)]);
        let drawn = stylize(&photo, &strong, &mut context).unwrap();
        let at = |image: &Image, x, y| chroma([0, 1, 2].map(|i| f32::from(image.planes()[i].at(x, y))));
        assert!(at(&drawn, 64, 60) <= CHROMA.0 * at(&photo, 64, 60) + CHROMA.1 + 4.0);
        assert!(at(&drawn, 150, 110) > 2.5 * at(&photo, 150, 110));
    }

    #[test]
    fn a_dull_dark_face_gets_light() {
        let care = [face(40.0, 30.0, 60.0)];
        let photo = photo();
        let lit = Care::of(&care, 160, 120).unwrap().lit(&photo);
        let (before, after) = (luma_plane(&photo), luma_plane(&lit));
        let (_, was, _) = light(&before, &care[0]).unwrap();
        let (_, is, _) = light(&after, &care[0]).unwrap();
        assert!(is > was + 10.0, "{was} {is}");
        assert_eq!(before.row(118), after.row(118));
    }
}
