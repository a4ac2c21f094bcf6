/**
 * The engine: all functions that make pixels, as promises. It is independent of the app, so benchmarks and other sites
 * can use it.
 */

import { createAesthetics } from './aesthetics.ts';
import { DUPLICATE_THRESHOLD } from './bounds.ts';
import { takeInHand } from './brush-module.ts';
import { loadCore } from './core-loading.ts';
import { createDesign } from './design.ts';
import { createDetector } from './detector.ts';
import { createExports } from './export.ts';
import { createFiles } from './files.ts';
import { createImitating } from './imitate.ts';
import { createLips } from './lips.ts';
import { createLiving } from './living.ts';
import { createMasking } from './masking.ts';
import { createMeasures } from './measures.ts';
import { ownModelsIn, withOwnModels } from './painters.ts';
import { createPhotos } from './photos.ts';
import { createPool } from './pool.ts';
import { Priority } from './queue.ts';
import { createRenders, nameOf } from './renders.ts';
import { createScheduler } from './scheduler.ts';
import { SHARES_CODE } from './shared-code.ts';
import { hearFilm } from './sounds.ts';
import { readVideo } from './video.ts';
import { givesWebp } from './webp.ts';
import { createWarming } from './warming.ts';
import { createWords } from './words.ts';
import type { Block, Detection, Layout, PageDocument, Style } from './types.ts';
import type { FindOwn } from './painters.ts';
import type { Job, Pool } from './pool.ts';
import type { Imported, Operations, PixelPatch, Program, Start } from './protocol.ts';
import type { Scheduler } from './scheduler.ts';
import type { About, Frame } from './video.ts';

export type Call = { signal?: AbortSignal; priority?: number; key?: string; promoted?: Promise<unknown> };
export type Engine = ReturnType<typeof createEngine>;

const MB = 2 ** 20;
/** Files of this type and of at least this many bytes are read as drafts first. Smaller files are read quickly. */
const JPEG = 'image/jpeg';
const LARGE_JPEG = 500_000;
/**
 * Limits: number of workers; bytes of cached photos, in total and at least per worker; memory of an idle worker; number of
 * workers that detect. `nets`: milliseconds until the face detector is unloaded. A phone closes a tab that uses too much
 * memory. Each worker keeps the memory of its largest photo, and code that is compiled per worker needs much memory as well.
 */
const USUAL = {
  workers: 8,
  photos: 256 * MB,
  least: 64 * MB,
  rest: undefined,
  detectors: 2,
  nets: SHARES_CODE ? Infinity : 30_000,
};
/** With these, the tab has at most 400 MB while thirty photos of 12 megapixels are read. */
const SPARING = { workers: 2, photos: 64 * MB, least: 16 * MB, rest: 64 * MB, detectors: 1, nets: 5_000 };

/**
 * Suitable number of workers: one per core. If each worker compiles the code, half as many, because the compiler has
 * separate threads, and WebKit reports four cores instead of two. There the first page of twelve photos took 8 to 24 s
 * with four workers, 3 to 8 s with two.
 */
function suitable(): number {
  const cores = globalThis.navigator?.hardwareConcurrency || 2;
  return SHARES_CODE ? cores : Math.ceil(cores / 2);
}

/**
 * @param options `workers`: number of workers, at most 8 (default: depends on the device); `sparing`: for devices with
 *   little memory; `scheduler`: the scheduler of the app
 */
export function createEngine({
  workers = suitable(),
  sparing = false,
  scheduler = createScheduler(),
}: {
  workers?: number;
  sparing?: boolean;
  scheduler?: Scheduler;
} = {}) {
  const most = sparing ? SPARING : USUAL;
  const size = Math.max(1, Math.min(most.workers, Math.floor(workers)));
  const photos = createPhotos();
  const detector = createDetector(photos, {
    scheduler,
    workers: most.detectors,
    spare: (count) => pool?.spare(count),
    linger: most.nets,
  });
  const design = createDesign(photos, () => ownPainters);
  const words = createWords();
  const files = createFiles();
  let pool: Pool | undefined;
  let ownPainters: FindOwn | undefined;
  let imported = 0;

  const ready = loadCore().then(({ program, planner }) => {
    const budget = Math.max(most.least, most.photos / size);
    pool = createPool({ size, spawn: () => spawn(program, budget), restWater: most.rest });
    design.prepare(() => spawn(program, most.least));
    return planner;
  });
  // Callers that await it receive the error.
  ready.catch(() => {});

  const warming = createWarming(ask, SHARES_CODE ? 1 : size);
  const renders = createRenders({ run, photos, words });
  const aesthetics = createAesthetics({ run, photos, scheduler });
  const masking = createMasking(photos, scheduler);
  const unfollow = scheduler.follow((on) => pool?.hold(on));

  return {
    /** Resolves to the planner, whose functions are synchronous. */
    ready,
    blocks: async (): Promise<Block[]> => (await ready).blocks(),
    layouts: async (): Promise<Layout[]> => (await ready).layouts(),
    styles: async (): Promise<Style[]> => (await ready).styles(),
    stylize,
    compose,
    select,
    detect,
    dispose,
    importPhoto,
    importDraft,
    isDraft: photos.isDraft,
    importVideo,
    /** Sounds of a video that can become sound effects. */
    hearFilm,
    /** Sets the function that finds models of the user for the block Painter. */
    ownPaintersFrom: (find: FindOwn) => {
      ownPainters = find;
    },
    prepareDetectors: detector.prepare,
    facesReady: detector.facesReady,
    /** Subjects of an imported photo, in fractions of it. */
    findFaces: detector.findFaces,
    findMoreFaces: detector.findMoreFaces,
    findObjects: detector.findObjects,
    /** Whether subject detection is available, and the detection for one photo. */
    masks: masking.masks,
    findMask: masking.findMask,
    /** Sets the subject mask of a photo, for styles with a part. */
    knowMask: photos.know,
    /** Opens the mask editor for an imported photo. @param masks as text: corrected before, and detected */
    takeInHand: (id: string, masks: { own?: string; found?: string }) => takeInHand(photos.get(id).work, masks),
    forgetPhoto: photos.forget,
    warm: warming.warm,
    hasPhoto: photos.has,
    photos,
    lettering: words.lettering,
    ...renders,
    ...createLiving({ run }),
    ...createLips({ run, readLips: detector.readLips }),
    ...createImitating({ run, photos }),
    judges: aesthetics.judges,
    judgeStyle: aesthetics.judgeStyle,
    drawDesign: design.draw,
    ...createExports({ run, photos, words, files }),
    ...createMeasures({ run, renders, files }),
    givesWebp,
    losslessPicture: files.losslessPicture,
    comicPieces: files.comicPieces,
    comicFiles: files.comicFiles,
    boardSheets: files.boardSheets,
    stripPages: files.stripPages,
    shotFile: files.shotFile,
    animatic: files.animatic,
    motion: files.motion,
  };

  function run<Op extends keyof Operations>(job: Job<Operations, Op>): Promise<Operations[Op]['ok']> {
    warming.stop();
    return ask(job);
  }

  async function ask<Op extends keyof Operations>(job: Job<Operations, Op>): Promise<Operations[Op]['ok']> {
    // With a pool, a job is passed on at once, before later tasks such as drawing the whole window.
    if (!pool) await ready;
    const needs = ownPainters !== undefined && ownModelsIn(job.args).length > 0;
    const whole = needs ? { ...job, args: await withOwnModels(job.args, ownPainters) } : job;
    return (pool as NonNullable<typeof pool>).run(whole);
  }

  /** @param image RGBA */
  function stylize(
    {
      width,
      height,
      data,
      style,
    }: { width: number; height: number; data: Uint8Array | Uint8ClampedArray; style: string | object },
    call?: Call,
  ): Promise<PixelPatch> {
    const bytes = new Uint8Array(data);
    const args = { style: JSON.stringify(style), width, height, data: bytes };
    return run({ op: 'stylize', args, transfer: [bytes.buffer], priority: Priority.PAGE, ...call });
  }

  /**
   * A whole page as pixels.
   * @param options `photos`: files by id, for photos that are not imported yet
   */
  async function compose(
    document: PageDocument,
    { width, photos: files = {}, ...call }: Call & { width: number; photos?: Record<string, Blob> },
  ): Promise<PixelPatch> {
    const missing = Object.keys(files).filter((id) => !photos.has(id));
    await Promise.all(missing.map((id) => importPhoto(id, files[id], call)));
    return renders.composePixels(document, width, call);
  }

  /**
   * Which of some photos are worth keeping, and why.
   * @param options `duplicateThreshold`: maximum fingerprint distance of near-duplicates, in bits; `threshold` is its old name
   */
  async function select(
    blobs: Blob[],
    {
      signal,
      threshold = DUPLICATE_THRESHOLD.default,
      duplicateThreshold = threshold,
    }: { signal?: AbortSignal; duplicateThreshold?: number; threshold?: number } = {},
  ) {
    const ids = blobs.map(() => `select-${(imported += 1)}`);
    try {
      const read = await Promise.all(blobs.map((blob, i) => importPhoto(ids[i], blob, { signal })));
      const measured = read.map((meta, i) => ({ id: ids[i], name: nameOf(blobs[i], ids[i]), ...meta.measures }));
      const verdicts = (await ready).choose(measured, duplicateThreshold);
      return verdicts.map(({ group, kept, why }, i) => ({
        fingerprint: read[i].fingerprint,
        sharpness: read[i].sharpness,
        group,
        kept,
        why,
      }));
    } finally {
      ids.forEach(photos.forget);
    }
  }

  /** Faces and objects, in pixels of the upright photo. */
  async function detect(blob: Blob, call?: { signal?: AbortSignal }): Promise<Detection[]> {
    const id = `detect-${(imported += 1)}`;
    try {
      const { width, height } = await importPhoto(id, blob, call);
      const found = await detector.detect(id, call);
      return found.map((box) => ({
        ...box,
        x: box.x * width,
        y: box.y * height,
        width: box.width * width,
        height: box.height * height,
        points: box.points?.map(([x, y]) => [x * width, y * height] as const),
      }));
    } finally {
      photos.forget(id);
    }
  }

  /** Decodes, reduces and measures a photo, and stores it under `id`. */
  async function importPhoto(id: string, file: Blob, call?: Call): Promise<Imported['meta']> {
    const name = nameOf(file, id);
    const job = { op: 'import' as const, args: { id, file }, photo: name, holds: [`${id}/work`, `${id}/small`] };
    const { meta, work, small } = await run({ ...job, priority: Priority.PAGE, ...call });
    photos.add(id, { name, file, work, small });
    return meta;
  }

  /**
   * Reads a smaller copy of a large JPEG file, in a third of the time of `importPhoto`, which replaces it.
   * @returns null for other files, so that their import starts before the imports of later photos; a promise of null for
   *   files that cannot be read
   */
  function importDraft(id: string, file: Blob, call?: Call): Promise<Imported['meta'] | null> | null {
    return file.type === JPEG && file.size >= LARGE_JPEG ? readDraft(id, file, call) : null;
  }

  async function readDraft(id: string, file: Blob, call?: Call): Promise<Imported['meta'] | null> {
    const job = { op: 'draft' as const, args: { id, file }, holds: [`${id}/work`, `${id}/small`] };
    // The import reports errors.
    const draft = await run({ ...job, priority: Priority.PAGE, ...call }).catch(() => null);
    if (!draft || call?.signal?.aborted) return null;
    photos.add(id, { name: nameOf(file, id), file, work: draft.work, small: draft.small });
    return draft.meta;
  }

  /**
   * Extracts frames of a video. Each becomes a photo with the id at its position.
   * @param wish one frame per id, between `start` and `end` in seconds, with the indices `leading` first, or at these
   *   `times`. With `shots`, `count` representative frames of the shots, or an automatic number; then `more` returns
   *   additional ids, or `undefined`. `time` is the position of a frame in the video, `shot` the number of its shot
   */
  async function importVideo(
    file: Blob,
    {
      ids,
      leading = [],
      more = () => undefined,
      shots = false,
      count = shots ? 0 : ids.length,
      signal,
      onAbout = () => {},
      onPhoto,
      ...wish
    }: {
      ids: string[];
      leading?: string[];
      more?: (index: number) => string | undefined;
      shots?: boolean;
      count?: number;
      times?: readonly number[];
      moments?: readonly number[];
      start?: number;
      end?: number;
      signal?: AbortSignal;
      onAbout?: (about: About) => void;
      onPhoto: (id: string, meta: Imported['meta'], time: number, shot?: number) => void;
    },
  ) {
    await ready;
    const name = nameOf(file, 'video');
    await readVideo(
      file,
      { ...wish, shots, count, leading: leading.map((id) => ids.indexOf(id)) },
      { signal, onAbout, onFrame },
    );

    async function onFrame({ index, time, shot, ...frame }: Frame) {
      const id = ids[index] ?? more(index);
      if (id === undefined) return;
      const job = {
        op: 'importFrame' as const,
        args: { id, frame },
        transfer: [frame.data.buffer],
        photo: name,
        holds: [`${id}/work`, `${id}/small`],
      };
      const {
        meta,
        work,
        small,
        file: still,
      } = await run({ ...job, priority: leading.includes(id) ? Priority.PAGE : Priority.REST, signal });
      photos.add(id, { name, file: still, work, small });
      onPhoto(id, meta, time, shot);
    }
  }

  function dispose() {
    unfollow();
    for (const part of [detector, design, aesthetics, masking, words, files]) part.dispose();
    // If the pool exists, it is disposed at once, so that later jobs are rejected.
    if (pool) pool.dispose();
    else ready.then(() => pool?.dispose()).catch(() => {});
  }
}

function spawn(program: Program, budget: number) {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'inkpanel' });
  worker.postMessage({ start: { program, budget } satisfies Start });
  return worker;
}
