import { beforeEach, expect, it, vi } from 'vitest';
import { fakeBrowser } from '../storage/testing.ts';
import { noteFolders } from './folders.ts';

type Tab = Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;

let browser: ReturnType<typeof fakeBrowser>;
let tab: Tab;

beforeEach(async () => {
  browser = fakeBrowser();
  tab = await browser.tab();
});

const name = (of = tab) => of.store.project.value.name;

function photo(file: string, { day = 3, folders = [] as string[] } = {}) {
  const made = new File([file], file, { lastModified: new Date(2026, 5, day, 12).getTime() });
  return folders.length > 0 ? noteFolders(made, folders) : made;
}

async function add(...files: File[]) {
  await tab.reading.addFiles(files);
  await tab.keeping.flush();
}

it('is called after its folder, or its days, which follow the photos that come', async () => {
  await add(photo('a.jpg'), photo('b.jpg', { day: 5 }));
  expect(name()).toBe('June 3 – 5, 2026');
  await add(photo('c.jpg', { day: 8 }));
  expect(name()).toBe('June 3 – 8, 2026');
  // The name is part of the step that brought the photos.
  tab.store.change({ type: 'undo' });
  expect([name(), tab.names()]).toEqual(['June 3 – 5, 2026', ['a.jpg', 'b.jpg']]);
  await tab.keeping.create();
  await add(photo('d.jpg', { folders: ['Lisbon'] }));
  expect(name()).toBe('Lisbon');
  expect(tab.store.mirror.value.undos).toBe(0);
});

it('keeps the name that a person gave it, and gets its own again when that is taken away', async () => {
  await add(photo('a.jpg'));
  tab.store.change({ type: 'rename', name: 'Summer' });
  await add(photo('b.jpg', { day: 9 }));
  expect([name(), tab.reading.automaticName()]).toEqual(['Summer', 'June 3 – 9, 2026']);
});

it('a project of another session with a name of its own keeps it', async () => {
  await add(photo('a.jpg', { folders: ['Lisbon'] }));
  const id = tab.keeping.current.value;
  tab = await browser.died().tab();
  expect([tab.keeping.current.value, name()]).toEqual([id, 'Lisbon']);
  await add(photo('b.jpg'));
  expect(name()).toBe('Lisbon');
});

it('does not ask for the times of files whose photos have dates, or before they are read', async () => {
  const asked = vi.fn(() => 0);
  const made = Object.defineProperty(photo('a.jpg', { folders: ['Lisbon'] }), 'lastModified', { get: asked });
  await add(made);
  expect(name()).toBe('Lisbon');
  expect(asked).not.toHaveBeenCalled();
});

it('the times of files are no title, also not in another session', async () => {
  await add(photo('a.jpg'));
  expect([name(), tab.reading.title()]).toEqual(['June 3, 2026', '']);
  tab = await browser.died().tab();
  expect([name(), tab.reading.title()]).toEqual(['June 3, 2026', '']);
  tab.store.change({ type: 'rename', name: 'Summer' });
  expect(tab.reading.title()).toBe('Summer');
});
