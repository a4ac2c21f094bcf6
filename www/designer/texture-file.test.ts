import { describe, expect, it } from 'vitest';
import { MOST } from '../document/limits.ts';
import { pictureOf } from '../ui/data-picture.tsx';
import { textureOf } from './texture-file.ts';

const PNG = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a];
const fine = () => undefined;

describe('the texture of a file', () => {
  it('is a data URL of what the file is, whatever its name says, and comes back as that file', async () => {
    const url = await textureOf(new File([Uint8Array.from(PNG)], 'hatch.jpg'), fine);
    expect(url).toBe('data:image/png;base64,iVBORw0K');
    const picture = pictureOf(url);
    expect(picture.type).toBe('image/png');
    expect(Array.from(new Uint8Array(await picture.arrayBuffer()))).toEqual(PNG);
  });

  it('is refused with the name of the file where it is too large, another kind, or the core cannot read it', async () => {
    const large = new File([new Uint8Array(MOST.texture + 1)], 'large.png');
    await expect(textureOf(large, fine)).rejects.toThrow(/large\.png.*257.*256/);
    await expect(textureOf(new File(['GIF89a'], 'moves.gif'), fine)).rejects.toThrow('moves.gif');
    const broken = (_: unknown, name: string) => {
      throw new Error(`style ${name}: background[1] (pattern), texture: cannot be read`);
    };
    await expect(textureOf(new File([Uint8Array.from(PNG)], 'cut.png'), broken)).rejects.toThrow('cut.png');
  });
});
