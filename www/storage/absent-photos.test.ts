/** Messages about missing photos. */

import { describe, expect, it, vi } from 'vitest';
import { save as saveFile } from '../ui/files.ts';
import { fakeBrowser } from './testing.ts';
import { downloaded, dropped, tripTab } from './files/testing-pages.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

type Tab = Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;
const graves = ({ messages }: Tab) =>
  messages.list.value.filter(({ kind }) => kind === 'grave').map(({ text }) => text);

describe('the message that photos are missing', () => {
  it('counts down while they come back, and goes with the last', async () => {
    const file = await downloaded(await tripTab(), 'project');
    const other = await fakeBrowser().tab();
    await dropped(other, file);
    expect(graves(other)).toEqual([expect.stringMatching(/its 3 photos are not on this device/)]);
    await dropped(other, ...other.files('a.jpg'));
    expect(graves(other)).toEqual([expect.stringMatching(/^2 photos of this page are still missing/)]);
    await dropped(other, ...other.files('b.jpg', 'c.jpg'));
    expect(graves(other)).toEqual([]);
    // There is no second message later.
    await new Promise((resolve) => {
      setTimeout(resolve, 500);
    });
    expect(graves(other)).toEqual([]);
  });

  it('counts those that are taken out of the tray, too', async () => {
    const file = await downloaded(await tripTab(), 'project');
    const other = await fakeBrowser().tab();
    await dropped(other, file);
    const [first] = other.keeping.absentPhotos.list.value;
    other.reading.remove(first.id);
    expect(graves(other)).toEqual([expect.stringMatching(/^2 photos of this page are still missing/)]);
    other.pages.undo();
    expect(graves(other)).toEqual([expect.stringMatching(/^3 photos of this page are still missing/)]);
  });

  it('belongs to its project: it goes with it, and comes back with it, also after the page was loaded again', async () => {
    const file = await downloaded(await tripTab(), 'project');
    const browser = fakeBrowser();
    const other = await browser.tab();
    await dropped(other, file);
    const id = other.keeping.current.value;
    await other.keeping.flush();
    await other.keeping.create();
    expect(graves(other)).toEqual([]);
    await other.keeping.open(id);
    await vi.waitFor(() =>
      expect(graves(other)).toEqual([expect.stringMatching(/^All 3 photos are not in this browser/)]),
    );
    await other.keeping.flush();
    const again = await fakeBrowser(browser).tab({ session: other.session });
    await vi.waitFor(() =>
      expect(graves(again)).toEqual([expect.stringMatching(/^All 3 photos are not in this browser/)]),
    );
    await dropped(again, ...again.files('a.jpg', 'b.jpg'));
    expect(graves(again)).toEqual([expect.stringMatching(/^1 photo of this page is still missing/)]);
  });

  it('is there for a project file with empty places, too', async () => {
    const other = await fakeBrowser().tab();
    await dropped(other, await downloaded(await tripTab(), 'project'));
    await other.keeping.files.save();
    const [blob, name] = vi.mocked(saveFile).mock.calls[0];
    const third = await fakeBrowser().tab();
    await third.keeping.files.open(new File([blob], name));
    await vi.waitFor(() =>
      expect(graves(third)).toEqual([expect.stringMatching(/^3 photos of this page are still missing/)]),
    );
  });

  it('that was closed comes back only when more is known', async () => {
    const file = await downloaded(await tripTab(), 'project');
    const other = await fakeBrowser().tab();
    await dropped(other, file);
    other.messages.list.value.filter(({ kind }) => kind === 'grave').forEach(({ id }) => other.messages.close(id));
    other.store.change({ type: 'rename', name: 'Later' });
    await new Promise((resolve) => {
      setTimeout(resolve, 500);
    });
    expect(graves(other)).toEqual([]);
    await dropped(other, ...other.files('a.jpg'));
    expect(graves(other)).toEqual([expect.stringMatching(/^2 photos of this page are still missing/)]);
  });
});
