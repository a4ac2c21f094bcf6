import { describe, expect, it } from 'vitest';
import { hasParts } from './parts.ts';
import type { Style } from '../engine/types.ts';

const style = (more: object) => ({ id: 'a', name: 'A', tags: [], background: [], ...more }) as Style;

describe('styles for a part of the photo', () => {
  it('have a layer or a block that runs for one', () => {
    expect(hasParts(style({ where: { foreground: 'subject' } }))).toBe(true);
    expect(hasParts(style({ foreground: [{ block: 'sobel', where: 'background' }] }))).toBe(true);
  });

  it('are no others', () => {
    expect(hasParts(undefined)).toBe(false);
    expect(hasParts(style({ background: [{ block: 'sobel' }] }))).toBe(false);
    expect(hasParts(style({ background: [{ block: 'sobel', where: 'subject', bypass: true }] }))).toBe(false);
  });
});
