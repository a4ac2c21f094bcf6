/** The photos of the pages as shots: in reading order, with the text of the balloons and captions. */

import { MOST } from '../engine/bounds.ts';
import { readingOrder } from '../page/reading-order.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { Planner } from '../document/store.ts';

/** As in `crates/engine/src/document/listing.rs`: the weight of the horizontal position against the vertical one. */
const SLANT = 0.3;

/** Returns the dialogue of each photo on the pages, by the ids of the photos in reading order. */
export function shotsOf(pages: readonly PageDocument[], planner: Planner | null): ReadonlyMap<string, string> {
  const said = new Map<string, string[]>();
  for (const page of pages) {
    for (const panel of readingOrder(page, planner)) {
      const photo = page.panels[panel]?.photo;
      if (photo) said.set(photo, [...(said.get(photo) ?? []), ...saidIn(page, panel)]);
    }
  }
  return new Map([...said].map(([photo, lines]) => [photo, lines.join('\n').slice(0, MOST.field)]));
}

function saidIn({ words = [] }: PageDocument, panel: number): string[] {
  const place = ({ x, y }: Word) => (y ?? 0.5) + SLANT * (x ?? 0.5);
  return words
    .filter((word) => word.panel === panel && word.kind !== 'effect')
    .sort((a, b) => place(a) - place(b))
    .map(({ text, by }) => {
      // Stars are emphasis.
      const plain = text.replaceAll('*', '').replace(/\s+/g, ' ').trim();
      return by ? `${by}: ${plain}` : plain;
    });
}
