/**
 * The style designer: the preview, and the two layers as lanes of cards next to it.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { LAYERS } from './designer.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Workspace } from '../ui/workspace.tsx';
import { BlockName } from './block-name.tsx';
import { useCardDrag } from './card-drag.ts';
import { focusCard } from './focus-card.ts';
import { Lane } from './lane.tsx';
import { Palette } from './palette.tsx';
import { Preview } from './preview.tsx';
import { StyleBar } from './style-bar.tsx';
import type { Designed } from '../engine/design.ts';

export function Designer() {
  const { store, designer, ui, actions } = useApp();
  const [stages, setStages] = useState(new Map() as ReadonlyMap<number, ImageBitmap>);
  const [adding, setAdding] = useState(false);
  const opener = useRef(null as HTMLButtonElement | null);
  const draft = designer.draft.value;

  const drag = useCardDrag(({ from, block }, gap) => {
    if (block !== undefined) {
      const place = designer.insert(block, gap);
      // On a small screen, the palette covers the lanes.
      if (!ui.wide.peek()) setAdding(false);
      if (place) focusCard(place);
      return;
    }
    // Removing the card moves later ones up by one.
    const to = gap.layer === from.layer && from.at < gap.at ? gap.at - 1 : gap.at;
    if (gap.layer !== from.layer || to !== from.at)
      designer.change({ type: 'move', layer: from.layer, at: from.at, toLayer: gap.layer, to });
  });

  // If the screen closes during a drag, the new value of a slider is retained, and the move of a card is cancelled.
  useEffect(
    () => () => {
      designer.release();
      drag.cancel.current();
    },
    [],
  );
  if (!draft) return null;

  function onStages({ stages }: Designed) {
    setStages(new Map(stages.map(({ place, bitmap }) => [place, bitmap])));
  }

  function closePalette() {
    setAdding(false);
    opener.current?.focus();
  }

  const empty = LAYERS.every((layer) => draft[layer].length === 0);
  const { carried } = drag;
  const lifted = carried?.block !== undefined ? designer.blocks.value.find(({ id }) => id === carried.block) : null;
  const addBlock = {
    label: strings.addBlock,
    icon: 'add',
    on: adding,
    run() {
      designer.place.value = { ...designer.place.peek(), at: null };
      setAdding(!adding);
    },
  };
  return (
    <Workspace
      title={strings.styleDesigner}
      class={`designer ${adding ? 'designer-adding' : ''}`}
      tools={<StyleBar />}
      onClose={designer.close}
    >
      <Preview onStages={onStages} />
      {adding && (
        <div class="palette-side" data-lifted={lifted !== null}>
          <Palette drag={drag} onClose={closePalette} onAdded={() => setAdding(false)} />
        </div>
      )}
      <div class="lanes-side">
        <header class="lanes-head">
          <ActionButton action={addBlock} class="button strong" text opens button={opener} />
        </header>
        <div class="lanes">
          {LAYERS.map((layer) => (
            <Lane
              key={layer}
              layer={layer}
              draft={draft}
              drag={drag}
              stages={stages}
              adding={adding}
              onAdd={(at) => {
                designer.place.value = { layer, at };
                setAdding(true);
              }}
            />
          ))}
          {empty && store.page.value && (
            <ActionButton action={actions.designer.begin} class="button lanes-begin" text />
          )}
        </div>
      </div>
      {lifted && carried && (
        <div class="drag-ghost" aria-hidden="true" style={{ left: `${carried.x}px`, top: `${carried.y}px` }}>
          <BlockName block={lifted} />
        </div>
      )}
    </Workspace>
  );
}
