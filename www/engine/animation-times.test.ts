import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, test, vi } from 'vitest';
import { endsOf, pictureEnds } from './animation-times.ts';

const DATA = new URL('../../tests/oracles/data/', import.meta.url);

const file = (name: string) => new Uint8Array(readFileSync(new URL(name, DATA)));

describe('the times of an animation', () => {
  test('are those that Pillow finds', () => {
    const expected = JSON.parse(readFileSync(new URL('animations/expected.json', DATA), 'utf8'));
    expect(expected.length).toBeGreaterThan(5);
    for (const { file: name, ends } of expected) {
      const found = endsOf(file(`animations/${name}`));
      expect(found.length, name).toBe(ends.length);
      found.forEach((end, i) => expect(end, name).toBeCloseTo(ends[i], 6));
    }
  });

  test('are none for a still picture and for any other file', async () => {
    for (const name of readdirSync(new URL('files/', DATA)).filter((other) => !other.includes('animated')))
      expect(endsOf(file(`files/${name}`)), name).toEqual([]);
    expect(endsOf(new Uint8Array())).toEqual([]);
    const gif = new File([file('animations/kept.gif')], 'a.gif');
    expect(await pictureEnds(new File([file('animations/kept.gif')], 'a.jpg', { type: 'image/jpeg' }))).toEqual([]);
    expect(await pictureEnds(gif)).toHaveLength(6);
  });

  test('need only the head of a still WebP picture', async () => {
    const whole = async (name: string) => {
      const picture = new File([file(name)], 'a.webp');
      const read = vi.spyOn(picture, 'arrayBuffer');
      await pictureEnds(picture);
      return read.mock.calls.length > 0;
    };
    const stills = readdirSync(new URL('files/', DATA)).filter(
      (name) => /\.webp$/.test(name) && !name.includes('animated'),
    );
    expect(stills.length).toBeGreaterThan(2);
    for (const name of stills) expect(await whole(`files/${name}`), name).toBe(false);
    expect(await whole('animations/clear.webp')).toBe(true);
  });

  test('stand for what browsers do with a delay of nothing', () => {
    const bytes = file('animations/kept.gif').slice();
    const at = bytes.findIndex((byte, i) => byte === 0x21 && bytes[i + 1] === 0xf9);
    bytes[at + 4] = 0;
    expect(endsOf(bytes)[0]).toBeCloseTo(0.1);
  });

  test('end before the pictures become too many', () => {
    const bytes = file('animations/kept.gif').slice();
    new DataView(bytes.buffer).setUint16(6, 30_000, true);
    new DataView(bytes.buffer).setUint16(8, 20_000, true);
    expect(endsOf(bytes)).toHaveLength(2);
  });

  test('of a file cut anywhere are no error', () => {
    for (const name of ['kept.gif', 'clear.webp']) {
      const bytes = file(`animations/${name}`);
      for (let length = 0; length < bytes.length; length += 1)
        expect(endsOf(bytes.subarray(0, length)).length).toBeLessThanOrEqual(6);
    }
  });
});
