// @ts-check
/**
 * Words on the page, by hand: added, written, moved, pointed, removed. Each edit is one step of the undo. A word that
 * nobody has moved is placed by the core, again and again as the page changes, so that it hides no face.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings.js';
import { MOST, wellFormed } from './limits.js';
import { anchored, pagePoint } from './word-places.js';
import { createWordPlanning } from './word-planning.js';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {import('../engine/documents.js').Word} Word */
/** @typedef {ReturnType<typeof createLettering>} Lettering */
/** What the next click on the page is for. @typedef {'move' | 'tail'} Mode */

/**
 * @param {{
 *   store: Store, messages: Pick<import('./messages.js').Messages, 'alert' | 'note'>,
 *   selection: Pick<import('./selection.js').Selection, 'panels'>, load: import('../engine/engine.js').Engine['lettering'],
 * }} app `load`: what knows the letters
 */
export function createLettering({ store, messages, selection, load }) {
  const planning = createWordPlanning({ store, messages, load });
  const { words, letters, ready, failed, settled } = planning;
  const boxes = computed(() => {
    const page = store.page.value;
    return page && letters.value && words.value.length > 0 ? letters.value.measure(page) : [];
  });
  const marked = signal(-1);
  /** The word that is being changed. */
  const chosen = computed(() => (marked.value < words.value.length ? marked.value : -1));
  /** The word whose text is being written. */
  const editing = signal(-1);
  /** @type {import('@preact/signals').Signal<Mode | null>} */
  const mode = signal(null);
  let steps = 0;

  return {
    words, boxes, chosen, editing, mode, rested: planning.rested, within: planning.within, on: planning.on,
    choose, add, addAll, edit, write, move, point, remove, settleOne, step, pageAt,
  };

  /** @returns {string} the name of a new gesture */
  function step() {
    steps += 1;
    return `word-${steps}`;
  }

  /** @param {number} index */
  function choose(index) {
    if (index !== marked.peek()) mode.value = null;
    marked.value = index;
  }

  /**
   * A new word on the panel that is chosen, else on the first that has none.
   * @param {Word['kind']} kind
   * @returns {Promise<boolean>} whether it is there
   */
  async function add(kind) {
    const page = store.page.peek();
    if (!page) return false;
    const busy = new Set(words.peek().map(({ panel }) => panel));
    const free = page.panels.findIndex((_, i) => !busy.has(i));
    const panel = selection.panels.peek()[0] ?? Math.max(0, free);
    const added = await addAll([{ kind, text: strings.wordSample[kind], panel, auto: true, ...(kind === 'effect' ? { angle: -8 } : {}) }]);
    if (added > 0) choose(words.peek().length - 1);
    return added > 0;
  }

  /** @param {Word[]} fresh @returns {Promise<number>} how many of them are on the page */
  async function addAll(fresh) {
    try {
      await ready();
    } catch (error) {
      failed(/** @type {Error} */ (error));
      return 0;
    }
    const page = store.page.peek();
    if (!page) return 0;
    const before = words.peek();
    const some = fresh.slice(0, Math.max(0, MOST.words - before.length)).map((word) => ({ ...word, text: bounded(word.text) }));
    if (some.length < fresh.length) messages.alert(strings.wordsFull(MOST.words));
    if (some.length === 0) return 0;
    const all = [...before, ...some];
    const places = some.map((_, i) => before.length + i);
    store.change({ type: 'change-page', page: settled({ ...page, words: all }, places) });
    return some.length;
  }

  /**
   * @param {number} index
   * @param {Partial<Word>} news
   * @param {string} [gesture]
   */
  function edit(index, news, gesture) {
    const page = store.page.peek();
    if (!page || !words.peek()[index]) return;
    const changed = words.peek().map((word, i) => (i === index ? { ...word, ...news } : word));
    store.change({ type: 'change-page', page: settled({ ...page, words: changed }, [index]), gesture });
  }

  /** @param {number} index @param {string} text nothing removes the word */
  function write(index, text) {
    const clean = bounded(text.trim()).trim();
    editing.value = -1;
    if (clean === '') remove(index);
    else if (clean !== words.peek()[index]?.text) edit(index, { text: clean });
  }

  /**
   * @param {number} index
   * @param {[number, number]} to its middle, in page widths
   * @param {string} [gesture]
   */
  function move(index, to, gesture) {
    const geometry = store.geometry.peek();
    const word = words.peek()[index];
    if (!geometry || !word) return;
    const tip = boxes.peek()[index]?.tip ?? null;
    edit(index, { ...anchored(geometry, word, to, tip), auto: false }, gesture);
  }

  /**
   * @param {number} index
   * @param {[number, number] | null} to in page widths; null takes the tail off
   * @param {string} [gesture]
   */
  function point(index, to, gesture) {
    const geometry = store.geometry.peek();
    const word = words.peek()[index];
    const box = boxes.peek()[index];
    if (!geometry || !word || !box) return;
    const middle = /** @type {[number, number]} */ ([box.x + box.width / 2, box.y + box.height / 2]);
    edit(index, { ...anchored(geometry, word, middle, to), auto: false }, gesture);
  }

  /** @param {number} index */
  function remove(index) {
    const page = store.page.peek();
    const word = words.peek()[index];
    if (!page || !word) return;
    choose(-1);
    editing.value = -1;
    store.change({ type: 'change-page', page: { ...page, words: words.peek().filter((_, i) => i !== index) } });
    messages.note(strings.wordRemoved(strings.word(word.kind, word.text)));
  }

  /** Lets a word find its place again. @param {number} index */
  function settleOne(index) {
    edit(index, { auto: true, width: null, size: 'auto' });
  }

  /**
   * @param {number} index
   * @returns {[number, number]} its middle, in page widths
   */
  function pageAt(index) {
    const box = boxes.peek()[index];
    const geometry = store.geometry.peek();
    if (box) return [box.x + box.width / 2, box.y + box.height / 2];
    const word = words.peek()[index];
    return geometry && word ? pagePoint(geometry, word, [word.x ?? 0.5, word.y ?? 0.5]) : [0.5, 0.5];
  }
}

/** @param {string} text @returns {string} as the core takes it */
function bounded(text) {
  return [...wellFormed(text).normalize('NFC')].slice(0, MOST.letters).join('');
}
