//! The photos that pages are planned from. They are passed only once, because an album of hundreds of photos
//! is a megabyte of text, and plans are frequent.

use super::parse;
use super::planning::parse_request;
use inkpanel_engine::document::planning::{Known, planned_of};
use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::page::fill::framed_json;
use inkpanel_engine::plan::prepared::Place;
use std::collections::{HashMap, HashSet};
use wasm_bindgen::prelude::*;

/// Photos by id.
#[wasm_bindgen]
#[derive(Default)]
pub struct Album {
    /// Measurements of each photo, and cached results of plans.
    photos: HashMap<String, (PhotoMeta, Place)>,
    /// Ids of the photos in use, in order.
    used: Vec<String>,
}

#[wasm_bindgen]
impl Album {
    /// An empty album.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Stores the measurements of photos, a JSON array. Each replaces the photo with its id.
    pub fn know(&mut self, photos: &str) -> Result<()> {
        let photos: Vec<PhotoMeta> = parse(photos, "photos")?;
        for photo in photos {
            // Unchanged photos keep their cached results.
            if self.photos.get(&photo.id).is_none_or(|(known, _)| *known != photo) {
                self.photos.insert(photo.id.clone(), (photo, Place::default()));
            }
        }
        Ok(())
    }

    /// Drops all other photos. `ids` is a JSON array.
    pub fn keep(&mut self, ids: &str) -> Result<()> {
        let ids: HashSet<String> = parse(ids, "photos")?;
        self.photos.retain(|id, _| ids.contains(id));
        Ok(())
    }

    /// Learns which photos are in use, a JSON array of ids in their order.
    pub fn take(&mut self, ids: &str) -> Result<()> {
        self.used = parse(ids, "photos")?;
        Ok(())
    }

    /// A new document from photos, locks and a seed; see `page::request::Request`, whose photos are `ids`, a JSON array.
    pub fn plan(&self, request: &str, ids: &str) -> Result<String> {
        let ids: Vec<String> = parse(ids, "photos")?;
        Ok(planned_of(parse_request(request)?, &self.known(&ids)?)?.to_json())
    }
}

#[wasm_bindgen]
impl Album {
    /// Crops of the photos `ids` (JSON) for an aspect ratio: a list of `{photo, crop, faces}`.
    pub fn frames(&self, ids: &str, aspect: f64) -> Result<String> {
        let ids: Vec<String> = parse(ids, "photos")?;
        Ok(framed_json(self.known(&ids)?.iter().map(|known| known.meta), aspect))
    }
}

impl Album {
    /// The photos in use.
    pub(super) fn used(&self) -> Result<Vec<Known<'_>>> {
        self.known(&self.used)
    }

    /// These photos.
    #[inline(never)]
    pub(super) fn known(&self, ids: &[String]) -> Result<Vec<Known<'_>>> {
        let known = |id: &String| {
            let (meta, place) = self.photos.get(id).ok_or_else(|| Error::MissingPhoto(id.clone()))?;
            Ok(Known { meta, place: Some(place) })
        };
        ids.iter().map(known).collect()
    }
}
