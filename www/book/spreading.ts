/** An album laid out over pages: how many, which photos on each, and words that go with their photos. */

import { MOST } from '../document/limits.ts';
import type { Plan } from '../document/pages.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { PhotoMeta } from '../engine/types.ts';

/** Seeds are tried this often for a layout that the two pages before do not have. */
const TRIES = 6;

/**
 * @param wish `photos` in their order, one at least; `before`: the pages whose words they keep; `per`: panels of a page at
 *   most; `counts`: numbers of panels that layouts have; `fixed`: the layout of every page that its photos fill
 */
export function spread({
  photos,
  before,
  style,
  per,
  counts,
  fixed,
  plan,
}: {
  photos: readonly PhotoMeta[];
  before: readonly PageDocument[];
  style: PageDocument['style'];
  per: number;
  counts: readonly number[];
  fixed: { layout: PageDocument['layout']; places: number } | null;
  plan: Plan;
}): PageDocument[] {
  // Of a large album a page has more photos than are wanted, so that there are not too many pages.
  const most = Math.max(per, Math.ceil(photos.length / MOST.sheets));
  const sizes =
    fixed && fixed.places >= photos.length / MOST.sheets
      ? filled(photos.length, fixed.places)
      : balanced(photos.length, most, counts);
  const made: PageDocument[] = [];
  let start = 0;
  for (const size of sizes) {
    const own = photos.slice(start, start + size);
    const layout = fixed?.places === size ? fixed.layout : undefined;
    const page = varied(made, () =>
      plan({
        keep: { layout: false, style: false, photos: false },
        current: null,
        style,
        photos: own,
        panels: size,
        ...(layout === undefined ? {} : { layout }),
      }),
    );
    if (page) made.push(withWords(page, before, own, plan));
    start += size;
  }
  return made;
}

/**
 * Pages of nearly the same number of photos each, so that no page is a leftover.
 * @param count of photos
 * @param most on a page
 * @param counts numbers of panels that layouts have; any while none is known
 * @returns the photos of each page
 */
export function balanced(count: number, most: number, counts: readonly number[]): number[] {
  const sizes = [];
  for (let rest = count; rest > 0; ) {
    const even = Math.ceil(rest / Math.ceil(rest / most));
    // Of photos that are more than its panels a page would leave some out.
    const size = counts.reduce((best, other) => (other <= even && other > best ? other : best), 0) || even;
    sizes.push(size);
    rest -= size;
  }
  return sizes;
}

/** @returns full pages, and the rest */
function filled(count: number, places: number): number[] {
  const rest = count % places;
  return [...Array.from({ length: Math.floor(count / places) }, () => places), ...(rest > 0 ? [rest] : [])];
}

/** @returns with another layout than the last two, if one was drawn */
export function varied(made: readonly PageDocument[], draw: () => PageDocument | null): PageDocument | null {
  const seen = made.slice(-2).map(({ layout }) => JSON.stringify(layout));
  let page = draw();
  for (let i = 1; i < TRIES && page && seen.includes(JSON.stringify(page.layout)); i += 1) page = draw();
  return page;
}

/** The page with the words that were on its photos before; those of a whole page stay on the first photo of theirs. */
function withWords(page: PageDocument, before: readonly PageDocument[], photos: PhotoMeta[], plan: Plan) {
  const words = before.flatMap((old) =>
    (old.words ?? []).flatMap((word) => {
      const photo = old.panels[word.panel ?? 0]?.photo;
      const panel = page.panels.findIndex((use) => use.photo === photo);
      return panel < 0 ? [] : [{ ...word, ...(typeof word.panel === 'number' ? { panel } : {}) } as Word];
    }),
  );
  if (words.length === 0) return page;
  const current = { ...page, words: words.slice(0, MOST.words) };
  return plan({ keep: { layout: true, style: true, photos: true }, current, seed: page.seed, photos }) ?? current;
}
