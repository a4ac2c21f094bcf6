/**
 * Shots read from files: screenplays in Fountain, and tables with commas, semicolons or tabs. Loaded with the first file, as is
 * the library that reads tables.
 */

// Quotes, line ends and delimiters of cells, as RFC 4180 and spreadsheets have them.
import Papa from 'papaparse';
import { wellFormed } from '../document/limits.ts';
import { MOST } from '../engine/bounds.ts';
import type { Board, Shot } from '../engine/types.ts';
import { fountainLines } from './fountain.ts';
import type { Field, ShotRow, Spoken } from './shots.ts';
import { lengthOf, USUAL_SECONDS, withColumn, withField } from './shots.ts';

export { isFountain } from './fountain.ts';

/**
 * The result of an import: shots by the ids of their photos, and new columns. Unused data: `lost` lines match no shot,
 * `cells` were left out or shortened, `beyond` are columns beyond the maximum of the board.
 */
export type Imported = {
  shots: Record<string, Shot>;
  columns: string[];
  lost: string[];
  cells: string[];
  beyond: string[];
};

/** Maximum size of a file in bytes. */
export const MAX_BYTES = 5_000_000;
/** Begins a cell that a spreadsheet would take for a formula, see `crates/engine/src/output/shots/csv.rs`. */
const GUARDED = /^'(?='*[=+\-@\t\r])/;
/** The line with which Excel names the delimiter. */
const DELIMITER = /^"?sep=(.)"?[,;\t]*(?:\r\n|\r|\n|$)/i;

/** Puts the paragraphs of a screenplay on shots, one per shot. */
export function fromFountain(text: string, rows: readonly ShotRow[]): Imported {
  const cells: string[] = [];
  const lines = fountainLines(text).map((line) => {
    const fields = Object.entries(line).map(([field, told]) => {
      const fitting = fitted(told, field === 'scene' ? MOST.label : MOST.field);
      if (fitting.cut) cells.push(told);
      return [field, fitting.text] as const;
    });
    return Object.fromEntries(fields.filter(([, told]) => told)) as Shot;
  });
  const shots = rows.slice(0, lines.length).map(({ id, shot }, i) => [id, { ...shot, ...lines[i] }] as const);
  const lost = lines.slice(rows.length).map(({ scene, action, dialogue }) => action ?? dialogue ?? scene ?? '');
  return { shots: Object.fromEntries(shots), columns: [], lost, cells, beyond: [] };
}

/** The cells of a table. */
export function cells(text: string, delimiter: string): string[][] {
  const { data } = Papa.parse<string[]>(text.replace(/^\ufeff/, ''), { delimiter });
  return data.map((line) => line.map((cell) => cell.replace(GUARDED, '')));
}

/** A table as text with tabs, quoted as spreadsheets do, so that it can be pasted and imported again. */
export function tabbed(table: readonly (readonly string[])[]): string {
  const cell = (text: string) => {
    const told = GUARDED.test(text) ? `'${text}` : text;
    return /["\t\r\n]/.test(told) ? `"${told.replaceAll('"', '""')}"` : told;
  };
  return table.map((line) => line.map(cell).join('\t')).join('\n');
}

type Headings = readonly (readonly (string | readonly string[])[])[];
/** The lines of a table: those above its headings, the headings, and the lines of shots. */
type Table = { titles: Line[]; head: Line | undefined; lines: Line[] };

/** Maximum number of lines above the headings. */
const MAX_TITLES = 20;
/** Delimiters to try. */
const DELIMITERS = [',', ';', '\t', '|'] as const;

/** Rows that are not empty, with their numbers in a spreadsheet. */
function tableOf(text: string, headings: Headings): Table {
  const [named = '', mark] = DELIMITER.exec(text) ?? [];
  const table = text.slice(named.length);
  const tables = (mark === undefined ? DELIMITERS : [mark]).map((delimiter) => {
    const lines = cells(table, delimiter)
      .map((line, i) => ({ row: i + 1, cells: line }))
      .filter((line) => line.cells.some((cell) => cell.trim() !== ''));
    const counts = lines.slice(0, MAX_TITLES).map((line) => knownIn(line, headings));
    const most = Math.max(0, ...counts);
    const at = counts.indexOf(most);
    // A single known word below the first line may be a cell, unless the lines above have only one cell, as titles do.
    const isHead = at > 0 && (most > 1 || lines.slice(0, at).every(isTitle)) && !isTitle(lines[at]);
    return { delimiter, lines, most: isHead || at === 0 ? most : 0, at: isHead ? at : 0 };
  });
  const best = tables.reduce((a, b) => (b.most > a.most ? b : a));
  const usual = Papa.parse(table, { preview: MAX_TITLES, skipEmptyLines: 'greedy' }).meta.delimiter;
  const { lines, at } = best.most > 0 ? best : (tables.find(({ delimiter }) => delimiter === usual) ?? best);
  return { titles: lines.slice(0, at), head: lines[at], lines: lines.slice(at + 1) };
}

function isTitle({ cells }: Line): boolean {
  return cells.filter((cell) => cell.trim() !== '').length <= 1;
}

/** The number of standard columns that a line names. */
function knownIn({ cells }: Line, headings: Headings): number {
  const places = cells.map((cell) => headings.map((list) => placeIn(list, cell)).find((place) => place >= 0));
  return new Set(places.filter((place) => place !== undefined)).size;
}

/** The place of a heading in a list of names, or -1. */
function placeIn(list: Headings[number], heading: string): number {
  const plain = plainHeading(heading);
  return plain === '' ? -1 : list.findIndex((names) => [names].flat().some((name) => plainHeading(name) === plain));
}

function plainHeading(heading: string): string {
  return heading
    .normalize('NFKC')
    .toLowerCase()
    .replace(/[\s.:#*_]+/g, ' ')
    .trim();
}

/** The standard columns that are fields of a shot, by their places among the headings. */
const FIELDS: Readonly<Record<number, Field>> = {
  0: 'scene',
  7: 'action',
  8: 'dialogue',
  9: 'notes',
  10: 'caption',
  11: 'sound',
};
const SCENE = 0;
const NUMBER = 1;
const PICTURE = 2;
const DURATION = 5;
const FRAMES = 6;
/** Standard columns that only describe the picture of a shot. */
const FIXED: readonly (number | string)[] = [PICTURE, 3, 4];

/** A column of a table: a standard column by its place among the headings, or a custom column by its name. */
type Column = { place: number | string; heading: string };
type Line = { row: number; cells: string[] };

/**
 * Puts the lines of a table on shots. A line with the name of a photo belongs to the shot of that photo: the n-th line of a name
 * to the n-th shot of that name. The other lines go to the remaining shots in order.
 * @param headings the names of the standard columns in every language
 * @param names of photos, by id
 */
export function fromTable(
  text: string,
  {
    rows,
    board,
    headings,
    names,
  }: {
    rows: readonly ShotRow[];
    board: Board;
    headings: Headings;
    names: ReadonlyMap<string, string>;
  },
): Imported {
  const { titles, head, lines } = tableOf(text, headings);
  const columns = columnsOf(head?.cells ?? [], headings, board.columns);
  const custom = columns.flatMap(({ place }) => (typeof place === 'string' && place !== '' ? place : []));
  const fresh = custom.filter((name) => !board.columns.includes(name));
  const room = Math.max(0, MOST.columns - board.columns.length);
  const beyond = fresh.slice(room);
  const used = columns.map((column) => ({
    ...column,
    off: typeof column.place === 'string' && beyond.includes(column.place),
  }));
  const picture = columns.findIndex(({ place }) => place === PICTURE);
  const homes = homesOf(lines, picture, { rows, names });
  const shots: Record<string, Shot> = {};
  const numbers = new Map<string, { number: string; saved: boolean }>();
  const cells: string[] = [];
  const lost = titles.map(told);
  lines.forEach((line, i) => {
    const home = homes[i];
    if (!home) {
      lost.push(told(line));
      return;
    }
    const { shot, number } = filled(home, line, used, { board, failed: (cell) => cells.push(cell) });
    shots[home.id] = shot;
    if (number !== undefined) numbers.set(home.id, { number, saved: Boolean(line.cells[picture]?.trim()) });
  });
  return { shots: withNumbers(shots, numbers, rows), columns: fresh.slice(0, room), lost, cells, beyond };
}

function told({ row, cells }: Line): string {
  return `${row}: ${cells.join(' ').trim()}`;
}

/**
 * Names the columns of a table, in the language with the most of its headings. A heading that occurs again gets a number, so
 * that no column overwrites another.
 * @param own the custom columns of the board
 */
function columnsOf(head: readonly string[], headings: Headings, own: readonly string[]): Column[] {
  const line = { row: 1, cells: [...head] };
  const sorted = headings.toSorted((a, b) => knownIn(line, [b]) - knownIn(line, [a]));
  const isSaved = head.some((cell) => headings.some((list) => placeIn(list, cell) === PICTURE));
  const taken = new Set<number | string>();
  return head.map((cell) => {
    const heading = fitted(cell, MOST.label).text;
    const place0 = placeIn(sorted[0] ?? [], heading);
    const isOwn = own.includes(heading) && !taken.has(heading) && (place0 < 0 || taken.has(place0));
    const found = sorted.map((list) => placeIn(list, heading)).find((place) => place >= 0);
    // Only lists of the app have columns that describe the picture.
    const known = found !== undefined && FIXED.includes(found) && !isSaved ? undefined : found;
    let place = heading === '' ? '' : isOwn ? heading : (known ?? heading);
    for (let n = 2; place !== '' && taken.has(place); n += 1) place = `${fitted(heading, MOST.label - 6).text} ${n}`;
    taken.add(place);
    return { place, heading };
  });
}

/**
 * Returns the shot of each line, or undefined for a line that no shot is left for.
 * @param picture the column with the names of photos, or -1
 */
function homesOf(
  lines: readonly Line[],
  picture: number,
  { rows, names }: { rows: readonly ShotRow[]; names: ReadonlyMap<string, string> },
): (ShotRow | undefined)[] {
  const waiting = new Map<string, ShotRow[]>();
  for (const row of rows) {
    const name = (names.get(row.id) ?? row.id).trim();
    const same = waiting.get(name);
    if (same) same.push(row);
    else waiting.set(name, [row]);
  }
  const named = lines.map(({ cells }) => (cells[picture] ?? '').trim());
  const homes = named.map((name) => (name === '' ? undefined : waiting.get(name)?.shift()));
  const taken = new Set(homes);
  const free = rows.filter((row) => !taken.has(row));
  return homes.map((home, i) => (named[i] === '' ? free.shift() : home));
}

/**
 * Puts the cells of a line into a shot.
 * @param how `failed` is called for each cell that was changed or left out
 * @returns the shot, and the number in the line, if there is one
 */
function filled(
  { shot: before, said }: ShotRow,
  { row, cells }: Line,
  columns: readonly (Column & { off: boolean })[],
  { board, failed }: { board: Board; failed: (cell: string) => void },
): { shot: Shot; number: string | undefined } {
  let shot = before;
  let number: string | undefined;
  /** Lengths in frames. */
  const lengths: number[] = [];
  cells.forEach((cell, at) => {
    const { place, heading, off } = columns[at] ?? { place: '', heading: '', off: false };
    if (off || FIXED.includes(place)) return;
    const { text, cut } = fitted(cell, place === SCENE || place === NUMBER ? MOST.label : MOST.field);
    const field = typeof place === 'number' ? FIELDS[place] : undefined;
    const frames = place === FRAMES && text !== '' ? `${text}f` : text;
    const length = place === DURATION || place === FRAMES ? lengthOf(frames, board, MOST.shotFrames) : null;
    if (cut || length === undefined || (place === '' && text !== ''))
      failed(`${row}, ${heading && `${heading}: `}${text}`);
    if (place === NUMBER) number = text;
    else if (typeof length === 'number') lengths.push(length);
    // The text of the pages is in the list of a shot without its own text.
    else if (field !== undefined && before[field] === undefined && text === textOn(said, field)) return;
    else if (field !== undefined) shot = withField(shot, field, text);
    else if (typeof place === 'string' && place !== '') shot = withColumn(shot, place, text);
  });
  // A list has the length of a shot twice. The one that was edited counts, and an unchanged default stays a default.
  const now = before.frames ?? USUAL_SECONDS * board.fps;
  const edited = lengths.filter((length) => length !== now).at(-1);
  return { shot: edited === undefined ? shot : { ...shot, frames: edited }, number };
}

/** Returns the text of the pages for a field. */
function textOn(said: Spoken, field: Field): string | undefined {
  return said[field as keyof Spoken]?.trim();
}

/**
 * Gives shots the numbers of a table. A number that the board counts anyway is not fixed, nor is one that is unchanged since the
 * list was saved.
 * @param numbers with the lines of a saved list, which name their photos, as `saved`
 */
function withNumbers(
  shots: Record<string, Shot>,
  numbers: ReadonlyMap<string, { number: string; saved: boolean }>,
  rows: readonly ShotRow[],
): Record<string, Shot> {
  const all = { ...shots };
  let counted = 0;
  for (const { id, shot, number: shown } of rows) {
    const { number, saved } = numbers.get(id) ?? { number: shown, saved: true };
    const same = number === shot.number?.trim() || (saved && number === shown);
    const own = same ? (shot.number?.trim() ?? '') : number === String(counted + 1) ? '' : number;
    if (own === '') counted += 1;
    if (!same) all[id] = withField(all[id], 'number', own);
  }
  return all;
}

/** Returns a text with at most that many characters, and whether it was cut. */
function fitted(text: string, most: number): { text: string; cut: boolean } {
  const plain = wellFormed(text.trim());
  const cut = plain.length > most;
  return { text: cut ? wellFormed(plain.slice(0, most)).trim() : plain, cut };
}
