/**
 * `My styles` and favourites: stored in this browser (`storage/shelves.ts`), saved to files, shared as links. They are
 * a part of the project, so a style that was deleted comes back by undo.
 */

import { computed } from '@preact/signals';
import { noteUntilUndo } from '../ui/undo-note.ts';
import { readText } from '../engine/text-file.ts';
import { strings } from '../strings/strings.ts';
import { save as saveFile } from '../ui/files.ts';
import { importing } from '../ui/importing.ts';
import { LONGEST_LINK, LONGEST_STYLE, isStyleLink, linkOf, textOfLink } from './style-link.ts';
import { UserError } from '../ui/user-error.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { Style } from '../engine/types.ts';

export type OwnStyles = ReturnType<typeof createOwnStyles>;

/** Maximum number of styles, to limit the lists and the storage. The oldest are removed. */
const MOST = 300;

/** @returns an id that no other style has */
export function freshStyleId(): string {
  return `my-${Array.from(crypto.getRandomValues(new Uint8Array(6)), (byte) => byte.toString(16).padStart(2, '0')).join('')}`;
}

export function createOwnStyles({
  store,
  messages,
  designer,
  freshId,
}: {
  store: Store;
  messages: Messages;
  designer: { open: (style: Style) => void };
  freshId: () => string;
}) {
  const mine = computed(() => store.project.value.mine);
  const favourites = computed(() => store.project.value.favourites);

  return { mine, favourites, save, remove, duplicate, exportFile, open, openLink, copyLink, favour, isFavourite, find };

  /** @returns a custom or favourite style of the user */
  function find(id: string): Style | undefined {
    return [...mine.peek(), ...favourites.peek()].find((style) => style.id === id);
  }

  /** Saves a style, or replaces the style with its id. */
  function save(style: Style) {
    put(style);
    messages.note(strings.styleSaved({ name: style.name }));
  }

  function remove(id: string) {
    const gone = mine.peek().find((style) => style.id === id);
    if (!gone) return;
    store.change({ type: 'own-styles', mine: mine.peek().filter((style) => style !== gone) });
    noteUntilUndo({ messages, store }, strings.styleDeleted({ name: gone.name }));
  }

  /** @returns a stored copy */
  function duplicate(style: Style): Style {
    const copy = { ...style, id: freshId(), name: strings.nameOfCopy(style.name) };
    put(copy);
    return copy;
  }

  function exportFile(style: Style) {
    const name =
      style.name
        .toLowerCase()
        .replaceAll(/[^a-z0-9]+/g, '-')
        .replaceAll(/^-|-$/g, '') || style.id;
    saveFile(new Blob([`${JSON.stringify(style, null, 2)}\n`], { type: 'application/json' }), `${name}.json`);
  }

  /** Imports styles from files. The last valid one opens in the designer. */
  async function open(files: readonly File[]) {
    const taken: { file: File; style: Style }[] = [];
    for (const file of files) {
      const style = await importing(messages, file.name, async () => {
        if (file.size > LONGEST_STYLE) throw new UserError(strings.styleTooLong({ name: file.name }));
        return take((await readText(file)).text, file.name);
      });
      if (style) taken.push({ file, style });
    }
    const last = taken.at(-1);
    if (last) await importing(messages, last.file.name, () => show(last.style));
  }

  /** Takes the style of a link, if it is one. */
  async function openLink(hash: string) {
    if (!isStyleLink(hash)) return;
    await importing(
      messages,
      strings.linkedStyle,
      async () => show(take(await textOfLink(hash), strings.linkedStyle)),
      {
        text: (why) => why,
      },
    );
  }

  /**
   * @param to `write` puts a text into the clipboard
   * @returns the link
   */
  async function copyLink(
    style: Style,
    { address, write: copy }: { address: string; write: (text: string) => Promise<void> },
  ): Promise<string> {
    const mark = await linkOf(style);
    const link = address.replace(/#.*$/s, '') + mark;
    // Links with a texture are too long for most programs.
    if (mark.length > LONGEST_LINK) {
      messages.alert(strings.linkTooLong({ name: style.name }));
      return link;
    }
    await copy(link).then(
      () => messages.note(strings.linkCopied),
      () => messages.alert(strings.linkNotCopied({ link })),
    );
    return link;
  }

  /** Marks a style as a favourite, or no longer. */
  function favour(style: Style) {
    const others = favourites.peek().filter(({ id }) => id !== style.id);
    const all = others.length === favourites.peek().length ? [style, ...others] : others;
    store.change({ type: 'favourites', favourites: all.slice(0, MOST) });
  }

  function isFavourite(id: string) {
    return favourites.value.some((style) => style.id === id);
  }

  /**
   * @param file its name, for the message
   * @returns the validated and stored style
   */
  function take(json: string, file: string): Style {
    const planner = store.planner.peek();
    if (!planner) throw new UserError(strings.starting);
    const style = planner.checkStyle(json, file);
    // A built-in style, or another one with this id, does not change.
    const taken = [...planner.styles(), ...mine.peek()].find(({ id }) => id === style.id);
    const same = taken && JSON.stringify(taken) === JSON.stringify(style);
    const kept = taken && !same ? { ...style, id: freshId() } : style;
    put(kept);
    return kept;
  }

  function show(style: Style) {
    if (store.page.peek()) designer.open(style);
    else messages.note(strings.styleKept({ name: style.name }));
  }

  function put(style: Style) {
    store.change({
      type: 'own-styles',
      mine: [style, ...mine.peek().filter(({ id }) => id !== style.id)].slice(0, MOST),
    });
  }
}
