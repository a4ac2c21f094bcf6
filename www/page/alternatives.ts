/**
 * An endless stream of alternative pages, planned as they scroll into view. It depends on the unused photos, the page
 * settings, the number of panels, and the locks. Choosing one of its pages or editing text does not restart it. Planning
 * stops while a page is planned or drawn, and a moment after, because it takes as long as many shuffles.
 */

import { computed, signal, untracked } from '@preact/signals';
import { sheetsOf } from '../engine/sheets.ts';
import { DARK_PAPER } from './paper.ts';
import { DEFAULT_SETTINGS } from '../document/empty.ts';
import type { Pages } from '../document/pages.ts';
import type { Scheduler } from '../engine/scheduler.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument, PageSettings } from '../engine/types.ts';
import type { Signal } from '@preact/signals';

export type Alternatives = ReturnType<typeof createAlternatives>;

/** Seeds are tried this often for a page that is not in the stream yet; then there are no more. */
const TRIES = 12;
/** Maximum milliseconds of continuous planning: the duration of a frame, so that the app stays responsive. */
const STRETCH = 12;

export function createAlternatives({
  store,
  pages,
  scheduler,
}: {
  store: Store;
  pages: Pages;
  scheduler: Pick<Scheduler, 'turn'>;
}) {
  /** The photos of all pages, as text. Other changes of a page keep the free photos. */
  const shown = computed(() =>
    JSON.stringify(sheetsOf(store.project.value).map(({ page }) => page.panels.map(({ photo }) => photo))),
  );
  const free = computed(() => {
    const isSome = store.photos.value.length > 0 && shown.value !== '';
    return isSome && untracked(() => store.plans().freePhotos());
  });
  /** The inputs of the stream, as text. */
  const basis = computed(() => {
    const { project, reading, planner } = store;
    const { page, locks, panels, settings, styling, sheet } = project.value;
    // The first page has priority. Nothing else is drawn while it waits for photos.
    if (!planner.value || !page || reading.value) return '';
    return JSON.stringify([
      free.value,
      sheet,
      chosen(settings),
      panels,
      locks,
      styling,
      locks.layout && page.layout,
      locks.style && page.style,
      locks.photos && [page.order, page.panels],
      page.panels.filter(({ locked }) => locked).map(({ photo }) => photo),
    ]);
  });

  const stream: Signal<{ basis: string; items: readonly PageDocument[]; over: boolean }> = signal({
    basis: '',
    items: [],
    over: false,
  });
  const empty = { items: [] as readonly PageDocument[], over: false };
  let running = false;

  return {
    basis,
    /** The pages made so far. */
    items: computed(() => (stream.value.basis === basis.value ? stream.value : empty).items),
    more,
  };

  /** Makes the stream longer, a few pages at a stretch. */
  async function more(count: number) {
    if (running) return;
    running = true;
    try {
      const now = basis.peek();
      const goal = current(now).items.length + count;
      while (now !== '' && basis.peek() === now && !current(now).over && current(now).items.length < goal) {
        stretch(now, goal);
        await scheduler.turn('background');
      }
    } finally {
      running = false;
    }
    // Its inputs have changed, so the stream starts again.
    if (basis.peek() !== '' && current(basis.peek()).items.length === 0 && !current(basis.peek()).over)
      await more(count);
  }

  function current(now: string) {
    return stream.peek().basis === now ? stream.peek() : empty;
  }

  function stretch(now: string, goal: number) {
    const fresh = [...current(now).items];
    const known = new Set(fresh.map(look));
    const end = performance.now() + STRETCH;
    let tries = 0;
    while (fresh.length < goal && tries < TRIES && (performance.now() < end || tries > 0)) {
      const page = pages.plan({
        keep: { ...store.project.peek().locks },
        mode: 'shuffle',
        avoid: before(fresh),
        recent: fresh.map(photosOf),
      });
      if (!page || known.has(look(page))) {
        tries += 1;
        continue;
      }
      tries = 0;
      known.add(look(page));
      fresh.push(page);
    }
    stream.value = { basis: now, items: fresh, over: tries >= TRIES };
  }
}

/** @returns the settings without the colours that the style of a page chooses. Then a shuffle does not restart the stream. */
function chosen({ paper, borderColor, ...others }: PageSettings): Partial<PageSettings> {
  const automatic = [DEFAULT_SETTINGS, DARK_PAPER].some(
    (colours) => colours.paper === paper && colours.borderColor === borderColor,
  );
  return automatic ? others : { ...others, paper, borderColor };
}

/**
 * @returns the photos of a planned page, so that the next pages show others. The first id is empty, because the photo
 * of the leading panel is unknown
 */
function photosOf({ panels }: PageDocument): string[] {
  return ['', ...panels.flatMap(({ photo }) => photo ?? [])];
}

/**
 * @returns layout and style of the page before the next one, because two successive pages with equal values look alike
 */
function before(items: readonly PageDocument[]): { layouts: string[]; styles: string[] } {
  const last = items.at(-1);
  const idOf = (plan: string | object | undefined) => (typeof plan === 'object' ? (plan as { id?: string }).id : plan);
  const [layout, style] = [idOf(last?.layout), idOf(last?.style)];
  return { layouts: layout === undefined ? [] : [layout], styles: style === undefined ? [] : [style] };
}

/** @returns an equal text for pages that look equal */
function look(page: PageDocument): string {
  return JSON.stringify({ ...page, seed: 0 });
}
