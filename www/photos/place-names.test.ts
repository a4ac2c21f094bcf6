import { expect, it } from 'vitest';
import { createPlaceNames } from './place-names.ts';

const file = (name: string) => new File([name], name);

function names({ table = true } = {}) {
  let loads = 0;
  const places = createPlaceNames({
    locationOf: async (photo) => {
      const text = await photo.text();
      if (text === 'broken') throw new Error('cannot be read');
      return text.startsWith('at ') ? new TextEncoder().encode(text) : null;
    },
    load: async () => {
      loads += 1;
      return table ? (bytes) => new TextDecoder().decode(bytes).match(/^at (\w+)/)?.[1] : null;
    },
  });
  return { places, loads: () => loads };
}

it('photos with a location get a place, and the table is loaded once', async () => {
  const { places, loads } = names();
  places.begin([
    { file: file('plain'), ids: ['a'], video: null },
    { file: file('broken'), ids: ['b'], video: null },
  ]);
  await places.settled();
  expect([places.names.peek().size, loads()]).toEqual([0, 0]);
  places.begin([
    { file: file('at Sintra'), ids: ['c'], video: null },
    { file: file('at Lisbon'), ids: ['d', 'e'], video: {} },
    { file: file('at ?'), ids: ['f'], video: null },
  ]);
  places.begin([{ file: file('at Cascais'), ids: ['g'], video: null }]);
  await places.settled();
  expect([...places.names.peek()]).toEqual([
    ['c', 'Sintra'],
    ['g', 'Cascais'],
  ]);
  expect(loads()).toBe(1);
});

it('without a table no photo has a place', async () => {
  const { places } = names({ table: false });
  places.begin([{ file: file('at Sintra'), ids: ['a'], video: null }]);
  await places.settled();
  expect(places.names.peek().size).toBe(0);
});
