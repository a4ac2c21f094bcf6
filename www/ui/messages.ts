/**
 * Messages of the app. Serious problems come first and stay until they are solved or closed. Alerts and offers stay
 * until they are closed. Notes disappear automatically. Files that are damaged, cannot be read, or are skipped share one
 * message. If there are many, it has a list.
 */

import { batch, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { byName } from './by-name.ts';
import { after, createTimer } from '../engine/scheduler.ts';
import type { Signal } from '@preact/signals';

/** An action of a message; it closes the message unless it `stays`. */
export type Way = { label: string; run: () => void; stays?: boolean };
/** `grave`: work or photos are lost unless the user acts. */
type Kind = 'grave' | 'alert' | 'offer' | 'note';
/** `more`: another way; `near`: it is about files, and appears at the button that chose them */
export type Message = { id: number; kind: Kind; text: string; way?: Way; more?: Way; near?: boolean };
/** a file with a problem; `text` is the message for a single file; `isUsed`: the readable part is used */
type Failure = { name: string; why: string; text: string; way?: Way; isUsed?: boolean };
export type Messages = ReturnType<typeof createMessages>;

const NOTE_MS = 4_000;
/** Milliseconds to find and press the button. */
const WAY_MS = 12_000;
/** Maximum number of messages. Serious problems do not count. */
const MOST = 24;
/** Kinds that are removed first if there are too many. */
const GIVES_WAY: readonly Kind[] = ['note', 'alert', 'offer'];
/** Files of the list; beyond it they are counted. */
export const MOST_NAMED = 2_000;
/** Time in ms to collect failed files into one message. */
const GATHER_MS = 400;
/** Minimum interval in ms for updates of the count, because screen readers announce each update. */
const COUNT_MS = 2_000;

export function createMessages() {
  /** In order of appearance. */
  const list: Signal<readonly Message[]> = signal([]);
  /** Files with problems. */
  const failures: Signal<readonly Failure[]> = signal([]);
  /** How many more there are. */
  const unnamed = signal(0);
  /** Whether the list of those files is open. */
  const listed = signal(false);
  const listWay: Way = {
    label: strings.showList,
    run: () => {
      listed.value = true;
    },
    stays: true,
  };
  let last = 0;
  /** The message about those files; 0 without one. */
  let summary = 0;
  /** All of them, by name and reason. */
  let failed: Map<string, Failure> = new Map();
  let beyond = 0;
  /** How many files were skipped on purpose. */
  let skipped = 0;
  /** The note about skipped files, until a file with a problem is reported. */
  let skipNote = 0;
  /** Whether no file of the last ones could be used. */
  let isNothingUsed = false;
  const telling = createTimer();

  /** @returns to close it by */
  function say(kind: Kind, text: string, way?: Way, more?: Way, near = false): number {
    last += 1;
    const id = last;
    const others = list.value.filter(
      (message) => message.text !== text && (kind !== 'note' || message.kind !== 'note'),
    );
    list.value = bounded([...others, { id, kind, text, way, more, near }]);
    if (kind === 'note') after(way ? WAY_MS : NOTE_MS, () => close(id));
    return id;
  }

  /**
   * Updates a message in its place.
   * @returns whether it is still there
   */
  function change(id: number, text: string, way?: Way, more?: Way): boolean {
    const there = list.value.some((message) => message.id === id);
    if (there)
      list.value = list.value.map((message) => (message.id === id ? { ...message, text, way, more } : message));
    return there;
  }

  function close(id: number) {
    batch(() => {
      list.value = list.value.filter((message) => message.id !== id);
      if (id === summary && summary > 0) forgetFiles();
    });
  }

  /** Alerts about failures of a repeated task. They disappear when the task succeeds, or when the user closes them. */
  function alertGroup() {
    const ids: Set<number> = new Set();
    return {
      report: (text: string) => void ids.add(say('alert', text)),
      clear() {
        if (ids.size === 0) return;
        list.value = list.value.filter(({ id }) => !ids.has(id));
        ids.clear();
      },
    };
  }

  function forgetFiles() {
    telling.stop();
    [summary, beyond, skipped, isNothingUsed] = [0, 0, 0, false];
    failed = new Map();
    failures.value = [];
    unnamed.value = 0;
    listed.value = false;
  }

  /**
   * A file with a problem. It is added to the existing message.
   * @param how `text`: the message for a single file; `isUsed`: the readable part of the file is used
   */
  function fileFailed(
    name: string,
    why: string,
    { text = strings.fileFailed({ name, why }), way, isUsed }: Partial<Omit<Failure, 'name' | 'why'>> = {},
  ) {
    const key = `${name}\n${why}`;
    if (failed.size >= MOST_NAMED && !failed.has(key)) beyond += 1;
    else failed.set(key, { name, why, text, way, isUsed });
    if (telling.runs) return;
    tellOfFiles();
    telling.start(GATHER_MS, tellOfFiles);
  }

  function tellOfFiles() {
    const all = byName([...failed.values()]);
    const count = all.length + beyond;
    const fresh = count > failures.peek().length + unnamed.peek();
    if (!fresh) return;
    telling.start(COUNT_MS, tellOfFiles);
    batch(() => {
      failures.value = all;
      unnamed.value = beyond;
      showSummary();
    });
  }

  function showSummary() {
    const [first] = failures.peek();
    const count = failures.peek().length + unnamed.peek();
    const text = summaryOf(count === 1 ? first.text : undefined);
    const way = count > 1 ? listWay : first?.way;
    close(skipNote);
    if (text === '') close(summary);
    else if (!change(summary, text, way)) summary = say('alert', text, way, undefined, true);
  }

  /** @param single the text about a single file */
  function summaryOf(single?: string): string {
    const used = failures.peek().filter(({ isUsed }) => isUsed).length;
    const unread = failures.peek().length + unnamed.peek() - used;
    return [
      isNothingUsed ? strings.noUsablePhoto : (single ?? (unread > 0 && strings.filesFailed({ n: unread }))),
      single === undefined && used > 0 && strings.filesDamaged({ n: used }),
      skipped > 0 && strings.filesSkipped({ n: skipped }),
    ]
      .filter(Boolean)
      .join(' ');
  }

  /** Files that no person wants to add. */
  function filesSkipped(n: number) {
    skipped += n;
    if (summary > 0) showSummary();
    else skipNote = say('note', strings.filesSkipped({ n: skipped }));
  }

  /** @param isNone whether no file of a drop could be used */
  function noneUsed(isNone: boolean) {
    if (isNone === isNothingUsed) return;
    isNothingUsed = isNone;
    tellOfFiles();
    if (summary > 0 || isNone) showSummary();
  }

  /** Closes the notes about a page when another page is shown. */
  function leaveNotes() {
    list.value = list.value.filter(({ kind, way }) => kind !== 'note' || !way);
  }

  return {
    list,
    leaveNotes,
    failures,
    unnamed,
    listed,
    /** Work or photos are lost unless the user acts. */
    grave: (text: string, way?: Way, more?: Way) => say('grave', text, way, more),
    alert: (text: string, way?: Way, more?: Way) => say('alert', text, way, more),
    note: (text: string, way?: Way, more?: Way) => say('note', text, way, more),
    /** An action for now or later. */
    offer: (text: string, way?: Way) => say('offer', text, way),
    alertGroup,
    fileFailed,
    filesSkipped,
    noneUsed,
    change,
    close,
  };
}

/** @returns as many as there may be */
function bounded(messages: Message[]): Message[] {
  const left = [...messages];
  while (left.length > MOST) {
    const kind = GIVES_WAY.find((one) => left.some((message) => message.kind === one));
    if (kind === undefined) break;
    left.splice(
      left.findIndex((message) => message.kind === kind),
      1,
    );
  }
  return left;
}
