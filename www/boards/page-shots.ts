/** The photos of the pages as shots: in reading order, with the text of the balloons, captions and sound effects. */

import { MOST } from '../engine/bounds.ts';
import { readingOrder } from '../page/reading-order.ts';
import { SPOKEN } from './shots.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { Planner } from '../document/store.ts';
import type { Spoken } from './shots.ts';

/** As in `crates/engine/src/page/words/layout.rs`: the weight of the horizontal position against the vertical one. */
const SLANT = 0.3;
/** The kind of text of each field. */
const KINDS: Readonly<Record<keyof Spoken, Word['kind']>> = {
  dialogue: 'balloon',
  caption: 'caption',
  sound: 'effect',
};

/** Returns the text of each photo on the pages, by the ids of the photos in reading order. */
export function shotsOf(pages: readonly PageDocument[], planner: Planner | null): ReadonlyMap<string, Spoken> {
  const panels = new Map<string, [PageDocument, number][]>();
  for (const page of pages) {
    for (const panel of readingOrder(page, planner)) {
      const photo = page.panels[panel]?.photo;
      if (photo) panels.set(photo, [...(panels.get(photo) ?? []), [page, panel]]);
    }
  }
  const saidOn = (own: readonly [PageDocument, number][], field: keyof Spoken) =>
    own
      .flatMap(([page, panel]) => saidIn(page, panel, KINDS[field]))
      .join('\n')
      .slice(0, MOST.field);
  const spoken = (own: readonly [PageDocument, number][]) =>
    Object.fromEntries(SPOKEN.map((field) => [field, saidOn(own, field)])) as Spoken;
  return new Map([...panels].map(([photo, own]) => [photo, spoken(own)]));
}

function saidIn({ words = [] }: PageDocument, panel: number, kind: Word['kind']): string[] {
  const place = ({ x, y }: Word) => (y ?? 0.5) + SLANT * (x ?? 0.5);
  return words
    .filter((word) => word.panel === panel && word.kind === kind)
    .sort((a, b) => place(a) - place(b))
    .map(({ text, by }) => {
      // Stars are emphasis.
      const plain = text.replaceAll('*', '').replace(/\s+/g, ' ').trim();
      // Speakers of a script are stored in lower case.
      const name = by?.replace(/(?<![\p{L}\p{M}’'])\p{L}/gu, (letter) => letter.toLocaleUpperCase());
      return name ? `${name}: ${plain}` : plain;
    });
}
