/** Every kind of project opens with its saved content, from each kind of file that can contain it. */

import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { archiveOf } from '../../engine/archive.ts';
import { photosOn } from '../../engine/sheets.ts';
import { save as saveFile } from '../../ui/files.ts';
import { allDie, fakeBrowser } from '../testing.ts';
import { bare, downloaded, dropped } from './testing-pages.ts';
import type { Tab } from './testing-pages.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));
beforeEach(() => void vi.mocked(saveFile).mockClear());
afterEach(allDie);

const ANIMATION = new URL('../../../tests/oracles/data/animations/kept.gif', import.meta.url);
const video = (name = 'film.mp4') => new File([`bytes of ${name}`], name, { type: 'video/mp4' });
const animation = () => new File([readFileSync(ANIMATION)], 'kept.gif', { type: 'image/gif' });

/** An engine that extracts as many frames from a video as it has ids for, one every second. */
function prepare({ engine }: any) {
  engine.importVideo = async (file: File, { ids, start = 0, onAbout, onPhoto }: any) => {
    onAbout({ duration: 24, frames: ids.length });
    for (const [at, id] of ids.entries()) {
      const time = start + at;
      onPhoto(id, await engine.importPhoto(id, new File([`${file.name} at ${time}`], `${id}.png`)), time, at + 1);
    }
  };
}

const newTab = (browser = fakeBrowser()): Promise<Tab> => browser.tab({ prepare });

async function reading(tab: Tab, ...files: File[]) {
  await tab.reading.addFiles(files);
  await tab.keeping.flush();
}

/** The visible project: with names of photos and videos instead of ids. */
async function look({ store, photos }: Tab) {
  const album = store.album.value;
  const name = (id: string | null | undefined) => album.get(id ?? '')?.name ?? null;
  const { tray, waiting = [], board, name: title, mine, favourites, ownLayouts, ...rest } = store.project.value;
  const inTray = new Set(tray.map(({ id }) => id));
  // The undo history, which a file does not have, may need others.
  const videos = [...store.videos.value.values()].filter(({ ids }) => ids.some((id) => inTray.has(id)));
  const onPages = photosOn(store.sheets.value);
  const page = ({ order, panels, words, ...page }: any) => ({
    ...page,
    order: order.map(name),
    panels: panels.map((panel: any) => ({ ...panel, photo: name(panel.photo) })),
    words: words.map((word: any) => ({ ...word, photo: name(word.photo) })),
  });
  return {
    title,
    tray: tray.map(({ id, ...item }) => ({ ...item, photo: name(id) })),
    photos: await Promise.all(
      tray.map(async ({ id }) => {
        const { video, time, shot, looked, meta } = album.get(id) as any;
        const file = await photos.get(id).file.text();
        const film = store.videos.value.get(video)?.name;
        return { file, film, time, shot, looked: !!looked, mask: meta.mask, shown: onPages.has(id) };
      }),
    ),
    videos: await Promise.all(
      videos.map(async ({ key: _key, file, ids, ...video }) => {
        const frames = ids.filter((id) => inTray.has(id)).map(name);
        return { ...video, type: file.type, bytes: await file.text(), frames };
      }),
    ),
    pages: store.sheets.value.map(page),
    waiting: waiting.map((word) => ({ ...word, photo: name(word.photo as string) })),
    board: board && { ...board, order: board.order?.map(name) },
    lists: { mine, favourites, ownLayouts },
    settings: [rest.alike, rest.order, rest.panels, rest.locks, rest.styling, rest.settings, rest.at, rest.draft],
  };
}

async function savedFile(tab: Tab): Promise<File> {
  vi.mocked(saveFile).mockClear();
  await tab.keeping.files.save();
  const [blob, name] = vi.mocked(saveFile).mock.calls[0];
  return new File([blob], name);
}

const problems = (tab: Tab) => tab.messages.list.value.filter(({ kind }) => kind !== 'note').map(({ text }) => text);

const STYLE = { id: 'my-1', name: 'Mine', tags: [], background: [{ block: 'posterize', levels: 5 }] };
const LAYOUT = {
  id: 'mine-1',
  name: 'Mine',
  family: 'custom',
  aspect: 0.7,
  tree: { rows: ['panel', 'panel'] },
  weights: [1, 1],
};

/** Makes a project of each kind in a new tab. */
const KINDS: Record<string, (tab: Tab) => Promise<void>> = {
  photos: (tab) => tab.add('a.jpg', 'b.jpg', 'c.jpg'),
  'a video': (tab) => reading(tab, video()),
  'a video and photos': (tab) => reading(tab, ...tab.files('a.jpg', 'b.jpg'), video()),
  'two videos of one name': (tab) => reading(tab, video(), video()),
  'an animated GIF': (tab) => reading(tab, animation()),
  'a video that was sampled again': async (tab) => {
    await reading(tab, video());
    const [{ key }] = tab.store.videos.value.values();
    await tab.reading.resample(key, { start: 4, end: 9, frames: 5 });
    await tab.keeping.flush();
  },
  'a video that was sampled again, undone': async (tab) => {
    await KINDS['a video that was sampled again'](tab);
    tab.pages.undo();
  },
  'a video without its first frame': async (tab) => {
    await reading(tab, video());
    tab.reading.remove(tab.store.tray.value[0].id);
  },
  'a video whose first frame is another photo now': async (tab) => {
    await reading(tab, ...tab.files('a.jpg'), video());
    const frame = tab.store.facts.value.find((fact) => fact.video) as any;
    const photo = tab.store.facts.value.find((fact) => !fact.video) as any;
    tab.store.change({ type: 'exchange-photo', id: frame.id, by: photo.id });
  },
  'several pages': async (tab) => {
    await tab.add('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg');
    const { page } = tab.store.project.value as any;
    const ids = tab.store.tray.value.map(({ id }) => id);
    const panels = (own: string[]) => own.map((photo) => ({ photo, crop: null, locked: false, edited: false }));
    const of = (own: string[], seed: number) => ({
      ...page,
      seed,
      layout: 'grid-2',
      order: own,
      merges: [],
      panels: panels(own),
    });
    const sheets = [
      { page: of(ids.slice(0, 2), 1), pageId: 7, sheet: 3 },
      { page: of(ids.slice(2), 2), pageId: 9, sheet: 5 },
    ];
    tab.store.change({ type: 'set-sheets', sheets, at: 1 });
  },
  'a storyboard of a video': async (tab) => {
    await reading(tab, video());
    const [a, b] = tab.store.tray.value.map(({ id }) => id);
    const { board } = tab.store.project.value;
    tab.store.change({
      type: 'set-board',
      board: { ...board, columns: ['Lens'], order: [b, a], author: 'Ann' },
    } as any);
    const shot = { scene: '1', number: '4A', action: 'She turns.', dialogue: 'Oh!', frames: 36, more: { Lens: '35' } };
    tab.store.change({ type: 'describe-shots', shots: { [a]: shot } } as any);
  },
  masks: async (tab) => {
    await tab.add('a.jpg', 'b.jpg');
    tab.store.change({ type: 'mask-photo', id: tab.store.tray.value[0].id, mask: '2x2:ap2a' } as any);
  },
  'custom styles and layouts': async (tab) => {
    await tab.add('a.jpg', 'b.jpg');
    tab.store.change({ type: 'own-styles', mine: [STYLE] });
    tab.store.change({ type: 'own-layouts', ownLayouts: [LAYOUT] } as any);
    const page = tab.store.page.value as any;
    tab.store.change({ type: 'change-page', page: { ...page, style: STYLE } });
  },
  'text on the page and unplaced': async (tab) => {
    await reading(tab, video());
    const page = tab.store.page.value as any;
    const shown = page.panels.map(({ photo }: any) => photo);
    const hidden = tab.store.tray.value.find(({ id }) => !shown.includes(id)) as any;
    const word = (photo: string, text: string) => ({ kind: 'balloon', text, photo, panel: 0, cue: `film ${text}` });
    tab.store.change({ type: 'add-words', words: [word(shown[0], 'Hi'), word(hidden.id, 'Later')] } as any);
    expect([tab.store.page.value?.words.length, tab.store.project.value.waiting?.length]).toEqual([1, 1]);
  },
};

describe.each(Object.entries(KINDS))('a project with %s', (_, make) => {
  let browser: ReturnType<typeof fakeBrowser>;
  let tab: Tab;
  beforeEach(async () => {
    browser = fakeBrowser();
    tab = await newTab(browser);
    await make(tab);
    tab.store.change({ type: 'rename', name: 'Trip' });
    await tab.keeping.flush();
  });

  it('opens from its file as it was, and again from the file of the opened project', async () => {
    const before = await look(tab);
    let file = await savedFile(tab);
    for (let time = 0; time < 2; time += 1) {
      const other = await newTab();
      expect([await other.keeping.files.open(file), problems(other)]).toEqual([true, []]);
      expect(await look(other)).toEqual(before);
      file = await savedFile(other);
    }
  });

  it('is there after the tab was closed', async () => {
    const before = await look(tab);
    expect(tab.keeping.status.value).toBe('saved');
    expect(await look(await newTab(browser.died()))).toEqual(before);
  });

  it.each(['png', 'cbz'])('opens from a %s of its pages as they were', async (kind) => {
    const before = await look(tab);
    const page = async () => {
      if (kind === 'png') return downloaded(tab, 'photos');
      const packed = await tab.keeping.pageFiles.packed('photos');
      const entries = [{ name: '1.png', blob: await bare() }, ...(packed ? [packed.entry] : [])];
      return new File([await archiveOf(entries)], 'Trip.cbz');
    };
    const other = await newTab();
    const file = await page();
    if (kind === 'png') expect((await dropped(other, file)).opened).toBe(true);
    else expect(await other.keeping.pageFiles.openChosen(file, other.keeping.files.open)).toBe(true);
    const after = await look(other);
    expect(problems(other)).toEqual([]);
    // Names of files are not in it.
    const plain = (pages: any[]) =>
      pages.map(({ panels, order: _order, words, ...page }) => ({
        ...page,
        panels: panels.map(({ crop }: any) => crop),
        words: words.map(({ text, kind }: any) => [text, kind]),
      }));
    expect(plain(after.pages)).toEqual(plain(before.pages));
    const files = ({ photos }: typeof before) => photos.flatMap(({ file, shown }) => (shown ? file : [])).sort();
    expect(files(after)).toEqual(files(before));
  });
});
