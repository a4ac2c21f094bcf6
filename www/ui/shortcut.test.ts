import { expect, test } from 'vitest';
import { ariaShortcut, keyNames, pressed } from './shortcut.ts';

test('a shortcut is called as the keyboard at hand calls its keys', () => {
  expect(keyNames('Shift+Mod+Z', false)).toEqual(['Shift', 'Ctrl', 'Z']);
  expect(keyNames('Shift+Mod+Z', true)).toEqual(['Shift', '⌘', 'Z']);
  expect([keyNames('+'), keyNames('-'), keyNames('PageUp')]).toEqual([['+'], ['−'], ['Page Up']]);
});

test('assistive technology is told in the words of its standard', () => {
  expect(ariaShortcut('Shift+Mod+Z', false)).toBe('Shift+Control+Z');
  expect(ariaShortcut('Mod+S', true)).toBe('Meta+S');
  expect([ariaShortcut('Space'), ariaShortcut('+'), ariaShortcut('?')]).toEqual(['Space', 'Plus', '?']);
});

test('what is pressed is a shortcut, with Shift or without', () => {
  const event = (key: string, how = {}) =>
    ({ key, shiftKey: false, ctrlKey: false, metaKey: false, ...how }) as KeyboardEvent;
  expect(pressed(event(' '))).toEqual(['Space']);
  expect(pressed(event('z', { metaKey: true }))).toEqual(['Mod+Z']);
  expect(pressed(event('?', { shiftKey: true }))).toEqual(['Shift+?', '?']);
});
