/**
 * The style explorer: a wall of styles that nobody designed, on the person's own photo, that keeps growing.
 */

import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { useHero } from '../photos/hero.ts';
import { Icon } from '../ui/icon.tsx';
import { Workspace } from '../ui/workspace.tsx';
import { Dials } from './dials.tsx';
import { Judging } from './judging.tsx';
import { useVisible } from './visible.ts';
import { WallItem } from './wall-item.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import type { Item, Photo } from './explorer.ts';
import type { VNode } from 'preact';

/** The size that thumbnails cover, in CSS pixels. */
const SIZE = { width: 160, height: 120 };

export function Explorer() {
  const { explorer, designer, actions } = useApp();
  const photo = usePhoto();
  const items = explorer.items.value;
  const shown = explorer.shown.value;
  const running = explorer.progress.value;
  const vnodes = useItems(shown, photo);
  const wall = useVisible(explorer.scores.visible, shown);

  useEffect(() => {
    if (photo) void explorer.showFavourites(photo);
    return explorer.stop;
  }, [photo?.id]);

  const tools = (
    <div class="explorer-bar">
      {running ? (
        <ActionButton action={actions.explorer.stop} class="button strong" text />
      ) : (
        <button
          type="button"
          class="button strong"
          disabled={!photo}
          onClick={() => photo && void explorer.generate(photo)}
        >
          <Icon name="surprise" />
          {strings.generate}
        </button>
      )}
      <ActionButton action={actions.explorer.sort} class="button" text />
      <select
        class="select"
        aria-label={strings.looks}
        value={explorer.look.value}
        onChange={(event) => {
          explorer.look.value = event.currentTarget.value;
        }}
      >
        {Object.entries(strings.lookName).map(([id, name]) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </select>
      <Dials />
      <span class="count" title={strings.dropped(explorer.dropped.value)}>
        {items.length > 0 && strings.inventedCount(shown.length, items.length)}
      </span>
      <ActionButton action={actions.explorer.clear} />
    </div>
  );
  return (
    <Workspace
      title={strings.styleExplorer}
      class="explorer"
      tools={tools}
      busy={running !== null}
      onClose={designer.close}
    >
      {running && (
        <progress
          class="progress explorer-progress"
          aria-label={strings.inventing(running.done, running.total)}
          value={running.done}
          max={running.total}
        />
      )}
      {!running && <Judging />}
      <Hint />
      <ul class="wall" ref={wall}>
        {vnodes}
      </ul>
      {items.length === 0 && !running && <p class="wall-empty">{strings.explorerEmpty}</p>}
      {items.length > 0 && shown.length === 0 && <p class="wall-empty">{strings.explorerNone}</p>}
    </Workspace>
  );
}

/** What breeding waits for, or what came of it. */
function Hint() {
  const { explorer } = useApp();
  const { parent, lastParents } = explorer;
  if (parent.value) return <p class="explorer-hint">{strings.breedWith(parent.value.name)}</p>;
  return lastParents.value && <p class="explorer-hint">{strings.litterOf(...lastParents.value)}</p>;
}

/** The photo that styles are tried on. */
function usePhoto(): Photo | null {
  const { store } = useApp();
  const hero = useHero();
  const meta = store.facts.value.find(({ id }) => id === hero)?.meta;
  if (hero === null || !meta) return null;
  const scale = Math.max(screenPixels(SIZE.width) / meta.width, screenPixels(SIZE.height) / meta.height);
  return { id: hero, width: Math.round(meta.width * scale), height: Math.round(meta.height * scale) };
}

/** The same element is handed over as long as nothing in it changes, so that a wall of hundreds grows quickly. */
function useItems(shown: readonly Item[], photo: Photo | null) {
  const { explorer, ownStyles } = useApp();
  const made = useRef(new Map() as Map<string, VNode>);
  const parent = explorer.parent.value?.id;
  const last = explorer.lastParents.value;
  return shown.map((item) => {
    const { id } = item.style;
    const judgement = explorer.scores.judged.value.get(id);
    const parents = explorer.parentsOf(id);
    const fresh = parents !== undefined && parents === last;
    const key = `${id} ${judgement} ${ownStyles.isFavourite(id)} ${parent === id} ${fresh} ${photo?.id}`;
    const found = made.current.get(key);
    if (found) return found;
    const vnode = (
      <WallItem
        key={id}
        item={item}
        judgement={judgement}
        photo={photo}
        favourite={ownStyles.isFavourite(id)}
        parent={parent === id}
        parents={parents}
        fresh={fresh}
      />
    );
    made.current.set(key, vnode);
    return vnode;
  });
}
