// @ts-check
/**
 * One layer: its blocks as cards joined by arrows, in the order in which they run. Cards are moved by dragging their
 * heads, also to the other layer, by buttons, and by Alt with the arrow keys.
 */

import { useRef, useState } from 'preact/hooks';
import { FOREGROUND } from '../../engine/design.js';
import { misfits } from '../../state/designer-draft.js';
import { strings } from '../../strings.js';
import { useApp } from '../context.js';
import { Icon } from '../icon.jsx';
import { Card } from './card.jsx';

/** @typedef {import('../../state/designer-draft.js').Layer} Layer */
/** @typedef {import('../../state/designer-draft.js').Draft} Draft */

/** What a dragged card carries: its layer and place. */
const CARD = 'application/x-inkpanel-block';

/**
 * @param {{
 *   layer: Layer, draft: Draft, onAdd: () => void,
 *   drawn: { times: ReadonlyMap<number, number>, stages: ReadonlyMap<number, ImageBitmap> },
 * }} props
 */
export function Lane({ layer, draft, drawn, onAdd }) {
  const { designer } = useApp();
  const list = useRef(/** @type {HTMLOListElement | null} */ (null));
  /** Where a dragged card would go. */
  const [gap, setGap] = useState(-1);
  const steps = draft[layer];
  const blocks = designer.blocks.value;
  const lacks = misfits(steps, blocks);
  const first = layer === 'foreground' ? FOREGROUND : 0;

  /** @param {DragEvent} event */
  function over(event) {
    if (!event.dataTransfer?.types.includes(CARD)) return;
    event.preventDefault();
    const cards = [.../** @type {HTMLElement} */ (list.current).querySelectorAll('.card')];
    const before = cards.findIndex((card) => {
      const { top, height } = card.getBoundingClientRect();
      return event.clientY < top + height / 2;
    });
    setGap(before < 0 ? cards.length : before);
  }

  /** @param {DragEvent} event */
  function drop(event) {
    const carried = event.dataTransfer?.getData(CARD);
    setGap(-1);
    if (!carried) return;
    event.preventDefault();
    const from = JSON.parse(carried);
    // Taking the card out moves those behind it up by one.
    const to = from.layer === layer && from.at < gap ? gap - 1 : gap;
    designer.change({ type: 'move', layer: from.layer, at: from.at, toLayer: layer, to });
  }

  return (
    <section class="lane" onFocusIn={() => { designer.layer.value = layer; }} onDragOver={over} onDrop={drop}
      onDragLeave={(event) => !list.current?.contains(/** @type {Node | null} */ (event.relatedTarget)) && setGap(-1)}>
      <header class="lane-head">
        <h3 title={strings.layerHelp[layer]}>{strings.layerName[layer]}</h3>
        {layer === 'foreground' && (
          <input type="color" aria-label={strings.ink} title={strings.ink} value={draft.ink}
            onChange={(event) => designer.change({ type: 'ink', ink: event.currentTarget.value })} />
        )}
      </header>
      <ol class="cards" aria-label={strings.layerName[layer]} ref={list}>
        {steps.map((step, at) => (
          <Card
            key={step.key}
            step={step}
            layer={layer}
            at={at}
            last={at === steps.length - 1}
            lacks={lacks[at]}
            marked={gap === at ? 'before' : gap === steps.length && at === steps.length - 1 ? 'behind' : ''}
            ms={drawn.times.get(first + at)}
            picture={drawn.stages.get(first + at)}
            onDragStart={(event) => event.dataTransfer?.setData(CARD, JSON.stringify({ layer, at }))}
            onDragEnd={() => setGap(-1)}
          />
        ))}
      </ol>
      {steps.length === 0 && <p class="quiet lane-empty" data-target={gap >= 0}>{strings.emptyLayer[layer]}</p>}
      <button type="button" class="button small lane-add" onClick={onAdd}><Icon name="add" />{strings.addToLayer[layer]}</button>
    </section>
  );
}
