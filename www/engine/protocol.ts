/**
 * Every message between the page and its workers, defined once.
 *
 * To a worker: optionally `{ start }`, then `{ id, op, args }`. Back: `{ id, ok, memory }` or `{ id, error: { code,
 * message }, memory }`, and before that `{ id, slow }` if the job takes long. A worker that is ready sends `{ id: 0 }`. Pixels are transferred as buffers and bitmaps. Photos are blob handles, which are cheap to
 * send.
 */

import type { Designed } from './design.ts';
import type {
  Bounds,
  Detection,
  FirstLook,
  ImportEntry,
  PageDocument,
  PdfOptions,
  PhotoMeta,
  SoundEvent,
  Style,
} from './types.ts';
import type { Frame } from './video.ts';

/**
 * Data of a photo for drawing. `key` is `ID/work` or `ID/small`. `planes` holds the red, green and blue planes in
 * sequence, `width * height` bytes each. `mask` is the subject mask as text, if known. A `draft` is a smaller copy until
 * the photo is imported.
 */
export type PhotoHandle = { key: string; width: number; height: number; planes: Blob; mask?: string; draft?: true };

/** A rendered rectangle of a page, in page pixels. */
export type BitmapPatch = Bounds & { bitmap: ImageBitmap };
export type PixelPatch = Bounds & { data: Uint8ClampedArray<ArrayBuffer> };

/** Operations of the workers of a pool: arguments and results. */
export type Table = { [op: string]: { args: unknown; ok: unknown } };

/** Source of a wasm instance: a compiled module that all threads share, or bytes that each thread compiles. */
export type Program = WebAssembly.Module | ArrayBuffer;

/** Initial message to a worker, `{ start }`. */
export type Start = { program: Program; budget: number };

/** Its operations. */
export type Operations = {
  import: { args: { id: string; file: Blob }; ok: Imported };
  /** a smaller copy of a large JPEG file; null for other files */
  draft: { args: { id: string; file: Blob }; ok: Imported | null };
  importFrame: { args: { id: string; frame: Omit<Frame, 'index' | 'time'> }; ok: Imported & { file: Blob } };
  /** a frame upright and small */
  smallFrame: { args: { frame: Omit<Frame, 'index' | 'time'>; longest: number }; ok: PixelPatch };
  /** the frames of an animated panel, from small frames; `still` is the index of its photo. Empty for a still panel */
  living: {
    args: { document: string; index: number; width: number; frames: PixelPatch[]; still: number };
    ok: BitmapPatch[];
  };
  /** Images of one panel in order of their indices: the panel, its breakout, its foreground. */
  panel: { args: PanelJob; ok: BitmapPatch[] };
  /** Like `panel`, as pixels. */
  front: { args: PanelJob; ok: PixelPatch[] };
  page: { args: { document: string; width: number; tier: Tier; photos: PhotoHandle[] }; ok: BitmapPatch };
  compose: { args: { document: string; width: number; tier: Tier; photos: PhotoHandle[] }; ok: PixelPatch };
  stylePhoto: {
    args: { photo: PhotoHandle; style: string; width: number; height: number; crop: string };
    ok: BitmapPatch;
  };
  stylePixels: { args: { photo: PhotoHandle; style: string; width: number; height: number }; ok: PixelPatch };
  design: { args: { photo: PhotoHandle; style: string; width: number; height: number; stages: number }; ok: Designed };
  explore: { args: { photo: PhotoHandle; styles: string[]; width: number; height: number }; ok: Explored[] };
  plates: { args: { document: string }; ok: Plates | null };
  readLook: { args: { photo: PhotoHandle; anyway: boolean }; ok: string };
  /** `asks` are trials of a search. Failures are null. */
  tryLooks: { args: { photo: PhotoHandle; asks: Trial[] }; ok: (string | null)[] };
  stylize: { args: { style: string; width: number; height: number; data: Uint8Array }; ok: PixelPatch };
  fullPanels: {
    /** Images by panel. Without a file, images of panels without a photo. In a PDF file panels have no border. */
    args: {
      id: string;
      file: Blob | null;
      mask?: string;
      document: string;
      panels: number[][];
      width: number;
      bordered: boolean;
    };
    ok: (PixelPatch & { index: number })[];
  };
  cutOut: { args: { id: string; file: Blob; mask: string }; ok: Blob };
  encode: { args: { document: string; width: number; patches: (PixelPatch & { index: number })[] }; ok: Blob };
  warm: { args: { document: string }; ok: null };
};

type PanelJob = { document: string; pictures: number[]; width: number; tier: Tier; photos: PhotoHandle[] };

/** The sound track of a video, in seconds. */
export type SoundTrack = { begins: number; length: number };

/** Operations of the worker that analyses the sound of a video. */
export type Hearing = {
  track: { args: { file: Blob }; ok: SoundTrack | null };
  sounds: { args: { samples: Float32Array<ArrayBuffer>; rate: number }; ok: SoundEvent[] };
};

/** Operations of the worker that scores images, from 1 to 10; `net` is the address of its model. */
export type Judging = {
  judge: { args: { width: number; height: number; data: Uint8ClampedArray<ArrayBuffer>; net: string }; ok: number };
};

/**
 * Operations of the worker that finds subjects, one slice each; `look` is the number of the detection, `net` the
 * address of its model. The last slice returns the mask.
 */
export type Masking = { mask: { args: { photo: PhotoHandle; net: string; look: number }; ok: string | null } };

type Looked<Ok> = {
  args: { photo: PhotoHandle; boxes?: readonly Detection[]; objects?: readonly Detection[] };
  ok: Ok;
};

/** Operations of a worker that finds faces or objects. */
export type Looking = {
  load: { args: { net: 'faces' | 'objects' }; ok: null };
  make: { args: { net: 'faces' | 'objects' }; ok: null };
  faces: Looked<FirstLook>;
  closer: Looked<readonly Detection[]>;
  objects: Looked<readonly Detection[]>;
  /** Eyes and mouths of the faces in `boxes`. */
  lips: Looked<readonly Detection[]>;
};

/**
 * Operations of the worker that draws text; `document` is JSON. `fronts` are the subjects in front of effects, in the
 * order of `frontsOf`.
 */
export type Wording = {
  word: { args: Lettered & { index: number }; ok: BitmapPatch };
  words: { args: Lettered; ok: PixelPatch[] };
  over: { args: Lettered & { bitmap: ImageBitmap }; ok: ImageBitmap };
};
type Lettered = { document: string; width: number; fronts: PixelPatch[] };

/** A panel in a PDF file, or on a plate; `alpha` for breakouts and foregrounds. */
export type Picture = Bounds & {
  index: number;
  jpeg: Uint8Array<ArrayBuffer>;
  alpha?: Uint8Array<ArrayBuffer>;
  plate?: number;
};
/** A page of a PDF file as JSON, the alternative texts of its panels, and their images. */
export type PdfPage = { document: string; alts: readonly string[]; pictures: Picture[] };
/** The inks of a page, the strongest last, and the page for drawing plates. */
export type Plates = { inks: { name: string; rgb: Rgb }[]; document: PageDocument };
export type Rgb = [number, number, number];

/** Operations of the export worker; `quality` is from 1 to 100. */
export type Making = {
  jpeg: {
    args: { document: string; size: { width: number; height: number }; patches: PixelPatch[]; quality: number };
    ok: Blob;
  };
  webp: { args: { picture: Blob; quality: number; dpi: number }; ok: Blob };
  losslessWebp: {
    args: { document: string; size: { width: number; height: number }; patches: PixelPatch[]; dpi: number };
    ok: Blob;
  };
  /** a lossless WebP image with alpha */
  losslessPicture: { args: Omit<PixelPatch, 'x' | 'y'>; ok: Uint8Array<ArrayBuffer> };
  pictures: {
    args: { document: string; patches: (PixelPatch & { index: number })[]; quality: number; inks: readonly Rgb[] };
    ok: Picture[];
  };
  pdf: { args: { pages: PdfPage[]; options: PdfOptions }; ok: Blob };
  comic: { args: { kind: ComicKind; comic: string }; ok: string };
  /** the pages of a board, and a list of its shots */
  board: { args: { request: string }; ok: string };
  /** the pages of a vertical strip */
  strip: { args: { request: string }; ok: string };
  shots: { args: { ending: ListKind; list: string }; ok: string };
  /** the plan of an animatic, and the content of its frames; likewise for motion comics */
  animatic: { args: { request: string }; ok: { plan: string; table: Float32Array } };
  motion: { args: { request: string }; ok: { plan: string; table: Float32Array } };
};

/** A list of shots, by the ending of its file. */
export type ListKind = 'csv' | 'edl' | 'otio' | 'xml';

/** A comic that is read. */
export type ComicKind = 'html' | 'epub' | 'cbz';

/** A request of a style search: a style, the number of pixels to draw, and whether it is a close-up. */
export type Trial = { style: Style; area: number; close: boolean };

type Tier = 'small' | 'work' | 'full';

/**
 * A photo in the style with that index:
 *
 * - its simple score from 0 to 1, and the factor for any score, which is low if the image is almost the photo;
 * - its problem, if any;
 * - its look (`line`, `gray`, `flat` or `wild`), and a signature that is similar for similar images.
 */
export type Explored = {
  index: number;
  score: number;
  novelty: number;
  fault: string;
  look: string;
  signature: Uint8Array;
  clipped: Clipped;
  bitmap: ImageBitmap;
};

/**
 * The parts of the pixels of an image that are pure white and pure black, and that have nearly its own lightest and darkest
 * tone.
 */
export type Clipped = { white: number; black: number; lightest: number; darkest: number };

export const NOT_CLIPPED: Clipped = { white: 0, black: 0, lightest: 0, darkest: 0 };

/** Result of `import`: the measurements of a photo, and its two reduced copies. */
export type Imported = {
  meta: PhotoMeta & Pick<ImportEntry, 'format' | 'damage' | 'measures'>;
  work: PhotoHandle;
  small: PhotoHandle;
};

type Failure = { code: string; message: string };
export type Reply = { id: number; ok?: unknown; error?: Failure; memory: number };
/** The job downloads a file or paints. */
export type Sign = { id: number; slow: true };

/** Buffers to transfer with pixels. */
export function buffersOf(patches: readonly Pick<PixelPatch, 'data'>[]): ArrayBuffer[] {
  return patches.map(({ data }) => data.buffer);
}

/** A worker answers with this code when its wasm instance can no longer be trusted. */
export const TRAP = 'trap';

/**
 * An error with a stable code, as every failing call of the engine rejects with.
 * @param about the name of the photo with the error, if any
 */
export function failure(
  code: string,
  message: string,
  about: { photo?: string } = {},
): Error & { code: string; photo?: string } {
  return Object.assign(new Error(message), { code, ...about });
}

/** Error for a damaged project file, page file or archive. */
export function damaged(what: string) {
  return failure('damaged-project', what);
}

/**
 * Error of a cancelled or overtaken call. Named as a fetch names it; a `DOMException` would not do, as its `code` is a
 * number that cannot be set.
 */
export function cancelled() {
  const error = failure('cancelled', 'The work was cancelled.');
  error.name = 'AbortError';
  return error;
}

/** @returns the two fields that cross to the page */
export function describe(error: unknown): Failure {
  if (error instanceof WebAssembly.RuntimeError) return { code: TRAP, message: error.message };
  if (error instanceof RangeError && /memory|allocation/i.test(error.message))
    return { code: TRAP, message: error.message };
  const { code, message } = (error ?? {}) as { code?: unknown; message?: unknown };
  return {
    code: typeof code === 'string' ? code : 'internal',
    message: typeof message === 'string' ? message : String(error),
  };
}

/** @param photo the name of the photo that the worker was busy with */
export function lost(photo: string | undefined) {
  const what = photo
    ? `The worker stopped while it was busy with ${photo}.`
    : 'A worker stopped in the middle of its work.';
  return failure('worker-lost', what, { photo });
}
