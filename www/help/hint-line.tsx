/** The present hint: a line among the controls, so that it covers neither the page nor a control. */

import { useEffect } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { createTimer } from '../engine/scheduler.ts';

/** The pointer rests on a panel for this long, in ms, before the hint about photos appears. */
const REST = 500;

export function HintLine() {
  const { hints } = useApp();
  const hint = hints.shown.value;
  const text = hint && strings.hint[hint === 'crop' && isTouch() ? 'cropTouch' : hint];
  usePointedPanel();
  return (
    <p class="hint" role="status" data-hint={hint ?? undefined}>
      {text ?? ''}
    </p>
  );
}

const isTouch = () => window.matchMedia('(pointer: coarse)').matches;

/** Reports the panel that a mouse rests on, as long as that matters. */
function usePointedPanel() {
  const { hints } = useApp();
  const watches = hints.watches.value;
  useEffect(() => {
    if (!watches) return;
    const ended = new AbortController();
    const timer = createTimer();
    const over = ({ target, pointerType }: PointerEvent) => {
      const panel = pointerType === 'mouse' && target instanceof Element ? target.closest('.panels > .panel') : null;
      timer.stop();
      if (!panel) return hints.point(null);
      const at = [...(panel.parentElement?.children ?? [])].indexOf(panel);
      timer.start(REST, () => hints.point(at));
    };
    window.addEventListener('pointerover', over, { signal: ended.signal });
    return () => {
      timer.stop();
      ended.abort();
    };
  }, [watches]);
}
