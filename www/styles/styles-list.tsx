/**
 * The styles, as pictures of the person's own photo: the page's own one when it is in no list, the person's, the
 * favourites, and the designed ones by their families.
 */

import { strings } from '../strings/strings.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { thumbnail } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import { Listbox } from '../ui/listbox.tsx';
import type { Style } from '../engine/documents.ts';

const WIDTH = 132;
const HEIGHT = 99;

export function StylesList() {
  const { store, pages, engine, ownStyles } = useApp();
  const hero = useHero();
  const style = (store.page.value?.style ?? null) as string | Style | null;
  const selected = typeof style === 'string' ? style : (style?.id ?? null);
  const meta = store.facts.value.find(({ id }) => id === hero)?.meta;
  const size = thumbnail(meta, WIDTH, HEIGHT);
  const mine = ownStyles.mine.value;
  const favourites = without(ownStyles.favourites.value, mine);
  const designed = without(store.styles.value, [...mine, ...favourites]);
  const listed = [...mine, ...favourites, ...designed].some(({ id }) => id === selected);
  const groups = [
    { name: strings.thisPage, options: style !== null && typeof style === 'object' && !listed ? [style] : [] },
    { name: strings.myStyles, options: [...mine] },
    { name: strings.favourites, options: favourites },
    ...families(designed),
  ];

  return (
    <Listbox
      label={strings.styles}
      class="styles-list"
      groups={groups}
      selected={selected}
      onChoose={(id) => pages.chooseStyle(ownStyles.find(id) ?? id)}
      names
      nameOf={strings.styleTitle}
      picture={(option) =>
        hero === null ? (
          <span class="bitmap" />
        ) : (
          <Bitmap
            of={designed.includes(option) ? hero : `${hero} ${JSON.stringify(option)}`}
            draw={(call) => engine.stylePhoto(hero, option, size, call)}
          />
        )
      }
    />
  );
}

/** @returns those whose id no other has */
function without(styles: readonly Style[], others: readonly Style[]): Style[] {
  return styles.filter(({ id }) => others.every((other) => other.id !== id));
}

/** @returns by their first tag, in the order of the catalogue */
function families(styles: Style[]): { name: string; options: Style[] }[] {
  const groups: Map<string, Style[]> = new Map();
  for (const style of styles) {
    const tag = style.tags[0] ?? strings.otherStyles;
    groups.set(tag, [...(groups.get(tag) ?? []), style]);
  }
  return [...groups].map(([name, options]) => ({ name: strings.familyName(name), options }));
}
