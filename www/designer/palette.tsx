/**
 * The palette of blocks. Each block shows its effect on the user's photo at the insert position. A press adds one
 * there, at the end unless a place was named; dragging puts it anywhere.
 */

import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { followerOf, LAYERS } from './designer.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { Bitmap } from '../ui/bitmap.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { thumbnail } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import { BlockName, plainName } from './block-name.tsx';
import { focusCard, showCard } from './focus-card.ts';
import type { CardDrag } from './card-drag.ts';
import type { Block, DraftFacts, Layer, ParamValue, Style } from '../engine/types.ts';

const SIZE = { width: 132, height: 99 };
/** Example values for blocks whose default values have no effect. */
const TELLING: Record<string, Record<string, ParamValue>> = {
  hue: { angle: 90 },
  size: { percent: 20 },
  dynamic_range: { range: 255 },
};

export function Palette({ drag, onClose, onAdded }: { drag: CardDrag; onClose: () => void; onAdded: () => void }) {
  const { store, designer, engine, ui } = useApp();
  const [words, setWords] = useState('');
  const field = useRef(null as HTMLInputElement | null);
  const hero = useHero();
  const blocks = designer.blocks.value;
  const draft = designer.draft.value;
  const { layer, at } = designer.place.value;
  const steps = draft?.[layer] ?? [];
  // An undo may have removed the position.
  const to = Math.min(at ?? steps.length, steps.length);
  const facts = useMemo(() => designer.factsBefore({ layer, at: to }), [draft, layer, to]);
  const follower = blocks.find(({ id }) => id === steps[to]?.block);
  const brings = facts?.[layer].brings ?? {};
  const meta = store.facts.value.find(({ id }) => id === hero)?.meta;
  const size = thumbnail(meta, SIZE.width, SIZE.height);
  const found = search(blocks, words);
  const pictures = useMemo(
    () => new Map(blocks.map((block) => [block.id, facts && styleWith(facts, layer, block)])),
    [facts, layer, blocks],
  );
  // The next typed text goes to the search field.
  useLayoutEffect(() => field.current?.focus(), [layer, at]);

  function add(block: Block) {
    const place = designer.insert(block.id, { layer, at: to });
    if (!place) return;
    // The palette stays open for more blocks. A place that was named is for one, and on a small screen it hides the lanes.
    if (ui.wide.peek() && at === null) {
      setWords('');
      showCard(place);
      return;
    }
    onAdded();
    focusCard(place);
  }

  const toEnd = {
    label: strings.toEnd,
    run() {
      designer.place.value = { layer, at: null };
    },
  };
  return (
    <section
      class="palette"
      aria-label={strings.palette}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        event.stopPropagation();
        onClose();
      }}
    >
      <div class="palette-head">
        <input
          ref={field}
          class="text"
          type="search"
          aria-label={strings.searchBlocks}
          placeholder={strings.searchBlocks}
          value={words}
          onInput={(event) => setWords(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === 'Enter' && found.length > 0 && words !== '') add(found[0]);
          }}
        />
        <IconButton icon="close" label={strings.close} onClick={onClose} />
      </div>
      <div class="segments">
        {LAYERS.map((name) => (
          <button
            type="button"
            key={name}
            aria-pressed={name === layer}
            onClick={() => {
              designer.place.value = { layer: name, at: null };
            }}
          >
            {strings.addToLayer[name]}
          </button>
        ))}
      </div>
      {follower ? (
        <p class="palette-place">
          <span>{strings.goesBefore({ card: strings.card({ name: strings.blockName(follower), n: to + 1 }) })}</span>
          <ActionButton action={toEnd} class="button small" text />
        </p>
      ) : (
        <p class="quiet palette-place">{strings.dragBlock}</p>
      )}
      {steps.length >= MOST.blocks - 1 && <p class="quiet">{strings.fullLayer}</p>}
      <ul class="palette-blocks">
        {found.map((block) => {
          const before = brings[block.id];
          const after = followerOf(block.id, steps[to]?.block);
          const others = blocks.filter(({ id }) => id === before?.remedy || id === after);
          const note = others.map((other) => strings.bringsWith({ name: plainName(other) })).join(' ');
          return (
            <li key={block.id}>
              <button
                type="button"
                class="palette-block"
                title={`${strings.blockName(block)}: ${strings.blockHelp(block)}`}
                aria-description={[strings.blockHelp(block), note].filter(Boolean).join(' ')}
                disabled={steps.length + 1 + Number(!!before) + Number(!!after) > MOST.blocks}
                onPointerDown={(event) => drag.take(event, { block: block.id })}
                onClick={() => add(block)}
              >
                {hero === null ? (
                  <span class="bitmap" />
                ) : (
                  <Bitmap
                    of={pictures.get(block.id)}
                    draw={(call) => engine.stylePhoto(hero, pictures.get(block.id) ?? {}, size, call)}
                  />
                )}
                <span class="card-handle" aria-hidden="true">
                  <Icon name="handle" />
                </span>
                <span class="palette-name">
                  <BlockName block={block} />
                </span>
                {note && <span class="palette-note">{note}</span>}
              </button>
            </li>
          );
        })}
      </ul>
      {found.length === 0 && <p class="quiet">{strings.noBlocks}</p>}
    </section>
  );
}

/** @returns blocks with all search words in their names first, then in their descriptions */
function search(blocks: readonly Block[], words: string): Block[] {
  const wanted = words.toLowerCase().split(/\s+/);
  const has = (text: string) => wanted.every((word) => text.toLowerCase().includes(word));
  const named = blocks.filter((block) => has(`${block.id} ${block.label} ${strings.blockName(block)}`));
  return [
    ...named,
    ...blocks.filter(
      (block) => !named.includes(block) && has(`${strings.blockName(block)} ${strings.blockHelp(block)}`),
    ),
  ];
}

/** A style of the layer up to that point and the block. */
function styleWith(facts: DraftFacts, layer: Layer, block: Block): Style {
  const before = facts[layer].brings[block.id];
  const after = [followerOf(block.id, undefined) ?? []].flat();
  const steps = [
    ...(facts.shown[layer] ?? []),
    ...(before ? [{ block: before.remedy }] : []),
    { block: block.id, ...TELLING[block.id] },
    ...after.map((id) => ({ block: id })),
  ];
  return { id: 'palette', name: 'palette', tags: [], background: steps.slice(-MOST.blocks) };
}
