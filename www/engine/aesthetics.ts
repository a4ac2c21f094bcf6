/**
 * Aesthetic score of a photo in a style. The core draws the style, and a separate worker scores the image with a model.
 * The worker and the model are loaded with the first call and unloaded some time after the last. The model is an
 * optional part of the site.
 */

import { NET } from './aesthetics-net.ts';
import { createModelPool } from './model-pool.ts';
import { failure } from './protocol.ts';
import { Priority } from './queue.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Run } from './pool.ts';
import type { Judging, PixelPatch } from './protocol.ts';
import type { Lane, Scheduler } from './scheduler.ts';

export function createAesthetics({
  run,
  photos,
  scheduler,
}: {
  run: Run;
  photos: ReturnType<typeof createPhotos>;
  scheduler: Scheduler;
}) {
  const pool = createModelPool<Judging>(scheduler, spawn);
  return { judges: NET !== undefined, judgeStyle, dispose: pool.dispose };

  /**
   * The predicted mean rating of a photo in a style, from 1 to 10.
   * @param id of an imported photo
   * @param size at which it is drawn
   */
  async function judgeStyle(
    id: string,
    style: object,
    { width, height }: { width: number; height: number },
    { lane = 'requested', ...call }: Call & { lane?: Lane } = {},
  ): Promise<number> {
    if (!NET) throw failure('net-missing', 'The net that scores pictures is not part of this site.');
    const [photo] = photos.handles([id], 'small');
    const job = { photo: photos.names([id]), priority: Priority.REST, ...call };
    const args = { photo, style: JSON.stringify(style), width, height };
    const picture: PixelPatch = await run({ ...job, op: 'stylePixels', args, holds: [photo.key] });
    const { data } = picture;
    const net = new URL(NET, document.baseURI).href;
    const judge = async () => {
      await scheduler.turn(lane, { rest: 0, signal: call.signal });
      return pool.run({ ...job, op: 'judge', args: { width, height, data, net }, transfer: [data.buffer] });
    };
    return pool.use(judge, { lane, signal: call.signal });
  }
}

function spawn() {
  return new Worker(new URL('./aesthetics-worker.ts', import.meta.url), {
    type: 'module',
    name: 'inkpanel-aesthetics',
  });
}
