import { signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { createPlaceNames } from './place-names.ts';

const file = (name: string) => new File([name], name);

function names({ table = true, wanted = true } = {}) {
  let loads = 0;
  const on = signal(wanted);
  const places = createPlaceNames({
    wanted: on,
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
  return { places, on, loads: () => loads };
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

it('text gets names unless the user turned them off, and is marked', async () => {
  const { places, on } = names({ wanted: false });
  expect(places.offered.peek()).toBe(false);
  places.begin([{ file: file('at Sintra'), ids: ['a'], video: null }]);
  await places.settled();
  const word = { kind: 'caption', text: 'Second day. Sintra.', made: true };
  const page: any = { words: [word, { ...word, text: 'Second day.' }, { ...word, made: undefined }] };
  expect([places.names.peek().size, places.offered.peek(), places.marked(page)]).toEqual([0, true, page]);
  on.value = true;
  expect([places.names.peek().get('a'), places.offered.peek()]).toEqual(['Sintra', false]);
  expect(places.marked(page).words?.map(({ located }) => located)).toEqual([true, undefined, undefined]);
});
