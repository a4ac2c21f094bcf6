/**
 * What is told of shots, read from files: screenplays in Fountain, and tables of values apart by commas, semicolons or tabs.
 * Loaded with the first of them, as are the libraries that read them.
 */

// The reader of Fountain that is kept, in TypeScript and without dependencies.
import { Fountain } from 'fountain-js';
// Quotes, line ends and what parts the cells, as RFC 4180 and spreadsheets have them.
import Papa from 'papaparse';
import { MOST } from '../engine/bounds.ts';
import type { Board, Shot } from '../engine/types.ts';
import type { ShotRow } from './shots.ts';
import { lengthOf, withColumn, withField } from './shots.ts';

/** What came of a file: shots by their photos, columns that are new, how many lines there were, and the first that found no shot. */
export type Imported = { shots: Record<string, Shot>; columns: string[]; lines: number; left: number; first: string };

type Line = Pick<Shot, 'scene' | 'action' | 'dialogue'>;

/** Bytes of a file. */
const MOST_BYTES = 5_000_000;
/** Begins a cell that would be a formula, see `src/output/shots/csv.rs`. */
const GUARDED = /^'(?=[=+\-@\t\r])/;

/** @returns null for a file that is too large to be one */
export function fits(file: Blob): boolean {
  return file.size <= MOST_BYTES;
}

/** The paragraphs of a screenplay, each with its scene: one a shot. What is said belongs to what happens before it. */
export function fountainLines(text: string): Line[] {
  const lines: Line[] = [];
  let scene = '';
  let speaker = '';
  let open = false;
  const plain = (said = '') =>
    said
      .replace(/<br\s*\/?>|\n/g, ' ')
      .replace(/[*_]{1,3}([^*_]+)[*_]{1,3}/g, '$1')
      .trim();
  for (const token of new Fountain().parse(text, true).tokens) {
    if (token.type === 'scene_heading') {
      scene = [token.scene_number, plain(token.text)].filter(Boolean).join(' ').slice(0, MOST.label);
      open = false;
    } else if (token.type === 'action' || token.type === 'centered') {
      const action = plain(token.text).slice(0, MOST.field);
      if (action) lines.push({ scene, action });
      open = action !== '' || open;
    } else if (token.type === 'character') {
      speaker = plain(token.text);
    } else if (token.type === 'dialogue' || token.type === 'lyrics') {
      const said = `${speaker ? `${speaker}: ` : ''}${plain(token.text)}`;
      const last = lines.at(-1);
      if (open && last) last.dialogue = [last.dialogue, said].filter(Boolean).join('\n').slice(0, MOST.field);
      else lines.push({ scene, dialogue: said.slice(0, MOST.field) });
      open = true;
    }
  }
  return lines.map((line) => Object.fromEntries(Object.entries(line).filter(([, told]) => told)) as Line);
}

/** Lays the paragraphs of a screenplay on shots, one each. */
export function fromFountain(text: string, rows: readonly ShotRow[]): Imported {
  const lines = fountainLines(text);
  const shots = Object.fromEntries(
    rows.slice(0, lines.length).map(({ id, shot }, i) => [id, { ...shot, ...lines[i] }]),
  );
  const rest = lines.slice(rows.length);
  return {
    shots,
    columns: [],
    lines: lines.length,
    left: rest.length,
    first: rest[0]?.action ?? rest[0]?.dialogue ?? '',
  };
}

/** Cells of a table, whatever parts them. */
export function cells(text: string, delimiter = ''): string[][] {
  const { data } = Papa.parse<string[]>(text.replace(/^\ufeff/, ''), { delimiter, skipEmptyLines: 'greedy' });
  return data.map((line) => line.map((cell) => cell.replace(GUARDED, '')));
}

/**
 * Lays the lines of a table on shots: those that name a picture of the album on its shot, the others one after the other.
 * @param headings what the ten columns of a list are called, in every language
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
    headings: readonly (readonly string[])[];
    names: ReadonlyMap<string, string>;
  },
): Imported {
  const [head = [], ...lines] = cells(text);
  const known = (name: string) => {
    const plain = name.trim().toLowerCase();
    return headings.map((list) => list.findIndex((heading) => heading.toLowerCase() === plain)).find((at) => at >= 0);
  };
  const places = head.map((name) => known(name) ?? name.trim());
  const fresh = places.filter((place): place is string => typeof place === 'string' && place !== '');
  const own = [...new Set([...board.columns, ...fresh])].slice(0, MOST.columns);
  const picture = places.indexOf(2);
  const shots: Record<string, Shot> = {};
  let left = 0;
  let first = '';
  lines.forEach((line, i) => {
    const named = picture < 0 ? undefined : rows.find(({ id }) => names.get(id) === line[picture]);
    const row = named ?? (picture < 0 || !line[picture] ? rows[i] : undefined);
    if (!row) {
      left += 1;
      first ||= line.join(' ').trim();
      return;
    }
    shots[row.id] = places.reduce((shot, place, at) => withCell(shot, place, line[at] ?? '', { board, own }), row.shot);
  });
  return { shots, columns: own.slice(board.columns.length), lines: lines.length, left, first };
}

/** The columns of a list that are fields, by their places among the headings. */
const PLACES: Readonly<Record<number, string>> = { 0: 'scene', 1: 'number', 7: 'action', 8: 'dialogue', 9: 'notes' };

function withCell(
  shot: Shot,
  place: string | number,
  text: string,
  { board, own }: { board: Board; own: readonly string[] },
): Shot {
  if (typeof place === 'string')
    return own.includes(place) ? withColumn(shot, place, text.trim().slice(0, MOST.field)) : shot;
  const field = PLACES[place];
  // A number that is only counted is not one of its own.
  if (field === 'number' && /^\d+$/.test(text.trim())) return shot;
  if (field) return withField(shot, field, text.trim().slice(0, field === 'scene' ? MOST.label : MOST.field));
  if (place !== 5 && place !== 6) return shot;
  const frames = lengthOf(place === 6 ? `${text.trim()}f` : text, board, MOST.shotFrames);
  return frames ? { ...shot, frames } : shot;
}
