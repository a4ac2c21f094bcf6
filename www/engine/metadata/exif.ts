/**
 * EXIF records: small TIFF files inside of photos. An image needs only the orientation. A new record with only this
 * field replaces the original. Source: TIFF 6.0, CIPA DC-008 (Exif 2.32).
 */

const ORIENTATION = 0x0112;
const FIELD = 12;

/** @returns null if it is not a TIFF file */
function opened(record: Uint8Array): { view: DataView; little: boolean } | null {
  const view = new DataView(record.buffer, record.byteOffset, record.byteLength);
  const mark = record.length < 8 ? 0 : view.getUint32(0);
  return mark === 0x49492a00 || mark === 0x4d4d002a ? { view, little: mark === 0x49492a00 } : null;
}

/** @returns 1 to 8; 1 is upright, and the default */
export function orientationOf(record: Uint8Array): number {
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
    [12, 3],
    [14, 1],
    [18, orientation],
  ])
    view.setUint16(at, value, true);
  return record;
}
