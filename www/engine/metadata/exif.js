// @ts-check
/**
 * EXIF records: small TIFF files inside of photos. Of all that they say a picture needs one field, which side is up.
 * Source: TIFF 6.0, CIPA DC-008 (Exif 2.32).
 */

const ORIENTATION = 0x0112;
/** Directories behind a field: EXIF, place, interoperability, and more pictures. */
const DIRECTORIES = [0x8769, 0x8825, 0xa005, 0x014a];
/** Where the thumbnail of a record is, and its length. */
const [THUMBNAIL, THUMBNAIL_LENGTH] = [0x0201, 0x0202];
/** Bytes of a value by its type. */
const SIZES = [0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4];
const FIELD = 12;
/** A file has a handful. */
const MOST_DIRECTORIES = 64;

/**
 * @param {Uint8Array} record
 * @returns {{ view: DataView, little: boolean } | null} null where it is no TIFF file
 */
function opened(record) {
  const view = new DataView(record.buffer, record.byteOffset, record.byteLength);
  const mark = record.length < 8 ? 0 : view.getUint32(0);
  return mark === 0x49492a00 || mark === 0x4d4d002a ? { view, little: mark === 0x49492a00 } : null;
}

/** @param {Uint8Array} record @returns {number} 1 to 8; 1 is upright, also where nothing is said */
export function orientationOf(record) {
  const tiff = opened(record);
  if (!tiff) return 1;
  const { view, little } = tiff;
  const at = view.getUint32(4, little);
  const count = at + 2 <= record.length ? view.getUint16(at, little) : 0;
  for (let i = 0, field = at + 2; i < count && field + FIELD <= record.length; i += 1, field += FIELD) {
    if (view.getUint16(field, little) !== ORIENTATION) continue;
    const value = view.getUint16(field + 8, little);
    return value >= 1 && value <= 8 ? value : 1;
  }
  return 1;
}

/** @param {number} orientation @returns {Uint8Array<ArrayBuffer>} a record that says nothing else */
export function recordOf(orientation) {
  const record = new Uint8Array(26);
  const view = new DataView(record.buffer);
  view.setUint32(0, 0x49492a00);
  view.setUint32(4, 8, true);
  // One field: a short, once.
  for (const [at, value] of [[8, 1], [10, ORIENTATION], [12, 3], [14, 1], [18, orientation]]) view.setUint16(at, value, true);
  return record;
}

/**
 * Takes fields out of a record where it stands, and blanks their values. All else stays where it was.
 * @param {Uint8Array} record is changed
 * @param {(tag: number) => boolean} keeps whether a field of a picture stays; of the directories behind a field that goes, none does
 * @returns {boolean} whether it is a record
 */
export function scrub(record, keeps) {
  const tiff = opened(record);
  if (!tiff) return false;
  const { view, little } = tiff;
  const seen = new Set();
  // A value that claims to lie in the head of the file is a fault of its writer.
  const blank = (/** @type {number} */ from, /** @type {number} */ length) => { if (from >= 8) record.fill(0, from, from + length); };

  /** @param {number} at @param {(tag: number) => boolean} stays */
  const directory = (at, stays) => {
    if (seen.has(at) || seen.size === MOST_DIRECTORIES || at < 8 || at + 2 > record.length) return;
    seen.add(at);
    const count = view.getUint16(at, little);
    const end = at + 2 + count * FIELD;
    if (end > record.length) return;
    const next = end + 4 <= record.length ? view.getUint32(end, little) : 0;
    let to = at + 2;
    const thumbnail = { from: 0, length: 0 };
    for (let field = at + 2; field < end; field += FIELD) {
      const [tag, type, many, value] = [view.getUint16(field, little), view.getUint16(field + 2, little), view.getUint32(field + 4, little), view.getUint32(field + 8, little)];
      const length = many * (SIZES[type] ?? 1);
      const kept = stays(tag);
      if (DIRECTORIES.includes(tag)) {
        const list = Array.from({ length: length > 4 ? Math.min(many, MOST_DIRECTORIES) : 1 }, (_, i) => (length > 4 ? value + 4 * i : field + 8));
        for (const place of list) if (place + 4 <= record.length) directory(view.getUint32(place, little), kept ? stays : () => false);
      }
      if (kept) {
        record.copyWithin(to, field, field + FIELD);
        to += FIELD;
      } else {
        if (tag === THUMBNAIL) thumbnail.from = value;
        if (tag === THUMBNAIL_LENGTH) thumbnail.length = value;
        if (length > 4) blank(value, length);
      }
    }
    if (thumbnail.from > 0) blank(thumbnail.from, thumbnail.length);
    view.setUint16(at, (to - at - 2) / FIELD, little);
    blank(to, Math.min(end + 4, record.length) - to);
    if (to + 4 <= record.length) view.setUint32(to, next, little);
    directory(next, stays);
  };
  directory(view.getUint32(4, little), keeps);
  return true;
}

/** @param {number} tag */
export const isOrientation = (tag) => tag === ORIENTATION;
