import { expect, it } from 'vitest';
import { fakeBrowser } from './testing.ts';

it('a project is renamed without being opened, in all of its states', async () => {
  const browser = fakeBrowser();
  const tab = await browser.tab();
  await tab.add('a.jpg');
  tab.store.change({ type: 'rename', name: 'First' });
  await tab.add('b.jpg');
  await tab.keeping.flush();
  const first = tab.keeping.current.value;
  await tab.keeping.create();
  await tab.add('c.jpg');
  const second = tab.keeping.current.value;
  expect(await tab.keeping.rename(first, '  Lisbon  ')).toBe(true);
  expect(tab.keeping.current.value).toBe(second);
  expect(tab.keeping.list.value.find(({ id }) => id === first)?.name).toBe('Lisbon');
  expect(await tab.keeping.open(first)).toBe(true);
  expect(tab.store.project.value.name).toBe('Lisbon');
  // Undo takes the photos away, not the name.
  tab.store.change({ type: 'undo' });
  expect([tab.store.project.value.name, tab.names()]).toEqual(['Lisbon', ['a.jpg']]);
});

it('the one on the page is renamed as by its own field, as a step of the undo', async () => {
  const tab = await fakeBrowser().tab();
  await tab.add('a.jpg');
  const before = tab.store.project.value.name;
  expect(await tab.keeping.rename(tab.keeping.current.value, 'Lisbon')).toBe(true);
  expect([tab.store.project.value.name, tab.keeping.list.value[0].name]).toEqual(['Lisbon', 'Lisbon']);
  tab.store.change({ type: 'undo' });
  expect(tab.store.project.value.name).toBe(before);
  expect(await tab.keeping.rename(tab.keeping.current.value, '   ')).toBe(false);
});

it('one that is open in another tab keeps its name, which is said', async () => {
  const browser = fakeBrowser();
  const one = await browser.tab();
  await one.add('a.jpg');
  one.store.change({ type: 'rename', name: 'Mine' });
  await one.keeping.flush();
  const other = await browser.tab();
  await other.keeping.refresh();
  expect(await other.keeping.rename(one.keeping.current.value, 'Theirs')).toBe(false);
  expect(other.messages.list.value.map(({ text }) => text)).toContain('Mine is open in another tab.');
  expect(one.store.project.value.name).toBe('Mine');
});
