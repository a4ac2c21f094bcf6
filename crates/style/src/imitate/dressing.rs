//! A designed style in the colours of a picture: its colour steps give way to some that take the picture's palette over.

use super::colours::{Colour, MOST, SEVERAL, delta_e, hues, oklab};
use super::features::Features;
use super::inks::Inks;
use crate::Style;
use crate::blocks::{self, Block};
use crate::file::Step;
use crate::order::sort_by;
use crate::params::{MIN_PITCH, Repeat, colour_value};

/// How the colours are taken over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dress {
    /// Only the colour of the lines.
    Lines,
    /// Lines on a blank sheet.
    Blank,
    /// One ink on a tinted sheet, in the tones of the photo.
    Mono,
    /// Up to three inks on a tinted sheet.
    Plates,
    /// Flat areas of the palette.
    Flats,
    /// Flat areas, painted over.
    Painted,
}

pub(super) const ALL: [Dress; 6] =
    [Dress::Lines, Dress::Blank, Dress::Mono, Dress::Plates, Dress::Flats, Dress::Painted];

/// Features of the picture that candidate styles must match.
#[derive(Debug, Clone)]
pub(super) struct Wanted {
    pub(super) features: Features,
    pub(super) inks: Inks,
}

impl Wanted {
    pub(super) fn new(features: Features) -> Self {
        Self { inks: Inks::of(&features.palette), features }
    }

    fn lightest_first(&self) -> Vec<Colour> {
        let mut palette = self.features.palette.clone();
        sort_by(&mut palette, |a, b| oklab(b.rgb)[0].total_cmp(&oklab(a.rgb)[0]));
        palette.retain(|colour| colour.share > 0.004);
        palette
    }
}

/// Applies a variant to a style. Returns `None` if that is impossible or has no effect.
pub(super) fn dressed(style: &Style, dress: Dress, wanted: &Wanted) -> Option<Style> {
    let mut out = style.clone();
    let light_ink = oklab(style.ink)[0] > 0.6;
    let by_light = wanted.lightest_first();
    let ink = if light_ink { by_light.first() } else { by_light.last() }?.rgb;
    if out.foreground.is_some() {
        out.ink = ink;
    }
    let screen = wanted.features.screen;
    match dress {
        Dress::Lines => {
            out.foreground.as_ref()?;
            if delta_e(out.ink, style.ink) < 2.0 && screen.pitch == 0.0 {
                return None;
            }
        }
        Dress::Blank => {
            out.foreground.as_ref()?;
            let sheet = if light_ink { by_light.last()?.rgb } else { wanted.inks.paper };
            let bias = sheet.map(f32::from);
            out.background = vec![
                step("brightness", &[("gain", 0.0)])?,
                step("hue", &[("red", bias[0]), ("green", bias[1]), ("blue", bias[2])])?,
            ];
        }
        Dress::Mono | Dress::Plates => {
            // One ink is not the look of a picture in several hues.
            if dress == Dress::Mono && hues(&wanted.features.palette) > SEVERAL {
                return None;
            }
            let inks = &wanted.inks.inks;
            let inks = if dress == Dress::Mono { &inks[..1] } else { &inks[..] };
            if dress == Dress::Plates && inks.len() < 2 {
                return None;
            }
            // Dots come from the plates, or from the style's own screen.
            let dots = screen.pitch > 0.0 && screen.directed > 0.25;
            let kept = body(&style.background, dress == Dress::Mono, if dots { &["halftone"] } else { &[] })?;
            let own = kept.iter().any(|step| ["pattern", "engrave", "strokes"].contains(&step.block.id));
            let pitch = if dots && !own { screen.pitch.clamp(3.0, 30.0) } else { 0.0 };
            let ink = |i: usize| colour_value(inks.get(i).copied().unwrap_or([255; 3]));
            out.background = kept;
            out.background.push(step(
                "plates",
                &[
                    ("inks", 11.0),
                    ("shift", if inks.len() > 1 { 2.0 } else { 0.0 }),
                    ("grain", 0.0),
                    ("pitch", pitch),
                    ("ink_1", ink(0)),
                    ("ink_2", ink(1)),
                    ("ink_3", ink(2)),
                ],
            )?);
            out.background.push(sheet(wanted.inks.paper)?);
        }
        Dress::Flats | Dress::Painted => {
            let mut kept = body(&style.background, false, &["halftone", "strokes"])?;
            let brush = kept.iter().rposition(|step| ["kuwahara", "etf", "painter"].contains(&step.block.id));
            let flat = flats(&wanted.features.palette)?;
            match (dress, brush) {
                (Dress::Flats, _) => kept.push(flat),
                (_, Some(brush)) => kept.insert(brush, flat),
                (_, None) => return None,
            }
            out.background = kept;
        }
    }
    pitched(&mut out, screen.pitch);
    // The parser checks that gray and colour inputs match.
    Style::from_value("imitation", &out.to_value()).ok()
}

/// The steps of a background that do not colour. `gray` makes it gray first.
fn body(background: &[Step], gray: bool, without: &[&str]) -> Option<Vec<Step>> {
    let luma_only = background.iter().any(|step| ["pattern", "engrave"].contains(&step.block.id));
    let dropped = |block: &Block| {
        block.is_coloring || without.contains(&block.id) || (block.id == "to_gray" && !luma_only)
    };
    let mut kept: Vec<Step> = background.iter().filter(|step| !dropped(step.block)).cloned().collect();
    // Without a tone to reproduce, blocks that only make an even tone have no use.
    if background.iter().any(|step| step.block.id == "brightness" && step.values[0] == 0.0) {
        kept.clear();
        kept.push(step("equalize", &[("low", 1.0), ("high", 92.0)])?);
    }
    if gray && !kept.iter().any(|step| step.block.id == "to_gray") {
        kept.push(step("to_gray", &[])?);
    }
    Some(kept)
}

/// Flat areas of these colours.
pub(super) fn flats(palette: &[Colour]) -> Option<Step> {
    let colours = palette.iter().filter(|colour| colour.share > 0.004).take(MOST);
    let mut values = vec![("palette", 9.0), ("detail", 10.0), ("smoothness", 50.0)];
    let names = ["color_1", "color_2", "color_3", "color_4", "color_5", "color_6", "color_7", "color_8"];
    let own: Vec<_> = names.into_iter().zip(colours).map(|(name, c)| (name, colour_value(c.rgb))).collect();
    values.push(("colors", own.len().max(2) as f32));
    if own.len() == 1 {
        values.push(("color_2", own[0].1));
    }
    values.extend(own);
    step("flatten", &values)
}

/// A sheet of that colour with a little grain.
fn sheet(tint: [u8; 3]) -> Option<Step> {
    let values = [("tint", 8.0), ("grain", 8.0), ("pigment", 4.0), ("color", colour_value(tint))];
    step("paper", &values)
}

/// Sets the pitch of all screens of a style, unless `pitch` is 0.
pub(super) fn pitched(style: &mut Style, pitch: f32) {
    if pitch <= 0.0 {
        return;
    }
    for step in layers(style).flatten() {
        for (param, value) in step.block.params.iter().zip(&mut step.values) {
            if param.repeat == Some(Repeat::Pitch) && *value >= MIN_PITCH {
                *value = param.rounded(pitch);
            }
        }
    }
}

/// Multiplies the size of all repeating structures by a factor. Returns whether the style has any.
pub(super) fn scaled(style: &mut Style, factor: f32) -> bool {
    let mut any = false;
    for step in layers(style).flatten() {
        for (param, value) in step.block.params.iter().zip(&mut step.values) {
            let repeats = match param.repeat {
                Some(Repeat::Pitch) => *value >= MIN_PITCH,
                Some(Repeat::Size) => true,
                None => false,
            };
            if repeats {
                *value = param.rounded(*value * factor);
                any = true;
            }
        }
    }
    any
}

/// Both layers, to be changed.
pub(super) fn layers(style: &mut Style) -> impl Iterator<Item = &mut Vec<Step>> {
    std::iter::once(&mut style.background).chain(style.foreground.as_mut())
}

/// A block with some of its values.
pub(super) fn step(block: &str, values: &[(&str, f32)]) -> Option<Step> {
    let mut step = Step::new(blocks::find(block)?);
    for &(name, value) in values {
        let at = step.block.params.iter().position(|param| param.id == name)?;
        step.values[at] = step.block.params[at].rounded(value);
    }
    Some(step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::catalogue;
    use crate::raster::{Image, Plane};
    use crate::{Context, stylize};

    fn wanted() -> Wanted {
        let print = Image::from_rgb([[248, 30], [239, 40], [220, 90]].map(|[paper, ink]: [u8; 2]| {
            Plane::from_fn(240, 160, move |x, y| if x % 8 < 3 && y % 8 < 3 { ink } else { paper })
        }));
        Wanted::new(Features::of(&print.unwrap()))
    }

    #[test]
    fn every_dress_of_every_style_is_a_valid_file_that_draws() {
        let wanted = wanted();
        let photo =
            Image::from_rgb([3, 5, 7].map(|k| Plane::from_fn(60, 40, |x, y| ((x * k) ^ (y * 4)) as u8)));
        let photo = photo.unwrap();
        let mut made = 0;
        for style in catalogue() {
            for dress in ALL {
                let Some(style) = dressed(style, dress, &wanted) else { continue };
                made += 1;
                let drawn = stylize(&photo, &style, &mut Context::for_image(&photo)).unwrap();
                assert_eq!((drawn.width(), drawn.height()), (60, 40));
            }
        }
        assert!(made > 4 * catalogue().len(), "{made}");
    }

    #[test]
    fn one_ink_and_its_sheet_are_those_of_the_picture() {
        let wanted = wanted();
        assert_eq!(wanted.inks.paper, [248, 239, 220]);
        let comic = crate::catalogue::find("comic").unwrap();
        let style = dressed(comic, Dress::Mono, &wanted).unwrap();
        let photo = Image::from_luma(Plane::from_fn(60, 40, |x, _| if x < 30 { 255 } else { 0 }));
        let drawn = stylize(&photo, &style, &mut Context::for_image(&photo)).unwrap();
        let at = |x: usize| [0, 1, 2].map(|c: usize| drawn.planes()[c].at(x, 20));
        assert!(delta_e(at(8), [248, 239, 220]) < 3.0, "{:?}", at(8));
        assert!(delta_e(at(52), [30, 40, 90]) < 6.0, "{:?}", at(52));
    }
}
