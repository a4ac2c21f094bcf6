/** The panels that are too coarse for paper: named before the page is saved, with a way to each, and marked on the page. */

import { useMemo } from 'preact/hooks';
import type { Geometry, PageDocument } from '../engine/types.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import type { Coarse } from './print.ts';
import { COARSE, coarsePanels } from './print.ts';

/** Maximum number of listed panels. The marks on the page show all of them. */
const NAMED = 3;

type Found = Coarse & { page: number };

/**
 * @param pages the exported pages. `only`: index of the page in the storyboard if a single page is exported. `enlarge`:
 * whether the photos of these panels are upscaled
 */
export function PrintCheck({
  pages,
  only,
  enlarge,
  change,
  close,
}: {
  pages: readonly PageDocument[];
  only: number | null;
  enlarge: boolean;
  change: (enlarge: boolean) => void;
  close: () => void;
}) {
  const { store, book, selection, ui } = useApp();
  const album = store.album.value;
  const found = useMemo((): Found[] => {
    const planner = store.planner.peek();
    if (!planner) return [];
    return pages.flatMap((page, i) =>
      coarsePanels(page, planner.geometry(page.layout, page.page), album, inchesOf(page)).map((coarse) => ({
        ...coarse,
        page: only ?? i,
      })),
    );
  }, [pages, only, album]);
  if (found.length === 0) return null;

  function go({ page, panel }: Found) {
    ui.printCheck.value = inchesOf(pages[only === null ? page : 0]);
    if (page !== book.at.peek()) book.go(page);
    close();
    selection.set([panel]);
  }

  return (
    <section class="print-check" aria-live="polite">
      <p>{strings.print.coarse({ n: found.length, dpi: COARSE })}</p>
      <ul>
        {found.slice(0, NAMED).map((coarse) => (
          <li key={`${coarse.page} ${coarse.panel}`}>
            <button type="button" class="link-button" onClick={() => go(coarse)}>
              {only === null
                ? strings.print.coarseOn({ page: coarse.page + 1, n: coarse.panel + 1, dpi: coarse.dpi })
                : strings.print.coarsePanel({ n: coarse.panel + 1, dpi: coarse.dpi })}
            </button>
          </li>
        ))}
        {found.length > NAMED && <li class="quiet">{strings.print.coarseMore({ n: found.length - NAMED })}</li>}
      </ul>
      <label class="check">
        <input type="checkbox" checked={enlarge} onChange={({ currentTarget }) => change(currentTarget.checked)} />
        <span>{strings.print.enlarge}</span>
      </label>
      <p class="quiet">{enlarge ? strings.print.enlargeHelp({ n: found.length }) : strings.print.coarseHelp}</p>
    </section>
  );
}

/** Marks on the panels of the page that are too coarse, until they are hidden or cured. */
export function CoarseMarks({ page, geometry }: { page: PageDocument; geometry: Geometry }) {
  const { store, ui } = useApp();
  const inches = ui.printCheck.value;
  const found = inches === null ? [] : coarsePanels(page, geometry, store.album.value, inches);
  if (found.length === 0) return null;
  return (
    <div class="coarse-marks">
      {found.map(({ panel, dpi }) => {
        const { x, y, width, height } = geometry.panels[panel].bounds;
        const style = { left: `${(x + width / 2) * 100}%`, top: `${((y + height / 2) / geometry.height) * 100}%` };
        return (
          <span key={panel} class="coarse-mark" style={style}>
            {strings.print.coarseMark({ dpi })}
          </span>
        );
      })}
    </div>
  );
}

/** Hides the marks. */
export function CoarseHide() {
  const { ui, actions } = useApp();
  if (ui.printCheck.value === null) return null;
  return <ActionButton action={actions.download.hideMarks} class="button coarse-hide" text />;
}

/** Width of a page on paper. */
function inchesOf({ page }: PageDocument) {
  return page.width / page.dpi;
}
