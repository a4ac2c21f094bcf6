/** Blobs that can be read for as long as they are there. */

/** Milliseconds between tries, each twice as long as the one before. */
const WAIT = 100;
/** Three seconds in all. */
const TRIES = 6;

/**
 * A blob whose bytes have arrived in the browser's store. They go there some time after it was made; with hundreds of
 * megabytes there Chromium refuses them for moments, while it makes room, and tells nobody before the blob is read.
 * @param options `make`: for tests
 */
export async function blobOf(
  bytes: Uint8Array<ArrayBuffer>,
  {
    type = '',
    wait = WAIT,
    make = (parts, options) => new Blob(parts, options),
  }: { type?: string; wait?: number; make?: (parts: BlobPart[], options: BlobPropertyBag) => Blob } = {},
): Promise<Blob> {
  for (let tries = 1; ; tries += 1) {
    const blob = make([bytes], { type });
    try {
      // A byte is there when all are.
      await blob.slice(0, 1).arrayBuffer();
      return blob;
    } catch (cause) {
      if (tries === TRIES)
        throw Object.assign(new Error('The browser has no room for the photo.', { cause }), { code: 'no-room' });
      await new Promise((resolve) => {
        setTimeout(resolve, wait * 2 ** (tries - 1));
      });
    }
  }
}
