/**
 * The style designer: the preview, and beside it the two layers as lanes of cards.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { LAYERS } from './designer.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { Workspace } from '../ui/workspace.tsx';
import { useCardDrag } from './card-drag.ts';
import { Lane } from './lane.tsx';
import { Palette } from './palette.tsx';
import { Preview } from './preview.tsx';
import { StyleBar } from './style-bar.tsx';
import type { Designed } from '../engine/design.ts';

const NOTHING: { times: ReadonlyMap<number, number>; stages: ReadonlyMap<number, ImageBitmap> } = {
  times: new Map(),
  stages: new Map(),
};

export function Designer() {
  const { store, designer } = useApp();
  const [drawn, setDrawn] = useState(NOTHING);
  const [adding, setAdding] = useState(false);
  const opener = useRef(null as HTMLButtonElement | null);
  const draft = designer.draft.value;

  const drag = useCardDrag((from, to) =>
    designer.change({ type: 'move', layer: from.layer, at: from.at, toLayer: to.layer, to: to.at }),
  );

  // A slider's drag that is cut short, by leaving say, is kept as far as it went; a card's is not.
  useEffect(
    () => () => {
      designer.release();
      drag.cancel.current();
    },
    [],
  );
  if (!draft) return null;

  function onStages({ times, stages }: Designed) {
    setDrawn({ times: new Map(times), stages: new Map(stages.map(({ place, bitmap }) => [place, bitmap])) });
  }

  function closePalette() {
    setAdding(false);
    opener.current?.focus();
  }

  const empty = LAYERS.every((layer) => draft[layer].length === 0);
  const total = [...drawn.times.values()].reduce((sum, ms) => sum + ms, 0);
  return (
    <Workspace title={strings.styleDesigner} class="designer" tools={<StyleBar />} onClose={designer.close}>
      <Preview onStages={onStages} />
      <div class="lanes-side">
        <header class="lanes-head">
          <button
            type="button"
            class="button strong"
            ref={opener}
            aria-expanded={adding}
            onClick={() => setAdding(!adding)}
          >
            <Icon name="add" />
            {strings.addBlock}
          </button>
          {drawn.times.size > 0 && <span class="count">{strings.totalTime(strings.milliseconds(total))}</span>}
        </header>
        {adding ? (
          <Palette onClose={closePalette} onAdded={() => setAdding(false)} />
        ) : (
          <div class="lanes">
            {LAYERS.map((layer) => (
              <Lane
                key={layer}
                layer={layer}
                draft={draft}
                drag={drag}
                drawn={drawn}
                onAdd={() => {
                  designer.layer.value = layer;
                  setAdding(true);
                }}
              />
            ))}
            {empty && store.page.value && (
              <button type="button" class="button lanes-begin" onClick={designer.beginWithPage}>
                <Icon name="style" />
                {strings.beginWithPage}
              </button>
            )}
          </div>
        )}
      </div>
    </Workspace>
  );
}
