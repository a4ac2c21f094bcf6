/** Files that are imported into a real project, and the list that the core saves of it. */

import { readFileSync } from 'node:fs';
import { beforeAll, expect, test, vi } from 'vitest';
import { fakeApp, orderByName } from '../document/testing.ts';
import { readAssetsFromFiles } from '../engine/testing-assets.ts';
import { initSync, shotFile } from '../pkg-exports/inkpanel.js';
import { choosing } from '../ui/encodings.ts';
import { importShots } from './board-import.ts';
import { createBoards } from './boards.ts';

readAssetsFromFiles();

beforeAll(() => {
  initSync({ module: readFileSync(new URL('../pkg-exports/inkpanel_bg.wasm', import.meta.url)) });
});

/** A board with the shots in the order of the names. */
async function board(...names: string[]) {
  const app = fakeApp();
  orderByName(app);
  await app.reading.addFiles(names.map((name, i) => new File([String(i)], name)));
  const messages = { alert: vi.fn(), note: vi.fn(), fileFailed: vi.fn() };
  const boards = createBoards({ store: app.store, engine: app.engine, chooseStyle: () => {} });
  return {
    ...app,
    boards,
    messages,
    take: (name: string, ...parts: BlobPart[]) =>
      importShots(new File(parts, name), { boards, store: app.store, messages }),
    shots: () => boards.rows.peek().map(({ shot }) => shot),
    csv: () => shotFile('csv', JSON.stringify(boards.shotList())),
  };
}

const latin = (text: string) => Uint8Array.from(Buffer.from(text, 'latin1'));

test('a list that was saved changes nothing when it is imported again, whatever the photos are called', async () => {
  const { boards, take, csv, store, messages, shots } = await board('a.jpg', 'a.jpg', '=b.jpg', 'a.jpg', 'c.jpg');
  const ids = boards.rows.peek().map(({ id }) => id);
  boards.describe({
    [ids[1]]: { number: '4A', notes: '=1+1, "x"\nand more' },
    [ids[3]]: { number: '101', frames: 37, scene: '7', action: 'She waits.', dialogue: '- Well?' },
  });
  boards.addColumn('Lens');
  const before = store.mirror.peek().present;
  const saved = csv();
  await take('shots.csv', saved);
  expect(shots()).toEqual(before.tray.map(({ shot }) => shot ?? {}));
  expect(messages.note.mock.calls).toEqual([['shots.csv: 5 shots were filled in.']]);
  expect(messages.alert).not.toHaveBeenCalled();
  expect(csv()).toBe(saved);
});

test('each change of a saved list arrives at its shot, with photos of one name and as one step', async () => {
  const { take, csv, shots, store } = await board('a.jpg', 'a.jpg', 'a.jpg');
  const lines = csv().split('\r\n');
  const changed = lines.map((line, i) => (i > 0 && line ? line.replace(/,,,$/, `,Action ${i},,`) : line));
  await take('shots.csv', changed.join('\r\n').replace(',2,a.jpg', ',2B,a.jpg'));
  expect(shots().map(({ action, number }) => [action, number])).toEqual([
    ['Action 1', undefined],
    ['Action 2', '2B'],
    ['Action 3', undefined],
  ]);
  store.change({ type: 'undo' });
  expect(shots()).toEqual([{}, {}, {}]);
});

test('new columns and their cells are one step of the undo', async () => {
  const { take, boards, shots, store } = await board('a.jpg');
  await take('shots.csv', 'Action,Lens\nShe waits.,35\n');
  expect([boards.board.peek().columns, shots()]).toEqual([['Lens'], [{ action: 'She waits.', more: { Lens: '35' } }]]);
  store.change({ type: 'undo' });
  expect([boards.board.peek().columns, shots()]).toEqual([[], [{}]]);
});

test('files in Windows-1252 are read, and the guess is reported', async () => {
  const table = await board('a.jpg');
  await table.take('liste.csv', latin('Scene;Shot;Action\r\n1;1A;Öffnet die Tür leise\r\n'));
  expect(table.shots()).toEqual([{ scene: '1', number: '1A', action: 'Öffnet die Tür leise' }]);
  expect(table.messages.alert.mock.calls).toEqual([
    [expect.stringMatching(/^liste\.csv: .*Windows-1252/), expect.objectContaining({ label: 'Change encoding' })],
  ]);
  const script = await board('a.jpg');
  await script.take('buch.fountain', latin('INT. KÜCHE - TAG\n\nSie geht.\n\nMÜLLER\nGrüß Gott!\n'));
  expect(script.shots()).toEqual([{ scene: 'INT. KÜCHE - TAG', action: 'Sie geht.', dialogue: 'MÜLLER: Grüß Gott!' }]);
});

test('a changed encoding replaces the imported fields after other edits, as one step', async () => {
  const { take, messages, boards, shots, store } = await board('a.jpg', 'b.jpg');
  const names = boards.rows.peek().map(({ id }) => id);
  await take('liste.csv', latin('Scene;Action;Kühl;Notes\r\n1;Öffnet die Tür leise;é;ü\r\n2;Schließt;ß;ö\r\n'));
  const [, way] = messages.alert.mock.calls[0];
  boards.describe({ [names[0]]: { ...shots()[0], action: 'Edited', number: '9' } });
  store.change({ type: 'rename', name: 'Other' });
  way.run();
  choosing.value?.again('KOI8-R');
  await vi.waitFor(() => expect(boards.board.peek().columns).not.toEqual(['Kühl']));
  const [column] = boards.board.peek().columns;
  const koi = (text: string) => new TextDecoder('koi8-r').decode(latin(text));
  expect(column).toBe(koi('Kühl'));
  expect(shots()).toEqual([
    { scene: '1', number: '9', action: 'Edited', notes: koi('ü'), more: { [column]: koi('é') } },
    { scene: '2', action: koi('Schließt'), notes: koi('ö'), more: { [column]: koi('ß') } },
  ]);
  expect(store.project.peek().name).toBe('Other');
  await vi.waitFor(() =>
    expect(messages.note).toHaveBeenLastCalledWith('5 texts were replaced. Edited texts did not change.'),
  );
  store.change({ type: 'undo' });
  expect([boards.board.peek().columns, shots()[0].action, shots()[1].action]).toEqual([['Kühl'], 'Edited', 'Schließt']);
});

test('a text file with scenes is a screenplay, any other is a table', async () => {
  const { take, shots } = await board('a.jpg');
  await take('script.txt', 'INT. HOUSE - DAY\n\nShe sits.\n');
  await take('table.txt', 'Notes\tScene\nsoon\t7\n');
  expect(shots()).toEqual([{ scene: '7', action: 'She sits.', notes: 'soon' }]);
});

test('every lost line is counted, and the first dozen are named', async () => {
  const { take, messages } = await board('a.jpg');
  await take('some.csv', 'Picture,Action,Duration\na.jpg,A,soon\na.jpg,B,\nz.jpg,C,\n');
  expect(messages.alert.mock.calls).toEqual([
    [
      'some.csv: 1 shot was filled in. 2 lines did not match any shot: “3: a.jpg B” and “4: z.jpg C”. ' +
        '1 cell was skipped or shortened: “2, Duration: soon”.',
    ],
  ]);
  messages.alert.mockClear();
  await take('many.fountain', Array.from({ length: 20 }, (_, i) => `Paragraph ${i}.`).join('\n\n'));
  expect(messages.alert.mock.calls[0][0]).toMatch(
    /^many\.fountain: 1 shot .* 19 lines .*“Paragraph 12\.” and 7 more\.$/,
  );
});

test('a file without anything for the shots, one that is no text and one that is too large are reported', async () => {
  const { take, messages, shots } = await board('a.jpg');
  await take('other.csv', 'Picture,Action\nz.jpg,C\n');
  await take('photo.csv', Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 0x10));
  await take('large.csv', new Uint8Array(5_000_001));
  expect(messages.alert.mock.calls).toEqual([
    ['Nothing in other.csv matches the shots. 1 line did not match any shot: “2: z.jpg C”.'],
  ]);
  expect(messages.fileFailed.mock.calls.map(([name, why]) => [name, why])).toEqual([
    ['photo.csv', expect.stringMatching(/not a text file/)],
    ['large.csv', expect.stringMatching(/too large/)],
  ]);
  expect(shots()).toEqual([{}]);
});
