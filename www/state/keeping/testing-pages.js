// @ts-check
/** Pages that carry their project, for the tests of keeping. */

import { chunkOf, chunksOf, pngOf, textHead, textOf } from '../../engine/png-chunks.js';
import { fakeBrowser } from './testing.js';

/** @typedef {Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>} Tab */

/** Of every panel. */
export const CROP = { x: 0.1, y: 0.2, width: 0.5, height: 0.25 };

/** A PNG without pixels: nobody looks at them here. */
export const bare = async () => pngOf([await chunkOf('IHDR', new Uint8Array(13)), await chunkOf('IDAT', new Uint8Array(9)), await chunkOf('IEND', new Uint8Array(0))]);

/** A browser with a page of three photos, cropped by hand. @returns {Promise<Tab>} */
export async function tripTab() {
  const tab = await fakeBrowser().tab();
  await tab.add('a.jpg', 'b.jpg', 'c.jpg');
  const page = /** @type {any} */ (tab.store.page.value);
  const panels = page.panels.map((/** @type {any} */ panel) => ({ ...panel, crop: CROP, edited: true }));
  tab.store.change({ type: 'change-page', page: { ...page, panels, words: [{ kind: 'caption', text: 'Meanwhile' }] } });
  tab.store.change({ type: 'rename', name: 'Trip' });
  await tab.keeping.flush();
  return tab;
}

/** @param {Tab} tab @param {import('./page-files.js').Cargo} what @returns {Promise<File>} */
export async function downloaded(tab, what) {
  const page = /** @type {any} */ (tab.store.page.value);
  const { png } = await tab.keeping.pageFiles.carrying(await bare(), page, what);
  return new File([png], 'page.png', { type: 'image/png' });
}

/** What the page does with files. @param {Tab} tab @param {File[]} files */
export async function dropped(tab, ...files) {
  const page = await tab.keeping.pageFiles.among(files);
  const opened = page !== null && await tab.keeping.pageFiles.open(page);
  const rest = await tab.keeping.absentPhotos.fill(files.filter((file) => file !== page?.file));
  await tab.keeping.flush();
  return { opened, rest };
}

/** @param {Blob} file @returns {Promise<string>} what it tells of its project */
export async function textIn(file) {
  const chunk = (await chunksOf(file))?.find(({ type }) => type === 'iTXt');
  const head = chunk && await textHead(file.slice(chunk.at, chunk.at + chunk.length));
  return head ? /** @type {string} */ (await textOf(head, 1 << 22)) : '';
}

/** The names of the photos in the panels. @param {Tab} tab */
export const inPanels = (tab) => tab.store.page.value?.panels.map(({ photo }) => tab.store.album.value.get(photo ?? '')?.name);
/** @param {Tab} tab */
export const alerts = (tab) => tab.messages.list.value.filter(({ kind }) => kind === 'alert' || kind === 'grave');
/** @param {Blob} blob */
export const bytesOf = async (blob) => new Uint8Array(await blob.arrayBuffer());
