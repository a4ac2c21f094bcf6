import { beforeEach, describe, expect, it, vi } from 'vitest';
import { photosOn } from '../../engine/sheets.ts';
import { save as saveFile } from '../../ui/files.ts';
import { archiveOf, readArchive } from '../../engine/archive.ts';
import { documentOf, fakeBrowser } from '../testing.ts';
import type { Fact } from '../../document/album.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));

let tab: Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;
/** A saved project of three photos. */
let file: File;

beforeEach(async () => {
  vi.mocked(saveFile).mockClear();
  tab = await fakeBrowser().tab();
  await tab.add('a.jpg', 'b.jpg', 'c.jpg');
  tab.pages.shuffle('all');
  tab.store.change({ type: 'rename', name: 'Trip: one/two' });
  tab.store.change({ type: 'own-styles', mine: [{ id: 'my-1', name: 'Mine', tags: [], background: [] }] });
  await tab.keeping.files.save();
  const [blob, name] = vi.mocked(saveFile).mock.calls[0];
  file = new File([blob], name);
});

const reasons = () => tab.messages.list.value.filter(({ kind }) => kind === 'alert').map(({ text }) => text);

/** The file with another `project.json`. */
async function changed(change: (json: any) => any) {
  const found = await readArchive(file);
  const entries = await Promise.all(
    [...found.values()].map(async ({ name, read }) => {
      const blob = await read();
      if (name !== 'project.json') return [{ name, blob }];
      const made = change(JSON.parse(await blob.text()));
      return made === null ? [] : [{ name, blob: new Blob([typeof made === 'string' ? made : JSON.stringify(made)]) }];
    }),
  );
  return new File([await archiveOf(entries.flat())], file.name);
}

describe('a project file', () => {
  it('opens as a project of its own, as it was', async () => {
    expect(file.name).toBe('Trip one two.inkpanel');
    const { present, shown } = documentOf(tab);
    await tab.keeping.create();
    tab.store.change({ type: 'own-styles', mine: [] });
    await tab.keeping.files.open(file);
    await tab.keeping.flush();
    expect(tab.names()).toEqual(['a.jpg', 'b.jpg', 'c.jpg']);
    const now = documentOf(tab);
    expect([now.present.name, now.shown.length, now.present.mine.map(({ id }) => id)]).toEqual([
      present.name,
      shown.length,
      ['my-1'],
    ]);
    const look = (page: any) => ({
      ...page,
      order: page.order.length,
      panels: page.panels.map(({ crop }: any) => crop),
    });
    expect(look(now.present.page)).toEqual(look(present.page));
    const name = (id: string | null) => tab.store.album.value.get(String(id))?.name;
    expect(now.present.page?.panels.every(({ photo }) => name(photo))).toBe(true);
    // It is saved next to its source project.
    expect([tab.keeping.status.value, reasons()]).toEqual(['saved', []]);
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.length).toBe(2);
  });

  it('has no photos that only the undo history needs', async () => {
    // More than the limit of a page, in addition to the three of the earlier pages.
    await tab.add(...'defghijklmnop'.split('').map((name) => `${name}.jpg`));
    const { shown } = tab.store.mirror.value;
    const onPages = photosOn(shown.map(({ page }) => page));
    const unseen = tab.store.facts.value.find(({ id }) => !onPages.has(id)) as Fact;
    tab.reading.remove(unseen.id);
    await tab.keeping.files.save();
    const [blob] = vi.mocked(saveFile).mock.lastCall as [Blob, string];
    const names = [...(await readArchive(blob)).keys()].join();
    expect([names.includes(unseen.name), names.includes('c.jpg')]).toEqual([false, true]);
  });

  it('may be opened twice, and each stays itself', async () => {
    await tab.keeping.files.open(file);
    const first = tab.store.tray.value.map(({ id }) => id);
    await tab.keeping.files.open(file);
    expect(tab.store.tray.value.some(({ id }) => first.includes(id))).toBe(false);
    await tab.keeping.flush();
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.length).toBe(3);
  });

  it('opens with the photos that are left, names the others, and keeps their places', async () => {
    const text = new TextDecoder('latin1').decode(await file.arrayBuffer());
    const bytes = new Uint8Array(await file.arrayBuffer());
    bytes[text.indexOf('photos/002-b.jpgb.jpg') + 'photos/002-b.jpg'.length] ^= 1;
    await tab.keeping.files.open(new File([bytes], file.name));
    expect(tab.store.facts.value.map(({ name, absent }) => [name, !!absent])).toEqual([
      ['a.jpg', false],
      ['b.jpg', true],
      ['c.jpg', false],
    ]);
    // Failed files are reported together, a moment later.
    await vi.waitFor(() => expect(reasons().join()).toMatch(/b\.jpg.*damaged/));
  });

  it.each([
    ['no ZIP file', async () => new File(['hello'], 'x.inkpanel'), /damaged/],
    ['half of one', async () => new File([file.slice(0, file.size >> 1)], 'x.inkpanel'), /damaged/],
    ['without a document', () => changed(() => null), /damaged/],
    ['without JSON', () => changed(() => '{"format"'), /damaged/],
    ['of another program', () => changed((json) => ({ ...json, format: 'other' })), /damaged/],
    ['of a newer program', () => changed((json) => ({ ...json, version: 99 })), /newer version of Inkpanel/],
    ['without a version', () => changed(({ version: _version, ...json }) => json), /damaged/],
    ['without a history', () => changed((json) => ({ ...json, history: 7 })), /damaged/],
    [
      'with a tray of numbers',
      () =>
        changed((json) => ({
          ...json,
          history: { ...json.history, present: { ...json.history.present, tray: [1, 2] } },
        })),
      /damaged/,
    ],
    [
      'with a page of an unknown layout',
      () =>
        changed((json) => {
          const { present } = json.history;
          return {
            ...json,
            history: { ...json.history, present: { ...present, page: { ...present.page, layout: 'gone' } } },
          };
        }),
      /damaged/,
    ],
    [
      'with a page that has too few panels',
      () =>
        changed((json) => {
          const { present } = json.history;
          return {
            ...json,
            history: { ...json.history, present: { ...present, page: { ...present.page, panels: [] } } },
          };
        }),
      /damaged/,
    ],
    [
      'with photos that are not in it',
      () => changed((json) => ({ ...json, photos: json.photos.map((photo: any) => ({ ...photo, path: 'gone.jpg' })) })),
      /damaged/,
    ],
    ['with a photo without an id', () => changed((json) => ({ ...json, photos: [{ name: 'x' }] })), /damaged/],
  ])('%s changes nothing on the page', async (_, make, reason) => {
    const before = documentOf(tab);
    const held = [...tab.store.album.value.keys()];
    await tab.keeping.files.open(await make());
    expect(reasons().join()).toMatch(reason);
    expect(documentOf(tab)).toEqual(before);
    expect(held.every(tab.photos.has)).toBe(true);
    expect(tab.keeping.files.progress.value).toBe(null);
  });
});
