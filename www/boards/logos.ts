/**
 * The logo of a board, as the engine stores it: a picture with a separate id. It is not a photo of the album, and
 * documents do not contain its id.
 */

import { strings } from '../strings/strings.ts';
import { pictureOf } from '../ui/data-picture.tsx';
import { UserError } from '../ui/user-error.ts';
import type { BoardLogo } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';

/** The present one, and the one before: a file that is being made may still show it. */
const HELD = 2;

export function createLogos(engine: Pick<Engine, 'importPhoto' | 'forgetPhoto'>) {
  const held: { url: string; id: string; read: Promise<BoardLogo> }[] = [];
  let count = 0;

  /**
   * @param url as the board has it; another one has another id
   * @throws a sentence if it cannot be read
   */
  return (url: string): Promise<BoardLogo> => {
    const at = held.findIndex((one) => one.url === url);
    const [logo] = at < 0 ? [taken(url)] : held.splice(at, 1);
    held.push(logo);
    if (held.length > HELD) held.splice(0, 1).forEach(forget);
    return logo.read;
  };

  function taken(url: string) {
    count += 1;
    const id = `board-logo-${count}`;
    const logo = { url, id, read: read(id, url) };
    // It may be tried again.
    logo.read.catch(() => {
      const at = held.indexOf(logo);
      if (at >= 0) held.splice(at, 1);
    });
    return logo;
  }

  async function read(id: string, url: string): Promise<BoardLogo> {
    try {
      const file = new File([pictureOf(url)], strings.boards.logo, { type: 'image/png' });
      const { width, height } = await engine.importPhoto(id, file);
      return { photo: id, aspect: width / height };
    } catch (cause) {
      throw new UserError(strings.boards.brokenLogo, { cause });
    }
  }

  function forget({ id, read }: { id: string; read: Promise<BoardLogo> }) {
    read.then(
      () => engine.forgetPhoto(id),
      () => {},
    );
  }
}
