/**
 * Operations of a worker, one function per operation of `protocol.ts`. Each returns the value and the buffers to
 * transfer.
 */

import { blobOf, detach } from './blobs.ts';
import { buffersOf, failure } from './protocol.ts';
import { reading } from './readable.ts';
import { createStyleOperations } from './style-operations.ts';
import { createWarmUp } from './warm-up.ts';
import { plates_of } from '../pkg/inkpanel.js';
import type { Patch, Studio } from '../pkg/inkpanel.js';
import type { createLru } from './lru.ts';
import type { BitmapPatch, Imported, Operations, PhotoHandle, PixelPatch, Plates } from './protocol.ts';
import type { Slow, Work } from './serving.ts';
import type { ImportEntry, PixelSize } from './types.ts';

/** Maximum size of a photo, so that a dropped video does not fill the memory. */
const MOST_BYTES = 512 * 2 ** 20;

/** Size of files whose reading takes long on a slow disk. */
const LARGE = 32 * 2 ** 20;

type Lru = ReturnType<typeof createLru>;

/**
 * @param held the photos in the studio
 * @param passing photos that are video frames and not shown yet: a long video has a hundred, a page shows a few
 */
export function createOperations(studio: Studio, held: Lru, passing: Lru): Work<Operations> {
  /** Keys of photos whose pixels in the studio are a draft. */
  const drafts = new Set<string>();

  return {
    import: importPhoto,
    draft: importDraft,
    importFrame,
    smallFrame,
    living,
    panel,
    front,
    page,
    compose,
    stylePhoto,
    stylePixels,
    stylize,
    fullPanels,
    cutOut,
    encode,
    plates,
    warm: createWarmUp(studio),
    ...createStyleOperations({ studio, fetchPhotos, bitmap }),
  };

  async function importPhoto({ id, file }: Operations['import']['args'], slow: Slow) {
    if (file.size > LARGE) slow();
    const bytes = await bytesOf(file);
    const { entry, told } = await read(id, bytes);
    detach(bytes);
    for (const key of keysOf(id)) drafts.delete(key);
    const { meta, ...photo } = await kept(entry, held);
    evict([]);
    return { ok: { ...photo, meta: { ...meta, ...told } }, transfer: [] };
  }

  async function importDraft({ id, file }: Operations['draft']['args']) {
    const bytes = await bytesOf(file);
    const entry = studio.import_draft(id, bytes);
    detach(bytes);
    if (entry === undefined) return { ok: null, transfer: [] };
    for (const key of keysOf(id)) drafts.add(key);
    const { meta, work, small } = await kept(JSON.parse(entry), held);
    evict([]);
    return {
      ok: { meta, work: { ...work, draft: true as const }, small: { ...small, draft: true as const } },
      transfer: [],
    };
  }

  /** @param bytes of the file */
  async function read(id: string, bytes: Uint8Array<ArrayBuffer>) {
    const { value, told } = await reading(bytes, (file) => studio.import_photo(id, file));
    const entry: ImportEntry = JSON.parse(value);
    return { entry, told };
  }

  async function kept({ meta, format, damage, measures, work, small }: ImportEntry, among: Lru): Promise<Imported> {
    return {
      meta: { ...meta, format, damage, measures },
      work: await keep(`${meta.id}/work`, work, among),
      small: await keep(`${meta.id}/small`, small, among),
    };
  }

  async function importFrame({
    id,
    frame: { width, height, data, squareWidth, squareHeight, rotation },
  }: Operations['importFrame']['args']) {
    const entry: ImportEntry = JSON.parse(
      studio.import_frame(id, width, height, data, squareWidth, squareHeight, rotation),
    );
    detach(data);
    const png = studio.take_file() as Uint8Array<ArrayBuffer>;
    const file = await blobOf(png, { type: 'image/png' });
    const ok = { ...(await kept(entry, passing)), file };
    evict([]);
    return { ok, transfer: [] };
  }

  async function smallFrame({
    frame: { width, height, data, squareWidth, squareHeight, rotation },
    longest,
  }: Operations['smallFrame']['args']) {
    const small = pixels(studio.small_frame(width, height, data, squareWidth, squareHeight, rotation, longest));
    detach(data);
    return small;
  }

  async function living({ document, index, width, frames, still }: Operations['living']['args']) {
    for (const { width: across, height, data } of frames) {
      studio.add_living(across, height, new Uint8Array(data.buffer));
      detach(data);
    }
    const drawn: BitmapPatch[] = [];
    for (const patch of studio.draw_living(document, index, width, still)) drawn.push((await bitmap(patch)).ok);
    return { ok: drawn, transfer: drawn.map((patch) => patch.bitmap) };
  }

  async function panel(args: Operations['panel']['args']) {
    const drawn: BitmapPatch[] = [];
    for (const patch of await drawnPanel(args)) drawn.push((await bitmap(patch)).ok);
    return { ok: drawn, transfer: drawn.map((patch) => patch.bitmap) };
  }

  async function front(args: Operations['front']['args']) {
    const ok = (await drawnPanel(args)).map((patch) => pixels(patch).ok);
    return { ok, transfer: buffersOf(ok) };
  }

  async function drawnPanel({
    document,
    pictures,
    width,
    tier,
    photos,
  }: Operations['panel']['args']): Promise<Patch[]> {
    await fetchPhotos(photos);
    return studio.render_panel(document, Uint32Array.from(pictures), width, tier, true);
  }

  async function page({ document, width, tier, photos }: Operations['page']['args']) {
    await fetchPhotos(photos);
    return bitmap(studio.compose(document, width, tier));
  }

  async function compose({ document, width, tier, photos }: Operations['compose']['args']) {
    await fetchPhotos(photos);
    return pixels(studio.compose(document, width, tier));
  }

  async function stylePhoto({ photo, style, width, height, crop }: Operations['stylePhoto']['args']) {
    await fetchPhotos([photo]);
    return bitmap(studio.stylize_photo(photo.key, style, width, height, crop));
  }

  async function stylePixels({ photo, style, width, height }: Operations['stylePixels']['args']) {
    await fetchPhotos([photo]);
    return pixels(studio.stylize_photo(photo.key, style, width, height, ''));
  }

  async function plates({ document }: Operations['plates']['args']) {
    const ok: Plates | null = JSON.parse(plates_of(document));
    return { ok, transfer: [] };
  }

  async function stylize({ style, width, height, data }: Operations['stylize']['args']) {
    const styled = studio.stylize(style, width, height, data) as Uint8Array<ArrayBuffer>;
    const ok = {
      x: 0,
      y: 0,
      width,
      height,
      data: new Uint8ClampedArray(styled.buffer, styled.byteOffset, styled.length),
    };
    return { ok, transfer: [styled.buffer] };
  }

  /** The panels that show one photo, from its original file at full size, so that it is decoded once for all. */
  async function fullPanels({ id, file, mask, document, panels, width, bordered }: Operations['fullPanels']['args']) {
    if (file) {
      const bytes = await bytesOf(file);
      await reading(bytes, (file) => studio.import_full(id, file));
      studio.know_subject(`${id}/full`, mask);
    }
    try {
      const ok = [];
      for (const pictures of panels) {
        const drawn = studio.render_panel(document, Uint32Array.from(pictures), width, 'full', bordered);
        ok.push(...drawn.map((patch, at) => ({ ...pixels(patch).ok, index: pictures[at] })));
      }
      return { ok, transfer: buffersOf(ok) };
    } finally {
      if (file) studio.drop_photo(`${id}/full`);
    }
  }

  /** The subject of a photo, from its original file at full size. */
  async function cutOut({ id, file, mask }: Operations['cutOut']['args']) {
    const bytes = await bytesOf(file);
    await reading(bytes, (original) => studio.import_full(id, original));
    try {
      const png = studio.cut_out(`${id}/full`, mask) as Uint8Array<ArrayBuffer> | undefined;
      if (!png) throw failure('no-mask', 'The subject of the photo is not known.');
      return { ok: await blobOf(png, { type: 'image/png' }), transfer: [] };
    } finally {
      studio.drop_photo(`${id}/full`);
    }
  }

  async function encode({ document, width, patches }: Operations['encode']['args']) {
    studio.begin_page(document, width);
    for (const { x, y, width: w, height: h, data } of patches) {
      studio.add_patch(x, y, w, h, new Uint8Array(data.buffer, data.byteOffset, data.length));
    }
    const png = studio.finish_png() as Uint8Array<ArrayBuffer>;
    return { ok: await blobOf(png, { type: 'image/png' }), transfer: [] };
  }

  /** Copies the planes of a new photo into a Blob, which the app passes to the other workers. */
  async function keep(key: string, { width, height }: PixelSize, among: Lru): Promise<PhotoHandle> {
    const planes = studio.photo_planes(key) as Uint8Array<ArrayBuffer>;
    among.touch(key, planes.length);
    return { key, width, height, planes: await blobOf(planes) };
  }

  /** Reads missing photos into the studio. */
  async function fetchPhotos(photos: PhotoHandle[]) {
    await Promise.all(
      photos.map(async ({ key, width, height, planes, mask, draft }) => {
        if (!studio.has_photo(key) || (drafts.has(key) && !draft)) {
          const bytes = await bytesOf(planes);
          studio.drop_photo(key);
          studio.put_photo(key, width, height, bytes);
          detach(bytes);
          if (draft) drafts.add(key);
          else drafts.delete(key);
        }
        studio.know_subject(key, mask);
        passing.forget(key);
        held.touch(key, planes.size);
      }),
    );
    evict(photos.map(({ key }) => key));
  }

  function evict(needed: string[]) {
    const isNeeded = (key: string) => needed.includes(key);
    for (const key of [...held.evict(isNeeded), ...passing.evict(isNeeded)]) studio.drop_photo(key);
  }
}

function keysOf(id: string): string[] {
  return [`${id}/work`, `${id}/small`];
}

async function bytesOf(blob: Blob): Promise<Uint8Array<ArrayBuffer>> {
  if (blob.size > MOST_BYTES) throw failure('too-large', `The file is larger than ${MOST_BYTES / 2 ** 20} MB.`);
  try {
    return new Uint8Array(await blob.arrayBuffer());
  } catch (cause) {
    // The browser throws this when a file was moved, changed or deleted since it was chosen.
    throw Object.assign(new Error('The file can no longer be read.', { cause }), { code: 'unreadable-file' });
  }
}

function pixels(patch: Patch): { ok: PixelPatch; transfer: Transferable[] } {
  const { x, y, width, height } = patch;
  const data = patch.take() as Uint8ClampedArray<ArrayBuffer>;
  patch.free();
  return { ok: { x, y, width, height, data }, transfer: [data.buffer] };
}

/** @param measure reads the pixels */
async function bitmap(
  patch: Patch,
  measure?: (data: Uint8ClampedArray) => void,
): Promise<{ ok: BitmapPatch; transfer: Transferable[] }> {
  const {
    ok: { x, y, width, height, data },
  } = pixels(patch);
  measure?.(data);
  const image = await createImageBitmap(new ImageData(data, width, height));
  detach(data);
  return { ok: { x, y, width, height, bitmap: image }, transfer: [image] };
}
