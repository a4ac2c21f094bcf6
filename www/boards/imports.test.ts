import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { MOST } from '../engine/bounds.ts';
import { inLanguage, translations } from '../strings/testing.ts';
import { HEADINGS } from './headings.ts';
import { cells, fromFountain, fromTable, tabbed } from './imports.ts';
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
  for (const code of Object.keys(translations)) {
    const { columns } = inLanguage(code).boards;
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

/** Typical typed cells, trimmed. */
const CELL = fc
  .array(fc.constantFrom('a', 'Ä', '"', "'", '=', '+', '-', ',', ';', '\t', '\n', ' ', '漢', '@'), { maxLength: 8 })
  .map((letters) => letters.join('').trim());

describe('tables', () => {
  test('may have title lines above their headings, which are reported', () => {
    const told = table('Shot list;;\nFilm: Night;;\n\nSzene;Handlung;Optik\n1;Sie geht.;35\n');
    expect(told.shots.p0).toEqual({ notes: 'kept', scene: '1', action: 'Sie geht.', more: { Optik: '35' } });
    expect(told.lost).toEqual(['1: Shot list', '2: Film: Night']);
  });

  test('of other programs have other headings', () => {
    const told = table('SCENE #,Shot No.,DESCRIPTION,Dur.,Comments\n7,A,She waits.,2:12,soft\n');
    expect([told.shots.p0, told.columns]).toEqual([
      { scene: '7', number: 'A', action: 'She waits.', frames: 62, notes: 'soft' },
      [],
    ]);
  });

  test('without pictures have no columns that describe pictures, and lose none', () => {
    expect(table('Action,Film\nA,night.mp4\n').shots.p0).toEqual({
      notes: 'kept',
      action: 'A',
      more: { Film: 'night.mp4' },
    });
  });

  test('keep the custom columns of the board, whatever they are called', () => {
    const columns = ['Plan', 'Description', 'Notes', 'Lens'];
    const board = { ...NO_BOARD, columns };
    const more = { Plan: 'a', Description: 'b', Notes: 'c', Lens: 'd' };
    const told = fromTable(
      'Scene,Shot,Picture,Film,Time code,Duration,Frames,Action,Dialogue,Notes,Plan,Description,Notes,Lens\n1,1,p,,,,,A,,N,a,b,c,d\n',
      { rows: numbered([{ id: 'p', shot: {} }]), board, headings: HEADINGS, names: new Map([['p', 'p']]) },
    );
    expect([told.shots.p, told.columns]).toEqual([{ scene: '1', action: 'A', notes: 'N', more }, []]);
  });

  test('list the dialogue of pages, which stays that of the pages', () => {
    const [row] = numbered([{ id: 'p', shot: {}, said: { dialogue: 'Anna: Hello', caption: 'Later', sound: '' } }]);
    const told = fromTable('Dialogue,Notes\nAnna: Hello,N\n', {
      rows: [row],
      board: NO_BOARD,
      headings: HEADINGS,
      names: new Map(),
    });
    expect(told.shots.p).toEqual({ notes: 'N' });
  });

  test('that are copied are imported again unchanged', () => {
    fc.assert(
      fc.property(
        fc.array(fc.tuple(CELL, CELL, CELL), { minLength: 1, maxLength: 6 }),
        fc.constantFrom(...Object.keys(translations)),
        (lines, code) => {
          const { scene, action, notes } = inLanguage(code).boards.columns;
          const shots = lines.map(([a, b, c]) => ({ scene: a, action: b, notes: c }));
          const told = fromTable(tabbed([[scene, action, notes], ...lines]), {
            rows: numbered(shots.map((shot, i) => ({ id: `p${i}`, shot }))),
            board: NO_BOARD,
            headings: HEADINGS,
            names: new Map(),
          });
          const kept = shots.map((shot) => Object.fromEntries(Object.entries(shot).filter(([, text]) => text !== '')));
          const read = shots.map((_, i) => told.shots[`p${i}`] ?? {});
          // A line without text is skipped.
          if (kept.every((shot) => Object.keys(shot).length > 0)) expect(read).toEqual(kept);
          expect([told.lost, told.cells]).toEqual([[], []]);
        },
      ),
      { numRuns: 400 },
    );
  });

  test('of any shape are read or reported as a whole', () => {
    const known = HEADINGS.flat(2).filter((name) => name !== '');
    const heading = fc.oneof(fc.constantFrom(...known), fc.constantFrom('Lens', 'Crane', '', 'Notes', 'Plan'));
    fc.assert(
      fc.property(
        fc.array(heading, { minLength: 1, maxLength: 9 }),
        fc.array(fc.array(fc.constantFrom('', 'x', '"', ';', ', ', '\n'), { maxLength: 10 }), { maxLength: 6 }),
        fc.array(fc.constantFrom('Shot list', 'Film: Night'), { maxLength: 2 }),
        fc.constantFrom(',', ';', '\t'),
        fc.constantFrom('\n', '\r\n'),
        (head, lines, titles, delimiter, end) => {
          // Each cell has a unique word.
          let count = 0;
          const cell = (part: string) => (part === '' ? '' : `w${(count += 1)}_${part}`);
          const body = lines.map((line) => line.map(cell));
          const quoted = (text: string) => `"${text.replaceAll('"', '""')}"`;
          const text = [...titles.map((title) => [title]), head, ...body]
            .map((line) => line.map(quoted).join(delimiter))
            .join(end);
          const told = table(text, 4);
          const all = JSON.stringify([told.shots, told.lost, told.cells, told.beyond, told.columns]);
          // Only the names of photos, and the lengths and films of saved lists, describe what the board has.
          const places = head.map((name) =>
            HEADINGS.map((list) => list.findIndex((names) => [names].flat().includes(name))),
          );
          const isDescribed = places.map((list) => list.some((place) => place >= 2 && place <= 4));
          for (const line of body)
            line.forEach((word, i) => {
              if (word !== '' && !isDescribed[i]) expect(all, word).toContain(word.split('_')[0]);
            });
        },
      ),
      { numRuns: 400 },
    );
  });
});

describe('screenplays', () => {
  test('are put on shots or reported as a whole', () => {
    const BLOCKS: readonly ((word: string) => string)[] = [
      (word) => `INT. ${word} - DAY`,
      (word) => `.${word}`,
      (word) => `She _${word}_ waits.`,
      (word) => `!${word.toUpperCase()}`,
      (word) => `ANNA\n${word}`,
      (word) => `@anna (V.O.) ^\n(quiet)\n${word}`,
      (word) => `ANNA\n~${word}`,
      (word) => `~${word}`,
      (word) => `> ${word} <`,
      (word) => `${word} 2*3*4=24 [[hidden]] /* hidden */`,
      (word) => `ANNA\n${word}\n  \nmore`,
      (word) => `INT. HOUSE\n= ${word}`,
    ];
    fc.assert(
      fc.property(
        fc.array(fc.nat(BLOCKS.length - 1), { minLength: 1, maxLength: 12 }),
        fc.constantFrom('\n\n', '\r\n\r\n', '\n\n\n'),
        fc.nat(6),
        (kinds, gap, count) => {
          const words = kinds.map((_, i) => `w${i}_x`);
          const told = fromFountain(kinds.map((kind, i) => BLOCKS[kind](words[i])).join(gap), rows(count));
          const all = JSON.stringify([told.shots, told.lost, told.cells]).toLowerCase();
          const hasShot = kinds.map((kind) => kind !== 0 && kind !== 1 && kind !== 11);
          words.forEach((word, i) => {
            if (count === 6 && kinds.length <= 6 && hasShot[i]) expect(all, word).toContain(word);
          });
          expect(all).not.toContain('hidden');
          // With too few shots, the paragraphs that are left are reported.
          const full = fromFountain(kinds.map((kind, i) => BLOCKS[kind](words[i])).join(gap), rows(30));
          expect(Object.keys(told.shots).length + told.lost.length).toBe(Object.keys(full.shots).length);
        },
      ),
      { numRuns: 400 },
    );
  });
});
