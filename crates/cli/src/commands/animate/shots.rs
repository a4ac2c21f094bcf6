//! The shots of a board one after the other.

use super::Animate;
use super::drawn::Drawn;
use super::reel::Step;
use crate::boards::{self, ShotPhoto};
use crate::commands::read_style;
use crate::masks::Masks;
use crate::run::Run;
use crate::{CliError, detectors, reopening};
use inkpanel::survived;
use inkpanel_engine::document::listing::shot_list;
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::native;
use inkpanel_engine::output::animatic::{Animatic, Clip, Picture, Request};
use inkpanel_engine::output::board::PictureOf;
use inkpanel_engine::page::words::Letters;
use inkpanel_engine::page::words::draw;
use inkpanel_engine::page::words::given::GivenFonts;
use inkpanel_engine::page::{Patch, StyleRef};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use serde_json::{Value, json};
use std::collections::HashMap;

/// The timed shots of a project, and the resources to draw them.
pub(super) struct Shots<'r> {
    pub(super) plan: Animatic,
    photos: Vec<ShotPhoto>,
    masks: Masks<'r>,
    letters: Letters,
}

impl<'r> Shots<'r> {
    pub(super) fn of(
        run: &'r Run,
        mut saved: Saved,
        asked: &Animate,
        fonts: &GivenFonts,
    ) -> Result<Self, CliError> {
        let masks = reopening::masks(run, &saved);
        let photos = boards::shown(&mut saved)?;
        let request = request(run, &saved, asked, &photos)?;
        let plan = request.planned()?;
        let style = plan.clips[0].picture.style()?;
        detectors::warn_about_models(run, [style.as_ref()]);
        if !style.has_parts() {
            let moving = photos.iter().filter(|photo| super::is_of_film(&saved, &photo.id)).count();
            super::tell_still(run, moving, ("shot", "shots"));
        }
        let words = plan.clips.iter().filter_map(|clip| clip.caption.as_ref()).flat_map(|page| &page.words);
        let letters = fonts.letters(words)?;
        Ok(Self { plan, photos, masks, letters })
    }

    pub(super) fn steps(&self) -> Vec<Step> {
        let step = |clip: &Clip| Step {
            frames: clip.start..clip.start + clip.frames,
            called: format!("shot {}", clip.number),
            event: json!({ "event": "shot", "shot": clip.number }),
        };
        self.plan.clips.iter().map(step).collect()
    }

    /// Each shot with its frames, as JSON for programs.
    pub(super) fn told(&self) -> Value {
        let told = |clip: &Clip| {
            json!({
                "shot": clip.number, "first": clip.start + 1, "frames": clip.frames,
                "from": clip.first, "to": clip.last,
            })
        };
        self.plan.clips.iter().map(told).collect()
    }

    /// The picture of a clip in its style, from the photo at its full size, and its caption.
    pub(super) fn drawn(&self, clip: usize) -> Result<Drawn, CliError> {
        let document = &self.plan.clips[clip].picture;
        let ShotPhoto { id, name, file } = &self.photos[clip];
        let photo = survived(|| Ok(decode(file, &Limits::default())?))
            .map_err(|error: CliError| error.at(format_args!("the photo {name}")))?;
        self.masks.run.report.damage(name, photo.damage);
        let subject = self.masks.asked_by(&*document.style()?, id, &photo.image);
        let photos = HashMap::from([(id.clone(), native::Photo { image: photo.image, subject })]);
        let sheet = native::sheet(document, &photos, &GivenFonts::default())?;
        let picture = Image::from_interleaved_rgb(sheet.width(), sheet.height(), sheet.rgb())?;
        Ok(Drawn::Shot(picture, self.caption(&self.plan.clips[clip])?))
    }

    /// The caption of a clip, if any, at its position in the frame.
    fn caption(&self, clip: &Clip) -> Result<Option<Patch>, CliError> {
        let Some(document) = &clip.caption else { return Ok(None) };
        let [width, height] = self.plan.size.map(|side| side as usize);
        let mut patch = draw::render(document, 0, width, &self.letters)?;
        let foot = (Animatic::FOOT * height as f64).round() as i64;
        patch.area.x = (width as i64 - patch.area.width as i64) / 2;
        patch.area.y = (height as i64 - foot - patch.area.height as i64).max(0);
        Ok(Some(patch))
    }
}

/// The request for a project's shots.
fn request(run: &Run, saved: &Saved, asked: &Animate, photos: &[ShotPhoto]) -> Result<Request, CliError> {
    let found = reopening::known(saved);
    let aspect = f64::from(asked.size[0]) / f64::from(asked.size[1]);
    let picture = |PictureOf { photo, crop, faces }: PictureOf| {
        let subjects = found.get(&photo).cloned().unwrap_or_default();
        Ok(Picture { photo, crop: crop.ok_or("a photo has no crop")?, faces, subjects })
    };
    let pictures = boards::framed(photos, aspect, &found)?;
    let project = saved.project();
    let page = project.history.present.page();
    let style = match &asked.style {
        Some(style) => StyleRef::of(&read_style(run, style)?),
        None => page.map_or_else(StyleRef::default, |page| page.style.clone()),
    };
    Ok(Request {
        list: shot_list(project),
        pictures: pictures.into_iter().map(picture).collect::<Result<_, CliError>>()?,
        size: asked.size,
        fps: asked.fps.unwrap_or(0),
        seconds: asked.seconds,
        dissolve: asked.dissolve,
        moves: !asked.still,
        captions: asked.captions,
        living: 0,
        style,
    })
}
