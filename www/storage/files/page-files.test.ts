import { beforeEach, describe, expect, it, vi } from 'vitest';
import { chunksOf } from '../../engine/png-chunks.ts';
import { save as saveFile } from '../../ui/files.ts';
import { withProject } from './page-file.ts';
import { placeholderOf } from '../../photos/placeholder.ts';
import { fakeBrowser } from '../testing.ts';
import { CROP, alerts, bare, bytesOf, downloaded, dropped, inPanels, textIn, tripTab } from './testing-pages.ts';
import type { Tab } from './testing-pages.ts';

vi.mock('../../ui/files.ts', () => ({ save: vi.fn() }));

/** The tab that made the page. */
let tab: Tab;

beforeEach(async () => {
  vi.mocked(saveFile).mockClear();
  tab = await tripTab();
});

/** A page, without data that depends on the browser. */
function look(of: Tab) {
  const { name, page, tray, settings } = of.store.project.value;
  const ids = tray.map(({ id }) => id);
  return JSON.parse(
    ids.reduce(
      (text, id, i) => text.replaceAll(id, `#${i}`),
      JSON.stringify({ name, page, settings, photos: ids.length }),
    ),
  );
}

describe('a page that carries its project', () => {
  it('tells nothing of files, ids and times', async () => {
    const facts = tab.store.facts.value;
    facts.forEach((fact, i) =>
      tab.store.know({ ...fact, meta: { ...(fact.meta as any), taken: `2021:05:0${i + 1} 07:08:09` } }),
    );
    const text = await textIn(await downloaded(tab, 'photos'));
    for (const secret of ['a.jpg', '2021', ...facts.map(({ id }) => id)]) expect(text).not.toContain(secret);
    expect(JSON.parse(text).photos.map((photo: any) => [photo.name, photo.rank, photo.like.hash.length])).toEqual([
      ['photo-1', 0, 64],
      ['photo-2', 1, 64],
      ['photo-3', 2, 64],
    ]);
    expect(text).toContain('Meanwhile');
  });

  it('tells the size of the photos in it', async () => {
    const { pageFiles } = tab.keeping;
    expect(pageFiles.photoBytes()).toBe(0);
    pageFiles.cargo.value = 'photos';
    // Three files of five bytes.
    expect(pageFiles.photoBytes()).toBe(15);
    pageFiles.cargo.value = 'project';
    expect(pageFiles.photoBytes()).toBe(0);
  });

  it('opens beside the work that is there, with the photos of this browser', async () => {
    const file = await downloaded(tab, 'project');
    const before = look(tab);
    const ids = tab.store.tray.value.map(({ id }) => id);
    await tab.keeping.create();
    await tab.add('x.jpg');
    const work = tab.keeping.current.value;
    expect((await dropped(tab, file)).opened).toBe(true);
    expect(look(tab)).toEqual(before);
    expect([inPanels(tab), tab.store.tray.value.map(({ id }) => id), alerts(tab)]).toEqual([
      ['a.jpg', 'b.jpg', 'c.jpg'],
      ids,
      [],
    ]);
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.map(({ photos }) => photos).sort()).toEqual([1, 3, 3]);
    const note = tab.messages.list.value.at(-1);
    expect([note?.way?.label, note?.more?.label]).toEqual(['Back to Untitled', 'Use as a photo']);
    note?.way?.run();
    await vi.waitFor(() => expect(tab.keeping.current.value).toBe(work));
    expect(tab.names()).toEqual(['x.jpg']);
  });

  it('with its photos is whole on another device, and goes out again as it came', async () => {
    const file = await downloaded(tab, 'photos');
    const before = look(tab);
    const other = await fakeBrowser().tab();
    await dropped(other, file);
    expect(look(other)).toEqual(before);
    expect([inPanels(other), alerts(other)]).toEqual([['photo-1', 'photo-2', 'photo-3'], []]);
    expect(await bytesOf(await downloaded(other, 'photos'))).toEqual(await bytesOf(file));
    // Without photos it is found there the next time.
    await dropped(other, await downloaded(tab, 'project'));
    expect([inPanels(other), alerts(other)]).toEqual([['photo-1', 'photo-2', 'photo-3'], []]);
  });

  it('keeps a place for each photo that is missing, which goes there when it comes', async () => {
    const file = await downloaded(tab, 'project');
    const other = await fakeBrowser().tab();
    await other.add('b.jpg');
    await dropped(other, file);
    expect(inPanels(other)).toEqual(['Missing photo 1', 'b.jpg', 'Missing photo 2']);
    expect([alerts(other).map(({ text }) => text), alerts(other)[0].way?.label]).toEqual([
      [expect.stringMatching(/2 of its 3 photos are not on this device/)],
      'Choose photos',
    ]);
    // It is exported unchanged, although two photos are missing.
    expect(await textIn(await downloaded(other, 'project'))).toBe(await textIn(file));
    other.store.change({ type: 'rename', name: 'Later' });
    const [z, c] = other.files('z.jpg', 'c.jpg');
    expect((await dropped(other, z, c)).rest).toEqual([z]);
    expect(inPanels(other)).toEqual(['Missing photo 1', 'b.jpg', 'c.jpg']);
    expect(other.store.page.value?.panels.map(({ crop }) => crop)).toEqual([CROP, CROP, CROP]);
    await dropped(other, ...other.files('a.jpg'));
    expect([inPanels(other), other.keeping.absentPhotos.list.value]).toEqual([['a.jpg', 'b.jpg', 'c.jpg'], []]);
    // Undo does not bring the frames back.
    other.store.change({ type: 'undo' });
    expect([inPanels(other), other.store.project.value.name]).toEqual([['a.jpg', 'b.jpg', 'c.jpg'], 'Trip']);
  });

  it('comes with its photos in one go', async () => {
    const file = await downloaded(tab, 'project');
    const other = await fakeBrowser().tab();
    const [a, b, c, d] = other.files('a.jpg', 'b.jpg', 'c.jpg', 'd.jpg');
    expect((await dropped(other, d, c, file, b, a)).rest).toEqual([d]);
    expect(inPanels(other)).toEqual(['a.jpg', 'b.jpg', 'c.jpg']);
  });

  it('goes through a project file with its empty places', async () => {
    const file = await downloaded(tab, 'project');
    const other = await fakeBrowser().tab();
    await dropped(other, file);
    await other.keeping.files.save();
    const [blob, name] = vi.mocked(saveFile).mock.calls[0];
    const third = await fakeBrowser().tab();
    await third.keeping.files.open(new File([blob], name));
    await dropped(third, ...third.files('a.jpg', 'b.jpg', 'c.jpg'));
    expect(inPanels(third)).toEqual(['a.jpg', 'b.jpg', 'c.jpg']);
  });

  it('can carry nothing, and photos go with one file only', async () => {
    const { pageFiles } = tab.keeping;
    expect((await chunksOf(await downloaded(tab, 'none')))?.map(({ type }) => type)).toEqual(['IHDR', 'IDAT', 'IEND']);
    expect(
      await pageFiles.among([await downloaded(tab, 'none'), new File(['text'], 'x.png'), new File([], 'y.png')]),
    ).toBe(null);
    expect(pageFiles.take(), 'without a wish').toBe('none');
    pageFiles.cargo.value = 'photos';
    expect([pageFiles.take(), pageFiles.take()]).toEqual(['photos', 'none']);
    pageFiles.cargo.value = 'project';
    expect([pageFiles.take(), pageFiles.take()]).toEqual(['project', 'none']);
  });

  it('that cannot be opened can still be a photo', async () => {
    const json = JSON.parse(await textIn(await downloaded(tab, 'project')));
    const file = new File([await withProject(await bare(), JSON.stringify({ ...json, version: 99 }), [])], 'new.png', {
      type: 'image/png',
    });
    await dropped(tab, file);
    expect(alerts(tab).map(({ text }) => text)).toEqual([
      expect.stringMatching(/^new\.png could not be opened: it was saved by a newer version of Inkpanel/),
    ]);
    alerts(tab)[0].way?.run();
    await vi.waitFor(() => expect(tab.names()).toContain('new.png'));
  });
});

it('the frame of a missing photo has its shape', async () => {
  const sizes = [
    [1500, 1000],
    [1000, 4000],
    [1, 1_000_000],
  ].map(async ([width, height]) => {
    const head = new DataView(await (await placeholderOf({ width, height })).slice(16, 24).arrayBuffer());
    return [head.getUint32(0), head.getUint32(4)];
  });
  expect(await Promise.all(sizes)).toEqual([
    [480, 320],
    [120, 480],
    [8, 480],
  ]);
});

it('the order of time goes through a project file, the times do not', async () => {
  const [a, b, c] = tab.store.facts.value;
  for (const [fact, day] of [
    [a, 3],
    [b, 1],
    [c, 2],
  ] as const)
    tab.store.know({ ...fact, meta: { ...(fact.meta as any), taken: `2021:05:0${day} 07:08:09` } });
  const order = () => tab.store.photos.value.map(({ id }) => tab.store.album.value.get(id)?.name);
  expect(order()).toEqual(['b.jpg', 'c.jpg', 'a.jpg']);
  await tab.keeping.files.save();
  const [blob, name] = vi.mocked(saveFile).mock.calls[0];
  expect(Buffer.from(await blob.arrayBuffer()).includes('2021:05')).toBe(false);
  await tab.keeping.files.open(new File([blob], name));
  expect(order()).toEqual(['b.jpg', 'c.jpg', 'a.jpg']);
});
