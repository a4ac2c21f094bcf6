/**
 * State of the window. It is not part of the document and cannot be undone.
 */

import { computed, signal } from '@preact/signals';
import { mediaSignal } from './media.ts';
import { remember, remembered, rememberedSwitch } from './remembered.ts';
import { createTheme } from './theme.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Signal } from '@preact/signals';

/** The tabs next to the page, in order. */
export const SIDE_TABS = ['styles', 'layouts', 'words', 'page'] as const;
export type SideTab = (typeof SIDE_TABS)[number];
/** Zoom factors of the page relative to the window. */
export const ZOOMS = [1, 1.5, 2, 3, 4] as const;
export type Sheet = 'photos' | 'styles' | 'layouts' | 'words' | 'settings';
export type Ui = ReturnType<typeof createUi>;

const LETTERS_KEY = 'inkpanel.letters';
const DETECT_KEY = 'inkpanel.detect';
const IDEAS_KEY = 'inkpanel.ideas';
const NARRATION_KEY = 'inkpanel.narration';
const PLACES_KEY = 'inkpanel.places';

/** `brush`: the photo whose subject is corrected. */
export type OpenDialog = 'help' | 'export' | { brush: string };

/** A question before an action that replaces work. `yes`: the label of the button that runs the action. */
export type Question = { text: string; yes: string; run: () => void };

export type Work = 'designer' | 'explorer' | 'imitation' | 'projects' | 'pages' | 'boards';

export function createUi(window: Window) {
  const box = () => window.localStorage;
  const wide = mediaSignal(window, '(min-width: 1000px)');
  /** Whether there is space for labels in addition to numbers. */
  const roomy = mediaSignal(window, '(min-width: 1340px)');
  /** The workspace over the board. */
  const work: Signal<Work | null> = signal(null);
  /** The open question. It belongs to the open view. */
  const question: Signal<Question | null> = signal(null);
  work.subscribe(() => void (question.value = null));

  /** Whether single letters are shortcuts. Speech input and tremor can trigger them unintentionally. */
  const letterKeys = rememberedSwitch(box, LETTERS_KEY, true);
  /** Whether the window has space for suggestions below the page. */
  const tall = mediaSignal(window, '(min-height: 1000px)');
  const choice = signal(remembered(box, IDEAS_KEY));
  /** Whether the strip of suggestions is unfolded. */
  const ideas = computed(() => (choice.value === null ? tall.value : choice.value === 'on'));

  /** Whether new pages get a title and captions. */
  const narration = rememberedSwitch(box, NARRATION_KEY, true);
  /** Whether captions name places by the location in photos. */
  const places = rememberedSwitch(box, PLACES_KEY, true);

  return {
    ...createTheme(window),
    wide,
    roomy,
    letterKeys: letterKeys.on,
    useLetterKeys: letterKeys.turn,
    ideas,
    toggleIdeas() {
      choice.value = ideas.peek() ? 'off' : 'on';
      remember(box, IDEAS_KEY, choice.value);
    },
    narrates: narration.on,
    narrate: narration.turn,
    places: places.on,
    showPlaces: places.turn,
    /** Whether the page fills the window. */
    preview: signal(false),
    /** Zoom factor of the page; 1 shows the whole page. */
    zoom: signal(1) as Signal<number>,
    /** The sheet that is open on a small screen. */
    sheet: signal(null) as Signal<Sheet | null>,
    /** The open tab next to the page on a large screen. */
    sideTab: signal('styles') as Signal<SideTab>,
    work,
    question,
    /** Opens a workspace, or closes the open one. */
    toggleWork(which: Work) {
      work.value = work.peek() === which ? null : which;
    },
    /** Whether faces and objects are detected. `inkpanel.detect` = `off` in the storage turns detection off. */
    detects: remembered(box, DETECT_KEY) !== 'off',
    /** Whether the page shows its safe area. */
    safeArea: signal(false),
    /** Width on paper in inches for which coarse panels are marked; null marks none. */
    printCheck: signal(null) as Signal<number | null>,
    /** Whether the settings of Shuffle for styles are shown. */
    styleShuffle: signal(false),
    /** Whether the page shows its photos without a style. */
    originals: signal(false),
    /** Whether the toolbar shows all tools. */
    allTools: signal(false),
    /** Whether the boxes of detected subjects are shown. */
    subjects: signal(false),
    /** A photo of the stack that is open. */
    stack: signal(null) as Signal<string | null>,
    dialog: signal(null) as Signal<OpenDialog | null>,
    /** The page that is on the screen with all its panels; null while work for it is going on. */
    painted: signal(null) as Signal<PageDocument | null>,
    /** The page whose text items are all visible. */
    lettered: signal(null) as Signal<PageDocument | null>,
    /** The error that the views threw. */
    failed: signal(null) as Signal<unknown>,
  };
}
