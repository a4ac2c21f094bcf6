//! Kinds of files, by their names and by their first bytes. This one table serves the app, archives, folders, the command line and the
//! Python package. `www/engine/file-table.ts` is generated from it.

use crate::error::Error;
use std::fmt::{self, Display, Formatter};

/// How Inkpanel handles a kind of file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// A photo of an album.
    Photo,
    /// A video, whose frames are photos.
    Video,
    /// Subtitles.
    Subtitles,
    /// Plain text, which may be a script.
    Text,
    /// A screenplay or a table for a storyboard.
    Board,
    /// A layout, a style, or data of another program.
    Json,
    /// A project.
    Project,
    /// An archive of pages or photos.
    Archive,
    /// A model of painters of the user.
    Painters,
    /// A file that a system or a program stores next to photos. It is skipped.
    Sidecar,
    /// A file that cannot be read.
    Unsupported(Remedy),
}

/// Advice for a file that cannot be read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Remedy {
    /// Save the picture as JPEG.
    Jpeg,
    /// Unpack the archive.
    Unpack,
    /// Save the pages as pictures.
    Pages,
    /// Convert the video to MP4.
    Mp4,
    /// Convert the subtitles to SRT.
    Srt,
    /// Export the screenplay as Fountain.
    Fountain,
    /// Save the table as CSV.
    Csv,
    /// Save the document as plain text.
    Text,
}

/// A kind of file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Kind {
    /// Common name.
    pub name: &'static str,
    /// Media type; empty for kinds that the app does not hand to the browser.
    pub media_type: &'static str,
    /// Endings of file names in lower case, without the dot.
    pub endings: &'static [&'static str],
    /// How Inkpanel handles it.
    pub role: Role,
}

const fn kind(
    name: &'static str,
    media_type: &'static str,
    endings: &'static [&'static str],
    role: Role,
) -> Kind {
    Kind { name, media_type, endings, role }
}

const fn other(name: &'static str, remedy: Remedy, endings: &'static [&'static str]) -> Kind {
    kind(name, "", endings, Role::Unsupported(remedy))
}

/// All kinds. No ending is in two of them.
pub const KINDS: &[Kind] = &[
    kind(
        "JPEG",
        "image/jpeg",
        &["jpg", "jpeg", "jpe", "jif", "jfif", "jfi", "pjpeg", "pjp", "mpo"],
        Role::Photo,
    ),
    kind("PNG", "image/png", &["png", "apng"], Role::Photo),
    kind("WebP", "image/webp", &["webp"], Role::Photo),
    kind("AVIF", "image/avif", &["avif"], Role::Photo),
    kind("HEIC", "image/heic", &["heic", "heif", "hif"], Role::Photo),
    kind("GIF", "image/gif", &["gif"], Role::Photo),
    kind("BMP", "image/bmp", &["bmp", "dib"], Role::Photo),
    kind("TIFF", "image/tiff", &["tif", "tiff"], Role::Photo),
    kind("MP4", "video/mp4", &["mp4", "m4v"], Role::Video),
    kind("QuickTime", "video/quicktime", &["mov", "qt"], Role::Video),
    kind("WebM", "video/webm", &["webm"], Role::Video),
    kind("Matroska", "video/x-matroska", &["mkv"], Role::Video),
    kind("MPEG transport stream", "video/mp2t", &["ts", "m2ts", "mts"], Role::Video),
    // The app reads some of these and names the codec of the others.
    kind("AVI", "video/x-msvideo", &["avi"], Role::Video),
    kind("MPEG", "video/mpeg", &["mpg", "mpeg"], Role::Video),
    kind("Windows Media", "video/x-ms-wmv", &["wmv"], Role::Video),
    kind("Flash Video", "video/x-flv", &["flv"], Role::Video),
    kind("Ogg", "video/ogg", &["ogv"], Role::Video),
    kind("3GPP", "video/3gpp", &["3gp", "3g2"], Role::Video),
    kind("SubRip", "application/x-subrip", &["srt"], Role::Subtitles),
    kind("WebVTT", "text/vtt", &["vtt"], Role::Subtitles),
    kind("SubStation Alpha", "text/x-ssa", &["ass", "ssa"], Role::Subtitles),
    kind("SBV", "", &["sbv"], Role::Subtitles),
    kind("plain text", "text/plain", &["txt"], Role::Text),
    kind("Fountain", "", &["fountain", "spmd"], Role::Board),
    kind("CSV", "text/csv", &["csv", "tsv"], Role::Board),
    kind("JSON", "application/json", &["json"], Role::Json),
    kind("Inkpanel project", "application/x-inkpanel", &["inkpanel"], Role::Project),
    kind("ZIP", "application/zip", &["zip"], Role::Archive),
    kind("CBZ", "application/vnd.comicbook+zip", &["cbz"], Role::Archive),
    kind("ONNX", "", &["onnx"], Role::Painters),
    // Edits of photos by iPhones and by programs for raw photos; previews and indexes of cameras.
    kind("edits of a photo", "", &["aae", "xmp", "pp3", "dop", "on1", "cos"], Role::Sidecar),
    kind("preview of a camera", "", &["thm", "lrv", "ctg"], Role::Sidecar),
    other(
        "camera raw",
        Remedy::Jpeg,
        &[
            "dng", "cr2", "cr3", "crw", "nef", "nrw", "arw", "srf", "sr2", "raf", "orf", "rw2", "pef", "srw",
            "x3f", "3fr", "iiq", "rwl", "kdc", "dcr", "erf", "mrw", "gpr",
        ],
    ),
    other("JPEG XL", Remedy::Jpeg, &["jxl"]),
    other("JPEG 2000", Remedy::Jpeg, &["jp2", "j2k", "jpf", "jpx", "j2c"]),
    other("Photoshop", Remedy::Jpeg, &["psd", "psb"]),
    other("SVG", Remedy::Jpeg, &["svg", "svgz"]),
    other("OpenEXR", Remedy::Jpeg, &["exr"]),
    other("TGA", Remedy::Jpeg, &["tga"]),
    other("ICO", Remedy::Jpeg, &["ico"]),
    other("GIMP", Remedy::Jpeg, &["xcf"]),
    other("Krita", Remedy::Jpeg, &["kra"]),
    other("Clip Studio", Remedy::Jpeg, &["clip", "lip"]),
    other("Procreate", Remedy::Jpeg, &["procreate"]),
    other("Illustrator", Remedy::Jpeg, &["ai", "eps"]),
    other("RAR", Remedy::Unpack, &["rar", "cbr"]),
    other("7-Zip", Remedy::Unpack, &["7z", "cb7"]),
    other("tar", Remedy::Unpack, &["tar", "cbt", "tgz", "gz", "bz2", "xz", "zst"]),
    other("PDF", Remedy::Pages, &["pdf"]),
    other("EPUB", Remedy::Pages, &["epub"]),
    other("Kindle", Remedy::Pages, &["mobi", "azw", "azw3"]),
    other("DjVu", Remedy::Pages, &["djvu", "djv"]),
    other("RealMedia", Remedy::Mp4, &["rm", "rmvb"]),
    other("DVD video", Remedy::Mp4, &["vob"]),
    other("MXF", Remedy::Mp4, &["mxf"]),
    other("raw video", Remedy::Mp4, &["r3d", "braw", "crm"]),
    other("TTML", Remedy::Srt, &["ttml", "dfxp"]),
    other("SAMI", Remedy::Srt, &["smi"]),
    other("MicroDVD or VobSub", Remedy::Srt, &["sub", "idx"]),
    other("lyrics", Remedy::Srt, &["lrc"]),
    other("Final Draft", Remedy::Fountain, &["fdx", "fdr"]),
    other("Celtx", Remedy::Fountain, &["celtx"]),
    other("Fade In", Remedy::Fountain, &["fadein"]),
    other("Excel", Remedy::Csv, &["xlsx", "xls", "xlsm"]),
    other("OpenDocument table", Remedy::Csv, &["ods"]),
    other("Numbers", Remedy::Csv, &["numbers"]),
    other("Word", Remedy::Text, &["docx", "doc"]),
    other("OpenDocument text", Remedy::Text, &["odt"]),
    other("RTF", Remedy::Text, &["rtf"]),
];

/// Names of files of systems and programs, in lower case. Names that start with a dot are such files, too.
pub const SYSTEM_NAMES: &[&str] =
    &["thumbs.db", "ehthumbs.db", "ehthumbs_vista.db", "desktop.ini", "picasa.ini", "icon\r"];

/// Folders of systems and programs. Names that start with a dot are such folders, too.
pub const SYSTEM_FOLDERS: &[&str] =
    &["__MACOSX", "@eaDir", "#recycle", "$RECYCLE.BIN", "System Volume Information"];

/// First bytes of kinds: a position, the bytes there, and an ending of the kind. Two entries for one file must both be right.
pub const SIGNATURES: &[(usize, &[u8], &str)] = &[
    (0, b"Rar!\x1a\x07", "rar"),
    (0, b"7z\xbc\xaf\x27\x1c", "7z"),
    (0, b"\x1f\x8b\x08", "gz"),
    (257, b"ustar", "tar"),
    (0, b"%PDF-", "pdf"),
    (0, b"8BPS", "psd"),
    (0, b"\0\0\0\x0cJXL ", "jxl"),
    (0, b"\xff\x0a", "jxl"),
    (0, b"\0\0\0\x0cjP  ", "jp2"),
    (0, b"\xff\x4f\xff\x51", "j2c"),
    (0, b"FUJIFILMCCD-RAW", "raf"),
    (4, b"ftypcrx ", "cr3"),
    (0, b"IIRO", "orf"),
    (0, b"IIU\0", "rw2"),
    (0, b"\x76\x2f\x31\x01", "exr"),
    (0, b"gimp xcf", "xcf"),
    (0, b"<svg", "svg"),
    (0, b"AT&TFORM", "djvu"),
    (0, b"PK\x03\x04", "zip"),
    (0, b"\x1a\x45\xdf\xa3", "mkv"),
    (4, b"ftypqt  ", "mov"),
    (4, b"ftypisom", "mp4"),
    (4, b"ftypmp4", "mp4"),
    (4, b"ftypiso", "mp4"),
    (4, b"ftypavc1", "mp4"),
    (4, b"ftypM4V", "m4v"),
    (4, b"moov", "mov"),
    (4, b"ftyp3g", "3gp"),
];

/// The kind of a file by the ending of its name.
#[must_use]
pub fn by_name(name: &str) -> Option<&'static Kind> {
    let (_, ending) = name.rsplit_once('.')?;
    by_ending(&ending.to_lowercase())
}

/// The kind of a file by its first bytes; `None` for photos that have a decoder.
#[must_use]
pub fn by_content(bytes: &[u8]) -> Option<&'static Kind> {
    let starts = |&&(at, start, _): &&(usize, &[u8], &str)| {
        bytes.get(at..).is_some_and(|rest| rest.starts_with(start))
    };
    SIGNATURES.iter().find(starts).and_then(|(_, _, ending)| by_ending(ending))
}

fn by_ending(ending: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.endings.contains(&ending))
}

/// Whether a system or program stores a file or folder of this name next to photos.
#[must_use]
pub fn is_system(name: &str) -> bool {
    name.starts_with('.')
        || SYSTEM_FOLDERS.contains(&name)
        || SYSTEM_NAMES.contains(&name.to_lowercase().as_str())
}

/// Returns whether a file is stored next to photos, but is not a photo: a system file, edits of a photo, or
/// photo data by Google Takeout, such as `photo.jpg.json`.
#[must_use]
pub fn is_sidecar(name: &str) -> bool {
    is_system(name) || by_name(name).is_some_and(|kind| kind.role == Role::Sidecar) || is_takeout(name)
}

fn is_takeout(name: &str) -> bool {
    let lower = name.to_lowercase();
    let pictured =
        |part: &str| by_ending(part).is_some_and(|kind| matches!(kind.role, Role::Photo | Role::Video));
    lower.strip_suffix(".json").is_some_and(|stem| stem.split('.').skip(1).any(pictured))
}

/// A file that is not a photo, and advice for the user.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Explained(&'static Kind);

/// Explains why a file is not a photo. The content counts more than the name, because an archive may have a
/// wrong name.
///
/// Returns `None` for photos and for unknown kinds.
#[must_use]
pub fn explained(name: &str, bytes: &[u8]) -> Option<Explained> {
    let kind = by_content(bytes).or_else(|| by_name(name))?;
    (!matches!(kind.role, Role::Photo | Role::Sidecar)).then_some(Explained(kind))
}

/// Explains the error of a file that is not a photo by its kind, if the kind is known.
#[must_use]
pub fn clearer(error: Error, name: &str, bytes: &[u8]) -> Error {
    match (&error, explained(name, bytes)) {
        (Error::UnknownFormat, Some(explained)) => Error::OtherKind(explained.to_string()),
        _ => error,
    }
}

impl Explained {
    /// The kind of the file.
    #[must_use]
    pub fn kind(self) -> &'static Kind {
        self.0
    }
}

impl Display for Explained {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let name = self.0.name;
        match self.0.role {
            Role::Unsupported(remedy) => {
                write!(out, "this kind of file ({name}) cannot be read; {}", remedy.sentence())
            }
            Role::Video => {
                write!(out, "this is a video ({name}), not a photo; `inkpanel shots` finds its frames")
            }
            Role::Archive => write!(out, "this is an archive ({name}); unpack it and name the folder"),
            Role::Painters => write!(out, "this is a model ({name}), not a photo; `--painters` uses it"),
            Role::Project => write!(out, "this is a project; `inkpanel render` draws it"),
            Role::Subtitles => write!(out, "this file has subtitles ({name}), not a photo; the app reads it"),
            Role::Board | Role::Json | Role::Text => {
                write!(out, "this is a {name} file, not a photo; the app reads it")
            }
            Role::Photo | Role::Sidecar => write!(out, "this {name} file is not a photo"),
        }
    }
}

impl Remedy {
    /// Name in generated code.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Jpeg => "jpeg",
            Self::Unpack => "unpack",
            Self::Pages => "pages",
            Self::Mp4 => "mp4",
            Self::Srt => "srt",
            Self::Fountain => "fountain",
            Self::Csv => "csv",
            Self::Text => "text",
        }
    }

    /// A request to the user.
    #[must_use]
    pub fn sentence(self) -> &'static str {
        match self {
            Self::Jpeg => "save it as JPEG with a program that opens it",
            Self::Unpack => "unpack it and take its pictures, or pack them as ZIP",
            Self::Pages => "save its pages as PNG or JPEG",
            Self::Mp4 => "convert it to MP4 with H.264 video",
            Self::Srt => "convert it to SRT or WebVTT",
            Self::Fountain => "export it as Fountain",
            Self::Csv => "save it as CSV",
            Self::Text => "save it as plain text",
        }
    }
}

impl Role {
    /// Name in generated code.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Photo => "photo",
            Self::Video => "video",
            Self::Subtitles => "subtitles",
            Self::Text => "text",
            Self::Board => "board",
            Self::Json => "json",
            Self::Project => "project",
            Self::Archive => "archive",
            Self::Painters => "painters",
            Self::Sidecar => "sidecar",
            Self::Unsupported(_) => "unsupported",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_ending_belongs_to_one_kind() {
        let mut seen = HashSet::new();
        for ending in KINDS.iter().flat_map(|kind| kind.endings) {
            assert!(seen.insert(ending), "{ending}");
            assert_eq!(*ending, ending.to_lowercase());
        }
        for (_, _, ending) in SIGNATURES {
            assert!(seen.contains(ending), "{ending}");
        }
    }

    #[test]
    fn photos_have_all_their_endings() {
        for name in
            ["a.jfif", "b.JPE", "c.pjpeg", "d.jif", "e.HEIC", "f.HIF", "g.avif", "h.tiff", "i.jpeg.jpg"]
        {
            assert_eq!(by_name(name).unwrap().role, Role::Photo, "{name}");
        }
        for name in ["jpg", "a", "a.", "a.exe"] {
            assert_eq!(by_name(name), None, "{name}");
        }
    }

    #[test]
    fn files_of_systems_and_programs_are_sidecars() {
        let sidecars = [
            "._IMG_1.jpg",
            ".DS_Store",
            "Thumbs.db",
            "DESKTOP.INI",
            "b.AAE",
            "b.xmp",
            "b.JPG.json",
            "Icon\r",
            "IMG_1.HEIC.supplemental-metadata.json",
            "clip.MP4.json",
        ];
        for name in sidecars {
            assert!(is_sidecar(name), "{name}");
        }
        for name in ["b.jpg", "layout.json", "jpg.json", "notes.txt", "a.thumbs.db.jpg", "Icon"] {
            assert!(!is_sidecar(name), "{name}");
        }
        assert!(is_system("__MACOSX") && is_system("@eaDir") && !is_system("holiday"));
    }

    #[test]
    fn what_cannot_be_read_is_named_with_a_way_out() {
        let told = |name: &str, bytes: &[u8]| explained(name, bytes).map(|told| told.to_string());
        let archive =
            "this kind of file (RAR) cannot be read; unpack it and take its pictures, or pack them as ZIP";
        assert_eq!(told("a.cbr", b"").unwrap(), archive);
        assert_eq!(told("a.cbz", b"Rar!\x1a\x07\x01\0").unwrap(), archive);
        assert!(told("a.fdx", b"<?xml").unwrap().contains("Final Draft"));
        assert!(told("a.CR3", b"\0\0\0\x18ftypcrx ").unwrap().contains("JPEG"));
        assert!(told("clip.mov", b"").unwrap().contains("inkpanel shots"));
        assert_eq!(told("a.jpg", b""), None);
        assert_eq!(told("a.unheard", b"?"), None);
    }
}
