/** Actions for a style of the wall, on its tile and in its large view. */

import { useApp } from '../ui/context.ts';
import type { Style } from '../engine/types.ts';
import type { Photo } from './explorer.ts';

export function useStyleDeeds(style: Style, photo: Photo | null) {
  const { explorer, ownStyles, pages, designer, ui } = useApp();
  return {
    /** Puts the page into it, and shows the page. */
    use() {
      explorer.enlarged.value = null;
      pages.chooseStyle(style);
      ui.work.value = null;
    },
    favour: () => ownStyles.favour(style),
    edit() {
      explorer.enlarged.value = null;
      designer.open(style);
    },
    breed: () => photo && void explorer.breed(style, photo),
    moreLike: () => photo && void explorer.moreLike(style, photo),
  };
}
