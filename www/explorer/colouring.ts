/**
 * Colours for invented styles. Rules for new styles preserve the colours of the photo, so all styles on the wall would
 * have the same colours. Five of six styles therefore get a print colour after their chain, spread evenly over the
 * colour wheel. Dark tones stay dark and light tones stay light, so that faces keep their shading. The same seed gives
 * the same colours.
 */

import type { Block, Style, StyleStep } from '../engine/types.ts';

/** Degrees between a colour and the next: the golden angle, so that any number in a row is spread evenly. */
const GOLDEN = 137.508;
/** Ways to colour; the first leaves the photo's own colours. */
const WAYS = [none, oneInk, tintedPaper, twoInks, palette, faded];
const PALETTES = ['poster', 'gouache', 'night'];
/** Grey value of dark inks, 0 to 255. */
const INK = 42;
const SHEETS = ['smooth', 'cold-press', 'laid', 'newsprint', 'canvas'];
/** Degrees from an ink to the hue of its paper. */
const PAPERS = [0, 180, 40, -40];

/**
 * @param style generated from the seed
 * @param blocks determine whether the chain ends in gray
 * @returns the same style if it preserves the colours of the photo
 */
export function coloured(style: Style, seed: number, blocks: readonly Block[]): Style {
  const turn = Math.floor(seed / WAYS.length);
  const hue = Math.round(turn * GOLDEN) % 360;
  const gray = endsGray(style.background, blocks);
  const steps = WAYS[seed % WAYS.length](hue, turn, gray);
  if (steps.length === 0) return style;
  return { ...style, id: `coloured-${seed}`, background: [...style.background, ...steps] };
}

function none(): StyleStep[] {
  return [];
}

/** One dark ink on a light paper. */
function oneInk(hue: number, turn: number, gray: boolean): StyleStep[] {
  const sheet = paper(hue + PAPERS[turn % PAPERS.length], turn, 0.88);
  return [...(gray ? [] : [{ block: 'to_gray' }]), plates(dark(hue)), sheet];
}

/** The photo's colours on a tinted paper. */
function tintedPaper(hue: number, turn: number, gray: boolean): StyleStep[] {
  return [...(gray ? [plates(dark(hue + 180))] : []), paper(hue, turn, 0.87)];
}

/** Two inks of opposite colours. */
function twoInks(hue: number, turn: number, gray: boolean): StyleStep[] {
  if (gray) return oneInk(hue, turn, gray);
  const bright = colour(hue + 150 + 30 * (turn % 3), 0.85, 0.55);
  return [{ ...plates(dark(hue), bright), steps: [1, 5][turn % 2] }, paper(45, turn, 0.95)];
}

/** The nearest colours of a painter's palette. */
function palette(hue: number, turn: number, gray: boolean): StyleStep[] {
  if (gray) return oneInk(hue, turn, gray);
  const name = PALETTES[turn % PALETTES.length];
  return [{ block: 'flatten', palette: name, colors: 12, detail: 8, smoothness: 40, own: 40 }];
}

/** The photo's colours with an ink instead of black, as on an old print. */
function faded(hue: number, turn: number, gray: boolean): StyleStep[] {
  if (gray) return oneInk(hue, turn, gray);
  const [red, green, blue] = inkOf(hue);
  return [
    { block: 'brightness', gain: 0.9, channels: 'each' },
    { block: 'hue', red, green, blue },
    paper(hue + 180, turn, 0.95),
  ];
}

/** Plates of one or two inks. */
function plates(first: string, second = '#ffffff'): StyleStep {
  return { block: 'plates', inks: 'own', ink_1: first, ink_2: second, grain: 20, shift: 2 };
}

/** A dark ink as `#rrggbb`. */
function dark(hue: number): string {
  return hex(inkOf(hue));
}

/** Red, green and blue, 0 to 255, of a dark ink. All inks are equally dark. */
function inkOf(hue: number): number[] {
  const ink = channels(hue, 0.7, 0.3);
  const luma = 0.299 * ink[0] + 0.587 * ink[1] + 0.114 * ink[2];
  return ink.map((channel) => Math.min(255, Math.round((channel * INK) / luma)));
}

/** A sheet under the picture. @param light of the sheet, 0 to 1 */
function paper(hue: number, turn: number, light: number): StyleStep {
  const sheet = SHEETS[turn % SHEETS.length];
  return { block: 'paper', sheet, tint: 'own', color: colour(hue, 0.6, light), grain: 20, pigment: 10 };
}

/** A colour as `#rrggbb`. Saturation and lightness, 0 to 1, as in HSL. */
function colour(hue: number, saturation: number, lightness: number): string {
  return hex(channels(hue, saturation, lightness));
}

function hex(rgb: readonly number[]): string {
  return `#${rgb.map((channel) => channel.toString(16).padStart(2, '0')).join('')}`;
}

/** Red, green and blue, 0 to 255, of a colour in HSL. */
function channels(hue: number, saturation: number, lightness: number): number[] {
  const spread = saturation * Math.min(lightness, 1 - lightness);
  return [0, 8, 4].map((offset) => {
    const at = (offset + (((hue % 360) + 360) % 360) / 30) % 12;
    return Math.round(255 * (lightness - spread * Math.max(-1, Math.min(at - 3, 9 - at, 1))));
  });
}

function endsGray(steps: readonly StyleStep[], blocks: readonly Block[]): boolean {
  const last = steps.map(({ block }) => blocks.find(({ id }) => id === block)?.output).filter((to) => to !== 'any');
  return last.at(-1) === 'luma';
}
