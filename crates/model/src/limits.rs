//! All limits of a document. They are far above normal use, and low enough to read the largest document in
//! seconds and a hundred megabytes. Limits that other modules enforce are defined there.

use crate::json::Bounds;
pub use crate::page::{LONGEST_ID, MOST_PHOTOS};
pub use crate::style::file::MOST_BLOCKS;
pub use crate::style::texture::MOST_BYTES as TEXTURE;
pub use crate::text::{MOST_LETTERS, MOST_WORDS};

/// Bytes of one text: a texture as a data URL is the longest.
const TEXT: usize = 2 * TEXTURE;
/// The text of a project file, and the text in a page PNG.
pub const PROJECT: Bounds = Bounds { bytes: 32 << 20, values: 2_000_000, text: TEXT };
/// A project with all its undo steps, as the browser's database has it.
pub const HISTORY: Bounds = Bounds { bytes: 128 << 20, values: 8_000_000, text: TEXT };
/// Bytes of the text in a page PNG, which contains all pages of its storyboard.
pub const PAGE_TEXT: usize = PROJECT.bytes;
/// Files in a project file. Pages that were shown before may need more photos than a project has at a time.
pub const ARCHIVE_ENTRIES: usize = 20_000;
/// Maximum unpacked size of one file in a project file, in bytes. The file is in memory, and once more during
/// decoding.
pub const ENTRY: u64 = 128 << 20;
/// Maximum number of chunks of a PNG file. More chunks mean a malformed file.
pub const PNG_CHUNKS: usize = 100_000;
/// Maximum number of other text chunks before the project in a PNG file. Files with more are treated as
/// images.
pub const PNG_TEXTS: usize = 64;
/// Characters of a name: of a project, a photo, a video, an author.
pub const LONGEST_NAME: usize = 1_000;
/// Characters of a place in the archive of a project file, and of the type of a file.
pub const LONGEST_PATH: usize = 1_000;
/// Undo steps, and as many redo steps.
pub const MOST_STEPS: usize = 500;
/// Maximum number of pages in the page history. The oldest are dropped first, favourites never.
pub const MOST_SHOWN: usize = 1_000;
/// Pages of one storyboard.
pub const MOST_SHEETS: usize = 1_000;
/// Maximum number of custom styles, and of favourite styles. The list offers 300; merged projects may have
/// more.
pub const MOST_STYLES: usize = 1_000;
/// Maximum number of custom layouts.
pub const MOST_LAYOUTS: usize = 1_000;
/// Maximum number of favourite pages. Favourites stay in the list after their pages are dropped.
pub const MOST_LOVED: usize = 10_000;
/// Maximum number of panels that a user can request.
pub const MOST_WANTED: u64 = 100;
/// Maximum number of unplaced text items of a project: text of photos that no page shows, and text without
/// space on its panel.
pub const MOST_WAITING: usize = 2_000;
/// Text items that one edit adds.
pub const MOST_ADDED: usize = 20_000;
/// Videos in a project file: each has at least one frame, which is a photo.
pub const MOST_VIDEOS: usize = ARCHIVE_ENTRIES;
/// Maximum number of subjects in one photo.
pub const MOST_SUBJECTS: usize = 1_000;
/// Families that a draft belongs to.
pub const MOST_TAGS: usize = 20;
/// Maximum id of pages and storyboard positions that a file may contain. New ids are larger.
pub const GREATEST_ID: u64 = 1 << 40;
/// Pixels of a side of a photo.
pub const LONGEST_SIDE: u64 = 1_000_000;
/// Maximum length of one shot field in characters.
pub const LONGEST_FIELD: usize = 10_000;
/// Characters of the number or the scene of a shot, and of the name of a column.
pub const LONGEST_LABEL: usize = 200;
/// Characters of the logo of a board: a PNG file of 48 kB as a data URL.
pub const LONGEST_LOGO: usize = 64 << 10;
/// Maximum number of custom columns.
pub const MOST_COLUMNS: usize = 12;
/// Frames of a shot: a day of thirty a second.
pub const MOST_SHOT_FRAMES: u32 = 24 * 60 * 60 * 30;
/// Maximum number of reported dropped parts.
pub const MOST_TOLD: usize = 20;

/// Default maximum fingerprint distance of near-duplicates, in bits. A test set of 2145 pairs of different
/// photos has no pair this close.
pub const DUPLICATE_THRESHOLD: u32 = 10;
/// Range of the thresholds that the app offers.
pub const DUPLICATE_THRESHOLD_RANGE: [u32; 2] = [4, 16];
