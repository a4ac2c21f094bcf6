/**
 * Linked balloons: they share one outline and one tail. A balloon stores the name of the previous balloon in its chain:
 * in `joined` if the user linked it, in `linked` if the placement did.
 */

import type { Word } from '../engine/types.ts';

/** @returns the index of the balloon that a text item is linked to; -1 without a link */
export function hangsOn(words: readonly Word[], index: number): number {
  const name = words[index]?.joined || words[index]?.linked;
  if (!name) return -1;
  const at = words.findIndex(({ kind, id }) => kind === 'balloon' && id === name);
  return at === index ? -1 : at;
}

/** @returns the indices of all text items of a chain, in order */
export function chainOf(words: readonly Word[], index: number): number[] {
  const on = words.map((_, i) => hangsOn(words, i));
  const chain = new Set([index]);
  for (const at of chain)
    for (const [other, to] of on.entries())
      if (to === at || (to >= 0 && other === at)) chain.add(to === at ? other : to);
  return [...chain].sort((a, b) => a - b);
}

/** @returns the balloon that is read before one, on the same panel; -1 for the first */
export function balloonBefore(words: readonly Word[], index: number): number {
  const { kind, panel = null } = words[index] ?? {};
  if (kind !== 'balloon') return -1;
  return words.findLastIndex((word, i) => i < index && word.kind === 'balloon' && (word.panel ?? null) === panel);
}

/** @returns the text items with a balloon linked to the previous one, at the position that the core finds next to it */
export function joinedBefore(words: readonly Word[], index: number): Word[] {
  const before = balloonBefore(words, index);
  if (before < 0) return [...words];
  const held = words.findIndex(({ id }) => id && id === words[before].id);
  const name = held === before ? (words[before].id as string) : freeName(words);
  return words.map((word, i) => {
    if (i === before) return { ...word, id: name };
    return i === index ? { ...word, joined: name, linked: null, apart: false, auto: true } : word;
  });
}

/** @returns the text items without the link of this balloon */
export function parted(words: readonly Word[], index: number): Word[] {
  return words.map((word, i) =>
    i === index ? { ...word, joined: null, linked: null, apart: true, auto: true } : word,
  );
}

/** Returns an unused name. */
function freeName(words: readonly Word[]): string {
  const taken = new Set(words.map(({ id }) => id));
  let number = 1;
  while (taken.has(`b${number}`)) number += 1;
  return `b${number}`;
}
