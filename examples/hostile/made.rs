//! Generated malformed files, which are missing in public corpora. Tests include this module too.

/// A PNG file of 45 x 27 grey pixels with these chunks before them.
pub(crate) fn png(extra: &[([u8; 4], Vec<u8>)]) -> Vec<u8> {
    let head = [&45u32.to_be_bytes()[..], &27u32.to_be_bytes(), &[8, 0, 0, 0, 0]].concat();
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    add_chunk(&mut file, *b"IHDR", &head);
    for (kind, body) in extra {
        add_chunk(&mut file, *kind, body);
    }
    add_chunk(&mut file, *b"IDAT", &zeros(27 * 46));
    add_chunk(&mut file, *b"IEND", &[]);
    file
}

fn add_chunk(file: &mut Vec<u8>, kind: [u8; 4], body: &[u8]) {
    file.extend((body.len() as u32).to_be_bytes());
    let start = file.len();
    file.extend(kind);
    file.extend(body);
    let sum = crc32(&file[start..]);
    file.extend(sum.to_be_bytes());
}

/// The check sum of PNG chunks, four bits at a time.
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32| if crc & 1 == 1 { (crc >> 1) ^ 0xEDB8_8320 } else { crc >> 1 };
    let table: [u32; 16] = std::array::from_fn(|i| (0..4).fold(i as u32, |crc, _| step(crc)));
    let half = |crc: u32| table[(crc & 15) as usize] ^ crc >> 4;
    !bytes.iter().fold(!0, |crc, &byte| half(half(crc ^ u32::from(byte))))
}

/// A zlib stream of `count` zeros, one byte for 159: a zero, then copies of 258 with fixed codes of 13 bits each.
pub(crate) fn zeros(count: u64) -> Vec<u8> {
    let mut bits = Bits { out: vec![0x78, 0x01], pending: 0, length: 0 };
    bits.put(0b011, 3);
    let whole = count.saturating_sub(1) / 258;
    for _ in 0..count - whole * 258 {
        bits.code(0b0011_0000, 8);
    }
    for _ in 0..whole {
        bits.code(0b1100_0101, 8);
        bits.code(0, 5);
    }
    bits.code(0, 7);
    bits.put(0, 7);
    // Adler-32 of zeros: the first sum stays 1, the second one counts the zeros.
    let sum = ((count % 65_521) << 16 | 1) as u32;
    [bits.out, sum.to_be_bytes().to_vec()].concat()
}

struct Bits {
    out: Vec<u8>,
    pending: u32,
    length: u32,
}

impl Bits {
    /// The lowest bit first.
    fn put(&mut self, bits: u32, length: u32) {
        self.pending |= bits << self.length;
        self.length += length;
        while self.length >= 8 {
            self.out.push(self.pending as u8);
            (self.pending, self.length) = (self.pending >> 8, self.length - 8);
        }
    }

    /// The highest bit first, as codes of deflate are.
    fn code(&mut self, code: u32, length: u32) {
        self.put(code.reverse_bits() >> (32 - length), length);
    }
}

/// The body of an `iCCP` or `zTXt` chunk that inflates to `count` zeros.
pub(crate) fn inflating(count: u64) -> Vec<u8> {
    [b"bomb\0\0".to_vec(), zeros(count)].concat()
}

/// The body of an `iTXt` chunk of the same kind.
fn inflating_text(count: u64) -> Vec<u8> {
    [b"bomb\0\x01\0\0\0".to_vec(), zeros(count)].concat()
}

/// A JPEG file with segments of `kind` put in after its first two bytes.
pub(crate) fn jpeg_with(jpeg: &[u8], kind: u8, bodies: impl Iterator<Item = Vec<u8>>) -> Vec<u8> {
    let mut file = jpeg[..2].to_vec();
    for body in bodies {
        file.extend([0xFF, kind]);
        file.extend((body.len() as u16 + 2).to_be_bytes());
        file.extend(body);
    }
    file.extend(&jpeg[2..]);
    file
}

/// Returns an ICC profile in `count` segments of maximum size.
pub(crate) fn profile_parts(count: u8) -> impl Iterator<Item = Vec<u8>> {
    (1..=count).map(move |i| [b"ICC_PROFILE\0".to_vec(), vec![i, count], vec![7; 65_519]].concat())
}

/// A TIFF file without compression, of the samples that `Self::sample` tells.
#[derive(Clone)]
pub(crate) struct Tiff {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Sides of a tile; without, strips of four rows.
    pub(crate) tile: Option<(u32, u32)>,
    /// Samples a pixel.
    pub(crate) samples: u16,
    /// 8 or 16.
    pub(crate) bits: u16,
    /// Each sample is in a separate plane.
    pub(crate) planar: bool,
    /// Kinds of samples beyond the colours.
    pub(crate) extra: Vec<u16>,
    /// Fields that replace or join the others: tag, type, count, value.
    pub(crate) fields: Vec<[u32; 4]>,
}

impl Tiff {
    /// Three samples of eight bits, side by side.
    pub(crate) fn rgb(width: u32, height: u32) -> Self {
        let (tile, extra, fields) = (None, Vec::new(), Vec::new());
        Self { width, height, tile, samples: 3, bits: 8, planar: false, extra, fields }
    }

    /// Returns the value of a sample. With 16 bits, both bytes have this value.
    pub(crate) fn sample(x: u32, y: u32, channel: u32) -> u8 {
        (x * 5 + y * 3 + channel * 70) as u8
    }

    /// The file.
    pub(crate) fn file(&self) -> Vec<u8> {
        let (chunk_width, chunk_height) = self.tile.unwrap_or((self.width, 4.min(self.height)));
        let across = self.width.div_ceil(chunk_width);
        let down = self.height.div_ceil(chunk_height);
        let samples = u32::from(self.samples);
        let planes = if self.planar { samples } else { 1 };
        let mut file = b"II*\0\0\0\0\0".to_vec();
        let (mut offsets, mut lengths) = (Vec::new(), Vec::new());
        for chunk in 0..planes * across * down {
            let (plane, place) = (chunk / (across * down), chunk % (across * down));
            let (left, top) = (place % across * chunk_width, place / across * chunk_height);
            // The last strip ends with the image, but a tile is always complete.
            let rows = if self.tile.is_some() { chunk_height } else { chunk_height.min(self.height - top) };
            offsets.push(file.len() as u32);
            for y in top..top + rows {
                for x in left..left + chunk_width {
                    let channels = if self.planar { plane..plane + 1 } else { 0..samples };
                    for channel in channels {
                        let value = Self::sample(x, y, channel);
                        file.extend([value, value].iter().take(usize::from(self.bits / 8)));
                    }
                }
            }
            lengths.push(file.len() as u32 - offsets.last().copied().unwrap_or(0));
        }
        file.resize(file.len().next_multiple_of(2), 0);
        let mut fields = vec![
            [256, 4, 1, self.width],
            [257, 4, 1, self.height],
            [259, 3, 1, 1],
            [262, 3, 1, if self.samples < 3 { 1 } else { 2 }],
            [277, 3, 1, samples],
            [284, 3, 1, if self.planar { 2 } else { 1 }],
        ];
        fields.push(list(&mut file, 258, 3, &vec![u32::from(self.bits); self.samples.into()]));
        if !self.extra.is_empty() {
            let extra: Vec<u32> = self.extra.iter().map(|&kind| kind.into()).collect();
            fields.push(list(&mut file, 338, 3, &extra));
        }
        let tags = if self.tile.is_some() { [322, 323, 324, 325] } else { [0, 278, 273, 279] };
        fields.push([tags[0], 4, 1, chunk_width]);
        fields.push([tags[1], 4, 1, chunk_height]);
        fields.push(list(&mut file, tags[2], 4, &offsets));
        fields.push(list(&mut file, tags[3], 4, &lengths));
        fields.retain(|field| field[0] > 0 && self.fields.iter().all(|other| other[0] != field[0]));
        fields.extend(&self.fields);
        fields.sort_unstable();
        let directory = (file.len() as u32).to_le_bytes();
        file[4..8].copy_from_slice(&directory);
        file.extend((fields.len() as u16).to_le_bytes());
        for [tag, kind, count, value] in fields {
            file.extend((tag as u16).to_le_bytes());
            file.extend((kind as u16).to_le_bytes());
            file.extend([count.to_le_bytes(), value.to_le_bytes()].concat());
        }
        file.extend([0; 4]);
        file
    }
}

/// Writes a field of 16-bit (3) or 32-bit (4) values. If they fit, they are stored in the field itself.
fn list(file: &mut Vec<u8>, tag: u32, kind: u32, values: &[u32]) -> [u32; 4] {
    let bytes: Vec<u8> =
        values.iter().flat_map(|value| value.to_le_bytes().into_iter().take(2 * kind as usize - 4)).collect();
    let count = values.len() as u32;
    if let Some(value) = bytes.first_chunk().filter(|_| bytes.len() == 4) {
        return [tag, kind, count, u32::from_le_bytes(*value)];
    }
    if bytes.len() < 4 {
        return [tag, kind, count, values[0]];
    }
    let at = file.len() as u32;
    file.extend(bytes);
    file.resize(file.len().next_multiple_of(2), 0);
    [tag, kind, count, at]
}

/// A GIF file: a screen, and one frame of it in two colours.
pub(crate) fn gif(screen: (u16, u16), place: (u16, u16), frame: (u16, u16)) -> Vec<u8> {
    let pair = |(x, y): (u16, u16)| [x.to_le_bytes(), y.to_le_bytes()].concat();
    let mut file = [b"GIF89a".to_vec(), pair(screen), vec![0x80, 0, 0, 200, 0, 0, 0, 0, 200, b',']].concat();
    file.extend([pair(place), pair(frame), vec![0, 2]].concat());
    // Codes of three bits: a clear before every second pixel keeps them so.
    let mut bits = Bits { out: Vec::new(), pending: 0, length: 0 };
    let pixels = u32::from(frame.0) * u32::from(frame.1);
    for pixel in 0..pixels.min(100_000) {
        if pixel % 2 == 0 {
            bits.put(4, 3);
        }
        bits.put(pixel % 2, 3);
    }
    bits.put(5, 3);
    bits.put(0, 7);
    for block in bits.out.chunks(255) {
        file.push(block.len() as u8);
        file.extend(block);
    }
    file.extend([0, b';']);
    file
}

/// All files of the corpus, named for the table's complaints.
#[allow(dead_code, reason = "the tests that take this module make their own choice")]
pub(crate) fn all(jpeg: &[u8]) -> Vec<(String, Vec<u8>)> {
    const HUGE: u64 = 900 << 20;
    let mut files = Vec::new();
    let mut add = |name: String, file: Vec<u8>| files.push((name, file));
    add("png-iccp-900-mb".into(), png(&[(*b"iCCP", inflating(HUGE))]));
    add("png-iccp-twice".into(), png(&[(*b"iCCP", inflating(HUGE)), (*b"iCCP", inflating(HUGE))]));
    add("png-ztxt-900-mb".into(), png(&[(*b"zTXt", inflating(HUGE))]));
    add("png-itxt-900-mb".into(), png(&[(*b"iTXt", inflating_text(HUGE))]));
    add("png-exif-60-mb".into(), png(&[(*b"eXIf", vec![b'I'; 60 << 20])]));
    add("png-text-60-mb".into(), png(&[(*b"tEXt", vec![b'a'; 60 << 20])]));
    add("jpeg-icc-16-mb".into(), jpeg_with(jpeg, 0xE2, profile_parts(255)));
    let part = || profile_parts(1).map(|part| part[..40].to_vec());
    add("jpeg-icc-many".into(), jpeg_with(jpeg, 0xE2, (0..500_000).flat_map(|_| part())));
    let comments = (0..900).map(|_| vec![b'a'; 65_000]);
    add("jpeg-comments-60-mb".into(), jpeg_with(jpeg, 0xFE, comments));
    for (width, height) in [(1, 1), (45, 27), (48, 32), (100, 70), (17, 200)] {
        for tile in [None, Some((16, 16)), Some((48, 32)), Some((64, 16)), Some((256, 256)), Some((1, 1))] {
            for (samples, bits, planar) in
                [(3, 8, true), (3, 16, true), (4, 8, true), (1, 8, true), (3, 8, false)]
            {
                let extra = if samples == 4 { vec![1] } else { Vec::new() };
                let tiff = Tiff { tile, samples, bits, planar, extra, ..Tiff::rgb(width, height) };
                let words = if planar { "planar" } else { "pixels" };
                let tile = tile.map_or("strips".into(), |(w, h)| format!("tiles-{w}x{h}"));
                add(format!("tiff-{width}x{height}-{tile}-{samples}x{bits}-{words}"), tiff.file());
            }
        }
    }
    // One wrong field: tags of sides, counts and positions, with unusual types and numbers.
    for tag in
        [256, 257, 258, 259, 262, 273, 277, 278, 279, 284, 317, 320, 322, 323, 324, 325, 338, 339, 347, 530]
    {
        for (kind, count, value) in [
            (3, 1, 0),
            (3, 1, 65_535),
            (4, 1, u32::MAX),
            (4, 1, 1 << 24),
            (4, 1 << 26, 8),
            (1, u32::MAX, 8),
            (5, 1, 8),
            (2, 3, 0x0041_4141),
            (3, 0, 1),
            (12, 1 << 20, 8),
        ] {
            for tile in [None, Some((16, 16))] {
                let tiff = Tiff { tile, fields: vec![[tag, kind, count, value]], ..Tiff::rgb(45, 27) };
                add(format!("tiff-field-{tag}-{kind}-{count}-{value}"), tiff.file());
                let planar = Tiff { planar: true, ..tiff };
                add(format!("tiff-field-{tag}-{kind}-{count}-{value}-planar"), planar.file());
            }
        }
    }
    for compression in [2, 3, 4, 5, 6, 7, 8, 32_773, 32_946, 34_712, 50_000, 50_001] {
        let tiff = Tiff { fields: vec![[259, 3, 1, compression]], ..Tiff::rgb(45, 27) };
        add(format!("tiff-compression-{compression}"), tiff.file());
    }
    for screen in [(0, 0), (45, 27), (1, 1), (65_535, 65_535), (40, 65_535)] {
        for (place, frame) in
            [((0, 0), (45, 27)), ((9, 9), (9, 9)), ((60_000, 60_000), (9, 9)), ((0, 0), (0, 0))]
        {
            add(format!("gif-{screen:?}-{place:?}-{frame:?}"), gif(screen, place, frame));
        }
        add(format!("gif-{screen:?}-huge"), gif(screen, (0, 0), (65_535, 65_535)));
        add(format!("gif-{screen:?}-gigabyte"), gif(screen, (0, 0), (16_000, 16_000)));
    }
    files
}
