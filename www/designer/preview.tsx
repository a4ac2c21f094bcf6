/**
 * What the style does to a photo of the album, or to four at once, beside the photo as it is.
 */

import { useSignal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { PLAIN, thumbnail } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import { Comparison } from './comparison.tsx';
import type { Designed } from '../engine/design.ts';

const THUMB = 64;

export function Preview({ onStages }: { onStages: (designed: Designed) => void }) {
  const { store, engine, designer } = useApp();
  const chosen = useSignal(null as string | null);
  const four = useSignal(false);
  const compare = useSignal(false);
  const split = useSignal(0.5);
  /** The photos that are being drawn. */
  const busy = useSignal(new Set() as ReadonlySet<string>);
  const hero = useHero();
  const facts = store.facts.value.flatMap((fact) =>
    fact.meta && engine.hasPhoto(fact.id) ? [{ ...fact, meta: fact.meta }] : [],
  );
  const ids = facts.map(({ id }) => id);
  const first = chosen.value && ids.includes(chosen.value) ? chosen.value : (hero ?? ids[0]);
  const at = Math.max(0, ids.indexOf(first));
  const shown = four.value ? [...facts.slice(at), ...facts.slice(0, at)].slice(0, 4) : facts.slice(at, at + 1);

  return (
    <section class="preview" aria-label={strings.preview} aria-busy={busy.value.size > 0}>
      <div class="preview-stage" data-count={shown.length}>
        {shown.map((fact, i) => (
          <Comparison
            key={`${fact.id}/${shown.length}`}
            fact={fact}
            style={designer.shown.value ?? PLAIN}
            small={shown.length > 1}
            split={compare.value ? split : null}
            onStages={i === 0 ? onStages : null}
            onBusy={(now) => {
              const others = [...busy.peek()].filter((other) => other !== fact.id);
              busy.value = new Set(now ? [...others, fact.id] : others);
            }}
          />
        ))}
      </div>
      <div class="preview-tools">
        <button
          type="button"
          class="button small"
          aria-pressed={compare.value}
          onClick={() => {
            compare.value = !compare.value;
          }}
        >
          {strings.compare}
        </button>
        <button
          type="button"
          class="button small"
          aria-pressed={four.value}
          disabled={ids.length < 2}
          onClick={() => {
            four.value = !four.value;
          }}
        >
          {strings.fourPhotos}
        </button>
        <ul class="preview-photos" aria-label={strings.previewPhotos}>
          {facts.map(({ id, name, meta }) => (
            <li key={id}>
              <button
                type="button"
                aria-label={strings.previewOf(name)}
                title={name}
                aria-current={id === first ? 'true' : undefined}
                onClick={() => {
                  chosen.value = id;
                }}
              >
                <Bitmap of={id} draw={(call) => engine.stylePhoto(id, PLAIN, thumbnail(meta, THUMB), call)} />
              </button>
            </li>
          ))}
        </ul>
      </div>
    </section>
  );
}
