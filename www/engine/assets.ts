/**
 * The files that the engine loads beside its modules: wasm, letters, nets. A site serves them; a program without a browser
 * has them on its disk, which `fetch` does not read there, and says so how they are read.
 */

/** As `fetch`, of an address beside the engine's modules. */
export type AssetReader = (address: string | URL) => Promise<Response>;

let read: AssetReader = (address) => fetch(address);

export function fetchAsset(address: string | URL): Promise<Response> {
  return read(address);
}

/** @param reader in the place of `fetch`, in this thread */
export function readAssetsWith(reader: AssetReader) {
  read = reader;
}
