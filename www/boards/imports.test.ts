import { expect, test } from 'vitest';
import { HEADINGS } from './headings.ts';
import { cells, fountainLines, fromFountain, fromTable } from './imports.ts';
import { NO_BOARD, numbered } from './shots.ts';

const SCRIPT = `Title: Night
Author: Ann

INT. CORRIDOR - NIGHT #4#

She opens the *door*
and looks out.

ANNA
(quietly)
Is anybody there?

Nothing moves.

EXT. GARDEN - DAY

BEN
Here!

CUT TO:
`;

const rows = (count: number) =>
  numbered(Array.from({ length: count }, (_, i) => ({ id: `p${i}`, shot: i === 0 ? { notes: 'kept' } : {} })));

test('a screenplay is laid on shots: headings are scenes, what is said belongs to what happens', () => {
  expect(fountainLines(SCRIPT)).toEqual([
    {
      scene: '4 INT. CORRIDOR - NIGHT',
      action: 'She opens the door and looks out.',
      dialogue: 'ANNA: Is anybody there?',
    },
    { scene: '4 INT. CORRIDOR - NIGHT', action: 'Nothing moves.' },
    { scene: 'EXT. GARDEN - DAY', dialogue: 'BEN: Here!' },
  ]);
  const told = fromFountain(SCRIPT, rows(2));
  expect(told.shots.p0).toMatchObject({ notes: 'kept', action: 'She opens the door and looks out.' });
  expect([Object.keys(told.shots), told.left, told.first]).toEqual([['p0', 'p1'], 1, 'BEN: Here!']);
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
  expect([told.columns, told.left, told.first]).toEqual([['Lens'], 1, '2 gone.jpg 1 x 50']);
});

test('a table without pictures goes to the shots one after the other; what is too long for them is told', () => {
  const told = table('Shot\tAction\tFrames\n1\tA\t12\n4A\tB\t\n3\tC\t1\n4\tD\t2\n');
  expect(told.shots).toEqual({
    p0: { notes: 'kept', action: 'A', frames: 12 },
    p1: { number: '4A', action: 'B' },
    p2: { action: 'C', frames: 1 },
  });
  expect([told.lines, told.left, told.first]).toEqual([4, 1, '4 D 2']);
});

test('cells that were guarded as formulas are as they were', () => {
  expect(cells('\ufeffa,\'=1+1\r\n\'b,"x\ny"\r\n')).toEqual([
    ['a', '=1+1'],
    ["'b", 'x\ny'],
  ]);
});
