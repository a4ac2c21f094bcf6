//! Boards of saved projects on the command line: their shots as lists, and as sheets of frames.

use crate::{Complaint, survived};
use inkpanel::document::saved::Saved;
use inkpanel::document::shots::ASPECTS;
use inkpanel::framing::Subject;
use inkpanel::output::board::{PictureOf, Request};
use inkpanel::page::Document;
use inkpanel::page::fill::framed_json;
use inkpanel::page::import::import;
use inkpanel::raster::decode::Limits;
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::HashMap;

/// The style of a project without a page.
const STYLE: &str = "storyboard";

/// The sheets of a project's board, in the style of its page. `title`: what it is called where it has no name; `found`: what is
/// known to be in a photo.
///
/// # Errors
/// A sentence for a photo that is not there or cannot be read, and for a project without shots.
pub(crate) fn sheets(
    saved: &mut Saved,
    frames: u32,
    (title, found): (&str, &HashMap<String, Vec<Subject>>),
) -> Result<Vec<Document>, Complaint> {
    let project = saved.project().clone();
    let ids = project.shots();
    if ids.is_empty() {
        return Err("there is no shot in it".into());
    }
    let mut files = Vec::new();
    for id in &ids {
        let file = saved.photo_file(id).map_err(|error| error.to_string())?;
        let name = project.photos.iter().find(|photo| photo.id == *id).map_or(*id, |photo| &photo.name);
        files.push((
            *id,
            name,
            file.ok_or_else(|| format!("the photo {name} is not in it; save it again with the photos"))?,
        ));
    }
    let board = &project.history.present.board;
    let aspect =
        ASPECTS.iter().find(|(name, _)| *name == board.aspect).map_or(16.0 / 9.0, |(_, aspect)| *aspect);
    let pictures: Vec<PictureOf> = files
        .par_iter()
        .map(|(id, name, file)| {
            let complain = |reason: String| format!("the photo {name}: {reason}");
            let mut meta = survived(|| import(id, file, &Limits::default())).map_err(complain)?.meta;
            let subjects = found.get(*id).cloned().unwrap_or_default();
            meta.find(subjects);
            let framed: Value = serde_json::from_str(&framed_json([&meta].into_iter(), aspect))
                .map_err(|error| complain(error.to_string()))?;
            serde_json::from_value(framed[0].clone()).map_err(|error| complain(error.to_string()))
        })
        .collect::<Result<_, Complaint>>()?;
    let present = &project.history.present;
    let mut list = project.shot_list();
    if list.title.trim().is_empty() {
        title.clone_into(&mut list.title);
    }
    let style = present.page.as_ref().map_or_else(|| json!(STYLE), |page| page.style.clone());
    let request = Request {
        list,
        pictures,
        frames: frames as usize,
        aspect,
        beside: board.beside,
        ruled: board.ruled,
        author: board.author.clone(),
        date: board.date.clone(),
        style,
        ..Request::default()
    };
    request.sheets().map_err(|error| error.to_string())
}
