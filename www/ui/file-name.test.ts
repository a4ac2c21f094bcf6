import { expect, test } from 'vitest';
import { fileNameOf } from './file-name.ts';

test('names are what a person would give', () => {
  expect(fileNameOf(['Summer in Lisbon', 'page 2'], 'png', 'Untitled')).toBe('Summer in Lisbon - page 2.png');
  expect(fileNameOf(['夏の旅', '', 'コマ3'], 'png', 'x')).toBe('夏の旅 - コマ3.png');
  expect(fileNameOf(['3\u2009–\u20095 June 2026'], 'pdf', 'x')).toBe('3 – 5 June 2026.pdf');
});

test('no system refuses them', () => {
  expect(fileNameOf(['a/b\\c:d*e?f"g<h>i|j\u0000k'], 'png', 'x')).toBe('a b c d e f g h i j k.png');
  expect(fileNameOf(['../../etc/passwd'], 'png', 'x')).toBe('etc passwd.png');
  expect(fileNameOf(['Ends with dots... '], 'png', 'x')).toBe('Ends with dots.png');
  for (const name of ['CON', 'nul', 'com1', 'LPT9.txt', 'Aux'])
    expect(fileNameOf([name], 'png', 'x')).toBe(`_${name}.png`);
  expect(fileNameOf(['Console'], 'png', 'x')).toBe('Console.png');
  // The direction cannot be turned to make one ending look like another.
  expect(fileNameOf(['photo\u202egnp'], 'zip', 'x')).toBe('photo gnp.zip');
  expect(fileNameOf(['half \ud800'], 'png', 'x')).toBe('half \ufffd.png');
  for (const nothing of ['', '   ', '...', '???'])
    expect(fileNameOf([nothing], 'png', 'Untitled')).toBe('Untitled.png');
});

test('long names are cut between letters, and what tells files apart stays', () => {
  const family = '👩‍👩‍👧';
  const name = fileNameOf([family.repeat(300), 'page 12'], 'png', 'x');
  expect(new TextEncoder().encode(name).length).toBeLessThan(200);
  expect(name).toMatch(/^(👩‍👩‍👧)+ - page 12\.png$/u);
});
