/**
 * A cache of panel pictures. Each is rendered once, shared, and cached for a while, so that the previous page appears
 * at once. A panel and the subject that breaks its border are one job.
 */

import { drawnWith, panelOf } from '../engine/figures.ts';
import { Priority } from '../engine/queue.ts';
import type { Bounds, Geometry, PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';

/** `page`: the width of the page it was drawn for; `crop` of the photo in `bounds` of the page */
export type Patch = {
  x: number;
  y: number;
  width: number;
  height: number;
  bitmap: ImageBitmap;
  page: number;
  crop: Bounds | null;
  bounds: Bounds;
};
/** `stop` cancels the job. `promote` makes it urgent, if no view needed its pictures before. */
type Flight = { promise: Promise<Patch>; stop: AbortController; promote: () => void };

/** Maximum bytes of cached pictures: a dozen pages on a large screen. */
const BUDGET = 96 * 2 ** 20;

/**
 * @param subjectOf the subject mask of a photo, if the style of the page uses it
 * @param modelsOf the models of the user that the style of the page uses
 * @param isDraft whether only a smaller copy of a photo was read
 */
export function createPatches(
  render: Engine['renderPictures'],
  subjectOf: (document: PageDocument, photo: string) => string | undefined = () => undefined,
  modelsOf: (document: PageDocument) => string = () => '',
  isDraft: (photo: string) => boolean = () => false,
) {
  /** Oldest first. */
  const kept: Map<string, Patch> = new Map();
  const flights: Map<string, Flight> = new Map();
  /** Quick pictures that are being drawn, by their panels. */
  const sketches: Map<number, { document: PageDocument; page: number; patches: Promise<Patch[]> }> = new Map();
  let bytes = 0;
  /** Rendering time of a page per style, in ms per pixel. */
  const pace: Map<string, number> = new Map();

  return { signature, cached, get, coarse, keepOnly, expected, forget, dispose };

  /**
   * The key of a picture. It contains only the shapes of the panel and of panels that share its image, so moving a
   * divider elsewhere does not change it. The number of panels is included, because it changes the width of lines.
   * @returns all that the picture depends on
   */
  function signature(document: PageDocument, geometry: Geometry, picture: number, width: number): string {
    const { style, page, merges, panels } = document;
    const index = panelOf(document, picture);
    const group = merges.find((other) => other.includes(index)) ?? [index];
    const { photo, crop, faces } = panels[group[0]];
    const shapes = group.map((i) => geometry.panels[i]);
    return JSON.stringify([
      style,
      modelsOf(document),
      page,
      photo,
      crop,
      faces,
      photo === null ? null : [subjectOf(document, photo), isDraft(photo)],
      geometry.panels[index],
      shapes,
      geometry.panels.filter(({ overlay }) => !overlay).length,
      width,
      // A panel is cut out of the picture of its subject. That picture does not depend on the faces of other panels.
      drawnWith(document, index).length > 1
        ? [picture, panels[index].figure, panels.map((panel) => [panel.crop, panel.faces]), geometry.panels]
        : null,
    ]);
  }

  function cached(key: string): Patch | null {
    const patch = kept.get(key);
    if (!patch) return null;
    kept.delete(key);
    kept.set(key, patch);
    return patch;
  }

  /** @param ahead whether no view needs the picture yet, so that it is rendered last */
  function get(
    key: string,
    document: PageDocument,
    geometry: Geometry,
    index: number,
    width: number,
    ahead = false,
  ): Promise<Patch> {
    const before = flights.get(key);
    if (before) {
      if (!ahead) before.promote();
      return before.promise;
    }
    const stop = new AbortController();
    const start = performance.now();
    const priority = ahead ? Priority.REST : Priority.PANEL;
    let promote = () => {};
    const promoted = new Promise<void>((resolve) => {
      promote = resolve;
    });
    // Pictures that exist or are being rendered are not rendered again. A picture is identical whether it is rendered
    // separately or in a group.
    const lacks = (other: string) => other === key || (!kept.has(other) && !flights.has(other));
    const keyOf = (picture: number) => (picture === index ? key : signature(document, geometry, picture, width));
    const pictures = drawnWith(document, index).filter((picture) => lacks(keyOf(picture)));
    const keys = pictures.map(keyOf);
    const job = render(document, pictures, width, { tier: 'work', priority, promoted, signal: stop.signal }).then(
      (patches) => {
        if (!ahead) learn(document, width, performance.now() - start);
        const about = { page: width, ...shown(document, geometry, index) };
        return patches.map((patch, at) => keep(keys[at], { ...patch, ...about }));
      },
    );
    const landed = () => {
      for (const own of keys) if (flights.get(own)?.stop === stop) flights.delete(own);
    };
    job.then(landed, landed);
    const flightOf = (at: number) => ({ promise: job.then((patches) => patches[at]), stop, promote });
    const flying = keys.map((_, at) => flightOf(at));
    flying.forEach((flight, at) => {
      flights.set(keys[at], flight);
      // The other pictures of the job may have no reader.
      flight.promise.catch(() => {});
    });
    return flying[keys.indexOf(key)].promise;
  }

  /** A quick picture at half the size, from the small copy of the photo. */
  async function coarse(document: PageDocument, geometry: Geometry, index: number, width: number): Promise<Patch> {
    const page = Math.ceil(width / 2);
    const panel = panelOf(document, index);
    const pictures = drawnWith(document, index);
    let sketch = sketches.get(panel);
    if (sketch?.document !== document || sketch.page !== page) {
      const key = `coarse/${panel}`;
      const patches = render(document, pictures, page, { tier: 'small', priority: Priority.PANEL, key }).then((drawn) =>
        drawn.map((patch) => ({ ...patch, page, ...shown(document, geometry, panel) })),
      );
      const own = { document, page, patches };
      const done = () => {
        if (sketches.get(panel) === own) sketches.delete(panel);
      };
      patches.then(done, done);
      sketches.set(panel, own);
      sketch = own;
    }
    return (await sketch.patches)[pictures.indexOf(index)];
  }

  /** Cancels the pictures that no view needs any more. */
  function keepOnly(wanted: string[]) {
    const needed = new Set(wanted.map((key) => flights.get(key)?.stop));
    for (const { stop } of flights.values()) if (!needed.has(stop)) stop.abort();
  }

  /** Measures the time of a page. Its panels are requested together, so the last one gives the total. */
  function learn({ style, page }: PageDocument, width: number, ms: number) {
    const name = JSON.stringify(style);
    const now = ms / ((width * width * page.height) / page.width);
    pace.set(name, Math.max(now, (pace.get(name) ?? 0) * 0.8));
  }

  /** @returns the expected time of the page, in ms */
  function expected({ style, page }: PageDocument, width: number): number {
    return ((pace.get(JSON.stringify(style)) ?? 0) * width * width * page.height) / page.width;
  }

  function keep(key: string, patch: Patch) {
    kept.set(key, patch);
    bytes += size(patch);
    for (const [old, { bitmap }] of kept) {
      if (bytes <= BUDGET || old === key) break;
      bytes -= size({ bitmap });
      kept.delete(old);
      // Not closed, because the canvas may still show it. The browser frees it after the last reference is gone.
    }
    return patch;
  }

  function forget() {
    kept.clear();
    bytes = 0;
  }

  function dispose() {
    for (const { stop } of flights.values()) stop.abort();
    forget();
  }
}

function size({ bitmap }: { bitmap: ImageBitmap }) {
  return bitmap.width * bitmap.height * 4;
}

/**
 * The part of the photo that a panel's image shows, and the position of the image. Merged panels share the image of
 * their group.
 */
export function shown(
  document: PageDocument,
  geometry: Geometry,
  picture: number,
): { crop: Bounds | null; bounds: Bounds } {
  const { panels, merges } = document;
  const index = panelOf(document, picture);
  const group = merges.find((other) => other.includes(index)) ?? [index];
  const boxes = group.map((i) => geometry.panels[i].bounds);
  const [x, y] = [Math.min(...boxes.map((box) => box.x)), Math.min(...boxes.map((box) => box.y))];
  const width = Math.max(...boxes.map((box) => box.x + box.width)) - x;
  const height = Math.max(...boxes.map((box) => box.y + box.height)) - y;
  return { crop: panels[group[0]].crop, bounds: { x, y, width, height } };
}
