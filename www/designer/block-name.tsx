/** The name of a block: a plain name, and the technical term for screen readers. */

import { strings } from '../strings/strings.ts';
import type { Block } from '../engine/types.ts';

export function BlockName({ block }: { block: Block }) {
  const name = strings.blockName(block);
  const at = name.search(/ ?[(（]/);
  if (at < 0) return <>{name}</>;
  return (
    <>
      {name.slice(0, at)}
      <span class="visually-hidden">{name.slice(at)}</span>
    </>
  );
}
