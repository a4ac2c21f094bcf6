/**
 * The tools of the selection: a text item, one panel, several panels, the layout while it is edited, or the page. A few tools that can be
 * used are shown; `More` has the others, each with the reason why it cannot be used.
 */

import { useLayoutEffect } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { wordName } from '../document/word-names.ts';
import { useApp } from '../ui/context.ts';
import { isEnabled, now } from '../ui/action.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { BookProgress } from './book-progress.tsx';
import type { Action } from '../ui/action.ts';
import type { App } from '../ui/context.ts';

/** Tools besides `More`: at most; while a photo is cropped; on a small screen; and for a page that was shuffled, as a first page is not crowded by tools. */
const SHOWN = { most: 5, crop: 6, small: 4, page: 2 };

/** `kind` of the selection; `shown`: tools besides `More`; `end`: ends the mode that the tools belong to */
type Tools = {
  kind: 'text' | 'layout' | 'crop' | 'panels' | 'panel' | 'page';
  title: string;
  tools: readonly Action[];
  shown: number;
  end?: Action;
};

/** @param props `bare`: show only the effect of the next click, if another bar is open */
export function ContextBar({ bare = false }: { bare?: boolean }) {
  const app = useApp();
  const { ui, lettering } = app;
  const found = bare ? null : toolsFor(app);
  const open = ui.allTools.value;
  // Another selection begins with a few tools. A passive effect would close tools that were opened right after a selection.
  useLayoutEffect(() => {
    ui.allTools.value = false;
  }, [found?.kind]);
  const usable = found?.tools.filter(isEnabled) ?? [];
  const first = usable.slice(0, found?.shown);
  const rest = found?.tools.filter((tool) => !first.includes(tool)) ?? [];
  const more = {
    label: strings.more,
    icon: open ? 'unfold' : 'dots',
    on: open,
    run() {
      ui.allTools.value = !open;
    },
  };
  return (
    <div
      class="context-bar"
      role="toolbar"
      aria-label={lettering.chosen.value >= 0 ? strings.wordBar : strings.panelTools}
      data-kind={found?.kind}
      data-open={open}
    >
      <p class="context-title" aria-live="polite">
        {found?.title}
      </p>
      {found && (
        <>
          {first.map((tool) => (
            <ActionButton key={now(tool.label)} action={tool} class="tool" text />
          ))}
          {rest.length > 0 && <ActionButton action={more} class="tool" text opens />}
          {open && rest.map((tool) => <ActionButton key={now(tool.label)} action={tool} class="tool" text explains />)}
          {found.end && <ActionButton action={found.end} class="tool tool-end" text />}
        </>
      )}
      {/* A large screen shows it below the list, which scrolls. */}
      {!ui.wide.value && <ModeHint />}
      <BookProgress />
    </div>
  );
}

/** The effect of the next click or key on the page. */
export function ModeHint() {
  const { framing, reshaping, selection, lettering } = useApp();
  const mode = framing.mode.value;
  const aim = lettering.mode.value;
  const edits = reshaping.editing.value && reshaping.cut.value === null && selection.panels.value.length === 0;
  const kind = mode?.kind ?? (framing.placing.value !== null ? 'place' : edits ? 'layout' : null);
  return (
    <p class="context-hint" aria-live="polite">
      {aim ? strings.wordModes[aim] : kind && strings.modes[kind]}
    </p>
  );
}

/** Returns null on a small screen without a selection. */
export function toolsFor({
  store,
  book: pages,
  selection,
  reshaping,
  framing,
  scrubbing,
  lettering,
  actions,
  ui,
}: App): Tools | null {
  const { panels, layouts, book, styles, page, photos, window } = actions;
  const facts = store.layoutFacts.value;
  const chosen = selection.panels.value;
  const [panel, other] = chosen;
  const wide = ui.wide.value;
  const shown = wide ? SHOWN.most : SHOWN.small;
  if (!facts) return null;
  const index = lettering.chosen.value;
  const word = lettering.words.value[index];
  if (word) {
    const { edit, format, smaller, larger, pointTail, remove, place, move, removeTail } = actions.text;
    const tail = word.kind === 'balloon' ? [pointTail] : [];
    const more = word.kind === 'balloon' ? [removeTail] : [];
    // On a large screen, the fields of the text item are next to the page already.
    const tools = wide ? [edit, smaller, larger, ...tail, remove] : [edit, format, smaller, larger, remove, ...tail];
    return {
      kind: 'text',
      title: wordName(word, lettering.textOf(index)),
      tools: [...tools, place, move, ...more],
      shown: SHOWN.most,
    };
  }
  const merged = isEnabled(panels.split) ? [panels.split] : [];
  if (reshaping.editing.value) {
    const cuts = [panels.cutBack, panels.cutForth, panels.slantBack, panels.slantForth];
    const cells = [panels.splitRows, panels.splitColumns, panels.remove, panels.join];
    const { insetLeft, insetRight, insetUp, insetDown, insetLarger, insetSmaller } = panels;
    const insets = [insetLarger, insetSmaller, insetLeft, insetRight, insetUp, insetDown];
    const isInset = panel !== undefined && isEnabled(insetLarger);
    return {
      kind: 'layout',
      title: strings.editLayout,
      tools: isInset ? [...insets, panels.remove] : panel === undefined ? [...cuts, ...cells] : [...cells, ...cuts],
      shown: isInset && wide ? insets.length : shown - 1,
      end: panels.done,
    };
  }
  if (panel !== undefined && other === undefined && framing.cropping.value === panel)
    return {
      kind: 'crop',
      title: strings.crop,
      tools: [panels.zoomIn, panels.zoomOut, panels.rotate, panels.flip, panels.fit, panels.reset].filter(isEnabled),
      shown: wide ? SHOWN.crop : SHOWN.small,
      end: panels.cropped,
    };
  if (other !== undefined || selection.several.value)
    return {
      kind: 'panels',
      title: chosen.length > 0 ? strings.chosenPanels({ n: chosen.length }) : strings.selectPanels,
      tools: [panels.join, panels.merge, ...(chosen.length === 2 ? [panels.swap] : []), ...merged, panels.select],
      shown,
    };
  if (panel !== undefined) {
    const { crop, replace, lock, star, splitPanel, swap, rotate, flip } = panels;
    const { breakFrame, correct, saveSubject, save, remove } = panels;
    const frame = scrubbing.isFrame(panel) ? [panels.earlier, panels.later] : [];
    return {
      kind: 'panel',
      title: strings.panel({ n: panel + 1, of: store.page.value?.panels.length ?? 0 }),
      tools: [
        // A locked panel has neither Crop nor Replace. `lock` is first, so that it does not move under the pointer.
        ...[lock, crop, replace, star, splitPanel, ...merged, ...frame, swap, rotate, flip],
        ...[panels.fit, panels.focus, panels.reset],
        ...[breakFrame, correct, remove, panels.select, save, saveSubject],
      ],
      shown,
    };
  }
  if (!wide) return null;
  const isFirst = store.pageHistory.value.length < 2;
  // A book is offered as long as many photos are on no page.
  const several = pages.several.value;
  const isAlbum = !several && pages.areManyLeft.value && isEnabled(book.make);
  const offers = [...(isEnabled(page.acceptCrops) ? [page.acceptCrops] : []), ...(isAlbum ? [book.make] : [])];
  return {
    kind: 'page',
    title: strings.sideTab.page,
    tools: [
      ...offers,
      // With several pages, the list of pages has these buttons.
      ...(several ? [] : [book.add]),
      ...[
        layouts.edit,
        ...(isAlbum || several ? [] : [book.make]),
        ...(isEnabled(book.makeChapters) ? [book.makeChapters] : []),
        styles.edit,
        book.spread,
        styles.shuffleSettings,
        panels.select,
      ],
      ...[photos.subjects, window.originals, window.enlargePage, window.shrinkPage, window.preview],
    ],
    shown: offers.length + (isFirst ? 0 : SHOWN.page),
  };
}
