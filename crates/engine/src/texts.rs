//! Decodes text files of users: Unicode with and without a byte order mark, or a guessed encoding. Only this
//! decoder reads subtitles, scripts, tables, settings and names in archives.

use chardetng::{EncodingDetector, Iso2022JpDetection, Utf8Detection};
use encoding_rs::{Encoding, IBM866, ISO_2022_JP, SHIFT_JIS, UTF_8, UTF_16BE, UTF_16LE};
use std::borrow::Cow;

/// Names of the encodings that a user can choose from, by the languages that they are for.
pub const ENCODINGS: [(&str, &str); 34] = [
    ("UTF-8", ""),
    ("UTF-16LE", ""),
    ("UTF-16BE", ""),
    ("UTF-32LE", ""),
    ("UTF-32BE", ""),
    ("windows-1252", "en de es fr pt"),
    ("macintosh", "en de es fr pt"),
    (CP437, "en"),
    ("windows-1250", "pl cs hu"),
    ("ISO-8859-2", "pl cs hu"),
    ("windows-1251", "ru uk bg"),
    ("KOI8-R", "ru"),
    ("KOI8-U", "uk"),
    ("IBM866", "ru"),
    ("ISO-8859-5", "ru"),
    ("x-mac-cyrillic", "ru uk"),
    ("windows-1253", "el"),
    ("ISO-8859-7", "el"),
    ("windows-1254", "tr"),
    ("windows-1255", "he"),
    ("ISO-8859-8", "he"),
    ("windows-1256", "ar fa"),
    ("ISO-8859-6", "ar"),
    ("windows-1257", "lt lv et"),
    ("ISO-8859-4", "lt lv et"),
    ("windows-1258", "vi"),
    ("windows-874", "th"),
    ("Shift_JIS", "ja"),
    ("EUC-JP", "ja"),
    ("ISO-2022-JP", "ja"),
    ("GBK", "zh-Hans"),
    ("gb18030", "zh-Hans"),
    ("Big5", "zh-Hant"),
    ("EUC-KR", "ko"),
];

/// The encoding of names in archives that were made on DOS.
const CP437: &str = "IBM437";
/// The characters of IBM437 from 0x80.
const DOS: &str = "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u{a0}";

/// A decoded text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Text {
    /// The characters, without a byte order mark.
    pub text: String,
    /// The name of its encoding, see [`ENCODINGS`].
    pub encoding: &'static str,
    /// Whether the encoding was guessed from the bytes.
    pub guessed: bool,
    /// Number of places that are invalid in the encoding. The text has U+FFFD there.
    pub lost: usize,
}

/// Decodes a file. `language` is the language of the user as a BCP 47 tag, which decides between encodings that fit
/// equally well. `None` for bytes that are not text.
#[must_use]
pub fn decode(bytes: &[u8], language: &str) -> Option<Text> {
    let known = |encoding, guessed| decode_as(bytes, encoding).map(|text| Text { guessed, ..text });
    match bytes {
        [0xff, 0xfe, 0, 0, ..] => return known("UTF-32LE", false).and_then(sound),
        [0, 0, 0xfe, 0xff, ..] => return known("UTF-32BE", false).and_then(sound),
        [0xff, 0xfe, ..] => return known("UTF-16LE", false).and_then(sound),
        [0xfe, 0xff, ..] => return known("UTF-16BE", false).and_then(sound),
        _ => {}
    }
    if bytes.contains(&0) {
        return known(wide(bytes)?, false).filter(|text| text.lost == 0).and_then(sound);
    }
    match std::str::from_utf8(bytes) {
        Ok(text) if text.is_ascii() && text.contains("\x1b$") => {
            return known(ISO_2022_JP.name(), true).filter(|text| text.lost == 0);
        }
        Ok(_) => return known(UTF_8.name(), false),
        Err(_) if bytes.iter().any(|byte| is_control(*byte)) => return None,
        Err(_) if is_nearly_utf8(bytes) => return known(UTF_8.name(), false).and_then(sound),
        Err(_) => {}
    }
    known(guess(bytes, language).name(), true).and_then(sound)
}

/// Decodes a file in an encoding that the user chose. `None` for an unknown encoding.
#[must_use]
pub fn decode_as(bytes: &[u8], encoding: &str) -> Option<Text> {
    let (text, encoding) = match encoding {
        "UTF-32LE" => (utf32(bytes, u32::from_le_bytes), "UTF-32LE"),
        "UTF-32BE" => (utf32(bytes, u32::from_be_bytes), "UTF-32BE"),
        CP437 => (dos(bytes), CP437),
        label => {
            let encoding = Encoding::for_label(label.as_bytes())?;
            let (text, _) = encoding.decode_with_bom_removal(bytes);
            (text.into_owned(), encoding.name())
        }
    };
    let lost = text.matches('\u{fffd}').count();
    Some(Text { text, encoding, guessed: false, lost })
}

/// Decodes the names in an archive, which have one encoding. UTF-8 is used if all names are valid in it.
#[must_use]
pub fn names(names: &[&[u8]], language: &str) -> Vec<String> {
    if let Ok(names) = names.iter().map(|name| std::str::from_utf8(name)).collect::<Result<Vec<_>, _>>() {
        return names.into_iter().map(str::to_owned).collect();
    }
    let all = names.join(&b'\n');
    if is_japanese(&all) {
        return names.iter().map(|name| SHIFT_JIS.decode_without_bom_handling(name).0.into_owned()).collect();
    }
    let guessed = guess(&all, language);
    // Western names come from DOS more often than from Windows. The letters of DOS are signs in Windows.
    let is_dos = |byte: &&u8| matches!(byte, 0x80..=0xa5 | 0xe1);
    let is_windows = |byte: &&u8| matches!(byte, 0xc0..=0xff);
    let count = |is: &dyn Fn(&&u8) -> bool| all.iter().filter(|byte| is(byte)).count();
    let western = guessed.is_single_byte() && guessed != IBM866;
    let encoding = if western && count(&is_dos) > count(&is_windows) { CP437 } else { guessed.name() };
    let decoded = |name: &&[u8]| decode_as(name, encoding).map(|text| text.text);
    names.iter().map(|name| decoded(name).unwrap_or_default()).collect()
}

/// Whether short text is Shift-JIS: all of it is valid, and some of it is hiragana. Half-width kana are not a sign, because
/// bytes of many encodings give them.
fn is_japanese(bytes: &[u8]) -> bool {
    let (text, lost) = SHIFT_JIS.decode_without_bom_handling(bytes);
    let is_hiragana = |letter: char| ('\u{3041}'..='\u{3096}').contains(&letter);
    let is_half = |letter: char| ('\u{ff61}'..='\u{ff9f}').contains(&letter);
    !lost && text.contains(is_hiragana) && !text.contains(is_half)
}

/// The text, unless it has characters of binary files or much of it is invalid.
fn sound(text: Text) -> Option<Text> {
    let is_text = !text.text.chars().any(|letter| u8::try_from(letter).is_ok_and(is_control));
    (is_text && 20 * text.lost <= text.text.chars().count()).then_some(text)
}

/// Control characters of binary files. Line ends, tabs, page breaks and the end mark of DOS are part of text.
fn is_control(byte: u8) -> bool {
    matches!(byte, 0..=8 | 0x0e..=0x19 | 0x1b..=0x1f | 0x7f)
}

/// The encoding of bytes with zeros, by their places: every file has line ends, spaces or digits.
fn wide(bytes: &[u8]) -> Option<&'static str> {
    let zeros =
        |from: usize, every: usize| bytes.iter().skip(from).step_by(every).filter(|byte| **byte == 0).count();
    let quarter = bytes.len() / 4;
    if bytes.len().is_multiple_of(4) && zeros(3, 4) == quarter && zeros(2, 4) > 0 {
        return Some("UTF-32LE");
    }
    if bytes.len().is_multiple_of(4) && zeros(0, 4) == quarter && zeros(1, 4) > 0 {
        return Some("UTF-32BE");
    }
    let (high, low) = (zeros(1, 2), zeros(0, 2));
    // A few characters of other scripts have the low byte 0, such as 一 (U+4E00).
    if high > 2 * low { Some(UTF_16LE.name()) } else { (low > 2 * high).then(|| UTF_16BE.name()) }
}

/// Whether most of the bytes outside ASCII are valid UTF-8: a damaged or truncated file.
fn is_nearly_utf8(bytes: &[u8]) -> bool {
    let (mut valid, mut invalid) = (0, 0);
    for chunk in bytes.utf8_chunks() {
        valid += chunk.valid().chars().filter(|letter| !letter.is_ascii()).count();
        invalid += usize::from(!chunk.invalid().is_empty());
    }
    valid >= 8 && valid > 20 * invalid
}

fn guess(bytes: &[u8], language: &str) -> &'static Encoding {
    let mut detector = EncodingDetector::new(Iso2022JpDetection::Deny);
    detector.feed(bytes, true);
    // The detector knows languages by the top-level domains of their countries.
    let domain: Option<&[u8]> = match language.split('-').next().unwrap_or_default() {
        "ja" => Some(b"jp"),
        "ko" => Some(b"kr"),
        "zh" => Some(if language.contains("Hant") || language.contains("TW") { b"tw" } else { b"cn" }),
        _ => None,
    };
    detector.guess(domain, Utf8Detection::Deny)
}

fn utf32(bytes: &[u8], order: fn([u8; 4]) -> u32) -> String {
    let (units, rest) = bytes.as_chunks::<4>();
    let letter = |unit: &[u8; 4]| char::from_u32(order(*unit)).unwrap_or('\u{fffd}');
    let text: String = units.iter().map(letter).chain((!rest.is_empty()).then_some('\u{fffd}')).collect();
    text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text)
}

fn dos(bytes: &[u8]) -> String {
    let high: Vec<char> = DOS.chars().collect();
    let letter = |byte: &u8| byte.checked_sub(0x80).map_or(char::from(*byte), |at| high[usize::from(at)]);
    bytes.iter().map(letter).collect()
}

/// A file of a format that is always Unicode, such as JSON. Returns the text without its byte order mark.
///
/// # Errors
/// A reason, if the bytes are not UTF-8, UTF-16 or UTF-32.
pub fn unicode(bytes: &[u8]) -> Result<Cow<'_, str>, &'static str> {
    match std::str::from_utf8(bytes) {
        Ok(text) if !text.contains('\0') => Ok(Cow::Borrowed(crate::json::unmarked(text))),
        _ => decode(bytes, "")
            .filter(|text| !text.guessed && text.lost == 0)
            .map(|text| Cow::Owned(text.text))
            .ok_or("it is not text in UTF-8 or UTF-16"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SRT: &str = "1\r\n00:00:01,000 --> 00:00:02,500\r\n";

    fn encoded(text: &str, encoding: &str) -> Vec<u8> {
        let wide = |units: Vec<[u8; 4]>| units.concat();
        match encoding {
            "UTF-16LE" => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
            "UTF-16BE" => text.encode_utf16().flat_map(u16::to_be_bytes).collect(),
            "UTF-32LE" => wide(text.chars().map(|letter| u32::from(letter).to_le_bytes()).collect()),
            "UTF-32BE" => wide(text.chars().map(|letter| u32::from(letter).to_be_bytes()).collect()),
            _ => {
                let (bytes, _, lost) = Encoding::for_label(encoding.as_bytes()).unwrap().encode(text);
                assert!(!lost, "{text} has no form in {encoding}");
                bytes.into_owned()
            }
        }
    }

    #[test]
    fn unicode_is_read_with_and_without_its_mark() {
        for encoding in ["UTF-8", "UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE"] {
            for said in ["Schöne Grüße", "Привет, мир", "一二三「漢字」", "😀 \u{2028}"]
            {
                let text = format!("{SRT}{said}\r\n");
                for mark in ["", "\u{feff}"] {
                    let read = decode(&encoded(&format!("{mark}{text}"), encoding), "en").unwrap();
                    let expected =
                        Text { text: text.clone(), encoding: read.encoding, guessed: false, lost: 0 };
                    assert_eq!(read, expected, "{encoding}");
                    assert_eq!(read.encoding, encoding);
                }
            }
        }
    }

    #[test]
    fn old_encodings_are_guessed() {
        let cases = [
            ("windows-1252", "Öffnet die Tür, „schnell“! Das wäre schön. Ça va, garçon?"),
            ("windows-1250", "Příliš žluťoučký kůň úpěl ďábelské ódy. Zażółć gęślą jaźń."),
            ("windows-1251", "Привет, мир! Как дела? Всё хорошо, спасибо."),
            ("KOI8-U", "Привет, мир! Как дела? Сегодня хорошая погода, пойдём гулять."),
            ("windows-1253", "Καλημέρα, τι κάνεις σήμερα; Όλα είναι καλά."),
            (
                "windows-1254",
                "Günaydın, bugün nasılsın? Çok iyiyim, teşekkür ederim. Şimdi İstanbul'a gidiyoruz.",
            ),
            ("windows-1255", "שלום, מה שלומך היום? הכול בסדר, תודה."),
            ("windows-1256", "مرحبا، كيف حالك اليوم؟ كل شيء على ما يرام."),
            ("Shift_JIS", "こんにちは。今日はいい天気ですね。海へ行きましょう。"),
            ("EUC-JP", "こんにちは。今日はいい天気ですね。海へ行きましょう。"),
            ("ISO-2022-JP", "こんにちは。今日はいい天気ですね。"),
            ("GBK", "你好，世界！今天天气很好，我们去海边吧。"),
            ("Big5", "你好，世界！今天天氣很好，我們去海邊吧。"),
            ("EUC-KR", "안녕하세요. 오늘은 날씨가 좋네요. 바다에 갑시다."),
        ];
        for (encoding, said) in cases {
            let text = format!("{SRT}{said}\r\n\r\n2\r\n00:00:03,000 --> 00:00:04,000\r\n{said}\r\n");
            let read = decode(&encoded(&text, encoding), "en").unwrap();
            assert_eq!((read.encoding, read.guessed, read.lost), (encoding, true, 0));
            assert_eq!(read.text, text);
            assert_eq!(decode_as(&encoded(&text, encoding), encoding).unwrap().text, text);
        }
    }

    #[test]
    fn a_damaged_file_in_utf_8_stays_utf_8_and_its_losses_are_counted() {
        let text = "Привет, мир! ".repeat(20);
        let bytes = text.as_bytes();
        let cut = decode(&bytes[..bytes.len() - 15], "en").unwrap();
        assert_eq!((cut.encoding, cut.lost), ("UTF-8", 1));
        assert!(text.starts_with(cut.text.trim_end_matches('\u{fffd}')));
    }

    #[test]
    fn binary_files_are_refused() {
        let files: [&[u8]; 7] = [
            b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR",
            b"\xff\xd8\xff\xe0\0\x10JFIF\0\x01",
            b"12\0",
            b"1\xe9\n\x01",
            b"\xff\xfe\0\0\xff\xff\xff\xff\x01\0\0\0",
            b"\x1f\x8b\x08\0\0\0",
            b"\0\0\0\0",
        ];
        for file in files {
            assert_eq!(decode(file, "en"), None, "{file:?}");
        }
        assert_eq!(decode(b"", "en").unwrap().text, "");
        assert_eq!(decode_as(b"a", "nonsense"), None);
    }

    #[test]
    fn names_of_archives_are_read_together() {
        let read = |list: &[&str], encoding: &str| {
            let bytes: Vec<Vec<u8>> = list.iter().map(|name| encoded(name, encoding)).collect();
            names(&bytes.iter().map(Vec::as_slice).collect::<Vec<_>>(), "en")
        };
        for (encoding, list) in [
            ("UTF-8", ["あ.jpg", "ü.jpg"]),
            ("Shift_JIS", ["第一話/表紙.jpg", "第一話/ページ１.jpg"]),
            ("GBK", ["第一章/封面图片.jpg", "第一章/页面.jpg"]),
            ("IBM866", ["Глава 1/Страница.jpg", "Глава 1/Обложка.jpg"]),
            ("windows-1252", ["Übung/Größe.jpg", "Übung/Löwe.jpg"]),
        ] {
            assert_eq!(read(&list, encoding), list, "{encoding}");
        }
        assert_eq!(read(&["あ.jpg", "い.jpg"], "Shift_JIS"), ["あ.jpg", "い.jpg"]);
        let dos: [&[u8]; 3] = [b"\x8a.jpg", b"\x81.jpg", b"\xe1.jpg"];
        assert_eq!(names(&dos, "en"), ["è.jpg", "ü.jpg", "ß.jpg"]);
        let dos: [&[u8]; 2] = [b"K\x94ln/Stra\xe1e.jpg", b"K\x94ln/caf\x82.jpg"];
        assert_eq!(names(&dos, "en"), ["Köln/Straße.jpg", "Köln/café.jpg"]);
    }

    #[test]
    fn every_listed_encoding_is_known() {
        for (name, _) in ENCODINGS {
            assert_eq!(decode_as(b"a", name).unwrap().encoding, name);
        }
        assert_eq!(DOS.chars().count(), 128);
    }

    #[test]
    fn json_is_unicode() {
        for bytes in [&b"\xef\xbb\xbf{}"[..], b"\xff\xfe{\0}\0", b"{\0}\0", b"{}"] {
            assert_eq!(unicode(bytes).unwrap(), "{}");
        }
        assert!(unicode(b"{\"a\": \"\xe9\"}").is_err());
    }

    proptest! {
        #[test]
        fn any_text_survives(said in "[\\PC\n\t]{0,80}", which in 0_usize..5) {
            let encoding = ENCODINGS[which].0;
            let text = format!("{SRT}{}", said.replace('\u{fffd}', ""));
            let read = decode(&encoded(&text, encoding), "en").unwrap();
            prop_assert_eq!(read.encoding, encoding);
            prop_assert_eq!(read.text, text);
        }

        #[test]
        fn any_bytes_are_text_or_not(bytes in prop::collection::vec(any::<u8>(), 0..200), which in 0_usize..34) {
            if let Some(read) = decode(&bytes, "ja") {
                prop_assert_eq!(read.lost, read.text.matches('\u{fffd}').count());
            }
            prop_assert!(decode_as(&bytes, ENCODINGS[which].0).is_some());
            prop_assert_eq!(names(&[&bytes, b"a"], "en").len(), 2);
        }
    }
}
