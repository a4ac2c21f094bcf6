/** Reliable blobs, and early release of buffers. */

import { pause } from './scheduler.ts';

/** Milliseconds between tries, each twice as long as the one before. */
const WAIT = 100;
/** Three seconds in all. */
const TRIES = 6;

/**
 * A blob whose bytes have arrived in the browser's store. Blobs are stored some time after their creation. With
 * hundreds of megabytes, Chromium rejects new blobs while it frees space, and reports this only when the blob is read.
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
      await pause(wait * 2 ** (tries - 1));
    }
  }
}

/** Target of unneeded buffers. A message to a port is freed if its other end is closed. */
let drain: MessagePort | undefined;

/**
 * Frees the memory of a buffer immediately. The garbage collector ignores the memory behind small objects, and runs
 * late. Frames of a long video took hundreds of megabytes more in the meantime. `ArrayBuffer.transfer` does not work:
 * for buffers from messages or blobs, Chromium appears to keep the memory without counting it.
 */
export function detach({ buffer }: { buffer: ArrayBuffer }) {
  // The buffer was already transferred to a worker.
  if (buffer.byteLength === 0) return;
  if (!drain) {
    const { port1, port2 } = new MessageChannel();
    port2.close();
    drain = port1;
  }
  drain.postMessage(null, [buffer]);
}
