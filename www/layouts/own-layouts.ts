/**
 * `My layouts`: stored in this browser (`storage/shelves.ts`), saved to files, opened from files. They are a part of
 * the project, so a layout that was removed comes back by undo.
 */

import { readText } from '../engine/text-file.ts';
import { strings } from '../strings/strings.ts';
import { save as saveFile } from '../ui/files.ts';
import { importing } from '../ui/importing.ts';
import { UserError } from '../ui/user-error.ts';
import type { Messages } from '../ui/messages.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Template } from '../engine/types.ts';

export type OwnLayouts = ReturnType<typeof createOwnLayouts>;

/** Maximum number of layouts, to limit the list and the storage. The oldest are removed. */
const MOST = 200;
/** Maximum size of a layout file in bytes. The core has the same limit, but checks it after reading the file. */
const LONGEST = 256 * 1024;

export function createOwnLayouts({ store, pages, messages }: { store: Store; pages: Pages; messages: Messages }) {
  return { save, open, remove, isOwn };

  /** The layout of the page as a file, and in the list. */
  function save() {
    const layout = full();
    if (!layout) return;
    keep(layout);
    saveFile(new Blob([`${JSON.stringify(layout, null, 2)}\n`], { type: 'application/json' }), `${layout.id}.json`);
    messages.note(strings.layoutSaved);
  }

  /** Takes layouts from files; the last good one becomes the page's. */
  async function open(files: readonly File[]) {
    const taken: { file: File; layout: Template }[] = [];
    for (const file of files) {
      const layout = await importing(messages, file.name, () => take(file));
      if (layout) taken.push({ file, layout });
    }
    const last = taken.at(-1);
    if (!last) return;
    if (store.page.peek()) await importing(messages, last.file.name, () => pages.chooseLayout(last.layout));
    else messages.note(strings.layoutKept);
  }

  async function take(file: File): Promise<Template> {
    const planner = store.planner.peek();
    if (!planner) throw new UserError(strings.starting);
    if (file.size > LONGEST) throw new UserError(strings.layoutTooLong({ name: file.name }));
    const layout = planner.checkLayout((await readText(file)).text, file.name);
    keep(layout);
    return layout;
  }

  function remove(id: string) {
    write(store.own.peek().filter((layout) => layout.id !== id));
  }

  /** @returns the layout of the page in full */
  function full(): Template | null {
    const page = store.page.peek();
    return (page && store.planner.peek()?.layoutFile(page.layout)) ?? null;
  }

  function isOwn(id: string) {
    return store.own.value.some((layout) => layout.id === id);
  }

  function keep(layout: Template) {
    // One of the catalogue is in the list already.
    if (store.layouts.peek().some(({ id, own }) => id === layout.id && own === null)) return;
    write([layout, ...store.own.peek().filter(({ id }) => id !== layout.id)].slice(0, MOST));
  }

  function write(ownLayouts: readonly Template[]) {
    store.change({ type: 'own-layouts', ownLayouts });
  }
}
