/** Projects and photos that come together. */

import { beforeEach, describe, expect, it, vi } from 'vitest';
import { createDroppedFiles } from './dropped-files.ts';
import { zipOf } from '../engine/testing-archives.ts';
import { noteFolders } from '../photos/folders.ts';
import { save as saveFile } from '../ui/files.ts';
import { fakeBrowser } from '../storage/testing.ts';
import { downloaded, inPanels } from '../storage/files/testing-pages.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

type Tab = Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;

function dropsOn(tab: Tab) {
  const showProjects = vi.fn();
  const opened = () => vi.fn(async (_files: readonly File[]) => {});
  const [speech, layouts, styles, models] = [opened(), opened(), opened(), opened()];
  const made = createDroppedFiles({
    ...(tab as any),
    subtitling: { open: speech },
    ownLayouts: { open: layouts },
    ownStyles: { open: styles },
    ownPainters: { open: models },
    showProjects,
  });
  return { ...made, showProjects, speech, layouts, styles, models };
}

/** The names of the files that a mock was called with. */
const namesIn = ({ mock }: { mock: { calls: [readonly File[]][] } }) =>
  mock.calls.flatMap(([files]) => files.map(({ name }) => name));

/** A browser that has made a project, and the project as a file. */
async function made(name: string, ...photos: string[]) {
  const tab = await fakeBrowser().tab();
  await tab.add(...photos);
  tab.store.change({ type: 'rename', name });
  await tab.keeping.flush();
  vi.mocked(saveFile).mockClear();
  await tab.keeping.files.save();
  const [blob] = vi.mocked(saveFile).mock.calls[0];
  return { tab, file: new File([blob], `${name}.inkpanel`) };
}

/** A PNG of it without its photos. */
const pngOf = async (tab: Tab, name: string) =>
  new File([await downloaded(tab, 'project')], name, { type: 'image/png' });

const texts = ({ messages }: Tab) => messages.list.value.map(({ text }) => text);
const projects = ({ keeping }: Tab) => keeping.list.value.map(({ name }) => name).sort();

describe('project files that are dropped together', () => {
  let one: Awaited<ReturnType<typeof made>>;
  let two: Awaited<ReturnType<typeof made>>;
  beforeEach(async () => {
    [one, two] = [await made('One', 'a.jpg'), await made('Two', 'b.jpg', 'c.jpg')];
  });

  it('each become a project of their own; the last is on the page, the other is a press away', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('mine.jpg');
    await dropsOn(tab).take([two.file, one.file]);
    await tab.keeping.flush();
    await tab.keeping.refresh();
    expect([tab.store.project.value.name, tab.names()]).toEqual(['Two', ['b.jpg', 'c.jpg']]);
    expect(projects(tab)).toEqual(['', 'One', 'Two']);
    const told = tab.messages.list.value.find(({ kind }) => kind === 'offer');
    expect(told?.text).toBe('2 projects were opened separately. Two is on the page; One is in Projects.');
    expect(told?.way?.label).toBe('Open One');
    told?.way?.run();
    await vi.waitFor(() => expect([tab.store.project.value.name, tab.names()]).toEqual(['One', ['a.jpg']]));
  });

  it('are told with the list of projects where they are more', async () => {
    const three = await made('Three', 'd.jpg');
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await drops.take([one.file, two.file, three.file]);
    const told = tab.messages.list.value.find(({ kind }) => kind === 'offer');
    expect(told?.text).toBe('3 projects were opened separately. Two is on the page; 2 more are in Projects.');
    told?.way?.run();
    expect(drops.showProjects).toHaveBeenCalledOnce();
  });

  it('that cannot be opened are named, and the others open', async () => {
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([
      one.file,
      new File(['no project'], 'Odd.inkpanel'),
      new File(['none either'], 'Zzz.inkpanel'),
    ]);
    expect(tab.store.project.value.name).toBe('One');
    await vi.waitFor(() => expect(texts(tab)).toContain('2 files could not be read.'));
    expect(tab.messages.failures.value.map(({ name }) => name)).toEqual(['Odd.inkpanel', 'Zzz.inkpanel']);
  });

  it('wait for those of the drop before, and all of them are opened', async () => {
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await Promise.all([drops.take([two.file]), drops.take([one.file])]);
    await tab.keeping.flush();
    await tab.keeping.refresh();
    expect([tab.store.project.value.name, projects(tab)]).toEqual(['One', ['One', 'Two']]);
  });

  it('that are stopped open no more, and bring no photos', async () => {
    const tab = await fakeBrowser().tab();
    const begun = [] as string[];
    tab.keeping.files.progress.subscribe((progress) => {
      if (!progress) return;
      begun.push(progress.name);
      queueMicrotask(tab.keeping.files.cancel);
    });
    await dropsOn(tab).take([one.file, two.file, ...tab.files('x.jpg')]);
    expect([[...new Set(begun)], tab.names(), texts(tab)]).toEqual([['One.inkpanel'], [], []]);
  });

  it('and a page among them open in the order of their names', async () => {
    const page = await pngOf(one.tab, 'Zoo.png');
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([page, two.file]);
    await tab.keeping.flush();
    await tab.keeping.refresh();
    expect([tab.store.project.value.name, projects(tab)]).toEqual(['One', ['One', 'Two']]);
    expect(inPanels(tab)).toEqual(['Missing photo 1']);
  });

  it('take the photos that came along where these are missing, in each of them; the rest joins the one on the page', async () => {
    const pages = [await pngOf(one.tab, '1.png'), await pngOf(two.tab, '2.png')];
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([...tab.files('x.jpg', 'a.jpg', 'b.jpg', 'c.jpg'), ...pages]);
    expect([tab.store.project.value.name, tab.names().sort()]).toEqual(['Two', ['b.jpg', 'c.jpg', 'x.jpg']]);
    const told = tab.messages.list.value.find(({ kind }) => kind === 'offer');
    expect(told?.text).toBe('2 projects were opened separately. Two is on the page; One is in Projects.');
    expect(texts(tab)).toContain('The photo from the same drop was added to Two.');
    told?.way?.run();
    await vi.waitFor(() => expect([tab.store.project.value.name, inPanels(tab)]).toEqual(['One', ['a.jpg']]));
  });
});

describe('a PNG file of a page', () => {
  it('opens as a picture if its photos are missing, and can be opened as a project', async () => {
    const { tab: other } = await made('One', 'a.jpg');
    const tab = await fakeBrowser().tab();
    await tab.add('mine.jpg');
    await dropsOn(tab).take([await pngOf(other, 'page.png')]);
    expect(tab.names()).toEqual(['mine.jpg', 'page.png']);
    const note = tab.messages.list.value.at(-1);
    expect([note?.kind, note?.way?.label]).toEqual(['note', 'Open as a project']);
    note?.way?.run();
    await vi.waitFor(() => expect(inPanels(tab)).toEqual(['Missing photo 1']));
    expect(tab.store.project.value.name).toBe('One');
  });

  it('opens as a project if one of its photos is on this device or in the file', async () => {
    const { tab: other } = await made('Two', 'a.jpg', 'b.jpg');
    const tab = await fakeBrowser().tab();
    await tab.add('b.jpg');
    await dropsOn(tab).take([await pngOf(other, 'page.png')]);
    // In the panels of the saved page.
    const missing = inPanels(other)?.map((name) => (name === 'a.jpg' ? 'Missing photo 1' : name));
    expect(missing?.toSorted()).toEqual(['Missing photo 1', 'b.jpg']);
    expect(inPanels(tab)).toEqual(missing);
    const third = await fakeBrowser().tab();
    await dropsOn(third).take([await downloaded(other, 'photos')]);
    expect(inPanels(third)).toEqual(inPanels(other)?.map((name) => (name === 'a.jpg' ? 'photo-1' : 'photo-2')));
  });
});

describe('photos with a project file', () => {
  it('join it, and that is said', async () => {
    const { file } = await made('One', 'a.jpg');
    const tab = await fakeBrowser().tab();
    await tab.add('mine.jpg');
    await dropsOn(tab).take([...tab.files('x.jpg', 'y.jpg'), file]);
    expect([tab.store.project.value.name, tab.names()]).toEqual(['One', ['a.jpg', 'x.jpg', 'y.jpg']]);
    expect(texts(tab)).toContain('The 2 photos from the same drop were added to One.');
  });

  it('that cannot be read are not said to have joined it', async () => {
    const { file } = await made('One', 'a.jpg');
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([new File(['bad'], 'x.jpg'), file]);
    expect([tab.names(), texts(tab)]).toEqual([['a.jpg'], [expect.stringMatching(/^x\.jpg: /)]]);
  });

  it('that cannot be opened join what is on the page', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('mine.jpg');
    await dropsOn(tab).take([...tab.files('x.jpg'), new File(['none'], 'Odd.inkpanel')]);
    expect(tab.names()).toEqual(['mine.jpg', 'x.jpg']);
  });

  it('that come after it, while it is being opened, join it', async () => {
    const { file } = await made('One', 'a.jpg');
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await Promise.all([drops.take([file]), drops.take(tab.files('x.jpg'))]);
    expect([tab.store.project.value.name, tab.names()]).toEqual(['One', ['a.jpg', 'x.jpg']]);
  });
});

it('several files that are chosen as projects are all opened; a picture among them is named', async () => {
  const [one, two] = [await made('One', 'a.jpg'), await made('Two', 'b.jpg')];
  const tab = await fakeBrowser().tab();
  await dropsOn(tab).openProjects([two.file, new File(['none'], 'plain.png', { type: 'image/png' }), one.file]);
  await tab.keeping.flush();
  await tab.keeping.refresh();
  expect([tab.store.project.value.name, projects(tab)]).toEqual(['Two', ['One', 'Two']]);
  await vi.waitFor(() =>
    expect(texts(tab)).toContain('plain.png could not be opened: it is an image without project data.'),
  );
});

describe('photos that are dropped while another project is on its way', () => {
  it('join that one', async () => {
    const tab = await fakeBrowser().tab();
    await tab.add('old.jpg');
    await tab.keeping.flush();
    const old = tab.keeping.current.value;
    const created = tab.keeping.create();
    await dropsOn(tab).take([new File(['x'], 'new.jpg')]);
    expect(await created).toBe(true);
    expect(tab.names()).toEqual(['new.jpg']);
    await tab.keeping.flush();
    await tab.keeping.open(old);
    expect(tab.names()).toEqual(['old.jpg']);
  });
});

describe('files that systems and programs store next to photos', () => {
  const SIDECARS = ['.DS_Store', '._a.jpg', 'Thumbs.db', 'desktop.ini', 'a.AAE', 'a.xmp', 'Icon\r'];

  it('are skipped', async () => {
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([
      ...SIDECARS.map((name) => new File(['bad'], name)),
      ...tab.files('a.jpg'),
      noteFolders(new File(['bad'], 'b.jpg'), ['trip', '__MACOSX']),
    ]);
    expect([tab.names(), texts(tab)]).toEqual([
      ['a.jpg'],
      ['8 files that systems and programs store next to photos were skipped.'],
    ]);
  });

  it('are reported if nothing else comes', async () => {
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([new File(['bad'], 'a.xmp')]);
    expect(texts(tab)).toEqual([expect.stringMatching(/^a\.xmp: /)]);
  });
});

describe('a Live Photo', () => {
  it('is one photo; its video is offered', async () => {
    const tab = await fakeBrowser().tab();
    const added = vi.spyOn((tab as any).reading, 'addFiles');
    await dropsOn(tab).take(tab.files('IMG_1.HEIC', 'IMG_1.MOV', 'b.jpg'));
    expect(tab.names()).toEqual(['b.jpg', 'IMG_1.HEIC']);
    const offer = tab.messages.list.value.find(({ kind }) => kind === 'offer');
    expect([offer?.text, offer?.way?.label]).toEqual([
      '1 video of a Live Photo was not added. Its photo was.',
      'Add the video',
    ]);
    offer?.way?.run();
    const [last] = added.mock.lastCall as unknown as [File[]];
    expect(last.map(({ name }) => name)).toEqual(['IMG_1.MOV']);
  });
});

describe('files that are no photos', () => {
  it('are named by their kind, with a way out', async () => {
    const tab = await fakeBrowser().tab();
    const rar = new File(['bad'], 'book.cbr');
    await dropsOn(tab).take([
      rar,
      new File(['bad'], 'script.fdx'),
      new File(['a,b'], 'list.csv'),
      ...tab.files('a.jpg'),
    ]);
    await vi.waitFor(() => expect(tab.messages.failures.value).toHaveLength(3));
    expect(tab.messages.failures.value.map(({ name, why }) => [name, why])).toEqual([
      ['book.cbr', 'this kind of file (RAR) cannot be read. Unpack it and add its pictures, or pack them as ZIP.'],
      ['list.csv', 'it is a screenplay or a table. Open the storyboard and choose “Import script or table”.'],
      ['script.fdx', 'this kind of file (Final Draft) cannot be read. Export it as Fountain.'],
    ]);
    expect(tab.names()).toEqual(['a.jpg']);
  });

  it('are archives if they are ZIP files, whatever their name', async () => {
    const tab = await fakeBrowser().tab();
    const comic = new File([zipOf([{ name: '1.jpg', content: Buffer.from('pixels') }])], 'book.cbr');
    await dropsOn(tab).take([comic]);
    expect(tab.names()).toEqual(['1.jpg']);
  });
});

describe('JSON files', () => {
  const json = (name: string, value: unknown) => new File([JSON.stringify(value)], name);
  const takeout = json('a.jpg.json', { title: 'a.jpg', photoTakenTime: { timestamp: '1' } });
  const layout = json('layout.json', { id: 'x', family: 'custom', tree: {} });
  const style = json('style.json', { id: 'x', background: [] });

  it('of Google Takeout are skipped like other files next to photos', async () => {
    const tab = await fakeBrowser().tab();
    await dropsOn(tab).take([takeout, ...tab.files('a.jpg')]);
    expect([tab.names(), texts(tab)]).toEqual([
      ['a.jpg'],
      ['1 file that a system or program stores next to photos was skipped.'],
    ]);
  });

  it('of other programs are skipped next to photos; layouts and styles are opened', async () => {
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    const other = json('list.json', [1]);
    await drops.take([other, layout, style, new File(['{'], 'broken.json'), ...tab.files('a.jpg')]);
    await vi.waitFor(() => expect(namesIn(drops.styles)).toEqual(['style.json']));
    // The layout reader reports errors of a file that is not JSON.
    expect(namesIn(drops.layouts)).toEqual(['layout.json', 'broken.json']);
    expect([tab.names(), texts(tab)]).toEqual([['a.jpg'], []]);
  });

  it('of painters join no album', async () => {
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await drops.take([new File(['x'], 'Night.ONNX'), ...tab.files('a.jpg')]);
    expect([namesIn(drops.models), tab.names(), texts(tab)]).toEqual([['Night.ONNX'], ['a.jpg'], []]);
  });

  it('of other programs that come alone are said to be neither layouts nor styles', async () => {
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await drops.take([json('album.json', { title: 'Lisbon' }), json('list.json', [1]), json('null.json', null)]);
    await vi.waitFor(() => expect(tab.messages.failures.value).toHaveLength(3));
    expect(new Set(tab.messages.failures.value.map(({ why }) => why))).toEqual(
      new Set(['it is not an Inkpanel layout or style.']),
    );
    expect(namesIn(drops.layouts)).toEqual([]);
  });
});

describe('a text', () => {
  const readme = () => new File(['Album: Lisbon\nCamera: Nikon D70\nLicense: CC BY 4.0'], 'readme.txt');

  it('that comes alone is a script if somebody speaks in it', async () => {
    const drops = dropsOn(await fakeBrowser().tab());
    await drops.take([readme(), new File(['1'], 'a.srt')]);
    expect(namesIn(drops.speech)).toEqual(['readme.txt', 'a.srt']);
  });

  it('that comes with photos is only offered as a script', async () => {
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await drops.take([readme(), new File(['1'], 'a.srt'), ...tab.files('a.jpg')]);
    expect([namesIn(drops.speech), tab.names()]).toEqual([['a.srt'], ['a.jpg']]);
    const offer = tab.messages.list.value.find(({ kind }) => kind === 'offer');
    expect(offer?.text).toBe('readme.txt may be a script. It was not added to the pages.');
    offer?.way?.run();
    expect(namesIn(drops.speech)).toEqual(['a.srt', 'readme.txt']);
  });

  it('without speech is skipped in a folder of photos, and reported among chosen files', async () => {
    const tab = await fakeBrowser().tab();
    const drops = dropsOn(tab);
    await drops.take([noteFolders(new File(['bad'], 'notes.txt'), ['trip']), ...tab.files('a.jpg')]);
    expect([tab.names(), texts(tab)]).toEqual([['a.jpg'], []]);
    await drops.take([new File(['bad'], 'notes.txt'), ...tab.files('b.jpg')]);
    expect([tab.names(), texts(tab)]).toEqual([['a.jpg', 'b.jpg'], [expect.stringMatching(/^notes\.txt: /)]]);
  });
});

it('a drop that fails as a whole is reported with the names of its files', async () => {
  const tab = await fakeBrowser().tab();
  tab.keeping.absentPhotos.fill = () => Promise.reject(new TypeError('broken'));
  const drops = dropsOn(tab);
  await drops.take(tab.files('a.jpg', 'b.jpg'));
  expect(texts(tab)).toEqual(['a.jpg, b.jpg: an internal error occurred: broken']);
  expect(drops.busy.value).toBe(false);
});

it('a text that cannot be read does not take away the photos that came with it', async () => {
  const tab = await fakeBrowser().tab();
  const unreadable = { arrayBuffer: () => Promise.reject(new DOMException('gone', 'NotFoundError')) };
  const gone = Object.assign(new File([''], 'gone.txt'), { slice: () => unreadable, ...unreadable });
  await dropsOn(tab).take([gone, ...tab.files('a.jpg')]);
  expect(tab.names()).toContain('a.jpg');
});
