import { beforeEach, expect, test, vi } from 'vitest';
import { createDownload } from './download.ts';
import * as files from '../ui/files.ts';
import { readArchive } from '../storage/files/archive.ts';
import { createMessages } from '../ui/messages.ts';
import { createStore } from '../document/store.ts';

const page = (seed: number) =>
  ({ layout: 'grid-6', style: 'noir', seed, panels: [], page: { width: 2480, height: 3508, dpi: 300 } }) as any;

let saved: { name: string; blob: Blob }[];

beforeEach(() => {
  saved = [];
  vi.spyOn(files, 'save').mockImplementation((blob, name) => void saved.push({ blob, name }));
});

function app(engine: Record<string, any> = {}) {
  const messages = createMessages();
  const made = async (document: any, { onProgress }: any) => {
    onProgress(0, 4);
    onProgress(4, 4);
    return new Blob([`page ${document.seed}`]);
  };
  const store = createStore();
  const download = createDownload({
    store,
    messages,
    pages: {} as any,
    engine: { exportPng: made, exportJpeg: made, ...engine } as any,
    pageFiles: { take: () => 'project', carrying: async (png) => ({ png, unclean: 0 }) },
  });
  return { download, messages, store };
}

test('pages stand in an archive in their order, each made after the one before', async () => {
  let busy = 0;
  const exportJpeg = async (document: any, { quality }: any) => {
    busy += 1;
    await Promise.resolve();
    expect(busy).toBe(1);
    busy -= 1;
    return new Blob([`${document.seed} at ${quality}`]);
  };
  const { download, messages } = app({ exportJpeg });
  await download.saveAs({ pages: [page(1), page(2), page(3)], format: 'cbz', inside: 'jpeg', quality: 70 });
  expect(saved.map(({ name }) => name)).toEqual(['inkpanel-3-pages.cbz']);
  const entries = [...(await readArchive(saved[0].blob)).values()];
  expect(entries.map(({ name }) => name)).toEqual(['page-01.jpg', 'page-02.jpg', 'page-03.jpg']);
  expect(await Promise.all(entries.map(async ({ read }) => (await read()).text()))).toEqual([
    '1 at 70',
    '2 at 70',
    '3 at 70',
  ]);
  expect(messages.list.value.map(({ text }) => text)).toEqual(['3 pages were saved in one file.']);
});

test('progress goes from page to page', async () => {
  const { download } = app();
  const seen: number[] = [];
  const stop = download.progress.subscribe((value) => {
    if (value) seen.push(value.done / value.total);
  });
  await download.saveAs({ pages: [page(1), page(2)], format: 'zip' });
  stop();
  expect(seen).toEqual([0, 0.5, 0.5, 1]);
  expect(download.progress.value).toBe(null);
});

test('all pages of the storyboard are offered, with fewer pixels where asked for', () => {
  const { download, store } = app();
  Object.assign(store, { sheets: { value: [page(1), page(2)] } });
  expect(download.sheets().map(({ seed }) => seed)).toEqual([1, 2]);
  expect(download.scaledSheets(0.5).map((sheet) => sheet.page)).toEqual(
    [1, 2].map(() => ({ width: 1240, height: 1754, dpi: 150 })),
  );
});

test('what goes wrong is said with the photo at fault, and what is cancelled is not', async () => {
  const fail = (about: object) => async () => {
    throw Object.assign(new Error('it is broken'), about);
  };
  const { download, messages } = app({ exportPdf: fail({ photo: 'cat.jpg' }), exportPng: fail({ code: 'cancelled' }) });
  await download.start(page(1));
  expect(messages.list.value).toEqual([]);
  await download.saveAs({ pages: [page(1)], format: 'pdf' });
  expect(messages.list.value.map(({ text }) => text)).toEqual(['The file could not be made: cat.jpg: it is broken']);
  expect(saved).toEqual([]);
});
