/** A style on the wall, and what can be done with it. */

import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { Thumbnail, useInView } from '../ui/bitmap.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import { middleOf } from '../photos/cover.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { pointing } from '../ui/pointing.ts';
import { useStyleDeeds } from './style-deeds.ts';
import type { Point } from '../ui/pointing.ts';
import type { Item, Parents, Photo } from './explorer.ts';

/**
 * @param props `points`: its score; `parent`: it is the first parent of a combination; `parents`: its parents;
 *   `family`: its relation to the last litter
 */
function Score({ points }: { points: number }) {
  const score = strings.scoreOf({ score: strings.decimal(points, 0) });
  return (
    <span class="wall-score" title={score} role="img" aria-label={score}>
      {strings.decimal(points, 0)}
    </span>
  );
}

/**
 * The picture of a visible style with two pixels per CSS pixel, over the picture of the wall. Pictures of the wall are
 * smaller, because most of them are rejected.
 */
function SharpPicture({ item: { style, photo } }: { item: Item }) {
  const { engine } = useApp();
  const scale = 2 / Math.min(2, globalThis.devicePixelRatio || 1);
  const size = { width: Math.round(scale * photo.width), height: Math.round(scale * photo.height) };
  return <Thumbnail of={`${style.id} ${photo.id}`} draw={(call) => engine.photoFile(photo.id, style, size, call)} />;
}

/** @returns how a style came from its parents, or from one */
const originOf = (a: string, b: string) => (a === b ? strings.bredFromOne({ a }) : strings.bredFrom({ a, b }));

export function WallItem({
  item,
  points,
  photo,
  favourite,
  parent,
  parents,
  family,
  point,
}: {
  item: Item;
  points: number | null;
  photo: Photo | null;
  favourite: boolean;
  parent: boolean;
  parents?: Parents;
  family?: 'parent' | 'child';
  point: Point;
}) {
  const { explorer, store } = useApp();
  const tile = useRef(null as HTMLLIElement | null);
  const isInView = useInView(tile);
  // New styles come before sharp pictures.
  const isSharp = useRef(false);
  isSharp.current = isInView && (isSharp.current || explorer.progress.value === null);
  const { style } = item;
  const deeds = useStyleDeeds(style, photo, favourite);
  // A tile does not cut the face.
  const middle = middleOf(store.album.peek().get(item.photo.id)?.meta?.subjects ?? []);
  const canvas = useRef(null as HTMLCanvasElement | null);

  useEffect(() => {
    const bitmap = explorer.pictures.get(style.id);
    if (!canvas.current || !bitmap) return;
    canvas.current.width = bitmap.width;
    canvas.current.height = bitmap.height;
    canvas.current.getContext('2d')?.drawImage(bitmap, 0, 0);
  }, [style.id, item.photo.id]);

  // The hint asks for the second parent.
  const isChosen = explorer.parent.value !== null && photo !== null && !parent;
  const origin = family === 'parent' ? strings.parent : parents && originOf(parents[0].name, parents[1].name);
  return (
    <li
      ref={tile}
      class="wall-item"
      data-style={style.id}
      aria-label={style.name}
      data-parent={parent}
      data-family={family}
      data-stale={photo !== null && item.photo.id !== photo.id}
    >
      <button
        type="button"
        class="wall-picture"
        style={{ '--middle': middle.map((part) => `${Math.round(part * 100)}%`).join(' ') }}
        aria-label={(isChosen ? strings.chooseParent : strings.enlarge)({ name: style.name })}
        {...pointing(style.id, point)}
        onClick={() => {
          point(null);
          if (isChosen) deeds.breed.run();
          else explorer.enlarged.value = style.id;
        }}
      >
        <canvas ref={canvas} class="bitmap" aria-hidden="true" />
        {isSharp.current && <SharpPicture item={item} />}
      </button>
      <p class="wall-name" aria-hidden="true">
        {style.name}
      </p>
      {points !== null && <Score points={points} />}
      {origin && (
        <span class="wall-origin" title={origin}>
          <Icon name="breed" />
          <span class={family === 'parent' ? undefined : 'visually-hidden'}>{origin}</span>
        </span>
      )}
      <ActionButton action={deeds.favour} class="icon-button wall-heart" />
      <div class="wall-tools">
        <ActionButton action={deeds.use} named />
        <ActionButton action={deeds.edit} named />
        <ActionButton action={{ ...deeds.breed, on: parent }} named />
        <ActionButton action={deeds.moreLike} named />
      </div>
    </li>
  );
}
