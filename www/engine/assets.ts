/**
 * Files that the engine loads in addition to its modules: wasm, glyphs, models. On a site they are fetched. A program
 * without a browser sets a reader, because `fetch` does not read local files there.
 */

/** Like `fetch`, for an address next to the engine's modules. */
export type AssetReader = (address: string | URL) => Promise<Response>;

let read: AssetReader = (address) => fetch(address);

export function fetchAsset(address: string | URL): Promise<Response> {
  return read(address);
}

/** @param reader replaces `fetch` in this thread */
export function readAssetsWith(reader: AssetReader) {
  read = reader;
}
