import { expect, test } from 'vitest';
import {
  createExportChoice,
  hasAll,
  KINDS,
  madeOf,
  shownChoice,
  wayOf,
  WAYS,
  withAll,
  withWay,
} from './export-choice.ts';

function boxOf() {
  const kept: Map<string, string> = new Map();
  return {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, text: string) => kept.set(key, text),
  };
}

test('the format stays the same if all pages are exported', () => {
  for (const way of KINDS.flatMap((kind) => WAYS[kind])) {
    const [one, all] = [madeOf(way, false, 'png'), madeOf(way, true, 'png')];
    // Only images need an archive, which contains images of the chosen format.
    if (WAYS.image.includes(way)) expect(all).toEqual({ format: 'zip', inside: way });
    else expect(all, way).toEqual(one);
  }
  expect(madeOf('cbz', true, 'jpeg')).toEqual({ format: 'cbz', inside: 'jpeg' });
});

test('a kind begins with its last format', () => {
  const { choice, choose } = createExportChoice(boxOf);
  expect(wayOf(choice.value)).toBe('png');
  choose(withWay(choice.value, 'cbz'));
  expect([choice.value.kind, wayOf(choice.value)]).toEqual(['comic', 'cbz']);
  choose({ ...choice.value, kind: 'video' });
  expect(wayOf(choice.value)).toBe('animatic');
  choose({ ...choice.value, kind: 'comic' });
  expect(wayOf(choice.value)).toBe('cbz');
});

test('a book begins with PDF until the user chooses a format', () => {
  const box = boxOf();
  const made = createExportChoice(() => box as any);
  expect(wayOf(shownChoice(made, false))).toBe('png');
  expect(wayOf(shownChoice(made, true))).toBe('pdf');
  expect(hasAll(shownChoice(made, true))).toBe(true);
  made.asked.value = 'animatic';
  expect(wayOf(shownChoice(made, true))).toBe('animatic');
  made.asked.value = null;
  made.choose(withWay(made.choice.value, 'jpeg'));
  expect(wayOf(shownChoice(made, true))).toBe('jpeg');
  const later = createExportChoice(() => box as any);
  expect(wayOf(shownChoice(later, true))).toBe('jpeg');
});

test('the storyboard is a choice of its view, which the next dialog does not begin with', () => {
  const made = createExportChoice(boxOf);
  made.choose(withWay(made.choice.value, 'jpeg'));
  made.asked.value = 'boardPdf';
  const shown = () => shownChoice(made, false);
  expect([shown().kind, wayOf(shown())]).toEqual(['board', 'boardPdf']);
  expect(madeOf('boardPdf', false, 'jpeg')).toEqual({ format: 'pdf', inside: 'jpeg' });
  made.choose(withWay(shown(), 'boardZip'));
  expect([shown().kind, wayOf(shown())]).toEqual(['board', 'boardZip']);
  expect(madeOf('boardZip', false, 'jpeg')).toEqual({ format: 'zip', inside: 'png' });
  made.asked.value = null;
  expect(wayOf(shown())).toBe('jpeg');
  // Another format replaces it.
  made.asked.value = 'boardPdf';
  made.choose({ ...shown(), kind: 'pdf' });
  expect([wayOf(shown()), wayOf(made.choice.value)]).toEqual(['pdf', 'pdf']);
  expect(KINDS).not.toContain('board');
});

test('documents have all pages, images have the current one, and each kind keeps the choice of the user', () => {
  const box = boxOf();
  const { choice, choose } = createExportChoice(() => box as any);
  const all = () => Object.fromEntries(KINDS.map((kind) => [kind, hasAll({ ...choice.value, kind })]));
  const first = { image: false, pdf: true, print: true, comic: true, video: false, project: false, more: false };
  expect(all()).toEqual(first);
  choose(withAll(withWay(choice.value, 'pdf'), false));
  choose(withAll(withWay(choice.value, 'png'), true));
  expect(all()).toEqual({ ...first, image: true, pdf: false });
  expect(createExportChoice(() => box as any).choice.value.every).toEqual({ image: true, pdf: false });
});

test('the browser remembers the choice, and ignores a damaged one', () => {
  const box = boxOf();
  const { choice, choose } = createExportChoice(() => box as any);
  choose(withAll(withWay(choice.value, 'jpeg'), true));
  expect(createExportChoice(() => box as any).choice.value).toEqual({
    kind: 'image',
    ways: { image: 'jpeg' },
    every: { image: true },
    inside: 'png',
  });
  for (const damaged of [
    '{',
    '{"kind":"exe","ways":{"image":"exe","video":"png"},"every":{"exe":true},"inside":"gif"}',
    '[]',
  ]) {
    box.setItem('inkpanel.export', damaged);
    expect(wayOf(createExportChoice(() => box as any).choice.value)).toBe('png');
  }
  const denied = createExportChoice(() => {
    throw new Error('denied');
  });
  denied.choose(withWay(denied.choice.value, 'epub'));
  expect(wayOf(denied.choice.value)).toBe('epub');
});
