//! The photos that pages are planned from. They are told once: an album of hundreds is a megabyte of text, and a page is
//! planned with every shuffle, for every alternative and whenever a photo was searched for subjects.

use super::{parse, thrown};
use crate::error::{Error, Result};
use crate::framing::PhotoMeta;
use crate::page::request::Request;
use crate::page::shuffle;
use crate::plan::prepared::{Place, Shelf};
use std::collections::{HashMap, HashSet};
use wasm_bindgen::prelude::*;

/// Photos by id.
#[wasm_bindgen]
#[derive(Default)]
pub struct Album {
    /// What is told of each, and what plans found out about it.
    photos: HashMap<String, (PhotoMeta, Place)>,
}

#[wasm_bindgen]
impl Album {
    /// An empty album.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Learns what is known of some photos, a JSON array; each takes the place of the photo with its id.
    pub fn know(&mut self, photos: &str) -> std::result::Result<(), JsValue> {
        let photos: Vec<PhotoMeta> = parse(photos, "photos").map_err(thrown)?;
        for photo in photos {
            // Told again as it was, a photo is not looked at again.
            if self.photos.get(&photo.id).is_none_or(|(known, _)| *known != photo) {
                self.photos.insert(photo.id.clone(), (photo, Place::default()));
            }
        }
        Ok(())
    }

    /// Forgets all but these photos, a JSON array of ids.
    pub fn keep(&mut self, ids: &str) -> std::result::Result<(), JsValue> {
        let ids: HashSet<String> = parse(ids, "photos").map_err(thrown)?;
        self.photos.retain(|id, _| ids.contains(id));
        Ok(())
    }

    /// A new document from photos, locks and a seed; see `page::request::Request`, whose photos are `ids`, a JSON array.
    pub fn plan(&self, request: &str, ids: &str) -> std::result::Result<String, JsValue> {
        let plan = || -> Result<String> {
            let ids: Vec<String> = parse(ids, "photos")?;
            let (mut photos, mut places) = (Vec::new(), Vec::new());
            for id in ids {
                let (photo, place) = self.photos.get(&id).ok_or_else(|| Error::MissingPhoto(id.clone()))?;
                photos.push(photo.clone());
                places.push(Place::clone(place));
            }
            let request = Request { photos, ..parse(request, "request")? };
            Ok(shuffle::planned(&request, &Shelf::of(places))?.document.to_json())
        };
        plan().map_err(thrown)
    }
}
