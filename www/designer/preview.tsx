/**
 * What the style does to a photo of the album, or to four at once, beside the photo as it is.
 */

import { useSignal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { PLAIN } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import { PhotoPicker, useDrawnPhotos } from '../photos/photo-picker.tsx';
import { Comparison } from './comparison.tsx';
import type { Designed } from '../engine/design.ts';

export function Preview({ onStages }: { onStages: (designed: Designed) => void }) {
  const { designer } = useApp();
  const chosen = useSignal(null as string | null);
  const four = useSignal(false);
  const compare = useSignal(false);
  const split = useSignal(0.5);
  /** The photos that are being drawn. */
  const busy = useSignal(new Set() as ReadonlySet<string>);
  const hero = useHero();
  const facts = useDrawnPhotos();
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
        <PhotoPicker
          label={strings.previewPhotos}
          facts={facts}
          chosen={first ?? null}
          told={strings.previewOf}
          onChoose={(id) => {
            chosen.value = id;
          }}
        />
      </div>
    </section>
  );
}
