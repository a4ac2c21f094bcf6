//! Boards of saved projects on the command line: their shots as lists, and as sheets of frames.

use crate::CliError;
use crate::run::Run;
use inkpanel::survived;
use inkpanel_engine::document::listing::{ordered_shots, shot_list};
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::document::shots::{ASPECTS, logo_file};
use inkpanel_engine::framing::Subject;
use inkpanel_engine::output::board::{Logo, PictureOf, Request};
use inkpanel_engine::page::fill::framed_json;
use inkpanel_engine::page::import::import;
use inkpanel_engine::page::{Document, StyleRef};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use rayon::prelude::*;
use std::collections::HashMap;

/// The id of the logo on sheets: no photo of a project is called so.
pub(crate) const LOGO: &str = "board/logo";

/// The logo of a project's storyboard at full size. `None` if there is no logo.
///
/// # Errors
/// A sentence for one that cannot be read.
pub(crate) fn logo(run: &Run, saved: &Saved) -> Result<Option<Image>, CliError> {
    let Some(file) = logo_file(&saved.project().history.present.board.logo) else { return Ok(None) };
    let decoded = survived(|| Ok(decode(&file, &Limits::default())?))
        .map_err(|error: CliError| error.at("the logo of the board"))?;
    run.report.damage("the logo of the board", decoded.damage);
    Ok(Some(decoded.image))
}

/// The storyboard sheets of a project, in the style of its page. `title`: title for a project without a name.
/// `found`: subjects of a photo. `logo`: from [`logo`].
///
/// # Errors
/// A sentence for a photo that is not there or cannot be read, and for a project without shots.
pub(crate) fn sheets(
    saved: &mut Saved,
    frames: u32,
    (title, found): (&str, &HashMap<String, Vec<Subject>>),
    logo: Option<&Image>,
) -> Result<Vec<Document>, CliError> {
    let project = saved.project().clone();
    let present = &project.history.present;
    let board = &present.board;
    let aspect =
        ASPECTS.iter().find(|(name, _)| *name == board.aspect).map_or(16.0 / 9.0, |(_, aspect)| *aspect);
    let pictures = framed(&shown(saved)?, aspect, found)?;
    let mut list = shot_list(&project);
    if list.title.trim().is_empty() {
        title.clone_into(&mut list.title);
    }
    let style = present.page().map_or_else(StyleRef::default, |page| page.style.clone());
    let request = Request {
        list,
        pictures,
        frames: frames as usize,
        aspect,
        beside: board.beside,
        ruled: board.ruled,
        author: board.author.clone(),
        date: board.date.clone(),
        logo: logo
            .map(|image| Logo { photo: LOGO.into(), aspect: image.width() as f64 / image.height() as f64 }),
        style,
        ..Request::default()
    };
    Ok(request.sheets()?)
}

/// The photo of a shot.
pub(crate) struct ShotPhoto {
    /// Its id.
    pub(crate) id: String,
    /// File name.
    pub(crate) name: String,
    /// The file.
    pub(crate) file: Vec<u8>,
}

/// The photos of a project's shots, in their order.
///
/// # Errors
/// A sentence for a photo that is not in the project, and for a project without shots.
pub(crate) fn shown(saved: &mut Saved) -> Result<Vec<ShotPhoto>, CliError> {
    let ids: Vec<String> = ordered_shots(saved.project()).into_iter().map(str::to_owned).collect();
    if ids.is_empty() {
        return Err("the project has no shots".into());
    }
    let photo = |id: String| {
        let file = saved.photo_file(&id)?;
        let name = saved.photo(&id).map_or(id.as_str(), |photo| &photo.name).to_owned();
        let file = file.ok_or_else(|| {
            let why = format!("the photo {name} is not in it; save it again with the photos");
            CliError::new("missing-photo", why)
        })?;
        Ok(ShotPhoto { id, name, file })
    };
    ids.into_iter().map(photo).collect()
}

/// Crops of photos for an aspect ratio.
///
/// # Errors
/// A sentence for a photo that cannot be read.
pub(crate) fn framed(
    photos: &[ShotPhoto],
    aspect: f64,
    found: &HashMap<String, Vec<Subject>>,
) -> Result<Vec<PictureOf>, CliError> {
    let picture = |ShotPhoto { id, name, file }: &ShotPhoto| {
        let complain = |error: CliError| error.at(format_args!("the photo {name}"));
        let mut meta = survived(|| Ok(import(id, file, &Limits::default())?)).map_err(complain)?.meta;
        meta.find(found.get(id).cloned().unwrap_or_default());
        let framed: Vec<PictureOf> = serde_json::from_str(&framed_json([&meta].into_iter(), aspect))
            .map_err(|error| complain(CliError::fault(error)))?;
        framed.into_iter().next().ok_or_else(|| complain(CliError::fault("it has no crop")))
    };
    photos.par_iter().map(picture).collect()
}
