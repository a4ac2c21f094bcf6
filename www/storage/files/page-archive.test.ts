import fc from 'fast-check';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { ARCHIVE } from '../../engine/limits.ts';
import { foldersOf } from '../../photos/folders.ts';
import { save as saveFile } from '../../ui/files.ts';
import { archiveOf } from '../../engine/archive.ts';
import { fakeBrowser } from '../testing.ts';
import { packedNothing, zipOf } from '../../engine/testing-archives.ts';
import { readInside } from './page-archive.ts';
import { bare, downloaded, dropped, textIn } from './testing-pages.ts';
import type { Cargo } from './page-files.ts';
import type { Tab } from './testing-pages.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));

/** The tab that made a storyboard of two pages. */
let tab: Tab;

const pages = (of: Tab) =>
  of.store.sheets.value.map(({ layout, style, panels }) => [
    layout,
    style,
    panels.map(({ photo }) => of.store.album.value.get(photo ?? '')?.name),
  ]);

async function twoPages() {
  const made = await fakeBrowser().tab();
  await made.add('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg', 'e.jpg');
  const { page } = made.store.project.value;
  const [a, b, ...rest] = made.store.tray.value.map(({ id }) => id);
  const of = (ids: string[], seed: number) => ({
    ...(page as any),
    seed,
    layout: `grid-${ids.length}`,
    order: ids,
    merges: [],
    panels: ids.map((photo) => ({ photo, crop: null, locked: false, edited: false })),
  });
  made.store.change({
    type: 'set-sheets',
    sheets: [
      { page: of([a, b], 1), pageId: 7, sheet: 3 },
      { page: of(rest, 2), pageId: 9, sheet: 5 },
    ],
    at: 1,
  });
  made.store.change({ type: 'rename', name: 'Trip' });
  await made.keeping.flush();
  return made;
}

/** Its pages as one file. */
async function book(of: Tab, what: Cargo, ending = 'cbz') {
  const packed = await of.keeping.pageFiles.packed(what);
  const entries = [{ name: 'page-01.png', blob: await bare() }, ...(packed ? [packed.entry] : [])];
  return new File([await archiveOf(entries)], `Trip.${ending}`);
}

beforeEach(async () => {
  vi.mocked(saveFile).mockClear();
  tab = await twoPages();
});

describe('a page', () => {
  it('carries all pages of its storyboard, and opens again on the one that it shows', async () => {
    const other = await fakeBrowser().tab();
    await dropped(other, await downloaded(tab, 'photos'));
    const name = (photo: string) => `photo-${photo.charCodeAt(0) - 96}`;
    expect(pages(other)).toEqual(
      pages(tab).map(([layout, style, photos]) => [layout, style, (photos as string[]).map((photo) => name(photo))]),
    );
    expect([other.store.project.value.at, other.store.project.value.name]).toEqual([1, 'Trip']);
    expect(other.store.mirror.value.shown.map(({ id }) => id)).toEqual([1, 2]);
    // Without the undo history.
    const present = JSON.parse(await textIn(await downloaded(tab, 'project'))).history.present;
    expect([present.sheet, present.pageId, present.others[0].sheet]).toEqual([1, 2, 0]);
  });

  it('in fewer pixels has the others in as many, on other paper as they are', async () => {
    const page = tab.store.page.value as any;
    const drawnAs = async (size: object) => {
      const drawn = { ...page, page: { ...page.page, ...size } };
      const { png } = await tab.keeping.pageFiles.carrying(await bare(), drawn, 'project');
      const { present } = JSON.parse(await textIn(png)).history;
      return [present.page.page.width, present.others[0].page.page.width];
    };
    const { width, height } = page.page;
    expect(await drawnAs({ width: width / 2, height: height / 2, dpi: 150 })).toEqual([width / 2, width / 2]);
    expect(await drawnAs({ width: 2400, height: 2400 })).toEqual([2400, width]);
  });
});

describe('an archive of pages', () => {
  it.each(['cbz', 'zip'])('as %s opens again as the storyboard', async (ending) => {
    const other = await fakeBrowser().tab();
    const { page } = await other.keeping.pageFiles.unpacked(await book(tab, 'photos', ending));
    expect(page && (await other.keeping.pageFiles.open(page))).toBe(true);
    expect(pages(other).map(([layout]) => layout)).toEqual(['grid-2', 'grid-3']);
    expect(other.names()).toEqual(['photo-1', 'photo-2', 'photo-3', 'photo-4', 'photo-5']);
    expect(other.store.project.value.name).toBe('Trip');
  });

  it('finds its photos on the device where it was made, and can be chosen', async () => {
    const file = await book(tab, 'project');
    await tab.keeping.create();
    expect(await tab.keeping.pageFiles.openChosen(file, async () => false)).toBe(true);
    expect(tab.names()).toEqual(['a.jpg', 'b.jpg', 'c.jpg', 'd.jpg', 'e.jpg']);
    expect(await book(tab, 'none').then((bare) => tab.keeping.pageFiles.unpacked(bare))).toMatchObject({
      pictures: [{ name: 'page-01.png' }],
    });
  });

  it('that is a project file under another name is opened as one', async () => {
    await tab.keeping.files.save();
    const [blob] = vi.mocked(saveFile).mock.calls[0];
    const file = new File([blob], 'mailed.zip');
    expect((await tab.keeping.pageFiles.unpacked(file)).project).toBe(file);
  });
});

describe('an archive of others', () => {
  const said = () => tab.messages.failures.value.map(({ name, why }) => [name, why]);
  const zip = (files: Parameters<typeof zipOf>[0], name = 'Lisbon.zip') => new File([zipOf(files)], name);

  it('gives its pictures, and nothing else that is in it', async () => {
    const content = Buffer.from('pixels');
    const file = zip([
      { name: 'day 1/b.JPG', content, packed: true },
      { name: 'a.png', content },
      { name: 'notes.txt', content },
      { name: '__MACOSX/._a.png', content },
      { name: '.hidden.jpg', content },
      { name: 'day 1/' },
    ]);
    const { pictures } = await tab.keeping.pageFiles.unpacked(file);
    expect(pictures.map(({ name, type }) => [name, type])).toEqual([
      ['b.JPG', 'image/jpeg'],
      ['a.png', 'image/png'],
    ]);
    expect(await pictures[0].text()).toBe('pixels');
    expect(pictures.map(foldersOf)).toEqual([['Lisbon', 'day 1'], ['Lisbon']]);
  });

  it('gives or names all that is in it', async () => {
    const kinds = {
      photo: ['jpg', 'JFIF', 'heic', 'mov'],
      unsupported: ['cbr', 'psd'],
      other: ['txt', 'AAE', 'jpg.json'],
    };
    const ending = fc.constantFrom(...Object.values(kinds).flat());
    const folder = fc.constantFrom('', 'trip/', '__MACOSX/', 'a\\\\b/', '.hidden/');
    const made = fc.record({ folder, stem: fc.stringMatching(/^[a-z._~ ]{1,6}$/), ending, bad: fc.boolean() });
    const content = Buffer.from('pixels');
    await fc.assert(
      fc.asyncProperty(
        fc.uniqueArray(made, { selector: (one) => one.folder + one.stem + one.ending, maxLength: 12 }),
        async (all) => {
          const files = all.map(({ folder, stem, ending, bad }) => ({
            name: `${folder}${stem}.${ending}`,
            content,
            ...(bad ? { crc: 1 } : {}),
          }));
          const inside = await readInside(zip([{ name: 'trip/' }, ...files]), { step: () => {} } as any);
          if (!('pictures' in inside)) throw new Error('no pictures');
          const { pictures, damaged, unsupported, others, beyond } = inside;
          expect(pictures.length + damaged.length + unsupported.length + others + beyond).toBe(files.length);
          const wanted = all.filter(
            ({ folder, stem, ending }) =>
              kinds.photo.includes(ending) && !/^(?:\.|__)/.test(folder) && !stem.startsWith('.'),
          );
          expect(pictures.length + damaged.length).toBe(wanted.length);
          expect(damaged.length).toBe(wanted.filter(({ bad }) => bad).length);
        },
      ),
      { numRuns: 300 },
    );
  });

  it('that is a RAR file is named as one', async () => {
    await tab.keeping.pageFiles.unpacked(new File(['Rar!\x1a\x07\x01\x00'], 'book.cbz'));
    expect(said()).toEqual([
      ['book.cbz', 'this kind of file (RAR) cannot be read. Unpack it and add its pictures, or pack them as ZIP.'],
    ]);
  });

  it('with a picture that is damaged gives the others, and names it', async () => {
    const content = Buffer.from('pixels');
    const { pictures } = await tab.keeping.pageFiles.unpacked(
      zip([
        { name: 'good.jpg', content },
        { name: 'bad.jpg', content, crc: 1 },
      ]),
    );
    expect(pictures.map(({ name }) => name)).toEqual(['good.jpg']);
    expect(said()).toEqual([['bad.jpg', 'it is damaged in Lisbon.zip.']]);
  });

  it.each([
    ['nothing to look at', () => zip([{ name: 'notes.txt' }]), /it contains no images/],
    ['no archive', () => new File(['words'], 'x.zip'), /damaged/],
    [
      'one that says how much it unpacks to',
      () => zip([{ name: 'a.jpg', content: Buffer.from('x'), method: 8, size: ARCHIVE.entry + 1 }]),
      /exceeds the limits of a project/,
    ],
    [
      'one that does not',
      () => {
        const packed = packedNothing(320);
        return zip([{ name: 'a.jpg', content: packed, method: 8, length: packed.length, size: 100 * 2 ** 20, crc: 0 }]);
      },
      /damaged|exceeds the limits of a project/,
    ],
  ])('with %s is refused with a reason', async (_, made, why) => {
    const before = tab.store.mirror.value;
    expect((await tab.keeping.pageFiles.unpacked(made())).pictures).toEqual([]);
    expect(said().map(([, reason]) => reason)).toEqual([expect.stringMatching(why)]);
    expect(tab.store.mirror.value).toBe(before);
  });
});

describe('saving a project as a file', () => {
  it('tells how far it is, and can be stopped, which gives no file', async () => {
    const seen: number[] = [];
    const stop = tab.keeping.files.saving.subscribe((value) => value && seen.push(value.done / value.total));
    await tab.keeping.files.save();
    expect(seen.length).toBeGreaterThan(5);
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
    expect([Math.max(...seen) < 1, tab.keeping.files.saving.value]).toEqual([true, null]);
    stop();
    vi.mocked(saveFile).mockClear();
    const saving = tab.keeping.files.save();
    tab.keeping.files.cancelSaving();
    await saving;
    expect(vi.mocked(saveFile)).not.toHaveBeenCalled();
    expect([tab.keeping.files.saving.value, tab.messages.list.value.some(({ kind }) => kind === 'alert')]).toEqual([
      null,
      false,
    ]);
    await tab.keeping.files.save();
    expect(vi.mocked(saveFile)).toHaveBeenCalledOnce();
  });
});
