/**
 * A picture file as the texture of a style: a data URL. Messages here are in the language of the app. Only the core can
 * detect errors inside an image.
 */

import { MOST } from '../document/limits.ts';
import { strings } from '../strings/strings.ts';
import { urlOf } from '../ui/data-picture.tsx';
import { UserError } from '../ui/user-error.ts';
import type { Style, StyleStep } from '../engine/types.ts';

/** First bytes of PNG and JPEG files, because a file name can be wrong. */
const KINDS = [
  { type: 'image/png', start: [0x89, 0x50, 0x4e, 0x47] },
  { type: 'image/jpeg', start: [0xff, 0xd8, 0xff] },
];

/**
 * @param check the core's check of a style, which throws
 * @returns the data URL of a picture that the core can draw with
 * @throws a sentence that names the file
 */
export async function textureOf(file: File, check: (style: Style, name: string) => unknown): Promise<string> {
  if (file.size > MOST.texture) {
    throw new UserError(
      strings.textureTooLarge({ name: file.name, kilobytes: Math.ceil(file.size / 1024), most: MOST.texture / 1024 }),
    );
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  const kind = KINDS.find(({ start }) => start.every((byte, at) => bytes[at] === byte));
  if (!kind) throw new UserError(strings.textureOfAnotherKind({ name: file.name }));
  const url = urlOf(bytes, kind.type);
  const background: StyleStep[] = [{ block: 'to_gray' }, { block: 'pattern', texture: url }];
  check({ id: 'texture', name: 'texture', tags: [], background }, file.name);
  return url;
}
