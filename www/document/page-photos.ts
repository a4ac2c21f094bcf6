/**
 * Which photos a page of a storyboard may show: here it is decided that a photo is on one page only. A page is planned
 * from its own photos and from those that no other page shows; where these are too few to fill it, from all.
 */

import { photosOn } from './sheets.ts';
import type { Planner } from '../engine/core.ts';
import type { PlanRequest } from '../engine/core.ts';
import type { PageDocument } from '../engine/types.ts';
import type { PhotoMeta } from '../engine/types.ts';

/**
 * @param all photos in use
 * @param elsewhere the other pages
 * @param current the page itself
 * @returns those that are free for the page, in the same order; all where it is the only page
 */
export function photosFor(
  all: readonly PhotoMeta[],
  elsewhere: readonly PageDocument[],
  current: PageDocument | null,
): readonly PhotoMeta[] {
  if (elsewhere.length === 0) return all;
  const taken = photosOn(elsewhere);
  const own = photosOn(current ? [current] : []);
  return all.filter(({ id }) => own.has(id) || !taken.has(id));
}

/**
 * What a plan has to be told of photos.
 * @param all photos in use
 * @param elsewhere the other pages
 */
export function casting(
  request: Omit<PlanRequest, 'photos'>,
  all: readonly PhotoMeta[],
  elsewhere: readonly PageDocument[],
  planner: Pick<Planner, 'layoutFacts'>,
): Pick<PlanRequest, 'photos' | 'panels'> {
  const { current } = request;
  const photos = [...photosFor(all, elsewhere, current)];
  if (elsewhere.length === 0) return { photos };
  if (photos.length < needed(request, planner)) return { photos: [...all] };
  const free = !request.keep.layout && !request.layout && !request.panels;
  const own = photosOn(current ? [current] : []);
  // Where no photo is left over, a page with fewer panels would leave some on no page: its photos keep their places.
  return free && photos.every(({ id }) => own.has(id)) ? { photos, panels: photos.length } : { photos };
}

/** @returns the photos that fill the page without repeats; one where its layout is still to be drawn */
function needed(
  { layout, panels, keep, current, page }: Omit<PlanRequest, 'photos'>,
  planner: Pick<Planner, 'layoutFacts'>,
): number {
  if (layout) return planner.layoutFacts(layout, page).count;
  if (panels) return panels;
  return keep.layout && current ? placesOf(current) : 1;
}

/** @returns the images on it: merged panels share one */
export function placesOf({ panels, merges }: PageDocument): number {
  return merges.reduce((places, group) => places - group.length + 1, panels.length);
}
