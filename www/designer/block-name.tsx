/** The name of a block: a plain name, and the technical term for screen readers. */

import { strings } from '../strings/strings.ts';
import type { Block } from '../engine/types.ts';

export function BlockName({ block }: { block: Block }) {
  const name = strings.blockName(block);
  const plain = plainName(block);
  return (
    <>
      {plain}
      {name !== plain && <span class="visually-hidden">{name.slice(plain.length)}</span>}
    </>
  );
}

/** The name of a block without the technical term. */
export function plainName(block: Block): string {
  return strings.blockName(block).split(/ ?[(（]/)[0];
}
