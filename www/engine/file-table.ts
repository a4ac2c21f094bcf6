/** Kinds of files. `cargo xtask bless` generates this file from `crates/engine/src/kinds.rs`. */

export type Role =
  | 'photo'
  | 'video'
  | 'subtitles'
  | 'text'
  | 'board'
  | 'json'
  | 'project'
  | 'archive'
  | 'painters'
  | 'sidecar'
  | 'unsupported';
export type Remedy = 'jpeg' | 'unpack' | 'pages' | 'mp4' | 'srt' | 'fountain' | 'csv' | 'text';
/** `endings` of names, separated by spaces; `type`: media type, if any; `remedy` for files that cannot be read */
export type FileKind = { name: string; type: string; endings: string; role: Role; remedy?: Remedy };

export const FILE_KINDS: readonly FileKind[] = [
  {
    name: 'JPEG',
    type: 'image/jpeg',
    endings: 'jpg jpeg jpe jif jfif jfi pjpeg pjp mpo',
    role: 'photo',
  },
  {
    name: 'PNG',
    type: 'image/png',
    endings: 'png apng',
    role: 'photo',
  },
  {
    name: 'WebP',
    type: 'image/webp',
    endings: 'webp',
    role: 'photo',
  },
  {
    name: 'AVIF',
    type: 'image/avif',
    endings: 'avif',
    role: 'photo',
  },
  {
    name: 'HEIC',
    type: 'image/heic',
    endings: 'heic heif hif',
    role: 'photo',
  },
  {
    name: 'GIF',
    type: 'image/gif',
    endings: 'gif',
    role: 'photo',
  },
  {
    name: 'BMP',
    type: 'image/bmp',
    endings: 'bmp dib',
    role: 'photo',
  },
  {
    name: 'TIFF',
    type: 'image/tiff',
    endings: 'tif tiff',
    role: 'photo',
  },
  {
    name: 'MP4',
    type: 'video/mp4',
    endings: 'mp4 m4v',
    role: 'video',
  },
  {
    name: 'QuickTime',
    type: 'video/quicktime',
    endings: 'mov qt',
    role: 'video',
  },
  {
    name: 'WebM',
    type: 'video/webm',
    endings: 'webm',
    role: 'video',
  },
  {
    name: 'Matroska',
    type: 'video/x-matroska',
    endings: 'mkv',
    role: 'video',
  },
  {
    name: 'MPEG transport stream',
    type: 'video/mp2t',
    endings: 'ts m2ts mts',
    role: 'video',
  },
  {
    name: 'AVI',
    type: 'video/x-msvideo',
    endings: 'avi',
    role: 'video',
  },
  {
    name: 'MPEG',
    type: 'video/mpeg',
    endings: 'mpg mpeg',
    role: 'video',
  },
  {
    name: 'Windows Media',
    type: 'video/x-ms-wmv',
    endings: 'wmv',
    role: 'video',
  },
  {
    name: 'Flash Video',
    type: 'video/x-flv',
    endings: 'flv',
    role: 'video',
  },
  {
    name: 'Ogg',
    type: 'video/ogg',
    endings: 'ogv',
    role: 'video',
  },
  {
    name: '3GPP',
    type: 'video/3gpp',
    endings: '3gp 3g2',
    role: 'video',
  },
  {
    name: 'SubRip',
    type: 'application/x-subrip',
    endings: 'srt',
    role: 'subtitles',
  },
  {
    name: 'WebVTT',
    type: 'text/vtt',
    endings: 'vtt',
    role: 'subtitles',
  },
  {
    name: 'SubStation Alpha',
    type: 'text/x-ssa',
    endings: 'ass ssa',
    role: 'subtitles',
  },
  {
    name: 'SBV',
    type: '',
    endings: 'sbv',
    role: 'subtitles',
  },
  {
    name: 'plain text',
    type: 'text/plain',
    endings: 'txt',
    role: 'text',
  },
  {
    name: 'Fountain',
    type: '',
    endings: 'fountain spmd',
    role: 'board',
  },
  {
    name: 'CSV',
    type: 'text/csv',
    endings: 'csv tsv',
    role: 'board',
  },
  {
    name: 'JSON',
    type: 'application/json',
    endings: 'json',
    role: 'json',
  },
  {
    name: 'Inkpanel project',
    type: 'application/x-inkpanel',
    endings: 'inkpanel',
    role: 'project',
  },
  {
    name: 'ZIP',
    type: 'application/zip',
    endings: 'zip',
    role: 'archive',
  },
  {
    name: 'CBZ',
    type: 'application/vnd.comicbook+zip',
    endings: 'cbz',
    role: 'archive',
  },
  {
    name: 'ONNX',
    type: '',
    endings: 'onnx',
    role: 'painters',
  },
  {
    name: 'edits of a photo',
    type: '',
    endings: 'aae xmp pp3 dop on1 cos',
    role: 'sidecar',
  },
  {
    name: 'preview of a camera',
    type: '',
    endings: 'thm lrv ctg',
    role: 'sidecar',
  },
  {
    name: 'camera raw',
    type: '',
    endings: 'dng cr2 cr3 crw nef nrw arw srf sr2 raf orf rw2 pef srw x3f 3fr iiq rwl kdc dcr erf mrw gpr',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'JPEG XL',
    type: '',
    endings: 'jxl',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'JPEG 2000',
    type: '',
    endings: 'jp2 j2k jpf jpx j2c',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'Photoshop',
    type: '',
    endings: 'psd psb',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'SVG',
    type: '',
    endings: 'svg svgz',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'OpenEXR',
    type: '',
    endings: 'exr',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'TGA',
    type: '',
    endings: 'tga',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'ICO',
    type: '',
    endings: 'ico',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'GIMP',
    type: '',
    endings: 'xcf',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'Krita',
    type: '',
    endings: 'kra',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'Clip Studio',
    type: '',
    endings: 'clip lip',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'Procreate',
    type: '',
    endings: 'procreate',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'Illustrator',
    type: '',
    endings: 'ai eps',
    role: 'unsupported',
    remedy: 'jpeg',
  },
  {
    name: 'RAR',
    type: '',
    endings: 'rar cbr',
    role: 'unsupported',
    remedy: 'unpack',
  },
  {
    name: '7-Zip',
    type: '',
    endings: '7z cb7',
    role: 'unsupported',
    remedy: 'unpack',
  },
  {
    name: 'tar',
    type: '',
    endings: 'tar cbt tgz gz bz2 xz zst',
    role: 'unsupported',
    remedy: 'unpack',
  },
  {
    name: 'PDF',
    type: '',
    endings: 'pdf',
    role: 'unsupported',
    remedy: 'pages',
  },
  {
    name: 'EPUB',
    type: '',
    endings: 'epub',
    role: 'unsupported',
    remedy: 'pages',
  },
  {
    name: 'Kindle',
    type: '',
    endings: 'mobi azw azw3',
    role: 'unsupported',
    remedy: 'pages',
  },
  {
    name: 'DjVu',
    type: '',
    endings: 'djvu djv',
    role: 'unsupported',
    remedy: 'pages',
  },
  {
    name: 'RealMedia',
    type: '',
    endings: 'rm rmvb',
    role: 'unsupported',
    remedy: 'mp4',
  },
  {
    name: 'DVD video',
    type: '',
    endings: 'vob',
    role: 'unsupported',
    remedy: 'mp4',
  },
  {
    name: 'MXF',
    type: '',
    endings: 'mxf',
    role: 'unsupported',
    remedy: 'mp4',
  },
  {
    name: 'raw video',
    type: '',
    endings: 'r3d braw crm',
    role: 'unsupported',
    remedy: 'mp4',
  },
  {
    name: 'TTML',
    type: '',
    endings: 'ttml dfxp',
    role: 'unsupported',
    remedy: 'srt',
  },
  {
    name: 'SAMI',
    type: '',
    endings: 'smi',
    role: 'unsupported',
    remedy: 'srt',
  },
  {
    name: 'MicroDVD or VobSub',
    type: '',
    endings: 'sub idx',
    role: 'unsupported',
    remedy: 'srt',
  },
  {
    name: 'lyrics',
    type: '',
    endings: 'lrc',
    role: 'unsupported',
    remedy: 'srt',
  },
  {
    name: 'Final Draft',
    type: '',
    endings: 'fdx fdr',
    role: 'unsupported',
    remedy: 'fountain',
  },
  {
    name: 'Celtx',
    type: '',
    endings: 'celtx',
    role: 'unsupported',
    remedy: 'fountain',
  },
  {
    name: 'Fade In',
    type: '',
    endings: 'fadein',
    role: 'unsupported',
    remedy: 'fountain',
  },
  {
    name: 'Excel',
    type: '',
    endings: 'xlsx xls xlsm',
    role: 'unsupported',
    remedy: 'csv',
  },
  {
    name: 'OpenDocument table',
    type: '',
    endings: 'ods',
    role: 'unsupported',
    remedy: 'csv',
  },
  {
    name: 'Numbers',
    type: '',
    endings: 'numbers',
    role: 'unsupported',
    remedy: 'csv',
  },
  {
    name: 'Word',
    type: '',
    endings: 'docx doc',
    role: 'unsupported',
    remedy: 'text',
  },
  {
    name: 'OpenDocument text',
    type: '',
    endings: 'odt',
    role: 'unsupported',
    remedy: 'text',
  },
  {
    name: 'RTF',
    type: '',
    endings: 'rtf',
    role: 'unsupported',
    remedy: 'text',
  },
];

/** Names of files of systems and programs, in lower case. */
export const SYSTEM_NAMES: readonly string[] = [
  'thumbs.db',
  'ehthumbs.db',
  'ehthumbs_vista.db',
  'desktop.ini',
  'picasa.ini',
  'icon\r',
];

/** Folders of systems and programs. */
export const SYSTEM_FOLDERS: readonly string[] = [
  '__MACOSX',
  '@eaDir',
  '#recycle',
  '$RECYCLE.BIN',
  'System Volume Information',
];

/** First bytes of kinds: a position, the bytes there, and an ending of the kind. */
export const SIGNATURES: readonly [at: number, bytes: readonly number[], ending: string][] = [
  [0, [82, 97, 114, 33, 26, 7], 'rar'],
  [0, [55, 122, 188, 175, 39, 28], '7z'],
  [0, [31, 139, 8], 'gz'],
  [257, [117, 115, 116, 97, 114], 'tar'],
  [0, [37, 80, 68, 70, 45], 'pdf'],
  [0, [56, 66, 80, 83], 'psd'],
  [0, [0, 0, 0, 12, 74, 88, 76, 32], 'jxl'],
  [0, [255, 10], 'jxl'],
  [0, [0, 0, 0, 12, 106, 80, 32, 32], 'jp2'],
  [0, [255, 79, 255, 81], 'j2c'],
  [0, [70, 85, 74, 73, 70, 73, 76, 77, 67, 67, 68, 45, 82, 65, 87], 'raf'],
  [4, [102, 116, 121, 112, 99, 114, 120, 32], 'cr3'],
  [0, [73, 73, 82, 79], 'orf'],
  [0, [73, 73, 85, 0], 'rw2'],
  [0, [118, 47, 49, 1], 'exr'],
  [0, [103, 105, 109, 112, 32, 120, 99, 102], 'xcf'],
  [0, [60, 115, 118, 103], 'svg'],
  [0, [65, 84, 38, 84, 70, 79, 82, 77], 'djvu'],
  [0, [80, 75, 3, 4], 'zip'],
  [0, [26, 69, 223, 163], 'mkv'],
  [4, [102, 116, 121, 112, 113, 116, 32, 32], 'mov'],
  [4, [102, 116, 121, 112, 105, 115, 111, 109], 'mp4'],
  [4, [102, 116, 121, 112, 109, 112, 52], 'mp4'],
  [4, [102, 116, 121, 112, 105, 115, 111], 'mp4'],
  [4, [102, 116, 121, 112, 97, 118, 99, 49], 'mp4'],
  [4, [102, 116, 121, 112, 77, 52, 86], 'm4v'],
  [4, [109, 111, 111, 118], 'mov'],
  [4, [102, 116, 121, 112, 51, 103], '3gp'],
];

/** Brands of HEIC and AVIF files. */
export const HEIC_BRANDS = ['heic', 'heix', 'heim', 'heis', 'hevc', 'hevx', 'mif1', 'msf1'];
export const AVIF_BRANDS = ['avif', 'avis'];
