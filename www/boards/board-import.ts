/** Imports screenplays and tables into the shots of the board, as one step of the undo. */

import { readText } from '../engine/text-file.ts';
import { strings } from '../strings/strings.ts';
import { importText } from '../ui/encodings.ts';
import { importing } from '../ui/importing.ts';
import type { DecodedText } from '../engine/text-file.ts';
import type { Store } from '../document/store.ts';
import type { Messages } from '../ui/messages.ts';
import type { Boards } from './boards.ts';
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

async function take(file: File, { boards, store, messages }: App, encoding: string): Promise<DecodedText> {
  const { MAX_BYTES, fromFountain, fromTable, isFountain } = await import('./imports.ts').catch(() => {
    throw new UserError(strings.boards.missing);
  });
  if (file.size > MAX_BYTES) throw new UserError(strings.boards.tooLarge({ name: file.name }));
  const decoded = await readText(file, encoding);
  const { text } = decoded;
  const rows = boards.rows.peek();
  const names = new Map([...store.album.peek().values()].map(({ id, name }) => [id, name]));
  const isScript = /\.(fountain|spmd)$/i.test(file.name) || (/\.txt$/i.test(file.name) && isFountain(text));
  const imported = isScript
    ? fromFountain(text, rows)
    : fromTable(text, { rows, board: boards.board.peek(), headings: HEADINGS, names });
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
  return decoded;
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
