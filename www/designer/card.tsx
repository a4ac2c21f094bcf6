/**
 * A block of a layer: the picture after it, what it costs, its controls.
 */

import { useEffect, useRef } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { partsOf } from '../painters/references.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { Menu } from '../ui/menu.tsx';
import { BlockName } from './block-name.tsx';
import { Parameter } from './parameter.tsx';
import { WhereChoice } from './where-choice.tsx';
import type { BlockParam, DraftStep, Layer, Misfit } from '../engine/types.ts';

/** The entry for custom colours. */
const OWN = 'own';

/** @param props `marked`: a dragged card would land on that side of it */
export function Card({
  step,
  layer,
  at,
  last,
  misfit,
  marked,
  picture,
  carried,
  onTake,
  onInsert,
}: {
  step: DraftStep;
  layer: Layer;
  at: number;
  last: boolean;
  misfit: Misfit | null;
  marked: '' | 'before' | 'behind';
  picture?: ImageBitmap;
  carried: boolean;
  onTake: (event: PointerEvent) => void;
  onInsert: () => void;
}) {
  const { designer, ownPainters } = useApp();
  const ref = useRef(null as HTMLLIElement | null);
  const block = designer.blocks.value.find(({ id }) => id === step.block);
  if (!block) return null;

  /** Moves the card and restores its focus, which the browser removes from moved elements. */
  function move(to: number) {
    const focused = document.activeElement as HTMLElement | null;
    designer.change({ type: 'move', layer, at, toLayer: layer, to });
    requestAnimationFrame(() => {
      const usable = focused?.isConnected && !(focused as HTMLButtonElement).disabled;
      (usable ? focused : ref.current)?.focus();
      ref.current?.scrollIntoView({ block: 'nearest' });
    });
  }

  /** To the end of the other layer, with the focus. */
  function moveAcross() {
    const toLayer = layer === 'background' ? 'foreground' : 'background';
    designer.change({ type: 'move', layer, at, toLayer, to: MOST.blocks });
    requestAnimationFrame(() => {
      const moved = document.querySelector(`.card[data-key="${step.key}"]`) as HTMLElement | null;
      moved?.focus();
      moved?.scrollIntoView({ block: 'nearest' });
    });
  }

  function remove() {
    const cards = [...(ref.current?.parentElement?.children ?? [])];
    const next = (cards[at + 1] ?? cards[at - 1]) as HTMLElement | undefined;
    designer.change({ type: 'remove', layer, at });
    next?.focus();
  }

  function onKeyDown(event: KeyboardEvent) {
    const { key, altKey, target } = event;
    if (altKey && (key === 'ArrowUp' || key === 'ArrowDown')) move(key === 'ArrowUp' ? at - 1 : at + 1);
    else if (key === 'Delete' && target === ref.current) remove();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  const model = ownPainters.models.value.get(partsOf(String(step.values.model ?? '')).id);

  /** Custom colours are shown only if the parameter uses them, in the required number. */
  const asked = ({ id, kind }: BlockParam) => {
    if (model?.painters === 1 && id === 'painter') return false;
    if (kind !== 'colour') return true;
    const place = /^color_(\d)$/.exec(id)?.[1];
    const own = Object.values(step.values).includes(OWN);
    return own && (place === undefined || Number(place) <= Number(step.values.colors));
  };

  /** A model of the user has its own number of painters. */
  const ranged = (param: BlockParam) => (model && param.id === 'painter' ? { ...param, max: model.painters } : param);

  const name = strings.card({ name: strings.blockName(block), n: at + 1 });
  const more = [
    { label: strings.moveAcross, run: moveAcross },
    { label: strings.duplicate, run: () => designer.change({ type: 'duplicate', layer, at }) },
    {
      label: strings.reset,
      enabled: block.params.length > 0,
      run: () => designer.change({ type: 'reset', layer, at }),
    },
  ];
  return (
    <li
      class="card"
      ref={ref}
      tabIndex={-1}
      aria-label={name}
      data-bypass={step.bypass}
      data-marked={marked}
      data-carried={carried}
      data-key={step.key}
      onKeyDown={onKeyDown}
    >
      <button
        type="button"
        class="card-insert"
        aria-label={strings.insertBefore({ card: name })}
        title={strings.insertBefore({ card: name })}
        onClick={onInsert}
      >
        <Icon name="add" />
      </button>
      <div class="card-head" title={strings.handle} onPointerDown={onTake}>
        <Picture bitmap={picture} />
        <div class="card-name">
          <h4>
            <BlockName block={block} />
          </h4>
        </div>
        <span class="card-handle" aria-hidden="true">
          <Icon name="handle" />
        </span>
      </div>
      <div class="card-tools">
        <IconButton
          icon={step.bypass ? 'hidden' : 'shown'}
          label={strings.bypass}
          help={strings.skipBlock}
          short={strings.cardShort.bypass}
          pressed={step.bypass}
          onClick={() => designer.change({ type: 'bypass', layer, at, on: !step.bypass })}
        />
        <IconButton icon="bin" label={strings.remove} short={strings.cardShort.remove} onClick={remove} />
        <Menu icon="dots" label={strings.more}>
          {more.map((action) => (
            <ActionButton key={action.label} action={action} class="button" text />
          ))}
        </Menu>
        <span class="card-moves">
          <IconButton
            icon="up"
            label={strings.moveUp}
            short={strings.cardShort.up}
            disabled={at === 0}
            onClick={() => move(at - 1)}
          />
          <IconButton
            icon="down"
            label={strings.moveDown}
            short={strings.cardShort.down}
            disabled={last}
            onClick={() => move(at + 1)}
          />
        </span>
      </div>
      {misfit && (
        <p class="card-lacks">
          <span>{strings.lacks[misfit.lacks]}</span>
          <ActionButton
            action={{
              label: strings.fix[misfit.lacks],
              run: () => designer.change({ type: 'add', layer, at, blocks: [misfit.remedy] }),
            }}
            class="button small"
            text
          />
        </p>
      )}
      {block.params.filter(asked).map((param) => (
        <Parameter
          key={param.id}
          block={block.id}
          param={ranged(param)}
          value={step.values[param.id]}
          onMove={(value) => designer.hold({ type: 'set', layer, at, param: param.id, value })}
          onSet={(value) => designer.change({ type: 'set', layer, at, param: param.id, value })}
          onRest={designer.release}
        />
      ))}
      <WhereChoice
        label={strings.where}
        part={step.where ?? null}
        onSet={(part) => designer.change({ type: 'where', layer, at, part })}
      />
    </li>
  );
}

function Picture({ bitmap }: { bitmap?: ImageBitmap }) {
  const ref = useRef(null as HTMLCanvasElement | null);
  useEffect(() => {
    const canvas = ref.current;
    if (!canvas || !bitmap) return;
    canvas.width = bitmap.width;
    canvas.height = bitmap.height;
    canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
  }, [bitmap]);
  return <canvas ref={ref} class="bitmap card-picture" aria-hidden="true" />;
}
