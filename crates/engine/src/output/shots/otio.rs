//! An `OpenTimelineIO` timeline of one video track. Shot fields are in the metadata of the clips. Source
//! times are the source timecodes. Source: the schema of `OpenTimelineIO` 0.15 (`Timeline.1`, `Clip.2`,
//! `ExternalReference.1`).

use super::timecode::Rate;
use super::{Cut, ShotList};
use serde_json::{Value, json};

/// The key of the media reference.
const MEDIA: &str = "DEFAULT_MEDIA";

pub(super) fn write(list: &ShotList) -> String {
    let rate = list.rate();
    let clips: Vec<Value> = list.cuts().iter().map(|cut| clip(cut, rate)).collect();
    let track = json!({
        "OTIO_SCHEMA": "Track.1", "metadata": {}, "name": "V1", "source_range": null, "effects": [], "markers": [],
        "enabled": true, "children": clips, "kind": "Video",
    });
    let timeline = json!({
        "OTIO_SCHEMA": "Timeline.1", "metadata": {}, "name": list.title,
        "global_start_time": time(rate.programme(), rate),
        "tracks": {
            "OTIO_SCHEMA": "Stack.1", "metadata": {}, "name": "tracks", "source_range": null, "effects": [],
            "markers": [], "enabled": true, "children": [track],
        },
    });
    format!("{timeline:#}\n")
}

fn clip(cut: &Cut, rate: Rate) -> Value {
    let Cut { shot, start, frames, origin, .. } = cut;
    let available = cut.length.map(|length| range(*origin, length, rate));
    let media = json!({
        "OTIO_SCHEMA": "ExternalReference.1", "metadata": {}, "name": cut.file(), "available_range": available,
        "available_image_bounds": null, "target_url": cut.url(),
    });
    let mut about = json!({
        "scene": shot.scene, "shot": shot.number, "action": shot.action, "dialogue": shot.dialogue,
        "notes": shot.notes, "picture": shot.name, "columns": shot.more,
    });
    for (name, text) in [("caption", &shot.caption), ("sound", &shot.sound)] {
        if !text.is_empty() {
            about[name] = json!(text);
        }
    }
    json!({
        "OTIO_SCHEMA": "Clip.2", "name": cut.title(), "source_range": range(origin + start, *frames, rate), "effects": [],
        "markers": [], "enabled": true, "media_references": { MEDIA: media }, "active_media_reference_key": MEDIA,
        "metadata": { "inkpanel": about },
    })
}

fn range(start: u64, frames: u64, rate: Rate) -> Value {
    json!({ "OTIO_SCHEMA": "TimeRange.1", "start_time": time(start, rate), "duration": time(frames, rate) })
}

fn time(frames: u64, rate: Rate) -> Value {
    json!({ "OTIO_SCHEMA": "RationalTime.1", "rate": rate.exact(), "value": frames as f64 })
}
