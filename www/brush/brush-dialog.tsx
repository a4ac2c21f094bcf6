/** The mask editor: the photo with its mask, and tools next to it. */

import { useEffect, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Dialog } from '../ui/dialog.tsx';
import { pressed } from '../ui/shortcut.ts';
import { BrushCanvas } from './brush-canvas.tsx';
import { BrushTools } from './brush-tools.tsx';
import { keepSteps } from './keeping-masks.ts';
import { createRetouching } from './retouching.ts';
import './brush.css';
import type { App } from '../ui/context.ts';
import type { Retouching } from './retouching.ts';

/** @param props `id`: of a photo that was read */
export function BrushDialog({ id }: { id: string }) {
  const app = useApp();
  const { store, ui, messages, crops } = app;
  const name = store.album.peek().get(id)?.name ?? id;
  const retouching = useRetouching(app, id);

  function keep(steps: readonly (string | null)[]) {
    if (steps.length === 0) return;
    keepSteps(store, id, steps);
    crops.found();
  }

  function done() {
    const steps = retouching?.steps() ?? [];
    ui.dialog.value = null;
    keep(steps);
  }

  /** Escape and a click outside also close the dialog. The discarded changes can be restored for a while. */
  function cancel() {
    // The `close` event also comes if the dialog is removed.
    if (typeof ui.dialog.peek() !== 'object' || ui.dialog.peek() === null) return;
    const steps = retouching?.steps() ?? [];
    ui.dialog.value = null;
    if (steps.length > 0) messages.note(strings.brush.dropped, { label: strings.brush.keep, run: () => keep(steps) });
  }

  return (
    <Dialog title={strings.brush.title({ name })} class="brush-dialog" onClose={cancel}>
      {retouching ? (
        <div class="brush" onKeyDown={(event) => steps(event, retouching)}>
          <BrushCanvas id={id} name={name} retouching={retouching} />
          <BrushTools retouching={retouching} done={done} cancel={cancel} />
        </div>
      ) : (
        <p class="brush-waiting" aria-busy="true">
          {strings.brush.waiting}
        </p>
      )}
    </Dialog>
  );
}

/** Undo and redo, wherever in the dialog the focus is. */
function steps(event: KeyboardEvent, retouching: Retouching) {
  if (event.altKey) return;
  const keys = pressed(event);
  const back = keys[0] === 'Mod+Z';
  if (!back && !keys.includes('Shift+Mod+Z') && !keys.includes('Mod+Y')) return;
  event.preventDefault();
  if (back) retouching.undo();
  else retouching.redo();
}

/** @returns the mask of a photo that is being corrected, null until it is loaded */
function useRetouching({ store, engine, ui, messages }: App, id: string): Retouching | null {
  const [retouching, setRetouching] = useState(null as Retouching | null);
  useEffect(() => {
    let left = false;
    let free = () => {};
    const masks = {
      own: store.project.peek().tray.find((item) => item.id === id)?.mask,
      found: store.album.peek().get(id)?.meta?.mask,
    };
    const begin = async () => {
      const hand = await engine.takeInHand(id, masks);
      free = hand.free;
      if (left) free();
      else setRetouching(createRetouching(hand));
    };
    begin().catch(() => {
      if (left) return;
      ui.dialog.value = null;
      messages.alert(strings.brush.missing);
    });
    return () => {
      left = true;
      free();
    };
  }, [id]);
  return retouching;
}
