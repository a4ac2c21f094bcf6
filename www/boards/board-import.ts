/** Imports screenplays and tables into the shots of the board, as one step of the undo. */

import { readText } from '../engine/text-file.ts';
import { strings } from '../strings/strings.ts';
import { importText } from '../ui/encodings.ts';
import type { ImportedText } from '../ui/encodings.ts';
import { importing } from '../ui/importing.ts';
import type { Store } from '../document/store.ts';
import type { Messages } from '../ui/messages.ts';
import type { Boards } from './boards.ts';
import type { ShotRow } from './shots.ts';
import type { Board, Shot } from '../engine/types.ts';
import { HEADINGS } from './headings.ts';
import { UserError } from '../ui/user-error.ts';
import type { Imported } from './imports.ts';

/** Maximum number of lost lines or cells that a message names, and of characters of each. */
const MAX_NAMED = 12;
const MAX_NAME = 60;

type App = {
  boards: Pick<Boards, 'board' | 'rows' | 'change' | 'describe'>;
  store: Pick<Store, 'album' | 'change' | 'project'>;
  messages: Pick<Messages, 'alert' | 'note' | 'fileFailed'>;
};

/** Fills the shots from a file, and reports filled and lost fields. */
export async function importShots(file: File, app: App) {
  await importing(app.messages, file.name, () => importText(file, app, (encoding) => take(file, app, encoding)));
}

/** The shots and the settings before an import, and the imported data. */
type Before = { rows: readonly ShotRow[]; board: Board; imported: Imported };

/** @param before the import whose texts are replaced */
async function take(file: File, app: App, encoding: string, before?: Before): Promise<ImportedText> {
  const { boards, store, messages } = app;
  const { MAX_BYTES, fromFountain, fromTable, isFountain } = await import('./imports.ts').catch(() => {
    throw new UserError(strings.boards.missing);
  });
  if (file.size > MAX_BYTES) throw new UserError(strings.boards.tooLarge({ name: file.name }));
  const decoded = await readText(file, encoding);
  const { text } = decoded;
  const rows = before?.rows ?? boards.rows.peek();
  const board = before?.board ?? boards.board.peek();
  const names = new Map([...store.album.peek().values()].map(({ id, name }) => [id, name]));
  const isScript = /\.(fountain|spmd)$/i.test(file.name) || (/\.txt$/i.test(file.name) && isFountain(text));
  const imported = isScript ? fromFountain(text, rows) : fromTable(text, { rows, board, headings: HEADINGS, names });
  const amend = (other: string) => take(file, app, other, { rows, board, imported });
  if (before) {
    messages.note(strings.textReplaced({ n: replace(before.imported, imported, app) }));
    return { decoded, amend };
  }
  const { shots, columns } = imported;
  const count = Object.keys(shots).length;
  if (count > 0) {
    // The columns and their cells are one step.
    const gesture = `import ${performance.now()}`;
    if (columns.length > 0) boards.change({ columns: [...boards.board.peek().columns, ...columns] }, gesture);
    boards.describe(shots, gesture);
  }
  const losses = lossesOf(imported);
  const done =
    count > 0 ? strings.boards.taken({ count, name: file.name }) : strings.boards.nothingIn({ name: file.name });
  if (count > 0 && losses.length === 0) messages.note(done);
  else messages.alert(strings.sentences([done, ...losses]));
  return { decoded, amend };
}

/**
 * Replaces the fields of an import by the fields of a new import. Fields that the user edited stay. It is one undo step.
 * @returns number of replaced fields
 */
function replace(was: Imported, now: Imported, { boards }: App): number {
  const gesture = `import ${performance.now()}`;
  let count = 0;
  /** @returns the value that a field has afterwards */
  const next = <T>(here: T, old: T, fresh: T): T => {
    if (here !== old || old === fresh) return here;
    count += 1;
    return fresh;
  };
  const { columns } = boards.board.peek();
  const rows = boards.rows.peek();
  const renamed = new Map(was.columns.map((name, i) => [name, now.columns[i]]));
  const named = columns.flatMap((name) => (renamed.has(name) ? (renamed.get(name) ?? []) : name));
  const fresh = now.columns.filter((name) => !named.includes(name));
  if (was.columns.join('\n') !== now.columns.join('\n')) boards.change({ columns: [...named, ...fresh] }, gesture);
  const shots = rows.flatMap(({ id, shot }) => {
    const [old, other] = [was.shots[id] ?? {}, now.shots[id] ?? {}];
    const before = count;
    const fields = [...new Set([...Object.keys(old), ...Object.keys(other)])].filter((field) => field !== 'more');
    const told = fields.map((field) => {
      const of = (one: Shot) => one[field as 'action'];
      return [field, next(of(shot), of(old), of(other))] as const;
    });
    const own = Object.keys(other.more ?? {}).filter((name) => !now.columns.includes(name));
    const names = new Set([...Object.keys(shot.more ?? {}), ...Object.keys(old.more ?? {}), ...own]);
    const cells = [...names].flatMap((name) => {
      const to = renamed.get(name) ?? name;
      const cell = next(shot.more?.[name], old.more?.[name], other.more?.[to]);
      return cell === undefined ? [] : [[to, cell] as const];
    });
    if (count === before && renamed.size === 0) return [];
    const more = Object.fromEntries(cells);
    const whole = { ...shot, ...Object.fromEntries(told), more };
    const kept = Object.entries(whole).filter(
      ([, value]) => value !== undefined && (value !== more || cells.length > 0),
    );
    return [[id, Object.fromEntries(kept) as Shot] as const];
  });
  boards.describe(Object.fromEntries(shots), gesture);
  return count;
}

/** Returns a sentence for each kind of loss. */
function lossesOf({ lost, cells, beyond }: Imported): string[] {
  const { left, cellsLeft, columnsLeft } = strings.boards;
  return [
    ...(lost.length > 0 ? [left({ count: lost.length, lines: named(lost) })] : []),
    ...(cells.length > 0 ? [cellsLeft({ count: cells.length, cells: named(cells) })] : []),
    ...(beyond.length > 0 ? [columnsLeft({ columns: named(beyond) })] : []),
  ];
}

function named(texts: readonly string[]): string {
  const shown = texts.slice(0, MAX_NAMED).map((text) => {
    const short = text.length > MAX_NAME ? `${text.slice(0, MAX_NAME)}…` : text;
    return strings.boards.quoted({ text: short.replace(/\s+/g, ' ') });
  });
  const more = texts.length - shown.length;
  return more > 0 ? `${shown.join(', ')} ${strings.moreFiles({ n: more })}` : strings.listed(shown);
}
