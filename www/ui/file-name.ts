/** File names for all systems: readable, without characters that Windows, macOS or Linux reject. */

/** Maximum bytes of a name without its extension. Systems allow 255, and browsers add ` (1)` to an existing name. */
const MOST_BYTES = 180;
/**
 * Characters that Windows rejects, path separators, control characters, and direction marks, which can disguise an
 * extension.
 */
const REFUSED = /[<>:"/\\|?*\p{Cc}\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\ufeff]+/gu;
/** Names of devices on Windows, whatever ending they have. */
const DEVICE = /^(con|prn|aux|nul|conin\$|conout\$|com[0-9¹²³]|lpt[0-9¹²³])(?=\.|$)/i;

/**
 * @param parts parts of the name, joined by ` - `; empty ones are skipped. If the name is too long, the first part is
 *   truncated
 * @param ending without its dot
 * @param fallback used if the first part has no allowed characters
 */
export function fileNameOf(parts: readonly string[], ending: string, fallback: string): string {
  const [first = '', ...rest] = parts;
  const tail = rest
    .map(cleaned)
    .filter((part) => part !== '')
    .map((part) => ` - ${part}`)
    .join('');
  const room = Math.max(16, MOST_BYTES - bytesOf(tail));
  const head = cut(cleaned(first) || cleaned(fallback), room);
  return `${undeviced(`${head}${tail}`)}.${ending}`;
}

function cleaned(part: string): string {
  const plain = part
    .replaceAll(/\p{Surrogate}/gu, '\ufffd')
    .normalize('NFC')
    .replaceAll(REFUSED, ' ')
    .replaceAll(/\s+/gu, ' ');
  // A leading dot hides the file, and Windows removes trailing dots and spaces.
  return plain.replaceAll(/^[. ~]+|[. ]+$/gu, '');
}

function undeviced(name: string): string {
  return DEVICE.test(name) ? `_${name}` : name;
}

/** Cuts between user-perceived characters. */
function cut(text: string, most: number): string {
  if (bytesOf(text) <= most) return text;
  let kept = '';
  for (const letter of lettersOf(text)) {
    if (bytesOf(kept + letter) > most) break;
    kept += letter;
  }
  return cleaned(kept);
}

function lettersOf(text: string): string[] {
  // Younger than the browsers that run the page.
  if (typeof Intl.Segmenter !== 'function') return [...text];
  return [...new Intl.Segmenter().segment(text)].map(({ segment }) => segment);
}

function bytesOf(text: string): number {
  return new TextEncoder().encode(text).length;
}
