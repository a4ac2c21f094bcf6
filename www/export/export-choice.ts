/**
 * The choice of the export dialog: a kind of file, and a format of that kind. The browser remembers the choice, and it
 * does not depend on how many pages are exported.
 */

import { signal } from '@preact/signals';
import { LISTS } from './formats.ts';
import type { Format, Inside, Way } from './formats.ts';
import type { Signal } from '@preact/signals';

/**
 * The first choice. `board` has the sheets of the storyboard, `print` is a PDF file with bleed and marks, `more` has formats of
 * editing programs.
 */
export type Kind = 'board' | 'image' | 'pdf' | 'print' | 'comic' | 'video' | 'project' | 'more';
/** `ways` and `every`: the last format of each kind, and whether it has all pages; `inside`: the pictures of a CBZ file. */
export type Choice = {
  kind: Kind;
  ways: Partial<Record<Kind, Way>>;
  every: Partial<Record<Kind, boolean>>;
  inside: 'png' | 'jpeg';
};
export type ExportChoice = ReturnType<typeof createExportChoice>;

export const WAYS: Record<Kind, readonly Way[]> = {
  board: ['boardPdf', 'boardZip'],
  image: ['png', 'jpeg', 'webp'],
  pdf: ['pdf'],
  print: ['print'],
  comic: ['html', 'epub', 'cbz', 'strip'],
  video: ['animatic', 'motion'],
  project: ['project'],
  more: LISTS,
};
const ALL = Object.keys(WAYS) as readonly Kind[];
/** The kinds of files of the comic. The browser remembers only these. */
export const KINDS: readonly Kind[] = ALL.filter((kind) => kind !== 'board');

const KEY = 'inkpanel.export';
const FIRST: Choice = { kind: 'image', ways: {}, every: {}, inside: 'png' };
/** Documents of several pages. The other kinds begin with the current page. */
const DOCUMENTS: readonly Kind[] = ['pdf', 'print', 'comic'];

/** Returns the chosen format: the last one of the chosen kind, or its first one. */
export function wayOf({ kind, ways }: Choice): Way {
  return ways[kind] ?? WAYS[kind][0];
}

/**
 * Returns the choice that the dialog shows: the format that the user asked for, or the last one. A book begins with PDF if the
 * user has not chosen a format yet.
 */
export function shownChoice({ choice, asked }: Pick<ExportChoice, 'choice' | 'asked'>, isBook: boolean): Choice {
  const way = asked.value ?? (isBook && choice.value === FIRST ? 'pdf' : null);
  return way ? withWay(choice.value, way) : choice.value;
}

/** Returns whether all pages are exported: the last choice of the user for this kind, or its default. */
export function hasAll({ kind, every }: Choice): boolean {
  return every[kind] ?? DOCUMENTS.includes(kind);
}

/** Returns the choice with all pages or only the current page. */
export function withAll(choice: Choice, all: boolean): Choice {
  return { ...choice, every: { ...choice.every, [choice.kind]: all } };
}

/** Returns the choice with another format. */
export function withWay(choice: Choice, way: Way): Choice {
  const kind = ALL.find((one) => WAYS[one].includes(way)) ?? choice.kind;
  return { ...choice, kind, ways: { ...choice.ways, [kind]: way } };
}

/**
 * Returns the format of the file, and of the pictures in an archive. Images of several pages are a ZIP file.
 * Videos and projects have dialogs and files that do not depend on it.
 */
export function madeOf(way: Way, all: boolean, inside: Inside): { format: Format; inside: Inside } {
  if (way === 'animatic' || way === 'motion' || way === 'project') return { format: 'png', inside };
  if (way === 'print' || way === 'boardPdf') return { format: 'pdf', inside };
  if (way === 'boardZip') return { format: 'zip', inside: 'png' };
  if (way === 'strip') return { format: 'zip', inside: 'jpeg' };
  if (all && (way === 'png' || way === 'jpeg' || way === 'webp')) return { format: 'zip', inside: way };
  return { format: way, inside };
}

/** @param box may throw if the browser denies storage. The choice then lasts until the app is closed. */
export function createExportChoice(box: () => Pick<Storage, 'getItem' | 'setItem'>) {
  const choice = signal(read(box));
  const asked: Signal<Way | null> = signal(null);
  return {
    choice,
    /** The format that the user opened the dialog for. */
    asked,
    /** The next dialog begins with this choice, except with the storyboard, which is a choice of its view. */
    choose(next: Choice) {
      if (next.kind === 'board') {
        asked.value = wayOf(next);
        return;
      }
      asked.value = null;
      choice.value = next;
      try {
        box().setItem(KEY, JSON.stringify(next));
      } catch {
        // Storage is blocked or full, so the choice lasts until the app closes.
      }
    },
  };
}

function read(box: () => Pick<Storage, 'getItem'>): Choice {
  try {
    const text = box().getItem(KEY);
    if (text === null) return FIRST;
    const { kind, ways, every, inside } = JSON.parse(text);
    return {
      kind: KINDS.includes(kind) ? kind : FIRST.kind,
      ways: Object.fromEntries(
        Object.entries(ways ?? {}).filter(([key, way]) => WAYS[key as Kind]?.includes(way as Way)),
      ),
      every: Object.fromEntries(
        Object.entries(every ?? {}).filter(([key, all]) => KINDS.includes(key as Kind) && typeof all === 'boolean'),
      ),
      inside: inside === 'jpeg' ? 'jpeg' : 'png',
    };
  } catch {
    return FIRST;
  }
}
