//! The mark of the pages that the command line writes, so that a folder of photos that also has such pages is read without
//! them. The mark is metadata that other programs ignore.

use crate::format::Format;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

/// The mark. Its length is even, as `WebP` needs it.
const MARK: &[u8] = b"Inkpanel page\n";
/// Bytes at the start and at the end of a file in which the mark is looked for.
const NEAR: usize = 256;
/// Length of the signature of PNG and of its first chunk.
const PNG_HEAD: usize = 33;

/// The file of a page with the mark: a text of PNG, a comment of JPEG, or a chunk of `WebP`.
pub(crate) fn marked(file: Vec<u8>, kind: Format) -> Vec<u8> {
    match kind {
        Format::Png if file.len() > PNG_HEAD => {
            let content = [b"tEXtSoftware\0", MARK].concat();
            let length = (content.len() - 4) as u32;
            let sum = crc32fast::hash(&content);
            inserted(file, PNG_HEAD, &[&length.to_be_bytes()[..], &content, &sum.to_be_bytes()].concat())
        }
        // The segment of JFIF stays the first one.
        Format::Jpeg if file.starts_with(b"\xff\xd8\xff\xe0") && file.len() > 6 => {
            let at = 4 + usize::from(u16::from_be_bytes([file[4], file[5]]));
            let length = (MARK.len() + 2) as u16;
            inserted(file, at, &[&b"\xff\xfe"[..], &length.to_be_bytes(), MARK].concat())
        }
        Format::Webp if file.len() > 12 => {
            let chunk = [b"inkp", &(MARK.len() as u32).to_le_bytes()[..], MARK].concat();
            let mut all = [file, chunk].concat();
            let length = (all.len() - 8) as u32;
            all[4..8].copy_from_slice(&length.to_le_bytes());
            all
        }
        _ => file,
    }
}

fn inserted(mut file: Vec<u8>, at: usize, bytes: &[u8]) -> Vec<u8> {
    let at = at.min(file.len());
    file.splice(at..at, bytes.iter().copied());
    file
}

/// Whether a file is a page with the mark. A file that cannot be read is not.
pub(crate) fn is_page(path: &Path) -> bool {
    let near = || -> std::io::Result<Vec<u8>> {
        let mut file = File::open(path)?;
        let mut bytes = Vec::new();
        file.by_ref().take(NEAR as u64).read_to_end(&mut bytes)?;
        if bytes.starts_with(b"RIFF") {
            let end = file.seek(SeekFrom::End(0))?;
            file.seek(SeekFrom::Start(end.saturating_sub(NEAR as u64)))?;
            file.read_to_end(&mut bytes)?;
        }
        Ok(bytes)
    };
    near().is_ok_and(|bytes| bytes.windows(MARK.len()).any(|window| window == MARK))
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_engine::page::{jpeg, png, webp};
    use inkpanel_engine::raster::decode::{Limits, decode};

    #[test]
    fn a_marked_page_is_recognised_and_has_its_pixels() {
        let folder = tempfile::tempdir().unwrap();
        let rgb = [90; 3 * 8 * 8];
        let files = [
            (Format::Png, png::encode_rgb(8, 8, &rgb, 300).unwrap()),
            (Format::Jpeg, jpeg::encode_rgb(8, 8, &rgb, 300, 90).unwrap()),
            (Format::Webp, webp::encode_rgb(8, 8, &rgb).unwrap()),
        ];
        for (kind, plain) in files {
            let path = folder.path().join("page");
            std::fs::write(&path, &plain).unwrap();
            assert!(!is_page(&path), "{kind:?}");
            let page = marked(plain.clone(), kind);
            std::fs::write(&path, &page).unwrap();
            assert!(is_page(&path), "{kind:?}");
            let pixels = |file: &[u8]| decode(file, &Limits::default()).unwrap().image.to_rgb();
            assert_eq!(pixels(&page), pixels(&plain), "{kind:?}");
        }
        assert!(!is_page(&folder.path().join("missing")));
    }
}
