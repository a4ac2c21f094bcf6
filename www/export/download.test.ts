import { beforeEach, expect, test, vi } from 'vitest';
import { createDownload } from './download.ts';
import * as files from '../ui/files.ts';
import { readArchive } from '../engine/archive.ts';
import { createMessages } from '../ui/messages.ts';
import { createStore } from '../document/store.ts';

const page = (seed: number) =>
  ({ layout: 'grid-6', style: 'noir', seed, panels: [], page: { width: 2480, height: 3508, dpi: 300 } }) as any;

let saved: { name: string; blob: Blob }[];

beforeEach(() => {
  saved = [];
  vi.spyOn(files, 'save').mockImplementation((blob, name) => void saved.push({ blob, name }));
});

function app(engine: Record<string, any> = {}, animatics: Record<string, any> = {}) {
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
    shotList: () => ({}) as any,
    animatics: animatics as any,
    pageFiles: {
      take: () => 'project',
      carrying: async (png) => ({ png, unclean: 0 }),
      packed: async () => null,
    },
  });
  return { download, messages, store };
}

test('pages are in an archive in their order, and at most two are drawn at the same time', async () => {
  let [busy, most] = [0, 0];
  const exportJpeg = async (document: any, { quality }: any) => {
    busy += 1;
    most = Math.max(most, busy);
    await Promise.resolve();
    busy -= 1;
    return new Blob([`${document.seed} at ${quality}`]);
  };
  const comicFiles = async (kind: string, { title, pages }: any) => [
    { name: 'page-01.jpg', content: 0 },
    { name: 'ComicInfo.xml', content: `${kind} ${title} ${pages.length}` },
  ];
  const { download, messages } = app({ exportJpeg, comicFiles });
  await download.saveAs({ pages: [page(1), page(2), page(3)], format: 'cbz', inside: 'jpeg', quality: 70 });
  expect(most).toBe(2);
  expect(saved.map(({ name }) => name)).toEqual(['Untitled.cbz']);
  const entries = [...(await readArchive(saved[0].blob)).values()];
  expect(entries.map(({ name }) => name)).toEqual(['page-01.jpg', 'page-02.jpg', 'page-03.jpg', 'ComicInfo.xml']);
  expect(await Promise.all(entries.map(async ({ read }) => (await read()).text()))).toEqual([
    '1 at 70',
    '2 at 70',
    '3 at 70',
    'cbz Inkpanel 3',
  ]);
  expect(messages.list.value.map(({ text }) => text)).toEqual(['Untitled.cbz was saved with 3 pages.']);
});

test('a strip is an archive of the pages that the core makes of the pages and the facts of their photos', async () => {
  const asked: any[] = [];
  const stripPages = async (request: any) => {
    asked.push(request);
    return [page(7), page(8), page(9)];
  };
  const { download, store } = app({ stripPages });
  store.know({ id: 'a', name: 'a.jpg', meta: { taken: '2026:06:09 10:00:00', subjects: [] } as any, measures: null });
  store.know({ id: 'b', name: 'b.jpg', meta: null, measures: null });
  await download.saveAs({ pages: [page(1), page(2)], format: 'zip', inside: 'jpeg', strip: true });
  expect(asked[0].pages.map(({ seed }: any) => seed)).toEqual([1, 2]);
  expect(asked[0].photos).toEqual({ a: { taken: '2026:06:09 10:00:00', subjects: [] } });
  const entries = [...(await readArchive(saved[0].blob)).values()];
  expect(await Promise.all(entries.map(async ({ read }) => (await read()).text()))).toEqual([
    'page 7',
    'page 8',
    'page 9',
  ]);
});

class Reader extends EventTarget {
  result = '';
  async readAsDataURL(blob: Blob) {
    this.result = `data:${blob.type},${await blob.text()}`;
    this.dispatchEvent(new Event('load'));
  }
}

test('an HTML comic has the pictures that move behind those of its pages, and tells how far both are', async () => {
  vi.stubGlobal('FileReader', Reader);
  const exportWebp = async (document: any, { onProgress }: any) => {
    onProgress(2, 2);
    return new Blob([`still ${document.seed}`], { type: 'image/webp' });
  };
  const place = { x: 0, y: 0, width: 1, height: 0.5 };
  const movingPictures = async (document: any) =>
    document.seed === 2 ? [{ place, file: new Blob(['moves'], { type: 'image/webp' }) }] : [];
  const comicPieces = async ({ pages }: any) => [0, ' ', 1, ...(pages[1].moving.length > 0 ? [' ', 2] : [])];
  const { download } = app({ exportWebp, givesWebp: async () => true, comicPieces }, { movingPictures });
  const seen: number[] = [];
  const stop = download.progress.subscribe((value) => {
    if (value) seen.push(value.done / value.total);
  });
  await download.saveAs({ pages: [page(1), page(2)], format: 'html', living: true });
  await download.saveAs({ pages: [page(1), page(2)], format: 'html' });
  stop();
  vi.unstubAllGlobals();
  expect(seen.slice(0, 4)).toEqual([0.25, 0.5, 0.75, 1]);
  const stills = 'data:image/webp,still 1 data:image/webp,still 2';
  expect(await Promise.all(saved.map(({ blob }) => blob.text()))).toEqual([`${stills} data:image/webp,moves`, stills]);
});

test('an HTML comic has its pictures where the core says, with progress of all pages', async () => {
  const made: any[] = [];
  const draw =
    (kind: string) =>
    async (document: any, { quality, onProgress }: any) => {
      onProgress(1, 2);
      made.push([kind, document.seed, quality]);
      return new Blob([`${document.seed}`], { type: 'image/webp' });
    };
  vi.stubGlobal('FileReader', Reader);
  const comicPieces = async ({ picture }: any) => ['<img src="', 0, '"><img src="', 1, `"> ${picture}`];
  const { download } = app({ exportWebp: draw('webp'), givesWebp: async () => true, comicPieces });
  const seen: number[] = [];
  const stop = download.progress.subscribe((value) => {
    if (value) seen.push(value.done / value.total);
  });
  await download.saveAs({ pages: [page(1), page(2)], format: 'html', quality: 80 });
  stop();
  vi.unstubAllGlobals();
  expect(made).toEqual([
    ['webp', 1, 80],
    ['webp', 2, 80],
  ]);
  expect(seen).toEqual([0.25, 0.5]);
  expect(saved[0].name).toMatch(/\.html$/);
  expect(await saved[0].blob.text()).toBe('<img src="data:image/webp,1"><img src="data:image/webp,2"> webp');
});

test('a message names the saved file', async () => {
  const { download, messages, store } = app({ exportPanel: async () => new Blob(['panel']) });
  store.page.peek = () => page(1);
  const said = () => messages.list.value.map(({ text }) => text);
  await download.start();
  expect(said()).toEqual(['Untitled.png was saved.']);
  await download.savePanel(1);
  expect(said()).toEqual(['Untitled - panel 2.png was saved.']);
  expect(saved.map(({ name }) => name)).toEqual(['Untitled.png', 'Untitled - panel 2.png']);
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
  expect(messages.list.value.map(({ text }) => text)).toEqual(['The file could not be created: cat.jpg: it is broken']);
  expect(saved).toEqual([]);
});
