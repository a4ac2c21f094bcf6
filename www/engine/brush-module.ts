/**
 * The module that corrects masks. It is loaded with the first correction, on the main thread, because it draws while
 * the brush moves.
 */

import { moduleBytes } from './module-bytes.ts';
import { onceMore } from './once-more.ts';
import type { PhotoHandle } from './protocol.ts';

const MODULE = new URL('../pkg-brush/inkpanel_bg.wasm', import.meta.url);

type Brushing = typeof import('../pkg-brush/inkpanel.js');
/** A correction of the whole mask. */
export type Mending = 'Grow' | 'Shrink' | 'Feather' | 'Invert' | 'Everything' | 'Nothing' | 'Found' | 'NextFigure';
export type Hand = ReturnType<typeof createHand>;

/** Loads the module once, and tries again after an error. Rejects with `brush-missing`. */
const { get: brushing } = onceMore(load);

async function load(): Promise<Brushing> {
  const bytes = await moduleBytes(
    MODULE,
    'brush-missing',
    'The brush for subjects could not be loaded. Try again with a connection.',
  );
  const module = await import('../pkg-brush/inkpanel.js');
  await module.default({ module_or_path: bytes });
  return module;
}

/**
 * A mask during correction. Must be freed.
 * @param own the corrected mask; `found` is the detected mask
 */
export async function takeInHand(
  { width, height, planes }: Omit<PhotoHandle, 'key'>,
  { own, found }: { own?: string; found?: string },
): Promise<Hand> {
  const [module, pixels] = await Promise.all([brushing(), planes.arrayBuffer()]);
  return createHand(module, [width, height, new Uint8Array(pixels), own, found]);
}

/** @param begin creates the mask in the module */
export function createHand(
  { Retouch, Mend }: Pick<Brushing, 'Retouch' | 'Mend'>,
  begin: ConstructorParameters<Brushing['Retouch']>,
) {
  const retouch = new Retouch(...begin);
  return {
    /** Width of the image from `draw`, in pixels. */
    width: retouch.width,
    height: retouch.height,
    /** @param fine with the photo's own edges, for which a stroke under way may not wait @returns RGBA */
    draw: (fine: boolean) => new Uint8ClampedArray(retouch.draw(fine)),
    /**
     * Goes on with a stroke.
     * @param path x and y in parts of the photo, one after the other
     * @param radius in photo widths
     */
    paint: (path: readonly number[], radius: number, adds: boolean) =>
      retouch.paint(new Float32Array(path), radius, adds),
    /** Ends the stroke. @returns whether anything changed, as all that follow */
    end: () => retouch.end(),
    /** Takes back the stroke that is not ended. */
    abandon: () => retouch.abandon(),
    mend: (how: Mending) => retouch.mend(Mend[how]),
    /** Selects only the figure at a position, in fractions of the photo. */
    choose: (x: number, y: number) => retouch.choose(x, y),
    undo: () => retouch.undo(),
    redo: () => retouch.redo(),
    /** How the mask is now; `coverage` is the part of the photo that is the subject. */
    told: () => ({
      coverage: retouch.coverage,
      undoable: retouch.undoable,
      redoable: retouch.redoable,
      found: retouch.found,
    }),
    /** @returns the mask after each step; null for the detected mask */
    steps: (): (string | null)[] => retouch.steps().map((mask) => mask || null),
    free: () => retouch.free(),
  };
}
