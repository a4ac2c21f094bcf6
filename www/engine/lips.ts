/** Lips of the faces of a video: how much each mouth opens and closes around a frame. */

import { readVideo } from './video.ts';
import { Priority } from './queue.ts';
import type { Call } from './engine.ts';
import type { Moment } from './living.ts';
import type { Run } from './pool.ts';
import type { PhotoHandle } from './protocol.ts';
import type { Detection } from './types.ts';
import type { Frame } from './video.ts';

/** Frames before and after a photo, their distance in seconds, and the long side of a frame in pixels. */
const FRAMES = { beside: 3, step: 0.15, longest: 1280 } as const;

/** @returns times of frames around a photo, rising, all within the video */
export function lipTimes({ time, duration }: Pick<Moment, 'time' | 'duration'>): number[] {
  const steps = Array.from({ length: 2 * FRAMES.beside + 1 }, (_, i) => i - FRAMES.beside);
  return steps.map((step) => time + step * FRAMES.step).filter((at) => at >= 0 && at < duration);
}

/**
 * @param looks the same faces in other frames, in the same order
 * @returns the faces with the change of their lips as the distance of their lips; null if a face is not readable in at
 *   least two frames
 */
export function withMovement(
  faces: readonly Detection[],
  looks: readonly (readonly Detection[])[],
): readonly Detection[] | null {
  const mouths = faces.map((_, i) => looks.flatMap((look) => look[i]?.expression?.mouth ?? []));
  if (mouths.some((distances) => distances.length < 2)) return null;
  const change = mouths.map((distances) => Math.max(...distances) - Math.min(...distances));
  return faces.map((face, i) =>
    face.expression ? { ...face, expression: { ...face.expression, mouth: change[i] } } : face,
  );
}

/** @param app `readLips` finds the lips of known faces in pixels */
export function createLips({
  run,
  readLips,
}: {
  run: Run;
  readLips: (photo: PhotoHandle, faces: readonly Detection[], call?: Call) => Promise<readonly Detection[]>;
}) {
  return { watchLips };

  /**
   * Compares the lips of faces over the frames around a photo of a video.
   * @param faces of the photo, in fractions of it
   * @returns as `withMovement`
   * @throws as `importVideo`
   */
  async function watchLips({ file, ...moment }: Moment, faces: readonly Detection[], call: Call = {}) {
    const times = lipTimes(moment);
    // Old expressions would count for faces that the model does not find.
    const boxes = faces.map(({ expression: _, ...box }) => box);
    const looks: (readonly Detection[])[] = [];
    await readVideo(
      file,
      { count: times.length, times },
      {
        signal: call.signal,
        onAbout: () => {},
        onFrame: async ({ index: _, time: __, shot: ___, ...frame }: Frame) => {
          const args = { frame, longest: FRAMES.longest };
          const job = { op: 'smallFrame' as const, args, transfer: [frame.data.buffer], photo: file.name };
          const { width, height, data } = await run({ ...job, priority: Priority.REST, ...call });
          const planes = new Blob([planesOf(data)]);
          looks.push(await readLips({ key: '', width, height, planes }, boxes, call));
        },
      },
    );
    return withMovement(faces, looks);
  }
}

/** @param data RGBA */
function planesOf(data: Uint8ClampedArray<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const size = data.length / 4;
  const planes = new Uint8Array(3 * size);
  for (let i = 0; i < size; i += 1)
    for (let channel = 0; channel < 3; channel += 1) planes[channel * size + i] = data[4 * i + channel];
  return planes;
}
