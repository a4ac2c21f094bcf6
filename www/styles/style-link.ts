/**
 * A style as a link: its JSON, deflated, in base64url, after `#style=`. Links are untrusted, so their size is limited.
 * The core then checks the style like a file.
 */

const MARK = '#style=';
/** Maximum length of a link in characters. */
export const LONGEST_LINK = 16 * 1024;
/** No style in a link is longer, in bytes; a small link may hold a huge text. */
export const LONGEST_STYLE = 512 * 1024;

export function isStyleLink(hash: string): boolean {
  return hash.startsWith(MARK);
}

/** @returns the fragment for the app's address */
export async function linkOf(style: object): Promise<string> {
  const packed = await gathered(
    new Blob([JSON.stringify(style)]).stream().pipeThrough(new CompressionStream('deflate-raw')),
    Infinity,
  );
  const letters = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  return MARK + letters.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** @returns the text of the style, which is not checked yet */
export async function textOfLink(hash: string): Promise<string> {
  const letters = hash.slice(MARK.length);
  if (!isStyleLink(hash) || letters === '') throw broken('it is empty');
  if (letters.length > LONGEST_LINK) throw broken('it is too long');
  if (!/^[\w-]+$/.test(letters)) throw broken('it holds letters that no link has');
  let packed: Uint8Array<ArrayBuffer>;
  try {
    packed = Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
  } catch {
    throw broken('a part of it is missing');
  }
  try {
    const bytes = await gathered(
      new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw')),
      LONGEST_STYLE,
    );
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch (error) {
    throw (error as { code?: string }).code === 'invalid-link'
      ? error
      : broken('a part of it is missing or was changed');
  }
}

/** @param most bytes */
async function gathered(stream: ReadableStream<Uint8Array>, most: number) {
  const reader = stream.getReader();
  const bytes: number[] = [];
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return Uint8Array.from(bytes);
    if (bytes.length + value.length > most) {
      await reader.cancel();
      throw broken('the style in it is too long');
    }
    bytes.push(...value);
  }
}

function broken(why: string) {
  return Object.assign(new Error(`This link holds no style: ${why}.`), { code: 'invalid-link' });
}
