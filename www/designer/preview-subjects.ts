/** Subjects of the designer's preview: a photo of the album, or the page. */

import { strings } from '../strings/strings.ts';
import type { Call, Engine } from '../engine/engine.ts';
import type { Designed } from '../engine/design.ts';
import type { PageDocument, Style } from '../engine/types.ts';
import type { Shown } from '../photos/photo-picker.tsx';

type Size = { width: number; height: number };
type Picture = { bitmap: ImageBitmap };
export type Subject = {
  /** A change requests a new picture. */
  of: unknown;
  name: string;
  /** Size of the live preview. */
  size: Size;
  /** The most pixels in width that are worth drawing. */
  most: number;
  /** During an edit. */
  draw: (style: Style, size: Size, call?: Call) => Promise<Picture>;
  /** The pictures of the cards. `whole`: together with the picture of the preview. */
  drawCards: (
    style: Style,
    size: Size & { stages: number },
    call?: Call,
  ) => Promise<{ designed: Designed; whole: boolean }>;
  /** After an edit. */
  drawWhole: (style: Style, size: Size, call?: Call) => Promise<Picture>;
};

/** Minimum size of a live preview in pixels, on its long and its short side. */
const LIVE = { long: 960, short: 540 };
/** The long side of the copy of a photo that is drawn from. */
const WORK = 1600;
/** Width of a page during an edit, because a page has many photos to draw. */
const LIVE_PAGE = 360;

type Drawing = Pick<Engine, 'drawDesign' | 'stylePhoto' | 'renderPage' | 'composePixels'>;

/** @param small one of several previews */
export function photoSubject(engine: Drawing, { id, name, meta }: Shown, small: boolean): Subject {
  return {
    // Also when its subject was found.
    of: `${id} ${meta.mask ?? ''}`,
    name: strings.previewOf({ name }),
    size: liveSize(meta, small),
    most: Math.round((WORK / Math.max(WORK, meta.width, meta.height)) * meta.width),
    draw: (style, size, call) => engine.drawDesign(id, style, size, call),
    drawCards: async (style, size, call) => ({ designed: await engine.drawDesign(id, style, size, call), whole: true }),
    drawWhole: (style, size, call) => engine.stylePhoto(id, style, { ...size, tier: 'work' }, call),
  };
}

/**
 * @param of identifies the page, without its style
 * @param cards the photo that the cards show
 */
export function pageSubject(engine: Drawing, of: string, page: PageDocument, cards: Shown): Subject {
  const { width, height } = page.page;
  const inStyle = (style: Style): PageDocument => ({ ...page, style });
  return {
    of,
    name: strings.previewOfPage,
    size: { width: LIVE_PAGE, height: Math.max(1, Math.round((LIVE_PAGE * height) / width)) },
    most: WORK,
    draw: (style, size, call) => engine.renderPage(inStyle(style), size.width, call),
    drawCards: async (style, { stages }, call) => ({
      designed: await engine.drawDesign(cards.id, style, { ...liveSize(cards.meta, true), stages }, call),
      whole: false,
    }),
    // From the larger copies of the photos, as the board has it.
    drawWhole: async (style, size, call) => {
      const { width: w, height: h, data } = await engine.composePixels(inStyle(style), size.width, call);
      return { bitmap: await createImageBitmap(new ImageData(data, w, h)) };
    },
  };
}

/**
 * Covers 960 x 540 in either orientation, or half of it for one of several previews, even if the photo is smaller.
 * Lines are then as fine as on a large photo.
 */
function liveSize({ width, height }: Size, small: boolean): Size {
  const [long, short] = [Math.max(width, height), Math.min(width, height)];
  const wanted = Math.max(LIVE.long / long, LIVE.short / short) / (small ? 2 : 1);
  const scale = Math.min(wanted, WORK / long);
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}
