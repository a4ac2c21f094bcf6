// @ts-check
/**
 * Keeps a preview true to the style: one picture at a time is drawn, and the next begins with what is wanted by then, so
 * that a slider's drag never piles up work. When the hand rests the cards get their pictures, and the preview the
 * full size of its place.
 */

/** @typedef {import('../../engine/documents.js').Style} Style */
/** @typedef {import('../../engine/design.js').Designed} Designed */
/** @typedef {{ id: string, style: Style, width: number, height: number, full: number }} Wish `full`: the width of the preview on the screen */

/** The hand rests when nothing changed for so long, in ms. */
const REST = 140;
/** The longer side of the pictures on the cards. */
const CARD = 176;

/**
 * @param {{
 *   engine: Pick<import('../../engine/engine.js').Engine, 'drawDesign' | 'stylePhoto'>, cards: () => boolean,
 *   onPicture: (picture: { bitmap: ImageBitmap }) => void, onStages: (designed: Designed) => void, onBusy: (busy: boolean) => void,
 *   onError: (error: Error) => void,
 * }} options `cards`: whether the cards want pictures
 */
export function createPreviewLoop({ engine, cards, onPicture, onStages, onBusy, onError }) {
  /** @type {Wish | null} */
  let wanted = null;
  let drawing = false;
  /** @type {any} */
  let timer;
  let stop = new AbortController();

  return {
    /** @param {Wish} wish */
    show(wish) {
      wanted = wish;
      stop.abort();
      clearTimeout(timer);
      onBusy(true);
      if (!drawing) void draw();
    },
    dispose() {
      wanted = null;
      stop.abort();
      clearTimeout(timer);
    },
  };

  async function draw() {
    drawing = true;
    let wish = wanted;
    while (wish) {
      const { id, style, width, height } = wish;
      try {
        const designed = await engine.drawDesign(id, style, { width, height });
        if (wanted) onPicture(designed);
      } catch (error) {
        tell(error);
      }
      if (wanted === wish) break;
      wish = wanted;
    }
    drawing = false;
    if (wanted) timer = setTimeout(refine, REST);
  }

  async function refine() {
    const wish = /** @type {Wish} */ (wanted);
    const { id, style, width, height, full } = wish;
    stop = new AbortController();
    const { signal } = stop;
    try {
      if (cards()) {
        const designed = await engine.drawDesign(id, style, { width, height, stages: CARD }, { signal });
        if (wanted === wish) onStages(designed);
      }
      if (full > width * 1.05 && wanted === wish) {
        const size = { width: full, height: Math.max(1, Math.round(full * height / width)), tier: /** @type {const} */ ('work') };
        const picture = await engine.stylePhoto(id, style, size, { signal });
        if (wanted === wish) onPicture(picture);
      }
    } catch (error) {
      tell(error);
    }
    if (wanted === wish) onBusy(false);
  }

  /** @param {unknown} error */
  function tell(error) {
    const { code } = /** @type {{ code?: string }} */ (error);
    if (code !== 'cancelled' && wanted) onError(/** @type {Error} */ (error));
  }
}
