/**
 * Rotates and flips photos. The rotated photo is a new photo with its own file: it replaces the photo in the tray and on
 * all pages, as one undo step. So saved projects, exports and the command line need to know nothing of it.
 */

import { batch, signal } from '@preact/signals';
import { Priority } from '../engine/queue.ts';
import { importing } from '../ui/importing.ts';
import type { Fact } from '../document/album.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';
import type { Engine } from '../engine/engine.ts';
import type { Rotation } from '../engine/metadata/rotate.ts';
import type { Subject } from '../engine/types.ts';
import type { Messages } from '../ui/messages.ts';
import type { Reading } from './reading.ts';

export type Rotating = ReturnType<typeof createRotating>;

type Point = { x: number; y: number };

export function createRotating({
  store,
  pages,
  reading,
  engine,
  messages,
}: {
  store: Store;
  pages: Pick<Pages, 'edit'>;
  reading: Pick<Reading, 'freshIds'>;
  engine: Pick<Engine, 'rotatedPhoto' | 'importPhoto'>;
  messages: Pick<Messages, 'fileFailed'>;
}) {
  const waiting = signal(0);
  let last: Promise<string | undefined> = Promise.resolve(undefined);
  /** The rotated photo of each photo. */
  const later: Map<string, string> = new Map();

  return {
    /** Whether a photo is being rotated. */
    busy: () => waiting.value > 0,
    rotate,
  };

  /**
   * @param photoOf returns the id of the photo. It is called after earlier rotations, which change ids
   * @returns the new id; undefined if nothing was rotated
   */
  function rotate(photoOf: () => string | null, rotation: Rotation): Promise<string | undefined> {
    waiting.value += 1;
    last = last
      .then(() => rotateNow(store.album.peek().get(latest(photoOf() ?? '')), rotation))
      .finally(() => {
        waiting.value -= 1;
      });
    return last;
  }

  /** @returns the photo of the tray that a photo has become, by rotations that were not undone */
  function latest(id: string): string {
    const there = new Set(store.tray.peek().map((item) => item.id));
    let now = id;
    while (!there.has(now) && later.has(now)) now = later.get(now) as string;
    return now;
  }

  async function rotateNow(fact: Fact | undefined, rotation: Rotation): Promise<string | undefined> {
    if (!fact?.meta || fact.absent) return undefined;
    const { id, name, credit, meta: before } = fact;
    const [fresh] = reading.freshIds(1);
    const meta = await importing(messages, name, async () => {
      const file = new File([await engine.rotatedPhoto(id, rotation)], name);
      const {
        damage: _damage,
        measures: _measures,
        ...read
      } = await engine.importPhoto(fresh, file, {
        priority: Priority.PAGE,
      });
      return read;
    });
    const item = store.tray.peek().find((other) => other.id === id);
    // Another project may be open now, without this photo.
    if (!meta || !item) return undefined;
    const gesture = `rotate-${fresh}`;
    batch(() => {
      // A photo that the user rotated is never excluded as a near-duplicate.
      store.know({
        id: fresh,
        name,
        credit,
        meta: {
          ...meta,
          taken: meta.taken ?? before.taken,
          subjects: before.subjects.map((subject) => rotatedSubject(subject, rotation)),
        },
        measures: null,
      });
      if (item.focus) store.change({ type: 'focus-photo', id, focus: rotatedPoint(item.focus, rotation), gesture });
      store.change({ type: 'exchange-photo', id, by: fresh, gesture });
      pages.edit({ type: 'recrop-photo', photo: fresh, everywhere: true, gesture });
    });
    later.set(id, fresh);
    return fresh;
  }
}

function rotatedPoint({ x, y }: Point, rotation: Rotation): Point {
  return rotation === 'flip' ? { x: 1 - x, y } : { x: 1 - y, y: x };
}

function rotatedSubject({ x, y, width, height, points, expression, ...subject }: Subject, rotation: Rotation): Subject {
  const corner = rotatedPoint(rotation === 'flip' ? { x: x + width, y } : { x, y: y + height }, rotation);
  const [wide, high] = rotation === 'flip' ? [width, height] : [height, width];
  const at = points?.map(([left, top]): [number, number] => {
    const point = rotatedPoint({ x: left, y: top }, rotation);
    return [point.x, point.y];
  });
  // A flip exchanges the eyes.
  const seen =
    rotation === 'flip' && expression
      ? { ...expression, rightEye: expression.leftEye, leftEye: expression.rightEye }
      : expression;
  return {
    ...subject,
    ...corner,
    width: wide,
    height: high,
    ...(at && { points: at }),
    ...(seen && { expression: seen }),
  };
}
