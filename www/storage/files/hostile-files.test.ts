import { crc32 } from 'node:zlib';
import { beforeEach, afterEach, describe, expect, it, vi } from 'vitest';
import { chunkOf, textChunk, withChunks } from '../../engine/png-chunks.ts';
import { ARCHIVE, PHOTOS_AT_ONCE, SILENCE, TEXT } from '../../engine/limits.ts';
import { archiveOf, readArchive } from '../../engine/archive.ts';
import { photosOn } from '../../engine/sheets.ts';
import { documentOf } from '../testing.ts';
import { packedNothing, zipOf } from '../../engine/testing-archives.ts';
import { alerts, bare, downloaded, dropped, textIn, tripTab } from './testing-pages.ts';
import { save as saveFile } from '../../ui/files.ts';
import type { Made } from '../../engine/testing-archives.ts';
import type { Tab } from './testing-pages.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));

let tab: Tab;
/** The saved project, as JSON. */
let json: any;
/** The state before a file is opened. */
let before: string;

beforeEach(async () => {
  vi.mocked(saveFile).mockClear();
  tab = await tripTab();
  await tab.keeping.files.save();
  const found = await readArchive(vi.mocked(saveFile).mock.calls[0][0] as any);
  json = JSON.parse(await (await found.get('project.json')!.read()).text());
  before = state();
});

afterEach(() => {
  vi.useRealTimers();
});

const state = () => JSON.stringify([documentOf(tab), [...tab.store.album.value.keys()], tab.keeping.current.value]);
const said = () => alerts(tab).map(({ text }) => text);

const fileOf = (bytes: Buffer<ArrayBuffer>) => new File([bytes], 'x.inkpanel');
const MB = 2 ** 20;

/**
 * A project with a number of photos.
 * @param how `bytes`: content of each file
 */
function projectOf(
  count: number,
  {
    bytes = { content: Buffer.from('photo') },
    change = (photo) => photo,
    also = {},
  }: { bytes?: Partial<Made>; change?: (photo: any, i: number) => any; also?: any } = {},
) {
  const [photo] = json.photos;
  const photos = Array.from({ length: count }, (_, i) =>
    change({ ...photo, id: `n${i}`, name: `n${i}.jpg`, path: `photos/${i}.jpg` }, i),
  );
  const present = { ...json.history.present, page: null, pageId: 0, tray: photos.map(({ id }) => ({ id, use: true })) };
  const text = JSON.stringify({ ...json, photos, history: { present, shown: [] }, ...also });
  const paths = [...new Set(photos.map(({ path }) => path))].filter((path) => !path.startsWith('gone/'));
  return fileOf(
    zipOf([
      { name: 'project.json', content: Buffer.from(text), packed: true },
      ...paths.map((name) => ({ name, ...bytes })),
    ]),
  );
}

/** Counts the photos that are read, and how many at the same time. */
function counted(wait: () => Promise<unknown> = () => Promise.resolve()) {
  const seen = { now: 0, most: 0, all: 0 };
  const { importPhoto } = tab.engine;
  tab.engine.importPhoto = async (...args: any[]) => {
    seen.now += 1;
    seen.all += 1;
    seen.most = Math.max(seen.most, seen.now);
    try {
      await wait();
      return await importPhoto(...args);
    } finally {
      seen.now -= 1;
    }
  };
  return seen;
}

// Unpacking takes longer on a busy machine.
describe('a project file that is a trap', { timeout: 60_000 }, () => {
  const nothing = packedNothing(64);
  const bomb = { content: nothing, method: 8, length: nothing.length, size: 64 * MB };

  it.each([
    [
      'of five thousand photos in one file',
      () => projectOf(5_000, { change: (photo) => ({ ...photo, path: 'photos/0.jpg' }) }),
      'it is damaged',
    ],
    [
      'of videos in one file',
      () =>
        projectOf(1, {
          also: {
            videos: Array.from({ length: 999 }, (_, i) => ({ key: `v${i}`, name: 'v', path: 'photos/0.jpg', ids: [] })),
          },
        }),
      'it is damaged',
    ],
    [
      'of photos that say what they unpack to',
      () => projectOf(100, { bytes: bomb }),
      'exceeds the limits of a project',
    ],
    [
      'of photos that do not say what they unpack to',
      () => projectOf(100, { bytes: { ...bomb, size: 1000 } }),
      'it is damaged',
    ],
    [
      'of a document that says what it unpacks to',
      () => fileOf(zipOf([{ name: 'project.json', ...bomb }])),
      'exceeds the limits of a project',
    ],
    [
      'of a document that does not say what it unpacks to',
      () => fileOf(zipOf([{ name: 'project.json', ...bomb, size: 99 }])),
      'it is damaged',
    ],
    [
      'of a document that is too long',
      () => fileOf(zipOf([{ name: 'project.json', content: Buffer.alloc(TEXT.project + 1, ' ') }])),
      'exceeds the limits of a project',
    ],
    [
      'of a document of brackets',
      () => fileOf(zipOf([{ name: 'project.json', content: Buffer.alloc(TEXT.project, '['), packed: true }])),
      'exceeds the limits of a project',
    ],
    [
      'of words by the thousands',
      () => {
        json.history.present.page.words = Array(20_000).fill({ kind: 'caption', text: 'x' });
        return projectOf(1, { also: { history: json.history } });
      },
      'exceeds the limits of a project',
    ],
    [
      'with a name of megabytes',
      () => {
        json.history.present.name = 'x'.repeat(20 * MB);
        return projectOf(1);
      },
      'exceeds the limits of a project',
    ],
    [
      'with a name of a photo of megabytes',
      () => projectOf(1, { change: (photo) => ({ ...photo, name: 'x'.repeat(20 * MB) }) }),
      'exceeds the limits of a project',
    ],
  ])('%s changes nothing on the page, and is told', async (_, make, reason) => {
    const seen = counted();
    await tab.keeping.files.open(await make());
    expect(said().at(-1)).toMatch(`x.inkpanel could not be opened: `);
    expect(said().at(-1)).toMatch(reason);
    expect(state()).toBe(before);
    expect([seen.all, tab.keeping.files.progress.value]).toEqual([0, null]);
  });

  it('of nothing, within its bounds, is held one file at a time', async () => {
    const sizes: number[] = [];
    const seen = counted(() => Promise.reject(Object.assign(new Error('no photo'), { code: 'unknown-format' })));
    const { importPhoto } = tab.engine;
    tab.engine.importPhoto = (id: string, file: File) => {
      sizes.push(file.size);
      return importPhoto(id, file);
    };
    await tab.keeping.files.open(projectOf(3, { bytes: { ...bomb, crc: crc32(Buffer.alloc(64 * MB)) } }));
    expect([sizes, seen.most]).toEqual([[64 * MB, 64 * MB, 64 * MB], 1]);
    expect(said().at(-1)).toMatch('x.inkpanel could not be opened: it is damaged');
    expect(state()).toBe(before);
  });
});

describe('photos of a project file', () => {
  it('that are not in it are forgotten, but for the first on its pages', async () => {
    const { page } = json.history.present;
    const pageOf = (first: number) => ({
      ...page,
      panels: page.panels.map((use: object, i: number) => ({ ...use, photo: `n${first + i}` })),
    });
    const whole = {
      ...json.history.present,
      tray: Array.from({ length: 4_000 }, (_, i) => ({ id: `n${i}`, use: true })),
      page: pageOf(0),
      others: Array.from({ length: 99 }, (_, i) => ({ page: pageOf(3 * i + 3), pageId: 100 + i, sheet: 1 + i })),
    };
    const file = projectOf(4_000, {
      change: (photo, i) => ({ ...photo, path: i === 0 ? photo.path : `gone/${i}` }),
      also: { history: { present: whole, shown: [] } },
    });
    await tab.keeping.files.open(file);
    expect([
      tab.store.tray.value.length,
      tab.names()[0],
      said().filter((text) => text.includes('could not be opened')),
    ]).toEqual([101, 'n0.jpg', []]);
    expect(tab.store.facts.value.filter(({ absent }) => absent)).toHaveLength(100);
    expect(photosOn(tab.store.sheets.value).size).toBe(101);
  });

  it.each([
    ['that are stored are read few at a time', {}, PHOTOS_AT_ONCE],
    ['that are packed are read one at a time', { packed: true }, 1],
  ])('%s', async (_, how, most) => {
    const seen = counted(
      () =>
        new Promise((resolve) => {
          setTimeout(resolve, 1);
        }),
    );
    await tab.keeping.files.open(projectOf(30, { bytes: { content: Buffer.from('photo'), ...how } }));
    expect([seen.all, seen.most, tab.names().length, said()]).toEqual([30, most, 30, []]);
  });

  it('are no more begun when one of them was refused for all', async () => {
    const seen = counted(
      () =>
        new Promise((_, reject) => {
          reject(Object.assign(new Error('too much'), { code: 'too-large-project' }));
        }),
    );
    await tab.keeping.files.open(projectOf(30));
    expect(seen.all).toBeLessThanOrEqual(PHOTOS_AT_ONCE);
    expect([said().length, state()]).toEqual([1, before]);
  });
});

describe('a file of which nothing comes', () => {
  const forever = () => new Promise(() => {});
  /** Waits for files, which are read asynchronously. */
  const until = async (isSo: () => boolean) => {
    while (!isSo())
      await new Promise((resolve) => {
        setImmediate(resolve);
      });
  };
  const pass = async (ms: number) => {
    for (let gone = 0; gone < ms; gone += 1_000) await vi.advanceTimersByTimeAsync(1_000);
  };
  beforeEach(() => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  });

  it('is given up after a minute, and another opens', async () => {
    const { importPhoto } = tab.engine;
    const seen = counted(forever);
    const opened = tab.keeping.files.open(projectOf(2));
    await until(() => seen.all === 2);
    await pass(SILENCE - 3_000);
    expect([said(), tab.keeping.files.progress.value !== null]).toEqual([[], true]);
    await pass(6_000);
    await opened;
    expect(said()).toEqual([
      'x.inkpanel could not be opened: reading the file timed out after a minute. Check the drive and try again.',
    ]);
    expect([state(), tab.keeping.files.progress.value]).toEqual([before, null]);
    tab.engine.importPhoto = importPhoto;
    vi.useRealTimers();
    await tab.keeping.files.open(projectOf(2));
    expect(tab.names()).toEqual(['n0.jpg', 'n1.jpg']);
  });

  it('may take its time as long as something comes', async () => {
    const seen = counted(
      () =>
        new Promise((resolve) => {
          setTimeout(resolve, SILENCE * 0.8);
        }),
    );
    const opened = tab.keeping.files.open(projectOf(3 * PHOTOS_AT_ONCE));
    for (let turn = 1; turn <= 3; turn += 1) {
      await until(() => seen.all === turn * PHOTOS_AT_ONCE && seen.now === PHOTOS_AT_ONCE);
      await pass(SILENCE * 0.8);
    }
    vi.useRealTimers();
    await opened;
    expect([tab.names().length, said()]).toEqual([3 * PHOTOS_AT_ONCE, []]);
  });

  it('is stopped by the person without a word', async () => {
    const seen = counted(forever);
    const opened = tab.keeping.files.open(projectOf(2));
    await until(() => seen.all === 2);
    tab.keeping.files.cancel();
    await opened;
    await pass(2 * SILENCE);
    expect([said(), state(), tab.keeping.files.progress.value]).toEqual([[], before, null]);
  });
});

describe('a page that is a trap', { timeout: 60_000 }, () => {
  const nothing = packedNothing(64);
  const bomb = (name: string, how: any = {}) => ({
    name,
    content: nothing,
    method: 8,
    length: nothing.length,
    size: 64 * MB,
    ...how,
  });

  /** The page with these chunks. */
  async function pageOf(text: string, photos?: Buffer<ArrayBuffer>) {
    const after = photos ? [await chunkOf('ipPh', photos)] : [];
    return new File([await withChunks(await bare(), { before: [await textChunk('inkpanel', text)], after })], 'x.png');
  }
  const told = async () => textIn(await downloaded(tab, 'photos'));
  const elsewhere = async () =>
    (await told())
      .replaceAll(/"hash": "\w+"/g, '"hash": ""')
      .replaceAll(/"fingerprint": "\w+"/g, '"fingerprint": "0123456789abcdef"');

  it.each([
    [
      'by the files of its photos',
      async () => pageOf(await elsewhere(), zipOf('abcdefgh'.split('').map((name) => bomb(name)))),
      'exceeds the limits of a project',
    ],
    [
      'by the number of its photos',
      async () =>
        pageOf(await elsewhere(), zipOf(Array.from({ length: ARCHIVE.entries + 1 }, (_, i) => ({ name: `${i}` })))),
      'exceeds the limits of a project',
    ],
    ['by a text of brackets', async () => pageOf('['.repeat(TEXT.page)), 'exceeds the limits of a project'],
    [
      'by a name of megabytes',
      async () => pageOf((await told()).replace('"Trip"', `"${'x'.repeat(3 * MB)}"`)),
      'exceeds the limits of a project',
    ],
    ['by a text that unpacks to more', async () => pageOf(' '.repeat(64 * MB)), 'it is damaged'],
  ])('%s changes nothing, and is told', async (_, make, reason) => {
    const { opened } = await dropped(tab, await make());
    expect([opened, state()]).toEqual([false, before]);
    expect(said()).toEqual([expect.stringMatching(`x.png could not be opened: .*${reason}`)]);
  });

  it('by photos that unpack to more than they say lacks these', async () => {
    const page = JSON.parse(await elsewhere());
    const { opened } = await dropped(
      tab,
      await pageOf(JSON.stringify(page), zipOf(page.photos.map(({ path }: any) => bomb(path, { size: 9 })))),
    );
    expect(opened).toBe(true);
    expect(said().join()).toMatch('x.png is open, but its 3 photos are not on this device');
    await vi.waitFor(() =>
      expect(tab.messages.failures.value.map(({ why }) => why)).toEqual(
        Array(3).fill(expect.stringMatching('damaged')),
      ),
    );
  });
});

it('a project that is written can be read again, however many photos it has', async () => {
  const files = [
    { name: 'project.json', blob: new Blob(['{}']) },
    ...Array.from({ length: 3_000 }, (_, i) => ({ name: `photos/${i}`, blob: new Blob(['x']) })),
  ];
  expect((await readArchive(await archiveOf(files))).size).toBe(3_001);
});
