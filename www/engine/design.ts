/**
 * Preview of a style in the designer, drawn by a separate worker. The worker caches the image after every block, so it
 * computes only the blocks after a change. The worker starts with the first call.
 */

import { withOwnModels } from './painters.ts';
import { createPool } from './pool.ts';
import { Priority } from './queue.ts';
import type { FindOwn } from './painters.ts';
import type { Pool } from './pool.ts';
import type { Style } from './types.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { BitmapPatch } from './protocol.ts';

/**
 * `times`: milliseconds of each block by its index, plus 256 in the foreground. `stages`: the images after the blocks,
 * if requested.
 */
export type Designed = BitmapPatch & { times: [number, number][]; stages: { place: number; bitmap: ImageBitmap }[] };

/** Offset of the block indices in the foreground. */
export const FOREGROUND = 256;

/** @param ownPainters returns the function that finds models of the user */
export function createDesign(
  photos: ReturnType<typeof createPhotos>,
  ownPainters: () => FindOwn | undefined = () => undefined,
) {
  let spawn: (() => Worker) | undefined;
  let pool: Pool | undefined;

  return {
    /** @param how a worker is made */
    prepare: (how: () => Worker) => {
      spawn = how;
    },
    draw,
    dispose: () => pool?.dispose(),
  };

  /**
   * @param id of a photo
   * @param size `stages`: the longer side of the images after each block; by default there are no such images
   */
  async function draw(
    id: string,
    style: Style,
    { width, height, stages = 0 }: { width: number; height: number; stages?: number },
    call?: Call,
  ): Promise<Designed> {
    const { name } = photos.get(id);
    const work = photos.handle(id, 'work');
    pool ??= createPool({ size: 1, spawn: spawn as () => Worker });
    const plain = { photo: work, style: JSON.stringify(style), width, height, stages };
    const args = await withOwnModels(plain, ownPainters());
    return pool.run({ op: 'design', args, photo: name, holds: [work.key], priority: Priority.PANEL, ...call });
  }
}
