/**
 * Videos of the album: an animatic with the shots of the storyboard in order, or a motion comic with animated pages.
 * The core plans it, the engine draws its images, and a separate worker encodes the file.
 */

import { ANIMATIC_SIZES } from '../engine/bounds.ts';
import { LIVING } from '../engine/living.ts';
import { stream } from '../engine/streaming.ts';
import { cancelled, failure } from '../engine/protocol.ts';
import { drawsParts } from '../page/subjects-of.ts';
import { bitmapsOf } from './frames.ts';
import { drawnWord } from './drawn-word.ts';
import { createLoops } from './loops.ts';
import { createMovingPictures } from './moving-pictures.ts';
import { soundOf } from './sound.ts';
import { GIF, KINDS, gifSize } from './kinds.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type {
  Animatic,
  AnimaticClip,
  AnimaticRequest,
  MotionRequest,
  PageDocument,
  ShotList,
  Subject,
} from '../engine/types.ts';
import type { ReadonlySignal } from '@preact/signals';
import type { FromEncoder, ToEncoder } from './encode-worker.ts';
import type { Drawn, DrawnLoop, DrawnWord } from './frames.ts';
import type { Kind } from './kinds.ts';

export type SizeId = (typeof ANIMATIC_SIZES)[number]['id'];
/**
 * `seconds`: default duration of a shot, or of a panel without text; `dissolve`: in seconds, 0 for hard cuts. `skips`
 * leaves out shots that look like the shot before, and `living` animates panels from videos.
 */
export type AnimaticWish = {
  of: 'shots' | 'pages';
  kind: Kind;
  size: SizeId;
  seconds: number;
  dissolve: number;
  moves: boolean;
  captions: boolean;
  skips: boolean;
  living: boolean;
  sound: File | null;
};
/** `table`: content of each frame (`frames.ts`). */
export type Planned = { plan: Animatic; table: Float32Array };
export type Animatics = ReturnType<typeof createAnimatics>;
type Call = { signal?: AbortSignal };

export const USUAL: AnimaticWish = {
  of: 'shots',
  kind: 'mp4',
  size: '1080p',
  seconds: 2,
  dissolve: 0,
  moves: true,
  captions: true,
  skips: true,
  living: true,
  sound: null,
};

/** Frames per second of pages; shots use the rate of the storyboard. */
const PAGES_FPS = 24;
/** Pixels of all pictures of all panels of a clip that move, in the preview and in a file. */
const PREVIEW_PIXELS = 16e6;
const FILM_PIXELS = 48e6;

export function createAnimatics({
  store,
  engine,
  boards,
}: {
  store: Store;
  engine: Pick<
    Engine,
    | 'animatic'
    | 'motion'
    | 'renderPanel'
    | 'renderPictures'
    | 'renderWord'
    | 'composePixels'
    | 'exportPng'
    | 'drawLiving'
    | 'givesWebp'
    | 'losslessPicture'
  >;
  boards: {
    rows: ReadonlySignal<readonly { id: string }[]>;
    similar: ReadonlySignal<ReadonlySet<string>>;
    shotList: () => ShotList;
  };
}) {
  const loops = createLoops({ store, engine });

  /** The panels of a page that move, as pictures over it. */
  const movingPictures = createMovingPictures({ engine, loops });

  return { sizeOf, planned, preview, previewLoops, film, living, movingPictures };

  /** In pixels, of frames of a kind of file. */
  function sizeOf({ kind, size }: Pick<AnimaticWish, 'kind' | 'size'>) {
    const found = ANIMATIC_SIZES.find(({ id }) => id === size) ?? ANIMATIC_SIZES[0];
    return kind === 'gif' ? gifSize(found) : { width: found.width, height: found.height };
  }

  async function planned(wish: AnimaticWish, call?: Call): Promise<Planned> {
    return wish.of === 'pages' ? engine.motion(pagesOf(wish), call) : engine.animatic(shotsOf(wish), call);
  }

  /**
   * Which panels of pages or shots can be animated: photos that are frames of an available video.
   * @returns `apart`: it would move, but its style draws subjects separately, and the subject masks of a video are
   * known for one frame only
   */
  function living(of: AnimaticWish['of']): 'none' | 'apart' | 'some' {
    const page = store.page.value;
    const parts =
      of === 'pages'
        ? store.sheets.value.map((sheet) => ({ sheet, photos: sheet.panels.map(({ photo }) => photo) }))
        : page
          ? [{ sheet: page, photos: boards.rows.value.map(({ id }) => id) }]
          : [];
    const moving = parts.filter(({ photos }) => photos.some(loops.known));
    if (moving.length === 0) return 'none';
    return moving.some(({ sheet }) => !drawsParts(store, sheet)) ? 'some' : 'apart';
  }

  function pagesOf(wish: AnimaticWish): MotionRequest {
    const { width, height } = sizeOf(wish);
    const { seconds, dissolve, moves } = wish;
    return {
      pages: [...store.sheets.peek()],
      size: [width, height],
      fps: wish.kind === 'gif' ? GIF.fps : PAGES_FPS,
      seconds,
      dissolve,
      moves,
      living: livingRate(wish),
    };
  }

  function livingRate(wish: AnimaticWish) {
    return wish.living && living(wish.of) === 'some' ? LIVING.rate : 0;
  }

  function shotsOf(wish: AnimaticWish): AnimaticRequest {
    const { width, height } = sizeOf(wish);
    const album = store.album.peek();
    const rows = boards.rows.peek();
    const skipped = wish.skips ? boards.similar.peek() : new Set();
    const list = boards.shotList();
    const shots = list.shots.filter((_, i) => !skipped.has(rows[i].id));
    const ids = rows.flatMap(({ id }) => (skipped.has(id) ? [] : [id]));
    const framed = store.planner.peek()?.frames(store.photos.peek(), ids, width / height) ?? [];
    const subjectsOf = (id: string): readonly Subject[] => album.get(id)?.meta?.subjects ?? [];
    return {
      list: { ...list, shots },
      pictures: framed.map((picture) => ({ ...picture, subjects: subjectsOf(picture.photo) })),
      size: [width, height],
      fps: wish.kind === 'gif' ? GIF.fps : 0,
      seconds: wish.seconds,
      dissolve: wish.dissolve,
      moves: wish.moves,
      captions: wish.captions,
      living: livingRate(wish),
      style: store.page.peek()?.style ?? 'storyboard',
    };
  }

  /** A clip of the preview, from photos in memory. @param width of the frames of the preview, in pixels */
  async function preview({ plan }: Planned, clip: number, width: number, call?: Call): Promise<Drawn> {
    const { picture, caption, reading } = plan.clips[clip];
    const wide = pictureWidth(plan, clip, width);
    if (reading) {
      const [page, words] = await Promise.all([
        engine.composePixels(picture, wide, call),
        wordsOf(plan.clips[clip], wide, call),
      ]);
      const bitmap = await createImageBitmap(new ImageData(page.data, page.width, page.height));
      return { picture: bitmap, caption: null, page: { words, panels: reading.panels } };
    }
    const [{ bitmap }, text] = await Promise.all([
      engine.renderPanel(picture, 0, wide, { tier: 'work', ...call }),
      captionOf(caption, width, call),
    ]);
    return { picture: bitmap, caption: text };
  }

  /** Renders the animated panels of a clip, which takes seconds. `onDrawn` is called after each panel. */
  async function previewLoops(
    { plan }: Planned,
    clip: number,
    call: Call & { onDrawn: (loops: DrawnLoop[]) => void },
  ): Promise<void> {
    if (plan.living > 0) await loops.of(plan.clips[clip].picture, PREVIEW_PIXELS, call);
  }

  function pictureWidth(plan: Animatic, clip: number, width: number) {
    return Math.max(1, Math.round((plan.clips[clip].picture.page.width * width) / plan.size[0]));
  }

  /** The text items of a page in order of appearance. @param width of the page, in pixels */
  async function wordsOf({ reading }: AnimaticClip, width: number, call?: Call): Promise<DrawnWord[]> {
    const words = reading?.words;
    if (!reading || !words) return [];
    const drawn: DrawnWord[] = [];
    for (const { word, panel } of reading.said)
      drawn.push({ ...(await drawnWord(engine, words, word, width, call)), panel });
    return drawn;
  }

  async function captionOf(caption: PageDocument | null | undefined, width: number, call?: Call) {
    return caption ? (await engine.renderWord(caption, 0, width, call)).bitmap : null;
  }

  /**
   * The file. Pictures are drawn from the photos at full size, each before its first frame, and released after the last
   * one.
   * @throws as `failure`: `animatic-empty`, `animatic-encoder`, `animatic-long`, `sound-unread`, and errors of photos
   */
  async function film(
    wish: AnimaticWish,
    { signal, onProgress }: { signal: AbortSignal; onProgress: (done: number, total: number) => void },
  ): Promise<Blob> {
    // The plan, the sound and the first picture take seconds, and the user can cancel them.
    onProgress(0, 1);
    const { plan, table } = await planned(wish, { signal });
    if (wish.kind === 'gif' && plan.frames > GIF.fps * GIF.mostSeconds)
      throw failure('animatic-long', 'A GIF file is for up to a minute.');
    const sound = wish.sound && wish.kind !== 'gif' ? await soundOf(wish.sound, plan.frames / plan.rate) : null;
    if (signal.aborted) throw cancelled();
    const stop = new AbortController();
    const drawing = AbortSignal.any([signal, stop.signal]);
    const worker = new Worker(new URL('./encode-worker.ts', import.meta.url), {
      type: 'module',
      name: 'inkpanel-animatic',
    });
    const { width, height } = sizeOf(wish);
    const message: ToEncoder = { kind: wish.kind, width, height, rate: plan.rate, table, sound };
    const transfer = sound ? sound.channels.map(({ buffer }) => buffer) : [];
    const encoded = stream<FromEncoder, Blob>(
      worker,
      { message, transfer },
      {
        signal,
        lost: () => failure('animatic-encoder', 'What makes the film stopped.'),
        onMessage(news, { resolve, reject }) {
          if ('wants' in news) return picture(news.wants);
          if ('done' in news) onProgress(news.done, plan.frames);
          else if ('file' in news) resolve(new Blob([news.file], { type: KINDS[wish.kind].type }));
          else reject(failure(news.error.code, news.error.message));
          return undefined;
        },
      },
    );
    return encoded.finally(() => stop.abort());

    async function picture(clip: number) {
      const drawn = await draw(plan, clip, drawing);
      return { message: { ...drawn, clip } satisfies ToEncoder, transfer: bitmapsOf(drawn) };
    }
  }

  async function draw(plan: Animatic, clip: number, signal: AbortSignal): Promise<Drawn> {
    const { picture, caption, reading } = plan.clips[clip];
    const [png, text, words, moving] = await Promise.all([
      engine.exportPng(picture, { signal }),
      captionOf(caption, plan.size[0], { signal }),
      wordsOf(plan.clips[clip], picture.page.width, { signal }),
      plan.living > 0 ? loops.of(picture, FILM_PIXELS, { signal }) : [],
    ]);
    const drawn = { picture: await createImageBitmap(png), caption: text, loops: moving };
    return reading ? { ...drawn, page: { words, panels: reading.panels } } : drawn;
  }
}
