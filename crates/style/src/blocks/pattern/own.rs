//! Tones drawn with a custom texture. A tone of darkness d takes ink in the darkest parts of the texture,
//! which cover the share d. Each tone holds the ink of the lighter ones, as with the patterns of code.

use crate::context::Context;
use crate::error::Result;
use crate::raster::Plane;
use crate::raster::resize::{Region, resample};
use crate::texture::Texture;
use std::sync::Arc;

/// Width of the soft edge of a line, from ink to paper, in ranks of 255.
const EDGE: f32 = 24.0;

/// Longest side of a tile in pixels of the render, which bounds its memory, and its shortest.
const SIDES: (f32, f32) = (2.0, 4096.0);

/// A texture at the size at which it was drawn, each pixel's rank among all from 0, the darkest, to 255.
struct Drawn {
    texture: Arc<Texture>,
    ranks: Plane,
}

/// Draws luma in `levels` tones. A pixel of the texture is `scale` pixels of the render.
pub(super) fn fill(
    mut plane: Plane,
    texture: &Arc<Texture>,
    levels: usize,
    scale: f32,
    context: &mut Context<'_>,
) -> Result<Plane> {
    context.check_cancelled()?;
    let side = |side: usize| (side as f32 * scale).round().clamp(SIDES.0, SIDES.1) as usize;
    let tones = texture.tones();
    let (width, height) = (side(tones.width()), side(tones.height()));
    let fits = |drawn: &Drawn| {
        (drawn.ranks.width(), drawn.ranks.height()) == (width, height) && drawn.texture == *texture
    };
    let drawn = context.take().filter(fits).unwrap_or_else(|| {
        let whole = Region::whole(tones.width(), tones.height());
        let sized = if (tones.width(), tones.height()) == (width, height) {
            tones.clone()
        } else {
            resample(tones, whole, width, height)
        };
        Drawn { texture: texture.clone(), ranks: ranked(sized) }
    });
    let inks: Vec<[u8; 256]> = (0..levels).map(|level| ink(level, levels)).collect();
    for y in 0..plane.height() {
        let ranks = drawn.ranks.row(y % height);
        for part in plane.row_mut(y).chunks_mut(width) {
            for (sample, &rank) in part.iter_mut().zip(ranks) {
                *sample = inks[usize::from(*sample) * levels / 256][usize::from(rank)];
            }
        }
    }
    context.give(drawn);
    Ok(plane)
}

/// Tone of each rank: 0 for ink, 255 for paper.
fn ink(level: usize, levels: usize) -> [u8; 256] {
    let darkness = 1.0 - level as f32 / (levels - 1) as f32;
    std::array::from_fn(|rank| {
        let past = (rank as f32 - 255.0 * darkness) / EDGE;
        match level {
            0 => 0,
            _ if level + 1 == levels => 255,
            _ => ((past + 0.5).clamp(0.0, 1.0) * 255.0).round() as u8,
        }
    })
}

/// Tones as ranks: the number of darker tones plus half the number of equal ones.
fn ranked(mut plane: Plane) -> Plane {
    let mut counts = [0_u64; 256];
    for &tone in plane.samples() {
        counts[usize::from(tone)] += 1;
    }
    let all = plane.samples().len().max(1) as u64;
    let mut below = 0;
    let ranks = counts.map(|count| {
        let twice = 2 * below + count;
        below += count;
        ((twice * 255 + all) / (2 * all)).min(255) as u8
    });
    for sample in plane.samples_mut() {
        *sample = ranks[usize::from(*sample)];
    }
    plane
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::tests::url_of;

    fn texture() -> Arc<Texture> {
        Arc::new(Texture::read(&url_of(48, 48, |x, y| if (x + y) % 12 < 4 { 20 } else { 240 })).unwrap())
    }

    #[test]
    fn tones_of_a_picture_of_two_tones_cover_what_they_should_at_every_scale() {
        for scale in [0.25, 0.6, 1.0, 2.3] {
            for level in 0..5_u8 {
                let gray = Plane::filled(300, 300, level * 63);
                let drawn = fill(gray, &texture(), 5, scale, &mut Context::default()).unwrap();
                let mean = drawn.samples().iter().map(|&v| f64::from(v)).sum::<f64>() / 90_000.0;
                let wanted = f64::from(level) * 63.75;
                // A tile of twelve pixels has few ranks, and soft edges on all of them.
                assert!((mean - wanted).abs() < 25.0, "scale {scale}, level {level}: {mean} for {wanted}");
            }
        }
    }

    #[test]
    fn another_texture_in_the_same_context_is_drawn_anew() {
        let other = Arc::new(Texture::read(&url_of(48, 48, |x, _| (x * 5) as u8)).unwrap());
        let mut context = Context::default();
        let mut draw =
            |texture: &Arc<Texture>| fill(Plane::filled(96, 96, 128), texture, 5, 1.0, &mut context).unwrap();
        let (first, second) = (draw(&texture()), draw(&other));
        assert!(first != second);
        assert!(draw(&texture()) == first);
    }
}
