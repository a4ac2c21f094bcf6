/** The name of a block: the plain words, and the term of the field, which stands back. */

import { strings } from '../strings/strings.ts';
import type { Block } from '../engine/types.ts';

export function BlockName({ block }: { block: Block }) {
  const name = strings.blockName(block);
  const at = name.search(/ ?[(（]/);
  if (at < 0) return <>{name}</>;
  return (
    <>
      {name.slice(0, at)}
      <span class="block-term">{name.slice(at)}</span>
    </>
  );
}
