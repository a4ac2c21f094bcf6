/** Actions for the selected panels, their photos, and the dividers between them. */

import { computed } from '@preact/signals';
import { LARGE_STEP as LARGE_SCRUB, STEP as SCRUB } from './scrubbing.ts';
import { strings } from '../../strings/strings.ts';
import { SLANT_KEYS } from './cuts.tsx';
import { SIZE_KEYS } from './insets.tsx';
import { CHOOSE_KEYS, FRAME_KEYS } from './panel-keys.ts';
import type { ReadonlySignal } from '@preact/signals';
import type { Rotation } from '../../engine/metadata/rotate.ts';
import type { App } from '../../ui/context.ts';
import type { Action, OwnKeys } from '../../ui/action.ts';

/** The focused panel has additional keys. They affect only this panel, not the selection. */
export type PanelAction = Action & {
  /** @param how `gesture`: the step of the undo; `large`: Shift is held */
  onPanel?: (panel: number, how: { gesture: string; large: boolean }) => void;
  /** Whether its keys mean anything there. */
  allows?: (panel: number) => boolean;
};

/** Zoom factors of a click and of a key press. */
const CLICK_ZOOM = 1.2;
const KEY_ZOOM = 1.1;
/** Distance that a click moves a divider, as a fraction of the divided cell. */
const CUT_STEP = 0.02;
/** Distance in page widths of a click that moves an inset, and the factor of a click that sizes it. */
const INSET_STEP = 0.02;
const INSET_FACTOR = 1.1;

export function createPanelActions({
  store,
  selection,
  merging,
  framing,
  scrubbing,
  rotating,
  reshaping,
  download,
  choosing,
  masks,
  messages,
  ui,
}: Pick<
  App,
  | 'store'
  | 'selection'
  | 'merging'
  | 'framing'
  | 'scrubbing'
  | 'rotating'
  | 'reshaping'
  | 'download'
  | 'choosing'
  | 'masks'
  | 'messages'
  | 'ui'
>) {
  const chosen = selection.panels;
  const panel = () => chosen.peek()[0];
  const whyNotOne = computed(() => (chosen.value.length === 1 ? '' : strings.selectOne));
  const whyHeld = computed(() => (chosen.value.some(framing.isLocked) ? strings.panelLocked : ''));
  const whyNotFramed = computed(() => whyNotOne.value || whyHeld.value);
  const use = computed(() => store.page.value?.panels[chosen.value[0]]);
  const lockedOne = computed(() => use.value?.locked ?? false);
  const starred = computed(() =>
    store.tray.value.some((item) => item.id === use.value?.photo && item.starred === true),
  );
  const facts = store.layoutFacts;

  const whyNotSplit = computed(
    () => whyNotOne.value || (facts.value?.editable && chosen.value[0] < facts.value.base ? '' : strings.noCuts),
  );
  const whyNotRemoved = computed(() => {
    if (whyNotOne.value || !facts.value) return whyNotOne.value;
    const { base, editable } = facts.value;
    return chosen.value[0] < base && (!editable || base === 1) ? (editable ? strings.onlyPanel : strings.noCuts) : '';
  });

  const broken = computed(() => use.value?.figure !== undefined);
  const merged = computed(() => !!store.page.value?.merges.some((group) => group.includes(chosen.value[0])));
  const whyNoMask = computed(() => {
    if (whyNotOne.value) return whyNotOne.value;
    const photo = use.value?.photo;
    if (!photo) return strings.noPhotoHere;
    if (store.masks.value.has(photo)) return '';
    if (masks.held.value) return strings.figureStopped;
    return masks.there.value ? strings.figureSought : strings.noFigureNet;
  });
  const whyNotCorrected = computed(() => {
    if (whyNotOne.value) return whyNotOne.value;
    const photo = store.album.value.get(use.value?.photo ?? '');
    return photo?.meta && !photo.absent ? '' : strings.noPhotoHere;
  });
  const rotated = (rotation: Rotation) =>
    ({
      why: computed(() => whyHeld.value || whyNotCorrected.value),
      run: () => void rotating.rotate(() => framing.photoOf(panel()), rotation),
      undo: 'step',
    }) satisfies Partial<Action>;
  const whyNotBroken = computed(() => {
    if (whyNotFramed.value || broken.value) return whyNotFramed.value;
    return merged.value ? strings.sharedImage : whyNoMask.value;
  });

  const zoomed = (way: 1 | -1) =>
    ({
      about: strings.keyAbout.zoom,
      heard: 'panel',
      why: whyNotFramed,
      run: () => framing.closer(panel(), CLICK_ZOOM ** way),
      onPanel: (index, { gesture }) => framing.closer(index, KEY_ZOOM ** way, gesture),
      undo: 'step',
    }) satisfies Partial<PanelAction>;

  /** As in video editors: a frame, and with Shift a second. */
  const scrubbed = (way: 1 | -1) =>
    ({
      about: strings.keyAbout.scrub,
      heard: 'panel',
      why: whyHeld,
      run: () => void scrubbing.nudge(panel(), way * SCRUB, `scrub-${panel()}`),
      onPanel: (index, { gesture, large }) => void scrubbing.nudge(index, way * (large ? LARGE_SCRUB : SCRUB), gesture),
      allows: (index) => !framing.isLocked(index) && scrubbing.isFrame(index),
      undo: 'gesture',
    }) satisfies Partial<PanelAction>;

  /** The next click selects one panel again. */
  const ended = (run: () => void) => () => {
    run();
    selection.several.value = false;
  };

  /** The first half stays selected. */
  const split = (axis: 'rows' | 'columns') => {
    const at = panel();
    reshaping.splitPanel(at, axis);
    selection.set([at]);
  };
  const splitInto = (axis: 'rows' | 'columns') =>
    ({
      icon: axis,
      why: whyNotSplit,
      run: () => split(axis),
      undo: 'step',
    }) satisfies Partial<Action>;

  const cut = computed(() => facts.value?.cuts[reshaping.cut.value ?? -1]);
  const whyNoCut = computed(() => (cut.value ? '' : strings.selectCut));
  const moved = (by: number, slant: number) =>
    ({
      why: whyNoCut,
      run() {
        const at = reshaping.cut.peek();
        const from = cut.peek();
        if (from && at !== null)
          reshaping.moveCut(at, { fraction: from.fraction + by, slant: from.slant + slant }, `cut-clicks-${at}`);
      },
      undo: 'gesture',
    }) satisfies Partial<Action>;
  const alongCut = (rows: string, columns: string): ReadonlySignal<string> =>
    computed(() => (cut.value?.axis === 'rows' ? rows : columns));

  const whyNoInset = computed(
    () => whyNotOne.value || (chosen.value[0] >= (facts.value?.base ?? 0) ? '' : strings.notInset),
  );
  /** Moves the middle of the selected inset, in page widths, and sizes the inset. */
  const placed = (x: number, y: number, factor = 1) =>
    ({
      why: whyNoInset,
      run() {
        const bounds = store.geometry.peek()?.panels[panel()]?.bounds;
        if (!bounds) return;
        const [width, height] = [bounds.width * factor, bounds.height * factor];
        const left = bounds.x + (bounds.width - width) / 2 + x;
        const top = bounds.y + (bounds.height - height) / 2 + y;
        reshaping.moveInset(panel(), { x: left, y: top, width, height }, `inset-clicks-${panel()}`);
      },
      undo: 'gesture',
    }) satisfies Partial<Action>;

  return {
    select: {
      label: strings.selectPanels,
      icon: 'select',
      on: selection.several,
      run: () => selection.choose(!selection.several.peek()),
    },
    crop: {
      label: strings.crop,
      icon: 'crop',
      why: whyNotFramed,
      run: () => {
        framing.cropping.value = panel();
        framing.mode.value = null;
      },
    },
    cropped: {
      label: strings.doneEditing,
      icon: 'check',
      run: () => {
        framing.cropping.value = null;
        framing.mode.value = null;
      },
    },
    replace: {
      label: strings.replacePhoto,
      icon: 'photos',
      why: whyNotFramed,
      on: computed(() => framing.mode.value?.kind === 'replace'),
      run() {
        framing.toggle('replace', panel());
        if (framing.mode.peek() !== null && !ui.wide.peek()) ui.sheet.value = 'photos';
      },
    },
    splitPanel: {
      label: strings.splitPanel,
      icon: 'columns',
      why: whyNotSplit,
      run() {
        const { width, height } = framing.boundsOf(panel()) ?? { width: 0, height: 0 };
        split(width > height ? 'columns' : 'rows');
      },
      undo: 'step',
    },
    merge: {
      label: strings.merge,
      short: strings.short.span,
      icon: 'merge',
      why: computed(merging.cannotMerge),
      run: ended(merging.merge),
      undo: 'step',
    },
    split: {
      label: strings.split,
      icon: 'split',
      why: computed(merging.cannotSplit),
      run: ended(merging.split),
      undo: 'step',
    },
    join: {
      label: strings.joinPanels,
      icon: 'join',
      why: computed(() => reshaping.cannotJoin(chosen.value)),
      run: ended(() => {
        const at = panel();
        reshaping.joinPanels(chosen.peek());
        selection.set([at]);
      }),
      undo: 'step',
    },
    frame: FRAME_KEYS,
    earlier: {
      label: strings.earlierFrame,
      short: strings.short.earlier,
      icon: 'earlier',
      keys: [',', '<'],
      ...scrubbed(-1),
    },
    later: { label: strings.laterFrame, short: strings.short.later, icon: 'later', keys: ['.', '>'], ...scrubbed(1) },
    zoomIn: { label: strings.zoomIn, icon: 'zoomIn', keys: ['+', '='], ...zoomed(1) },
    zoomOut: { label: strings.zoomOut, icon: 'zoomOut', keys: ['-'], ...zoomed(-1) },
    reset: {
      label: strings.resetCrop,
      keys: ['0'],
      about: strings.keyAbout.zoom,
      heard: 'panel',
      icon: 'reset',
      why: computed(() => whyNotFramed.value || (use.value?.edited ? '' : strings.unchanged)),
      run: () => framing.reset(panel()),
      onPanel: (index) => framing.reset(index),
      undo: 'step',
    },
    choose: CHOOSE_KEYS,
    fit: {
      label: strings.fitSubject,
      short: strings.short.fit,
      icon: 'fit',
      why: whyNotFramed,
      run: () => framing.fit(panel()),
      undo: 'step',
    },
    rotate: { label: strings.rotatePhoto, short: strings.short.rotate, icon: 'rotate', ...rotated('right') },
    flip: { label: strings.flipPhoto, short: strings.short.flip, icon: 'flip', ...rotated('flip') },
    swap: {
      label: strings.swapPhoto,
      short: strings.short.swap,
      icon: 'swap',
      why: computed(() => (chosen.value.length > 2 ? whyNotOne.value : whyHeld.value)),
      on: computed(() => framing.mode.value?.kind === 'swap'),
      run: ended(() => {
        const [one, other] = chosen.peek();
        if (other === undefined) framing.toggle('swap', one);
        else framing.swap(one, other);
      }),
      undo: 'step',
    },
    star: {
      label: strings.starPanel,
      short: strings.short.star,
      help: strings.starPanelLong,
      icon: 'star',
      why: computed(() => whyNotOne.value || (use.value?.photo ? '' : strings.noPhotoHere)),
      on: starred,
      run: () => use.peek()?.photo && choosing.star(use.peek()?.photo ?? '', !starred.peek()),
      undo: 'step',
    },
    focus: {
      label: strings.focusPoint,
      short: strings.short.focus,
      icon: 'focus',
      why: whyNotFramed,
      on: computed(() => framing.mode.value?.kind === 'focus'),
      run: () => framing.toggle('focus', panel()),
    },
    breakFrame: {
      label: strings.breakFrame,
      short: strings.short.breakFrame,
      help: strings.breakFrameLong,
      icon: 'breakFrame',
      why: whyNotBroken,
      on: broken,
      run() {
        if (!framing.breakFrame(panel(), !broken.peek())) messages.note(strings.noWayOut);
      },
      undo: 'step',
    },
    lock: {
      label: strings.lockPanel,
      short: strings.short.lock,
      icon: computed(() => (lockedOne.value ? 'lock' : 'unlock')),
      why: whyNotOne,
      on: lockedOne,
      run: () => framing.lock(panel(), !lockedOne.peek()),
      undo: 'step',
    },
    save: {
      label: strings.savePanel,
      short: strings.short.save,
      icon: 'save',
      why: computed(() => whyNotOne.value || (use.value?.photo ? '' : strings.noPhotoHere)),
      run: () => void download.savePanel(panel()),
    },
    correct: {
      label: strings.brush.correct,
      short: strings.short.correct,
      help: strings.brush.correctLong,
      icon: 'brush',
      why: whyNotCorrected,
      run() {
        ui.dialog.value = { brush: use.peek()?.photo ?? '' };
      },
    },
    saveSubject: {
      label: strings.saveSubject,
      short: strings.short.subject,
      icon: 'subjects',
      why: whyNoMask,
      run: () => void download.saveSubject(use.peek()?.photo ?? ''),
    },
    splitRows: { label: strings.splitRows, ...splitInto('rows') },
    splitColumns: { label: strings.splitColumns, ...splitInto('columns') },
    remove: {
      label: strings.removePanel,
      icon: 'bin',
      why: whyNotRemoved,
      run: () => reshaping.removePanel(panel()),
      undo: 'step',
    },
    slant: SLANT_KEYS,
    cutBack: { label: strings.cutBack, icon: alongCut('up', 'previous'), ...moved(-CUT_STEP, 0) },
    cutForth: { label: strings.cutForth, icon: alongCut('down', 'next'), ...moved(CUT_STEP, 0) },
    slantBack: { label: strings.slantBack, icon: 'slantLess', ...moved(0, -2 * CUT_STEP) },
    slantForth: { label: strings.slantForth, icon: 'slantMore', ...moved(0, 2 * CUT_STEP) },
    sizeInset: SIZE_KEYS,
    insetLeft: { label: strings.insetLeft, icon: 'previous', ...placed(-INSET_STEP, 0) },
    insetRight: { label: strings.insetRight, icon: 'next', ...placed(INSET_STEP, 0) },
    insetUp: { label: strings.insetUp, icon: 'up', ...placed(0, -INSET_STEP) },
    insetDown: { label: strings.insetDown, icon: 'down', ...placed(0, INSET_STEP) },
    insetLarger: { label: strings.insetLarger, icon: 'zoomIn', ...placed(0, 0, INSET_FACTOR) },
    insetSmaller: { label: strings.insetSmaller, icon: 'zoomOut', ...placed(0, 0, 1 / INSET_FACTOR) },
    done: {
      label: strings.doneEditing,
      icon: 'check',
      run: () => {
        reshaping.editing.value = false;
      },
    },
  } satisfies Record<string, PanelAction | OwnKeys>;
}
