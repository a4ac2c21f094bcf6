/**
 * The designer: the current draft, its edits, and saving it. The draft is a part of the project, so undo and redo
 * include its edits. While a slider is dragged the draft is separate, and the whole drag is one step.
 */

import { computed, signal, untracked } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { MOST, wellFormed } from '../document/limits.ts';
import { explain } from '../ui/explain.ts';
import type { Messages } from '../ui/messages.ts';
import type { Ui } from '../ui/ui.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Draft, DraftEdit, DraftFacts, Layer, Place, Style } from '../engine/types.ts';
import type { Signal } from '@preact/signals';

export type Designer = ReturnType<typeof createDesigner>;

export const LAYERS: readonly Layer[] = ['background', 'foreground'];

/** Blocks that show nothing useful without the block after them: pen lines are gray until a threshold makes ink and paper. */
const FOLLOWERS: Readonly<Record<string, string>> = { xdog: 'soft_threshold' };

/** Returns the block that comes with another one, unless it is the next block already. */
export function followerOf(block: string, next: string | undefined): string | null {
  const follower = FOLLOWERS[block] ?? null;
  return follower === next ? null : follower;
}

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
  /** The draft of the page's style that the designer opened with. */
  let opened: Draft | null = null;

  const draft = computed(() => held.value ?? store.project.value.draft);
  const facts = computed(() => (draft.value && store.planner.value?.draftFacts(draft.value)) ?? null);
  /** The style for the preview. Blocks without their input are skipped. */
  const shown = computed(() => facts.value?.shown ?? null);
  /** Whether the page is in this very style, so that it follows each edit. */
  const onPage = computed(() => {
    const style = store.page.value?.style;
    return typeof style === 'object' && style.id !== undefined && style.id === store.project.value.draft?.id;
  });

  const id = computed(() => draft.value?.id);
  /** The page on the paper that it would have after `use`: the core chooses it by the id of the style. */
  const sheet = computed(() => {
    const page = store.page.value;
    if (!page || id.value === undefined || onPage.value) return page;
    const style = untracked(() => shown.value);
    const used = style && untracked(() => pages.preview({ type: 'choose-style', style, seed: 0 }));
    return used ? { ...page, page: used.page } : page;
  });

  /** Position of the next block from the palette. Default: at the end. */
  const place: Signal<{ layer: Layer; at: number | null }> = signal({ layer: 'background', at: null });

  return {
    blocks,
    draft,
    facts,
    shown,
    onPage,
    sheet,
    place,
    /** Content of the preview. */
    preview: signal('photo') as Signal<'photo' | 'page'>,
    /** Selects the layer that receives new blocks at its end. */
    turnTo(layer: Layer) {
      if (place.peek().layer !== layer) place.value = { layer, at: null };
    },
    factsBefore,
    insert,
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

  /** @param style the first style; default: the last edited draft, or the style of the page */
  function open(style?: Style) {
    const last = store.project.peek().draft;
    if (style) begin(style);
    else if (!last || last === opened) {
      begin(pageStyle(), { silent: true });
      opened = store.project.peek().draft;
    }
    ui.work.value = 'designer';
  }

  function close() {
    release();
    ui.work.value = null;
  }

  /**
   * A new draft. A built-in style is copied with a new id, so that the original does not change.
   * @param style null begins with an empty style
   */
  function begin(style: Style | null, how?: { silent?: boolean }) {
    release();
    const planner = store.planner.peek();
    if (!planner) return;
    if (!style) keep(planner.emptyDraft(freshId(), strings.untitledStyle), how);
    else {
      const fresh = planner.draftOf(style);
      const designed = planner.styles().some(({ id }) => id === style.id);
      keep(designed ? { ...fresh, id: freshId(), name: strings.nameOfCopy(style.name) } : fresh, how);
    }
  }

  /** A new draft of the style that the page has. */
  function beginWithPage() {
    const style = pageStyle();
    if (style) begin(style);
  }

  function pageStyle(): Style | null {
    const style = store.page.peek()?.style;
    if (typeof style === 'object') return style as Style;
    const designed = store.planner.peek()?.styles() ?? [];
    return designed.find(({ id }) => id === style) ?? null;
  }

  /** The facts of the draft as if that layer ended before this block. */
  function factsBefore({ layer, at }: Place): DraftFacts | null {
    const now = draft.peek();
    const planner = store.planner.peek();
    return now && planner && planner.draftFacts({ ...now, [layer]: now[layer].slice(0, at) });
  }

  /**
   * Inserts a block before another one, and the blocks that it needs before and after it.
   * @returns its position; null if the layer is full
   */
  function insert(block: string, { layer, at }: Place): Place | null {
    const count = draft.peek()?.[layer].length ?? 0;
    const before = factsBefore({ layer, at })?.[layer].brings[block];
    const after = followerOf(block, draft.peek()?.[layer][at]?.block);
    const blocks = [...(before ? [before.remedy] : []), block, ...(after ? [after] : [])];
    if (count + blocks.length > MOST.blocks) {
      messages.alert(strings.fullLayer);
      return null;
    }
    change({ type: 'add', layer, at, blocks });
    return { layer, at: at + (before ? 1 : 0) };
  }

  function change(change: DraftEdit) {
    release();
    const after = edited(store.project.peek().draft, change);
    if (after) keep(after);
  }

  /** An edit in the middle of a drag, which `release` ends. */
  function hold(change: DraftEdit) {
    const after = edited(draft.peek(), change);
    if (after) held.value = after;
  }

  /** @returns null if nothing changes */
  function edited(before: Draft | null, change: DraftEdit): Draft | null {
    const whole = change.type === 'name' ? { ...change, name: wellFormed(change.name) } : change;
    return before && (store.planner.peek()?.editDraft(before, whole) ?? null);
  }

  function release() {
    const after = held.peek();
    held.value = null;
    if (after && after !== store.project.peek().draft) keep(after);
  }

  function keep(after: Draft, how?: { silent?: boolean }) {
    const known = store.planner.peek()?.draftFacts(after);
    const follows = onPage.peek() && store.project.peek().draft?.id === after.id && known?.whole;
    gestures += 1;
    const gesture = `design-${gestures}`;
    store.change({ type: 'design', draft: after, gesture, ...how });
    if (follows) pages.edit({ type: 'restyle', style: known.style, gesture });
  }

  /** @returns the draft as a style file that the core has checked; errors are shown */
  function checked(): Style | null {
    release();
    const now = store.project.peek().draft;
    const planner = store.planner.peek();
    if (!now || !planner) return null;
    try {
      return planner.checkStyle(JSON.stringify(planner.draftFacts(now).style), now.name.trim() || now.id);
    } catch (error) {
      messages.alert(explain(error));
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
