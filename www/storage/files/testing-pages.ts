/** Pages that carry their project, for the tests of keeping. */

import { chunkOf, chunksOf, pngOf, textHead, textOf } from '../../engine/png-chunks.ts';
import { orderByName } from '../../document/testing.ts';
import { fakeBrowser } from '../testing.ts';
import type { Cargo } from './page-files.ts';

export type Tab = Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;

/** The crop of every panel. */
export const CROP = { x: 0.1, y: 0.2, width: 0.5, height: 0.25 };

/** A PNG without pixels, which are not needed here. */
export const bare = async () =>
  pngOf([
    await chunkOf('IHDR', new Uint8Array(13)),
    await chunkOf('IDAT', new Uint8Array(9)),
    await chunkOf('IEND', new Uint8Array(0)),
  ]);

/** A browser with a page of three photos in the order of their names, with manual crops. */
export async function tripTab(): Promise<Tab> {
  const tab = await fakeBrowser().tab();
  orderByName(tab);
  await tab.add('a.jpg', 'b.jpg', 'c.jpg');
  tab.store.change({ type: 'choose-by', order: 'time', silent: true });
  const page = tab.store.page.value as any;
  const panels = page.panels.map((panel: any) => ({ ...panel, crop: CROP, edited: true }));
  tab.store.change({ type: 'change-page', page: { ...page, panels, words: [{ kind: 'caption', text: 'Meanwhile' }] } });
  tab.store.change({ type: 'rename', name: 'Trip' });
  await tab.keeping.flush();
  return tab;
}

export async function downloaded(tab: Tab, what: Cargo): Promise<File> {
  const page = tab.store.page.value as any;
  const { png } = await tab.keeping.pageFiles.carrying(await bare(), page, what);
  return new File([png], 'page.png', { type: 'image/png' });
}

/** Drops files on the app. */
export async function dropped(tab: Tab, ...files: File[]) {
  const page = await tab.keeping.pageFiles.among(files);
  const opened = page !== null && (await tab.keeping.pageFiles.open(page));
  const rest = await tab.keeping.absentPhotos.fill(files.filter((file) => file !== page?.file));
  await tab.keeping.flush();
  return { opened, rest };
}

/** @returns its project data */
export async function textIn(file: Blob): Promise<string> {
  const chunk = (await chunksOf(file))?.find(({ type }) => type === 'iTXt');
  const head = chunk && (await textHead(file.slice(chunk.at, chunk.at + chunk.length)));
  return head ? ((await textOf(head, 1 << 22)) as string) : '';
}

/** The names of the photos in the panels. */
export const inPanels = (tab: Tab) =>
  tab.store.page.value?.panels.map(({ photo }) => tab.store.album.value.get(photo ?? '')?.name);
export const alerts = (tab: Tab) => tab.messages.list.value.filter(({ kind }) => kind === 'alert' || kind === 'grave');
export const bytesOf = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer());
