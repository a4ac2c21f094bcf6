/**
 * The designer: the draft on its table, what is done to it, and where it goes. The draft is a part of the project, so
 * undo and redo walk through its edits as through all others; while a slider is dragged it is held apart, and the
 * whole drag is one step.
 */

import { computed, signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { draftOf, edit, emptyDraft, misfits, styleOf } from './designer-draft.ts';
import type { Messages } from '../ui/messages.ts';
import type { Ui } from '../app/ui.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Style } from '../engine/types.ts';
import type { Draft, Edit, Layer } from './designer-draft.ts';
import type { Signal } from '@preact/signals';

export type Designer = ReturnType<typeof createDesigner>;

export function createDesigner({
  store,
  pages,
  messages,
  ui,
  freshId,
}: {
  store: Store;
  pages: Pages;
  messages: Messages;
  ui: Pick<Ui, 'work'>;
  freshId: () => string;
}) {
  const blocks = computed(() => store.planner.value?.blocks() ?? []);
  /** The draft in the middle of a drag. */
  const held: Signal<Draft | null> = signal(null);
  let gestures = 0;

  const draft = computed(() => held.value ?? store.project.value.draft);
  /** What the preview shows: blocks that lack something are passed over. */
  const shown = computed(() => draft.value && styleOf(draft.value, blocks.value, { tolerant: true }));
  /** Whether the page is in this very style, so that it follows each edit. */
  const onPage = computed(() => {
    const style = store.page.value?.style;
    return typeof style === 'object' && style.id !== undefined && style.id === store.project.value.draft?.id;
  });

  return {
    blocks,
    draft,
    shown,
    onPage,
    layer: signal('background' as Layer),
    open,
    close,
    begin,
    beginWithPage,
    change,
    hold,
    release,
    use,
    checked,
  };

  /** @param style to begin with; the draft as it was left unless told */
  function open(style?: Style) {
    if (style) begin(style);
    else if (!store.project.peek().draft) keep(emptyDraft(freshId(), strings.untitledStyle), { silent: true });
    ui.work.value = 'designer';
  }

  function close() {
    release();
    ui.work.value = null;
  }

  /**
   * A new draft. A designed style is copied under an id of its own, so that it stays as it is in the catalogue.
   * @param style nothing begins with an empty one
   */
  function begin(style: Style | null) {
    release();
    if (!style) keep(emptyDraft(freshId(), strings.untitledStyle));
    else {
      const fresh = draftOf(style, blocks.peek());
      const designed = store.planner
        .peek()
        ?.styles()
        .some(({ id }) => id === style.id);
      keep(designed ? { ...fresh, id: freshId(), name: strings.copyOf(style.name) } : fresh);
    }
  }

  /** A new draft of the style that the page has. */
  function beginWithPage() {
    const style = store.page.peek()?.style;
    const known =
      typeof style === 'object'
        ? style
        : store.planner
            .peek()
            ?.styles()
            .find(({ id }) => id === style);
    if (known) begin(known as Style);
  }

  function change(change: Edit) {
    release();
    const before = store.project.peek().draft;
    if (!before) return;
    const after = edit(before, change, blocks.peek());
    if (after !== before) keep(after);
  }

  /** An edit in the middle of a drag, which `release` ends. */
  function hold(change: Edit) {
    const before = draft.peek();
    if (before) held.value = edit(before, change, blocks.peek());
  }

  function release() {
    const after = held.peek();
    held.value = null;
    if (after && after !== store.project.peek().draft) keep(after);
  }

  function keep(after: Draft, how?: { silent?: boolean }) {
    const follows = onPage.peek() && store.project.peek().draft?.id === after.id && whole(after);
    gestures += 1;
    const gesture = `design-${gestures}`;
    store.change({ type: 'design', draft: after, gesture, ...how });
    const page = store.page.peek();
    if (follows && page) pages.amend({ ...page, style: styleOf(after, blocks.peek()) }, { gesture });
  }

  /** @returns whether every block can work where it is */
  function whole(of: Draft): boolean {
    return [of.background, of.foreground].every((steps) =>
      misfits(steps, blocks.peek()).every((lacks) => lacks === ''),
    );
  }

  /** @returns the draft as a style file that the core has checked; what is wrong is said */
  function checked(): Style | null {
    release();
    const now = store.project.peek().draft;
    const planner = store.planner.peek();
    if (!now || !planner) return null;
    try {
      return planner.checkStyle(JSON.stringify(styleOf(now, blocks.peek())), now.name.trim() || now.id);
    } catch (error) {
      messages.alert((error as Error).message);
      return null;
    }
  }

  /** Puts the page into this style, and shows it. */
  function use() {
    const style = checked();
    if (!style) return;
    pages.chooseStyle(style);
    ui.work.value = null;
  }
}
