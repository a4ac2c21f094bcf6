/** Actions that show or hide parts of the window. */

import { computed } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Action, OwnKeys } from '../ui/action.ts';
import { ORIGINALS_KEYS } from '../page/originals.tsx';
import type { App } from '../ui/context.ts';
import { ZOOMS } from '../ui/ui.ts';
import type { Sheet } from '../ui/ui.ts';

export function createWindowActions({ ui, designer, installing }: Pick<App, 'ui' | 'designer' | 'installing'>) {
  const drawer = (sheet: Sheet, icon: string, label: string) =>
    ({
      label,
      icon,
      on: computed(() => ui.sheet.value === sheet),
      run: () => {
        ui.sheet.value = ui.sheet.peek() === sheet ? null : sheet;
      },
    }) satisfies Action;

  const designing = computed(() => ui.work.value === 'designer');
  const exploring = computed(() => ui.work.value === 'explorer');
  const view = (label: string, icon: string, on: ReadonlySignal<boolean>, run: () => void) => ({
    label,
    icon,
    on,
    run: () => {
      ui.sheet.value = null;
      run();
    },
  });
  return {
    comic: view(
      strings.boards.comic,
      'layout',
      computed(() => ui.work.value === null),
      () => void (ui.work.value = null),
    ),
    boards: view(
      strings.boards.board,
      'film',
      computed(() => ui.work.value === 'boards'),
      () => ui.toggleWork('boards'),
    ),
    designer: view(strings.designer, 'designer', designing, () =>
      designing.peek() ? designer.close() : designer.open(),
    ),
    explorer: view(strings.explorer, 'explorer', exploring, () => ui.toggleWork('explorer')),
    photos: drawer('photos', 'photos', strings.photos),
    styles: drawer('styles', 'style', strings.styles),
    layouts: drawer('layouts', 'layout', strings.layouts),
    words: drawer('words', 'balloon', strings.words),
    settings: drawer('settings', 'settings', strings.pageSettings),
    preview: {
      label: computed(() => (ui.preview.value ? strings.endFullScreen : strings.fullScreen)),
      keys: ['F'],
      icon: computed(() => (ui.preview.value ? 'close' : 'preview')),
      on: ui.preview,
      run: () => {
        ui.preview.value = !ui.preview.peek();
      },
    },
    originals: {
      label: strings.showOriginals,
      icon: 'photos',
      on: ui.originals,
      run: () => {
        ui.originals.value = !ui.originals.peek();
      },
    },
    originalsKey: ORIGINALS_KEYS,
    enlargePage: {
      label: strings.enlargePage,
      keys: ['Z'],
      icon: 'zoomIn',
      enabled: computed(() => ui.zoom.value < ZOOMS[ZOOMS.length - 1]),
      run: () => {
        ui.zoom.value = ZOOMS.find((zoom) => zoom > ui.zoom.peek()) ?? ui.zoom.peek();
      },
    },
    shrinkPage: {
      label: strings.shrinkPage,
      keys: ['X'],
      icon: 'zoomOut',
      enabled: computed(() => ui.zoom.value > 1),
      run: () => {
        ui.zoom.value = ZOOMS.findLast((zoom) => zoom < ui.zoom.peek()) ?? 1;
      },
    },
    install: {
      label: strings.install,
      help: strings.installHelp,
      icon: 'install',
      enabled: installing.possible,
      run: installing.install,
    },
    help: {
      label: strings.help,
      short: strings.helpShort,
      keys: ['?'],
      about: strings.keyAbout.list,
      icon: 'help',
      run: () => {
        ui.dialog.value = 'help';
      },
    },
  } satisfies Record<string, Action | OwnKeys>;
}
