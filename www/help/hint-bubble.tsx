/** The hint that is to be seen, near what it is about; it takes neither the focus nor the pointer, but for its button. */

import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { placeHint } from './hint-place.ts';
import type { Hint } from './hints.ts';
import type { Place, Side } from './hint-place.ts';

/** Time in ms that the pointer must rest on a panel. */
const REST = 500;
const CONTROLS = 'button, select, summary, textarea, a[href], input:not([type=file]), [role=slider], [role=option]';

const SIDES: Record<Hint, readonly Side[]> = {
  shuffle: ['above', 'before', 'after', 'below'],
  lock: ['above', 'before', 'after', 'below'],
  crop: ['after', 'before', 'below', 'above'],
};

export function HintBubble() {
  const { hints } = useApp();
  const hint = hints.shown.value;
  const text = hint && strings.hint[hint === 'crop' && isTouch() ? 'cropTouch' : hint];
  usePointedPanel();
  return (
    <div class="hints">
      <p class="visually-hidden" aria-live="polite">
        {text ?? ''}
      </p>
      {hint && text && <Bubble key={hint} hint={hint} text={text} />}
    </div>
  );
}

const isTouch = () => window.matchMedia('(pointer: coarse)').matches;

function Bubble({ hint, text }: { hint: Hint; text: string }) {
  const { hints } = useApp();
  const ref = useRef(null as HTMLDivElement | null);
  const [place, setPlace] = useState(null as Place | null);
  const panel = hints.panel.value;
  const last = useRef(0);
  if (panel !== null) last.current = panel;

  useLayoutEffect(() => {
    let frame = 0;
    const put = () => {
      frame = 0;
      const found = ref.current && findPlace(ref.current, hint, last.current);
      setPlace((before) => (JSON.stringify(before) === JSON.stringify(found) ? before : found));
    };
    const later = () => {
      frame ||= requestAnimationFrame(put);
    };
    put();
    const changes = new MutationObserver(later);
    changes.observe(document.body, {
      childList: true,
      subtree: true,
      attributeFilter: ['style', 'hidden', 'data-open'],
    });
    const sizes = new ResizeObserver(later);
    for (const element of document.querySelectorAll('.page, .centre')) sizes.observe(element);
    const ended = new AbortController();
    for (const type of ['resize', 'transitionend', 'animationend', 'scroll'])
      window.addEventListener(type, later, { signal: ended.signal, capture: true });
    return () => {
      cancelAnimationFrame(frame);
      changes.disconnect();
      sizes.disconnect();
      ended.abort();
    };
  }, [hint, panel]);

  useEffect(() => {
    const ended = new AbortController();
    // Escape does what else it does, too.
    const onKey = ({ key }: KeyboardEvent) => key === 'Escape' && hints.close();
    window.addEventListener('keydown', onKey, { signal: ended.signal, capture: true });
    return () => ended.abort();
  }, []);

  return (
    <div
      ref={ref}
      class="hint"
      data-side={place?.tail == null ? undefined : place.side}
      data-placed={place !== null}
      style={
        place === null ? undefined : { left: `${place.x}px`, top: `${place.y}px`, '--tail': `${place.tail ?? 0}px` }
      }
    >
      <p aria-hidden="true">{text}</p>
      <IconButton icon="close" label={strings.closeHint} onClick={hints.close} />
    </div>
  );
}

function findPlace(bubble: HTMLElement, hint: Hint, panel: number): Place | null {
  const anchor = anchorOf(hint, panel);
  if (!anchor) return null;
  const controls = [...document.querySelectorAll<HTMLElement>(CONTROLS)]
    .filter((element) => !bubble.contains(element) && element.checkVisibility({ visibilityProperty: true }))
    .map((element) => element.getBoundingClientRect());
  const messages = [...document.querySelectorAll('.toast')].map((element) => element.getBoundingClientRect());
  const size = { width: bubble.offsetWidth, height: bubble.offsetHeight };
  const stage = hint === 'crop' ? document.querySelector('.centre') : null;
  const room = stage?.getBoundingClientRect() ?? new DOMRect(0, 0, window.innerWidth, window.innerHeight);
  return placeHint(anchor.getBoundingClientRect(), size, room, { controls, messages }, SIDES[hint]);
}

function anchorOf(hint: Hint, panel: number): Element | null {
  if (hint === 'crop') return document.querySelectorAll('.panels > .panel')[panel] ?? null;
  return document.querySelector(hint === 'shuffle' ? '.shuffle' : '.part-lock');
}

/** Reports the panel under a resting mouse, while hints need it. */
function usePointedPanel() {
  const { hints } = useApp();
  const watches = hints.watches.value;
  useEffect(() => {
    if (!watches) return;
    const ended = new AbortController();
    let timer: ReturnType<typeof setTimeout> | undefined;
    const over = ({ target, pointerType }: PointerEvent) => {
      const panel = pointerType === 'mouse' && target instanceof Element ? target.closest('.panels > .panel') : null;
      clearTimeout(timer);
      if (!panel) return hints.point(null);
      const at = [...(panel.parentElement?.children ?? [])].indexOf(panel);
      timer = setTimeout(() => hints.point(at), REST);
    };
    window.addEventListener('pointerover', over, { signal: ended.signal });
    return () => {
      clearTimeout(timer);
      ended.abort();
    };
  }, [watches]);
}
