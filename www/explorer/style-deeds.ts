/** The actions of a style of the wall, on its tile and in its large view. */

import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { Action } from '../ui/action.ts';
import type { Style } from '../engine/types.ts';
import type { Photo } from './explorer.ts';

/** @param favourite whether the user marked it */
export function useStyleDeeds(style: Style, photo: Photo | null, favourite: boolean) {
  const { explorer, ownStyles, pages, designer, ui } = useApp();
  const enabled = photo !== null;
  return {
    /** Puts the page into it, and shows the page. */
    use: {
      label: strings.useStyle,
      short: strings.styleShort.use,
      icon: 'check',
      run() {
        explorer.enlarged.value = null;
        pages.chooseStyle(style);
        ui.work.value = null;
      },
      undo: 'step',
    },
    favour: {
      label: strings.favourite,
      short: strings.styleShort.favourite,
      icon: 'heart',
      on: favourite,
      run: () => ownStyles.favour(style),
      undo: 'step',
    },
    edit: {
      label: strings.editInDesigner,
      short: strings.styleShort.edit,
      icon: 'designer',
      run() {
        explorer.enlarged.value = null;
        designer.open(style);
      },
    },
    breed: {
      label: strings.breed,
      short: strings.styleShort.combine,
      icon: 'breed',
      enabled,
      run: () => photo && void explorer.breed(style, photo),
    },
    moreLike: {
      label: strings.moreLikeThis,
      short: strings.styleShort.similar,
      icon: 'more',
      enabled,
      run: () => photo && void explorer.moreLike(style, photo),
    },
  } satisfies Record<string, Action>;
}
