/** A style on the wall, and what can be done with it. */

import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import type { Item, Parents, Photo } from './explorer.ts';

/**
 * @param props `judgement`: what the net thinks of it, if it was asked; `parent`: it waits for another to breed with; `parents`:
 * what it was bred from, `fresh`: just now
 */
export function WallItem({
  item: { style, score },
  judgement,
  photo,
  favourite,
  parent,
  parents,
  fresh,
}: {
  item: Item;
  judgement?: number | null;
  photo: Photo | null;
  favourite: boolean;
  parent: boolean;
  parents?: Parents;
  fresh: boolean;
}) {
  const { explorer, ownStyles, pages, designer, ui } = useApp();
  const ref = useRef(null as HTMLLIElement | null);
  const canvas = useRef(null as HTMLCanvasElement | null);

  useEffect(() => {
    const bitmap = explorer.pictures.get(style.id);
    if (!canvas.current || !bitmap) return;
    canvas.current.width = bitmap.width;
    canvas.current.height = bitmap.height;
    canvas.current.getContext('2d')?.drawImage(bitmap, 0, 0);
  }, [style.id]);

  function use() {
    pages.chooseStyle(style);
    ui.work.value = null;
  }

  /** Children are hung first, and must not be missed. */
  function atTop(bred: Promise<void>) {
    const wall = ref.current?.parentElement;
    void bred.then(() => wall?.scrollTo({ top: 0 }));
  }

  const shown = judgement ? strings.decimal(judgement, 2) : strings.decimal(score * 100, 0);
  const bred = parents && strings.bredFrom(...parents);
  const label = judgement ? strings.netScoreOf(shown) : strings.lightScoreOf(shown);
  return (
    <li
      class="wall-item"
      ref={ref}
      data-style={style.id}
      aria-label={style.name}
      data-parent={parent}
      data-fresh={fresh}
    >
      <canvas ref={canvas} class="bitmap" aria-hidden="true" onClick={use} title={strings.useStyle} />
      <span class="wall-score" data-net={!!judgement} title={label} role="img" aria-label={label}>
        {shown}
      </span>
      {bred && (
        <span class="wall-origin" title={bred}>
          <Icon name="breed" />
          <span class="visually-hidden">{bred}</span>
        </span>
      )}
      <IconButton
        icon="heart"
        label={strings.favourite}
        pressed={favourite}
        class="wall-heart"
        onClick={() => ownStyles.favour(style)}
      />
      <div class="wall-tools">
        <IconButton icon="check" label={strings.useStyle} onClick={use} />
        <IconButton icon="designer" label={strings.editInDesigner} onClick={() => designer.open(style)} />
        <IconButton
          icon="breed"
          label={strings.breed}
          pressed={parent}
          disabled={!photo}
          onClick={() => photo && atTop(explorer.breed(style, photo))}
        />
        <IconButton
          icon="more"
          label={strings.moreLikeThis}
          disabled={!photo}
          onClick={() => photo && atTop(explorer.moreLike(style, photo))}
        />
      </div>
    </li>
  );
}
