/**
 * The settings of a video of shots or pages, next to the preview, which equals the exported video. Loaded on first use.
 */

import { useEffect, useMemo, useState } from 'preact/hooks';
import { ANIMATIC_SIZES } from '../engine/bounds.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { FilePick } from './file-pick.tsx';
import { LivingChoice } from './living-choice.tsx';
import { AnimaticPlayer } from './animatic-player.tsx';
import { USUAL } from './animatics.ts';
import { clock } from './clock.ts';
import { bytesOf, GIF, KINDS, kindsHere } from './kinds.ts';
import './animatic.css';
import { after } from '../engine/scheduler.ts';
import { explain } from '../ui/explain.ts';
import type { ComponentChildren } from 'preact';
import type { AnimaticWish, Planned, SizeId } from './animatics.ts';
import type { Kind } from './kinds.ts';

/** Seconds of a dissolve. */
const DISSOLVE = 0.5;
/** While a slider is dragged, nothing is planned. */
const REST_MS = 150;

/** `of`: the source; `children`: the format control, above the others. */
export type AnimaticProps = { of: AnimaticWish['of']; close: () => void; children: ComponentChildren };

export function AnimaticPanel({ of, close, children }: AnimaticProps) {
  const { animatics, boards, download, store } = useApp();
  const [chosen, setWish] = useState(USUAL);
  const wish = useMemo(() => ({ ...chosen, of }), [chosen, of]);
  const pages = of === 'pages';
  const says = pages ? strings.motion : strings.animatic;
  const change = (part: Partial<AnimaticWish>) => setWish({ ...chosen, ...part });
  const { planned, failed } = usePlan(wish);
  const kinds = useKinds(wish);
  // Formats that the browser cannot encode are not offered. The next best format is used.
  const kind = kinds === null || kinds.includes(wish.kind) ? wish.kind : kinds[0];
  const asked = useMemo(() => ({ ...wish, kind }), [wish, kind]);
  const seconds = planned ? planned.plan.frames / planned.plan.rate : 0;
  const similar = pages ? 0 : boards.similar.value.size;
  const long = kind === 'gif' && seconds > GIF.mostSeconds;
  const save = {
    label: strings.save,
    icon: 'download',
    enabled: planned !== null && planned.plan.frames > 0,
    why: long ? strings.reasons['animatic-long'] : download.progress.value === null ? '' : strings.exportRuns,
    run() {
      void download.saveAs({ pages: [], format: kind, film: asked });
      close();
    },
  };
  return (
    <div class="export animatic">
      <AnimaticPlayer planned={planned} />
      <div class="export-choices">
        {children}
        <p class="quiet">{says.help}</p>
        <label class="field">
          <span>{strings.animatic.kind}</span>
          <select class="select" value={kind} onChange={(event) => change({ kind: event.currentTarget.value as Kind })}>
            {(Object.keys(KINDS) as Kind[]).map((id) => (
              <option key={id} value={id} disabled={kinds !== null && !kinds.includes(id)}>
                {strings.animatic.kinds[id]}
              </option>
            ))}
          </select>
        </label>
        {kinds !== null && kinds.length < Object.keys(KINDS).length && (
          <p class="quiet">{strings.animatic.kindsMissing}</p>
        )}
        <label class="field">
          <span>{strings.animatic.size}</span>
          <select
            class="select"
            value={wish.size}
            onChange={(event) => change({ size: event.currentTarget.value as SizeId })}
          >
            {ANIMATIC_SIZES.map(({ id }) => (
              <option key={id} value={id}>
                {strings.animatic.sizes[id]}
              </option>
            ))}
          </select>
        </label>
        <label class="field">
          <span>{says.seconds}</span>
          <input
            type="range"
            min="0.5"
            max="10"
            step="0.5"
            value={wish.seconds}
            onInput={(event) => change({ seconds: Number(event.currentTarget.value) })}
          />
          <output aria-hidden="true">{strings.animatic.secondsOf({ seconds: wish.seconds })}</output>
        </label>
        <label class="field">
          <span>{says.change}</span>
          <select
            class="select"
            value={wish.dissolve}
            onChange={(event) => change({ dissolve: Number(event.currentTarget.value) })}
          >
            <option value={0}>{strings.animatic.cuts}</option>
            <option value={DISSOLVE}>{strings.animatic.dissolves}</option>
          </select>
        </label>
        <div class="animatic-checks">
          <Check on={wish.moves} set={(moves) => change({ moves })} label={strings.animatic.moves} />
          {!pages && (
            <Check on={wish.captions} set={(captions) => change({ captions })} label={strings.animatic.captions} />
          )}
          {similar > 0 && (
            <Check
              on={wish.skips}
              set={(skips) => change({ skips })}
              label={strings.animatic.skips({ count: similar })}
            />
          )}
          <LivingChoice of={of} on={wish.living} set={(living) => change({ living })} />
        </div>
        <FilePick
          label={strings.animatic.sound}
          file={wish.sound}
          accept="audio/*"
          off={kind === 'gif'}
          choose={(sound) => change({ sound })}
        />
        {kind === 'gif' && wish.sound && <p class="quiet">{strings.animatic.gifMute}</p>}
        <p class="quiet export-facts" aria-live="polite">
          {failed ? (
            <span>{says.failed({ why: failed })}</span>
          ) : planned ? (
            <>
              <span>
                {says.facts({
                  count: planned.plan.clips.length,
                  length: clock(seconds),
                  fps: strings.decimal(Math.round(planned.plan.rate * 1000) / 1000),
                })}
              </span>
              <span>
                {strings.aboutSize({
                  size: strings.fileSize(
                    bytesOf(kind, {
                      ...animatics.sizeOf(asked),
                      seconds,
                      sound: wish.sound !== null && kind !== 'gif',
                    }),
                  ),
                })}
              </span>
            </>
          ) : (
            <span>{store.tray.value.length === 0 ? strings.animatic.empty : says.planning}</span>
          )}
        </p>
        {long && <p class="quiet">{strings.reasons['animatic-long']}</p>}
        <div class="export-actions">
          <ActionButton action={save} class="button strong wide" text />
        </div>
      </div>
    </div>
  );
}

function Check({ on, set, label }: { on: boolean; set: (on: boolean) => void; label: string }) {
  return (
    <label class="choice">
      <input type="checkbox" checked={on} onChange={(event) => set(event.currentTarget.checked)} />
      {label}
    </label>
  );
}

/** The current plan, updated when options or shots change. The file type matters only for GIF. */
function usePlan(wish: AnimaticWish): { planned: Planned | null; failed: string | null } {
  const { animatics, boards, store } = useApp();
  const [state, setState] = useState({ planned: null as Planned | null, failed: null as string | null });
  const rows = boards.rows.value;
  const board = boards.board.value;
  const style = store.page.value?.style;
  const sheets = wish.of === 'pages' ? store.sheets.value : null;
  const { of, size, seconds, dissolve, moves, captions, skips, living } = wish;
  const gif = wish.kind === 'gif';
  useEffect(() => {
    const stop = new AbortController();
    const cancel = after(REST_MS, () => {
      animatics.planned(wish, { signal: stop.signal }).then(
        (planned) => !stop.signal.aborted && setState({ planned, failed: null }),
        (error) => !stop.signal.aborted && setState({ planned: null, failed: explain(error) }),
      );
    });
    return () => {
      cancel();
      stop.abort();
    };
  }, [rows, board, style, sheets, of, size, seconds, dissolve, moves, captions, skips, living, gif]);
  return state;
}

/** The formats that this browser can encode at this size; null until it is known. */
function useKinds({ size }: AnimaticWish): readonly Kind[] | null {
  const { animatics } = useApp();
  const [kinds, setKinds] = useState(null as readonly Kind[] | null);
  useEffect(() => {
    let gone = false;
    // Tested with a video, because the size of a GIF does not depend on an encoder.
    void kindsHere(animatics.sizeOf({ kind: 'mp4', size })).then((found) => {
      if (!gone) setKinds(found);
    });
    return () => {
      gone = true;
    };
  }, [size]);
  return kinds;
}
