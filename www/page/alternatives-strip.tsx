/**
 * A strip of alternative pages that grows during scrolling.
 */

import { useEffect, useMemo, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { usePageGlimpse } from '../ui/glimpse.tsx';
import { pointing } from '../ui/pointing.ts';
import { Thumbnail, screenPixels, useInView } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { useSubjectsOf } from './subjects-of.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Point } from '../ui/pointing.ts';

/** Number of pages per batch: more than any strip shows at once. */
const BATCH = 24;

export function Alternatives() {
  const { store, alternatives, lettering, scheduler, ui, actions } = useApp();
  const strip = useRef(null as HTMLUListElement | null);
  const end = useRef(null as HTMLLIElement | null);
  const atEnd = useInView(end);
  const items = alternatives.items.value;
  const basis = alternatives.basis.value;
  const open = ui.ideas.value || !ui.wide.value;
  const glimpse = usePageGlimpse((number) => {
    const page = alternatives.items.peek()[Number(number) - 1];
    return page ? lettering.on(page) : null;
  });

  // Both run in separate tasks: scrolling forces a layout of the page, and planning pages takes longer than rendering the
  // change.
  useEffect(() => {
    const frame = requestAnimationFrame(() => strip.current?.scrollTo({ left: 0 }));
    return () => cancelAnimationFrame(frame);
  }, [basis]);
  useEffect(() => {
    if (!open || basis === '' || (!atEnd && items.length > 0)) return undefined;
    const stop = new AbortController();
    scheduler.background(() => alternatives.more(BATCH), stop);
    return () => stop.abort();
  }, [open, basis, atEnd, items]);

  function onWheel(event: WheelEvent) {
    // A vertical wheel scrolls the strip sideways.
    if (event.deltaX === 0 && !event.ctrlKey && strip.current) strip.current.scrollLeft += event.deltaY;
  }

  return (
    <section class="alternatives" aria-label={strings.alternatives} aria-busy={basis === ''} data-open={open}>
      {ui.wide.value && <ActionButton action={actions.page.ideas} class="tool ideas-head" text opens />}
      <ul class="strip" ref={strip} onWheel={onWheel} onPointerLeave={() => glimpse.point(null)} hidden={!open}>
        {items.map((page, i) => (
          <Alternative key={`${basis}/${i}`} page={page} number={i + 1} point={glimpse.point} />
        ))}
        {items.length === 0 &&
          Array.from({ length: BATCH }, (_, i) => (
            <li key={i} class="alternative">
              <span class="bitmap" />
            </li>
          ))}
        <li class="strip-end" ref={end} aria-hidden="true" />
      </ul>
      {glimpse.view}
      {store.page.value && items.length === 0 && <span class="visually-hidden">{strings.alternativesWait}</span>}
    </section>
  );
}

function Alternative({ page, number, point }: { page: PageDocument; number: number; point: Point }) {
  const { store, pages, engine, lettering } = useApp();
  const words = lettering.rested.value;
  // Text items belong to the story, so the alternatives show the text of this page.
  const shown = useMemo(() => lettering.on(page), [page, words]);
  const ref = useRef(null as HTMLButtonElement | null);
  const width = () => screenPixels(ref.current?.clientWidth ?? 100);
  return (
    <li class="alternative" style={{ '--aspect': page.page.width / page.page.height }}>
      <button
        type="button"
        ref={ref}
        aria-label={strings.alternative({ n: number })}
        aria-current={store.page.value === shown ? 'true' : undefined}
        {...pointing(String(number), point)}
        onBlur={() => point(null)}
        onClick={() => pages.show(lettering.on(page))}
      >
        <Thumbnail of={shown} by={useSubjectsOf(shown)} draw={(call) => engine.pageFile(shown, width(), call)} />
      </button>
    </li>
  );
}
