//! The size and the line breaks of a text in a shape: reduces the text while it stays readable, enlarges the
//! shape, then reduces the text further.

use super::lens;
use super::letters::{Font, Letters};
use super::model::{Kind, Shape};
use super::setting::{Manner, PITCH, Setter, Setting, Wish};
use super::vertical;
use super::wording::Mark;

/// Each size that is tried is smaller by this factor.
const STEP: f64 = 0.93;
fn manner(kind: Kind, width: Option<f64>, screens: bool) -> Manner {
    if kind == Kind::Effect {
        let largest = if width.is_some() { 0.4 } else { 0.085 };
        let pad = (0.14, 0.14);
        return Manner { round: false, pad, aspect: 20.0, largest, readable: largest, smallest: 0.012 };
    }
    let round = kind != Kind::Caption;
    let (pad, aspect) = if round { ((0.5, 0.46), 1.5) } else { ((0.6, 0.52), 3.2) };
    // On A4, 210 mm wide, 0.0168 are 10 points and 0.0134 are 8. Shouts are larger, whispers are smaller.
    let loud: f64 = match kind {
        Kind::Balloon(Shape::Shout) => 1.15,
        Kind::Balloon(Shape::Whisper) | Kind::Caption => 0.95,
        _ => 1.0,
    };
    if screens {
        let [largest, readable] = ON_SCREENS.map(|size| size * loud.max(1.0));
        return Manner { round, pad, aspect, largest, readable, smallest: LEGIBLE_ON_SCREENS };
    }
    Manner { round, pad, aspect, largest: 0.0168 * loud, readable: 0.0134 * loud, smallest: 0.0098 }
}

/// Sizes of text for screens: the usual one, and the smallest one of a short text. On a page that is 435 pixels wide, as in
/// a small window, these are 12 and 10 pixels, and on a phone 11 and 9.
const ON_SCREENS: [f64; 2] = [0.028, 0.0235];
/// The smallest size of long texts on screens: 10 pixels on a page that is 550 pixels wide.
pub(super) const LEGIBLE_ON_SCREENS: f64 = 0.0182;

/// Sets a text of [`marks`](super::wording::marks), with its [`readings`](super::wording::readings).
#[must_use]
pub(super) fn set(letters: &Letters, font: &Font, text: (&[Mark], &[Vec<char>]), wish: &Wish) -> Setting {
    let mut manner = manner(wish.kind, wish.width, wish.screens);
    if wish.plain {
        manner.pad = (0.0, 0.0);
    }
    if !wish.vertical {
        return lines(letters, font, text, (wish, &manner));
    }
    // Columns are rotated lines.
    let aside = |(across, down): (f64, f64)| (down, across);
    let mut own =
        Wish { width: None, room: aside(wish.room), most: aside(wish.most), page: aside(wish.page), ..*wish };
    let mut aspect = manner.aspect;
    if let Some(width) = wish.width {
        (own.room.1, own.most.1) = (width, width);
        // As high as the text is in a shape of that width, about.
        let size = wish.size.unwrap_or(manner.largest);
        let area = text.0.len() as f64 * vertical::PITCH * size * size * if manner.round { 2.0 } else { 1.3 };
        aspect = (area / (width * width)).clamp(0.3, 8.0);
    }
    let mut setting = lines(letters, font, text, (&own, &Manner { aspect, ..manner }));
    setting.half = aside(setting.half);
    setting.half.0 = setting.half.0.max(wish.width.unwrap_or(0.0) / 2.0);
    setting
}

/// Sets a text in lines, or in columns as if they were lines.
fn lines(
    letters: &Letters,
    font: &Font,
    (text, readings): (&[Mark], &[Vec<char>]),
    (wish, manner): (&Wish, &Manner),
) -> Setting {
    let smallest = wish.size.unwrap_or(manner.smallest);
    let strong = letters.strong(font);
    let column: Vec<char> = text.iter().map(|mark| mark.letter).collect();
    let steps = if wish.vertical { vertical::steps(letters, font, &column) } else { Vec::new() };
    let bare = Setter { letters, font, strong, text, readings, wish, manner, steps: &steps, apart: &[] };
    let apart = bare.apart();
    let setter = Setter { apart: &apart, ..bare };
    if wish.plain {
        return plain(&setter);
    }
    let lens = (wish.kind != Kind::Effect).then(|| lens::Lens::new(&setter));
    let lens = lens.filter(lens::Lens::is_short);
    let at = |setter: &Setter, size: f64, room: (f64, f64)| match &lens {
        Some(lens) => lens.at(size, room, setter.wish.width),
        None => setter.at(size, room, false),
    };
    // Step 1: reduce the text while it stays readable. Step 2: enlarge the shape. Step 3: reduce the text
    // further.
    let readable = wish.size.unwrap_or(manner.readable);
    let stages =
        [(wish.room, wish.size.unwrap_or(manner.largest), readable), (wish.most, readable, smallest)];
    for (room, largest, smallest) in &stages {
        let mut size = *largest;
        loop {
            if setter.may_fit(size, *room)
                && let Some(setting) = at(&setter, size, *room)
            {
                return setting;
            }
            if size <= *smallest {
                break;
            }
            size = (size * STEP).max(*smallest);
        }
    }
    let wider = Wish { width: None, ..*wish };
    let last = Setter { wish: &wider, ..setter };
    at(&last, smallest, wish.page).or_else(|| last.at(smallest, wish.page, true)).unwrap_or(Setting {
        size: smallest,
        pitch: smallest,
        lines: Vec::new(),
        strong: Vec::new(),
        under: Vec::new(),
        readings: Vec::new(),
        flush: false,
        half: (smallest, smallest),
        cut: true,
    })
}

/// Sets left-aligned lines at the requested size, or a little smaller to fit. If they still do not
/// fit, the end is cut off.
fn plain(setter: &Setter) -> Setting {
    let (room, wished) = (setter.wish.room, setter.wish.size.unwrap_or(setter.manner.largest));
    let whole = [1.0, STEP, STEP * STEP].into_iter().find_map(|by| setter.at(wished * by, room, false));
    let set = whole.or_else(|| setter.at(wished * STEP * STEP, room, true));
    let half = (room.0 / 2.0, room.1 / 2.0);
    let empty = Setting {
        size: wished,
        pitch: wished * PITCH,
        lines: Vec::new(),
        strong: Vec::new(),
        under: Vec::new(),
        readings: Vec::new(),
        flush: false,
        half,
        cut: true,
    };
    Setting { half, ..set.unwrap_or(empty) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::words::setting::FULLNESS;

    fn wish(kind: Kind) -> Wish {
        let room = (0.42, 0.3);
        Wish {
            kind,
            vertical: false,
            plain: false,
            screens: false,
            width: None,
            size: None,
            room,
            most: room,
            page: (0.94, 1.3),
        }
    }

    fn setting(text: &str, wish: &Wish) -> Setting {
        let letters = Letters::bundled().unwrap();
        let font = letters.font("comic-neue-bold").unwrap();
        let marks: Vec<Mark> = letters.cleaned(text).into_iter().map(Mark::plain).collect();
        set(&letters, font, (&marks, &[]), wish)
    }

    fn text_of(setting: &Setting) -> Vec<String> {
        setting.lines.iter().map(|(run, _)| run.iter().collect()).collect()
    }

    const SPEECH: &str = "I never thought that we would see the lighthouse again, not after such a night.";

    #[test]
    fn a_balloon_is_widest_in_its_middle_and_holds_its_lines() {
        for text in ["Hi", "Where are we?", SPEECH, "Supercalifragilisticexpialidocious"] {
            for width in [None, Some(0.2), Some(0.35)] {
                let set = setting(text, &Wish { width, ..wish(Kind::Balloon(Shape::Oval)) });
                assert!(!set.cut);
                let joined: String = text_of(&set).join(" ");
                assert_eq!(joined.replace(' ', ""), text.replace(' ', ""));
                let (a, b) = set.half;
                assert!(width.is_none_or(|width| (2.0 * a - width).abs() < 1e-9));
                let middle = (set.lines.len() - 1) as f64 / 2.0;
                for (i, (_, width)) in set.lines.iter().enumerate() {
                    let edge = (i as f64 - middle).abs() * set.pitch + 0.34 * set.size;
                    let room = a * (1.0 - (edge / b).powf(FULLNESS)).powf(1.0 / FULLNESS);
                    assert!(width / 2.0 < room, "{text}, line {i}");
                }
            }
        }
    }

    #[test]
    fn lines_are_balanced() {
        let set = setting(SPEECH, &wish(Kind::Caption));
        let widths: Vec<f64> = set.lines.iter().map(|line| line.1).collect();
        let longest = widths.iter().copied().fold(0.0, f64::max);
        assert!(widths.len() > 1 && widths.iter().all(|width| *width > 0.6 * longest), "{widths:?}");
    }

    #[test]
    fn more_text_is_smaller_and_far_too_much_is_cut() {
        let kind = Kind::Balloon(Shape::Oval);
        let sizes: Vec<f64> = [1, 4, 8].map(|n| setting(&SPEECH.repeat(n), &wish(kind)).size).into();
        assert!(sizes.windows(2).all(|pair| pair[1] <= pair[0]) && sizes[2] < sizes[0], "{sizes:?}");
        let endless = setting(&"word ".repeat(800), &Wish { page: (0.3, 0.25), ..wish(kind) });
        assert!(endless.cut && text_of(&endless).last().unwrap().ends_with('…'));
        assert!(2.0 * endless.half.0 <= 0.3 && 2.0 * endless.half.1 <= 0.25);
    }

    #[test]
    fn line_ends_stay_and_odd_text_is_set() {
        assert_eq!(text_of(&setting("one\ntwo three\n", &wish(Kind::Caption))), ["one", "two three"]);
        for text in ["", " ", "\n\n", "\u{200d}", "😀", &"x".repeat(4_000), "שלום עולם", "\u{301}\u{301}"]
        {
            for kind in [Kind::Caption, Kind::Balloon(Shape::Shout), Kind::Effect] {
                for size in [None, Some(0.004), Some(0.5)] {
                    let set = setting(text, &Wish { size, ..wish(kind) });
                    assert!(set.half.0 > 0.0 && set.half.0.is_finite() && set.half.1.is_finite());
                }
            }
        }
    }

    #[test]
    fn an_effect_is_as_large_as_its_width_lets_it_be() {
        let size = |width| setting("KRAKOOM!", &Wish { width, ..wish(Kind::Effect) }).size;
        assert!(size(Some(0.4)) > 1.5 * size(Some(0.2)));
        assert_eq!(text_of(&setting("BAM BAM", &wish(Kind::Effect))), ["BAM BAM"]);
    }
}
