/**
 * The picture of a style that is being designed, by a worker of its own, which keeps the picture after every block: it
 * computes only what a change touches. The worker starts with the first call.
 */

import { createPool } from './pool.ts';
import { Priority } from './queue.ts';
import type { Pool } from './pool.ts';
import type { Style } from './types.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { BitmapPatch } from './protocol.ts';

/**
 * `times`: milliseconds of each block by its place, 256 more in the foreground; `stages`: the pictures after them,
 * where they were asked for.
 */
export type Designed = BitmapPatch & { times: [number, number][]; stages: { place: number; bitmap: ImageBitmap }[] };

/** What is added to the place of a block in the foreground. */
export const FOREGROUND = 256;

export function createDesign(photos: ReturnType<typeof createPhotos>) {
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
   * @param size `stages`: the longer side of the pictures after
   *   each block; none unless told
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
    const args = { photo: work, style: JSON.stringify(style), width, height, stages };
    return pool.run({ op: 'design', args, photo: name, holds: [work.key], priority: Priority.PANEL, ...call });
  }
}
