/** Streaming DEFLATE decompression. The stated length of a file is not trusted. */

import { failure } from './protocol.ts';

/** Small pieces are combined to blobs of this many bytes, which the browser can store on disk. */
const PART = 4 * 2 ** 20;

/**
 * Bytes that are decompressed at once. Browsers unpack all that they were given before anyone can count it, and a byte
 * may be a thousand.
 */
const STEP = 8 * 2 ** 10;

/** Something that waits for a file: `beat` is called with every piece. */
export type Watch = { signal?: AbortSignal; beat?: () => void };

/**
 * @param how `take` receives the size of each piece and returns whether it is within the limit
 * @returns rejects with `damaged`, with `too-large` if a limit is exceeded, and if `signal` is aborted
 */
export async function inflated(
  packed: Blob,
  format: 'deflate' | 'deflate-raw',
  { take, signal, beat = () => {} }: { take: (bytes: number) => boolean } & Watch,
): Promise<Blob> {
  const reader = inSteps(packed).pipeThrough(new DecompressionStream(format)).getReader();
  const blobs: Blob[] = [];
  let parts: BlobPart[] = [];
  let length = 0;
  try {
    for (;;) {
      signal?.throwIfAborted();
      const { value, done } = await reader.read().catch((cause) => {
        throw Object.assign(failure('damaged', 'It cannot be unpacked.'), { cause });
      });
      if (done) return new Blob([...blobs, ...parts]);
      beat();
      if (!take(value.length)) throw failure('too-large', 'The uncompressed size exceeds the limit.');
      parts.push(value);
      length += value.length;
      if (length < PART) continue;
      blobs.push(new Blob(parts));
      [parts, length] = [[], 0];
    }
  } catch (error) {
    void reader.cancel().catch(() => {});
    throw error;
  }
}

/** @returns a counter with a limit of `most` bytes */
export function roomFor(most: number): (bytes: number) => boolean {
  let left = most;
  return (bytes) => (left -= bytes) >= 0;
}

function inSteps(blob: Blob): ReadableStream<Uint8Array<ArrayBuffer>> {
  const reader = blob.stream().getReader();
  let left = new Uint8Array(0);
  return new ReadableStream(
    {
      async pull(controller) {
        if (left.length === 0) {
          const { value, done } = await reader.read();
          if (done) {
            controller.close();
            return;
          }
          left = value;
        }
        controller.enqueue(left.subarray(0, STEP));
        left = left.subarray(STEP);
      },
      cancel: (reason) => reader.cancel(reason),
    },
    { highWaterMark: 0 },
  );
}
