/** Preview of the style on one photo, four photos, or the page, next to the original. */

import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { PLAIN } from '../photos/cover.ts';
import { modelsOf } from '../painters/references.ts';
import { useHero } from '../photos/hero.ts';
import { PhotoPicker, useDrawnPhotos } from '../photos/photo-picker.tsx';
import { Comparison } from './comparison.tsx';
import { pageSubject, photoSubject } from './preview-subjects.ts';
import type { Signal } from '@preact/signals';
import type { Action } from '../ui/action.ts';
import type { Designed } from '../engine/design.ts';

const KINDS = ['photo', 'page'] as const;

function toggle(label: string, on: Signal<boolean>): Action {
  return {
    label,
    on,
    run() {
      on.value = !on.peek();
    },
  };
}

export function Preview({ onStages }: { onStages: (designed: Designed) => void }) {
  const { engine, designer, lettering, ownPainters } = useApp();
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

  const page = designer.sheet.value;
  const kind = page && facts.length > 0 ? designer.preview.value : 'photo';
  // The style of the page is ignored: the preview uses the draft, and the page may follow each edit.
  const pageKey = kind === 'page' ? JSON.stringify({ ...page, style: null }) : '';
  const subjects = useMemo(
    () =>
      kind === 'page' && page
        ? [pageSubject(engine, pageKey, lettering.on(page), facts[at])]
        : shown.map((fact) => photoSubject(engine, fact, shown.length > 1)),
    [kind, pageKey, at, shown.length, ids.join(' ')],
  );

  return (
    <section class="preview" aria-label={strings.preview} aria-busy={busy.value.size > 0}>
      <div class="preview-stage" data-count={subjects.length}>
        {subjects.map((subject, i) => {
          const key = kind === 'page' ? 'page' : `${subject.of}/${subjects.length}`;
          return (
            <Comparison
              key={key}
              subject={subject}
              style={designer.shown.value ?? PLAIN}
              models={modelsOf(ownPainters.models.value, designer.shown.value)}
              split={compare.value ? split : null}
              onStages={i === 0 ? onStages : null}
              onBusy={(now) => {
                const others = [...busy.peek()].filter((other) => other !== key);
                busy.value = new Set(now ? [...others, key] : others);
              }}
            />
          );
        })}
      </div>
      <div class="preview-tools">
        <div class="segments" role="group" aria-label={strings.previewKinds}>
          {KINDS.map((each) => (
            <button
              key={each}
              type="button"
              aria-pressed={each === kind}
              disabled={each === 'page' && page === null}
              onClick={() => {
                designer.preview.value = each;
              }}
            >
              {strings.previewKind[each]}
            </button>
          ))}
        </div>
        <ActionButton action={toggle(strings.compare, compare)} class="button small" text />
        {kind === 'photo' && (
          <>
            <ActionButton
              action={{ ...toggle(strings.fourPhotos, four), enabled: ids.length > 1 }}
              class="button small"
              text
            />
            <PhotoPicker
              label={strings.previewPhotos}
              facts={facts}
              chosen={first ?? null}
              told={(name) => strings.previewOf({ name })}
              onChoose={(id) => {
                chosen.value = id;
              }}
            />
          </>
        )}
      </div>
    </section>
  );
}
