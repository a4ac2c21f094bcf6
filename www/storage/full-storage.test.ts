import { describe, expect, it, vi } from 'vitest';
import { encoded, recordIn } from '../engine/interned.ts';
import { fakeBrowser } from './testing.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

describe('storage that takes no more', () => {
  const full = Object.assign(new Error('no room'), { name: 'QuotaExceededError' });

  it('is said once, with a way out, and the next change tries again', async () => {
    const tab = await fakeBrowser().tab();
    const put = vi.spyOn(IDBObjectStore.prototype as any, 'put').mockImplementation(() => {
      throw full;
    });
    await tab.add('a.jpg');
    tab.pages.shuffle('all');
    await tab.keeping.flush();
    expect([tab.keeping.status.value, tab.names()]).toEqual(['full', ['a.jpg']]);
    const alerts = tab.messages.list.value.filter(({ kind }) => kind === 'grave');
    expect(alerts.map(({ way }) => way?.label)).toEqual(['Save to file']);
    put.mockRestore();
    tab.pages.shuffle('all');
    await tab.keeping.flush();
    expect(tab.keeping.status.value).toBe('saved');
  });

  it('keeps the files where there is no room for their copies', async () => {
    const browser = fakeBrowser();
    const tab = await browser.tab();
    const store = IDBObjectStore.prototype as any;
    const { put: original } = store;
    vi.spyOn(store, 'put').mockImplementation(function put(value: any) {
      if (value.work) throw full;
      return original.call(this, value);
    });
    await tab.add('a.jpg');
    const [fact] = tab.store.facts.value;
    const face = { label: 'face', score: 1, x: 0.1, y: 0.1, width: 0.2, height: 0.2 } as any;
    tab.store.know({ ...fact, meta: { ...(fact.meta as any), subjects: [face] }, looked: true });
    await tab.keeping.flush();
    expect(tab.keeping.status.value).toBe('saved');
    vi.restoreAllMocks();
    const after = await fakeBrowser(browser).tab();
    await vi.waitFor(() => expect(after.decoded).toEqual(['a.jpg']));
    expect(after.names()).toEqual(['a.jpg']);
    await vi.waitFor(() => expect(after.store.reading.value).toBe(null));
    expect(after.store.facts.value[0].meta?.subjects).toEqual([face]);
  });

  it('says not saved where what was written cannot be read back', async () => {
    const tab = await fakeBrowser().tab();
    const store = IDBObjectStore.prototype as any;
    const { put: original } = store;
    vi.spyOn(store, 'put').mockImplementation(function put(value: any) {
      return original.call(
        this,
        value.bytes ? { ...value, bytes: encoded({ ...recordIn(value.bytes), gesture: 'other' }) } : value,
      );
    });
    await tab.add('a.jpg');
    expect(tab.keeping.status.value).toBe('failed');
    vi.restoreAllMocks();
  });

  it('that is refused altogether takes nothing from the page', async () => {
    const browser = fakeBrowser();
    vi.spyOn(browser.factory, 'open').mockImplementation(() => {
      throw Object.assign(new Error('refused'), { name: 'SecurityError' });
    });
    const tab = await browser.tab();
    await tab.add('a.jpg');
    expect([tab.keeping.status.value, tab.names()]).toEqual(['refused', ['a.jpg']]);
    // Another project would replace unsaved data.
    expect(await tab.keeping.create()).toBe(false);
    expect(tab.names()).toEqual(['a.jpg']);
    await tab.keeping.files.save();
    expect(await tab.keeping.create()).toBe(true);
  });
});
