//! Final Cut Pro 7 XML: a sequence of one video track. Source: Apple, Final Cut Pro XML Interchange Format,
//! version 5.

use super::timecode::{Pace, Rate};
use super::{Cut, ShotList};
use crate::output::markup::escaped;
use std::fmt::Write as _;

pub(super) fn write(list: &ShotList) -> String {
    let rate = list.rate();
    let pace = pace(rate);
    let mut items = String::new();
    let cuts = list.cuts();
    let end = cuts.last().map_or(0, |cut| cut.at + cut.frames);
    for (i, cut) in cuts.iter().enumerate() {
        item(&mut items, (i, cut), length_of(cut, &cuts), &pace);
    }
    let begin = rate.programme();
    let shown = shown(rate);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE xmeml>\n<xmeml version=\"5\">\n<sequence id=\"sequence-1\">\n<name>{}</name>\n<duration>{end}</duration>\n{pace}\n<timecode>{pace}<string>{}</string><frame>{begin}</frame><displayformat>{shown}</displayformat></timecode>\n<media>\n<video>\n<track>\n{items}<enabled>TRUE</enabled>\n<locked>FALSE</locked>\n</track>\n</video>\n</media>\n</sequence>\n</xmeml>\n",
        escaped(&list.title),
        rate.timecode(begin),
    )
}

fn pace(rate: Rate) -> String {
    let ntsc = if rate.pace == Pace::Clock { "FALSE" } else { "TRUE" };
    format!("<rate><timebase>{}</timebase><ntsc>{ntsc}</ntsc></rate>", rate.base)
}

/// Whether numbers of frames are left out.
fn shown(rate: Rate) -> &'static str {
    if rate.drops() { "DF" } else { "NDF" }
}

/// A clip of a file of `length` frames. The file is described by the first clip that is from it.
fn item(out: &mut String, (i, cut): (usize, &Cut), length: u64, pace: &str) {
    let Cut { shot, source, start, frames, at, .. } = cut;
    let (number, known) = (i + 1, source.first + 1);
    let still = if shot.film.is_some() { "" } else { "<stillframe>TRUE</stillframe>\n" };
    let file = if source.first < i {
        format!("<file id=\"file-{known}\"/>")
    } else {
        format!(
            "<file id=\"file-{known}\">\n<name>{}</name>\n<pathurl>{}</pathurl>\n{pace}\n<duration>{length}</duration>\n<timecode>{pace}<string>{}</string><frame>{}</frame><displayformat>{}</displayformat></timecode>\n<media><video/></media>\n</file>",
            escaped(cut.file()),
            cut.url(),
            cut.timecode(0),
            cut.origin,
            shown(cut.counting),
        )
    };
    let comment = |(name, text): (&str, &String)| {
        (!text.is_empty()).then(|| format!("<{name}>{}</{name}>", escaped(text)))
    };
    let more: String = [("mastercomment2", &shot.caption), ("mastercomment3", &shot.sound)]
        .into_iter()
        .filter_map(comment)
        .collect();
    // Writing into text never fails.
    let _ = write!(
        out,
        "<clipitem id=\"clipitem-{number}\">\n<name>{}</name>\n<enabled>TRUE</enabled>\n<duration>{length}</duration>\n{pace}\n{still}<start>{at}</start>\n<end>{}</end>\n<in>{start}</in>\n<out>{}</out>\n{file}\n<logginginfo><scene>{}</scene><shottake>{}</shottake><description>{}</description><lognote>{}</lognote></logginginfo>\n<comments><mastercomment1>{}</mastercomment1>{}</comments>\n</clipitem>\n",
        escaped(&cut.title()),
        at + frames,
        start + frames,
        escaped(&shot.scene),
        escaped(&shot.number),
        escaped(&shot.action),
        escaped(&shot.notes),
        escaped(&shot.dialogue),
        more,
    );
}

/// Returns the number of frames of the source of a shot. If it is unknown, the last frame of any shot counts.
fn length_of(cut: &Cut, cuts: &[Cut]) -> u64 {
    let same = cuts.iter().filter(|other| other.source == cut.source);
    cut.length.unwrap_or_else(|| same.map(|other| other.start + other.frames).fold(0, u64::max))
}

#[cfg(test)]
mod tests {
    use super::super::tests::list;
    use super::*;

    #[test]
    fn a_film_is_told_once_and_its_shots_name_it() {
        let mut list = list(24);
        list.shots.push(list.shots[1].clone());
        let text = write(&list);
        assert!(
            text.contains("<file id=\"file-2\">\n<name>night.mp4</name>\n<pathurl>night.mp4</pathurl>")
                && text.contains("<file id=\"file-2\"/>")
        );
        assert!(text.contains("<start>36</start>\n<end>84</end>\n<in>300</in>\n<out>348</out>"), "{text}");
        assert!(text.contains("<name>One &amp; two</name>\n<duration>133</duration>"), "{text}");
    }
}
