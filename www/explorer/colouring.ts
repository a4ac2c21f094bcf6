/**
 * Colours for invented styles. Rules for new styles preserve the colours of the photo, so all styles on the wall would
 * have the same colours. Three of four styles therefore get a print colour after their chain, spread evenly over the
 * colour wheel and from dark to light. The same seed gives the same colours.
 */

import type { Block, Style, StyleStep } from '../engine/types.ts';

/** Degrees between a colour and the next: the golden angle, so that any number in a row is spread evenly. */
const GOLDEN = 137.508;
/** Ways to colour; the first leaves the photo's own colours. */
const WAYS = 4;

/**
 * @param style generated from the seed
 * @param blocks determine whether the chain ends in gray
 * @returns the same style if it preserves the colours of the photo
 */
export function coloured(style: Style, seed: number, blocks: readonly Block[]): Style {
  const turn = Math.floor(seed / WAYS);
  const hue = Math.round(turn * GOLDEN) % 360;
  const gray = endsGray(style.background, blocks);
  const steps = [none, oneInk, tintedPaper, turned][seed % WAYS](hue, turn, gray);
  if (steps.length === 0) return style;
  return { ...style, id: `coloured-${seed}`, background: [...style.background, ...steps] };
}

function none(): StyleStep[] {
  return [];
}

/** Everything in one colour; black becomes a dark ink. */
function oneInk(hue: number, turn: number, gray: boolean): StyleStep[] {
  return [
    ...(gray ? [] : [{ block: 'to_gray' }]),
    { block: 'colorize', hue, saturation: spread(turn, 5, 0.2, 0.6) },
    tint((hue + 20) % 360, spread(turn, 3, 15, 55)),
  ];
}

/** The photo's colours, a little weaker, on a paper with a tint. */
function tintedPaper(hue: number, turn: number, gray: boolean): StyleStep[] {
  const depth = spread(turn, 3, 40, 100);
  return [
    ...(gray ? [{ block: 'colorize', hue, saturation: 0.25 }] : [{ block: 'saturation', amount: 0.7 }]),
    tint(hue, -depth),
  ];
}

/** The photo's colours turned to their neighbours on the wheel, darker or lighter. */
function turned(hue: number, turn: number, gray: boolean): StyleStep[] {
  if (gray) return oneInk((hue + 180) % 360, turn, gray);
  const angle = (turn % 2 === 0 ? 1 : -1) * spread(turn, 5, 20, 80);
  return [
    { block: 'hue', angle: Math.round(angle) },
    { block: 'brightness', gain: [0.6, 1, 1.35][turn % 3], channels: 'each' },
  ];
}

/**
 * A bias of every pixel to a hue.
 * @param strength added to the channels of the hue; a negative value is subtracted from the others
 */
function tint(hue: number, strength: number): StyleStep {
  const [red, green, blue] = [0, 240, 120].map((offset) => {
    const sector = ((hue + offset) / 60) % 6;
    const share = Math.min(1, Math.max(0, Math.abs(sector - 3) - 1));
    return Math.round(strength * (strength < 0 ? 1 - share : share));
  });
  return { block: 'hue', red, green, blue };
}

/** One of `count` steps from `least` to `most`. */
function spread(turn: number, count: number, least: number, most: number): number {
  const at = (turn * 2) % count;
  return Number((least + ((most - least) * at) / (count - 1)).toFixed(2));
}

function endsGray(steps: readonly StyleStep[], blocks: readonly Block[]): boolean {
  const last = steps.map(({ block }) => blocks.find(({ id }) => id === block)?.output).filter((to) => to !== 'any');
  return last.at(-1) === 'luma';
}
