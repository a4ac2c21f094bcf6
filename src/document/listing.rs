//! The shots of a project file in order, with all metadata: for lists and storyboards without the app.

use super::file::{FilePhoto, ProjectFile};
use super::project::TrayItem;
use super::shots::{Board, numbers, ordered};
use crate::output::shots::{Film, ListedShot, ShotList};
use std::collections::{HashMap, HashSet};

impl ProjectFile {
    /// Ids of the photos that are shots, in order: photos in use or on a page.
    #[must_use]
    pub fn shots(&self) -> Vec<&str> {
        let present = &self.history.present;
        let sheets = present.sheets();
        let shown: HashSet<&str> = sheets
            .iter()
            .flat_map(|sheet| &sheet.page.panels)
            .filter_map(|panel| panel.photo.as_deref())
            .collect();
        let told: HashSet<&str> = present.board.order.iter().map(String::as_str).collect();
        let used = |item: &TrayItem| {
            let id = item.id.as_str();
            item.used.unwrap_or(shown.contains(id) || told.contains(id) || !item.shot.is_empty())
        };
        let photos: HashMap<&str, &FilePhoto> =
            self.photos.iter().map(|photo| (photo.id.as_str(), photo)).collect();
        let mut own: Vec<&TrayItem> =
            present.tray.iter().map(AsRef::as_ref).filter(|item| used(item)).collect();
        own.retain(|item| photos.contains_key(item.id.as_str()));
        // If any capture time is missing, the order of the tray stays.
        let rank = |item: &TrayItem| photos.get(item.id.as_str()).and_then(|photo| photo.rank);
        if own.iter().all(|item| rank(item).is_some()) {
            own.sort_by_key(|item| rank(item));
        }
        let own: Vec<&str> = own.iter().map(|item| item.id.as_str()).collect();
        ordered(&present.board.order, &own)
    }

    /// Its shots as a list.
    #[must_use]
    pub fn shot_list(&self) -> ShotList {
        let present = &self.history.present;
        let ids = self.shots();
        let items: HashMap<&str, &TrayItem> =
            present.tray.iter().map(|item| (item.id.as_str(), item.as_ref())).collect();
        let items: Vec<&TrayItem> = ids.iter().filter_map(|id| items.get(id).copied()).collect();
        let numbers = numbers(items.iter().map(|item| item.shot.number.as_str()));
        let shots = items.iter().zip(numbers).map(|(item, number)| self.listed(item, number)).collect();
        let Board { fps, pace, columns, .. } = Board::clone(&present.board);
        ShotList { title: present.name.clone(), fps, pace, columns, headings: Vec::new(), shots }
    }

    fn listed(&self, item: &TrayItem, number: String) -> ListedShot {
        let shot = item.shot.clone();
        let photo = self.photos.iter().find(|photo| photo.id == item.id);
        let film = photo.and_then(|photo| {
            let video = self.videos.iter().find(|video| Some(&video.key) == photo.video.as_ref())?;
            Some(Film {
                key: video.key.clone(),
                name: video.name.clone(),
                time: photo.time.unwrap_or_default(),
                length: video.duration,
                timecode: video.timecode,
            })
        });
        let more =
            shot.more.iter().filter_map(|(name, text)| Some((name.clone(), text.as_str()?.to_owned())));
        ListedShot {
            number,
            more: more.collect(),
            scene: shot.scene,
            action: shot.action,
            dialogue: shot.dialogue,
            notes: shot.notes,
            frames: shot.frames,
            name: photo.map(|photo| photo.name.clone()).unwrap_or_default(),
            film,
        }
    }
}
