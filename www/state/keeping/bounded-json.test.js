// @ts-check
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { parsedJson } from './bounded-json.js';

const MOST = { depth: 4, values: 10, items: 7, string: 8 };

describe('JSON that is counted', () => {
  it('is what it says', () => {
    fc.assert(fc.property(fc.jsonValue(), fc.nat(3), (value, space) => {
      expect(parsedJson(JSON.stringify(value, null, space))).toEqual(JSON.parse(JSON.stringify(value)));
    }));
  });

  it.each([
    ['[[[[1]]]]', '[[[[[1]]]]]'],
    ['[[1,2,3,4],[1,2,3,4]]', '[[1,2,3,4],[1,2,3,4,5]]'],
    ['[1,2,3,4,5,6,7]', '[1,2,3,4,5,6,7,8]'],
    ['[[],[1,2,3,4,5,6,7]]', '[[],[1,2,3,4,5,6,7,8]]'],
    ['{"a":1,"b":2,"c":3,"d":4,"e":5,"f":6,"g":7}', '{"a":1,"b":2,"c":3,"d":4,"e":5,"f":6,"g":7,"h":8}'],
    ['[[],[],[],[],[]]', '[[],[],[],[],[],[]]'],
    ['{"a":{"b":{}}}', '{"a":{"b":{"c":{"d":{}}}}}'],
    ['"12345678"', '"123456789"'],
    ['{"12345678":1}', '{"123456789":1}'],
    ['["[[[[[[["]', '["\\"[[[[[[["]'],
    ['[",\\",,,",",,,,",1]', '["\\\\",1,2,3,4,5,6,7]'],
  ])('is taken as %s, and not as %s', (good, bad) => {
    expect(parsedJson(good, MOST)).toEqual(JSON.parse(good));
    expect(() => parsedJson(bad, MOST)).toThrow(expect.objectContaining({ code: 'too-large-project' }));
  });

  it('that is none is none', () => {
    fc.assert(fc.property(fc.string(), (text) => {
      const said = (/** @type {() => any} */ parse) => { try { return [parse()]; } catch (error) { return error?.constructor?.name; } };
      expect(said(() => parsedJson(text))).toEqual(said(() => JSON.parse(text)));
    }));
  });

  it('is not read to its end where it is a trap', () => {
    for (const text of ['['.repeat(30 << 20), `"${'x'.repeat(30 << 20)}"`, `[${'[],'.repeat(8 << 20)}1]`]) {
      expect(() => parsedJson(text)).toThrow(expect.objectContaining({ code: 'too-large-project' }));
    }
  });
});
