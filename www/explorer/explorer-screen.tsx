/** The style explorer: a growing wall of generated styles on one of the user's photos. */

import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { useGlimpse } from '../ui/glimpse.tsx';
import { useHero } from '../photos/hero.ts';
import { useDrawnPhotos } from '../photos/photo-picker.tsx';
import { Workspace } from '../ui/workspace.tsx';
import { TOGETHER } from './explorer.ts';
import { Dials } from './dials.tsx';
import { Enlarged } from './enlarged.tsx';
import { Filters } from './filters.tsx';
import { Status } from './status.tsx';
import { useVisible } from './visible.ts';
import { WallItem } from './wall-item.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import type { Shown } from '../photos/photo-picker.tsx';
import type { Point } from '../ui/pointing.ts';
import type { Item, Photo } from './explorer.ts';
import type { VNode } from 'preact';

/** The size that thumbnails cover, in CSS pixels. */
const SIZE = { width: 160, height: 120 };
/** Maximum size of a large view, in CSS pixels. */
const LARGER = { width: 440, height: 380 };
/** Milliseconds that the pointer stays on a style before it is enlarged, so that users can view the wall. */
const REST = 500;

export function Explorer() {
  const { engine, explorer, designer, actions } = useApp();
  const facts = useDrawnPhotos();
  const fact = useChosen(facts);
  const photo = fact && sized(fact);
  const items = explorer.items.value;
  const shown = explorer.shown.value;
  const running = explorer.progress.value;
  const glimpse = useGlimpse(
    (id) => {
      const item = explorer.shown.peek().find(({ style }) => style.id === id);
      if (!item || !photo) return null;
      const aspect = photo.width / photo.height;
      return {
        of: `${id} ${photo.id}`,
        name: item.style.name,
        aspect,
        draw: (width, call) =>
          engine.stylePhoto(photo.id, item.style, { width, height: Math.round(width / aspect), tier: 'work' }, call),
      };
    },
    { side: 'beside', rest: REST, size: LARGER },
  );
  const vnodes = useItems(shown, photo, glimpse.point);
  const wall = useVisible(explorer.scores.visible, shown);

  useEffect(() => {
    if (photo) void explorer.open(photo);
    return explorer.stop;
  }, [photo?.id]);

  const generate = {
    label: strings.generate,
    icon: 'surprise',
    enabled: photo !== null,
    run: () => photo && void explorer.generate(photo),
  };
  const tools = (
    <div class="explorer-bar">
      <ActionButton action={generate} class="button strong" text />
      <ActionButton action={actions.explorer.sort} class="button" text />
      <Dials />
      <ActionButton action={actions.explorer.clear} class="button" text />
    </div>
  );
  return (
    <Workspace
      title={strings.styleExplorer}
      heading={strings.explorer}
      class="explorer"
      tools={tools}
      busy={running !== null}
      onClose={designer.close}
    >
      <Filters facts={facts} chosen={fact?.id ?? null} />
      <Status />
      <ul class="wall" ref={wall} onPointerLeave={() => glimpse.point(null)} onBlurCapture={() => glimpse.point(null)}>
        {vnodes}
        {items.length === 0 &&
          running &&
          Array.from({ length: TOGETHER }, (_, i) => <li key={i} class="wall-waiting" aria-hidden="true" />)}
      </ul>
      {items.length === 0 && !running && <p class="wall-empty">{strings.explorerEmpty}</p>}
      {items.length > 0 && shown.length === 0 && <p class="wall-empty">{strings.explorerNone}</p>}
      {glimpse.view}
      {fact && <Enlarged fact={fact} photo={photo as Photo} />}
    </Workspace>
  );
}

/** The photo of the wall: the chosen one, the one of the first wall, or the photo of all thumbnails. */
function useChosen(facts: readonly Shown[]): Shown | null {
  const { explorer } = useApp();
  const hero = useHero();
  const found = (id: string | null) => facts.find((fact) => fact.id === id);
  return found(explorer.photo.value) ?? found(explorer.begun.value) ?? found(hero) ?? null;
}

function sized({ id, meta }: Shown): Photo {
  const scale = Math.max(screenPixels(SIZE.width) / meta.width, screenPixels(SIZE.height) / meta.height);
  return { id, width: Math.round(meta.width * scale), height: Math.round(meta.height * scale) };
}

/** The same element is reused while nothing in it changes, so that a wall of hundreds updates quickly. */
function useItems(shown: readonly Item[], photo: Photo | null, point: Point) {
  const { explorer, ownStyles } = useApp();
  const made = useRef(new Map() as Map<string, VNode>);
  const before = made.current;
  // An element holds its canvas, so elements that are not shown any more are dropped.
  made.current = new Map();
  const pointed = useRef(point);
  pointed.current = point;
  const parent = explorer.parent.value?.id;
  const last = explorer.lastParents.value;
  return shown.map((item) => {
    const { id } = item.style;
    const points = explorer.scores.shown(item);
    const parents = explorer.parentsOf(id);
    const role =
      parents !== undefined && parents === last ? 'child' : last?.some((one) => one.id === id) ? 'parent' : undefined;
    const favourite = ownStyles.isFavourite(id);
    const key = `${id} ${points} ${favourite} ${parent === id} ${role} ${item.photo.id} ${photo?.id}`;
    const vnode = before.get(key) ?? (
      <WallItem
        key={id}
        item={item}
        points={points}
        photo={photo}
        favourite={favourite}
        parent={parent === id}
        parents={parents}
        family={role}
        point={(...what) => pointed.current(...what)}
      />
    );
    made.current.set(key, vnode);
    return vnode;
  });
}
