/**
 * The blocks that can be added, each as a picture of what it does to the person's own photo at the end of the layer.
 */

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { LAYERS } from './designer.ts';
import { strings } from '../strings/strings.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { thumbnail } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import type { Block, DraftFacts, Layer, ParamValue, Style } from '../engine/types.ts';

const SIZE = { width: 132, height: 99 };
/** What a picture shows of the blocks whose usual values do nothing. */
const TELLING: Record<string, Record<string, ParamValue>> = {
  hue: { angle: 90 },
  size: { percent: 20 },
  dynamic_range: { range: 255 },
};

export function Palette({ onClose, onAdded }: { onClose: () => void; onAdded: () => void }) {
  const { store, designer, engine } = useApp();
  const [words, setWords] = useState('');
  const field = useRef(null as HTMLInputElement | null);
  const hero = useHero();
  const blocks = designer.blocks.value;
  const draft = designer.draft.value;
  const layer = designer.layer.value;
  const steps = draft?.[layer] ?? [];
  const facts = designer.facts.value;
  const brings = facts?.[layer].brings ?? {};
  const meta = store.facts.value.find(({ id }) => id === hero)?.meta;
  const size = thumbnail(meta, SIZE.width, SIZE.height);
  const found = search(blocks, words);
  const pictures = useMemo(
    () => new Map(blocks.map((block) => [block.id, facts && styleWith(facts, layer, block)])),
    [facts, layer, blocks],
  );
  useEffect(() => field.current?.focus(), []);

  function add(block: Block) {
    const before = brings[block.id];
    designer.change({ type: 'add', layer, at: steps.length, blocks: before ? [before.remedy, block.id] : [block.id] });
    onAdded();
    requestAnimationFrame(() => {
      const cards = document.querySelectorAll(`.cards[aria-label="${strings.layerName[layer]}"] .card`);
      ([...cards].at(-1) as HTMLElement | undefined)?.focus();
    });
  }

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
              designer.layer.value = name;
            }}
          >
            {strings.addToLayer[name]}
          </button>
        ))}
      </div>
      {steps.length >= MOST.blocks - 1 && <p class="quiet">{strings.fullLayer}</p>}
      <ul class="palette-blocks">
        {found.map((block) => {
          const before = brings[block.id];
          const note = before ? strings.brings[before.lacks] : '';
          return (
            <li key={block.id}>
              <button
                type="button"
                class="palette-block"
                title={strings.blockHelp(block)}
                aria-description={[strings.blockHelp(block), note].filter(Boolean).join(' ')}
                disabled={steps.length + (before ? 2 : 1) > MOST.blocks}
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
                <span class="palette-name">{strings.blockName(block)}</span>
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

/** @returns those whose names have the words first, then those that are explained with them */
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

/** The layer with the block at its end, by itself. */
function styleWith(facts: DraftFacts, layer: Layer, block: Block): Style {
  const before = facts[layer].brings[block.id];
  const steps = [
    ...(facts.shown[layer] ?? []),
    ...(before ? [{ block: before.remedy }] : []),
    { block: block.id, ...TELLING[block.id] },
  ];
  return { id: 'palette', name: 'palette', tags: [], background: steps.slice(-MOST.blocks) };
}
