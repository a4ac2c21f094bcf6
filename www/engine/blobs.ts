/** Blobs that can be read for as long as they are there, and bytes that go when nobody needs them any more. */

/** Milliseconds between tries, each twice as long as the one before. */
const WAIT = 100;
/** Three seconds in all. */
const TRIES = 6;

/**
 * A blob whose bytes have arrived in the browser's store. They go there some time after it was made; with hundreds of
 * megabytes there Chromium refuses them for moments, while it makes room, and tells nobody before the blob is read.
 * @param bytes are detached once the blob has them
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
      detach(bytes);
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

/** Where bytes go that nobody needs: what is handed to a port whose other end is closed is let go of. */
let drain: MessagePort | undefined;

/**
 * Gives the memory of bytes back at once. The collector does not see that megabytes hang on each small object, and comes by late:
 * the frames of a long film took hundreds of megabytes more in the meantime. `ArrayBuffer.transfer` is no way: what came as a
 * message or out of a blob Chromium seems to hold behind the empty object, and then does not even count it.
 */
export function detach({ buffer }: { buffer: ArrayBuffer }) {
  // What was handed to a worker is gone already.
  if (buffer.byteLength === 0) return;
  if (!drain) {
    const { port1, port2 } = new MessageChannel();
    port2.close();
    drain = port1;
  }
  drain.postMessage(null, [buffer]);
}
