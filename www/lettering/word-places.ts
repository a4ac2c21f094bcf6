/** Converts positions of text items: fractions of a panel or of the page, to and from page widths. */

import { MOST } from '../document/limits.ts';
import type { Bounds, Geometry, Word, WordBox } from '../engine/types.ts';

/** A position in page widths, or in fractions of a frame. */
export type Place = [number, number];

/**
 * The frame of a text item: its position is a fraction of it.
 * @returns in page widths
 */
export function frameOf({ panels, height }: Geometry, { panel }: Pick<Word, 'panel'>): Bounds {
  const own = panel === null || panel === undefined ? undefined : (panels[panel] ?? panels.at(-1));
  return own?.bounds ?? { x: 0, y: 0, width: 1, height };
}

/**
 * @param place fractions
 * @returns in page widths
 */
export function pagePoint(geometry: Geometry, word: Pick<Word, 'panel'>, [x, y]: Place): Place {
  const frame = frameOf(geometry, word);
  return [frame.x + x * frame.width, frame.y + y * frame.height];
}

/**
 * Moves the centre of a text item to a position on the page. It belongs to the topmost panel there, and in a gutter to
 * its previous panel. `tip` is the end of the tail.
 */
export function anchored(geometry: Geometry, word: Word, to: Place, tip: Place | null): Partial<Word> {
  const at = [Math.min(1, Math.max(0, to[0])), Math.min(geometry.height, Math.max(0, to[1]))] as Place;
  const below = geometry.panels.findLastIndex(({ bounds }) => contains(bounds, at));
  const panel = below < 0 ? (word.panel ?? null) : below;
  const frame = frameOf(geometry, { panel });
  const part = ([x, y]: Place) => ({ x: within((x - frame.x) / frame.width), y: within((y - frame.y) / frame.height) });
  return { panel, ...part(at), tail: tip && part(tip) };
}

function contains({ x, y, width, height }: Bounds, [px, py]: Place) {
  return px >= x && px <= x + width && py >= y && py <= y + height;
}

/** @returns the part, limited to the range of the core. For a narrow panel, the page is many panel widths */
function within(part: number): number {
  return Math.min(MOST.away, Math.max(-MOST.away, Math.round(part * 1e5) / 1e5));
}

/**
 * @param middle of the effect, in page widths
 * @param box its box, or undefined if it is unknown
 * @param angle in degrees
 * @returns the position of the rotation handle, above the sound effect
 */
export function knobOf([x, y]: Place, box: Pick<WordBox, 'height'> | undefined, angle?: number | null): Place {
  const turned = ((angle ?? 0) * Math.PI) / 180;
  const reach = (box?.height ?? 0) / 2 + 0.04;
  return [x + Math.sin(turned) * reach, y - Math.cos(turned) * reach];
}
