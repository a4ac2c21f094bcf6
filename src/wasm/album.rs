//! The photos that pages are planned from. They are told once: an album of hundreds is a megabyte of text, and a page is
//! planned with every shuffle, for every alternative and whenever a photo was searched for subjects.

use super::{parse, thrown};
use crate::error::{Error, Result};
use crate::framing::PhotoMeta;
use crate::page::request::Request;
use crate::page::shuffle;
use std::collections::{HashMap, HashSet};
use wasm_bindgen::prelude::*;

/// Photos by id.
#[wasm_bindgen]
#[derive(Default)]
pub struct Album {
    photos: HashMap<String, PhotoMeta>,
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
        self.photos.extend(photos.into_iter().map(|photo| (photo.id.clone(), photo)));
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
            let known =
                |id: &String| self.photos.get(id).cloned().ok_or_else(|| Error::MissingPhoto(id.clone()));
            let photos = ids.iter().map(known).collect::<Result<_>>()?;
            Ok(shuffle::plan(&Request { photos, ..parse(request, "request")? })?.to_json())
        };
        plan().map_err(thrown)
    }
}
