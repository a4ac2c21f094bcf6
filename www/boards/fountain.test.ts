import { describe, expect, test } from 'vitest';
import { fountainLines, isFountain } from './fountain.ts';

const actions = (text: string) => fountainLines(text).map(({ action }) => action);

test('headings are scenes, and what is said belongs to what happens before it', () => {
  const text = `Title: Night
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
  expect(fountainLines(text)).toEqual([
    {
      scene: '4 INT. CORRIDOR - NIGHT',
      action: 'She opens the door and looks out.',
      dialogue: 'ANNA: Is anybody there?',
    },
    { scene: '4 INT. CORRIDOR - NIGHT', action: 'Nothing moves.' },
    { scene: 'EXT. GARDEN - DAY', dialogue: 'BEN: Here!' },
  ]);
});

test('dialogue may begin with a song, and a song without a singer is dialogue too', () => {
  expect(fountainLines('SINGER\n~These are the songs\n~That I sing.\nSpoken.\n\nShe bows.\n\n~La la\n~la')).toEqual([
    { scene: '', dialogue: 'SINGER: These are the songs That I sing.\nSINGER: Spoken.' },
    { scene: '', action: 'She bows.', dialogue: 'La la la' },
  ]);
});

test.each([
  ['INT. HOUSE', 'INT. HOUSE'],
  ['ext. garden - day', 'ext. garden - day'],
  ['INT./EXT. CAR', 'INT./EXT. CAR'],
  ['INT/EXT CAR', 'INT/EXT CAR'],
  ['I/E CAR', 'I/E CAR'],
  ['EST. CITY #12A#', '12A EST. CITY'],
  ['.LATER', 'LATER'],
  ['**INT. HOUSE**', 'INT. HOUSE'],
])('%s is the heading of a scene', (line, scene) => {
  expect(fountainLines(`${line}\n\nShe sits.`)).toEqual([{ scene, action: 'She sits.' }]);
  expect(fountainLines(`${line}\nShe sits.`)).toEqual([{ scene, action: 'She sits.' }]);
});

test.each(['...and then', 'Interior light', 'Exterminate!', 'Esther', '..', 'I am'])('%s is action', (line) => {
  expect(fountainLines(line)).toEqual([{ scene: '', action: line }]);
});

test('characters are lines in capitals with text below; @ forces one and ! forces action', () => {
  const said = (text: string) => fountainLines(text)[0].dialogue;
  expect(said("ANNA (cont'd)\nYes.")).toBe("ANNA (cont'd): Yes.");
  expect(said('@McCLANE\nYippee.')).toBe('McCLANE: Yippee.');
  expect(said('BEN ^\nNo.')).toBe('BEN: No.');
  expect(said('МИША\nДа.')).toBe('МИША: Да.');
  expect(said('花子\nはい。')).toBe('花子: はい。');
  expect(said('ANNA\nOne.\n  \nTwo.')).toBe('ANNA: One. Two.');
  expect(actions('Миша\nидёт.')).toEqual(['Миша идёт.']);
  expect(actions('!BANG\nShe falls.')).toEqual(['BANG She falls.']);
  expect(actions('BANG\n  \nShe falls.')).toEqual(['BANG', 'She falls.']);
  expect(actions('23\nmen')).toEqual(['23 men']);
});

test('transitions, page breaks and sections are no shots; centred text is', () => {
  const text = 'FADE IN:\n\n# Act\n\n> SMASH CUT\n\n===\n\nShe sits.\n\nCUT TO BLACK.\n\n> THE END <\n\nDISSOLVE TO:';
  expect(actions(text)).toEqual(['She sits.', 'THE END']);
});

test('notes and comments are removed, and do not end a paragraph', () => {
  const text = `INT. HOUSE - DAY

She sits [[check prop]] down.

[[This note spans
two lines.]]

He /* never
ever */ leaves.
[[a note]]
At last.

/*
ANNA
Cut.
*/

Open [[ stays.`;
  expect(actions(text)).toEqual(['She sits down.', 'He leaves. At last.', 'Open [[ stays.']);
});

test('marks of emphasis are removed in pairs around words; names and calculations keep theirs', () => {
  const cases = [
    ['*a* **b** ***c*** _d_ _**e**_ **_f_**', 'a b c d e f'],
    ['(*really*), *two words*!', '(really), two words!'],
    ['file_name_here', 'file_name_here'],
    ['2*3*4=24', '2*3*4=24'],
    ['2 * 3 * 4', '2 * 3 * 4'],
    ['a * b* c', 'a * b* c'],
    ['*open', '*open'],
    ['\\*not\\* \\_this\\_ a\\b', '*not* _this_ a\\b'],
    ['****', '****'],
    ['彼は*本当に*行く', '彼は本当に行く'],
    ['🎬 *cut* 🎬', '🎬 cut 🎬'],
  ];
  for (const [text, shown] of cases) expect(actions(text), text).toEqual([shown]);
});

describe('an outline', () => {
  test('of headings and synopses becomes a line per scene', () => {
    const text =
      '# Act One\n\nINT. HOUSE\n\n= Ann finds it.\n= She reads.\n\nEXT. GARDEN\n\nEXT. SEA\n\n= Ben leaves.\n';
    expect(fountainLines(text)).toEqual([
      { scene: 'INT. HOUSE', action: 'Ann finds it.' },
      { scene: 'INT. HOUSE', action: 'She reads.' },
      { scene: 'EXT. GARDEN' },
      { scene: 'EXT. SEA', action: 'Ben leaves.' },
    ]);
  });

  test('of sections and synopses has the sections as scenes', () => {
    expect(fountainLines('# One\n= A.\n## Two\n\n= B.')).toEqual([
      { scene: 'One', action: 'A.' },
      { scene: 'Two', action: 'B.' },
    ]);
  });

  test('does not count where scenes are written', () => {
    expect(actions('# One\n\n= A.\n\nINT. HOUSE\n\n= B.\n\nShe sits.')).toEqual(['She sits.']);
  });
});

test('a screenplay is recognised by its title page or its scenes', () => {
  const texts = ['Title: Night\n\nShe sits.', 'She sits.\r\n\r\nINT. HOUSE\r\n', 'Scene;Shot\n1;2', 'Interior;1', ''];
  expect(texts.map(isFountain)).toEqual([true, true, false, false, false]);
});
