// @ts-check
/**
 * The styles, as pictures of the person's own photo.
 */

import { useRef } from 'preact/hooks';
import { strings } from '../strings.js';
import { Bitmap, screenPixels } from './bitmap.jsx';
import { useApp } from './context.js';
import { Listbox } from './listbox.jsx';

/** @typedef {import('../engine/documents.js').Style} Style */

const WIDTH = 132;
const HEIGHT = 99;

export function StylesList() {
  const { store, pages, engine } = useApp();
  const hero = useHero();
  const style = store.page.value?.style ?? null;
  const selected = typeof style === 'string' ? style : style?.id ?? null;
  const size = { width: screenPixels(WIDTH), height: screenPixels(HEIGHT) };

  return (
    <Listbox
      label={strings.styles}
      class="styles-list"
      groups={families(store.styles.value)}
      selected={selected}
      onChoose={pages.chooseStyle}
      names
      picture={(option) => (
        hero === null
          ? <span class="bitmap" />
          : <Bitmap of={hero} draw={(call) => engine.stylePhoto(hero, option, size, call)} />
      )}
    />
  );
}

/**
 * The photo that the styles are shown on: the first page's largest, for as long as it is in use, so that the
 * pictures stay while pages come and go.
 * @returns {string | null}
 */
function useHero() {
  const { store, engine } = useApp();
  const hero = useRef(/** @type {string | null} */ (null));
  const usable = store.photos.value.map(({ id }) => id).filter(engine.hasPhoto);
  if (hero.current === null || !usable.includes(hero.current)) {
    const panels = store.page.value?.panels ?? [];
    const boxes = store.geometry.value?.panels ?? [];
    const area = (/** @type {number} */ i) => (boxes[i] ? boxes[i].bounds.width * boxes[i].bounds.height : 0);
    const order = panels.map((_, i) => i).sort((a, b) => area(b) - area(a));
    const shown = order.map((i) => panels[i].photo).find((id) => id !== null && usable.includes(id));
    hero.current = shown ?? usable[0] ?? null;
  }
  return hero.current;
}

/**
 * @param {Style[]} styles
 * @returns {{ name: string, options: Style[] }[]} by their first tag, in the order of the catalogue
 */
function families(styles) {
  /** @type {Map<string, Style[]>} */
  const groups = new Map();
  for (const style of styles) {
    const tag = style.tags[0] ?? strings.otherStyles;
    groups.set(tag, [...(groups.get(tag) ?? []), style]);
  }
  return [...groups].map(([name, options]) => ({ name: strings.familyName(name), options }));
}
