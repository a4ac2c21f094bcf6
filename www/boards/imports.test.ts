import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { MOST } from '../engine/bounds.ts';
import { translations } from '../strings/testing.ts';
import { HEADINGS } from './headings.ts';
import { cells, fromFountain, fromTable } from './imports.ts';
import { NO_BOARD, numbered } from './shots.ts';

const rows = (count: number) =>
  numbered(Array.from({ length: count }, (_, i) => ({ id: `p${i}`, shot: i === 0 ? { notes: 'kept' } : {} })));

test('a screenplay is put on shots, one paragraph each, and the paragraphs without a shot are named', () => {
  const told = fromFountain('INT. HALL\n\nShe sits.\n\nANNA\nHello?\n\nHe stands.\n\nHe falls.', rows(2));
  expect(told.shots).toEqual({
    p0: { notes: 'kept', scene: 'INT. HALL', action: 'She sits.', dialogue: 'ANNA: Hello?' },
    p1: { scene: 'INT. HALL', action: 'He stands.' },
  });
  expect([told.lost, told.cells]).toEqual([['He falls.'], []]);
});

test('what is longer than a field of a shot is cut, and that is reported', () => {
  const long = 'long '.repeat(3_000).trim();
  const told = fromFountain(`INT. ${'HALL '.repeat(60)}\n\n${long}`, rows(1));
  expect([told.shots.p0.scene?.length, told.shots.p0.action?.length]).toEqual([199, 9_999]);
  expect(told.cells).toEqual([expect.stringMatching(/^INT\. HALL/), long]);
});

const table = (text: string, count = 3) =>
  fromTable(text, {
    rows: rows(count),
    board: { ...NO_BOARD, fps: 25 },
    headings: HEADINGS,
    names: new Map([
      ['p0', 'a.jpg'],
      ['p1', 'b.jpg'],
      ['p2', 'c.jpg'],
    ]),
  });

test('a table is read by its headings in any language, by its pictures, and with columns of its own', () => {
  const told = table(
    'Szene;Bild;Dauer;Handlung;Lens\n1;c.jpg;2:12;"Sie sagt ""ja"";\nund geht";35\n2;gone.jpg;1;x;50\n',
  );
  expect(told.shots).toEqual({
    p2: { scene: '1', frames: 62, action: 'Sie sagt "ja";\nund geht', more: { Lens: '35' } },
  });
  expect([told.columns, told.lost]).toEqual([['Lens'], ['3: 2 gone.jpg 1 x 50']]);
});

test('a table without pictures goes to the shots in order, and the lines without a shot are named', () => {
  const told = table('Shot\tAction\tFrames\n1\tA\t12\n4A\tB\t\n\n2\tC\t1\n4\tD\t2\n');
  expect(told.shots).toEqual({
    p0: { notes: 'kept', action: 'A', frames: 12 },
    p1: { number: '4A', action: 'B' },
    p2: { action: 'C', frames: 1 },
  });
  expect(told.lost).toEqual(['6: 4 D 2']);
});

describe('numbers of shots', () => {
  const numbers = (text: string, own: readonly (string | undefined)[]) => {
    const given = numbered(own.map((number, i) => ({ id: `p${i}`, shot: number ? { number } : {} })));
    const board = { ...NO_BOARD, fps: 25 };
    const { shots } = fromTable(text, { rows: given, board, headings: HEADINGS, names: new Map() });
    const after = given.map(({ id, shot }) => ({ id, shot: shots[id] ?? shot }));
    return [after.map(({ shot }) => shot.number), numbered(after).map(({ number }) => number)];
  };
  const none = [undefined, undefined, undefined];

  test('that the board does not count are fixed, digits or not', () => {
    const own = ['101', '102', '203'];
    expect(numbers('Shot\n101\n102\n203', none)).toEqual([own, own]);
    expect(numbers('Shot\n01\n2\n3', none)[1]).toEqual(['01', '2', '3']);
    expect(numbers('Shot\n1\n1A\n3', none)).toEqual([
      [undefined, '1A', '3'],
      ['1', '1A', '3'],
    ]);
  });

  test('that the board counts anyway are not fixed', () => {
    expect(numbers('Shot\n1\n2\n3', none)).toEqual([none, ['1', '2', '3']]);
    // As they are saved, next to a fixed number.
    expect(numbers('Shot\n1\n4A\n2', [undefined, '4A', undefined])[0]).toEqual([undefined, '4A', undefined]);
    // A number that the user fixed at its automatic value stays fixed.
    expect(numbers('Shot\n1\n2', ['1', undefined, undefined])[0]).toEqual(['1', '2', undefined]);
  });

  test('always are those of the table afterwards', () => {
    fc.assert(
      fc.property(
        fc.array(fc.option(fc.constantFrom('1', '2', '3', '4A', '101'), { nil: undefined }), { maxLength: 6 }),
        fc.array(fc.constantFrom('1', '2', '3', '4', '4A', '101'), { minLength: 1, maxLength: 6 }),
        (own, wanted) => {
          const given = wanted.map((_, i) => own[i]);
          expect(numbers(['Shot', ...wanted].join('\n'), given)[1]).toEqual(wanted);
        },
      ),
      { seed: 7 },
    );
  });

  test('are removed by an empty cell', () => {
    expect(numbers('Shot,Action\n,x', ['4A', undefined])[0]).toEqual([undefined, undefined]);
  });
});

/** Three photos of two cards with one name, and another photo. */
const same = (text: string) =>
  fromTable(text, {
    rows: rows(4),
    board: NO_BOARD,
    headings: HEADINGS,
    names: new Map([
      ['p0', 'IMG_1.jpg'],
      ['p1', 'b.jpg'],
      ['p2', 'IMG_1.jpg'],
      ['p3', 'IMG_1.jpg'],
    ]),
  });

test('the n-th line of a name goes to the n-th shot of that name, and a line too many is named', () => {
  const told = same('Picture,Action\nIMG_1.jpg,A\nIMG_1.jpg,B\nb.jpg,C\nIMG_1.jpg,D\nIMG_1.jpg,E\nb.jpg,F\n');
  expect(Object.entries(told.shots).map(([id, { action }]) => [id, action])).toEqual([
    ['p0', 'A'],
    ['p2', 'B'],
    ['p1', 'C'],
    ['p3', 'D'],
  ]);
  expect(told.lost).toEqual(['6: IMG_1.jpg E', '7: b.jpg F']);
});

test('a line without a picture does not overwrite the shot of a line with one', () => {
  const told = same('Picture,Action\nb.jpg,A\n,B\n,C\n,D\n,E\n');
  expect(Object.fromEntries(Object.entries(told.shots).map(([id, { action }]) => [id, action]))).toEqual({
    p1: 'A',
    p0: 'B',
    p2: 'C',
    p3: 'D',
  });
  expect(told.lost).toEqual(['6: E']);
});

test.each(['sep=;\r\n', 'SEP=;\n', '"sep=;"\r\n', 'sep=;;;;\r\n', '\ufeffsep=;\r\n'])(
  '%j names the delimiter',
  (line) => {
    const told = table(`${line.replace('\ufeff', '')}Scene;Shot;Action;Duration\r\n1;1A;Opens, slowly;2:12\r\n`);
    expect(told.shots.p0).toEqual({ notes: 'kept', scene: '1', number: '1A', action: 'Opens, slowly', frames: 62 });
    expect([told.columns, told.lost, told.cells]).toEqual([[], [], []]);
  },
);

test('the headings of the table in the app are known in every language', () => {
  for (const { words } of Object.values(translations)) {
    const { columns } = words.boards;
    const { scene, number, length, action, dialogue, notes } = columns;
    const told = table([scene, number, length, action, dialogue, notes].join('\t').concat('\n1\t1A\t36f\tA\tD\tN'));
    expect([told.shots.p0, told.columns]).toEqual([
      { scene: '1', number: '1A', frames: 36, action: 'A', dialogue: 'D', notes: 'N' },
      [],
    ]);
  }
});

test('a heading that occurs twice does not overwrite the first', () => {
  const told = table('Notes,Lens,Lens,Notizen\na,b,c,d\n');
  expect(told.shots.p0).toEqual({ notes: 'a', more: { Lens: 'b', 'Lens 2': 'c', 'Notizen 2': 'd' } });
});

test('cells and columns that cannot be used are named', () => {
  const many = Array.from({ length: MOST.columns + 2 }, (_, i) => `C${i}`);
  const told = table(`Duration,,${many.join(',')}\nsoon,loose,${many.join(',')},behind\n`);
  expect(told.cells).toEqual(['2, Duration: soon', '2, loose', '2, behind']);
  expect([told.columns, told.beyond]).toEqual([many.slice(0, MOST.columns), many.slice(MOST.columns)]);
});

test('a line that ends early leaves the other fields as they are', () => {
  expect(table('Action,Notes\nA\n').shots.p0).toEqual({ notes: 'kept', action: 'A' });
  expect(table('Action,Notes\nA,\n').shots.p0).toEqual({ action: 'A' });
});

test('of a duration and a number of frames the edited one counts, and a default length stays a default', () => {
  const frames = (cells: string, before?: number) =>
    fromTable(`Duration,Frames\n${cells}`, {
      rows: numbered([{ id: 'p', shot: before ? { frames: before } : {} }]),
      board: { ...NO_BOARD, fps: 25 },
      headings: HEADINGS,
      names: new Map(),
    }).shots.p.frames;
  expect(frames('00:00:02:00,50')).toBeUndefined();
  expect(frames('00:00:03:00,50')).toBe(75);
  expect(frames('00:00:02:00,60')).toBe(60);
  expect(frames('00:00:01:12,37', 37)).toBe(37);
  expect(frames('00:00:02:00,37', 37)).toBe(50);
});

test('cells that were guarded as formulas are as they were', () => {
  expect(cells('\ufeffa,\'=1+1\r\n\'b,"x\ny"\r\n', ',')).toEqual([['a', '=1+1'], ["'b", 'x\ny'], ['']]);
});
