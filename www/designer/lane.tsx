/**
 * One layer: its blocks as cards joined by arrows, in the order in which they run. Cards are moved by dragging, also to
 * the other layer, by buttons, and by Alt with the arrow keys. Blocks are dragged from the palette, or inserted with
 * the buttons between cards.
 */

import { FOREGROUND } from '../engine/design.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Card } from './card.tsx';
import { WhereChoice } from './where-choice.tsx';
import type { CardDrag } from './card-drag.ts';
import type { Draft, Layer } from '../engine/types.ts';

export function Lane({
  layer,
  draft,
  drag,
  stages,
  adding,
  onAdd,
}: {
  layer: Layer;
  draft: Draft;
  drag: CardDrag;
  /** Whether the palette is open, which has a button for the same. */
  adding: boolean;
  /** Opens the palette for a block before that one, or at the end. */
  onAdd: (at: number | null) => void;
  stages: ReadonlyMap<number, ImageBitmap>;
}) {
  const { designer } = useApp();
  const { carried, take } = drag;
  /** Drop position of a dragged card. */
  const gap = carried?.gap?.layer === layer ? carried.gap.at : -1;
  const steps = draft[layer];
  const misfits = designer.facts.value?.[layer].misfits ?? [];
  const first = layer === 'foreground' ? FOREGROUND : 0;

  return (
    <section class="lane" data-layer={layer} onFocusIn={() => designer.turnTo(layer)}>
      <header class="lane-head">
        <h3 title={strings.layerHelp[layer]}>{strings.layerTitle[layer]}</h3>
        {layer === 'background' && (
          <label class="lane-setting" title={strings.careForFacesHelp}>
            <input
              type="checkbox"
              checked={!draft.careless}
              onChange={(event) => designer.change({ type: 'faces', on: event.currentTarget.checked })}
            />
            <span>{strings.careForFaces}</span>
          </label>
        )}
        {layer === 'foreground' && (
          <label class="lane-setting" title={strings.darkPaperHelp}>
            <input
              type="checkbox"
              checked={draft.dark === true}
              onChange={(event) => designer.change({ type: 'dark', on: event.currentTarget.checked })}
            />
            <span>{strings.darkPaper}</span>
          </label>
        )}
        {layer === 'foreground' && (
          <label class="lane-setting">
            <span>{strings.ink}</span>
            <input
              type="color"
              value={draft.ink}
              onChange={(event) => designer.change({ type: 'ink', ink: event.currentTarget.value })}
            />
          </label>
        )}
      </header>
      <ol class="cards" aria-label={strings.layerName[layer]}>
        {steps.map((step, at) => (
          <Card
            key={step.key}
            step={step}
            layer={layer}
            at={at}
            last={at === steps.length - 1}
            misfit={misfits[at] ?? null}
            marked={gap === at ? 'before' : gap === steps.length && at === steps.length - 1 ? 'behind' : ''}
            picture={stages.get(first + at)}
            carried={carried?.from?.layer === layer && carried.from.at === at}
            onTake={(event) => take(event, { from: { layer, at } })}
            onInsert={() => onAdd(at)}
          />
        ))}
      </ol>
      {steps.length === 0 && (
        <p class="quiet lane-empty" data-target={gap >= 0}>
          {strings.emptyLayer[layer]}
        </p>
      )}
      <WhereChoice
        label={strings.whereLayer[layer]}
        part={draft.where?.[layer] ?? null}
        onSet={(part) => designer.change({ type: 'layer-where', layer, part })}
      />
      {!adding && (
        <ActionButton
          action={{ label: strings.addToLayer[layer], icon: 'add', run: () => onAdd(null) }}
          class="button small lane-add"
          text
        />
      )}
    </section>
  );
}
