// @ts-check
/** The sample album, fetched from beside the page. */

import { strings } from '../strings.js';

/** @typedef {{ file: string, title: string, author: string, licence: string }} Sample */

/** @returns {Promise<{ files: File[], credits: Map<string, string> }>} the photos, and their authors by file name */
export async function fetchSamples() {
  const base = new URL('./samples/', document.baseURI);
  /** @type {Sample[]} */
  const index = await (await fetchOk(new URL('index.json', base))).json();
  const files = index.map(async ({ file }) => new File([await (await fetchOk(new URL(file, base))).blob()], file));
  return { files: await Promise.all(files), credits: new Map(index.map((sample) => [sample.file, strings.credit(sample)])) };
}

/** @param {URL} address */
async function fetchOk(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname}: ${response.status}`);
  return response;
}
