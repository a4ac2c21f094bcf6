// @ts-check
/**
 * `My styles` and the favourites: kept in this browser (`keeping/shelves.js`), saved as files, shared as links. They are
 * a part of the project, so a style that was deleted comes back by undo.
 */

import { computed } from '@preact/signals';
import { strings } from '../strings.js';
import { save as saveFile } from './files.js';
import { LONGEST_STYLE, isStyleLink, linkOf, textOfLink } from './style-link.js';

/** @typedef {import('../engine/documents.js').Style} Style */
/** @typedef {ReturnType<typeof createOwnStyles>} OwnStyles */

/** More would make the lists long and the storage full; the oldest go. */
const MOST = 300;

/** @returns {string} an id that no other style has */
export function freshStyleId() {
  return `my-${Array.from(crypto.getRandomValues(new Uint8Array(6)), (byte) => byte.toString(16).padStart(2, '0')).join('')}`;
}

/**
 * @param {{
 *   store: import('./store.js').Store, pages: import('./pages.js').Pages, messages: import('./messages.js').Messages,
 *   designer: Pick<import('./designer.js').Designer, 'open' | 'change'>, freshId: () => string,
 * }} app
 */
export function createOwnStyles({ store, pages, messages, designer, freshId }) {
  const mine = computed(() => store.project.value.mine);
  const favourites = computed(() => store.project.value.favourites);

  return { mine, favourites, save, remove, duplicate, exportFile, open, openLink, copyLink, favour, isFavourite, find };

  /** @param {string} id @returns {Style | undefined} one of the person's own or favourite styles */
  function find(id) {
    return [...mine.peek(), ...favourites.peek()].find((style) => style.id === id);
  }

  /** Keeps a style, in the place of the one with its id. @param {Style} style */
  function save(style) {
    put(style);
    messages.note(strings.styleSaved(style.name));
  }

  /** @param {string} id */
  function remove(id) {
    const gone = mine.peek().find((style) => style.id === id);
    if (!gone) return;
    store.change({ type: 'own-styles', mine: mine.peek().filter((style) => style !== gone) });
    messages.note(strings.styleDeleted(gone.name));
  }

  /** @param {Style} style @returns {Style} a copy, kept */
  function duplicate(style) {
    const copy = { ...style, id: freshId(), name: strings.copyOf(style.name) };
    put(copy);
    return copy;
  }

  /** @param {Style} style */
  function exportFile(style) {
    const name = style.name.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-').replaceAll(/^-|-$/g, '') || style.id;
    saveFile(new Blob([`${JSON.stringify(style, null, 2)}\n`], { type: 'application/json' }), `${name}.json`);
  }

  /**
   * Takes styles from files; the last good one goes to the designer.
   * @param {readonly File[]} files
   */
  async function open(files) {
    let last = /** @type {Style | null} */ (null);
    for (const file of files) {
      try {
        if (file.size > LONGEST_STYLE) throw new Error(strings.styleTooLong(file.name));
        last = take(await file.text(), file.name);
      } catch (error) {
        const { message } = /** @type {Error} */ (error);
        messages.fileFailed(file.name, message, { text: message });
      }
    }
    if (last) show(last);
  }

  /** Takes the style of a link, if it is one. @param {string} hash */
  async function openLink(hash) {
    if (!isStyleLink(hash)) return;
    try {
      show(take(await textOfLink(hash), strings.linkedStyle));
    } catch (error) {
      messages.alert(/** @type {Error} */ (error).message);
    }
  }

  /**
   * @param {Style} style
   * @param {{ address: string, write: (text: string) => Promise<void> }} to `write` puts a text into the clipboard
   * @returns {Promise<string>} the link
   */
  async function copyLink(style, { address, write: copy }) {
    const link = address.replace(/#.*$/s, '') + await linkOf(style);
    await copy(link).then(() => messages.note(strings.linkCopied), () => messages.alert(strings.linkNotCopied(link)));
    return link;
  }

  /** Marks a style as a favourite, or no longer. @param {Style} style */
  function favour(style) {
    const others = favourites.peek().filter(({ id }) => id !== style.id);
    const all = others.length === favourites.peek().length ? [style, ...others] : others;
    store.change({ type: 'favourites', favourites: all.slice(0, MOST) });
  }

  /** @param {string} id */
  function isFavourite(id) {
    return favourites.value.some((style) => style.id === id);
  }

  /**
   * @param {string} json
   * @param {string} file its name, for the message
   * @returns {Style} checked and kept
   */
  function take(json, file) {
    const planner = store.planner.peek();
    if (!planner) throw new Error(strings.starting);
    const style = planner.checkStyle(json, file);
    // A designed style, or another one of that id, stays what it is.
    const taken = [...planner.styles(), ...mine.peek()].find(({ id }) => id === style.id);
    const same = taken && JSON.stringify(taken) === JSON.stringify(style);
    const kept = taken && !same ? { ...style, id: freshId() } : style;
    put(kept);
    return kept;
  }

  /** @param {Style} style */
  function show(style) {
    if (store.page.peek()) designer.open(style);
    else messages.note(strings.styleKept(style.name));
  }

  /** @param {Style} style */
  function put(style) {
    store.change({ type: 'own-styles', mine: [style, ...mine.peek().filter(({ id }) => id !== style.id)].slice(0, MOST) });
  }
}
