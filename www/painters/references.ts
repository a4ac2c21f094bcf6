/** References of styles to models of the user: `HASH NAME`. */

import type { OwnModel } from './own-painters.ts';
import type { Style } from '../engine/types.ts';

/** Maximum bytes of a reference, as the core has it. */
const LONGEST = 200;

/** @param id of the model @param name of its file */
export function referenceOf(id: string, name: string): string {
  const letters = [...name.replaceAll(/\p{Cc}/gu, ' ')];
  const fits = () => new TextEncoder().encode(`${id} ${letters.join('')}`).length <= LONGEST;
  while (!fits()) letters.pop();
  return `${id} ${letters.join('') || 'onnx'}`;
}

/** @returns the id and the name of a model */
export function partsOf(reference: string): { id: string; name: string } {
  const [, id = '', name = ''] = /^(\w*) (.*)$/s.exec(reference) ?? [];
  return { id, name };
}

/** @returns references of the active blocks of a style; empty for built-in styles */
export function referencesIn(style: string | Style | null | undefined): string[] {
  if (typeof style !== 'object' || style === null) return [];
  const { background, foreground = [] } = style;
  const found = [...background, ...foreground].flatMap(({ bypass, model }) =>
    bypass || typeof model !== 'string' || model === '' ? [] : [model],
  );
  return [...new Set(found)];
}

/**
 * @param models of this browser, by id
 * @returns a text that changes when a model of the style is added or removed, so that its pictures must be drawn again
 */
export function modelsOf(models: ReadonlyMap<string, OwnModel>, style: string | Style | null | undefined): string {
  return referencesIn(style)
    .map((reference) => partsOf(reference).id)
    .filter((id) => models.has(id))
    .join(' ');
}
