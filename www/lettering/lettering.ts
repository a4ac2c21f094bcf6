/**
 * Manual lettering: adding, editing, moving and removing text items, and pointing their tails. Each edit is one undo
 * step. The core places the other text items again whenever the page changes, so that they hide no face.
 */

import { computed, effect, signal, untracked } from '@preact/signals';
import { language, strings } from '../strings/strings.ts';
import { MOST, wellFormed } from '../document/limits.ts';
import { noteUntilUndo } from '../ui/undo-note.ts';
import { TITLE_FONT, roleOf, wordName } from '../document/word-names.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { chainOf, hangsOn, joinedBefore, parted } from './joining.ts';
import { anchored, pagePoint } from './word-places.ts';
import { createWordPlanning, setWords } from './word-planning.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument, Word, WordBox } from '../engine/types.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Engine } from '../engine/engine.ts';
import type { Signal } from '@preact/signals';

/** Allowed widths of text items, in page widths. */
const [NARROWEST, WIDEST] = [0.04, 0.96];

/** A new title: as wide as the page, in the font of a book's title, and at the top of the page if no face is there. */
const TITLE: Partial<Word> = { font: TITLE_FONT, boxless: true, size: 0.1, width: WIDEST };

/** Maximum number of letters of a text whose place is searched at each key, and when the user pauses. */
const [MOST_SEARCHED, MOST_SEARCHED_AT_REST] = [150, 600];
/** An edited text item belongs to the user: neither Shuffle nor a new book replaces it. */
const BY_HAND = { made: undefined, book: undefined, number: undefined };

export type Lettering = ReturnType<typeof createLettering>;
/** A text item that is added to pages: to a panel of the page `sheet` if it is set, otherwise to its photo. */
export type AddedWord = Word & { sheet?: number; joins?: boolean };
/** The purpose of the next click on the page. */
export type Mode = 'move' | 'tail';

/** @param app `load`: loads the glyphs */
export function createLettering({
  store,
  messages,
  selection,
  load,
  scheduler,
}: {
  store: Store;
  messages: Pick<Messages, 'list' | 'alert' | 'note' | 'close'>;
  selection: Pick<import('../page/panels/selection.ts').Selection, 'panels'>;
  load: Engine['lettering'];
  scheduler: Scheduler;
}) {
  const planning = createWordPlanning({ store, messages, load, scheduler });
  const { words, letters, ready, settled } = planning;
  const boxes = computed(() => {
    const page = store.page.value;
    return page && letters.value && words.value.length > 0 ? letters.value.measure(page) : [];
  });
  /** The indices of the text items in reading order. */
  const reading = computed(() => {
    const turn = (index: number) => boxes.value[index]?.turn ?? index;
    return [...words.value.keys()].sort((a, b) => turn(a) - turn(b));
  });
  const marked = signal(-1);
  /** The selected text item. */
  const chosen = computed(() => (marked.value < words.value.length ? marked.value : -1));
  /** The panel that the user selected for the last added text. */
  let target: number | undefined;
  /** The text item that is being edited. */
  const editing = signal(-1);
  /** Its text in the field. The page has it after the edit. */
  const typed = signal('');
  /** The page after the last search for the place of this text. */
  let searched: PageDocument | null = null;
  /** The page with this text, for drawing; null if the text did not change. */
  const draft = signal<PageDocument | null>(null);
  effect(() => {
    typed.value = untracked(() => words.value)[editing.value]?.text ?? '';
    searched = null;
    draft.value = null;
  });
  const mode: Signal<Mode | null> = signal(null);
  /** Words of photos that no page shows. */
  const waiting = computed(() => store.project.value.waiting ?? []);
  let steps = 0;
  /** The last added text item until its first text, which belongs to its undo step. */
  let latest: { index: number; gesture: string } | null = null;

  return {
    words,
    boxes,
    reading,
    chosen,
    editing,
    typed,
    draft,
    textOf,
    mode,
    rested: planning.rested,
    loading: planning.loading,
    ready,
    settled,
    cleared: planning.cleared,
    on: planning.on,
    choose,
    add,
    addAll,
    lay,
    reword,
    waiting,
    take,
    drop,
    edit,
    write,
    move,
    point,
    resize,
    turn,
    alike,
    match,
    join,
    reorder,
    measured,
    foreign: (text: string) => letters.value?.foreign(text) ?? false,
    missing: (text: string, font: string) => letters.value?.missing(text, font) ?? '',
    remove,
    settleOne,
    step,
    typingStep,
    pageAt,
  };

  /** The text of an item, as far as it is typed. */
  function textOf(index: number): string {
    return index === editing.value ? typed.value : words.value[index].text;
  }

  /**
   * Returns the box that a text item would have after its text changed; null without glyphs. A search takes too long for long
   * texts at each key, so their box is at the last place that was found. Sets the draft to the page with this text.
   * @param isAtRest whether the user pauses
   */
  function measured(index: number, text: string, isAtRest = false): WordBox | null {
    const clean = bounded(text);
    const page = retyped(index, clean, isAtRest);
    draft.value = clean === words.peek()[index]?.text ? null : page;
    return boxOn(page, index);
  }

  function retyped(index: number, clean: string, isAtRest: boolean): PageDocument | null {
    if (clean.length <= (isAtRest ? MOST_SEARCHED_AT_REST : MOST_SEARCHED)) {
      searched = rewritten(index, clean);
      return searched;
    }
    const page = searched ?? edited(index, {}, true);
    return page && { ...page, words: page.words?.map((word, i) => (i === index ? { ...word, text: clean } : word)) };
  }

  function boxOn(page: PageDocument | null, index: number): WordBox | null {
    return (page && letters.peek()?.measure(page)[index]) ?? null;
  }

  /** Sets the text items of the page, and places some of them. */
  function setPage(page: PageDocument, placed: readonly number[], gesture?: string) {
    put(settled(page, placed), gesture);
  }

  function put(page: PageDocument | null, gesture?: string) {
    if (page) setWords(store, [{ at: store.project.peek().at, page }], { gesture });
  }

  /** @returns the name of a new gesture */
  function step(): string {
    steps += 1;
    return `word-${steps}`;
  }

  /** @returns the gesture in which the user types the text of an item. The first text of a new item joins its step. */
  function typingStep(index: number): string {
    const first = latest?.index === index ? latest.gesture : null;
    latest = null;
    return first ?? step();
  }

  function choose(index: number) {
    if (index !== marked.peek()) mode.value = null;
    marked.value = index;
  }

  /** @returns whether a new text item is there */
  async function add(role: Word['kind'] | 'title'): Promise<boolean> {
    const page = store.page.peek();
    if (!page) return false;
    const text = strings.wordSample[role];
    const item: Word =
      role === 'title' ? { ...TITLE, kind: 'caption', text, auto: true } : { ...onPanel(role, page), text };
    const gesture = step();
    if ((await addAll([item], gesture)) === 0) return false;
    const index = words.peek().length - 1;
    latest = { index, gesture };
    choose(index);
    return true;
  }

  /**
   * A new text item on the selected panel. Another one goes to the same panel while the first is chosen. Without a
   * selection, it goes to the first panel without text.
   */
  function onPanel(kind: Word['kind'], page: PageDocument): Omit<Word, 'text'> {
    const busy = new Set(words.peek().map(({ panel }) => panel));
    const free = page.panels.findIndex((_, i) => !busy.has(i));
    // The panel of the chosen text, if the user selected that panel for it.
    const again = target === words.peek()[chosen.peek()]?.panel ? target : undefined;
    target = selection.panels.peek()[0] ?? again;
    const panel = target ?? Math.max(0, free);
    return { kind, panel, photo: photoOn(page, panel), auto: true, ...(kind === 'effect' ? { angle: -8 } : {}) };
  }

  /** @returns number of added items on the page */
  async function addAll(fresh: Word[], gesture?: string): Promise<number> {
    if (!(await ready())) return 0;
    const page = store.page.peek();
    if (!page) return 0;
    const before = words.peek();
    const some = fresh
      .slice(0, Math.max(0, MOST.words - before.length))
      .map((word): Word => ({ language, ...word, text: bounded(word.text) }));
    if (some.length < fresh.length) messages.alert(strings.wordsFull({ most: MOST.words }));
    if (some.length === 0) return 0;
    const all = [...before, ...some];
    const places = some.map((_, i) => before.length + i);
    setPage({ ...page, words: all }, places, gesture);
    return some.length;
  }

  /**
   * Adds text items to all pages in one step. Items without a page or without space are unplaced. Existing items are
   * not added again.
   * @returns the number of added text items on pages and in the list of unplaced text
   */
  function lay(fresh: readonly AddedWord[], gesture?: string): { shown: number; waiting: number } {
    const count = () => ({
      shown: store.sheets.peek().reduce((sum, page) => sum + (page.words?.length ?? 0), 0),
      waiting: waiting.peek().length,
    });
    const before = count();
    // The language of a video may differ from the language of the page, so its words are not hyphenated.
    const laid = fresh.slice(0, MOST.added).map((word): AddedWord => ({ ...word, text: bounded(word.text) }));
    store.change({ type: 'add-words', words: laid, ...(gesture && { gesture }) });
    const after = count();
    return { shown: after.shown - before.shown, waiting: after.waiting - before.waiting };
  }

  /**
   * Replaces texts on all pages and in the list of unplaced text. Items with other texts do not change.
   * @param texts new texts by their old ones; an empty text deletes its items
   * @returns number of changed items
   */
  function reword(texts: ReadonlyMap<string, string>, gesture: string): number {
    let count = 0;
    const reworded = <One extends { text: string }>(list: readonly One[]): One[] => {
      const all = list.map((word) => {
        const text = texts.get(word.text);
        if (text === undefined || text === word.text) return word;
        count += 1;
        return { ...word, text: bounded(text) };
      });
      return all.filter(({ text }) => text !== '');
    };
    const project = store.project.peek();
    const pages = sheetsOf(project).flatMap(({ page }, at) => {
      const before = count;
      const words = reworded(page.words ?? []);
      return count === before ? [] : [{ at, words }];
    });
    if (count > 0) store.change({ type: 'set-words', pages, gesture });
    const onPages = count;
    const unplaced = waiting.peek();
    const kept = reworded(unplaced);
    if (count > onPages) {
      store.change({ type: 'drop-waiting', words: unplaced.map((_, i) => i), gesture });
      store.change({ type: 'add-words', words: kept, gesture });
    }
    return count;
  }

  /** Places an unplaced text item on the page. It belongs to the photo of the selected panel, or of the first one. */
  function take(index: number) {
    const page = store.page.peek();
    const word = waiting.peek()[index];
    if (!page || !word) return;
    const gesture = step();
    const panel = selection.panels.peek()[0] ?? 0;
    store.change({ type: 'drop-waiting', words: [index], gesture });
    const all = [...words.peek(), { ...word, panel, photo: photoOn(page, panel) }];
    setPage({ ...page, words: all }, [all.length - 1], gesture);
    choose(all.length - 1);
  }

  /** Deletes unplaced text items. */
  function drop(indices: readonly number[]) {
    store.change({ type: 'drop-waiting', words: [...indices] });
  }

  /** @param stays whether it keeps its place */
  function edit(index: number, news: Partial<Word>, gesture?: string, stays?: boolean) {
    put(edited(index, news, stays), gesture);
  }

  /** Returns the page after an edit. */
  function edited(index: number, news: Partial<Word>, stays = news.auto === false): PageDocument | null {
    const page = store.page.peek();
    if (!page || !words.peek()[index]) return null;
    // Shuffle does not replace edited text.
    const changed = words.peek().map((word, i) => (i === index ? { ...word, ...news, ...BY_HAND } : word));
    const next = { ...page, words: changed };
    // A text item that the user moves has a fixed position. Others stay where they are, or as close as possible. Vertical text
    // and another shape need other room.
    const box = boxes.peek()[index];
    const chain = chainOf(changed, index);
    const isReshaped = news.vertical !== undefined || news.shape !== undefined;
    const isPlaced = stays || news.auto || isReshaped || !box;
    const stayed = isPlaced ? null : planning.stayed(next, index, box, chain.length === 1);
    // Otherwise all balloons of its chain are placed again.
    return stayed ?? settled(next, stays ? [] : chain);
  }

  /** Indices of the other text items with the role of one. */
  function alike(index: number): number[] {
    const role = words.value[index] && roleOf(words.value[index]);
    return words.value.flatMap((word, i) => (i !== index && roleOf(word) === role ? [i] : []));
  }

  /** Gives the font and the letter size of a text item to the others with its role. Automatic items are placed again. */
  function match(index: number, gesture?: string) {
    const page = store.page.peek();
    const box = boxes.peek()[index];
    if (!page || !box) return;
    const others = alike(index);
    const look = { font: words.peek()[index].font, size: rounded(box.size), ...BY_HAND };
    const all = words.peek().map((word, i) => (i === index || others.includes(i) ? { ...word, ...look } : word));
    setPage({ ...page, words: all }, others, gesture);
  }

  /** Links a balloon to the previous one on its panel, or removes its link. */
  function join(index: number, on: boolean) {
    const page = store.page.peek();
    if (!page || !words.peek()[index]) return;
    const before = words.peek();
    const changed = on ? joinedBefore(before, index) : parted(before, index);
    const free = [...new Set([...chainOf(before, index), ...chainOf(changed, index)])];
    setPage({ ...page, words: changed }, free);
  }

  /**
   * Moves a text item in the reading order. It is placed again, on the panel of the items around its new place.
   * @param to its place after removal
   */
  function reorder(from: number, to: number) {
    const page = store.page.peek();
    const order = [...reading.peek()];
    if (!page || from === to || order[from] === undefined || order[to] === undefined) return;
    const [index] = order.splice(from, 1);
    order.splice(to, 0, index);
    const all = unlinked(index);
    const panelOf = (at: number) => all[order[at]]?.panel ?? null;
    const [own, before, after] = [panelOf(to), to - 1, to + 1];
    const stays = [before, after].some((at) => order[at] !== undefined && panelOf(at) === own);
    const panel = stays ? own : panelOf(to < from ? after : before);
    const moved = { ...all[index], ...BY_HAND, auto: true, panel, photo: photoOn(page, panel ?? -1) };
    const words = order.map((other) => (other === index ? moved : all[other]));
    const free = words.flatMap(({ auto, panel: its = null }, i) =>
      auto !== false && (its === own || its === panel) ? [i] : [],
    );
    setPage({ ...page, words }, free);
    choose(to);
  }

  /** The text items of the page without the links of one of them. */
  function unlinked(index: number): Word[] {
    const all = words.peek();
    const linked = all.flatMap((_, i) =>
      hangsOn(all, i) === index || (i === index && hangsOn(all, i) >= 0) ? [i] : [],
    );
    return all.map((word, i) => (linked.includes(i) ? { ...word, joined: null, linked: null } : word));
  }

  /** @param text an empty text deletes the item */
  function write(index: number, text: string, gesture?: string) {
    const clean = bounded(text.trim()).trim();
    editing.value = -1;
    if (clean === '') remove(index);
    else if (clean !== words.peek()[index]?.text) put(rewritten(index, clean), gesture);
  }

  /** Returns the page after the text of an item changed. */
  function rewritten(index: number, text: string): PageDocument | null {
    const news = { text, located: undefined };
    const inPlace = edited(index, news, true);
    const [before, after] = [boxes.peek()[index], boxOn(inPlace, index)];
    const hasSize = !!before && !!after && before.width === after.width && before.height === after.height;
    return hasSize ? inPlace : edited(index, news);
  }

  /** @param to its middle, in page widths */
  function move(index: number, to: [number, number], gesture?: string) {
    const geometry = store.geometry.peek();
    const word = words.peek()[index];
    if (!geometry || !word) return;
    const tip = boxes.peek()[index]?.tip ?? null;
    const held = word.linked ? { joined: word.linked, linked: null } : {};
    edit(index, { ...onPhoto(anchored(geometry, word, to, tip)), ...held, auto: false }, gesture);
  }

  /** @param to in page widths; null removes the tail */
  function point(index: number, to: [number, number] | null, gesture?: string) {
    const geometry = store.geometry.peek();
    const word = words.peek()[index];
    const box = boxes.peek()[index];
    if (!geometry || !word || !box) return;
    const middle = [box.x + box.width / 2, box.y + box.height / 2] as [number, number];
    edit(index, { ...onPhoto(anchored(geometry, word, middle, to)), auto: false }, gesture);
  }

  /** @param width of its box, in page widths */
  function resize(index: number, width: number, gesture?: string) {
    edit(index, { width: rounded(Math.min(WIDEST, Math.max(NARROWEST, width))) }, gesture);
  }

  /** @param angle of an effect in degrees, clockwise, whatever turn it is of */
  function turn(index: number, angle: number, gesture?: string) {
    edit(index, { angle: rounded(((((angle + 180) % 360) + 360) % 360) - 180) }, gesture);
  }

  /** A text item belongs to the photo below it. */
  function onPhoto(place: Partial<Word>): Partial<Word> {
    const page = store.page.peek();
    return { ...place, photo: page ? photoOn(page, place.panel ?? -1) : null };
  }

  function remove(index: number) {
    const page = store.page.peek();
    const word = words.peek()[index];
    if (!page || !word) return;
    choose(-1);
    editing.value = -1;
    const all = words.peek();
    // Balloons that were linked to it have separate tails again.
    const orphans = all.flatMap((_, i) => (hangsOn(all, i) === index ? [i - Number(i > index)] : []));
    setPage({ ...page, words: unlinked(index).filter((_, i) => i !== index) }, orphans);
    noteUntilUndo({ messages, store }, strings.wordRemoved({ name: wordName(word) }));
  }

  /** Places a text item automatically again. */
  function settleOne(index: number) {
    edit(index, { auto: true, width: null, size: 'auto' });
  }

  /** @returns its middle, in page widths */
  function pageAt(index: number): [number, number] {
    const box = boxes.peek()[index];
    const geometry = store.geometry.peek();
    if (box) return [box.x + box.width / 2, box.y + box.height / 2];
    const word = words.peek()[index];
    return geometry && word ? pagePoint(geometry, word, [word.x ?? 0.5, word.y ?? 0.5]) : [0.5, 0.5];
  }
}

function rounded(number: number): number {
  return Math.round(number * 1e4) / 1e4;
}

function photoOn({ panels }: PageDocument, panel: number): string | null {
  return panels[panel]?.photo ?? null;
}

/** @returns the text, limited to the maximum of the core */
function bounded(text: string): string {
  return [...wellFormed(text).normalize('NFC')].slice(0, MOST.letters).join('');
}
