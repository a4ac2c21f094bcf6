//! Layers and blocks that apply to a part of the picture: to its subject or to the background.
//!
//! If the subject is unknown or too vague to be cut out, the whole picture is the subject. A style that uses
//! parts must look complete in that case.

use super::context::Context;
use crate::raster::guided::{refined, steepen};
use crate::raster::resize::{Region, resample, resample_image};
use crate::raster::{Image, Matte, Plane};
use crate::simd::point::luma_plane;

/// A part of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "StylePart", rename_all = "lowercase"))]
pub enum Part {
    /// The subject of the photo.
    Subject,
    /// The background of the subject.
    Background,
}

/// The parts that the layers of a style apply to; the whole picture if a layer defines no part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "LayerParts", optional_fields))]
pub struct Parts {
    /// The part of the colour layer: the photo is unchanged outside it.
    pub background: Option<Part>,
    /// The part of the line layer: no lines are drawn outside it.
    pub foreground: Option<Part>,
}

impl Part {
    /// By the name that style files have for it.
    #[must_use]
    pub fn of(name: &str) -> Option<Self> {
        match name {
            "subject" => Some(Self::Subject),
            "background" => Some(Self::Background),
            _ => None,
        }
    }

    /// The name that style files have for it.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Subject => "subject",
            Self::Background => "background",
        }
    }

    /// The share of a pixel in this part, from its share in the subject.
    fn share(self, subject: u8) -> u32 {
        u32::from(if self == Self::Subject { subject } else { 255 - subject })
    }
}

/// Factor that steepens the border: faint parts fall outside the subject, nearly solid parts inside.
const STEEPER: i32 = 2;

/// Returns the subject mask at the size of `picture`, refined at its edges, or `None` if the mask is vague.
/// `picture` shows `region` of a photo of `size` pixels. `scale` is the scale of lengths.
#[must_use]
pub fn subject_in(
    matte: &Matte,
    region: Region,
    size: (usize, usize),
    (picture, scale): (&Image, f32),
) -> Option<Plane> {
    if matte.facts().is_vague() {
        return None;
    }
    let shares = matte.plane();
    let (across, down) =
        (shares.width() as f64 / size.0.max(1) as f64, shares.height() as f64 / size.1.max(1) as f64);
    let region = Region {
        x: region.x * across,
        y: region.y * down,
        width: region.width * across,
        height: region.height * down,
    };
    let mut subject = refined(&shares, region, picture, scale);
    steepen(&mut subject, STEEPER);
    Some(subject)
}

/// Limits the result of a block or layer to one part of the picture. The result has colour if one of the two
/// pictures has it, even without a subject mask. It has the size of `before`.
#[inline(never)]
pub(crate) fn mixed(before: Image, after: Image, part: Part, context: &Context<'_>) -> Image {
    let (width, height) = (before.width(), before.height());
    let after = if (after.width(), after.height()) == (width, height) {
        after
    } else {
        resample_image(&after, Region::whole(after.width(), after.height()), width, height)
    };
    let (before, mut after) =
        if before.is_luma() == after.is_luma() { (before, after) } else { (widened(before), widened(after)) };
    let Some(subject) = context.subject() else {
        return if part == Part::Subject { after } else { before };
    };
    let subject = sized(subject, width, height);
    for (plane, before) in after.planes_mut().iter_mut().zip(before.planes()) {
        for ((after, before), share) in
            plane.samples_mut().iter_mut().zip(before.samples()).zip(subject.samples())
        {
            let share = part.share(*share);
            *after = ((u32::from(*after) * share + u32::from(*before) * (255 - share) + 127) / 255) as u8;
        }
    }
    after
}

/// Lines that are white outside of their part.
pub(crate) fn lines_in(lines: &Image, part: Part, context: &Context<'_>) -> Image {
    let none = Image::from_luma(Plane::filled(lines.width(), lines.height(), 255));
    mixed(none, Image::from_luma(luma_plane(lines)), part, context)
}

/// Gray as three equal channels.
pub(crate) fn widened(image: Image) -> Image {
    if !image.is_luma() {
        return image;
    }
    let y = &image.planes()[0];
    // The three copies have one size, so this cannot fail; the luma image is the fallback.
    Image::from_rgb([y.clone(), y.clone(), y.clone()]).unwrap_or(image)
}

fn sized(plane: &Plane, width: usize, height: usize) -> Plane {
    if (plane.width(), plane.height()) == (width, height) {
        return plane.clone();
    }
    resample(plane, Region::whole(plane.width(), plane.height()), width, height)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stages::Stages;
    use crate::{Style, stylize};

    const WIDTH: usize = 48;
    const HEIGHT: usize = 32;

    fn photo() -> Image {
        Image::from_rgb([3, 5, 7].map(|k| Plane::from_fn(WIDTH, HEIGHT, |x, y| (x * k + y * 3 + 20) as u8)))
            .unwrap()
    }

    /// The left half.
    fn half() -> Plane {
        Plane::from_fn(WIDTH, HEIGHT, |x, _| if x < WIDTH / 2 { 255 } else { 0 })
    }

    fn drawn(json: &str, subject: Option<Plane>) -> Vec<u8> {
        let style = Style::parse("test.json", json).unwrap();
        let photo = photo();
        let mut context = Context::for_image(&photo);
        context.show_subject(subject.clone());
        let whole = stylize(&photo, &style, &mut context).unwrap().to_rgb();
        // The designer draws the same.
        let mut stages = Stages::new(photo, subject);
        stages.set(style);
        while stages.advance(&mut context).unwrap().is_some() {}
        assert!(stages.result().to_rgb() == whole, "{json}");
        assert!(context.subject().is_none(), "the next picture has another subject");
        whole
    }

    /// The pixels of the left or the right half.
    fn side(rgb: &[u8], right: bool) -> Vec<u8> {
        let from = if right { WIDTH * 3 / 2 } else { 0 };
        rgb.chunks_exact(WIDTH * 3).flat_map(|row| row[from..from + WIDTH * 3 / 2].to_vec()).collect()
    }

    #[test]
    fn a_block_changes_its_part_alone() {
        let two = r#"{"block":"posterize","levels":2"#;
        let whole = drawn(&format!(r#"{{"background":[{two}}}]}}"#), None);
        let plain = photo().to_rgb();
        for (part, right) in [("subject", false), ("background", true)] {
            let json = format!(r#"{{"background":[{two},"where":"{part}"}}]}}"#);
            let rgb = drawn(&json, Some(half()));
            assert_eq!(side(&rgb, right), side(&whole, right), "{part}");
            assert_eq!(side(&rgb, !right), side(&plain, !right), "{part}");
            // Without a mask all is subject.
            assert_eq!(drawn(&json, None), if right { plain.clone() } else { whole.clone() }, "{part}");
        }
    }

    #[test]
    fn gray_in_one_part_leaves_the_colours_of_the_other() {
        let gray = drawn(r#"{"background":[{"block":"to_gray"}]}"#, None);
        let json =
            r#"{"background":[{"block":"to_gray","where":"background"},{"block":"saturation","amount":1}]}"#;
        let rgb = drawn(json, Some(half()));
        assert_eq!(side(&rgb, true), side(&gray, true));
        assert_eq!(side(&rgb, false), side(&photo().to_rgb(), false));
        // Colour comes back in only one part.
        let json = r#"{"background":[{"block":"to_gray"},{"block":"to_color","where":"subject"}]}"#;
        let rgb = drawn(json, Some(half()));
        assert_eq!(side(&rgb, true), side(&gray, true));
        assert_ne!(side(&rgb, false), side(&gray, false));
    }

    #[test]
    fn a_layer_is_of_its_part_alone() {
        let layers = r##""background":[{"block":"posterize","levels":2}],"foreground":[{"block":"brightness","gain":0,"channels":"each"}],"ink":"#ff0000""##;
        let colours = drawn(r#"{"background":[{"block":"posterize","levels":2}]}"#, None);
        let red = [255, 0, 0].repeat(WIDTH * HEIGHT / 2);
        let json = format!(r#"{{{layers},"where":{{"foreground":"background"}}}}"#);
        let rgb = drawn(&json, Some(half()));
        assert!(side(&rgb, true) == red);
        assert!(side(&rgb, false) == side(&colours, false));
        assert!(drawn(&json, None) == colours);
        let json = format!(r#"{{{layers},"where":{{"background":"background","foreground":"subject"}}}}"#);
        let rgb = drawn(&json, Some(half()));
        assert!(side(&rgb, false) == red);
        assert!(side(&rgb, true) == side(&colours, true));
    }

    #[test]
    fn a_block_of_another_size_is_brought_back() {
        let json = r#"{"background":[{"block":"size","percent":50,"where":"background"},{"block":"posterize","levels":2,"where":"subject"}]}"#;
        let rgb = drawn(json, Some(half()));
        let two = drawn(r#"{"background":[{"block":"posterize","levels":2}]}"#, None);
        assert_eq!(side(&rgb, false), side(&two, false));
        let json = r#"{"background":[{"block":"size","percent":50},{"block":"posterize","levels":2,"where":"subject"}]}"#;
        assert_eq!(drawn(json, Some(half())).len(), WIDTH * HEIGHT * 3);
    }

    #[test]
    fn two_blocks_for_both_parts_start_from_the_same_picture() {
        // A blur looks across the border.
        let blur = |part: &str| format!(r#"{{"block":"gaussian","sigma":50{part}}}"#);
        let [all, subject, background] = ["", r#","where":"subject""#, r#","where":"background""#].map(blur);
        let colours =
            |blocks: &[&str]| drawn(&format!(r#"{{"background":[{}]}}"#, blocks.join(",")), Some(half()));
        let once = colours(&[&all]);
        assert!(colours(&[&subject, &background]) == once);
        let bypassed = blur(r#","bypass":true"#);
        assert!(colours(&[&background, &bypassed, &subject]) == once);
        // A third block starts from the result of both.
        let thrice = colours(&[&subject, &background, &subject]);
        assert!(side(&thrice, true) == side(&once, true));
        assert!(side(&thrice, false) == side(&colours(&[&all, &subject]), false));
        // Another block between them separates them.
        assert!(
            colours(&[&subject, r#"{"block":"posterize"}"#, &background])
                != colours(&[&all, r#"{"block":"posterize"}"#])
        );
    }

    #[test]
    fn vague_subjects_and_empty_ones_are_none() {
        let photo = photo();
        let seen = |shares: Plane| {
            let matte = Matte::new(&shares, (WIDTH, HEIGHT));
            subject_in(&matte, Region::whole(WIDTH, HEIGHT), (WIDTH, HEIGHT), (&photo, 0.1)).is_some()
        };
        assert!(seen(half()));
        assert!(!seen(Plane::filled(WIDTH, HEIGHT, 0)));
        assert!(!seen(Plane::from_fn(WIDTH, HEIGHT, |x, _| (x * 5) as u8)));
    }
}
