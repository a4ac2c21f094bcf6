/**
 * The model of the block Painter. A worker loads it before the first job whose style has the block, and the browser
 * stores it for offline use.
 */

import { fetchKept, isPage } from './kept.ts';
import { onceMore } from './once-more.ts';
import { failure } from './protocol.ts';

const MODEL = new URL('../models/painters.onnx', import.meta.url);

/** The block, or the id of a built-in style with the block. */
const MENTIONED = /(^|")painter(-|"|$)/;

/** @param args of an operation: styles and documents as JSON or as plain data; binary data is ignored */
export function mentionsPainter(args: unknown): boolean {
  if (typeof args === 'string') return MENTIONED.test(args);
  if (Array.isArray(args)) return args.some(mentionsPainter);
  const plain = typeof args === 'object' && args !== null && Object.getPrototypeOf(args) === Object.prototype;
  return plain && Object.values(args).some(mentionsPainter);
}

/** The file of the model. Rejects with `painters-missing`, and is loaded again at the next call. */
export const { get: paintersFile } = onceMore(async () => {
  const response = await fetchKept(String(MODEL)).catch(() => null);
  if (!response?.ok || isPage(response)) {
    throw failure('painters-missing', 'The painters could not be loaded. Try again with a connection.');
  }
  return new Uint8Array(await response.arrayBuffer());
});

/** Gives the model to a module that draws, once per module. */
export function paintersLoader(give: (onnx: Uint8Array) => void) {
  return onceMore(async () => give(await paintersFile())).get;
}
