/**
 * Face and object detection, in two parallel workers, or in one to save memory. A worker and all it needs are loaded with
 * its first call, or before by `prepare`.
 */

import { STORED_AFTER } from './kept.ts';
import { createPool } from './pool.ts';
import { Priority } from './queue.ts';
import type { Look } from './detector-worker.ts';
import type { Call } from './engine.ts';
import type { createPhotos } from './photos.ts';
import type { Pool } from './pool.ts';
import type { Looking, PhotoHandle } from './protocol.ts';
import type { Scheduler } from './scheduler.ts';
import type { Detection, FirstLook } from './types.ts';

type Net = 'faces' | 'objects';

/** Rounds of detection on a blank picture while the user chooses photos, and its sides in pixels. */
const ROUNDS = 12;
const BLANK = { width: 640, height: 480 };

/** Whether a closer look may find the face of a person. */
export const showsPerson = (objects: readonly Detection[]) => objects.some(({ label }) => label === 'person');

/**
 * @param options `workers`: 2, or 1 on devices with little memory; `spare`: the pool keeps this many other workers idle during low-priority work. `linger`: milliseconds
 *   after the last detection until the models are unloaded
 */
export function createDetector(
  photos: ReturnType<typeof createPhotos>,
  {
    scheduler,
    workers,
    spare,
    linger,
  }: { scheduler: Scheduler; workers: number; spare: (workers: number) => void; linger: number },
) {
  const pools: Partial<Record<Net, Pool<Looking>>> = {};
  /** Models whose files are requested. */
  const fetched: Set<Net> = new Set();
  /** Models that are loaded or queued for loading. */
  const made: Partial<Record<Net, Promise<unknown>>> = {};
  /** The end of that line. */
  let last: Promise<unknown> = Promise.resolve();
  let running = 0;
  let facesMade = false;
  /** The user has not chosen photos yet. */
  let early = false;
  let rehearsal: Promise<void> | undefined;
  const ticket = scheduler.createTicket({ unload, linger, storing: STORED_AFTER });

  return {
    prepare,
    /** Whether a look for faces need not wait for anything. */
    facesReady: () => facesMade,
    detect,
    findFaces,
    findMoreFaces,
    findObjects,
    readLips,
    dispose: ticket.free,
  };

  /**
   * Loads the models, for faces first. Errors are reported by the first detection.
   * @param choosing whether the user still chooses photos, so that no urgent work is waiting
   */
  function prepare(choosing = false) {
    early = choosing;
    const load = async () => {
      await make('faces');
      if (choosing) await (rehearsal ??= rehearse()).catch(() => {});
      await make('objects');
    };
    ticket.use(load, { expected: true }).catch(() => {});
  }

  /**
   * Runs the face detector on an empty image. Browsers compile wasm to slow code first and optimise frequently used
   * code later.
   */
  async function rehearse() {
    const photo = { key: '', ...BLANK, planes: new Blob([new Uint8Array(3 * BLANK.width * BLANK.height)]) };
    for (let round = 0; round < ROUNDS && early; round += 1)
      await open('faces').run({ op: 'faces', args: { photo }, priority: Priority.REST });
  }

  /**
   * Everything that is found in a photo, faces first.
   * @param id of an imported photo
   */
  async function detect(id: string, call?: Call): Promise<readonly Detection[]> {
    const [objects, { boxes, closer }] = await Promise.all([findObjects(id, call), findFaces(id, call)]);
    const faces = closer || showsPerson(objects) ? await findMoreFaces(id, boxes, objects, call) : boxes;
    return [...faces, ...objects];
  }

  /**
   * `closer` is `true` if `findMoreFaces` may find more, even without objects.
   * @param id of an imported photo
   */
  function findFaces(id: string, call?: Call): Promise<FirstLook> {
    return run('faces', 'faces', id, {}, call);
  }

  /**
   * Also finds small faces and the faces of persons. It searches parts of the photo.
   * @param id of an imported photo
   * @param boxes the faces found at first
   * @param objects the objects of the photo
   * @returns the new result, which replaces `boxes`
   */
  function findMoreFaces(
    id: string,
    boxes: readonly Detection[],
    objects: readonly Detection[],
    call?: Call,
  ): Promise<readonly Detection[]> {
    return run('faces', 'closer', id, { boxes, objects }, call);
  }

  /** @param id of an imported photo */
  function findObjects(id: string, call?: Call): Promise<readonly Detection[]> {
    return run('objects', 'objects', id, {}, call);
  }

  /**
   * Eyes and mouths of known faces in pixels that are not a photo.
   * @param boxes the faces, without their expressions
   */
  function readLips(photo: PhotoHandle, boxes: readonly Detection[], call?: Call): Promise<readonly Detection[]> {
    return look('faces', 'lips', 'video', { photo, boxes }, call);
  }

  async function run<Op extends Look>(
    net: Net,
    op: Op,
    id: string,
    more: { boxes?: readonly Detection[]; objects?: readonly Detection[] },
    call?: Call,
  ): Promise<Looking[Op]['ok']> {
    const { name, work } = photos.get(id);
    return look(net, op, name, { photo: work, ...more }, call);
  }

  function look<Op extends Look>(
    net: Net,
    op: Op,
    name: string,
    args: Looking[Op]['args'],
    call?: Call,
  ): Promise<Looking[Op]['ok']> {
    early = false;
    return ticket.use(async () => {
      spare((running += 1));
      try {
        await make(net);
        return await open(net).run({ op, args, photo: name, priority: Priority.REST, ...call });
      } finally {
        spare((running -= 1));
      }
    }, call);
  }

  /** The next detection loads the models again in half a second. */
  function unload() {
    for (const net of ['faces', 'objects'] as const) {
      pools[net]?.dispose();
      delete pools[net];
      delete made[net];
    }
    fetched.clear();
    facesMade = false;
    rehearsal = undefined;
  }

  /**
   * Loads one model after the other. The browser compiles the module during the first one, and parallel loading would
   * be slower.
   */
  function make(net: Net) {
    // Downloads do not need a core.
    for (const one of ['faces', 'objects'] as const) {
      if (!fetched.has(one)) order(one, 'load').catch(() => {});
      fetched.add(one);
    }
    made[net] ??= last = last
      .catch(() => {})
      .then(() => order(net, 'make'))
      .then(() => {
        ticket.made();
        facesMade ||= net === 'faces';
      })
      .catch((error) => {
        delete made[net];
        throw error;
      });
    return made[net];
  }

  function order(net: Net, op: 'load' | 'make'): Promise<null> {
    return open(net).run({ op, args: { net }, priority: Priority.REST });
  }

  function open(net: Net) {
    return (pools[workers > 1 ? net : 'faces'] ??= createPool<Looking>({ size: 1, spawn }));
  }
}

function spawn() {
  return new Worker(new URL('./detector-worker.ts', import.meta.url), { type: 'module', name: 'inkpanel-detector' });
}
