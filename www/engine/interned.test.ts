import { describe, expect, it } from 'vitest';
import { edited, historyOf, pageOf } from '../document/testing.ts';
import { expanded, interned } from './interned.ts';
import type { Change } from '../document/history.ts';
import type { TabledHistory } from './types.ts';

/** A history of five states that share most of their parts. */
function worked() {
  const changes: Change[] = [
    { type: 'add-photos', ids: ['a', 'b', 'c'] },
    { type: 'show-page', page: pageOf(1), pageId: 1 },
    { type: 'own-styles', mine: ['x', 'y'].map((id) => ({ id, name: id, tags: [], background: [] })) },
    {
      type: 'set-sheets',
      sheets: [
        { page: pageOf(1), pageId: 1, sheet: 0 },
        { page: pageOf(2), pageId: 2, sheet: 1 },
      ],
      at: 1,
    },
    { type: 'use-photos', uses: { b: false } },
    { type: 'undo' },
  ];
  return historyOf(edited(...changes));
}

describe('a history with tables', () => {
  it('has each part once', () => {
    const { parts, past, future } = interned(worked()) as TabledHistory;
    expect([parts.items.length, parts.trays.length, parts.styles.length, parts.books.length]).toEqual([4, 3, 2, 2]);
    // The second tray shares two photos with the first.
    expect(parts.trays).toEqual([[], [0, 1, 2], [0, 3, 2]]);
    expect([past.length, future.length, past[2].tray, past[3].tray]).toEqual([4, 1, 1, 1]);
  });

  it('is whole again through JSON, and shares what it shared', () => {
    const history = worked();
    const back = expanded(JSON.parse(JSON.stringify(interned(history))));
    expect(back).toEqual(history);
    expect(back.past[2].tray).toBe(back.present.tray);
    expect(back.future[0].tray[0]).toBe(back.present.tray[0]);
    expect(back.shown.find(({ id }) => id === back.present.pageId)?.page).toBe(back.present.page);
  });

  it('never takes a number for the name of a part', () => {
    const told = interned({
      present: { tray: 0, page: 0, settings: null, mine: [1], others: [{ page: 3 }] },
      shown: [{ id: 1, page: 0 }],
    }) as TabledHistory;
    expect(told.present).toEqual({ tray: '0', page: '0', settings: null, mine: 0, others: 0 });
    expect([told.parts.shelves, told.parts.sheets, told.shown]).toEqual([
      [['1']],
      [{ page: '3' }],
      [{ id: 1, page: '0' }],
    ]);
  });

  it.each([
    [null],
    [7],
    ['x'],
    [[]],
    [{ past: 5, present: null, shown: [null, 3] }],
    [{ present: { tray: [[]], others: { length: 5 } } }],
    [undefined],
  ])('takes %j as it is', (wrong) => {
    expect(() => JSON.stringify(interned(wrong))).not.toThrow();
  });
});
