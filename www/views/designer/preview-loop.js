// @ts-check
/**
 * Keeps a preview true to the style: one picture is drawn and one waits, and the next begins with what is wanted by
 * then, so that the worker never idles during a drag and no work piles up. When the hand rests the cards get their pictures, and the preview the
 * full size of its place.
 */

/** @typedef {import('../../engine/documents.js').Style} Style */
/** @typedef {import('../../engine/design.js').Designed} Designed */
/** @typedef {{ id: string, style: Style, width: number, height: number, full: number }} Wish `full`: the width of the preview on the screen */

/** The hand rests when nothing changed for so long, in ms. */
const REST = 140;
/** Pictures on their way at once. */
const AHEAD = 2;
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
  /** What was sent last. @type {Wish | null} */
  let sent = null;
  let flying = 0;
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
      next();
    },
    dispose() {
      wanted = null;
      stop.abort();
      clearTimeout(timer);
    },
  };

  function next() {
    if (wanted && sent !== wanted && flying < AHEAD) void draw(wanted);
    else if (wanted && flying === 0) timer = setTimeout(refine, REST);
  }

  /** @param {Wish} wish */
  async function draw(wish) {
    const { id, style, width, height } = wish;
    sent = wish;
    flying += 1;
    try {
      const designed = await engine.drawDesign(id, style, { width, height });
      if (wanted) onPicture(designed);
    } catch (error) {
      tell(error);
    }
    flying -= 1;
    next();
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
