/**
 * The page, as large as the window allows: a canvas, and over it one focusable element a panel.
 */

import { useComputed } from '@preact/signals';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { Cuts, Gutters } from '../page/panels/cuts.tsx';
import { Insets } from '../page/panels/insets.tsx';
import { createPainter } from '../page/painter.ts';
import { Panels } from '../page/panels/panels.tsx';
import { Originals } from '../page/originals.tsx';
import { PanelSubjects } from '../photos/subject-boxes.tsx';
import { useSwipe } from '../page/swipe.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { WordLayer } from '../lettering/word-layer.tsx';
import { drawsParts, useSubjectsOf } from '../page/subjects-of.ts';
import { modelsOf } from '../painters/references.ts';
import { styleOfPage } from '../styles/style-actions.ts';
import { CoarseHide, CoarseMarks } from '../export/print-check.tsx';
import { SafeArea } from '../page/safe-area.tsx';
import { explain } from '../ui/explain.ts';
import type { App } from '../ui/context.ts';
import type { Store } from '../document/store.ts';

/** Maximum painted width of the page in pixels. A larger page takes too long, and hundreds of megabytes. */
const SHARPEST = 2800;

export function Stage() {
  const app = useApp();
  const { store, pages, engine, messages, ui, selection, lettering, reshaping, ahead, ownPainters } = app;
  const canvas = useRef(null as HTMLCanvasElement | null);
  const sheet = useRef(null as HTMLDivElement | null);
  const painter = useRef(null as ReturnType<typeof createPainter> | null);
  const width = useWidth(sheet);
  const area = useRef(null as HTMLDivElement | null);
  const pixels = Math.min(SHARPEST, screenPixels(width));
  // On a small screen two fingers enlarge everything.
  const zoom = ui.wide.value ? ui.zoom.value : 1;
  useHeldMiddle(area, zoom);
  const page = store.page.value;
  const geometry = store.geometry.value;
  const { settings } = store.project.value;
  const swipe = useSwipe(sheet, {
    forth: () => (atEnd(store) ? pages.shuffle('all') : pages.next()),
    back: pages.previous,
  });

  useLayoutEffect(() => {
    const alerts = messages.alertGroup();
    const made = createPainter(canvas.current as HTMLCanvasElement, {
      engine: {
        renderPictures: engine.renderPictures,
        subjectOf: (document, photo) => (drawsParts(store, document) ? store.masks.peek().get(photo) : undefined),
        modelsOf: ({ style }) => modelsOf(ownPainters.models.peek(), style),
        thumbnailOf: (id) => store.thumbnails.peek().get(id),
        isDraft: engine.isDraft,
        hasPhoto: (id) => !store.sketch.peek() && engine.hasPhoto(id),
      },
      onPainted: (document, whole) => {
        if (whole) alerts.clear();
        // A sketch is not visible yet.
        ui.painted.value = store.sketch.peek() ? null : document;
      },
      onError: (error) => alerts.report(strings.panelFailed({ why: explain(error) })),
    });
    painter.current = made;
    return () => {
      made.dispose();
      ui.painted.value = null;
    };
  }, []);

  // The pictures of another project are of no use any more.
  useLayoutEffect(() => () => painter.current?.forget(), [store.place.value]);

  const about = description(app);
  /** Said once a page, when it is there to be seen. */
  const [said, say] = useState('');
  useEffect(() => {
    if (ui.painted.value === page && about) say(about);
  }, [ui.painted.value, page, about]);

  const drafts = useComputed(() => {
    const shown = new Set(store.page.value?.panels.map(({ photo }) => photo));
    return store.facts.value.flatMap(({ id }) => (shown.has(id) && engine.isDraft(id) ? id : [])).join();
  }).value;
  // The number of imported photos is a dependency: panels fill during the import. Photos also replace drafts.
  const read = store.reading.value?.done;
  const sketch = store.sketch.value;
  const thumbnails = store.thumbnails.value;
  // The subject masks of photos are a dependency, if the style uses them.
  const subjects = useSubjectsOf(page);
  useLayoutEffect(() => {
    if (page && geometry && width > 0)
      painter.current?.show(page, geometry, pixels, reshaping.editing.peek() || reshaping.dragging.peek());
  }, [page, geometry, pixels, read, drafts, sketch, thumbnails, subjects]);

  const next = ahead.page.value;
  useLayoutEffect(() => {
    const planner = store.planner.peek();
    if (!next || !planner || width === 0) return;
    const drawing = painter.current?.prepare(next, planner.geometry(next.layout, next.page), pixels);
    drawing?.then((whole) => whole && pages.drawn(next));
  }, [next, pixels, subjects]);

  return (
    <section
      class="stage"
      aria-label={strings.page}
      aria-description={about}
      aria-busy={store.reading.value !== null || (page !== null && ui.painted.value !== page)}
    >
      <div
        class="stage-area"
        ref={area}
        data-zoomed={zoom > 1}
        {...(zoom > 1 ? {} : swipe)}
        onClick={() => {
          selection.clear();
          lettering.choose(-1);
        }}
        onWheelCapture={(event: WheelEvent) => {
          // If the page is larger than the window, the wheel scrolls it. With Ctrl, it zooms the photo of the panel, as
          // always.
          if (zoom > 1 && !event.ctrlKey) event.stopPropagation();
        }}
      >
        <div class="page" ref={sheet} style={{ '--aspect': settings.width / settings.height, '--zoom': zoom }}>
          <canvas ref={canvas} class="page-canvas" aria-hidden="true" />
          {page && <Originals page={page} width={pixels} />}
          {page && geometry && ui.wide.value && !reshaping.editing.value && <Gutters />}
          {page && geometry && <Panels page={page} geometry={geometry} />}
          {page && geometry && !reshaping.editing.value && (
            <WordLayer page={page} geometry={geometry} width={width > 0 ? pixels : 0} />
          )}
          {page && geometry && ui.subjects.value && <PanelSubjects page={page} geometry={geometry} />}
          {page && ui.safeArea.value && <SafeArea settings={settings} />}
          {page && geometry && <CoarseMarks page={page} geometry={geometry} />}
          {page && geometry && reshaping.editing.value && <Cuts />}
          {page && geometry && reshaping.editing.value && <Insets geometry={geometry} />}
        </div>
        {page && <CoarseHide />}
      </div>
      {page && ui.wide.value && (zoom > 1 || ui.preview.value) && (
        <div class="stage-tools">
          <ActionButton action={app.actions.window.enlargePage} class="icon-button" />
          <ActionButton action={app.actions.window.shrinkPage} class="icon-button" />
          <ActionButton action={app.actions.window.preview} class="icon-button" />
        </div>
      )}
      <p class="visually-hidden" aria-live="polite">
        {said}
      </p>
      {!page && <p class="stage-note">{strings.noPhotosInUse}</p>}
    </section>
  );
}

/** Describes layout and style of the page. Each panel describes its content. */
function description(app: App) {
  const { store } = app;
  const layout = store.layoutFacts.value;
  const style = styleOfPage(app);
  if (!store.page.value) return undefined;
  return strings.pageHolds({
    panels: store.page.value.panels.length,
    layout: layout ? strings.layoutTitle(layout) : '',
    style: style ? strings.styleTitle(style) : strings.ownStyle,
  });
}

function atEnd(store: Store) {
  return store.versions.peek().at(-1)?.id === store.project.peek().pageId;
}

/** @returns the width of an element in CSS pixels, as it changes */
function useWidth(ref: { current: Element | null }): number {
  const [width, setWidth] = useState(0);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => setWidth(Math.round(entry.contentRect.width)));
    if (ref.current) observer.observe(ref.current);
    return () => observer.disconnect();
  }, []);
  return width;
}

/** Keeps the centre of the view fixed when the page changes its size. */
function useHeldMiddle(ref: { current: HTMLElement | null }, zoom: number) {
  const middle = useRef({ x: 0.5, y: 0.5 });
  const before = useRef(1);
  useEffect(() => {
    const area = ref.current;
    if (!area) return undefined;
    const look = () => {
      middle.current = {
        x: (area.scrollLeft + area.clientWidth / 2) / area.scrollWidth,
        y: (area.scrollTop + area.clientHeight / 2) / area.scrollHeight,
      };
    };
    area.addEventListener('scroll', look, { passive: true });
    return () => area.removeEventListener('scroll', look);
  }, []);
  useLayoutEffect(() => {
    const area = ref.current;
    // A page that fits does not scroll, and reading its size would force a layout of the window.
    if (!area || (zoom <= 1 && before.current <= 1)) return;
    before.current = zoom;
    const { x, y } = zoom > 1 ? middle.current : { x: 0.5, y: 0.5 };
    area.scrollTo(x * area.scrollWidth - area.clientWidth / 2, y * area.scrollHeight - area.clientHeight / 2);
    middle.current = { x, y };
  }, [zoom]);
}
