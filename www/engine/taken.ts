/**
 * Capture time of a photo that the core does not read. Its EXIF record, a small TIFF file, is inside a box file (HEIF).
 * Source: CIPA DC-008 (Exif 2.32). Invalid records are ignored.
 */

const EXIF_DIRECTORY = 0x8769;
const DATES = [0x9003, 0x9004];
/** Number of bytes at the beginning and at the end that are searched for records. */
const REACH = 2 ** 20;

/**
 * @param bytes of an AVIF or HEIC file
 * @returns `YYYY:MM:DD HH:MM:SS`
 */
export function takenOf(bytes: Uint8Array): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = 0; at + 8 <= bytes.length; at += 1) {
    if (at === REACH) at = Math.max(at, bytes.length - REACH);
    const little = bytes[at] === 0x49;
    if (!little && bytes[at] !== 0x4d) continue;
    if (view.getUint32(at) !== (little ? 0x49492a00 : 0x4d4d002a) || view.getUint32(at + 4, little) !== 8) continue;
    const taken = dateOf(view, at, little);
    if (taken) return taken;
  }
  return null;
}

/**
 * @param start of the record
 * @param little its byte order
 */
function dateOf(view: DataView, start: number, little: boolean) {
  /** Position of a field. */
  const find = (directory: number, tag: number) => {
    const count = view.getUint16(directory, little);
    for (let i = 0; i < count; i += 1)
      if (view.getUint16(directory + 2 + 12 * i, little) === tag) return directory + 2 + 12 * i;
    return 0;
  };
  try {
    const pointer = find(start + 8, EXIF_DIRECTORY);
    const directory = pointer && start + view.getUint32(pointer + 8, little);
    const field = directory && (find(directory, DATES[0]) || find(directory, DATES[1]));
    if (!field) return null;
    const at = view.byteOffset + start + view.getUint32(field + 8, little);
    const text = String.fromCharCode(...new Uint8Array(view.buffer, at, 19));
    // A camera whose clock was never set writes zeros.
    return /^(?!0000)\d{4}:\d\d:\d\d \d\d:\d\d:\d\d$/.test(text) ? text : null;
  } catch {
    return null;
  }
}
