/** The wasm modules that are not there from the start. */

import { fetchAsset } from './assets.ts';
import { isPage } from './kept.ts';
import { failure } from './protocol.ts';

/**
 * @param address of the module
 * @param code code and message of the error if it cannot be loaded
 */
export async function moduleBytes(address: URL, code: string, sentence: string): Promise<ArrayBuffer> {
  const response = await fetchAsset(address).catch(() => null);
  if (!response?.ok || isPage(response)) throw failure(code, sentence);
  return response.arrayBuffer();
}
