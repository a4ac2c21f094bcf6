import { expect, test } from 'vitest';
import { wordName } from './word-names.ts';
import type { Word } from '../engine/types.ts';

const caption = (text: string, more: Partial<Word> = {}): Word => ({ kind: 'caption', text, ...more });

test('texts of a book have the names of their roles', () => {
  expect(wordName(caption('3', { book: true, boxless: true, number: true }))).toBe('Page number: 3');
  expect(wordName(caption('The end', { book: true, boxless: true, font: 'bangers' }))).toBe('Title: The end');
  expect(wordName(caption('9–12 June', { book: true, boxless: true, font: 'comic-neue-bold' }))).toBe(
    'Caption: 9–12 June',
  );
  expect(wordName(caption('Second day.', { book: true }))).toBe('Caption: Second day.');
});

test('other texts have the name of their kind, and the text that is typed', () => {
  expect(wordName(caption('Loud', { font: 'bangers' }))).toBe('Caption: Loud');
  expect(wordName({ kind: 'balloon', text: 'Hello!' }, 'Well')).toBe('Balloon: Well');
});
