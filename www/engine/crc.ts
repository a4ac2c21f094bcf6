/** CRC-32 as ZIP and PNG have it. */

import type { Watch } from './inflate.ts';

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; bit += 1) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

/** read piece by piece, so it may be large */
export async function crcOf(blob: Blob, { signal, beat = () => {} }: Watch = {}): Promise<number> {
  let crc = 0xffffffff;
  const reader = blob.stream().getReader();
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return (crc ^ 0xffffffff) >>> 0;
    if (signal?.aborted) {
      void reader.cancel().catch(() => {});
      throw signal.reason;
    }
    beat();
    for (let i = 0; i < value.length; i += 1) crc = TABLE[(crc ^ value[i]) & 0xff] ^ (crc >>> 8);
  }
}
