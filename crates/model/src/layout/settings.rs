//! Settings of the page, not of the template: size, gutter, margin, border, corners, colours.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::error::{Error, Result};
use crate::json::typed::{self, is_default, typed};
use crate::json::{Read, Wrong};

/// Default gutter in page widths.
pub const DEFAULT_GUTTER: f64 = 0.018;

/// Resolution in PPI below which a printed photo looks soft at arm's length.
pub const COARSE: f64 = 200.0;

/// Maximum of a whole number in JSON. Sizes have narrower limits.
const MOST_WHOLE: u64 = u32::MAX as u64;

/// Pixels that an upright page is wide on a screen.
const SCREEN: f64 = 1280.0;

/// The settings of one page. Lengths are fractions of the page's width unless a unit is given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate field of the file")]
pub struct PageSettings {
    /// Width of the exported page in pixels, 64..=14000.
    #[serde(deserialize_with = "typed::whole::<_, _, 0, MOST_WHOLE>")]
    pub width: u32,
    /// Height of the exported page in pixels, 64..=14000.
    #[serde(deserialize_with = "typed::whole::<_, _, 0, MOST_WHOLE>")]
    pub height: u32,
    /// Pixels an inch that the file announces to a printer, 36..=1200.
    #[serde(deserialize_with = "typed::whole::<_, _, 0, MOST_WHOLE>")]
    pub dpi: u32,
    /// Distance between two panels, 0..=0.1.
    pub gutter: f64,
    /// Distance between the panels and the edge of the page, 0..=0.2.
    pub margin: f64,
    /// Width of the line round a panel, 0..=0.05.
    pub border: f64,
    /// Radius of the panels' corners, 0..=0.2.
    pub corner_radius: f64,
    /// Colour of the paper, `#rrggbb`.
    pub paper: String,
    /// Colour of the line round a panel, `#rrggbb`.
    pub border_color: String,
    /// Whether text has the larger size for screens.
    #[serde(skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<bool>", optional))]
    pub for_screens: bool,
    /// Whether the page is read from right to left: its layout is mirrored.
    #[serde(skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<bool>", optional))]
    pub rtl: bool,
    /// Whether photos are shown whole: the layout follows their aspect ratios.
    #[serde(skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<bool>", optional))]
    pub whole_photos: bool,
    /// Bleed in page widths, 0 to 0.1. For print files only; it is never saved.
    #[serde(skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<f64>", optional))]
    pub bleed: f64,
    /// Upscale photos below [`COARSE`] pixels per inch with edge enhancement. For printed files only; it is
    /// never saved.
    #[serde(skip_serializing_if = "is_default")]
    #[cfg_attr(feature = "typescript", ts(as = "Option<bool>", optional))]
    pub enlarge: bool,
}

impl Default for PageSettings {
    /// A4 portrait at 300 DPI.
    fn default() -> Self {
        Self {
            width: 2480,
            height: 3508,
            dpi: 300,
            gutter: DEFAULT_GUTTER,
            margin: 0.027,
            border: 0.004,
            corner_radius: 0.0,
            paper: "#ffffff".into(),
            border_color: "#111111".into(),
            for_screens: false,
            rtl: false,
            whole_photos: false,
            bleed: 0.0,
            enlarge: false,
        }
    }
}

/// A setting that users choose by its name. The command line, Python and the public API read this list, and
/// [`PageSettings::validate`] checks the ranges.
pub struct Setting {
    /// Name as an option of the command line. Python has `_` instead of `-`.
    pub name: &'static str,
    /// Its field.
    pub field: Field,
    /// Help text.
    pub help: &'static str,
}

/// A field of [`PageSettings`].
pub enum Field {
    /// A length in page widths, from 0 to this maximum.
    Length(fn(&mut PageSettings) -> &mut f64, f64),
    /// A colour, `#rrggbb`.
    Colour(fn(&mut PageSettings) -> &mut String),
    /// Whether it is on.
    Flag(fn(&mut PageSettings) -> &mut bool),
}

/// The settings that users choose by name, in the order of the help.
pub const SETTINGS: [Setting; 8] = [
    Setting {
        name: "gutter",
        field: Field::Length(|page| &mut page.gutter, 0.1),
        help: "Distance between panels, as a fraction of the page width.",
    },
    Setting {
        name: "margin",
        field: Field::Length(|page| &mut page.margin, 0.2),
        help: "Distance between panels and the page edge, as a fraction of the page width.",
    },
    Setting {
        name: "border",
        field: Field::Length(|page| &mut page.border, 0.05),
        help: "Width of the panel border, as a fraction of the page width.",
    },
    Setting {
        name: "corner-radius",
        field: Field::Length(|page| &mut page.corner_radius, 0.2),
        help: "Radius of the panel corners, as a fraction of the page width.",
    },
    Setting {
        name: "rtl",
        field: Field::Flag(|page| &mut page.rtl),
        help: "Read pages from right to left: layouts are mirrored.",
    },
    Setting {
        name: "whole-photos",
        field: Field::Flag(|page| &mut page.whole_photos),
        help: "Show photos whole: the layout follows their aspect ratios.",
    },
    Setting {
        name: "paper",
        field: Field::Colour(|page| &mut page.paper),
        help: "Paper colour, as #rrggbb.",
    },
    Setting {
        name: "border-color",
        field: Field::Colour(|page| &mut page.border_color),
        help: "Colour of the panel border, as #rrggbb.",
    },
];

impl Setting {
    /// Name in JSON, such as `cornerRadius`.
    fn key(&self) -> String {
        let mut parts = self.name.split('-');
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |key, part| {
            let (head, rest) = part.split_at(1);
            key + &head.to_uppercase() + rest
        })
    }
}

/// Purpose of a page size.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Purpose {
    /// Paper of offices and homes.
    Paper,
    /// Books that are printed and cut.
    Book,
    /// Screens.
    Screen,
}

/// A named page size.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PagePreset {
    /// Stable name.
    pub id: &'static str,
    /// Display name.
    pub name: &'static str,
    /// Purpose.
    pub purpose: Purpose,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Resolution in pixels per inch.
    pub dpi: u32,
    /// Safe distance of faces and text from the edge in pixels: left and right, then top and bottom. Closer
    /// content may be trimmed or covered by the controls of other apps.
    pub safe: [u32; 2],
    /// Safe distance from the fold between two pages, to each side; 0 for a single page.
    pub fold: u32,
}

/// Pixels of a length in tenths of a millimetre, at 300 DPI.
const fn tenths(length: u32) -> u32 {
    (length * 300 + 127) / 254
}

/// A size in pixels at 300 DPI, with a trim tolerance in tenths of a millimetre.
const fn printed(
    id: &'static str,
    name: &'static str,
    purpose: Purpose,
    (width, height): (u32, u32),
    safe: u32,
) -> PagePreset {
    PagePreset { id, name, purpose, width, height, dpi: 300, safe: [tenths(safe); 2], fold: 0 }
}

/// A screen size, with the controls of other apps at its sides, and at its top and bottom.
const fn screen(
    id: &'static str,
    name: &'static str,
    (width, height): (u32, u32),
    safe: [u32; 2],
) -> PagePreset {
    PagePreset { id, name, purpose: Purpose::Screen, width, height, dpi: 96, safe, fold: 0 }
}

/// Two adjacent pages of a book.
const fn spread(id: &'static str, name: &'static str, size: (u32, u32)) -> PagePreset {
    PagePreset { fold: tenths(100), ..printed(id, name, Purpose::Book, size, 60) }
}

/// The page sizes that are offered, the default first. Safe areas follow the requirements of each kind of
/// printer.
pub const PRESETS: [PagePreset; 20] = [
    printed("a4", "A4", Purpose::Paper, (2480, 3508), 50),
    printed("a4-landscape", "A4 landscape", Purpose::Paper, (3508, 2480), 50),
    printed("a3", "A3", Purpose::Paper, (3508, 4961), 50),
    printed("a5", "A5", Purpose::Paper, (1748, 2480), 50),
    printed("a6", "A6", Purpose::Paper, (1240, 1748), 40),
    printed("letter", "Letter", Purpose::Paper, (2550, 3300), 64),
    printed("letter-landscape", "Letter landscape", Purpose::Paper, (3300, 2550), 64),
    printed("half-letter", "Half Letter", Purpose::Paper, (1650, 2550), 64),
    printed("legal", "Legal", Purpose::Paper, (2550, 4200), 64),
    printed("tabloid", "Tabloid", Purpose::Paper, (3300, 5100), 64),
    printed("us-comic", "US comic", Purpose::Book, (1988, 3075), 64),
    printed("manga-b5", "Manga B5", Purpose::Book, (2150, 3035), 60),
    printed("tankobon", "Tankobon", Purpose::Book, (1500, 2150), 60),
    printed("square", "Square", Purpose::Book, (2400, 2400), 50),
    spread("spread-a4", "Photo book, A4 spread", (4961, 3508)),
    spread("spread-square", "Photo book, square spread", (4961, 2480)),
    screen("wide", "Screen 16:9", (3840, 2160), [192, 108]),
    screen("story", "Story 9:16", (1440, 2560), [86, 333]),
    screen("portrait", "Portrait 4:5", (2160, 2700), [108, 135]),
    screen("webtoon", "Webtoon", (1600, 4000), [80, 0]),
];

/// The page size of a name.
#[must_use]
pub fn preset(id: &str) -> Option<PagePreset> {
    PRESETS.into_iter().find(|preset| preset.id == id)
}

/// Maximum number of pixels of an exported page: A1 at 300 DPI.
pub const MOST_PIXELS: u64 = 72_000_000;
/// Pixels of a side of an exported page: the least and the most.
pub const SIDES: [u32; 2] = [64, 14_000];
/// Minimum and maximum resolution in DPI.
pub const DPI: [u32; 2] = [36, 1_200];

impl PageSettings {
    /// Reads settings; a missing field has its default. Ranges are left to [`validate`](Self::validate).
    ///
    /// # Errors
    /// If a field has another type or is unknown.
    pub fn read(value: Value) -> Read<Self> {
        // A struct without required fields would accept a list.
        if value.is_object() { typed(value) } else { Err(Wrong::new("must be an object")) }
    }

    /// Width over height.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        f64::from(self.width) / f64::from(self.height.max(1))
    }

    /// Whether the page becomes a printed book, so that it needs the pixels of print. Other pages are mainly
    /// for screens.
    #[must_use]
    pub fn is_for_print(&self) -> bool {
        let size = (self.width, self.height);
        let is_book =
            |preset: &PagePreset| preset.purpose == Purpose::Book && (preset.width, preset.height) == size;
        self.bleed > 0.0 || self.enlarge || PRESETS.iter().any(is_book)
    }

    /// The width in pixels at which the photos of the page are judged.
    #[must_use]
    pub fn looked_at(&self) -> f64 {
        let width = f64::from(self.width);
        if self.is_for_print() { width } else { width.min(SCREEN * self.aspect().max(1.0).sqrt()) }
    }

    /// The paper's colour as R, G, B; white when it was never validated.
    #[must_use]
    pub fn paper_rgb(&self) -> [u8; 3] {
        rgb(&self.paper).unwrap_or([255; 3])
    }

    /// The border's colour as R, G, B; black when it was never validated.
    #[must_use]
    pub fn border_rgb(&self) -> [u8; 3] {
        rgb(&self.border_color).unwrap_or([0; 3])
    }

    /// Sets one of [`SETTINGS`], by its name.
    ///
    /// # Errors
    /// `invalid-document` naming the field as `page.gutter`.
    pub fn set(&mut self, name: &str, value: &Value) -> Result<()> {
        let setting = SETTINGS.into_iter().find(|setting| setting.name == name);
        let setting = setting.ok_or_else(|| invalid(name, "is not a page setting".into()))?;
        let wrong = |kind: &str| invalid(&setting.key(), format!("must be {kind}, not {value}"));
        match setting.field {
            Field::Length(of, _) => *of(self) = value.as_f64().ok_or_else(|| wrong("a number"))?,
            Field::Colour(of) => value.as_str().ok_or_else(|| wrong("a colour"))?.clone_into(of(self)),
            Field::Flag(of) => *of(self) = value.as_bool().ok_or_else(|| wrong("true or false"))?,
        }
        self.validate()
    }

    /// Checks every field.
    ///
    /// # Errors
    /// `invalid-document` naming the field as `page.gutter`.
    pub fn validate(&self) -> Result<()> {
        let numbers = [("width", self.width, SIDES), ("height", self.height, SIDES), ("dpi", self.dpi, DPI)];
        for (field, value, [least, most]) in numbers {
            if !(least..=most).contains(&value) {
                return Err(invalid(field, format!("must be from {least} to {most}, not {value}")));
            }
        }
        if u64::from(self.width) * u64::from(self.height) > MOST_PIXELS {
            let most = MOST_PIXELS / 1_000_000;
            return Err(invalid("width", format!("times height must be at most {most} million pixels")));
        }
        check_length("bleed", self.bleed, 0.1)?;
        let mut page = self.clone();
        SETTINGS.iter().try_for_each(|setting| match setting.field {
            Field::Length(of, most) => check_length(&setting.key(), *of(&mut page), most),
            Field::Colour(of) => check_colour(&setting.key(), of(&mut page)),
            Field::Flag(_) => Ok(()),
        })
    }
}

fn invalid(field: &str, reason: String) -> Error {
    Error::InvalidDocument { location: format!("page.{field}"), reason }
}

fn check_length(field: &str, value: f64, most: f64) -> Result<()> {
    if (0.0..=most).contains(&value) {
        return Ok(());
    }
    Err(invalid(field, format!("must be from 0 to {most} of the page's width, not {value}")))
}

fn check_colour(field: &str, value: &str) -> Result<()> {
    match rgb(value) {
        Some(_) => Ok(()),
        None => Err(invalid(field, format!("must be a colour like #f4efe6, not \"{value}\""))),
    }
}

fn rgb(text: &str) -> Option<[u8; 3]> {
    let digits =
        text.strip_prefix('#').filter(|d| d.len() == 6 && d.bytes().all(|b| b.is_ascii_hexdigit()))?;
    let value = u32::from_str_radix(digits, 16).ok()?;
    Some([(value >> 16) as u8, (value >> 8) as u8, value as u8])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_defaults_and_every_preset_are_valid() {
        assert_eq!(PageSettings::default().validate(), Ok(()));
        for PagePreset { width, height, dpi, .. } in PRESETS {
            let page = PageSettings { width, height, dpi, ..PageSettings::default() };
            assert_eq!(page.validate(), Ok(()));
        }
    }

    #[test]
    fn a_value_out_of_range_names_its_field() {
        let bad = [
            (r#"{"gutter": 0.2}"#, "page.gutter"),
            (r#"{"margin": -0.1}"#, "page.margin"),
            (r#"{"border": 1}"#, "page.border"),
            (r#"{"cornerRadius": 9}"#, "page.cornerRadius"),
            (r##"{"paper": "#fff"}"##, "page.paper"),
            (r#"{"borderColor": "black"}"#, "page.borderColor"),
            (r#"{"width": 3}"#, "page.width"),
            (r#"{"width": 14000, "height": 14000}"#, "page.width"),
            (r#"{"dpi": 0}"#, "page.dpi"),
        ];
        for (json, field) in bad {
            let page: PageSettings = serde_json::from_str(json).unwrap();
            let Err(Error::InvalidDocument { location, .. }) = page.validate() else { panic!("{json}") };
            assert_eq!(location, field);
        }
        assert!(serde_json::from_str::<PageSettings>(r#"{"guter": 0.01}"#).is_err());
    }

    #[test]
    fn every_setting_sets_its_own_field() {
        for setting in SETTINGS {
            let mut page = PageSettings::default();
            let value = match setting.field {
                Field::Length(_, most) => Value::from(most),
                Field::Colour(_) => "#123456".into(),
                Field::Flag(_) => true.into(),
            };
            page.set(setting.name, &value).unwrap();
            let json = serde_json::to_value(&page).unwrap();
            assert_eq!(json[setting.key()], value, "{}", setting.name);
            let Err(Error::InvalidDocument { location, .. }) = page.set(setting.name, &Value::Null) else {
                panic!("{}", setting.name)
            };
            assert_eq!(location, format!("page.{}", setting.key()));
        }
    }

    #[test]
    fn colours_are_read() {
        let page = PageSettings { paper: "#F4efe6".into(), ..PageSettings::default() };
        assert_eq!(page.paper_rgb(), [0xf4, 0xef, 0xe6]);
    }
}
