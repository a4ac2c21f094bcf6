/**
 * The styles as images of the user's photo, searched by name or kind. The list has favourites, recent styles, custom
 * styles, and built-in styles by family. If the style of the page is in no list, it comes first.
 */

import { useSignal } from '@preact/signals';
import { useEffect, useMemo, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { Thumbnail } from '../ui/bitmap.tsx';
import { StyleShuffle } from './style-shuffle.tsx';
import { useApp } from '../ui/context.ts';
import { hasParts } from './parts.ts';
import { modelsOf } from '../painters/references.ts';
import { thumbnail } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import { Listbox } from '../ui/listbox.tsx';
import { freshSeed } from '../document/pages.ts';
import { usePageGlimpse } from '../ui/glimpse.tsx';
import type { Style } from '../engine/types.ts';

const WIDTH = 132;
const HEIGHT = 99;

type Kind = { id: string; name: string; options: Style[] };

export function StylesList() {
  const { store, pages, engine, ownStyles, ownPainters, recentStyles, actions, ui } = useApp();
  const hero = useHero();
  const kind = useSignal('');
  const sought = useSignal('');
  const [recent, setRecent] = useState(recentStyles.ids.peek());
  // The list of recent styles is updated when the user returns to it, so that nothing moves under the pointer.
  useEffect(() => setRecent(recentStyles.ids.peek()), [ui.sideTab.value]);
  const style = (store.page.value?.style ?? null) as string | Style | null;
  const selected = typeof style === 'string' ? style : (style?.id ?? null);
  const [catalogue, mine, favourites] = [store.styles.value, ownStyles.mine.value, ownStyles.favourites.value];
  const kinds = useMemo(() => kindsOf({ catalogue, mine, favourites, recent }), [catalogue, mine, favourites, recent]);
  const glimpse = usePageGlimpse((id) =>
    pages.preview({ type: 'choose-style', style: ownStyles.find(id) ?? id, seed: freshSeed() }),
  );

  // If the kind does not exist any more, for example without the last favourite, all styles are shown.
  const open = kinds.some(({ id }) => id === kind.value) ? kind.value : '';
  const words = sought.value.trim().toLocaleLowerCase();
  const found = (option: Style) => strings.styleTitle(option).toLocaleLowerCase().includes(words);
  const listed = kinds.some(({ options }) => options.some(({ id }) => id === selected));
  const own = style !== null && typeof style === 'object' && !listed ? [style] : [];
  const groups = [{ id: '', name: strings.thisPage, options: own }, ...kinds]
    .filter(({ id }) => open === '' || id === open)
    .map(({ name, options }) => ({ name, options: options.filter(found) }));
  const meta = store.facts.value.find(({ id }) => id === hero)?.meta;
  const size = thumbnail(meta, WIDTH, HEIGHT);
  const designed = new Set<object>(catalogue);

  function choose(id: string) {
    recentStyles.add(id);
    pages.chooseStyle(ownStyles.find(id) ?? id);
  }

  return (
    <>
      <div class="style-search" data-first={store.versions.value.length < 2}>
        <ActionButton action={actions.imitation.open} class="button small" text />
        <div class="style-sought">
          <input
            type="search"
            class="search"
            aria-label={strings.searchStyles}
            placeholder={strings.searchShort}
            value={sought.value}
            onInput={({ currentTarget }) => {
              sought.value = currentTarget.value;
            }}
          />
          <select
            class="select"
            aria-label={strings.styleFamilies}
            value={open}
            onChange={({ currentTarget }) => {
              kind.value = currentTarget.value;
            }}
          >
            {[{ id: '', name: strings.anyStyles }, ...kinds].map(({ id, name }) => (
              <option key={id} value={id}>
                {name}
              </option>
            ))}
          </select>
        </div>
      </div>
      {ui.styleShuffle.value && <StyleShuffle />}
      <Listbox
        label={strings.styles}
        class="styles-list"
        groups={groups}
        selected={selected}
        onChoose={choose}
        onPoint={glimpse.point}
        empty={strings.noStyles}
        names
        nameOf={strings.styleTitle}
        tileOf={strings.styleTile}
        picture={(option) =>
          hero === null ? (
            <span class="bitmap" />
          ) : (
            <Thumbnail
              of={`${designed.has(option) ? hero : `${hero} ${JSON.stringify(option)}`} ${hasParts(option) ? (store.masks.value.get(hero) ?? '') : ''} ${modelsOf(ownPainters.models.value, option)}`}
              by={JSON.stringify(size.crop)}
              draw={(call) => engine.photoFile(hero, option, size, call)}
            />
          )
        }
      />
      {glimpse.view}
    </>
  );
}

/** All kinds with styles. Each style belongs to the first matching kind. */
function kindsOf(from: {
  catalogue: readonly Style[];
  mine: readonly Style[];
  favourites: readonly Style[];
  recent: readonly string[];
}): Kind[] {
  const { mine, recent } = from;
  const favourites = without(from.favourites, mine);
  const others = without(from.catalogue, [...mine, ...favourites]);
  const last = recent.flatMap((id) => others.find((style) => style.id === id) ?? []);
  return [
    { id: 'Favourites', name: strings.favourites, options: favourites },
    { id: 'Recent', name: strings.recentStyles, options: last },
    { id: 'Mine', name: strings.myStyles, options: [...mine] },
    ...families(without(others, last)),
  ].filter(({ options }) => options.length > 0);
}

/** @returns the styles whose ids are not in `others` */
function without(styles: readonly Style[], others: readonly Style[]): Style[] {
  return styles.filter(({ id }) => others.every((other) => other.id !== id));
}

/** @returns by their first tag, in the order of the catalogue; no tag begins with a capital */
function families(styles: Style[]): Kind[] {
  const groups: Map<string, Style[]> = new Map();
  for (const style of styles) {
    const tag = style.tags[0] ?? strings.otherStyles;
    groups.set(tag, [...(groups.get(tag) ?? []), style]);
  }
  return [...groups].map(([id, options]) => ({ id, name: strings.familyName(id), options }));
}
