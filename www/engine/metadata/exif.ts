/**
 * EXIF records: small TIFF files inside of photos. An image needs only the orientation. A new record with only this
 * field replaces the original. Source: TIFF 6.0, CIPA DC-008 (Exif 2.32).
 */

const ORIENTATION = 0x0112;
/** Size of a field in bytes, and the type of a whole number of two bytes. */
const [FIELD, SHORT] = [12, 3];

/** @returns null if it is not a TIFF file */
function opened(record: Uint8Array): { view: DataView; little: boolean } | null {
  const view = new DataView(record.buffer, record.byteOffset, record.byteLength);
  const mark = record.length < 8 ? 0 : view.getUint32(0);
  return mark === 0x49492a00 || mark === 0x4d4d002a ? { view, little: mark === 0x49492a00 } : null;
}

/** @returns 1 to 8; 1 is upright, and the default */
export function orientationOf(record: Uint8Array): number {
  const tiff = opened(record);
  const field = tiff && fieldsOf(record, tiff).find(({ tag }) => tag === ORIENTATION);
  const value = field ? tiff.view.getUint16(field.at + 8, tiff.little) : 1;
  return value >= 1 && value <= 8 ? value : 1;
}

/**
 * @param orientation 1 to 8
 * @returns the record with another orientation, and with all other fields; null if it is not a TIFF file
 */
export function withOrientation(record: Uint8Array, orientation: number): Uint8Array<ArrayBuffer> | null {
  const tiff = opened(record);
  if (!tiff) return null;
  const fields = fieldsOf(record, tiff);
  const known = fields.find(({ tag }) => tag === ORIENTATION);
  const { little } = tiff;
  if (known) {
    const copy = record.slice();
    new DataView(copy.buffer).setUint16(known.at + 8, orientation, little);
    return copy;
  }
  // The directory is copied to the end, with one more field. Fields are in the order of their tags.
  const place = fields.filter(({ tag }) => tag < ORIENTATION).length;
  const from = tiff.view.getUint32(4, little);
  const start = record.length + (record.length % 2);
  const longer = new Uint8Array(start + 2 + FIELD * (fields.length + 1) + 4);
  const view = new DataView(longer.buffer);
  longer.set(record);
  view.setUint32(4, start, little);
  view.setUint16(start, fields.length + 1, little);
  fields.forEach(({ at }, i) =>
    longer.set(record.subarray(at, at + FIELD), start + 2 + FIELD * (i < place ? i : i + 1)),
  );
  const field = start + 2 + FIELD * place;
  view.setUint16(field, ORIENTATION, little);
  view.setUint16(field + 2, SHORT, little);
  view.setUint32(field + 4, 1, little);
  view.setUint16(field + 8, orientation, little);
  const next = from + 2 + FIELD * fields.length;
  if (next + 4 <= record.length) longer.set(record.subarray(next, next + 4), longer.length - 4);
  return longer;
}

/** @returns the fields of the first directory: their tags and positions */
function fieldsOf(record: Uint8Array, { view, little }: { view: DataView; little: boolean }) {
  const start = view.getUint32(4, little);
  const count = start + 2 <= record.length ? view.getUint16(start, little) : 0;
  const fields = [];
  for (let i = 0, at = start + 2; i < count && at + FIELD <= record.length; i += 1, at += FIELD)
    fields.push({ tag: view.getUint16(at, little), at });
  return fields;
}

/** @returns a record with only the orientation */
export function recordOf(orientation: number): Uint8Array<ArrayBuffer> {
  const record = new Uint8Array(26);
  const view = new DataView(record.buffer);
  view.setUint32(0, 0x49492a00);
  view.setUint32(4, 8, true);
  // One field: a short, once.
  for (const [at, value] of [
    [8, 1],
    [10, ORIENTATION],
    [12, SHORT],
    [14, 1],
    [18, orientation],
  ])
    view.setUint16(at, value, true);
  return record;
}
