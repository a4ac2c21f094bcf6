/**
 * The album as an animatic: the shots of the board one after the other. The core plans it; here its pictures are drawn by the
 * engine, and a worker of its own makes a file of them.
 */

import { ANIMATIC_SIZES } from '../engine/bounds.ts';
import { patience } from '../engine/patience.ts';
import { cancelled, failure } from '../engine/protocol.ts';
import { soundOf } from './sound.ts';
import { GIF, KINDS, gifSize } from './kinds.ts';
import type { Boards } from '../boards/boards.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Animatic, AnimaticRequest, PageDocument, Subject } from '../engine/types.ts';
import type { Work } from '../export/page-making.ts';
import type { FromEncoder, ToEncoder } from './encode-worker.ts';
import type { Drawn } from './frames.ts';
import type { Kind } from './kinds.ts';

export type SizeId = (typeof ANIMATIC_SIZES)[number]['id'];
/** `seconds` of a shot that does not say how long it is; `dissolve` in seconds, 0 cuts. */
export type AnimaticWish = {
  kind: Kind;
  size: SizeId;
  seconds: number;
  dissolve: number;
  moves: boolean;
  captions: boolean;
  sound: File | null;
};
/** `table`: what each frame shows (`frames.ts`). */
export type Planned = { plan: Animatic; table: Float32Array };
export type Animatics = ReturnType<typeof createAnimatics>;

export const USUAL: AnimaticWish = {
  kind: 'mp4',
  size: '1080p',
  seconds: 2,
  dissolve: 0,
  moves: true,
  captions: true,
  sound: null,
};

/** Milliseconds between two signs of life of the encoder; one frame of a slow device is a fraction of it. */
const SILENCE = 60_000;

export function createAnimatics({
  store,
  engine,
  boards,
}: {
  store: Store;
  engine: Pick<Engine, 'animatic' | 'renderPanel' | 'renderWord' | 'exportPng'>;
  boards: Pick<Boards, 'rows' | 'shotList'>;
}) {
  return { sizeOf, planned, preview, film };

  /** In pixels, of frames of a kind of file. */
  function sizeOf({ kind, size }: Pick<AnimaticWish, 'kind' | 'size'>) {
    const found = ANIMATIC_SIZES.find(({ id }) => id === size) ?? ANIMATIC_SIZES[0];
    return kind === 'gif' ? gifSize(found) : { width: found.width, height: found.height };
  }

  async function planned(wish: AnimaticWish, call?: { signal?: AbortSignal }): Promise<Planned> {
    return engine.animatic(request(wish), call);
  }

  function request(wish: AnimaticWish): AnimaticRequest {
    const { width, height } = sizeOf(wish);
    const album = store.album.peek();
    const ids = boards.rows.peek().map(({ id }) => id);
    const framed = store.planner.peek()?.frames(store.photos.peek(), ids, width / height) ?? [];
    const subjectsOf = (id: string): readonly Subject[] => album.get(id)?.meta?.subjects ?? [];
    return {
      list: boards.shotList(),
      pictures: framed.map((picture) => ({ ...picture, subjects: subjectsOf(picture.photo) })),
      size: [width, height],
      fps: wish.kind === 'gif' ? GIF.fps : 0,
      seconds: wish.seconds,
      dissolve: wish.dissolve,
      moves: wish.moves,
      captions: wish.captions,
      style: store.page.peek()?.style ?? 'storyboard',
    };
  }

  /** A clip as the preview shows it, from what is in memory of its photo. @param width of the frames of the preview, in pixels */
  async function preview(
    { plan }: Planned,
    clip: number,
    width: number,
    call?: { signal?: AbortSignal },
  ): Promise<Drawn> {
    const { picture, caption } = plan.clips[clip];
    const wide = Math.round((picture.page.width * width) / plan.size[0]);
    const [{ bitmap }, text] = await Promise.all([
      engine.renderPanel(picture, 0, wide, { tier: 'work', ...call }),
      captionOf(caption, width, call),
    ]);
    return { picture: bitmap, caption: text };
  }

  async function captionOf(caption: PageDocument | null | undefined, width: number, call?: { signal?: AbortSignal }) {
    return caption ? (await engine.renderWord(caption, 0, width, call)).bitmap : null;
  }

  /**
   * The file. Pictures are drawn from the photos at full size, each when its first frame is due, and forgotten behind it.
   * @throws as `failure`: `animatic-empty`, `animatic-encoder`, `animatic-long`, `sound-unread`, and those of photos
   */
  async function film(wish: AnimaticWish, { signal, onProgress }: Work): Promise<Blob> {
    const { plan, table } = await planned(wish, { signal });
    if (wish.kind === 'gif' && plan.frames > GIF.fps * GIF.mostSeconds)
      throw failure('animatic-long', 'A GIF file is for up to a minute.');
    const sound = wish.sound && wish.kind !== 'gif' ? await soundOf(wish.sound, plan.frames / plan.fps) : null;
    if (signal.aborted) throw cancelled();
    const stop = new AbortController();
    const drawing = AbortSignal.any([signal, stop.signal]);
    const worker = new Worker(new URL('./encode-worker.ts', import.meta.url), {
      type: 'module',
      name: 'inkpanel-animatic',
    });
    let relax = () => {};
    try {
      return await new Promise<Blob>((resolve, reject) => {
        const lost = () => reject(failure('animatic-encoder', 'What makes the film stopped.'));
        const listen = () => {
          relax();
          relax = patience(SILENCE, lost);
        };
        signal.addEventListener('abort', () => reject(cancelled()), { once: true });
        worker.onerror = (event) => {
          event.preventDefault();
          lost();
        };
        worker.onmessage = ({ data }: MessageEvent<FromEncoder>) => {
          listen();
          if ('wants' in data) {
            // Drawing a picture from its photo takes as long as it takes.
            relax();
            draw(plan, data.wants, drawing).then(({ picture, caption }) => {
              listen();
              const message: ToEncoder = { clip: data.wants, picture, caption };
              worker.postMessage(message, caption ? [picture, caption] : [picture]);
            }, reject);
          } else if ('done' in data) onProgress(data.done, plan.frames);
          else if ('file' in data) resolve(new Blob([data.file], { type: KINDS[wish.kind].type }));
          else reject(failure(data.error.code, data.error.message));
        };
        listen();
        const { width, height } = sizeOf(wish);
        const begin: ToEncoder = { kind: wish.kind, width, height, fps: plan.fps, table, sound };
        worker.postMessage(begin, sound ? sound.channels.map(({ buffer }) => buffer) : []);
      });
    } finally {
      relax();
      stop.abort();
      worker.terminate();
    }
  }

  async function draw(plan: Animatic, clip: number, signal: AbortSignal) {
    const { picture, caption } = plan.clips[clip];
    const [png, text] = await Promise.all([
      engine.exportPng(picture, { signal }),
      captionOf(caption, plan.size[0], { signal }),
    ]);
    return { picture: await createImageBitmap(png), caption: text };
  }
}
