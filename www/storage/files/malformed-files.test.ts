/** A thousand malformed project files and pages, fewer in the tests of a change: each is opened or rejected, and no byte of the open project changes. */

import { afterEach, expect, it, vi } from 'vitest';
import {
  enriched,
  essence,
  malformedPage,
  malformedProject,
  soundPage,
  soundProject,
  unshared,
} from '../../../tests/web/app/malformed-files.js';
import { readArchive } from '../../engine/archive.ts';
import { openDatabase } from '../database.ts';
import { allDie, documentOf } from '../testing.ts';
import { save as saveFile } from '../../ui/files.ts';
import { alerts, downloaded, textIn, tripTab } from './testing-pages.ts';
import type { Malformed } from '../../../tests/web/app/malformed-files.js';
import type { Tab } from './testing-pages.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));
afterEach(allDie);

const FIRST_SEED = Number(process.env.INKPANEL_SEED ?? 20_260);
/** Number of files of each kind. The tests of a change try some of them, with the same first seeds. */
const COUNT = Number(process.env.INKPANEL_MALFORMED ?? (process.env.INKPANEL_TIER === 'change' ? 100 : 500));
/** Number of files that one tab opens. */
const BATCH = 50;

/** Returns the documents of a project file and of a page, with content of all kinds, and their photos. */
async function goodFiles(tab: Tab) {
  vi.mocked(saveFile).mockClear();
  await tab.keeping.files.save();
  const archive = await readArchive(vi.mocked(saveFile).mock.calls[0][0] as File);
  const document = JSON.parse(await (await archive.get('project.json')!.read()).text());
  const entries = [...archive.values()].filter(({ name }) => name !== 'project.json');
  const photos = await Promise.all(entries.map(async ({ name, read }) => ({ name, blob: await read() })));
  const page = JSON.parse(await textIn(await downloaded(tab, 'project')));
  const packed = page.photos.map(({ path }: { path: string }, i: number) => ({
    name: path,
    blob: photos[i % photos.length].blob,
  }));
  return { project: { document: enriched(document), photos }, page: { document: enriched(page), photos: packed } };
}

/** Returns all records of a project, with the text of files instead of blobs. */
async function recordsOf(id: string) {
  const base = await openDatabase();
  const plain = async (value: unknown): Promise<unknown> => {
    if (value instanceof Blob) return `${value.size} ${await value.text()}`;
    if (Array.isArray(value)) return Promise.all(value.map(plain));
    if (typeof value !== 'object' || value === null) return value;
    const parts = Object.entries(value).map(async ([key, part]) => [key, await plain(part)]);
    return Object.fromEntries(await Promise.all(parts));
  };
  const project = await base.get('projects', id);
  const keys = project?.refs ?? [];
  const found = {
    projects: { [id]: project },
    states: { [id]: await base.get('states', id) },
    facts: await Promise.all(keys.map((key) => base.get('facts', key))),
    photos: await Promise.all(keys.map((key) => base.get('photos', key))),
  };
  base.close();
  return (await plain(found)) as typeof found;
}

/** Opens a file as the app does. Returns whether the project in it is open. */
async function feed(tab: Tab, { name, bytes }: Malformed): Promise<boolean> {
  const isPage = name.endsWith('.png');
  const file = new File([new Uint8Array(bytes)], name, { type: isPage ? 'image/png' : 'application/zip' });
  if (!isPage) await tab.keeping.files.open(file);
  else {
    const page = await tab.keeping.pageFiles.among([file]);
    if (page) await tab.keeping.pageFiles.open(page);
    // The app would add the file as a photo. It reports that the photo cannot be read.
    else tab.messages.fileFailed(name, 'not a page');
  }
  await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
  await tab.keeping.flush();
  return tab.keeping.current.value !== first(tab);
}

const FIRST: WeakMap<Tab, string> = new WeakMap();
const first = (tab: Tab) => FIRST.get(tab) as string;

/** Returns the visible state of a tab. */
const look = (tab: Tab) =>
  JSON.stringify([
    unshared(documentOf(tab)),
    [...tab.store.album.value.keys()],
    tab.keeping.current.value,
    tab.names(),
  ]);

const batches = Array.from({ length: Math.ceil(COUNT / BATCH) }, (_, i) => FIRST_SEED + i * BATCH);

it.each(
  (
    [
      ['projects', malformedProject, soundProject],
      ['pages', malformedPage, soundPage],
    ] as const
  ).flatMap(([kind, make, sound]) => batches.map((seed) => ({ kind, make, sound, seed }))),
)(
  'malformed $kind from seed $seed leave the open project as it was',
  { timeout: 240_000 },
  async ({ kind, make, sound, seed }) => {
    const tab = await tripTab();
    FIRST.set(tab, tab.keeping.current.value);
    const id = first(tab);
    const good = (await goodFiles(tab))[kind === 'projects' ? 'project' : 'page'];
    // The file can be opened before it is damaged.
    expect(
      await feed(tab, await sound(good)),
      alerts(tab)
        .map(({ text }) => text)
        .join(),
    ).toBe(true);
    expect(await tab.keeping.open(id)).toBe(true);
    await tab.keeping.flush();
    const before = { look: look(tab), records: await recordsOf(id) };
    let [opened, rejected] = [0, 0];
    for (let at = seed; at < Math.min(seed + BATCH, FIRST_SEED + COUNT); at += 1) {
      const file = await make(at, good);
      const about = `${file.name}: ${file.what}`;
      for (const { id: message } of alerts(tab)) tab.messages.close(message);
      const isOpen = await feed(tab, file);
      expect(tab.keeping.files.progress.value, about).toBe(null);
      if (isOpen) {
        opened += 1;
        expect(await tab.keeping.open(id), about).toBe(true);
        await tab.keeping.flush();
      } else {
        rejected += 1;
        expect(
          alerts(tab)
            .map(({ text }) => text)
            .join(),
          about,
        ).toContain(file.name);
      }
      expect(look(tab), about).toBe(before.look);
      const now = await recordsOf(id);
      const isSame = now.projects[id]?.stamp === before.records.projects[id]?.stamp;
      // Files that were opened add styles to the lists of all projects, which are saved with the project.
      expect(isSame ? now : essence(now), about).toEqual(isSame ? before.records : essence(before.records));
    }
    expect(Math.min(opened, rejected)).toBeGreaterThan(0);
  },
);
