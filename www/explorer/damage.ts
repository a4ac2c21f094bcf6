/**
 * Detects generated styles that burn out the details of a photo, lose its faces, or cover it with noise. All follow from
 * the signature of the picture, so that no pixels are read again. The signature of the photo without a style makes the
 * checks stricter.
 */

import { NOT_CLIPPED } from '../engine/protocol.ts';
import type { Explored } from '../engine/protocol.ts';
import type { EnergyMap, Subject } from '../engine/types.ts';

/** The label of a face. */
const FACE = 'face';
/** The grid of a signature, and the bytes of a cell: red, green, blue and roughness. */
const [COLUMNS, ROWS, CELL] = [12, 9, 4];
/** Minimum channel value of white paper, and maximum channel value of black. */
const [WHITE, BLACK] = [240, 14];
/** Maximum roughness of a cell without content. */
const SMOOTH = 6;
/** The part of the detailed cells that may be white paper. */
const BURNT = 0.3;
/** Faces with a smaller part of the photo than this need not be seen. */
const LEAST_FACE = 0.004;
/** Maximum roughness of a picture, in roughnesses of its photo, and the least roughness of a photo for that. */
const NOISE = 1.7;
const LEAST_ROUGH = 50;
/** Maximum standard deviation of the lightness of a picture, in deviations of its photo, and its least deviation for that. */
const CONTRAST = 1.8;
const LEAST_DEVIATION = 40;
/** Lightness of midtones, and the part of the midtones that may become black or white. */
const MIDTONES = [45, 215];
const CLIPPED = 0.2;
/** A midtone is lost below this lightness, or if all channels are above this value. */
const [LOST_BLACK, LOST_WHITE] = [22, 236];
/** The part of the pixels that a style may make pure white, pure black, or one of them. Line drawings are mostly paper. */
const MOST_CLIPPED = { white: 0.18, black: 0.2, both: 0.25 };
const MOST_CLIPPED_LINES = { white: 0.85, black: 0.4, both: 0.95 };
/**
 * The part of the pixels that a style may give the lightest or the darkest tone of its picture, in any colour. Line drawings are
 * mostly paper, so only their dark areas count.
 */
const MOST_ENDS = 0.35;
const MOST_DARK_LINES = 0.2;
/** Minimum roughness of a face, in roughnesses of the face in the photo; of a face that became lighter; and the steps of that. */
const [FEATURES, LIGHT_FEATURES, LIGHTER] = [0.6, 0.8, 10];

/** Difference of the largest and the smallest channel, from calm colours to neon colours. */
const [CALM, NEON] = [80, 200];
/** Minimum channel value of a bleached area. */
const BLEACHED = 225;

type Photo = { energy?: EnergyMap; subjects: readonly Subject[] };

/**
 * Returns why a picture of a photo is not shown; empty if it is fine.
 * @param plain the signature of the photo without a style
 */
export function damageOf(
  { energy, subjects }: Photo,
  signature: Uint8Array,
  plain?: Uint8Array,
): '' | 'burnt' | 'faceless' | 'noisy' {
  if (signature.length !== COLUMNS * ROWS * CELL) return '';
  const cells = cellsIn(signature);
  const isPaper = ([r, g, b, rough]: Uint8Array) => Math.min(r, g, b) >= WHITE && rough <= SMOOTH;
  const detailed = energy ? detailedCells(energy) : [];
  if (detailed.length > 0 && detailed.filter((i) => isPaper(cells[i])).length > BURNT * detailed.length) return 'burnt';
  const isEmpty = (cell: Uint8Array) => isPaper(cell) || cell[3] <= SMOOTH || Math.max(...cell.slice(0, 3)) <= BLACK;
  const faces = subjects.filter(({ label, width, height }) => label === FACE && width * height >= LEAST_FACE);
  const lost = faces.filter((face) => cellsOf(face).every((i) => isEmpty(cells[i])));
  if (faces.length > 0 && 2 * lost.length >= faces.length) return 'faceless';
  if (plain?.length !== signature.length) return '';
  const before = cellsIn(plain);
  const isHarsh = deviation(cells) > CONTRAST * Math.max(LEAST_DEVIATION, deviation(before));
  if (isHarsh || clippedPart(cells, before) > CLIPPED) return 'burnt';
  if (roughness(cells) > NOISE * Math.max(LEAST_ROUGH, roughness(before))) return 'noisy';
  const faded = faces.filter((face) => {
    const [now, then] = [cells, before].map((all) => cellsOf(face).map((i) => all[i]));
    const lighter = lightness(now) - lightness(then) > LIGHTER;
    return roughness(now) < (lighter ? LIGHT_FEATURES : FEATURES) * roughness(then);
  });
  return faces.length > 0 && 2 * faded.length >= faces.length ? 'faceless' : '';
}

/**
 * Whether a style makes too many pixels of a photo pure white or pure black, or loses its tones between the lightest and the
 * darkest one. Dark photos lose them first.
 * @param plain of the photo without a style
 */
export function isClipped(
  { clipped: { white, black, lightest, darkest }, look }: Pick<Explored, 'clipped' | 'look'>,
  plain = NOT_CLIPPED,
): boolean {
  const isLines = look === 'line';
  const darker = darkest - plain.darkest;
  if (isLines ? darker > MOST_DARK_LINES : darker + lightest - plain.lightest > MOST_ENDS) return true;
  const most = isLines ? MOST_CLIPPED_LINES : MOST_CLIPPED;
  const [whiter, blacker] = [white - plain.white, black - plain.black];
  return whiter > most.white || blacker > most.black || whiter + blacker > most.both;
}

/**
 * Returns how harsh a picture is, from 0 to 2: neon colours and bleached areas, each by its part of the picture. Drawings
 * of lines have white paper.
 * @param look of the style
 */
export function harshness(signature: Uint8Array, look: string): number {
  const cells = cellsIn(signature);
  const neon = ([r, g, b]: Uint8Array) =>
    Math.min(1, Math.max(0, (Math.max(r, g, b) - Math.min(r, g, b) - CALM) / (NEON - CALM)));
  const bleached = ([r, g, b]: Uint8Array) => Number(Math.min(r, g, b) > BLEACHED);
  return mean(cells, neon) + (look === 'line' ? 0 : mean(cells, bleached));
}

/** The part of the midtones of a photo that are black or white in a picture. */
function clippedPart(cells: readonly Uint8Array[], before: readonly Uint8Array[]): number {
  const midtones = cells.filter((_, i) => {
    const light = lightness([before[i]]);
    return light > MIDTONES[0] && light < MIDTONES[1];
  });
  const clipped = midtones.filter(
    (cell) => lightness([cell]) < LOST_BLACK || Math.min(...cell.subarray(0, 3)) > LOST_WHITE,
  );
  return clipped.length / Math.max(1, midtones.length);
}

function cellsIn(signature: Uint8Array): Uint8Array[] {
  return Array.from({ length: Math.floor(signature.length / CELL) }, (_, i) =>
    signature.subarray(i * CELL, (i + 1) * CELL),
  );
}

const mean = (cells: readonly Uint8Array[], of: (cell: Uint8Array) => number) =>
  cells.reduce((sum, cell) => sum + of(cell), 0) / Math.max(1, cells.length);
const roughness = (cells: readonly Uint8Array[]) => mean(cells, ([, , , rough]) => rough);
/** Standard deviation of the lightness of cells. */
function deviation(cells: readonly Uint8Array[]): number {
  const middle = lightness(cells);
  return Math.sqrt(mean(cells, (cell) => (lightness([cell]) - middle) ** 2));
}

const lightness = (cells: readonly Uint8Array[]) => mean(cells, ([r, g, b]) => 0.299 * r + 0.587 * g + 0.114 * b);

/** The half of the cells in which the photo has most to see. */
function detailedCells({ columns, rows, values }: EnergyMap): number[] {
  if (columns * rows === 0 || values.length < 2 * columns * rows) return [];
  const energyOf = (i: number) => {
    const x = Math.floor((((i % COLUMNS) + 0.5) / COLUMNS) * columns);
    const y = Math.floor(((Math.floor(i / COLUMNS) + 0.5) / ROWS) * rows);
    return Number.parseInt(values.slice(2 * (y * columns + x), 2 * (y * columns + x) + 2), 16);
  };
  const all = Array.from({ length: COLUMNS * ROWS }, (_, i) => ({ i, energy: energyOf(i) }));
  all.sort((a, b) => b.energy - a.energy);
  return all.slice(0, all.length / 2).map(({ i }) => i);
}

/** Returns the cells with their centre in a box, or the cell that contains the centre of the box. */
function cellsOf({ x, y, width, height }: Subject): number[] {
  const all = Array.from({ length: COLUMNS * ROWS }, (_, i) => i);
  const inside = all.filter((i) => {
    const [cx, cy] = [((i % COLUMNS) + 0.5) / COLUMNS, (Math.floor(i / COLUMNS) + 0.5) / ROWS];
    return cx >= x && cx <= x + width && cy >= y && cy <= y + height;
  });
  if (inside.length > 0) return inside;
  const at = (middle: number, count: number) => Math.min(count - 1, Math.max(0, Math.floor(middle * count)));
  return [at(y + height / 2, ROWS) * COLUMNS + at(x + width / 2, COLUMNS)];
}
